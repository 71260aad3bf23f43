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
    prepared: &[T; 22],
    dx: &mut [T; 12],
) {
    let phi = state[6];
    let (sin_phi, cos_phi) = phi.sin_cos();
    let theta = state[7];
    let (sin_theta, cos_theta) = theta.sin_cos();
    let phidot = state[9];
    let sin_theta_phidot = sin_theta * phidot;
    let cos_theta_phidot = cos_theta * phidot;
    let g = parameters[6];
    let v = state[4];
    let cos_phi_g_plus_v_phidot = g.mul_add(cos_phi, v * phidot);
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let minus_sin_phi_wind_y_sum = wind_y.neg_mul_add(sin_phi, wind_z * cos_phi);

    // disc.hyz:75  let air_velocity = velocity - in_B(air);
    let air_velocity_2 = wind_y.neg_mul_add(cos_phi, wind_z.neg_mul_add(sin_phi, v));
    let gammadot = state[11];

    // disc.hyz:91  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let w = state[5];
    let thetadot = state[10];
    let part_of_u_dot = sin_theta.mul_sub(cos_phi_g_plus_v_phidot, w * thetadot);
    let u = state[3];
    let sin_theta_u_minus_w_cos_sum = w.neg_mul_add(cos_theta, sin_theta * u);

    // disc.hyz:55  position (x, y, z) in N;
    let y_dot = sin_theta_u_minus_w_cos_sum.mul_add(sin_phi, cos_phi * v);
    dx[1] = y_dot;
    let wind_x = parameters[15];
    let minus_air_velocity_3 =
        cos_theta.mul_add(minus_sin_phi_wind_y_sum, wind_x.mul_sub(sin_theta, w));
    let C_Rr = parameters[13];
    let r_C_Rr = C_Rr * r;
    let inv_I_d_I_a = prepared[3];
    let r_inv_I_d_I_a = inv_I_d_I_a * r;
    let z_dot = sin_theta_u_minus_w_cos_sum.neg_mul_add(cos_phi, sin_phi * v);
    dx[2] = z_dot;
    let air_velocity_1 =
        wind_x.neg_mul_add(cos_theta, sin_theta.mul_add(minus_sin_phi_wind_y_sum, u));
    let x_dot = cos_theta.mul_add(u, sin_theta * w);
    dx[0] = x_dot;
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let part_of_phidot_dot = thetadot * sin_theta_phidot.neg_mul_add(T::splat(2.0), r_inv_I_d_I_a);
    let part_of_thetadot_dot_4 = (sin_theta_phidot - r_inv_I_d_I_a) * cos_theta_phidot;
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);

    // disc.hyz:77  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let half_rho_A_d_inv_I_d = prepared[2];
    let V_sq_half_rho_A_d_inv_I_d = half_rho_A_d_inv_I_d * V_sq;

    // disc.hyz:82  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let inv_m_half_rho_A = prepared[0];
    let V_inv_m_half_rho_A = inv_m_half_rho_A * V;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let C_Mq = parameters[12];
    let nonzero_air_velocity_12_C_Mq = C_Mq * nonzero_air_velocity_12;
    let C_Ma = parameters[11];
    let alpha_C_Ma = C_Ma * alpha;
    let part_of_phidot_dot_2 = air_velocity_2.neg_mul_add(alpha_C_Ma, air_velocity_1 * r_C_Rr);
    let part_of_thetadot_dot = air_velocity_1.mul_add(alpha_C_Ma, air_velocity_2 * r_C_Rr);
    let part_of_phidot_dot_3 = cos_theta_phidot * nonzero_air_velocity_12_C_Mq;
    let part_of_phidot_dot_4 =
        inv_air_velocity_12.mul_add(part_of_phidot_dot_2, part_of_phidot_dot_3);
    let part_of_phidot_dot_5 =
        V_sq_half_rho_A_d_inv_I_d.mul_sub(part_of_phidot_dot_4, part_of_phidot_dot);
    let phidot_dot = part_of_phidot_dot_5 / cos_theta;
    dx[9] = phidot_dot;
    let C_Nr_inv_I_a = prepared[4];
    let part_of_gammadot_dot = sin_theta.neg_mul_add(phidot_dot, C_Nr_inv_I_a * r);
    let part_of_thetadot_dot_2 = thetadot * nonzero_air_velocity_12_C_Mq;

    // disc.hyz:49  frame C = B turned gamma about 3; // fixed in the disc
    let gammadot_dot = thetadot.neg_mul_add(cos_theta_phidot, part_of_gammadot_dot);
    dx[11] = gammadot_dot;
    let part_of_thetadot_dot_3 =
        inv_air_velocity_12.mul_add(part_of_thetadot_dot, part_of_thetadot_dot_2);

    // disc.hyz:48  frame B = A turned theta about 2; // does not spin with the disc
    let thetadot_dot =
        V_sq_half_rho_A_d_inv_I_d.mul_sub(part_of_thetadot_dot_3, part_of_thetadot_dot_4);
    dx[10] = thetadot_dot;
    let C_La = parameters[8];
    let C_L0 = parameters[7];

    // disc.hyz:85  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La.mul_add(alpha, C_L0);
    let C_Da = parameters[10];
    let C_D0 = parameters[9];

    // disc.hyz:86  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = alpha.mul_add(C_Da * alpha, C_D0);
    let part_of_w_dot = minus_air_velocity_3.mul_add(C_D, air_velocity_12 * C_L);
    let part_of_V_inv_m_half_rho_A =
        air_velocity_12.mul_sub(C_D, minus_air_velocity_3 * C_L) * inv_air_velocity_12;
    let part_of_w_dot_2 = V_inv_m_half_rho_A.mul_add(part_of_w_dot, u * thetadot);
    let V_inv_m_half_rho_A_product = V_inv_m_half_rho_A * part_of_V_inv_m_half_rho_A;

    // disc.hyz:56  velocity (u, v, w) in B;
    let w_dot = cos_theta.neg_mul_add(cos_phi_g_plus_v_phidot, part_of_w_dot_2);
    dx[5] = w_dot;
    let minus_g = prepared[1];
    let part_of_v_dot = air_velocity_2.neg_mul_add(V_inv_m_half_rho_A_product, minus_g * sin_phi);
    let u_dot = air_velocity_1.neg_mul_add(V_inv_m_half_rho_A_product, part_of_u_dot);
    dx[3] = u_dot;
    let v_dot = phidot.neg_mul_add(sin_theta_u_minus_w_cos_sum, part_of_v_dot);
    dx[4] = v_dot;

    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
}
