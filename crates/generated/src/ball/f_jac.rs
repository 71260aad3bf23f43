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
    let wind_y = parameters[6];
    let vy = state[4];

    // ball.hyz:41  let air_velocity = velocity - air;
    let minus_air_velocity_y = wind_y - vy;
    let vx = state[3];
    let wind_x = parameters[5];
    let air_velocity_x = vx - wind_x;
    let wind_z = parameters[7];
    let vz = state[5];
    let minus_air_velocity_z = wind_z - vz;
    let minus_air_velocity_y_sq = minus_air_velocity_y * minus_air_velocity_y;
    let minus_air_velocity_z_sq = minus_air_velocity_z * minus_air_velocity_z;
    let part_of_V =
        air_velocity_x.mul_add(air_velocity_x, minus_air_velocity_y_sq) + minus_air_velocity_z_sq;

    // ball.hyz:42  let V = norm(air_velocity);
    let V = part_of_V.sqrt();
    let inv_V = V.recip_or_zero();
    let half_pi_C_D_rho_product = prepared[0];
    let V_half_part_part_product = half_pi_C_D_rho_product * V;
    dx[4] = minus_air_velocity_y * V_half_part_part_product;
    let g = parameters[3];

    // ball.hyz:30  velocity (vx, vy, vz) in N;
    let vz_dot = minus_air_velocity_z.mul_sub(V_half_part_part_product, g);
    dx[5] = vz_dot;
    let vx_dot = -(air_velocity_x * V_half_part_part_product);
    dx[3] = vx_dot;
    let inv_V_half_pi_C_D_product = half_pi_C_D_rho_product * inv_V;
    let air_velocity_x_inv_product = air_velocity_x * inv_V_half_pi_C_D_product;
    let minus_air_velocity_product =
        minus_air_velocity_y * minus_air_velocity_z * inv_V_half_pi_C_D_product;
    let d_vy_dot_d_vy =
        minus_air_velocity_y_sq.neg_mul_add(inv_V_half_pi_C_D_product, -V_half_part_part_product);
    j[7] = d_vy_dot_d_vy;
    let d_vz_dot_d_vz =
        minus_air_velocity_z_sq.neg_mul_add(inv_V_half_pi_C_D_product, -V_half_part_part_product);
    j[11] = d_vz_dot_d_vz;
    let d_vx_dot_d_vx =
        air_velocity_x.neg_mul_add(air_velocity_x_inv_product, -V_half_part_part_product);
    j[3] = d_vx_dot_d_vx;
    let d_vx_dot_d_vy = minus_air_velocity_y * air_velocity_x_inv_product;
    j[4] = d_vx_dot_d_vy;
    j[6] = d_vx_dot_d_vy; // d_vy_dot_d_vx
    let d_vx_dot_d_vz = minus_air_velocity_z * air_velocity_x_inv_product;
    j[5] = d_vx_dot_d_vz;
    j[9] = d_vx_dot_d_vz; // d_vz_dot_d_vx
    let d_vy_dot_d_vz = -minus_air_velocity_product;
    j[8] = d_vy_dot_d_vz;
    j[10] = d_vy_dot_d_vz; // d_vz_dot_d_vy

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    j[0] = T::splat(1.0); // d_x_dot_d_vx
    j[1] = T::splat(1.0); // d_y_dot_d_vy
    j[2] = T::splat(1.0); // d_z_dot_d_vz
}
