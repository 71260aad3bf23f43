// Written by `hyzer generate`; changes belong in the model.
//! `ball`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 53 operations: 9 add, 33 mul, 1 div, 9 neg, 1 sqrt.
/// `prepare` takes 11 operations for it.
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
    let wind_y = parameters[6];
    let vy = state[4];

    // ball.hyz:41  let air_velocity = velocity - air;
    let minus_air_velocity_y = wind_y - vy;
    let wind_x = parameters[5];
    let vx = state[3];
    let minus_air_velocity_x = wind_x - vx;
    let wind_z = parameters[7];
    let vz = state[5];
    let minus_air_velocity_z = wind_z - vz;
    let minus_air_velocity_y_sq = minus_air_velocity_y * minus_air_velocity_y;
    let minus_air_velocity_z_sq = minus_air_velocity_z * minus_air_velocity_z;
    let part_of_V = minus_air_velocity_x.mul_add(minus_air_velocity_x, minus_air_velocity_y_sq);

    // ball.hyz:42  let V = norm(air_velocity);
    let V = (part_of_V + minus_air_velocity_z_sq).sqrt();
    let inv_V = V.recip_or_zero();
    let C_D_rho_pi_radius_inv_part = prepared[3];
    let V_C_D_rho_pi_radius_inv_part = C_D_rho_pi_radius_inv_part * V;
    let radius_half = prepared[1];
    let V_radius_half = radius_half * V;
    let half_pi_C_D_rho_product = prepared[0];
    let V_half_part_part_product = half_pi_C_D_rho_product * V;
    let half_radius_inv_m = prepared[4];
    let V_C_D_rho_pi_radius_product = half_radius_inv_m * V_C_D_rho_pi_radius_inv_part;
    let d_vx_dot_d_radius = minus_air_velocity_x * V_C_D_rho_pi_radius_inv_part;
    jp[1] = d_vx_dot_d_radius;
    let C_D_pi_radius_inv_m = prepared[5];
    let V_radius_half_C_D_product = C_D_pi_radius_inv_m * V_radius_half;
    let rho_pi_radius_inv_m = prepared[2];
    let rho_pi_radius_inv_m_product = rho_pi_radius_inv_m * V_radius_half;
    dx[3] = minus_air_velocity_x * V_half_part_part_product;
    dx[4] = minus_air_velocity_y * V_half_part_part_product;
    let g = parameters[3];

    // ball.hyz:30  velocity (vx, vy, vz) in N;
    let vz_dot = minus_air_velocity_z.mul_sub(V_half_part_part_product, g);
    dx[5] = vz_dot;
    let d_vy_dot_d_radius = minus_air_velocity_y * V_C_D_rho_pi_radius_inv_part;
    jp[8] = d_vy_dot_d_radius;
    let d_vz_dot_d_radius = minus_air_velocity_z * V_C_D_rho_pi_radius_inv_part;
    jp[15] = d_vz_dot_d_radius;
    jp[2] = minus_air_velocity_x * V_radius_half_C_D_product; // d_vx_dot_d_rho
    jp[3] = minus_air_velocity_x * rho_pi_radius_inv_m_product; // d_vx_dot_d_C_D
    jp[9] = minus_air_velocity_y * V_radius_half_C_D_product; // d_vy_dot_d_rho
    jp[16] = minus_air_velocity_z * V_radius_half_C_D_product; // d_vz_dot_d_rho
    jp[10] = minus_air_velocity_y * rho_pi_radius_inv_m_product; // d_vy_dot_d_C_D
    jp[18] = minus_air_velocity_z * rho_pi_radius_inv_m_product; // d_vz_dot_d_C_D
    let d_vx_dot_d_m = -(minus_air_velocity_x * V_C_D_rho_pi_radius_product);
    jp[0] = d_vx_dot_d_m;
    let d_vy_dot_d_m = -(minus_air_velocity_y * V_C_D_rho_pi_radius_product);
    jp[7] = d_vy_dot_d_m;
    let inv_V_half_pi_C_D_product = half_pi_C_D_rho_product * inv_V;
    let d_vz_dot_d_m = -(minus_air_velocity_z * V_C_D_rho_pi_radius_product);
    jp[14] = d_vz_dot_d_m;
    let minus_air_velocity_product = minus_air_velocity_x * inv_V_half_pi_C_D_product;
    let minus_d_vy_dot_d_vy =
        minus_air_velocity_y_sq.mul_add(inv_V_half_pi_C_D_product, V_half_part_part_product);
    jp[12] = minus_d_vy_dot_d_vy; // d_vy_dot_d_wind_y
    let d_vy_dot_d_wind_z = minus_air_velocity_y * minus_air_velocity_z * inv_V_half_pi_C_D_product;
    jp[13] = d_vy_dot_d_wind_z;
    jp[20] = d_vy_dot_d_wind_z; // d_vz_dot_d_wind_y
    let minus_d_vz_dot_d_vz =
        minus_air_velocity_z_sq.mul_add(inv_V_half_pi_C_D_product, V_half_part_part_product);
    jp[21] = minus_d_vz_dot_d_vz; // d_vz_dot_d_wind_z
    let minus_d_vx_dot_d_vx =
        minus_air_velocity_x.mul_add(minus_air_velocity_product, V_half_part_part_product);
    jp[4] = minus_d_vx_dot_d_vx; // d_vx_dot_d_wind_x
    let d_vx_dot_d_wind_y = minus_air_velocity_y * minus_air_velocity_product;
    jp[5] = d_vx_dot_d_wind_y;
    jp[11] = d_vx_dot_d_wind_y; // d_vy_dot_d_wind_x
    let d_vx_dot_d_wind_z = minus_air_velocity_z * minus_air_velocity_product;
    jp[6] = d_vx_dot_d_wind_z;
    jp[19] = d_vx_dot_d_wind_z; // d_vz_dot_d_wind_x
    let d_vy_dot_d_vy = -minus_d_vy_dot_d_vy;
    j[7] = d_vy_dot_d_vy;
    let d_vy_dot_d_vz = -d_vy_dot_d_wind_z;
    j[8] = d_vy_dot_d_vz;
    j[10] = d_vy_dot_d_vz; // d_vz_dot_d_vy
    let d_vz_dot_d_vz = -minus_d_vz_dot_d_vz;
    j[11] = d_vz_dot_d_vz;
    let d_vx_dot_d_vx = -minus_d_vx_dot_d_vx;
    j[3] = d_vx_dot_d_vx;
    let d_vx_dot_d_vy = -d_vx_dot_d_wind_y;
    j[4] = d_vx_dot_d_vy;
    j[6] = d_vx_dot_d_vy; // d_vy_dot_d_vx
    let d_vx_dot_d_vz = -d_vx_dot_d_wind_z;
    j[5] = d_vx_dot_d_vz;
    j[9] = d_vx_dot_d_vz; // d_vz_dot_d_vx

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    j[0] = T::splat(1.0); // d_x_dot_d_vx
    j[1] = T::splat(1.0); // d_y_dot_d_vy
    j[2] = T::splat(1.0); // d_z_dot_d_vz
    jp[17] = T::splat(-1.0); // d_vz_dot_d_g
}
