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
    _prepared: &[T; 28],
    marker: &[T; 3],
    seen: &mut [T; 3],
    dy_dx: &mut [T; 11],
    _dy_dp: &mut [T; 0],
    dy_dmarker: &mut [T; 9],
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
    let mark_x_cos_gamma_minus_sum = mark_x * cos_gamma - mark_y * sin_gamma;
    let cos_theta_mark_x_sum = cos_theta * mark_x_cos_gamma_minus_sum + sin_theta * mark_z;

    // disc_appendix.hyz:132  observe mark = (x, y, z) in N + in_N(mark);
    let mark_x_2 = x + cos_theta_mark_x_sum;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let cos_gamma_mark_y_plus_sum = cos_gamma * mark_y + mark_x * sin_gamma;
    let cos_theta_mark_z_minus_sum = cos_theta * mark_z - mark_x_cos_gamma_minus_sum * sin_theta;
    let cos_phi_cos_gamma_sum =
        cos_phi * cos_gamma_mark_y_plus_sum - sin_phi * cos_theta_mark_z_minus_sum;
    let mark_y_2 = y + cos_phi_cos_gamma_sum;
    let minus_cos_phi_cos_theta_sum =
        -(cos_phi * cos_theta_mark_z_minus_sum) - cos_gamma_mark_y_plus_sum * sin_phi;
    let mark_z_2 = z - minus_cos_phi_cos_theta_sum;
    let sin_theta_sin_phi = sin_theta * sin_phi;
    let part_of_d_y_y_d_gamma =
        mark_x_cos_gamma_minus_sum * cos_phi - cos_gamma_mark_y_plus_sum * sin_theta_sin_phi;
    let sin_theta_cos_phi = sin_theta * cos_phi;
    let part_of_d_y_z_d_gamma =
        cos_gamma_mark_y_plus_sum * sin_theta_cos_phi + mark_x_cos_gamma_minus_sum * sin_phi;
    let minus_cos_theta_cos_gamma_product = -(cos_theta * cos_gamma_mark_y_plus_sum);
    let minus_cos_phi_cos_theta_mark_x_sum = -(cos_phi * cos_theta_mark_x_sum);
    let minus_cos_theta_sin_gamma = -(cos_theta * sin_gamma);
    let minus_cos_theta_sin_phi = -(cos_theta * sin_phi);

    seen[0] = mark_x_2;
    seen[1] = mark_y_2;
    seen[2] = mark_z_2;

    dy_dx[0] = T::splat(1.0); // d_y_x_d_x
    dy_dx[1] = cos_theta_mark_z_minus_sum; // d_y_x_d_theta
    dy_dx[2] = minus_cos_theta_cos_gamma_product; // d_y_x_d_gamma
    dy_dx[3] = T::splat(1.0); // d_y_y_d_y
    dy_dx[4] = minus_cos_phi_cos_theta_sum; // d_y_y_d_phi
    dy_dx[5] = sin_phi * cos_theta_mark_x_sum; // d_y_y_d_theta
    dy_dx[6] = part_of_d_y_y_d_gamma; // d_y_y_d_gamma
    dy_dx[7] = T::splat(1.0); // d_y_z_d_z
    dy_dx[8] = cos_phi_cos_gamma_sum; // d_y_z_d_phi
    dy_dx[9] = minus_cos_phi_cos_theta_mark_x_sum; // d_y_z_d_theta
    dy_dx[10] = part_of_d_y_z_d_gamma; // d_y_z_d_gamma

    dy_dmarker[0] = cos_theta * cos_gamma; // d_y_x_d_mark_x
    dy_dmarker[1] = minus_cos_theta_sin_gamma; // d_y_x_d_mark_y
    dy_dmarker[2] = sin_theta; // d_y_x_d_mark_z
    dy_dmarker[3] = cos_gamma * sin_theta_sin_phi + sin_gamma * cos_phi; // d_y_y_d_mark_x
    dy_dmarker[4] = cos_gamma * cos_phi - sin_gamma * sin_theta_sin_phi; // d_y_y_d_mark_y
    dy_dmarker[5] = minus_cos_theta_sin_phi; // d_y_y_d_mark_z
    dy_dmarker[6] = sin_gamma * sin_phi - cos_gamma * sin_theta_cos_phi; // d_y_z_d_mark_x
    dy_dmarker[7] = sin_gamma * sin_theta_cos_phi + cos_gamma * sin_phi; // d_y_z_d_mark_y
    dy_dmarker[8] = cos_theta * cos_phi; // d_y_z_d_mark_z
}
