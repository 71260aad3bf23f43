// Written by `hyzer generate`; changes belong in the model.
//! `discus`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 31 operations: 4 add, 17 mul, 4 div, 6 neg.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 28]) {
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
    let wind_y = parameters[16];
    let minus_C_Lp_plus_C_Ls = C_Ls - C_Lp;
    let inv_s_stall = T::splat(1.0) / s_stall;
    let inv_m = T::splat(1.0) / m;
    let A_rho = A * rho;
    let half_A_rho = T::splat(0.5) * A_rho;
    let inv_m_half_A_rho = inv_m * half_A_rho;
    let inv_I_d = T::splat(1.0) / I_d;
    let inv_I_d_I_a = I_a * inv_I_d;
    let d_inv_I_d = inv_I_d * d;
    let inv_I_a = T::splat(1.0) / I_a;
    let C_Nr_inv_I_a = C_Nr * inv_I_a;
    let minus_C_Lp_plus_C_Ls_2 = C_Ls - C_Lp;
    let two_inv_I_d_half_rho_A_d = A_rho * d_inv_I_d;
    let two_minus_inv_I_d_I_a = T::splat(2.0) - inv_I_d_I_a;
    let minus_one_plus_inv_I_d_I_a = inv_I_d_I_a - T::splat(1.0);
    let A_half = A * T::splat(0.5);
    let minus_C_Lp_plus_C_Ls_n8 = minus_C_Lp_plus_C_Ls * T::splat(8.0);
    let rho_half = rho * T::splat(0.5);
    let inv_I_d_half_A_rho = inv_I_d * half_A_rho;
    let inv_I_a_d_gammadot_dot_d_r = inv_I_a * C_Nr_inv_I_a;
    let C_Mq_d = d * C_Mq;
    let minus_g = -g;
    let minus_wind_y = -wind_y;
    let minus_rho_half = -rho_half;
    let minus_A_half = -A_half;
    let minus_inv_m_half_A_rho = -inv_m_half_A_rho;
    let minus_inv_I_d_half_A_rho = -inv_I_d_half_A_rho;

    prepared[0] = minus_C_Lp_plus_C_Ls;
    prepared[1] = inv_s_stall;
    prepared[2] = inv_m_half_A_rho;
    prepared[3] = minus_g;
    prepared[4] = inv_I_d_I_a;
    prepared[5] = d_inv_I_d * half_A_rho;
    prepared[6] = C_Nr_inv_I_a;
    prepared[7] = minus_wind_y;
    prepared[8] = C_Ds * T::splat(2.0);
    prepared[9] = inv_s_stall * minus_C_Lp_plus_C_Ls_2 * T::splat(8.0);
    prepared[10] = two_inv_I_d_half_rho_A_d;
    prepared[11] = two_minus_inv_I_d_I_a;
    prepared[12] = minus_one_plus_inv_I_d_I_a;
    prepared[13] = A_half;
    prepared[14] = half_A_rho;
    prepared[15] = inv_m;
    prepared[16] = inv_I_d;
    prepared[17] = d_inv_I_d;
    prepared[18] = inv_I_a;
    prepared[19] = minus_C_Lp_plus_C_Ls_n8;
    prepared[20] = rho_half;
    prepared[21] = minus_rho_half;
    prepared[22] = minus_A_half;
    prepared[23] = minus_inv_m_half_A_rho;
    prepared[24] = inv_I_d_half_A_rho;
    prepared[25] = minus_inv_I_d_half_A_rho;
    prepared[26] = inv_I_a_d_gammadot_dot_d_r;
    prepared[27] = C_Mq_d;
}
