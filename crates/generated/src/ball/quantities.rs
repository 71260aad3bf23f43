// Written by `hyzer generate`; changes belong in the model.
//! `ball`: the named quantities.

use lanes::Real;

/// Every named quantity, see `QUANTITIES`.
///
/// 10 operations: 5 add, 4 mul, 1 sqrt.
/// `prepare` takes 6 operations for it.
#[inline(always)]
pub fn quantities<T: Real>(
    _time: T,
    state: &[T; 6],
    parameters: &[T; 11],
    prepared: &[T; 8],
    values: &mut [T; 11],
) {
    let vz = state[5];
    let wind_z = parameters[7];

    // ball.hyz:41  let air_velocity = velocity - air;
    let air_velocity_z = vz - wind_z;
    values[7] = air_velocity_z;
    let vy = state[4];
    let wind_y = parameters[6];
    let air_velocity_y = vy - wind_y;
    values[6] = air_velocity_y;
    let vx = state[3];
    let wind_x = parameters[5];
    let air_velocity_x = vx - wind_x;
    values[5] = air_velocity_x;
    let part_of_V_sq = air_velocity_y.mul_add(air_velocity_y, air_velocity_z * air_velocity_z);
    let V_sq = air_velocity_x.mul_add(air_velocity_x, part_of_V_sq);

    // ball.hyz:42  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    values[8] = V;
    let C_D_half_pi_radius_product = prepared[7];
    values[10] = C_D_half_pi_radius_product * V_sq;

    values[0] = wind_x;
    values[1] = wind_y;
    values[2] = wind_z;
    let rho = parameters[2];
    values[3] = rho;
    let g = parameters[3];
    values[4] = g;
    let A = prepared[6];
    values[9] = A;
}
