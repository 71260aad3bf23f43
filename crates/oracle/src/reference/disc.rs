//! The disc of Hubbard & Hummel (2000), with the signs of the project's contract.
//!
//! Written with vectors and without the model's formulas: the lift acts along v × d2, the drag against
//! the velocity, and the body answers by its momenta in the inertial frame.

use crate::dynamics::MassProperties;
use crate::physical::{Motion, Physical};
use crate::rigid::{angular_acceleration, inertia_in_n};
use crate::scalar::Real;
use crate::tree::norm;
use nalgebra::{Matrix3, Vector3};

pub(super) const CONSTANTS: [&str; 15] = [
    "m", "I_a", "I_d", "d", "A", "rho", "g", "C_L0", "C_La", "C_D0", "C_Da", "C_Ma", "C_Mq",
    "C_Rr", "C_Nr",
];

#[allow(non_snake_case)]
pub(super) fn motion<T: Real>(constants: &[T], body: &Physical<T>, wind: Vector3<T>) -> Motion<T> {
    let &[
        m,
        I_a,
        I_d,
        d,
        A,
        rho,
        g,
        C_L0,
        C_La,
        C_D0,
        C_Da,
        C_Ma,
        C_Mq,
        C_Rr,
        C_Nr,
    ] = constants
    else {
        unreachable!("bound to {CONSTANTS:?}")
    };
    let normal = body.attitude.axis(3);
    let through_air = body.velocity - wind;
    let climb = through_air.dot(&normal);
    let in_plane = through_air - normal * climb;
    let (speed, in_plane_speed) = (norm(&through_air), norm(&in_plane));
    let d1 = if in_plane_speed.re() == 0.0 {
        Vector3::zeros()
    } else {
        in_plane / in_plane_speed
    };
    let d2 = normal.cross(&d1);
    let alpha = (-climb).atan2(in_plane_speed);

    // ρ A / 2, to be multiplied by V for each force along a vector that itself has the length V.
    let half = rho * A / T::lit(2.0);
    let lift = through_air.cross(&d2) * (half * speed * (C_L0 + C_La * alpha));
    let drag = -through_air * (half * speed * (C_D0 + C_Da * alpha * alpha));
    let force = lift + drag + Vector3::new(T::zero(), T::zero(), -m * g);

    let omega = body.angular_velocity;
    let spin = omega.dot(&normal);
    let lever = half * speed * speed * d;
    let in_plane_rates = omega - normal * spin;
    // C_Mq acts on both rates in the plane alike; split along d1 and d2 it is C_Mq times their vector,
    // but only where there is a direction to split along.
    let damped = if in_plane_speed.re() == 0.0 {
        Vector3::zeros()
    } else {
        in_plane_rates
    };
    let moment =
        (d1 * (C_Rr * spin) + d2 * (C_Ma * alpha) + damped * C_Mq) * lever + normal * (C_Nr * spin);

    let inertia = inertia_in_n(&body.attitude.matrix(), &principal(I_a, I_d));
    Motion {
        force,
        moment,
        acceleration: force / m,
        angular_acceleration: angular_acceleration(&inertia, &omega, &omega, &moment),
    }
}

pub(super) fn mass_properties<T: Real>(constants: &[T]) -> MassProperties<T> {
    MassProperties {
        mass: constants[0],
        inertia: Some(principal(constants[1], constants[2])),
    }
}

fn principal<T: Real>(axial: T, diametral: T) -> Matrix3<T> {
    Matrix3::from_diagonal(&Vector3::new(diametral, diametral, axial))
}
