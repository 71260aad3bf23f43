//! Random fits: flights simulated by the oracle, fitted from the model's default initial values.

use identify::{FitStatus, fit};

use super::case::{FitCase, rms_distance};
use crate::bounded_fit::on_threads;
use crate::progress::{Progress, each_run, threads_of_each_run};

/// A fit counts as having reached the noise level if its RMS residual is at most this multiple of the RMS residual
/// expected of the true model.
const MAX_RATIO: f64 = 1.02;

/// Maximum fraction of the measured marker positions that a good fit may classify as outliers. The simulated flights
/// contain no outliers.
const MAX_OUTLIERS: f64 = 0.005;

/// Outcome of fitting one simulated dataset whose flights contain randomly drawn effects.
#[derive(Clone, Debug)]
pub struct FitOutcome {
    /// Simulated flights that were fitted, with the effects that were added to them.
    pub case: FitCase,
    /// Error message if the fit ended without a result; `None` otherwise.
    pub failure: Option<String>,
    /// RMS residual / the RMS residual expected of the true model, which is the RMS noise corrected for the degrees of
    /// freedom. `None` if the fit ended with an error.
    pub ratio: Option<f64>,
    /// Fraction of the measured marker positions that the fit classified as outliers; 0 if the fit ended with an error.
    pub outliers: f64,
    /// Number of flights that the fit excluded, and number of flights that it truncated; both 0 if the fit ended with
    /// an error.
    pub lost: [usize; 2],
    /// Reason why the iteration of the fit ended; `None` if the fit ended with an error.
    pub status: Option<FitStatus>,
    /// Elapsed time of the fit on `threads` threads, s.
    pub seconds: f64,
    /// Number of threads on which the fit ran.
    pub threads: usize,
}

impl FitOutcome {
    /// Whether the fit used all flights in full and its residuals are at the noise level of the true model.
    pub fn is_reached(&self) -> bool {
        self.ratio.is_some_and(|ratio| ratio <= MAX_RATIO)
            && self.outliers <= MAX_OUTLIERS
            && self.lost == [0, 0]
    }
}

/// For each of `seeds`, simulates one dataset with randomly drawn effects and fits it. `threads` fits run in parallel
/// and share the processors equally. Calls `progress` after each fit with the numbers of finished fits and of all fits.
pub fn fits(seeds: &[u64], threads: usize, progress: Progress<'_>) -> Vec<FitOutcome> {
    let of_fit = threads_of_each_run(threads);
    each_run(threads, seeds.len(), progress, |index| {
        fit_outcome(FitCase::of(seeds[index]), of_fit)
    })
}

/// Simulates the flights of a case, and fits them on `threads` threads with a model that contains the added effects.
///
/// # Panics
/// If the built-in effects do not load.
pub fn fit_outcome(case: FitCase, threads: usize) -> FitOutcome {
    let [exact, dataset] = case.datasets();
    let model = model_spec::load::load("disc", &case.names()).expect("effects that load");
    let clock = std::time::Instant::now();
    let fitted = fit(&model, &dataset, &on_threads(threads));
    let seconds = clock.elapsed().as_secs_f64();
    let mut outcome = FitOutcome {
        case,
        failure: None,
        ratio: None,
        outliers: 0.0,
        lost: [0, 0],
        status: None,
        seconds,
        threads,
    };
    let report = match fitted {
        Ok(fitted) => fitted.report,
        Err(error) => {
            outcome.failure = Some(error.to_string());
            return outcome;
        }
    };
    let states = model.states.len() * dataset.flights.len();
    let coordinates: usize = dataset
        .flights
        .iter()
        .map(|flight| 3 * dataset::measurements(flight))
        .sum();
    let dof = 1.0 - (model.coefficients.len() + states) as f64 / coordinates as f64;
    let noise = rms_distance(&exact, &dataset).unwrap_or(f64::NAN);
    outcome.ratio = Some(report.rms() / (noise * dof.sqrt()));
    outcome.outliers = report.leading_noise().outlier_fraction;
    let cut = report.flights.iter().filter(|flight| flight.cut.is_some());
    outcome.lost = [report.excluded().count(), cut.count()];
    outcome.status = Some(report.iterations.status);
    outcome
}
