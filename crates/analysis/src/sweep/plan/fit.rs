//! Fitted coefficients as axes of a sweep: reads their estimates, standard errors and correlations from
//! `report.json`.

use std::path::Path;

use flight::release::Reader;
use serde_json::Value as Json;
use toml::de::DeTable;

use super::axes::{Axis, AxisKind, Names, Target};

/// Maximum size of the file `report.json` of a fit, from which standard errors are read, bytes.
const MAX_BYTES: u64 = 64 << 20;

/// The coefficients estimated by a fit, as quantities that the sweep varies, and the correlations of their estimates as
/// (name, name, correlation).
#[derive(Default)]
pub(super) struct FitAxes {
    pub axes: Vec<Axis>,
    pub correlations: Vec<(String, String, f64)>,
}

/// Reads the table `[fit]` of a sweep plan: `report`, the path of a fit's `report.json` relative to the plan, and
/// optionally `coefficients`, the names of the coefficients to vary (default: all).
///
/// Returns the coefficients to vary with their correlations, and the names and estimates of the coefficients that do
/// not vary because they are at a bound or have no standard error. Coefficients already in `varied` are in neither
/// result. Both results are empty if the plan has no table `[fit]`. Faults are reported to `reader`.
pub(super) fn read<'t>(
    reader: &mut Reader<'t>,
    document: &DeTable<'t>,
    folder: &Path,
    names: &Names<'_>,
    varied: &[Axis],
) -> (FitAxes, Vec<(String, f64)>) {
    let mut found = FitAxes::default();
    let mut fixed = Vec::new();
    let Some(table) = document.get("fit") else {
        return (found, fixed);
    };
    let entries = reader.table(document, "fit");
    let mut report = None;
    let mut only: Option<Vec<String>> = None;
    for (key, span, value) in entries {
        match key {
            "report" => report = value.get_ref().as_str().map(|path| (path, value.span())),
            "coefficients" => {
                let items = value.get_ref().as_array();
                let texts = items.and_then(|items| {
                    let text = |item: &flight::release::Value<'_>| {
                        Some(item.get_ref().as_str()?.to_owned())
                    };
                    items.iter().map(text).collect::<Option<Vec<_>>>()
                });
                match texts {
                    Some(texts) => only = Some(texts),
                    None => reader.wrong_type(
                        value,
                        "coefficients",
                        "a list of names, as in [\"C_L0\"]",
                    ),
                }
            }
            _ => reader.fault(
                span,
                format!("unknown key {key:?} in [fit]; expected report or coefficients"),
            ),
        }
    }
    let Some((path, span)) = report else {
        reader.fault(
            table.span(),
            "found no report in [fit]; expected one, as in report = \"fitted/report.json\"",
        );
        return (found, fixed);
    };
    let json = match open(&folder.join(path)) {
        Ok(json) => json,
        Err(error) => {
            reader.fault(span, format!("{path}: {error}"));
            return (found, fixed);
        }
    };
    let Some(coefficients) = json["coefficients"].as_object() else {
        reader.fault(
            span,
            format!("{path}: found no coefficients; expected the report.json of a fit"),
        );
        return (found, fixed);
    };
    for name in only.iter().flatten() {
        if !coefficients.contains_key(name) {
            reader.fault(table.span(), format!("{path} has no coefficient {name:?}"));
        }
    }
    for (name, coefficient) in coefficients {
        let is_asked = only.as_ref().is_none_or(|only| only.contains(name));
        if !is_asked || varied.iter().any(|axis| axis.name == *name) {
            continue;
        }
        let Some(parameter) = names.parameter(name) else {
            reader.fault(
                span.clone(),
                format!("{path}: the model of the plan has no {name:?}, which was fitted"),
            );
            continue;
        };
        let Some(mean) = coefficient["value"].as_f64() else {
            reader.fault(span.clone(), format!("{path}: {name} has no value"));
            continue;
        };
        let sd = coefficient["std_error"].as_f64().filter(|sd| *sd > 0.0);
        let at_bound = coefficient["at_bound"].as_bool().unwrap_or(false);
        match sd.filter(|sd| sd.is_finite() && !at_bound) {
            Some(sd) => found.axes.push(Axis {
                name: name.clone(),
                target: Target::Parameter(parameter),
                kind: AxisKind::Normal { mean, sd },
            }),
            None => fixed.push((name.clone(), mean)),
        }
    }
    for (k, a) in found.axes.iter().enumerate() {
        for b in &found.axes[..k] {
            let (a, b) = (&a.name, &b.name);
            let value = json["correlations"][a][b].as_f64();
            if let Some(value) = value.or(json["correlations"][b][a].as_f64()) {
                found.correlations.push((a.clone(), b.clone(), value));
            }
        }
    }
    (found, fixed)
}

/// Reason why the `report.json` of a fit cannot be read.
#[derive(Debug, thiserror::Error)]
enum ReportError {
    #[error(transparent)]
    Unreadable(#[from] std::io::Error),
    #[error("has {0} bytes; expected at most {MAX_BYTES}")]
    TooLong(u64),
    #[error("is no JSON: {0}")]
    Malformed(#[from] serde_json::Error),
}

fn open(path: &Path) -> Result<Json, ReportError> {
    let size = std::fs::metadata(path)?.len();
    if size > MAX_BYTES {
        return Err(ReportError::TooLong(size));
    }
    Ok(serde_json::from_str(&std::fs::read_to_string(path)?)?)
}
