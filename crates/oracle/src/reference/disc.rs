//! Disc of Hubbard and Hummel (2000), with the sign conventions of this project's model contract.

use super::spinning::{Body, Coefficients, Stream};
use crate::physical::{Load, MassProperties, Physical};
use crate::scalar::Real;
use nalgebra::Vector3;

pub(super) const CONSTANTS: [&str; 15] = [
    "m", "I_a", "I_d", "d", "A", "rho", "g", "C_L0", "C_La", "C_D0", "C_Da", "C_Ma", "C_Mq",
    "C_Rr", "C_Nr",
];

#[allow(non_snake_case)]
pub(super) fn load<T: Real>(constants: &[T], at: &Physical<T>, wind: Vector3<T>) -> Load<T> {
    let [C_L0, C_La, C_D0, C_Da, C_Ma, C_Mq, C_Rr, C_Nr] = constants[7..] else {
        unreachable!("bound to {CONSTANTS:?}")
    };
    let stream = Stream::new(at, wind);
    // Angle of attack, from the plane of the disc to the velocity, positive if the air comes from below.
    let alpha = (-stream.axial_velocity).atan2(stream.in_plane);
    let coefficients = Coefficients {
        lift: C_L0 + C_La * alpha,
        drag: C_D0 + C_Da * alpha * alpha,
        roll: C_Rr * stream.spin,
        pitch: C_Ma * alpha,
        damping: C_Mq,
        spin_down: C_Nr,
    };
    body(constants).load(&stream, &coefficients)
}

pub(super) fn mass_properties<T: Real>(constants: &[T]) -> MassProperties<T> {
    body(constants).mass_properties()
}

/// Mass, inertia, dimensions and environment of a disc or discus, from the first seven of its `constants`, which are
/// the same for the laws [`Law::Disc`](super::Law::Disc) and [`Law::Discus`](super::Law::Discus).
pub(super) fn body<T: Real>(constants: &[T]) -> Body<T> {
    let &[mass, axial, diametral, diameter, area, density, gravity, ..] = constants else {
        unreachable!("bound to names that begin with {:?}", &CONSTANTS[..7])
    };
    Body {
        mass,
        axial,
        diametral,
        diameter,
        area,
        density,
        gravity,
    }
}
