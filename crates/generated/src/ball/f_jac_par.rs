// Written by `hyzer generate`; changes belong in the model.
//! `ball`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 68 operations: 9 add, 33 mul, 1 div, 24 neg, 1 sqrt.
#[inline(always)]
pub fn f_jac_par<T: Real>(
    _time: T,
    state: &[T; 6],
    parameters: &[T; 11],
    prepared: &[T; 8],
    dx: &mut [T; 6],
    j: &mut [T; 12],
    jp: &mut [T; 22],
) {
    let vx = state[3];
    let vy = state[4];
    let vz = state[5];
    let g = parameters[3];
    let wind_x = parameters[5];
    let wind_y = parameters[6];
    let wind_z = parameters[7];
    let half_pi_p4_p2_p1_p1_inv_p0 = prepared[0];
    let p1_half = prepared[1];
    let p2_pi_p1_inv_p0 = prepared[2];
    let p4_p2_pi_p1_inv_part = prepared[3];
    let half_p1_inv_p0 = prepared[4];
    let p4_pi_p1_inv_p0 = prepared[5];

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
    let minus_sqrt_air_velocity_sum =
        -sqrt_air_velocity_x_product - air_velocity_x * air_velocity_x_inv_product;
    let air_velocity_y_air_product = air_velocity_y * air_velocity_x_inv_product;
    let air_velocity_z_air_product = air_velocity_z * air_velocity_x_inv_product;
    let minus_sqrt_air_velocity_sum_2 =
        -sqrt_air_velocity_x_product - air_velocity_y_sq * inv_sqrt_air_product;
    let air_velocity_y_air_product_2 = air_velocity_y * air_velocity_z * inv_sqrt_air_product;
    let minus_sqrt_air_velocity_sum_3 =
        -sqrt_air_velocity_x_product - air_velocity_z_sq * inv_sqrt_air_product;
    let sqrt_air_velocity_x_product_2 = p4_p2_pi_p1_inv_part * sqrt_air_velocity_x_sq_of;
    let sqrt_air_velocity_x_product_3 = half_p1_inv_p0 * sqrt_air_velocity_x_product_2;
    let sqrt_air_velocity_x_product_4 = p1_half * sqrt_air_velocity_x_sq_of;
    let sqrt_air_velocity_x_product_5 = p4_pi_p1_inv_p0 * sqrt_air_velocity_x_product_4;
    let rho_pi_part_part_product = p2_pi_p1_inv_p0 * sqrt_air_velocity_x_product_4;
    let minus_minus_sqrt_air_sum = -minus_sqrt_air_velocity_sum;
    let minus_minus_sqrt_air_sum_2 = -minus_sqrt_air_velocity_sum_2;
    let minus_minus_sqrt_air_sum_3 = -minus_sqrt_air_velocity_sum_3;
    let minus_air_velocity_x_sqrt_product = -(air_velocity_x * sqrt_air_velocity_x_product);
    let minus_air_velocity_y_sqrt_product = -(air_velocity_y * sqrt_air_velocity_x_product);
    let minus_air_velocity_y_air_product = -air_velocity_y_air_product;
    let minus_air_velocity_z_air_product = -air_velocity_z_air_product;
    let minus_air_velocity_y_air_product_2 = -air_velocity_y_air_product;
    let minus_air_velocity_y_air_product_2_2 = -air_velocity_y_air_product_2;
    let minus_air_velocity_z_air_product_2 = -air_velocity_z_air_product;
    let minus_air_velocity_y_air_product_2_3 = -air_velocity_y_air_product_2;
    let minus_air_velocity_x_sqrt_product_2 = -(air_velocity_x * sqrt_air_velocity_x_product_2);
    let minus_air_velocity_x_sqrt_product_3 = -(air_velocity_x * sqrt_air_velocity_x_product_5);
    let minus_air_velocity_x_rho_product = -(air_velocity_x * rho_pi_part_part_product);
    let minus_air_velocity_y_sqrt_product_2 = -(air_velocity_y * sqrt_air_velocity_x_product_2);
    let minus_air_velocity_y_sqrt_product_3 = -(air_velocity_y * sqrt_air_velocity_x_product_5);
    let minus_air_velocity_y_rho_product = -(air_velocity_y * rho_pi_part_part_product);
    let minus_air_velocity_z_sqrt_product = -(air_velocity_z * sqrt_air_velocity_x_product_2);
    let minus_air_velocity_z_sqrt_product_2 = -(air_velocity_z * sqrt_air_velocity_x_product_5);
    let minus_air_velocity_z_rho_product = -(air_velocity_z * rho_pi_part_part_product);

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    dx[3] = minus_air_velocity_x_sqrt_product;
    dx[4] = minus_air_velocity_y_sqrt_product;
    dx[5] = vz_dot;

    j[0] = T::splat(1.0); // d_x_dot_d_vx
    j[1] = T::splat(1.0); // d_y_dot_d_vy
    j[2] = T::splat(1.0); // d_z_dot_d_vz
    j[3] = minus_sqrt_air_velocity_sum; // d_vx_dot_d_vx
    j[4] = minus_air_velocity_y_air_product; // d_vx_dot_d_vy
    j[5] = minus_air_velocity_z_air_product; // d_vx_dot_d_vz
    j[6] = minus_air_velocity_y_air_product_2; // d_vy_dot_d_vx
    j[7] = minus_sqrt_air_velocity_sum_2; // d_vy_dot_d_vy
    j[8] = minus_air_velocity_y_air_product_2_2; // d_vy_dot_d_vz
    j[9] = minus_air_velocity_z_air_product_2; // d_vz_dot_d_vx
    j[10] = minus_air_velocity_y_air_product_2_3; // d_vz_dot_d_vy
    j[11] = minus_sqrt_air_velocity_sum_3; // d_vz_dot_d_vz

    jp[0] = air_velocity_x * sqrt_air_velocity_x_product_3; // d_vx_dot_d_m
    jp[1] = minus_air_velocity_x_sqrt_product_2; // d_vx_dot_d_radius
    jp[2] = minus_air_velocity_x_sqrt_product_3; // d_vx_dot_d_rho
    jp[3] = minus_air_velocity_x_rho_product; // d_vx_dot_d_C_D
    jp[4] = minus_minus_sqrt_air_sum; // d_vx_dot_d_wind_x
    jp[5] = air_velocity_y_air_product; // d_vx_dot_d_wind_y
    jp[6] = air_velocity_z_air_product; // d_vx_dot_d_wind_z
    jp[7] = air_velocity_y * sqrt_air_velocity_x_product_3; // d_vy_dot_d_m
    jp[8] = minus_air_velocity_y_sqrt_product_2; // d_vy_dot_d_radius
    jp[9] = minus_air_velocity_y_sqrt_product_3; // d_vy_dot_d_rho
    jp[10] = minus_air_velocity_y_rho_product; // d_vy_dot_d_C_D
    jp[11] = air_velocity_y_air_product; // d_vy_dot_d_wind_x
    jp[12] = minus_minus_sqrt_air_sum_2; // d_vy_dot_d_wind_y
    jp[13] = air_velocity_y_air_product_2; // d_vy_dot_d_wind_z
    jp[14] = air_velocity_z * sqrt_air_velocity_x_product_3; // d_vz_dot_d_m
    jp[15] = minus_air_velocity_z_sqrt_product; // d_vz_dot_d_radius
    jp[16] = minus_air_velocity_z_sqrt_product_2; // d_vz_dot_d_rho
    jp[17] = T::splat(-1.0); // d_vz_dot_d_g
    jp[18] = minus_air_velocity_z_rho_product; // d_vz_dot_d_C_D
    jp[19] = air_velocity_z_air_product; // d_vz_dot_d_wind_x
    jp[20] = air_velocity_y_air_product_2; // d_vz_dot_d_wind_y
    jp[21] = minus_minus_sqrt_air_sum_3; // d_vz_dot_d_wind_z
}
