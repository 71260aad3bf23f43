// Written by `hyzer generate`; changes belong in the model.
//! `disc_appendix`: the constants of a flight.

use lanes::Real;

/// What depends on the parameters alone, once per flight.
///
/// 23 operations: 2 add, 18 mul, 3 div.
#[inline(always)]
pub fn prepare<T: Real>(parameters: &[T; 18], prepared: &mut [T; 22]) {
    let m = parameters[0];
    let I_a = parameters[1];
    let I_d = parameters[2];
    let d = parameters[3];
    let A = parameters[4];
    let rho = parameters[5];
    let g = parameters[6];
    let C_Da = parameters[10];
    let C_Rr = parameters[13];
    let C_Nr = parameters[14];
    let p6_p0 = m * g;
    let A_rho_half = A * rho * T::splat(0.5);
    let inv_m = T::splat(1.0) / m;
    let I_d_two = I_d * T::splat(2.0);
    let inv_I_d = T::splat(1.0) / I_d;
    let inv_I_a = T::splat(1.0) / I_a;
    let p1_minus_p2_two = I_a - I_d_two;
    let minus_p2_plus_p1 = I_a - I_d;
    let p13_inv_p2 = inv_I_d * C_Rr;
    let p1_inv_p2 = inv_I_d * I_a;
    let p14_inv_p1 = inv_I_a * C_Nr;
    let p6_inv_p0 = g * inv_m;
    let inv_p0_sq = inv_m * inv_m;
    let inv_p2_sq = inv_I_d * inv_I_d;
    let inv_p1_sq = inv_I_a * inv_I_a;

    prepared[0] = p6_p0;
    prepared[1] = A_rho_half;
    prepared[2] = inv_m;
    prepared[3] = I_d_two;
    prepared[4] = inv_I_d;
    prepared[5] = inv_I_a;
    prepared[6] = T::splat(2.0) * C_Da;
    prepared[7] = inv_m * A_rho_half;
    prepared[8] = d * A_rho_half;
    prepared[9] = p1_minus_p2_two;
    prepared[10] = T::splat(2.0) * inv_I_d;
    prepared[11] = minus_p2_plus_p1;
    prepared[12] = p13_inv_p2;
    prepared[13] = p1_inv_p2;
    prepared[14] = p14_inv_p1;
    prepared[15] = A * T::splat(0.5);
    prepared[16] = T::splat(2.0) * d;
    prepared[17] = p6_inv_p0;
    prepared[18] = inv_p0_sq;
    prepared[19] = rho * T::splat(0.5);
    prepared[20] = inv_p2_sq;
    prepared[21] = inv_p1_sq;
}
