// Written by `hyzer generate`; changes belong in the model.
//! `disc_quaternion`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 17 operations: 1 add, 11 mul, 3 div, 2 neg.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 16]) {
    let m = parameters[0];
    let I_a = parameters[1];
    let I_d = parameters[2];
    let d = parameters[3];
    let A = parameters[4];
    let rho = parameters[5];
    let C_Da = parameters[10];
    let C_Nr = parameters[14];
    let inv_m = T::splat(1.0) / m;
    let rho_A = A * rho;
    let inv_m_rho_A = inv_m * rho_A;
    let inv_I_d = T::splat(1.0) / I_d;
    let inv_I_d_d = d * inv_I_d;
    let half_rho_A = T::splat(0.5) * rho_A;
    let I_a_inv_I_d = inv_I_d * I_a;
    let one_minus_inv_I_d_I_a = T::splat(1.0) - I_a_inv_I_d;
    let inv_I_a = T::splat(1.0) / I_a;
    let C_Nr_inv_I_a = C_Nr * inv_I_a;
    let d_rho_A_inv_I_d = rho_A * inv_I_d_d;
    let minus_I_a_inv_I_d = -I_a_inv_I_d;
    let minus_inv_I_a_C_Nr_inv_I_a = -(inv_I_a * C_Nr_inv_I_a);

    prepared[0] = inv_m_rho_A;
    prepared[1] = inv_I_d_d * half_rho_A;
    prepared[2] = one_minus_inv_I_d_I_a;
    prepared[3] = C_Nr_inv_I_a;
    prepared[4] = d_rho_A_inv_I_d;
    prepared[5] = C_Da * T::splat(2.0);
    prepared[6] = rho_A;
    prepared[7] = inv_m;
    prepared[8] = inv_I_d;
    prepared[9] = I_a_inv_I_d;
    prepared[10] = inv_I_d_d;
    prepared[11] = inv_I_a;
    prepared[12] = minus_I_a_inv_I_d;
    prepared[13] = minus_inv_I_a_C_Nr_inv_I_a;
    prepared[14] = rho * T::splat(0.5);
    prepared[15] = half_rho_A;
}
