// Written by `hyzer generate`; changes belong in the model.
//! `discus`: what is observed.

use lanes::Real;

/// The marker, `seen`, in the inertial frame.
///
/// 27 operations: 9 add, 12 mul, 6 call.
#[inline(always)]
pub fn observe<T: Real>(
    _time: T,
    state: &[T; 12],
    _parameters: &[T; 18],
    _prepared: &[T; 29],
    marker: &[T; 3],
    seen: &mut [T; 3],
) {
    let gamma = state[8];
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let theta = state[7];
    let (sin_theta, cos_theta) = theta.sin_cos();
    let phi = state[6];
    let (sin_phi, cos_phi) = phi.sin_cos();
    let mark_y = marker[1];
    let mark_x = marker[0];
    let minus_sin_gamma_mark_y_sum = sin_gamma.neg_mul_add(mark_y, cos_gamma * mark_x);
    let sin_gamma_mark_x_plus_sum = mark_y.mul_add(cos_gamma, sin_gamma * mark_x);
    let mark_z = marker[2];
    let minus_sin_theta_minus_sum =
        sin_theta.neg_mul_add(minus_sin_gamma_mark_y_sum, mark_z * cos_theta);
    let part_of_mark_x_2 = minus_sin_gamma_mark_y_sum.mul_add(cos_theta, mark_z * sin_theta);
    let part_of_mark_y_2 =
        minus_sin_theta_minus_sum.neg_mul_add(sin_phi, sin_gamma_mark_x_plus_sum * cos_phi);
    let part_of_mark_z_2 =
        minus_sin_theta_minus_sum.mul_add(cos_phi, sin_phi * sin_gamma_mark_x_plus_sum);
    let x = state[0];

    // discus.hyz:120  observe mark = place;
    let mark_x_2 = part_of_mark_x_2 + x;
    seen[0] = mark_x_2;
    let y = state[1];
    let mark_y_2 = part_of_mark_y_2 + y;
    seen[1] = mark_y_2;
    let z = state[2];
    let mark_z_2 = part_of_mark_z_2 + z;
    seen[2] = mark_z_2;
}
