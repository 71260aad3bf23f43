// Written by `hyzer generate`; changes belong in the model.
//! `disc`: derivatives of the states.

use lanes::Real;

/// Derivatives `dx` of the states.
///
/// 108 operations: 35 add, 63 mul, 2 div, 2 sqrt, 5 call, 1 select.
#[inline(always)]
pub fn f<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 26],
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
    let inv_p0_half_p5_p4 = prepared[0];
    let minus_p6 = prepared[1];
    let half_p5_p4_p3_inv_p2 = prepared[2];
    let inv_p2_p1 = prepared[3];
    let p14_inv_p1 = prepared[4];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // disc.hyz:55  position (x, y, z) in N;
    let x_dot = sin_theta * w + cos_theta * u;
    let sin_theta_u_minus_w_cos_sum = sin_theta * u - w * cos_theta;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let y_dot = sin_theta_u_minus_w_cos_sum * sin_phi + cos_phi * v;
    let z_dot = sin_phi * v - sin_theta_u_minus_w_cos_sum * cos_phi;
    let minus_sin_phi_wind_y_sum = wind_z * cos_phi - wind_y * sin_phi;

    // disc.hyz:62  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u + sin_theta * minus_sin_phi_wind_y_sum - wind_x * cos_theta;
    let air_velocity_2 = v - wind_z * sin_phi - wind_y * cos_phi;
    let air_velocity_2_sq_plus_sum =
        air_velocity_2 * air_velocity_2 + air_velocity_1 * air_velocity_1;
    let minus_w_plus_sin_theta_sum = wind_x * sin_theta - w + cos_theta * minus_sin_phi_wind_y_sum;
    let air_velocity_2_sq_plus_sum_2 =
        air_velocity_2_sq_plus_sum + minus_w_plus_sin_theta_sum * minus_w_plus_sin_theta_sum;

    // disc.hyz:64  let V = norm(air_velocity);
    let V = air_velocity_2_sq_plus_sum_2.sqrt();
    let V_inv_m_half_part_part = inv_p0_half_p5_p4 * V;
    let sqrt_air_velocity_2_sq_of = air_velocity_2_sq_plus_sum.sqrt();

    // disc.hyz:69  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_w_plus_sin_theta_sum.atan2(sqrt_air_velocity_2_sq_of);

    // disc.hyz:73  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_Da * alpha * alpha + C_D0;

    // disc.hyz:72  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La * alpha + C_L0;
    let part_of_V_inv_m_half_part_product =
        sqrt_air_velocity_2_sq_of * C_D - minus_w_plus_sin_theta_sum * C_L;
    let inv_sqrt_air_velocity_2_of = sqrt_air_velocity_2_sq_of.recip_or_zero();
    let V_inv_m_half_part_product =
        V_inv_m_half_part_part * (part_of_V_inv_m_half_part_product * inv_sqrt_air_velocity_2_of);
    let cos_phi_g_plus_v_phidot = g * cos_phi + v * phidot;
    let part_of_u_dot = sin_theta * cos_phi_g_plus_v_phidot - w * thetadot;

    // disc.hyz:56  velocity (u, v, w) in B;
    let u_dot = part_of_u_dot - air_velocity_1 * V_inv_m_half_part_product;
    let part_of_v_dot = minus_p6 * sin_phi - air_velocity_2 * V_inv_m_half_part_product;
    let v_dot = part_of_v_dot - phidot * sin_theta_u_minus_w_cos_sum;
    let part_of_w_dot = minus_w_plus_sin_theta_sum * C_D + sqrt_air_velocity_2_sq_of * C_L;
    let w_dot =
        u * thetadot + part_of_w_dot * V_inv_m_half_part_part - cos_theta * cos_phi_g_plus_v_phidot;
    let cos_theta_phidot = cos_theta * phidot;
    let nonzero_air_velocity_2_of =
        air_velocity_2_sq_plus_sum.if_zero(T::splat(0.0), T::splat(1.0));
    let nonzero_air_product = C_Mq * nonzero_air_velocity_2_of;
    let sin_theta_phidot = sin_theta * phidot;

    // disc.hyz:78  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let r_C_Rr = C_Rr * r;
    let alpha_C_Ma = C_Ma * alpha;
    let part_of_part_plus_part_air_product =
        inv_sqrt_air_velocity_2_of * (air_velocity_1 * r_C_Rr - air_velocity_2 * alpha_C_Ma);
    let part_of_part_plus_part_air_product_2 =
        cos_theta_phidot * nonzero_air_product + part_of_part_plus_part_air_product;
    let air_velocity_2_sq_product = half_p5_p4_p3_inv_p2 * air_velocity_2_sq_plus_sum_2;
    let part_of_part_plus_part_air_product_3 =
        part_of_part_plus_part_air_product_2 * air_velocity_2_sq_product;
    let r_inv_I_d_I_a = inv_p2_p1 * r;
    let part_of_part_plus_part_air_product_4 =
        thetadot * (r_inv_I_d_I_a - T::splat(2.0) * sin_theta_phidot);
    let part_of_part_plus_part_air_product_5 =
        part_of_part_plus_part_air_product_3 - part_of_part_plus_part_air_product_4;
    let part_plus_part_air_product = part_of_part_plus_part_air_product_5 / cos_theta;
    let part_of_thetadot_dot =
        inv_sqrt_air_velocity_2_of * (air_velocity_2 * r_C_Rr + air_velocity_1 * alpha_C_Ma);
    let part_of_thetadot_dot_2 =
        (thetadot * nonzero_air_product + part_of_thetadot_dot) * air_velocity_2_sq_product;

    // disc.hyz:48  frame B = A turned theta about 2; // does not spin with the disc
    let thetadot_dot =
        part_of_thetadot_dot_2 - (sin_theta_phidot - r_inv_I_d_I_a) * cos_theta_phidot;

    // disc.hyz:49  frame C = B turned gamma about 3; // fixed in the disc
    let gammadot_dot =
        p14_inv_p1 * r - sin_theta * part_plus_part_air_product - thetadot * cos_theta_phidot;

    dx[0] = x_dot;
    dx[1] = y_dot;
    dx[2] = z_dot;
    dx[3] = u_dot;
    dx[4] = v_dot;
    dx[5] = w_dot;
    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    dx[9] = part_plus_part_air_product;
    dx[10] = thetadot_dot;
    dx[11] = gammadot_dot;
}
