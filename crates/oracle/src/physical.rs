//! The state of a body as nature has it, whatever coordinates a model chooses for it.

use crate::attitude::Quaternion;
use crate::scalar::Field;
use nalgebra::Vector3;

/// Where a body is and how it moves; every vector in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Physical<T> {
    /// Position of the mass centre.
    pub position: Vector3<T>,
    /// Velocity of the mass centre.
    pub velocity: Vector3<T>,
    /// Attitude of the frame that is fixed in the body.
    pub attitude: Quaternion<T>,
    /// Angular velocity of the body.
    pub angular_velocity: Vector3<T>,
}

impl<T: Field> Physical<T> {
    /// At rest at the origin.
    pub fn rest() -> Self {
        Self {
            position: Vector3::zeros(),
            velocity: Vector3::zeros(),
            attitude: Quaternion::identity(),
            angular_velocity: Vector3::zeros(),
        }
    }
}

/// What acts on a body and how it answers; every vector in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<T> {
    /// Sum of the forces.
    pub force: Vector3<T>,
    /// Sum of the moments about the mass centre.
    pub moment: Vector3<T>,
    /// Acceleration of the mass centre.
    pub acceleration: Vector3<T>,
    /// Angular acceleration of the body.
    pub angular_acceleration: Vector3<T>,
}
