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
    let p4_p5 = A * rho;
    let inv_p0_p5_p4 = inv_m * p4_p5;
    let inv_I_d = T::splat(1.0) / I_d;
    let inv_p2_p3 = d * inv_I_d;
    let half_p4_p5 = T::splat(0.5) * p4_p5;
    let p1_inv_p2 = inv_I_d * I_a;
    let n1_minus_inv_p2_p1 = T::splat(1.0) - p1_inv_p2;
    let inv_I_a = T::splat(1.0) / I_a;
    let p14_inv_p1 = C_Nr * inv_I_a;
    let p3_p4_p5_inv_p2 = p4_p5 * inv_p2_p3;
    let minus_p1_inv_p2 = -p1_inv_p2;
    let minus_inv_I_a_p14_inv_p1 = -(inv_I_a * p14_inv_p1);

    prepared[0] = inv_p0_p5_p4;
    prepared[1] = inv_p2_p3 * half_p4_p5;
    prepared[2] = n1_minus_inv_p2_p1;
    prepared[3] = p14_inv_p1;
    prepared[4] = p3_p4_p5_inv_p2;
    prepared[5] = C_Da * T::splat(2.0);
    prepared[6] = p4_p5;
    prepared[7] = inv_m;
    prepared[8] = inv_I_d;
    prepared[9] = p1_inv_p2;
    prepared[10] = inv_p2_p3;
    prepared[11] = inv_I_a;
    prepared[12] = minus_p1_inv_p2;
    prepared[13] = minus_inv_I_a_p14_inv_p1;
    prepared[14] = rho * T::splat(0.5);
    prepared[15] = half_p4_p5;
}
