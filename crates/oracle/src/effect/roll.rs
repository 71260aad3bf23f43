//! Rolling moments of a disc, about d1.

use super::{DISCS, Effect, Flow, Kind, Load, effect};
use crate::scalar::Real;

/// Angle of attack around which the rolling moment that acts only at low angles of attack drops to 0, and half-width of
/// this transition, degrees.
const LOW_ANGLE_END: (f64, f64) = (10.0, 2.0);

/// Built-in effects (optional additions to a model) that change the rolling moment of a disc.
pub(super) const EFFECTS: &[Effect] = &[
    effect("roll_damping", &["C_Rp"], &DISCS, Kind::Roll(Roll::Damping)),
    effect(
        "rolling_moment_by_angle",
        &["C_Ra"],
        &DISCS,
        Kind::Roll(Roll::ByAngle),
    ),
    effect(
        "rolling_moment_by_spin_ratio",
        &["C_RS"],
        &DISCS,
        Kind::Roll(Roll::BySpinRatio),
    ),
    effect(
        "rolling_moment_at_low_angle",
        &["C_Rg"],
        &DISCS,
        Kind::Roll(Roll::AtLowAngle),
    ),
];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Roll {
    /// Damping moment coefficient proportional to the angular rate about d1, the forward direction normal to the axis
    /// of symmetry.
    Damping,
    /// Rolling moment coefficient proportional to the angle of attack.
    ByAngle,
    /// Rolling moment coefficient proportional to the advance ratio (spin × radius / airspeed).
    BySpinRatio,
    /// Rolling moment coefficient proportional to the advance ratio (spin × radius / airspeed), at low angles of attack
    /// only.
    AtLowAngle,
}

impl Roll {
    pub fn load<T: Real>(self, values: &[T], flow: &Flow<'_, T>) -> Load<T> {
        let [forward, _] = flow.forward_and_left();
        let by = match self {
            Self::Damping => flow.at.angular_velocity.dot(&forward),
            Self::ByAngle => flow.alpha(),
            Self::BySpinRatio => flow.advance_ratio(),
            Self::AtLowAngle => {
                // The model text states the same logistic function by a hyperbolic tangent.
                let [end, width] = [LOW_ANGLE_END.0, LOW_ANGLE_END.1]
                    .map(|degrees: f64| T::lit(degrees.to_radians()));
                let x = (flow.alpha() - end) / width;
                flow.advance_ratio() / (T::one() + (x + x).exp())
            }
        };
        Load::moment(flow.pressure_moment(values[0] * by, forward))
    }
}
