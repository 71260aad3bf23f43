//! Outcome of each flight, convergence status of a fit, and residuals by kind of sensor.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::channel::MARKER;
use crate::least_squares::StopReason;
use crate::numbers::quantity;

/// Outcome of a flight in a fit.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "outcome", rename_all = "snake_case")]
pub enum FlightOutcome {
    /// The initial state of the flight was fitted together with the global parameters.
    #[default]
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
    #[doc(hidden)]
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FitStatus {
    /// The last least-squares minimisation converged, and the noise model agrees with its residuals.
    #[default]
    Converged,
    /// The last minimisation reached its maximum number of steps, or progressed too slowly.
    MaxSteps,
    /// The last least-squares minimisation ended at a point from which no step decreases the sum of squares.
    NoDescent,
    /// The deadline passed; the result is the best one found before.
    Deadline,
    /// The noise model and the residuals did not agree after the maximum number of noise estimates.
    NoiseNotConverged,
}

impl FitStatus {
    /// Status after a minimisation; `noise_agrees` states whether the noise model agrees with its residuals.
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
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

// Root mean square residuals by kind of sensor.

/// Root mean square residual of one component of a measured quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rms {
    /// Root mean square of the residuals, outliers excluded, in the unit `unit`.
    pub value: f64,
    /// Unit of the measured quantity.
    pub unit: String,
}

/// Sums of squared residuals and their numbers, by kind of sensor.
#[derive(Clone, Debug, Default)]
pub(crate) struct SquareSums(BTreeMap<&'static str, (f64, usize, Unit)>);

/// Name of a unit, and its value in SI.
type Unit = (&'static str, f64);

impl SquareSums {
    /// Adds `count` squared residuals of a kind of sensor, whose sum is `squares`, in the square of `unit`. The unit of
    /// a kind is the one that is added first.
    pub fn add(&mut self, kind: &'static str, unit: Unit, squares: f64, count: usize) {
        let sum = self.0.entry(kind).or_insert((0.0, 0, unit));
        sum.0 += squares * (unit.1 / sum.2.1).powi(2);
        sum.1 += count;
    }

    /// Root mean square of the residuals of each kind that has any.
    pub fn rms(self) -> BTreeMap<String, Rms> {
        let kinds = self.0.into_iter().filter(|(_, (_, count, _))| *count > 0);
        let each = kinds.map(|(kind, (squares, count, (unit, _)))| {
            let value = (squares / count as f64).sqrt();
            let unit = unit.to_owned();
            (kind.to_owned(), Rms { value, unit })
        });
        each.collect()
    }
}

/// The value of the [`leading`] kind of sensor with its unit, in words; `–` if there is none.
pub(super) fn text(by_kind: &BTreeMap<String, Rms>) -> String {
    leading(by_kind).map_or_else(|| "–".to_owned(), |rms| quantity(rms.value, &rms.unit))
}

/// What belongs to the positions among the kinds of sensors, or to the first kind where no positions are measured.
pub(super) fn leading<T>(by_kind: &BTreeMap<String, T>) -> Option<&T> {
    by_kind.get(MARKER).or_else(|| by_kind.values().next())
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
