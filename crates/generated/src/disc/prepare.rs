// Written by `hyzer generate`; changes belong in the model.
//! `disc`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 23 operations: 14 mul, 3 div, 6 neg.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 22]) {
    let I_d = parameters[2];
    let inv_I_d = T::splat(1.0) / I_d;
    prepared[9] = inv_I_d;
    let I_a = parameters[1];
    let inv_I_a = T::splat(1.0) / I_a;
    prepared[10] = inv_I_a;
    let m = parameters[0];
    let inv_m = T::splat(1.0) / m;
    prepared[8] = inv_m;
    let A = parameters[4];
    let rho = parameters[5];
    let A_rho = A * rho;
    let A_half = A * T::splat(0.5);
    prepared[11] = A_half;
    let rho_half = rho * T::splat(0.5);
    prepared[14] = rho_half;
    let C_Da = parameters[10];
    prepared[6] = C_Da * T::splat(2.0);
    let d = parameters[3];
    prepared[21] = T::splat(0.5) * d;
    let g = parameters[6];
    let minus_g = -g;
    prepared[1] = minus_g;
    let wind_y = parameters[16];
    let minus_wind_y = -wind_y;
    prepared[5] = minus_wind_y;
    let half_A_rho = T::splat(0.5) * A_rho;
    prepared[12] = half_A_rho;
    let minus_A_half = -A_half;
    prepared[16] = minus_A_half;
    let minus_rho_half = -rho_half;
    prepared[15] = minus_rho_half;
    let inv_I_d_d = d * inv_I_d;
    prepared[13] = inv_I_d_d;
    let C_Nr = parameters[14];
    let C_Nr_inv_I_a = C_Nr * inv_I_a;
    prepared[4] = C_Nr_inv_I_a;
    let inv_m_half_A_rho = inv_m * half_A_rho;
    prepared[0] = inv_m_half_A_rho;
    let inv_I_d_half_A_rho = inv_I_d * half_A_rho;
    prepared[18] = inv_I_d_half_A_rho;
    let inv_I_d_I_a = inv_I_d * I_a;
    prepared[3] = inv_I_d_I_a;
    let inv_I_a_d_gammadot_dot_d_r = inv_I_a * C_Nr_inv_I_a;
    prepared[20] = inv_I_a_d_gammadot_dot_d_r;
    prepared[2] = inv_I_d_d * half_A_rho;
    let two_d_half_rho_A_inv_I_d = A_rho * inv_I_d_d;
    prepared[7] = two_d_half_rho_A_inv_I_d;
    let minus_inv_m_half_A_rho = -inv_m_half_A_rho;
    prepared[17] = minus_inv_m_half_A_rho;
    let minus_inv_I_d_half_A_rho = -inv_I_d_half_A_rho;
    prepared[19] = minus_inv_I_d_half_A_rho;
}
