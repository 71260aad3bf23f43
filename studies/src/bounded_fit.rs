//! Fits and diagnoses with a time limit, on a given number of threads.

use std::sync::mpsc;
use std::time::{Duration, Instant};

use dataset::Dataset;
use identify::{CancellationToken, Fit, FitError, FitOptions, fit};
use model_spec::model::Model;

/// Result of a fit with a time limit, and its computing time.
pub(crate) struct BoundedFit {
    /// The fit, or the error that ended it; [`FitError::Interrupted`] if the time limit was reached.
    pub(crate) result: Result<Fit, FitError>,
    /// Elapsed time of the fit, s.
    pub(crate) seconds: f64,
}

/// Fits a model on one thread and cancels the fit after `limit`. A cancelled fit ends shortly after the limit.
pub(crate) fn bounded_fit(model: &Model, dataset: &Dataset, limit: Duration) -> BoundedFit {
    cancelled_after(limit, |token| {
        let options = FitOptions {
            cancellation: Some(token),
            ..on_threads(1)
        };
        let clock = Instant::now();
        BoundedFit {
            result: fit(model, dataset, &options),
            seconds: clock.elapsed().as_secs_f64(),
        }
    })
}

/// Default options of a fit on a given number of threads.
pub(crate) fn on_threads(threads: usize) -> FitOptions<'static> {
    FitOptions {
        threads: Some(threads),
        ..FitOptions::default()
    }
}

/// Runs `work` with a cancellation token that is cancelled after `limit`, and returns its result. `work` must end soon
/// after the cancellation.
pub(crate) fn cancelled_after<R>(limit: Duration, work: impl FnOnce(&CancellationToken) -> R) -> R {
    let token = CancellationToken::default();
    let (finished, wait) = mpsc::channel::<()>();
    let watched = token.clone();
    std::thread::scope(|scope| {
        scope.spawn(move || {
            if wait.recv_timeout(limit) == Err(mpsc::RecvTimeoutError::Timeout) {
                watched.cancel();
            }
        });
        let result = work(&token);
        drop(finished);
        result
    })
}
