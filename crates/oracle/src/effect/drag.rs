//! What changes the drag of a disc.

use super::{Load, Scene};
use crate::scalar::Real;

/// Speed at which the drag by the Reynolds number is that of the law, m/s.
const MIDDLE: f64 = 14.0;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Drag {
    /// It is least at another angle than zero.
    ZeroLiftAngle,
    /// By the size of the spin.
    BySpin,
    /// By the logarithm of the speed.
    ByReynolds,
}

impl Drag {
    pub fn load<T: Real>(self, values: &[T], scene: &Scene<'_, T>) -> Load<T> {
        let value = values[0];
        let change = match self {
            Self::ZeroLiftAngle => {
                // The parabola about its new place, less the parabola about zero.
                let alpha = scene.alpha();
                let from = alpha - value;
                scene.constant("C_Da") * (from * from - alpha * alpha)
            }
            Self::BySpin => value * scene.spin_ratio().abs(),
            Self::ByReynolds => value * (scene.speed() / T::lit(MIDDLE)).ln(),
        };
        Load::force(scene.dragged(change))
    }
}
