// Written by `hyzer generate`; changes belong in the model.
//! `discus`: derivatives of the states.

use lanes::Real;

/// Derivatives `dx` of the states.
///
/// 114 operations: 34 add, 67 mul, 4 div, 2 sqrt, 6 call, 1 select.
/// `prepare` takes 13 operations for it.
#[inline(always)]
pub fn f<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 28],
    dx: &mut [T; 12],
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
    let minus_g = prepared[3];
    let inv_I_d_I_a = prepared[4];
    let half_rho_A_d_inv_I_d = prepared[5];
    let C_Nr_inv_I_a = prepared[6];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // discus.hyz:64  position (x, y, z) in N;
    let x_dot = sin_theta * w + cos_theta * u;
    let sin_theta_u_minus_w_cos_sum = sin_theta * u - w * cos_theta;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let y_dot = sin_theta_u_minus_w_cos_sum * sin_phi + cos_phi * v;
    let z_dot = sin_phi * v - sin_theta_u_minus_w_cos_sum * cos_phi;
    let minus_sin_phi_wind_y_sum = wind_z * cos_phi - wind_y * sin_phi;

    // discus.hyz:71  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u + sin_theta * minus_sin_phi_wind_y_sum - wind_x * cos_theta;
    let air_velocity_2 = v - wind_z * sin_phi - wind_y * cos_phi;
    let air_velocity_12_sq = air_velocity_2 * air_velocity_2 + air_velocity_1 * air_velocity_1;
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let minus_air_velocity_3 = wind_x * sin_theta - w + cos_theta * minus_sin_phi_wind_y_sum;
    let V_sq = minus_air_velocity_3 * minus_air_velocity_3 + air_velocity_12_sq;

    // discus.hyz:73  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let inv_V = V.recip_or_zero();
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;

    // discus.hyz:84  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = C_Ds * minus_air_velocity_3_inv_V * minus_air_velocity_3_inv_V + C_D0;

    // discus.hyz:78  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let sin_alpha_two = (T::splat(2.0) * alpha).sin_cos().0;
    let inv_s_stall_minus_product = inv_s_stall * minus_air_velocity_3_inv_V;
    let inv_s_stall_minus_product_sq = inv_s_stall_minus_product * inv_s_stall_minus_product;
    let inv_s_stall_minus_product_2 = inv_s_stall_minus_product_sq * inv_s_stall_minus_product_sq;
    let part_of_sin_alpha_two_C_Lp =
        inv_s_stall_minus_product_2 * inv_s_stall_minus_product_2 + T::splat(1.0);
    let sin_alpha_two_C_Lp_product =
        sin_alpha_two * (C_Lp + minus_C_Lp_plus_C_Ls / part_of_sin_alpha_two_C_Lp);
    let part_of_C_D_air_velocity_12 =
        C_D * air_velocity_12 - minus_air_velocity_3 * sin_alpha_two_C_Lp_product;
    let V_inv_m_half_rho_A = inv_m_half_rho_A * V;
    let C_D_air_velocity_12_product = part_of_C_D_air_velocity_12 * V_inv_m_half_rho_A;
    let part_of_u_dot = air_velocity_1_inv_product * C_D_air_velocity_12_product;
    let cos_phi_g_plus_v_phidot = g * cos_phi + v * phidot;

    // discus.hyz:65  velocity (u, v, w) in B;
    let u_dot = sin_theta * cos_phi_g_plus_v_phidot - w * thetadot - part_of_u_dot;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12;
    let part_of_v_dot =
        minus_g * sin_phi - air_velocity_2_inv_product * C_D_air_velocity_12_product;
    let v_dot = part_of_v_dot - phidot * sin_theta_u_minus_w_cos_sum;
    let part_of_w_dot = minus_air_velocity_3 * C_D + air_velocity_12 * sin_alpha_two_C_Lp_product;
    let w_dot =
        u * thetadot + part_of_w_dot * V_inv_m_half_rho_A - cos_theta * cos_phi_g_plus_v_phidot;
    let sin_theta_phidot = sin_theta * phidot;

    // discus.hyz:89  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let r_inv_I_d_I_a = inv_I_d_I_a * r;
    let V_sq_half_rho_A_d_inv_I_d = half_rho_A_d_inv_I_d * V_sq;
    let V_sq_half_rho_A_d_product = V_sq_half_rho_A_d_inv_I_d * (C_Ms * sin_alpha_two);
    let part_of_phidot_dot_2 = air_velocity_2_inv_product * V_sq_half_rho_A_d_product;
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let V_sq_half_rho_A_d_product_2 = V_sq_half_rho_A_d_inv_I_d * (C_Mq * nonzero_air_velocity_12);
    let part_of_phidot_dot =
        T::splat(2.0) * sin_theta * thetadot + cos_theta * V_sq_half_rho_A_d_product_2;
    let part_of_phidot_dot_3 =
        phidot * part_of_phidot_dot - thetadot * r_inv_I_d_I_a - part_of_phidot_dot_2;
    let phidot_dot = part_of_phidot_dot_3 / cos_theta;
    let part_of_thetadot_dot = air_velocity_1_inv_product * V_sq_half_rho_A_d_product;
    let cos_theta_phidot = cos_theta * phidot;
    let part_of_thetadot_dot_2 = part_of_thetadot_dot + thetadot * V_sq_half_rho_A_d_product_2;

    // discus.hyz:57  frame B = A turned theta about 2; // does not spin with the discus
    let thetadot_dot =
        part_of_thetadot_dot_2 - (sin_theta_phidot - r_inv_I_d_I_a) * cos_theta_phidot;

    // discus.hyz:58  frame C = B turned gamma about 3; // fixed in the discus
    let gammadot_dot = C_Nr_inv_I_a * r - sin_theta * phidot_dot - thetadot * cos_theta_phidot;

    dx[0] = x_dot;
    dx[1] = y_dot;
    dx[2] = z_dot;
    dx[3] = u_dot;
    dx[4] = v_dot;
    dx[5] = w_dot;
    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    dx[9] = phidot_dot;
    dx[10] = thetadot_dot;
    dx[11] = gammadot_dot;
}
