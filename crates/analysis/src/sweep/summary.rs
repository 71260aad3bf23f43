//! Summary statistics of a sweep, merged part by part in ascending order, so that the flights need not stay in
//! memory.

use serde_json::{Map, Value, json};

use crate::sweep::plan::Plan;
use crate::sweep::rows::{Rows, STATUSES};
use crate::sweep::sketch::{ACCURACY, Sketch};

const QUANTILES: [(&str, f64); 7] = [
    ("0.01", 0.01),
    ("0.05", 0.05),
    ("0.25", 0.25),
    ("0.5", 0.5),
    ("0.75", 0.75),
    ("0.95", 0.95),
    ("0.99", 0.99),
];

/// Summary of a sweep; the statistics include only flights that reached the intended end: ground or final time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Summary {
    flights: u64,
    statuses: [u64; STATUSES.len()],
    columns: Vec<(String, ColumnSummary)>,
    /// Of the landing points x and y.
    landing: Joint,
}

/// Mean, sum of squared deviations, extremes and quantiles of one column.
#[derive(Clone, Debug, PartialEq)]
struct ColumnSummary {
    count: u64,
    mean: f64,
    /// Sum of the squared deviations from the mean.
    squares: f64,
    least: f64,
    greatest: f64,
    sketch: Sketch,
}

/// Means of two columns, and sum of the products of the deviations from them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Joint {
    count: u64,
    mean: [f64; 2],
    products: f64,
}

impl Summary {
    /// Summary of one part; `end` is the index in [`STATUSES`] of the intended end.
    pub(crate) fn of(rows: &Rows, end: u8) -> Summary {
        let mut statuses = [0; STATUSES.len()];
        for status in &rows.status {
            statuses[usize::from(*status)] += 1;
        }
        let ended = |values: &[f64]| {
            let flights = values.iter().zip(&rows.status);
            let ended = flights.filter(|(value, status)| **status == end && !value.is_nan());
            ended.map(|(value, _)| *value).collect::<Vec<f64>>()
        };
        let columns = rows.columns.iter();
        let columns = columns.map(|own| (own.name.clone(), ColumnSummary::of(&ended(&own.values))));
        let named = |name: &str| {
            let column = rows.columns.iter().find(|column| column.name == name);
            column
                .map(|column| ended(&column.values))
                .unwrap_or_default()
        };
        Summary {
            flights: rows.status.len() as u64,
            statuses,
            columns: columns.collect(),
            landing: Joint::of(&named("landing_x"), &named("landing_y")),
        }
    }

    pub(crate) fn merge(&mut self, next: &Summary) {
        self.flights += next.flights;
        for (own, more) in self.statuses.iter_mut().zip(next.statuses) {
            *own += more;
        }
        for ((_, own), (_, more)) in self.columns.iter_mut().zip(&next.columns) {
            own.merge(more);
        }
        self.landing.merge(&next.landing);
    }

    pub(crate) fn json(&self, plan: &Plan) -> Value {
        let statuses = STATUSES.into_iter().zip(self.statuses);
        let statuses = statuses.filter(|(_, count)| *count > 0);
        let statuses: Map<String, Value> = statuses
            .map(|(name, count)| (name.to_owned(), count.into()))
            .collect();
        let columns: Map<String, Value> = self
            .columns
            .iter()
            .map(|(name, own)| (name.clone(), own.json()))
            .collect();
        let of = |name: &str| {
            let column = self.columns.iter().find(|(own, _)| own == name);
            column.map_or(f64::NAN, |(_, own)| own.deviation().powi(2))
        };
        let xy = self.landing.products / (self.landing.count.max(2) - 1) as f64;
        json!({
            "schema": "hyzer.sweep/1",
            "model": plan.model.name,
            "flights": self.flights,
            "statuses": statuses,
            "seed": plan.seed,
            "method": format!("{:?}", plan.options.method).to_lowercase(),
            "tolerance": plan.options.rtol,
            "columns": columns,
            "landing_covariance": [[of("landing_x"), xy], [xy, of("landing_y")]],
            "quantile_accuracy": ACCURACY,
        })
    }
}

impl ColumnSummary {
    fn of(values: &[f64]) -> ColumnSummary {
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count.max(1.0);
        ColumnSummary {
            count: values.len() as u64,
            mean,
            squares: values.iter().map(|value| (value - mean).powi(2)).sum(),
            least: values.iter().copied().fold(f64::INFINITY, f64::min),
            greatest: values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            sketch: Sketch::of(values.iter().copied()),
        }
    }

    fn merge(&mut self, next: &ColumnSummary) {
        // Chan, Golub & LeVeque, "Updating formulae and a pairwise algorithm for computing sample variances" (1979).
        let (a, b) = (self.count as f64, next.count as f64);
        if next.count > 0 {
            let step = next.mean - self.mean;
            self.mean += step * b / (a + b);
            self.squares += next.squares + step * step * a * b / (a + b);
        }
        self.count += next.count;
        self.least = self.least.min(next.least);
        self.greatest = self.greatest.max(next.greatest);
        self.sketch.merge(&next.sketch);
    }

    fn deviation(&self) -> f64 {
        (self.squares / (self.count.max(2) - 1) as f64).sqrt()
    }

    fn quantile(&self, q: f64) -> f64 {
        self.sketch.quantile(q).clamp(self.least, self.greatest)
    }

    fn json(&self) -> Value {
        if self.count == 0 {
            return Value::Null;
        }
        let quantiles: Map<String, Value> = QUANTILES
            .iter()
            .map(|(name, q)| ((*name).to_owned(), self.quantile(*q).into()))
            .collect();
        json!({
            "mean": self.mean,
            "sd": self.deviation(),
            "min": self.least,
            "max": self.greatest,
            "quantiles": quantiles,
        })
    }
}

impl Joint {
    fn of(x: &[f64], y: &[f64]) -> Joint {
        let count = x.len().min(y.len());
        let mean = [x, y].map(|values| values[..count].iter().sum::<f64>() / count.max(1) as f64);
        let pairs = x.iter().zip(y);
        Joint {
            count: count as u64,
            mean,
            products: pairs.map(|(x, y)| (x - mean[0]) * (y - mean[1])).sum(),
        }
    }

    fn merge(&mut self, next: &Joint) {
        if next.count == 0 {
            return;
        }
        let (a, b) = (self.count as f64, next.count as f64);
        let step = [0, 1].map(|k| next.mean[k] - self.mean[k]);
        for (mean, step) in self.mean.iter_mut().zip(step) {
            *mean += step * b / (a + b);
        }
        self.products += next.products + step[0] * step[1] * a * b / (a + b);
        self.count += next.count;
    }
}
