//! Effects on the surroundings: wind, air density, gravity, and the clock of the measurement.

use nalgebra::Vector3;
use oracle::scalar::Real;

/// Velocity that the effect called `name` adds to the wind at the height `height` (m), m/s, in inertial components; 0
/// for an effect on something else. `values` are those of the effect's coefficients and states.
pub(super) fn wind<T: Real>(name: &str, values: &[T], height: T) -> Vector3<T> {
    let along = match name {
        "wind" | "wind_of_each_flight" => T::one(),
        "wind_by_height" => height,
        _ => return Vector3::zeros(),
    };
    Vector3::new(values[0], values[1], T::zero()) * along
}

/// Name of the constant of the law that the effect called `name` scales, `rho` (air density) or `g` (gravity), and the
/// scale factor 1 + value; `None` for an effect on something else.
pub(super) fn factor<T: Real>(name: &str, values: &[T]) -> Option<(&'static str, T)> {
    let constant = match name {
        "air_density" => "rho",
        "gravity" => "g",
        _ => return None,
    };
    Some((constant, T::one() + values[0]))
}

/// Factor 1/(1 + e) by which an error of the clock multiplies the seconds of true time per second of recorded time,
/// with the relative error e of the time stamps, the only value of the effect.
pub(super) fn clock<T: Real>(values: &[T]) -> T {
    T::one() / (T::one() + values[0])
}
