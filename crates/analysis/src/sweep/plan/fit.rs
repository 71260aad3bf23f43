//! Fitted coefficients as axes of a sweep, from the `report.json` of a fit.

use std::path::Path;

use flight::files::bounded_text;
use flight::release::Reader;
use serde_json::Value as Json;
use toml::de::DeTable;

use super::axes::{Axis, AxisKind, Names, Target};

/// Maximum size of `report.json`, bytes.
const MAX_BYTES: u64 = 64 << 20;

/// What a plan takes from a fit.
#[derive(Default)]
pub(super) struct Fitted {
    /// Coefficients that vary.
    pub axes: Vec<Axis>,
    /// Correlations of their estimates.
    pub correlations: Vec<(String, String, f64)>,
    /// Names and estimates of coefficients that do not vary: at a bound or without a standard error.
    pub fixed: Vec<(String, f64)>,
    /// Why the estimates are not to be relied on.
    pub doubt: Option<String>,
}

/// Reads the table `[fit]`: `report`, the path of a `report.json` relative to the plan, and optionally `coefficients`,
/// the names of those to vary, without those in `varied`. `None` without it or after a fault.
pub(super) fn read<'t>(
    reader: &mut Reader<'t>,
    document: &DeTable<'t>,
    folder: &Path,
    names: &Names<'_>,
    varied: &[Axis],
) -> Option<Fitted> {
    let table = document.get("fit")?;
    let (mut report, mut only) = (None, None);
    for (key, span, value) in reader.table(document, "fit") {
        match key {
            "report" => report = value.get_ref().as_str().map(|path| (path, value.span())),
            "coefficients" => {
                let items = value.get_ref().as_array();
                let texts = items.map(|items| items.iter().map(|item| item.get_ref().as_str()));
                only = texts.and_then(Iterator::collect::<Option<Vec<&str>>>);
                if only.is_none() {
                    let expected = "a list of names, as in [\"C_L0\"]";
                    reader.wrong_type(value, "coefficients", expected);
                }
            }
            _ => {
                let message =
                    format!("unknown key {key:?} in [fit]; expected report or coefficients");
                reader.fault(span, message);
            }
        }
    }
    let Some((path, span)) = report else {
        let message =
            "found no report in [fit]; expected one, as in report = \"fitted/report.json\"";
        return reader.refuse(table.span(), message);
    };
    let text = bounded_text(&folder.join(path), MAX_BYTES).map_err(|error| error.to_string());
    let json = text.and_then(|text| {
        serde_json::from_str::<Json>(&text).map_err(|error| format!("is no JSON: {error}"))
    });
    let json = match json {
        Ok(json) => json,
        Err(error) => return reader.refuse(span, format!("{path}: {error}")),
    };
    let Some(coefficients) = json["coefficients"].as_object() else {
        let message = format!("{path}: found no coefficients; expected the report.json of a fit");
        return reader.refuse(span, message);
    };
    for name in only.iter().flatten() {
        if !coefficients.contains_key(*name) {
            reader.fault(table.span(), format!("{path} has no coefficient {name:?}"));
        }
    }
    let mut found = Fitted {
        doubt: crate::doubt_of_fit(&json).map(|doubt| format!("{path}: {doubt}")),
        ..Fitted::default()
    };
    for (name, coefficient) in coefficients {
        let is_asked = only.as_ref().is_none_or(|only| only.contains(&&**name));
        if !is_asked || varied.iter().any(|axis| axis.name == *name) {
            continue;
        }
        let Some(parameter) = names.parameter(name) else {
            let message =
                format!("{path}: the model of the plan has no {name:?}, which was fitted");
            reader.fault(span.clone(), message);
            continue;
        };
        let Some(mean) = coefficient["value"].as_f64() else {
            reader.fault(span.clone(), format!("{path}: {name} has no value"));
            continue;
        };
        let plan = &names.release;
        let mut stated = plan.coefficients.iter().chain(&plan.parameters);
        if let Some((_, value)) = stated.find(|(own, value)| own == name && *value != mean) {
            let message = format!(
                "{path}: {name} is {value} in the plan and {mean} in the fit; expected one of the two: leave out that of the plan, \
                 or state in [fit] the coefficients to take, as in coefficients = [\"C_L0\"]"
            );
            reader.fault(span.clone(), message);
        }
        let sd = coefficient["std_error"].as_f64();
        let at_bound = coefficient["at_bound"].as_bool().unwrap_or(false);
        match sd.filter(|sd| *sd > 0.0 && sd.is_finite() && !at_bound) {
            Some(sd) => found.axes.push(Axis {
                name: name.clone(),
                target: Target::Parameter(parameter),
                kind: AxisKind::Normal { mean, sd },
            }),
            None => found.fixed.push((name.clone(), mean)),
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
    Some(found)
}
