// Written by `hyzer generate`; changes belong in the model.
//! `ball`: derivatives of the states.

use lanes::Real;

/// Derivatives `dx` of the states.
///
/// 17 operations: 6 add, 7 mul, 3 neg, 1 sqrt.
#[inline(always)]
pub fn f<T: Real>(
    _time: T,
    state: &[T; 6],
    parameters: &[T; 11],
    prepared: &[T; 8],
    dx: &mut [T; 6],
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
    let air_velocity_z = vz - wind_z;
    let air_velocity_y = vy - wind_y;
    let part_of_sqrt_air_velocity_z_sq_of =
        air_velocity_z * air_velocity_z + air_velocity_y * air_velocity_y;
    let part_of_sqrt_air_velocity_z_sq_of_2 =
        part_of_sqrt_air_velocity_z_sq_of + air_velocity_x * air_velocity_x;
    let sqrt_air_velocity_z_sq_of = part_of_sqrt_air_velocity_z_sq_of_2.sqrt();
    let sqrt_air_velocity_z_product = half_pi_p4_p2_p1_p1_inv_p0 * sqrt_air_velocity_z_sq_of;

    // ball.hyz:30  velocity (vx, vy, vz) in N;
    let vz_dot = -g - air_velocity_z * sqrt_air_velocity_z_product;
    let minus_air_velocity_x_sqrt_product = -(air_velocity_x * sqrt_air_velocity_z_product);
    let minus_air_velocity_y_sqrt_product = -(air_velocity_y * sqrt_air_velocity_z_product);

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    dx[3] = minus_air_velocity_x_sqrt_product;
    dx[4] = minus_air_velocity_y_sqrt_product;
    dx[5] = vz_dot;
}
