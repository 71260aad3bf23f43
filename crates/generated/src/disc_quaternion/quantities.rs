// Written by `hyzer generate`; changes belong in the model.
//! `disc_quaternion`: the named quantities.

use lanes::Real;

/// Every named quantity, see `QUANTITIES`.
///
/// 89 operations: 28 add, 54 mul, 2 div, 2 neg, 2 sqrt, 1 call.
/// `prepare` takes 4 operations for it.
#[inline(always)]
pub fn quantities<T: Real>(
    _time: T,
    state: &[T; 13],
    parameters: &[T; 18],
    prepared: &[T; 18],
    values: &mut [T; 34],
) {
    let q0 = state[6];
    let q1 = state[7];
    let q0_q1 = q0 * q1;
    let q2 = state[8];
    let q3 = state[9];
    let q2_q3 = q2 * q3;
    let vz = state[5];
    let wind_z = parameters[17];
    let minus_wind_z_plus_vz = vz - wind_z;
    let q0_q3 = q0 * q3;
    let q2_q1 = q2 * q1;
    let vx = state[3];
    let wind_x = parameters[15];
    let minus_wind_x_plus_vx = vx - wind_x;
    let q2_sq_two_minus_one = q2.mul_sub(T::splat(2.0) * q2, T::splat(1.0));
    let q2_q0 = q2 * q0;
    let q3_sq_two = T::splat(2.0) * q3 * q3;
    let q3_q1 = q3 * q1;
    let q1_sq_two = T::splat(2.0) * q1 * q1;
    let vy = state[4];
    let wind_y = parameters[16];
    let minus_wind_y_plus_vy = vy - wind_y;
    let part_of_air_velocity_2 =
        minus_wind_x_plus_vx.mul_add(q2_q1 - q0_q3, minus_wind_z_plus_vz * (q0_q1 + q2_q3));
    let part_of_air_velocity_2_3 = q3_sq_two - T::splat(1.0) + q1_sq_two;
    let part_of_air_velocity_1 = (q3_sq_two + q2_sq_two_minus_one) * minus_wind_x_plus_vx;
    let part_of_air_velocity_2_2 = T::splat(2.0) * part_of_air_velocity_2;
    let part_of_minus_air_velocity_3 =
        minus_wind_x_plus_vx.mul_add(q2_q0 + q3_q1, minus_wind_y_plus_vy * (q2_q3 - q0_q1));
    let part_of_minus_air_velocity_3_2 = minus_wind_z_plus_vz * (q1_sq_two + q2_sq_two_minus_one);
    let part_of_air_velocity_1_2 =
        minus_wind_y_plus_vy.neg_mul_add(T::splat(2.0) * (q0_q3 + q2_q1), part_of_air_velocity_1);
    let C_Nr = parameters[14];
    let r = state[12];

    // disc_quaternion.hyz:91  let spin_down = C_Nr*r;
    let spin_down = C_Nr * r;
    values[33] = spin_down;

    // disc_quaternion.hyz:68  let air_velocity = in_C(velocity - air);
    let air_velocity_2 =
        minus_wind_y_plus_vy.neg_mul_add(part_of_air_velocity_2_3, part_of_air_velocity_2_2);
    values[10] = air_velocity_2;
    let minus_air_velocity_3 =
        T::splat(2.0).neg_mul_add(part_of_minus_air_velocity_3, part_of_minus_air_velocity_3_2);
    let air_velocity_1 =
        minus_wind_z_plus_vz.mul_sub(T::splat(2.0) * (q3_q1 - q2_q0), part_of_air_velocity_1_2);
    values[9] = air_velocity_1;
    let air_velocity_3 = -minus_air_velocity_3;
    values[11] = air_velocity_3;
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let p = state[10];
    let q = state[11];
    let air_velocity_2_q_plus_sum = air_velocity_1.mul_add(p, air_velocity_2 * q);
    let air_velocity_1_q_minus_sum = air_velocity_2.neg_mul_add(p, air_velocity_1 * q);
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);

    // disc_quaternion.hyz:70  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    values[15] = V;
    let A_rho_half = prepared[16];
    let V_sq_A_rho_half = A_rho_half * V_sq;
    let rho_half = prepared[15];
    values[23] = rho_half * V_sq;
    let d = parameters[3];
    let d_V_sq_A_rho_half = d * V_sq_A_rho_half;

    // disc_quaternion.hyz:75  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    values[22] = alpha;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let inv_V = V.recip_or_zero();
    let C_Mq = parameters[12];
    let inv_air_velocity_12_C_Mq = C_Mq * inv_air_velocity_12;

    // disc_quaternion.hyz:71  let d1 = unit(air_velocity - dot(air_velocity, d3)*d3);
    let d1_2 = air_velocity_2 * inv_air_velocity_12;
    values[17] = d1_2;
    let d1_1 = air_velocity_1 * inv_air_velocity_12;
    values[16] = d1_1;
    values[20] = d1_1;

    // disc_quaternion.hyz:85  let rate_1 = dot(angular_velocity, d1);
    let rate_1 = inv_air_velocity_12 * air_velocity_2_q_plus_sum;
    values[28] = rate_1;
    values[29] = inv_air_velocity_12 * air_velocity_1_q_minus_sum;
    let C_Rr = parameters[13];
    let part_of_roll = air_velocity_2_q_plus_sum.mul_add(inv_air_velocity_12_C_Mq, C_Rr * r);
    let half_d = prepared[17];
    values[30] = half_d * r * inv_V;
    let d2_1 = -d1_2;
    values[19] = d2_1;
    values[31] = part_of_roll * d_V_sq_A_rho_half;
    let C_Ma = parameters[11];
    let part_of_pitch = C_Ma.mul_add(alpha, air_velocity_1_q_minus_sum * inv_air_velocity_12_C_Mq);
    let C_La = parameters[8];
    let C_L0 = parameters[7];

    // disc_quaternion.hyz:79  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La.mul_add(alpha, C_L0);
    values[24] = C_L;
    let C_Da = parameters[10];
    let C_D0 = parameters[9];

    // disc_quaternion.hyz:80  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = alpha.mul_add(C_Da * alpha, C_D0);
    values[25] = C_D;
    values[32] = part_of_pitch * d_V_sq_A_rho_half;
    values[26] = C_L * V_sq_A_rho_half;
    values[27] = C_D * V_sq_A_rho_half;

    values[0] = wind_x;
    values[1] = wind_y;
    values[2] = wind_z;
    let rho = parameters[5];
    values[3] = rho;
    let g = parameters[6];
    values[4] = g;
    let I_d = parameters[2];
    values[5] = I_d;
    values[6] = I_d;
    values[7] = T::splat(0.0);
    values[8] = T::splat(0.0);
    values[12] = T::splat(0.0);
    values[13] = T::splat(0.0);
    values[14] = T::splat(1.0);
    values[18] = T::splat(0.0);
    values[21] = T::splat(0.0);
}
