// Written by `hyzer generate`; changes belong in the model.
//! `disc_quaternion`: what is observed.

use lanes::Real;

/// The marker, `seen`, in the inertial frame.
///
/// 44 operations: 20 add, 24 mul.
#[inline(always)]
pub fn observe<T: Real>(
    _time: T,
    state: &[T; 13],
    _parameters: &[T; 18],
    _prepared: &[T; 18],
    marker: &[T; 3],
    seen: &mut [T; 3],
) {
    let q2 = state[8];
    let q0 = state[6];
    let q2_q0 = q2 * q0;
    let q3 = state[9];
    let q1 = state[7];
    let q3_q1 = q3 * q1;
    let q0_q1 = q0 * q1;
    let q2_q3 = q2 * q3;
    let q0_q3 = q0 * q3;
    let q3_sq_two = T::splat(2.0) * q3 * q3;
    let q2_sq_two_minus_one = q2.mul_sub(T::splat(2.0) * q2, T::splat(1.0));
    let q2_q1 = q2 * q1;
    let q1_sq_two = T::splat(2.0) * q1 * q1;
    let mark_x = marker[0];
    let x = state[0];
    let part_of_mark_x_2_2 = mark_x.neg_mul_add(q3_sq_two + q2_sq_two_minus_one, x);
    let mark_y = marker[1];
    let mark_z = marker[2];
    let part_of_mark_x_2 = mark_y.mul_add(q2_q1 - q0_q3, mark_z * (q2_q0 + q3_q1));
    let z = state[2];
    let part_of_mark_z_2_2 = mark_z.neg_mul_add(q1_sq_two + q2_sq_two_minus_one, z);
    let part_of_mark_y_2_2 = mark_x.mul_add(q0_q3 + q2_q1, mark_z * (q2_q3 - q0_q1));
    let part_of_mark_z_2 = mark_x.mul_add(q3_q1 - q2_q0, mark_y * (q0_q1 + q2_q3));
    let y = state[1];
    let part_of_mark_y_2 = mark_y.neg_mul_add(q3_sq_two - T::splat(1.0) + q1_sq_two, y);

    // disc_quaternion.hyz:102  observe mark = place;
    let mark_x_2 = T::splat(2.0).mul_add(part_of_mark_x_2, part_of_mark_x_2_2);
    seen[0] = mark_x_2;
    let mark_z_2 = T::splat(2.0).mul_add(part_of_mark_z_2, part_of_mark_z_2_2);
    seen[2] = mark_z_2;
    let mark_y_2 = T::splat(2.0).mul_add(part_of_mark_y_2_2, part_of_mark_y_2);
    seen[1] = mark_y_2;
}
