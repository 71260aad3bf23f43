// Written by `hyzer generate`; changes belong in the model.
//! `discus`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 42 operations: 3 add, 26 mul, 4 div, 9 neg.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 33]) {
    let m = parameters[0];
    let I_a = parameters[1];
    let I_d = parameters[2];
    let d = parameters[3];
    let A = parameters[4];
    let rho = parameters[5];
    let g = parameters[6];
    let C_Ls = parameters[7];
    let C_Lp = parameters[8];
    let s_stall = parameters[9];
    let C_Ds = parameters[11];
    let C_Mq = parameters[13];
    let C_Nr = parameters[14];
    let minus_C_Lp_plus_C_Ls = C_Ls - C_Lp;
    let inv_s_stall = T::splat(1.0) / s_stall;
    let A_rho = A * rho;
    let inv_m = T::splat(1.0) / m;
    let A_rho_inv_m_half = A_rho * (inv_m * T::splat(0.5));
    let inv_I_d = T::splat(1.0) / I_d;
    let inv_I_d_I_a = I_a * inv_I_d;
    let half_inv_I_d = T::splat(0.5) * inv_I_d;
    let d_A_rho = d * A_rho;
    let inv_I_a = T::splat(1.0) / I_a;
    let C_Nr_inv_I_a = C_Nr * inv_I_a;
    let minus_C_Lp_plus_C_Ls_2 = C_Ls - C_Lp;
    let two_inv_I_d_half_rho_A_d = inv_I_d * d_A_rho;
    let minus_one_plus_inv_I_d_I_a = inv_I_d_I_a - T::splat(1.0);
    let A_half = A * T::splat(0.5);
    let minus_C_Lp_plus_C_Ls_n8 = minus_C_Lp_plus_C_Ls * T::splat(8.0);
    let rho_half = rho * T::splat(0.5);
    let inv_I_d_sq = inv_I_d * inv_I_d;
    let A_rho_half_inv_I_d = A_rho * half_inv_I_d;
    let d_half_inv_I_d = d * half_inv_I_d;
    let rho_d_half_inv_I_d = rho * d_half_inv_I_d;
    let A_d_half_inv_I_d = A * d_half_inv_I_d;
    let inv_I_a_d_gammadot_dot_d_r = inv_I_a * C_Nr_inv_I_a;
    let C_Mq_d = d * C_Mq;
    let minus_g = -g;
    let minus_two_inv_I_d_half_rho_A_d = -two_inv_I_d_half_rho_A_d;
    let minus_rho_half = -rho_half;
    let minus_A_half = -A_half;
    let minus_A_rho_inv_m_half = -A_rho_inv_m_half;
    let minus_d_A_rho_inv_I_d_half_inv_I_d = -(d_A_rho * (inv_I_d * half_inv_I_d));
    let minus_A_rho_half_inv_I_d = -A_rho_half_inv_I_d;
    let minus_rho_d_half_inv_I_d = -rho_d_half_inv_I_d;
    let minus_A_d_half_inv_I_d = -A_d_half_inv_I_d;

    prepared[0] = minus_C_Lp_plus_C_Ls;
    prepared[1] = inv_s_stall;
    prepared[2] = A_rho_inv_m_half;
    prepared[3] = minus_g;
    prepared[4] = inv_I_d_I_a;
    prepared[5] = half_inv_I_d * d_A_rho;
    prepared[6] = C_Nr_inv_I_a;
    prepared[7] = C_Ds * T::splat(2.0);
    prepared[8] = inv_s_stall * minus_C_Lp_plus_C_Ls_2 * T::splat(8.0);
    prepared[9] = two_inv_I_d_half_rho_A_d;
    prepared[10] = minus_two_inv_I_d_half_rho_A_d;
    prepared[11] = minus_one_plus_inv_I_d_I_a;
    prepared[12] = A_half;
    prepared[13] = T::splat(0.5) * A_rho;
    prepared[14] = inv_m;
    prepared[15] = inv_I_d;
    prepared[16] = inv_I_a;
    prepared[17] = minus_C_Lp_plus_C_Ls_n8;
    prepared[18] = rho_half;
    prepared[19] = minus_rho_half;
    prepared[20] = minus_A_half;
    prepared[21] = minus_A_rho_inv_m_half;
    prepared[22] = T::splat(0.5) * d_A_rho;
    prepared[23] = inv_I_d_sq;
    prepared[24] = A_rho_half_inv_I_d;
    prepared[25] = rho_d_half_inv_I_d;
    prepared[26] = A_d_half_inv_I_d;
    prepared[27] = minus_d_A_rho_inv_I_d_half_inv_I_d;
    prepared[28] = inv_I_a_d_gammadot_dot_d_r;
    prepared[29] = minus_A_rho_half_inv_I_d;
    prepared[30] = minus_rho_d_half_inv_I_d;
    prepared[31] = minus_A_d_half_inv_I_d;
    prepared[32] = C_Mq_d;
}
