//! Errors of the generation of synthetic datasets.

use flight::release::Release;
use ode::IntegrationError;

use super::MAX_POINTS;

/// Error for a setting of a synthetic dataset that is outside its allowed range.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("{name}: found {found}, expected {least} to {most}")]
pub struct OutOfRange {
    /// Name of the setting.
    pub name: &'static str,
    /// Value of the setting, which is outside the allowed range.
    pub found: f64,
    /// Minimum allowed value.
    pub least: f64,
    /// Maximum allowed value.
    pub most: f64,
}

impl OutOfRange {
    /// Checks that `found`, the value of the setting `name`, is between `least` and `most`.
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

/// Reason why a flight cannot be simulated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SimulationError {
    /// The dataset would contain more marker positions than the maximum `MAX_POINTS`.
    #[error(
        "at {samples} samples a flight there are {points} marker points, expected at most {MAX_POINTS}"
    )]
    TooManyPoints {
        /// Number of samples of a flight.
        samples: f64,
        /// Number of marker positions in all flights.
        points: f64,
    },
    /// A flight is to be simulated until it reaches the ground, but no state of the model is its height.
    #[error("no state of the model is a height")]
    NoHeight,
    /// The flight does not reach the ground within the maximum duration of a simulation.
    #[error("it is still up after {} s", Release::MAX_DURATION)]
    NoLanding,
    /// The trajectory cannot be integrated.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
}

/// Reason why a synthetic dataset cannot be generated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SynthesisError {
    /// The settings, the model or the launch conditions (releases) are invalid. Contains the message.
    #[error("{0}")]
    Plan(String),
    /// A setting of the measurement noise or of the variation of the initial states is outside its allowed range.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
    /// A flight cannot be simulated.
    #[error("flight {number}: {reason}")]
    Flight {
        /// Number of the flight in the dataset, counted from 1.
        number: usize,
        /// Reason why the flight cannot be simulated.
        reason: SimulationError,
    },
}
