//! Executes the runs: simulates flights with a hidden effect, diagnoses them, and compares the answer with the hidden
//! effect.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use dataset::Dataset;
use dataset::synthesize::Corruption;
use diagnose::{DiagnosisError, DiagnosisOptions, Report, Verdict, diagnose};
use identify::FitOptions;
use model_spec::model::Model;

use super::hidden::Hidden;
use super::hidden_lists::hidden_of;
use super::subjects::{SUBJECTS, Subject};
use super::world::dataset;
use crate::bounded_fit::{bounded_fit, cancelled_after, on_threads};
use crate::progress::{Progress, each_run, threads_of_each_run};

/// Limit of the computing time of a diagnosis or a fit.
const LIMIT: Duration = Duration::from_secs(60);

/// Approximate square root of the χ² misfit that a diagnosis detects with power 0.9. It is the sum of the detection
/// threshold if about thirty candidate effects are tested, 4.4 standard deviations, and of the 0.9 quantile of the
/// standard normal distribution, 1.3.
const DETECTABLE: f64 = 5.7;

/// Settings of one run of the study, that is of one simulated and diagnosed dataset.
#[derive(Clone, Copy, Debug)]
pub struct Task {
    /// User model whose simulated flights are diagnosed.
    pub subject: &'static Subject,
    /// Physical effect that is added to the simulated flights but not to the diagnosed model, its signed size, and the
    /// label of the size ("weak" or "strong"); `None` if no effect is added.
    pub hidden: Option<(Hidden, f64, &'static str)>,
    /// Seed of the throws and the noise.
    pub seed: u64,
}

impl Task {
    /// Name of the effect that is added to the simulated flights but not to the diagnosed model; "nothing" if there is
    /// none.
    pub fn hidden_name(&self) -> &'static str {
        self.hidden.map_or("nothing", |(hidden, _, _)| hidden.name)
    }

    /// Label ("weak" or "strong") of the size of the effect that is added to the simulated flights; empty if there is
    /// none.
    pub fn size(&self) -> &'static str {
        self.hidden.map_or("", |(_, _, label)| label)
    }
}

/// Result of the diagnosis of one simulated dataset, and how detectable the effect added to its flights was.
#[derive(Debug)]
pub struct Outcome {
    /// Settings with which the flights were simulated and diagnosed.
    pub task: Task,
    /// Verdict of the diagnosis, or the error that ended it.
    pub verdict: Result<Verdict, DiagnosisError>,
    /// Effects that the diagnosis found, as pairs (name, quantity of the model on which the effect acts). If it found
    /// none: the terms selected from its library of force and moment terms. Without such terms: the missing force or
    /// moment that explains most of the misfit.
    pub answer: Vec<(String, String)>,
    /// Size of the effect added to the simulated flights / minimum detectable size, from the χ² that remains when the
    /// model without the effect is fitted to noise-free flights. `None` if no effect is added or that fit fails.
    pub detectability: Option<f64>,
    /// Elapsed time of the diagnosis, s.
    pub seconds: f64,
    /// Number of threads on which the diagnosis ran.
    pub threads: usize,
}

impl Outcome {
    /// Whether the diagnosis succeeded and detected a deviation from the model (verdict other than `Verdict::Adequate`).
    pub fn is_detected(&self) -> bool {
        self.verdict
            .as_ref()
            .is_ok_and(|verdict| *verdict != Verdict::Adequate)
    }

    /// Whether the effect added to the simulated flights has at least `times` times the minimum detectable size; false
    /// if no effect is added or its detectability could not be computed.
    pub fn is_detectable(&self, times: f64) -> bool {
        self.detectability.is_some_and(|ratio| ratio >= times)
    }

    /// Whether an effect that the diagnosis found acts on one of the model's quantities that count as correct for the
    /// effect added to the simulated flights; false if no effect is added.
    pub fn is_site_right(&self) -> bool {
        let Some((hidden, _, _)) = self.task.hidden else {
            return false;
        };
        let is_right = |site: &str| hidden.sites.contains(&site);
        self.answer.iter().any(|(_, site)| is_right(site))
    }

    /// Formats the verdict as text, with the names of the effects found and of the model quantities (sites) on which
    /// they act; for a failed diagnosis, formats its error message.
    pub fn says(&self) -> String {
        let answer = self
            .answer
            .iter()
            .map(|(name, site)| format!("{name} ({site})"));
        let answer: Vec<String> = answer.collect();
        match &self.verdict {
            Ok(verdict) => format!("{verdict:?}: {}", answer.join(", ")),
            Err(error) => format!("failed: {}", error.to_string().replace('\n', " ")),
        }
    }
}

/// Lists the runs (simulated and diagnosed datasets) whose model name, effect name and size label together contain all
/// of `words`. Before this selection, each model has `10 * seeds` runs whose flights contain no added effect, and
/// `seeds` runs for each added effect and size.
pub fn tasks(seeds: u64, words: &str) -> Vec<Task> {
    let mut tasks = Vec::new();
    for subject in &SUBJECTS {
        for seed in 0..10 * seeds {
            tasks.push(Task {
                subject,
                hidden: None,
                seed,
            });
        }
        for (place, hidden) in hidden_of(subject).into_iter().enumerate() {
            for (label, size) in ["weak", "strong"].into_iter().zip(hidden.sizes) {
                for run in 0..seeds {
                    let seed = 1000 + 100 * place as u64 + run;
                    let sign = if (place as u64 + run).is_multiple_of(2) {
                        1.0
                    } else {
                        -1.0
                    };
                    tasks.push(Task {
                        subject,
                        hidden: Some((hidden, sign * size, label)),
                        seed,
                    });
                }
            }
        }
    }
    tasks.retain(|task| {
        let text = format!(
            "{} {} {}",
            task.subject.name,
            task.hidden_name(),
            task.size()
        );
        words.split_whitespace().all(|word| text.contains(word))
    });
    tasks
}

/// Simulates and diagnoses the flights of each task, `threads` diagnoses in parallel, which share the processors. Calls
/// `progress` with the numbers of finished tasks and of all tasks.
pub fn own_models(tasks: &[Task], threads: usize, progress: Progress<'_>) -> Vec<Outcome> {
    let models: BTreeMap<&str, Model> = SUBJECTS.iter().map(|s| (s.name, s.model())).collect();
    let of_run = threads_of_each_run(threads);
    each_run(threads, tasks.len(), progress, |index| {
        let model = &models[tasks[index].subject.name];
        outcome(tasks[index], model, of_run)
    })
}

fn outcome(task: Task, model: &Model, threads: usize) -> Outcome {
    let hidden = task.hidden.map(|(hidden, size, _)| (hidden, size));
    let noise = Corruption::default();
    let observed = dataset(task.subject, model, hidden, Some(noise), task.seed);
    let detectability = hidden.and_then(|hidden| {
        let exact = dataset(task.subject, model, Some(hidden), None, task.seed);
        detectability(model, exact, noise.sigma)
    });
    let clock = Instant::now();
    let found = bounded_diagnosis(model, &observed, threads);
    let seconds = clock.elapsed().as_secs_f64();
    Outcome {
        task,
        answer: found.as_ref().map(answer).unwrap_or_default(),
        verdict: found.map(|report| report.verdict),
        detectability,
        seconds,
        threads,
    }
}

/// Diagnoses a dataset. Cancels the diagnosis if it has not ended after the computing time [`LIMIT`].
fn bounded_diagnosis(
    model: &Model,
    observed: &Dataset,
    threads: usize,
) -> Result<Report, DiagnosisError> {
    let found = cancelled_after(LIMIT, |token| {
        let options = DiagnosisOptions {
            dataset: "hidden",
            fit: FitOptions {
                cancellation: Some(token),
                ..on_threads(threads)
            },
            ..DiagnosisOptions::default()
        };
        diagnose(model, observed, &options)
    });
    Ok(found?.report)
}

/// Size of an effect that is added to simulated flights / minimum detectable size. It is the square root of the χ² that
/// remains when the model without the effect is fitted to the noise-free flights, divided by [`DETECTABLE`]. `None` if
/// the fit fails.
fn detectability(model: &Model, mut exact: Dataset, sigma: f64) -> Option<f64> {
    exact.sigma = Some(sigma);
    let fitted = bounded_fit(model, &exact, LIMIT).result.ok()?;
    let flights = fitted.report.flights.iter().zip(&exact.flights);
    let squares = flights.filter(|(report, _)| report.role == dataset::Role::Fit);
    let chi2: f64 = squares
        .map(|(report, flight)| match report.position_rms() {
            Some(rms) => (rms / sigma).powi(2) * 3.0 * dataset::measurements(flight) as f64,
            None => 0.0,
        })
        .sum();
    Some(chi2.sqrt() / DETECTABLE)
}

/// Result of a diagnosis report, as pairs (name, quantity of the model on which it acts): the effects of all causes
/// found, then the terms selected from the library of force and moment terms. If there are neither: the missing force
/// or moment that explains most of the misfit.
fn answer(report: &Report) -> Vec<(String, String)> {
    let causes = report.explanations.iter().flat_map(|cause| &cause.effects);
    let mut answer: Vec<(String, String)> = causes
        .map(|effect| (effect.name.clone(), effect.site.clone()))
        .collect();
    let terms = report.unattributed.iter().flat_map(|found| &found.terms);
    let selected = terms.filter(|term| term.selected);
    answer.extend(selected.map(|term| (term.name.clone(), term.site.clone())));
    if answer.is_empty() {
        let channels = report.unattributed.iter().flat_map(|found| &found.channels);
        let most = channels.max_by(|a, b| a.explained_fraction.total_cmp(&b.explained_fraction));
        answer.extend(most.map(|channel| ("missing load".to_owned(), channel.site.clone())));
    }
    answer
}
