//! Effects on the surroundings: wind, air density, gravity.

use super::{ANY, Effect, Kind, effect};
use crate::physical::Physical;
use crate::scalar::Real;
use nalgebra::Vector3;

/// Built-in effects (optional additions to a model) that change the wind, air density and gravity.
pub(super) const EFFECTS: &[Effect] = &[
    effect("wind", &["W_x", "W_y"], &ANY, Kind::Air(Air::Wind)),
    Effect {
        states: &["gust_x", "gust_y"],
        ..effect("wind_of_each_flight", &[], &ANY, Kind::Air(Air::Wind))
    },
    effect(
        "wind_by_height",
        &["shear_x", "shear_y"],
        &ANY,
        Kind::Air(Air::WindByHeight),
    ),
    effect("air_density", &["rho_error"], &ANY, Kind::Air(Air::Density)),
    effect("gravity", &["g_error"], &ANY, Kind::Air(Air::Gravity)),
];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Air {
    /// Adds a uniform horizontal wind.
    Wind,
    /// Adds a horizontal wind proportional to the height.
    WindByHeight,
    /// Relative error of the air density: the true density is (1 + value) times that of the model, where value is the
    /// coefficient of the effect.
    Density,
    /// Relative error of the gravitational acceleration: the true one is (1 + value) times that of the model, where
    /// value is the coefficient of the effect.
    Gravity,
}

impl Air {
    /// Velocity that this effect (optional addition to a model) adds to the wind of the model, m/s, in inertial
    /// components; 0 for an effect on density or gravity. `values` are those of the effect's coefficients and states.
    pub fn velocity<T: Real>(self, values: &[T], at: &Physical<T>) -> Vector3<T> {
        let along = match self {
            Self::Wind => T::one(),
            Self::WindByHeight => at.position.z,
            Self::Density | Self::Gravity => return Vector3::zeros(),
        };
        Vector3::new(values[0], values[1], T::zero()) * along
    }

    /// Name of the model's constant that this effect (optional addition to a model) scales, `rho` (air density) or `g`
    /// (gravity), and the scale factor. `None` for an effect on the wind. `values` are those of the effect's
    /// coefficients and states.
    pub fn factor<T: Real>(self, values: &[T]) -> Option<(&'static str, T)> {
        let name = match self {
            Self::Density => "rho",
            Self::Gravity => "g",
            Self::Wind | Self::WindByHeight => return None,
        };
        Some((name, T::one() + values[0]))
    }
}
