//! Table of the coefficients before and after the model is extended.

use diagnose::{Coefficient, Report};
use model_spec::sort_by_number;

use crate::html::Html;
use crate::table::{Cell, Table};
use identify::numbers::{Digits, plain, unit};

/// Minimum difference between the estimates of a coefficient without and with the effects added by the diagnosis, in
/// standard errors, for the estimate without them to count as biased.
const BIASED: f64 = 3.0;

/// Coefficients of the model under test, then those of the effects that the diagnosis added to it.
pub(super) fn section(report: &Report) -> Html {
    let is_extended = report.coefficients.values().any(|c| c.before.is_some());
    let mut all: Vec<_> = report.coefficients.iter().collect();
    sort_by_number(&mut all, |(_, found)| f64::from(found.before.is_none()));
    let digits = |c: &Coefficient| Digits::of(c.value, c.std_error);
    let change = |c: &Coefficient| {
        let change = (c.value - c.before?) / c.std_error;
        Some(change).filter(|change| change.is_finite() && c.std_error > 0.0)
    };
    let sign = |change: f64| if change >= 0.05 { "+" } else { "" };
    let standard_errors = |c: f64| format!("{}{}", sign(c), plain(c, 1));
    let value = if is_extended { "extended" } else { "value" };
    let table = Table::of(all)
        .name("", |(name, _)| *name)
        .when(is_extended, |rows| {
            rows.number("before", |(_, c)| c.before.map(|v| digits(c).one(v)))
        })
        .number(value, |(_, c)| digits(c).one(c.value))
        .when(is_extended, |rows| {
            rows.number("change, σ", |(_, c)| {
                let is_biased = change(c).is_some_and(|c| c.abs() > BIASED);
                Cell::from(change(c).map(standard_errors)).doubtful_if(is_biased)
            })
        })
        .number("standard error", |(_, c)| digits(c).one(c.std_error))
        .plain("unit", |(_, c)| unit(&c.unit))
        .when(is_extended, |rows| {
            rows.plain("", |(_, c)| match c.before {
                Some(_) => Html::new(),
                None => Html::tag("added"),
            })
        })
        .table();
    let mut content = Html::new();
    content.table(&table);
    if is_extended {
        content.note(
            "The change is in standard errors of the extended fit. A missing effect biases the other coefficients \
             (omitted-variable bias) while their standard errors stay small; changes above 3 are marked.",
        );
    }
    content
}
