// Written by `hyzer generate`; changes belong in the model.
//! `ball`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 33 operations: 9 add, 16 mul, 1 div, 6 neg, 1 sqrt.
#[inline(always)]
pub fn f_jac<T: Real>(
    _time: T,
    state: &[T; 6],
    parameters: &[T; 11],
    prepared: &[T; 8],
    dx: &mut [T; 6],
    j: &mut [T; 12],
) {
    let vx = state[3];
    let vy = state[4];
    let vz = state[5];
    let g = parameters[3];
    let wind_x = parameters[5];
    let wind_y = parameters[6];
    let wind_z = parameters[7];
    let half_pi_p4_p2_p1_p1_inv_p0 = prepared[0];
    let vx_minus_wind_x = vx - wind_x;
    let minus_vy_plus_wind_y = wind_y - vy;
    let minus_vy_plus_wind_y_sq = minus_vy_plus_wind_y * minus_vy_plus_wind_y;
    let minus_vz_plus_wind_z = wind_z - vz;
    let minus_vz_plus_wind_z_sq = minus_vz_plus_wind_z * minus_vz_plus_wind_z;
    let part_of_V =
        vx_minus_wind_x * vx_minus_wind_x + minus_vy_plus_wind_y_sq + minus_vz_plus_wind_z_sq;

    // ball.hyz:34  let V = norm(air_velocity);
    let V = part_of_V.sqrt();
    let V_half_part_sq_part_product = half_pi_p4_p2_p1_p1_inv_p0 * V;

    // ball.hyz:30  velocity (vx, vy, vz) in N;
    let vz_dot = minus_vz_plus_wind_z * V_half_part_sq_part_product - g;
    let inv_V = V.recip_or_zero();
    let inv_V_half_part_sq_product = half_pi_p4_p2_p1_p1_inv_p0 * inv_V;
    let vx_minus_wind_x_inv_product = vx_minus_wind_x * inv_V_half_part_sq_product;
    let part_of_d_vx_dot_d_vx =
        -V_half_part_sq_part_product - vx_minus_wind_x * vx_minus_wind_x_inv_product;
    let minus_vy_plus_wind_product = minus_vy_plus_wind_y * vx_minus_wind_x_inv_product;
    let minus_vz_plus_wind_product = minus_vz_plus_wind_z * vx_minus_wind_x_inv_product;
    let part_of_d_vy_dot_d_vy =
        -V_half_part_sq_part_product - minus_vy_plus_wind_y_sq * inv_V_half_part_sq_product;
    let minus_vy_plus_wind_product_2 =
        minus_vy_plus_wind_y * minus_vz_plus_wind_z * inv_V_half_part_sq_product;
    let part_of_d_vz_dot_d_vz =
        -V_half_part_sq_part_product - minus_vz_plus_wind_z_sq * inv_V_half_part_sq_product;
    let minus_vx_minus_wind_x_V_product = -(vx_minus_wind_x * V_half_part_sq_part_product);
    let minus_minus_vy_plus_wind_product_2 = -minus_vy_plus_wind_product_2;
    let minus_minus_vy_plus_wind_product_2_2 = -minus_vy_plus_wind_product_2;

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    dx[3] = minus_vx_minus_wind_x_V_product;
    dx[4] = minus_vy_plus_wind_y * V_half_part_sq_part_product;
    dx[5] = vz_dot;

    j[0] = T::splat(1.0); // d_x_dot_d_vx
    j[1] = T::splat(1.0); // d_y_dot_d_vy
    j[2] = T::splat(1.0); // d_z_dot_d_vz
    j[3] = part_of_d_vx_dot_d_vx; // d_vx_dot_d_vx
    j[4] = minus_vy_plus_wind_product; // d_vx_dot_d_vy
    j[5] = minus_vz_plus_wind_product; // d_vx_dot_d_vz
    j[6] = minus_vy_plus_wind_product; // d_vy_dot_d_vx
    j[7] = part_of_d_vy_dot_d_vy; // d_vy_dot_d_vy
    j[8] = minus_minus_vy_plus_wind_product_2; // d_vy_dot_d_vz
    j[9] = minus_vz_plus_wind_product; // d_vz_dot_d_vx
    j[10] = minus_minus_vy_plus_wind_product_2_2; // d_vz_dot_d_vy
    j[11] = part_of_d_vz_dot_d_vz; // d_vz_dot_d_vz
}
