//! Reads the standard errors of coefficients from the report of a fit.

use std::path::Path;

use analysis::design::CoefficientErrors;
use anyhow::{Context, bail};
use flight::files::bounded_text;
use serde_json::Value;

/// Maximum size of `report.json`, bytes.
const MAX_BYTES: u64 = 64 << 20;

/// Reads the text of the `report.json` of `hyzer fit`.
pub fn text(file: &Path) -> anyhow::Result<String> {
    bounded_text(file, MAX_BYTES).with_context(|| format!("--fit: {}", file.display()))
}

/// Reads standard errors and correlations from the text of a `report.json`, named by `name` in messages, and why they are
/// not to be relied on.
pub fn read(name: &str, text: &str) -> anyhow::Result<(CoefficientErrors, Option<String>)> {
    let place = || name.to_owned();
    let report: Value = serde_json::from_str(text).with_context(place)?;
    let Some(coefficients) = report["coefficients"].as_object() else {
        bail!(
            "{}: found no \"coefficients\", expected the report.json of hyzer fit",
            place()
        );
    };
    let mut errors = Vec::new();
    for (name, own) in coefficients {
        match &own["std_error"] {
            // A coefficient held fixed has no standard error.
            Value::Null => {}
            value => match value.as_f64().filter(|error| *error >= 0.0) {
                Some(error) => errors.push((name.clone(), error)),
                None => bail!(
                    "{}: the std_error of {name} is {value}, expected a number of at least 0",
                    place()
                ),
            },
        }
    }
    let mut correlations = Vec::new();
    for (a, row) in report["correlations"].as_object().into_iter().flatten() {
        for (b, value) in row.as_object().into_iter().flatten() {
            if let Some(value) = value.as_f64().filter(|value| value.abs() <= 1.0 && a < b) {
                correlations.push((a.clone(), b.clone(), value));
            }
        }
    }
    let found = CoefficientErrors {
        errors,
        correlations,
    };
    Ok((found, analysis::doubt_of_fit(&report)))
}
