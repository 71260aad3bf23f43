// Written by `hyzer generate`; changes belong in the model.
//! `disc_quaternion`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 19 operations: 1 add, 13 mul, 3 div, 2 neg.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 18]) {
    let I_d = parameters[2];
    let inv_I_d = T::splat(1.0) / I_d;
    prepared[8] = inv_I_d;
    let I_a = parameters[1];
    let inv_I_a = T::splat(1.0) / I_a;
    prepared[9] = inv_I_a;
    let m = parameters[0];
    let inv_m = T::splat(1.0) / m;
    prepared[7] = inv_m;
    let A = parameters[4];
    let rho = parameters[5];
    let rho_A = A * rho;
    prepared[10] = rho_A;
    let C_Da = parameters[10];
    prepared[5] = C_Da * T::splat(2.0);
    prepared[15] = rho * T::splat(0.5);
    let d = parameters[3];
    prepared[17] = d * T::splat(0.5);
    prepared[16] = T::splat(0.5) * rho_A;
    let inv_I_d_d = d * inv_I_d;
    prepared[12] = inv_I_d_d;
    let C_Nr = parameters[14];
    let C_Nr_inv_I_a = C_Nr * inv_I_a;
    prepared[3] = C_Nr_inv_I_a;
    let I_a_inv_I_d = inv_I_d * I_a;
    prepared[11] = I_a_inv_I_d;
    let inv_m_rho_A = inv_m * rho_A;
    prepared[0] = inv_m_rho_A;
    let d_rho_A_inv_I_d = rho_A * inv_I_d_d;
    prepared[4] = d_rho_A_inv_I_d;
    let one_minus_inv_I_d_I_a = T::splat(1.0) - I_a_inv_I_d;
    prepared[2] = one_minus_inv_I_d_I_a;
    let minus_I_a_inv_I_d = -I_a_inv_I_d;
    prepared[13] = minus_I_a_inv_I_d;
    prepared[1] = T::splat(0.5) * d_rho_A_inv_I_d;
    let C_Mq = parameters[12];
    let C_Mq_d_rho_A_inv_I_d = C_Mq * d_rho_A_inv_I_d;
    prepared[6] = C_Mq_d_rho_A_inv_I_d;
    let minus_inv_I_a_C_Nr_inv_I_a = -(inv_I_a * C_Nr_inv_I_a);
    prepared[14] = minus_inv_I_a_C_Nr_inv_I_a;
}
