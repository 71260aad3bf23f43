//! Options of a fit, progress reports and cancellation.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use flight::parallel;

use crate::error::{FitError, FlightError};
use dataset::DataFault;

/// Options of a fit. By default, every coefficient is estimated within its bounds, on all processors.
#[derive(Clone, Copy, Debug, Default)]
pub struct FitOptions<'a> {
    /// Coefficients that are fixed, each with its value (SI); `None` is the model's value.
    pub fixed: &'a [(String, Option<f64>)],
    /// Constants and components of inputs (such as `wind_x`) that are estimated, too, with one value for all flights.
    pub free: &'a [String],
    /// Gaussian priors of global parameters.
    pub priors: &'a [Prior],
    /// Whether estimates may leave the bounds that the model gives for its coefficients.
    pub unbounded: bool,
    /// Names of the global parameters whose profile likelihood is computed.
    pub profiles: &'a [String],
    /// Whether flights with a [`DataFault`](crate::DataFault), which the report lists, are fitted nevertheless.
    pub trust_data: bool,
    /// Data faults that an earlier fit of the same flights reported; `None` if the data are to be screened for faults.
    pub known_faults: Option<&'a [DataFault]>,
    /// Number of threads; `None` for the number of processors. The result does not depend on it.
    pub threads: Option<usize>,
    /// Receiver of progress reports.
    pub progress: Option<&'a dyn Progress>,
    /// Token with which another thread can cancel the fit: as if its deadline had passed, and without a result.
    pub cancellation: Option<&'a CancellationToken>,
    /// Time at which the best estimates so far are returned, with status
    /// [`FitStatus::Deadline`](crate::FitStatus::Deadline).
    pub deadline: Option<Instant>,
}

/// Gaussian prior of a global parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Prior {
    /// Name of the global parameter.
    pub name: String,
    /// Mean of the prior distribution, in the SI unit of the parameter.
    pub value: f64,
    /// Standard deviation of the prior distribution, in the SI unit of the parameter.
    pub sigma: f64,
}

/// Receiver of progress reports of a fit. Methods may be called from any thread.
pub trait Progress: std::fmt::Debug + Sync {
    /// Called when a stage starts, with its name and the number of flights that it processes, perhaps several times.
    fn stage_started(&self, stage: &str, flights: usize);
    /// Called when the present stage of the fit has processed one flight.
    fn flight_done(&self);
}

/// Flag with which another thread cancels work. All clones share one flag.
#[derive(Clone, Debug, Default)]
pub struct CancellationToken(Arc<AtomicBool>);

impl CancellationToken {
    /// Requests cancellation of the work to which this token was given.
    pub fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether cancellation was requested by this token or a clone of it.
    pub fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

impl FitOptions<'_> {
    /// Checks that values are finite, standard deviations positive, and the number of threads at least 1.
    ///
    /// # Errors
    /// [`FitError::InvalidOption`] if a value is outside its allowed range.
    pub fn validate(&self) -> Result<(), FitError> {
        let finite = |value: f64| (value.is_finite(), "a finite number");
        let fixed = self.fixed.iter().filter_map(|(name, value)| {
            let value = (*value)?;
            Some(("the fixed value", &**name, value, finite(value)))
        });
        let priors = self.priors.iter().flat_map(|prior| {
            let Prior { name, value, sigma } = prior;
            let is_positive = sigma.is_finite() && *sigma > 0.0;
            let positive = (is_positive, "a positive number");
            [
                ("the prior mean", &**name, *value, finite(*value)),
                ("the prior standard deviation", &**name, *sigma, positive),
            ]
        });
        let threads = (self.threads != Some(0), "at least 1");
        let threads = ("the number", "threads", 0.0, threads);
        let mut all = fixed.chain(priors).chain([threads]);
        match all.find(|(.., (is_valid, _))| !is_valid) {
            Some((option, name, value, (_, expected))) => Err(FitError::InvalidOption {
                option,
                name: name.to_owned(),
                value,
                expected,
            }),
            None => Ok(()),
        }
    }

    pub(crate) fn stage_started(&self, stage: &str, flights: usize) {
        if let Some(progress) = self.progress {
            progress.stage_started(stage, flights);
        }
    }

    /// Runs `task` for each of `count` flights of a stage, on the threads of the fit.
    pub(crate) fn each_flight<R: Send>(
        &self,
        stage: &str,
        count: usize,
        task: impl Fn(usize) -> R + Sync,
    ) -> Vec<R> {
        self.stage_started(stage, count);
        parallel::each_on(self.threads(), count, |flight| {
            let is_skipped = self.is_cancelled();
            let done = task(flight);
            if !is_skipped {
                self.flight_done();
            }
            done
        })
    }

    pub(crate) fn flight_done(&self) {
        if let Some(progress) = self.progress {
            progress.flight_done();
        }
    }

    /// Whether the deadline of the fit has passed, or it was cancelled; `false` without a deadline and a token.
    pub fn is_past_deadline(&self) -> bool {
        let is_past = |deadline| Instant::now() >= deadline;
        self.is_cancelled() || self.deadline.is_some_and(is_past)
    }

    fn is_cancelled(&self) -> bool {
        let token = self.cancellation;
        token.is_some_and(CancellationToken::is_cancelled)
    }

    /// Nothing, or an error in place of the result of work that was cancelled: that is only what was found until then.
    ///
    /// # Errors
    /// [`FitError::Interrupted`] if the work was cancelled.
    pub fn check_cancelled(&self) -> Result<(), FitError> {
        match self.is_cancelled() {
            true => Err(FitError::Interrupted),
            false => Ok(()),
        }
    }

    /// Nothing, or an error in place of the work on a flight if the fit was cancelled.
    pub(crate) fn check_flight(&self) -> Result<(), FlightError> {
        self.check_cancelled().map_err(|_| FlightError::Deadline)
    }

    /// Number of threads to use: the given number, or the number of processors if none is given; 0 is replaced by 1.
    pub fn threads(&self) -> usize {
        self.threads.unwrap_or_else(parallel::threads).max(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_are_valid_and_impossible_numbers_are_not() {
        assert_eq!(FitOptions::default().validate(), Ok(()));
        let prior = |value, sigma| {
            [Prior {
                name: "C_La".into(),
                value,
                sigma,
            }]
        };
        for priors in [
            prior(f64::NAN, 1.0),
            prior(1.0, 0.0),
            prior(1.0, -1.0),
            prior(1.0, f64::INFINITY),
        ] {
            let options = FitOptions {
                priors: &priors,
                ..FitOptions::default()
            };
            assert!(matches!(
                options.validate(),
                Err(FitError::InvalidOption { .. })
            ));
        }
        let options = FitOptions {
            threads: Some(0),
            ..FitOptions::default()
        };
        assert!(options.validate().is_err());
    }
}
