//! The table of the coefficients: what a missing effect did to the others.

use diagnose::{Coefficient, Report};
use serde::Serialize;

use crate::fit::numbers::{Digits, plain, unit};

/// A coefficient that changes by more of its standard errors was biased.
const BIASED: f64 = 3.0;

/// One row.
#[derive(Serialize)]
pub(super) struct Row {
    name: String,
    before: String,
    value: String,
    error: String,
    /// Change in standard errors.
    change: String,
    biased: bool,
    /// Whether the extension brought it.
    added: bool,
    unit: String,
}

/// Whether anything is known of before.
pub(super) fn extended(report: &Report) -> bool {
    report.coefficients.values().any(|c| c.before.is_some())
}

/// The rows: what the model had, then what the extension adds.
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
