//! Moments about the axis.

use super::{Load, Scene};
use crate::scalar::Real;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Spin {
    /// By the square of the spin, against it or with it.
    Quadratic,
    /// By the stream and the spin ratio.
    ByPressure,
    /// By the spin and the angle of attack.
    ByAngle,
}

impl Spin {
    pub fn load<T: Real>(self, values: &[T], scene: &Scene<'_, T>) -> Load<T> {
        let (value, spin, axis) = (values[0], scene.spin(), scene.normal());
        Load::moment(match self {
            Self::Quadratic => {
                let sense = if spin.re() < 0.0 { -T::one() } else { T::one() };
                axis * (value * sense * spin * spin)
            }
            Self::ByPressure => scene.turned(value * scene.spin_ratio(), axis),
            Self::ByAngle => axis * (value * scene.alpha() * spin),
        })
    }
}
