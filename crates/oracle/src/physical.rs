//! State of a body, independent of the coordinates that a model chooses for it, and the laws dp/dt = F and dH/dt = M in
//! inertial components, with p = m v and H = I ω; their formulas are rational, and so valid in any field.

use crate::attitude::Quaternion;
use crate::scalar::{Field, Real};
use nalgebra::{Matrix3, Vector3};

/// Mass and inertia of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties<T> {
    /// Mass, kg.
    pub mass: T,
    /// Inertia tensor about the mass centre, kg·m²; `None` for a point mass. Its components are in the frame in which
    /// the model declares the inertia, or in the body frame for a reference law.
    pub inertia: Option<Matrix3<T>>,
}

/// Physical state of a body: position, velocity, attitude and angular velocity. All vectors are in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Physical<T> {
    /// Position of the mass centre in inertial components, m.
    pub position: Vector3<T>,
    /// Velocity of the mass centre in inertial components, m/s.
    pub velocity: Vector3<T>,
    /// Attitude of the body frame relative to the inertial frame.
    pub attitude: Quaternion<T>,
    /// Angular velocity of the body in inertial components, rad/s.
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

/// Force at the mass centre, N, and moment about it, N·m, in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load<T> {
    /// Sum of the forces in inertial components, N.
    pub force: Vector3<T>,
    /// Sum of the moments about the mass centre, in inertial components, N·m.
    pub moment: Vector3<T>,
}

/// Forces and moments on a body, and the accelerations of the body; all vectors are in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<T> {
    /// Sum of the forces on the body in inertial components, N.
    pub force: Vector3<T>,
    /// Sum of the moments on the body about its mass centre, in inertial components, N·m.
    pub moment: Vector3<T>,
    /// Acceleration of the mass centre in inertial components, m/s².
    pub acceleration: Vector3<T>,
    /// Angular acceleration of the body in inertial components, rad/s².
    pub angular_acceleration: Vector3<T>,
}

impl<T: Real> Motion<T> {
    /// Forces, moments and accelerations of a body at `at` under `load`; the inertia is given in the body frame.
    pub fn under(load: Load<T>, properties: &MassProperties<T>, at: &Physical<T>) -> Self {
        let Load { force, moment } = load;
        let omega = at.angular_velocity;
        let angular_acceleration = properties.inertia.map_or_else(Vector3::zeros, |inertia| {
            let inertia = inertia_in_n(&at.attitude.matrix(), &inertia);
            angular_acceleration(&inertia, &omega, &omega, &moment)
        });
        Self {
            force,
            moment,
            acceleration: force / properties.mass,
            angular_acceleration,
        }
    }
}

/// Solves the linear system `a` x = `b` by Cramer's rule.
pub fn solve<T: Field>(a: &Matrix3<T>, b: &Vector3<T>) -> Vector3<T> {
    let [p, q, r] = [0, 1, 2].map(|i| a.column(i).into_owned());
    let determinant = p.dot(&q.cross(&r));
    Vector3::new(b.dot(&q.cross(&r)), p.dot(&b.cross(&r)), p.dot(&q.cross(b))) / determinant
}

/// Converts an inertia tensor to inertial components from the frame whose axes are the columns of `axes`.
pub fn inertia_in_n<T: Field>(axes: &Matrix3<T>, inertia: &Matrix3<T>) -> Matrix3<T> {
    axes * inertia * axes.transpose()
}

/// Angular acceleration dω/dt of a body under a moment about its mass centre, all in inertial components. The inertia
/// is constant in a frame of angular velocity `frame_rate`: dH/dt = I dω/dt + frame_rate × I ω − I (frame_rate × ω).
pub fn angular_acceleration<T: Field>(
    inertia: &Matrix3<T>,
    frame_rate: &Vector3<T>,
    omega: &Vector3<T>,
    moment: &Vector3<T>,
) -> Vector3<T> {
    let momentum = inertia * omega;
    let transported = inertia * frame_rate.cross(omega);
    solve(
        inertia,
        &(moment - frame_rate.cross(&momentum) + transported),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cramer_solves() {
        let a = Matrix3::new(2.0, 1.0, -1.0, 0.5, 3.0, 0.25, -1.0, 1.0, 4.0);
        let x = Vector3::new(1.0, -2.0, 0.5);
        assert!((solve(&a, &(a * x)) - x).norm() < 1e-15);
    }
}
