// Written by `hyzer generate`; changes belong in the model.
//! `disc`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 22 operations: 13 mul, 3 div, 6 neg.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 21]) {
    let m = parameters[0];
    let I_a = parameters[1];
    let I_d = parameters[2];
    let d = parameters[3];
    let A = parameters[4];
    let rho = parameters[5];
    let g = parameters[6];
    let C_Da = parameters[10];
    let C_Nr = parameters[14];
    let wind_y = parameters[16];
    let inv_m = T::splat(1.0) / m;
    let A_rho = A * rho;
    let half_A_rho = T::splat(0.5) * A_rho;
    let inv_m_half_A_rho = inv_m * half_A_rho;
    let inv_I_d = T::splat(1.0) / I_d;
    let inv_I_d_d = d * inv_I_d;
    let inv_I_d_I_a = inv_I_d * I_a;
    let inv_I_a = T::splat(1.0) / I_a;
    let C_Nr_inv_I_a = C_Nr * inv_I_a;
    let two_d_half_rho_A_inv_I_d = A_rho * inv_I_d_d;
    let A_half = A * T::splat(0.5);
    let rho_half = rho * T::splat(0.5);
    let inv_I_d_half_A_rho = inv_I_d * half_A_rho;
    let inv_I_a_d_gammadot_dot_d_r = inv_I_a * C_Nr_inv_I_a;
    let minus_g = -g;
    let minus_wind_y = -wind_y;
    let minus_rho_half = -rho_half;
    let minus_A_half = -A_half;
    let minus_inv_m_half_A_rho = -inv_m_half_A_rho;
    let minus_inv_I_d_half_A_rho = -inv_I_d_half_A_rho;

    prepared[0] = inv_m_half_A_rho;
    prepared[1] = minus_g;
    prepared[2] = inv_I_d_d * half_A_rho;
    prepared[3] = inv_I_d_I_a;
    prepared[4] = C_Nr_inv_I_a;
    prepared[5] = minus_wind_y;
    prepared[6] = C_Da * T::splat(2.0);
    prepared[7] = two_d_half_rho_A_inv_I_d;
    prepared[8] = A_half;
    prepared[9] = half_A_rho;
    prepared[10] = inv_m;
    prepared[11] = inv_I_d;
    prepared[12] = inv_I_d_d;
    prepared[13] = inv_I_a;
    prepared[14] = rho_half;
    prepared[15] = minus_rho_half;
    prepared[16] = minus_A_half;
    prepared[17] = minus_inv_m_half_A_rho;
    prepared[18] = inv_I_d_half_A_rho;
    prepared[19] = minus_inv_I_d_half_A_rho;
    prepared[20] = inv_I_a_d_gammadot_dot_d_r;
}
