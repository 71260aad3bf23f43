//! Symmetric discus of Frohlich (1981): lift and pitching moment with sin 2α, stall, drag with sin² α. The angle of
//! attack α is not computed: sin α and cos α are ratios of velocities.

use super::disc::body;
use super::spinning::{Coefficients, Stream};
use crate::physical::{Load, Physical};
use crate::scalar::Real;
use nalgebra::Vector3;

pub(super) const CONSTANTS: [&str; 15] = [
    "m", "I_a", "I_d", "d", "A", "rho", "g", "C_Ls", "C_Lp", "s_stall", "C_D0", "C_Ds", "C_Ms",
    "C_Mq", "C_Nr",
];

#[allow(non_snake_case)]
pub(super) fn load<T: Real>(constants: &[T], at: &Physical<T>, wind: Vector3<T>) -> Load<T> {
    let [C_Ls, C_Lp, s_stall, C_D0, C_Ds, C_Ms, C_Mq, C_Nr] = constants[7..] else {
        unreachable!("bound to {CONSTANTS:?}")
    };
    let stream = Stream::new(at, wind);
    let still = stream.speed.re() == 0.0;
    let [sine, cosine] = [-stream.axial_velocity, stream.in_plane]
        .map(|v| if still { T::zero() } else { v / stream.speed });
    let twice = T::lit(2.0) * sine * cosine;
    // 1 for attached flow, 0 for stalled flow.
    let attached = T::one() / (T::one() + (sine / s_stall).powi(8));
    let coefficients = Coefficients {
        lift: (C_Ls * attached + C_Lp * (T::one() - attached)) * twice,
        drag: C_D0 + C_Ds * sine * sine,
        roll: T::zero(),
        pitch: C_Ms * twice,
        damping: C_Mq,
        spin_down: C_Nr,
    };
    body(constants).load(&stream, &coefficients)
}
