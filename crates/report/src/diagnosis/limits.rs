//! Tables of effects that are not identifiable, minimum detectable effects, stepwise terms, score tests and flights.

use dataset::Role;
use diagnose::{CandidateTest, FlightGain, LackOfFit, Report, SmoothMisfit, StepwiseTerm};
use model_spec::sort_by_number;
use serde::Serialize;

use super::words;
use crate::fit::flights::short;
use crate::fit::words::names;
use crate::numbers::{Digits, millimetres, plain, significant, unit};

/// Maximum number of rows of a table in the HTML report of a diagnosis.
const MAX_ROWS: usize = 60;

/// Effects that are not identifiable from the flights: name of the effect, and names of the parameters with which it is
/// confounded.
pub(super) fn not_identifiable(report: &Report) -> Vec<[String; 2]> {
    let all = report.not_identifiable.iter().take(MAX_ROWS);
    all.map(|u| {
        let absorbed = names(&u.confounded_with);
        let by = if absorbed.is_empty() {
            "nothing: it has no influence in these flights".to_owned()
        } else {
            absorbed
        };
        [u.name.clone(), by]
    })
    .collect()
}

/// Table of minimum detectable effects: for each coefficient of an effect, the name of the effect, the coefficient, the
/// minimum detectable size and its unit.
pub(super) fn detectable(report: &Report) -> Vec<[String; 4]> {
    let all = report.minimum_detectable_effects.iter().take(MAX_ROWS);
    all.map(|d| {
        let size = significant(d.value, 2);
        [d.name.clone(), d.coefficient.clone(), size, unit(&d.unit)]
    })
    .collect()
}

/// Table row of a library term tested by stepwise regression, with all values formatted as text.
#[derive(Serialize)]
pub(super) struct TermRow {
    site: String,
    formula: String,
    score_chi2: String,
    value: String,
    error: String,
    taken: bool,
}

/// Table rows of the library terms tested by stepwise regression, in the order of the tests.
pub(super) fn terms(terms: &[StepwiseTerm]) -> Vec<TermRow> {
    let row = |term: &StepwiseTerm| {
        let digits = Digits::of(term.value, term.std_error);
        TermRow {
            site: words::site(&term.site).to_owned(),
            formula: term.formula.clone(),
            score_chi2: significant(term.score_chi2, 4),
            value: digits.one(term.value),
            error: digits.one(term.std_error),
            taken: term.selected,
        }
    };
    terms.iter().take(MAX_ROWS).map(row).collect()
}

/// Table row of the score test of a candidate effect, with all values formatted as text.
#[derive(Serialize)]
pub(super) struct Score {
    name: String,
    doc: String,
    site: String,
    z: String,
    score_chi2: String,
    degrees_of_freedom: usize,
    p: String,
    tolerance: String,
    one_step_estimates: String,
    significant: bool,
}

/// Table rows of the score tests of candidate effects, in the order of the report: the most significant candidate
/// first.
pub(super) fn scores(report: &Report) -> Vec<Score> {
    let row = |c: &CandidateTest| {
        let expected = c.one_step_estimates.iter().take(6).map(|(name, e)| {
            let digits = Digits::of(e.value, e.std_error);
            let (value, error) = (digits.one(e.value), digits.one(e.std_error));
            let unit = unit(&e.unit);
            let text = format!("{name} = {value} ± {error} {unit}");
            text.trim_end().to_owned()
        });
        Score {
            name: c.name.clone(),
            doc: c.description.replace('\n', " "),
            site: words::site(&c.site).to_owned(),
            z: words::equivalent_z(c.z),
            score_chi2: significant(c.score_chi2, 4),
            degrees_of_freedom: c.degrees_of_freedom,
            p: words::probability_of_ln(c.ln_p_value),
            tolerance: crate::numbers::percent(c.tolerance),
            one_step_estimates: expected.collect::<Vec<_>>().join("; "),
            significant: c.significant,
        }
    };
    report.tests.iter().take(MAX_ROWS).map(row).collect()
}

/// Table row of a flight in the report of a diagnosis: file, role, and RMS residual without and with the effects added
/// to the model.
#[derive(Serialize)]
pub(super) struct Flight {
    file: String,
    held_out: bool,
    before: String,
    after: String,
    /// Decrease of the RMS residual by the effects added to the model, formatted with its unit, mm; negative if the
    /// residual increases; `–` if no effects were added or the flight has no RMS residual.
    gain: String,
    /// Whether the RMS residual of the flight is larger with the effects added to the model than without.
    worse: bool,
    /// p-value of the flight's lack-of-fit test; `–` if the flight was not tested.
    p: String,
    /// Whether the flight is left out of the comparison of prediction errors, because neither the model under test nor
    /// the extended model predicts it.
    apart: bool,
    /// Reason why the flight was excluded from the fit or from the prediction; `None` if it was not excluded.
    excluded: Option<String>,
}

/// Table rows of the flights, in dataset order. If there are more than [`MAX_ROWS`], only the flights with the largest
/// RMS residuals, in descending order.
pub(super) fn flights(report: &Report) -> Vec<Flight> {
    let mut all: Vec<&FlightGain> = report.flights.iter().collect();
    if all.len() > MAX_ROWS {
        let size = |f: &FlightGain| match f.rms_before_m {
            Some(rms) if rms.is_nan() => f64::INFINITY,
            Some(rms) => rms,
            None => f64::NEG_INFINITY,
        };
        sort_by_number(&mut all, |flight| -size(flight));
        all.truncate(MAX_ROWS);
    }
    let tested = report.lack_of_fit.as_ref().map(|test| &test.flights);
    let is_apart = |f: &FlightGain| {
        let gain = report.predictive_gain.as_ref();
        gain.is_some_and(|gain| gain.set_apart.contains(&f.file))
    };
    let gain = |f: &FlightGain| Some(f.rms_before_m? - f.rms_after_m?);
    let row = |f: &FlightGain| Flight {
        gain: gain(f).map_or("–".to_owned(), millimetres),
        worse: gain(f).is_some_and(|gain| gain < 0.0),
        p: tested
            .and_then(|tested| tested.get(&f.file))
            .map_or("–".to_owned(), |p| words::probability(*p)),
        apart: is_apart(f),
        excluded: f.outcome.reason().map(short),
        file: f.file.clone(),
        held_out: f.role == Role::HeldOut,
        before: f.rms_before_m.map_or("–".to_owned(), millimetres),
        after: f.rms_after_m.map_or("–".to_owned(), millimetres),
    };
    all.into_iter().map(row).collect()
}

/// Lack-of-fit test of the residuals of the fit, with all values formatted as text.
#[derive(Serialize)]
pub(super) struct LackOfFitText {
    description: String,
    head: [&'static str; 6],
    /// Rows of the largest smooth deviations of the residuals from zero, smallest p-value first; the field `head` names
    /// the columns.
    largest_misfits: Vec<[String; 6]>,
}

/// Formats the lack-of-fit test with a table of the largest smooth deviations of the residuals from zero.
pub(super) fn lack_of_fit(test: &LackOfFit) -> LackOfFitText {
    let row = |d: &SmoothMisfit| {
        [
            d.file.clone(),
            d.coordinate.clone(),
            plain(d.from_s, 2),
            plain(d.to_s, 2),
            match d.unit.as_str() {
                "" | "m" => millimetres(d.size_m),
                unit => format!("{} {unit}", significant(d.size_m, 3)),
            },
            words::probability(d.p_value),
        ]
    };
    LackOfFitText {
        description: words::lack_of_fit(test),
        head: [
            "flight",
            "coordinate",
            "from, s",
            "to, s",
            "largest departure",
            "p",
        ],
        largest_misfits: test
            .largest_misfits
            .iter()
            .take(MAX_ROWS)
            .map(row)
            .collect(),
    }
}
