//! Table of the coefficients before and after the model is extended.

use diagnose::Report;
use model_spec::sort_by_number;

use crate::html::Html;
use crate::table::{Cell, Column, Table};
use identify::numbers::{Digits, plain, unit};

/// Minimum difference between the estimates of a coefficient without and with the effects added by the diagnosis, in
/// standard errors, for the estimate without them to count as biased.
const BIASED: f64 = 3.0;

/// Coefficients of the model under test, then those of the effects that the diagnosis added to it.
pub(super) fn section(report: &Report) -> Html {
    let is_extended = report.coefficients.values().any(|c| c.before.is_some());
    let mut all: Vec<_> = report.coefficients.iter().collect();
    sort_by_number(&mut all, |(_, found)| f64::from(found.before.is_none()));
    let numbers: &[&str] = if is_extended {
        &["before", "extended", "change, σ", "standard error"]
    } else {
        &["value", "standard error"]
    };
    let mut table = Table::new()
        .with(Column::Name, &[""])
        .with(Column::Number, numbers)
        .with(Column::Plain, &["unit"]);
    if is_extended {
        table = table.with(Column::Plain, &[""]);
    }
    for (name, found) in all {
        let digits = Digits::of(found.value, found.std_error);
        let number = |value: f64| Cell::from(digits.one(value));
        let (value, error) = (number(found.value), number(found.std_error));
        let unit = Cell::from(unit(&found.unit));
        if !is_extended {
            table.row([name.into(), value, error, unit]);
            continue;
        }
        let change = found
            .before
            .map(|before| (found.value - before) / found.std_error);
        let change = change.filter(|c| c.is_finite() && found.std_error > 0.0);
        let sign = |change: f64| if change >= 0.05 { "+" } else { "" };
        let text = change.map_or("–".to_owned(), |c| format!("{}{}", sign(c), plain(c, 1)));
        let added = match found.before {
            Some(_) => Html::new(),
            None => Html::tag("added"),
        };
        table.row([
            name.into(),
            found.before.map_or("–".into(), number),
            value,
            Cell::from(text).doubtful_if(change.is_some_and(|c| c.abs() > BIASED)),
            error,
            unit,
            added.into(),
        ]);
    }
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
