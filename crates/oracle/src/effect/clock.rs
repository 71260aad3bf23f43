//! Errors of the clock that produces the time stamps.

use super::{ANY, Effect, Kind, effect};
use crate::scalar::Real;

/// Built-in effects on the clock.
pub(super) const EFFECTS: &[Effect] = &[effect(
    "clock_rate",
    &["clock_error"],
    &ANY,
    Kind::Clock(Clock::Rate),
)];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Clock {
    /// The clock runs fast by a constant fraction.
    Rate,
}

impl Clock {
    /// Factor 1/(1 + error) by which the effect multiplies the seconds of flight per second of the measuring clock.
    pub fn factor<T: Real>(self, values: &[T]) -> T {
        match self {
            Self::Rate => T::one() / (T::one() + values[0]),
        }
    }
}
