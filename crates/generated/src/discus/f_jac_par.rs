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
    let minus_C_Lp_plus_C_Ls = prepared[0];
    let inv_s_stall = prepared[1];
    let inv_m_half_rho_A = prepared[2];
    let inv_I_d_I_a = prepared[4];
    let half_rho_A_d_inv_I_d = prepared[5];
    let C_Nr_inv_I_a = prepared[6];
    let two_C_Ds = prepared[7];
    let minus_one_plus_inv_I_d_I_a = prepared[11];
    let A_half = prepared[12];
    let half_rho_A = prepared[13];
    let inv_m = prepared[14];
    let inv_I_d = prepared[15];
    let inv_I_a = prepared[16];
    let minus_C_Lp_plus_C_Ls_n8 = prepared[17];
    let rho_half = prepared[18];
    let minus_rho_half = prepared[19];
    let minus_A_half = prepared[20];
    let minus_half_rho_A_inv_m = prepared[21];
    let half_rho_A_d = prepared[22];
    let inv_I_d_sq = prepared[23];
    let half_rho_A_inv_I_d = prepared[24];
    let d_inv_I_d_rho_half = prepared[25];
    let d_inv_I_d_A_half = prepared[26];
    let minus_inv_I_d_half_rho_sum = prepared[27];
    let inv_I_a_d_gammadot_dot_d_r = prepared[28];
    let minus_half_rho_A_inv_I_d = prepared[29];
    let minus_d_inv_I_d_rho_half = prepared[30];
    let minus_d_inv_I_d_A_half = prepared[31];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // discus.hyz:63  position (x, y, z) in N;
    let x_dot = u * cos_theta + w * sin_theta;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let minus_sin_theta_u_minus_w_cos_sum_2 = cos_theta * w - u * sin_theta;
    let y_dot = v * cos_phi - sin_phi * minus_sin_theta_u_minus_w_cos_sum_2;
    let z_dot = cos_phi * minus_sin_theta_u_minus_w_cos_sum_2 + v * sin_phi;
    let cos_phi_g = g * cos_phi;
    let cos_phi_g_plus_v_phidot = v * phidot + cos_phi_g;
    let sin_theta_cos_phi_g_product = sin_theta * cos_phi_g_plus_v_phidot;
    let minus_sin_phi_wind_y_sum = wind_z * cos_phi - wind_y * sin_phi;
    let d_air_velocity_1_d_theta = cos_theta * minus_sin_phi_wind_y_sum + wind_x * sin_theta;

    // discus.hyz:70  let air_velocity = velocity - in_B(wind);
    let minus_air_velocity_3 = d_air_velocity_1_d_theta - w;
    let minus_air_velocity_3_sq = minus_air_velocity_3 * minus_air_velocity_3;
    let minus_d_minus_air_velocity_3_d_theta =
        sin_theta * minus_sin_phi_wind_y_sum - wind_x * cos_theta;
    let air_velocity_1 = u + minus_d_minus_air_velocity_3_d_theta;
    let minus_d_minus_sin_phi_wind_y_sum_d_phi = wind_y * cos_phi + wind_z * sin_phi;
    let air_velocity_2 = v - minus_d_minus_sin_phi_wind_y_sum_d_phi;
    let air_velocity_12_sq = air_velocity_1 * air_velocity_1 + air_velocity_2 * air_velocity_2;
    let V_sq = minus_air_velocity_3_sq + air_velocity_12_sq;

    // discus.hyz:72  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let V_inv_m = inv_m * V;
    let V_inv_m_half_rho_A = half_rho_A * V_inv_m;
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

    // discus.hyz:77  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let alpha_two = T::splat(2.0) * alpha;
    let (sin_alpha_two, cos_alpha_two) = alpha_two.sin_cos();
    let sin_alpha_two_C_Lp_product = C_Lp_plus_minus_C_Lp_sum * sin_alpha_two;

    // discus.hyz:83  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = C_D0 + C_Ds * minus_air_velocity_3_inv_V * minus_air_velocity_3_inv_V;
    let C_D_air_velocity_12_sum =
        air_velocity_12 * C_D - minus_air_velocity_3 * sin_alpha_two_C_Lp_product;
    let C_D_air_velocity_12_product = V_inv_m_half_rho_A * C_D_air_velocity_12_sum;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let part_of_u_dot =
        sin_theta_cos_phi_g_product - C_D_air_velocity_12_product * air_velocity_1_inv_product;

    // discus.hyz:64  velocity (u, v, w) in B;
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
    let nonzero_air_velocity_12_sq = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let V_sq_half_rho_A_d_inv_part = half_rho_A_d_inv_I_d * V_sq;
    let nonzero_air_product = nonzero_air_velocity_12_sq * V_sq_half_rho_A_d_inv_part;
    let V_sq_half_rho_A_d_product_2 = C_Mq * nonzero_air_product;
    let sin_theta_two = T::splat(2.0) * sin_theta;
    let sin_theta_two_thetadot_sum =
        cos_theta * V_sq_half_rho_A_d_product_2 + thetadot * sin_theta_two;
    let V_sq_half_rho_A_d_product = C_Ms * V_sq_half_rho_A_d_inv_part;
    let V_sq_half_rho_A_d_product_3 = sin_alpha_two * V_sq_half_rho_A_d_product;
    let part_of_minus_thetadot_r_inv_I = air_velocity_2_inv_product * V_sq_half_rho_A_d_product_3;
    let sin_theta_phidot = sin_theta * phidot;

    // discus.hyz:88  let r = dot(angular_velocity, d3);
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

    // discus.hyz:56  frame B = A turned theta about 2; // does not spin with the discus
    let thetadot_dot =
        part_of_thetadot_dot + air_velocity_1_inv_product * V_sq_half_rho_A_d_product_3;

    // discus.hyz:57  frame C = B turned gamma about 3; // fixed in the discus
    let gammadot_dot =
        C_Nr_inv_I_a * r - thetadot * cos_theta_phidot - sin_theta * minus_thetadot_r_product;
    let d_y_dot_d_u = sin_theta * sin_phi;
    let cos_theta_sin_phi = cos_theta * sin_phi;
    let d_y_dot_d_theta = x_dot * sin_phi;
    let d_air_velocity_1_d_wind_z = sin_theta * cos_phi;
    let d_minus_air_velocity_3_d_wind_z = cos_theta * cos_phi;
    let d_w_dot_d_minus_air_velocity_3 = V_inv_m_half_rho_A * C_D;
    let C_Lp_plus_minus_C_product = C_Lp_plus_minus_C_Lp_sum * cos_alpha_two;
    let air_velocity_12_inv_V = air_velocity_12 * inv_V;
    let inv_s_stall_inv_inv_product = inv_s_stall * inv_inv_s_stall_minus_sum;
    let part_of_inv_s_stall_minus =
        minus_C_Lp_plus_C_Ls_n8 * (inv_s_stall_minus_product * inv_s_stall_minus_product_sq);
    let inv_s_stall_minus_product_3 =
        inv_s_stall_minus_product_2 * inv_s_stall_inv_inv_product * part_of_inv_s_stall_minus;
    let inv_inv_s_stall_product = inv_inv_s_stall_minus_sum * sin_alpha_two;
    let inv_s_stall_minus_product_4 = inv_s_stall_minus_product_3 * inv_inv_s_stall_product;
    let part_of_two_C_Lp_plus_minus = air_velocity_12_inv_V * inv_s_stall_minus_product_4;
    let part_of_two_C_Lp_plus_minus_2 =
        T::splat(2.0) * C_Lp_plus_minus_C_product - part_of_two_C_Lp_plus_minus;
    let d_w_dot_d_C_D = minus_air_velocity_3 * V_inv_m_half_rho_A;
    let two_C_Lp_plus_minus_product = part_of_two_C_Lp_plus_minus_2 * d_w_dot_d_C_D;
    let part_of_d_w_dot_d_minus_air_sum = minus_air_velocity_3_inv_V * two_C_Lp_plus_minus_product;
    let air_velocity_12_two = T::splat(2.0) * air_velocity_12;
    let minus_air_velocity_product = minus_air_velocity_3_inv_V * d_w_dot_d_C_D;
    let inv_V_sq = inv_V * inv_V;
    let minus_air_velocity_product_2 = minus_air_velocity_product * (C_Ds * inv_V_sq);
    let part_of_d_C_D_air_velocity_12 = air_velocity_12_two * minus_air_velocity_product_2;
    let d_C_D_air_velocity_12_product_d_V =
        inv_m_half_rho_A * C_D_air_velocity_12_sum - part_of_d_C_D_air_velocity_12;
    let part_of_d_w_dot_d_minus_air_sum_2 =
        part_of_d_w_dot_d_minus_air_sum + air_velocity_12 * d_C_D_air_velocity_12_product_d_V;
    let part_of_d_w_dot_d_minus_air_sum_3 =
        d_w_dot_d_minus_air_velocity_3 + inv_V * part_of_d_w_dot_d_minus_air_sum_2;
    let d_w_dot_d_minus_air_sum_sum =
        part_of_d_w_dot_d_minus_air_sum_3 - C_D_air_velocity_12_product * inv_air_velocity_12;
    let part_of_inv_air_velocity_12 =
        air_velocity_1 * (air_velocity_1_inv_product * d_w_dot_d_minus_air_sum_sum);
    let inv_air_velocity_12_product =
        inv_air_velocity_12 * (C_D_air_velocity_12_product + part_of_inv_air_velocity_12);
    let air_velocity_2_inv_product_2 =
        air_velocity_2_inv_product * (air_velocity_1_inv_product * d_w_dot_d_minus_air_sum_sum);
    let d_u_dot_d_v = sin_theta_phidot - air_velocity_2_inv_product_2;
    let d_w_dot_d_air_velocity_12 = V_inv_m_half_rho_A * sin_alpha_two_C_Lp_product;
    let air_velocity_12_V_product = air_velocity_12 * V_inv_m_half_rho_A;
    let minus_air_velocity_product_3 = minus_air_velocity_3_inv_V * air_velocity_12_V_product;
    let part_of_minus_inv_V_C_Lp_plus =
        (T::splat(1.0) - minus_air_velocity_3_sq * inv_V_sq) * inv_s_stall_minus_product_4;
    let minus_inv_V_C_Lp_plus_sum =
        part_of_minus_inv_V_C_Lp_plus - inv_V * C_Lp_plus_minus_C_product * air_velocity_12_two;
    let part_of_minus_d_w_dot_d_air_sum =
        d_C_D_air_velocity_12_product_d_V + V_inv_m_half_rho_A * minus_inv_V_C_Lp_plus_sum;
    let part_of_minus_d_w_dot_d_air_sum_2 = minus_air_velocity_3 * part_of_minus_d_w_dot_d_air_sum;
    let part_of_minus_d_w_dot_d_air_sum_3 =
        two_C_Ds * minus_air_velocity_product_3 + part_of_minus_d_w_dot_d_air_sum_2;
    let minus_d_w_dot_d_air_sum =
        inv_V * part_of_minus_d_w_dot_d_air_sum_3 - d_w_dot_d_air_velocity_12;
    let minus_d_u_dot_d_minus_air_velocity_3 = air_velocity_1_inv_product * minus_d_w_dot_d_air_sum;
    let d_u_dot_d_w = minus_d_u_dot_d_minus_air_velocity_3 - thetadot;
    let cos_theta_air_product = cos_theta * air_velocity_1_inv_product;
    let minus_d_w_dot_d_air_product = minus_d_w_dot_d_air_sum * cos_theta_air_product;
    let part_of_d_u_dot_d_phi =
        minus_d_minus_sin_phi_wind_y_sum_d_phi * minus_d_w_dot_d_air_product;
    let part_of_d_u_dot_d_phi_2 =
        inv_air_velocity_12_product * minus_d_minus_sin_phi_wind_y_sum_d_phi;
    let part_of_d_u_dot_d_phi_3 =
        part_of_d_u_dot_d_phi + minus_sin_phi_wind_y_sum * air_velocity_2_inv_product_2;
    let d_u_dot_d_phi = part_of_d_u_dot_d_phi_3 - sin_theta * (sin_phi_g - part_of_d_u_dot_d_phi_2);
    let part_of_d_u_dot_d_theta =
        minus_d_u_dot_d_minus_air_velocity_3 * minus_d_minus_air_velocity_3_d_theta;
    let part_of_d_u_dot_d_theta_2 =
        cos_theta_cos_phi_g_product - inv_air_velocity_12_product * d_air_velocity_1_d_theta;
    let d_u_dot_d_theta = part_of_d_u_dot_d_theta_2 + part_of_d_u_dot_d_theta;
    let d_u_dot_d_phidot = sin_theta * v;
    let minus_air_velocity_2_sum = -(air_velocity_2_inv_product * d_w_dot_d_minus_air_sum_sum);
    let d_v_dot_d_u = air_velocity_1_inv_product * minus_air_velocity_2_sum - sin_theta_phidot;
    let C_D_air_velocity_12_sum_2 =
        C_D_air_velocity_12_product - air_velocity_2 * minus_air_velocity_2_sum;
    let inv_air_velocity_12_product_2 = inv_air_velocity_12 * C_D_air_velocity_12_sum_2;
    let minus_d_v_dot_d_minus_air_velocity_3 = air_velocity_2_inv_product * minus_d_w_dot_d_air_sum;
    let d_v_dot_d_w = cos_theta_phidot + minus_d_v_dot_d_minus_air_velocity_3;
    let cos_theta_minus_d_v_product = cos_theta * minus_d_v_dot_d_minus_air_velocity_3;
    let part_of_d_v_dot_d_phi =
        minus_d_minus_sin_phi_wind_y_sum_d_phi * cos_theta_minus_d_v_product;
    let sin_theta_air_velocity_1 = sin_theta * air_velocity_1;
    let minus_d_minus_sin_product =
        minus_d_minus_sin_phi_wind_y_sum_d_phi * sin_theta_air_velocity_1;
    let part_of_d_v_dot_d_phi_2 = minus_sin_phi_wind_y_sum * C_D_air_velocity_12_sum_2;
    let part_of_d_v_dot_d_phi_3 =
        minus_air_velocity_2_sum * minus_d_minus_sin_product - part_of_d_v_dot_d_phi_2;
    let d_v_dot_d_phi =
        part_of_d_v_dot_d_phi - cos_phi_g - inv_air_velocity_12 * part_of_d_v_dot_d_phi_3;
    let air_velocity_1_inv_product_2 = air_velocity_1_inv_product * d_air_velocity_1_d_theta;
    let part_of_d_v_dot_d_theta =
        minus_d_minus_air_velocity_3_d_theta * minus_d_v_dot_d_minus_air_velocity_3;
    let part_of_d_v_dot_d_theta_2 =
        minus_air_velocity_2_sum * air_velocity_1_inv_product_2 + part_of_d_v_dot_d_theta;
    let d_v_dot_d_theta = part_of_d_v_dot_d_theta_2 - x_dot * phidot;
    let minus_air_velocity_3_two = T::splat(2.0) * minus_air_velocity_3;
    let part_of_d_w_dot_d_V = minus_air_velocity_3_two * minus_air_velocity_product_2;
    let d_w_dot_d_V = inv_m_half_rho_A * minus_air_velocity_3_C_sum - part_of_d_w_dot_d_V;
    let part_of_d_w_dot_d_air_velocity =
        (d_w_dot_d_V - inv_V * two_C_Lp_plus_minus_product) * air_velocity_12_inv_V;
    let d_w_dot_d_air_velocity_12_2 = d_w_dot_d_air_velocity_12 + part_of_d_w_dot_d_air_velocity;
    let d_w_dot_d_air_velocity_1 = air_velocity_1_inv_product * d_w_dot_d_air_velocity_12_2;
    let d_w_dot_d_u = thetadot + d_w_dot_d_air_velocity_1;
    let d_w_dot_d_air_velocity_2 = air_velocity_2_inv_product * d_w_dot_d_air_velocity_12_2;
    let d_w_dot_d_v = d_w_dot_d_air_velocity_2 - cos_theta_phidot;
    let part_of_d_w_dot_d_minus_air = inv_V * minus_inv_V_C_Lp_plus_sum * air_velocity_12_V_product;
    let part_of_d_w_dot_d_minus_air_3 =
        d_w_dot_d_minus_air_velocity_3 - part_of_d_w_dot_d_minus_air;
    let part_of_d_w_dot_d_minus_air_2 =
        minus_air_velocity_3_inv_V * d_w_dot_d_V + two_C_Ds * inv_V * minus_air_velocity_product;
    let d_w_dot_d_minus_air_velocity_3_2 =
        part_of_d_w_dot_d_minus_air_3 + part_of_d_w_dot_d_minus_air_2;
    let air_velocity_2_product = air_velocity_2 * minus_sin_phi_wind_y_sum;
    let inv_air_velocity_12_product_3 = inv_air_velocity_12 * d_w_dot_d_air_velocity_12_2;
    let part_of_d_w_dot_d_phi =
        (air_velocity_2_product + minus_d_minus_sin_product) * inv_air_velocity_12_product_3;
    let part_of_d_w_dot_d_phi_2 =
        minus_d_minus_sin_phi_wind_y_sum_d_phi * d_w_dot_d_minus_air_velocity_3_2;
    let d_w_dot_d_phi = cos_theta * (sin_phi_g - part_of_d_w_dot_d_phi_2) - part_of_d_w_dot_d_phi;
    let part_of_d_w_dot_d_theta =
        minus_d_minus_air_velocity_3_d_theta * d_w_dot_d_minus_air_velocity_3_2;
    let part_of_d_w_dot_d_theta_2 =
        sin_theta_cos_phi_g_product + d_w_dot_d_air_velocity_12_2 * air_velocity_1_inv_product_2;
    let d_w_dot_d_theta = part_of_d_w_dot_d_theta_2 - part_of_d_w_dot_d_theta;
    let phidot_C_Mq = C_Mq * phidot;
    let sin_alpha_two_air_product = sin_alpha_two * air_velocity_2_inv_product;
    let C_Ms_inv_cos_theta_product = C_Ms * inv_cos_theta * sin_alpha_two_air_product;
    let half_rho_A_d_inv_product = half_rho_A_d_inv_I_d * air_velocity_12_two;
    let part_of_minus_minus_phidot_C_Mq =
        (C_Ms_inv_cos_theta_product - phidot_C_Mq) * half_rho_A_d_inv_product;
    let inv_air_velocity_12_product_4 = inv_air_velocity_12 * V_sq_half_rho_A_d_product_3;
    let part_of_minus_minus_phidot_C_Mq_2 =
        air_velocity_2_inv_product * inv_air_velocity_12_product_4;
    let V_sq_half_rho_A_d_product_4 = V_sq_half_rho_A_d_product * (cos_alpha_two * inv_V_sq);
    let air_velocity_2_inv_product_3 = air_velocity_2_inv_product * V_sq_half_rho_A_d_product_4;
    let part_of_minus_minus_phidot_C_Mq_3 =
        part_of_minus_minus_phidot_C_Mq_2 + minus_air_velocity_3_two * air_velocity_2_inv_product_3;
    let minus_minus_phidot_C_Mq_sum =
        inv_cos_theta * part_of_minus_minus_phidot_C_Mq_3 - part_of_minus_minus_phidot_C_Mq;
    let d_phidot_dot_d_air_velocity_1 = air_velocity_1_inv_product * minus_minus_phidot_C_Mq_sum;
    let minus_air_velocity_2_sum_2 =
        V_sq_half_rho_A_d_product_3 * inv_cos_theta - air_velocity_2 * minus_minus_phidot_C_Mq_sum;
    let inv_air_velocity_12_product_5 = inv_air_velocity_12 * minus_air_velocity_2_sum_2;
    let inv_cos_theta_air_product = inv_cos_theta * air_velocity_2_inv_product_3;
    let minus_C_Ms_inv_cos_sum =
        nonzero_air_velocity_12_sq * phidot_C_Mq - C_Ms_inv_cos_theta_product;
    let half_rho_A_d_inv_product_2 = half_rho_A_d_inv_I_d * minus_air_velocity_3_two;
    let part_of_minus_d_phidot_dot_d = minus_C_Ms_inv_cos_sum * half_rho_A_d_inv_product_2;
    let minus_d_phidot_dot_d_minus_air_velocity_3 =
        air_velocity_12_two * inv_cos_theta_air_product - part_of_minus_d_phidot_dot_d;
    let minus_air_velocity_product_4 = half_rho_A_d_inv_I_d * minus_air_velocity_3;
    let part_of_minus_C_Ms_inv_cos_sum_2 = minus_C_Ms_inv_cos_sum * minus_air_velocity_product_4;
    let minus_C_Ms_inv_cos_sum_2 =
        part_of_minus_C_Ms_inv_cos_sum_2 - air_velocity_12 * inv_cos_theta_air_product;
    let cos_theta_two = T::splat(2.0) * cos_theta;
    let minus_d_minus_sin_product_2 = minus_d_minus_sin_phi_wind_y_sum_d_phi * cos_theta_two;
    let part_of_minus_d_phidot_dot_d_phi = minus_minus_phidot_C_Mq_sum * minus_d_minus_sin_product;
    let part_of_minus_d_phidot_dot_d_phi_2 =
        part_of_minus_d_phidot_dot_d_phi - minus_sin_phi_wind_y_sum * minus_air_velocity_2_sum_2;
    let part_of_minus_d_phidot_dot_d_phi_3 =
        inv_air_velocity_12 * part_of_minus_d_phidot_dot_d_phi_2;
    let minus_d_phidot_dot_d_phi =
        minus_C_Ms_inv_cos_sum_2 * minus_d_minus_sin_product_2 + part_of_minus_d_phidot_dot_d_phi_3;
    let phidot_thetadot = phidot * thetadot;
    let thetadot_inv_I_d_I_a = inv_I_d_I_a * thetadot;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let part_of_d_minus_thetadot_r =
        (minus_thetadot_r_product - phidot * V_sq_half_rho_A_d_product_2) * sin_theta_inv_cos_theta;
    let part_of_d_minus_thetadot_r_2 = phidot * thetadot_inv_I_d_I_a - part_of_d_minus_thetadot_r;
    let d_minus_thetadot_r_product_d_theta =
        T::splat(2.0) * phidot_thetadot - part_of_d_minus_thetadot_r_2;
    let part_of_d_phidot_dot_d_theta = minus_minus_phidot_C_Mq_sum * air_velocity_1_inv_product_2;
    let two_minus_d_minus_product = T::splat(2.0) * minus_d_minus_air_velocity_3_d_theta;
    let part_of_d_phidot_dot_d_theta_2 =
        part_of_d_phidot_dot_d_theta - minus_C_Ms_inv_cos_sum_2 * two_minus_d_minus_product;
    let d_phidot_dot_d_theta = d_minus_thetadot_r_product_d_theta + part_of_d_phidot_dot_d_theta_2;
    let d_phidot_dot_d_phidot =
        inv_cos_theta * (sin_theta_two_thetadot_sum - sin_theta * thetadot_inv_I_d_I_a);
    let minus_r_inv_I_d_I_a_sum = phidot * sin_theta_two - r_inv_I_d_I_a;
    let d_phidot_dot_d_thetadot = inv_cos_theta * minus_r_inv_I_d_I_a_sum;
    let part_of_minus_d_thetadot_dot_d_2 =
        air_velocity_1_inv_product * inv_air_velocity_12_product_4;
    let air_velocity_1_inv_product_3 = air_velocity_1_inv_product * V_sq_half_rho_A_d_product_4;
    let thetadot_C_Mq = C_Mq * thetadot;
    let sin_alpha_two_air_product_2 = sin_alpha_two * air_velocity_1_inv_product;
    let C_Ms_sin_alpha_two_product = C_Ms * sin_alpha_two_air_product_2;
    let part_of_minus_d_thetadot_dot_d =
        (thetadot_C_Mq + C_Ms_sin_alpha_two_product) * half_rho_A_d_inv_product;
    let part_of_minus_d_thetadot_dot_d_3 =
        part_of_minus_d_thetadot_dot_d_2 + minus_air_velocity_3_two * air_velocity_1_inv_product_3;
    let minus_d_thetadot_dot_d_air_velocity_12 =
        part_of_minus_d_thetadot_dot_d_3 - part_of_minus_d_thetadot_dot_d;
    let V_sq_half_rho_A_d_sum =
        V_sq_half_rho_A_d_product_3 - air_velocity_1 * minus_d_thetadot_dot_d_air_velocity_12;
    let d_thetadot_dot_d_u = inv_air_velocity_12 * V_sq_half_rho_A_d_sum;
    let air_velocity_2_inv_product_4 =
        air_velocity_2_inv_product * minus_d_thetadot_dot_d_air_velocity_12;
    let C_Ms_sin_alpha_two_sum =
        C_Ms_sin_alpha_two_product + nonzero_air_velocity_12_sq * thetadot_C_Mq;
    let part_of_d_thetadot_dot_d_w = -(air_velocity_12_two * air_velocity_1_inv_product_3);
    let d_thetadot_dot_d_w =
        part_of_d_thetadot_dot_d_w - C_Ms_sin_alpha_two_sum * half_rho_A_d_inv_product_2;
    let part_of_C_Ms_sin_alpha_two_sum_2 = C_Ms_sin_alpha_two_sum * minus_air_velocity_product_4;
    let C_Ms_sin_alpha_two_sum_2 =
        part_of_C_Ms_sin_alpha_two_sum_2 + air_velocity_12 * air_velocity_1_inv_product_3;
    let part_of_d_thetadot_dot_d_phi =
        sin_theta * minus_d_minus_sin_phi_wind_y_sum_d_phi * V_sq_half_rho_A_d_sum;
    let part_of_d_thetadot_dot_d_phi_2 =
        minus_d_thetadot_dot_d_air_velocity_12 * air_velocity_2_product;
    let part_of_d_thetadot_dot_d_phi_3 =
        inv_air_velocity_12 * (part_of_d_thetadot_dot_d_phi_2 - part_of_d_thetadot_dot_d_phi);
    let d_thetadot_dot_d_phi =
        part_of_d_thetadot_dot_d_phi_3 - C_Ms_sin_alpha_two_sum_2 * minus_d_minus_sin_product_2;
    let part_of_d_thetadot_dot_d_theta_2 = C_Ms_sin_alpha_two_sum_2 * two_minus_d_minus_product;
    let cos_theta_phidot_product = minus_one_plus_inv_I_d_I_a * cos_theta_phidot;
    let part_of_d_thetadot_dot_d_theta =
        sin_theta * sin_theta_phidot_minus_sum + cos_theta * cos_theta_phidot_product;
    let part_of_d_thetadot_dot_d_theta_3 =
        d_air_velocity_1_d_theta * d_thetadot_dot_d_u - part_of_d_thetadot_dot_d_theta_2;
    let d_thetadot_dot_d_theta =
        part_of_d_thetadot_dot_d_theta_3 + phidot * part_of_d_thetadot_dot_d_theta;
    let d_thetadot_dot_d_phidot =
        sin_theta * cos_theta_phidot_product - cos_theta * sin_theta_phidot_minus_sum;
    let d_thetadot_dot_d_gammadot = inv_I_d_I_a * cos_theta_phidot;
    let sin_theta_air_product = sin_theta * air_velocity_1_inv_product;
    let minus_minus_phidot_product = minus_minus_phidot_C_Mq_sum * sin_theta_air_product;
    let d_gammadot_dot_d_v = sin_theta * inv_air_velocity_12_product_5;
    let d_gammadot_dot_d_w = minus_C_Ms_inv_cos_sum_2 * sin_theta_two;
    let d_gammadot_dot_d_phi = sin_theta * minus_d_phidot_dot_d_phi;
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * (minus_thetadot_r_product - C_Nr_inv_I_a * phidot);
    let d_gammadot_dot_d_theta =
        sin_theta * (phidot_thetadot - d_phidot_dot_d_theta) - part_of_d_gammadot_dot_d_theta;
    let d_gammadot_dot_d_phidot =
        sin_theta * (C_Nr_inv_I_a - d_phidot_dot_d_phidot) - cos_theta * thetadot;
    let d_gammadot_dot_d_thetadot =
        -cos_theta_phidot - minus_r_inv_I_d_I_a_sum * sin_theta_inv_cos_theta;
    let d_gammadot_dot_d_gammadot = sin_theta_inv_cos_theta * thetadot_inv_I_d_I_a + C_Nr_inv_I_a;
    let C_D_air_velocity_12_product_2 = C_D_air_velocity_12_sum * V_inv_m;
    let air_velocity_1_inv_product_4 = air_velocity_1_inv_product * C_D_air_velocity_12_product_2;
    let d_u_dot_d_m = inv_m_half_rho_A * air_velocity_1_inv_product_4;
    let inv_inv_s_stall_product_2 = inv_inv_s_stall_minus_sum * d_w_dot_d_C_D;
    let d_u_dot_d_C_Ls = sin_alpha_two_air_product_2 * inv_inv_s_stall_product_2;
    let one_minus_inv_inv_s_sum = T::splat(1.0) - inv_inv_s_stall_minus_sum;
    let one_minus_inv_inv_s_product = one_minus_inv_inv_s_sum * d_w_dot_d_C_D;
    let inv_s_stall_inv_inv_product_2 = inv_s_stall_inv_inv_product * inv_s_stall_minus_product_3;
    let minus_air_velocity_product_5 = minus_air_velocity_product * inv_s_stall_inv_inv_product_2;
    let minus_air_velocity_product_6 = minus_air_velocity_3_inv_V * minus_air_velocity_product_3;
    let d_u_dot_d_wind_x =
        cos_theta * inv_air_velocity_12_product - minus_d_w_dot_d_air_sum * sin_theta_air_product;
    let sin_theta_inv_air_sum =
        sin_theta * inv_air_velocity_12_product + minus_d_w_dot_d_air_product;
    let d_u_dot_d_wind_y = cos_phi * air_velocity_2_inv_product_2 + sin_phi * sin_theta_inv_air_sum;
    let d_u_dot_d_wind_z = sin_phi * air_velocity_2_inv_product_2 - cos_phi * sin_theta_inv_air_sum;
    let air_velocity_2_inv_product_5 = air_velocity_2_inv_product * C_D_air_velocity_12_product_2;
    let d_v_dot_d_m = inv_m_half_rho_A * air_velocity_2_inv_product_5;
    let d_v_dot_d_C_Ls = sin_alpha_two_air_product * inv_inv_s_stall_product_2;
    let part_of_d_v_dot_d_wind_x = -(minus_air_velocity_2_sum * cos_theta_air_product);
    let d_v_dot_d_wind_x =
        part_of_d_v_dot_d_wind_x - sin_theta * minus_d_v_dot_d_minus_air_velocity_3;
    let minus_air_velocity_sum =
        minus_air_velocity_2_sum * sin_theta_air_product - cos_theta_minus_d_v_product;
    let d_v_dot_d_wind_y =
        cos_phi * inv_air_velocity_12_product_2 - sin_phi * minus_air_velocity_sum;
    let d_v_dot_d_wind_z =
        sin_phi * inv_air_velocity_12_product_2 + cos_phi * minus_air_velocity_sum;
    let minus_air_velocity_product_7 = minus_air_velocity_3_C_sum * V_inv_m;
    let d_w_dot_d_C_Ls = air_velocity_12_V_product * inv_inv_s_stall_product;
    let part_of_d_w_dot_d_C_Lp =
        sin_alpha_two * one_minus_inv_inv_s_sum * air_velocity_12_V_product;
    let part_of_d_w_dot_d_s_stall =
        sin_alpha_two * minus_air_velocity_product_3 * inv_s_stall_inv_inv_product_2;
    let d_w_dot_d_C_Ds = minus_air_velocity_3_inv_V * minus_air_velocity_product;
    let part_of_d_w_dot_d_wind_x = d_w_dot_d_air_velocity_12_2 * cos_theta_air_product;
    let d_w_dot_d_wind_x = sin_theta * d_w_dot_d_minus_air_velocity_3_2 - part_of_d_w_dot_d_wind_x;
    let part_of_d_w_dot_d_wind_y = sin_phi * sin_theta_air_velocity_1 + cos_phi * air_velocity_2;
    let part_of_d_w_dot_d_wind_y_2 = part_of_d_w_dot_d_wind_y * inv_air_velocity_12_product_3;
    let d_w_dot_d_wind_y =
        -(cos_theta_sin_phi * d_w_dot_d_minus_air_velocity_3_2) - part_of_d_w_dot_d_wind_y_2;
    let part_of_d_w_dot_d_wind_z =
        d_minus_air_velocity_3_d_wind_z * d_w_dot_d_minus_air_velocity_3_2;
    let part_of_d_w_dot_d_wind_z_2 = cos_phi * sin_theta_air_velocity_1 - sin_phi * air_velocity_2;
    let d_w_dot_d_wind_z =
        part_of_d_w_dot_d_wind_z + part_of_d_w_dot_d_wind_z_2 * inv_air_velocity_12_product_3;
    let inv_I_d_r = inv_I_d * r;
    let thetadot_inv_cos_theta = thetadot * inv_cos_theta;
    let V_sq_minus_C_Ms_inv_cos_sum = V_sq * minus_C_Ms_inv_cos_sum;
    let part_of_d_phidot_dot_d_I_d =
        I_a * r * thetadot_inv_cos_theta - half_rho_A_d * V_sq_minus_C_Ms_inv_cos_sum;
    let d_phidot_dot_d_I_d = inv_I_d_sq * part_of_d_phidot_dot_d_I_d;
    let d_minus_thetadot_r_product_d_d = half_rho_A_inv_I_d * V_sq_minus_C_Ms_inv_cos_sum;
    let V_sq_half_rho_A_d_product_5 = V_sq_half_rho_A_d_inv_part * sin_alpha_two_air_product;
    let d_minus_thetadot_r_product_d_C_Mq = phidot * nonzero_air_product;
    let d_phidot_dot_d_wind_x =
        d_gammadot_dot_d_w - minus_minus_phidot_C_Mq_sum * cos_theta_air_product;
    let d_minus_thetadot_r_product_d_wind_y = cos_phi * inv_air_velocity_12_product_5;
    let minus_minus_phidot_sum =
        minus_minus_phidot_product + minus_C_Ms_inv_cos_sum_2 * cos_theta_two;
    let d_phidot_dot_d_wind_y =
        d_minus_thetadot_r_product_d_wind_y - sin_phi * minus_minus_phidot_sum;
    let d_minus_thetadot_r_product_d_wind_z = sin_phi * inv_air_velocity_12_product_5;
    let d_phidot_dot_d_wind_z =
        d_minus_thetadot_r_product_d_wind_z + cos_phi * minus_minus_phidot_sum;
    let d_thetadot_dot_d_I_a = cos_theta_phidot * inv_I_d_r;
    let V_sq_C_Ms_sin_alpha_two_sum = V_sq * C_Ms_sin_alpha_two_sum;
    let part_of_d_thetadot_dot_d_I_d = minus_inv_I_d_half_rho_sum * V_sq_C_Ms_sin_alpha_two_sum;
    let d_thetadot_dot_d_I_d = part_of_d_thetadot_dot_d_I_d - inv_I_d_r * d_thetadot_dot_d_gammadot;
    let d_thetadot_dot_d_d = half_rho_A_inv_I_d * V_sq_C_Ms_sin_alpha_two_sum;
    let d_thetadot_dot_d_C_Ms = V_sq_half_rho_A_d_inv_part * sin_alpha_two_air_product_2;
    let d_thetadot_dot_d_C_Mq = thetadot * nonzero_air_product;
    let d_thetadot_dot_d_wind_x =
        C_Ms_sin_alpha_two_sum_2 * sin_theta_two - cos_theta * d_thetadot_dot_d_u;
    let sin_theta_d_thetadot_sum =
        sin_theta * d_thetadot_dot_d_u + C_Ms_sin_alpha_two_sum_2 * cos_theta_two;
    let d_thetadot_dot_d_wind_y =
        cos_phi * air_velocity_2_inv_product_4 - sin_phi * sin_theta_d_thetadot_sum;
    let d_thetadot_dot_d_wind_z =
        sin_phi * air_velocity_2_inv_product_4 + cos_phi * sin_theta_d_thetadot_sum;
    let part_of_d_gammadot_dot_d_I_a =
        inv_I_d * thetadot * sin_theta_inv_cos_theta - inv_I_a_d_gammadot_dot_d_r;
    let d_gammadot_dot_d_I_a = r * part_of_d_gammadot_dot_d_I_a;
    let sin_theta_V_sq_product = sin_theta * V_sq_minus_C_Ms_inv_cos_sum;
    let d_gammadot_dot_d_C_Ms = sin_theta_inv_cos_theta * V_sq_half_rho_A_d_product_5;
    let d_gammadot_dot_d_C_Nr = inv_I_a * r;
    let minus_d_phidot_dot_d_wind_x = -d_phidot_dot_d_wind_x;
    let d_gammadot_dot_d_wind_x = sin_theta * minus_d_phidot_dot_d_wind_x;
    let minus_d_phidot_dot_d_wind_y = -d_phidot_dot_d_wind_y;
    let d_gammadot_dot_d_wind_y = sin_theta * minus_d_phidot_dot_d_wind_y;
    let d_gammadot_dot_d_wind_z = -(sin_theta * d_phidot_dot_d_wind_z);
    let d_y_dot_d_w = -cos_theta_sin_phi;
    let d_y_dot_d_phi = -z_dot;
    let d_z_dot_d_u = -d_air_velocity_1_d_wind_z;
    let d_z_dot_d_theta = -(x_dot * cos_phi);
    let d_u_dot_d_u = -inv_air_velocity_12_product;
    let d_u_dot_d_thetadot = -w;
    let d_v_dot_d_v = -inv_air_velocity_12_product_2;
    let d_w_dot_d_w = -d_w_dot_d_minus_air_velocity_3_2;
    let d_w_dot_d_phidot = -(cos_theta * v);
    let d_phidot_dot_d_v = -inv_air_velocity_12_product_5;
    let d_phidot_dot_d_phi = -minus_d_phidot_dot_d_phi;
    let d_phidot_dot_d_gammadot = -(inv_cos_theta * thetadot_inv_I_d_I_a);
    let d_thetadot_dot_d_v = -air_velocity_2_inv_product_4;
    let d_gammadot_dot_d_u = -minus_minus_phidot_product;
    let d_u_dot_d_C_D0 = -(air_velocity_1_inv_product * air_velocity_12_V_product);
    let d_u_dot_d_C_Ds = -(air_velocity_1_inv_product * minus_air_velocity_product_6);
    let d_v_dot_d_g = -sin_phi;
    let d_v_dot_d_C_D0 = -(air_velocity_2_inv_product * air_velocity_12_V_product);
    let d_v_dot_d_C_Ds = -(air_velocity_2_inv_product * minus_air_velocity_product_6);
    let d_w_dot_d_g = -d_minus_air_velocity_3_d_wind_z;
    let d_phidot_dot_d_I_a = -(inv_I_d_r * thetadot_inv_cos_theta);
    let d_phidot_dot_d_C_Ms = -(inv_cos_theta * V_sq_half_rho_A_d_product_5);
    let d_gammadot_dot_d_I_d = -(sin_theta * d_phidot_dot_d_I_d);
    let d_gammadot_dot_d_C_Mq = -(sin_theta_phidot * nonzero_air_product);

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
    j[10] = d_minus_air_velocity_3_d_wind_z; // d_z_dot_d_w
    j[11] = y_dot; // d_z_dot_d_phi
    j[12] = d_z_dot_d_theta;
    j[13] = d_u_dot_d_u;
    j[14] = d_u_dot_d_v;
    j[15] = d_u_dot_d_w;
    j[16] = d_u_dot_d_phi;
    j[17] = d_u_dot_d_theta;
    j[18] = d_u_dot_d_phidot;
    j[19] = d_u_dot_d_thetadot;
    j[20] = d_v_dot_d_u;
    j[21] = d_v_dot_d_v;
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
    j[36] = d_phidot_dot_d_air_velocity_1; // d_phidot_dot_d_u
    j[37] = d_phidot_dot_d_v;
    j[38] = minus_d_phidot_dot_d_minus_air_velocity_3; // d_phidot_dot_d_w
    j[39] = d_phidot_dot_d_phi;
    j[40] = d_phidot_dot_d_theta;
    j[41] = d_phidot_dot_d_phidot;
    j[42] = d_phidot_dot_d_thetadot;
    j[43] = d_phidot_dot_d_gammadot;
    j[44] = d_thetadot_dot_d_u;
    j[45] = d_thetadot_dot_d_v;
    j[46] = d_thetadot_dot_d_w;
    j[47] = d_thetadot_dot_d_phi;
    j[48] = d_thetadot_dot_d_theta;
    j[49] = d_thetadot_dot_d_phidot;
    j[50] = V_sq_half_rho_A_d_product_2; // d_thetadot_dot_d_thetadot
    j[51] = d_thetadot_dot_d_gammadot;
    j[52] = d_gammadot_dot_d_u;
    j[53] = d_gammadot_dot_d_v;
    j[54] = d_gammadot_dot_d_w;
    j[55] = d_gammadot_dot_d_phi;
    j[56] = d_gammadot_dot_d_theta;
    j[57] = d_gammadot_dot_d_phidot;
    j[58] = d_gammadot_dot_d_thetadot;
    j[59] = d_gammadot_dot_d_gammadot;

    jp[0] = d_u_dot_d_m;
    jp[1] = minus_rho_half * air_velocity_1_inv_product_4; // d_u_dot_d_A
    jp[2] = minus_A_half * air_velocity_1_inv_product_4; // d_u_dot_d_rho
    jp[3] = d_air_velocity_1_d_wind_z; // d_u_dot_d_g
    jp[4] = d_u_dot_d_C_Ls;
    jp[5] = sin_alpha_two_air_product_2 * one_minus_inv_inv_s_product; // d_u_dot_d_C_Lp
    jp[6] = sin_alpha_two_air_product_2 * minus_air_velocity_product_5; // d_u_dot_d_s_stall
    jp[7] = d_u_dot_d_C_D0;
    jp[8] = d_u_dot_d_C_Ds;
    jp[9] = d_u_dot_d_wind_x;
    jp[10] = d_u_dot_d_wind_y;
    jp[11] = d_u_dot_d_wind_z;
    jp[12] = d_v_dot_d_m;
    jp[13] = minus_rho_half * air_velocity_2_inv_product_5; // d_v_dot_d_A
    jp[14] = minus_A_half * air_velocity_2_inv_product_5; // d_v_dot_d_rho
    jp[15] = d_v_dot_d_g;
    jp[16] = d_v_dot_d_C_Ls;
    jp[17] = sin_alpha_two_air_product * one_minus_inv_inv_s_product; // d_v_dot_d_C_Lp
    jp[18] = sin_alpha_two_air_product * minus_air_velocity_product_5; // d_v_dot_d_s_stall
    jp[19] = d_v_dot_d_C_D0;
    jp[20] = d_v_dot_d_C_Ds;
    jp[21] = d_v_dot_d_wind_x;
    jp[22] = d_v_dot_d_wind_y;
    jp[23] = d_v_dot_d_wind_z;
    jp[24] = minus_half_rho_A_inv_m * minus_air_velocity_product_7; // d_w_dot_d_m
    jp[25] = rho_half * minus_air_velocity_product_7; // d_w_dot_d_A
    jp[26] = A_half * minus_air_velocity_product_7; // d_w_dot_d_rho
    jp[27] = d_w_dot_d_g;
    jp[28] = d_w_dot_d_C_Ls;
    jp[29] = part_of_d_w_dot_d_C_Lp; // d_w_dot_d_C_Lp
    jp[30] = part_of_d_w_dot_d_s_stall; // d_w_dot_d_s_stall
    jp[31] = d_w_dot_d_C_D; // d_w_dot_d_C_D0
    jp[32] = d_w_dot_d_C_Ds;
    jp[33] = d_w_dot_d_wind_x;
    jp[34] = d_w_dot_d_wind_y;
    jp[35] = d_w_dot_d_wind_z;
    jp[36] = d_phidot_dot_d_I_a;
    jp[37] = d_phidot_dot_d_I_d;
    jp[38] = d_minus_thetadot_r_product_d_d; // d_phidot_dot_d_d
    jp[39] = d_inv_I_d_rho_half * V_sq_minus_C_Ms_inv_cos_sum; // d_phidot_dot_d_A
    jp[40] = d_inv_I_d_A_half * V_sq_minus_C_Ms_inv_cos_sum; // d_phidot_dot_d_rho
    jp[41] = d_phidot_dot_d_C_Ms;
    jp[42] = d_minus_thetadot_r_product_d_C_Mq; // d_phidot_dot_d_C_Mq
    jp[43] = d_phidot_dot_d_wind_x;
    jp[44] = d_phidot_dot_d_wind_y;
    jp[45] = d_phidot_dot_d_wind_z;
    jp[46] = d_thetadot_dot_d_I_a;
    jp[47] = d_thetadot_dot_d_I_d;
    jp[48] = d_thetadot_dot_d_d;
    jp[49] = d_inv_I_d_rho_half * V_sq_C_Ms_sin_alpha_two_sum; // d_thetadot_dot_d_A
    jp[50] = d_inv_I_d_A_half * V_sq_C_Ms_sin_alpha_two_sum; // d_thetadot_dot_d_rho
    jp[51] = d_thetadot_dot_d_C_Ms;
    jp[52] = d_thetadot_dot_d_C_Mq;
    jp[53] = d_thetadot_dot_d_wind_x;
    jp[54] = d_thetadot_dot_d_wind_y;
    jp[55] = d_thetadot_dot_d_wind_z;
    jp[56] = d_gammadot_dot_d_I_a;
    jp[57] = d_gammadot_dot_d_I_d;
    jp[58] = minus_half_rho_A_inv_I_d * sin_theta_V_sq_product; // d_gammadot_dot_d_d
    jp[59] = minus_d_inv_I_d_rho_half * sin_theta_V_sq_product; // d_gammadot_dot_d_A
    jp[60] = minus_d_inv_I_d_A_half * sin_theta_V_sq_product; // d_gammadot_dot_d_rho
    jp[61] = d_gammadot_dot_d_C_Ms;
    jp[62] = d_gammadot_dot_d_C_Mq;
    jp[63] = d_gammadot_dot_d_C_Nr;
    jp[64] = d_gammadot_dot_d_wind_x;
    jp[65] = d_gammadot_dot_d_wind_y;
    jp[66] = d_gammadot_dot_d_wind_z;
}
