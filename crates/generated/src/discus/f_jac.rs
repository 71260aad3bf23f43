// Written by `hyzer generate`; changes belong in the model.
//! `discus`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 350 operations: 104 add, 218 mul, 4 div, 14 neg, 2 sqrt, 7 call, 1 select.
/// `prepare` takes 20 operations for it.
#[inline(always)]
pub fn f_jac<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 28],
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
    let minus_C_Lp_plus_C_Ls = prepared[0];
    let inv_s_stall = prepared[1];
    let inv_m_half_rho_A = prepared[2];
    let inv_I_d_I_a = prepared[4];
    let half_rho_A_d_inv_I_d = prepared[5];
    let C_Nr_inv_I_a = prepared[6];
    let minus_wind_y = prepared[7];
    let two_C_Ds = prepared[8];
    let n8_inv_s_stall_product = prepared[9];
    let two_inv_I_d_half_rho_A_d = prepared[10];
    let two_minus_inv_I_d_I_a = prepared[11];
    let minus_one_plus_inv_I_d_I_a = prepared[12];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // discus.hyz:64  position (x, y, z) in N;
    let x_dot = u * cos_theta + w * sin_theta;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let minus_sin_theta_u_minus_w_cos_sum_2 = cos_theta * w - u * sin_theta;
    let y_dot = v * cos_phi - sin_phi * minus_sin_theta_u_minus_w_cos_sum_2;
    let z_dot = cos_phi * minus_sin_theta_u_minus_w_cos_sum_2 + v * sin_phi;
    let cos_phi_g = g * cos_phi;
    let cos_phi_g_plus_v_phidot = v * phidot + cos_phi_g;
    let sin_theta_cos_phi_g_product = sin_theta * cos_phi_g_plus_v_phidot;
    let sin_phi_wind_y_sum = wind_y * sin_phi - wind_z * cos_phi;
    let d_air_velocity_1_d_theta = wind_x * sin_theta - cos_theta * sin_phi_wind_y_sum;

    // discus.hyz:71  let air_velocity = velocity - in_B(wind);
    let minus_air_velocity_3 = d_air_velocity_1_d_theta - w;
    let d_minus_air_velocity_3_d_theta = wind_x * cos_theta + sin_theta * sin_phi_wind_y_sum;
    let air_velocity_1 = u - d_minus_air_velocity_3_d_theta;
    let d_minus_sin_phi_wind_y_sum_d_phi = minus_wind_y * cos_phi - wind_z * sin_phi;
    let air_velocity_2 = v + d_minus_sin_phi_wind_y_sum_d_phi;
    let air_velocity_12_sq = air_velocity_1 * air_velocity_1 + air_velocity_2 * air_velocity_2;
    let V_sq = minus_air_velocity_3 * minus_air_velocity_3 + air_velocity_12_sq;

    // discus.hyz:73  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let V_inv_m_half_rho_A = inv_m_half_rho_A * V;
    let inv_V = V.recip_or_zero();
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;
    let inv_s_stall_minus_product = inv_s_stall * minus_air_velocity_3_inv_V;
    let inv_s_stall_minus_product_sq = inv_s_stall_minus_product * inv_s_stall_minus_product;
    let inv_s_stall_minus_product_2 = inv_s_stall_minus_product_sq * inv_s_stall_minus_product_sq;
    let inv_s_stall_minus_sum =
        inv_s_stall_minus_product_2 * inv_s_stall_minus_product_2 + T::splat(1.0);
    let inv_inv_s_stall_minus_sum = T::splat(1.0) / inv_s_stall_minus_sum;
    let C_Lp_plus_minus_C_Lp_sum = C_Lp + minus_C_Lp_plus_C_Ls * inv_inv_s_stall_minus_sum;
    let air_velocity_12 = air_velocity_12_sq.sqrt();

    // discus.hyz:78  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let alpha_two = T::splat(2.0) * alpha;
    let (sin_alpha_two, cos_alpha_two) = alpha_two.sin_cos();
    let sin_alpha_two_C_Lp_product = C_Lp_plus_minus_C_Lp_sum * sin_alpha_two;
    let minus_air_velocity_product = minus_air_velocity_3_inv_V * minus_air_velocity_3_inv_V;

    // discus.hyz:84  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = C_D0 + C_Ds * minus_air_velocity_product;
    let C_D_air_velocity_12_sum =
        air_velocity_12 * C_D - minus_air_velocity_3 * sin_alpha_two_C_Lp_product;
    let C_D_air_velocity_12_product = V_inv_m_half_rho_A * C_D_air_velocity_12_sum;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let part_of_u_dot =
        sin_theta_cos_phi_g_product - C_D_air_velocity_12_product * air_velocity_1_inv_product;

    // discus.hyz:65  velocity (u, v, w) in B;
    let u_dot = part_of_u_dot - w * thetadot;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12;
    let part_of_v_dot = C_D_air_velocity_12_product * air_velocity_2_inv_product;
    let sin_phi_g = g * sin_phi;
    let v_dot = minus_sin_theta_u_minus_w_cos_sum_2 * phidot - part_of_v_dot - sin_phi_g;
    let cos_theta_cos_phi_g_product = cos_theta * cos_phi_g_plus_v_phidot;
    let minus_air_velocity_3_C_sum =
        air_velocity_12 * sin_alpha_two_C_Lp_product + minus_air_velocity_3 * C_D;
    let part_of_w_dot =
        V_inv_m_half_rho_A * minus_air_velocity_3_C_sum - cos_theta_cos_phi_g_product;
    let w_dot = part_of_w_dot + u * thetadot;
    let V_sq_half_rho_A_d_inv_part = half_rho_A_d_inv_I_d * V_sq;
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let C_Mq_nonzero_air_velocity_12 = C_Mq * nonzero_air_velocity_12;
    let V_sq_half_rho_A_d_product_2 = V_sq_half_rho_A_d_inv_part * C_Mq_nonzero_air_velocity_12;
    let sin_theta_two_thetadot_sum =
        cos_theta * V_sq_half_rho_A_d_product_2 + T::splat(2.0) * sin_theta * thetadot;
    let V_sq_half_rho_A_d_product = C_Ms * V_sq_half_rho_A_d_inv_part;
    let V_sq_half_rho_A_d_product_3 = sin_alpha_two * V_sq_half_rho_A_d_product;
    let part_of_minus_thetadot_r_inv_I = air_velocity_2_inv_product * V_sq_half_rho_A_d_product_3;
    let sin_theta_phidot = sin_theta * phidot;

    // discus.hyz:89  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let r_inv_I_d_I_a = inv_I_d_I_a * r;
    let part_of_minus_thetadot_r_inv_I_2 =
        phidot * sin_theta_two_thetadot_sum - part_of_minus_thetadot_r_inv_I;
    let minus_thetadot_r_inv_I_sum = part_of_minus_thetadot_r_inv_I_2 - thetadot * r_inv_I_d_I_a;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let minus_thetadot_r_product = minus_thetadot_r_inv_I_sum * inv_cos_theta;
    let cos_theta_phidot = cos_theta * phidot;
    let sin_theta_phidot_minus_sum = sin_theta_phidot - r_inv_I_d_I_a;
    let part_of_thetadot_dot =
        thetadot * V_sq_half_rho_A_d_product_2 - cos_theta_phidot * sin_theta_phidot_minus_sum;

    // discus.hyz:57  frame B = A turned theta about 2; // does not spin with the discus
    let thetadot_dot =
        part_of_thetadot_dot + air_velocity_1_inv_product * V_sq_half_rho_A_d_product_3;

    // discus.hyz:58  frame C = B turned gamma about 3; // fixed in the discus
    let gammadot_dot =
        C_Nr_inv_I_a * r - thetadot * cos_theta_phidot - sin_theta * minus_thetadot_r_product;
    let d_y_dot_d_u = sin_theta * sin_phi;
    let d_y_dot_d_phi = -z_dot;
    let d_y_dot_d_theta = x_dot * sin_phi;
    let d_z_dot_d_w = cos_theta * cos_phi;
    let minus_air_velocity_product_2 = two_C_Ds * minus_air_velocity_3_inv_V;
    let part_of_n8_inv_s_stall_product_2 =
        n8_inv_s_stall_product * (inv_s_stall_minus_product * inv_s_stall_minus_product_sq);
    let part_of_n8_inv_s_stall_product_2_2 =
        inv_s_stall_minus_product_2 * inv_inv_s_stall_minus_sum;
    let part_of_n8_inv_s_stall_product_2_3 =
        part_of_n8_inv_s_stall_product_2_2 * (inv_inv_s_stall_minus_sum * sin_alpha_two);
    let n8_inv_s_stall_product_2 =
        part_of_n8_inv_s_stall_product_2 * part_of_n8_inv_s_stall_product_2_3;
    let part_of_inv_V_air_velocity = minus_air_velocity_3 * n8_inv_s_stall_product_2;
    let part_of_inv_V_air_velocity_2 =
        air_velocity_12 * minus_air_velocity_product_2 + part_of_inv_V_air_velocity;
    let inv_V_air_velocity_product = inv_V * part_of_inv_V_air_velocity_2;
    let V_inv_m_half_rho_A_product = V_inv_m_half_rho_A * minus_air_velocity_3_inv_V;
    let part_of_d_C_D_air_velocity_12 = inv_V_air_velocity_product * V_inv_m_half_rho_A_product;
    let d_C_D_air_velocity_12_product_d_V =
        inv_m_half_rho_A * C_D_air_velocity_12_sum - part_of_d_C_D_air_velocity_12;
    let air_velocity_12_inv_V = air_velocity_12 * inv_V;
    let part_of_minus_d_C_D_air_sum_2 = d_C_D_air_velocity_12_product_d_V * air_velocity_12_inv_V;
    let two_cos_alpha_two = T::splat(2.0) * cos_alpha_two;
    let part_of_minus_d_C_D_air_sum =
        C_Lp_plus_minus_C_Lp_sum * two_cos_alpha_two * minus_air_velocity_product;
    let part_of_minus_d_C_D_air_sum_3 =
        part_of_minus_d_C_D_air_sum_2 + V_inv_m_half_rho_A * (C_D + part_of_minus_d_C_D_air_sum);
    let C_D_air_velocity_12_product_2 = C_D_air_velocity_12_product * inv_air_velocity_12;
    let minus_d_C_D_air_sum = C_D_air_velocity_12_product_2 - part_of_minus_d_C_D_air_sum_3;
    let part_of_d_u_dot_d_air_velocity_1 =
        air_velocity_1_inv_product * (air_velocity_1_inv_product * minus_d_C_D_air_sum);
    let d_u_dot_d_air_velocity_1 = part_of_d_u_dot_d_air_velocity_1 - C_D_air_velocity_12_product_2;
    let d_u_dot_d_air_velocity_2 =
        air_velocity_2_inv_product * (air_velocity_1_inv_product * minus_d_C_D_air_sum);
    let d_u_dot_d_v = sin_theta_phidot + d_u_dot_d_air_velocity_2;
    let part_of_minus_air_velocity_sum_2 =
        minus_air_velocity_3_inv_V * d_C_D_air_velocity_12_product_d_V;
    let part_of_minus_air_velocity_sum =
        V_inv_m_half_rho_A * (sin_alpha_two_C_Lp_product - inv_V_air_velocity_product);
    let inv_V_two_cos_alpha_two = inv_V * two_cos_alpha_two;
    let C_Lp_plus_minus_C_product = C_Lp_plus_minus_C_Lp_sum * inv_V_two_cos_alpha_two;
    let air_velocity_12_V_product =
        air_velocity_12 * V_inv_m_half_rho_A_product * C_Lp_plus_minus_C_product;
    let part_of_minus_air_velocity_sum_3 =
        part_of_minus_air_velocity_sum_2 - part_of_minus_air_velocity_sum;
    let minus_air_velocity_sum = part_of_minus_air_velocity_sum_3 - air_velocity_12_V_product;
    let air_velocity_1_inv_product_2 = air_velocity_1_inv_product * minus_air_velocity_sum;
    let d_u_dot_d_w = air_velocity_1_inv_product_2 - thetadot;
    let part_of_d_u_dot_d_phi =
        cos_theta * air_velocity_1_inv_product_2 * d_minus_sin_phi_wind_y_sum_d_phi;
    let part_of_d_u_dot_d_phi_2 =
        sin_phi_g - d_u_dot_d_air_velocity_1 * d_minus_sin_phi_wind_y_sum_d_phi;
    let part_of_d_u_dot_d_phi_3 =
        sin_phi_wind_y_sum * d_u_dot_d_air_velocity_2 - part_of_d_u_dot_d_phi;
    let d_u_dot_d_phi = part_of_d_u_dot_d_phi_3 - sin_theta * part_of_d_u_dot_d_phi_2;
    let part_of_d_u_dot_d_theta =
        cos_theta_cos_phi_g_product + d_u_dot_d_air_velocity_1 * d_air_velocity_1_d_theta;
    let d_u_dot_d_theta =
        part_of_d_u_dot_d_theta - air_velocity_1_inv_product_2 * d_minus_air_velocity_3_d_theta;
    let d_u_dot_d_phidot = sin_theta * v;
    let d_v_dot_d_air_velocity_1 =
        air_velocity_1_inv_product * (air_velocity_2_inv_product * minus_d_C_D_air_sum);
    let d_v_dot_d_u = d_v_dot_d_air_velocity_1 - sin_theta_phidot;
    let part_of_d_v_dot_d_air_velocity_2 =
        air_velocity_2_inv_product * (air_velocity_2_inv_product * minus_d_C_D_air_sum);
    let d_v_dot_d_air_velocity_2 = part_of_d_v_dot_d_air_velocity_2 - C_D_air_velocity_12_product_2;
    let air_velocity_2_inv_product_2 = air_velocity_2_inv_product * minus_air_velocity_sum;
    let d_v_dot_d_w = cos_theta_phidot + air_velocity_2_inv_product_2;
    let sin_theta_air_product = sin_theta * air_velocity_1_inv_product;
    let part_of_d_v_dot_d_phi =
        air_velocity_2_inv_product * minus_d_C_D_air_sum * sin_theta_air_product;
    let part_of_d_v_dot_d_phi_2 = part_of_d_v_dot_d_phi - cos_theta * air_velocity_2_inv_product_2;
    let part_of_d_v_dot_d_phi_3 = d_minus_sin_phi_wind_y_sum_d_phi * part_of_d_v_dot_d_phi_2;
    let d_v_dot_d_phi =
        sin_phi_wind_y_sum * d_v_dot_d_air_velocity_2 - cos_phi_g + part_of_d_v_dot_d_phi_3;
    let air_velocity_1_inv_product_3 = air_velocity_1_inv_product * d_air_velocity_1_d_theta;
    let part_of_d_v_dot_d_theta =
        air_velocity_2_inv_product * minus_d_C_D_air_sum * air_velocity_1_inv_product_3;
    let part_of_d_v_dot_d_theta_2 = d_minus_air_velocity_3_d_theta * air_velocity_2_inv_product_2;
    let d_v_dot_d_theta = part_of_d_v_dot_d_theta - x_dot * phidot - part_of_d_v_dot_d_theta_2;
    let part_of_inv_V_minus_air = minus_air_velocity_3 * minus_air_velocity_product_2;
    let part_of_inv_V_minus_air_2 =
        part_of_inv_V_minus_air - air_velocity_12 * n8_inv_s_stall_product_2;
    let inv_V_minus_air_velocity_sum = inv_V * part_of_inv_V_minus_air_2;
    let part_of_d_w_dot_d_V = inv_V_minus_air_velocity_sum * V_inv_m_half_rho_A_product;
    let d_w_dot_d_V = inv_m_half_rho_A * minus_air_velocity_3_C_sum - part_of_d_w_dot_d_V;
    let part_of_d_w_dot_d_air_velocity =
        d_w_dot_d_V * air_velocity_12_inv_V - air_velocity_12_V_product;
    let d_w_dot_d_air_velocity_12 =
        part_of_d_w_dot_d_air_velocity + V_inv_m_half_rho_A * sin_alpha_two_C_Lp_product;
    let d_w_dot_d_air_velocity_1 = air_velocity_1_inv_product * d_w_dot_d_air_velocity_12;
    let d_w_dot_d_u = thetadot + d_w_dot_d_air_velocity_1;
    let d_w_dot_d_air_velocity_2 = air_velocity_2_inv_product * d_w_dot_d_air_velocity_12;
    let d_w_dot_d_v = d_w_dot_d_air_velocity_2 - cos_theta_phidot;
    let part_of_d_w_dot_d_minus_air =
        C_D + inv_V_minus_air_velocity_sum + air_velocity_12_sq * inv_V * C_Lp_plus_minus_C_product;
    let d_w_dot_d_minus_air_velocity_3 =
        minus_air_velocity_3_inv_V * d_w_dot_d_V + V_inv_m_half_rho_A * part_of_d_w_dot_d_minus_air;
    let part_of_d_w_dot_d_phi = sin_theta * air_velocity_1 * d_minus_sin_phi_wind_y_sum_d_phi;
    let part_of_d_w_dot_d_phi_2 = part_of_d_w_dot_d_phi + air_velocity_2 * sin_phi_wind_y_sum;
    let part_of_d_w_dot_d_phi_3 =
        inv_air_velocity_12 * d_w_dot_d_air_velocity_12 * part_of_d_w_dot_d_phi_2;
    let part_of_d_w_dot_d_phi_4 = d_minus_sin_phi_wind_y_sum_d_phi * d_w_dot_d_minus_air_velocity_3;
    let d_w_dot_d_phi = part_of_d_w_dot_d_phi_3 + cos_theta * (sin_phi_g + part_of_d_w_dot_d_phi_4);
    let part_of_d_w_dot_d_theta =
        sin_theta_cos_phi_g_product + d_w_dot_d_air_velocity_12 * air_velocity_1_inv_product_3;
    let d_w_dot_d_theta =
        part_of_d_w_dot_d_theta + d_minus_air_velocity_3_d_theta * d_w_dot_d_minus_air_velocity_3;
    let sin_alpha_two_C_Ms = C_Ms * sin_alpha_two;
    let air_velocity_2_inv_product_3 = air_velocity_2_inv_product * inv_cos_theta;
    let sin_alpha_two_C_Ms_product = sin_alpha_two_C_Ms * air_velocity_2_inv_product_3;
    let air_velocity_12_two_product = two_inv_I_d_half_rho_A_d * air_velocity_12;
    let part_of_minus_minus_part_part =
        (sin_alpha_two_C_Ms_product - C_Mq * phidot) * air_velocity_12_two_product;
    let d_thetadot_dot_d_air_velocity_1 = inv_air_velocity_12 * V_sq_half_rho_A_d_product_3;
    let inv_V_two_cos_alpha_product = inv_V_two_cos_alpha_two * V_sq_half_rho_A_d_product;
    let d_thetadot_dot_d_air_sum =
        d_thetadot_dot_d_air_velocity_1 + minus_air_velocity_3_inv_V * inv_V_two_cos_alpha_product;
    let part_of_minus_minus_part_part_2 =
        inv_cos_theta * (air_velocity_2_inv_product * d_thetadot_dot_d_air_sum);
    let minus_minus_part_part_sum = part_of_minus_minus_part_part_2 - part_of_minus_minus_part_part;
    let d_minus_thetadot_r_product_d_u = air_velocity_1_inv_product * minus_minus_part_part_sum;
    let part_of_d_phidot_dot_d_v =
        air_velocity_2 * minus_minus_part_part_sum - V_sq_half_rho_A_d_product_3 * inv_cos_theta;
    let d_phidot_dot_d_v = inv_air_velocity_12 * part_of_d_phidot_dot_d_v;
    let air_velocity_12_inv_product = air_velocity_12_inv_V * inv_V_two_cos_alpha_product;
    let part_of_minus_air_velocity_2_sum_3 =
        air_velocity_2_inv_product_3 * air_velocity_12_inv_product;
    let part_of_minus_air_velocity_2_sum =
        phidot * C_Mq_nonzero_air_velocity_12 - sin_alpha_two_C_Ms_product;
    let minus_air_velocity_product_3 = two_inv_I_d_half_rho_A_d * minus_air_velocity_3;
    let part_of_minus_air_velocity_2_sum_2 =
        part_of_minus_air_velocity_2_sum * minus_air_velocity_product_3;
    let minus_air_velocity_2_sum =
        part_of_minus_air_velocity_2_sum_2 - part_of_minus_air_velocity_2_sum_3;
    let minus_minus_part_product = minus_minus_part_part_sum * sin_theta_air_product;
    let part_of_d_minus_thetadot_r =
        minus_minus_part_product + cos_theta * minus_air_velocity_2_sum;
    let part_of_d_minus_thetadot_r_2 =
        d_minus_sin_phi_wind_y_sum_d_phi * part_of_d_minus_thetadot_r;
    let d_minus_thetadot_r_product_d_phi =
        sin_phi_wind_y_sum * d_phidot_dot_d_v + part_of_d_minus_thetadot_r_2;
    let part_of_d_minus_thetadot_r_4 = d_minus_air_velocity_3_d_theta * minus_air_velocity_2_sum;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let part_of_d_minus_thetadot_r_3 =
        (minus_thetadot_r_product - phidot * V_sq_half_rho_A_d_product_2) * sin_theta_inv_cos_theta;
    let phidot_thetadot = phidot * thetadot;
    let part_of_d_minus_thetadot_r_5 =
        minus_minus_part_part_sum * air_velocity_1_inv_product_3 + part_of_d_minus_thetadot_r_4;
    let part_of_d_minus_thetadot_r_6 = part_of_d_minus_thetadot_r_5 + part_of_d_minus_thetadot_r_3;
    let d_minus_thetadot_r_product_d_theta =
        part_of_d_minus_thetadot_r_6 + two_minus_inv_I_d_I_a * phidot_thetadot;
    let thetadot_inv_I_d_I_a = inv_I_d_I_a * thetadot;
    let sin_theta_inv_cos_product = sin_theta_inv_cos_theta * thetadot_inv_I_d_I_a;
    let d_minus_thetadot_r_product_d_phidot =
        sin_theta_two_thetadot_sum * inv_cos_theta - sin_theta_inv_cos_product;
    let minus_r_inv_I_d_I_a_sum = T::splat(2.0) * sin_theta_phidot - r_inv_I_d_I_a;
    let d_phidot_dot_d_thetadot = inv_cos_theta * minus_r_inv_I_d_I_a_sum;
    let air_velocity_1_inv_product_4 = air_velocity_1_inv_product * sin_alpha_two_C_Ms;
    let part_of_d_thetadot_dot_d_air =
        (C_Mq * thetadot + air_velocity_1_inv_product_4) * air_velocity_12_two_product;
    let d_thetadot_dot_d_air_velocity_12 =
        part_of_d_thetadot_dot_d_air - air_velocity_1_inv_product * d_thetadot_dot_d_air_sum;
    let part_of_d_thetadot_dot_d_air_2 =
        V_sq_half_rho_A_d_product_3 + air_velocity_1 * d_thetadot_dot_d_air_velocity_12;
    let d_thetadot_dot_d_air_velocity_1_2 = inv_air_velocity_12 * part_of_d_thetadot_dot_d_air_2;
    let d_thetadot_dot_d_air_velocity_2 =
        air_velocity_2_inv_product * d_thetadot_dot_d_air_velocity_12;
    let part_of_air_velocity_1_inv_sum =
        air_velocity_1_inv_product_4 + thetadot * C_Mq_nonzero_air_velocity_12;
    let part_of_air_velocity_1_inv_sum_2 =
        part_of_air_velocity_1_inv_sum * minus_air_velocity_product_3;
    let air_velocity_1_inv_sum =
        air_velocity_1_inv_product * air_velocity_12_inv_product + part_of_air_velocity_1_inv_sum_2;
    let part_of_d_thetadot_dot_d_phi =
        sin_theta * d_thetadot_dot_d_air_velocity_1_2 + cos_theta * air_velocity_1_inv_sum;
    let part_of_d_thetadot_dot_d_phi_2 =
        d_minus_sin_phi_wind_y_sum_d_phi * part_of_d_thetadot_dot_d_phi;
    let d_thetadot_dot_d_phi =
        sin_phi_wind_y_sum * d_thetadot_dot_d_air_velocity_2 + part_of_d_thetadot_dot_d_phi_2;
    let part_of_d_thetadot_dot_d_theta_2 =
        d_air_velocity_1_d_theta * d_thetadot_dot_d_air_velocity_1_2;
    let cos_theta_phidot_product = minus_one_plus_inv_I_d_I_a * cos_theta_phidot;
    let part_of_d_thetadot_dot_d_theta =
        sin_theta * sin_theta_phidot_minus_sum + cos_theta * cos_theta_phidot_product;
    let part_of_d_thetadot_dot_d_theta_3 =
        part_of_d_thetadot_dot_d_theta_2 + d_minus_air_velocity_3_d_theta * air_velocity_1_inv_sum;
    let d_thetadot_dot_d_theta =
        part_of_d_thetadot_dot_d_theta_3 + phidot * part_of_d_thetadot_dot_d_theta;
    let d_thetadot_dot_d_phidot =
        sin_theta * cos_theta_phidot_product - cos_theta * sin_theta_phidot_minus_sum;
    let d_thetadot_dot_d_r = inv_I_d_I_a * cos_theta_phidot;
    let d_gammadot_dot_d_w = sin_theta * minus_air_velocity_2_sum;
    let part_of_d_gammadot_dot_d_theta_2 =
        cos_theta * (minus_thetadot_r_product - C_Nr_inv_I_a * phidot);
    let part_of_d_gammadot_dot_d_theta =
        sin_theta * (phidot_thetadot - d_minus_thetadot_r_product_d_theta);
    let d_gammadot_dot_d_theta = part_of_d_gammadot_dot_d_theta - part_of_d_gammadot_dot_d_theta_2;
    let d_gammadot_dot_d_phidot =
        sin_theta * (C_Nr_inv_I_a - d_minus_thetadot_r_product_d_phidot) - cos_theta * thetadot;
    let d_gammadot_dot_d_thetadot =
        -cos_theta_phidot - minus_r_inv_I_d_I_a_sum * sin_theta_inv_cos_theta;
    let d_gammadot_dot_d_gammadot = sin_theta_inv_cos_product + C_Nr_inv_I_a;
    let d_y_dot_d_w = -(cos_theta * sin_phi);
    let d_z_dot_d_u = -(sin_theta * cos_phi);
    let d_z_dot_d_theta = -(x_dot * cos_phi);
    let d_u_dot_d_thetadot = -w;
    let d_w_dot_d_w = -d_w_dot_d_minus_air_velocity_3;
    let d_w_dot_d_phidot = -(cos_theta * v);
    let d_phidot_dot_d_w = -minus_air_velocity_2_sum;
    let d_phidot_dot_d_gammadot = -(inv_cos_theta * thetadot_inv_I_d_I_a);
    let d_thetadot_dot_d_w = -air_velocity_1_inv_sum;
    let d_gammadot_dot_d_u = -minus_minus_part_product;
    let d_gammadot_dot_d_v = -(sin_theta * d_phidot_dot_d_v);
    let d_gammadot_dot_d_phi = -(sin_theta * d_minus_thetadot_r_product_d_phi);

    dx[0] = x_dot;
    dx[1] = y_dot;
    dx[2] = z_dot;
    dx[3] = u_dot;
    dx[4] = v_dot;
    dx[5] = w_dot;
    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    dx[9] = minus_thetadot_r_product;
    dx[10] = thetadot_dot;
    dx[11] = gammadot_dot;

    j[0] = cos_theta; // d_x_dot_d_u
    j[1] = sin_theta; // d_x_dot_d_w
    j[2] = minus_sin_theta_u_minus_w_cos_sum_2; // d_x_dot_d_theta
    j[3] = d_y_dot_d_u;
    j[4] = cos_phi; // d_y_dot_d_v
    j[5] = d_y_dot_d_w;
    j[6] = d_y_dot_d_phi;
    j[7] = d_y_dot_d_theta;
    j[8] = d_z_dot_d_u;
    j[9] = sin_phi; // d_z_dot_d_v
    j[10] = d_z_dot_d_w;
    j[11] = y_dot; // d_z_dot_d_phi
    j[12] = d_z_dot_d_theta;
    j[13] = d_u_dot_d_air_velocity_1; // d_u_dot_d_u
    j[14] = d_u_dot_d_v;
    j[15] = d_u_dot_d_w;
    j[16] = d_u_dot_d_phi;
    j[17] = d_u_dot_d_theta;
    j[18] = d_u_dot_d_phidot;
    j[19] = d_u_dot_d_thetadot;
    j[20] = d_v_dot_d_u;
    j[21] = d_v_dot_d_air_velocity_2; // d_v_dot_d_v
    j[22] = d_v_dot_d_w;
    j[23] = d_v_dot_d_phi;
    j[24] = d_v_dot_d_theta;
    j[25] = minus_sin_theta_u_minus_w_cos_sum_2; // d_v_dot_d_phidot
    j[26] = d_w_dot_d_u;
    j[27] = d_w_dot_d_v;
    j[28] = d_w_dot_d_w;
    j[29] = d_w_dot_d_phi;
    j[30] = d_w_dot_d_theta;
    j[31] = d_w_dot_d_phidot;
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
    j[36] = d_minus_thetadot_r_product_d_u; // d_phidot_dot_d_u
    j[37] = d_phidot_dot_d_v;
    j[38] = d_phidot_dot_d_w;
    j[39] = d_minus_thetadot_r_product_d_phi; // d_phidot_dot_d_phi
    j[40] = d_minus_thetadot_r_product_d_theta; // d_phidot_dot_d_theta
    j[41] = d_minus_thetadot_r_product_d_phidot; // d_phidot_dot_d_phidot
    j[42] = d_phidot_dot_d_thetadot;
    j[43] = d_phidot_dot_d_gammadot;
    j[44] = d_thetadot_dot_d_air_velocity_1_2; // d_thetadot_dot_d_u
    j[45] = d_thetadot_dot_d_air_velocity_2; // d_thetadot_dot_d_v
    j[46] = d_thetadot_dot_d_w;
    j[47] = d_thetadot_dot_d_phi;
    j[48] = d_thetadot_dot_d_theta;
    j[49] = d_thetadot_dot_d_phidot;
    j[50] = V_sq_half_rho_A_d_product_2; // d_thetadot_dot_d_thetadot
    j[51] = d_thetadot_dot_d_r; // d_thetadot_dot_d_gammadot
    j[52] = d_gammadot_dot_d_u;
    j[53] = d_gammadot_dot_d_v;
    j[54] = d_gammadot_dot_d_w;
    j[55] = d_gammadot_dot_d_phi;
    j[56] = d_gammadot_dot_d_theta;
    j[57] = d_gammadot_dot_d_phidot;
    j[58] = d_gammadot_dot_d_thetadot;
    j[59] = d_gammadot_dot_d_gammadot;
}
