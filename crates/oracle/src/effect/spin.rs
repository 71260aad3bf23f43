//! Moments about the axis of a disc, which change its spin.

use super::{DISCS, Effect, Flow, Kind, Load, effect};
use crate::scalar::Real;

/// Built-in effects (optional additions to a model) that change the spin moment of a disc.
pub(super) const EFFECTS: &[Effect] = &[
    effect(
        "quadratic_spin_down",
        &["C_Nrr"],
        &DISCS,
        Kind::Spin(Spin::Quadratic),
    ),
    effect(
        "spin_down_by_pressure",
        &["C_Np"],
        &DISCS,
        Kind::Spin(Spin::ByPressure),
    ),
    effect(
        "spin_down_by_angle",
        &["C_Na"],
        &DISCS,
        Kind::Spin(Spin::ByAngle),
    ),
];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Spin {
    /// Moment about the body axis, proportional to the square of the spin, with the sign of the spin.
    Quadratic,
    /// Moment about the body axis, proportional to the product of dynamic pressure and advance ratio (spin × radius /
    /// airspeed).
    ByPressure,
    /// Moment about the body axis, proportional to the product of spin and angle of attack.
    ByAngle,
}

impl Spin {
    pub fn load<T: Real>(self, values: &[T], flow: &Flow<'_, T>) -> Load<T> {
        let (value, spin, axis) = (values[0], flow.spin(), flow.normal());
        Load::moment(match self {
            Self::Quadratic => {
                let sense = if spin.re() < 0.0 { -T::one() } else { T::one() };
                axis * (value * sense * spin * spin)
            }
            Self::ByPressure => flow.pressure_moment(value * flow.advance_ratio(), axis),
            Self::ByAngle => axis * (value * flow.alpha() * spin),
        })
    }
}
