//! State of a body, independent of the coordinates that a model chooses for it.

use crate::attitude::Quaternion;
use crate::scalar::Field;
use nalgebra::Vector3;

/// Physical state of a body; all vectors are in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Physical<T> {
    /// Position of the mass centre, m.
    pub position: Vector3<T>,
    /// Velocity of the mass centre, m/s.
    pub velocity: Vector3<T>,
    /// Attitude of the body frame relative to the inertial frame.
    pub attitude: Quaternion<T>,
    /// Angular velocity of the body, rad/s.
    pub angular_velocity: Vector3<T>,
}

impl<T: Field> Physical<T> {
    /// State of a body at rest at the origin, with body axes parallel to the inertial axes.
    pub fn rest() -> Self {
        Self {
            position: Vector3::zeros(),
            velocity: Vector3::zeros(),
            attitude: Quaternion::identity(),
            angular_velocity: Vector3::zeros(),
        }
    }
}

/// Forces and moments on a body, and the accelerations of the body; all vectors are in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<T> {
    /// Sum of the forces, N.
    pub force: Vector3<T>,
    /// Sum of the moments about the mass centre, N·m.
    pub moment: Vector3<T>,
    /// Acceleration of the mass centre, m/s².
    pub acceleration: Vector3<T>,
    /// Angular acceleration of the body, rad/s².
    pub angular_acceleration: Vector3<T>,
}
