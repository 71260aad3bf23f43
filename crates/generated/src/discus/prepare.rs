// Written by `hyzer generate`; changes belong in the model.
//! `discus`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 29 operations: 4 add, 20 mul, 4 div, 1 neg.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 22]) {
    let m = parameters[0];
    let I_a = parameters[1];
    let I_d = parameters[2];
    let d = parameters[3];
    let A = parameters[4];
    let rho = parameters[5];
    let C_Ls = parameters[7];
    let C_Lp = parameters[8];
    let s_stall = parameters[9];
    let C_Ds = parameters[11];
    let C_Mq = parameters[13];
    let C_Nr = parameters[14];
    let inv_m = T::splat(1.0) / m;
    let A_rho = A * rho;
    let inv_m_A_rho = inv_m * A_rho;
    let minus_p8_plus_p7 = C_Ls - C_Lp;
    let inv_s_stall = T::splat(1.0) / s_stall;
    let inv_I_d = T::splat(1.0) / I_d;
    let inv_p2_p1 = inv_I_d * I_a;
    let inv_I_a = T::splat(1.0) / I_a;
    let p14_inv_p1 = C_Nr * inv_I_a;
    let minus_two_plus_p1_inv_p2 = inv_p2_p1 - T::splat(2.0);
    let minus_n1_plus_p1_inv_p2 = inv_p2_p1 - T::splat(1.0);
    let p7_minus_p8_n4 = minus_p8_plus_p7 * T::splat(4.0);
    let p7_minus_p8_n8 = minus_p8_plus_p7 * T::splat(8.0);
    let inv_p2_sq = inv_I_d * inv_I_d;
    let inv_p1_d_gammadot_dot_d_r = inv_I_a * p14_inv_p1;
    let p13_p3 = d * C_Mq;
    let minus_inv_s_stall_minus_C_product = -(inv_s_stall * (C_Lp - C_Ls) * T::splat(8.0));

    prepared[0] = T::splat(0.5) * inv_m_A_rho;
    prepared[1] = minus_p8_plus_p7;
    prepared[2] = inv_s_stall;
    prepared[3] = T::splat(0.5) * d * (inv_I_d * A_rho);
    prepared[4] = inv_p2_p1;
    prepared[5] = p14_inv_p1;
    prepared[6] = C_Ds * T::splat(2.0);
    prepared[7] = minus_inv_s_stall_minus_C_product;
    prepared[8] = minus_two_plus_p1_inv_p2;
    prepared[9] = minus_n1_plus_p1_inv_p2;
    prepared[10] = A * T::splat(0.5);
    prepared[11] = T::splat(0.5) * A_rho;
    prepared[12] = inv_m;
    prepared[13] = inv_I_d;
    prepared[14] = inv_I_a;
    prepared[15] = T::splat(0.25) * inv_m_A_rho;
    prepared[16] = p7_minus_p8_n4;
    prepared[17] = p7_minus_p8_n8;
    prepared[18] = rho * T::splat(0.5);
    prepared[19] = inv_p2_sq;
    prepared[20] = inv_p1_d_gammadot_dot_d_r;
    prepared[21] = p13_p3;
}
