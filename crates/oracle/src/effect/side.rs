//! Forces to the side, along d2.

use super::{Load, Scene};
use crate::scalar::Real;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Side {
    /// By the spin ratio.
    BySpin,
    /// By the spin ratio and the angle of attack.
    BySpinAndAngle,
}

impl Side {
    pub fn load<T: Real>(self, values: &[T], scene: &Scene<'_, T>) -> Load<T> {
        let by = match self {
            Self::BySpin => scene.spin_ratio(),
            Self::BySpinAndAngle => scene.alpha() * scene.spin_ratio(),
        };
        let [_, left] = scene.forward_and_left();
        Load::force(scene.pressed(values[0] * by, left))
    }
}
