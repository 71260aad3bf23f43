//! Relative differences of physical quantities of two bodies.

use nalgebra::Vector3;
use oracle::PhysicalRate;

/// Relative differences of the rates of two bodies, by name of the quantity.
pub fn rate_differences(a: &PhysicalRate, b: &PhysicalRate) -> [(&'static str, f64); 4] {
    let turning = (a.angular_acceleration, b.angular_acceleration);
    [
        ("velocity", (a.velocity, b.velocity)),
        ("acceleration", (a.acceleration, b.acceleration)),
        ("angular velocity", (a.angular_velocity, b.angular_velocity)),
        ("angular acceleration", turning),
    ]
    .map(|(what, (a, b))| (what, relative_difference(a, b)))
}

/// Norm of the difference of two vectors, relative to the sum of their norms and 1, SI: far below a typical fault.
pub fn relative_difference(a: Vector3<f64>, b: Vector3<f64>) -> f64 {
    (a - b).norm() / (a.norm() + b.norm() + 1.0)
}
