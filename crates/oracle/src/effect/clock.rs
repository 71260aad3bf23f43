//! Errors of the clock that time stamps are taken from.

use super::{ANY, Effect, Kind, effect};
use crate::scalar::Real;

/// The effects of this file.
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
    /// Factor on the seconds of flight per second of the clock.
    pub fn factor<T: Real>(self, values: &[T]) -> T {
        match self {
            Self::Rate => T::one() / (T::one() + values[0]),
        }
    }
}
