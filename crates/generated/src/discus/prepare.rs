// Written by `hyzer generate`; changes belong in the model.
//! `discus`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 32 operations: 4 add, 18 mul, 4 div, 6 neg.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 29]) {
    let s_stall = parameters[9];
    let inv_s_stall = T::splat(1.0) / s_stall;
    prepared[0] = inv_s_stall;
    let I_d = parameters[2];
    let inv_I_d = T::splat(1.0) / I_d;
    prepared[14] = inv_I_d;
    let I_a = parameters[1];
    let inv_I_a = T::splat(1.0) / I_a;
    prepared[15] = inv_I_a;
    let m = parameters[0];
    let inv_m = T::splat(1.0) / m;
    prepared[13] = inv_m;
    let A = parameters[4];
    let rho = parameters[5];
    let A_rho = A * rho;
    let C_Ls = parameters[7];
    let C_Lp = parameters[8];
    let minus_C_Lp_plus_C_Ls_2 = C_Ls - C_Lp;
    let minus_C_Lp_plus_C_Ls = C_Ls - C_Lp;
    prepared[1] = minus_C_Lp_plus_C_Ls;
    let A_half = A * T::splat(0.5);
    prepared[16] = A_half;
    let rho_half = rho * T::splat(0.5);
    prepared[20] = rho_half;
    let C_Ds = parameters[11];
    prepared[8] = C_Ds * T::splat(2.0);
    let d = parameters[3];
    prepared[27] = T::splat(0.5) * d;
    let C_Mq = parameters[13];
    let d_C_Mq = d * C_Mq;
    prepared[28] = d_C_Mq;
    let half_A_rho = T::splat(0.5) * A_rho;
    prepared[17] = half_A_rho;
    let g = parameters[6];
    let minus_g = -g;
    prepared[3] = minus_g;
    let minus_C_Lp_plus_C_Ls_n8 = minus_C_Lp_plus_C_Ls * T::splat(8.0);
    prepared[19] = minus_C_Lp_plus_C_Ls_n8;
    let minus_A_half = -A_half;
    prepared[22] = minus_A_half;
    let minus_rho_half = -rho_half;
    prepared[21] = minus_rho_half;
    let wind_y = parameters[16];
    let minus_wind_y = -wind_y;
    prepared[7] = minus_wind_y;
    let inv_I_d_I_a = I_a * inv_I_d;
    prepared[4] = inv_I_d_I_a;
    let d_inv_I_d = inv_I_d * d;
    prepared[18] = d_inv_I_d;
    let C_Nr = parameters[14];
    let C_Nr_inv_I_a = C_Nr * inv_I_a;
    prepared[6] = C_Nr_inv_I_a;
    let inv_m_half_A_rho = inv_m * half_A_rho;
    prepared[2] = inv_m_half_A_rho;
    let inv_I_d_half_A_rho = inv_I_d * half_A_rho;
    prepared[24] = inv_I_d_half_A_rho;
    prepared[9] = inv_s_stall * minus_C_Lp_plus_C_Ls_2 * T::splat(8.0);
    let two_minus_inv_I_d_I_a = T::splat(2.0) - inv_I_d_I_a;
    prepared[11] = two_minus_inv_I_d_I_a;
    let inv_I_a_d_gammadot_dot_d_r = inv_I_a * C_Nr_inv_I_a;
    prepared[26] = inv_I_a_d_gammadot_dot_d_r;
    prepared[5] = d_inv_I_d * half_A_rho;
    let two_inv_I_d_half_rho_A_d = A_rho * d_inv_I_d;
    prepared[10] = two_inv_I_d_half_rho_A_d;
    let minus_one_plus_inv_I_d_I_a = inv_I_d_I_a - T::splat(1.0);
    prepared[12] = minus_one_plus_inv_I_d_I_a;
    let minus_inv_m_half_A_rho = -inv_m_half_A_rho;
    prepared[23] = minus_inv_m_half_A_rho;
    let minus_inv_I_d_half_A_rho = -inv_I_d_half_A_rho;
    prepared[25] = minus_inv_I_d_half_A_rho;
}
