// Written by `hyzer generate`; changes belong in the model.
//! `disc_quaternion`: derivatives of the states.

use lanes::Real;

/// Derivatives `dx` of the states.
///
/// 141 operations: 47 add, 88 mul, 1 div, 1 neg, 2 sqrt, 1 call, 1 select.
#[inline(always)]
pub fn f<T: Real>(
    _time: T,
    state: &[T; 13],
    parameters: &[T; 18],
    prepared: &[T; 16],
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
    let inv_p0_p5_p4 = prepared[0];
    let half_p3_inv_p2_p5_p4 = prepared[1];
    let n1_minus_inv_p2_p1 = prepared[2];
    let p14_inv_p1 = prepared[3];
    let q0_q2 = q0 * q2;
    let q1_q3 = q1 * q3;
    let q0_q2_plus_q1_q3 = q0_q2 + q1_q3;
    let vz_minus_wind_z = vz - wind_z;
    let q1_sq_two = T::splat(2.0) * q1 * q1;
    let q2_sq_two = T::splat(2.0) * q2 * q2;
    let q1_sq_two_minus_n1_plus_sum = q1_sq_two - T::splat(1.0) + q2_sq_two;
    let vy_minus_wind_y = vy - wind_y;
    let q1_q0 = q1 * q0;
    let q3_q2 = q3 * q2;
    let minus_q1_q0_plus_q3_q2 = q3_q2 - q1_q0;
    let vx_minus_wind_x = vx - wind_x;
    let part_of_vz_minus_wind_z_q1_sum =
        vy_minus_wind_y * minus_q1_q0_plus_q3_q2 + vx_minus_wind_x * q0_q2_plus_q1_q3;
    let part_of_vz_minus_wind_z_q1_sum_2 = T::splat(2.0) * part_of_vz_minus_wind_z_q1_sum;
    let vz_minus_wind_z_q1_sum =
        vz_minus_wind_z * q1_sq_two_minus_n1_plus_sum - part_of_vz_minus_wind_z_q1_sum_2;
    let q3_sq_two_minus_n1 = T::splat(2.0) * q3 * q3 - T::splat(1.0);
    let q1_sq_two_plus_q3_sq_sum = q1_sq_two + q3_sq_two_minus_n1;
    let q1_q0_plus_q3_q2 = q1_q0 + q3_q2;
    let q0_q3 = q0 * q3;
    let q1_q2 = q1 * q2;
    let minus_q0_q3_plus_q1_q2 = q1_q2 - q0_q3;
    let part_of_air_velocity_2 =
        q1_q0_plus_q3_q2 * vz_minus_wind_z + minus_q0_q3_plus_q1_q2 * vx_minus_wind_x;

    // disc_quaternion.hyz:55  let air_velocity = in_C(velocity - wind);
    let air_velocity_2 =
        T::splat(2.0) * part_of_air_velocity_2 - q1_sq_two_plus_q3_sq_sum * vy_minus_wind_y;
    let q2_sq_two_plus_q3_sq_sum = q2_sq_two + q3_sq_two_minus_n1;
    let minus_q0_q2_plus_q1_q3 = q1_q3 - q0_q2;
    let q0_q3_plus_q1_q2 = q0_q3 + q1_q2;
    let part_of_vx_minus_wind_x_q2_sum =
        vz_minus_wind_z * minus_q0_q2_plus_q1_q3 + vy_minus_wind_y * q0_q3_plus_q1_q2;
    let vx_minus_wind_x_q2_sum =
        vx_minus_wind_x * q2_sq_two_plus_q3_sq_sum - T::splat(2.0) * part_of_vx_minus_wind_x_q2_sum;
    let air_velocity_2_sq_plus_sum =
        air_velocity_2 * air_velocity_2 + vx_minus_wind_x_q2_sum * vx_minus_wind_x_q2_sum;
    let sqrt_air_velocity_2_sq_of = air_velocity_2_sq_plus_sum.sqrt();

    // disc_quaternion.hyz:62  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = vz_minus_wind_z_q1_sum.atan2(sqrt_air_velocity_2_sq_of);

    // disc_quaternion.hyz:67  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_Da * alpha * alpha + C_D0;

    // disc_quaternion.hyz:66  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La * alpha + C_L0;
    let vz_minus_wind_z_q1_sum_sum = vz_minus_wind_z_q1_sum * C_D + sqrt_air_velocity_2_sq_of * C_L;
    let part_of_vx_dot = T::splat(0.5) * q2_sq_two_plus_q3_sq_sum * vx_minus_wind_x_q2_sum;
    let part_of_sqrt_air_velocity_2_product =
        sqrt_air_velocity_2_sq_of * C_D - vz_minus_wind_z_q1_sum * C_L;
    let inv_sqrt_air_velocity_2_of = sqrt_air_velocity_2_sq_of.recip_or_zero();
    let sqrt_air_velocity_2_product =
        part_of_sqrt_air_velocity_2_product * inv_sqrt_air_velocity_2_of;
    let part_of_vx_dot_2 =
        (minus_q0_q3_plus_q1_q2 * air_velocity_2 + part_of_vx_dot) * sqrt_air_velocity_2_product;
    let air_velocity_2_sq_plus_sum_2 =
        air_velocity_2_sq_plus_sum + vz_minus_wind_z_q1_sum * vz_minus_wind_z_q1_sum;

    // disc_quaternion.hyz:57  let V = norm(air_velocity);
    let V = air_velocity_2_sq_plus_sum_2.sqrt();
    let V_inv_m_rho_A = inv_p0_p5_p4 * V;

    // disc_quaternion.hyz:50  velocity (vx, vy, vz) in N;
    let vx_dot = (q0_q2_plus_q1_q3 * vz_minus_wind_z_q1_sum_sum - part_of_vx_dot_2) * V_inv_m_rho_A;
    let part_of_vy_dot = T::splat(0.5) * q1_sq_two_plus_q3_sq_sum * air_velocity_2;
    let part_of_vy_dot_2 =
        (q0_q3_plus_q1_q2 * vx_minus_wind_x_q2_sum + part_of_vy_dot) * sqrt_air_velocity_2_product;
    let part_of_vy_dot_3 = minus_q1_q0_plus_q3_q2 * vz_minus_wind_z_q1_sum_sum + part_of_vy_dot_2;
    let vy_dot = part_of_vy_dot_3 * V_inv_m_rho_A;
    let part_of_vz_dot = T::splat(0.5) * q1_sq_two_minus_n1_plus_sum * vz_minus_wind_z_q1_sum_sum;
    let part_of_vz_dot_2 =
        q1_q0_plus_q3_q2 * air_velocity_2 - minus_q0_q2_plus_q1_q3 * vx_minus_wind_x_q2_sum;
    let part_of_vz_dot_3 =
        (part_of_vz_dot + part_of_vz_dot_2 * sqrt_air_velocity_2_product) * V_inv_m_rho_A;
    let vz_dot = -g - part_of_vz_dot_3;
    let air_velocity_2_sq_product = half_p3_inv_p2_p5_p4 * air_velocity_2_sq_plus_sum_2;
    let inv_sqrt_air_product = inv_sqrt_air_velocity_2_of * air_velocity_2_sq_product;
    let air_velocity_2_inv_product = air_velocity_2 * inv_sqrt_air_product;
    let alpha_C_Ma = C_Ma * alpha;
    let nonzero_air_velocity_2_of =
        air_velocity_2_sq_plus_sum.if_zero(T::splat(0.0), T::splat(1.0));
    let air_velocity_2_sq_product_2 =
        air_velocity_2_sq_product * (C_Mq * nonzero_air_velocity_2_of);
    let vx_minus_wind_x_q2_product = vx_minus_wind_x_q2_sum * inv_sqrt_air_product;
    let part_of_p_dot = p * air_velocity_2_sq_product_2 - air_velocity_2_inv_product * alpha_C_Ma;

    // disc_quaternion.hyz:51  angular velocity (p, q, r) in C;
    let p_dot = part_of_p_dot + r * (n1_minus_inv_p2_p1 * q - C_Rr * vx_minus_wind_x_q2_product);
    let part_of_q_dot = q * air_velocity_2_sq_product_2 - vx_minus_wind_x_q2_product * alpha_C_Ma;
    let q_dot = part_of_q_dot - r * (n1_minus_inv_p2_p1 * p - C_Rr * air_velocity_2_inv_product);
    let r_dot = p14_inv_p1 * r;

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
