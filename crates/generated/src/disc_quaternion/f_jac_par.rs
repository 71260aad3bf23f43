// Written by `hyzer generate`; changes belong in the model.
//! `disc_quaternion`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 676 operations: 215 add, 417 mul, 2 div, 38 neg, 2 sqrt, 1 call, 1 select.
#[inline(always)]
pub fn f_jac_par<T: Real>(
    _time: T,
    state: &[T; 13],
    parameters: &[T; 18],
    prepared: &[T; 16],
    dx: &mut [T; 13],
    j: &mut [T; 69],
    jp: &mut [T; 55],
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
    let A = parameters[4];
    let rho = parameters[5];
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
    let n1_minus_inv_p2_p1 = prepared[2];
    let p14_inv_p1 = prepared[3];
    let p3_p4_p5_inv_p2 = prepared[4];
    let two_p10 = prepared[5];
    let p4_p5 = prepared[6];
    let inv_p0 = prepared[7];
    let inv_p2 = prepared[8];
    let p1_inv_p2 = prepared[9];
    let inv_p2_p3 = prepared[10];
    let inv_p1 = prepared[11];
    let minus_p1_inv_p2 = prepared[12];
    let minus_inv_p1_p14_inv_p1 = prepared[13];
    let q2_sq_two = T::splat(2.0) * q2 * q2;
    let q1_sq_two = T::splat(2.0) * q1 * q1;
    let q2_sq_two_plus_q1_sq_sum = q2_sq_two + q1_sq_two - T::splat(1.0);
    let vz_minus_wind_z = vz - wind_z;
    let vx_minus_wind_x = vx - wind_x;
    let q3_q1 = q3 * q1;
    let q2_q0 = q2 * q0;
    let q3_q1_plus_q2_q0 = q3_q1 + q2_q0;
    let q3_q2 = q3 * q2;
    let q1_q0 = q1 * q0;
    let q3_q2_minus_q1_q0 = q3_q2 - q1_q0;
    let vy_minus_wind_y = vy - wind_y;
    let part_of_q2_sq_two_plus_q1_sum =
        vx_minus_wind_x * q3_q1_plus_q2_q0 + q3_q2_minus_q1_q0 * vy_minus_wind_y;
    let q2_sq_two_plus_q1_sum =
        q2_sq_two_plus_q1_sq_sum * vz_minus_wind_z - T::splat(2.0) * part_of_q2_sq_two_plus_q1_sum;
    let minus_n1_plus_q3_sq_two = T::splat(2.0) * q3 * q3 - T::splat(1.0);
    let q2_sq_two_plus_minus_n1_sum = q2_sq_two + minus_n1_plus_q3_sq_two;
    let q1_q2 = q1 * q2;
    let q3_q0 = q3 * q0;
    let q1_q2_plus_q3_q0 = q1_q2 + q3_q0;
    let q3_q1_minus_q2_q0 = q3_q1 - q2_q0;
    let part_of_vx_minus_wind_x_q2_sum =
        vy_minus_wind_y * q1_q2_plus_q3_q0 + vz_minus_wind_z * q3_q1_minus_q2_q0;
    let part_of_vx_minus_wind_x_q2_sum_2 = T::splat(2.0) * part_of_vx_minus_wind_x_q2_sum;
    let vx_minus_wind_x_q2_sum =
        vx_minus_wind_x * q2_sq_two_plus_minus_n1_sum - part_of_vx_minus_wind_x_q2_sum_2;
    let q1_sq_two_plus_minus_n1_sum = q1_sq_two + minus_n1_plus_q3_sq_two;
    let q1_q2_minus_q3_q0 = q1_q2 - q3_q0;
    let q3_q2_plus_q1_q0 = q3_q2 + q1_q0;
    let part_of_air_velocity_2 =
        vx_minus_wind_x * q1_q2_minus_q3_q0 + vz_minus_wind_z * q3_q2_plus_q1_q0;

    // disc_quaternion.hyz:55  let air_velocity = in_C(velocity - wind);
    let air_velocity_2 =
        T::splat(2.0) * part_of_air_velocity_2 - vy_minus_wind_y * q1_sq_two_plus_minus_n1_sum;
    let vx_minus_wind_x_q2_sum_sum =
        vx_minus_wind_x_q2_sum * vx_minus_wind_x_q2_sum + air_velocity_2 * air_velocity_2;
    let q2_sq_two_plus_q1_sum_sum =
        q2_sq_two_plus_q1_sum * q2_sq_two_plus_q1_sum + vx_minus_wind_x_q2_sum_sum;

    // disc_quaternion.hyz:57  let V = norm(air_velocity);
    let V = q2_sq_two_plus_q1_sum_sum.sqrt();
    let V_A_rho_inv_m = inv_p0_p5_p4 * V;
    let sqrt_vx_minus_wind_x_q2_of = vx_minus_wind_x_q2_sum_sum.sqrt();

    // disc_quaternion.hyz:62  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = q2_sq_two_plus_q1_sum.atan2(sqrt_vx_minus_wind_x_q2_of);

    // disc_quaternion.hyz:66  let C_L = C_L0 + C_La*alpha;
    let C_L = C_L0 + C_La * alpha;

    // disc_quaternion.hyz:67  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_D0 + C_Da * alpha * alpha;
    let part_of_minus_q2_sq_two_product =
        sqrt_vx_minus_wind_x_q2_of * C_D - q2_sq_two_plus_q1_sum * C_L;
    let inv_sqrt_vx_minus_wind_x_of = sqrt_vx_minus_wind_x_q2_of.recip_or_zero();
    let minus_q2_sq_two_product = part_of_minus_q2_sq_two_product * inv_sqrt_vx_minus_wind_x_of;
    let q2_sq_two_plus_product = T::splat(0.5) * q2_sq_two_plus_minus_n1_sum;
    let q1_q2_minus_q3_q0_sum =
        q1_q2_minus_q3_q0 * air_velocity_2 + vx_minus_wind_x_q2_sum * q2_sq_two_plus_product;
    let sqrt_vx_minus_wind_sum = sqrt_vx_minus_wind_x_q2_of * C_L + q2_sq_two_plus_q1_sum * C_D;
    let minus_minus_q2_sq_two_sum =
        q3_q1_plus_q2_q0 * sqrt_vx_minus_wind_sum - minus_q2_sq_two_product * q1_q2_minus_q3_q0_sum;

    // disc_quaternion.hyz:50  velocity (vx, vy, vz) in N;
    let vx_dot = V_A_rho_inv_m * minus_minus_q2_sq_two_sum;
    let q1_sq_two_plus_product = T::splat(0.5) * q1_sq_two_plus_minus_n1_sum;
    let q1_q2_plus_q3_q0_vx_sum =
        q1_q2_plus_q3_q0 * vx_minus_wind_x_q2_sum + air_velocity_2 * q1_sq_two_plus_product;
    let part_of_minus_q2_sq_two_product_sum = minus_q2_sq_two_product * q1_q2_plus_q3_q0_vx_sum;
    let minus_q2_sq_two_product_sum =
        part_of_minus_q2_sq_two_product_sum + q3_q2_minus_q1_q0 * sqrt_vx_minus_wind_sum;
    let vy_dot = V_A_rho_inv_m * minus_q2_sq_two_product_sum;
    let minus_q3_q1_minus_q2_q0_sum =
        q3_q2_plus_q1_q0 * air_velocity_2 - q3_q1_minus_q2_q0 * vx_minus_wind_x_q2_sum;
    let part_of_minus_q2_sq_two_product_sum_2 =
        minus_q2_sq_two_product * minus_q3_q1_minus_q2_q0_sum;
    let q2_sq_two_plus_q1_product = T::splat(0.5) * q2_sq_two_plus_q1_sq_sum;
    let minus_q2_sq_two_product_sum_2 =
        part_of_minus_q2_sq_two_product_sum_2 + sqrt_vx_minus_wind_sum * q2_sq_two_plus_q1_product;
    let vz_dot = -(V_A_rho_inv_m * minus_q2_sq_two_product_sum_2) - g;
    let q2_sq_two_plus_q1_product_2 = T::splat(0.5) * q2_sq_two_plus_q1_sum_sum;
    let q2_sq_two_plus_q1_product_3 = p3_p4_p5_inv_p2 * q2_sq_two_plus_q1_product_2;
    let inv_sqrt_vx_minus_product = inv_sqrt_vx_minus_wind_x_of * q2_sq_two_plus_q1_product_3;
    let vx_minus_wind_x_q2_product = vx_minus_wind_x_q2_sum * inv_sqrt_vx_minus_product;
    let q_n1_minus_part_part_sum = n1_minus_inv_p2_p1 * q - C_Rr * vx_minus_wind_x_q2_product;
    let nonzero_sqrt_vx_minus_of = sqrt_vx_minus_wind_x_q2_of.if_zero(T::splat(0.0), T::splat(1.0));
    let q2_sq_two_plus_q1_product_4 = q2_sq_two_plus_q1_product_3 * nonzero_sqrt_vx_minus_of;
    let C_Mq_q2_sq_two_plus_product = C_Mq * q2_sq_two_plus_q1_product_4;
    let alpha_C_Ma = C_Ma * alpha;
    let air_velocity_2_inv_product = air_velocity_2 * inv_sqrt_vx_minus_product;
    let part_of_p_dot = r * q_n1_minus_part_part_sum + p * C_Mq_q2_sq_two_plus_product;

    // disc_quaternion.hyz:51  angular velocity (p, q, r) in C;
    let p_dot = part_of_p_dot - alpha_C_Ma * air_velocity_2_inv_product;
    let minus_p_n1_minus_part_sum = C_Rr * air_velocity_2_inv_product - n1_minus_inv_p2_p1 * p;
    let part_of_q_dot = r * minus_p_n1_minus_part_sum + q * C_Mq_q2_sq_two_plus_product;
    let q_dot = part_of_q_dot - vx_minus_wind_x_q2_product * alpha_C_Ma;
    let r_dot = p14_inv_p1 * r;
    let inv_V = V.recip_or_zero();
    let inv_V_A_rho_inv_m = inv_p0_p5_p4 * inv_V;
    let q2_sq_two_plus_q1_product_5 = q2_sq_two_plus_q1_sum * inv_V_A_rho_inv_m;
    let part_of_minus_minus_q2_sq_sum_3 = minus_minus_q2_sq_two_sum * q2_sq_two_plus_q1_product_5;
    let alpha_two_C_Da = two_p10 * alpha;
    let sqrt_vx_minus_wind_sum_2 =
        C_La * sqrt_vx_minus_wind_x_q2_of + q2_sq_two_plus_q1_sum * alpha_two_C_Da;
    let inv_V_sq = inv_V * inv_V;
    let sqrt_vx_minus_wind_product = sqrt_vx_minus_wind_x_q2_of * inv_V_sq;
    let C_D_plus_sqrt_vx_minus_sum = C_D + sqrt_vx_minus_wind_sum_2 * sqrt_vx_minus_wind_product;
    let q2_sq_two_plus_q1_product_6 = q2_sq_two_plus_q1_sum * inv_sqrt_vx_minus_wind_x_of;
    let C_La_q2_sq_two_plus_product = C_La * q2_sq_two_plus_q1_product_6;
    let part_of_minus_minus_C_La_q2_sq_sum =
        (alpha_two_C_Da - C_La_q2_sq_two_plus_product) * sqrt_vx_minus_wind_product;
    let minus_minus_C_La_q2_sq_sum =
        C_L * inv_sqrt_vx_minus_wind_x_of - part_of_minus_minus_C_La_q2_sq_sum;
    let part_of_minus_minus_q2_sq_sum = q1_q2_minus_q3_q0_sum * minus_minus_C_La_q2_sq_sum;
    let part_of_minus_minus_q2_sq_sum_2 =
        q3_q1_plus_q2_q0 * C_D_plus_sqrt_vx_minus_sum + part_of_minus_minus_q2_sq_sum;
    let minus_minus_q2_sq_sum =
        part_of_minus_minus_q2_sq_sum_3 + V_A_rho_inv_m * part_of_minus_minus_q2_sq_sum_2;
    let q3_q1_plus_q2_q0_two = T::splat(2.0) * q3_q1_plus_q2_q0;
    let V_A_rho_inv_m_minus_product = V_A_rho_inv_m * minus_q2_sq_two_product;
    let part_of_V_A_rho_inv_m_minus_sum = V_A_rho_inv_m_minus_product * q2_sq_two_plus_product;
    let q2_sq_two_plus_q1_product_7 = q2_sq_two_plus_q1_sum * inv_V_sq;
    let C_L_minus_sqrt_vx_minus_sum = C_L - sqrt_vx_minus_wind_sum_2 * q2_sq_two_plus_q1_product_7;
    let part_of_minus_minus_q2_sq_sum_2_2 = q3_q1_plus_q2_q0 * C_L_minus_sqrt_vx_minus_sum;
    let part_of_minus_C_La_q2_sq_sum =
        nonzero_sqrt_vx_minus_of * alpha_two_C_Da - C_La_q2_sq_two_plus_product;
    let part_of_minus_C_La_q2_sq_sum_2 =
        inv_sqrt_vx_minus_wind_x_of * (C_D - minus_q2_sq_two_product);
    let minus_C_La_q2_sq_sum =
        part_of_minus_C_La_q2_sq_sum * q2_sq_two_plus_q1_product_7 - part_of_minus_C_La_q2_sq_sum_2;
    let part_of_minus_minus_q2_sq_sum_2_3 =
        part_of_minus_minus_q2_sq_sum_2_2 + q1_q2_minus_q3_q0_sum * minus_C_La_q2_sq_sum;
    let V_A_rho_inv_m_inv_product = V_A_rho_inv_m * inv_sqrt_vx_minus_wind_x_of;
    let part_of_minus_minus_q2_sq_sum_2_4 =
        part_of_minus_minus_q2_sq_sum_2_3 * V_A_rho_inv_m_inv_product;
    let minus_minus_q2_sq_sum_2 =
        minus_minus_q2_sq_two_sum * inv_V_A_rho_inv_m + part_of_minus_minus_q2_sq_sum_2_4;
    let V_A_rho_inv_m_minus_sum =
        part_of_V_A_rho_inv_m_minus_sum - vx_minus_wind_x_q2_sum * minus_minus_q2_sq_sum_2;
    let part_of_minus_minus_q2_sq_sum_3_2 = q2_sq_two_plus_minus_n1_sum * V_A_rho_inv_m_minus_sum;
    let q1_q2_minus_q3_q0_V_sum =
        q1_q2_minus_q3_q0 * V_A_rho_inv_m_minus_product - air_velocity_2 * minus_minus_q2_sq_sum_2;
    let two_q1_q2_minus_q3_q0 = T::splat(2.0) * q1_q2_minus_q3_q0;
    let part_of_minus_minus_q2_sq_sum_3_3 =
        part_of_minus_minus_q2_sq_sum_3_2 + q1_q2_minus_q3_q0_V_sum * two_q1_q2_minus_q3_q0;
    let minus_minus_q2_sq_sum_3 =
        minus_minus_q2_sq_sum * q3_q1_plus_q2_q0_two + part_of_minus_minus_q2_sq_sum_3_3;
    let q3_q2_minus_q1_q0_two = T::splat(2.0) * q3_q2_minus_q1_q0;
    let part_of_minus_minus_minus_q2_sq_sum = q1_sq_two_plus_minus_n1_sum * q1_q2_minus_q3_q0_V_sum;
    let two_q1_q2_plus_q3_q0 = T::splat(2.0) * q1_q2_plus_q3_q0;
    let part_of_minus_minus_minus_q2_sq_sum_2 =
        part_of_minus_minus_minus_q2_sq_sum + V_A_rho_inv_m_minus_sum * two_q1_q2_plus_q3_q0;
    let minus_minus_minus_q2_sq_sum =
        part_of_minus_minus_minus_q2_sq_sum_2 - minus_minus_q2_sq_sum * q3_q2_minus_q1_q0_two;
    let two_q3_q2_plus_q1_q0 = T::splat(2.0) * q3_q2_plus_q1_q0;
    let part_of_minus_q1_q2_minus_q3_q0_sum = q2_sq_two_plus_q1_sq_sum * minus_minus_q2_sq_sum;
    let two_q3_q1_minus_q2_q0 = T::splat(2.0) * q3_q1_minus_q2_q0;
    let part_of_minus_q1_q2_minus_q3_q0_sum_2 =
        part_of_minus_q1_q2_minus_q3_q0_sum + V_A_rho_inv_m_minus_sum * two_q3_q1_minus_q2_q0;
    let minus_q1_q2_minus_q3_q0_sum =
        part_of_minus_q1_q2_minus_q3_q0_sum_2 - q1_q2_minus_q3_q0_V_sum * two_q3_q2_plus_q1_q0;
    let V_A_rho_inv_m_sqrt_product = V_A_rho_inv_m * sqrt_vx_minus_wind_sum;
    let q2_V_A_rho_inv_m_product = q2 * V_A_rho_inv_m_sqrt_product;
    let air_velocity_2_V_A_product = air_velocity_2 * V_A_rho_inv_m_minus_product;
    let q3_air_velocity_2_V_product = q3 * air_velocity_2_V_A_product;
    let q1_vy_minus_wind_y = q1 * vy_minus_wind_y;
    let vx_minus_wind_x_q2 = vx_minus_wind_x * q2;
    let minus_q1_vy_minus_wind_sum = vx_minus_wind_x_q2 - q1_vy_minus_wind_y;
    let q1_vz_minus_wind_z = q1 * vz_minus_wind_z;
    let vx_minus_wind_x_q3 = vx_minus_wind_x * q3;
    let minus_q1_vz_minus_wind_sum = vx_minus_wind_x_q3 - q1_vz_minus_wind_z;
    let part_of_d_vx_dot_d_q0 = q1_q2_minus_q3_q0_V_sum * minus_q1_vz_minus_wind_sum;
    let q2_vz_minus_wind_z = q2 * vz_minus_wind_z;
    let q3_vy_minus_wind_y = q3 * vy_minus_wind_y;
    let minus_q2_vz_minus_wind_sum = q3_vy_minus_wind_y - q2_vz_minus_wind_z;
    let part_of_d_vx_dot_d_q0_2 =
        minus_minus_q2_sq_sum * minus_q1_vy_minus_wind_sum - part_of_d_vx_dot_d_q0;
    let part_of_d_vx_dot_d_q0_3 =
        part_of_d_vx_dot_d_q0_2 - V_A_rho_inv_m_minus_sum * minus_q2_vz_minus_wind_sum;
    let part_of_d_vx_dot_d_q0_4 = q2_V_A_rho_inv_m_product + q3_air_velocity_2_V_product;
    let part_of_d_vx_dot_d_q0_5 = part_of_d_vx_dot_d_q0_4 - T::splat(2.0) * part_of_d_vx_dot_d_q0_3;
    let q0_two = T::splat(2.0) * q0;
    let vy_minus_wind_y_q0_two = vy_minus_wind_y * q0_two;
    let part_of_two_vx_minus_wind_x_q3_sum =
        T::splat(2.0) * vx_minus_wind_x_q3 - T::splat(4.0) * q1_vz_minus_wind_z;
    let two_vx_minus_wind_x_q3_sum = part_of_two_vx_minus_wind_x_q3_sum - vy_minus_wind_y_q0_two;
    let vz_minus_wind_z_q0_two = vz_minus_wind_z * q0_two;
    let part_of_two_vx_minus_wind_x_q2_sum =
        T::splat(2.0) * vx_minus_wind_x_q2 - T::splat(4.0) * q1_vy_minus_wind_y;
    let two_vx_minus_wind_x_q2_sum = part_of_two_vx_minus_wind_x_q2_sum + vz_minus_wind_z_q0_two;
    let q3_V_A_rho_inv_m_product = q3 * V_A_rho_inv_m_sqrt_product;
    let q2_air_velocity_2_V_product = q2 * air_velocity_2_V_A_product;
    let q3_vz_minus_wind_z = q3 * vz_minus_wind_z;
    let q2_vy_minus_wind_y = q2 * vy_minus_wind_y;
    let q3_vz_minus_wind_z_plus_sum = q3_vz_minus_wind_z + q2_vy_minus_wind_y;
    let two_q3_vz_minus_product = T::splat(2.0) * q3_vz_minus_wind_z_plus_sum;
    let part_of_d_vx_dot_d_q1 =
        q3_V_A_rho_inv_m_product - minus_minus_q2_sq_sum * two_vx_minus_wind_x_q3_sum;
    let part_of_d_vx_dot_d_q1_2 =
        part_of_d_vx_dot_d_q1 - q1_q2_minus_q3_q0_V_sum * two_vx_minus_wind_x_q2_sum;
    let part_of_d_vx_dot_d_q1_3 = part_of_d_vx_dot_d_q1_2 - q2_air_velocity_2_V_product;
    let part_of_d_vx_dot_d_q1_4 =
        part_of_d_vx_dot_d_q1_3 + V_A_rho_inv_m_minus_sum * two_q3_vz_minus_product;
    let vx_minus_wind_x_q0_two = vx_minus_wind_x * q0_two;
    let part_of_two_q3_vy_minus_wind_y_sum =
        T::splat(2.0) * q3_vy_minus_wind_y - T::splat(4.0) * q2_vz_minus_wind_z;
    let two_q3_vy_minus_wind_y_sum = part_of_two_q3_vy_minus_wind_y_sum + vx_minus_wind_x_q0_two;
    let part_of_vz_minus_wind_z_q0_two_sum =
        vz_minus_wind_z_q0_two + T::splat(4.0) * vx_minus_wind_x_q2;
    let vz_minus_wind_z_q0_two_sum =
        part_of_vz_minus_wind_z_q0_two_sum - T::splat(2.0) * q1_vy_minus_wind_y;
    let q0_V_A_rho_inv_m_product = q0 * V_A_rho_inv_m_sqrt_product;
    let q1_air_velocity_2_V_product = q1 * air_velocity_2_V_A_product;
    let vx_minus_wind_x_q1 = vx_minus_wind_x * q1;
    let q3_vz_minus_wind_z_plus_sum_2 = q3_vz_minus_wind_z + vx_minus_wind_x_q1;
    let vx_minus_wind_x_q2_product_2 = vx_minus_wind_x_q2_sum * V_A_rho_inv_m_minus_product;
    let q2_vx_minus_wind_x_product = q2 * vx_minus_wind_x_q2_product_2;
    let part_of_d_vx_dot_d_q2 =
        q1_q2_minus_q3_q0_V_sum * q3_vz_minus_wind_z_plus_sum_2 + q2_vx_minus_wind_x_product;
    let part_of_d_vx_dot_d_q2_2 =
        q0_V_A_rho_inv_m_product - minus_minus_q2_sq_sum * two_q3_vy_minus_wind_y_sum;
    let part_of_d_vx_dot_d_q2_3 =
        part_of_d_vx_dot_d_q2_2 - V_A_rho_inv_m_minus_sum * vz_minus_wind_z_q0_two_sum;
    let part_of_d_vx_dot_d_q2_4 = part_of_d_vx_dot_d_q2_3 - q1_air_velocity_2_V_product;
    let part_of_vx_minus_wind_x_q0_two_sum =
        vx_minus_wind_x_q0_two + T::splat(4.0) * q3_vy_minus_wind_y;
    let vx_minus_wind_x_q0_two_sum =
        part_of_vx_minus_wind_x_q0_two_sum - T::splat(2.0) * q2_vz_minus_wind_z;
    let part_of_d_vx_dot_d_q3_2 = q1_q2_minus_q3_q0_V_sum * vx_minus_wind_x_q0_two_sum;
    let part_of_minus_vy_minus_wind_y_sum =
        T::splat(4.0) * vx_minus_wind_x_q3 - vy_minus_wind_y_q0_two;
    let minus_vy_minus_wind_y_sum =
        part_of_minus_vy_minus_wind_y_sum - T::splat(2.0) * q1_vz_minus_wind_z;
    let q0_air_velocity_2_V_product = q0 * air_velocity_2_V_A_product;
    let q1_V_A_rho_inv_m_product = q1 * V_A_rho_inv_m_sqrt_product;
    let q2_vy_minus_wind_y_plus_sum = q2_vy_minus_wind_y + vx_minus_wind_x_q1;
    let q3_vx_minus_wind_x_product = q3 * vx_minus_wind_x_q2_product_2;
    let part_of_d_vx_dot_d_q3 =
        minus_minus_q2_sq_sum * q2_vy_minus_wind_y_plus_sum + q3_vx_minus_wind_x_product;
    let part_of_d_vx_dot_d_q3_3 =
        part_of_d_vx_dot_d_q3_2 - V_A_rho_inv_m_minus_sum * minus_vy_minus_wind_y_sum;
    let part_of_d_vx_dot_d_q3_4 =
        part_of_d_vx_dot_d_q3_3 + q0_air_velocity_2_V_product + q1_V_A_rho_inv_m_product;
    let part_of_minus_q2_sq_two_product_sum_3_3 =
        minus_q2_sq_two_product_sum * q2_sq_two_plus_q1_product_5;
    let part_of_minus_q2_sq_two_product_sum_3 =
        q1_q2_plus_q3_q0_vx_sum * minus_minus_C_La_q2_sq_sum;
    let part_of_minus_q2_sq_two_product_sum_3_2 =
        q3_q2_minus_q1_q0 * C_D_plus_sqrt_vx_minus_sum - part_of_minus_q2_sq_two_product_sum_3;
    let part_of_minus_q2_sq_two_product_sum_3_4 =
        V_A_rho_inv_m * part_of_minus_q2_sq_two_product_sum_3_2;
    let minus_q2_sq_two_product_sum_3 =
        part_of_minus_q2_sq_two_product_sum_3_3 + part_of_minus_q2_sq_two_product_sum_3_4;
    let part_of_minus_minus_q2_sq_two_sum_2_3 =
        minus_q2_sq_two_product_sum_3 * q3_q1_plus_q2_q0_two;
    let part_of_minus_q2_sq_two_product_sum_4 = q3_q2_minus_q1_q0 * C_L_minus_sqrt_vx_minus_sum;
    let part_of_minus_q2_sq_two_product_sum_4_2 =
        part_of_minus_q2_sq_two_product_sum_4 - q1_q2_plus_q3_q0_vx_sum * minus_C_La_q2_sq_sum;
    let part_of_minus_q2_sq_two_product_sum_4_3 =
        part_of_minus_q2_sq_two_product_sum_4_2 * V_A_rho_inv_m_inv_product;
    let minus_q2_sq_two_product_sum_4 =
        minus_q2_sq_two_product_sum * inv_V_A_rho_inv_m + part_of_minus_q2_sq_two_product_sum_4_3;
    let part_of_q1_q2_plus_q3_q0_V_sum = vx_minus_wind_x_q2_sum * minus_q2_sq_two_product_sum_4;
    let q1_q2_plus_q3_q0_V_sum =
        q1_q2_plus_q3_q0 * V_A_rho_inv_m_minus_product + part_of_q1_q2_plus_q3_q0_V_sum;
    let part_of_minus_minus_q2_sq_two_sum_2 = q2_sq_two_plus_minus_n1_sum * q1_q2_plus_q3_q0_V_sum;
    let part_of_V_A_rho_inv_m_minus_sum_2 = V_A_rho_inv_m_minus_product * q1_sq_two_plus_product;
    let V_A_rho_inv_m_minus_sum_2 =
        part_of_V_A_rho_inv_m_minus_sum_2 + air_velocity_2 * minus_q2_sq_two_product_sum_4;
    let part_of_minus_minus_q2_sq_two_sum_2_2 =
        part_of_minus_minus_q2_sq_two_sum_2 + V_A_rho_inv_m_minus_sum_2 * two_q1_q2_minus_q3_q0;
    let minus_minus_q2_sq_two_sum_2 =
        part_of_minus_minus_q2_sq_two_sum_2_2 - part_of_minus_minus_q2_sq_two_sum_2_3;
    let part_of_minus_q2_sq_two_product_sum_5_3 =
        minus_q2_sq_two_product_sum_3 * q3_q2_minus_q1_q0_two;
    let part_of_minus_q2_sq_two_product_sum_5 =
        q1_sq_two_plus_minus_n1_sum * V_A_rho_inv_m_minus_sum_2;
    let part_of_minus_q2_sq_two_product_sum_5_2 =
        part_of_minus_q2_sq_two_product_sum_5 + q1_q2_plus_q3_q0_V_sum * two_q1_q2_plus_q3_q0;
    let minus_q2_sq_two_product_sum_5 =
        part_of_minus_q2_sq_two_product_sum_5_3 + part_of_minus_q2_sq_two_product_sum_5_2;
    let part_of_V_A_rho_inv_m_minus_sum_3 =
        q2_sq_two_plus_q1_sq_sum * minus_q2_sq_two_product_sum_3;
    let part_of_V_A_rho_inv_m_minus_sum_3_2 =
        part_of_V_A_rho_inv_m_minus_sum_3 - q1_q2_plus_q3_q0_V_sum * two_q3_q1_minus_q2_q0;
    let V_A_rho_inv_m_minus_sum_3 =
        V_A_rho_inv_m_minus_sum_2 * two_q3_q2_plus_q1_q0 + part_of_V_A_rho_inv_m_minus_sum_3_2;
    let part_of_d_vy_dot_d_q0 = minus_q1_vy_minus_wind_sum * minus_q2_sq_two_product_sum_3;
    let part_of_d_vy_dot_d_q0_2 =
        part_of_d_vy_dot_d_q0 + minus_q1_vz_minus_wind_sum * V_A_rho_inv_m_minus_sum_2;
    let part_of_d_vy_dot_d_q0_3 =
        part_of_d_vy_dot_d_q0_2 + minus_q2_vz_minus_wind_sum * q1_q2_plus_q3_q0_V_sum;
    let part_of_d_vy_dot_d_q0_4 = q3_vx_minus_wind_x_product - q1_V_A_rho_inv_m_product;
    let part_of_d_vy_dot_d_q0_5 = part_of_d_vy_dot_d_q0_4 - T::splat(2.0) * part_of_d_vy_dot_d_q0_3;
    let part_of_d_vy_dot_d_q1_2 = two_vx_minus_wind_x_q3_sum * minus_q2_sq_two_product_sum_3;
    let part_of_d_vy_dot_d_q1 =
        q1_air_velocity_2_V_product - q3_vz_minus_wind_z_plus_sum * q1_q2_plus_q3_q0_V_sum;
    let part_of_d_vy_dot_d_q1_3 =
        q2_vx_minus_wind_x_product - q0_V_A_rho_inv_m_product - part_of_d_vy_dot_d_q1_2;
    let part_of_d_vy_dot_d_q1_4 =
        part_of_d_vy_dot_d_q1_3 + two_vx_minus_wind_x_q2_sum * V_A_rho_inv_m_minus_sum_2;
    let q1_vx_minus_wind_x_product = q1 * vx_minus_wind_x_q2_product_2;
    let two_q3_vz_minus_product_2 = T::splat(2.0) * q3_vz_minus_wind_z_plus_sum_2;
    let part_of_d_vy_dot_d_q2_3 = V_A_rho_inv_m_minus_sum_2 * two_q3_vz_minus_product_2;
    let part_of_d_vy_dot_d_q2 =
        q3_V_A_rho_inv_m_product - two_q3_vy_minus_wind_y_sum * minus_q2_sq_two_product_sum_3;
    let part_of_d_vy_dot_d_q2_2 =
        part_of_d_vy_dot_d_q2 + vz_minus_wind_z_q0_two_sum * q1_q2_plus_q3_q0_V_sum;
    let part_of_d_vy_dot_d_q2_4 =
        part_of_d_vy_dot_d_q2_2 + q1_vx_minus_wind_x_product + part_of_d_vy_dot_d_q2_3;
    let q0_vx_minus_wind_x_product = q0 * vx_minus_wind_x_q2_product_2;
    let part_of_d_vy_dot_d_q3 =
        q3_air_velocity_2_V_product - q2_vy_minus_wind_y_plus_sum * minus_q2_sq_two_product_sum_3;
    let part_of_d_vy_dot_d_q3_2 =
        q2_V_A_rho_inv_m_product - vx_minus_wind_x_q0_two_sum * V_A_rho_inv_m_minus_sum_2;
    let part_of_d_vy_dot_d_q3_3 =
        part_of_d_vy_dot_d_q3_2 + minus_vy_minus_wind_y_sum * q1_q2_plus_q3_q0_V_sum;
    let part_of_d_vy_dot_d_q3_4 = part_of_d_vy_dot_d_q3_3 + q0_vx_minus_wind_x_product;
    let part_of_minus_q2_sq_two_product_sum_6_4 =
        minus_q2_sq_two_product_sum_2 * q2_sq_two_plus_q1_product_5;
    let part_of_minus_q2_sq_two_product_sum_6 =
        minus_q3_q1_minus_q2_q0_sum * minus_minus_C_La_q2_sq_sum;
    let part_of_minus_q2_sq_two_product_sum_6_2 =
        C_D_plus_sqrt_vx_minus_sum * q2_sq_two_plus_q1_product;
    let part_of_minus_q2_sq_two_product_sum_6_3 =
        part_of_minus_q2_sq_two_product_sum_6 - part_of_minus_q2_sq_two_product_sum_6_2;
    let part_of_minus_q2_sq_two_product_sum_6_5 =
        V_A_rho_inv_m * part_of_minus_q2_sq_two_product_sum_6_3;
    let minus_q2_sq_two_product_sum_6 =
        part_of_minus_q2_sq_two_product_sum_6_4 - part_of_minus_q2_sq_two_product_sum_6_5;
    let part_of_minus_q2_sq_two_product_sum_8_3 =
        minus_q2_sq_two_product_sum_6 * q3_q1_plus_q2_q0_two;
    let part_of_minus_q2_sq_two_product_sum_7 =
        C_L_minus_sqrt_vx_minus_sum * q2_sq_two_plus_q1_product;
    let part_of_minus_q2_sq_two_product_sum_7_2 =
        minus_q3_q1_minus_q2_q0_sum * minus_C_La_q2_sq_sum - part_of_minus_q2_sq_two_product_sum_7;
    let part_of_minus_q2_sq_two_product_sum_7_3 =
        part_of_minus_q2_sq_two_product_sum_7_2 * V_A_rho_inv_m_inv_product;
    let minus_q2_sq_two_product_sum_7 =
        minus_q2_sq_two_product_sum_2 * inv_V_A_rho_inv_m - part_of_minus_q2_sq_two_product_sum_7_3;
    let part_of_q3_q1_minus_q2_q0_V_sum = vx_minus_wind_x_q2_sum * minus_q2_sq_two_product_sum_7;
    let q3_q1_minus_q2_q0_V_sum =
        q3_q1_minus_q2_q0 * V_A_rho_inv_m_minus_product - part_of_q3_q1_minus_q2_q0_V_sum;
    let part_of_minus_q2_sq_two_product_sum_8 =
        q2_sq_two_plus_minus_n1_sum * q3_q1_minus_q2_q0_V_sum;
    let part_of_q3_q2_plus_q1_q0_V_sum = air_velocity_2 * minus_q2_sq_two_product_sum_7;
    let q3_q2_plus_q1_q0_V_sum =
        q3_q2_plus_q1_q0 * V_A_rho_inv_m_minus_product + part_of_q3_q2_plus_q1_q0_V_sum;
    let part_of_minus_q2_sq_two_product_sum_8_2 =
        part_of_minus_q2_sq_two_product_sum_8 - q3_q2_plus_q1_q0_V_sum * two_q1_q2_minus_q3_q0;
    let minus_q2_sq_two_product_sum_8 =
        part_of_minus_q2_sq_two_product_sum_8_3 + part_of_minus_q2_sq_two_product_sum_8_2;
    let part_of_minus_q2_sq_two_product_sum_9_3 =
        minus_q2_sq_two_product_sum_6 * q3_q2_minus_q1_q0_two;
    let part_of_minus_q2_sq_two_product_sum_9 =
        q1_sq_two_plus_minus_n1_sum * q3_q2_plus_q1_q0_V_sum;
    let part_of_minus_q2_sq_two_product_sum_9_2 =
        part_of_minus_q2_sq_two_product_sum_9 - q3_q1_minus_q2_q0_V_sum * two_q1_q2_plus_q3_q0;
    let minus_q2_sq_two_product_sum_9 =
        part_of_minus_q2_sq_two_product_sum_9_3 + part_of_minus_q2_sq_two_product_sum_9_2;
    let part_of_q3_q2_plus_q1_q0_V_sum_2 = q2_sq_two_plus_q1_sq_sum * minus_q2_sq_two_product_sum_6;
    let part_of_q3_q2_plus_q1_q0_V_sum_2_2 =
        part_of_q3_q2_plus_q1_q0_V_sum_2 + q3_q1_minus_q2_q0_V_sum * two_q3_q1_minus_q2_q0;
    let q3_q2_plus_q1_q0_V_sum_2 =
        q3_q2_plus_q1_q0_V_sum * two_q3_q2_plus_q1_q0 + part_of_q3_q2_plus_q1_q0_V_sum_2_2;
    let part_of_d_vz_dot_d_q0 = minus_q1_vy_minus_wind_sum * minus_q2_sq_two_product_sum_6;
    let part_of_d_vz_dot_d_q0_2 =
        part_of_d_vz_dot_d_q0 + minus_q1_vz_minus_wind_sum * q3_q2_plus_q1_q0_V_sum;
    let part_of_d_vz_dot_d_q0_3 =
        part_of_d_vz_dot_d_q0_2 - minus_q2_vz_minus_wind_sum * q3_q1_minus_q2_q0_V_sum;
    let part_of_d_vz_dot_d_q0_4 =
        T::splat(2.0) * part_of_d_vz_dot_d_q0_3 - q1_air_velocity_2_V_product;
    let part_of_d_vz_dot_d_q1_2 = two_vx_minus_wind_x_q3_sum * minus_q2_sq_two_product_sum_6;
    let part_of_d_vz_dot_d_q1 =
        q1_V_A_rho_inv_m_product + q3_vz_minus_wind_z_plus_sum * q3_q1_minus_q2_q0_V_sum;
    let part_of_d_vz_dot_d_q1_3 =
        q3_vx_minus_wind_x_product - q0_air_velocity_2_V_product + part_of_d_vz_dot_d_q1_2;
    let part_of_d_vz_dot_d_q1_4 =
        part_of_d_vz_dot_d_q1_3 - two_vx_minus_wind_x_q2_sum * q3_q2_plus_q1_q0_V_sum;
    let part_of_d_vz_dot_d_q2_3 = vz_minus_wind_z_q0_two_sum * q3_q1_minus_q2_q0_V_sum;
    let part_of_d_vz_dot_d_q2 =
        q2_V_A_rho_inv_m_product + q3_vz_minus_wind_z_plus_sum_2 * q3_q2_plus_q1_q0_V_sum;
    let part_of_d_vz_dot_d_q2_2 =
        two_q3_vy_minus_wind_y_sum * minus_q2_sq_two_product_sum_6 - q3_air_velocity_2_V_product;
    let part_of_d_vz_dot_d_q2_4 =
        part_of_d_vz_dot_d_q2_2 - q0_vx_minus_wind_x_product + part_of_d_vz_dot_d_q2_3;
    let two_q2_vy_minus_product = T::splat(2.0) * q2_vy_minus_wind_y_plus_sum;
    let part_of_d_vz_dot_d_q3 = q1_vx_minus_wind_x_product - q2_air_velocity_2_V_product;
    let part_of_d_vz_dot_d_q3_2 =
        part_of_d_vz_dot_d_q3 + vx_minus_wind_x_q0_two_sum * q3_q2_plus_q1_q0_V_sum;
    let part_of_d_vz_dot_d_q3_3 =
        part_of_d_vz_dot_d_q3_2 + minus_vy_minus_wind_y_sum * q3_q1_minus_q2_q0_V_sum;
    let part_of_d_vz_dot_d_q3_4 =
        part_of_d_vz_dot_d_q3_3 + minus_q2_sq_two_product_sum_6 * two_q2_vy_minus_product;
    let half_p = T::splat(0.5) * p;
    let half_q = T::splat(0.5) * q;
    let half_r = T::splat(0.5) * r;
    let q1_half = T::splat(0.5) * q1;
    let q2_half = T::splat(0.5) * q2;
    let q3_half = T::splat(0.5) * q3;
    let q0_half = T::splat(0.5) * q0;
    let r_C_Rr = C_Rr * r;
    let air_velocity_2_alpha_C_sum = air_velocity_2 * alpha_C_Ma + vx_minus_wind_x_q2_sum * r_C_Rr;
    let inv_sqrt_vx_minus_product_2 = inv_sqrt_vx_minus_wind_x_of * air_velocity_2_alpha_C_sum;
    let p_C_Mq = C_Mq * p;
    let minus_inv_sqrt_vx_minus_sum =
        nonzero_sqrt_vx_minus_of * p_C_Mq - inv_sqrt_vx_minus_product_2;
    let q2_sq_two_plus_q1_product_8 = p3_p4_p5_inv_p2 * q2_sq_two_plus_q1_sum;
    let part_of_minus_minus_inv_sqrt_vx_sum =
        minus_inv_sqrt_vx_minus_sum * q2_sq_two_plus_q1_product_8;
    let C_Ma_air_velocity_2_product = C_Ma * air_velocity_2_inv_product;
    let part_of_minus_minus_inv_sqrt_vx_sum_2 =
        sqrt_vx_minus_wind_product * C_Ma_air_velocity_2_product;
    let minus_minus_inv_sqrt_vx_sum =
        part_of_minus_minus_inv_sqrt_vx_sum_2 - part_of_minus_minus_inv_sqrt_vx_sum;
    let sqrt_vx_minus_wind_product_2 = p3_p4_p5_inv_p2 * sqrt_vx_minus_wind_x_q2_of;
    let part_of_minus_inv_sqrt_vx_minus_sum_2 =
        (inv_sqrt_vx_minus_product_2 - p_C_Mq) * sqrt_vx_minus_wind_product_2;
    let part_of_minus_inv_sqrt_vx_minus_sum_2_2 =
        q2_sq_two_plus_q1_product_7 * C_Ma_air_velocity_2_product;
    let inv_sqrt_vx_minus_product_3 = inv_sqrt_vx_minus_wind_x_of * inv_sqrt_vx_minus_product;
    let part_of_minus_inv_sqrt_vx_minus_sum_2_4 =
        air_velocity_2_alpha_C_sum * inv_sqrt_vx_minus_product_3;
    let part_of_minus_inv_sqrt_vx_minus_sum_2_3 =
        part_of_minus_inv_sqrt_vx_minus_sum_2_2 - part_of_minus_inv_sqrt_vx_minus_sum_2;
    let minus_inv_sqrt_vx_minus_sum_2 =
        part_of_minus_inv_sqrt_vx_minus_sum_2_3 + part_of_minus_inv_sqrt_vx_minus_sum_2_4;
    let vx_minus_wind_x_q2_product_3 = vx_minus_wind_x_q2_sum * inv_sqrt_vx_minus_wind_x_of;
    let inv_sqrt_vx_minus_product_4 = inv_sqrt_vx_minus_product * r_C_Rr;
    let minus_minus_inv_sqrt_vx_sum_2 =
        inv_sqrt_vx_minus_product_4 - minus_inv_sqrt_vx_minus_sum_2 * vx_minus_wind_x_q2_product_3;
    let part_of_minus_minus_inv_product_sum =
        q2_sq_two_plus_minus_n1_sum * minus_minus_inv_sqrt_vx_sum_2;
    let air_velocity_2_inv_product_2 = air_velocity_2 * inv_sqrt_vx_minus_wind_x_of;
    let inv_sqrt_vx_minus_product_5 = inv_sqrt_vx_minus_product * alpha_C_Ma;
    let minus_inv_sqrt_vx_sum =
        minus_inv_sqrt_vx_minus_sum_2 * air_velocity_2_inv_product_2 - inv_sqrt_vx_minus_product_5;
    let part_of_minus_minus_inv_product_sum_2 =
        part_of_minus_minus_inv_product_sum - minus_inv_sqrt_vx_sum * two_q1_q2_minus_q3_q0;
    let minus_minus_inv_product_sum =
        minus_minus_inv_sqrt_vx_sum * q3_q1_plus_q2_q0_two - part_of_minus_minus_inv_product_sum_2;
    let part_of_minus_minus_inv_product_sum_2_5 =
        minus_minus_inv_sqrt_vx_sum * q3_q2_minus_q1_q0_two;
    let part_of_minus_minus_inv_product_sum_2_3 =
        q1_sq_two_plus_minus_n1_sum * minus_inv_sqrt_vx_sum;
    let part_of_minus_minus_inv_product_sum_2_2 =
        minus_minus_inv_sqrt_vx_sum_2 * two_q1_q2_plus_q3_q0;
    let part_of_minus_minus_inv_product_sum_2_4 =
        part_of_minus_minus_inv_product_sum_2_2 - part_of_minus_minus_inv_product_sum_2_3;
    let minus_minus_inv_product_sum_2 =
        part_of_minus_minus_inv_product_sum_2_5 + part_of_minus_minus_inv_product_sum_2_4;
    let part_of_minus_inv_sqrt_vx_sum_2 = q2_sq_two_plus_q1_sq_sum * minus_minus_inv_sqrt_vx_sum;
    let part_of_minus_inv_sqrt_vx_sum_2_2 =
        part_of_minus_inv_sqrt_vx_sum_2 - minus_minus_inv_sqrt_vx_sum_2 * two_q3_q1_minus_q2_q0;
    let minus_inv_sqrt_vx_sum_2 =
        minus_inv_sqrt_vx_sum * two_q3_q2_plus_q1_q0 - part_of_minus_inv_sqrt_vx_sum_2_2;
    let part_of_d_p_dot_d_q0 = minus_q1_vy_minus_wind_sum * minus_minus_inv_sqrt_vx_sum;
    let part_of_d_p_dot_d_q0_2 =
        part_of_d_p_dot_d_q0 - minus_q1_vz_minus_wind_sum * minus_inv_sqrt_vx_sum;
    let part_of_d_p_dot_d_q0_3 =
        part_of_d_p_dot_d_q0_2 + minus_q2_vz_minus_wind_sum * minus_minus_inv_sqrt_vx_sum_2;
    let part_of_d_p_dot_d_q1 = two_vx_minus_wind_x_q3_sum * minus_minus_inv_sqrt_vx_sum;
    let part_of_d_p_dot_d_q1_2 =
        part_of_d_p_dot_d_q1 + two_vx_minus_wind_x_q2_sum * minus_inv_sqrt_vx_sum;
    let part_of_d_p_dot_d_q1_3 =
        part_of_d_p_dot_d_q1_2 + minus_minus_inv_sqrt_vx_sum_2 * two_q3_vz_minus_product;
    let part_of_d_p_dot_d_q2 = vz_minus_wind_z_q0_two_sum * minus_minus_inv_sqrt_vx_sum_2;
    let part_of_d_p_dot_d_q2_2 =
        two_q3_vy_minus_wind_y_sum * minus_minus_inv_sqrt_vx_sum - part_of_d_p_dot_d_q2;
    let part_of_d_p_dot_d_q2_3 =
        part_of_d_p_dot_d_q2_2 + minus_inv_sqrt_vx_sum * two_q3_vz_minus_product_2;
    let part_of_d_p_dot_d_q3 = minus_minus_inv_sqrt_vx_sum * two_q2_vy_minus_product;
    let part_of_d_p_dot_d_q3_2 =
        part_of_d_p_dot_d_q3 - vx_minus_wind_x_q0_two_sum * minus_inv_sqrt_vx_sum;
    let part_of_d_p_dot_d_q3_3 =
        part_of_d_p_dot_d_q3_2 - minus_vy_minus_wind_y_sum * minus_minus_inv_sqrt_vx_sum_2;
    let r_n1_minus_I_a_inv_part = n1_minus_inv_p2_p1 * r;
    let minus_air_velocity_2_r_sum = vx_minus_wind_x_q2_sum * alpha_C_Ma - air_velocity_2 * r_C_Rr;
    let inv_sqrt_vx_minus_product_6 = inv_sqrt_vx_minus_wind_x_of * minus_air_velocity_2_r_sum;
    let q_C_Mq = C_Mq * q;
    let minus_inv_sqrt_vx_minus_sum_3 =
        nonzero_sqrt_vx_minus_of * q_C_Mq - inv_sqrt_vx_minus_product_6;
    let part_of_minus_minus_inv_sqrt_vx_sum_3 =
        minus_inv_sqrt_vx_minus_sum_3 * q2_sq_two_plus_q1_product_8;
    let vx_minus_wind_x_q2_product_4 = C_Ma * vx_minus_wind_x_q2_product;
    let part_of_minus_minus_inv_sqrt_vx_sum_3_2 =
        sqrt_vx_minus_wind_product * vx_minus_wind_x_q2_product_4;
    let minus_minus_inv_sqrt_vx_sum_3 =
        part_of_minus_minus_inv_sqrt_vx_sum_3_2 - part_of_minus_minus_inv_sqrt_vx_sum_3;
    let part_of_minus_minus_inv_product_sum_3_3 =
        minus_minus_inv_sqrt_vx_sum_3 * q3_q1_plus_q2_q0_two;
    let part_of_minus_inv_sqrt_vx_minus_sum_4 =
        (inv_sqrt_vx_minus_product_6 - q_C_Mq) * sqrt_vx_minus_wind_product_2;
    let part_of_minus_inv_sqrt_vx_minus_sum_4_2 =
        q2_sq_two_plus_q1_product_7 * vx_minus_wind_x_q2_product_4;
    let part_of_minus_inv_sqrt_vx_minus_sum_4_4 =
        minus_air_velocity_2_r_sum * inv_sqrt_vx_minus_product_3;
    let part_of_minus_inv_sqrt_vx_minus_sum_4_3 =
        part_of_minus_inv_sqrt_vx_minus_sum_4_2 - part_of_minus_inv_sqrt_vx_minus_sum_4;
    let minus_inv_sqrt_vx_minus_sum_4 =
        part_of_minus_inv_sqrt_vx_minus_sum_4_3 + part_of_minus_inv_sqrt_vx_minus_sum_4_4;
    let inv_sqrt_vx_minus_sum =
        inv_sqrt_vx_minus_product_5 - minus_inv_sqrt_vx_minus_sum_4 * vx_minus_wind_x_q2_product_3;
    let part_of_minus_minus_inv_product_sum_3 = q2_sq_two_plus_minus_n1_sum * inv_sqrt_vx_minus_sum;
    let inv_sqrt_vx_minus_sum_2 =
        inv_sqrt_vx_minus_product_4 + minus_inv_sqrt_vx_minus_sum_4 * air_velocity_2_inv_product_2;
    let part_of_minus_minus_inv_product_sum_3_2 =
        part_of_minus_minus_inv_product_sum_3 - inv_sqrt_vx_minus_sum_2 * two_q1_q2_minus_q3_q0;
    let minus_minus_inv_product_sum_3 =
        part_of_minus_minus_inv_product_sum_3_3 - part_of_minus_minus_inv_product_sum_3_2;
    let part_of_minus_minus_inv_product_sum_4_3 =
        minus_minus_inv_sqrt_vx_sum_3 * q3_q2_minus_q1_q0_two;
    let part_of_minus_minus_inv_product_sum_4 =
        q1_sq_two_plus_minus_n1_sum * inv_sqrt_vx_minus_sum_2;
    let part_of_minus_minus_inv_product_sum_4_2 =
        part_of_minus_minus_inv_product_sum_4 - inv_sqrt_vx_minus_sum * two_q1_q2_plus_q3_q0;
    let minus_minus_inv_product_sum_4 =
        part_of_minus_minus_inv_product_sum_4_3 - part_of_minus_minus_inv_product_sum_4_2;
    let part_of_inv_sqrt_vx_minus_sum_3 = q2_sq_two_plus_q1_sq_sum * minus_minus_inv_sqrt_vx_sum_3;
    let part_of_inv_sqrt_vx_minus_sum_3_2 =
        part_of_inv_sqrt_vx_minus_sum_3 - inv_sqrt_vx_minus_sum * two_q3_q1_minus_q2_q0;
    let inv_sqrt_vx_minus_sum_3 =
        inv_sqrt_vx_minus_sum_2 * two_q3_q2_plus_q1_q0 - part_of_inv_sqrt_vx_minus_sum_3_2;
    let part_of_d_q_dot_d_q0 = minus_q1_vy_minus_wind_sum * minus_minus_inv_sqrt_vx_sum_3;
    let part_of_d_q_dot_d_q0_2 =
        part_of_d_q_dot_d_q0 - minus_q1_vz_minus_wind_sum * inv_sqrt_vx_minus_sum_2;
    let part_of_d_q_dot_d_q0_3 =
        part_of_d_q_dot_d_q0_2 + minus_q2_vz_minus_wind_sum * inv_sqrt_vx_minus_sum;
    let part_of_d_q_dot_d_q1 = two_vx_minus_wind_x_q3_sum * minus_minus_inv_sqrt_vx_sum_3;
    let part_of_d_q_dot_d_q1_2 =
        part_of_d_q_dot_d_q1 + two_vx_minus_wind_x_q2_sum * inv_sqrt_vx_minus_sum_2;
    let part_of_d_q_dot_d_q1_3 =
        part_of_d_q_dot_d_q1_2 + inv_sqrt_vx_minus_sum * two_q3_vz_minus_product;
    let part_of_d_q_dot_d_q2 = two_q3_vy_minus_wind_y_sum * minus_minus_inv_sqrt_vx_sum_3;
    let part_of_d_q_dot_d_q2_2 =
        part_of_d_q_dot_d_q2 - vz_minus_wind_z_q0_two_sum * inv_sqrt_vx_minus_sum;
    let part_of_d_q_dot_d_q2_3 =
        part_of_d_q_dot_d_q2_2 + inv_sqrt_vx_minus_sum_2 * two_q3_vz_minus_product_2;
    let part_of_d_q_dot_d_q3 = minus_minus_inv_sqrt_vx_sum_3 * two_q2_vy_minus_product;
    let part_of_d_q_dot_d_q3_2 =
        part_of_d_q_dot_d_q3 - vx_minus_wind_x_q0_two_sum * inv_sqrt_vx_minus_sum_2;
    let part_of_d_q_dot_d_q3_3 =
        part_of_d_q_dot_d_q3_2 - minus_vy_minus_wind_y_sum * inv_sqrt_vx_minus_sum;
    let V_inv_m = inv_p0 * V;
    let A_rho_inv_m_V_inv_m = inv_p0_p5_p4 * V_inv_m;
    let rho_V_inv_m = rho * V_inv_m;
    let A_V_inv_m = A * V_inv_m;
    let part_of_q3_q1_plus_q2_q0_sum = q1_q2_minus_q3_q0_sum * q2_sq_two_plus_q1_product_6;
    let q3_q1_plus_q2_q0_sum =
        q3_q1_plus_q2_q0 * sqrt_vx_minus_wind_x_q2_of + part_of_q3_q1_plus_q2_q0_sum;
    let V_A_rho_inv_m_alpha = V_A_rho_inv_m * alpha;
    let q3_q1_plus_q2_q0_q2_sum =
        q3_q1_plus_q2_q0 * q2_sq_two_plus_q1_sum - q1_q2_minus_q3_q0_sum * nonzero_sqrt_vx_minus_of;
    let alpha_V_A_rho_inv_m_alpha = alpha * V_A_rho_inv_m_alpha;
    let minus_minus_minus_minus_sum = -minus_minus_minus_q2_sq_sum;
    let minus_minus_q1_q2_minus_sum = -minus_q1_q2_minus_q3_q0_sum;
    let part_of_q3_q2_minus_q1_q0_sum = q1_q2_plus_q3_q0_vx_sum * q2_sq_two_plus_q1_product_6;
    let q3_q2_minus_q1_q0_sum =
        q3_q2_minus_q1_q0 * sqrt_vx_minus_wind_x_q2_of - part_of_q3_q2_minus_q1_q0_sum;
    let part_of_q3_q2_minus_q1_q0_sum_2 = q1_q2_plus_q3_q0_vx_sum * nonzero_sqrt_vx_minus_of;
    let q3_q2_minus_q1_q0_sum_2 =
        q3_q2_minus_q1_q0 * q2_sq_two_plus_q1_sum + part_of_q3_q2_minus_q1_q0_sum_2;
    let minus_minus_minus_q2_sq_sum_2 = -minus_minus_q2_sq_two_sum_2;
    let minus_V_A_rho_inv_m_sum = -V_A_rho_inv_m_minus_sum_3;
    let part_of_minus_q3_q1_minus_sum = minus_q3_q1_minus_q2_q0_sum * q2_sq_two_plus_q1_product_6;
    let minus_q3_q1_minus_sum =
        part_of_minus_q3_q1_minus_sum - sqrt_vx_minus_wind_x_q2_of * q2_sq_two_plus_q1_product;
    let part_of_minus_minus_q3_q1_minus_sum =
        -(minus_q3_q1_minus_q2_q0_sum * nonzero_sqrt_vx_minus_of);
    let minus_minus_q3_q1_minus_sum =
        part_of_minus_minus_q3_q1_minus_sum - q2_sq_two_plus_q1_sum * q2_sq_two_plus_q1_product;
    let minus_minus_q2_sq_two_sum_3 = -minus_q2_sq_two_product_sum_8;
    let minus_minus_q2_sq_two_sum_4 = -minus_q2_sq_two_product_sum_9;
    let r_inv_I_d = inv_p2 * r;
    let q_r_inv_I_d = q * r_inv_I_d;
    let inv_I_d_q2_sq_two_product = inv_p2 * q2_sq_two_plus_q1_product_2;
    let A_rho_inv_part_d_product = p3_p4_p5_inv_p2 * inv_I_d_q2_sq_two_product;
    let part_of_d_p_dot_d_I_d =
        p1_inv_p2 * q_r_inv_I_d - minus_inv_sqrt_vx_minus_sum * A_rho_inv_part_d_product;
    let A_rho_inv_I_d_q2_sq_product = p4_p5 * inv_I_d_q2_sq_two_product;
    let inv_I_d_d_q2_sq_two_product = inv_p2_p3 * q2_sq_two_plus_q1_product_2;
    let rho_inv_I_d_d_q2_sq_product = rho * inv_I_d_d_q2_sq_two_product;
    let A_inv_I_d_d_q2_sq_product = A * inv_I_d_d_q2_sq_two_product;
    let minus_minus_minus_inv_sum = -minus_minus_inv_product_sum;
    let minus_minus_minus_inv_sum_2 = -minus_minus_inv_product_sum_2;
    let minus_minus_inv_sqrt_vx_sum_4 = -minus_inv_sqrt_vx_sum_2;
    let p_r_inv_I_d = p * r_inv_I_d;
    let part_of_d_q_dot_d_I_d =
        minus_p1_inv_p2 * p_r_inv_I_d - minus_inv_sqrt_vx_minus_sum_3 * A_rho_inv_part_d_product;
    let minus_minus_minus_inv_sum_3 = -minus_minus_inv_product_sum_3;
    let minus_minus_minus_inv_sum_4 = -minus_minus_inv_product_sum_4;
    let minus_inv_sqrt_vx_minus_sum_5 = -inv_sqrt_vx_minus_sum_3;
    let minus_minus_minus_q2_sq_sum_3 = -minus_minus_q2_sq_sum_3;
    let minus_minus_q2_sq_two_product_sum_5 = -minus_q2_sq_two_product_sum_5;
    let minus_q3_q2_plus_q1_q0_V_sum_2 = -q3_q2_plus_q1_q0_V_sum_2;
    let minus_half_p = -half_p;
    let minus_half_q = -half_q;
    let minus_half_r = -half_r;
    let minus_q1_half = -q1_half;
    let minus_q2_half = -q2_half;
    let minus_q3_half = -q3_half;
    let minus_half_q_2 = -half_q;
    let minus_q3_half_2 = -q3_half;
    let minus_half_r_2 = -half_r;
    let minus_q1_half_2 = -q1_half;
    let minus_half_p_2 = -half_p;
    let minus_q2_half_2 = -q2_half;
    let minus_r_n1_minus_I_a_inv_part = -r_n1_minus_I_a_inv_part;
    let minus_minus_minus_q2_sq_product = -(minus_minus_q2_sq_two_sum * A_rho_inv_m_V_inv_m);
    let minus_minus_q2_sq_two_product = -(minus_q2_sq_two_product_sum * A_rho_inv_m_V_inv_m);
    let minus_minus_q2_sq_two_product_2 = -(minus_q2_sq_two_product_sum_2 * rho_V_inv_m);
    let minus_minus_q2_sq_two_product_3 = -(minus_q2_sq_two_product_sum_2 * A_V_inv_m);
    let minus_q_r_inv_I_d = -q_r_inv_I_d;
    let minus_alpha_air_velocity_product = -(alpha * air_velocity_2_inv_product);
    let minus_r_vx_minus_wind_x_q2_product = -(r * vx_minus_wind_x_q2_product);
    let minus_alpha_vx_minus_wind_product = -(alpha * vx_minus_wind_x_q2_product);

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    dx[3] = vx_dot;
    dx[4] = vy_dot;
    dx[5] = vz_dot;
    dx[6] = T::splat(-0.5) * (q1 * p + q2 * q + q3 * r);
    dx[7] = T::splat(-0.5) * (q3 * q - q0 * p - q2 * r);
    dx[8] = T::splat(-0.5) * (q1 * r - q0 * q - q3 * p);
    dx[9] = T::splat(-0.5) * (q2 * p - q0 * r - q1 * q);
    dx[10] = p_dot;
    dx[11] = q_dot;
    dx[12] = r_dot;

    j[0] = T::splat(1.0); // d_x_dot_d_vx
    j[1] = T::splat(1.0); // d_y_dot_d_vy
    j[2] = T::splat(1.0); // d_z_dot_d_vz
    j[3] = minus_minus_minus_q2_sq_sum_3; // d_vx_dot_d_vx
    j[4] = minus_minus_minus_q2_sq_sum; // d_vx_dot_d_vy
    j[5] = minus_q1_q2_minus_q3_q0_sum; // d_vx_dot_d_vz
    j[6] = part_of_d_vx_dot_d_q0_5; // d_vx_dot_d_q0
    j[7] = part_of_d_vx_dot_d_q1_4; // d_vx_dot_d_q1
    j[8] = part_of_d_vx_dot_d_q2_4 - T::splat(2.0) * part_of_d_vx_dot_d_q2; // d_vx_dot_d_q2
    j[9] = part_of_d_vx_dot_d_q3_4 - T::splat(2.0) * part_of_d_vx_dot_d_q3; // d_vx_dot_d_q3
    j[10] = minus_minus_q2_sq_two_sum_2; // d_vy_dot_d_vx
    j[11] = minus_minus_q2_sq_two_product_sum_5; // d_vy_dot_d_vy
    j[12] = V_A_rho_inv_m_minus_sum_3; // d_vy_dot_d_vz
    j[13] = part_of_d_vy_dot_d_q0_5; // d_vy_dot_d_q0
    j[14] = part_of_d_vy_dot_d_q1_4 + T::splat(2.0) * part_of_d_vy_dot_d_q1; // d_vy_dot_d_q1
    j[15] = part_of_d_vy_dot_d_q2_4; // d_vy_dot_d_q2
    j[16] = part_of_d_vy_dot_d_q3_4 + T::splat(2.0) * part_of_d_vy_dot_d_q3; // d_vy_dot_d_q3
    j[17] = minus_q2_sq_two_product_sum_8; // d_vz_dot_d_vx
    j[18] = minus_q2_sq_two_product_sum_9; // d_vz_dot_d_vy
    j[19] = minus_q3_q2_plus_q1_q0_V_sum_2; // d_vz_dot_d_vz
    j[20] = part_of_d_vz_dot_d_q0_4 - q2_vx_minus_wind_x_product; // d_vz_dot_d_q0
    j[21] = part_of_d_vz_dot_d_q1_4 - T::splat(2.0) * part_of_d_vz_dot_d_q1; // d_vz_dot_d_q1
    j[22] = part_of_d_vz_dot_d_q2_4 - T::splat(2.0) * part_of_d_vz_dot_d_q2; // d_vz_dot_d_q2
    j[23] = part_of_d_vz_dot_d_q3_4; // d_vz_dot_d_q3
    j[24] = minus_half_p; // d_q0_dot_d_q1
    j[25] = minus_half_q; // d_q0_dot_d_q2
    j[26] = minus_half_r; // d_q0_dot_d_q3
    j[27] = minus_q1_half; // d_q0_dot_d_p
    j[28] = minus_q2_half; // d_q0_dot_d_q
    j[29] = minus_q3_half; // d_q0_dot_d_r
    j[30] = half_p; // d_q1_dot_d_q0
    j[31] = half_r; // d_q1_dot_d_q2
    j[32] = minus_half_q_2; // d_q1_dot_d_q3
    j[33] = q0_half; // d_q1_dot_d_p
    j[34] = minus_q3_half_2; // d_q1_dot_d_q
    j[35] = q2_half; // d_q1_dot_d_r
    j[36] = half_q; // d_q2_dot_d_q0
    j[37] = minus_half_r_2; // d_q2_dot_d_q1
    j[38] = half_p; // d_q2_dot_d_q3
    j[39] = q3_half; // d_q2_dot_d_p
    j[40] = q0_half; // d_q2_dot_d_q
    j[41] = minus_q1_half_2; // d_q2_dot_d_r
    j[42] = half_r; // d_q3_dot_d_q0
    j[43] = half_q; // d_q3_dot_d_q1
    j[44] = minus_half_p_2; // d_q3_dot_d_q2
    j[45] = minus_q2_half_2; // d_q3_dot_d_p
    j[46] = q1_half; // d_q3_dot_d_q
    j[47] = q0_half; // d_q3_dot_d_r
    j[48] = minus_minus_inv_product_sum; // d_p_dot_d_vx
    j[49] = minus_minus_inv_product_sum_2; // d_p_dot_d_vy
    j[50] = minus_inv_sqrt_vx_sum_2; // d_p_dot_d_vz
    j[51] = T::splat(2.0) * part_of_d_p_dot_d_q0_3; // d_p_dot_d_q0
    j[52] = part_of_d_p_dot_d_q1_3; // d_p_dot_d_q1
    j[53] = part_of_d_p_dot_d_q2_3; // d_p_dot_d_q2
    j[54] = part_of_d_p_dot_d_q3_3; // d_p_dot_d_q3
    j[55] = C_Mq_q2_sq_two_plus_product; // d_p_dot_d_p
    j[56] = r_n1_minus_I_a_inv_part; // d_p_dot_d_q
    j[57] = q_n1_minus_part_part_sum; // d_p_dot_d_r
    j[58] = minus_minus_inv_product_sum_3; // d_q_dot_d_vx
    j[59] = minus_minus_inv_product_sum_4; // d_q_dot_d_vy
    j[60] = inv_sqrt_vx_minus_sum_3; // d_q_dot_d_vz
    j[61] = T::splat(2.0) * part_of_d_q_dot_d_q0_3; // d_q_dot_d_q0
    j[62] = part_of_d_q_dot_d_q1_3; // d_q_dot_d_q1
    j[63] = part_of_d_q_dot_d_q2_3; // d_q_dot_d_q2
    j[64] = part_of_d_q_dot_d_q3_3; // d_q_dot_d_q3
    j[65] = minus_r_n1_minus_I_a_inv_part; // d_q_dot_d_p
    j[66] = C_Mq_q2_sq_two_plus_product; // d_q_dot_d_q
    j[67] = minus_p_n1_minus_part_sum; // d_q_dot_d_r
    j[68] = p14_inv_p1; // d_r_dot_d_r

    jp[0] = minus_minus_minus_q2_sq_product; // d_vx_dot_d_m
    jp[1] = minus_minus_q2_sq_two_sum * rho_V_inv_m; // d_vx_dot_d_A
    jp[2] = minus_minus_q2_sq_two_sum * A_V_inv_m; // d_vx_dot_d_rho
    jp[3] = V_A_rho_inv_m * q3_q1_plus_q2_q0_sum; // d_vx_dot_d_C_L0
    jp[4] = q3_q1_plus_q2_q0_sum * V_A_rho_inv_m_alpha; // d_vx_dot_d_C_La
    jp[5] = V_A_rho_inv_m * q3_q1_plus_q2_q0_q2_sum; // d_vx_dot_d_C_D0
    jp[6] = q3_q1_plus_q2_q0_q2_sum * alpha_V_A_rho_inv_m_alpha; // d_vx_dot_d_C_Da
    jp[7] = minus_minus_q2_sq_sum_3; // d_vx_dot_d_wind_x
    jp[8] = minus_minus_minus_minus_sum; // d_vx_dot_d_wind_y
    jp[9] = minus_minus_q1_q2_minus_sum; // d_vx_dot_d_wind_z
    jp[10] = minus_minus_q2_sq_two_product; // d_vy_dot_d_m
    jp[11] = minus_q2_sq_two_product_sum * rho_V_inv_m; // d_vy_dot_d_A
    jp[12] = minus_q2_sq_two_product_sum * A_V_inv_m; // d_vy_dot_d_rho
    jp[13] = V_A_rho_inv_m * q3_q2_minus_q1_q0_sum; // d_vy_dot_d_C_L0
    jp[14] = q3_q2_minus_q1_q0_sum * V_A_rho_inv_m_alpha; // d_vy_dot_d_C_La
    jp[15] = V_A_rho_inv_m * q3_q2_minus_q1_q0_sum_2; // d_vy_dot_d_C_D0
    jp[16] = q3_q2_minus_q1_q0_sum_2 * alpha_V_A_rho_inv_m_alpha; // d_vy_dot_d_C_Da
    jp[17] = minus_minus_minus_q2_sq_sum_2; // d_vy_dot_d_wind_x
    jp[18] = minus_q2_sq_two_product_sum_5; // d_vy_dot_d_wind_y
    jp[19] = minus_V_A_rho_inv_m_sum; // d_vy_dot_d_wind_z
    jp[20] = minus_q2_sq_two_product_sum_2 * A_rho_inv_m_V_inv_m; // d_vz_dot_d_m
    jp[21] = minus_minus_q2_sq_two_product_2; // d_vz_dot_d_A
    jp[22] = minus_minus_q2_sq_two_product_3; // d_vz_dot_d_rho
    jp[23] = T::splat(-1.0); // d_vz_dot_d_g
    jp[24] = V_A_rho_inv_m * minus_q3_q1_minus_sum; // d_vz_dot_d_C_L0
    jp[25] = minus_q3_q1_minus_sum * V_A_rho_inv_m_alpha; // d_vz_dot_d_C_La
    jp[26] = V_A_rho_inv_m * minus_minus_q3_q1_minus_sum; // d_vz_dot_d_C_D0
    jp[27] = minus_minus_q3_q1_minus_sum * alpha_V_A_rho_inv_m_alpha; // d_vz_dot_d_C_Da
    jp[28] = minus_minus_q2_sq_two_sum_3; // d_vz_dot_d_wind_x
    jp[29] = minus_minus_q2_sq_two_sum_4; // d_vz_dot_d_wind_y
    jp[30] = q3_q2_plus_q1_q0_V_sum_2; // d_vz_dot_d_wind_z
    jp[31] = minus_q_r_inv_I_d; // d_p_dot_d_I_a
    jp[32] = part_of_d_p_dot_d_I_d; // d_p_dot_d_I_d
    jp[33] = minus_inv_sqrt_vx_minus_sum * A_rho_inv_I_d_q2_sq_product; // d_p_dot_d_d
    jp[34] = minus_inv_sqrt_vx_minus_sum * rho_inv_I_d_d_q2_sq_product; // d_p_dot_d_A
    jp[35] = minus_inv_sqrt_vx_minus_sum * A_inv_I_d_d_q2_sq_product; // d_p_dot_d_rho
    jp[36] = minus_alpha_air_velocity_product; // d_p_dot_d_C_Ma
    jp[37] = p * q2_sq_two_plus_q1_product_4; // d_p_dot_d_C_Mq
    jp[38] = minus_r_vx_minus_wind_x_q2_product; // d_p_dot_d_C_Rr
    jp[39] = minus_minus_minus_inv_sum; // d_p_dot_d_wind_x
    jp[40] = minus_minus_minus_inv_sum_2; // d_p_dot_d_wind_y
    jp[41] = minus_minus_inv_sqrt_vx_sum_4; // d_p_dot_d_wind_z
    jp[42] = p_r_inv_I_d; // d_q_dot_d_I_a
    jp[43] = part_of_d_q_dot_d_I_d; // d_q_dot_d_I_d
    jp[44] = minus_inv_sqrt_vx_minus_sum_3 * A_rho_inv_I_d_q2_sq_product; // d_q_dot_d_d
    jp[45] = minus_inv_sqrt_vx_minus_sum_3 * rho_inv_I_d_d_q2_sq_product; // d_q_dot_d_A
    jp[46] = minus_inv_sqrt_vx_minus_sum_3 * A_inv_I_d_d_q2_sq_product; // d_q_dot_d_rho
    jp[47] = minus_alpha_vx_minus_wind_product; // d_q_dot_d_C_Ma
    jp[48] = q * q2_sq_two_plus_q1_product_4; // d_q_dot_d_C_Mq
    jp[49] = r * air_velocity_2_inv_product; // d_q_dot_d_C_Rr
    jp[50] = minus_minus_minus_inv_sum_3; // d_q_dot_d_wind_x
    jp[51] = minus_minus_minus_inv_sum_4; // d_q_dot_d_wind_y
    jp[52] = minus_inv_sqrt_vx_minus_sum_5; // d_q_dot_d_wind_z
    jp[53] = minus_inv_p1_p14_inv_p1 * r; // d_r_dot_d_I_a
    jp[54] = inv_p1 * r; // d_r_dot_d_C_Nr
}
