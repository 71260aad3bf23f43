//! Ball as a point mass with weight and drag.

use crate::physical::{Load, MassProperties, Physical};
use crate::scalar::Real;
use crate::tree::norm;
use nalgebra::Vector3;

pub(super) const CONSTANTS: [&str; 5] = ["m", "radius", "rho", "g", "C_D"];

pub(super) fn load<T: Real>(constants: &[T], body: &Physical<T>, wind: Vector3<T>) -> Load<T> {
    let &[m, radius, rho, g, drag] = constants else {
        unreachable!("bound to {CONSTANTS:?}")
    };
    let through_air = body.velocity - wind;
    // D = ρ V² A C_D / 2 against the velocity, so the force is −(D / V) v = −ρ A C_D V v / 2.
    let area = T::lit(std::f64::consts::PI) * radius * radius;
    let force = -through_air * (rho * area * drag * norm(&through_air) / T::lit(2.0));
    let force = force + Vector3::new(T::zero(), T::zero(), -m * g);
    Load {
        force,
        moment: Vector3::zeros(),
    }
}

pub(super) fn mass_properties<T: Real>(constants: &[T]) -> MassProperties<T> {
    MassProperties {
        mass: constants[0],
        inertia: None,
    }
}
