//! Table of the coefficients before and after the model is extended.

use diagnose::{Coefficient, Report};
use serde::Serialize;

use crate::numbers::{Digits, plain, unit};

/// Minimum difference between the estimates of a coefficient without and with the effects added by the diagnosis, in
/// standard errors, for the estimate without them to count as biased.
const BIASED: f64 = 3.0;

/// Row of the coefficient table of a diagnosis, with all values formatted as text.
#[derive(Serialize)]
pub(super) struct Row {
    name: String,
    before: String,
    value: String,
    error: String,
    /// Change of the estimate when the effects found by the diagnosis are added to the model, in standard errors,
    /// formatted.
    change: String,
    biased: bool,
    /// Whether the coefficient belongs to an effect that the diagnosis added to the model.
    added: bool,
    unit: String,
}

/// Whether the diagnosis extended the model by effects: at least one coefficient has an estimate both without and with
/// these effects.
pub(super) fn extended(report: &Report) -> bool {
    report.coefficients.values().any(|c| c.before.is_some())
}

/// Rows of the coefficient table of a diagnosis: coefficients of the model under test, then those of the effects added
/// to it.
pub(super) fn rows(report: &Report) -> Vec<Row> {
    let extended = extended(report);
    let all = report.coefficients.iter();
    let mut rows: Vec<Row> = all
        .map(|(name, found)| row(name, found, extended))
        .collect();
    rows.sort_by_key(|row| row.added);
    rows
}

fn row(name: &str, found: &Coefficient, extended: bool) -> Row {
    let digits = Digits::of(found.value, found.std_error);
    let change = found
        .before
        .filter(|_| found.std_error > 0.0)
        .map(|before| (found.value - before) / found.std_error)
        .filter(|c| c.is_finite());
    let sign = if change.is_some_and(|c| c >= 0.05) {
        "+"
    } else {
        ""
    };
    Row {
        name: name.to_owned(),
        before: found.before.map_or("–".to_owned(), |b| digits.one(b)),
        value: digits.one(found.value),
        error: digits.one(found.std_error),
        change: change.map_or("–".to_owned(), |c| format!("{sign}{}", plain(c, 1))),
        biased: change.is_some_and(|c| c.abs() > BIASED),
        added: extended && found.before.is_none(),
        unit: unit(&found.unit),
    }
}
