// Written by `hyzer generate`; changes belong in the model.
//! `ball`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 32 operations: 9 add, 16 mul, 1 div, 5 neg, 1 sqrt.
/// `prepare` takes 7 operations for it.
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
    let half_pi_C_D_rho_product = prepared[0];

    // ball.hyz:33  let air_velocity = velocity - wind;
    let air_velocity_x = vx - wind_x;
    let minus_air_velocity_y = wind_y - vy;
    let minus_air_velocity_y_sq = minus_air_velocity_y * minus_air_velocity_y;
    let minus_air_velocity_z = wind_z - vz;
    let minus_air_velocity_z_sq = minus_air_velocity_z * minus_air_velocity_z;
    let part_of_V =
        air_velocity_x * air_velocity_x + minus_air_velocity_y_sq + minus_air_velocity_z_sq;

    // ball.hyz:34  let V = norm(air_velocity);
    let V = part_of_V.sqrt();
    let V_half_part_part_product = half_pi_C_D_rho_product * V;

    // ball.hyz:30  velocity (vx, vy, vz) in N;
    let vz_dot = minus_air_velocity_z * V_half_part_part_product - g;
    let inv_V = V.recip_or_zero();
    let inv_V_half_pi_C_D_product = half_pi_C_D_rho_product * inv_V;
    let air_velocity_x_inv_product = air_velocity_x * inv_V_half_pi_C_D_product;
    let d_vx_dot_d_vx = -V_half_part_part_product - air_velocity_x * air_velocity_x_inv_product;
    let d_vx_dot_d_vy = minus_air_velocity_y * air_velocity_x_inv_product;
    let d_vx_dot_d_vz = minus_air_velocity_z * air_velocity_x_inv_product;
    let d_vy_dot_d_vy =
        -V_half_part_part_product - minus_air_velocity_y_sq * inv_V_half_pi_C_D_product;
    let minus_air_velocity_product =
        minus_air_velocity_y * minus_air_velocity_z * inv_V_half_pi_C_D_product;
    let d_vz_dot_d_vz =
        -V_half_part_part_product - minus_air_velocity_z_sq * inv_V_half_pi_C_D_product;
    let vx_dot = -(air_velocity_x * V_half_part_part_product);
    let d_vy_dot_d_vz = -minus_air_velocity_product;

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    dx[3] = vx_dot;
    dx[4] = minus_air_velocity_y * V_half_part_part_product;
    dx[5] = vz_dot;

    j[0] = T::splat(1.0); // d_x_dot_d_vx
    j[1] = T::splat(1.0); // d_y_dot_d_vy
    j[2] = T::splat(1.0); // d_z_dot_d_vz
    j[3] = d_vx_dot_d_vx;
    j[4] = d_vx_dot_d_vy;
    j[5] = d_vx_dot_d_vz;
    j[6] = d_vx_dot_d_vy; // d_vy_dot_d_vx
    j[7] = d_vy_dot_d_vy;
    j[8] = d_vy_dot_d_vz;
    j[9] = d_vx_dot_d_vz; // d_vz_dot_d_vx
    j[10] = d_vy_dot_d_vz; // d_vz_dot_d_vy
    j[11] = d_vz_dot_d_vz;
}
