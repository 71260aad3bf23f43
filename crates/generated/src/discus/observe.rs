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
    _prepared: &[T; 28],
    marker: &[T; 3],
    seen: &mut [T; 3],
) {
    let x = state[0];
    let y = state[1];
    let z = state[2];
    let phi = state[6];
    let theta = state[7];
    let gamma = state[8];
    let mark_x = marker[0];
    let mark_y = marker[1];
    let mark_z = marker[2];
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let minus_sin_gamma_mark_y_sum = cos_gamma * mark_x - sin_gamma * mark_y;

    // discus.hyz:102  observe mark = position + in_N(mark);
    let mark_x_2 = mark_z * sin_theta + minus_sin_gamma_mark_y_sum * cos_theta + x;
    let minus_sin_theta_minus_sum = mark_z * cos_theta - sin_theta * minus_sin_gamma_mark_y_sum;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let sin_gamma_mark_x_plus_sum = sin_gamma * mark_x + mark_y * cos_gamma;
    let part_of_mark_y_2 =
        sin_gamma_mark_x_plus_sum * cos_phi - minus_sin_theta_minus_sum * sin_phi;
    let mark_y_2 = part_of_mark_y_2 + y;
    let part_of_mark_z_2 =
        sin_phi * sin_gamma_mark_x_plus_sum + minus_sin_theta_minus_sum * cos_phi;
    let mark_z_2 = part_of_mark_z_2 + z;

    seen[0] = mark_x_2;
    seen[1] = mark_y_2;
    seen[2] = mark_z_2;
}
