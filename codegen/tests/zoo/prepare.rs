// Written by `hyzer generate`; changes belong in the model.
//! `zoo`: the constants of a flight.

use lanes::Real;
use std::f64::consts::PI;

/// What depends on the parameters alone, once per flight.
///
/// 14 operations: 10 mul, 1 div, 3 neg.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 3], prepared: &mut [T; 13]) {
    let tau = parameters[1];
    let inv_tau = T::splat(1.0) / tau;
    prepared[0] = inv_tau;
    let c = parameters[2];
    let c_sq = c * c;
    prepared[1] = c_sq;
    prepared[3] = T::splat(PI) * T::splat(0.5);
    let inv_tau_sq = inv_tau * inv_tau;
    prepared[11] = inv_tau_sq;
    prepared[5] = inv_tau * T::splat(2.0);
    let k = parameters[0];
    let k_inv_tau = inv_tau * k;
    prepared[6] = k_inv_tau;
    prepared[7] = inv_tau * T::splat(0.3333333333333333);
    prepared[8] = inv_tau * T::splat(0.5);
    prepared[9] = inv_tau * T::splat(1.5);
    prepared[10] = inv_tau * T::splat(0.05555555555555555);
    let minus_inv_tau = -inv_tau;
    prepared[2] = minus_inv_tau;
    let minus_inv_tau_c = -(inv_tau * c);
    prepared[4] = minus_inv_tau_c;
    let minus_inv_tau_sq = -inv_tau_sq;
    prepared[12] = minus_inv_tau_sq;
}
