//! What surrounds the body: wind, the density of the air, gravity.

use crate::physical::Physical;
use crate::scalar::Real;
use nalgebra::Vector3;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Air {
    /// The air moves, everywhere alike.
    Wind,
    /// It moves the faster the higher.
    WindByHeight,
    /// It is denser.
    Density,
    /// Gravity is greater.
    Gravity,
}

impl Air {
    /// Velocity of the air, beside the wind that was given.
    pub fn velocity<T: Real>(self, values: &[T], at: &Physical<T>) -> Vector3<T> {
        let along = match self {
            Self::Wind => T::one(),
            Self::WindByHeight => at.position.z,
            Self::Density | Self::Gravity => return Vector3::zeros(),
        };
        Vector3::new(values[0], values[1], T::zero()) * along
    }

    /// The constant of the law that it makes greater, and by which factor.
    pub fn factor<T: Real>(self, values: &[T]) -> Option<(&'static str, T)> {
        let name = match self {
            Self::Density => "rho",
            Self::Gravity => "g",
            Self::Wind | Self::WindByHeight => return None,
        };
        Some((name, T::one() + values[0]))
    }
}
