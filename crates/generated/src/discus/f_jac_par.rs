// Written by `hyzer generate`; changes belong in the model.
//! `discus`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 538 operations: 134 add, 358 mul, 4 div, 32 neg, 2 sqrt, 7 call, 1 select.
#[inline(always)]
pub fn f_jac_par<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 33],
    dx: &mut [T; 12],
    j: &mut [T; 60],
    jp: &mut [T; 67],
) {
    let u = state[3];
    let v = state[4];
    let w = state[5];
    let phi = state[6];
    let theta = state[7];
    let phidot = state[9];
    let thetadot = state[10];
    let gammadot = state[11];
    let I_a = parameters[1];
    let g = parameters[6];
    let C_Lp = parameters[8];
    let C_D0 = parameters[10];
    let C_Ds = parameters[11];
    let C_Ms = parameters[12];
    let C_Mq = parameters[13];
    let wind_x = parameters[15];
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let minus_p8_plus_p7 = prepared[0];
    let inv_p9 = prepared[1];
    let inv_p0_half_p5_p4 = prepared[2];
    let inv_p2_p1 = prepared[4];
    let half_p5_p4_p3_inv_p2 = prepared[5];
    let p14_inv_p1 = prepared[6];
    let two_p11 = prepared[7];
    let minus_n1_plus_inv_p2_p1 = prepared[11];
    let p4_half = prepared[12];
    let p5_p4_half = prepared[13];
    let inv_p0 = prepared[14];
    let inv_p2 = prepared[15];
    let inv_p1 = prepared[16];
    let p7_minus_p8_n8 = prepared[17];
    let p5_half = prepared[18];
    let minus_p5_half = prepared[19];
    let minus_p4_half = prepared[20];
    let minus_p5_p4_half_inv_p0 = prepared[21];
    let p5_p4_half_p3 = prepared[22];
    let inv_p2_sq = prepared[23];
    let p5_p4_half_inv_p2 = prepared[24];
    let p3_inv_p2_p5_half = prepared[25];
    let p3_inv_p2_p4_half = prepared[26];
    let minus_inv_p2_p5_part_sum = prepared[27];
    let inv_p1_d_gammadot_dot_d_r = prepared[28];
    let minus_p5_p4_half_inv_p2 = prepared[29];
    let minus_p3_inv_p2_p5_half = prepared[30];
    let minus_p3_inv_p2_p4_half = prepared[31];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // discus.hyz:63  position (x, y, z) in N;
    let x_dot = u * cos_theta + w * sin_theta;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let cos_theta_w_minus_u_sin_sum = cos_theta * w - u * sin_theta;
    let y_dot = v * cos_phi - sin_phi * cos_theta_w_minus_u_sin_sum;
    let z_dot = cos_phi * cos_theta_w_minus_u_sin_sum + v * sin_phi;
    let cos_phi_g = g * cos_phi;
    let v_phidot_plus_cos_phi_g = v * phidot + cos_phi_g;
    let sin_theta_v_phidot_product = sin_theta * v_phidot_plus_cos_phi_g;
    let cos_phi_wind_z_minus_sum = wind_z * cos_phi - wind_y * sin_phi;
    let cos_theta_cos_phi_sum = cos_theta * cos_phi_wind_z_minus_sum + wind_x * sin_theta;
    let minus_w_plus_cos_theta_sum = cos_theta_cos_phi_sum - w;
    let minus_w_plus_cos_product = minus_w_plus_cos_theta_sum * minus_w_plus_cos_theta_sum;
    let minus_cos_theta_wind_x_sum = sin_theta * cos_phi_wind_z_minus_sum - wind_x * cos_theta;

    // discus.hyz:70  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u + minus_cos_theta_wind_x_sum;
    let cos_phi_wind_y_plus_sin_sum = wind_y * cos_phi + wind_z * sin_phi;
    let air_velocity_2 = v - cos_phi_wind_y_plus_sin_sum;
    let air_velocity_1_sq_plus_sum =
        air_velocity_1 * air_velocity_1 + air_velocity_2 * air_velocity_2;
    let minus_w_plus_cos_sum = minus_w_plus_cos_product + air_velocity_1_sq_plus_sum;

    // discus.hyz:72  let V = norm(air_velocity);
    let V = minus_w_plus_cos_sum.sqrt();
    let V_inv_m = inv_p0 * V;
    let rho_A_half_V_inv_m = p5_p4_half * V_inv_m;
    let inv_V = V.recip_or_zero();
    let minus_w_plus_cos_product_2 = minus_w_plus_cos_theta_sum * inv_V;
    let minus_w_plus_cos_product_3 = inv_p9 * minus_w_plus_cos_product_2;
    let minus_w_plus_cos_product_4 = minus_w_plus_cos_product_3 * minus_w_plus_cos_product_3;
    let minus_w_plus_cos_product_5 = minus_w_plus_cos_product_4 * minus_w_plus_cos_product_4;
    let part_of_inv_minus_w_plus_cos_sum =
        minus_w_plus_cos_product_5 * minus_w_plus_cos_product_5 + T::splat(1.0);
    let inv_minus_w_plus_cos_sum = T::splat(1.0) / part_of_inv_minus_w_plus_cos_sum;
    let C_Lp_plus_C_Ls_minus_C_sum = C_Lp + minus_p8_plus_p7 * inv_minus_w_plus_cos_sum;
    let sqrt_air_velocity_1_sq_of = air_velocity_1_sq_plus_sum.sqrt();

    // discus.hyz:77  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_w_plus_cos_theta_sum.atan2(sqrt_air_velocity_1_sq_of);
    let alpha_two = T::splat(2.0) * alpha;
    let (sin_alpha_two, cos_alpha_two) = alpha_two.sin_cos();
    let C_Lp_plus_C_Ls_product = C_Lp_plus_C_Ls_minus_C_sum * sin_alpha_two;

    // discus.hyz:83  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = C_D0 + C_Ds * minus_w_plus_cos_product_2 * minus_w_plus_cos_product_2;
    let minus_minus_w_plus_cos_sum =
        sqrt_air_velocity_1_sq_of * C_D - minus_w_plus_cos_theta_sum * C_Lp_plus_C_Ls_product;
    let rho_A_half_V_inv_m_product = rho_A_half_V_inv_m * minus_minus_w_plus_cos_sum;
    let inv_sqrt_air_velocity_1_of = sqrt_air_velocity_1_sq_of.recip_or_zero();
    let air_velocity_1_inv_product = air_velocity_1 * inv_sqrt_air_velocity_1_of;
    let part_of_u_dot =
        sin_theta_v_phidot_product - rho_A_half_V_inv_m_product * air_velocity_1_inv_product;

    // discus.hyz:64  velocity (u, v, w) in B;
    let u_dot = part_of_u_dot - w * thetadot;
    let air_velocity_2_inv_product = air_velocity_2 * inv_sqrt_air_velocity_1_of;
    let part_of_v_dot = rho_A_half_V_inv_m_product * air_velocity_2_inv_product;
    let sin_phi_g = g * sin_phi;
    let v_dot = cos_theta_w_minus_u_sin_sum * phidot - part_of_v_dot - sin_phi_g;
    let cos_theta_v_phidot_product = cos_theta * v_phidot_plus_cos_phi_g;
    let sqrt_air_velocity_1_sum =
        sqrt_air_velocity_1_sq_of * C_Lp_plus_C_Ls_product + minus_w_plus_cos_theta_sum * C_D;
    let part_of_w_dot = rho_A_half_V_inv_m * sqrt_air_velocity_1_sum - cos_theta_v_phidot_product;
    let w_dot = part_of_w_dot + u * thetadot;
    let nonzero_sqrt_air_of = sqrt_air_velocity_1_sq_of.if_zero(T::splat(0.0), T::splat(1.0));
    let minus_w_plus_cos_product_6 = half_p5_p4_p3_inv_p2 * minus_w_plus_cos_sum;
    let nonzero_sqrt_air_of_product = nonzero_sqrt_air_of * minus_w_plus_cos_product_6;
    let C_Mq_nonzero_sqrt_product = C_Mq * nonzero_sqrt_air_of_product;
    let sin_theta_two = T::splat(2.0) * sin_theta;
    let cos_theta_C_Mq_product_sum =
        cos_theta * C_Mq_nonzero_sqrt_product + thetadot * sin_theta_two;
    let minus_w_plus_cos_product_7 = C_Ms * minus_w_plus_cos_product_6;
    let sin_alpha_two_minus_product = sin_alpha_two * minus_w_plus_cos_product_7;
    let part_of_phidot_cos_theta_C_product =
        air_velocity_2_inv_product * sin_alpha_two_minus_product;
    let sin_theta_phidot = sin_theta * phidot;

    // discus.hyz:88  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let r_inv_I_d_I_a = inv_p2_p1 * r;
    let part_of_phidot_cos_theta_C_product_2 =
        phidot * cos_theta_C_Mq_product_sum - part_of_phidot_cos_theta_C_product;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let phidot_cos_theta_C_product =
        (part_of_phidot_cos_theta_C_product_2 - thetadot * r_inv_I_d_I_a) * inv_cos_theta;
    let cos_theta_phidot = cos_theta * phidot;
    let sin_theta_phidot_minus_sum = sin_theta_phidot - r_inv_I_d_I_a;
    let part_of_thetadot_dot =
        thetadot * C_Mq_nonzero_sqrt_product - cos_theta_phidot * sin_theta_phidot_minus_sum;

    // discus.hyz:56  frame B = A turned theta about 2; // does not spin with the discus
    let thetadot_dot =
        part_of_thetadot_dot + air_velocity_1_inv_product * sin_alpha_two_minus_product;

    // discus.hyz:57  frame C = B turned gamma about 3; // fixed in the discus
    let gammadot_dot =
        p14_inv_p1 * r - thetadot * cos_theta_phidot - sin_theta * phidot_cos_theta_C_product;
    let cos_theta_sin_phi = cos_theta * sin_phi;
    let sin_theta_cos_phi = sin_theta * cos_phi;
    let cos_theta_cos_phi = cos_theta * cos_phi;
    let rho_A_half_V_inv_m_C_D = rho_A_half_V_inv_m * C_D;
    let C_Lp_plus_C_Ls_product_2 = C_Lp_plus_C_Ls_minus_C_sum * cos_alpha_two;
    let sqrt_air_velocity_1_product = sqrt_air_velocity_1_sq_of * inv_V;
    let inv_s_stall_inv_product = inv_p9 * inv_minus_w_plus_cos_sum;
    let part_of_minus_w_plus_cos_product_8 =
        p7_minus_p8_n8 * (minus_w_plus_cos_product_3 * minus_w_plus_cos_product_4);
    let minus_w_plus_cos_product_8 =
        minus_w_plus_cos_product_5 * inv_s_stall_inv_product * part_of_minus_w_plus_cos_product_8;
    let inv_minus_w_plus_product = inv_minus_w_plus_cos_sum * sin_alpha_two;
    let minus_w_plus_cos_product_9 = minus_w_plus_cos_product_8 * inv_minus_w_plus_product;
    let part_of_two_C_Lp_plus_C_Ls_product =
        sqrt_air_velocity_1_product * minus_w_plus_cos_product_9;
    let part_of_two_C_Lp_plus_C_Ls_product_2 =
        T::splat(2.0) * C_Lp_plus_C_Ls_product_2 - part_of_two_C_Lp_plus_C_Ls_product;
    let d_w_dot_d_C_D = minus_w_plus_cos_theta_sum * rho_A_half_V_inv_m;
    let two_C_Lp_plus_C_Ls_product = part_of_two_C_Lp_plus_C_Ls_product_2 * d_w_dot_d_C_D;
    let part_of_rho_A_half_V_inv_m_C_D_sum =
        minus_w_plus_cos_product_2 * two_C_Lp_plus_C_Ls_product;
    let sqrt_air_velocity_1_product_2 = T::splat(2.0) * sqrt_air_velocity_1_sq_of;
    let minus_w_plus_cos_product_10 = minus_w_plus_cos_product_2 * d_w_dot_d_C_D;
    let inv_V_sq = inv_V * inv_V;
    let minus_w_plus_cos_product_11 = minus_w_plus_cos_product_10 * (C_Ds * inv_V_sq);
    let part_of_minus_minus_w_plus_sum =
        sqrt_air_velocity_1_product_2 * minus_w_plus_cos_product_11;
    let minus_minus_w_plus_sum =
        inv_p0_half_p5_p4 * minus_minus_w_plus_cos_sum - part_of_minus_minus_w_plus_sum;
    let part_of_rho_A_half_V_inv_m_C_D_sum_2 =
        part_of_rho_A_half_V_inv_m_C_D_sum + sqrt_air_velocity_1_sq_of * minus_minus_w_plus_sum;
    let part_of_rho_A_half_V_inv_m_C_D_sum_3 =
        rho_A_half_V_inv_m_C_D + inv_V * part_of_rho_A_half_V_inv_m_C_D_sum_2;
    let part_of_rho_A_half_V_inv_m_C_D_sum_4 =
        rho_A_half_V_inv_m_product * inv_sqrt_air_velocity_1_of;
    let rho_A_half_V_inv_m_C_D_sum =
        part_of_rho_A_half_V_inv_m_C_D_sum_3 - part_of_rho_A_half_V_inv_m_C_D_sum_4;
    let part_of_inv_sqrt_air_product =
        air_velocity_1 * (air_velocity_1_inv_product * rho_A_half_V_inv_m_C_D_sum);
    let inv_sqrt_air_product =
        inv_sqrt_air_velocity_1_of * (rho_A_half_V_inv_m_product + part_of_inv_sqrt_air_product);
    let air_velocity_2_inv_product_2 =
        air_velocity_2_inv_product * (air_velocity_1_inv_product * rho_A_half_V_inv_m_C_D_sum);
    let rho_A_half_V_inv_m_product_2 = rho_A_half_V_inv_m * C_Lp_plus_C_Ls_product;
    let sqrt_air_velocity_1_product_3 = sqrt_air_velocity_1_sq_of * rho_A_half_V_inv_m;
    let minus_w_plus_cos_product_12 = minus_w_plus_cos_product_2 * sqrt_air_velocity_1_product_3;
    let part_of_minus_inv_V_C_Lp_plus_C_sum_2 =
        inv_V * C_Lp_plus_C_Ls_product_2 * sqrt_air_velocity_1_product_2;
    let part_of_minus_inv_V_C_Lp_plus_C_sum =
        (T::splat(1.0) - minus_w_plus_cos_product * inv_V_sq) * minus_w_plus_cos_product_9;
    let minus_inv_V_C_Lp_plus_C_sum =
        part_of_minus_inv_V_C_Lp_plus_C_sum - part_of_minus_inv_V_C_Lp_plus_C_sum_2;
    let part_of_minus_rho_A_half_V_inv_sum =
        minus_minus_w_plus_sum + rho_A_half_V_inv_m * minus_inv_V_C_Lp_plus_C_sum;
    let part_of_minus_rho_A_half_V_inv_sum_2 =
        minus_w_plus_cos_theta_sum * part_of_minus_rho_A_half_V_inv_sum;
    let part_of_minus_rho_A_half_V_inv_sum_3 =
        two_p11 * minus_w_plus_cos_product_12 + part_of_minus_rho_A_half_V_inv_sum_2;
    let minus_rho_A_half_V_inv_sum =
        inv_V * part_of_minus_rho_A_half_V_inv_sum_3 - rho_A_half_V_inv_m_product_2;
    let air_velocity_1_inv_product_2 = air_velocity_1_inv_product * minus_rho_A_half_V_inv_sum;
    let cos_theta_air_product = cos_theta * air_velocity_1_inv_product;
    let minus_rho_A_half_V_product = minus_rho_A_half_V_inv_sum * cos_theta_air_product;
    let part_of_d_u_dot_d_phi_2 = cos_phi_wind_y_plus_sin_sum * minus_rho_A_half_V_product;
    let part_of_d_u_dot_d_phi =
        sin_theta * (sin_phi_g - inv_sqrt_air_product * cos_phi_wind_y_plus_sin_sum);
    let part_of_d_u_dot_d_phi_3 =
        part_of_d_u_dot_d_phi_2 + cos_phi_wind_z_minus_sum * air_velocity_2_inv_product_2;
    let part_of_d_u_dot_d_theta =
        cos_theta_v_phidot_product - inv_sqrt_air_product * cos_theta_cos_phi_sum;
    let part_of_d_u_dot_d_theta_2 =
        part_of_d_u_dot_d_theta + air_velocity_1_inv_product_2 * minus_cos_theta_wind_x_sum;
    let minus_air_velocity_2_sum = -(air_velocity_2_inv_product * rho_A_half_V_inv_m_C_D_sum);
    let part_of_d_v_dot_d_u =
        air_velocity_1_inv_product * minus_air_velocity_2_sum - sin_theta_phidot;
    let rho_A_half_V_inv_m_sum =
        rho_A_half_V_inv_m_product - air_velocity_2 * minus_air_velocity_2_sum;
    let inv_sqrt_air_product_2 = inv_sqrt_air_velocity_1_of * rho_A_half_V_inv_m_sum;
    let air_velocity_2_inv_product_3 = air_velocity_2_inv_product * minus_rho_A_half_V_inv_sum;
    let cos_theta_air_product_2 = cos_theta * air_velocity_2_inv_product_3;
    let sin_theta_air_velocity_1 = sin_theta * air_velocity_1;
    let cos_phi_wind_y_plus_product = cos_phi_wind_y_plus_sin_sum * sin_theta_air_velocity_1;
    let part_of_d_v_dot_d_phi = minus_air_velocity_2_sum * cos_phi_wind_y_plus_product;
    let part_of_d_v_dot_d_phi_2 =
        part_of_d_v_dot_d_phi - cos_phi_wind_z_minus_sum * rho_A_half_V_inv_m_sum;
    let part_of_d_v_dot_d_phi_3 = cos_phi_wind_y_plus_sin_sum * cos_theta_air_product_2 - cos_phi_g;
    let part_of_d_v_dot_d_phi_4 =
        part_of_d_v_dot_d_phi_3 - inv_sqrt_air_velocity_1_of * part_of_d_v_dot_d_phi_2;
    let air_velocity_1_inv_product_3 = air_velocity_1_inv_product * cos_theta_cos_phi_sum;
    let part_of_d_v_dot_d_theta = minus_cos_theta_wind_x_sum * air_velocity_2_inv_product_3;
    let part_of_d_v_dot_d_theta_2 =
        minus_air_velocity_2_sum * air_velocity_1_inv_product_3 + part_of_d_v_dot_d_theta;
    let minus_w_plus_cos_product_13 = T::splat(2.0) * minus_w_plus_cos_theta_sum;
    let part_of_sqrt_air_velocity_1_sum_2 =
        minus_w_plus_cos_product_13 * minus_w_plus_cos_product_11;
    let sqrt_air_velocity_1_sum_2 =
        inv_p0_half_p5_p4 * sqrt_air_velocity_1_sum - part_of_sqrt_air_velocity_1_sum_2;
    let part_of_rho_A_half_V_inv_m_sum_2 =
        sqrt_air_velocity_1_sum_2 - inv_V * two_C_Lp_plus_C_Ls_product;
    let part_of_rho_A_half_V_inv_m_sum_2_2 =
        part_of_rho_A_half_V_inv_m_sum_2 * sqrt_air_velocity_1_product;
    let rho_A_half_V_inv_m_sum_2 =
        rho_A_half_V_inv_m_product_2 + part_of_rho_A_half_V_inv_m_sum_2_2;
    let part_of_d_w_dot_d_v =
        air_velocity_2_inv_product * rho_A_half_V_inv_m_sum_2 - cos_theta_phidot;
    let part_of_rho_A_half_V_inv_m_C_D_sum_2_2 =
        inv_V * minus_inv_V_C_Lp_plus_C_sum * sqrt_air_velocity_1_product_3;
    let part_of_rho_A_half_V_inv_m_C_D_sum_2_5 =
        rho_A_half_V_inv_m_C_D - part_of_rho_A_half_V_inv_m_C_D_sum_2_2;
    let part_of_rho_A_half_V_inv_m_C_D_sum_2_3 =
        minus_w_plus_cos_product_2 * sqrt_air_velocity_1_sum_2;
    let part_of_rho_A_half_V_inv_m_C_D_sum_2_4 =
        part_of_rho_A_half_V_inv_m_C_D_sum_2_3 + two_p11 * inv_V * minus_w_plus_cos_product_10;
    let rho_A_half_V_inv_m_C_D_sum_2 =
        part_of_rho_A_half_V_inv_m_C_D_sum_2_5 + part_of_rho_A_half_V_inv_m_C_D_sum_2_4;
    let air_velocity_2_cos_product = air_velocity_2 * cos_phi_wind_z_minus_sum;
    let inv_sqrt_air_product_3 = inv_sqrt_air_velocity_1_of * rho_A_half_V_inv_m_sum_2;
    let part_of_d_w_dot_d_phi =
        (air_velocity_2_cos_product + cos_phi_wind_y_plus_product) * inv_sqrt_air_product_3;
    let part_of_d_w_dot_d_phi_2 =
        sin_phi_g - cos_phi_wind_y_plus_sin_sum * rho_A_half_V_inv_m_C_D_sum_2;
    let part_of_d_w_dot_d_theta =
        sin_theta_v_phidot_product + rho_A_half_V_inv_m_sum_2 * air_velocity_1_inv_product_3;
    let part_of_d_w_dot_d_theta_2 =
        part_of_d_w_dot_d_theta - minus_cos_theta_wind_x_sum * rho_A_half_V_inv_m_C_D_sum_2;
    let phidot_C_Mq = C_Mq * phidot;
    let sin_alpha_two_air_product = sin_alpha_two * air_velocity_2_inv_product;
    let C_Ms_inv_cos_theta_product = C_Ms * inv_cos_theta * sin_alpha_two_air_product;
    let rho_part_part_d_inv_product = half_p5_p4_p3_inv_p2 * sqrt_air_velocity_1_product_2;
    let part_of_minus_minus_phidot_C_Mq_sum =
        (C_Ms_inv_cos_theta_product - phidot_C_Mq) * rho_part_part_d_inv_product;
    let inv_sqrt_air_product_4 = inv_sqrt_air_velocity_1_of * sin_alpha_two_minus_product;
    let minus_w_plus_cos_product_14 = minus_w_plus_cos_product_7 * (cos_alpha_two * inv_V_sq);
    let air_velocity_2_inv_product_4 = air_velocity_2_inv_product * minus_w_plus_cos_product_14;
    let part_of_minus_minus_phidot_C_Mq_sum_2 =
        minus_w_plus_cos_product_13 * air_velocity_2_inv_product_4;
    let part_of_minus_minus_phidot_C_Mq_sum_3 =
        air_velocity_2_inv_product * inv_sqrt_air_product_4 + part_of_minus_minus_phidot_C_Mq_sum_2;
    let minus_minus_phidot_C_Mq_sum =
        inv_cos_theta * part_of_minus_minus_phidot_C_Mq_sum_3 - part_of_minus_minus_phidot_C_Mq_sum;
    let minus_air_velocity_2_sum_2 =
        sin_alpha_two_minus_product * inv_cos_theta - air_velocity_2 * minus_minus_phidot_C_Mq_sum;
    let inv_sqrt_air_product_5 = inv_sqrt_air_velocity_1_of * minus_air_velocity_2_sum_2;
    let inv_cos_theta_air_product = inv_cos_theta * air_velocity_2_inv_product_4;
    let part_of_d_phidot_dot_d_w = sqrt_air_velocity_1_product_2 * inv_cos_theta_air_product;
    let minus_C_Ms_inv_cos_sum = nonzero_sqrt_air_of * phidot_C_Mq - C_Ms_inv_cos_theta_product;
    let rho_part_part_d_inv_product_2 = half_p5_p4_p3_inv_p2 * minus_w_plus_cos_product_13;
    let part_of_d_phidot_dot_d_w_2 =
        part_of_d_phidot_dot_d_w - minus_C_Ms_inv_cos_sum * rho_part_part_d_inv_product_2;
    let minus_w_plus_cos_product_15 = half_p5_p4_p3_inv_p2 * minus_w_plus_cos_theta_sum;
    let part_of_minus_C_Ms_inv_cos_sum_2 = sqrt_air_velocity_1_sq_of * inv_cos_theta_air_product;
    let minus_C_Ms_inv_cos_sum_2 =
        minus_C_Ms_inv_cos_sum * minus_w_plus_cos_product_15 - part_of_minus_C_Ms_inv_cos_sum_2;
    let cos_theta_two = T::splat(2.0) * cos_theta;
    let cos_phi_wind_y_plus_product_2 = cos_phi_wind_y_plus_sin_sum * cos_theta_two;
    let part_of_minus_C_Ms_inv_cos_sum_3_4 =
        minus_C_Ms_inv_cos_sum_2 * cos_phi_wind_y_plus_product_2;
    let part_of_minus_C_Ms_inv_cos_sum_3 =
        minus_minus_phidot_C_Mq_sum * cos_phi_wind_y_plus_product;
    let part_of_minus_C_Ms_inv_cos_sum_3_2 =
        part_of_minus_C_Ms_inv_cos_sum_3 - cos_phi_wind_z_minus_sum * minus_air_velocity_2_sum_2;
    let part_of_minus_C_Ms_inv_cos_sum_3_3 =
        inv_sqrt_air_velocity_1_of * part_of_minus_C_Ms_inv_cos_sum_3_2;
    let minus_C_Ms_inv_cos_sum_3 =
        part_of_minus_C_Ms_inv_cos_sum_3_4 + part_of_minus_C_Ms_inv_cos_sum_3_3;
    let phidot_thetadot = phidot * thetadot;
    let thetadot_inv_I_d_I_a = inv_p2_p1 * thetadot;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let part_of_two_phidot_thetadot_sum_sum =
        (phidot_cos_theta_C_product - phidot * C_Mq_nonzero_sqrt_product) * sin_theta_inv_cos_theta;
    let part_of_two_phidot_thetadot_sum_sum_2 =
        phidot * thetadot_inv_I_d_I_a - part_of_two_phidot_thetadot_sum_sum;
    let part_of_two_phidot_thetadot_sum_sum_3 =
        T::splat(2.0) * phidot_thetadot - part_of_two_phidot_thetadot_sum_sum_2;
    let part_of_two_phidot_thetadot_sum_sum_4 =
        minus_minus_phidot_C_Mq_sum * air_velocity_1_inv_product_3;
    let two_minus_cos_theta_product = T::splat(2.0) * minus_cos_theta_wind_x_sum;
    let part_of_two_phidot_thetadot_sum_sum_5 =
        minus_C_Ms_inv_cos_sum_2 * two_minus_cos_theta_product;
    let part_of_two_phidot_thetadot_sum_sum_6 =
        part_of_two_phidot_thetadot_sum_sum_4 - part_of_two_phidot_thetadot_sum_sum_5;
    let two_phidot_thetadot_sum_sum =
        part_of_two_phidot_thetadot_sum_sum_3 + part_of_two_phidot_thetadot_sum_sum_6;
    let inv_cos_theta_cos_product =
        inv_cos_theta * (cos_theta_C_Mq_product_sum - sin_theta * thetadot_inv_I_d_I_a);
    let minus_r_inv_I_d_I_a_sum = phidot * sin_theta_two - r_inv_I_d_I_a;
    let air_velocity_1_inv_product_4 = air_velocity_1_inv_product * minus_w_plus_cos_product_14;
    let part_of_air_velocity_1_inv_sum_2 =
        minus_w_plus_cos_product_13 * air_velocity_1_inv_product_4;
    let thetadot_C_Mq = C_Mq * thetadot;
    let sin_alpha_two_air_product_2 = sin_alpha_two * air_velocity_1_inv_product;
    let C_Ms_sin_alpha_two_product = C_Ms * sin_alpha_two_air_product_2;
    let part_of_air_velocity_1_inv_sum =
        (thetadot_C_Mq + C_Ms_sin_alpha_two_product) * rho_part_part_d_inv_product;
    let part_of_air_velocity_1_inv_sum_3 =
        air_velocity_1_inv_product * inv_sqrt_air_product_4 + part_of_air_velocity_1_inv_sum_2;
    let air_velocity_1_inv_sum = part_of_air_velocity_1_inv_sum_3 - part_of_air_velocity_1_inv_sum;
    let sin_alpha_two_minus_sum =
        sin_alpha_two_minus_product - air_velocity_1 * air_velocity_1_inv_sum;
    let inv_sqrt_air_product_6 = inv_sqrt_air_velocity_1_of * sin_alpha_two_minus_sum;
    let air_velocity_2_inv_product_5 = air_velocity_2_inv_product * air_velocity_1_inv_sum;
    let C_Ms_sin_alpha_two_sum = C_Ms_sin_alpha_two_product + nonzero_sqrt_air_of * thetadot_C_Mq;
    let part_of_d_thetadot_dot_d_w =
        -(sqrt_air_velocity_1_product_2 * air_velocity_1_inv_product_4);
    let part_of_d_thetadot_dot_d_w_2 =
        part_of_d_thetadot_dot_d_w - C_Ms_sin_alpha_two_sum * rho_part_part_d_inv_product_2;
    let part_of_C_Ms_sin_alpha_two_sum_2 = sqrt_air_velocity_1_sq_of * air_velocity_1_inv_product_4;
    let C_Ms_sin_alpha_two_sum_2 =
        C_Ms_sin_alpha_two_sum * minus_w_plus_cos_product_15 + part_of_C_Ms_sin_alpha_two_sum_2;
    let part_of_d_thetadot_dot_d_phi =
        sin_theta * cos_phi_wind_y_plus_sin_sum * sin_alpha_two_minus_sum;
    let part_of_d_thetadot_dot_d_phi_2 =
        air_velocity_1_inv_sum * air_velocity_2_cos_product - part_of_d_thetadot_dot_d_phi;
    let part_of_d_thetadot_dot_d_phi_3 =
        inv_sqrt_air_velocity_1_of * part_of_d_thetadot_dot_d_phi_2;
    let part_of_d_thetadot_dot_d_phi_4 =
        part_of_d_thetadot_dot_d_phi_3 - C_Ms_sin_alpha_two_sum_2 * cos_phi_wind_y_plus_product_2;
    let part_of_d_thetadot_dot_d_theta_2 = C_Ms_sin_alpha_two_sum_2 * two_minus_cos_theta_product;
    let cos_theta_phidot_product = minus_n1_plus_inv_p2_p1 * cos_theta_phidot;
    let part_of_d_thetadot_dot_d_theta =
        sin_theta * sin_theta_phidot_minus_sum + cos_theta * cos_theta_phidot_product;
    let part_of_d_thetadot_dot_d_theta_3 =
        cos_theta_cos_phi_sum * inv_sqrt_air_product_6 - part_of_d_thetadot_dot_d_theta_2;
    let part_of_d_thetadot_dot_d_theta_4 =
        part_of_d_thetadot_dot_d_theta_3 + phidot * part_of_d_thetadot_dot_d_theta;
    let part_of_d_thetadot_dot_d_phidot =
        sin_theta * cos_theta_phidot_product - cos_theta * sin_theta_phidot_minus_sum;
    let cos_theta_phidot_inv_I_d_I_a = inv_p2_p1 * cos_theta_phidot;
    let sin_theta_air_product = sin_theta * air_velocity_1_inv_product;
    let minus_minus_phidot_product = minus_minus_phidot_C_Mq_sum * sin_theta_air_product;
    let minus_C_Ms_inv_cos_product = minus_C_Ms_inv_cos_sum_2 * sin_theta_two;
    let part_of_d_gammadot_dot_d_theta_2 =
        sin_theta * (phidot_thetadot - two_phidot_thetadot_sum_sum);
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * (phidot_cos_theta_C_product - p14_inv_p1 * phidot);
    let part_of_d_gammadot_dot_d_theta_3 =
        part_of_d_gammadot_dot_d_theta_2 - part_of_d_gammadot_dot_d_theta;
    let part_of_d_gammadot_dot_d_phidot =
        sin_theta * (p14_inv_p1 - inv_cos_theta_cos_product) - cos_theta * thetadot;
    let part_of_d_gammadot_dot_d_thetadot =
        -cos_theta_phidot - minus_r_inv_I_d_I_a_sum * sin_theta_inv_cos_theta;
    let minus_minus_w_plus_product = minus_minus_w_plus_cos_sum * V_inv_m;
    let air_velocity_1_inv_product_5 = air_velocity_1_inv_product * minus_minus_w_plus_product;
    let inv_minus_w_plus_product_2 = inv_minus_w_plus_cos_sum * d_w_dot_d_C_D;
    let n1_minus_inv_minus_w_sum = T::splat(1.0) - inv_minus_w_plus_cos_sum;
    let n1_minus_inv_minus_product = n1_minus_inv_minus_w_sum * d_w_dot_d_C_D;
    let inv_s_stall_inv_product_2 = inv_s_stall_inv_product * minus_w_plus_cos_product_8;
    let minus_w_plus_cos_product_16 = minus_w_plus_cos_product_10 * inv_s_stall_inv_product_2;
    let minus_w_plus_cos_product_17 = minus_w_plus_cos_product_2 * minus_w_plus_cos_product_12;
    let part_of_d_u_dot_d_wind_x =
        cos_theta * inv_sqrt_air_product - minus_rho_A_half_V_inv_sum * sin_theta_air_product;
    let sin_theta_inv_sqrt_sum = sin_theta * inv_sqrt_air_product + minus_rho_A_half_V_product;
    let part_of_d_u_dot_d_wind_y =
        cos_phi * air_velocity_2_inv_product_2 + sin_phi * sin_theta_inv_sqrt_sum;
    let part_of_d_u_dot_d_wind_z =
        sin_phi * air_velocity_2_inv_product_2 - cos_phi * sin_theta_inv_sqrt_sum;
    let air_velocity_2_inv_product_6 = air_velocity_2_inv_product * minus_minus_w_plus_product;
    let part_of_d_v_dot_d_wind_x = -(minus_air_velocity_2_sum * cos_theta_air_product);
    let part_of_d_v_dot_d_wind_x_2 =
        part_of_d_v_dot_d_wind_x - sin_theta * air_velocity_2_inv_product_3;
    let minus_air_velocity_sum =
        minus_air_velocity_2_sum * sin_theta_air_product - cos_theta_air_product_2;
    let part_of_d_v_dot_d_wind_y =
        cos_phi * inv_sqrt_air_product_2 - sin_phi * minus_air_velocity_sum;
    let part_of_d_v_dot_d_wind_z =
        sin_phi * inv_sqrt_air_product_2 + cos_phi * minus_air_velocity_sum;
    let sqrt_air_velocity_1_product_4 = sqrt_air_velocity_1_sum * V_inv_m;
    let part_of_d_w_dot_d_C_Lp =
        sin_alpha_two * n1_minus_inv_minus_w_sum * sqrt_air_velocity_1_product_3;
    let part_of_d_w_dot_d_s_stall =
        sin_alpha_two * minus_w_plus_cos_product_12 * inv_s_stall_inv_product_2;
    let part_of_d_w_dot_d_wind_x =
        sin_theta * rho_A_half_V_inv_m_C_D_sum_2 - rho_A_half_V_inv_m_sum_2 * cos_theta_air_product;
    let part_of_d_w_dot_d_wind_y =
        (sin_phi * sin_theta_air_velocity_1 + cos_phi * air_velocity_2) * inv_sqrt_air_product_3;
    let part_of_d_w_dot_d_wind_y_2 =
        -(cos_theta_sin_phi * rho_A_half_V_inv_m_C_D_sum_2) - part_of_d_w_dot_d_wind_y;
    let part_of_d_w_dot_d_wind_z =
        (cos_phi * sin_theta_air_velocity_1 - sin_phi * air_velocity_2) * inv_sqrt_air_product_3;
    let part_of_d_w_dot_d_wind_z_2 =
        cos_theta_cos_phi * rho_A_half_V_inv_m_C_D_sum_2 + part_of_d_w_dot_d_wind_z;
    let inv_I_d_r = inv_p2 * r;
    let thetadot_inv_cos_theta = thetadot * inv_cos_theta;
    let minus_w_plus_cos_product_18 = minus_w_plus_cos_sum * minus_C_Ms_inv_cos_sum;
    let part_of_minus_minus_w_plus_product_2 =
        I_a * r * thetadot_inv_cos_theta - p5_p4_half_p3 * minus_w_plus_cos_product_18;
    let minus_minus_w_plus_product_2 = inv_p2_sq * part_of_minus_minus_w_plus_product_2;
    let minus_w_plus_cos_product_19 = minus_w_plus_cos_product_6 * sin_alpha_two_air_product;
    let minus_C_Ms_inv_cos_sum_4 =
        minus_C_Ms_inv_cos_product - minus_minus_phidot_C_Mq_sum * cos_theta_air_product;
    let minus_minus_phidot_sum =
        minus_minus_phidot_product + minus_C_Ms_inv_cos_sum_2 * cos_theta_two;
    let cos_phi_inv_sqrt_sum = cos_phi * inv_sqrt_air_product_5 - sin_phi * minus_minus_phidot_sum;
    let sin_phi_inv_sqrt_sum = sin_phi * inv_sqrt_air_product_5 + cos_phi * minus_minus_phidot_sum;
    let minus_w_plus_cos_product_20 = minus_w_plus_cos_sum * C_Ms_sin_alpha_two_sum;
    let part_of_d_thetadot_dot_d_I_d = minus_inv_p2_p5_part_sum * minus_w_plus_cos_product_20;
    let part_of_d_thetadot_dot_d_I_d_2 =
        part_of_d_thetadot_dot_d_I_d - inv_I_d_r * cos_theta_phidot_inv_I_d_I_a;
    let part_of_d_thetadot_dot_d_wind_x =
        C_Ms_sin_alpha_two_sum_2 * sin_theta_two - cos_theta * inv_sqrt_air_product_6;
    let sin_theta_inv_sqrt_sum_2 =
        sin_theta * inv_sqrt_air_product_6 + C_Ms_sin_alpha_two_sum_2 * cos_theta_two;
    let part_of_d_thetadot_dot_d_wind_y =
        cos_phi * air_velocity_2_inv_product_5 - sin_phi * sin_theta_inv_sqrt_sum_2;
    let part_of_d_thetadot_dot_d_wind_z =
        sin_phi * air_velocity_2_inv_product_5 + cos_phi * sin_theta_inv_sqrt_sum_2;
    let part_of_d_gammadot_dot_d_I_a =
        inv_p2 * thetadot * sin_theta_inv_cos_theta - inv_p1_d_gammadot_dot_d_r;
    let sin_theta_minus_w_product = sin_theta * minus_w_plus_cos_product_18;
    let minus_minus_C_Ms_inv_sum = -minus_C_Ms_inv_cos_sum_4;
    let minus_cos_phi_inv_sqrt_sum = -cos_phi_inv_sqrt_sum;
    let minus_sin_theta_sin_phi_sum = -(sin_theta * sin_phi_inv_sqrt_sum);
    let minus_cos_theta_sin_phi = -cos_theta_sin_phi;
    let minus_z_dot = -z_dot;
    let minus_sin_theta_cos_phi = -sin_theta_cos_phi;
    let minus_x_dot_cos_phi = -(x_dot * cos_phi);
    let minus_inv_sqrt_air_product = -inv_sqrt_air_product;
    let minus_w = -w;
    let minus_inv_sqrt_air_product_2 = -inv_sqrt_air_product_2;
    let minus_rho_A_half_V_inv_m_C_D_sum_2 = -rho_A_half_V_inv_m_C_D_sum_2;
    let minus_cos_theta_v = -(cos_theta * v);
    let minus_inv_sqrt_air_product_5 = -inv_sqrt_air_product_5;
    let minus_minus_C_Ms_inv_cos_sum_3 = -minus_C_Ms_inv_cos_sum_3;
    let minus_inv_cos_theta_product = -(inv_cos_theta * thetadot_inv_I_d_I_a);
    let minus_air_velocity_2_inv_product_5 = -air_velocity_2_inv_product_5;
    let minus_minus_minus_phidot_product = -minus_minus_phidot_product;
    let minus_air_velocity_1_inv_product =
        -(air_velocity_1_inv_product * sqrt_air_velocity_1_product_3);
    let minus_air_velocity_1_inv_product_2 =
        -(air_velocity_1_inv_product * minus_w_plus_cos_product_17);
    let minus_sin_phi = -sin_phi;
    let minus_air_velocity_2_inv_product =
        -(air_velocity_2_inv_product * sqrt_air_velocity_1_product_3);
    let minus_air_velocity_2_inv_product_2 =
        -(air_velocity_2_inv_product * minus_w_plus_cos_product_17);
    let minus_cos_theta_cos_phi = -cos_theta_cos_phi;
    let minus_inv_I_d_r_thetadot_product = -(inv_I_d_r * thetadot_inv_cos_theta);
    let minus_inv_cos_theta_minus_product = -(inv_cos_theta * minus_w_plus_cos_product_19);
    let minus_sin_theta_minus_product = -(sin_theta * minus_minus_w_plus_product_2);
    let minus_sin_theta_phidot_product = -(sin_theta_phidot * nonzero_sqrt_air_of_product);

    dx[0] = x_dot;
    dx[1] = y_dot;
    dx[2] = z_dot;
    dx[3] = u_dot;
    dx[4] = v_dot;
    dx[5] = w_dot;
    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    dx[9] = phidot_cos_theta_C_product;
    dx[10] = thetadot_dot;
    dx[11] = gammadot_dot;

    j[0] = cos_theta; // d_x_dot_d_u
    j[1] = sin_theta; // d_x_dot_d_w
    j[2] = cos_theta_w_minus_u_sin_sum; // d_x_dot_d_theta
    j[3] = sin_theta * sin_phi; // d_y_dot_d_u
    j[4] = cos_phi; // d_y_dot_d_v
    j[5] = minus_cos_theta_sin_phi; // d_y_dot_d_w
    j[6] = minus_z_dot; // d_y_dot_d_phi
    j[7] = x_dot * sin_phi; // d_y_dot_d_theta
    j[8] = minus_sin_theta_cos_phi; // d_z_dot_d_u
    j[9] = sin_phi; // d_z_dot_d_v
    j[10] = cos_theta_cos_phi; // d_z_dot_d_w
    j[11] = y_dot; // d_z_dot_d_phi
    j[12] = minus_x_dot_cos_phi; // d_z_dot_d_theta
    j[13] = minus_inv_sqrt_air_product; // d_u_dot_d_u
    j[14] = sin_theta_phidot - air_velocity_2_inv_product_2; // d_u_dot_d_v
    j[15] = air_velocity_1_inv_product_2 - thetadot; // d_u_dot_d_w
    j[16] = part_of_d_u_dot_d_phi_3 - part_of_d_u_dot_d_phi; // d_u_dot_d_phi
    j[17] = part_of_d_u_dot_d_theta_2; // d_u_dot_d_theta
    j[18] = sin_theta * v; // d_u_dot_d_phidot
    j[19] = minus_w; // d_u_dot_d_thetadot
    j[20] = part_of_d_v_dot_d_u; // d_v_dot_d_u
    j[21] = minus_inv_sqrt_air_product_2; // d_v_dot_d_v
    j[22] = cos_theta_phidot + air_velocity_2_inv_product_3; // d_v_dot_d_w
    j[23] = part_of_d_v_dot_d_phi_4; // d_v_dot_d_phi
    j[24] = part_of_d_v_dot_d_theta_2 - x_dot * phidot; // d_v_dot_d_theta
    j[25] = cos_theta_w_minus_u_sin_sum; // d_v_dot_d_phidot
    j[26] = thetadot + air_velocity_1_inv_product * rho_A_half_V_inv_m_sum_2; // d_w_dot_d_u
    j[27] = part_of_d_w_dot_d_v; // d_w_dot_d_v
    j[28] = minus_rho_A_half_V_inv_m_C_D_sum_2; // d_w_dot_d_w
    j[29] = cos_theta * part_of_d_w_dot_d_phi_2 - part_of_d_w_dot_d_phi; // d_w_dot_d_phi
    j[30] = part_of_d_w_dot_d_theta_2; // d_w_dot_d_theta
    j[31] = minus_cos_theta_v; // d_w_dot_d_phidot
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
    j[36] = air_velocity_1_inv_product * minus_minus_phidot_C_Mq_sum; // d_phidot_dot_d_u
    j[37] = minus_inv_sqrt_air_product_5; // d_phidot_dot_d_v
    j[38] = part_of_d_phidot_dot_d_w_2; // d_phidot_dot_d_w
    j[39] = minus_minus_C_Ms_inv_cos_sum_3; // d_phidot_dot_d_phi
    j[40] = two_phidot_thetadot_sum_sum; // d_phidot_dot_d_theta
    j[41] = inv_cos_theta_cos_product; // d_phidot_dot_d_phidot
    j[42] = inv_cos_theta * minus_r_inv_I_d_I_a_sum; // d_phidot_dot_d_thetadot
    j[43] = minus_inv_cos_theta_product; // d_phidot_dot_d_gammadot
    j[44] = inv_sqrt_air_product_6; // d_thetadot_dot_d_u
    j[45] = minus_air_velocity_2_inv_product_5; // d_thetadot_dot_d_v
    j[46] = part_of_d_thetadot_dot_d_w_2; // d_thetadot_dot_d_w
    j[47] = part_of_d_thetadot_dot_d_phi_4; // d_thetadot_dot_d_phi
    j[48] = part_of_d_thetadot_dot_d_theta_4; // d_thetadot_dot_d_theta
    j[49] = part_of_d_thetadot_dot_d_phidot; // d_thetadot_dot_d_phidot
    j[50] = C_Mq_nonzero_sqrt_product; // d_thetadot_dot_d_thetadot
    j[51] = cos_theta_phidot_inv_I_d_I_a; // d_thetadot_dot_d_gammadot
    j[52] = minus_minus_minus_phidot_product; // d_gammadot_dot_d_u
    j[53] = sin_theta * inv_sqrt_air_product_5; // d_gammadot_dot_d_v
    j[54] = minus_C_Ms_inv_cos_product; // d_gammadot_dot_d_w
    j[55] = sin_theta * minus_C_Ms_inv_cos_sum_3; // d_gammadot_dot_d_phi
    j[56] = part_of_d_gammadot_dot_d_theta_3; // d_gammadot_dot_d_theta
    j[57] = part_of_d_gammadot_dot_d_phidot; // d_gammadot_dot_d_phidot
    j[58] = part_of_d_gammadot_dot_d_thetadot; // d_gammadot_dot_d_thetadot
    // d_gammadot_dot_d_gammadot
    j[59] = sin_theta_inv_cos_theta * thetadot_inv_I_d_I_a + p14_inv_p1;

    jp[0] = inv_p0_half_p5_p4 * air_velocity_1_inv_product_5; // d_u_dot_d_m
    jp[1] = minus_p5_half * air_velocity_1_inv_product_5; // d_u_dot_d_A
    jp[2] = minus_p4_half * air_velocity_1_inv_product_5; // d_u_dot_d_rho
    jp[3] = sin_theta_cos_phi; // d_u_dot_d_g
    jp[4] = sin_alpha_two_air_product_2 * inv_minus_w_plus_product_2; // d_u_dot_d_C_Ls
    jp[5] = sin_alpha_two_air_product_2 * n1_minus_inv_minus_product; // d_u_dot_d_C_Lp
    jp[6] = sin_alpha_two_air_product_2 * minus_w_plus_cos_product_16; // d_u_dot_d_s_stall
    jp[7] = minus_air_velocity_1_inv_product; // d_u_dot_d_C_D0
    jp[8] = minus_air_velocity_1_inv_product_2; // d_u_dot_d_C_Ds
    jp[9] = part_of_d_u_dot_d_wind_x; // d_u_dot_d_wind_x
    jp[10] = part_of_d_u_dot_d_wind_y; // d_u_dot_d_wind_y
    jp[11] = part_of_d_u_dot_d_wind_z; // d_u_dot_d_wind_z
    jp[12] = inv_p0_half_p5_p4 * air_velocity_2_inv_product_6; // d_v_dot_d_m
    jp[13] = minus_p5_half * air_velocity_2_inv_product_6; // d_v_dot_d_A
    jp[14] = minus_p4_half * air_velocity_2_inv_product_6; // d_v_dot_d_rho
    jp[15] = minus_sin_phi; // d_v_dot_d_g
    jp[16] = sin_alpha_two_air_product * inv_minus_w_plus_product_2; // d_v_dot_d_C_Ls
    jp[17] = sin_alpha_two_air_product * n1_minus_inv_minus_product; // d_v_dot_d_C_Lp
    jp[18] = sin_alpha_two_air_product * minus_w_plus_cos_product_16; // d_v_dot_d_s_stall
    jp[19] = minus_air_velocity_2_inv_product; // d_v_dot_d_C_D0
    jp[20] = minus_air_velocity_2_inv_product_2; // d_v_dot_d_C_Ds
    jp[21] = part_of_d_v_dot_d_wind_x_2; // d_v_dot_d_wind_x
    jp[22] = part_of_d_v_dot_d_wind_y; // d_v_dot_d_wind_y
    jp[23] = part_of_d_v_dot_d_wind_z; // d_v_dot_d_wind_z
    jp[24] = minus_p5_p4_half_inv_p0 * sqrt_air_velocity_1_product_4; // d_w_dot_d_m
    jp[25] = p5_half * sqrt_air_velocity_1_product_4; // d_w_dot_d_A
    jp[26] = p4_half * sqrt_air_velocity_1_product_4; // d_w_dot_d_rho
    jp[27] = minus_cos_theta_cos_phi; // d_w_dot_d_g
    jp[28] = sqrt_air_velocity_1_product_3 * inv_minus_w_plus_product; // d_w_dot_d_C_Ls
    jp[29] = part_of_d_w_dot_d_C_Lp; // d_w_dot_d_C_Lp
    jp[30] = part_of_d_w_dot_d_s_stall; // d_w_dot_d_s_stall
    jp[31] = d_w_dot_d_C_D; // d_w_dot_d_C_D0
    jp[32] = minus_w_plus_cos_product_2 * minus_w_plus_cos_product_10; // d_w_dot_d_C_Ds
    jp[33] = part_of_d_w_dot_d_wind_x; // d_w_dot_d_wind_x
    jp[34] = part_of_d_w_dot_d_wind_y_2; // d_w_dot_d_wind_y
    jp[35] = part_of_d_w_dot_d_wind_z_2; // d_w_dot_d_wind_z
    jp[36] = minus_inv_I_d_r_thetadot_product; // d_phidot_dot_d_I_a
    jp[37] = minus_minus_w_plus_product_2; // d_phidot_dot_d_I_d
    jp[38] = p5_p4_half_inv_p2 * minus_w_plus_cos_product_18; // d_phidot_dot_d_d
    jp[39] = p3_inv_p2_p5_half * minus_w_plus_cos_product_18; // d_phidot_dot_d_A
    jp[40] = p3_inv_p2_p4_half * minus_w_plus_cos_product_18; // d_phidot_dot_d_rho
    jp[41] = minus_inv_cos_theta_minus_product; // d_phidot_dot_d_C_Ms
    jp[42] = phidot * nonzero_sqrt_air_of_product; // d_phidot_dot_d_C_Mq
    jp[43] = minus_C_Ms_inv_cos_sum_4; // d_phidot_dot_d_wind_x
    jp[44] = cos_phi_inv_sqrt_sum; // d_phidot_dot_d_wind_y
    jp[45] = sin_phi_inv_sqrt_sum; // d_phidot_dot_d_wind_z
    jp[46] = cos_theta_phidot * inv_I_d_r; // d_thetadot_dot_d_I_a
    jp[47] = part_of_d_thetadot_dot_d_I_d_2; // d_thetadot_dot_d_I_d
    jp[48] = p5_p4_half_inv_p2 * minus_w_plus_cos_product_20; // d_thetadot_dot_d_d
    jp[49] = p3_inv_p2_p5_half * minus_w_plus_cos_product_20; // d_thetadot_dot_d_A
    jp[50] = p3_inv_p2_p4_half * minus_w_plus_cos_product_20; // d_thetadot_dot_d_rho
    jp[51] = minus_w_plus_cos_product_6 * sin_alpha_two_air_product_2; // d_thetadot_dot_d_C_Ms
    jp[52] = thetadot * nonzero_sqrt_air_of_product; // d_thetadot_dot_d_C_Mq
    jp[53] = part_of_d_thetadot_dot_d_wind_x; // d_thetadot_dot_d_wind_x
    jp[54] = part_of_d_thetadot_dot_d_wind_y; // d_thetadot_dot_d_wind_y
    jp[55] = part_of_d_thetadot_dot_d_wind_z; // d_thetadot_dot_d_wind_z
    jp[56] = r * part_of_d_gammadot_dot_d_I_a; // d_gammadot_dot_d_I_a
    jp[57] = minus_sin_theta_minus_product; // d_gammadot_dot_d_I_d
    jp[58] = minus_p5_p4_half_inv_p2 * sin_theta_minus_w_product; // d_gammadot_dot_d_d
    jp[59] = minus_p3_inv_p2_p5_half * sin_theta_minus_w_product; // d_gammadot_dot_d_A
    jp[60] = minus_p3_inv_p2_p4_half * sin_theta_minus_w_product; // d_gammadot_dot_d_rho
    jp[61] = sin_theta_inv_cos_theta * minus_w_plus_cos_product_19; // d_gammadot_dot_d_C_Ms
    jp[62] = minus_sin_theta_phidot_product; // d_gammadot_dot_d_C_Mq
    jp[63] = inv_p1 * r; // d_gammadot_dot_d_C_Nr
    jp[64] = sin_theta * minus_minus_C_Ms_inv_sum; // d_gammadot_dot_d_wind_x
    jp[65] = sin_theta * minus_cos_phi_inv_sqrt_sum; // d_gammadot_dot_d_wind_y
    jp[66] = minus_sin_theta_sin_phi_sum; // d_gammadot_dot_d_wind_z
}
