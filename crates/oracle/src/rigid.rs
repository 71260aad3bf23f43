//! Newton's and Euler's laws in inertial components: dp/dt = F and dH/dt = M, with p = m v and H = I ω.
//!
//! Rational in everything, so that it holds in any field.

use crate::scalar::Field;
use nalgebra::{Matrix3, Vector3};

/// The solution of a x = b by Cramer's rule.
pub fn solve<T: Field>(a: &Matrix3<T>, b: &Vector3<T>) -> Vector3<T> {
    let [p, q, r] = [0, 1, 2].map(|i| a.column(i).into_owned());
    let determinant = p.dot(&q.cross(&r));
    Vector3::new(b.dot(&q.cross(&r)), p.dot(&b.cross(&r)), p.dot(&q.cross(b))) / determinant
}

/// The inertia in inertial components of a body whose principal frame has these axes.
pub fn inertia_in_n<T: Field>(axes: &Matrix3<T>, inertia: &Matrix3<T>) -> Matrix3<T> {
    axes * inertia * axes.transpose()
}

/// The angular acceleration that a moment gives, the inertia being constant in a frame that turns at
/// `carried`: dH/dt = I dω/dt + carried × I ω − I (carried × ω).
pub fn angular_acceleration<T: Field>(
    inertia: &Matrix3<T>,
    carried: &Vector3<T>,
    omega: &Vector3<T>,
    moment: &Vector3<T>,
) -> Vector3<T> {
    let momentum = inertia * omega;
    let turned = inertia * carried.cross(omega);
    solve(inertia, &(moment - carried.cross(&momentum) + turned))
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
