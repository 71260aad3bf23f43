// Written by `hyzer generate`; changes belong in the model.
//! `disc`: derivatives of the states.

use lanes::Real;

/// Derivatives `dx` of the states.
///
/// 108 operations: 35 add, 63 mul, 2 div, 2 sqrt, 5 call, 1 select.
/// `prepare` takes 11 operations for it.
#[inline(always)]
pub fn f<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 21],
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
    let inv_m_half_rho_A = prepared[0];
    let minus_g = prepared[1];
    let half_rho_A_d_inv_I_d = prepared[2];
    let inv_I_d_I_a = prepared[3];
    let C_Nr_inv_I_a = prepared[4];
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
    let air_velocity_12_sq = air_velocity_2 * air_velocity_2 + air_velocity_1 * air_velocity_1;
    let minus_air_velocity_3 = wind_x * sin_theta - w + cos_theta * minus_sin_phi_wind_y_sum;
    let V_sq = air_velocity_12_sq + minus_air_velocity_3 * minus_air_velocity_3;

    // disc.hyz:64  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let V_inv_m_half_rho_A = inv_m_half_rho_A * V;
    let air_velocity_12 = air_velocity_12_sq.sqrt();

    // disc.hyz:69  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);

    // disc.hyz:73  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_Da * alpha * alpha + C_D0;

    // disc.hyz:72  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La * alpha + C_L0;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let part_of_V_inv_m_half_rho_A =
        (air_velocity_12 * C_D - minus_air_velocity_3 * C_L) * inv_air_velocity_12;
    let V_inv_m_half_rho_A_product = V_inv_m_half_rho_A * part_of_V_inv_m_half_rho_A;
    let cos_phi_g_plus_v_phidot = g * cos_phi + v * phidot;
    let part_of_u_dot = sin_theta * cos_phi_g_plus_v_phidot - w * thetadot;

    // disc.hyz:56  velocity (u, v, w) in B;
    let u_dot = part_of_u_dot - air_velocity_1 * V_inv_m_half_rho_A_product;
    let part_of_v_dot = minus_g * sin_phi - air_velocity_2 * V_inv_m_half_rho_A_product;
    let v_dot = part_of_v_dot - phidot * sin_theta_u_minus_w_cos_sum;
    let part_of_w_dot = (minus_air_velocity_3 * C_D + air_velocity_12 * C_L) * V_inv_m_half_rho_A;
    let w_dot = u * thetadot + part_of_w_dot - cos_theta * cos_phi_g_plus_v_phidot;
    let cos_theta_phidot = cos_theta * phidot;
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let nonzero_air_velocity_12_C_Mq = C_Mq * nonzero_air_velocity_12;
    let sin_theta_phidot = sin_theta * phidot;

    // disc.hyz:78  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let r_C_Rr = C_Rr * r;
    let alpha_C_Ma = C_Ma * alpha;
    let part_of_phidot_dot =
        inv_air_velocity_12 * (air_velocity_1 * r_C_Rr - air_velocity_2 * alpha_C_Ma);
    let part_of_phidot_dot_2 = cos_theta_phidot * nonzero_air_velocity_12_C_Mq + part_of_phidot_dot;
    let V_sq_half_rho_A_d_inv_I_d = half_rho_A_d_inv_I_d * V_sq;
    let r_inv_I_d_I_a = inv_I_d_I_a * r;
    let part_of_phidot_dot_3 = thetadot * (r_inv_I_d_I_a - T::splat(2.0) * sin_theta_phidot);
    let part_of_phidot_dot_4 =
        part_of_phidot_dot_2 * V_sq_half_rho_A_d_inv_I_d - part_of_phidot_dot_3;
    let phidot_dot = part_of_phidot_dot_4 / cos_theta;
    let part_of_thetadot_dot_3 = (sin_theta_phidot - r_inv_I_d_I_a) * cos_theta_phidot;
    let part_of_thetadot_dot =
        inv_air_velocity_12 * (air_velocity_2 * r_C_Rr + air_velocity_1 * alpha_C_Ma);
    let part_of_thetadot_dot_2 = thetadot * nonzero_air_velocity_12_C_Mq + part_of_thetadot_dot;

    // disc.hyz:48  frame B = A turned theta about 2; // does not spin with the disc
    let thetadot_dot = part_of_thetadot_dot_2 * V_sq_half_rho_A_d_inv_I_d - part_of_thetadot_dot_3;

    // disc.hyz:49  frame C = B turned gamma about 3; // fixed in the disc
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
