// Written by `hyzer generate`; changes belong in the model.
//! `ball`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 39 operations: 9 add, 16 mul, 1 div, 12 neg, 1 sqrt.
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

    // ball.hyz:33  let air_velocity = velocity - wind;
    let air_velocity_x = vx - wind_x;
    let air_velocity_y = vy - wind_y;
    let air_velocity_y_sq = air_velocity_y * air_velocity_y;
    let air_velocity_z = vz - wind_z;
    let air_velocity_z_sq = air_velocity_z * air_velocity_z;
    let part_of_sqrt_air_velocity_x_sq_of =
        air_velocity_x * air_velocity_x + air_velocity_y_sq + air_velocity_z_sq;
    let sqrt_air_velocity_x_sq_of = part_of_sqrt_air_velocity_x_sq_of.sqrt();
    let sqrt_air_velocity_x_product = half_pi_p4_p2_p1_p1_inv_p0 * sqrt_air_velocity_x_sq_of;

    // ball.hyz:30  velocity (vx, vy, vz) in N;
    let vz_dot = -(air_velocity_z * sqrt_air_velocity_x_product) - g;
    let inv_sqrt_air_velocity_x_of = sqrt_air_velocity_x_sq_of.recip_or_zero();
    let inv_sqrt_air_product = half_pi_p4_p2_p1_p1_inv_p0 * inv_sqrt_air_velocity_x_of;
    let air_velocity_x_inv_product = air_velocity_x * inv_sqrt_air_product;
    let part_of_d_vx_dot_d_vx =
        -sqrt_air_velocity_x_product - air_velocity_x * air_velocity_x_inv_product;
    let air_velocity_y_air_product = air_velocity_y * air_velocity_x_inv_product;
    let air_velocity_z_air_product = air_velocity_z * air_velocity_x_inv_product;
    let part_of_d_vy_dot_d_vy =
        -sqrt_air_velocity_x_product - air_velocity_y_sq * inv_sqrt_air_product;
    let air_velocity_y_air_product_2 = air_velocity_y * air_velocity_z * inv_sqrt_air_product;
    let part_of_d_vz_dot_d_vz =
        -sqrt_air_velocity_x_product - air_velocity_z_sq * inv_sqrt_air_product;
    let minus_air_velocity_x_sqrt_product = -(air_velocity_x * sqrt_air_velocity_x_product);
    let minus_air_velocity_y_sqrt_product = -(air_velocity_y * sqrt_air_velocity_x_product);
    let minus_air_velocity_y_air_product = -air_velocity_y_air_product;
    let minus_air_velocity_z_air_product = -air_velocity_z_air_product;
    let minus_air_velocity_y_air_product_2 = -air_velocity_y_air_product;
    let minus_air_velocity_y_air_product_2_2 = -air_velocity_y_air_product_2;
    let minus_air_velocity_z_air_product_2 = -air_velocity_z_air_product;
    let minus_air_velocity_y_air_product_2_3 = -air_velocity_y_air_product_2;

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    dx[3] = minus_air_velocity_x_sqrt_product;
    dx[4] = minus_air_velocity_y_sqrt_product;
    dx[5] = vz_dot;

    j[0] = T::splat(1.0); // d_x_dot_d_vx
    j[1] = T::splat(1.0); // d_y_dot_d_vy
    j[2] = T::splat(1.0); // d_z_dot_d_vz
    j[3] = part_of_d_vx_dot_d_vx; // d_vx_dot_d_vx
    j[4] = minus_air_velocity_y_air_product; // d_vx_dot_d_vy
    j[5] = minus_air_velocity_z_air_product; // d_vx_dot_d_vz
    j[6] = minus_air_velocity_y_air_product_2; // d_vy_dot_d_vx
    j[7] = part_of_d_vy_dot_d_vy; // d_vy_dot_d_vy
    j[8] = minus_air_velocity_y_air_product_2_2; // d_vy_dot_d_vz
    j[9] = minus_air_velocity_z_air_product_2; // d_vz_dot_d_vx
    j[10] = minus_air_velocity_y_air_product_2_3; // d_vz_dot_d_vy
    j[11] = part_of_d_vz_dot_d_vz; // d_vz_dot_d_vz
}
