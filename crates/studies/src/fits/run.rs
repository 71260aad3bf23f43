//! Random fits: flights of the oracle, fitted from the model's own start.

use std::sync::atomic::{AtomicUsize, Ordering};

use flight::batch;
use identify::{FitOptions, FitStatus, fit};

use super::case::{FitCase, rms_distance};

/// Greatest RMS residual of a fit that has reached the noise, relative to the expected one.
const MAX_RATIO: f64 = 1.02;

/// Greatest fraction of points that a fit may take for outliers, where there are none.
const MAX_OUTLIERS: f64 = 0.005;

/// Outcome of one random fit.
#[derive(Clone, Debug)]
pub struct FitOutcome {
    /// The fit.
    pub case: FitCase,
    /// Error of a fit that ended without a result.
    pub failure: Option<String>,
    /// RMS residual over that of the true model: of the noise, less the degrees of freedom; `None` without a result.
    pub ratio: Option<f64>,
    /// Fraction of the points taken for outliers.
    pub outliers: f64,
    /// Numbers of excluded and of truncated flights.
    pub lost: [usize; 2],
    /// Why the iteration ended; `None` without a result.
    pub status: Option<FitStatus>,
    /// Time, s, on this number of threads.
    pub seconds: f64,
    /// Number of threads of the fit.
    pub threads: usize,
}

impl FitOutcome {
    /// Whether the residuals of all flights, whole, are those of the true model.
    pub fn is_reached(&self) -> bool {
        self.ratio.is_some_and(|ratio| ratio <= MAX_RATIO)
            && self.outliers <= MAX_OUTLIERS
            && self.lost == [0, 0]
    }
}

/// Fits the datasets of the seeds, this number of them at a time, each on its part of the processors; calls `progress` after each with its number.
pub fn fits(
    seeds: &[u64],
    threads: usize,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Vec<FitOutcome> {
    let finished = AtomicUsize::new(0);
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let of_fit = (processors / threads.max(1)).max(1);
    batch::each_on(threads, seeds.len(), |index| {
        let outcome = fit_outcome(FitCase::of(seeds[index]), of_fit);
        progress(1 + finished.fetch_add(1, Ordering::Relaxed), seeds.len());
        outcome
    })
}

/// Makes the flights of a random fit and fits them on this number of threads.
///
/// # Panics
/// If the built-in effects do not load.
pub fn fit_outcome(case: FitCase, threads: usize) -> FitOutcome {
    let [exact, dataset] = case.datasets();
    let model = model_spec::load::load("disc", &case.names()).expect("effects that load");
    let options = FitOptions {
        threads: Some(threads),
        ..FitOptions::default()
    };
    let clock = std::time::Instant::now();
    let fitted = fit(&model, &dataset, &options);
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
    let coordinates: usize = dataset.flights.iter().map(|f| f.measurements()).sum();
    let dof = 1.0 - (model.coefficients.len() + states) as f64 / coordinates as f64;
    let noise = rms_distance(&exact, &dataset).unwrap_or(f64::NAN);
    outcome.ratio = Some(report.rms_m / (noise * dof.sqrt()));
    outcome.outliers = report.noise.outlier_fraction;
    let cut = report.flights.iter().filter(|flight| flight.cut.is_some());
    outcome.lost = [report.excluded().count(), cut.count()];
    outcome.status = Some(report.iterations.status);
    outcome
}
