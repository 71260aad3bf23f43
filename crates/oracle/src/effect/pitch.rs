//! Moments about d2.

use super::{Load, Scene};
use crate::scalar::Real;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Pitch {
    /// At any angle.
    Constant,
    /// By the cube of the angle of attack.
    Cubic,
    /// By the size of the spin.
    BySpin,
}

impl Pitch {
    pub fn load<T: Real>(self, values: &[T], scene: &Scene<'_, T>) -> Load<T> {
        let by = match self {
            Self::Constant => T::one(),
            Self::Cubic => scene.alpha().powi(3),
            Self::BySpin => scene.spin_ratio().abs(),
        };
        let [_, left] = scene.forward_and_left();
        Load::moment(scene.turned(values[0] * by, left))
    }
}
