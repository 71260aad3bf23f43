//! Newton's and Euler's laws in inertial components: dp/dt = F and dH/dt = M, with p = m v and H = I ω.
//!
//! All formulas are rational, and therefore valid in any field.

use crate::scalar::Field;
use nalgebra::{Matrix3, Vector3};

/// Solves the linear system `a` x = `b` by Cramer's rule.
pub fn solve<T: Field>(a: &Matrix3<T>, b: &Vector3<T>) -> Vector3<T> {
    let [p, q, r] = [0, 1, 2].map(|i| a.column(i).into_owned());
    let determinant = p.dot(&q.cross(&r));
    Vector3::new(b.dot(&q.cross(&r)), p.dot(&b.cross(&r)), p.dot(&q.cross(b))) / determinant
}

/// Converts an inertia tensor to inertial components. The columns of `axes` are the axes of the frame in which
/// `inertia` is given.
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
