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
    _prepared: &[T; 16],
    marker: &[T; 3],
    seen: &mut [T; 3],
    dy_dx: &mut [T; 15],
    _dy_dp: &mut [T; 0],
    dy_dmarker: &mut [T; 9],
) {
    let x = state[0];
    let y = state[1];
    let z = state[2];
    let q0 = state[6];
    let q1 = state[7];
    let q2 = state[8];
    let q3 = state[9];
    let mark_x = marker[0];
    let mark_y = marker[1];
    let mark_z = marker[2];
    let q2_two = T::splat(2.0) * q2;
    let q2_q2_two_minus_n1 = q2 * q2_two - T::splat(1.0);
    let q3_two = T::splat(2.0) * q3;
    let q3_q3_two = q3 * q3_two;
    let q2_q2_two_minus_n1_plus_sum = q2_q2_two_minus_n1 + q3_q3_two;
    let q1_q2 = q1 * q2;
    let q0_q3 = q0 * q3;
    let q1_q2_minus_q0_q3 = q1_q2 - q0_q3;
    let q1_q3 = q1 * q3;
    let q2_q0 = q2 * q0;
    let q1_q3_plus_q2_q0 = q1_q3 + q2_q0;
    let part_of_mark_x_2 = T::splat(2.0) * (q1_q2_minus_q0_q3 * mark_y + q1_q3_plus_q2_q0 * mark_z);

    // disc_quaternion.hyz:84  observe mark = position + in_N(mark);
    let mark_x_2 = x - q2_q2_two_minus_n1_plus_sum * mark_x + part_of_mark_x_2;
    let q1_two = T::splat(2.0) * q1;
    let q1_q1_two = q1 * q1_two;
    let n1_minus_q3_q3_two_sum = T::splat(1.0) - q3_q3_two - q1_q1_two;
    let q1_q2_plus_q0_q3 = q1_q2 + q0_q3;
    let q2_q3 = q2 * q3;
    let q1_q0 = q1 * q0;
    let q2_q3_minus_q1_q0 = q2_q3 - q1_q0;
    let part_of_mark_y_2 = T::splat(2.0) * (mark_x * q1_q2_plus_q0_q3 + mark_z * q2_q3_minus_q1_q0);
    let mark_y_2 = y + mark_y * n1_minus_q3_q3_two_sum + part_of_mark_y_2;
    let q2_q2_two_minus_n1_plus_sum_2 = q2_q2_two_minus_n1 + q1_q1_two;
    let q1_q3_minus_q2_q0 = q1_q3 - q2_q0;
    let q2_q3_plus_q1_q0 = q2_q3 + q1_q0;
    let part_of_mark_z_2 = T::splat(2.0) * (mark_x * q1_q3_minus_q2_q0 + mark_y * q2_q3_plus_q1_q0);
    let mark_z_2 = z - mark_z * q2_q2_two_minus_n1_plus_sum_2 + part_of_mark_z_2;
    let mark_z_q2_two = mark_z * q2_two;
    let mark_y_q3_two = mark_y * q3_two;
    let mark_y_q2_two = mark_y * q2_two;
    let mark_z_q3_two = mark_z * q3_two;
    let mark_y_q1_two = mark_y * q1_two;
    let q2_n4 = T::splat(4.0) * q2;
    let q0_two = T::splat(2.0) * q0;
    let mark_z_q0_two = mark_z * q0_two;
    let mark_z_q1_two = mark_z * q1_two;
    let q3_n4 = T::splat(4.0) * q3;
    let mark_y_q0_two = mark_y * q0_two;
    let mark_x_q3_two = mark_x * q3_two;
    let q1_n4 = T::splat(4.0) * q1;
    let mark_x_q2_two = mark_x * q2_two;
    let mark_x_q1_two = mark_x * q1_two;
    let mark_x_q0_two = mark_x * q0_two;
    let minus_q2_q2_two_minus_n1_plus_sum = -q2_q2_two_minus_n1_plus_sum;
    let minus_q2_q2_two_minus_n1_plus_sum_2 = -q2_q2_two_minus_n1_plus_sum_2;

    seen[0] = mark_x_2;
    seen[1] = mark_y_2;
    seen[2] = mark_z_2;

    dy_dx[0] = T::splat(1.0); // d_y_x_d_x
    dy_dx[1] = mark_z_q2_two - mark_y_q3_two; // d_y_x_d_q0
    dy_dx[2] = mark_y_q2_two + mark_z_q3_two; // d_y_x_d_q1
    dy_dx[3] = mark_y_q1_two - mark_x * q2_n4 + mark_z_q0_two; // d_y_x_d_q2
    dy_dx[4] = mark_z_q1_two - mark_x * q3_n4 - mark_y_q0_two; // d_y_x_d_q3
    dy_dx[5] = T::splat(1.0); // d_y_y_d_y
    dy_dx[6] = mark_x_q3_two - mark_z_q1_two; // d_y_y_d_q0
    dy_dx[7] = mark_x_q2_two - mark_z_q0_two - mark_y * q1_n4; // d_y_y_d_q1
    dy_dx[8] = mark_z_q3_two + mark_x_q1_two; // d_y_y_d_q2
    dy_dx[9] = mark_z_q2_two - mark_y * q3_n4 + mark_x_q0_two; // d_y_y_d_q3
    dy_dx[10] = T::splat(1.0); // d_y_z_d_z
    dy_dx[11] = mark_y_q1_two - mark_x_q2_two; // d_y_z_d_q0
    dy_dx[12] = mark_y_q0_two + mark_x_q3_two - mark_z * q1_n4; // d_y_z_d_q1
    dy_dx[13] = mark_y_q3_two - mark_x_q0_two - mark_z * q2_n4; // d_y_z_d_q2
    dy_dx[14] = mark_y_q2_two + mark_x_q1_two; // d_y_z_d_q3

    dy_dmarker[0] = minus_q2_q2_two_minus_n1_plus_sum; // d_y_x_d_mark_x
    dy_dmarker[1] = T::splat(2.0) * q1_q2_minus_q0_q3; // d_y_x_d_mark_y
    dy_dmarker[2] = T::splat(2.0) * q1_q3_plus_q2_q0; // d_y_x_d_mark_z
    dy_dmarker[3] = T::splat(2.0) * q1_q2_plus_q0_q3; // d_y_y_d_mark_x
    dy_dmarker[4] = n1_minus_q3_q3_two_sum; // d_y_y_d_mark_y
    dy_dmarker[5] = T::splat(2.0) * q2_q3_minus_q1_q0; // d_y_y_d_mark_z
    dy_dmarker[6] = T::splat(2.0) * q1_q3_minus_q2_q0; // d_y_z_d_mark_x
    dy_dmarker[7] = T::splat(2.0) * q2_q3_plus_q1_q0; // d_y_z_d_mark_y
    dy_dmarker[8] = minus_q2_q2_two_minus_n1_plus_sum_2; // d_y_z_d_mark_z
}
