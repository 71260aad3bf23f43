// Written by `hyzer generate`; changes belong in the model.
//! `disc_quaternion`: derivatives of the states.

use lanes::Real;

/// Derivatives `dx` of the states.
///
/// 141 operations: 47 add, 88 mul, 1 div, 1 neg, 2 sqrt, 1 call, 1 select.
/// `prepare` takes 11 operations for it.
#[inline(always)]
pub fn f<T: Real>(
    _time: T,
    state: &[T; 13],
    parameters: &[T; 18],
    prepared: &[T; 17],
    dx: &mut [T; 13],
) {
    let vx = state[3];
    let vy = state[4];
    let vz = state[5];
    let q0 = state[6];
    let q1 = state[7];
    let q2 = state[8];
    let q3 = state[9];
    let p = state[10];
    let q = state[11];
    let r = state[12];
    let g = parameters[6];
    let C_L0 = parameters[7];
    let C_La = parameters[8];
    let C_D0 = parameters[9];
    let C_Da = parameters[10];
    let C_Ma = parameters[11];
    let C_Mq = parameters[12];
    let C_Rr = parameters[13];
    let wind_x = parameters[15];
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let inv_m_rho_A = prepared[0];
    let half_d_inv_I_d_rho_A = prepared[1];
    let one_minus_inv_I_d_I_a = prepared[2];
    let C_Nr_inv_I_a = prepared[3];
    let q0_q2 = q0 * q2;
    let q1_q3 = q1 * q3;
    let q0_q2_plus_q1_q3 = q0_q2 + q1_q3;
    let vz_minus_wind_z = vz - wind_z;
    let q1_sq_two = T::splat(2.0) * q1 * q1;
    let q2_sq_two = T::splat(2.0) * q2 * q2;
    let q1_sq_two_minus_one_sum = q1_sq_two - T::splat(1.0) + q2_sq_two;
    let vy_minus_wind_y = vy - wind_y;
    let q1_q0 = q1 * q0;
    let q3_q2 = q3 * q2;
    let minus_q1_q0_plus_q3_q2 = q3_q2 - q1_q0;
    let vx_minus_wind_x = vx - wind_x;
    let part_of_minus_air_velocity_3 =
        vy_minus_wind_y * minus_q1_q0_plus_q3_q2 + vx_minus_wind_x * q0_q2_plus_q1_q3;

    // disc_quaternion.hyz:55  let air_velocity = in_C(velocity - wind);
    let minus_air_velocity_3 =
        vz_minus_wind_z * q1_sq_two_minus_one_sum - T::splat(2.0) * part_of_minus_air_velocity_3;
    let q3_sq_two_minus_one = T::splat(2.0) * q3 * q3 - T::splat(1.0);
    let q1_sq_two_plus_q3_sq_sum = q1_sq_two + q3_sq_two_minus_one;
    let q1_q0_plus_q3_q2 = q1_q0 + q3_q2;
    let q0_q3 = q0 * q3;
    let q1_q2 = q1 * q2;
    let minus_q0_q3_plus_q1_q2 = q1_q2 - q0_q3;
    let part_of_air_velocity_2 =
        q1_q0_plus_q3_q2 * vz_minus_wind_z + minus_q0_q3_plus_q1_q2 * vx_minus_wind_x;
    let air_velocity_2 =
        T::splat(2.0) * part_of_air_velocity_2 - q1_sq_two_plus_q3_sq_sum * vy_minus_wind_y;
    let q2_sq_two_plus_q3_sq_sum = q2_sq_two + q3_sq_two_minus_one;
    let minus_q0_q2_plus_q1_q3 = q1_q3 - q0_q2;
    let q0_q3_plus_q1_q2 = q0_q3 + q1_q2;
    let part_of_minus_air_velocity_1 =
        vz_minus_wind_z * minus_q0_q2_plus_q1_q3 + vy_minus_wind_y * q0_q3_plus_q1_q2;
    let minus_air_velocity_1 =
        vx_minus_wind_x * q2_sq_two_plus_q3_sq_sum - T::splat(2.0) * part_of_minus_air_velocity_1;
    let air_velocity_12_sq =
        air_velocity_2 * air_velocity_2 + minus_air_velocity_1 * minus_air_velocity_1;
    let air_velocity_12 = air_velocity_12_sq.sqrt();

    // disc_quaternion.hyz:62  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);

    // disc_quaternion.hyz:67  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_Da * alpha * alpha + C_D0;

    // disc_quaternion.hyz:66  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La * alpha + C_L0;
    let minus_air_velocity_3_C_sum = minus_air_velocity_3 * C_D + air_velocity_12 * C_L;
    let part_of_vx_dot = T::splat(0.5) * q2_sq_two_plus_q3_sq_sum * minus_air_velocity_1;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let air_velocity_12_C_D_product =
        (air_velocity_12 * C_D - minus_air_velocity_3 * C_L) * inv_air_velocity_12;
    let part_of_vx_dot_2 =
        (minus_q0_q3_plus_q1_q2 * air_velocity_2 + part_of_vx_dot) * air_velocity_12_C_D_product;
    let V_sq = air_velocity_12_sq + minus_air_velocity_3 * minus_air_velocity_3;

    // disc_quaternion.hyz:57  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let V_inv_m_rho_A = inv_m_rho_A * V;

    // disc_quaternion.hyz:50  velocity (vx, vy, vz) in N;
    let vx_dot = (q0_q2_plus_q1_q3 * minus_air_velocity_3_C_sum - part_of_vx_dot_2) * V_inv_m_rho_A;
    let part_of_vy_dot = T::splat(0.5) * q1_sq_two_plus_q3_sq_sum * air_velocity_2;
    let part_of_vy_dot_2 =
        (q0_q3_plus_q1_q2 * minus_air_velocity_1 + part_of_vy_dot) * air_velocity_12_C_D_product;
    let part_of_vy_dot_3 = minus_q1_q0_plus_q3_q2 * minus_air_velocity_3_C_sum + part_of_vy_dot_2;
    let vy_dot = part_of_vy_dot_3 * V_inv_m_rho_A;
    let part_of_vz_dot = T::splat(0.5) * q1_sq_two_minus_one_sum * minus_air_velocity_3_C_sum;
    let part_of_vz_dot_2 =
        q1_q0_plus_q3_q2 * air_velocity_2 - minus_q0_q2_plus_q1_q3 * minus_air_velocity_1;
    let part_of_vz_dot_3 =
        (part_of_vz_dot + part_of_vz_dot_2 * air_velocity_12_C_D_product) * V_inv_m_rho_A;
    let vz_dot = -g - part_of_vz_dot_3;
    let V_sq_half_d_inv_I_d_rho_A = half_d_inv_I_d_rho_A * V_sq;
    let inv_air_velocity_12_product = inv_air_velocity_12 * V_sq_half_d_inv_I_d_rho_A;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12_product;
    let alpha_C_Ma = C_Ma * alpha;
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let V_sq_half_d_inv_I_d_product = V_sq_half_d_inv_I_d_rho_A * (C_Mq * nonzero_air_velocity_12);
    let minus_air_velocity_product = minus_air_velocity_1 * inv_air_velocity_12_product;
    let part_of_p_dot = r * (one_minus_inv_I_d_I_a * q - C_Rr * minus_air_velocity_product);
    let part_of_p_dot_2 = p * V_sq_half_d_inv_I_d_product - air_velocity_2_inv_product * alpha_C_Ma;

    // disc_quaternion.hyz:51  angular velocity (p, q, r) in C;
    let p_dot = part_of_p_dot_2 + part_of_p_dot;
    let part_of_q_dot = r * (one_minus_inv_I_d_I_a * p - C_Rr * air_velocity_2_inv_product);
    let part_of_q_dot_2 = q * V_sq_half_d_inv_I_d_product - minus_air_velocity_product * alpha_C_Ma;
    let q_dot = part_of_q_dot_2 - part_of_q_dot;
    let r_dot = C_Nr_inv_I_a * r;

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    dx[3] = vx_dot;
    dx[4] = vy_dot;
    dx[5] = vz_dot;
    dx[6] = T::splat(-0.5) * (q3 * r + q2 * q + q1 * p);
    dx[7] = T::splat(-0.5) * (q3 * q - q2 * r - q0 * p);
    dx[8] = T::splat(-0.5) * (q1 * r - q3 * p - q0 * q);
    dx[9] = T::splat(-0.5) * (q2 * p - q1 * q - q0 * r);
    dx[10] = p_dot;
    dx[11] = q_dot;
    dx[12] = r_dot;
}
