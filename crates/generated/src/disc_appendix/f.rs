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
    let phi = state[6];
    let (sin_phi, cos_phi) = phi.sin_cos();
    let theta = state[7];
    let (sin_theta, cos_theta) = theta.sin_cos();
    let phidot = state[9];
    let sin_theta_phidot = sin_theta * phidot;
    let cos_theta_phidot = cos_theta * phidot;
    let g_m = prepared[3];
    let cos_phi_g_m = g_m * cos_phi;
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let minus_sin_phi_wind_y_sum = wind_y.neg_mul_add(sin_phi, wind_z * cos_phi);
    let v = state[4];

    // disc_appendix.hyz:67  let air_velocity = velocity - in_B(wind);
    let air_velocity_2 = wind_y.neg_mul_add(cos_phi, wind_z.neg_mul_add(sin_phi, v));
    let gammadot = state[11];

    // disc_appendix.hyz:64  let angular_velocity = (phidot*cos(theta), thetadot, phidot*sin(th …
    let angular_velocity_3 = gammadot + sin_theta_phidot;
    let u = state[3];
    let w = state[5];
    let w_cos_theta_minus_sin_sum = sin_theta.neg_mul_add(u, w * cos_theta);
    let wind_x = parameters[15];
    let minus_air_velocity_3 =
        cos_theta.mul_add(minus_sin_phi_wind_y_sum, wind_x.mul_sub(sin_theta, w));
    let air_velocity_1 =
        wind_x.neg_mul_add(cos_theta, sin_theta.mul_add(minus_sin_phi_wind_y_sum, u));
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let thetadot = state[10];
    let part_of_part_part_plus_part_sum =
        air_velocity_1.mul_add(cos_theta_phidot, thetadot * air_velocity_2);
    let part_of_minus_minus_part_part =
        thetadot.neg_mul_add(air_velocity_1, air_velocity_2 * cos_theta_phidot);
    let C_Rr = parameters[13];
    let part_of_part_part_plus_part_sum_2 = C_Rr * angular_velocity_3;
    let I_a = parameters[1];
    let angular_velocity_3_I_a = I_a * angular_velocity_3;
    let C_Nr = parameters[14];

    // disc_appendix.hyz:88  let spin_down = C_Nr*r;
    let spin_down = C_Nr * angular_velocity_3;

    // disc_appendix.hyz:122  der(x) = u*cos(theta) + w*sin(theta);
    let x_dot = cos_theta.mul_add(u, sin_theta * w);
    dx[0] = x_dot;
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);

    // disc_appendix.hyz:123  der(y) = u*sin(theta)*sin(phi) + v*cos(phi) - w*cos(theta)*sin(phi);
    let y_dot = sin_phi.neg_mul_add(w_cos_theta_minus_sin_sum, cos_phi * v);
    dx[1] = y_dot;

    // disc_appendix.hyz:124  der(z) = -u*sin(theta)*cos(phi) + v*sin(phi) + w*cos(theta)*cos(p …
    let z_dot = cos_phi.mul_add(w_cos_theta_minus_sin_sum, sin_phi * v);
    dx[2] = z_dot;
    let I_d = parameters[2];
    let part_of_thetadot_dot =
        I_d.neg_mul_add(sin_theta_phidot, angular_velocity_3_I_a) * cos_theta_phidot;
    let I_d_two = prepared[5];
    let part_of_der_phidot =
        thetadot * I_d_two.neg_mul_add(sin_theta_phidot, angular_velocity_3_I_a);

    // disc_appendix.hyz:69  let V = norm(air_velocity);
    let V = V_sq.sqrt();

    // disc_appendix.hyz:74  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let C_Mq = parameters[12];
    let inv_air_velocity_12_C_Mq = C_Mq * inv_air_velocity_12;
    let part_part_plus_part_sum = inv_air_velocity_12_C_Mq.mul_add(
        part_of_part_part_plus_part_sum,
        part_of_part_part_plus_part_sum_2,
    );
    let part_of_minus_minus_part_part_2 = part_of_minus_minus_part_part * inv_air_velocity_12_C_Mq;
    let half_rho_A = prepared[4];
    let inv_air_velocity_12_product = half_rho_A * inv_air_velocity_12;
    let C_Ma = parameters[11];
    let minus_minus_part_part_sum = C_Ma.mul_sub(alpha, part_of_minus_minus_part_part_2);
    let d = parameters[3];
    let inv_air_velocity_12_product_3 = inv_air_velocity_12_product * (d * V_sq);
    let part_of_der_phidot_2 = air_velocity_1 * part_part_plus_part_sum;
    let part_of_der_phidot_3 =
        air_velocity_2.neg_mul_add(minus_minus_part_part_sum, part_of_der_phidot_2);
    let part_of_der_phidot_4 =
        inv_air_velocity_12_product_3.mul_sub(part_of_der_phidot_3, part_of_der_phidot);
    let part_of_thetadot_dot_2 = air_velocity_2 * part_part_plus_part_sum;
    let part_of_thetadot_dot_3 =
        air_velocity_1.mul_add(minus_minus_part_part_sum, part_of_thetadot_dot_2);
    let part_of_thetadot_dot_4 =
        inv_air_velocity_12_product_3.mul_add(part_of_thetadot_dot_3, part_of_thetadot_dot);
    let inv_I_d = prepared[1];

    // disc_appendix.hyz:115  der(thetadot) = (M_b2 - I_d*phidot^2*cos(theta)*sin(theta) + I_a* …
    let thetadot_dot = inv_I_d * part_of_thetadot_dot_4;
    dx[10] = thetadot_dot;

    // disc_appendix.hyz:112  der(phidot) = (M_b1 + 2*I_d*phidot*thetadot*sin(theta) - I_a*thet …
    let der_phidot = inv_I_d * part_of_der_phidot_4 / cos_theta;
    dx[9] = der_phidot;
    let part_of_gammadot_dot = sin_theta.mul_add(der_phidot, thetadot * cos_theta_phidot);
    let inv_I_a = prepared[2];

    // disc_appendix.hyz:119  der(gammadot) = (M_b3 - I_a*(der(phidot)*sin(theta) + phidot*thet …
    let gammadot_dot = inv_I_a * I_a.neg_mul_add(part_of_gammadot_dot, spin_down);
    dx[11] = gammadot_dot;
    let C_La = parameters[8];
    let C_L0 = parameters[7];

    // disc_appendix.hyz:77  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La.mul_add(alpha, C_L0);
    let C_Da = parameters[10];
    let C_D0 = parameters[9];

    // disc_appendix.hyz:78  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = alpha.mul_add(C_Da * alpha, C_D0);
    let part_of_force_b_3 = minus_air_velocity_3.mul_add(C_D, air_velocity_12 * C_L);
    let part_of_inv_air_velocity_12 = air_velocity_12.mul_sub(C_D, minus_air_velocity_3 * C_L) * V;

    // disc_appendix.hyz:91  let force_b = (lift*sin(alpha) - drag*cos(alpha))*d1 + (lift*cos(a …
    let force_b_3 = (half_rho_A * V).mul_sub(part_of_force_b_3, cos_theta * cos_phi_g_m);
    let inv_air_velocity_12_product_2 = inv_air_velocity_12_product * part_of_inv_air_velocity_12;
    let inv_m = prepared[0];

    // disc_appendix.hyz:106  der(w) = F_b3/m + u*thetadot - v*phidot*cos(theta);
    let w_dot = inv_m.mul_add(force_b_3, v.neg_mul_add(cos_theta_phidot, u * thetadot));
    dx[5] = w_dot;
    let minus_force_b_1 =
        air_velocity_1.mul_sub(inv_air_velocity_12_product_2, sin_theta * cos_phi_g_m);
    let minus_force_b_2 = air_velocity_2.mul_add(inv_air_velocity_12_product_2, g_m * sin_phi);

    // disc_appendix.hyz:102  der(u) = F_b1/m - w*thetadot + v*phidot*sin(theta);
    let u_dot = inv_m.neg_mul_add(minus_force_b_1, v.mul_sub(sin_theta_phidot, w * thetadot));
    dx[3] = u_dot;

    // disc_appendix.hyz:104  der(v) = F_b2/m + w*phidot*cos(theta) - u*phidot*sin(theta);
    let v_dot = inv_m.neg_mul_add(minus_force_b_2, phidot * w_cos_theta_minus_sin_sum);
    dx[4] = v_dot;

    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
}
