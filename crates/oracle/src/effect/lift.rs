//! What changes the lift.

use super::{Load, Scene};
use crate::scalar::Real;

/// Angle above which the lift bends, degrees.
const BEND: f64 = 8.0;
/// Height over which the ground is felt, m.
const NEAR: f64 = 0.5;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Lift {
    /// It bends away above an angle.
    Stall,
    /// By the size of the spin.
    BySpin,
    /// It grows near the ground.
    NearGround,
}

impl Lift {
    pub fn load<T: Real>(self, values: &[T], scene: &Scene<'_, T>) -> Load<T> {
        let change = match self {
            Self::Stall => {
                let beyond = scene.alpha() - T::lit(BEND.to_radians());
                if beyond.re() > 0.0 {
                    -(beyond * beyond)
                } else {
                    T::zero()
                }
            }
            Self::BySpin => scene.spin_ratio().abs(),
            Self::NearGround => {
                let height = scene.at.position.z;
                (-(height * height) / T::lit(NEAR * NEAR)).exp()
            }
        };
        Load::force(scene.lifted(values[0] * change))
    }
}
