//! Outcome of each flight, and convergence status of a fit.

use serde::{Deserialize, Serialize};

use crate::least_squares::StopReason;

/// Outcome of a flight in a fit.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "outcome", rename_all = "snake_case")]
pub enum FlightOutcome {
    /// The initial state of the flight was fitted together with the global parameters.
    Fitted,
    /// The initial state was fitted to the conditioning segment, and the later samples were predicted.
    HeldOut,
    /// The flight was not used in the fit.
    Excluded {
        /// Reason for the exclusion of the flight, as text for the report.
        reason: String,
    },
}

impl FlightOutcome {
    /// Name of the outcome in reports: `fitted`, `held_out` or `excluded`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Fitted => "fitted",
            Self::HeldOut => "held_out",
            Self::Excluded { .. } => "excluded",
        }
    }

    /// Reason for the exclusion of the flight; `None` if it was used.
    pub fn reason(&self) -> Option<&str> {
        match self {
            Self::Fitted | Self::HeldOut => None,
            Self::Excluded { reason } => Some(reason),
        }
    }
}

/// Convergence status of a fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FitStatus {
    /// The last least-squares minimisation converged, and the noise model agrees with its residuals.
    Converged,
    /// The last least-squares minimisation reached its maximum number of steps, or was stopped because of slow
    /// progress.
    MaxSteps,
    /// The last least-squares minimisation ended at a point from which no step decreases the sum of squares.
    NoDescent,
    /// The deadline passed; the result is the best one found before.
    Deadline,
    /// The noise model and the residuals did not agree after the maximum number of noise estimates.
    NoiseNotConverged,
}

impl FitStatus {
    /// Status after a least-squares minimisation, given the reason why it stopped. `noise_agrees` states whether the
    /// noise model agrees with the residuals at the end of the minimisation.
    pub(crate) fn of(least_squares: StopReason, noise_agrees: bool) -> Self {
        match least_squares {
            StopReason::MaxSteps | StopReason::GivenUp => Self::MaxSteps,
            StopReason::NoDescent => Self::NoDescent,
            StopReason::Deadline => Self::Deadline,
            StopReason::Converged if !noise_agrees => Self::NoiseNotConverged,
            StopReason::Converged => Self::Converged,
        }
    }

    /// Whether the status is [`Converged`](Self::Converged).
    pub fn converged(self) -> bool {
        self == Self::Converged
    }
}

/// Number of steps and status of the iterations of a fit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Iterations {
    /// Total number of least-squares steps in all stages of the fit.
    pub steps: usize,
    /// Number of times that the measurement noise was estimated from the residuals.
    pub rounds: usize,
    /// Whether `status` is [`FitStatus::Converged`].
    pub converged: bool,
    /// Convergence status: reason why the last least-squares minimisation, or the repeated noise estimation, ended.
    pub status: FitStatus,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fit_whose_noise_does_not_agree_is_not_converged() {
        assert!(FitStatus::of(StopReason::Converged, true).converged());
        let status = FitStatus::of(StopReason::Converged, false);
        assert_eq!(status, FitStatus::NoiseNotConverged);
        assert!(!status.converged());
    }
}
