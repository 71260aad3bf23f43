// Written by `hyzer generate`; changes belong in the model.
//! `disc`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 18 operations: 2 add, 13 mul, 3 div.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 17]) {
    let m = parameters[0];
    let I_a = parameters[1];
    let I_d = parameters[2];
    let d = parameters[3];
    let A = parameters[4];
    let rho = parameters[5];
    let C_Da = parameters[10];
    let C_Nr = parameters[14];
    let inv_m = T::splat(1.0) / m;
    let p5_p4_half_two = A * rho;
    let half_p5_p4_half_two = T::splat(0.5) * p5_p4_half_two;
    let inv_I_d = T::splat(1.0) / I_d;
    let inv_p2_p1 = inv_I_d * I_a;
    let inv_I_a = T::splat(1.0) / I_a;
    let p14_inv_p1 = C_Nr * inv_I_a;
    let two_minus_p1_inv_p2 = T::splat(2.0) - inv_p2_p1;
    let n1_minus_p1_inv_p2 = T::splat(1.0) - inv_p2_p1;
    let inv_p2_sq = inv_I_d * inv_I_d;
    let inv_p1_d_gammadot_dot_d_r = inv_I_a * p14_inv_p1;

    prepared[0] = inv_m * half_p5_p4_half_two;
    prepared[1] = half_p5_p4_half_two * (d * inv_I_d);
    prepared[2] = inv_p2_p1;
    prepared[3] = p14_inv_p1;
    prepared[4] = C_Da * T::splat(2.0);
    prepared[5] = two_minus_p1_inv_p2;
    prepared[6] = n1_minus_p1_inv_p2;
    prepared[7] = A * T::splat(0.5);
    prepared[8] = half_p5_p4_half_two;
    prepared[9] = inv_m;
    prepared[10] = inv_I_d;
    prepared[11] = inv_I_a;
    prepared[12] = p5_p4_half_two;
    prepared[13] = rho * T::splat(0.5);
    prepared[14] = inv_p2_sq;
    prepared[15] = inv_I_d * half_p5_p4_half_two;
    prepared[16] = inv_p1_d_gammadot_dot_d_r;
}
