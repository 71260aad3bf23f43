//! Side forces on a disc, along d2.

use super::{DISCS, Effect, Flow, Kind, Load, effect};
use crate::scalar::Real;

/// Built-in effects (optional additions to a model) that change the side force of a disc.
pub(super) const EFFECTS: &[Effect] = &[
    effect(
        "side_force_by_spin",
        &["C_YS"],
        &DISCS,
        Kind::Side(Side::BySpin),
    ),
    effect(
        "side_force_by_spin_and_angle",
        &["C_YSa"],
        &DISCS,
        Kind::Side(Side::BySpinAndAngle),
    ),
];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Side {
    /// Side force coefficient proportional to the advance ratio (spin × radius / airspeed).
    BySpin,
    /// Side force coefficient proportional to the product of advance ratio (spin × radius / airspeed) and angle of
    /// attack.
    BySpinAndAngle,
}

impl Side {
    pub fn load<T: Real>(self, values: &[T], flow: &Flow<'_, T>) -> Load<T> {
        let by = match self {
            Self::BySpin => flow.advance_ratio(),
            Self::BySpinAndAngle => flow.alpha() * flow.advance_ratio(),
        };
        let [_, left] = flow.forward_and_left();
        Load::force(flow.pressure_force(values[0] * by, left))
    }
}
