// Written by `hyzer generate`; changes belong in the model.
//! `disc_quaternion`: what is observed, and its derivatives.

use lanes::Real;

/// The marker, `seen`, and its derivatives by states, parameters and its own coordinates.
///
/// 92 operations: 38 add, 52 mul, 2 neg.
#[inline(always)]
pub fn observe_jac<T: Real>(
    _time: T,
    state: &[T; 13],
    _parameters: &[T; 18],
    _prepared: &[T; 18],
    marker: &[T; 3],
    seen: &mut [T; 3],
    dy_dx: &mut [T; 15],
    _dy_dp: &mut [T; 0],
    dy_dmarker: &mut [T; 9],
) {
    let q3 = state[9];
    let q3_two = T::splat(2.0) * q3;
    let q2 = state[8];
    let q2_two = T::splat(2.0) * q2;
    let q1 = state[7];
    let q2_q1 = q1 * q2;
    let q0 = state[6];
    let q0_q3 = q0 * q3;
    let q3_q1 = q1 * q3;
    let q2_q0 = q2 * q0;
    let q1_two = T::splat(2.0) * q1;
    let q2_q3 = q2 * q3;
    let q3_sq_two = q3 * q3_two;
    let q2_sq_two_minus_one = q2.mul_sub(q2_two, T::splat(1.0));
    let minus_q0_q3_plus_q2_q1 = q2_q1 - q0_q3;
    let q0_q3_plus_q2_q1 = q2_q1 + q0_q3;
    let q0_q1 = q1 * q0;
    let minus_q2_q0_plus_q3_q1 = q3_q1 - q2_q0;
    let q1_sq_two = q1 * q1_two;
    let q0_two = T::splat(2.0) * q0;
    let q2_q0_plus_q3_q1 = q3_q1 + q2_q0;
    let q3_sq_two_plus_q2_sq_sum = q2_sq_two_minus_one + q3_sq_two;
    let minus_q0_q1_plus_q2_q3 = q2_q3 - q0_q1;
    let q0_q1_plus_q2_q3 = q2_q3 + q0_q1;
    let q1_sq_two_plus_q2_sq_sum = q2_sq_two_minus_one + q1_sq_two;
    let minus_q3_sq_two_minus_one_sum = T::splat(1.0) - q3_sq_two - q1_sq_two;
    dy_dmarker[4] = minus_q3_sq_two_minus_one_sum; // d_seen_y_d_mark_y
    let mark_z = marker[2];
    let mark_z_q2_two = mark_z * q2_two;
    let mark_y = marker[1];
    let mark_y_q3_two = mark_y * q3_two;
    let mark_y_q1_two = mark_y * q1_two;
    let q2_n4 = T::splat(4.0) * q2;
    dy_dmarker[1] = T::splat(2.0) * minus_q0_q3_plus_q2_q1; // d_seen_x_d_mark_y
    let mark_z_q0_two = mark_z * q0_two;
    dy_dmarker[3] = T::splat(2.0) * q0_q3_plus_q2_q1; // d_seen_y_d_mark_x
    let mark_z_q1_two = mark_z * q1_two;
    dy_dmarker[6] = T::splat(2.0) * minus_q2_q0_plus_q3_q1; // d_seen_z_d_mark_x
    let q3_n4 = T::splat(4.0) * q3;
    let mark_z_q2_q0_plus_q3_q1_sum =
        q2_q0_plus_q3_q1.mul_add(mark_z, minus_q0_q3_plus_q2_q1 * mark_y);
    dy_dmarker[2] = T::splat(2.0) * q2_q0_plus_q3_q1; // d_seen_x_d_mark_z
    let mark_y_q0_two = mark_y * q0_two;
    let mark_x = marker[0];
    let mark_x_q0_two = mark_x * q0_two;
    let mark_z_minus_q0_q1_sum = mark_z.mul_add(minus_q0_q1_plus_q2_q3, mark_x * q0_q3_plus_q2_q1);
    dy_dmarker[5] = T::splat(2.0) * minus_q0_q1_plus_q2_q3; // d_seen_y_d_mark_z
    let mark_x_q3_two = mark_x * q3_two;
    let y = state[1];
    let part_of_mark_y_2 = mark_y.mul_add(minus_q3_sq_two_minus_one_sum, y);
    let mark_y_2 = mark_z_minus_q0_q1_sum.mul_add(T::splat(2.0), part_of_mark_y_2);
    seen[1] = mark_y_2;
    let mark_x_q2_two = mark_x * q2_two;
    let mark_y_q0_q1_plus_q2_q3_sum =
        mark_y.mul_add(q0_q1_plus_q2_q3, mark_x * minus_q2_q0_plus_q3_q1);
    let mark_z_q3_two = mark_z * q3_two;
    let mark_y_q2_two = mark_y * q2_two;
    let mark_x_q1_two = mark_x * q1_two;
    let x = state[0];
    let part_of_mark_x_2 = q3_sq_two_plus_q2_sq_sum.neg_mul_add(mark_x, x);
    let mark_x_2 = mark_z_q2_q0_plus_q3_q1_sum.mul_add(T::splat(2.0), part_of_mark_x_2);
    seen[0] = mark_x_2;
    let z = state[2];
    let part_of_mark_z_2 = mark_z.neg_mul_add(q1_sq_two_plus_q2_sq_sum, z);
    let mark_z_2 = mark_y_q0_q1_plus_q2_q3_sum.mul_add(T::splat(2.0), part_of_mark_z_2);
    seen[2] = mark_z_2;
    let q1_n4 = T::splat(4.0) * q1;
    let d_seen_x_d_q0 = mark_z_q2_two - mark_y_q3_two;
    dy_dx[1] = d_seen_x_d_q0;
    let d_seen_x_d_q2 = mark_x.neg_mul_add(q2_n4, mark_y_q1_two) + mark_z_q0_two;
    dy_dx[3] = d_seen_x_d_q2;
    let d_seen_x_d_q3 = mark_x.neg_mul_add(q3_n4, mark_z_q1_two) - mark_y_q0_two;
    dy_dx[4] = d_seen_x_d_q3;
    let d_seen_y_d_q0 = mark_x_q3_two - mark_z_q1_two;
    dy_dx[6] = d_seen_y_d_q0;
    let d_seen_y_d_q3 = mark_y.neg_mul_add(q3_n4, mark_z_q2_two) + mark_x_q0_two;
    dy_dx[9] = d_seen_y_d_q3;
    let d_seen_z_d_q0 = mark_y_q1_two - mark_x_q2_two;
    dy_dx[11] = d_seen_z_d_q0;
    let d_seen_z_d_q2 = mark_z.neg_mul_add(q2_n4, mark_y_q3_two - mark_x_q0_two);
    dy_dx[13] = d_seen_z_d_q2;
    let d_seen_y_d_q1 = mark_y.neg_mul_add(q1_n4, mark_x_q2_two - mark_z_q0_two);
    dy_dx[7] = d_seen_y_d_q1;
    dy_dmarker[7] = T::splat(2.0) * q0_q1_plus_q2_q3; // d_seen_z_d_mark_y
    let d_seen_z_d_q1 = mark_z.neg_mul_add(q1_n4, mark_y_q0_two + mark_x_q3_two);
    dy_dx[12] = d_seen_z_d_q1;
    let d_seen_x_d_q1 = mark_z_q3_two + mark_y_q2_two;
    dy_dx[2] = d_seen_x_d_q1;
    let d_seen_y_d_q2 = mark_z_q3_two + mark_x_q1_two;
    dy_dx[8] = d_seen_y_d_q2;
    let d_seen_z_d_q3 = mark_y_q2_two + mark_x_q1_two;
    dy_dx[14] = d_seen_z_d_q3;
    let d_seen_x_d_mark_x = -q3_sq_two_plus_q2_sq_sum;
    dy_dmarker[0] = d_seen_x_d_mark_x;
    let d_seen_z_d_mark_z = -q1_sq_two_plus_q2_sq_sum;
    dy_dmarker[8] = d_seen_z_d_mark_z;

    dy_dx[0] = T::splat(1.0); // d_seen_x_d_x
    dy_dx[5] = T::splat(1.0); // d_seen_y_d_y
    dy_dx[10] = T::splat(1.0); // d_seen_z_d_z
}
