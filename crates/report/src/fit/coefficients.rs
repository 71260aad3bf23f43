//! Table of the estimated coefficients, compared with values from the literature.

use identify::Coefficient;
use serde::Serialize;

use super::FitPage;
use crate::literature::{Source, sources};
use crate::numbers::{Digits, stated, unit};

/// Row of the table of fitted coefficients, with all values formatted as text.
#[derive(Serialize)]
pub(super) struct Row {
    name: String,
    doc: String,
    value: String,
    interval: String,
    error: String,
    clustered: String,
    /// Whether the cluster-robust standard error (from the scatter between flights) is more than 1.5 times the
    /// Cramér–Rao standard error.
    doubtful: bool,
    unit: String,
    at_bound: bool,
    /// Notes on the estimate: whether it was fixed, and its Gaussian prior.
    notes: Vec<String>,
    picture: Option<Picture>,
    /// Values of the coefficient for comparison: that in the model file, then that in each literature source.
    literature: Vec<String>,
}

/// Confidence interval and estimate of a coefficient, drawn on an axis that includes 0; positions in percent of the
/// axis length, 0 to 100.
#[derive(Serialize)]
struct Picture {
    zero: f64,
    low: f64,
    high: f64,
    value: f64,
    model: Option<f64>,
}

/// Rows of the table of fitted coefficients: first the coefficients in the order of declaration in the model, then
/// those that the model does not declare.
pub(super) fn rows(page: &FitPage<'_>) -> Vec<Row> {
    let sources = sources(page.model.reference.as_deref());
    let found = page.coefficients().into_iter();
    found.map(|(name, c)| row(page, name, c, sources)).collect()
}

fn row(page: &FitPage<'_>, name: &str, found: &Coefficient, sources: &[Source]) -> Row {
    let digits = Digits::of(found.value, found.std_error);
    let mut known = page.model.coefficients.iter().chain(&page.model.params);
    let known = known.find(|c| c.name == name);
    let mut notes = Vec::new();
    if found.fixed {
        notes.push("held".to_owned());
    }
    if let Some([mean, deviation]) = found.prior {
        let digits = Digits::of(mean, deviation);
        let prior = format!("prior {} ± {}", digits.one(mean), digits.one(deviation));
        notes.push(prior);
    }
    let estimated = !found.fixed && found.std_error > 0.0;
    let if_estimated = |text: String| if found.fixed { "–".to_owned() } else { text };
    let mut literature = vec![stated(found.model_value)];
    for source in sources {
        let value = source.value(name);
        literature.push(value.map_or("–".to_owned(), |v| v.to_string()));
    }
    Row {
        name: name.to_owned(),
        doc: known.map_or(String::new(), |c| c.doc.replace('\n', " ")),
        value: digits.one(found.value),
        interval: if_estimated(digits.range(found.interval)),
        error: if_estimated(digits.one(found.std_error)),
        clustered: found
            .std_error_cluster_robust
            .map_or("–".to_owned(), |e| digits.one(e)),
        doubtful: found
            .std_error_cluster_robust
            .is_some_and(|e| e > 1.5 * found.std_error)
            && !found.fixed,
        unit: unit(&found.unit),
        at_bound: found.at_bound,
        notes,
        picture: if estimated { picture(found) } else { None },
        literature,
    }
}

fn picture(found: &Coefficient) -> Option<Picture> {
    let [low, high] = found.interval;
    let model = found.model_value;
    let all = [low, high, found.value];
    if !all.iter().all(|v| v.is_finite()) || low > high {
        return None;
    }
    // The value in the model file is drawn unless the axis would have to be much longer for it.
    let near = all.iter().fold(0.0_f64, |a, v| a.max(v.abs()));
    let model = Some(model).filter(|m| m.is_finite() && m.abs() <= 2.0 * near);
    let values = || all.into_iter().chain(model);
    let (least, greatest) = (values().fold(0.0, f64::min), values().fold(0.0, f64::max));
    if least == greatest {
        return None;
    }
    let at = |v: f64| (10.0 * (4.0 + 92.0 * (v - least) / (greatest - least))).round() / 10.0;
    Some(Picture {
        zero: at(0.0),
        low: at(low),
        high: at(high),
        value: at(found.value),
        model: model.map(at),
    })
}
