// Written by `hyzer generate`; changes belong in the model.
//! `disc_appendix`: what is observed, and its derivatives.

use lanes::Real;

/// The marker, `seen`, and its derivatives by states, parameters and its own coordinates.
///
/// 59 operations: 15 add, 33 mul, 5 neg, 6 call.
#[inline(always)]
pub fn observe_jac<T: Real>(
    _time: T,
    state: &[T; 12],
    _parameters: &[T; 18],
    _prepared: &[T; 25],
    marker: &[T; 3],
    seen: &mut [T; 3],
    dy_dx: &mut [T; 11],
    _dy_dp: &mut [T; 0],
    dy_dmarker: &mut [T; 9],
) {
    let gamma = state[8];
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let theta = state[7];
    let (sin_theta, cos_theta) = theta.sin_cos();
    dy_dmarker[2] = sin_theta; // d_seen_x_d_mark_z
    let phi = state[6];
    let (sin_phi, cos_phi) = phi.sin_cos();
    let sin_theta_sin_phi = sin_theta * sin_phi;
    let sin_theta_cos_phi = sin_theta * cos_phi;
    let mark_y = marker[1];
    let mark_x = marker[0];
    let minus_sin_gamma_mark_y_sum = mark_y.neg_mul_add(sin_gamma, mark_x * cos_gamma);
    let sin_gamma_mark_x_plus_sum = mark_x.mul_add(sin_gamma, cos_gamma * mark_y);
    let d_seen_y_d_mark_x = cos_gamma.mul_add(sin_theta_sin_phi, sin_gamma * cos_phi);
    dy_dmarker[3] = d_seen_y_d_mark_x;
    let d_seen_y_d_mark_y = sin_gamma.neg_mul_add(sin_theta_sin_phi, cos_gamma * cos_phi);
    dy_dmarker[4] = d_seen_y_d_mark_y;
    let mark_z = marker[2];
    let minus_sin_theta_minus_sum =
        minus_sin_gamma_mark_y_sum.neg_mul_add(sin_theta, cos_theta * mark_z);
    dy_dx[1] = minus_sin_theta_minus_sum; // d_seen_x_d_theta
    let minus_d_minus_sin_theta_minus_sum_d_theta =
        cos_theta.mul_add(minus_sin_gamma_mark_y_sum, sin_theta * mark_z);
    let part_of_d_mark_z_2_d_phi = cos_phi * sin_gamma_mark_x_plus_sum;
    let part_of_d_seen_z_d_gamma = minus_sin_gamma_mark_y_sum * sin_phi;
    let minus_sin_gamma_mark_x_sum = -sin_gamma_mark_x_plus_sum;
    let d_seen_z_d_mark_y = sin_gamma.mul_add(sin_theta_cos_phi, cos_gamma * sin_phi);
    dy_dmarker[7] = d_seen_z_d_mark_y;
    let d_seen_z_d_mark_x = cos_gamma.neg_mul_add(sin_theta_cos_phi, sin_gamma * sin_phi);
    dy_dmarker[6] = d_seen_z_d_mark_x;
    let minus_d_seen_z_d_theta = cos_phi * minus_d_minus_sin_theta_minus_sum_d_theta;
    let d_mark_z_2_d_phi = sin_phi.neg_mul_add(minus_sin_theta_minus_sum, part_of_d_mark_z_2_d_phi);
    dy_dx[8] = d_mark_z_2_d_phi; // d_seen_z_d_phi
    let d_seen_y_d_gamma =
        minus_sin_gamma_mark_x_sum.mul_add(sin_theta_sin_phi, minus_sin_gamma_mark_y_sum * cos_phi);
    dy_dx[6] = d_seen_y_d_gamma;
    let d_seen_z_d_gamma =
        minus_sin_gamma_mark_x_sum.neg_mul_add(sin_theta_cos_phi, part_of_d_seen_z_d_gamma);
    dy_dx[10] = d_seen_z_d_gamma;
    let d_seen_x_d_gamma = cos_theta * minus_sin_gamma_mark_x_sum;
    dy_dx[2] = d_seen_x_d_gamma;
    let d_seen_x_d_mark_x = cos_theta * cos_gamma;
    dy_dmarker[0] = d_seen_x_d_mark_x;
    let d_seen_z_d_mark_z = cos_theta * cos_phi;
    dy_dmarker[8] = d_seen_z_d_mark_z;
    let x = state[0];
    let mark_x_2 = x + minus_d_minus_sin_theta_minus_sum_d_theta;
    seen[0] = mark_x_2;
    let d_mark_y_2_d_phi =
        sin_gamma_mark_x_plus_sum.neg_mul_add(sin_phi, -(cos_phi * minus_sin_theta_minus_sum));
    dy_dx[4] = d_mark_y_2_d_phi; // d_seen_y_d_phi
    dy_dx[5] = sin_phi * minus_d_minus_sin_theta_minus_sum_d_theta; // d_seen_y_d_theta
    let y = state[1];
    let mark_y_2 = y + d_mark_z_2_d_phi;
    seen[1] = mark_y_2;
    let d_seen_z_d_theta = -minus_d_seen_z_d_theta;
    dy_dx[9] = d_seen_z_d_theta;
    let d_seen_x_d_mark_y = -(cos_theta * sin_gamma);
    dy_dmarker[1] = d_seen_x_d_mark_y;
    let d_seen_y_d_mark_z = -(cos_theta * sin_phi);
    dy_dmarker[5] = d_seen_y_d_mark_z;
    let z = state[2];
    let mark_z_2 = z - d_mark_y_2_d_phi;
    seen[2] = mark_z_2;

    dy_dx[0] = T::splat(1.0); // d_seen_x_d_x
    dy_dx[3] = T::splat(1.0); // d_seen_y_d_y
    dy_dx[7] = T::splat(1.0); // d_seen_z_d_z
}
