// Written by `hyzer generate`; changes belong in the model.
//! `disc_appendix`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 30 operations: 2 add, 17 mul, 3 div, 8 neg.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 28]) {
    let m = parameters[0];
    let I_a = parameters[1];
    let I_d = parameters[2];
    let d = parameters[3];
    let A = parameters[4];
    let rho = parameters[5];
    let g = parameters[6];
    let C_Da = parameters[10];
    let C_Rr = parameters[13];
    let C_Nr = parameters[14];
    let g_m = m * g;
    let A_rho_half = A * rho * T::splat(0.5);
    let inv_m = T::splat(1.0) / m;
    let inv_I_d = T::splat(1.0) / I_d;
    let inv_I_a = T::splat(1.0) / I_a;
    let inv_m_A_rho_half = inv_m * A_rho_half;
    let I_a_inv_I_d = inv_I_d * I_a;
    let minus_two_plus_I_a_inv_I_d = I_a_inv_I_d - T::splat(2.0);
    let minus_one_plus_I_a_inv_I_d = I_a_inv_I_d - T::splat(1.0);
    let C_Rr_inv_I_d = inv_I_d * C_Rr;
    let d_gammadot_dot_d_angular_velocity_3 = inv_I_a * C_Nr;
    let A_half = A * T::splat(0.5);
    let g_inv_m = g * inv_m;
    let inv_m_sq = inv_m * inv_m;
    let rho_half = rho * T::splat(0.5);
    let minus_inv_I_d = -inv_I_d;
    let inv_I_a_sq = inv_I_a * inv_I_a;
    let minus_inv_m = -inv_m;
    let minus_inv_m_A_rho_half = -inv_m_A_rho_half;
    let minus_inv_I_d_2 = -inv_I_d;
    let minus_rho_half = -rho_half;
    let minus_A_half = -A_half;
    let minus_g_inv_m = -g_inv_m;
    let minus_g_m = -g_m;

    prepared[0] = g_m;
    prepared[1] = A_rho_half;
    prepared[2] = inv_m;
    prepared[3] = I_d * T::splat(2.0);
    prepared[4] = inv_I_d;
    prepared[5] = inv_I_a;
    prepared[6] = T::splat(2.0) * C_Da;
    prepared[7] = minus_inv_m;
    prepared[8] = inv_m_A_rho_half;
    prepared[9] = minus_inv_m_A_rho_half;
    prepared[10] = T::splat(2.0) * d;
    prepared[11] = d * A_rho_half;
    prepared[12] = I_a_inv_I_d;
    prepared[13] = minus_two_plus_I_a_inv_I_d;
    prepared[14] = minus_inv_I_d_2;
    prepared[15] = minus_one_plus_I_a_inv_I_d;
    prepared[16] = C_Rr_inv_I_d;
    prepared[17] = d_gammadot_dot_d_angular_velocity_3;
    prepared[18] = A_half;
    prepared[19] = g_inv_m;
    prepared[20] = inv_m_sq;
    prepared[21] = rho_half;
    prepared[22] = minus_rho_half;
    prepared[23] = minus_A_half;
    prepared[24] = minus_g_inv_m;
    prepared[25] = minus_inv_I_d * inv_I_d;
    prepared[26] = inv_I_a_sq;
    prepared[27] = minus_g_m;
}
