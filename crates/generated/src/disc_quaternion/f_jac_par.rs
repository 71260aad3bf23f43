// Written by `hyzer generate`; changes belong in the model.
//! `disc_quaternion`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 654 operations: 212 add, 405 mul, 2 div, 31 neg, 2 sqrt, 1 call, 1 select.
/// `prepare` takes 14 operations for it.
#[inline(always)]
pub fn f_jac_par<T: Real>(
    _time: T,
    state: &[T; 13],
    parameters: &[T; 18],
    prepared: &[T; 17],
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
    let inv_m_rho_A = prepared[0];
    let one_minus_inv_I_d_I_a = prepared[2];
    let C_Nr_inv_I_a = prepared[3];
    let d_rho_A_inv_I_d = prepared[4];
    let two_C_Da = prepared[5];
    let rho_A = prepared[7];
    let inv_m = prepared[8];
    let inv_I_d = prepared[9];
    let I_a_inv_I_d = prepared[10];
    let inv_I_d_d = prepared[11];
    let inv_I_a = prepared[12];
    let minus_I_a_inv_I_d = prepared[13];
    let minus_inv_I_a_d_r_dot_d_r = prepared[14];
    let q2_two = T::splat(2.0) * q2;
    let q2_sq_two = q2 * q2_two;
    let q1_two = T::splat(2.0) * q1;
    let q1_sq_two = q1 * q1_two;
    let q1_sq_two_minus_one_sum = q2_sq_two + q1_sq_two - T::splat(1.0);
    let vz_minus_wind_z = vz - wind_z;
    let vx_minus_wind_x = vx - wind_x;
    let q1_q3 = q3 * q1;
    let q0_q2 = q2 * q0;
    let q0_q2_plus_q1_q3 = q1_q3 + q0_q2;
    let q3_q2 = q3 * q2;
    let q1_q0 = q1 * q0;
    let q1_q0_plus_q3_q2 = q1_q0 - q3_q2;
    let minus_vy_minus_wind_y = wind_y - vy;
    let vy_minus_wind_y_product_sum =
        vx_minus_wind_x * q0_q2_plus_q1_q3 + q1_q0_plus_q3_q2 * minus_vy_minus_wind_y;

    // disc_quaternion.hyz:55  let air_velocity = in_C(velocity - wind);
    let minus_air_velocity_3 =
        q1_sq_two_minus_one_sum * vz_minus_wind_z - T::splat(2.0) * vy_minus_wind_y_product_sum;
    let q3_two = T::splat(2.0) * q3;
    let q3_sq_two_minus_one = q3 * q3_two - T::splat(1.0);
    let q2_sq_two_plus_q3_sq_sum = q2_sq_two + q3_sq_two_minus_one;
    let q1_q2 = q1 * q2;
    let q0_q3 = q3 * q0;
    let q0_q3_plus_q1_q2 = q1_q2 + q0_q3;
    let minus_q0_q2_plus_q1_q3 = q1_q3 - q0_q2;
    let vz_minus_wind_z_product_sum =
        vz_minus_wind_z * minus_q0_q2_plus_q1_q3 - minus_vy_minus_wind_y * q0_q3_plus_q1_q2;
    let minus_air_velocity_1 =
        vx_minus_wind_x * q2_sq_two_plus_q3_sq_sum - T::splat(2.0) * vz_minus_wind_z_product_sum;
    let q1_sq_two_plus_q3_sq_sum = q1_sq_two + q3_sq_two_minus_one;
    let minus_q0_q3_plus_q1_q2 = q1_q2 - q0_q3;
    let q1_q0_plus_q3_q2_2 = q3_q2 + q1_q0;
    let q1_q0_plus_q3_q2_vz_sum =
        vx_minus_wind_x * minus_q0_q3_plus_q1_q2 + vz_minus_wind_z * q1_q0_plus_q3_q2_2;
    let air_velocity_2 =
        minus_vy_minus_wind_y * q1_sq_two_plus_q3_sq_sum + T::splat(2.0) * q1_q0_plus_q3_q2_vz_sum;
    let air_velocity_12_sq =
        minus_air_velocity_1 * minus_air_velocity_1 + air_velocity_2 * air_velocity_2;
    let V_sq = minus_air_velocity_3 * minus_air_velocity_3 + air_velocity_12_sq;

    // disc_quaternion.hyz:57  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let V_inv_m_rho_A = inv_m_rho_A * V;
    let air_velocity_12 = air_velocity_12_sq.sqrt();

    // disc_quaternion.hyz:62  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);

    // disc_quaternion.hyz:66  let C_L = C_L0 + C_La*alpha;
    let C_L = C_L0 + C_La * alpha;

    // disc_quaternion.hyz:67  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_D0 + C_Da * alpha * alpha;
    let air_velocity_12_C_D_sum = air_velocity_12 * C_D - minus_air_velocity_3 * C_L;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let air_velocity_12_C_D_product = air_velocity_12_C_D_sum * inv_air_velocity_12;
    let q2_sq_two_plus_q3_product = T::splat(0.5) * q2_sq_two_plus_q3_sq_sum;
    let minus_q0_q3_plus_q1_sum =
        minus_q0_q3_plus_q1_q2 * air_velocity_2 + minus_air_velocity_1 * q2_sq_two_plus_q3_product;
    let part_of_q0_q2_plus_q1_q3_sum = air_velocity_12_C_D_product * minus_q0_q3_plus_q1_sum;
    let minus_air_velocity_3_C_sum = air_velocity_12 * C_L + minus_air_velocity_3 * C_D;
    let q0_q2_plus_q1_q3_sum =
        q0_q2_plus_q1_q3 * minus_air_velocity_3_C_sum - part_of_q0_q2_plus_q1_q3_sum;

    // disc_quaternion.hyz:50  velocity (vx, vy, vz) in N;
    let vx_dot = V_inv_m_rho_A * q0_q2_plus_q1_q3_sum;
    let q1_sq_two_plus_q3_product = T::splat(0.5) * q1_sq_two_plus_q3_sq_sum;
    let q0_q3_plus_q1_q2_sum =
        q0_q3_plus_q1_q2 * minus_air_velocity_1 + air_velocity_2 * q1_sq_two_plus_q3_product;
    let part_of_minus_q1_q0_plus_q3_sum = air_velocity_12_C_D_product * q0_q3_plus_q1_q2_sum;
    let minus_q1_q0_plus_q3_sum =
        part_of_minus_q1_q0_plus_q3_sum - q1_q0_plus_q3_q2 * minus_air_velocity_3_C_sum;
    let vy_dot = V_inv_m_rho_A * minus_q1_q0_plus_q3_sum;
    let minus_q1_q0_plus_q3_q2_sum =
        minus_q0_q2_plus_q1_q3 * minus_air_velocity_1 - q1_q0_plus_q3_q2_2 * air_velocity_2;
    let q1_sq_two_minus_one_sum_half = T::splat(0.5) * q1_sq_two_minus_one_sum;
    let part_of_minus_q1_sq_two_minus = minus_air_velocity_3_C_sum * q1_sq_two_minus_one_sum_half;
    let minus_q1_sq_two_minus_one_sum_2 =
        air_velocity_12_C_D_product * minus_q1_q0_plus_q3_q2_sum - part_of_minus_q1_sq_two_minus;
    let vz_dot = V_inv_m_rho_A * minus_q1_sq_two_minus_one_sum_2 - g;
    let q3_r_plus_q2_q_plus_q1_p = q1 * p + q2 * q + q3 * r;
    let q3_q_minus_q2_r_minus_q0_p = q3 * q - q0 * p - q2 * r;
    let q1_r_minus_q3_p_minus_q0_q = q1 * r - q0 * q - q3 * p;
    let q2_p_minus_q1_q_minus_q0_r = q2 * p - q0 * r - q1 * q;
    let V_sq_half = T::splat(0.5) * V_sq;
    let V_sq_half_d_inv_part_rho_A = d_rho_A_inv_I_d * V_sq_half;
    let inv_air_velocity_12_product = inv_air_velocity_12 * V_sq_half_d_inv_part_rho_A;
    let minus_air_velocity_product = minus_air_velocity_1 * inv_air_velocity_12_product;
    let minus_C_Rr_minus_air_sum = one_minus_inv_I_d_I_a * q - C_Rr * minus_air_velocity_product;
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let V_sq_half_d_inv_product = V_sq_half_d_inv_part_rho_A * nonzero_air_velocity_12;
    let V_sq_half_d_inv_product_2 = C_Mq * V_sq_half_d_inv_product;
    let alpha_C_Ma = C_Ma * alpha;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12_product;
    let part_of_p_dot = r * minus_C_Rr_minus_air_sum + p * V_sq_half_d_inv_product_2;

    // disc_quaternion.hyz:51  angular velocity (p, q, r) in C;
    let p_dot = part_of_p_dot - alpha_C_Ma * air_velocity_2_inv_product;
    let C_Rr_air_velocity_sum = C_Rr * air_velocity_2_inv_product - one_minus_inv_I_d_I_a * p;
    let part_of_q_dot = r * C_Rr_air_velocity_sum + q * V_sq_half_d_inv_product_2;
    let q_dot = part_of_q_dot - minus_air_velocity_product * alpha_C_Ma;
    let r_dot = C_Nr_inv_I_a * r;
    let inv_V = V.recip_or_zero();
    let inv_V_inv_m_rho_A = inv_m_rho_A * inv_V;
    let minus_air_velocity_product_2 = minus_air_velocity_3 * inv_V_inv_m_rho_A;
    let part_of_d_vx_dot_d_minus_air_3 = q0_q2_plus_q1_q3_sum * minus_air_velocity_product_2;
    let alpha_two_C_Da = two_C_Da * alpha;
    let air_velocity_12_C_La_sum = C_La * air_velocity_12 + minus_air_velocity_3 * alpha_two_C_Da;
    let inv_V_sq = inv_V * inv_V;
    let air_velocity_12_inv_V_sq = air_velocity_12 * inv_V_sq;
    let C_D_plus_air_velocity_sum = C_D + air_velocity_12_C_La_sum * air_velocity_12_inv_V_sq;
    let minus_air_velocity_product_3 = minus_air_velocity_3 * inv_air_velocity_12;
    let minus_C_La_minus_air_sum =
        nonzero_air_velocity_12 * alpha_two_C_Da - C_La * minus_air_velocity_product_3;
    let minus_C_La_minus_sum =
        minus_C_La_minus_air_sum * air_velocity_12_inv_V_sq - C_L * inv_air_velocity_12;
    let part_of_d_vx_dot_d_minus_air = minus_q0_q3_plus_q1_sum * minus_C_La_minus_sum;
    let part_of_d_vx_dot_d_minus_air_2 =
        q0_q2_plus_q1_q3 * C_D_plus_air_velocity_sum - part_of_d_vx_dot_d_minus_air;
    let d_vx_dot_d_minus_air_velocity_3 =
        part_of_d_vx_dot_d_minus_air_3 + V_inv_m_rho_A * part_of_d_vx_dot_d_minus_air_2;
    let q0_q2_plus_q1_q3_two = T::splat(2.0) * q0_q2_plus_q1_q3;
    let V_inv_m_rho_A_air_product = V_inv_m_rho_A * air_velocity_12_C_D_product;
    let part_of_d_vx_dot_d_minus_air_4 = V_inv_m_rho_A_air_product * q2_sq_two_plus_q3_product;
    let minus_air_velocity_product_4 = minus_air_velocity_3 * inv_V_sq;
    let C_L_minus_air_velocity_sum = C_L - air_velocity_12_C_La_sum * minus_air_velocity_product_4;
    let part_of_minus_minus_C_La_minus = inv_air_velocity_12 * (C_D - air_velocity_12_C_D_product);
    let minus_minus_C_La_minus_sum =
        part_of_minus_minus_C_La_minus - minus_C_La_minus_air_sum * minus_air_velocity_product_4;
    let part_of_q0_q2_plus_q1_q3_sum_2 = minus_q0_q3_plus_q1_sum * minus_minus_C_La_minus_sum;
    let part_of_q0_q2_plus_q1_q3_sum_2_2 =
        q0_q2_plus_q1_q3 * C_L_minus_air_velocity_sum - part_of_q0_q2_plus_q1_q3_sum_2;
    let V_inv_m_rho_A_inv_product = V_inv_m_rho_A * inv_air_velocity_12;
    let part_of_q0_q2_plus_q1_q3_sum_2_3 =
        part_of_q0_q2_plus_q1_q3_sum_2_2 * V_inv_m_rho_A_inv_product;
    let q0_q2_plus_q1_q3_sum_2 =
        q0_q2_plus_q1_q3_sum * inv_V_inv_m_rho_A + part_of_q0_q2_plus_q1_q3_sum_2_3;
    let d_vx_dot_d_minus_air_velocity_1 =
        minus_air_velocity_1 * q0_q2_plus_q1_q3_sum_2 - part_of_d_vx_dot_d_minus_air_4;
    let part_of_d_vx_dot_d_vx = q2_sq_two_plus_q3_sq_sum * d_vx_dot_d_minus_air_velocity_1;
    let part_of_d_vx_dot_d_air_velocity = minus_q0_q3_plus_q1_q2 * V_inv_m_rho_A_air_product;
    let d_vx_dot_d_air_velocity_2 =
        air_velocity_2 * q0_q2_plus_q1_q3_sum_2 - part_of_d_vx_dot_d_air_velocity;
    let two_minus_q0_q3_plus_q1_q2 = T::splat(2.0) * minus_q0_q3_plus_q1_q2;
    let part_of_d_vx_dot_d_vx_2 =
        part_of_d_vx_dot_d_vx + d_vx_dot_d_air_velocity_2 * two_minus_q0_q3_plus_q1_q2;
    let d_vx_dot_d_vx =
        part_of_d_vx_dot_d_vx_2 - d_vx_dot_d_minus_air_velocity_3 * q0_q2_plus_q1_q3_two;
    let q1_q0_plus_q3_q2_two = T::splat(2.0) * q1_q0_plus_q3_q2;
    let two_q0_q3_plus_q1_q2 = T::splat(2.0) * q0_q3_plus_q1_q2;
    let part_of_d_vx_dot_d_vy = d_vx_dot_d_minus_air_velocity_1 * two_q0_q3_plus_q1_q2;
    let part_of_d_vx_dot_d_vy_2 =
        q1_sq_two_plus_q3_sq_sum * d_vx_dot_d_air_velocity_2 + part_of_d_vx_dot_d_vy;
    let d_vx_dot_d_vy =
        d_vx_dot_d_minus_air_velocity_3 * q1_q0_plus_q3_q2_two - part_of_d_vx_dot_d_vy_2;
    let two_q1_q0_plus_q3_q2_2 = T::splat(2.0) * q1_q0_plus_q3_q2_2;
    let two_minus_q0_q2_plus_q1_q3 = T::splat(2.0) * minus_q0_q2_plus_q1_q3;
    let part_of_d_vx_dot_d_vz = d_vx_dot_d_minus_air_velocity_1 * two_minus_q0_q2_plus_q1_q3;
    let part_of_d_vx_dot_d_vz_2 =
        q1_sq_two_minus_one_sum * d_vx_dot_d_minus_air_velocity_3 - part_of_d_vx_dot_d_vz;
    let d_vx_dot_d_vz =
        d_vx_dot_d_air_velocity_2 * two_q1_q0_plus_q3_q2_2 + part_of_d_vx_dot_d_vz_2;
    let vx_minus_wind_x_q2_two = vx_minus_wind_x * q2_two;
    let minus_vy_minus_wind_y_q1_two = minus_vy_minus_wind_y * q1_two;
    let minus_d_minus_air_velocity_3_d_q0 = vx_minus_wind_x_q2_two + minus_vy_minus_wind_y_q1_two;
    let part_of_d_vx_dot_d_q0 = d_vx_dot_d_minus_air_velocity_3 * minus_d_minus_air_velocity_3_d_q0;
    let vx_minus_wind_x_q3_two = vx_minus_wind_x * q3_two;
    let vz_minus_wind_z_q1_two = vz_minus_wind_z * q1_two;
    let d_air_velocity_2_d_q0 = vz_minus_wind_z_q1_two - vx_minus_wind_x_q3_two;
    let minus_vy_minus_wind_y_q3_two = minus_vy_minus_wind_y * q3_two;
    let vz_minus_wind_z_q2_two = vz_minus_wind_z * q2_two;
    let d_minus_air_velocity_1_d_q0 = minus_vy_minus_wind_y_q3_two + vz_minus_wind_z_q2_two;
    let V_inv_m_rho_A_minus_product = V_inv_m_rho_A * minus_air_velocity_3_C_sum;
    let q2_V_inv_m_rho_A_product = q2 * V_inv_m_rho_A_minus_product;
    let air_velocity_2_V_product = air_velocity_2 * V_inv_m_rho_A_air_product;
    let q3_air_velocity_2_V_product = q3 * air_velocity_2_V_product;
    let part_of_d_vx_dot_d_q0_2 =
        d_vx_dot_d_air_velocity_2 * d_air_velocity_2_d_q0 - part_of_d_vx_dot_d_q0;
    let part_of_d_vx_dot_d_q0_3 =
        part_of_d_vx_dot_d_q0_2 + d_vx_dot_d_minus_air_velocity_1 * d_minus_air_velocity_1_d_q0;
    let d_vx_dot_d_q0 =
        part_of_d_vx_dot_d_q0_3 + q2_V_inv_m_rho_A_product + q3_air_velocity_2_V_product;
    let q1_n4 = T::splat(4.0) * q1;
    let q0_two = T::splat(2.0) * q0;
    let minus_vy_minus_wind_y_q0_two = minus_vy_minus_wind_y * q0_two;
    let d_minus_air_velocity_3_d_q1 =
        vz_minus_wind_z * q1_n4 - vx_minus_wind_x_q3_two - minus_vy_minus_wind_y_q0_two;
    let part_of_d_vx_dot_d_q1 = d_vx_dot_d_minus_air_velocity_3 * d_minus_air_velocity_3_d_q1;
    let vz_minus_wind_z_q0_two = vz_minus_wind_z * q0_two;
    let d_air_velocity_2_d_q1 =
        vx_minus_wind_x_q2_two + minus_vy_minus_wind_y * q1_n4 + vz_minus_wind_z_q0_two;
    let minus_vy_minus_wind_y_q2_two = minus_vy_minus_wind_y * q2_two;
    let vz_minus_wind_z_q3_two = vz_minus_wind_z * q3_two;
    let d_minus_air_velocity_1_d_q1 = minus_vy_minus_wind_y_q2_two - vz_minus_wind_z_q3_two;
    let q3_V_inv_m_rho_A_product = q3 * V_inv_m_rho_A_minus_product;
    let q2_air_velocity_2_V_product = q2 * air_velocity_2_V_product;
    let part_of_d_vx_dot_d_q1_2 =
        part_of_d_vx_dot_d_q1 + d_vx_dot_d_air_velocity_2 * d_air_velocity_2_d_q1;
    let part_of_d_vx_dot_d_q1_3 =
        part_of_d_vx_dot_d_q1_2 + d_vx_dot_d_minus_air_velocity_1 * d_minus_air_velocity_1_d_q1;
    let d_vx_dot_d_q1 =
        part_of_d_vx_dot_d_q1_3 + q3_V_inv_m_rho_A_product - q2_air_velocity_2_V_product;
    let vx_minus_wind_x_q0_two = vx_minus_wind_x * q0_two;
    let part_of_d_minus_air_velocity_3 =
        minus_vy_minus_wind_y_q3_two + T::splat(4.0) * q2 * vz_minus_wind_z;
    let d_minus_air_velocity_3_d_q2 = part_of_d_minus_air_velocity_3 - vx_minus_wind_x_q0_two;
    let part_of_d_vx_dot_d_q2 = d_vx_dot_d_minus_air_velocity_3 * d_minus_air_velocity_3_d_q2;
    let vx_minus_wind_x_q1_two = vx_minus_wind_x * q1_two;
    let d_air_velocity_2_d_q2 = vz_minus_wind_z_q3_two + vx_minus_wind_x_q1_two;
    let vx_minus_wind_x_n4 = T::splat(4.0) * vx_minus_wind_x;
    let d_minus_air_velocity_1_d_q2 =
        minus_vy_minus_wind_y_q1_two + vz_minus_wind_z_q0_two + q2 * vx_minus_wind_x_n4;
    let q0_V_inv_m_rho_A_product = q0 * V_inv_m_rho_A_minus_product;
    let q1_air_velocity_2_V_product = q1 * air_velocity_2_V_product;
    let minus_air_velocity_product_5 = minus_air_velocity_1 * V_inv_m_rho_A_air_product;
    let part_of_d_vx_dot_d_q2_2 =
        part_of_d_vx_dot_d_q2 + d_vx_dot_d_air_velocity_2 * d_air_velocity_2_d_q2;
    let part_of_d_vx_dot_d_q2_3 =
        part_of_d_vx_dot_d_q2_2 + d_vx_dot_d_minus_air_velocity_1 * d_minus_air_velocity_1_d_q2;
    let part_of_d_vx_dot_d_q2_4 =
        part_of_d_vx_dot_d_q2_3 + q0_V_inv_m_rho_A_product - q1_air_velocity_2_V_product;
    let d_vx_dot_d_q2 = part_of_d_vx_dot_d_q2_4 - q2_two * minus_air_velocity_product_5;
    let d_minus_air_velocity_3_d_q3 = minus_vy_minus_wind_y_q2_two - vx_minus_wind_x_q1_two;
    let part_of_d_vx_dot_d_q3 = d_vx_dot_d_minus_air_velocity_3 * d_minus_air_velocity_3_d_q3;
    let part_of_d_air_velocity_2_d_q3 = vz_minus_wind_z_q2_two - vx_minus_wind_x_q0_two;
    let d_air_velocity_2_d_q3 =
        part_of_d_air_velocity_2_d_q3 + T::splat(4.0) * q3 * minus_vy_minus_wind_y;
    let d_minus_air_velocity_1_d_q3 =
        minus_vy_minus_wind_y_q0_two - vz_minus_wind_z_q1_two + q3 * vx_minus_wind_x_n4;
    let q0_air_velocity_2_V_product = q0 * air_velocity_2_V_product;
    let q1_V_inv_m_rho_A_product = q1 * V_inv_m_rho_A_minus_product;
    let part_of_d_vx_dot_d_q3_2 =
        part_of_d_vx_dot_d_q3 + d_vx_dot_d_air_velocity_2 * d_air_velocity_2_d_q3;
    let part_of_d_vx_dot_d_q3_3 =
        part_of_d_vx_dot_d_q3_2 + d_vx_dot_d_minus_air_velocity_1 * d_minus_air_velocity_1_d_q3;
    let part_of_d_vx_dot_d_q3_4 =
        part_of_d_vx_dot_d_q3_3 + q0_air_velocity_2_V_product + q1_V_inv_m_rho_A_product;
    let d_vx_dot_d_q3 = part_of_d_vx_dot_d_q3_4 - q3_two * minus_air_velocity_product_5;
    let part_of_d_vy_dot_d_minus_air_2 = minus_q1_q0_plus_q3_sum * minus_air_velocity_product_2;
    let part_of_d_vy_dot_d_minus_air =
        q0_q3_plus_q1_q2_sum * minus_C_La_minus_sum - q1_q0_plus_q3_q2 * C_D_plus_air_velocity_sum;
    let d_vy_dot_d_minus_air_velocity_3 =
        part_of_d_vy_dot_d_minus_air_2 + V_inv_m_rho_A * part_of_d_vy_dot_d_minus_air;
    let part_of_minus_q1_q0_plus_q3_sum_2 = q0_q3_plus_q1_q2_sum * minus_minus_C_La_minus_sum;
    let part_of_minus_q1_q0_plus_q3_sum_3 =
        part_of_minus_q1_q0_plus_q3_sum_2 - q1_q0_plus_q3_q2 * C_L_minus_air_velocity_sum;
    let part_of_minus_q1_q0_plus_q3_sum_4 =
        part_of_minus_q1_q0_plus_q3_sum_3 * V_inv_m_rho_A_inv_product;
    let minus_q1_q0_plus_q3_sum_2 =
        minus_q1_q0_plus_q3_sum * inv_V_inv_m_rho_A + part_of_minus_q1_q0_plus_q3_sum_4;
    let part_of_d_vy_dot_d_minus_air_3 = minus_air_velocity_1 * minus_q1_q0_plus_q3_sum_2;
    let d_vy_dot_d_minus_air_velocity_1 =
        q0_q3_plus_q1_q2 * V_inv_m_rho_A_air_product + part_of_d_vy_dot_d_minus_air_3;
    let part_of_d_vy_dot_d_vx = q2_sq_two_plus_q3_sq_sum * d_vy_dot_d_minus_air_velocity_1;
    let part_of_d_vy_dot_d_air_velocity = V_inv_m_rho_A_air_product * q1_sq_two_plus_q3_product;
    let d_vy_dot_d_air_velocity_2 =
        part_of_d_vy_dot_d_air_velocity + air_velocity_2 * minus_q1_q0_plus_q3_sum_2;
    let part_of_d_vy_dot_d_vx_2 =
        part_of_d_vy_dot_d_vx + d_vy_dot_d_air_velocity_2 * two_minus_q0_q3_plus_q1_q2;
    let d_vy_dot_d_vx =
        part_of_d_vy_dot_d_vx_2 - d_vy_dot_d_minus_air_velocity_3 * q0_q2_plus_q1_q3_two;
    let part_of_d_vy_dot_d_vy = d_vy_dot_d_minus_air_velocity_1 * two_q0_q3_plus_q1_q2;
    let part_of_d_vy_dot_d_vy_2 =
        q1_sq_two_plus_q3_sq_sum * d_vy_dot_d_air_velocity_2 + part_of_d_vy_dot_d_vy;
    let d_vy_dot_d_vy =
        d_vy_dot_d_minus_air_velocity_3 * q1_q0_plus_q3_q2_two - part_of_d_vy_dot_d_vy_2;
    let part_of_d_vy_dot_d_vz = d_vy_dot_d_minus_air_velocity_1 * two_minus_q0_q2_plus_q1_q3;
    let part_of_d_vy_dot_d_vz_2 =
        q1_sq_two_minus_one_sum * d_vy_dot_d_minus_air_velocity_3 - part_of_d_vy_dot_d_vz;
    let d_vy_dot_d_vz =
        d_vy_dot_d_air_velocity_2 * two_q1_q0_plus_q3_q2_2 + part_of_d_vy_dot_d_vz_2;
    let q3_minus_air_product = q3 * minus_air_velocity_product_5;
    let part_of_d_vy_dot_d_q0 = minus_d_minus_air_velocity_3_d_q0 * d_vy_dot_d_minus_air_velocity_3;
    let part_of_d_vy_dot_d_q0_2 =
        q3_minus_air_product - q1_V_inv_m_rho_A_product - part_of_d_vy_dot_d_q0;
    let part_of_d_vy_dot_d_q0_3 =
        part_of_d_vy_dot_d_q0_2 + d_air_velocity_2_d_q0 * d_vy_dot_d_air_velocity_2;
    let d_vy_dot_d_q0 =
        part_of_d_vy_dot_d_q0_3 + d_minus_air_velocity_1_d_q0 * d_vy_dot_d_minus_air_velocity_1;
    let q2_minus_air_product = q2 * minus_air_velocity_product_5;
    let part_of_d_vy_dot_d_q1 = d_minus_air_velocity_3_d_q1 * d_vy_dot_d_minus_air_velocity_3;
    let part_of_d_vy_dot_d_q1_2 =
        q2_minus_air_product - q0_V_inv_m_rho_A_product + part_of_d_vy_dot_d_q1;
    let part_of_d_vy_dot_d_q1_3 =
        part_of_d_vy_dot_d_q1_2 + d_air_velocity_2_d_q1 * d_vy_dot_d_air_velocity_2;
    let part_of_d_vy_dot_d_q1_4 =
        part_of_d_vy_dot_d_q1_3 + d_minus_air_velocity_1_d_q1 * d_vy_dot_d_minus_air_velocity_1;
    let d_vy_dot_d_q1 = part_of_d_vy_dot_d_q1_4 + q1_two * air_velocity_2_V_product;
    let q1_minus_air_product = q1 * minus_air_velocity_product_5;
    let part_of_d_vy_dot_d_q2 =
        q3_V_inv_m_rho_A_product + d_minus_air_velocity_3_d_q2 * d_vy_dot_d_minus_air_velocity_3;
    let part_of_d_vy_dot_d_q2_2 =
        part_of_d_vy_dot_d_q2 + d_air_velocity_2_d_q2 * d_vy_dot_d_air_velocity_2;
    let part_of_d_vy_dot_d_q2_3 =
        part_of_d_vy_dot_d_q2_2 + d_minus_air_velocity_1_d_q2 * d_vy_dot_d_minus_air_velocity_1;
    let d_vy_dot_d_q2 = part_of_d_vy_dot_d_q2_3 + q1_minus_air_product;
    let q0_minus_air_product = q0 * minus_air_velocity_product_5;
    let part_of_d_vy_dot_d_q3 =
        q2_V_inv_m_rho_A_product + d_minus_air_velocity_3_d_q3 * d_vy_dot_d_minus_air_velocity_3;
    let part_of_d_vy_dot_d_q3_2 =
        part_of_d_vy_dot_d_q3 + d_air_velocity_2_d_q3 * d_vy_dot_d_air_velocity_2;
    let part_of_d_vy_dot_d_q3_3 =
        part_of_d_vy_dot_d_q3_2 + d_minus_air_velocity_1_d_q3 * d_vy_dot_d_minus_air_velocity_1;
    let d_vy_dot_d_q3 =
        part_of_d_vy_dot_d_q3_3 + q0_minus_air_product + q3_two * air_velocity_2_V_product;
    let part_of_d_vz_dot_d_minus_air_3 =
        minus_q1_sq_two_minus_one_sum_2 * minus_air_velocity_product_2;
    let part_of_d_vz_dot_d_minus_air = C_D_plus_air_velocity_sum * q1_sq_two_minus_one_sum_half;
    let part_of_d_vz_dot_d_minus_air_2 =
        part_of_d_vz_dot_d_minus_air - minus_q1_q0_plus_q3_q2_sum * minus_C_La_minus_sum;
    let d_vz_dot_d_minus_air_velocity_3 =
        part_of_d_vz_dot_d_minus_air_3 - V_inv_m_rho_A * part_of_d_vz_dot_d_minus_air_2;
    let d_vz_dot_d_minus_air_velocity_1 = minus_q0_q2_plus_q1_q3 * V_inv_m_rho_A_air_product;
    let part_of_minus_minus_q1_sq_two = C_L_minus_air_velocity_sum * q1_sq_two_minus_one_sum_half;
    let part_of_minus_minus_q1_sq_two_2 =
        part_of_minus_minus_q1_sq_two - minus_q1_q0_plus_q3_q2_sum * minus_minus_C_La_minus_sum;
    let part_of_minus_minus_q1_sq_two_3 =
        part_of_minus_minus_q1_sq_two_2 * V_inv_m_rho_A_inv_product;
    let minus_minus_q1_sq_two_sum =
        part_of_minus_minus_q1_sq_two_3 - minus_q1_sq_two_minus_one_sum_2 * inv_V_inv_m_rho_A;
    let d_vz_dot_d_minus_air_velocity_1_2 =
        d_vz_dot_d_minus_air_velocity_1 - minus_air_velocity_1 * minus_minus_q1_sq_two_sum;
    let minus_d_vz_dot_d_air_velocity_2 =
        q1_q0_plus_q3_q2_2 * V_inv_m_rho_A_air_product + air_velocity_2 * minus_minus_q1_sq_two_sum;
    let part_of_d_vz_dot_d_vx = minus_d_vz_dot_d_air_velocity_2 * two_minus_q0_q3_plus_q1_q2;
    let part_of_d_vz_dot_d_vx_2 =
        q2_sq_two_plus_q3_sq_sum * d_vz_dot_d_minus_air_velocity_1_2 - part_of_d_vz_dot_d_vx;
    let d_vz_dot_d_vx =
        part_of_d_vz_dot_d_vx_2 - d_vz_dot_d_minus_air_velocity_3 * q0_q2_plus_q1_q3_two;
    let part_of_d_vz_dot_d_vy = q1_sq_two_plus_q3_sq_sum * minus_d_vz_dot_d_air_velocity_2;
    let part_of_d_vz_dot_d_vy_2 =
        d_vz_dot_d_minus_air_velocity_1_2 * two_q0_q3_plus_q1_q2 - part_of_d_vz_dot_d_vy;
    let d_vz_dot_d_vy =
        d_vz_dot_d_minus_air_velocity_3 * q1_q0_plus_q3_q2_two - part_of_d_vz_dot_d_vy_2;
    let part_of_d_vz_dot_d_vz = d_vz_dot_d_minus_air_velocity_1_2 * two_minus_q0_q2_plus_q1_q3;
    let part_of_d_vz_dot_d_vz_2 =
        q1_sq_two_minus_one_sum * d_vz_dot_d_minus_air_velocity_3 - part_of_d_vz_dot_d_vz;
    let d_vz_dot_d_vz =
        part_of_d_vz_dot_d_vz_2 - minus_d_vz_dot_d_air_velocity_2 * two_q1_q0_plus_q3_q2_2;
    let part_of_d_vz_dot_d_q0 = minus_d_minus_air_velocity_3_d_q0 * d_vz_dot_d_minus_air_velocity_3;
    let part_of_d_vz_dot_d_q0_4 = d_air_velocity_2_d_q0 * minus_d_vz_dot_d_air_velocity_2;
    let part_of_d_vz_dot_d_q0_2 = d_minus_air_velocity_1_d_q0 * d_vz_dot_d_minus_air_velocity_1_2;
    let part_of_d_vz_dot_d_q0_3 =
        part_of_d_vz_dot_d_q0_2 - q1_air_velocity_2_V_product - q2_minus_air_product;
    let d_vz_dot_d_q0 = part_of_d_vz_dot_d_q0_3 - part_of_d_vz_dot_d_q0 - part_of_d_vz_dot_d_q0_4;
    let part_of_d_vz_dot_d_q1 = d_minus_air_velocity_3_d_q1 * d_vz_dot_d_minus_air_velocity_3;
    let part_of_d_vz_dot_d_q1_2 =
        q3_minus_air_product - q0_air_velocity_2_V_product + part_of_d_vz_dot_d_q1;
    let part_of_d_vz_dot_d_q1_3 =
        part_of_d_vz_dot_d_q1_2 - d_air_velocity_2_d_q1 * minus_d_vz_dot_d_air_velocity_2;
    let part_of_d_vz_dot_d_q1_4 =
        part_of_d_vz_dot_d_q1_3 + d_minus_air_velocity_1_d_q1 * d_vz_dot_d_minus_air_velocity_1_2;
    let d_vz_dot_d_q1 = part_of_d_vz_dot_d_q1_4 - q1_two * V_inv_m_rho_A_minus_product;
    let part_of_d_vz_dot_d_q2_2 = d_air_velocity_2_d_q2 * minus_d_vz_dot_d_air_velocity_2;
    let part_of_d_vz_dot_d_q2 =
        d_minus_air_velocity_3_d_q2 * d_vz_dot_d_minus_air_velocity_3 - q3_air_velocity_2_V_product;
    let part_of_d_vz_dot_d_q2_3 =
        part_of_d_vz_dot_d_q2 - q0_minus_air_product - part_of_d_vz_dot_d_q2_2;
    let part_of_d_vz_dot_d_q2_4 =
        part_of_d_vz_dot_d_q2_3 + d_minus_air_velocity_1_d_q2 * d_vz_dot_d_minus_air_velocity_1_2;
    let d_vz_dot_d_q2 = part_of_d_vz_dot_d_q2_4 - q2_two * V_inv_m_rho_A_minus_product;
    let part_of_d_vz_dot_d_q3 = d_minus_air_velocity_3_d_q3 * d_vz_dot_d_minus_air_velocity_3;
    let part_of_d_vz_dot_d_q3_2 =
        q1_minus_air_product - q2_air_velocity_2_V_product + part_of_d_vz_dot_d_q3;
    let part_of_d_vz_dot_d_q3_3 =
        part_of_d_vz_dot_d_q3_2 - d_air_velocity_2_d_q3 * minus_d_vz_dot_d_air_velocity_2;
    let d_vz_dot_d_q3 =
        part_of_d_vz_dot_d_q3_3 + d_minus_air_velocity_1_d_q3 * d_vz_dot_d_minus_air_velocity_1_2;
    let minus_d_q3_dot_d_q2 = T::splat(0.5) * p;
    let minus_d_q1_dot_d_q3 = T::splat(0.5) * q;
    let minus_d_q2_dot_d_q1 = T::splat(0.5) * r;
    let minus_d_q2_dot_d_r = T::splat(0.5) * q1;
    let minus_d_q3_dot_d_p = T::splat(0.5) * q2;
    let minus_d_q1_dot_d_q = T::splat(0.5) * q3;
    let d_q1_dot_d_p = T::splat(0.5) * q0;
    let r_C_Rr = C_Rr * r;
    let air_velocity_2_alpha_C_sum = air_velocity_2 * alpha_C_Ma + minus_air_velocity_1 * r_C_Rr;
    let C_Mq_nonzero_air_velocity_12 = C_Mq * nonzero_air_velocity_12;
    let minus_inv_air_velocity_sum =
        p * C_Mq_nonzero_air_velocity_12 - inv_air_velocity_12 * air_velocity_2_alpha_C_sum;
    let minus_inv_air_product = d_rho_A_inv_I_d * minus_inv_air_velocity_sum;
    let C_Ma_air_velocity_2_product = C_Ma * air_velocity_2_inv_product;
    let part_of_d_p_dot_d_minus_air = air_velocity_12_inv_V_sq * C_Ma_air_velocity_2_product;
    let d_p_dot_d_minus_air_velocity_3 =
        minus_air_velocity_3 * minus_inv_air_product - part_of_d_p_dot_d_minus_air;
    let part_of_d_p_dot_d_air_velocity = minus_air_velocity_product_4 * C_Ma_air_velocity_2_product;
    let inv_air_velocity_12_product_2 = inv_air_velocity_12 * inv_air_velocity_12_product;
    let part_of_d_p_dot_d_air_velocity_3 =
        air_velocity_2_alpha_C_sum * inv_air_velocity_12_product_2;
    let part_of_d_p_dot_d_air_velocity_2 =
        air_velocity_12 * minus_inv_air_product + part_of_d_p_dot_d_air_velocity;
    let d_p_dot_d_air_velocity_12 =
        part_of_d_p_dot_d_air_velocity_2 + part_of_d_p_dot_d_air_velocity_3;
    let minus_air_velocity_product_6 = minus_air_velocity_1 * inv_air_velocity_12;
    let inv_air_velocity_12_product_3 = inv_air_velocity_12_product * r_C_Rr;
    let d_p_dot_d_minus_air_velocity_1 =
        d_p_dot_d_air_velocity_12 * minus_air_velocity_product_6 - inv_air_velocity_12_product_3;
    let part_of_d_p_dot_d_vx = q2_sq_two_plus_q3_sq_sum * d_p_dot_d_minus_air_velocity_1;
    let air_velocity_2_inv_product_2 = air_velocity_2 * inv_air_velocity_12;
    let inv_air_velocity_12_product_4 = inv_air_velocity_12_product * alpha_C_Ma;
    let d_p_dot_d_air_velocity_2 =
        d_p_dot_d_air_velocity_12 * air_velocity_2_inv_product_2 - inv_air_velocity_12_product_4;
    let part_of_d_p_dot_d_vx_2 =
        part_of_d_p_dot_d_vx + d_p_dot_d_air_velocity_2 * two_minus_q0_q3_plus_q1_q2;
    let d_p_dot_d_vx =
        part_of_d_p_dot_d_vx_2 - d_p_dot_d_minus_air_velocity_3 * q0_q2_plus_q1_q3_two;
    let part_of_d_p_dot_d_vy = d_p_dot_d_minus_air_velocity_1 * two_q0_q3_plus_q1_q2;
    let part_of_d_p_dot_d_vy_2 =
        q1_sq_two_plus_q3_sq_sum * d_p_dot_d_air_velocity_2 + part_of_d_p_dot_d_vy;
    let d_p_dot_d_vy =
        d_p_dot_d_minus_air_velocity_3 * q1_q0_plus_q3_q2_two - part_of_d_p_dot_d_vy_2;
    let part_of_d_p_dot_d_vz = d_p_dot_d_minus_air_velocity_1 * two_minus_q0_q2_plus_q1_q3;
    let part_of_d_p_dot_d_vz_2 =
        q1_sq_two_minus_one_sum * d_p_dot_d_minus_air_velocity_3 - part_of_d_p_dot_d_vz;
    let d_p_dot_d_vz = d_p_dot_d_air_velocity_2 * two_q1_q0_plus_q3_q2_2 + part_of_d_p_dot_d_vz_2;
    let part_of_d_p_dot_d_q0 = minus_d_minus_air_velocity_3_d_q0 * d_p_dot_d_minus_air_velocity_3;
    let part_of_d_p_dot_d_q0_2 =
        d_air_velocity_2_d_q0 * d_p_dot_d_air_velocity_2 - part_of_d_p_dot_d_q0;
    let d_p_dot_d_q0 =
        part_of_d_p_dot_d_q0_2 + d_minus_air_velocity_1_d_q0 * d_p_dot_d_minus_air_velocity_1;
    let part_of_d_p_dot_d_q1 = d_minus_air_velocity_3_d_q1 * d_p_dot_d_minus_air_velocity_3;
    let part_of_d_p_dot_d_q1_2 =
        part_of_d_p_dot_d_q1 + d_air_velocity_2_d_q1 * d_p_dot_d_air_velocity_2;
    let d_p_dot_d_q1 =
        part_of_d_p_dot_d_q1_2 + d_minus_air_velocity_1_d_q1 * d_p_dot_d_minus_air_velocity_1;
    let part_of_d_p_dot_d_q2 = d_minus_air_velocity_3_d_q2 * d_p_dot_d_minus_air_velocity_3;
    let part_of_d_p_dot_d_q2_2 =
        part_of_d_p_dot_d_q2 + d_air_velocity_2_d_q2 * d_p_dot_d_air_velocity_2;
    let d_p_dot_d_q2 =
        part_of_d_p_dot_d_q2_2 + d_minus_air_velocity_1_d_q2 * d_p_dot_d_minus_air_velocity_1;
    let part_of_d_p_dot_d_q3 = d_minus_air_velocity_3_d_q3 * d_p_dot_d_minus_air_velocity_3;
    let part_of_d_p_dot_d_q3_2 =
        part_of_d_p_dot_d_q3 + d_air_velocity_2_d_q3 * d_p_dot_d_air_velocity_2;
    let d_p_dot_d_q3 =
        part_of_d_p_dot_d_q3_2 + d_minus_air_velocity_1_d_q3 * d_p_dot_d_minus_air_velocity_1;
    let d_p_dot_d_q = one_minus_inv_I_d_I_a * r;
    let air_velocity_2_r_C_Rr_sum = air_velocity_2 * r_C_Rr - minus_air_velocity_1 * alpha_C_Ma;
    let inv_air_velocity_12_sum =
        inv_air_velocity_12 * air_velocity_2_r_C_Rr_sum + q * C_Mq_nonzero_air_velocity_12;
    let inv_air_velocity_12_product_5 = d_rho_A_inv_I_d * inv_air_velocity_12_sum;
    let minus_air_velocity_product_7 = C_Ma * minus_air_velocity_product;
    let part_of_d_q_dot_d_minus_air = air_velocity_12_inv_V_sq * minus_air_velocity_product_7;
    let d_q_dot_d_minus_air_velocity_3 =
        minus_air_velocity_3 * inv_air_velocity_12_product_5 - part_of_d_q_dot_d_minus_air;
    let part_of_d_q_dot_d_air_velocity =
        minus_air_velocity_product_4 * minus_air_velocity_product_7;
    let part_of_d_q_dot_d_air_velocity_3 =
        air_velocity_2_r_C_Rr_sum * inv_air_velocity_12_product_2;
    let part_of_d_q_dot_d_air_velocity_2 =
        air_velocity_12 * inv_air_velocity_12_product_5 + part_of_d_q_dot_d_air_velocity;
    let d_q_dot_d_air_velocity_12 =
        part_of_d_q_dot_d_air_velocity_2 - part_of_d_q_dot_d_air_velocity_3;
    let d_q_dot_d_minus_air_velocity_1 =
        d_q_dot_d_air_velocity_12 * minus_air_velocity_product_6 - inv_air_velocity_12_product_4;
    let part_of_d_q_dot_d_vx = q2_sq_two_plus_q3_sq_sum * d_q_dot_d_minus_air_velocity_1;
    let d_q_dot_d_air_velocity_2 =
        inv_air_velocity_12_product_3 + d_q_dot_d_air_velocity_12 * air_velocity_2_inv_product_2;
    let part_of_d_q_dot_d_vx_2 =
        part_of_d_q_dot_d_vx + d_q_dot_d_air_velocity_2 * two_minus_q0_q3_plus_q1_q2;
    let d_q_dot_d_vx =
        part_of_d_q_dot_d_vx_2 - d_q_dot_d_minus_air_velocity_3 * q0_q2_plus_q1_q3_two;
    let part_of_d_q_dot_d_vy = d_q_dot_d_minus_air_velocity_1 * two_q0_q3_plus_q1_q2;
    let part_of_d_q_dot_d_vy_2 =
        q1_sq_two_plus_q3_sq_sum * d_q_dot_d_air_velocity_2 + part_of_d_q_dot_d_vy;
    let d_q_dot_d_vy =
        d_q_dot_d_minus_air_velocity_3 * q1_q0_plus_q3_q2_two - part_of_d_q_dot_d_vy_2;
    let part_of_d_q_dot_d_vz = d_q_dot_d_minus_air_velocity_1 * two_minus_q0_q2_plus_q1_q3;
    let part_of_d_q_dot_d_vz_2 =
        q1_sq_two_minus_one_sum * d_q_dot_d_minus_air_velocity_3 - part_of_d_q_dot_d_vz;
    let d_q_dot_d_vz = d_q_dot_d_air_velocity_2 * two_q1_q0_plus_q3_q2_2 + part_of_d_q_dot_d_vz_2;
    let part_of_d_q_dot_d_q0 = minus_d_minus_air_velocity_3_d_q0 * d_q_dot_d_minus_air_velocity_3;
    let part_of_d_q_dot_d_q0_2 =
        d_air_velocity_2_d_q0 * d_q_dot_d_air_velocity_2 - part_of_d_q_dot_d_q0;
    let d_q_dot_d_q0 =
        part_of_d_q_dot_d_q0_2 + d_minus_air_velocity_1_d_q0 * d_q_dot_d_minus_air_velocity_1;
    let part_of_d_q_dot_d_q1 = d_minus_air_velocity_3_d_q1 * d_q_dot_d_minus_air_velocity_3;
    let part_of_d_q_dot_d_q1_2 =
        part_of_d_q_dot_d_q1 + d_air_velocity_2_d_q1 * d_q_dot_d_air_velocity_2;
    let d_q_dot_d_q1 =
        part_of_d_q_dot_d_q1_2 + d_minus_air_velocity_1_d_q1 * d_q_dot_d_minus_air_velocity_1;
    let part_of_d_q_dot_d_q2 = d_minus_air_velocity_3_d_q2 * d_q_dot_d_minus_air_velocity_3;
    let part_of_d_q_dot_d_q2_2 =
        part_of_d_q_dot_d_q2 + d_air_velocity_2_d_q2 * d_q_dot_d_air_velocity_2;
    let d_q_dot_d_q2 =
        part_of_d_q_dot_d_q2_2 + d_minus_air_velocity_1_d_q2 * d_q_dot_d_minus_air_velocity_1;
    let part_of_d_q_dot_d_q3 = d_minus_air_velocity_3_d_q3 * d_q_dot_d_minus_air_velocity_3;
    let part_of_d_q_dot_d_q3_2 =
        part_of_d_q_dot_d_q3 + d_air_velocity_2_d_q3 * d_q_dot_d_air_velocity_2;
    let d_q_dot_d_q3 =
        part_of_d_q_dot_d_q3_2 + d_minus_air_velocity_1_d_q3 * d_q_dot_d_minus_air_velocity_1;
    let V_inv_m = inv_m * V;
    let inv_m_rho_A_V_inv_m = inv_m_rho_A * V_inv_m;
    let rho_V_inv_m = rho * V_inv_m;
    let d_vx_dot_d_A = q0_q2_plus_q1_q3_sum * rho_V_inv_m;
    let A_V_inv_m = A * V_inv_m;
    let d_vx_dot_d_rho = q0_q2_plus_q1_q3_sum * A_V_inv_m;
    let q0_q2_plus_q1_q3_sum_3 =
        q0_q2_plus_q1_q3 * air_velocity_12 + minus_q0_q3_plus_q1_sum * minus_air_velocity_product_3;
    let d_vx_dot_d_C_L0 = V_inv_m_rho_A * q0_q2_plus_q1_q3_sum_3;
    let V_inv_m_rho_A_alpha = V_inv_m_rho_A * alpha;
    let d_vx_dot_d_C_La = q0_q2_plus_q1_q3_sum_3 * V_inv_m_rho_A_alpha;
    let q0_q2_plus_q1_q3_sum_4 =
        q0_q2_plus_q1_q3 * minus_air_velocity_3 - minus_q0_q3_plus_q1_sum * nonzero_air_velocity_12;
    let d_vx_dot_d_C_D0 = V_inv_m_rho_A * q0_q2_plus_q1_q3_sum_4;
    let alpha_V_inv_m_rho_A_alpha = alpha * V_inv_m_rho_A_alpha;
    let d_vx_dot_d_C_Da = q0_q2_plus_q1_q3_sum_4 * alpha_V_inv_m_rho_A_alpha;
    let minus_d_vx_dot_d_vx = -d_vx_dot_d_vx;
    let minus_d_vx_dot_d_vy = -d_vx_dot_d_vy;
    let minus_d_vx_dot_d_vz = -d_vx_dot_d_vz;
    let d_vy_dot_d_A = minus_q1_q0_plus_q3_sum * rho_V_inv_m;
    let d_vy_dot_d_rho = minus_q1_q0_plus_q3_sum * A_V_inv_m;
    let minus_q1_q0_plus_q3_q2_sum_2 =
        -(q1_q0_plus_q3_q2 * air_velocity_12) - q0_q3_plus_q1_q2_sum * minus_air_velocity_product_3;
    let d_vy_dot_d_C_L0 = V_inv_m_rho_A * minus_q1_q0_plus_q3_q2_sum_2;
    let d_vy_dot_d_C_La = minus_q1_q0_plus_q3_q2_sum_2 * V_inv_m_rho_A_alpha;
    let minus_q1_q0_plus_q3_q2_sum_3 =
        q0_q3_plus_q1_q2_sum * nonzero_air_velocity_12 - q1_q0_plus_q3_q2 * minus_air_velocity_3;
    let d_vy_dot_d_C_D0 = V_inv_m_rho_A * minus_q1_q0_plus_q3_q2_sum_3;
    let d_vy_dot_d_C_Da = minus_q1_q0_plus_q3_q2_sum_3 * alpha_V_inv_m_rho_A_alpha;
    let minus_d_vy_dot_d_vx = -d_vy_dot_d_vx;
    let minus_d_vy_dot_d_vy = -d_vy_dot_d_vy;
    let minus_d_vy_dot_d_vz = -d_vy_dot_d_vz;
    let minus_d_vz_dot_d_m = minus_q1_sq_two_minus_one_sum_2 * inv_m_rho_A_V_inv_m;
    let part_of_minus_minus_q1_q0_plus =
        -(minus_q1_q0_plus_q3_q2_sum * minus_air_velocity_product_3);
    let minus_minus_q1_q0_plus_sum =
        part_of_minus_minus_q1_q0_plus - air_velocity_12 * q1_sq_two_minus_one_sum_half;
    let d_vz_dot_d_C_L0 = V_inv_m_rho_A * minus_minus_q1_q0_plus_sum;
    let d_vz_dot_d_C_La = minus_minus_q1_q0_plus_sum * V_inv_m_rho_A_alpha;
    let part_of_minus_q1_q0_plus_q3_sum_5 = minus_q1_q0_plus_q3_q2_sum * nonzero_air_velocity_12;
    let minus_q1_q0_plus_q3_sum_3 =
        part_of_minus_q1_q0_plus_q3_sum_5 - minus_air_velocity_3 * q1_sq_two_minus_one_sum_half;
    let minus_d_vz_dot_d_vx = -d_vz_dot_d_vx;
    let minus_d_vz_dot_d_vy = -d_vz_dot_d_vy;
    let minus_d_vz_dot_d_vz = -d_vz_dot_d_vz;
    let r_inv_I_d = inv_I_d * r;
    let q_r_inv_I_d = q * r_inv_I_d;
    let inv_I_d_V_sq_half = inv_I_d * V_sq_half;
    let d_p_dot_d_I_d = I_a_inv_I_d * q_r_inv_I_d - inv_I_d_V_sq_half * minus_inv_air_product;
    let rho_A_inv_I_d_V_sq_half = rho_A * inv_I_d_V_sq_half;
    let inv_I_d_d_V_sq_half = inv_I_d_d * V_sq_half;
    let rho_inv_I_d_d_V_sq_half = rho * inv_I_d_d_V_sq_half;
    let A_inv_I_d_d_V_sq_half = A * inv_I_d_d_V_sq_half;
    let d_p_dot_d_C_Mq = p * V_sq_half_d_inv_product;
    let minus_d_p_dot_d_vx = -d_p_dot_d_vx;
    let minus_d_p_dot_d_vy = -d_p_dot_d_vy;
    let minus_d_p_dot_d_vz = -d_p_dot_d_vz;
    let d_q_dot_d_I_a = p * r_inv_I_d;
    let d_q_dot_d_I_d =
        minus_I_a_inv_I_d * d_q_dot_d_I_a - inv_I_d_V_sq_half * inv_air_velocity_12_product_5;
    let d_q_dot_d_C_Mq = q * V_sq_half_d_inv_product;
    let d_q_dot_d_C_Rr = r * air_velocity_2_inv_product;
    let minus_d_q_dot_d_vx = -d_q_dot_d_vx;
    let minus_d_q_dot_d_vy = -d_q_dot_d_vy;
    let minus_d_q_dot_d_vz = -d_q_dot_d_vz;
    let d_r_dot_d_C_Nr = inv_I_a * r;
    let d_q0_dot_d_q1 = -minus_d_q3_dot_d_q2;
    let d_q0_dot_d_q2 = -minus_d_q1_dot_d_q3;
    let d_q0_dot_d_q3 = -minus_d_q2_dot_d_q1;
    let d_q0_dot_d_p = -minus_d_q2_dot_d_r;
    let d_q0_dot_d_q = -minus_d_q3_dot_d_p;
    let d_q0_dot_d_r = -minus_d_q1_dot_d_q;
    let d_q_dot_d_p = -d_p_dot_d_q;
    let d_vx_dot_d_m = -(q0_q2_plus_q1_q3_sum * inv_m_rho_A_V_inv_m);
    let d_vy_dot_d_m = -(minus_q1_q0_plus_q3_sum * inv_m_rho_A_V_inv_m);
    let d_vz_dot_d_m = -minus_d_vz_dot_d_m;
    let d_p_dot_d_I_a = -q_r_inv_I_d;
    let d_p_dot_d_C_Ma = -(alpha * air_velocity_2_inv_product);
    let d_p_dot_d_C_Rr = -(r * minus_air_velocity_product);
    let d_q_dot_d_C_Ma = -(alpha * minus_air_velocity_product);

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    dx[3] = vx_dot;
    dx[4] = vy_dot;
    dx[5] = vz_dot;
    dx[6] = T::splat(-0.5) * q3_r_plus_q2_q_plus_q1_p;
    dx[7] = T::splat(-0.5) * q3_q_minus_q2_r_minus_q0_p;
    dx[8] = T::splat(-0.5) * q1_r_minus_q3_p_minus_q0_q;
    dx[9] = T::splat(-0.5) * q2_p_minus_q1_q_minus_q0_r;
    dx[10] = p_dot;
    dx[11] = q_dot;
    dx[12] = r_dot;

    j[0] = T::splat(1.0); // d_x_dot_d_vx
    j[1] = T::splat(1.0); // d_y_dot_d_vy
    j[2] = T::splat(1.0); // d_z_dot_d_vz
    j[3] = d_vx_dot_d_vx;
    j[4] = d_vx_dot_d_vy;
    j[5] = d_vx_dot_d_vz;
    j[6] = d_vx_dot_d_q0;
    j[7] = d_vx_dot_d_q1;
    j[8] = d_vx_dot_d_q2;
    j[9] = d_vx_dot_d_q3;
    j[10] = d_vy_dot_d_vx;
    j[11] = d_vy_dot_d_vy;
    j[12] = d_vy_dot_d_vz;
    j[13] = d_vy_dot_d_q0;
    j[14] = d_vy_dot_d_q1;
    j[15] = d_vy_dot_d_q2;
    j[16] = d_vy_dot_d_q3;
    j[17] = d_vz_dot_d_vx;
    j[18] = d_vz_dot_d_vy;
    j[19] = d_vz_dot_d_vz;
    j[20] = d_vz_dot_d_q0;
    j[21] = d_vz_dot_d_q1;
    j[22] = d_vz_dot_d_q2;
    j[23] = d_vz_dot_d_q3;
    j[24] = d_q0_dot_d_q1;
    j[25] = d_q0_dot_d_q2;
    j[26] = d_q0_dot_d_q3;
    j[27] = d_q0_dot_d_p;
    j[28] = d_q0_dot_d_q;
    j[29] = d_q0_dot_d_r;
    j[30] = minus_d_q3_dot_d_q2; // d_q1_dot_d_q0
    j[31] = minus_d_q2_dot_d_q1; // d_q1_dot_d_q2
    j[32] = d_q0_dot_d_q2; // d_q1_dot_d_q3
    j[33] = d_q1_dot_d_p;
    j[34] = d_q0_dot_d_r; // d_q1_dot_d_q
    j[35] = minus_d_q3_dot_d_p; // d_q1_dot_d_r
    j[36] = minus_d_q1_dot_d_q3; // d_q2_dot_d_q0
    j[37] = d_q0_dot_d_q3; // d_q2_dot_d_q1
    j[38] = minus_d_q3_dot_d_q2; // d_q2_dot_d_q3
    j[39] = minus_d_q1_dot_d_q; // d_q2_dot_d_p
    j[40] = d_q1_dot_d_p; // d_q2_dot_d_q
    j[41] = d_q0_dot_d_p; // d_q2_dot_d_r
    j[42] = minus_d_q2_dot_d_q1; // d_q3_dot_d_q0
    j[43] = minus_d_q1_dot_d_q3; // d_q3_dot_d_q1
    j[44] = d_q0_dot_d_q1; // d_q3_dot_d_q2
    j[45] = d_q0_dot_d_q; // d_q3_dot_d_p
    j[46] = minus_d_q2_dot_d_r; // d_q3_dot_d_q
    j[47] = d_q1_dot_d_p; // d_q3_dot_d_r
    j[48] = d_p_dot_d_vx;
    j[49] = d_p_dot_d_vy;
    j[50] = d_p_dot_d_vz;
    j[51] = d_p_dot_d_q0;
    j[52] = d_p_dot_d_q1;
    j[53] = d_p_dot_d_q2;
    j[54] = d_p_dot_d_q3;
    j[55] = V_sq_half_d_inv_product_2; // d_p_dot_d_p
    j[56] = d_p_dot_d_q;
    j[57] = minus_C_Rr_minus_air_sum; // d_p_dot_d_r
    j[58] = d_q_dot_d_vx;
    j[59] = d_q_dot_d_vy;
    j[60] = d_q_dot_d_vz;
    j[61] = d_q_dot_d_q0;
    j[62] = d_q_dot_d_q1;
    j[63] = d_q_dot_d_q2;
    j[64] = d_q_dot_d_q3;
    j[65] = d_q_dot_d_p;
    j[66] = V_sq_half_d_inv_product_2; // d_q_dot_d_q
    j[67] = C_Rr_air_velocity_sum; // d_q_dot_d_r
    j[68] = C_Nr_inv_I_a; // d_r_dot_d_r

    jp[0] = d_vx_dot_d_m;
    jp[1] = d_vx_dot_d_A;
    jp[2] = d_vx_dot_d_rho;
    jp[3] = d_vx_dot_d_C_L0;
    jp[4] = d_vx_dot_d_C_La;
    jp[5] = d_vx_dot_d_C_D0;
    jp[6] = d_vx_dot_d_C_Da;
    jp[7] = minus_d_vx_dot_d_vx; // d_vx_dot_d_wind_x
    jp[8] = minus_d_vx_dot_d_vy; // d_vx_dot_d_wind_y
    jp[9] = minus_d_vx_dot_d_vz; // d_vx_dot_d_wind_z
    jp[10] = d_vy_dot_d_m;
    jp[11] = d_vy_dot_d_A;
    jp[12] = d_vy_dot_d_rho;
    jp[13] = d_vy_dot_d_C_L0;
    jp[14] = d_vy_dot_d_C_La;
    jp[15] = d_vy_dot_d_C_D0;
    jp[16] = d_vy_dot_d_C_Da;
    jp[17] = minus_d_vy_dot_d_vx; // d_vy_dot_d_wind_x
    jp[18] = minus_d_vy_dot_d_vy; // d_vy_dot_d_wind_y
    jp[19] = minus_d_vy_dot_d_vz; // d_vy_dot_d_wind_z
    jp[20] = d_vz_dot_d_m;
    jp[21] = minus_q1_sq_two_minus_one_sum_2 * rho_V_inv_m; // d_vz_dot_d_A
    jp[22] = minus_q1_sq_two_minus_one_sum_2 * A_V_inv_m; // d_vz_dot_d_rho
    jp[23] = T::splat(-1.0); // d_vz_dot_d_g
    jp[24] = d_vz_dot_d_C_L0;
    jp[25] = d_vz_dot_d_C_La;
    jp[26] = V_inv_m_rho_A * minus_q1_q0_plus_q3_sum_3; // d_vz_dot_d_C_D0
    jp[27] = minus_q1_q0_plus_q3_sum_3 * alpha_V_inv_m_rho_A_alpha; // d_vz_dot_d_C_Da
    jp[28] = minus_d_vz_dot_d_vx; // d_vz_dot_d_wind_x
    jp[29] = minus_d_vz_dot_d_vy; // d_vz_dot_d_wind_y
    jp[30] = minus_d_vz_dot_d_vz; // d_vz_dot_d_wind_z
    jp[31] = d_p_dot_d_I_a;
    jp[32] = d_p_dot_d_I_d;
    jp[33] = minus_inv_air_velocity_sum * rho_A_inv_I_d_V_sq_half; // d_p_dot_d_d
    jp[34] = minus_inv_air_velocity_sum * rho_inv_I_d_d_V_sq_half; // d_p_dot_d_A
    jp[35] = minus_inv_air_velocity_sum * A_inv_I_d_d_V_sq_half; // d_p_dot_d_rho
    jp[36] = d_p_dot_d_C_Ma;
    jp[37] = d_p_dot_d_C_Mq;
    jp[38] = d_p_dot_d_C_Rr;
    jp[39] = minus_d_p_dot_d_vx; // d_p_dot_d_wind_x
    jp[40] = minus_d_p_dot_d_vy; // d_p_dot_d_wind_y
    jp[41] = minus_d_p_dot_d_vz; // d_p_dot_d_wind_z
    jp[42] = d_q_dot_d_I_a;
    jp[43] = d_q_dot_d_I_d;
    jp[44] = inv_air_velocity_12_sum * rho_A_inv_I_d_V_sq_half; // d_q_dot_d_d
    jp[45] = inv_air_velocity_12_sum * rho_inv_I_d_d_V_sq_half; // d_q_dot_d_A
    jp[46] = inv_air_velocity_12_sum * A_inv_I_d_d_V_sq_half; // d_q_dot_d_rho
    jp[47] = d_q_dot_d_C_Ma;
    jp[48] = d_q_dot_d_C_Mq;
    jp[49] = d_q_dot_d_C_Rr;
    jp[50] = minus_d_q_dot_d_vx; // d_q_dot_d_wind_x
    jp[51] = minus_d_q_dot_d_vy; // d_q_dot_d_wind_y
    jp[52] = minus_d_q_dot_d_vz; // d_q_dot_d_wind_z
    jp[53] = minus_inv_I_a_d_r_dot_d_r * r; // d_r_dot_d_I_a
    jp[54] = d_r_dot_d_C_Nr;
}
