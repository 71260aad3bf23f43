// Written by `hyzer generate`; changes belong in the model.
//! `discus`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 368 operations: 108 add, 233 mul, 4 div, 13 neg, 2 sqrt, 7 call, 1 select.
#[inline(always)]
pub fn f_jac<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 33],
    dx: &mut [T; 12],
    j: &mut [T; 60],
) {
    let u = state[3];
    let v = state[4];
    let w = state[5];
    let phi = state[6];
    let theta = state[7];
    let phidot = state[9];
    let thetadot = state[10];
    let gammadot = state[11];
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
    let n8_inv_p9_p7_minus_p8 = prepared[8];
    let two_inv_p2_part_part_half_p3 = prepared[9];
    let minus_two_inv_p2_part_sum = prepared[10];
    let minus_n1_plus_inv_p2_p1 = prepared[11];
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
    let minus_cos_theta_wind_x_sum = sin_theta * cos_phi_wind_z_minus_sum - wind_x * cos_theta;

    // discus.hyz:70  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u + minus_cos_theta_wind_x_sum;
    let cos_phi_wind_y_plus_sin_sum = wind_y * cos_phi + wind_z * sin_phi;
    let air_velocity_2 = v - cos_phi_wind_y_plus_sin_sum;
    let air_velocity_1_sq_plus_sum =
        air_velocity_1 * air_velocity_1 + air_velocity_2 * air_velocity_2;
    let minus_w_plus_cos_sum =
        minus_w_plus_cos_theta_sum * minus_w_plus_cos_theta_sum + air_velocity_1_sq_plus_sum;

    // discus.hyz:72  let V = norm(air_velocity);
    let V = minus_w_plus_cos_sum.sqrt();
    let V_part_part_half_inv_m = inv_p0_half_p5_p4 * V;
    let inv_V = V.recip_or_zero();
    let minus_w_plus_cos_product = minus_w_plus_cos_theta_sum * inv_V;
    let minus_w_plus_cos_product_2 = inv_p9 * minus_w_plus_cos_product;
    let minus_w_plus_cos_product_3 = minus_w_plus_cos_product_2 * minus_w_plus_cos_product_2;
    let minus_w_plus_cos_product_4 = minus_w_plus_cos_product_3 * minus_w_plus_cos_product_3;
    let part_of_inv_minus_w_plus_cos_sum =
        minus_w_plus_cos_product_4 * minus_w_plus_cos_product_4 + T::splat(1.0);
    let inv_minus_w_plus_cos_sum = T::splat(1.0) / part_of_inv_minus_w_plus_cos_sum;
    let C_Lp_plus_C_Ls_minus_C_sum = C_Lp + minus_p8_plus_p7 * inv_minus_w_plus_cos_sum;
    let sqrt_air_velocity_1_sq_of = air_velocity_1_sq_plus_sum.sqrt();

    // discus.hyz:77  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_w_plus_cos_theta_sum.atan2(sqrt_air_velocity_1_sq_of);
    let alpha_two = T::splat(2.0) * alpha;
    let (sin_alpha_two, cos_alpha_two) = alpha_two.sin_cos();
    let C_Lp_plus_C_Ls_product = C_Lp_plus_C_Ls_minus_C_sum * sin_alpha_two;

    // discus.hyz:83  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = C_D0 + C_Ds * minus_w_plus_cos_product * minus_w_plus_cos_product;
    let minus_minus_w_plus_cos_sum =
        sqrt_air_velocity_1_sq_of * C_D - minus_w_plus_cos_theta_sum * C_Lp_plus_C_Ls_product;
    let V_part_part_half_product = V_part_part_half_inv_m * minus_minus_w_plus_cos_sum;
    let inv_sqrt_air_velocity_1_of = sqrt_air_velocity_1_sq_of.recip_or_zero();
    let air_velocity_1_inv_product = air_velocity_1 * inv_sqrt_air_velocity_1_of;
    let part_of_u_dot =
        sin_theta_v_phidot_product - V_part_part_half_product * air_velocity_1_inv_product;

    // discus.hyz:64  velocity (u, v, w) in B;
    let u_dot = part_of_u_dot - w * thetadot;
    let air_velocity_2_inv_product = air_velocity_2 * inv_sqrt_air_velocity_1_of;
    let part_of_v_dot = V_part_part_half_product * air_velocity_2_inv_product;
    let sin_phi_g = g * sin_phi;
    let v_dot = cos_theta_w_minus_u_sin_sum * phidot - part_of_v_dot - sin_phi_g;
    let cos_theta_v_phidot_product = cos_theta * v_phidot_plus_cos_phi_g;
    let sqrt_air_velocity_1_sum =
        sqrt_air_velocity_1_sq_of * C_Lp_plus_C_Ls_product + minus_w_plus_cos_theta_sum * C_D;
    let part_of_w_dot =
        V_part_part_half_inv_m * sqrt_air_velocity_1_sum - cos_theta_v_phidot_product;
    let w_dot = part_of_w_dot + u * thetadot;
    let minus_w_plus_cos_product_5 = half_p5_p4_p3_inv_p2 * minus_w_plus_cos_sum;
    let nonzero_sqrt_air_of = sqrt_air_velocity_1_sq_of.if_zero(T::splat(0.0), T::splat(1.0));
    let C_Mq_nonzero_sqrt_air_of = C_Mq * nonzero_sqrt_air_of;
    let minus_w_plus_cos_product_6 = minus_w_plus_cos_product_5 * C_Mq_nonzero_sqrt_air_of;
    let sin_theta_two = T::splat(2.0) * sin_theta;
    let cos_theta_minus_w_sum = cos_theta * minus_w_plus_cos_product_6 + thetadot * sin_theta_two;
    let minus_w_plus_cos_product_7 = C_Ms * minus_w_plus_cos_product_5;
    let sin_alpha_two_minus_product = sin_alpha_two * minus_w_plus_cos_product_7;
    let sin_theta_phidot = sin_theta * phidot;

    // discus.hyz:88  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let r_inv_I_d_I_a = inv_p2_p1 * r;
    let part_of_phidot_cos_theta_product =
        phidot * cos_theta_minus_w_sum - air_velocity_2_inv_product * sin_alpha_two_minus_product;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let phidot_cos_theta_product =
        (part_of_phidot_cos_theta_product - thetadot * r_inv_I_d_I_a) * inv_cos_theta;
    let cos_theta_phidot = cos_theta * phidot;
    let sin_theta_phidot_minus_sum = sin_theta_phidot - r_inv_I_d_I_a;
    let part_of_thetadot_dot =
        thetadot * minus_w_plus_cos_product_6 - cos_theta_phidot * sin_theta_phidot_minus_sum;

    // discus.hyz:56  frame B = A turned theta about 2; // does not spin with the discus
    let thetadot_dot =
        part_of_thetadot_dot + air_velocity_1_inv_product * sin_alpha_two_minus_product;

    // discus.hyz:57  frame C = B turned gamma about 3; // fixed in the discus
    let gammadot_dot =
        p14_inv_p1 * r - thetadot * cos_theta_phidot - sin_theta * phidot_cos_theta_product;
    let V_part_part_half_product_2 = V_part_part_half_product * inv_sqrt_air_velocity_1_of;
    let minus_w_plus_cos_product_8 = two_p11 * minus_w_plus_cos_product;
    let part_of_n8_part_part_minus_product =
        n8_inv_p9_p7_minus_p8 * (minus_w_plus_cos_product_2 * minus_w_plus_cos_product_3);
    let part_of_n8_part_part_minus_product_2 =
        minus_w_plus_cos_product_4 * inv_minus_w_plus_cos_sum;
    let part_of_n8_part_part_minus_product_3 =
        part_of_n8_part_part_minus_product_2 * (inv_minus_w_plus_cos_sum * sin_alpha_two);
    let n8_part_part_minus_product =
        part_of_n8_part_part_minus_product * part_of_n8_part_part_minus_product_3;
    let part_of_sqrt_air_velocity_1_sum_2 = minus_w_plus_cos_theta_sum * n8_part_part_minus_product;
    let sqrt_air_velocity_1_sum_2 =
        sqrt_air_velocity_1_sq_of * minus_w_plus_cos_product_8 + part_of_sqrt_air_velocity_1_sum_2;
    let V_part_part_half_inv_m_inv_V = V_part_part_half_inv_m * inv_V;
    let minus_w_plus_cos_product_9 = minus_w_plus_cos_product * V_part_part_half_inv_m_inv_V;
    let part_of_minus_sqrt_air_velocity_sum =
        sqrt_air_velocity_1_sum_2 * minus_w_plus_cos_product_9;
    let minus_sqrt_air_velocity_sum =
        inv_p0_half_p5_p4 * minus_minus_w_plus_cos_sum - part_of_minus_sqrt_air_velocity_sum;
    let sqrt_air_velocity_1_product = sqrt_air_velocity_1_sq_of * inv_V;
    let two_cos_alpha_two = T::splat(2.0) * cos_alpha_two;
    let minus_w_plus_cos_product_10 = minus_w_plus_cos_product * two_cos_alpha_two;
    let C_Lp_plus_C_Ls_product_2 = C_Lp_plus_C_Ls_minus_C_sum * minus_w_plus_cos_product_10;
    let part_of_V_part_part_half_sum =
        V_part_part_half_inv_m * (C_D + minus_w_plus_cos_product * C_Lp_plus_C_Ls_product_2);
    let part_of_V_part_part_half_sum_2 =
        minus_sqrt_air_velocity_sum * sqrt_air_velocity_1_product + part_of_V_part_part_half_sum;
    let V_part_part_half_sum = V_part_part_half_product_2 - part_of_V_part_part_half_sum_2;
    let air_velocity_1_inv_product_2 = air_velocity_1_inv_product * V_part_part_half_sum;
    let part_of_d_u_dot_d_u =
        air_velocity_1_inv_product * air_velocity_1_inv_product_2 - V_part_part_half_product_2;
    let part_of_d_u_dot_d_v =
        sin_theta_phidot + air_velocity_2_inv_product * air_velocity_1_inv_product_2;
    let part_of_minus_w_plus_cos_sum_2 =
        sqrt_air_velocity_1_sum_2 - sqrt_air_velocity_1_sq_of * C_Lp_plus_C_Ls_product_2;
    let part_of_minus_w_plus_cos_sum_2_2 =
        V_part_part_half_inv_m * (C_Lp_plus_C_Ls_product - inv_V * part_of_minus_w_plus_cos_sum_2);
    let minus_w_plus_cos_sum_2 =
        minus_w_plus_cos_product * minus_sqrt_air_velocity_sum - part_of_minus_w_plus_cos_sum_2_2;
    let air_velocity_1_inv_product_3 = air_velocity_1_inv_product * minus_w_plus_cos_sum_2;
    let sin_theta_cos_phi_product = sin_theta * cos_phi_wind_y_plus_sin_sum;
    let minus_cos_phi_wind_z_sum = -cos_phi_wind_z_minus_sum;
    let minus_air_velocity_1_sum =
        air_velocity_2 * minus_cos_phi_wind_z_sum - air_velocity_1 * sin_theta_cos_phi_product;
    let inv_sqrt_air_product = inv_sqrt_air_velocity_1_of * minus_air_velocity_1_sum;
    let cos_theta_cos_phi_product = cos_theta * cos_phi_wind_y_plus_sin_sum;
    let part_of_d_u_dot_d_phi_2 = air_velocity_1_inv_product_3 * cos_theta_cos_phi_product;
    let part_of_d_u_dot_d_phi =
        sin_phi_g - V_part_part_half_product_2 * cos_phi_wind_y_plus_sin_sum;
    let part_of_d_u_dot_d_phi_3 =
        air_velocity_1_inv_product_2 * inv_sqrt_air_product + part_of_d_u_dot_d_phi_2;
    let part_of_d_u_dot_d_theta =
        V_part_part_half_product - air_velocity_1 * air_velocity_1_inv_product_2;
    let inv_sqrt_air_product_2 = inv_sqrt_air_velocity_1_of * cos_theta_cos_phi_sum;
    let part_of_d_u_dot_d_theta_2 =
        cos_theta_v_phidot_product + air_velocity_1_inv_product_3 * minus_cos_theta_wind_x_sum;
    let part_of_d_u_dot_d_theta_3 =
        part_of_d_u_dot_d_theta_2 - part_of_d_u_dot_d_theta * inv_sqrt_air_product_2;
    let air_velocity_2_inv_product_2 = air_velocity_2_inv_product * V_part_part_half_sum;
    let part_of_d_v_dot_d_u =
        air_velocity_1_inv_product * air_velocity_2_inv_product_2 - sin_theta_phidot;
    let part_of_d_v_dot_d_v =
        air_velocity_2_inv_product * air_velocity_2_inv_product_2 - V_part_part_half_product_2;
    let air_velocity_2_inv_product_3 = air_velocity_2_inv_product * minus_w_plus_cos_sum_2;
    let part_of_d_v_dot_d_phi = minus_air_velocity_1_sum * air_velocity_2_inv_product_2;
    let part_of_d_v_dot_d_phi_2 =
        part_of_d_v_dot_d_phi - V_part_part_half_product * minus_cos_phi_wind_z_sum;
    let part_of_d_v_dot_d_phi_3 =
        air_velocity_2_inv_product_3 * cos_theta_cos_phi_product - cos_phi_g;
    let part_of_d_v_dot_d_phi_4 =
        part_of_d_v_dot_d_phi_3 + inv_sqrt_air_velocity_1_of * part_of_d_v_dot_d_phi_2;
    let air_velocity_1_inv_product_4 = air_velocity_1_inv_product * cos_theta_cos_phi_sum;
    let part_of_d_v_dot_d_theta = air_velocity_2_inv_product_2 * air_velocity_1_inv_product_4;
    let part_of_d_v_dot_d_theta_2 =
        part_of_d_v_dot_d_theta + minus_cos_theta_wind_x_sum * air_velocity_2_inv_product_3;
    let part_of_minus_w_plus_cos_sum_3 = minus_w_plus_cos_theta_sum * minus_w_plus_cos_product_8;
    let minus_w_plus_cos_sum_3 =
        part_of_minus_w_plus_cos_sum_3 - sqrt_air_velocity_1_sq_of * n8_part_part_minus_product;
    let part_of_minus_minus_w_plus_cos_sum_2 = minus_w_plus_cos_sum_3 * minus_w_plus_cos_product_9;
    let minus_minus_w_plus_cos_sum_2 =
        inv_p0_half_p5_p4 * sqrt_air_velocity_1_sum - part_of_minus_minus_w_plus_cos_sum_2;
    let part_of_V_part_part_half_sum_2_2 =
        minus_minus_w_plus_cos_sum_2 - V_part_part_half_inv_m * C_Lp_plus_C_Ls_product_2;
    let part_of_V_part_part_half_sum_2_3 =
        part_of_V_part_part_half_sum_2_2 * sqrt_air_velocity_1_product;
    let V_part_part_half_sum_2 =
        V_part_part_half_inv_m * C_Lp_plus_C_Ls_product + part_of_V_part_part_half_sum_2_3;
    let part_of_d_w_dot_d_v =
        air_velocity_2_inv_product * V_part_part_half_sum_2 - cos_theta_phidot;
    let part_of_minus_w_plus_cos_sum_sum = minus_w_plus_cos_product * minus_minus_w_plus_cos_sum_2;
    let part_of_minus_w_plus_cos_sum_sum_2 =
        part_of_minus_w_plus_cos_sum_sum + minus_w_plus_cos_sum_3 * V_part_part_half_inv_m_inv_V;
    let part_of_minus_w_plus_cos_sum_sum_3 =
        air_velocity_1_sq_plus_sum * inv_V * C_Lp_plus_C_Ls_minus_C_sum * two_cos_alpha_two;
    let part_of_minus_w_plus_cos_sum_sum_4 =
        part_of_minus_w_plus_cos_sum_sum_3 * V_part_part_half_inv_m_inv_V;
    let part_of_minus_w_plus_cos_sum_sum_5 =
        V_part_part_half_inv_m * C_D + part_of_minus_w_plus_cos_sum_sum_4;
    let minus_w_plus_cos_sum_sum =
        part_of_minus_w_plus_cos_sum_sum_2 + part_of_minus_w_plus_cos_sum_sum_5;
    let part_of_d_w_dot_d_phi = sin_phi_g - cos_phi_wind_y_plus_sin_sum * minus_w_plus_cos_sum_sum;
    let part_of_d_w_dot_d_phi_2 =
        V_part_part_half_sum_2 * inv_sqrt_air_product + cos_theta * part_of_d_w_dot_d_phi;
    let part_of_d_w_dot_d_theta =
        sin_theta_v_phidot_product + V_part_part_half_sum_2 * air_velocity_1_inv_product_4;
    let part_of_d_w_dot_d_theta_2 =
        part_of_d_w_dot_d_theta - minus_cos_theta_wind_x_sum * minus_w_plus_cos_sum_sum;
    let air_velocity_2_inv_product_4 = air_velocity_2_inv_product * inv_cos_theta;
    let sin_alpha_two_C_Ms = C_Ms * sin_alpha_two;
    let air_velocity_2_inv_product_5 = air_velocity_2_inv_product_4 * sin_alpha_two_C_Ms;
    let sqrt_air_velocity_1_product_2 = two_inv_p2_part_part_half_p3 * sqrt_air_velocity_1_sq_of;
    let part_of_minus_minus_part_part_sum =
        (air_velocity_2_inv_product_5 - C_Mq * phidot) * sqrt_air_velocity_1_product_2;
    let inv_V_minus_w_plus_product = inv_V * minus_w_plus_cos_product_7;
    let part_of_inv_sqrt_air_product_sum = inv_V_minus_w_plus_product * minus_w_plus_cos_product_10;
    let inv_sqrt_air_product_sum =
        inv_sqrt_air_velocity_1_of * sin_alpha_two_minus_product + part_of_inv_sqrt_air_product_sum;
    let part_of_minus_minus_part_part_sum_2 =
        inv_cos_theta * (air_velocity_2_inv_product * inv_sqrt_air_product_sum);
    let minus_minus_part_part_sum =
        part_of_minus_minus_part_part_sum_2 - part_of_minus_minus_part_part_sum;
    let air_velocity_1_inv_product_5 = air_velocity_1_inv_product * minus_minus_part_part_sum;
    let sin_alpha_two_minus_product_2 = sin_alpha_two_minus_product * inv_cos_theta;
    let part_of_inv_sqrt_air_product_3 =
        air_velocity_2 * minus_minus_part_part_sum - sin_alpha_two_minus_product_2;
    let inv_sqrt_air_product_3 = inv_sqrt_air_velocity_1_of * part_of_inv_sqrt_air_product_3;
    let sqrt_air_velocity_1_product_3 = sqrt_air_velocity_1_product * inv_V_minus_w_plus_product;
    let sqrt_air_velocity_1_product_4 =
        sqrt_air_velocity_1_product_3 * air_velocity_2_inv_product_4;
    let part_of_minus_w_plus_cos_product_11 =
        phidot * C_Mq_nonzero_sqrt_air_of - air_velocity_2_inv_product_5;
    let minus_w_plus_cos_product_11 =
        minus_w_plus_cos_theta_sum * part_of_minus_w_plus_cos_product_11;
    let part_of_d_phidot_dot_d_w = two_inv_p2_part_part_half_p3 * minus_w_plus_cos_product_11;
    let part_of_d_phidot_dot_d_w_2 =
        two_cos_alpha_two * sqrt_air_velocity_1_product_4 - part_of_d_phidot_dot_d_w;
    let part_of_inv_part_part_part_sum = half_p5_p4_p3_inv_p2 * minus_w_plus_cos_product_11;
    let inv_part_part_part_sum =
        part_of_inv_part_part_part_sum - cos_alpha_two * sqrt_air_velocity_1_product_4;
    let two_cos_theta_cos_product = T::splat(2.0) * cos_theta_cos_phi_product;
    let part_of_minus_inv_part_part_sum = minus_cos_phi_wind_z_sum * sin_alpha_two_minus_product_2;
    let part_of_minus_inv_part_part_sum_2 =
        minus_air_velocity_1_sum * minus_minus_part_part_sum - part_of_minus_inv_part_part_sum;
    let part_of_minus_inv_part_part_sum_3 =
        inv_sqrt_air_velocity_1_of * part_of_minus_inv_part_part_sum_2;
    let minus_inv_part_part_sum =
        part_of_minus_inv_part_part_sum_3 - inv_part_part_part_sum * two_cos_theta_cos_product;
    let phidot_thetadot = phidot * thetadot;
    let thetadot_inv_I_d_I_a = inv_p2_p1 * thetadot;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let part_of_two_phidot_thetadot_sum_sum =
        (phidot_cos_theta_product - phidot * minus_w_plus_cos_product_6) * sin_theta_inv_cos_theta;
    let part_of_two_phidot_thetadot_sum_sum_2 =
        phidot * thetadot_inv_I_d_I_a - part_of_two_phidot_thetadot_sum_sum;
    let part_of_two_phidot_thetadot_sum_sum_3 =
        T::splat(2.0) * phidot_thetadot - part_of_two_phidot_thetadot_sum_sum_2;
    let part_of_two_phidot_thetadot_sum_sum_4 =
        minus_minus_part_part_sum * air_velocity_1_inv_product_4;
    let two_minus_cos_theta_product = T::splat(2.0) * minus_cos_theta_wind_x_sum;
    let part_of_two_phidot_thetadot_sum_sum_5 =
        inv_part_part_part_sum * two_minus_cos_theta_product;
    let part_of_two_phidot_thetadot_sum_sum_6 =
        part_of_two_phidot_thetadot_sum_sum_4 - part_of_two_phidot_thetadot_sum_sum_5;
    let two_phidot_thetadot_sum_sum =
        part_of_two_phidot_thetadot_sum_sum_3 + part_of_two_phidot_thetadot_sum_sum_6;
    let inv_cos_theta_cos_product =
        inv_cos_theta * (cos_theta_minus_w_sum - sin_theta * thetadot_inv_I_d_I_a);
    let minus_r_inv_I_d_I_a_sum = phidot * sin_theta_two - r_inv_I_d_I_a;
    let air_velocity_1_inv_product_6 = air_velocity_1_inv_product * sin_alpha_two_C_Ms;
    let part_of_part_part_plus_air_sum =
        (C_Mq * thetadot + air_velocity_1_inv_product_6) * sqrt_air_velocity_1_product_2;
    let part_part_plus_air_sum =
        part_of_part_part_plus_air_sum - air_velocity_1_inv_product * inv_sqrt_air_product_sum;
    let sin_alpha_two_minus_sum =
        sin_alpha_two_minus_product + air_velocity_1 * part_part_plus_air_sum;
    let air_velocity_1_inv_product_7 = air_velocity_1_inv_product * sqrt_air_velocity_1_product_3;
    let part_of_minus_w_plus_cos_product_12 =
        air_velocity_1_inv_product_6 + thetadot * C_Mq_nonzero_sqrt_air_of;
    let minus_w_plus_cos_product_12 =
        minus_w_plus_cos_theta_sum * part_of_minus_w_plus_cos_product_12;
    let part_of_d_thetadot_dot_d_w = minus_two_inv_p2_part_sum * minus_w_plus_cos_product_12;
    let part_of_d_thetadot_dot_d_w_2 =
        part_of_d_thetadot_dot_d_w - two_cos_alpha_two * air_velocity_1_inv_product_7;
    let part_of_inv_part_part_part_sum_2 = half_p5_p4_p3_inv_p2 * minus_w_plus_cos_product_12;
    let inv_part_part_part_sum_2 =
        part_of_inv_part_part_part_sum_2 + cos_alpha_two * air_velocity_1_inv_product_7;
    let part_of_d_thetadot_dot_d_phi = sin_alpha_two_minus_product * sin_theta_cos_phi_product;
    let part_of_d_thetadot_dot_d_phi_2 =
        minus_air_velocity_1_sum * part_part_plus_air_sum - part_of_d_thetadot_dot_d_phi;
    let part_of_d_thetadot_dot_d_phi_3 =
        inv_sqrt_air_velocity_1_of * part_of_d_thetadot_dot_d_phi_2;
    let part_of_d_thetadot_dot_d_phi_4 =
        part_of_d_thetadot_dot_d_phi_3 - inv_part_part_part_sum_2 * two_cos_theta_cos_product;
    let part_of_d_thetadot_dot_d_theta_2 = inv_part_part_part_sum_2 * two_minus_cos_theta_product;
    let cos_theta_phidot_product = minus_n1_plus_inv_p2_p1 * cos_theta_phidot;
    let part_of_d_thetadot_dot_d_theta =
        sin_theta * sin_theta_phidot_minus_sum + cos_theta * cos_theta_phidot_product;
    let part_of_d_thetadot_dot_d_theta_3 =
        sin_alpha_two_minus_sum * inv_sqrt_air_product_2 - part_of_d_thetadot_dot_d_theta_2;
    let part_of_d_thetadot_dot_d_theta_4 =
        part_of_d_thetadot_dot_d_theta_3 + phidot * part_of_d_thetadot_dot_d_theta;
    let part_of_d_thetadot_dot_d_phidot =
        sin_theta * cos_theta_phidot_product - cos_theta * sin_theta_phidot_minus_sum;
    let minus_sin_theta_inv_sum = -(sin_theta * inv_sqrt_air_product_3);
    let minus_sin_theta_minus_sum = -(sin_theta * minus_inv_part_part_sum);
    let part_of_d_gammadot_dot_d_theta_2 =
        sin_theta * (phidot_thetadot - two_phidot_thetadot_sum_sum);
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * (phidot_cos_theta_product - p14_inv_p1 * phidot);
    let part_of_d_gammadot_dot_d_theta_3 =
        part_of_d_gammadot_dot_d_theta_2 - part_of_d_gammadot_dot_d_theta;
    let part_of_d_gammadot_dot_d_phidot =
        sin_theta * (p14_inv_p1 - inv_cos_theta_cos_product) - cos_theta * thetadot;
    let part_of_d_gammadot_dot_d_thetadot =
        -cos_theta_phidot - minus_r_inv_I_d_I_a_sum * sin_theta_inv_cos_theta;
    let minus_cos_theta_sin_phi = -(cos_theta * sin_phi);
    let minus_z_dot = -z_dot;
    let minus_sin_theta_cos_phi = -(sin_theta * cos_phi);
    let minus_x_dot_cos_phi = -(x_dot * cos_phi);
    let minus_w = -w;
    let minus_minus_w_plus_cos_sum_sum = -minus_w_plus_cos_sum_sum;
    let minus_cos_theta_v = -(cos_theta * v);
    let minus_inv_cos_theta_product = -(inv_cos_theta * thetadot_inv_I_d_I_a);
    let minus_sin_theta_air_product = -(sin_theta * air_velocity_1_inv_product_5);

    dx[0] = x_dot;
    dx[1] = y_dot;
    dx[2] = z_dot;
    dx[3] = u_dot;
    dx[4] = v_dot;
    dx[5] = w_dot;
    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    dx[9] = phidot_cos_theta_product;
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
    j[10] = cos_theta * cos_phi; // d_z_dot_d_w
    j[11] = y_dot; // d_z_dot_d_phi
    j[12] = minus_x_dot_cos_phi; // d_z_dot_d_theta
    j[13] = part_of_d_u_dot_d_u; // d_u_dot_d_u
    j[14] = part_of_d_u_dot_d_v; // d_u_dot_d_v
    j[15] = air_velocity_1_inv_product_3 - thetadot; // d_u_dot_d_w
    j[16] = part_of_d_u_dot_d_phi_3 - sin_theta * part_of_d_u_dot_d_phi; // d_u_dot_d_phi
    j[17] = part_of_d_u_dot_d_theta_3; // d_u_dot_d_theta
    j[18] = sin_theta * v; // d_u_dot_d_phidot
    j[19] = minus_w; // d_u_dot_d_thetadot
    j[20] = part_of_d_v_dot_d_u; // d_v_dot_d_u
    j[21] = part_of_d_v_dot_d_v; // d_v_dot_d_v
    j[22] = cos_theta_phidot + air_velocity_2_inv_product_3; // d_v_dot_d_w
    j[23] = part_of_d_v_dot_d_phi_4; // d_v_dot_d_phi
    j[24] = part_of_d_v_dot_d_theta_2 - x_dot * phidot; // d_v_dot_d_theta
    j[25] = cos_theta_w_minus_u_sin_sum; // d_v_dot_d_phidot
    j[26] = thetadot + air_velocity_1_inv_product * V_part_part_half_sum_2; // d_w_dot_d_u
    j[27] = part_of_d_w_dot_d_v; // d_w_dot_d_v
    j[28] = minus_minus_w_plus_cos_sum_sum; // d_w_dot_d_w
    j[29] = part_of_d_w_dot_d_phi_2; // d_w_dot_d_phi
    j[30] = part_of_d_w_dot_d_theta_2; // d_w_dot_d_theta
    j[31] = minus_cos_theta_v; // d_w_dot_d_phidot
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
    j[36] = air_velocity_1_inv_product_5; // d_phidot_dot_d_u
    j[37] = inv_sqrt_air_product_3; // d_phidot_dot_d_v
    j[38] = part_of_d_phidot_dot_d_w_2; // d_phidot_dot_d_w
    j[39] = minus_inv_part_part_sum; // d_phidot_dot_d_phi
    j[40] = two_phidot_thetadot_sum_sum; // d_phidot_dot_d_theta
    j[41] = inv_cos_theta_cos_product; // d_phidot_dot_d_phidot
    j[42] = inv_cos_theta * minus_r_inv_I_d_I_a_sum; // d_phidot_dot_d_thetadot
    j[43] = minus_inv_cos_theta_product; // d_phidot_dot_d_gammadot
    j[44] = inv_sqrt_air_velocity_1_of * sin_alpha_two_minus_sum; // d_thetadot_dot_d_u
    j[45] = air_velocity_2_inv_product * part_part_plus_air_sum; // d_thetadot_dot_d_v
    j[46] = part_of_d_thetadot_dot_d_w_2; // d_thetadot_dot_d_w
    j[47] = part_of_d_thetadot_dot_d_phi_4; // d_thetadot_dot_d_phi
    j[48] = part_of_d_thetadot_dot_d_theta_4; // d_thetadot_dot_d_theta
    j[49] = part_of_d_thetadot_dot_d_phidot; // d_thetadot_dot_d_phidot
    j[50] = minus_w_plus_cos_product_6; // d_thetadot_dot_d_thetadot
    j[51] = inv_p2_p1 * cos_theta_phidot; // d_thetadot_dot_d_gammadot
    j[52] = minus_sin_theta_air_product; // d_gammadot_dot_d_u
    j[53] = minus_sin_theta_inv_sum; // d_gammadot_dot_d_v
    j[54] = inv_part_part_part_sum * sin_theta_two; // d_gammadot_dot_d_w
    j[55] = minus_sin_theta_minus_sum; // d_gammadot_dot_d_phi
    j[56] = part_of_d_gammadot_dot_d_theta_3; // d_gammadot_dot_d_theta
    j[57] = part_of_d_gammadot_dot_d_phidot; // d_gammadot_dot_d_phidot
    j[58] = part_of_d_gammadot_dot_d_thetadot; // d_gammadot_dot_d_thetadot
    // d_gammadot_dot_d_gammadot
    j[59] = thetadot_inv_I_d_I_a * sin_theta_inv_cos_theta + p14_inv_p1;
}
