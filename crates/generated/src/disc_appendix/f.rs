// Written by `hyzer generate`; changes belong in the model.
//! `disc_appendix`: derivatives of the states.

use lanes::Real;

/// Derivatives `dx` of the states.
///
/// 123 operations: 38 add, 76 mul, 2 div, 2 sqrt, 5 call.
/// `prepare` takes 7 operations for it.
#[inline(always)]
pub fn f<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 25],
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
    let I_a = parameters[1];
    let I_d = parameters[2];
    let d = parameters[3];
    let C_L0 = parameters[7];
    let C_La = parameters[8];
    let C_D0 = parameters[9];
    let C_Da = parameters[10];
    let C_Ma = parameters[11];
    let C_Mq = parameters[12];
    let C_Rr = parameters[13];
    let C_Nr = parameters[14];
    let wind_x = parameters[15];
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let g_m = prepared[0];
    let half_rho_A = prepared[1];
    let inv_m = prepared[2];
    let I_d_two = prepared[3];
    let inv_I_d = prepared[4];
    let inv_I_a = prepared[5];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // disc_appendix.hyz:122  der(x) = u*cos(theta) + w*sin(theta);
    let x_dot = sin_theta * w + cos_theta * u;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let w_cos_theta_minus_sin_sum = w * cos_theta - sin_theta * u;

    // disc_appendix.hyz:123  der(y) = u*sin(theta)*sin(phi) + v*cos(phi) - w*cos(theta)*sin(phi);
    let y_dot = cos_phi * v - sin_phi * w_cos_theta_minus_sin_sum;

    // disc_appendix.hyz:124  der(z) = -u*sin(theta)*cos(phi) + v*sin(phi) + w*cos(theta)*cos(p …
    let z_dot = sin_phi * v + cos_phi * w_cos_theta_minus_sin_sum;
    let sin_theta_phidot = sin_theta * phidot;
    let cos_phi_g_m = g_m * cos_phi;
    let minus_sin_phi_wind_y_sum = wind_z * cos_phi - wind_y * sin_phi;

    // disc_appendix.hyz:67  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u + sin_theta * minus_sin_phi_wind_y_sum - wind_x * cos_theta;
    let air_velocity_2 = v - wind_z * sin_phi - wind_y * cos_phi;
    let air_velocity_12_sq = air_velocity_2 * air_velocity_2 + air_velocity_1 * air_velocity_1;
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let inv_air_velocity_12_product = half_rho_A * inv_air_velocity_12;
    let minus_air_velocity_3 = wind_x * sin_theta - w + cos_theta * minus_sin_phi_wind_y_sum;

    // disc_appendix.hyz:74  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);

    // disc_appendix.hyz:78  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_Da * alpha * alpha + C_D0;

    // disc_appendix.hyz:77  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La * alpha + C_L0;
    let V_sq = air_velocity_12_sq + minus_air_velocity_3 * minus_air_velocity_3;

    // disc_appendix.hyz:69  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let inv_air_velocity_12_product_2 =
        inv_air_velocity_12_product * ((air_velocity_12 * C_D - minus_air_velocity_3 * C_L) * V);

    // disc_appendix.hyz:91  let force_b = (lift*sin(alpha) - drag*cos(alpha))*d1 + (lift*cos(a …
    let minus_force_b_1 = air_velocity_1 * inv_air_velocity_12_product_2 - sin_theta * cos_phi_g_m;

    // disc_appendix.hyz:102  der(u) = F_b1/m - w*thetadot + v*phidot*sin(theta);
    let u_dot = v * sin_theta_phidot - w * thetadot - inv_m * minus_force_b_1;
    let minus_force_b_2 = g_m * sin_phi + air_velocity_2 * inv_air_velocity_12_product_2;

    // disc_appendix.hyz:104  der(v) = F_b2/m + w*phidot*cos(theta) - u*phidot*sin(theta);
    let v_dot = phidot * w_cos_theta_minus_sin_sum - inv_m * minus_force_b_2;
    let cos_theta_phidot = cos_theta * phidot;
    let part_of_force_b_3 = half_rho_A * V * (minus_air_velocity_3 * C_D + air_velocity_12 * C_L);
    let force_b_3 = part_of_force_b_3 - cos_theta * cos_phi_g_m;

    // disc_appendix.hyz:106  der(w) = F_b3/m + u*thetadot - v*phidot*cos(theta);
    let w_dot = u * thetadot - v * cos_theta_phidot + inv_m * force_b_3;
    let inv_air_velocity_12_C_Mq = C_Mq * inv_air_velocity_12;
    let part_of_part_part_plus_part_sum =
        (thetadot * air_velocity_2 + air_velocity_1 * cos_theta_phidot) * inv_air_velocity_12_C_Mq;

    // disc_appendix.hyz:64  let angular_velocity = (phidot*cos(theta), thetadot, phidot*sin(th …
    let angular_velocity_3 = gammadot + sin_theta_phidot;
    let part_part_plus_part_sum = part_of_part_part_plus_part_sum + C_Rr * angular_velocity_3;
    let part_of_minus_minus_part_part =
        (air_velocity_2 * cos_theta_phidot - thetadot * air_velocity_1) * inv_air_velocity_12_C_Mq;
    let minus_minus_part_part_sum = C_Ma * alpha - part_of_minus_minus_part_part;
    let part_of_der_phidot =
        air_velocity_1 * part_part_plus_part_sum - air_velocity_2 * minus_minus_part_part_sum;
    let inv_air_velocity_12_product_3 = inv_air_velocity_12_product * (d * V_sq);
    let angular_velocity_3_I_a = I_a * angular_velocity_3;
    let part_of_der_phidot_2 = thetadot * (angular_velocity_3_I_a - I_d_two * sin_theta_phidot);
    let part_of_der_phidot_3 =
        part_of_der_phidot * inv_air_velocity_12_product_3 - part_of_der_phidot_2;

    // disc_appendix.hyz:112  der(phidot) = (M_b1 + 2*I_d*phidot*thetadot*sin(theta) - I_a*thet …
    let der_phidot = inv_I_d * part_of_der_phidot_3 / cos_theta;
    let part_of_thetadot_dot =
        air_velocity_2 * part_part_plus_part_sum + air_velocity_1 * minus_minus_part_part_sum;
    let part_of_thetadot_dot_2 =
        (angular_velocity_3_I_a - I_d * sin_theta_phidot) * cos_theta_phidot;
    let part_of_thetadot_dot_3 =
        part_of_thetadot_dot * inv_air_velocity_12_product_3 + part_of_thetadot_dot_2;

    // disc_appendix.hyz:115  der(thetadot) = (M_b2 - I_d*phidot^2*cos(theta)*sin(theta) + I_a* …
    let thetadot_dot = inv_I_d * part_of_thetadot_dot_3;

    // disc_appendix.hyz:88  let spin_down = C_Nr*r;
    let spin_down = C_Nr * angular_velocity_3;
    let part_of_gammadot_dot =
        spin_down - I_a * (thetadot * cos_theta_phidot + sin_theta * der_phidot);

    // disc_appendix.hyz:119  der(gammadot) = (M_b3 - I_a*(der(phidot)*sin(theta) + phidot*thet …
    let gammadot_dot = inv_I_a * part_of_gammadot_dot;

    dx[0] = x_dot;
    dx[1] = y_dot;
    dx[2] = z_dot;
    dx[3] = u_dot;
    dx[4] = v_dot;
    dx[5] = w_dot;
    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    dx[9] = der_phidot;
    dx[10] = thetadot_dot;
    dx[11] = gammadot_dot;
}
