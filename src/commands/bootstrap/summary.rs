//! Summary of a bootstrap: the distribution of the estimates over the refits.

use identify::Fit;
use identify::numbers::Digits;
use report::{Cell, Column, Table};
use serde_json::{Map, Value, json};

use super::parts::Refit;
use crate::cli::Bootstrap;

/// Contents of the `summary.json` of a bootstrap: standard errors, 95 % percentile intervals and correlations of the
/// estimates; SI.
pub(super) fn json(fit: &Fit, refits: &[Refit], options: &Bootstrap) -> Value {
    let converged: Vec<&[f64]> = refits
        .iter()
        .filter_map(|refit| refit.1.as_deref())
        .collect();
    let names: Vec<&str> = fit
        .problem()
        .globals
        .iter()
        .map(|global| &*global.name)
        .collect();
    let columns: Vec<Estimates> = (0..names.len())
        .map(|i| Estimates::of(&converged, i))
        .collect();
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
        let row = (0..names.len()).map(|j| {
            (
                names[j].to_owned(),
                json!(correlation(&converged, &columns, i, j)),
            )
        });
        correlations.insert((*name).to_owned(), Value::Object(row.collect()));
    }
    json!({
        "schema": "hyzer.bootstrap/1",
        "model": fit.report.model,
        "refits": refits.len(),
        "converged": converged.len(),
        "seed": options.seed,
        "flights": super::flights(fit),
        "reliable": fit.report.reliable,
        "cautions": fit.report.cautions,
        "coefficients": coefficients,
        "correlations": correlations,
    })
}

/// Estimates of one parameter in the converged refits of a bootstrap, with their mean and standard deviation.
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

    /// Quantile at the probability `p` (0 to 1) of the parameter's estimates over the converged refits, by linear
    /// interpolation between the order statistics; NaN if no refit converged.
    fn quantile(&self, p: f64) -> f64 {
        let at = p * (self.sorted.len() as f64 - 1.0);
        let value = |k: f64| {
            self.sorted
                .get(k.max(0.0) as usize)
                .copied()
                .unwrap_or(f64::NAN)
        };
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

/// The summary of a bootstrap (its `summary.json`) as text for the terminal.
pub(super) fn text(summary: &Value) -> String {
    use Column::{Name, Number, Plain};
    let mut table = Table::new()
        .with(Name, &[""])
        .with(
            Number,
            &["estimate", "std error", "of the fit", "95 % interval"],
        )
        .with(Plain, &["unit"]);
    for (name, column) in summary["coefficients"].as_object().into_iter().flatten() {
        let value = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
        let digits = Digits::of(value(&column["value"]), value(&column["std_error"]));
        let number = |of: &Value| Cell::from(digits.one(value(of)));
        let of_fit = match &column["std_error_cluster_robust"] {
            Value::Null => &column["std_error_fit"],
            clustered => clustered,
        };
        let interval = [0, 1].map(|end| value(&column["interval"][end]));
        table.row([
            name.into(),
            number(&column["value"]),
            number(&column["std_error"]),
            number(of_fit),
            digits.range(interval).into(),
            column["unit"].as_str().unwrap_or_default().into(),
        ]);
    }
    format!(
        "{}: {} refits to {} flights drawn with replacement, {} converged\n{}",
        summary["model"].as_str().unwrap_or_default(),
        summary["refits"],
        summary["flights"],
        summary["converged"],
        table.text(usize::MAX),
    )
}
