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
    prepared: &[T; 18],
    dx: &mut [T; 13],
) {
    let q1 = state[7];
    let q0 = state[6];
    let q1_q0 = q1 * q0;
    let q3 = state[9];
    let q2 = state[8];
    let q3_q2 = q3 * q2;
    let vz = state[5];
    let wind_z = parameters[17];
    let vz_minus_wind_z = vz - wind_z;
    let q0_q3 = q0 * q3;
    let q1_q2 = q1 * q2;
    let q1_sq_two = T::splat(2.0) * q1 * q1;
    let q3_sq_two_minus_one = q3.mul_sub(T::splat(2.0) * q3, T::splat(1.0));
    let q1_q0_plus_q3_q2 = q1_q0 + q3_q2;
    let q0_q2 = q0 * q2;
    let q1_q3 = q1 * q3;
    let vy = state[4];
    let wind_y = parameters[16];
    let vy_minus_wind_y = vy - wind_y;
    let q2_sq_two = T::splat(2.0) * q2 * q2;
    let minus_q0_q3_plus_q1_q2 = q1_q2 - q0_q3;
    let q1_sq_two_plus_q3_sq_sum = q1_sq_two + q3_sq_two_minus_one;
    let vx = state[3];
    let wind_x = parameters[15];
    let vx_minus_wind_x = vx - wind_x;
    let q0_q3_plus_q1_q2 = q0_q3 + q1_q2;
    let minus_q0_q2_plus_q1_q3 = q1_q3 - q0_q2;
    let minus_q1_q0_plus_q3_q2 = q3_q2 - q1_q0;
    let q2_sq_two_plus_q3_sq_sum = q2_sq_two + q3_sq_two_minus_one;
    let part_of_air_velocity_2_2 = q1_sq_two_plus_q3_sq_sum * vy_minus_wind_y;
    let q0_q2_plus_q1_q3 = q0_q2 + q1_q3;
    let part_of_air_velocity_2 =
        minus_q0_q3_plus_q1_q2.mul_add(vx_minus_wind_x, q1_q0_plus_q3_q2 * vz_minus_wind_z);
    let part_of_vy_dot = T::splat(0.5) * q1_sq_two_plus_q3_sq_sum;
    let part_of_minus_air_velocity_1_2 = vx_minus_wind_x * q2_sq_two_plus_q3_sq_sum;
    let q1_sq_two_minus_one_sum = q1_sq_two - T::splat(1.0) + q2_sq_two;
    let part_of_vx_dot = T::splat(0.5) * q2_sq_two_plus_q3_sq_sum;

    // disc_quaternion.hyz:68  let air_velocity = in_C(velocity - air);
    let air_velocity_2 = T::splat(2.0).mul_sub(part_of_air_velocity_2, part_of_air_velocity_2_2);
    let part_of_minus_air_velocity_1 =
        vy_minus_wind_y.mul_add(q0_q3_plus_q1_q2, vz_minus_wind_z * minus_q0_q2_plus_q1_q3);
    let part_of_minus_air_velocity_3 =
        vx_minus_wind_x.mul_add(q0_q2_plus_q1_q3, vy_minus_wind_y * minus_q1_q0_plus_q3_q2);
    let part_of_minus_air_velocity_3_2 = vz_minus_wind_z * q1_sq_two_minus_one_sum;
    let minus_air_velocity_1 =
        T::splat(2.0).neg_mul_add(part_of_minus_air_velocity_1, part_of_minus_air_velocity_1_2);
    let minus_air_velocity_3 =
        T::splat(2.0).neg_mul_add(part_of_minus_air_velocity_3, part_of_minus_air_velocity_3_2);
    let air_velocity_12_sq =
        minus_air_velocity_1.mul_add(minus_air_velocity_1, air_velocity_2 * air_velocity_2);
    let part_of_vx_dot_2 =
        minus_air_velocity_1.mul_add(part_of_vx_dot, minus_q0_q3_plus_q1_q2 * air_velocity_2);
    let part_of_vz_dot =
        minus_q0_q2_plus_q1_q3.neg_mul_add(minus_air_velocity_1, q1_q0_plus_q3_q2 * air_velocity_2);
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);
    let part_of_vy_dot_2 =
        air_velocity_2.mul_add(part_of_vy_dot, q0_q3_plus_q1_q2 * minus_air_velocity_1);
    let p = state[10];
    let q = state[11];
    let r = state[12];
    dx[6] = T::splat(-0.5) * q1.mul_add(p, q2.mul_add(q, q3 * r));
    dx[7] = T::splat(-0.5) * q0.neg_mul_add(p, q2.neg_mul_add(r, q3 * q));
    dx[8] = T::splat(-0.5) * q0.neg_mul_add(q, q3.neg_mul_add(p, q1 * r));

    // disc_quaternion.hyz:70  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let half_d_inv_I_d_rho_A = prepared[1];
    let V_sq_half_d_inv_I_d_rho_A = half_d_inv_I_d_rho_A * V_sq;
    dx[9] = T::splat(-0.5) * q0.neg_mul_add(r, q1.neg_mul_add(q, q2 * p));
    let C_Nr_inv_I_a = prepared[3];

    // disc_quaternion.hyz:51  angular velocity (p, q, r) in C;
    let r_dot = C_Nr_inv_I_a * r;
    dx[12] = r_dot;

    // disc_quaternion.hyz:75  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let inv_m_rho_A = prepared[0];
    let V_inv_m_rho_A = inv_m_rho_A * V;
    let C_Mq = parameters[12];
    let V_sq_half_d_inv_I_d_product = V_sq_half_d_inv_I_d_rho_A * (C_Mq * nonzero_air_velocity_12);
    let inv_air_velocity_12_product = inv_air_velocity_12 * V_sq_half_d_inv_I_d_rho_A;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12_product;
    let minus_air_velocity_product = minus_air_velocity_1 * inv_air_velocity_12_product;
    let C_Rr = parameters[13];
    let one_minus_inv_I_d_I_a = prepared[2];
    let part_of_p_dot = C_Rr.neg_mul_add(minus_air_velocity_product, one_minus_inv_I_d_I_a * q);
    let part_of_q_dot = C_Rr.neg_mul_add(air_velocity_2_inv_product, one_minus_inv_I_d_I_a * p);
    let C_La = parameters[8];
    let C_L0 = parameters[7];

    // disc_quaternion.hyz:79  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La.mul_add(alpha, C_L0);
    let C_Da = parameters[10];
    let C_D0 = parameters[9];

    // disc_quaternion.hyz:80  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = alpha.mul_add(C_Da * alpha, C_D0);
    let C_Ma = parameters[11];
    let alpha_C_Ma = C_Ma * alpha;
    let part_of_p_dot_2 =
        air_velocity_2_inv_product.neg_mul_add(alpha_C_Ma, p * V_sq_half_d_inv_I_d_product);
    let part_of_q_dot_2 =
        minus_air_velocity_product.neg_mul_add(alpha_C_Ma, q * V_sq_half_d_inv_I_d_product);
    let p_dot = r.mul_add(part_of_p_dot, part_of_p_dot_2);
    dx[10] = p_dot;
    let minus_air_velocity_3_C_sum = minus_air_velocity_3.mul_add(C_D, air_velocity_12 * C_L);
    let q_dot = r.neg_mul_add(part_of_q_dot, part_of_q_dot_2);
    dx[11] = q_dot;
    let part_of_vx_dot_3 = q0_q2_plus_q1_q3 * minus_air_velocity_3_C_sum;
    let part_of_vy_dot_3 = minus_q1_q0_plus_q3_q2 * minus_air_velocity_3_C_sum;
    let air_velocity_12_C_D_product =
        air_velocity_12.mul_sub(C_D, minus_air_velocity_3 * C_L) * inv_air_velocity_12;
    let part_of_vz_dot_2 = T::splat(0.5) * q1_sq_two_minus_one_sum * minus_air_velocity_3_C_sum;
    let part_of_vx_dot_4 =
        air_velocity_12_C_D_product.neg_mul_add(part_of_vx_dot_2, part_of_vx_dot_3);
    let part_of_vy_dot_4 = air_velocity_12_C_D_product.mul_add(part_of_vy_dot_2, part_of_vy_dot_3);
    let part_of_vz_dot_3 = air_velocity_12_C_D_product.mul_add(part_of_vz_dot, part_of_vz_dot_2);

    // disc_quaternion.hyz:50  velocity (vx, vy, vz) in N;
    let vx_dot = part_of_vx_dot_4 * V_inv_m_rho_A;
    dx[3] = vx_dot;
    let vy_dot = part_of_vy_dot_4 * V_inv_m_rho_A;
    dx[4] = vy_dot;
    let g = parameters[6];
    let vz_dot = V_inv_m_rho_A.neg_mul_add(part_of_vz_dot_3, -g);
    dx[5] = vz_dot;

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
}
