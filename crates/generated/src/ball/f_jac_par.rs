// Written by `hyzer generate`; changes belong in the model.
//! `ball`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 56 operations: 9 add, 33 mul, 1 div, 12 neg, 1 sqrt.
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
    let minus_vx_plus_wind_x = wind_x - vx;
    let minus_vy_plus_wind_y = wind_y - vy;
    let minus_vy_plus_wind_y_sq = minus_vy_plus_wind_y * minus_vy_plus_wind_y;
    let minus_vz_plus_wind_z = wind_z - vz;
    let minus_vz_plus_wind_z_sq = minus_vz_plus_wind_z * minus_vz_plus_wind_z;
    let part_of_V = minus_vx_plus_wind_x * minus_vx_plus_wind_x + minus_vy_plus_wind_y_sq;

    // ball.hyz:34  let V = norm(air_velocity);
    let V = (part_of_V + minus_vz_plus_wind_z_sq).sqrt();
    let V_radius_half_C_D_part_part = half_pi_p4_p2_p1_p1_inv_p0 * V;

    // ball.hyz:30  velocity (vx, vy, vz) in N;
    let vz_dot = minus_vz_plus_wind_z * V_radius_half_C_D_part_part - g;
    let inv_V = V.recip_or_zero();
    let inv_V_radius_half_C_product = half_pi_p4_p2_p1_p1_inv_p0 * inv_V;
    let minus_vx_plus_wind_product = minus_vx_plus_wind_x * inv_V_radius_half_C_product;
    let V_radius_half_C_D_part_sum =
        V_radius_half_C_D_part_part + minus_vx_plus_wind_x * minus_vx_plus_wind_product;
    let minus_vy_plus_wind_product = minus_vy_plus_wind_y * minus_vx_plus_wind_product;
    let minus_vz_plus_wind_product = minus_vz_plus_wind_z * minus_vx_plus_wind_product;
    let V_radius_half_C_D_part_sum_2 =
        V_radius_half_C_D_part_part + minus_vy_plus_wind_y_sq * inv_V_radius_half_C_product;
    let minus_vy_plus_wind_product_2 =
        minus_vy_plus_wind_y * minus_vz_plus_wind_z * inv_V_radius_half_C_product;
    let V_radius_half_C_D_part_sum_3 =
        V_radius_half_C_D_part_part + minus_vz_plus_wind_z_sq * inv_V_radius_half_C_product;
    let V_C_D_rho_part_part = p4_p2_pi_p1_inv_part * V;
    let V_C_D_rho_part_part_product = half_p1_inv_p0 * V_C_D_rho_part_part;
    let V_radius_half = p1_half * V;
    let V_radius_half_C_D_product = p4_pi_p1_inv_p0 * V_radius_half;
    let rho_pi_part_part_V_product = p2_pi_p1_inv_p0 * V_radius_half;
    let minus_V_radius_half_C_D_part_sum = -V_radius_half_C_D_part_sum;
    let minus_minus_vy_plus_wind_product = -minus_vy_plus_wind_product;
    let minus_minus_vz_plus_wind_product = -minus_vz_plus_wind_product;
    let minus_minus_vy_plus_wind_product_2 = -minus_vy_plus_wind_product;
    let minus_V_radius_half_C_D_part_sum_2 = -V_radius_half_C_D_part_sum_2;
    let minus_minus_vy_plus_wind_product_2_2 = -minus_vy_plus_wind_product_2;
    let minus_minus_vz_plus_wind_product_2 = -minus_vz_plus_wind_product;
    let minus_minus_vy_plus_wind_product_2_3 = -minus_vy_plus_wind_product_2;
    let minus_V_radius_half_C_D_part_sum_3 = -V_radius_half_C_D_part_sum_3;
    let minus_minus_vx_plus_wind_product = -(minus_vx_plus_wind_x * V_C_D_rho_part_part_product);
    let minus_minus_vy_plus_wind_product_3 = -(minus_vy_plus_wind_y * V_C_D_rho_part_part_product);
    let minus_minus_vz_plus_wind_product_3 = -(minus_vz_plus_wind_z * V_C_D_rho_part_part_product);

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    dx[3] = minus_vx_plus_wind_x * V_radius_half_C_D_part_part;
    dx[4] = minus_vy_plus_wind_y * V_radius_half_C_D_part_part;
    dx[5] = vz_dot;

    j[0] = T::splat(1.0); // d_x_dot_d_vx
    j[1] = T::splat(1.0); // d_y_dot_d_vy
    j[2] = T::splat(1.0); // d_z_dot_d_vz
    j[3] = minus_V_radius_half_C_D_part_sum; // d_vx_dot_d_vx
    j[4] = minus_minus_vy_plus_wind_product; // d_vx_dot_d_vy
    j[5] = minus_minus_vz_plus_wind_product; // d_vx_dot_d_vz
    j[6] = minus_minus_vy_plus_wind_product_2; // d_vy_dot_d_vx
    j[7] = minus_V_radius_half_C_D_part_sum_2; // d_vy_dot_d_vy
    j[8] = minus_minus_vy_plus_wind_product_2_2; // d_vy_dot_d_vz
    j[9] = minus_minus_vz_plus_wind_product_2; // d_vz_dot_d_vx
    j[10] = minus_minus_vy_plus_wind_product_2_3; // d_vz_dot_d_vy
    j[11] = minus_V_radius_half_C_D_part_sum_3; // d_vz_dot_d_vz

    jp[0] = minus_minus_vx_plus_wind_product; // d_vx_dot_d_m
    jp[1] = minus_vx_plus_wind_x * V_C_D_rho_part_part; // d_vx_dot_d_radius
    jp[2] = minus_vx_plus_wind_x * V_radius_half_C_D_product; // d_vx_dot_d_rho
    jp[3] = minus_vx_plus_wind_x * rho_pi_part_part_V_product; // d_vx_dot_d_C_D
    jp[4] = V_radius_half_C_D_part_sum; // d_vx_dot_d_wind_x
    jp[5] = minus_vy_plus_wind_product; // d_vx_dot_d_wind_y
    jp[6] = minus_vz_plus_wind_product; // d_vx_dot_d_wind_z
    jp[7] = minus_minus_vy_plus_wind_product_3; // d_vy_dot_d_m
    jp[8] = minus_vy_plus_wind_y * V_C_D_rho_part_part; // d_vy_dot_d_radius
    jp[9] = minus_vy_plus_wind_y * V_radius_half_C_D_product; // d_vy_dot_d_rho
    jp[10] = minus_vy_plus_wind_y * rho_pi_part_part_V_product; // d_vy_dot_d_C_D
    jp[11] = minus_vy_plus_wind_product; // d_vy_dot_d_wind_x
    jp[12] = V_radius_half_C_D_part_sum_2; // d_vy_dot_d_wind_y
    jp[13] = minus_vy_plus_wind_product_2; // d_vy_dot_d_wind_z
    jp[14] = minus_minus_vz_plus_wind_product_3; // d_vz_dot_d_m
    jp[15] = minus_vz_plus_wind_z * V_C_D_rho_part_part; // d_vz_dot_d_radius
    jp[16] = minus_vz_plus_wind_z * V_radius_half_C_D_product; // d_vz_dot_d_rho
    jp[17] = T::splat(-1.0); // d_vz_dot_d_g
    jp[18] = minus_vz_plus_wind_z * rho_pi_part_part_V_product; // d_vz_dot_d_C_D
    jp[19] = minus_vz_plus_wind_product; // d_vz_dot_d_wind_x
    jp[20] = minus_vy_plus_wind_product_2; // d_vz_dot_d_wind_y
    jp[21] = V_radius_half_C_D_part_sum_3; // d_vz_dot_d_wind_z
}
