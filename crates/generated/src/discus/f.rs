// Written by `hyzer generate`; changes belong in the model.
//! `discus`: derivatives of the states.

use lanes::Real;

/// Derivatives `dx` of the states.
///
/// 123 operations: 37 add, 71 mul, 4 div, 3 neg, 2 sqrt, 6 call.
#[inline(always)]
pub fn f<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 22],
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
    let inv_p0_half_p5_p4 = prepared[0];
    let minus_p8_plus_p7 = prepared[1];
    let inv_p9 = prepared[2];
    let half_p5_p4_p3_inv_p2 = prepared[3];
    let inv_p2_p1 = prepared[4];
    let p14_inv_p1 = prepared[5];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // discus.hyz:63  position (x, y, z) in N;
    let x_dot = sin_theta * w + cos_theta * u;
    let minus_sin_theta_u_plus_sum = w * cos_theta - sin_theta * u;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let y_dot = cos_phi * v - minus_sin_theta_u_plus_sum * sin_phi;
    let z_dot = sin_phi * v + minus_sin_theta_u_plus_sum * cos_phi;
    let minus_sin_phi_wind_y_sum = wind_z * cos_phi - wind_y * sin_phi;

    // discus.hyz:70  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u + sin_theta * minus_sin_phi_wind_y_sum - wind_x * cos_theta;
    let minus_w_plus_sin_theta_sum = wind_x * sin_theta - w + cos_theta * minus_sin_phi_wind_y_sum;
    let air_velocity_2 = v - wind_z * sin_phi - wind_y * cos_phi;
    let air_velocity_2_sq_plus_sum =
        air_velocity_2 * air_velocity_2 + air_velocity_1 * air_velocity_1;
    let minus_w_plus_sin_sum =
        minus_w_plus_sin_theta_sum * minus_w_plus_sin_theta_sum + air_velocity_2_sq_plus_sum;
    let sqrt_minus_w_plus_sin_sum = minus_w_plus_sin_sum.sqrt();
    let sqrt_minus_w_plus_product = inv_p0_half_p5_p4 * sqrt_minus_w_plus_sin_sum;
    let inv_sqrt_minus_w_plus_of = sqrt_minus_w_plus_sin_sum.recip_or_zero();
    let minus_w_plus_sin_product = minus_w_plus_sin_theta_sum * inv_sqrt_minus_w_plus_of;

    // discus.hyz:83  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = C_Ds * minus_w_plus_sin_product * minus_w_plus_sin_product + C_D0;
    let sqrt_air_velocity_2_sq_of = air_velocity_2_sq_plus_sum.sqrt();

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
    let part_of_sqrt_minus_w_plus_product_2 =
        C_D * sqrt_air_velocity_2_sq_of - minus_w_plus_sin_theta_sum * sin_alpha_two_C_Lp_product;
    let inv_sqrt_air_velocity_2_of = sqrt_air_velocity_2_sq_of.recip_or_zero();
    let part_of_sqrt_minus_w_plus_product_2_2 =
        part_of_sqrt_minus_w_plus_product_2 * inv_sqrt_air_velocity_2_of;
    let sqrt_minus_w_plus_product_2 =
        sqrt_minus_w_plus_product * part_of_sqrt_minus_w_plus_product_2_2;
    let cos_phi_g_plus_v_phidot = g * cos_phi + v * phidot;
    let part_of_u_dot = sin_theta * cos_phi_g_plus_v_phidot - w * thetadot;

    // discus.hyz:64  velocity (u, v, w) in B;
    let u_dot = part_of_u_dot - air_velocity_1 * sqrt_minus_w_plus_product_2;
    let minus_minus_sin_theta_u_sum = -minus_sin_theta_u_plus_sum;
    let part_of_v_dot = -(g * sin_phi) - air_velocity_2 * sqrt_minus_w_plus_product_2;
    let v_dot = part_of_v_dot - phidot * minus_minus_sin_theta_u_sum;
    let part_of_w_dot =
        minus_w_plus_sin_theta_sum * C_D + sqrt_air_velocity_2_sq_of * sin_alpha_two_C_Lp_product;
    let part_of_w_dot_2 = u * thetadot + part_of_w_dot * sqrt_minus_w_plus_product;
    let w_dot = part_of_w_dot_2 - cos_theta * cos_phi_g_plus_v_phidot;
    let cos_theta_phidot = cos_theta * phidot;
    let inv_sqrt_air_product = C_Mq * inv_sqrt_air_velocity_2_of;
    let air_velocity_2_product =
        (air_velocity_2 * thetadot + air_velocity_1 * cos_theta_phidot) * inv_sqrt_air_product;
    let part_of_minus_minus_part_part_sum =
        (air_velocity_2 * cos_theta_phidot - air_velocity_1 * thetadot) * inv_sqrt_air_product;
    let minus_minus_part_part_sum = C_Ms * sin_alpha_two - part_of_minus_minus_part_part_sum;
    let part_of_minus_part_minus_product =
        air_velocity_1 * air_velocity_2_product - air_velocity_2 * minus_minus_part_part_sum;
    let half_part_part_d_product =
        half_p5_p4_p3_inv_p2 * (minus_w_plus_sin_sum * inv_sqrt_air_velocity_2_of);
    let part_of_minus_part_minus_product_3 =
        part_of_minus_part_minus_product * half_part_part_d_product;
    let sin_theta_phidot = sin_theta * phidot;

    // discus.hyz:88  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let r_inv_I_d_I_a = inv_p2_p1 * r;
    let part_of_minus_part_minus_product_2 =
        thetadot * (r_inv_I_d_I_a - T::splat(2.0) * sin_theta_phidot);
    let part_of_minus_part_minus_product_4 =
        part_of_minus_part_minus_product_2 - part_of_minus_part_minus_product_3;
    let minus_part_minus_product = part_of_minus_part_minus_product_4 / cos_theta;
    let part_of_thetadot_dot_2 = (sin_theta_phidot - r_inv_I_d_I_a) * cos_theta_phidot;
    let part_of_thetadot_dot =
        air_velocity_2 * air_velocity_2_product + air_velocity_1 * minus_minus_part_part_sum;

    // discus.hyz:56  frame B = A turned theta about 2; // does not spin with the discus
    let thetadot_dot = part_of_thetadot_dot * half_part_part_d_product - part_of_thetadot_dot_2;
    let part_of_gammadot_dot = sin_theta * minus_part_minus_product - thetadot * cos_theta_phidot;

    // discus.hyz:57  frame C = B turned gamma about 3; // fixed in the discus
    let gammadot_dot = part_of_gammadot_dot + p14_inv_p1 * r;
    let minus_minus_part_minus_product = -minus_part_minus_product;

    dx[0] = x_dot;
    dx[1] = y_dot;
    dx[2] = z_dot;
    dx[3] = u_dot;
    dx[4] = v_dot;
    dx[5] = w_dot;
    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    dx[9] = minus_minus_part_minus_product;
    dx[10] = thetadot_dot;
    dx[11] = gammadot_dot;
}
