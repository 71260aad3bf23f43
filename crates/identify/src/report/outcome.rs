//! What became of each flight, and whether the iteration converged.

use serde::{Deserialize, Serialize};

use crate::least_squares::StopReason;

/// Use of a flight in the fit.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "outcome", rename_all = "kebab-case")]
pub enum FlightOutcome {
    /// The initial state was fitted together with the global parameters.
    Fitted,
    /// The initial state was fitted to the conditioning segment, and the rest of the flight was predicted.
    HeldOut,
    /// The flight was not used.
    Excluded {
        /// Reason for the exclusion.
        reason: String,
    },
}

/// Whether a fit converged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FitStatus {
    /// The least squares converged, and the noise agrees with its residuals.
    Converged,
    /// The last least squares reached its greatest number of steps.
    MaxSteps,
    /// The last least squares found no step that decreases the sum of squares.
    NoDescent,
    /// The deadline passed; the answer is the best one until then.
    Deadline,
    /// Noise and residuals did not agree after the greatest number of noise estimates.
    NoiseNotConverged,
}

impl FitStatus {
    /// The status after a least squares and a comparison of its residuals with the noise.
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

/// Steps and status of the iteration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Iterations {
    /// Number of steps tried.
    pub steps: usize,
    /// Number of noise estimates.
    pub rounds: usize,
    /// Whether the status is converged.
    pub converged: bool,
    /// Why the iteration ended.
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
