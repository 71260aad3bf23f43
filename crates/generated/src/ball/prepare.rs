// Written by `hyzer generate`; changes belong in the model.
//! `ball`: the constants of a flight.

use lanes::Real;
use std::f64::consts::PI;

/// What depends on the parameters alone, once per flight.
///
/// 13 operations: 12 mul, 1 div.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 11], prepared: &mut [T; 8]) {
    let m = parameters[0];
    let inv_m = T::splat(1.0) / m;
    let radius = parameters[1];
    let radius_pi = radius * T::splat(PI);
    let radius_half = radius * T::splat(0.5);
    prepared[1] = radius_half;
    let rho = parameters[2];
    let rho_radius_pi = rho * radius_pi;
    let A = radius * radius_pi;
    prepared[6] = A;
    let radius_half_rho_radius_pi = radius_half * rho_radius_pi;
    let C_D = parameters[4];
    prepared[7] = C_D * radius_half_rho_radius_pi;
    let C_D_inv_m = C_D * inv_m;
    prepared[4] = inv_m * radius_half;
    let rho_pi_radius_inv_m = inv_m * rho_radius_pi;
    prepared[2] = rho_pi_radius_inv_m;
    prepared[0] = C_D_inv_m * radius_half_rho_radius_pi;
    let C_D_rho_pi_radius_inv_part = rho_radius_pi * C_D_inv_m;
    prepared[3] = C_D_rho_pi_radius_inv_part;
    let C_D_pi_radius_inv_m = radius_pi * C_D_inv_m;
    prepared[5] = C_D_pi_radius_inv_m;
}
