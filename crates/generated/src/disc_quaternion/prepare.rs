// Written by `hyzer generate`; changes belong in the model.
//! `disc_quaternion`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 17 operations: 1 add, 13 mul, 3 div.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 16]) {
    let m = parameters[0];
    let I_a = parameters[1];
    let I_d = parameters[2];
    let d = parameters[3];
    let A = parameters[4];
    let rho = parameters[5];
    let C_Da = parameters[10];
    let C_Mq = parameters[12];
    let C_Nr = parameters[14];
    let inv_m = T::splat(1.0) / m;
    let p4_p5 = A * rho;
    let inv_p0_p5_p4 = inv_m * p4_p5;
    let inv_I_d = T::splat(1.0) / I_d;
    let p3_p4_p5_inv_p2 = p4_p5 * (d * inv_I_d);
    let p1_inv_p2 = inv_I_d * I_a;
    let n1_minus_inv_p2_p1 = T::splat(1.0) - p1_inv_p2;
    let inv_I_a = T::splat(1.0) / I_a;
    let p14_inv_p1 = C_Nr * inv_I_a;
    let inv_p1_p14_inv_p1 = inv_I_a * p14_inv_p1;

    prepared[0] = inv_p0_p5_p4;
    prepared[1] = T::splat(0.5) * p3_p4_p5_inv_p2;
    prepared[2] = n1_minus_inv_p2_p1;
    prepared[3] = p14_inv_p1;
    prepared[4] = p3_p4_p5_inv_p2;
    prepared[5] = C_Da * T::splat(2.0);
    prepared[6] = T::splat(0.25) * p3_p4_p5_inv_p2;
    prepared[7] = T::splat(0.5) * C_Mq;
    prepared[8] = p4_p5;
    prepared[9] = inv_m;
    prepared[10] = inv_I_d;
    prepared[11] = p1_inv_p2;
    prepared[12] = inv_I_a;
    prepared[13] = inv_p1_p14_inv_p1;
    prepared[14] = rho * T::splat(0.5);
    prepared[15] = T::splat(0.5) * p4_p5;
}
