//! Effects on the drag of a disc.

use super::{DISC, DISCS, Effect, Flow, Kind, Load, effect};
use crate::scalar::Real;

/// Airspeed at which the Reynolds-number term of the drag is 0, m/s.
const REFERENCE_SPEED: f64 = 14.0;

/// Built-in effects (optional additions to a model) that change the drag of a disc.
pub(super) const EFFECTS: &[Effect] = &[
    effect(
        "zero_lift_drag_angle",
        &["alpha_0"],
        &DISC,
        Kind::Drag(Drag::ZeroLiftAngle),
    ),
    effect("drag_by_spin", &["C_DS"], &DISCS, Kind::Drag(Drag::BySpin)),
    effect(
        "drag_by_reynolds",
        &["C_DRe"],
        &DISCS,
        Kind::Drag(Drag::ByReynolds),
    ),
];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Drag {
    /// Shift of the minimum of the drag to a nonzero angle of attack.
    ZeroLiftAngle,
    /// Change of the drag coefficient proportional to the absolute value of the advance ratio (spin × radius /
    /// airspeed).
    BySpin,
    /// Change of the drag coefficient proportional to the logarithm of the ratio of the Reynolds number to its value at
    /// the reference speed of 14 m/s.
    ByReynolds,
}

impl Drag {
    pub fn load<T: Real>(self, values: &[T], flow: &Flow<'_, T>) -> Load<T> {
        let value = values[0];
        let change = match self {
            Self::ZeroLiftAngle => {
                // Parabola with the shifted minimum, minus the parabola with its minimum at 0.
                let alpha = flow.alpha();
                let shifted = alpha - value;
                flow.constant("C_Da") * (shifted * shifted - alpha * alpha)
            }
            Self::BySpin => value * flow.advance_ratio().abs(),
            Self::ByReynolds => value * (flow.speed() / T::lit(REFERENCE_SPEED)).ln(),
        };
        Load::force(flow.drag(change))
    }
}
