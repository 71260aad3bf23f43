// Written by `hyzer generate`; changes belong in the model.
//! `ball`: derivatives of the states.

use lanes::Real;

/// Derivatives `dx` of the states.
///
/// 14 operations: 6 add, 7 mul, 1 sqrt.
/// `prepare` takes 7 operations for it.
#[inline(always)]
pub fn f<T: Real>(
    _time: T,
    state: &[T; 6],
    parameters: &[T; 11],
    prepared: &[T; 8],
    dx: &mut [T; 6],
) {
    let wind_z = parameters[7];
    let vz = state[5];

    // ball.hyz:41  let air_velocity = velocity - air;
    let minus_air_velocity_z = wind_z - vz;
    let wind_y = parameters[6];
    let vy = state[4];
    let minus_air_velocity_y = wind_y - vy;
    let wind_x = parameters[5];
    let vx = state[3];
    let minus_air_velocity_x = wind_x - vx;
    let part_of_V = minus_air_velocity_z * minus_air_velocity_z;
    let part_of_V_2 = minus_air_velocity_y.mul_add(minus_air_velocity_y, part_of_V);
    let part_of_V_3 = minus_air_velocity_x.mul_add(minus_air_velocity_x, part_of_V_2);

    // ball.hyz:42  let V = norm(air_velocity);
    let V = part_of_V_3.sqrt();
    let half_pi_C_D_rho_product = prepared[0];
    let V_half_pi_C_D_rho_product = half_pi_C_D_rho_product * V;
    dx[3] = minus_air_velocity_x * V_half_pi_C_D_rho_product;
    dx[4] = minus_air_velocity_y * V_half_pi_C_D_rho_product;
    let g = parameters[3];

    // ball.hyz:30  velocity (vx, vy, vz) in N;
    let vz_dot = minus_air_velocity_z.mul_sub(V_half_pi_C_D_rho_product, g);
    dx[5] = vz_dot;

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
}
