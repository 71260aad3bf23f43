//! Why a synthetic dataset cannot be generated.

use flight::release::Release;
use ode::IntegrationError;

use super::MOST_POINTS;

/// A setting outside its range.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("{name}: found {found}, expected {least} to {most}")]
pub struct OutOfRange {
    /// Name of the setting.
    pub name: &'static str,
    /// Its value.
    pub found: f64,
    /// Least allowed value.
    pub least: f64,
    /// Greatest allowed value.
    pub most: f64,
}

impl OutOfRange {
    /// Checks that a value is in its range.
    pub(super) fn check(
        name: &'static str,
        found: f64,
        least: f64,
        most: f64,
    ) -> Result<(), OutOfRange> {
        match (least..=most).contains(&found) {
            true => Ok(()),
            false => Err(OutOfRange {
                name,
                found,
                least,
                most,
            }),
        }
    }
}

/// Why a flight cannot be simulated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SimulationError {
    /// The dataset would have more points than the limit.
    #[error(
        "at {samples} samples a flight there are {points} marker points, expected at most {MOST_POINTS}"
    )]
    TooManyPoints {
        /// Number of samples of a flight.
        samples: f64,
        /// Number of marker points of all flights.
        points: f64,
    },
    /// The release ends at the ground, and the model has no height.
    #[error("the model has no z")]
    NoHeight,
    /// The flight does not reach the ground.
    #[error("it is still up after {} s", Release::MAX_DURATION)]
    NoLanding,
    /// The trajectory cannot be integrated.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
}

/// Why a synthetic dataset cannot be generated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SynthesisError {
    /// A setting of the plan, the model or the releases is invalid; the message says which.
    #[error("{0}")]
    Plan(String),
    /// A setting of the noise or of the spread is outside its range.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
    /// A flight cannot be simulated.
    #[error("flight {number}: {reason}")]
    Flight {
        /// Number of the flight, from 1.
        number: usize,
        /// Reason why not.
        reason: SimulationError,
    },
}
