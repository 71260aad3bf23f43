//! Executes the runs: simulates each dataset, fits it, and diagnoses a part of them.

use std::time::{Duration, Instant};

use dataset::Dataset;
use diagnose::{DiagnosisOptions, diagnose};
use identify::{CancellationToken, FitOptions, fit};

use super::case::{Case, Group};
use super::judge::{Diagnosed, Fitted, Misfit};
use super::recording::Recording;
use crate::bounded_fit::{cancelled_after, on_threads};
use crate::progress::{Progress, each_run};

/// Limit of the elapsed time of a fit or diagnosis.
pub(super) const LIMIT: Duration = Duration::from_secs(75);

/// Result of one dataset.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The dataset.
    pub case: Case,
    /// Description of the recording and of its mistake.
    pub description: String,
    /// What the fit says.
    pub fitted: Fitted,
    /// What the diagnosis says; `None` if the dataset was not diagnosed.
    pub diagnosed: Option<Diagnosed>,
}

impl Outcome {
    /// Whether nothing is wrong with the dataset and the estimates, and the fit says that it is not reliable; or whether
    /// nothing is wrong with the dataset, and the fit has no result.
    pub fn is_vetoed(&self) -> bool {
        let is_right = self.fitted.is_right() || self.fitted.worst.is_none();
        self.case.group() == Group::Clean && is_right && !self.fitted.reliable
    }

    /// Whether nothing is wrong with the dataset, an estimate is wrong, and the fit says that it is not reliable.
    pub fn is_missed(&self) -> bool {
        self.case.group() == Group::Clean && !self.fitted.reliable && !self.is_vetoed()
    }
}

/// Fits every dataset of `cases` on one thread, and diagnoses every `diagnosed_of`-th of them, the first one included
/// (none for 0); `threads` datasets in parallel. Calls `progress` after each.
pub fn wild(
    cases: &[Case],
    diagnosed_of: u64,
    threads: usize,
    progress: Progress<'_>,
) -> Vec<Outcome> {
    each_run(threads, cases.len(), progress, |index| {
        let is_diagnosed = diagnosed_of > 0 && (index as u64).is_multiple_of(diagnosed_of);
        outcome(cases[index], is_diagnosed)
    })
}

fn outcome(case: Case, is_diagnosed: bool) -> Outcome {
    let recording = case.recording(false);
    // As `hyzer fit` does: the lack-of-fit test decides whether the fit is reliable.
    let (fitted, seconds) = timed(|token| {
        let options = options(&recording, token);
        fit(&recording.model, &recording.dataset, &options)?.with_lack_of_fit(1)
    });
    let mut fitted = Fitted::of(&fitted, &recording, seconds);
    if case.group() == Group::Hidden && fitted.is_confidently_wrong() {
        fitted.misfit = misfit(&case);
    }
    Outcome {
        fitted,
        diagnosed: is_diagnosed.then(|| diagnosed(&case, &recording)),
        description: recording.description,
        case,
    }
}

fn diagnosed(case: &Case, recording: &Recording) -> Diagnosed {
    let (found, seconds) = timed(|token| {
        let options = DiagnosisOptions {
            dataset: "wild",
            fit: options(recording, token),
            ..DiagnosisOptions::default()
        };
        diagnose(&recording.model, &recording.dataset, &options)
    });
    let found = found
        .map(|found| found.report)
        .map_err(|error| error.to_string());
    let misfit = match case.group() {
        Group::Hidden => misfit(case),
        Group::Clean | Group::Mistake => None,
    };
    Diagnosed::of(found, case, recording.cause.as_deref(), misfit, seconds)
}

/// Residuals of a fit of the flights without noise.
fn misfit(case: &Case) -> Option<Misfit> {
    let exact = case.recording(true);
    let sigma = exact.sigma?;
    let dataset = Dataset {
        sigma: Some(sigma),
        ..exact.dataset
    };
    let (found, _) = timed(|token| {
        let options = FitOptions {
            cancellation: Some(token),
            trust_data: true,
            ..on_threads(1)
        };
        fit(&exact.model, &dataset, &options)
    });
    let report = found.ok()?.report;
    let ratio = report.rms() / sigma;
    let points: usize = report.noise.values().map(|own| own.points).sum();
    Some(Misfit {
        ratio,
        chi2: 3.0 * points as f64 * ratio * ratio,
    })
}

/// Options with which a user fits a recording, on one thread.
fn options<'r>(recording: &'r Recording, token: &'r CancellationToken) -> FitOptions<'r> {
    FitOptions {
        fixed: &recording.fixed,
        priors: &recording.priors,
        cancellation: Some(token),
        ..on_threads(1)
    }
}

/// Result of work that is cancelled after [`LIMIT`], and the processor time, s, that this thread used for it: fits and
/// diagnoses on one thread do not leave it, and other programs on the machine do not count. Elapsed time where the
/// system does not tell the processor time.
fn timed<R>(work: impl FnOnce(&CancellationToken) -> R) -> (R, f64) {
    cancelled_after(LIMIT, |token| {
        let (clock, before) = (Instant::now(), processor_time());
        let result = work(token);
        let used = processor_time()
            .zip(before)
            .map(|(after, before)| after - before);
        (
            result,
            used.unwrap_or_else(|| clock.elapsed().as_secs_f64()),
        )
    })
}

/// Processor time of this thread, s, as Linux states it.
fn processor_time() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds: f64 = text.split_whitespace().next()?.parse().ok()?;
    Some(nanoseconds * 1e-9)
}
