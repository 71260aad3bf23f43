//! Pitching moments of a disc, about d2.

use super::{DISC, DISCS, Effect, Flow, Kind, Load, effect};
use crate::scalar::Real;

/// Built-in effects (optional additions to a model) that change the pitching moment of a disc.
pub(super) const EFFECTS: &[Effect] = &[
    effect(
        "constant_pitching_moment",
        &["C_M0"],
        &DISCS,
        Kind::Pitch(Pitch::Constant),
    ),
    effect(
        "cubic_pitching_moment",
        &["C_Maaa"],
        &DISC,
        Kind::Pitch(Pitch::Cubic),
    ),
    effect(
        "pitching_moment_by_spin",
        &["C_MS"],
        &DISCS,
        Kind::Pitch(Pitch::BySpin),
    ),
];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Pitch {
    /// Pitching moment coefficient independent of the angle of attack.
    Constant,
    /// Pitching moment coefficient proportional to the cube of the angle of attack.
    Cubic,
    /// Pitching moment coefficient proportional to the absolute value of the advance ratio (spin × radius / airspeed).
    BySpin,
}

impl Pitch {
    pub fn load<T: Real>(self, values: &[T], flow: &Flow<'_, T>) -> Load<T> {
        let by = match self {
            Self::Constant => T::one(),
            Self::Cubic => flow.alpha().powi(3),
            Self::BySpin => flow.advance_ratio().abs(),
        };
        let [_, left] = flow.forward_and_left();
        Load::moment(flow.pressure_moment(values[0] * by, left))
    }
}
