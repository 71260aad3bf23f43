// Written by `hyzer generate`; changes belong in the model.
//! `disc`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 339 operations: 103 add, 212 mul, 3 div, 13 neg, 2 sqrt, 5 call, 1 select.
/// `prepare` takes 13 operations for it.
#[inline(always)]
pub fn f_jac<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 21],
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
    let inv_m_half_rho_A = prepared[0];
    let half_rho_A_d_inv_I_d = prepared[2];
    let inv_I_d_I_a = prepared[3];
    let C_Nr_inv_I_a = prepared[4];
    let minus_wind_y = prepared[5];
    let C_Da_two = prepared[6];
    let two_d_half_rho_A_inv_I_d = prepared[7];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // disc.hyz:55  position (x, y, z) in N;
    let x_dot = u * cos_theta + w * sin_theta;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let minus_sin_theta_u_minus_w_cos_sum_2 = cos_theta * w - u * sin_theta;
    let y_dot = v * cos_phi - sin_phi * minus_sin_theta_u_minus_w_cos_sum_2;
    let z_dot = cos_phi * minus_sin_theta_u_minus_w_cos_sum_2 + v * sin_phi;
    let cos_phi_g = g * cos_phi;
    let cos_phi_g_plus_v_phidot = v * phidot + cos_phi_g;
    let sin_theta_cos_phi_g_product = sin_theta * cos_phi_g_plus_v_phidot;
    let sin_phi_wind_y_sum = wind_y * sin_phi - wind_z * cos_phi;
    let d_minus_air_velocity_3_d_theta = wind_x * cos_theta + sin_theta * sin_phi_wind_y_sum;

    // disc.hyz:62  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u - d_minus_air_velocity_3_d_theta;
    let d_minus_sin_phi_wind_y_sum_d_phi = minus_wind_y * cos_phi - wind_z * sin_phi;
    let air_velocity_2 = v + d_minus_sin_phi_wind_y_sum_d_phi;
    let air_velocity_12_sq = air_velocity_1 * air_velocity_1 + air_velocity_2 * air_velocity_2;
    let d_air_velocity_1_d_theta = wind_x * sin_theta - cos_theta * sin_phi_wind_y_sum;
    let minus_air_velocity_3 = d_air_velocity_1_d_theta - w;
    let V_sq = air_velocity_12_sq + minus_air_velocity_3 * minus_air_velocity_3;

    // disc.hyz:64  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let V_inv_m_half_rho_A = inv_m_half_rho_A * V;
    let air_velocity_12 = air_velocity_12_sq.sqrt();

    // disc.hyz:69  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);

    // disc.hyz:72  let C_L = C_L0 + C_La*alpha;
    let C_L = C_L0 + C_La * alpha;

    // disc.hyz:73  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_D0 + C_Da * alpha * alpha;
    let air_velocity_12_C_D_sum = air_velocity_12 * C_D - minus_air_velocity_3 * C_L;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let air_velocity_12_C_D_product = air_velocity_12_C_D_sum * inv_air_velocity_12;
    let V_inv_m_half_rho_A_product = V_inv_m_half_rho_A * air_velocity_12_C_D_product;
    let part_of_u_dot = sin_theta_cos_phi_g_product - air_velocity_1 * V_inv_m_half_rho_A_product;

    // disc.hyz:56  velocity (u, v, w) in B;
    let u_dot = part_of_u_dot - w * thetadot;
    let sin_phi_g = g * sin_phi;
    let part_of_v_dot =
        minus_sin_theta_u_minus_w_cos_sum_2 * phidot - air_velocity_2 * V_inv_m_half_rho_A_product;
    let v_dot = part_of_v_dot - sin_phi_g;
    let cos_theta_cos_phi_g_product = cos_theta * cos_phi_g_plus_v_phidot;
    let minus_air_velocity_3_C_sum = air_velocity_12 * C_L + minus_air_velocity_3 * C_D;
    let part_of_w_dot =
        V_inv_m_half_rho_A * minus_air_velocity_3_C_sum - cos_theta_cos_phi_g_product;
    let w_dot = part_of_w_dot + u * thetadot;
    let sin_theta_phidot = sin_theta * phidot;

    // disc.hyz:78  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let r_inv_I_d_I_a = inv_I_d_I_a * r;
    let r_inv_I_d_I_a_minus_sin_sum = r_inv_I_d_I_a - T::splat(2.0) * sin_theta_phidot;
    let V_sq_half_rho_A_d_inv_part = half_rho_A_d_inv_I_d * V_sq;
    let alpha_C_Ma = C_Ma * alpha;
    let r_C_Rr = C_Rr * r;
    let air_velocity_1_r_C_Rr_sum = air_velocity_1 * r_C_Rr - air_velocity_2 * alpha_C_Ma;
    let inv_air_velocity_12_product = inv_air_velocity_12 * air_velocity_1_r_C_Rr_sum;
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let nonzero_air_velocity_12_C_Mq = C_Mq * nonzero_air_velocity_12;
    let cos_theta_phidot = cos_theta * phidot;
    let cos_theta_phidot_sum =
        inv_air_velocity_12_product + nonzero_air_velocity_12_C_Mq * cos_theta_phidot;
    let cos_theta_phidot_sum_2 =
        V_sq_half_rho_A_d_inv_part * cos_theta_phidot_sum - thetadot * r_inv_I_d_I_a_minus_sin_sum;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let cos_theta_phidot_product = cos_theta_phidot_sum_2 * inv_cos_theta;
    let air_velocity_2_r_C_Rr_sum = air_velocity_1 * alpha_C_Ma + air_velocity_2 * r_C_Rr;
    let inv_air_velocity_12_product_2 = inv_air_velocity_12 * air_velocity_2_r_C_Rr_sum;
    let thetadot_nonzero_sum =
        inv_air_velocity_12_product_2 + thetadot * nonzero_air_velocity_12_C_Mq;
    let part_of_thetadot_dot = V_sq_half_rho_A_d_inv_part * thetadot_nonzero_sum;
    let sin_theta_phidot_minus_sum = sin_theta_phidot - r_inv_I_d_I_a;

    // disc.hyz:48  frame B = A turned theta about 2; // does not spin with the disc
    let thetadot_dot = part_of_thetadot_dot - cos_theta_phidot * sin_theta_phidot_minus_sum;

    // disc.hyz:49  frame C = B turned gamma about 3; // fixed in the disc
    let gammadot_dot =
        C_Nr_inv_I_a * r - thetadot * cos_theta_phidot - sin_theta * cos_theta_phidot_product;
    let d_y_dot_d_u = sin_theta * sin_phi;
    let d_y_dot_d_phi = -z_dot;
    let d_y_dot_d_theta = x_dot * sin_phi;
    let d_z_dot_d_w = cos_theta * cos_phi;
    let part_of_V_inv_m_half_rho_A_sum =
        V_inv_m_half_rho_A * inv_air_velocity_12 * (air_velocity_12_C_D_product - C_D);
    let inv_V = V.recip_or_zero();
    let air_velocity_12_C_D_product_2 = inv_m_half_rho_A * air_velocity_12_C_D_sum;
    let part_of_V_inv_m_half_rho_A_sum_2 = C_La * minus_air_velocity_3 * inv_air_velocity_12;
    let alpha_C_Da_two = C_Da_two * alpha;
    let part_of_V_inv_m_half_rho_A_sum_3 =
        part_of_V_inv_m_half_rho_A_sum_2 - nonzero_air_velocity_12 * alpha_C_Da_two;
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;
    let part_of_V_inv_m_half_rho_A_sum_4 =
        V_inv_m_half_rho_A * part_of_V_inv_m_half_rho_A_sum_3 * minus_air_velocity_3_inv_V;
    let part_of_V_inv_m_half_rho_A_sum_5 =
        nonzero_air_velocity_12 * air_velocity_12_C_D_product_2 + part_of_V_inv_m_half_rho_A_sum_4;
    let V_inv_m_half_rho_A_sum =
        part_of_V_inv_m_half_rho_A_sum - inv_V * part_of_V_inv_m_half_rho_A_sum_5;
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let V_inv_m_half_rho_A_product_2 = V_inv_m_half_rho_A_sum * air_velocity_1_inv_product;
    let d_u_dot_d_air_velocity_1 =
        air_velocity_1 * V_inv_m_half_rho_A_product_2 - V_inv_m_half_rho_A_product;
    let air_velocity_2_V_product = air_velocity_2 * V_inv_m_half_rho_A_product_2;
    let d_u_dot_d_v = sin_theta_phidot + air_velocity_2_V_product;
    let inv_V_sq = inv_V * inv_V;
    let air_velocity_12_inv_V_sq = air_velocity_12 * inv_V_sq;
    let part_of_minus_part_part_air_sum =
        V_inv_m_half_rho_A * part_of_V_inv_m_half_rho_A_sum_3 * air_velocity_12_inv_V_sq;
    let part_of_minus_part_part_air_sum_2 =
        minus_air_velocity_3_inv_V * air_velocity_12_C_D_product_2 - C_L * V_inv_m_half_rho_A;
    let minus_part_part_air_sum =
        inv_air_velocity_12 * part_of_minus_part_part_air_sum_2 - part_of_minus_part_part_air_sum;
    let air_velocity_1_product = air_velocity_1 * minus_part_part_air_sum;
    let d_u_dot_d_w = air_velocity_1_product - thetadot;
    let part_of_d_u_dot_d_phi =
        d_u_dot_d_air_velocity_1 * d_minus_sin_phi_wind_y_sum_d_phi - sin_phi_g;
    let cos_theta_minus_product = cos_theta * minus_part_part_air_sum;
    let part_of_d_u_dot_d_phi_2 = d_minus_sin_phi_wind_y_sum_d_phi * cos_theta_minus_product;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12;
    let V_inv_m_half_rho_A_product_3 = V_inv_m_half_rho_A_sum * air_velocity_2_inv_product;
    let part_of_d_u_dot_d_phi_3 =
        part_of_d_u_dot_d_phi_2 - sin_phi_wind_y_sum * V_inv_m_half_rho_A_product_3;
    let d_u_dot_d_phi =
        sin_theta * part_of_d_u_dot_d_phi - air_velocity_1 * part_of_d_u_dot_d_phi_3;
    let part_of_d_u_dot_d_theta =
        cos_theta_cos_phi_g_product + d_u_dot_d_air_velocity_1 * d_air_velocity_1_d_theta;
    let d_u_dot_d_theta =
        part_of_d_u_dot_d_theta - air_velocity_1_product * d_minus_air_velocity_3_d_theta;
    let d_u_dot_d_phidot = sin_theta * v;
    let d_v_dot_d_u = air_velocity_2_V_product - sin_theta_phidot;
    let d_v_dot_d_air_velocity_2 =
        air_velocity_2 * V_inv_m_half_rho_A_product_3 - V_inv_m_half_rho_A_product;
    let d_v_dot_d_w = cos_theta_phidot + air_velocity_2 * minus_part_part_air_sum;
    let part_of_d_v_dot_d_phi = cos_theta_minus_product - sin_theta * V_inv_m_half_rho_A_product_2;
    let part_of_d_v_dot_d_phi_2 =
        air_velocity_2 * d_minus_sin_phi_wind_y_sum_d_phi * part_of_d_v_dot_d_phi;
    let d_v_dot_d_phi =
        sin_phi_wind_y_sum * d_v_dot_d_air_velocity_2 - cos_phi_g - part_of_d_v_dot_d_phi_2;
    let part_of_d_v_dot_d_theta = minus_part_part_air_sum * d_minus_air_velocity_3_d_theta;
    let part_of_d_v_dot_d_theta_2 =
        d_air_velocity_1_d_theta * V_inv_m_half_rho_A_product_2 - part_of_d_v_dot_d_theta;
    let d_v_dot_d_theta = air_velocity_2 * part_of_d_v_dot_d_theta_2 - x_dot * phidot;
    let C_La_air_velocity_12_sum = C_La * air_velocity_12 + minus_air_velocity_3 * alpha_C_Da_two;
    let part_of_d_w_dot_d_air_velocity =
        V_inv_m_half_rho_A * (C_L - minus_air_velocity_3 * C_La_air_velocity_12_sum * inv_V_sq);
    let minus_air_velocity_product = inv_m_half_rho_A * minus_air_velocity_3_C_sum;
    let d_w_dot_d_air_velocity_12 =
        part_of_d_w_dot_d_air_velocity + air_velocity_12 * inv_V * minus_air_velocity_product;
    let d_w_dot_d_air_velocity_1 = d_w_dot_d_air_velocity_12 * air_velocity_1_inv_product;
    let d_w_dot_d_u = thetadot + d_w_dot_d_air_velocity_1;
    let d_w_dot_d_air_velocity_2 = d_w_dot_d_air_velocity_12 * air_velocity_2_inv_product;
    let d_w_dot_d_v = d_w_dot_d_air_velocity_2 - cos_theta_phidot;
    let part_of_d_w_dot_d_minus_air =
        V_inv_m_half_rho_A * (C_D + C_La_air_velocity_12_sum * air_velocity_12_inv_V_sq);
    let d_w_dot_d_minus_air_velocity_3 =
        part_of_d_w_dot_d_minus_air + minus_air_velocity_3_inv_V * minus_air_velocity_product;
    let sin_theta_d_minus_product = sin_theta * d_minus_sin_phi_wind_y_sum_d_phi;
    let part_of_d_w_dot_d_phi =
        air_velocity_1 * sin_theta_d_minus_product + air_velocity_2 * sin_phi_wind_y_sum;
    let part_of_d_w_dot_d_phi_2 =
        inv_air_velocity_12 * d_w_dot_d_air_velocity_12 * part_of_d_w_dot_d_phi;
    let part_of_d_w_dot_d_phi_3 = d_minus_sin_phi_wind_y_sum_d_phi * d_w_dot_d_minus_air_velocity_3;
    let d_w_dot_d_phi = part_of_d_w_dot_d_phi_2 + cos_theta * (sin_phi_g + part_of_d_w_dot_d_phi_3);
    let part_of_d_w_dot_d_theta =
        sin_theta_cos_phi_g_product + d_air_velocity_1_d_theta * d_w_dot_d_air_velocity_1;
    let d_w_dot_d_theta =
        part_of_d_w_dot_d_theta + d_minus_air_velocity_3_d_theta * d_w_dot_d_minus_air_velocity_3;
    let C_Ma_inv_V_sq = C_Ma * inv_V_sq;
    let air_velocity_2_C_Ma_inv_V_sq = air_velocity_2 * C_Ma_inv_V_sq;
    let part_of_minus_inv_air_velocity =
        inv_air_velocity_12_product - minus_air_velocity_3 * air_velocity_2_C_Ma_inv_V_sq;
    let inv_air_velocity_12_product_3 = inv_air_velocity_12 * V_sq_half_rho_A_d_inv_part;
    let part_of_minus_inv_air_velocity_2 =
        part_of_minus_inv_air_velocity * inv_air_velocity_12_product_3;
    let air_velocity_12_two_product = two_d_half_rho_A_inv_I_d * air_velocity_12;
    let minus_inv_air_velocity_sum =
        cos_theta_phidot_sum * air_velocity_12_two_product - part_of_minus_inv_air_velocity_2;
    let V_sq_half_rho_A_d_product = V_sq_half_rho_A_d_inv_part * r_C_Rr;
    let air_velocity_1_product_sum =
        air_velocity_1 * minus_inv_air_velocity_sum + V_sq_half_rho_A_d_product;
    let inv_air_velocity_12_product_4 = inv_air_velocity_12 * inv_cos_theta;
    let d_cos_theta_phidot_product_d_u = air_velocity_1_product_sum * inv_air_velocity_12_product_4;
    let V_sq_half_rho_A_d_product_2 = V_sq_half_rho_A_d_inv_part * alpha_C_Ma;
    let minus_air_velocity_2_sum =
        V_sq_half_rho_A_d_product_2 - air_velocity_2 * minus_inv_air_velocity_sum;
    let part_of_V_sq_half_rho_A_d_sum = V_sq_half_rho_A_d_inv_part * air_velocity_2_C_Ma_inv_V_sq;
    let minus_air_velocity_product_2 = two_d_half_rho_A_inv_I_d * minus_air_velocity_3;
    let V_sq_half_rho_A_d_sum =
        part_of_V_sq_half_rho_A_d_sum - cos_theta_phidot_sum * minus_air_velocity_product_2;
    let d_cos_theta_phidot_product_d_w = inv_cos_theta * V_sq_half_rho_A_d_sum;
    let part_of_d_cos_theta_phidot = air_velocity_1_product_sum * sin_theta_d_minus_product;
    let part_of_d_cos_theta_phidot_2 =
        part_of_d_cos_theta_phidot - sin_phi_wind_y_sum * minus_air_velocity_2_sum;
    let part_of_d_cos_theta_phidot_3 = part_of_d_cos_theta_phidot_2 * inv_air_velocity_12_product_4;
    let d_cos_theta_phidot_product_d_phi =
        part_of_d_cos_theta_phidot_3 - d_minus_sin_phi_wind_y_sum_d_phi * V_sq_half_rho_A_d_sum;
    let V_sq_half_rho_A_d_product_3 = C_Rr * V_sq_half_rho_A_d_inv_part;
    let d_cos_theta_phidot_sum_2_d_r =
        air_velocity_1_inv_product * V_sq_half_rho_A_d_product_3 - inv_I_d_I_a * thetadot;
    let d_cos_theta_phidot_sum_sum = d_cos_theta_phidot_sum_2_d_r + T::splat(2.0) * thetadot;
    let inv_air_velocity_12_product_5 = inv_air_velocity_12 * d_air_velocity_1_d_theta;
    let part_of_d_cos_theta_phidot_5 = air_velocity_1_product_sum * inv_air_velocity_12_product_5;
    let d_thetadot_dot_d_thetadot = V_sq_half_rho_A_d_inv_part * nonzero_air_velocity_12_C_Mq;
    let part_of_d_cos_theta_phidot_4 =
        sin_theta * (cos_theta_phidot_product - phidot * d_thetadot_dot_d_thetadot);
    let part_of_d_cos_theta_phidot_6 =
        part_of_d_cos_theta_phidot_5 - d_minus_air_velocity_3_d_theta * V_sq_half_rho_A_d_sum;
    let part_of_d_cos_theta_phidot_7 =
        inv_cos_theta * (part_of_d_cos_theta_phidot_6 + part_of_d_cos_theta_phidot_4);
    let d_cos_theta_phidot_product_d_theta =
        phidot * d_cos_theta_phidot_sum_sum + part_of_d_cos_theta_phidot_7;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let d_cos_theta_phidot_product_d_phidot =
        d_cos_theta_phidot_sum_sum * sin_theta_inv_cos_theta + d_thetadot_dot_d_thetadot;
    let d_phidot_dot_d_gammadot = inv_cos_theta * d_cos_theta_phidot_sum_2_d_r;
    let air_velocity_1_C_Ma_inv_V_sq = air_velocity_1 * C_Ma_inv_V_sq;
    let part_of_d_thetadot_dot_d_air =
        inv_air_velocity_12_product_2 + minus_air_velocity_3 * air_velocity_1_C_Ma_inv_V_sq;
    let part_of_d_thetadot_dot_d_air_2 =
        part_of_d_thetadot_dot_d_air * inv_air_velocity_12_product_3;
    let d_thetadot_dot_d_air_velocity_12 =
        thetadot_nonzero_sum * air_velocity_12_two_product - part_of_d_thetadot_dot_d_air_2;
    let V_sq_half_rho_A_d_sum_2 =
        V_sq_half_rho_A_d_product_2 + air_velocity_1 * d_thetadot_dot_d_air_velocity_12;
    let d_thetadot_dot_d_air_velocity_1 = inv_air_velocity_12 * V_sq_half_rho_A_d_sum_2;
    let V_sq_half_rho_A_d_sum_3 =
        V_sq_half_rho_A_d_product + air_velocity_2 * d_thetadot_dot_d_air_velocity_12;
    let d_thetadot_dot_d_air_velocity_2 = inv_air_velocity_12 * V_sq_half_rho_A_d_sum_3;
    let part_of_V_sq_half_rho_A_d_sum_4 = V_sq_half_rho_A_d_inv_part * air_velocity_1_C_Ma_inv_V_sq;
    let V_sq_half_rho_A_d_sum_4 =
        part_of_V_sq_half_rho_A_d_sum_4 + thetadot_nonzero_sum * minus_air_velocity_product_2;
    let part_of_d_thetadot_dot_d_phi =
        cos_theta * d_minus_sin_phi_wind_y_sum_d_phi * V_sq_half_rho_A_d_sum_4;
    let part_of_d_thetadot_dot_d_phi_2 = V_sq_half_rho_A_d_sum_2 * sin_theta_d_minus_product;
    let part_of_d_thetadot_dot_d_phi_3 =
        part_of_d_thetadot_dot_d_phi_2 + sin_phi_wind_y_sum * V_sq_half_rho_A_d_sum_3;
    let d_thetadot_dot_d_phi =
        part_of_d_thetadot_dot_d_phi + inv_air_velocity_12 * part_of_d_thetadot_dot_d_phi_3;
    let part_of_d_thetadot_dot_d_theta_2 = d_minus_air_velocity_3_d_theta * V_sq_half_rho_A_d_sum_4;
    let d_thetadot_dot_d_r =
        air_velocity_2_inv_product * V_sq_half_rho_A_d_product_3 + inv_I_d_I_a * cos_theta_phidot;
    let d_thetadot_dot_d_sin_theta_phidot = d_thetadot_dot_d_r - cos_theta_phidot;
    let part_of_d_thetadot_dot_d_theta =
        sin_theta * sin_theta_phidot_minus_sum + cos_theta * d_thetadot_dot_d_sin_theta_phidot;
    let part_of_d_thetadot_dot_d_theta_3 =
        V_sq_half_rho_A_d_sum_2 * inv_air_velocity_12_product_5 + part_of_d_thetadot_dot_d_theta_2;
    let d_thetadot_dot_d_theta =
        part_of_d_thetadot_dot_d_theta_3 + phidot * part_of_d_thetadot_dot_d_theta;
    let d_thetadot_dot_d_phidot =
        sin_theta * d_thetadot_dot_d_sin_theta_phidot - cos_theta * sin_theta_phidot_minus_sum;
    let inv_air_velocity_12_product_6 = inv_air_velocity_12 * sin_theta_inv_cos_theta;
    let d_gammadot_dot_d_v = minus_air_velocity_2_sum * inv_air_velocity_12_product_6;
    let part_of_d_gammadot_dot_d_theta_2 =
        cos_theta * (C_Nr_inv_I_a * phidot - cos_theta_phidot_product);
    let part_of_d_gammadot_dot_d_theta =
        sin_theta * (d_cos_theta_phidot_product_d_theta - phidot * thetadot);
    let d_gammadot_dot_d_theta = part_of_d_gammadot_dot_d_theta_2 - part_of_d_gammadot_dot_d_theta;
    let d_gammadot_dot_d_phidot =
        sin_theta * (C_Nr_inv_I_a - d_cos_theta_phidot_product_d_phidot) - cos_theta * thetadot;
    let d_gammadot_dot_d_thetadot =
        r_inv_I_d_I_a_minus_sin_sum * sin_theta_inv_cos_theta - cos_theta_phidot;
    let d_gammadot_dot_d_gammadot =
        C_Nr_inv_I_a - d_cos_theta_phidot_sum_2_d_r * sin_theta_inv_cos_theta;
    let d_y_dot_d_w = -(cos_theta * sin_phi);
    let d_z_dot_d_u = -(sin_theta * cos_phi);
    let d_z_dot_d_theta = -(x_dot * cos_phi);
    let d_u_dot_d_thetadot = -w;
    let d_w_dot_d_w = -d_w_dot_d_minus_air_velocity_3;
    let d_w_dot_d_phidot = -(cos_theta * v);
    let d_phidot_dot_d_v = -(minus_air_velocity_2_sum * inv_air_velocity_12_product_4);
    let d_phidot_dot_d_thetadot = -(r_inv_I_d_I_a_minus_sin_sum * inv_cos_theta);
    let d_thetadot_dot_d_w = -V_sq_half_rho_A_d_sum_4;
    let d_gammadot_dot_d_u = -(air_velocity_1_product_sum * inv_air_velocity_12_product_6);
    let d_gammadot_dot_d_w = -(V_sq_half_rho_A_d_sum * sin_theta_inv_cos_theta);
    let d_gammadot_dot_d_phi = -(sin_theta * d_cos_theta_phidot_product_d_phi);

    dx[0] = x_dot;
    dx[1] = y_dot;
    dx[2] = z_dot;
    dx[3] = u_dot;
    dx[4] = v_dot;
    dx[5] = w_dot;
    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    dx[9] = cos_theta_phidot_product;
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
    j[36] = d_cos_theta_phidot_product_d_u; // d_phidot_dot_d_u
    j[37] = d_phidot_dot_d_v;
    j[38] = d_cos_theta_phidot_product_d_w; // d_phidot_dot_d_w
    j[39] = d_cos_theta_phidot_product_d_phi; // d_phidot_dot_d_phi
    j[40] = d_cos_theta_phidot_product_d_theta; // d_phidot_dot_d_theta
    j[41] = d_cos_theta_phidot_product_d_phidot; // d_phidot_dot_d_phidot
    j[42] = d_phidot_dot_d_thetadot;
    j[43] = d_phidot_dot_d_gammadot;
    j[44] = d_thetadot_dot_d_air_velocity_1; // d_thetadot_dot_d_u
    j[45] = d_thetadot_dot_d_air_velocity_2; // d_thetadot_dot_d_v
    j[46] = d_thetadot_dot_d_w;
    j[47] = d_thetadot_dot_d_phi;
    j[48] = d_thetadot_dot_d_theta;
    j[49] = d_thetadot_dot_d_phidot;
    j[50] = d_thetadot_dot_d_thetadot;
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
