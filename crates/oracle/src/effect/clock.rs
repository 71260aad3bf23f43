//! Errors of the rate of recorded time (the time stamps of the measurements) relative to true time.

use super::{ANY, Effect, Kind, effect};
use crate::scalar::Real;

/// Built-in effects (optional additions to a model) that change the rate of recorded time (the time stamps of the
/// measurements) relative to true time.
pub(super) const EFFECTS: &[Effect] = &[effect("clock_rate", &["clock_error"], &ANY, Kind::Clock)];

/// Factor 1/(1 + e) by which the effect (optional addition to a model) multiplies the seconds of true time per second
/// of recorded time (the time stamps of the measurements). Here e is the relative error of the time stamps, the only
/// entry of `values`.
pub(super) fn factor<T: Real>(values: &[T]) -> T {
    T::one() / (T::one() + values[0])
}
