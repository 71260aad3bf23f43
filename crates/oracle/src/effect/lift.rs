//! Effects on the lift of a disc.

use super::{DISC, DISCS, Effect, Flow, Kind, Load, effect};
use crate::scalar::Real;

/// Angle of attack at which stall begins, degrees.
const STALL_ANGLE: f64 = 8.0;
/// Height above the ground at which the additional lift near the ground is 1/e of its value at the ground, m.
const GROUND_EFFECT_HEIGHT: f64 = 0.5;

/// Built-in effects (optional additions to a model) that change the lift of a disc.
pub(super) const EFFECTS: &[Effect] = &[
    effect("stall", &["C_Ls"], &DISC, Kind::Lift(Lift::Stall)),
    effect("lift_by_spin", &["C_LS"], &DISCS, Kind::Lift(Lift::BySpin)),
    effect(
        "ground_effect",
        &["C_Lg"],
        &DISCS,
        Kind::Lift(Lift::NearGround),
    ),
];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Lift {
    /// Decrease of the lift coefficient above the stall angle, proportional to the square of the excess angle of
    /// attack.
    Stall,
    /// Change of the lift coefficient proportional to the absolute value of the advance ratio (spin × radius /
    /// airspeed).
    BySpin,
    /// Increase of the lift coefficient near the ground, decreasing with height.
    NearGround,
}

impl Lift {
    pub fn load<T: Real>(self, values: &[T], flow: &Flow<'_, T>) -> Load<T> {
        let change = match self {
            Self::Stall => {
                let beyond = flow.alpha() - T::lit(STALL_ANGLE.to_radians());
                if beyond.re() > 0.0 {
                    -(beyond * beyond)
                } else {
                    T::zero()
                }
            }
            Self::BySpin => flow.advance_ratio().abs(),
            Self::NearGround => {
                let height = flow.at.position.z;
                (-(height * height) / T::lit(GROUND_EFFECT_HEIGHT * GROUND_EFFECT_HEIGHT)).exp()
            }
        };
        Load::force(flow.lift(values[0] * change))
    }
}
