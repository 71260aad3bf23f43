//! A fit on one thread that is cancelled after a given time.

use std::sync::mpsc;
use std::time::{Duration, Instant};

use identify::dataset::Dataset;
use identify::{CancellationToken, Fit, FitError, FitOptions, fit};
use model_spec::model::Model;

/// Result of a fit and its computing time, s.
pub(crate) struct BoundedFit {
    /// Result; [`FitError::Interrupted`] if the fit was cancelled.
    pub(crate) result: Result<Fit, FitError>,
    /// Computing time, s.
    pub(crate) seconds: f64,
}

/// Fits a model on one thread, for at most about `limit`.
pub(crate) fn bounded_fit(model: &Model, dataset: &Dataset, limit: Duration) -> BoundedFit {
    let token = CancellationToken::default();
    let options = FitOptions {
        threads: Some(1),
        cancellation: Some(&token),
        ..FitOptions::default()
    };
    let (finished, wait) = mpsc::channel::<()>();
    let watched = token.clone();
    std::thread::scope(|scope| {
        scope.spawn(move || {
            if wait.recv_timeout(limit) == Err(mpsc::RecvTimeoutError::Timeout) {
                watched.cancel();
            }
        });
        let clock = Instant::now();
        let result = fit(model, dataset, &options);
        drop(finished);
        BoundedFit {
            result,
            seconds: clock.elapsed().as_secs_f64(),
        }
    })
}
