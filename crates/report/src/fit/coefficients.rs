//! Tables of the estimated coefficients, and of their values in the literature.

use identify::Coefficient;

use super::FitPage;
use crate::html::Html;
use crate::literature::sources;
use crate::table::{Cell, Table};
use identify::numbers::{Digits, stated, unit};

/// Ratio of the cluster-robust to the other standard error above which it is marked.
const DOUBTFUL: f64 = 1.5;

/// Tables of the coefficients, in the order of the model; those that it does not declare are last.
pub(super) fn section(page: &FitPage<'_>) -> Html {
    let mut content = Html::new();
    let all = page.coefficients();
    if all.is_empty() {
        return content;
    }
    content.table(&estimates(&all));
    let mut note = "Figure: the value and its 95 % interval; the grey line is 0, the orange tick the default of the model’s file, \
                    where it is in range."
        .to_owned();
    if is_clustered(&all) {
        note += " The cluster-robust standard error (by flight) is computed from the differences between the flights; it is \
                 marked where it exceeds the other by half or more.";
    }
    content.note(note);
    content.heading("Compared with the literature");
    content.table(&literature(page, &all));
    let sources = sources(page.model.reference.as_deref()).iter();
    let cited =
        sources.map(|source| Html::strong(&source.short).then(format!(": {}", source.long)));
    content.list("note", cited);
    content
}

fn is_clustered(all: &[(&str, &Coefficient)]) -> bool {
    let mut all = all.iter();
    all.any(|(_, c)| c.std_error_cluster_robust.is_some())
}

/// Table of the estimates with their standard errors and intervals.
pub(super) fn estimates(all: &[(&str, &Coefficient)]) -> Table {
    let digits = |c: &Coefficient| Digits::of(c.value, c.std_error);
    let estimated = |c: &Coefficient, text: String| Some(text).filter(|_| !c.fixed);
    let clustered = |c: &Coefficient| {
        let error = c.std_error_cluster_robust;
        let is_larger = error.is_some_and(|e| e > DOUBTFUL * c.std_error);
        let cell = Cell::from(error.map(|e| digits(c).one(e)));
        cell.doubtful_if(is_larger && !c.fixed)
    };
    Table::of(all)
        .name("", |(name, _)| *name)
        .number("value", |(_, c)| digits(c).one(c.value))
        .number("standard error", |(_, c)| {
            estimated(c, digits(c).one(c.std_error))
        })
        .plain("unit", |(_, c)| unit(&c.unit))
        .number("95 % interval", |(_, c)| {
            estimated(c, digits(c).range(c.interval))
        })
        .plain("", |(_, c)| picture(c))
        .when(is_clustered(all), |rows| {
            rows.number("cluster-robust error", |(_, c)| clustered(c))
        })
        .plain("", |(_, c)| remarks(c))
        .table()
}

/// Whether an estimate is at a bound or fixed, and its prior.
fn remarks(found: &Coefficient) -> Html {
    let mut remarks = Html::new();
    if found.at_bound {
        remarks.push(Html::warning_tag("at its bound").then(" "));
    }
    if found.fixed {
        remarks.push(Html::tag("held").then(" "));
    }
    if let Some([mean, deviation]) = found.prior {
        let digits = Digits::of(mean, deviation);
        let prior = format!("prior {} ± {}", digits.one(mean), digits.one(deviation));
        remarks.push(Html::tag(prior));
    }
    remarks
}

fn literature(page: &FitPage<'_>, all: &[(&str, &Coefficient)]) -> Table {
    let digits = |c: &Coefficient| Digits::of(c.value, c.std_error);
    let meaning = |name: &str| {
        let mut known = page.model.coefficients.iter().chain(&page.model.params);
        let known = known.find(|c| c.name == name);
        known.map_or(String::new(), |c| c.doc.replace('\n', " "))
    };
    let mut rows = Table::of(all)
        .name("", |(name, _)| *name)
        .number("this fit", |(_, c)| digits(c).one(c.value))
        .number("model’s file", |(_, c)| stated(c.model_value));
    for source in sources(page.model.reference.as_deref()) {
        rows = rows.number(&source.short, |(name, _)| source.values.get(*name).cloned());
    }
    rows.plain("unit", |(_, c)| unit(&c.unit))
        .text("meaning", |(name, _)| meaning(name))
        .table()
}

/// Picture of an estimate and its interval on an axis that includes 0; empty without an interval.
fn picture(found: &Coefficient) -> Html {
    let [low, high] = found.interval;
    let all = [low, high, found.value];
    let is_estimated = !found.fixed && found.std_error > 0.0;
    if !is_estimated || !all.iter().all(|v| v.is_finite()) || low > high {
        return Html::new();
    }
    // The value in the model file is drawn unless the axis would have to be much longer for it.
    let near = all.iter().fold(0.0_f64, |a, v| a.max(v.abs()));
    let model = Some(found.model_value).filter(|m| m.is_finite() && m.abs() <= 2.0 * near);
    let values = || all.into_iter().chain(model);
    let (least, greatest) = (values().fold(0.0, f64::min), values().fold(0.0, f64::max));
    if least == greatest {
        return Html::new();
    }
    // Percent of the length of the axis.
    let at = |v: f64| (10.0 * (4.0 + 92.0 * (v - least) / (greatest - least))).round() / 10.0;
    let line = |class: &str, [x1, x2]: [f64; 2], [y1, y2]: [f64; 2]| {
        format!("<line class=\"{class}\" x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"/>")
    };
    let zero = line("null", [at(0.0); 2], [1.0, 15.0]);
    let model = model.map(|m| line("model", [at(m); 2], [2.5, 13.5]));
    let interval = line("reach", [at(low), at(high)], [8.0; 2]);
    Html::trusted(format!(
        "<svg class=\"interval\" viewBox=\"0 0 100 16\" width=\"100\" height=\"16\" aria-hidden=\"true\">{zero}{}{interval}\
         <circle class=\"value\" cx=\"{}\" cy=\"8\" r=\"3\"/></svg>",
        model.unwrap_or_default(),
        at(found.value)
    ))
}
