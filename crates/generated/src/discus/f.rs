// Written by `hyzer generate`; changes belong in the model.
//! `discus`: derivatives of the states.

use lanes::Real;

/// Derivatives `dx` of the states.
///
/// 114 operations: 34 add, 67 mul, 4 div, 2 sqrt, 6 call, 1 select.
#[inline(always)]
pub fn f<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 33],
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
    let minus_p8_plus_p7 = prepared[0];
    let inv_p9 = prepared[1];
    let inv_p0_half_p5_p4 = prepared[2];
    let minus_p6 = prepared[3];
    let inv_p2_p1 = prepared[4];
    let half_p5_p4_p3_inv_p2 = prepared[5];
    let p14_inv_p1 = prepared[6];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // discus.hyz:63  position (x, y, z) in N;
    let x_dot = sin_theta * w + cos_theta * u;
    let sin_theta_u_minus_w_cos_sum = sin_theta * u - w * cos_theta;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let y_dot = sin_theta_u_minus_w_cos_sum * sin_phi + cos_phi * v;
    let z_dot = sin_phi * v - sin_theta_u_minus_w_cos_sum * cos_phi;
    let minus_sin_phi_wind_y_sum = wind_z * cos_phi - wind_y * sin_phi;

    // discus.hyz:70  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u + sin_theta * minus_sin_phi_wind_y_sum - wind_x * cos_theta;
    let air_velocity_2 = v - wind_z * sin_phi - wind_y * cos_phi;
    let air_velocity_2_sq_plus_sum =
        air_velocity_2 * air_velocity_2 + air_velocity_1 * air_velocity_1;
    let sqrt_air_velocity_2_sq_of = air_velocity_2_sq_plus_sum.sqrt();
    let inv_sqrt_air_velocity_2_of = sqrt_air_velocity_2_sq_of.recip_or_zero();
    let air_velocity_1_inv_product = air_velocity_1 * inv_sqrt_air_velocity_2_of;
    let minus_w_plus_sin_theta_sum = wind_x * sin_theta - w + cos_theta * minus_sin_phi_wind_y_sum;
    let minus_w_plus_sin_sum =
        minus_w_plus_sin_theta_sum * minus_w_plus_sin_theta_sum + air_velocity_2_sq_plus_sum;

    // discus.hyz:72  let V = norm(air_velocity);
    let V = minus_w_plus_sin_sum.sqrt();
    let inv_V = V.recip_or_zero();
    let minus_w_plus_sin_product = minus_w_plus_sin_theta_sum * inv_V;

    // discus.hyz:83  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = C_Ds * minus_w_plus_sin_product * minus_w_plus_sin_product + C_D0;

    // discus.hyz:77  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_w_plus_sin_theta_sum.atan2(sqrt_air_velocity_2_sq_of);
    let sin_alpha_two = (T::splat(2.0) * alpha).sin_cos().0;
    let inv_s_stall_minus_w_product = inv_p9 * minus_w_plus_sin_product;
    let inv_s_stall_minus_w_product_2 = inv_s_stall_minus_w_product * inv_s_stall_minus_w_product;
    let inv_s_stall_minus_w_product_3 =
        inv_s_stall_minus_w_product_2 * inv_s_stall_minus_w_product_2;
    let part_of_sin_alpha_two_C_Lp_product =
        inv_s_stall_minus_w_product_3 * inv_s_stall_minus_w_product_3 + T::splat(1.0);
    let sin_alpha_two_C_Lp_product =
        sin_alpha_two * (C_Lp + minus_p8_plus_p7 / part_of_sin_alpha_two_C_Lp_product);
    let part_of_C_D_sqrt_air_product =
        C_D * sqrt_air_velocity_2_sq_of - minus_w_plus_sin_theta_sum * sin_alpha_two_C_Lp_product;
    let V_inv_m_half_part_part = inv_p0_half_p5_p4 * V;
    let C_D_sqrt_air_product = part_of_C_D_sqrt_air_product * V_inv_m_half_part_part;
    let cos_phi_g_plus_v_phidot = g * cos_phi + v * phidot;
    let part_of_u_dot = sin_theta * cos_phi_g_plus_v_phidot - w * thetadot;

    // discus.hyz:64  velocity (u, v, w) in B;
    let u_dot = part_of_u_dot - air_velocity_1_inv_product * C_D_sqrt_air_product;
    let air_velocity_2_inv_product = air_velocity_2 * inv_sqrt_air_velocity_2_of;
    let part_of_v_dot = minus_p6 * sin_phi - air_velocity_2_inv_product * C_D_sqrt_air_product;
    let v_dot = part_of_v_dot - phidot * sin_theta_u_minus_w_cos_sum;
    let part_of_w_dot =
        minus_w_plus_sin_theta_sum * C_D + sqrt_air_velocity_2_sq_of * sin_alpha_two_C_Lp_product;
    let w_dot =
        u * thetadot + part_of_w_dot * V_inv_m_half_part_part - cos_theta * cos_phi_g_plus_v_phidot;
    let sin_theta_phidot = sin_theta * phidot;

    // discus.hyz:88  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let r_inv_I_d_I_a = inv_p2_p1 * r;
    let minus_w_plus_sin_product_2 = half_p5_p4_p3_inv_p2 * minus_w_plus_sin_sum;
    let minus_w_plus_sin_product_3 = minus_w_plus_sin_product_2 * (C_Ms * sin_alpha_two);
    let part_of_minus_thetadot_r_product_3 =
        air_velocity_2_inv_product * minus_w_plus_sin_product_3;
    let nonzero_air_velocity_2_of =
        air_velocity_2_sq_plus_sum.if_zero(T::splat(0.0), T::splat(1.0));
    let minus_w_plus_sin_product_4 =
        minus_w_plus_sin_product_2 * (C_Mq * nonzero_air_velocity_2_of);
    let part_of_minus_thetadot_r_product =
        T::splat(2.0) * sin_theta * thetadot + cos_theta * minus_w_plus_sin_product_4;
    let part_of_minus_thetadot_r_product_2 =
        phidot * part_of_minus_thetadot_r_product - thetadot * r_inv_I_d_I_a;
    let part_of_minus_thetadot_r_product_4 =
        part_of_minus_thetadot_r_product_2 - part_of_minus_thetadot_r_product_3;
    let minus_thetadot_r_product = part_of_minus_thetadot_r_product_4 / cos_theta;
    let part_of_thetadot_dot = air_velocity_1_inv_product * minus_w_plus_sin_product_3;
    let cos_theta_phidot = cos_theta * phidot;
    let part_of_thetadot_dot_2 = part_of_thetadot_dot + thetadot * minus_w_plus_sin_product_4;

    // discus.hyz:56  frame B = A turned theta about 2; // does not spin with the discus
    let thetadot_dot =
        part_of_thetadot_dot_2 - (sin_theta_phidot - r_inv_I_d_I_a) * cos_theta_phidot;

    // discus.hyz:57  frame C = B turned gamma about 3; // fixed in the discus
    let gammadot_dot =
        p14_inv_p1 * r - sin_theta * minus_thetadot_r_product - thetadot * cos_theta_phidot;

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
}
