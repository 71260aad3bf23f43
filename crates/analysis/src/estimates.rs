//! What a fit estimated, from its `report.json`, for whatever flies with it.

use std::path::Path;

use flight::files::{bounded_text, json};
use serde_json::Value;

/// Maximum size of `report.json`, bytes.
const MAX_BYTES: u64 = 64 << 20;

/// What is read, in messages.
const WHAT: &str = "the report.json that `hyzer fit DATASET --out DIR` writes";

/// Estimates of a fit, with their errors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Estimates {
    /// The coefficients, in the order of the report.
    pub coefficients: Vec<Estimated>,
    /// Correlations of pairs of coefficients; others are uncorrelated.
    pub correlations: Vec<(String, String, f64)>,
    /// Why the estimates are not to be relied on; `None` if the fit is reliable.
    pub doubt: Option<String>,
}

/// Estimate of one coefficient.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimated {
    /// Name of the coefficient.
    pub name: String,
    /// Estimate, SI.
    pub value: f64,
    /// Standard error, SI, above 0; `None` for a coefficient that is held or at a bound.
    pub std_error: Option<f64>,
}

impl Estimates {
    /// Reads the text of a `report.json`, which may be large.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn text(file: &Path) -> Result<String, String> {
        bounded_text(file, MAX_BYTES, WHAT).map_err(|error| error.to_string())
    }

    /// Reads the estimates from the text of a `report.json`.
    ///
    /// # Errors
    /// If the text is not the report of a fit: what was found, and what was expected.
    pub fn read(text: &str) -> Result<Estimates, String> {
        let report: Value = json(text, WHAT).map_err(|error| error.to_string())?;
        let Some(coefficients) = report["coefficients"].as_object() else {
            return Err(format!("found no coefficients; expected {WHAT}"));
        };
        let coefficients = coefficients.iter().map(|(name, own)| estimated(name, own));
        let coefficients = coefficients.collect::<Result<Vec<_>, _>>()?;
        let rows = &report["correlations"];
        let mut correlations = Vec::new();
        for (a, row) in rows.as_object().into_iter().flatten() {
            for (b, value) in row.as_object().into_iter().flatten() {
                // Of a pair that is stated in both orders, one.
                let is_first = a < b || a != b && rows[b][a].is_null();
                if let Some(value) = value.as_f64().filter(|own| is_first && own.abs() <= 1.0) {
                    correlations.push((a.clone(), b.clone(), value));
                }
            }
        }
        let doubt = (report["reliable"] == false).then(|| {
            let first = report["cautions"][0].as_str().unwrap_or("see its report");
            format!("this fit is not reliable, and its errors may be far larger: {first}")
        });
        Ok(Estimates {
            coefficients,
            correlations,
            doubt,
        })
    }
}

fn estimated(name: &str, own: &Value) -> Result<Estimated, String> {
    let Some(value) = own["value"].as_f64() else {
        let found = &own["value"];
        return Err(format!("the value of {name} is {found}, expected a number"));
    };
    let std_error = match &own["std_error"] {
        Value::Null => None,
        error => match error.as_f64().filter(|error| *error >= 0.0) {
            Some(error) => Some(error),
            None => {
                return Err(format!(
                    "the std_error of {name} is {error}, expected a number of at least 0"
                ));
            }
        },
    };
    let is_free = own["at_bound"] != true;
    Ok(Estimated {
        name: name.to_owned(),
        value,
        std_error: std_error.filter(|error| is_free && *error > 0.0),
    })
}
