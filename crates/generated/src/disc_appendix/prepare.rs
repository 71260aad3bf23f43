// Written by `hyzer generate`; changes belong in the model.
//! `disc_appendix`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 30 operations: 18 mul, 3 div, 9 neg.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 25]) {
    let m = parameters[0];
    let inv_m = T::splat(1.0) / m;
    prepared[0] = inv_m;
    let I_d = parameters[2];
    let inv_I_d = T::splat(1.0) / I_d;
    prepared[1] = inv_I_d;
    let I_a = parameters[1];
    let inv_I_a = T::splat(1.0) / I_a;
    prepared[2] = inv_I_a;
    let A = parameters[4];
    let rho = parameters[5];
    let A_rho = A * rho;
    let g = parameters[6];
    let g_m = m * g;
    prepared[3] = g_m;
    let C_Da = parameters[10];
    let two_C_Da = T::splat(2.0) * C_Da;
    prepared[8] = two_C_Da;
    let A_half = A * T::splat(0.5);
    prepared[13] = A_half;
    let rho_half = rho * T::splat(0.5);
    prepared[17] = rho_half;
    prepared[5] = I_d * T::splat(2.0);
    prepared[4] = A_rho * T::splat(0.5);
    let d = parameters[3];
    prepared[10] = T::splat(2.0) * d;
    let minus_g_m = -g_m;
    prepared[24] = minus_g_m;
    let wind_y = parameters[16];
    let minus_wind_y = -wind_y;
    prepared[6] = minus_wind_y;
    let minus_two_C_Da = -two_C_Da;
    prepared[14] = minus_two_C_Da;
    let minus_A_half = -A_half;
    prepared[19] = minus_A_half;
    let minus_rho_half = -rho_half;
    prepared[18] = minus_rho_half;
    let inv_m_A_rho = inv_m * A_rho;
    let minus_inv_I_d_2 = -inv_I_d;
    let C_Nr = parameters[14];
    let d_gammadot_dot_d_angular_velocity_3 = inv_I_a * C_Nr;
    prepared[12] = d_gammadot_dot_d_angular_velocity_3;
    prepared[22] = minus_inv_I_d_2 * inv_I_d;
    let inv_I_a_sq = inv_I_a * inv_I_a;
    prepared[23] = inv_I_a_sq;
    let inv_m_sq = inv_m * inv_m;
    prepared[21] = inv_m_sq;
    let minus_inv_m = -inv_m;
    prepared[7] = minus_inv_m;
    let C_La = parameters[8];
    prepared[15] = inv_m_A_rho * (T::splat(0.5) * C_La);
    prepared[9] = T::splat(0.5) * inv_m_A_rho;
    let C_Da_two_half_rho_A_inv_m = C_Da * inv_m_A_rho;
    prepared[16] = C_Da_two_half_rho_A_inv_m;
    let minus_inv_I_d = -inv_I_d;
    prepared[11] = minus_inv_I_d;
    let minus_inv_m_g = -(inv_m * g);
    prepared[20] = minus_inv_m_g;
}
