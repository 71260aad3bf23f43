//! Executes the runs: simulates the flights, diagnoses them, and compares the answer with the effects added to the
//! simulated flights.

use std::collections::BTreeMap;
use std::sync::Mutex;

use dataset::{Dataset, Role};
use diagnose::{Diagnosis, DiagnosisOptions, diagnose};
use flight::parallel;
use identify::{Fit, fit};
use model_spec::model::Model;

use super::case::Case;
use super::outcome::{HeldOutErrors, Outcome};
use super::row::Row;
use super::score::{hypotheses, score};
use crate::bounded_fit::on_threads;
use crate::progress::{Progress, each_run, threads_of_each_run};

/// Settings of one row of the study's table (combination of simulation settings), with the outcomes of its runs
/// (simulated and diagnosed datasets).
#[derive(Clone, Debug)]
pub struct RowResult {
    /// Simulation settings that the runs have in common.
    pub row: Row,
    /// Outcomes of the runs (simulated and diagnosed datasets), in the order in which the runs are numbered.
    pub outcomes: Vec<Outcome>,
}

/// Executes the runs (simulated and diagnosed datasets) of each combination of simulation settings in `rows`.
/// `at_a_time` diagnoses run in parallel and share the processors. Calls `progress` with the numbers of finished runs
/// and of all runs.
pub fn run_rows(rows: &[Row], at_a_time: usize, progress: Progress<'_>) -> Vec<RowResult> {
    let threads = threads_of_each_run(at_a_time);
    let models = Models::default();
    let runs = rows.iter().enumerate();
    let runs: Vec<(usize, usize)> = runs
        .flat_map(|(row, of)| (0..of.runs).map(move |run| (row, run)))
        .collect();
    let outcomes = each_run(at_a_time, runs.len(), progress, |index| {
        let (row, run) = runs[index];
        outcome(&Case::of(&rows[row], run), &models, threads)
    });
    let mut outcomes = outcomes.into_iter();
    let results = rows.iter().map(|row| RowResult {
        row: row.clone(),
        outcomes: outcomes.by_ref().take(row.runs).collect(),
    });
    results.collect()
}

/// Repeats the diagnosis of each run that detected a deviation from the model but missed a detectable effect, with a
/// model that contains the effects added to the simulated flights. Returns one text per row and run: verdict,
/// hypotheses and first-ranked candidate effect of the repeated diagnosis. `None` for a run whose diagnosis is not
/// repeated or has no result.
pub fn rejections(results: &[RowResult]) -> Vec<Vec<Option<String>>> {
    let models = Models::default();
    let all: Vec<&Outcome> = results.iter().flat_map(|result| &result.outcomes).collect();
    let texts = parallel::each(all.len(), |index| {
        let outcome = all[index];
        let is_missed = outcome.is_detected() && !outcome.in_set && outcome.is_detectable(1.0);
        is_missed.then(|| rejection(&outcome.case, &models))?
    });
    let mut texts = texts.into_iter();
    let rows = results
        .iter()
        .map(|result| texts.by_ref().take(result.outcomes.len()).collect());
    rows.collect()
}

/// Cache of the built-in models, each extended by a set of effects, so that each combination is loaded once. The keys
/// are the name of the model and the names of the effects, separated by spaces.
#[derive(Default)]
struct Models(Mutex<BTreeMap<String, Model>>);

impl Models {
    /// Returns a clone of the built-in model `model` combined with the built-in effects `effects`. Each combination is
    /// loaded only once.
    ///
    /// # Panics
    /// If the effects cannot be combined with the model.
    fn get(&self, model: &str, effects: &[&str]) -> Model {
        let key = format!("{model} {}", effects.join(" "));
        let mut models = self
            .0
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner);
        let load = || model_spec::load::load(model, effects).expect("built-in effects");
        models.entry(key).or_insert_with(load).clone()
    }
}

fn diagnosis_options(threads: usize) -> DiagnosisOptions<'static> {
    DiagnosisOptions {
        dataset: "hidden",
        fit: on_threads(threads),
        ..DiagnosisOptions::default()
    }
}

/// Simulates the flights of a run, diagnoses them, and scores the diagnosis against the effects added to the simulated
/// flights.
fn outcome(case: &Case, models: &Models, threads: usize) -> Outcome {
    let dataset = case.dataset();
    let base = models.get(case.body.model(), &[]);
    let mut outcome = Outcome::unknown(case);
    outcome.threads = threads;
    match diagnose(&base, &dataset, &diagnosis_options(threads)) {
        Ok(found) => {
            score(&mut outcome, &found.report);
            outcome.held_out = held_out(&outcome, &found, &dataset, models);
        }
        Err(error) => outcome.failure = Some(error.to_string()),
    }
    outcome
}

/// RMS errors with which three fitted models predict the held-out flights: the model without added effects, the model
/// extended by the effects that the diagnosis found, and the model with the effects added to the simulated flights.
fn held_out(
    outcome: &Outcome,
    found: &Diagnosis,
    dataset: &Dataset,
    models: &Models,
) -> HeldOutErrors {
    let before = prediction_error(&found.before);
    let extended = found.after.as_ref();
    let extended = extended.map(|(_, fitted)| prediction_error(fitted));
    let case = &outcome.case;
    let truth = case.truth();
    let truth = if !case.seeded.unlisted.is_empty() || case.input_errors.is_some() {
        None
    } else if truth.is_empty() {
        Some(before)
    } else if extended.is_some() && outcome.hypotheses.first() == Some(&truth) {
        // The diagnosis has found the true model.
        extended
    } else {
        let names: Vec<&str> = truth.iter().map(String::as_str).collect();
        let model = models.get(case.body.model(), &names);
        let fitted = fit(&model, dataset, &on_threads(1)).ok();
        fitted.map(|fitted| prediction_error(&fitted))
    };
    HeldOutErrors {
        before,
        after: extended.unwrap_or(before),
        truth,
    }
}

/// RMS residual, m, of a fitted model over the held-out flights, which the fit did not use.
fn prediction_error(fitted: &Fit) -> f64 {
    let flights = fitted.report.flights.iter();
    let held_out = flights.filter(|f| f.role == Role::HeldOut && !f.initial.is_empty());
    let squares: Vec<f64> = held_out.map(|flight| flight.rms().powi(2)).collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

/// Repeats the diagnosis of a run with a model that already contains the effects added to the simulated flights.
/// Returns the verdict, the hypotheses and the first-ranked candidate effect as text. `None` if no effects were added,
/// if there is no candidate, or if the diagnosis fails.
fn rejection(case: &Case, models: &Models) -> Option<String> {
    let with = case.truth();
    let names: Vec<&str> = with.iter().map(String::as_str).collect();
    if names.is_empty() {
        return None;
    }
    let model = models.get(case.body.model(), &names);
    let found = diagnose(&model, &case.dataset(), &diagnosis_options(1));
    let report = found.ok()?.report;
    let strongest = report.tests.first()?;
    let effects = hypotheses(&report)
        .iter()
        .map(|h| h.join("+"))
        .collect::<Vec<_>>();
    Some(format!(
        "with the truth in the model: {:?} {}, strongest candidate {} (z = {:.1}, threshold {:.1})",
        report.verdict,
        effects.join(" | "),
        strongest.name,
        strongest.z,
        report.threshold.z
    ))
}
