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
    prepared: &[T; 18],
    dx: &mut [T; 13],
    j: &mut [T; 69],
    jp: &mut [T; 55],
) {
    let q2 = state[8];
    let q2_two = T::splat(2.0) * q2;
    let q3 = state[9];
    let q1 = state[7];
    let q1_q3 = q3 * q1;
    let q0 = state[6];
    let q0_q2 = q2 * q0;
    let q3_two = T::splat(2.0) * q3;
    let q1_two = T::splat(2.0) * q1;
    let vz = state[5];
    let wind_z = parameters[17];
    let vz_minus_wind_z = vz - wind_z;
    let q1_q2 = q1 * q2;
    let q0_q3 = q3 * q0;
    let q2_sq_two = q2 * q2_two;
    let vx = state[3];
    let wind_x = parameters[15];
    let vx_minus_wind_x = vx - wind_x;
    let q3_sq_two_minus_one = q3.mul_sub(q3_two, T::splat(1.0));
    let minus_q0_q2_plus_q1_q3 = q1_q3 - q0_q2;
    let q1_sq_two = q1 * q1_two;
    let q3_q2 = q3 * q2;
    let q1_q0 = q1 * q0;
    let wind_y = parameters[16];
    let vy = state[4];
    let minus_vy_minus_wind_y = wind_y - vy;
    let q0_q3_plus_q1_q2 = q1_q2 + q0_q3;
    let minus_q0_q3_plus_q1_q2 = q1_q2 - q0_q3;
    let q2_sq_two_plus_q3_sq_sum = q2_sq_two + q3_sq_two_minus_one;
    let part_of_vz_minus_wind_z_product = vz_minus_wind_z * minus_q0_q2_plus_q1_q3;
    let q1_sq_two_plus_q3_sq_sum = q1_sq_two + q3_sq_two_minus_one;
    let q1_q0_plus_q3_q2_2 = q3_q2 + q1_q0;
    let q0_q2_plus_q1_q3 = q1_q3 + q0_q2;
    let q1_q0_plus_q3_q2 = q1_q0 - q3_q2;
    let vz_minus_wind_z_product_sum =
        minus_vy_minus_wind_y.neg_mul_add(q0_q3_plus_q1_q2, part_of_vz_minus_wind_z_product);
    let part_of_minus_air_velocity_1 = vx_minus_wind_x * q2_sq_two_plus_q3_sq_sum;
    let part_of_air_velocity_2 = minus_vy_minus_wind_y * q1_sq_two_plus_q3_sq_sum;
    let q1_sq_two_minus_one_sum = q2_sq_two + q1_sq_two - T::splat(1.0);

    // disc_quaternion.hyz:68  let air_velocity = in_C(velocity - air);
    let minus_air_velocity_1 =
        vz_minus_wind_z_product_sum.neg_mul_add(T::splat(2.0), part_of_minus_air_velocity_1);
    let q1_q0_plus_q3_q2_vz_sum =
        vz_minus_wind_z.mul_add(q1_q0_plus_q3_q2_2, vx_minus_wind_x * minus_q0_q3_plus_q1_q2);
    let C_Rr = parameters[13];
    let r = state[12];
    let r_C_Rr = C_Rr * r;
    let air_velocity_2 = q1_q0_plus_q3_q2_vz_sum.mul_add(T::splat(2.0), part_of_air_velocity_2);
    let q2_sq_two_plus_q3_product = T::splat(0.5) * q2_sq_two_plus_q3_sq_sum;
    let C_Nr_inv_I_a = prepared[3];

    // disc_quaternion.hyz:51  angular velocity (p, q, r) in C;
    let r_dot = C_Nr_inv_I_a * r;
    dx[12] = r_dot;
    let d_q1_dot_d_p = T::splat(0.5) * q0;
    j[33] = d_q1_dot_d_p;
    j[40] = d_q1_dot_d_p; // d_q2_dot_d_q
    j[47] = d_q1_dot_d_p; // d_q3_dot_d_r
    let vy_minus_wind_y_product_sum =
        q1_q0_plus_q3_q2.mul_add(minus_vy_minus_wind_y, vx_minus_wind_x * q0_q2_plus_q1_q3);
    let minus_inv_I_a_d_r_dot_d_r = prepared[14];
    jp[53] = minus_inv_I_a_d_r_dot_d_r * r; // d_r_dot_d_I_a
    let inv_I_a = prepared[9];
    let d_r_dot_d_C_Nr = inv_I_a * r;
    jp[54] = d_r_dot_d_C_Nr;
    let air_velocity_12_sq =
        air_velocity_2.mul_add(air_velocity_2, minus_air_velocity_1 * minus_air_velocity_1);
    let part_of_minus_air_velocity_3 = q1_sq_two_minus_one_sum * vz_minus_wind_z;
    let minus_air_velocity_3 =
        vy_minus_wind_y_product_sum.neg_mul_add(T::splat(2.0), part_of_minus_air_velocity_3);
    let part_of_minus_q0_q3_plus_q1_sum = minus_q0_q3_plus_q1_q2 * air_velocity_2;
    let minus_q0_q3_plus_q1_sum =
        minus_air_velocity_1.mul_add(q2_sq_two_plus_q3_product, part_of_minus_q0_q3_plus_q1_sum);
    let part_of_q0_q3_plus_q1_q2_sum = q0_q3_plus_q1_q2 * minus_air_velocity_1;
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);
    let q1_sq_two_plus_q3_product = T::splat(0.5) * q1_sq_two_plus_q3_sq_sum;
    let q0_q3_plus_q1_q2_sum =
        air_velocity_2.mul_add(q1_sq_two_plus_q3_product, part_of_q0_q3_plus_q1_q2_sum);
    let part_of_minus_q1_q0_plus_q3_q2 = minus_q0_q2_plus_q1_q3 * minus_air_velocity_1;
    let minus_q1_q0_plus_q3_q2_sum =
        q1_q0_plus_q3_q2_2.neg_mul_add(air_velocity_2, part_of_minus_q1_q0_plus_q3_q2);
    let q1_sq_two_minus_one_sum_half = T::splat(0.5) * q1_sq_two_minus_one_sum;
    let minus_vy_minus_wind_y_q3_two = minus_vy_minus_wind_y * q3_two;

    // disc_quaternion.hyz:70  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let V_sq_half = T::splat(0.5) * V_sq;
    let q0_two = T::splat(2.0) * q0;
    let part_of_d_minus_air_velocity_3 =
        vz_minus_wind_z.mul_add(T::splat(4.0) * q2, minus_vy_minus_wind_y_q3_two);
    let vx_minus_wind_x_q3_two = vx_minus_wind_x * q3_two;
    let vz_minus_wind_z_q2_two = vz_minus_wind_z * q2_two;
    let d_minus_air_velocity_1_d_q0 = minus_vy_minus_wind_y_q3_two + vz_minus_wind_z_q2_two;
    let d_rho_A_inv_I_d = prepared[4];
    let V_sq_half_d_inv_part_rho_A = d_rho_A_inv_I_d * V_sq_half;
    let q1_n4 = T::splat(4.0) * q1;
    let minus_vy_minus_wind_y_q2_two = minus_vy_minus_wind_y * q2_two;
    let vx_minus_wind_x_q0_two = vx_minus_wind_x * q0_two;
    let d_minus_air_velocity_3_d_q2 = part_of_d_minus_air_velocity_3 - vx_minus_wind_x_q0_two;
    let part_of_d_air_velocity_2_d_q3 = vz_minus_wind_z_q2_two - vx_minus_wind_x_q0_two;
    let vx_minus_wind_x_q1_two = vx_minus_wind_x * q1_two;
    let vx_minus_wind_x_q2_two = vx_minus_wind_x * q2_two;
    let vx_minus_wind_x_n4 = T::splat(4.0) * vx_minus_wind_x;
    let minus_vy_minus_wind_y_q1_two = minus_vy_minus_wind_y * q1_two;
    let vz_minus_wind_z_q1_two = vz_minus_wind_z * q1_two;
    let minus_vy_minus_wind_y_q0_two = minus_vy_minus_wind_y * q0_two;
    let vz_minus_wind_z_q0_two = vz_minus_wind_z * q0_two;
    let vz_minus_wind_z_q3_two = vz_minus_wind_z * q3_two;
    let minus_d_minus_air_velocity_3_d_q0 = vx_minus_wind_x_q2_two + minus_vy_minus_wind_y_q1_two;
    let d_minus_air_velocity_3_d_q1 =
        vz_minus_wind_z.mul_sub(q1_n4, vx_minus_wind_x_q3_two) - minus_vy_minus_wind_y_q0_two;
    let part_of_d_minus_air_velocity_1_2 = minus_vy_minus_wind_y_q0_two - vz_minus_wind_z_q1_two;
    let d_air_velocity_2_d_q0 = vz_minus_wind_z_q1_two - vx_minus_wind_x_q3_two;
    let part_of_d_minus_air_velocity_1 = minus_vy_minus_wind_y_q1_two + vz_minus_wind_z_q0_two;
    let d_air_velocity_2_d_q1 =
        minus_vy_minus_wind_y.mul_add(q1_n4, vx_minus_wind_x_q2_two) + vz_minus_wind_z_q0_two;
    let d_minus_air_velocity_1_d_q2 =
        q2.mul_add(vx_minus_wind_x_n4, part_of_d_minus_air_velocity_1);
    let d_minus_air_velocity_1_d_q3 =
        q3.mul_add(vx_minus_wind_x_n4, part_of_d_minus_air_velocity_1_2);

    // disc_quaternion.hyz:75  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let inv_V = V.recip_or_zero();
    let inv_m_rho_A = prepared[0];
    let V_inv_m_rho_A = inv_m_rho_A * V;
    let inv_m = prepared[7];
    let V_inv_m = inv_m * V;
    let d_minus_air_velocity_3_d_q3 = minus_vy_minus_wind_y_q2_two - vx_minus_wind_x_q1_two;
    let d_air_velocity_2_d_q2 = vz_minus_wind_z_q3_two + vx_minus_wind_x_q1_two;
    let d_minus_air_velocity_1_d_q1 = minus_vy_minus_wind_y_q2_two - vz_minus_wind_z_q3_two;
    let C_Mq = parameters[12];
    let C_Mq_nonzero_air_velocity_12 = C_Mq * nonzero_air_velocity_12;
    let d_air_velocity_2_d_q3 =
        minus_vy_minus_wind_y.mul_add(T::splat(4.0) * q3, part_of_d_air_velocity_2_d_q3);
    let V_sq_half_d_inv_product = V_sq_half_d_inv_part_rho_A * nonzero_air_velocity_12;
    let inv_air_velocity_12_product = inv_air_velocity_12 * V_sq_half_d_inv_part_rho_A;
    let inv_air_velocity_12_product_3 = inv_air_velocity_12_product * r_C_Rr;
    let p = state[10];
    let d_p_dot_d_C_Mq = p * V_sq_half_d_inv_product;
    jp[37] = d_p_dot_d_C_Mq;
    let q = state[11];
    let d_q_dot_d_C_Mq = q * V_sq_half_d_inv_product;
    jp[48] = d_q_dot_d_C_Mq;
    let V_sq_half_d_inv_product_2 = C_Mq * V_sq_half_d_inv_product;
    j[55] = V_sq_half_d_inv_product_2; // d_p_dot_d_p
    j[66] = V_sq_half_d_inv_product_2; // d_q_dot_d_q
    let part_of_minus_inv_air_velocity = p * C_Mq_nonzero_air_velocity_12;
    let two_q0_q3_plus_q1_q2 = T::splat(2.0) * q0_q3_plus_q1_q2;
    let minus_air_velocity_product = minus_air_velocity_1 * inv_air_velocity_12_product;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12_product;
    let d_q_dot_d_C_Rr = r * air_velocity_2_inv_product;
    jp[49] = d_q_dot_d_C_Rr;
    let q3_r_plus_q2_q_plus_q1_p = q3.mul_add(r, q2.mul_add(q, q1 * p));
    dx[6] = T::splat(-0.5) * q3_r_plus_q2_q_plus_q1_p;
    let minus_air_velocity_product_3 = minus_air_velocity_3 * inv_air_velocity_12;
    let C_Ma = parameters[11];
    let C_Ma_air_velocity_2_product = C_Ma * air_velocity_2_inv_product;
    let minus_air_velocity_product_7 = C_Ma * minus_air_velocity_product;
    let inv_V_sq = inv_V * inv_V;
    let inv_V_inv_m_rho_A = inv_m_rho_A * inv_V;
    let V_inv_m_rho_A_inv_product = V_inv_m_rho_A * inv_air_velocity_12;
    let inv_air_velocity_12_product_2 = inv_air_velocity_12 * inv_air_velocity_12_product;
    let minus_air_velocity_product_6 = minus_air_velocity_1 * inv_air_velocity_12;
    let air_velocity_2_inv_product_2 = air_velocity_2 * inv_air_velocity_12;
    let q3_q_minus_q2_r_minus_q0_p = q2.neg_mul_add(r, q0.neg_mul_add(p, q3 * q));
    dx[7] = T::splat(-0.5) * q3_q_minus_q2_r_minus_q0_p;
    let air_velocity_12_inv_V_sq = air_velocity_12 * inv_V_sq;
    let minus_air_velocity_product_4 = minus_air_velocity_3 * inv_V_sq;
    let minus_air_velocity_product_2 = minus_air_velocity_3 * inv_V_inv_m_rho_A;
    let q1_r_minus_q3_p_minus_q0_q = q3.neg_mul_add(p, q0.neg_mul_add(q, q1 * r));
    dx[8] = T::splat(-0.5) * q1_r_minus_q3_p_minus_q0_q;
    let part_of_d_p_dot_d_minus_air = air_velocity_12_inv_V_sq * C_Ma_air_velocity_2_product;
    let part_of_d_p_dot_d_air_velocity = minus_air_velocity_product_4 * C_Ma_air_velocity_2_product;
    let part_of_d_q_dot_d_air_velocity =
        minus_air_velocity_product_4 * minus_air_velocity_product_7;
    let part_of_d_q_dot_d_minus_air = air_velocity_12_inv_V_sq * minus_air_velocity_product_7;
    let q2_p_minus_q1_q_minus_q0_r = q1.neg_mul_add(q, q0.neg_mul_add(r, q2 * p));
    dx[9] = T::splat(-0.5) * q2_p_minus_q1_q_minus_q0_r;
    let one_minus_inv_I_d_I_a = prepared[2];
    let minus_C_Rr_minus_air_sum =
        C_Rr.neg_mul_add(minus_air_velocity_product, one_minus_inv_I_d_I_a * q);
    j[57] = minus_C_Rr_minus_air_sum; // d_p_dot_d_r
    let C_Rr_air_velocity_sum = C_Rr.mul_sub(air_velocity_2_inv_product, one_minus_inv_I_d_I_a * p);
    j[67] = C_Rr_air_velocity_sum; // d_q_dot_d_r
    let inv_I_d = prepared[8];
    let r_inv_I_d = inv_I_d * r;
    let two_minus_q0_q3_plus_q1_q2 = T::splat(2.0) * minus_q0_q3_plus_q1_q2;
    let two_minus_q0_q2_plus_q1_q3 = T::splat(2.0) * minus_q0_q2_plus_q1_q3;
    let part_of_minus_q1_q0_plus_q3_q2_2 = -(q1_q0_plus_q3_q2 * air_velocity_12);
    let minus_q1_q0_plus_q3_q2_sum_2 = q0_q3_plus_q1_q2_sum.neg_mul_add(
        minus_air_velocity_product_3,
        part_of_minus_q1_q0_plus_q3_q2_2,
    );
    let d_vy_dot_d_C_L0 = V_inv_m_rho_A * minus_q1_q0_plus_q3_q2_sum_2;
    jp[13] = d_vy_dot_d_C_L0;
    let part_of_minus_minus_q1_q0_plus =
        -(minus_q1_q0_plus_q3_q2_sum * minus_air_velocity_product_3);
    let minus_minus_q1_q0_plus_sum =
        air_velocity_12.neg_mul_add(q1_sq_two_minus_one_sum_half, part_of_minus_minus_q1_q0_plus);
    let d_vz_dot_d_C_L0 = V_inv_m_rho_A * minus_minus_q1_q0_plus_sum;
    jp[24] = d_vz_dot_d_C_L0;
    let part_of_p_dot = r.mul_add(minus_C_Rr_minus_air_sum, p * V_sq_half_d_inv_product_2);
    let part_of_q_dot = r.mul_add(C_Rr_air_velocity_sum, q * V_sq_half_d_inv_product_2);
    let part_of_q0_q2_plus_q1_q3_sum_3 = q0_q2_plus_q1_q3 * air_velocity_12;
    let q0_q2_plus_q1_q3_sum_3 = minus_q0_q3_plus_q1_sum
        .mul_add(minus_air_velocity_product_3, part_of_q0_q2_plus_q1_q3_sum_3);
    let d_vx_dot_d_C_L0 = V_inv_m_rho_A * q0_q2_plus_q1_q3_sum_3;
    jp[3] = d_vx_dot_d_C_L0;
    let part_of_q0_q2_plus_q1_q3_sum_4 = q0_q2_plus_q1_q3 * minus_air_velocity_3;
    let q0_q2_plus_q1_q3_sum_4 = minus_q0_q3_plus_q1_sum
        .neg_mul_add(nonzero_air_velocity_12, part_of_q0_q2_plus_q1_q3_sum_4);
    let d_vx_dot_d_C_D0 = V_inv_m_rho_A * q0_q2_plus_q1_q3_sum_4;
    jp[5] = d_vx_dot_d_C_D0;
    let part_of_minus_q1_q0_plus_q3_q2_3 = q1_q0_plus_q3_q2 * minus_air_velocity_3;
    let minus_q1_q0_plus_q3_q2_sum_3 =
        q0_q3_plus_q1_q2_sum.mul_sub(nonzero_air_velocity_12, part_of_minus_q1_q0_plus_q3_q2_3);
    let d_vy_dot_d_C_D0 = V_inv_m_rho_A * minus_q1_q0_plus_q3_q2_sum_3;
    jp[15] = d_vy_dot_d_C_D0;
    let part_of_minus_q1_q0_plus_q3_sum = minus_air_velocity_3 * q1_sq_two_minus_one_sum_half;
    let minus_q1_q0_plus_q3_sum_3 = minus_q1_q0_plus_q3_q2_sum
        .mul_sub(nonzero_air_velocity_12, part_of_minus_q1_q0_plus_q3_sum);
    jp[26] = V_inv_m_rho_A * minus_q1_q0_plus_q3_sum_3; // d_vz_dot_d_C_D0
    let q_r_inv_I_d = q * r_inv_I_d;
    let d_q_dot_d_I_a = p * r_inv_I_d;
    jp[42] = d_q_dot_d_I_a;
    let minus_I_a_inv_I_d = prepared[13];
    let part_of_d_q_dot_d_I_d = minus_I_a_inv_I_d * d_q_dot_d_I_a;
    let d_p_dot_d_I_a = -q_r_inv_I_d;
    jp[31] = d_p_dot_d_I_a;
    let inv_I_d_V_sq_half = inv_I_d * V_sq_half;
    let inv_I_d_d = prepared[12];
    let inv_I_d_d_V_sq_half = inv_I_d_d * V_sq_half;
    let q0_q2_plus_q1_q3_two = T::splat(2.0) * q0_q2_plus_q1_q3;
    let q1_q0_plus_q3_q2_two = T::splat(2.0) * q1_q0_plus_q3_q2;
    let two_q1_q0_plus_q3_q2_2 = T::splat(2.0) * q1_q0_plus_q3_q2_2;
    let inv_m_rho_A_V_inv_m = inv_m_rho_A * V_inv_m;
    let C_La = parameters[8];
    let C_L0 = parameters[7];

    // disc_quaternion.hyz:79  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La.mul_add(alpha, C_L0);
    let C_Da = parameters[10];
    let C_D0 = parameters[9];

    // disc_quaternion.hyz:80  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = alpha.mul_add(C_Da * alpha, C_D0);
    let two_C_Da = prepared[5];
    let alpha_two_C_Da = two_C_Da * alpha;
    let minus_C_La_minus_air_sum =
        nonzero_air_velocity_12.mul_sub(alpha_two_C_Da, C_La * minus_air_velocity_product_3);
    let air_velocity_12_C_La_sum =
        minus_air_velocity_3.mul_add(alpha_two_C_Da, C_La * air_velocity_12);
    let alpha_C_Ma = C_Ma * alpha;
    let p_dot = alpha_C_Ma.neg_mul_add(air_velocity_2_inv_product, part_of_p_dot);
    dx[10] = p_dot;
    let q_dot = minus_air_velocity_product.neg_mul_add(alpha_C_Ma, part_of_q_dot);
    dx[11] = q_dot;
    let d_p_dot_d_C_Ma = -(alpha * air_velocity_2_inv_product);
    jp[36] = d_p_dot_d_C_Ma;
    let air_velocity_2_alpha_C_sum =
        air_velocity_2.mul_add(alpha_C_Ma, minus_air_velocity_1 * r_C_Rr);
    let air_velocity_2_r_C_Rr_sum =
        minus_air_velocity_1.neg_mul_add(alpha_C_Ma, air_velocity_2 * r_C_Rr);
    let inv_air_velocity_12_product_4 = inv_air_velocity_12_product * alpha_C_Ma;
    let minus_inv_air_velocity_sum =
        inv_air_velocity_12.neg_mul_add(air_velocity_2_alpha_C_sum, part_of_minus_inv_air_velocity);
    let inv_air_velocity_12_sum =
        inv_air_velocity_12.mul_add(air_velocity_2_r_C_Rr_sum, q * C_Mq_nonzero_air_velocity_12);
    let air_velocity_12_C_D_sum = air_velocity_12.mul_sub(C_D, minus_air_velocity_3 * C_L);
    let air_velocity_12_C_D_product = air_velocity_12_C_D_sum * inv_air_velocity_12;
    let minus_air_velocity_3_C_sum = minus_air_velocity_3.mul_add(C_D, air_velocity_12 * C_L);
    let C_D_plus_air_velocity_sum = air_velocity_12_C_La_sum.mul_add(air_velocity_12_inv_V_sq, C_D);
    let C_L_minus_air_velocity_sum =
        air_velocity_12_C_La_sum.neg_mul_add(minus_air_velocity_product_4, C_L);
    let minus_C_La_minus_sum =
        minus_C_La_minus_air_sum.mul_sub(air_velocity_12_inv_V_sq, C_L * inv_air_velocity_12);
    let part_of_minus_minus_C_La_minus = minus_C_La_minus_air_sum * minus_air_velocity_product_4;
    let part_of_minus_minus_C_La_minus_2 = C_D - air_velocity_12_C_D_product;
    let minus_minus_C_La_minus_sum = inv_air_velocity_12.mul_sub(
        part_of_minus_minus_C_La_minus_2,
        part_of_minus_minus_C_La_minus,
    );
    let part_of_q0_q2_plus_q1_q3_sum = q0_q2_plus_q1_q3 * minus_air_velocity_3_C_sum;
    let q0_q2_plus_q1_q3_sum = air_velocity_12_C_D_product
        .neg_mul_add(minus_q0_q3_plus_q1_sum, part_of_q0_q2_plus_q1_q3_sum);

    // disc_quaternion.hyz:50  velocity (vx, vy, vz) in N;
    let vx_dot = V_inv_m_rho_A * q0_q2_plus_q1_q3_sum;
    dx[3] = vx_dot;
    let part_of_minus_q1_q0_plus_q3_sum_2 = q1_q0_plus_q3_q2 * minus_air_velocity_3_C_sum;
    let minus_q1_q0_plus_q3_sum = air_velocity_12_C_D_product
        .mul_sub(q0_q3_plus_q1_q2_sum, part_of_minus_q1_q0_plus_q3_sum_2);
    let vy_dot = V_inv_m_rho_A * minus_q1_q0_plus_q3_sum;
    dx[4] = vy_dot;
    let part_of_minus_q1_sq_two_minus = minus_air_velocity_3_C_sum * q1_sq_two_minus_one_sum_half;
    let V_inv_m_rho_A_minus_product = V_inv_m_rho_A * minus_air_velocity_3_C_sum;
    let minus_q1_sq_two_minus_one_sum_2 = air_velocity_12_C_D_product
        .mul_sub(minus_q1_q0_plus_q3_q2_sum, part_of_minus_q1_sq_two_minus);
    let V_inv_m_rho_A_air_product = V_inv_m_rho_A * air_velocity_12_C_D_product;
    let part_of_d_vx_dot_d_air_velocity = minus_q0_q3_plus_q1_q2 * V_inv_m_rho_A_air_product;
    let part_of_d_vx_dot_d_minus_air_4 = V_inv_m_rho_A_air_product * q2_sq_two_plus_q3_product;
    let part_of_d_vy_dot_d_air_velocity = V_inv_m_rho_A_air_product * q1_sq_two_plus_q3_product;
    let d_vz_dot_d_minus_air_velocity_1 = minus_q0_q2_plus_q1_q3 * V_inv_m_rho_A_air_product;
    let part_of_d_vy_dot_d_minus_air_4 = q0_q3_plus_q1_q2 * V_inv_m_rho_A_air_product;
    let part_of_minus_d_vz_dot_d_air = q1_q0_plus_q3_q2_2 * V_inv_m_rho_A_air_product;
    let g = parameters[6];
    let vz_dot = V_inv_m_rho_A.mul_sub(minus_q1_sq_two_minus_one_sum_2, g);
    dx[5] = vz_dot;
    let part_of_d_vx_dot_d_minus_air = q0_q2_plus_q1_q3 * C_D_plus_air_velocity_sum;
    let part_of_q0_q2_plus_q1_q3_sum_2 = q0_q2_plus_q1_q3 * C_L_minus_air_velocity_sum;
    let part_of_d_vx_dot_d_minus_air_2 =
        minus_q0_q3_plus_q1_sum.neg_mul_add(minus_C_La_minus_sum, part_of_d_vx_dot_d_minus_air);
    let part_of_q0_q2_plus_q1_q3_sum_2_2 = minus_q0_q3_plus_q1_sum
        .neg_mul_add(minus_minus_C_La_minus_sum, part_of_q0_q2_plus_q1_q3_sum_2);
    let part_of_d_vx_dot_d_minus_air_3 = q0_q2_plus_q1_q3_sum * minus_air_velocity_product_2;
    let d_vx_dot_d_minus_air_velocity_3 = V_inv_m_rho_A.mul_add(
        part_of_d_vx_dot_d_minus_air_2,
        part_of_d_vx_dot_d_minus_air_3,
    );
    let part_of_q0_q2_plus_q1_q3_sum_2_3 = q0_q2_plus_q1_q3_sum * inv_V_inv_m_rho_A;
    let q0_q2_plus_q1_q3_sum_2 = V_inv_m_rho_A_inv_product.mul_add(
        part_of_q0_q2_plus_q1_q3_sum_2_2,
        part_of_q0_q2_plus_q1_q3_sum_2_3,
    );
    let d_vx_dot_d_air_velocity_2 =
        air_velocity_2.mul_sub(q0_q2_plus_q1_q3_sum_2, part_of_d_vx_dot_d_air_velocity);
    let d_vx_dot_d_minus_air_velocity_1 =
        minus_air_velocity_1.mul_sub(q0_q2_plus_q1_q3_sum_2, part_of_d_vx_dot_d_minus_air_4);
    let part_of_d_vy_dot_d_minus_air = q0_q3_plus_q1_q2_sum * minus_C_La_minus_sum;
    let part_of_d_vy_dot_d_minus_air_2 =
        q1_q0_plus_q3_q2.neg_mul_add(C_D_plus_air_velocity_sum, part_of_d_vy_dot_d_minus_air);
    let part_of_minus_q1_q0_plus_q3_sum_3 = q1_q0_plus_q3_q2 * C_L_minus_air_velocity_sum;
    let part_of_minus_q1_q0_plus_q3_sum_4 = q0_q3_plus_q1_q2_sum.mul_sub(
        minus_minus_C_La_minus_sum,
        part_of_minus_q1_q0_plus_q3_sum_3,
    );
    let part_of_d_vz_dot_d_minus_air = C_D_plus_air_velocity_sum * q1_sq_two_minus_one_sum_half;
    let part_of_minus_minus_q1_sq_two = C_L_minus_air_velocity_sum * q1_sq_two_minus_one_sum_half;
    let part_of_d_vz_dot_d_minus_air_2 =
        minus_q1_q0_plus_q3_q2_sum.neg_mul_add(minus_C_La_minus_sum, part_of_d_vz_dot_d_minus_air);
    let part_of_minus_minus_q1_sq_two_2 = minus_q1_q0_plus_q3_q2_sum
        .neg_mul_add(minus_minus_C_La_minus_sum, part_of_minus_minus_q1_sq_two);
    let minus_inv_air_product = d_rho_A_inv_I_d * minus_inv_air_velocity_sum;
    let I_a_inv_I_d = prepared[11];
    let d_p_dot_d_I_d =
        inv_I_d_V_sq_half.neg_mul_add(minus_inv_air_product, I_a_inv_I_d * q_r_inv_I_d);
    jp[32] = d_p_dot_d_I_d;
    let part_of_d_p_dot_d_air_velocity_2 =
        air_velocity_12.mul_add(minus_inv_air_product, part_of_d_p_dot_d_air_velocity);
    let d_p_dot_d_air_velocity_12 = air_velocity_2_alpha_C_sum.mul_add(
        inv_air_velocity_12_product_2,
        part_of_d_p_dot_d_air_velocity_2,
    );
    let d_p_dot_d_minus_air_velocity_3 =
        minus_air_velocity_3.mul_sub(minus_inv_air_product, part_of_d_p_dot_d_minus_air);
    let inv_air_velocity_12_product_5 = d_rho_A_inv_I_d * inv_air_velocity_12_sum;
    let part_of_d_q_dot_d_air_velocity_2 = air_velocity_12.mul_add(
        inv_air_velocity_12_product_5,
        part_of_d_q_dot_d_air_velocity,
    );
    let d_q_dot_d_air_velocity_12 = air_velocity_2_r_C_Rr_sum.neg_mul_add(
        inv_air_velocity_12_product_2,
        part_of_d_q_dot_d_air_velocity_2,
    );
    let d_q_dot_d_minus_air_velocity_3 =
        minus_air_velocity_3.mul_sub(inv_air_velocity_12_product_5, part_of_d_q_dot_d_minus_air);
    let d_q_dot_d_I_d =
        inv_I_d_V_sq_half.neg_mul_add(inv_air_velocity_12_product_5, part_of_d_q_dot_d_I_d);
    jp[43] = d_q_dot_d_I_d;
    let rho_A = prepared[10];
    let rho_A_inv_I_d_V_sq_half = rho_A * inv_I_d_V_sq_half;
    jp[33] = minus_inv_air_velocity_sum * rho_A_inv_I_d_V_sq_half; // d_p_dot_d_d
    jp[44] = inv_air_velocity_12_sum * rho_A_inv_I_d_V_sq_half; // d_q_dot_d_d
    let air_velocity_2_V_product = air_velocity_2 * V_inv_m_rho_A_air_product;
    let minus_air_velocity_product_5 = minus_air_velocity_1 * V_inv_m_rho_A_air_product;
    let part_of_d_vy_dot_d_minus_air_3 = minus_q1_q0_plus_q3_sum * minus_air_velocity_product_2;
    let d_vy_dot_d_minus_air_velocity_3 = V_inv_m_rho_A.mul_add(
        part_of_d_vy_dot_d_minus_air_2,
        part_of_d_vy_dot_d_minus_air_3,
    );
    let part_of_d_vz_dot_d_minus_air_3 =
        minus_q1_sq_two_minus_one_sum_2 * minus_air_velocity_product_2;
    let d_vz_dot_d_minus_air_velocity_3 = V_inv_m_rho_A.neg_mul_add(
        part_of_d_vz_dot_d_minus_air_2,
        part_of_d_vz_dot_d_minus_air_3,
    );
    let V_inv_m_rho_A_alpha = V_inv_m_rho_A * alpha;
    let d_vx_dot_d_C_La = q0_q2_plus_q1_q3_sum_3 * V_inv_m_rho_A_alpha;
    jp[4] = d_vx_dot_d_C_La;
    let d_vy_dot_d_C_La = minus_q1_q0_plus_q3_q2_sum_2 * V_inv_m_rho_A_alpha;
    jp[14] = d_vy_dot_d_C_La;
    let d_vz_dot_d_C_La = minus_minus_q1_q0_plus_sum * V_inv_m_rho_A_alpha;
    jp[25] = d_vz_dot_d_C_La;
    let alpha_V_inv_m_rho_A_alpha = alpha * V_inv_m_rho_A_alpha;
    let d_vx_dot_d_C_Da = q0_q2_plus_q1_q3_sum_4 * alpha_V_inv_m_rho_A_alpha;
    jp[6] = d_vx_dot_d_C_Da;
    let d_vy_dot_d_C_Da = minus_q1_q0_plus_q3_q2_sum_3 * alpha_V_inv_m_rho_A_alpha;
    jp[16] = d_vy_dot_d_C_Da;
    jp[27] = minus_q1_q0_plus_q3_sum_3 * alpha_V_inv_m_rho_A_alpha; // d_vz_dot_d_C_Da
    let d_q_dot_d_C_Ma = -(alpha * minus_air_velocity_product);
    jp[47] = d_q_dot_d_C_Ma;
    let d_p_dot_d_C_Rr = -(r * minus_air_velocity_product);
    jp[38] = d_p_dot_d_C_Rr;
    let part_of_minus_q1_q0_plus_q3_sum_5 = minus_q1_q0_plus_q3_sum * inv_V_inv_m_rho_A;
    let minus_q1_q0_plus_q3_sum_2 = V_inv_m_rho_A_inv_product.mul_add(
        part_of_minus_q1_q0_plus_q3_sum_4,
        part_of_minus_q1_q0_plus_q3_sum_5,
    );
    let part_of_minus_minus_q1_sq_two_3 = minus_q1_sq_two_minus_one_sum_2 * inv_V_inv_m_rho_A;
    let minus_minus_q1_sq_two_sum = V_inv_m_rho_A_inv_product.mul_sub(
        part_of_minus_minus_q1_sq_two_2,
        part_of_minus_minus_q1_sq_two_3,
    );
    let d_vy_dot_d_air_velocity_2 =
        air_velocity_2.mul_add(minus_q1_q0_plus_q3_sum_2, part_of_d_vy_dot_d_air_velocity);
    let d_vy_dot_d_minus_air_velocity_1 =
        minus_air_velocity_1.mul_add(minus_q1_q0_plus_q3_sum_2, part_of_d_vy_dot_d_minus_air_4);
    let d_vz_dot_d_minus_air_velocity_1_2 = minus_air_velocity_1
        .neg_mul_add(minus_minus_q1_sq_two_sum, d_vz_dot_d_minus_air_velocity_1);
    let minus_d_vz_dot_d_air_velocity_2 =
        air_velocity_2.mul_add(minus_minus_q1_sq_two_sum, part_of_minus_d_vz_dot_d_air);
    let q2_V_inv_m_rho_A_product = q2 * V_inv_m_rho_A_minus_product;
    let q3_air_velocity_2_V_product = q3 * air_velocity_2_V_product;
    let part_of_d_vx_dot_d_q2 = d_vx_dot_d_minus_air_velocity_3 * d_minus_air_velocity_3_d_q2;
    let part_of_d_vx_dot_d_q2_2 =
        d_vx_dot_d_air_velocity_2.mul_add(d_air_velocity_2_d_q2, part_of_d_vx_dot_d_q2);
    let part_of_d_vx_dot_d_q2_3 = d_vx_dot_d_minus_air_velocity_1
        .mul_add(d_minus_air_velocity_1_d_q2, part_of_d_vx_dot_d_q2_2);
    let q0_V_inv_m_rho_A_product = q0 * V_inv_m_rho_A_minus_product;
    let part_of_d_vx_dot_d_q3 = d_vx_dot_d_minus_air_velocity_3 * d_minus_air_velocity_3_d_q3;
    let part_of_d_vx_dot_d_q3_2 =
        d_vx_dot_d_air_velocity_2.mul_add(d_air_velocity_2_d_q3, part_of_d_vx_dot_d_q3);
    let part_of_d_vx_dot_d_q3_3 = d_vx_dot_d_minus_air_velocity_1
        .mul_add(d_minus_air_velocity_1_d_q3, part_of_d_vx_dot_d_q3_2);
    let q0_air_velocity_2_V_product = q0 * air_velocity_2_V_product;
    let q3_minus_air_product = q3 * minus_air_velocity_product_5;
    let part_of_d_vz_dot_d_q1 = q3_minus_air_product - q0_air_velocity_2_V_product;
    let part_of_d_vz_dot_d_q1_2 =
        d_minus_air_velocity_3_d_q1.mul_add(d_vz_dot_d_minus_air_velocity_3, part_of_d_vz_dot_d_q1);
    let part_of_d_vz_dot_d_q1_3 =
        d_air_velocity_2_d_q1.neg_mul_add(minus_d_vz_dot_d_air_velocity_2, part_of_d_vz_dot_d_q1_2);
    let part_of_d_vz_dot_d_q1_4 = d_minus_air_velocity_1_d_q1
        .mul_add(d_vz_dot_d_minus_air_velocity_1_2, part_of_d_vz_dot_d_q1_3);
    let d_vz_dot_d_q1 = q1_two.neg_mul_add(V_inv_m_rho_A_minus_product, part_of_d_vz_dot_d_q1_4);
    j[21] = d_vz_dot_d_q1;
    let q2_minus_air_product = q2 * minus_air_velocity_product_5;
    let part_of_d_vy_dot_d_q1 = q2_minus_air_product - q0_V_inv_m_rho_A_product;
    let part_of_d_vy_dot_d_q1_2 =
        d_minus_air_velocity_3_d_q1.mul_add(d_vy_dot_d_minus_air_velocity_3, part_of_d_vy_dot_d_q1);
    let part_of_d_vy_dot_d_q1_3 =
        d_air_velocity_2_d_q1.mul_add(d_vy_dot_d_air_velocity_2, part_of_d_vy_dot_d_q1_2);
    let part_of_d_vy_dot_d_q1_4 = d_minus_air_velocity_1_d_q1
        .mul_add(d_vy_dot_d_minus_air_velocity_1, part_of_d_vy_dot_d_q1_3);
    let d_vy_dot_d_q1 = q1_two.mul_add(air_velocity_2_V_product, part_of_d_vy_dot_d_q1_4);
    j[14] = d_vy_dot_d_q1;
    let part_of_d_vx_dot_d_q0 = d_vx_dot_d_minus_air_velocity_3 * minus_d_minus_air_velocity_3_d_q0;
    let part_of_d_vx_dot_d_q0_2 =
        d_vx_dot_d_air_velocity_2.mul_sub(d_air_velocity_2_d_q0, part_of_d_vx_dot_d_q0);
    let part_of_d_vx_dot_d_q0_3 = d_vx_dot_d_minus_air_velocity_1
        .mul_add(d_minus_air_velocity_1_d_q0, part_of_d_vx_dot_d_q0_2);
    let d_vx_dot_d_q0 =
        part_of_d_vx_dot_d_q0_3 + q2_V_inv_m_rho_A_product + q3_air_velocity_2_V_product;
    j[6] = d_vx_dot_d_q0;
    let part_of_d_vy_dot_d_q3 = d_minus_air_velocity_3_d_q3
        .mul_add(d_vy_dot_d_minus_air_velocity_3, q2_V_inv_m_rho_A_product);
    let part_of_d_vz_dot_d_q2 = d_minus_air_velocity_3_d_q2
        .mul_sub(d_vz_dot_d_minus_air_velocity_3, q3_air_velocity_2_V_product);
    let part_of_d_vy_dot_d_q3_2 =
        d_air_velocity_2_d_q3.mul_add(d_vy_dot_d_air_velocity_2, part_of_d_vy_dot_d_q3);
    let part_of_d_vy_dot_d_q3_3 = d_minus_air_velocity_1_d_q3
        .mul_add(d_vy_dot_d_minus_air_velocity_1, part_of_d_vy_dot_d_q3_2);
    let part_of_d_vx_dot_d_q1 = d_vx_dot_d_minus_air_velocity_3 * d_minus_air_velocity_3_d_q1;
    let part_of_d_vx_dot_d_q1_2 =
        d_vx_dot_d_air_velocity_2.mul_add(d_air_velocity_2_d_q1, part_of_d_vx_dot_d_q1);
    let part_of_d_vx_dot_d_q1_3 = d_vx_dot_d_minus_air_velocity_1
        .mul_add(d_minus_air_velocity_1_d_q1, part_of_d_vx_dot_d_q1_2);
    let q3_V_inv_m_rho_A_product = q3 * V_inv_m_rho_A_minus_product;
    let part_of_d_vy_dot_d_q2 = d_minus_air_velocity_3_d_q2
        .mul_add(d_vy_dot_d_minus_air_velocity_3, q3_V_inv_m_rho_A_product);
    let part_of_d_vy_dot_d_q2_2 =
        d_air_velocity_2_d_q2.mul_add(d_vy_dot_d_air_velocity_2, part_of_d_vy_dot_d_q2);
    let part_of_d_vy_dot_d_q2_3 = d_minus_air_velocity_1_d_q2
        .mul_add(d_vy_dot_d_minus_air_velocity_1, part_of_d_vy_dot_d_q2_2);
    let q2_air_velocity_2_V_product = q2 * air_velocity_2_V_product;
    let d_vx_dot_d_q1 =
        part_of_d_vx_dot_d_q1_3 + q3_V_inv_m_rho_A_product - q2_air_velocity_2_V_product;
    j[7] = d_vx_dot_d_q1;
    let q1_air_velocity_2_V_product = q1 * air_velocity_2_V_product;
    let part_of_d_vx_dot_d_q2_4 =
        part_of_d_vx_dot_d_q2_3 + q0_V_inv_m_rho_A_product - q1_air_velocity_2_V_product;
    let d_vx_dot_d_q2 = q2_two.neg_mul_add(minus_air_velocity_product_5, part_of_d_vx_dot_d_q2_4);
    j[8] = d_vx_dot_d_q2;
    let part_of_d_vz_dot_d_q0 = d_minus_air_velocity_1_d_q0.mul_sub(
        d_vz_dot_d_minus_air_velocity_1_2,
        q1_air_velocity_2_V_product,
    );
    let part_of_d_vz_dot_d_q0_2 = part_of_d_vz_dot_d_q0 - q2_minus_air_product;
    let part_of_d_vz_dot_d_q0_3 = minus_d_minus_air_velocity_3_d_q0
        .neg_mul_add(d_vz_dot_d_minus_air_velocity_3, part_of_d_vz_dot_d_q0_2);
    let d_vz_dot_d_q0 =
        d_air_velocity_2_d_q0.neg_mul_add(minus_d_vz_dot_d_air_velocity_2, part_of_d_vz_dot_d_q0_3);
    j[20] = d_vz_dot_d_q0;
    let q1_V_inv_m_rho_A_product = q1 * V_inv_m_rho_A_minus_product;
    let part_of_d_vy_dot_d_q0 = q3_minus_air_product - q1_V_inv_m_rho_A_product;
    let part_of_d_vx_dot_d_q3_4 =
        part_of_d_vx_dot_d_q3_3 + q0_air_velocity_2_V_product + q1_V_inv_m_rho_A_product;
    let d_vx_dot_d_q3 = q3_two.neg_mul_add(minus_air_velocity_product_5, part_of_d_vx_dot_d_q3_4);
    j[9] = d_vx_dot_d_q3;
    let part_of_d_vy_dot_d_q0_2 = minus_d_minus_air_velocity_3_d_q0
        .neg_mul_add(d_vy_dot_d_minus_air_velocity_3, part_of_d_vy_dot_d_q0);
    let part_of_d_vy_dot_d_q0_3 =
        d_air_velocity_2_d_q0.mul_add(d_vy_dot_d_air_velocity_2, part_of_d_vy_dot_d_q0_2);
    let d_vy_dot_d_q0 = d_minus_air_velocity_1_d_q0
        .mul_add(d_vy_dot_d_minus_air_velocity_1, part_of_d_vy_dot_d_q0_3);
    j[13] = d_vy_dot_d_q0;
    let q1_minus_air_product = q1 * minus_air_velocity_product_5;
    let d_vy_dot_d_q2 = part_of_d_vy_dot_d_q2_3 + q1_minus_air_product;
    j[15] = d_vy_dot_d_q2;
    let part_of_d_vz_dot_d_q3 = q1_minus_air_product - q2_air_velocity_2_V_product;
    let q0_minus_air_product = q0 * minus_air_velocity_product_5;
    let part_of_d_vz_dot_d_q2_2 = part_of_d_vz_dot_d_q2 - q0_minus_air_product;
    let part_of_d_vy_dot_d_q3_4 = part_of_d_vy_dot_d_q3_3 + q0_minus_air_product;
    let d_vy_dot_d_q3 = q3_two.mul_add(air_velocity_2_V_product, part_of_d_vy_dot_d_q3_4);
    j[16] = d_vy_dot_d_q3;
    let part_of_d_vz_dot_d_q2_3 =
        d_air_velocity_2_d_q2.neg_mul_add(minus_d_vz_dot_d_air_velocity_2, part_of_d_vz_dot_d_q2_2);
    let part_of_d_vz_dot_d_q3_2 =
        d_minus_air_velocity_3_d_q3.mul_add(d_vz_dot_d_minus_air_velocity_3, part_of_d_vz_dot_d_q3);
    let part_of_d_vz_dot_d_q2_4 = d_minus_air_velocity_1_d_q2
        .mul_add(d_vz_dot_d_minus_air_velocity_1_2, part_of_d_vz_dot_d_q2_3);
    let d_vz_dot_d_q2 = q2_two.neg_mul_add(V_inv_m_rho_A_minus_product, part_of_d_vz_dot_d_q2_4);
    j[22] = d_vz_dot_d_q2;
    let part_of_d_vz_dot_d_q3_3 =
        d_air_velocity_2_d_q3.neg_mul_add(minus_d_vz_dot_d_air_velocity_2, part_of_d_vz_dot_d_q3_2);
    let d_vz_dot_d_q3 = d_minus_air_velocity_1_d_q3
        .mul_add(d_vz_dot_d_minus_air_velocity_1_2, part_of_d_vz_dot_d_q3_3);
    j[23] = d_vz_dot_d_q3;
    let d_p_dot_d_minus_air_velocity_1 = d_p_dot_d_air_velocity_12
        .mul_sub(minus_air_velocity_product_6, inv_air_velocity_12_product_3);
    let d_p_dot_d_air_velocity_2 = d_p_dot_d_air_velocity_12
        .mul_sub(air_velocity_2_inv_product_2, inv_air_velocity_12_product_4);
    let d_q_dot_d_minus_air_velocity_1 = d_q_dot_d_air_velocity_12
        .mul_sub(minus_air_velocity_product_6, inv_air_velocity_12_product_4);
    let d_q_dot_d_air_velocity_2 = d_q_dot_d_air_velocity_12
        .mul_add(air_velocity_2_inv_product_2, inv_air_velocity_12_product_3);
    let part_of_d_vx_dot_d_vx = q2_sq_two_plus_q3_sq_sum * d_vx_dot_d_minus_air_velocity_1;
    let part_of_d_vx_dot_d_vx_2 =
        d_vx_dot_d_air_velocity_2.mul_add(two_minus_q0_q3_plus_q1_q2, part_of_d_vx_dot_d_vx);
    let d_vx_dot_d_vx =
        d_vx_dot_d_minus_air_velocity_3.neg_mul_add(q0_q2_plus_q1_q3_two, part_of_d_vx_dot_d_vx_2);
    j[3] = d_vx_dot_d_vx;
    let minus_d_vx_dot_d_vx = -d_vx_dot_d_vx;
    jp[7] = minus_d_vx_dot_d_vx; // d_vx_dot_d_wind_x
    let part_of_d_vx_dot_d_vy = q1_sq_two_plus_q3_sq_sum * d_vx_dot_d_air_velocity_2;
    let part_of_d_vx_dot_d_vy_2 =
        d_vx_dot_d_minus_air_velocity_1.mul_add(two_q0_q3_plus_q1_q2, part_of_d_vx_dot_d_vy);
    let d_vx_dot_d_vy =
        d_vx_dot_d_minus_air_velocity_3.mul_sub(q1_q0_plus_q3_q2_two, part_of_d_vx_dot_d_vy_2);
    j[4] = d_vx_dot_d_vy;
    let minus_d_vx_dot_d_vy = -d_vx_dot_d_vy;
    jp[8] = minus_d_vx_dot_d_vy; // d_vx_dot_d_wind_y
    let part_of_d_vx_dot_d_vz = q1_sq_two_minus_one_sum * d_vx_dot_d_minus_air_velocity_3;
    let part_of_d_vx_dot_d_vz_2 = d_vx_dot_d_minus_air_velocity_1
        .neg_mul_add(two_minus_q0_q2_plus_q1_q3, part_of_d_vx_dot_d_vz);
    let d_vx_dot_d_vz =
        d_vx_dot_d_air_velocity_2.mul_add(two_q1_q0_plus_q3_q2_2, part_of_d_vx_dot_d_vz_2);
    j[5] = d_vx_dot_d_vz;
    let minus_d_vx_dot_d_vz = -d_vx_dot_d_vz;
    jp[9] = minus_d_vx_dot_d_vz; // d_vx_dot_d_wind_z
    let part_of_d_vy_dot_d_vx = q2_sq_two_plus_q3_sq_sum * d_vy_dot_d_minus_air_velocity_1;
    let part_of_d_vy_dot_d_vx_2 =
        d_vy_dot_d_air_velocity_2.mul_add(two_minus_q0_q3_plus_q1_q2, part_of_d_vy_dot_d_vx);
    let d_vy_dot_d_vx =
        d_vy_dot_d_minus_air_velocity_3.neg_mul_add(q0_q2_plus_q1_q3_two, part_of_d_vy_dot_d_vx_2);
    j[10] = d_vy_dot_d_vx;
    let minus_d_vy_dot_d_vx = -d_vy_dot_d_vx;
    jp[17] = minus_d_vy_dot_d_vx; // d_vy_dot_d_wind_x
    let part_of_d_vy_dot_d_vy = q1_sq_two_plus_q3_sq_sum * d_vy_dot_d_air_velocity_2;
    let part_of_d_vy_dot_d_vy_2 =
        d_vy_dot_d_minus_air_velocity_1.mul_add(two_q0_q3_plus_q1_q2, part_of_d_vy_dot_d_vy);
    let d_vy_dot_d_vy =
        d_vy_dot_d_minus_air_velocity_3.mul_sub(q1_q0_plus_q3_q2_two, part_of_d_vy_dot_d_vy_2);
    j[11] = d_vy_dot_d_vy;
    let minus_d_vy_dot_d_vy = -d_vy_dot_d_vy;
    jp[18] = minus_d_vy_dot_d_vy; // d_vy_dot_d_wind_y
    let part_of_d_vy_dot_d_vz = q1_sq_two_minus_one_sum * d_vy_dot_d_minus_air_velocity_3;
    let part_of_d_vy_dot_d_vz_2 = d_vy_dot_d_minus_air_velocity_1
        .neg_mul_add(two_minus_q0_q2_plus_q1_q3, part_of_d_vy_dot_d_vz);
    let d_vy_dot_d_vz =
        d_vy_dot_d_air_velocity_2.mul_add(two_q1_q0_plus_q3_q2_2, part_of_d_vy_dot_d_vz_2);
    j[12] = d_vy_dot_d_vz;
    let minus_d_vy_dot_d_vz = -d_vy_dot_d_vz;
    jp[19] = minus_d_vy_dot_d_vz; // d_vy_dot_d_wind_z
    let part_of_d_vz_dot_d_vx = q2_sq_two_plus_q3_sq_sum * d_vz_dot_d_minus_air_velocity_1_2;
    let part_of_d_vz_dot_d_vx_2 = minus_d_vz_dot_d_air_velocity_2
        .neg_mul_add(two_minus_q0_q3_plus_q1_q2, part_of_d_vz_dot_d_vx);
    let d_vz_dot_d_vx =
        d_vz_dot_d_minus_air_velocity_3.neg_mul_add(q0_q2_plus_q1_q3_two, part_of_d_vz_dot_d_vx_2);
    j[17] = d_vz_dot_d_vx;
    let minus_d_vz_dot_d_vx = -d_vz_dot_d_vx;
    jp[28] = minus_d_vz_dot_d_vx; // d_vz_dot_d_wind_x
    let part_of_d_vz_dot_d_vy = d_vz_dot_d_minus_air_velocity_1_2 * two_q0_q3_plus_q1_q2;
    let part_of_d_vz_dot_d_vy_2 = q1_sq_two_plus_q3_sq_sum
        .neg_mul_add(minus_d_vz_dot_d_air_velocity_2, part_of_d_vz_dot_d_vy);
    let d_vz_dot_d_vy =
        d_vz_dot_d_minus_air_velocity_3.mul_sub(q1_q0_plus_q3_q2_two, part_of_d_vz_dot_d_vy_2);
    j[18] = d_vz_dot_d_vy;
    let minus_d_vz_dot_d_vy = -d_vz_dot_d_vy;
    jp[29] = minus_d_vz_dot_d_vy; // d_vz_dot_d_wind_y
    let part_of_d_vz_dot_d_vz = q1_sq_two_minus_one_sum * d_vz_dot_d_minus_air_velocity_3;
    let part_of_d_vz_dot_d_vz_2 = d_vz_dot_d_minus_air_velocity_1_2
        .neg_mul_add(two_minus_q0_q2_plus_q1_q3, part_of_d_vz_dot_d_vz);
    let d_vz_dot_d_vz = minus_d_vz_dot_d_air_velocity_2
        .neg_mul_add(two_q1_q0_plus_q3_q2_2, part_of_d_vz_dot_d_vz_2);
    j[19] = d_vz_dot_d_vz;
    let minus_d_vz_dot_d_vz = -d_vz_dot_d_vz;
    jp[30] = minus_d_vz_dot_d_vz; // d_vz_dot_d_wind_z
    let part_of_d_p_dot_d_vx = q2_sq_two_plus_q3_sq_sum * d_p_dot_d_minus_air_velocity_1;
    let part_of_d_q_dot_d_vx = q2_sq_two_plus_q3_sq_sum * d_q_dot_d_minus_air_velocity_1;
    let part_of_d_p_dot_d_vx_2 =
        d_p_dot_d_air_velocity_2.mul_add(two_minus_q0_q3_plus_q1_q2, part_of_d_p_dot_d_vx);
    let part_of_d_q_dot_d_vx_2 =
        d_q_dot_d_air_velocity_2.mul_add(two_minus_q0_q3_plus_q1_q2, part_of_d_q_dot_d_vx);
    let d_p_dot_d_vx =
        d_p_dot_d_minus_air_velocity_3.neg_mul_add(q0_q2_plus_q1_q3_two, part_of_d_p_dot_d_vx_2);
    j[48] = d_p_dot_d_vx;
    let d_q_dot_d_vx =
        d_q_dot_d_minus_air_velocity_3.neg_mul_add(q0_q2_plus_q1_q3_two, part_of_d_q_dot_d_vx_2);
    j[58] = d_q_dot_d_vx;
    let minus_d_p_dot_d_vx = -d_p_dot_d_vx;
    jp[39] = minus_d_p_dot_d_vx; // d_p_dot_d_wind_x
    let minus_d_q_dot_d_vx = -d_q_dot_d_vx;
    jp[50] = minus_d_q_dot_d_vx; // d_q_dot_d_wind_x
    let part_of_d_p_dot_d_vy = q1_sq_two_plus_q3_sq_sum * d_p_dot_d_air_velocity_2;
    let part_of_d_q_dot_d_vy = q1_sq_two_plus_q3_sq_sum * d_q_dot_d_air_velocity_2;
    let part_of_d_p_dot_d_vy_2 =
        d_p_dot_d_minus_air_velocity_1.mul_add(two_q0_q3_plus_q1_q2, part_of_d_p_dot_d_vy);
    let part_of_d_q_dot_d_vy_2 =
        d_q_dot_d_minus_air_velocity_1.mul_add(two_q0_q3_plus_q1_q2, part_of_d_q_dot_d_vy);
    let d_p_dot_d_vy =
        d_p_dot_d_minus_air_velocity_3.mul_sub(q1_q0_plus_q3_q2_two, part_of_d_p_dot_d_vy_2);
    j[49] = d_p_dot_d_vy;
    let d_q_dot_d_vy =
        d_q_dot_d_minus_air_velocity_3.mul_sub(q1_q0_plus_q3_q2_two, part_of_d_q_dot_d_vy_2);
    j[59] = d_q_dot_d_vy;
    let minus_d_p_dot_d_vy = -d_p_dot_d_vy;
    jp[40] = minus_d_p_dot_d_vy; // d_p_dot_d_wind_y
    let minus_d_q_dot_d_vy = -d_q_dot_d_vy;
    jp[51] = minus_d_q_dot_d_vy; // d_q_dot_d_wind_y
    let part_of_d_p_dot_d_vz = q1_sq_two_minus_one_sum * d_p_dot_d_minus_air_velocity_3;
    let part_of_d_q_dot_d_vz = q1_sq_two_minus_one_sum * d_q_dot_d_minus_air_velocity_3;
    let part_of_d_p_dot_d_vz_2 = d_p_dot_d_minus_air_velocity_1
        .neg_mul_add(two_minus_q0_q2_plus_q1_q3, part_of_d_p_dot_d_vz);
    let part_of_d_q_dot_d_vz_2 = d_q_dot_d_minus_air_velocity_1
        .neg_mul_add(two_minus_q0_q2_plus_q1_q3, part_of_d_q_dot_d_vz);
    let d_p_dot_d_vz =
        d_p_dot_d_air_velocity_2.mul_add(two_q1_q0_plus_q3_q2_2, part_of_d_p_dot_d_vz_2);
    j[50] = d_p_dot_d_vz;
    let d_q_dot_d_vz =
        d_q_dot_d_air_velocity_2.mul_add(two_q1_q0_plus_q3_q2_2, part_of_d_q_dot_d_vz_2);
    j[60] = d_q_dot_d_vz;
    let minus_d_p_dot_d_vz = -d_p_dot_d_vz;
    jp[41] = minus_d_p_dot_d_vz; // d_p_dot_d_wind_z
    let minus_d_q_dot_d_vz = -d_q_dot_d_vz;
    jp[52] = minus_d_q_dot_d_vz; // d_q_dot_d_wind_z
    let part_of_d_p_dot_d_q0 = minus_d_minus_air_velocity_3_d_q0 * d_p_dot_d_minus_air_velocity_3;
    let part_of_d_q_dot_d_q0 = minus_d_minus_air_velocity_3_d_q0 * d_q_dot_d_minus_air_velocity_3;
    let part_of_d_p_dot_d_q0_2 =
        d_air_velocity_2_d_q0.mul_sub(d_p_dot_d_air_velocity_2, part_of_d_p_dot_d_q0);
    let part_of_d_q_dot_d_q0_2 =
        d_air_velocity_2_d_q0.mul_sub(d_q_dot_d_air_velocity_2, part_of_d_q_dot_d_q0);
    let d_p_dot_d_q0 =
        d_minus_air_velocity_1_d_q0.mul_add(d_p_dot_d_minus_air_velocity_1, part_of_d_p_dot_d_q0_2);
    j[51] = d_p_dot_d_q0;
    let d_q_dot_d_q0 =
        d_minus_air_velocity_1_d_q0.mul_add(d_q_dot_d_minus_air_velocity_1, part_of_d_q_dot_d_q0_2);
    j[61] = d_q_dot_d_q0;
    let part_of_d_p_dot_d_q1 = d_minus_air_velocity_3_d_q1 * d_p_dot_d_minus_air_velocity_3;
    let part_of_d_q_dot_d_q1 = d_minus_air_velocity_3_d_q1 * d_q_dot_d_minus_air_velocity_3;
    let part_of_d_p_dot_d_q1_2 =
        d_air_velocity_2_d_q1.mul_add(d_p_dot_d_air_velocity_2, part_of_d_p_dot_d_q1);
    let part_of_d_q_dot_d_q1_2 =
        d_air_velocity_2_d_q1.mul_add(d_q_dot_d_air_velocity_2, part_of_d_q_dot_d_q1);
    let d_p_dot_d_q1 =
        d_minus_air_velocity_1_d_q1.mul_add(d_p_dot_d_minus_air_velocity_1, part_of_d_p_dot_d_q1_2);
    j[52] = d_p_dot_d_q1;
    let d_q_dot_d_q1 =
        d_minus_air_velocity_1_d_q1.mul_add(d_q_dot_d_minus_air_velocity_1, part_of_d_q_dot_d_q1_2);
    j[62] = d_q_dot_d_q1;
    let part_of_d_p_dot_d_q2 = d_minus_air_velocity_3_d_q2 * d_p_dot_d_minus_air_velocity_3;
    let part_of_d_p_dot_d_q3 = d_minus_air_velocity_3_d_q3 * d_p_dot_d_minus_air_velocity_3;
    let part_of_d_q_dot_d_q2 = d_minus_air_velocity_3_d_q2 * d_q_dot_d_minus_air_velocity_3;
    let part_of_d_q_dot_d_q3 = d_minus_air_velocity_3_d_q3 * d_q_dot_d_minus_air_velocity_3;
    let part_of_d_p_dot_d_q2_2 =
        d_air_velocity_2_d_q2.mul_add(d_p_dot_d_air_velocity_2, part_of_d_p_dot_d_q2);
    let part_of_d_p_dot_d_q3_2 =
        d_air_velocity_2_d_q3.mul_add(d_p_dot_d_air_velocity_2, part_of_d_p_dot_d_q3);
    let rho = parameters[5];
    let rho_V_inv_m = rho * V_inv_m;
    let part_of_d_q_dot_d_q2_2 =
        d_air_velocity_2_d_q2.mul_add(d_q_dot_d_air_velocity_2, part_of_d_q_dot_d_q2);
    let A = parameters[4];
    let A_V_inv_m = A * V_inv_m;
    let rho_inv_I_d_d_V_sq_half = rho * inv_I_d_d_V_sq_half;
    let part_of_d_q_dot_d_q3_2 =
        d_air_velocity_2_d_q3.mul_add(d_q_dot_d_air_velocity_2, part_of_d_q_dot_d_q3);
    let A_inv_I_d_d_V_sq_half = A * inv_I_d_d_V_sq_half;
    let minus_d_q3_dot_d_q2 = T::splat(0.5) * p;
    j[30] = minus_d_q3_dot_d_q2; // d_q1_dot_d_q0
    j[38] = minus_d_q3_dot_d_q2; // d_q2_dot_d_q3
    let minus_d_q1_dot_d_q3 = T::splat(0.5) * q;
    j[36] = minus_d_q1_dot_d_q3; // d_q2_dot_d_q0
    j[43] = minus_d_q1_dot_d_q3; // d_q3_dot_d_q1
    let d_p_dot_d_q2 =
        d_minus_air_velocity_1_d_q2.mul_add(d_p_dot_d_minus_air_velocity_1, part_of_d_p_dot_d_q2_2);
    j[53] = d_p_dot_d_q2;
    let minus_d_q2_dot_d_q1 = T::splat(0.5) * r;
    j[31] = minus_d_q2_dot_d_q1; // d_q1_dot_d_q2
    j[42] = minus_d_q2_dot_d_q1; // d_q3_dot_d_q0
    let d_p_dot_d_q3 =
        d_minus_air_velocity_1_d_q3.mul_add(d_p_dot_d_minus_air_velocity_1, part_of_d_p_dot_d_q3_2);
    j[54] = d_p_dot_d_q3;
    let minus_d_q2_dot_d_r = T::splat(0.5) * q1;
    j[46] = minus_d_q2_dot_d_r; // d_q3_dot_d_q
    let minus_d_q3_dot_d_p = T::splat(0.5) * q2;
    j[35] = minus_d_q3_dot_d_p; // d_q1_dot_d_r
    let d_q_dot_d_q2 =
        d_minus_air_velocity_1_d_q2.mul_add(d_q_dot_d_minus_air_velocity_1, part_of_d_q_dot_d_q2_2);
    j[63] = d_q_dot_d_q2;
    let minus_d_q1_dot_d_q = T::splat(0.5) * q3;
    j[39] = minus_d_q1_dot_d_q; // d_q2_dot_d_p
    let d_p_dot_d_q = one_minus_inv_I_d_I_a * r;
    j[56] = d_p_dot_d_q;
    let d_q_dot_d_q3 =
        d_minus_air_velocity_1_d_q3.mul_add(d_q_dot_d_minus_air_velocity_1, part_of_d_q_dot_d_q3_2);
    j[64] = d_q_dot_d_q3;
    let minus_d_vz_dot_d_m = minus_q1_sq_two_minus_one_sum_2 * inv_m_rho_A_V_inv_m;
    let d_vx_dot_d_A = q0_q2_plus_q1_q3_sum * rho_V_inv_m;
    jp[1] = d_vx_dot_d_A;
    let d_vx_dot_d_rho = q0_q2_plus_q1_q3_sum * A_V_inv_m;
    jp[2] = d_vx_dot_d_rho;
    let d_vy_dot_d_A = minus_q1_q0_plus_q3_sum * rho_V_inv_m;
    jp[11] = d_vy_dot_d_A;
    let d_vy_dot_d_rho = minus_q1_q0_plus_q3_sum * A_V_inv_m;
    jp[12] = d_vy_dot_d_rho;
    jp[21] = minus_q1_sq_two_minus_one_sum_2 * rho_V_inv_m; // d_vz_dot_d_A
    jp[22] = minus_q1_sq_two_minus_one_sum_2 * A_V_inv_m; // d_vz_dot_d_rho
    jp[34] = minus_inv_air_velocity_sum * rho_inv_I_d_d_V_sq_half; // d_p_dot_d_A
    jp[35] = minus_inv_air_velocity_sum * A_inv_I_d_d_V_sq_half; // d_p_dot_d_rho
    jp[45] = inv_air_velocity_12_sum * rho_inv_I_d_d_V_sq_half; // d_q_dot_d_A
    jp[46] = inv_air_velocity_12_sum * A_inv_I_d_d_V_sq_half; // d_q_dot_d_rho
    let d_q0_dot_d_q1 = -minus_d_q3_dot_d_q2;
    j[24] = d_q0_dot_d_q1;
    j[44] = d_q0_dot_d_q1; // d_q3_dot_d_q2
    let d_q0_dot_d_q2 = -minus_d_q1_dot_d_q3;
    j[25] = d_q0_dot_d_q2;
    j[32] = d_q0_dot_d_q2; // d_q1_dot_d_q3
    let d_q0_dot_d_q3 = -minus_d_q2_dot_d_q1;
    j[26] = d_q0_dot_d_q3;
    j[37] = d_q0_dot_d_q3; // d_q2_dot_d_q1
    let d_q0_dot_d_p = -minus_d_q2_dot_d_r;
    j[27] = d_q0_dot_d_p;
    j[41] = d_q0_dot_d_p; // d_q2_dot_d_r
    let d_q0_dot_d_q = -minus_d_q3_dot_d_p;
    j[28] = d_q0_dot_d_q;
    j[45] = d_q0_dot_d_q; // d_q3_dot_d_p
    let d_q0_dot_d_r = -minus_d_q1_dot_d_q;
    j[29] = d_q0_dot_d_r;
    j[34] = d_q0_dot_d_r; // d_q1_dot_d_q
    let d_q_dot_d_p = -d_p_dot_d_q;
    j[65] = d_q_dot_d_p;
    let d_vx_dot_d_m = -(q0_q2_plus_q1_q3_sum * inv_m_rho_A_V_inv_m);
    jp[0] = d_vx_dot_d_m;
    let d_vy_dot_d_m = -(minus_q1_q0_plus_q3_sum * inv_m_rho_A_V_inv_m);
    jp[10] = d_vy_dot_d_m;
    let d_vz_dot_d_m = -minus_d_vz_dot_d_m;
    jp[20] = d_vz_dot_d_m;

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    j[0] = T::splat(1.0); // d_x_dot_d_vx
    j[1] = T::splat(1.0); // d_y_dot_d_vy
    j[2] = T::splat(1.0); // d_z_dot_d_vz
    j[68] = C_Nr_inv_I_a; // d_r_dot_d_r
    jp[23] = T::splat(-1.0); // d_vz_dot_d_g
}
