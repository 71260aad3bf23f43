//! A disc's flight by hand, in the paper's angles: something real to fly in tests.
#![allow(dead_code)]

use lanes::Real;
use ode::{OdeRhs, rhs_from_fn};

/// Names of the states of the disc: position, velocity, Euler angles and their rates.
pub const NAMES: [&str; 12] = [
    "x", "y", "z", "u", "v", "w", "phi", "theta", "gamma", "phidot", "thetadot", "gammadot",
];

/// Parameters of the disc in SI units: mass, axial and diametral moments of inertia, diameter, area, air density, and
/// acceleration of gravity.
pub const DISC: [f64; 7] = [0.175, 0.00235, 0.00122, 0.269, 0.057, 1.23, 9.7935];
/// Aerodynamic coefficients of the disc: C_L0, C_La (lift), C_D0, C_Da (drag), C_Ma, C_Mq (pitch), C_Rr (roll by spin),
/// C_Nr (spin-down).
pub const AIR: [f64; 8] = [0.188, 2.37, 0.15, 1.24, -0.2, -0.012, -0.0004, -3.4e-5];
/// Initial state of a fast throw, in the order of [`NAMES`], SI.
pub const THROW: [f64; 12] = [
    -0.9, 0.63, 1.6, 13.1, 0.4, -2.5, -0.07, -0.2, 5.0, -1.0, 1.5, -54.0,
];

/// Writes the time derivative of the twelve states `x` of the disc to `dx`; `disc` contains its parameters, and `air`
/// its aerodynamic coefficients.
#[inline(always)]
pub fn rate<T: Real>(x: &[T; 12], disc: &[T; 7], air: &[T; 8], dx: &mut [T; 12]) {
    let [m, i_a, i_d, d, a, rho, g] = *disc;
    let [c_l0, c_la, c_d0, c_da, c_ma, c_mq, c_rr, c_nr] = *air;
    let [_, _, _, u, v, w, phi, theta, _, fd, td, gd] = *x;
    let ((sf, cf), (st, ct)) = (phi.sin_cos(), theta.sin_cos());
    let (p, q, s) = (fd * ct, td, fd * st);
    let r = s + gd;
    let in_plane = (u * u + v * v).sqrt();
    let turn = in_plane.recip_or_zero();
    let (cb, sb) = (u * turn, v * turn);
    let v2 = u * u + v * v + w * w;
    let over_v = v2.sqrt().recip_or_zero();
    let alpha = (-w).atan2(in_plane);
    let (sa, ca) = (-w * over_v, in_plane * over_v);
    let qa = rho * v2 * a * T::splat(0.5);
    let lift = qa * (c_l0 + c_la * alpha);
    let drag = qa * (c_d0 + c_da * alpha * alpha);
    let (f1, f3) = (lift * sa - drag * ca, lift * ca + drag * sa);
    let (rate_1, rate_2) = (p * cb + q * sb, q * cb - p * sb);
    let roll = qa * d * (c_rr * r + c_mq * rate_1);
    let pitch = qa * d * (c_ma * alpha + c_mq * rate_2);
    let (m1, m2, m3) = (roll * cb - pitch * sb, roll * sb + pitch * cb, c_nr * r);
    // Gravity in B is -g times the third row of the rotation.
    let (g1, g2, g3) = (g * st * cf, -(g * sf), -(g * ct * cf));
    dx[0] = u * ct + w * st;
    dx[1] = u * st * sf + v * cf - w * ct * sf;
    dx[2] = w * ct * cf + v * sf - u * st * cf;
    dx[3] = f1 * cb / m + g1 + s * v - q * w;
    dx[4] = f1 * sb / m + g2 + p * w - s * u;
    dx[5] = f3 / m + g3 + q * u - p * v;
    let pd = (m1 - i_a * q * r + i_d * s * q) / i_d;
    let qd = (m2 - i_d * s * p + i_a * p * r) / i_d;
    let fdd = (pd + fd * td * st) / ct;
    dx[6] = fd;
    dx[7] = td;
    dx[8] = gd;
    dx[9] = fdd;
    dx[10] = qd;
    dx[11] = m3 / i_a - fdd * st - fd * td * ct;
}

/// Right-hand side of a disc with the parameters [`DISC`] and the aerodynamic coefficients [`AIR`].
pub fn disc() -> impl OdeRhs<State = [f64; 12]> {
    rhs_from_fn(&NAMES, |_, x: &[f64; 12], dx: &mut [f64; 12]| {
        rate(x, &DISC, &AIR, dx);
    })
}
