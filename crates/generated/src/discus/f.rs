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
    prepared: &[T; 29],
    dx: &mut [T; 12],
) {
    let phi = state[6];
    let (sin_phi, cos_phi) = phi.sin_cos();
    let theta = state[7];
    let (sin_theta, cos_theta) = theta.sin_cos();
    let phidot = state[9];
    let sin_theta_phidot = sin_theta * phidot;
    let g = parameters[6];
    let v = state[4];
    let cos_phi_g_plus_v_phidot = g.mul_add(cos_phi, v * phidot);
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let minus_sin_phi_wind_y_sum = wind_y.neg_mul_add(sin_phi, wind_z * cos_phi);

    // discus.hyz:84  let air_velocity = velocity - in_B(air);
    let air_velocity_2 = wind_y.neg_mul_add(cos_phi, wind_z.neg_mul_add(sin_phi, v));
    let gammadot = state[11];

    // discus.hyz:102  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let thetadot = state[10];
    let part_of_phidot_dot = T::splat(2.0) * sin_theta * thetadot;
    let w = state[5];
    let part_of_u_dot = sin_theta.mul_sub(cos_phi_g_plus_v_phidot, w * thetadot);
    let u = state[3];
    let sin_theta_u_minus_w_cos_sum = w.neg_mul_add(cos_theta, sin_theta * u);
    let wind_x = parameters[15];
    let minus_air_velocity_3 =
        cos_theta.mul_add(minus_sin_phi_wind_y_sum, wind_x.mul_sub(sin_theta, w));
    let inv_I_d_I_a = prepared[4];
    let r_inv_I_d_I_a = inv_I_d_I_a * r;

    // discus.hyz:64  position (x, y, z) in N;
    let y_dot = sin_theta_u_minus_w_cos_sum.mul_add(sin_phi, cos_phi * v);
    dx[1] = y_dot;
    let cos_theta_phidot = cos_theta * phidot;
    let air_velocity_1 =
        wind_x.neg_mul_add(cos_theta, sin_theta.mul_add(minus_sin_phi_wind_y_sum, u));
    let x_dot = cos_theta.mul_add(u, sin_theta * w);
    dx[0] = x_dot;
    let z_dot = sin_theta_u_minus_w_cos_sum.neg_mul_add(cos_phi, sin_phi * v);
    dx[2] = z_dot;
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);

    // discus.hyz:86  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let half_rho_A_d_inv_I_d = prepared[5];
    let V_sq_half_rho_A_d_inv_I_d = half_rho_A_d_inv_I_d * V_sq;

    // discus.hyz:91  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let sin_alpha_two = (T::splat(2.0) * alpha).sin_cos().0;
    let C_Mq = parameters[13];
    let V_sq_half_rho_A_d_product_2 = V_sq_half_rho_A_d_inv_I_d * (C_Mq * nonzero_air_velocity_12);
    let part_of_phidot_dot_2 = cos_theta.mul_add(V_sq_half_rho_A_d_product_2, part_of_phidot_dot);
    let part_of_phidot_dot_3 = phidot.mul_sub(part_of_phidot_dot_2, thetadot * r_inv_I_d_I_a);
    let inv_V = V.recip_or_zero();
    let inv_m_half_rho_A = prepared[2];
    let V_inv_m_half_rho_A = inv_m_half_rho_A * V;
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;
    let part_of_thetadot_dot = thetadot * V_sq_half_rho_A_d_product_2;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12;
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let inv_s_stall = prepared[0];
    let inv_s_stall_minus_product = inv_s_stall * minus_air_velocity_3_inv_V;
    let inv_s_stall_minus_product_sq = inv_s_stall_minus_product * inv_s_stall_minus_product;
    let inv_s_stall_minus_product_2 = inv_s_stall_minus_product_sq * inv_s_stall_minus_product_sq;
    let part_of_sin_alpha_two_C_Lp =
        inv_s_stall_minus_product_2.mul_add(inv_s_stall_minus_product_2, T::splat(1.0));
    let C_Lp = parameters[8];
    let minus_C_Lp_plus_C_Ls = prepared[1];
    let sin_alpha_two_C_Lp_product =
        sin_alpha_two * (C_Lp + minus_C_Lp_plus_C_Ls / part_of_sin_alpha_two_C_Lp);
    let C_Ms = parameters[12];
    let V_sq_half_rho_A_d_product = V_sq_half_rho_A_d_inv_I_d * (C_Ms * sin_alpha_two);
    let part_of_phidot_dot_4 =
        air_velocity_2_inv_product.neg_mul_add(V_sq_half_rho_A_d_product, part_of_phidot_dot_3);
    let part_of_thetadot_dot_2 =
        air_velocity_1_inv_product.mul_add(V_sq_half_rho_A_d_product, part_of_thetadot_dot);

    // discus.hyz:57  frame B = A turned theta about 2; // does not spin with the discus
    let thetadot_dot =
        cos_theta_phidot.neg_mul_add(sin_theta_phidot - r_inv_I_d_I_a, part_of_thetadot_dot_2);
    dx[10] = thetadot_dot;
    let phidot_dot = part_of_phidot_dot_4 / cos_theta;
    dx[9] = phidot_dot;
    let C_Ds = parameters[11];
    let C_D0 = parameters[10];

    // discus.hyz:97  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = minus_air_velocity_3_inv_V.mul_add(C_Ds * minus_air_velocity_3_inv_V, C_D0);
    let part_of_C_D_air_velocity_12 =
        minus_air_velocity_3.neg_mul_add(sin_alpha_two_C_Lp_product, C_D * air_velocity_12);
    let part_of_w_dot =
        air_velocity_12.mul_add(sin_alpha_two_C_Lp_product, minus_air_velocity_3 * C_D);
    let C_D_air_velocity_12_product = part_of_C_D_air_velocity_12 * V_inv_m_half_rho_A;
    let part_of_w_dot_2 = V_inv_m_half_rho_A.mul_add(part_of_w_dot, u * thetadot);
    let C_Nr_inv_I_a = prepared[6];
    let part_of_gammadot_dot = sin_theta.neg_mul_add(phidot_dot, C_Nr_inv_I_a * r);
    let minus_g = prepared[3];
    let part_of_v_dot =
        air_velocity_2_inv_product.neg_mul_add(C_D_air_velocity_12_product, minus_g * sin_phi);

    // discus.hyz:65  velocity (u, v, w) in B;
    let u_dot = air_velocity_1_inv_product.neg_mul_add(C_D_air_velocity_12_product, part_of_u_dot);
    dx[3] = u_dot;
    let w_dot = cos_theta.neg_mul_add(cos_phi_g_plus_v_phidot, part_of_w_dot_2);
    dx[5] = w_dot;

    // discus.hyz:58  frame C = B turned gamma about 3; // fixed in the discus
    let gammadot_dot = thetadot.neg_mul_add(cos_theta_phidot, part_of_gammadot_dot);
    dx[11] = gammadot_dot;
    let v_dot = phidot.neg_mul_add(sin_theta_u_minus_w_cos_sum, part_of_v_dot);
    dx[4] = v_dot;

    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
}
