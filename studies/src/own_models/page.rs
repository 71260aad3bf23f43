//! Renders docs/studies/own-models.md.

use serde::Serialize;

use super::run::Outcome;
use super::subjects::SUBJECTS;
use crate::error::StudyError;
use crate::page::Page;
use crate::statistics::median;

/// The diagnosis is required to detect an added effect whose size is at least this multiple of its minimum detectable
/// size.
const CLEAR: f64 = 5.0;

/// Maximum length, in characters, of the quoted text of a diagnosis's result on the page docs/studies/own-models.md.
const MAX_QUOTE: usize = 140;

#[derive(Serialize)]
struct Results {
    #[serde(flatten)]
    all: ModelRow,
    failed: usize,
    runs: usize,
    median: Option<f64>,
    slowest: f64,
    /// Number of threads on which each diagnosis ran.
    threads: usize,
    models: Vec<ModelRow>,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct ModelRow {
    name: &'static str,
    kind: &'static str,
    clear: usize,
    missed: usize,
    site_right: usize,
    nulls: usize,
    false_alarms: usize,
}

#[derive(Serialize)]
struct Row {
    model: &'static str,
    hidden: &'static str,
    size: &'static str,
    seed: u64,
    detectability: Option<f64>,
    judgement: &'static str,
    description: String,
    seconds: f64,
}

/// Renders docs/studies/own-models.md from the outcomes of the diagnoses of simulated flights of user models.
///
/// # Errors
/// [`StudyError::Page`] if the template cannot be rendered with the results.
pub fn own_models_page(outcomes: &[Outcome]) -> Result<Page, StudyError> {
    let models = SUBJECTS.iter().map(|subject| {
        let of = outcomes
            .iter()
            .filter(|o| o.task.subject.name == subject.name);
        let of: Vec<&Outcome> = of.collect();
        model_row(subject.name, subject.kind, &of)
    });
    let models: Vec<ModelRow> = models.filter(|row| row.clear + row.nulls > 0).collect();
    let rows = outcomes.iter().filter(|o| o.task.hidden.is_some());
    let seconds = outcomes.iter().map(|o| o.seconds);
    let results = Results {
        all: model_row("", "", &outcomes.iter().collect::<Vec<_>>()),
        failed: outcomes.iter().filter(|o| o.verdict.is_err()).count(),
        runs: outcomes.len(),
        median: median(seconds.clone()),
        slowest: seconds.fold(0.0, f64::max),
        threads: outcomes.first().map_or(1, |outcome| outcome.threads),
        models,
        rows: rows.map(row).collect(),
    };
    Page::without_figures(include_str!("page.md"), results)
}

fn is_clear(outcome: &Outcome) -> bool {
    outcome.task.hidden.is_some() && outcome.is_detectable(CLEAR)
}

fn model_row(name: &'static str, kind: &'static str, of: &[&Outcome]) -> ModelRow {
    let count = |has: &dyn Fn(&Outcome) -> bool| of.iter().filter(|o| has(o)).count();
    ModelRow {
        name,
        kind,
        clear: count(&is_clear),
        missed: count(&|o| is_clear(o) && !o.is_detected()),
        site_right: count(&|o| is_clear(o) && o.is_site_right()),
        nulls: count(&|o| o.task.hidden.is_none()),
        false_alarms: count(&|o| {
            o.task.hidden.is_none() && (o.is_detected() || o.verdict.is_err())
        }),
    }
}

fn row(outcome: &Outcome) -> Row {
    let judgement = match () {
        () if outcome.verdict.is_err() => "**failed**",
        () if !outcome.is_detected() && is_clear(outcome) => "**missed**",
        () if !outcome.is_detected() => "not detected",
        () if outcome.is_site_right() => "right site",
        () if is_clear(outcome) => "**other site**",
        () => "other site",
    };
    let task = &outcome.task;
    Row {
        model: task.subject.name,
        hidden: task.hidden_name(),
        size: task.size(),
        seed: task.seed,
        detectability: outcome.detectability,
        judgement,
        description: outcome
            .says()
            .chars()
            .take(MAX_QUOTE)
            .collect::<String>()
            .replace('|', "/"),
        seconds: outcome.seconds,
    }
}
