//! One run: what was hidden, what the diagnosis said of it, and what that is worth.

use std::collections::BTreeMap;
use std::sync::Mutex;

use diagnose::diagnosis::{Asked, Diagnosed, diagnose};
use diagnose::report::{Report, Verdict};
use identify::dataset::{Dataset, Role};
use identify::{Fit, FitOptions, fit};
use model_spec::model::Model;

use super::case::Case;
use crate::seeded::input_errors::Told;
use crate::seeded::{file_of, unlisted};

/// The quantile that is exceeded nine times in ten.
const POWER: f64 = 1.281_551_565_544_6;

/// What came of a run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The case.
    pub case: Case,
    /// The verdict; none where the diagnosis failed.
    pub verdict: Option<Verdict>,
    /// Why it failed.
    pub failed: Option<String>,
    /// The effects of each cause, sorted, with underscores.
    pub causes: Vec<Vec<String>>,
    /// The rival of each cause with its probability.
    pub rivals: Vec<Option<(String, f64)>>,
    /// Whether what was hidden is among the causes; from outside the catalogue, whether the verdict says so.
    pub in_set: bool,
    /// Whether there is exactly one cause and it is not the one.
    pub wrong: bool,
    /// Whether the report says that the flights cannot show it.
    pub undetectable: bool,
    /// Its size over the smallest detectable, of several effects the least.
    pub detectable_sizes: Option<f64>,
    /// Its own score, as the size of a standard normal number: of several effects the least.
    pub sigmas: Option<f64>,
    /// Flights that are said to contradict, and how many of them were told another flight's spin.
    pub contradicting: (usize, usize),
    /// Sites of the terms that were written, for what is outside the catalogue.
    pub sites: Vec<String>,
    /// Error of prediction on held-out flights without an extension, m.
    pub held_out_before: f64,
    /// With it.
    pub held_out_after: f64,
    /// With what was hidden switched on; none where no model has it.
    pub held_out_true: Option<f64>,
    /// Time that the diagnosis took, s.
    pub seconds: f64,
}

/// Models by what is switched on, each loaded once.
#[derive(Default)]
pub struct Truths(Mutex<BTreeMap<String, Model>>);

impl Truths {
    /// The model of a body with effects.
    ///
    /// # Panics
    /// Where built-in effects cannot be switched on together.
    pub fn model(&self, model: &str, effects: &[&str]) -> Model {
        let key = format!("{model} {}", effects.join(" "));
        let mut known = self.0.lock().unwrap_or_else(|p| p.into_inner());
        let load = || model_spec::load::load(model, effects).expect("built-in effects");
        known.entry(key).or_insert_with(load).clone()
    }
}

/// Runs are worked on side by side: each has one thread.
pub fn alone() -> FitOptions<'static> {
    FitOptions {
        threads: Some(1),
        ..FitOptions::default()
    }
}

impl Outcome {
    /// Whether something was found at all.
    pub fn alarmed(&self) -> bool {
        self.verdict.is_some_and(|verdict| verdict != Verdict::None)
    }

    /// Error on held-out flights over that of the true model.
    pub fn held_out_ratio(&self) -> Option<f64> {
        Some(self.held_out_after / self.held_out_true?)
    }

    fn of(case: &Case) -> Self {
        Self {
            case: case.clone(),
            verdict: None,
            failed: None,
            causes: Vec::new(),
            rivals: Vec::new(),
            in_set: false,
            wrong: false,
            undetectable: false,
            detectable_sizes: None,
            sigmas: None,
            contradicting: (0, 0),
            sites: Vec::new(),
            held_out_before: f64::NAN,
            held_out_after: f64::NAN,
            held_out_true: None,
            seconds: f64::NAN,
        }
    }
}

/// Makes the flights, has them diagnosed, and compares.
pub fn run(case: &Case, truths: &Truths) -> Outcome {
    let dataset = case.dataset();
    let base = truths.model(case.body.model(), &[]);
    let asked = Asked {
        dataset: "hidden",
        fit: alone(),
        ..Asked::default()
    };
    let mut outcome = Outcome::of(case);
    let found = match diagnose(&base, &dataset, &asked) {
        Ok(found) => found,
        Err(error) => {
            outcome.failed = Some(error.to_string());
            return outcome;
        }
    };
    let report = &found.report;
    outcome.verdict = Some(report.verdict);
    outcome.seconds = report.seconds.get("total").copied().unwrap_or(f64::NAN);
    outcome.causes = causes(report);
    let rivals = report.causes.iter().map(|cause| {
        let rival = cause.rival.as_ref()?;
        Some((underscored(&rival.name), rival.p))
    });
    outcome.rivals = rivals.collect();
    judge(&mut outcome, report);
    held_out(&mut outcome, &found, &dataset, truths);
    outcome
}

/// Names are the same with hyphens and with underscores.
fn underscored(name: &str) -> String {
    name.replace('-', "_")
}

/// The effects of each cause, in an order of their own.
fn causes(report: &Report) -> Vec<Vec<String>> {
    let each = report.causes.iter().map(|cause| {
        let names = cause.effects.iter().map(|effect| underscored(&effect.name));
        let mut names: Vec<String> = names.collect();
        names.sort();
        names
    });
    each.collect()
}

/// What is hidden, in the same order.
fn truth(case: &Case) -> Vec<String> {
    let names = case.hidden.effects.iter().map(|(name, _)| name.clone());
    let mut names: Vec<String> = names.collect();
    names.sort();
    names
}

/// Holds what was said against what was hidden.
fn judge(outcome: &mut Outcome, report: &Report) {
    let hidden = outcome.case.hidden.clone();
    let truth = truth(&outcome.case);
    let single =
        outcome.causes.len() == 1 && matches!(report.verdict, Verdict::Named | Verdict::Immaterial);
    if let Some((name, _)) = hidden.outside.first() {
        let site = unlisted::by_name(name).expect("one from outside").site;
        let terms = report.outside.iter().flat_map(|outside| &outside.terms);
        let taken = terms.filter(|term| term.taken);
        outcome.sites = taken.map(|term| term.site.clone()).collect();
        outcome.sites.dedup();
        outcome.in_set = report.verdict == Verdict::Outside;
        outcome.wrong = single;
        debug_assert!(!site.is_empty());
        return;
    }
    if let Some(told) = outcome.case.told {
        outcome.contradicting = contradicting(&outcome.case, told, report);
        outcome.in_set = outcome.causes.contains(&truth);
        // Where nobody's spin is his own it says nothing.
        outcome.wrong = single && (outcome.causes[0] != truth || told.swapped == 1.0);
        return;
    }
    let mut shown: Vec<String> = Vec::new();
    for (name, values) in &hidden.effects {
        let gone = report.undetectable.iter();
        let gone = gone
            .clone()
            .any(|hidden| underscored(&hidden.name) == *name);
        let sizes = if gone {
            Some(0.0)
        } else {
            detectable_sizes(report, name, values)
        };
        outcome.undetectable |= gone;
        if sizes.is_none_or(|sizes| sizes >= 1.0) {
            shown.push(name.clone());
        }
        outcome.detectable_sizes = least(outcome.detectable_sizes, sizes);
        let mut scores = report.candidates.iter();
        let score = scores.find(|score| underscored(&score.name) == *name);
        outcome.sigmas = least(outcome.sigmas, score.map(|score| score.sigmas));
    }
    shown.sort();
    outcome.in_set = !truth.is_empty() && outcome.causes.contains(&truth);
    // Of two effects, one of which is too small to be seen, the other alone is right.
    let right = |cause: &Vec<String>| *cause == truth || (!shown.is_empty() && *cause == shown);
    outcome.wrong = single && !right(&outcome.causes[0]);
}

/// Flights that are said to contradict, and how many of them were told another flight's spin.
fn contradicting(case: &Case, told: Told, report: &Report) -> (usize, usize) {
    let swapped = told.swapped(case.flights, case.seed);
    let files = report.agreement.iter().flat_map(|a| &a.contradicting);
    let right = files.clone().filter(|file| {
        let swapped = swapped.iter().map(|flight| file_of(*flight));
        swapped.into_iter().any(|name| name == **file)
    });
    (files.count(), right.count())
}

fn least(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}

/// Size over the smallest detectable: the greatest over its coefficients. What differs from flight to flight has no
/// smallest size; there its score says how many times it exceeds what is needed.
fn detectable_sizes(report: &Report, name: &str, values: &[f64]) -> Option<f64> {
    let effect = oracle::effect::by_name(name)?;
    let each = effect.coefficients.iter().zip(values);
    let sizes = each.filter_map(|(coefficient, value)| {
        let mut all = report.smallest_detectable.iter();
        let least = all.find(|d| underscored(&d.name) == name && d.coefficient == *coefficient)?;
        Some(value.abs() / least.value)
    });
    let by_size = sizes.fold(None, |most: Option<f64>, size| {
        Some(most.map_or(size, |most| most.max(size)))
    });
    if by_size.is_some() || effect.states.is_empty() {
        return by_size;
    }
    let mut scores = report.candidates.iter();
    let score = scores.find(|score| underscored(&score.name) == name)?;
    Some(score.sigmas / (report.threshold.sigmas + POWER))
}

/// Errors of prediction on held-out flights: without, with, and with what was hidden switched on.
fn held_out(outcome: &mut Outcome, found: &Diagnosed, dataset: &Dataset, truths: &Truths) {
    let before = prediction(&found.before);
    let after = found.after.as_ref().map(|(_, fitted)| prediction(fitted));
    outcome.held_out_before = before;
    outcome.held_out_after = after.unwrap_or(before);
    if !outcome.case.hidden.outside.is_empty() || outcome.case.told.is_some() {
        return;
    }
    let truth = truth(&outcome.case);
    outcome.held_out_true = if truth.is_empty() {
        Some(before)
    } else if after.is_some() && outcome.causes.first() == Some(&truth) {
        // The extension is the true model.
        after
    } else {
        let names: Vec<&str> = truth.iter().map(String::as_str).collect();
        let model = truths.model(outcome.case.body.model(), &names);
        fit(&model, dataset, &alone()).ok().map(|f| prediction(&f))
    };
}

/// Root mean square of the residuals of held-out flights.
fn prediction(fitted: &Fit) -> f64 {
    let flights = fitted.report.flights.iter();
    let held_out = flights.filter(|f| f.role == Role::HeldOut && !f.initial.is_empty());
    let squares: Vec<f64> = held_out.map(|flight| flight.rms_m.powi(2)).collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

/// What the diagnosis says with what was hidden switched on: the rival that rejects it, with its sigmas and those that
/// an alarm takes; none where nothing more is found, or no model has it.
pub fn rejected_by(case: &Case, truths: &Truths) -> Option<String> {
    let with = truth(case);
    let names: Vec<&str> = with.iter().map(String::as_str).collect();
    if names.is_empty() {
        return None;
    }
    let model = truths.model(case.body.model(), &names);
    let asked = Asked {
        dataset: "hidden",
        with: &with,
        fit: alone(),
        ..Asked::default()
    };
    let report = diagnose(&model, &case.dataset(), &asked).ok()?.report;
    let first = report.candidates.first()?;
    let causes: Vec<String> = causes(&report).iter().map(|c| c.join("+")).collect();
    Some(format!(
        "with it on: {:?} {}, most {} at {:.1} of {:.1} sigmas",
        report.verdict,
        causes.join(" | "),
        first.name,
        first.sigmas,
        report.threshold.sigmas
    ))
}
