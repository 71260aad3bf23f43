//! Fitted coefficients as axes of a sweep, from the `report.json` of a fit.

use std::path::Path;

use flight::release::Reader;
use toml::de::DeTable;

use super::axes::{Axis, AxisKind, Names, Target};
use crate::Estimates;

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
    let text = Estimates::text(&folder.join(path));
    let estimates = match text.and_then(|text| Estimates::read(&text)) {
        Ok(estimates) => estimates,
        Err(error) => return reader.refuse(span, format!("{path}: {error}")),
    };
    for name in only.iter().flatten() {
        if !estimates.coefficients.iter().any(|own| own.name == *name) {
            reader.fault(table.span(), format!("{path} has no coefficient {name:?}"));
        }
    }
    let mut found = Fitted {
        doubt: estimates.doubt.map(|doubt| format!("{path}: {doubt}")),
        ..Fitted::default()
    };
    for own in estimates.coefficients {
        let is_asked = only.as_ref().is_none_or(|only| only.contains(&&*own.name));
        if !is_asked || varied.iter().any(|axis| axis.name == own.name) {
            continue;
        }
        let Some(parameter) = names.parameter(&own.name) else {
            let name = own.name;
            let message =
                format!("{path}: the model of the plan has no {name:?}, which was fitted");
            reader.fault(span.clone(), message);
            continue;
        };
        let plan = &names.release;
        let mut stated = plan.coefficients.iter().chain(&plan.parameters);
        if let Some((name, value)) =
            stated.find(|(name, value)| *name == own.name && *value != own.value)
        {
            let message = format!(
                "{path}: {name} is {value} in the plan and {} in the fit; expected one of the two: leave out that of the plan, \
                 or state in [fit] the coefficients to take, as in coefficients = [\"C_L0\"]",
                own.value
            );
            reader.fault(span.clone(), message);
        }
        match own.std_error {
            Some(sd) => found.axes.push(Axis {
                name: own.name,
                target: Target::Parameter(parameter),
                kind: AxisKind::Normal {
                    mean: own.value,
                    sd,
                },
            }),
            None => found.fixed.push((own.name, own.value)),
        }
    }
    let varies = |name: &str| found.axes.iter().any(|axis| axis.name == name);
    let of_axes = estimates.correlations.into_iter();
    let of_axes = of_axes.filter(|(a, b, _)| varies(a) && varies(b));
    found.correlations = of_axes.collect();
    Some(found)
}
