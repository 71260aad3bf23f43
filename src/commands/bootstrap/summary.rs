//! Summary of a bootstrap: the distribution of the estimates over the refits.

use identify::Fit;
use identify::numbers::Digits;
use report::Table;
use serde_json::{Map, Value, json};

use super::Refit;

/// Contents of `summary.json`; SI.
pub fn json(fit: &Fit, refits: &[Refit], seed: u64) -> Value {
    let converged = refits.iter().filter_map(|refit| refit.1.as_deref());
    let converged: Vec<&[f64]> = converged.collect();
    let globals = fit.problem().globals.iter();
    let names: Vec<&str> = globals.map(|global| &*global.name).collect();
    let columns = (0..names.len()).map(|i| Estimates::of(&converged, i));
    let columns: Vec<Estimates> = columns.collect();
    let mut coefficients = Map::new();
    for (name, column) in names.iter().zip(&columns) {
        let Some(of_fit) = fit.report.coefficients.get(*name) else {
            continue;
        };
        let scatter = json!({
            "value": of_fit.value,
            "unit": of_fit.unit,
            "std_error": column.sd,
            "std_error_fit": of_fit.std_error,
            "std_error_cluster_robust": of_fit.std_error_cluster_robust,
            "mean": column.mean,
            "interval": [column.quantile(0.025), column.quantile(0.975)],
        });
        coefficients.insert((*name).to_owned(), scatter);
    }
    let mut correlations = Map::new();
    for (i, name) in names.iter().enumerate() {
        let row = names.iter().enumerate().map(|(j, other)| {
            let correlation = correlation(&converged, &columns, i, j);
            ((*other).to_owned(), json!(correlation))
        });
        correlations.insert((*name).to_owned(), Value::Object(row.collect()));
    }
    json!({
        "schema": "hyzer.bootstrap/1",
        "model": fit.report.model,
        "refits": refits.len(),
        "converged": converged.len(),
        "seed": seed,
        "flights": super::flights(fit),
        "reliable": fit.report.reliable,
        "cautions": fit.report.cautions,
        "coefficients": coefficients,
        "correlations": correlations,
    })
}

/// Estimates of one parameter in the converged refits.
struct Estimates {
    sorted: Vec<f64>,
    mean: f64,
    sd: f64,
}

impl Estimates {
    fn of(refits: &[&[f64]], i: usize) -> Estimates {
        let mut sorted: Vec<f64> = refits.iter().map(|estimates| estimates[i]).collect();
        sorted.sort_by(f64::total_cmp);
        let count = sorted.len() as f64;
        let mean = sorted.iter().sum::<f64>() / count;
        let squares: f64 = sorted.iter().map(|value| (value - mean).powi(2)).sum();
        Estimates {
            mean,
            sd: (squares / (count - 1.0)).sqrt(),
            sorted,
        }
    }

    /// Quantile, by linear interpolation; NaN if no refit converged.
    fn quantile(&self, p: f64) -> f64 {
        let at = p * (self.sorted.len() as f64 - 1.0);
        let value = |k: f64| self.sorted.get(k.max(0.0) as usize).copied();
        let value = |k: f64| value(k).unwrap_or(f64::NAN);
        let (low, high) = (value(at.floor()), value(at.ceil()));
        low + (high - low) * at.fract()
    }
}

fn correlation(refits: &[&[f64]], columns: &[Estimates], i: usize, j: usize) -> f64 {
    let (a, b) = (&columns[i], &columns[j]);
    let products = refits
        .iter()
        .map(|estimates| (estimates[i] - a.mean) * (estimates[j] - b.mean));
    products.sum::<f64>() / (refits.len() as f64 - 1.0) / (a.sd * b.sd)
}

/// The summary as text.
pub fn text(summary: &Value) -> String {
    let number = |column: &Value, key: &str| column[key].as_f64().unwrap_or(f64::NAN);
    let digits = |column: &Value| Digits::of(number(column, "value"), number(column, "std_error"));
    let one = |column: &Value, key: &str| digits(column).one(number(column, key));
    let of_fit = |column: &Value| match column["std_error_cluster_robust"] {
        Value::Null => one(column, "std_error_fit"),
        _ => one(column, "std_error_cluster_robust"),
    };
    let interval = |column: &Value| {
        let end = |end: usize| column["interval"][end].as_f64().unwrap_or(f64::NAN);
        digits(column).range([end(0), end(1)])
    };
    let table = Table::of(summary["coefficients"].as_object().into_iter().flatten())
        .name("", |(name, _)| *name)
        .number("estimate", |(_, column)| one(column, "value"))
        .number("std error", |(_, column)| one(column, "std_error"))
        .number("of the fit", |(_, column)| of_fit(column))
        .number("95 % interval", |(_, column)| interval(column))
        .plain("unit", |(_, column)| {
            column["unit"].as_str().unwrap_or_default()
        })
        .table();
    format!(
        "{}: {} refits to {} flights drawn with replacement, {} converged\n{}",
        summary["model"].as_str().unwrap_or_default(),
        summary["refits"],
        summary["flights"],
        summary["converged"],
        table.text(usize::MAX),
    )
}
