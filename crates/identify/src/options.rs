//! Options of a fit, its progress and its cancellation.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use crate::error::FitError;
use crate::screening::DataFault;

/// Options of a fit. The default estimates every coefficient of the model within the model's bounds, without priors and
/// profiles, on all processors.
#[derive(Clone, Copy, Debug, Default)]
pub struct FitOptions<'a> {
    /// Coefficients that are fixed: at a value (SI), or at the model's value.
    pub fixed: &'a [(String, Option<f64>)],
    /// Constants and components of inputs (`wind_x`) that are estimated too, one value for all flights.
    pub free: &'a [String],
    /// Gaussian priors of global parameters.
    pub priors: &'a [Prior],
    /// Whether coefficients may leave the bounds of the model.
    pub unbounded: bool,
    /// Global parameters whose likelihood is profiled.
    pub profiles: &'a [String],
    /// Whether flights with a [`DataFault`](crate::DataFault) are used nevertheless; the report lists the faults either way.
    pub trust_data: bool,
    /// Faults that an earlier fit of the same flights reported; none to look for them.
    pub known_faults: Option<&'a [DataFault]>,
    /// Number of threads; none for the number of processors. The result does not depend on it.
    pub threads: Option<usize>,
    /// Receives the progress.
    pub progress: Option<&'a dyn Progress>,
    /// Cancels the fit.
    pub cancellation: Option<&'a CancellationToken>,
    /// Time at which the iteration stops with the best answer so far, whose status is
    /// [`FitStatus::Deadline`](crate::FitStatus::Deadline). That answer depends on the speed of the machine.
    pub deadline: Option<Instant>,
}

/// Gaussian prior of a global parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Prior {
    /// Name of the parameter.
    pub name: String,
    /// Mean of the prior distribution, in the SI unit of the parameter.
    pub value: f64,
    /// Standard deviation of the prior distribution, in the SI unit of the parameter.
    pub sigma: f64,
}

/// Receives the progress of a fit, from any thread.
pub trait Progress: std::fmt::Debug + Sync {
    /// A stage starts, which works on this number of flights. It may go over them several times.
    fn stage_started(&self, stage: &str, flights: usize);
    /// The stage has finished work on one flight.
    fn flight_done(&self);
}

/// Cancels work from another thread; clones cancel the same work.
#[derive(Clone, Debug, Default)]
pub struct CancellationToken(Arc<AtomicBool>);

impl CancellationToken {
    /// Cancels the work.
    pub fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether the work is cancelled.
    pub fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

impl FitOptions<'_> {
    /// Checks the numbers in the options: finite values, positive standard deviations, at least one thread.
    ///
    /// # Errors
    /// [`FitError::InvalidOption`].
    pub fn validate(&self) -> Result<(), FitError> {
        let invalid = |option, name: &str, value, expected| {
            Err(FitError::InvalidOption {
                option,
                name: name.to_owned(),
                value,
                expected,
            })
        };
        for (name, value) in self.fixed {
            if let Some(value) = *value
                && !value.is_finite()
            {
                return invalid("the fixed value", name, value, "a finite number");
            }
        }
        for prior in self.priors {
            if !prior.value.is_finite() {
                return invalid(
                    "the prior mean",
                    &prior.name,
                    prior.value,
                    "a finite number",
                );
            }
            if !(prior.sigma.is_finite() && prior.sigma > 0.0) {
                let expected = "a positive number";
                return invalid(
                    "the prior standard deviation",
                    &prior.name,
                    prior.sigma,
                    expected,
                );
            }
        }
        match self.threads {
            Some(0) => invalid("the number", "threads", 0.0, "at least 1"),
            _ => Ok(()),
        }
    }

    pub(crate) fn stage_started(&self, stage: &str, flights: usize) {
        if let Some(progress) = self.progress {
            progress.stage_started(stage, flights);
        }
    }

    pub(crate) fn flight_done(&self) {
        if let Some(progress) = self.progress {
            progress.flight_done();
        }
    }

    /// Whether the work is cancelled.
    pub fn is_cancelled(&self) -> bool {
        let token = self.cancellation;
        token.is_some_and(CancellationToken::is_cancelled)
    }

    /// Whether the deadline has passed.
    pub fn is_past_deadline(&self) -> bool {
        self.deadline
            .is_some_and(|deadline| Instant::now() >= deadline)
    }

    /// Number of threads, at least 1.
    pub fn threads(&self) -> usize {
        self.threads.unwrap_or_else(flight::batch::threads).max(1)
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
