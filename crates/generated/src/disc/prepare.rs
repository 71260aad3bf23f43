// Written by `hyzer generate`; changes belong in the model.
//! `disc`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 32 operations: 21 mul, 3 div, 8 neg.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 26]) {
    let m = parameters[0];
    let I_a = parameters[1];
    let I_d = parameters[2];
    let d = parameters[3];
    let A = parameters[4];
    let rho = parameters[5];
    let g = parameters[6];
    let C_Da = parameters[10];
    let C_Nr = parameters[14];
    let A_rho = A * rho;
    let inv_m = T::splat(1.0) / m;
    let A_rho_inv_m_half = A_rho * (inv_m * T::splat(0.5));
    let half_d = T::splat(0.5) * d;
    let inv_I_d = T::splat(1.0) / I_d;
    let inv_I_d_A_rho = inv_I_d * A_rho;
    let inv_I_d_I_a = inv_I_d * I_a;
    let inv_I_a = T::splat(1.0) / I_a;
    let C_Nr_inv_I_a = C_Nr * inv_I_a;
    let two_d_half_rho_A_inv_I_d = d * inv_I_d_A_rho;
    let A_half = A * T::splat(0.5);
    let rho_half = rho * T::splat(0.5);
    let inv_I_d_sq = inv_I_d * inv_I_d;
    let half_inv_I_d_A_rho = T::splat(0.5) * inv_I_d_A_rho;
    let inv_I_d_half_d = inv_I_d * half_d;
    let rho_inv_I_d_half_d = rho * inv_I_d_half_d;
    let A_inv_I_d_half_d = A * inv_I_d_half_d;
    let inv_I_a_d_gammadot_dot_d_r = inv_I_a * C_Nr_inv_I_a;
    let minus_g = -g;
    let minus_rho_half = -rho_half;
    let minus_A_half = -A_half;
    let minus_A_rho_inv_m_half = -A_rho_inv_m_half;
    let minus_inv_I_d_A_rho_inv_I_d_half_d = -(inv_I_d_A_rho * inv_I_d_half_d);
    let minus_half_inv_I_d_A_rho = -half_inv_I_d_A_rho;
    let minus_rho_inv_I_d_half_d = -rho_inv_I_d_half_d;
    let minus_A_inv_I_d_half_d = -A_inv_I_d_half_d;

    prepared[0] = A_rho_inv_m_half;
    prepared[1] = minus_g;
    prepared[2] = half_d * inv_I_d_A_rho;
    prepared[3] = inv_I_d_I_a;
    prepared[4] = C_Nr_inv_I_a;
    prepared[5] = C_Da * T::splat(2.0);
    prepared[6] = two_d_half_rho_A_inv_I_d;
    prepared[7] = A_half;
    prepared[8] = T::splat(0.5) * A_rho;
    prepared[9] = inv_m;
    prepared[10] = inv_I_d;
    prepared[11] = inv_I_a;
    prepared[12] = rho_half;
    prepared[13] = minus_rho_half;
    prepared[14] = minus_A_half;
    prepared[15] = minus_A_rho_inv_m_half;
    prepared[16] = A_rho * half_d;
    prepared[17] = inv_I_d_sq;
    prepared[18] = half_inv_I_d_A_rho;
    prepared[19] = rho_inv_I_d_half_d;
    prepared[20] = A_inv_I_d_half_d;
    prepared[21] = minus_inv_I_d_A_rho_inv_I_d_half_d;
    prepared[22] = inv_I_a_d_gammadot_dot_d_r;
    prepared[23] = minus_half_inv_I_d_A_rho;
    prepared[24] = minus_rho_inv_I_d_half_d;
    prepared[25] = minus_A_inv_I_d_half_d;
}
