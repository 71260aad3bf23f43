// Written by `hyzer generate`; changes belong in the model.
//! `disc_appendix`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 394 operations: 116 add, 255 mul, 3 div, 13 neg, 2 sqrt, 5 call.
/// `prepare` takes 15 operations for it.
#[inline(always)]
pub fn f_jac<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 25],
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
    let I_a = parameters[1];
    let I_d = parameters[2];
    let d = parameters[3];
    let g = parameters[6];
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
    let minus_wind_y = prepared[6];
    let minus_inv_m = prepared[7];
    let C_Da_two = prepared[8];
    let half_rho_A_inv_m = prepared[9];
    let two_d = prepared[10];
    let minus_inv_I_d = prepared[11];
    let d_gammadot_dot_d_angular_velocity_3 = prepared[12];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // disc_appendix.hyz:122  der(x) = u*cos(theta) + w*sin(theta);
    let x_dot = u * cos_theta + w * sin_theta;
    let w_cos_theta_minus_sin_sum = cos_theta * w - u * sin_theta;
    let (sin_phi, cos_phi) = phi.sin_cos();

    // disc_appendix.hyz:123  der(y) = u*sin(theta)*sin(phi) + v*cos(phi) - w*cos(theta)*sin(phi);
    let y_dot = v * cos_phi - w_cos_theta_minus_sin_sum * sin_phi;

    // disc_appendix.hyz:124  der(z) = -u*sin(theta)*cos(phi) + v*sin(phi) + w*cos(theta)*cos(p …
    let z_dot = w_cos_theta_minus_sin_sum * cos_phi + sin_phi * v;
    let sin_phi_wind_y_sum = wind_y * sin_phi - wind_z * cos_phi;
    let d_minus_air_velocity_3_d_theta = wind_x * cos_theta + sin_theta * sin_phi_wind_y_sum;

    // disc_appendix.hyz:67  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u - d_minus_air_velocity_3_d_theta;
    let d_air_velocity_1_d_theta = wind_x * sin_theta - cos_theta * sin_phi_wind_y_sum;
    let minus_air_velocity_3 = d_air_velocity_1_d_theta - w;
    let d_minus_sin_phi_wind_y_sum_d_phi = minus_wind_y * cos_phi - wind_z * sin_phi;
    let air_velocity_2 = v + d_minus_sin_phi_wind_y_sum_d_phi;
    let air_velocity_12_sq = air_velocity_1 * air_velocity_1 + air_velocity_2 * air_velocity_2;
    let V_sq = minus_air_velocity_3 * minus_air_velocity_3 + air_velocity_12_sq;

    // disc_appendix.hyz:69  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let air_velocity_12 = air_velocity_12_sq.sqrt();

    // disc_appendix.hyz:74  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);

    // disc_appendix.hyz:77  let C_L = C_L0 + C_La*alpha;
    let C_L = C_L0 + C_La * alpha;

    // disc_appendix.hyz:78  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_D0 + C_Da * alpha * alpha;
    let air_velocity_12_C_D_sum = air_velocity_12 * C_D - minus_air_velocity_3 * C_L;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let inv_air_velocity_12_product = half_rho_A * inv_air_velocity_12;
    let air_velocity_12_C_D_product = air_velocity_12_C_D_sum * inv_air_velocity_12_product;
    let inv_air_velocity_12_product_2 = V * air_velocity_12_C_D_product;
    let cos_phi_g_m = g_m * cos_phi;

    // disc_appendix.hyz:91  let force_b = (lift*sin(alpha) - drag*cos(alpha))*d1 + (lift*cos(a …
    let minus_force_b_1 = air_velocity_1 * inv_air_velocity_12_product_2 - sin_theta * cos_phi_g_m;
    let sin_theta_phidot = sin_theta * phidot;

    // disc_appendix.hyz:102  der(u) = F_b1/m - w*thetadot + v*phidot*sin(theta);
    let u_dot = v * sin_theta_phidot - inv_m * minus_force_b_1 - w * thetadot;
    let sin_phi_g_m = g_m * sin_phi;
    let minus_force_b_2 = air_velocity_2 * inv_air_velocity_12_product_2 + sin_phi_g_m;

    // disc_appendix.hyz:104  der(v) = F_b2/m + w*phidot*cos(theta) - u*phidot*sin(theta);
    let v_dot = w_cos_theta_minus_sin_sum * phidot - inv_m * minus_force_b_2;
    let minus_air_velocity_3_C_sum = air_velocity_12 * C_L + minus_air_velocity_3 * C_D;
    let cos_theta_cos_phi_g_m = cos_theta * cos_phi_g_m;
    let force_b_3 = half_rho_A * V * minus_air_velocity_3_C_sum - cos_theta_cos_phi_g_m;
    let cos_theta_phidot = cos_theta * phidot;

    // disc_appendix.hyz:106  der(w) = F_b3/m + u*thetadot - v*phidot*cos(theta);
    let w_dot = inv_m * force_b_3 + u * thetadot - v * cos_theta_phidot;

    // disc_appendix.hyz:64  let angular_velocity = (phidot*cos(theta), thetadot, phidot*sin(th …
    let angular_velocity_3 = sin_theta_phidot + gammadot;
    let angular_velocity_3_I_a = I_a * angular_velocity_3;
    let angular_velocity_3_I_a_sum = angular_velocity_3_I_a - I_d_two * sin_theta_phidot;
    let air_velocity_2_cos_product = air_velocity_2 * cos_theta_phidot;
    let air_velocity_1_thetadot = air_velocity_1 * thetadot;
    let minus_thetadot_air_sum = air_velocity_2_cos_product - air_velocity_1_thetadot;
    let inv_air_velocity_12_C_Mq = C_Mq * inv_air_velocity_12;
    let minus_thetadot_air_product = minus_thetadot_air_sum * inv_air_velocity_12_C_Mq;
    let minus_minus_thetadot_sum = C_Ma * alpha - minus_thetadot_air_product;
    let air_velocity_1_cos_product = air_velocity_1 * cos_theta_phidot;
    let air_velocity_2_thetadot = air_velocity_2 * thetadot;
    let thetadot_air_velocity_2_sum = air_velocity_1_cos_product + air_velocity_2_thetadot;
    let inv_air_velocity_12_product_3 = inv_air_velocity_12_C_Mq * thetadot_air_velocity_2_sum;
    let thetadot_air_product_sum = C_Rr * angular_velocity_3 + inv_air_velocity_12_product_3;
    let air_velocity_1_product_sum =
        air_velocity_1 * thetadot_air_product_sum - air_velocity_2 * minus_minus_thetadot_sum;
    let inv_air_velocity_12_product_3_2 = d * (V_sq * inv_air_velocity_12_product);
    let part_of_air_velocity_1_product =
        air_velocity_1_product_sum * inv_air_velocity_12_product_3_2;
    let air_velocity_1_product_sum_2 =
        part_of_air_velocity_1_product - thetadot * angular_velocity_3_I_a_sum;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let inv_cos_theta_inv_I_d = inv_I_d * inv_cos_theta;

    // disc_appendix.hyz:112  der(phidot) = (M_b1 + 2*I_d*phidot*thetadot*sin(theta) - I_a*thet …
    let der_phidot = air_velocity_1_product_sum_2 * inv_cos_theta_inv_I_d;
    let angular_velocity_3_I_a_sum_2 = angular_velocity_3_I_a - I_d * sin_theta_phidot;
    let air_velocity_2_product_sum =
        air_velocity_1 * minus_minus_thetadot_sum + air_velocity_2 * thetadot_air_product_sum;
    let part_of_air_velocity_2_product =
        air_velocity_2_product_sum * inv_air_velocity_12_product_3_2;
    let air_velocity_2_product_sum_2 =
        cos_theta_phidot * angular_velocity_3_I_a_sum_2 + part_of_air_velocity_2_product;

    // disc_appendix.hyz:115  der(thetadot) = (M_b2 - I_d*phidot^2*cos(theta)*sin(theta) + I_a* …
    let thetadot_dot = inv_I_d * air_velocity_2_product_sum_2;

    // disc_appendix.hyz:88  let spin_down = C_Nr*r;
    let spin_down = C_Nr * angular_velocity_3;
    let thetadot_cos_theta_sum = sin_theta * der_phidot + thetadot * cos_theta_phidot;
    let minus_I_a_thetadot_cos_sum = spin_down - I_a * thetadot_cos_theta_sum;

    // disc_appendix.hyz:119  der(gammadot) = (M_b3 - I_a*(der(phidot)*sin(theta) + phidot*thet …
    let gammadot_dot = inv_I_a * minus_I_a_thetadot_cos_sum;
    let d_y_dot_d_u = sin_theta * sin_phi;
    let d_y_dot_d_phi = -z_dot;
    let d_w_cos_theta_minus_sin_sum_d_theta = -x_dot;
    let d_z_dot_d_w = cos_theta * cos_phi;
    let d_z_dot_d_theta = cos_phi * d_w_cos_theta_minus_sin_sum_d_theta;
    let inv_V = V.recip_or_zero();
    let air_velocity_12_inv_V = air_velocity_12 * inv_V;
    let alpha_C_Da_two = C_Da_two * alpha;
    let d_air_velocity_12_C_D_sum_d_alpha =
        air_velocity_12 * alpha_C_Da_two - C_La * minus_air_velocity_3;
    let inv_V_sq = inv_V * inv_V;
    let minus_air_velocity_product = minus_air_velocity_3 * inv_V_sq;
    let part_of_minus_air_velocity_12_C =
        C_D - d_air_velocity_12_C_D_sum_d_alpha * minus_air_velocity_product;
    let part_of_minus_air_velocity_12_C_2 =
        inv_air_velocity_12_product * part_of_minus_air_velocity_12_C;
    let part_of_minus_air_velocity_12_C_3 =
        inv_air_velocity_12 * air_velocity_12_C_D_product - part_of_minus_air_velocity_12_C_2;
    let minus_air_velocity_12_C_sum =
        V * part_of_minus_air_velocity_12_C_3 - air_velocity_12_C_D_product * air_velocity_12_inv_V;
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let minus_air_velocity_product_2 = minus_air_velocity_12_C_sum * air_velocity_1_inv_product;
    let inv_air_velocity_12_sum =
        inv_air_velocity_12_product_2 - air_velocity_1 * minus_air_velocity_product_2;
    let air_velocity_2_inv_m = inv_m * air_velocity_2;
    let minus_air_velocity_product_3 = minus_air_velocity_product_2 * air_velocity_2_inv_m;
    let d_u_dot_d_v = sin_theta_phidot + minus_air_velocity_product_3;
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;
    let air_velocity_12_inv_V_sq = air_velocity_12 * inv_V_sq;
    let part_of_inv_air_velocity_12 =
        C_L - d_air_velocity_12_C_D_sum_d_alpha * air_velocity_12_inv_V_sq;
    let part_of_inv_air_velocity_12_2 =
        air_velocity_12_C_D_sum * minus_air_velocity_3_inv_V - V * part_of_inv_air_velocity_12;
    let inv_air_velocity_12_product_4 = inv_air_velocity_12_product * part_of_inv_air_velocity_12_2;
    let air_velocity_1_inv_product_2 = air_velocity_1 * inv_air_velocity_12_product_4;
    let d_u_dot_d_w = inv_m * air_velocity_1_inv_product_2 - thetadot;
    let part_of_d_u_dot_d_phi = air_velocity_2 * sin_phi_wind_y_sum * minus_air_velocity_product_2;
    let part_of_d_u_dot_d_phi_2 =
        sin_theta * inv_air_velocity_12_sum + cos_theta * air_velocity_1_inv_product_2;
    let part_of_d_u_dot_d_phi_3 = d_minus_sin_phi_wind_y_sum_d_phi * part_of_d_u_dot_d_phi_2;
    let part_of_d_u_dot_d_phi_4 =
        sin_theta * sin_phi_g_m - part_of_d_u_dot_d_phi + part_of_d_u_dot_d_phi_3;
    let cos_theta_v = cos_theta * v;
    let part_of_d_u_dot_d_theta =
        cos_theta_cos_phi_g_m - inv_air_velocity_12_sum * d_air_velocity_1_d_theta;
    let part_of_d_u_dot_d_theta_2 =
        part_of_d_u_dot_d_theta - d_minus_air_velocity_3_d_theta * air_velocity_1_inv_product_2;
    let d_u_dot_d_theta = phidot * cos_theta_v + inv_m * part_of_d_u_dot_d_theta_2;
    let d_u_dot_d_phidot = sin_theta * v;
    let d_v_dot_d_u = minus_air_velocity_product_3 - sin_theta_phidot;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12;
    let part_of_d_v_dot_d_phi =
        air_velocity_2 * minus_air_velocity_12_C_sum * air_velocity_2_inv_product;
    let part_of_d_v_dot_d_phi_2 =
        minus_inv_m * (inv_air_velocity_12_product_2 - part_of_d_v_dot_d_phi);
    let d_v_dot_d_w = cos_theta_phidot + inv_air_velocity_12_product_4 * air_velocity_2_inv_m;
    let part_of_d_v_dot_d_phi_3 =
        cos_theta * inv_air_velocity_12_product_4 - sin_theta * minus_air_velocity_product_2;
    let part_of_d_v_dot_d_phi_4 =
        d_minus_sin_phi_wind_y_sum_d_phi * part_of_d_v_dot_d_phi_3 * air_velocity_2_inv_m;
    let d_v_dot_d_phi =
        sin_phi_wind_y_sum * part_of_d_v_dot_d_phi_2 - g * cos_phi - part_of_d_v_dot_d_phi_4;
    let part_of_d_v_dot_d_theta = inv_air_velocity_12_product_4 * d_minus_air_velocity_3_d_theta;
    let part_of_d_v_dot_d_theta_2 =
        part_of_d_v_dot_d_theta - d_air_velocity_1_d_theta * minus_air_velocity_product_2;
    let part_of_d_v_dot_d_theta_3 = part_of_d_v_dot_d_theta_2 * air_velocity_2_inv_m;
    let d_v_dot_d_theta = phidot * d_w_cos_theta_minus_sin_sum_d_theta - part_of_d_v_dot_d_theta_3;
    let air_velocity_12_C_La_sum = C_La * air_velocity_12 + minus_air_velocity_3 * alpha_C_Da_two;
    let part_of_d_force_b_3_d_air =
        V * (C_L - air_velocity_12_C_La_sum * minus_air_velocity_product);
    let part_of_d_force_b_3_d_air_2 =
        minus_air_velocity_3_C_sum * air_velocity_12_inv_V + part_of_d_force_b_3_d_air;
    let d_force_b_3_d_air_velocity_12 = half_rho_A * part_of_d_force_b_3_d_air_2;
    let inv_m_d_force_b_3_d_product = inv_m * d_force_b_3_d_air_velocity_12;
    let d_w_dot_d_air_velocity_1 = air_velocity_1_inv_product * inv_m_d_force_b_3_d_product;
    let d_w_dot_d_u = thetadot + d_w_dot_d_air_velocity_1;
    let d_w_dot_d_air_velocity_2 = air_velocity_2_inv_product * inv_m_d_force_b_3_d_product;
    let d_w_dot_d_v = d_w_dot_d_air_velocity_2 - cos_theta_phidot;
    let part_of_minus_air_velocity_sum =
        V * (C_D + air_velocity_12_C_La_sum * air_velocity_12_inv_V_sq);
    let minus_air_velocity_sum =
        minus_air_velocity_3_C_sum * minus_air_velocity_3_inv_V + part_of_minus_air_velocity_sum;
    let d_w_dot_d_minus_air_velocity_3 = half_rho_A_inv_m * minus_air_velocity_sum;
    let part_of_d_w_dot_d_phi =
        sin_phi_wind_y_sum * d_force_b_3_d_air_velocity_12 * air_velocity_2_inv_product;
    let part_of_d_w_dot_d_phi_2 =
        sin_theta * d_force_b_3_d_air_velocity_12 * air_velocity_1_inv_product;
    let part_of_d_w_dot_d_phi_3 =
        part_of_d_w_dot_d_phi_2 + half_rho_A * cos_theta * minus_air_velocity_sum;
    let part_of_d_w_dot_d_phi_4 = d_minus_sin_phi_wind_y_sum_d_phi * part_of_d_w_dot_d_phi_3;
    let part_of_d_w_dot_d_phi_5 =
        part_of_d_w_dot_d_phi + cos_theta * sin_phi_g_m + part_of_d_w_dot_d_phi_4;
    let d_w_dot_d_phi = inv_m * part_of_d_w_dot_d_phi_5;
    let part_of_d_w_dot_d_theta = d_minus_air_velocity_3_d_theta * d_w_dot_d_minus_air_velocity_3;
    let part_of_d_w_dot_d_theta_2 =
        d_air_velocity_1_d_theta * d_w_dot_d_air_velocity_1 + part_of_d_w_dot_d_theta;
    let d_w_dot_d_theta =
        part_of_d_w_dot_d_theta_2 + sin_theta * (v * phidot + inv_m * cos_phi_g_m);
    let part_of_minus_inv_air_velocity = inv_air_velocity_12 * inv_air_velocity_12_product_3_2;
    let inv_air_velocity_12_product_5 = two_d * inv_air_velocity_12_product;
    let minus_inv_air_velocity_sum =
        air_velocity_12 * inv_air_velocity_12_product_5 - part_of_minus_inv_air_velocity;
    let minus_C_Ma_minus_air_sum =
        inv_air_velocity_12 * minus_thetadot_air_product - C_Ma * minus_air_velocity_product;
    let part_of_air_velocity_1_product_2 =
        inv_air_velocity_12_product_3 * air_velocity_1_inv_product;
    let part_of_air_velocity_1_product_3 =
        air_velocity_2 * minus_C_Ma_minus_air_sum + part_of_air_velocity_1_product_2;
    let part_of_air_velocity_1_product_4 =
        part_of_air_velocity_1_product_3 * inv_air_velocity_12_product_3_2;
    let air_velocity_1_product_sum_3 =
        air_velocity_1_product_sum * minus_inv_air_velocity_sum - part_of_air_velocity_1_product_4;
    let part_of_air_velocity_1_product_7 =
        air_velocity_1_product_sum_3 * air_velocity_1_inv_product;
    let inv_air_velocity_12_product_6 =
        inv_air_velocity_12_C_Mq * (air_velocity_1_cos_product - air_velocity_2_thetadot);
    let part_of_air_velocity_1_product_5 = thetadot_air_product_sum + inv_air_velocity_12_product_6;
    let part_of_air_velocity_1_product_6 =
        part_of_air_velocity_1_product_5 * inv_air_velocity_12_product_3_2;
    let air_velocity_1_product_sum_4 =
        part_of_air_velocity_1_product_7 + part_of_air_velocity_1_product_6;
    let d_phidot_dot_d_u = air_velocity_1_product_sum_4 * inv_cos_theta_inv_I_d;
    let part_of_air_velocity_1_product_10 =
        air_velocity_1_product_sum_3 * air_velocity_2_inv_product;
    let inv_air_velocity_12_product_7 =
        inv_air_velocity_12_C_Mq * (air_velocity_2_cos_product + air_velocity_1_thetadot);
    let part_of_air_velocity_1_product_8 = minus_minus_thetadot_sum - inv_air_velocity_12_product_7;
    let part_of_air_velocity_1_product_9 =
        part_of_air_velocity_1_product_8 * inv_air_velocity_12_product_3_2;
    let air_velocity_1_product_sum_5 =
        part_of_air_velocity_1_product_10 - part_of_air_velocity_1_product_9;
    let d_phidot_dot_d_v = air_velocity_1_product_sum_5 * inv_cos_theta_inv_I_d;
    let air_velocity_2_inv_product_2 = air_velocity_2 * inv_air_velocity_12_product_3_2;
    let C_Ma_air_velocity_product = C_Ma * air_velocity_12_inv_V_sq;
    let minus_air_velocity_product_4 = minus_air_velocity_3 * inv_air_velocity_12_product_5;
    let part_of_minus_air_velocity_2_sum =
        air_velocity_1_product_sum * minus_air_velocity_product_4;
    let minus_air_velocity_2_sum =
        part_of_minus_air_velocity_2_sum - air_velocity_2_inv_product_2 * C_Ma_air_velocity_product;
    let part_of_d_air_velocity_2_d_sum =
        sin_theta * air_velocity_1_product_sum_4 + cos_theta * minus_air_velocity_2_sum;
    let part_of_d_air_velocity_2_d_sum_2 =
        d_minus_sin_phi_wind_y_sum_d_phi * part_of_d_air_velocity_2_d_sum;
    let d_air_velocity_2_d_sum =
        sin_phi_wind_y_sum * air_velocity_1_product_sum_5 + part_of_d_air_velocity_2_d_sum_2;
    let d_phidot_dot_d_phi = d_air_velocity_2_d_sum * inv_cos_theta_inv_I_d;
    let part_of_d_phidot_dot_d_theta_2 = d_minus_air_velocity_3_d_theta * minus_air_velocity_2_sum;
    let air_velocity_1_inv_product_3 = air_velocity_1 * inv_air_velocity_12_product_3_2;
    let C_Rr_air_velocity_1_sum = C_Rr * air_velocity_1_inv_product_3 - I_a * thetadot;
    let C_Rr_air_velocity_1_sum_sum = C_Rr_air_velocity_1_sum + I_d_two * thetadot;
    let inv_air_velocity_12_product_8 =
        inv_air_velocity_12_C_Mq * (air_velocity_12_sq * inv_air_velocity_12_product_3_2);
    let part_of_d_phidot_dot_d_theta =
        cos_theta * C_Rr_air_velocity_1_sum_sum - sin_theta * inv_air_velocity_12_product_8;
    let part_of_d_phidot_dot_d_theta_3 =
        d_air_velocity_1_d_theta * air_velocity_1_product_sum_4 + part_of_d_phidot_dot_d_theta_2;
    let part_of_d_phidot_dot_d_theta_4 =
        part_of_d_phidot_dot_d_theta_3 + phidot * part_of_d_phidot_dot_d_theta;
    let part_of_d_phidot_dot_d_theta_5 =
        part_of_d_phidot_dot_d_theta_4 + sin_theta * air_velocity_1_product_sum_2 * inv_cos_theta;
    let d_phidot_dot_d_theta = part_of_d_phidot_dot_d_theta_5 * inv_cos_theta_inv_I_d;
    let part_of_d_phidot_dot_d_phidot =
        sin_theta * C_Rr_air_velocity_1_sum_sum + cos_theta * inv_air_velocity_12_product_8;
    let d_phidot_dot_d_phidot = part_of_d_phidot_dot_d_phidot * inv_cos_theta_inv_I_d;
    let d_phidot_dot_d_gammadot = C_Rr_air_velocity_1_sum * inv_cos_theta_inv_I_d;
    let part_of_air_velocity_2_product_2 =
        inv_air_velocity_12_product_3 * air_velocity_2_inv_product;
    let part_of_air_velocity_2_product_3 =
        air_velocity_1 * minus_C_Ma_minus_air_sum - part_of_air_velocity_2_product_2;
    let part_of_air_velocity_2_product_4 =
        part_of_air_velocity_2_product_3 * inv_air_velocity_12_product_3_2;
    let air_velocity_2_product_sum_3 =
        air_velocity_2_product_sum * minus_inv_air_velocity_sum + part_of_air_velocity_2_product_4;
    let part_of_air_velocity_2_product_7 =
        air_velocity_2_product_sum_3 * air_velocity_1_inv_product;
    let part_of_air_velocity_2_product_5 = minus_minus_thetadot_sum + inv_air_velocity_12_product_7;
    let part_of_air_velocity_2_product_6 =
        part_of_air_velocity_2_product_5 * inv_air_velocity_12_product_3_2;
    let air_velocity_2_product_sum_4 =
        part_of_air_velocity_2_product_7 + part_of_air_velocity_2_product_6;
    let d_thetadot_dot_d_air_velocity_1 = inv_I_d * air_velocity_2_product_sum_4;
    let part_of_air_velocity_2_product_10 =
        air_velocity_2_product_sum_3 * air_velocity_2_inv_product;
    let part_of_air_velocity_2_product_8 = thetadot_air_product_sum - inv_air_velocity_12_product_6;
    let part_of_air_velocity_2_product_9 =
        part_of_air_velocity_2_product_8 * inv_air_velocity_12_product_3_2;
    let air_velocity_2_product_sum_5 =
        part_of_air_velocity_2_product_10 + part_of_air_velocity_2_product_9;
    let d_thetadot_dot_d_v = inv_I_d * air_velocity_2_product_sum_5;
    let part_of_air_velocity_1_inv_sum = air_velocity_2_product_sum * minus_air_velocity_product_4;
    let air_velocity_1_inv_sum =
        air_velocity_1_inv_product_3 * C_Ma_air_velocity_product + part_of_air_velocity_1_inv_sum;
    let part_of_d_thetadot_dot_d_phi =
        sin_theta * air_velocity_2_product_sum_4 + cos_theta * air_velocity_1_inv_sum;
    let part_of_d_thetadot_dot_d_phi_2 =
        d_minus_sin_phi_wind_y_sum_d_phi * part_of_d_thetadot_dot_d_phi;
    let part_of_d_thetadot_dot_d_phi_3 =
        sin_phi_wind_y_sum * air_velocity_2_product_sum_5 + part_of_d_thetadot_dot_d_phi_2;
    let d_thetadot_dot_d_phi = inv_I_d * part_of_d_thetadot_dot_d_phi_3;
    let part_of_d_thetadot_dot_d_theta_2 = d_air_velocity_1_d_theta * air_velocity_2_product_sum_4;
    let C_Rr_air_velocity_2_sum = C_Rr * air_velocity_2_inv_product_2 + I_a * cos_theta_phidot;
    let minus_C_Rr_air_velocity_sum = I_d * cos_theta_phidot - C_Rr_air_velocity_2_sum;
    let part_of_d_thetadot_dot_d_theta =
        cos_theta * minus_C_Rr_air_velocity_sum + sin_theta * angular_velocity_3_I_a_sum_2;
    let part_of_d_thetadot_dot_d_theta_3 =
        phidot * part_of_d_thetadot_dot_d_theta - part_of_d_thetadot_dot_d_theta_2;
    let part_of_d_thetadot_dot_d_theta_4 =
        part_of_d_thetadot_dot_d_theta_3 - d_minus_air_velocity_3_d_theta * air_velocity_1_inv_sum;
    let part_of_d_thetadot_dot_d_phidot =
        sin_theta * minus_C_Rr_air_velocity_sum - cos_theta * angular_velocity_3_I_a_sum_2;
    let d_thetadot_dot_d_thetadot = inv_I_d * inv_air_velocity_12_product_8;
    let d_thetadot_dot_d_gammadot = inv_I_d * C_Rr_air_velocity_2_sum;
    let sin_theta_inv_cos_product = sin_theta * inv_cos_theta_inv_I_d;
    let d_gammadot_dot_d_w = minus_air_velocity_2_sum * sin_theta_inv_cos_product;
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * (d_gammadot_dot_d_angular_velocity_3 * phidot - der_phidot);
    let d_gammadot_dot_d_theta =
        part_of_d_gammadot_dot_d_theta - sin_theta * (d_phidot_dot_d_theta - thetadot * phidot);
    let part_of_d_gammadot_dot_d_phidot =
        sin_theta * (d_gammadot_dot_d_angular_velocity_3 - d_phidot_dot_d_phidot);
    let d_gammadot_dot_d_phidot = part_of_d_gammadot_dot_d_phidot - cos_theta * thetadot;
    let d_gammadot_dot_d_thetadot =
        angular_velocity_3_I_a_sum * sin_theta_inv_cos_product - cos_theta_phidot;
    let d_gammadot_dot_d_gammadot =
        d_gammadot_dot_d_angular_velocity_3 - C_Rr_air_velocity_1_sum * sin_theta_inv_cos_product;
    let d_y_dot_d_w = -(cos_theta * sin_phi);
    let d_y_dot_d_theta = -(sin_phi * d_w_cos_theta_minus_sin_sum_d_theta);
    let d_z_dot_d_u = -(sin_theta * cos_phi);
    let d_u_dot_d_thetadot = -w;
    let d_w_dot_d_w = -d_w_dot_d_minus_air_velocity_3;
    let d_w_dot_d_phidot = -cos_theta_v;
    let d_phidot_dot_d_w = -(minus_air_velocity_2_sum * inv_cos_theta_inv_I_d);
    let d_phidot_dot_d_thetadot = -(angular_velocity_3_I_a_sum * inv_cos_theta_inv_I_d);
    let d_gammadot_dot_d_u = -(air_velocity_1_product_sum_4 * sin_theta_inv_cos_product);
    let d_gammadot_dot_d_v = -(air_velocity_1_product_sum_5 * sin_theta_inv_cos_product);
    let d_gammadot_dot_d_phi = -(d_air_velocity_2_d_sum * sin_theta_inv_cos_product);

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

    j[0] = cos_theta; // d_x_dot_d_u
    j[1] = sin_theta; // d_x_dot_d_w
    j[2] = w_cos_theta_minus_sin_sum; // d_x_dot_d_theta
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
    j[13] = minus_inv_m * inv_air_velocity_12_sum; // d_u_dot_d_u
    j[14] = d_u_dot_d_v;
    j[15] = d_u_dot_d_w;
    j[16] = minus_inv_m * part_of_d_u_dot_d_phi_4; // d_u_dot_d_phi
    j[17] = d_u_dot_d_theta;
    j[18] = d_u_dot_d_phidot;
    j[19] = d_u_dot_d_thetadot;
    j[20] = d_v_dot_d_u;
    j[21] = part_of_d_v_dot_d_phi_2; // d_v_dot_d_v
    j[22] = d_v_dot_d_w;
    j[23] = d_v_dot_d_phi;
    j[24] = d_v_dot_d_theta;
    j[25] = w_cos_theta_minus_sin_sum; // d_v_dot_d_phidot
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
    j[36] = d_phidot_dot_d_u;
    j[37] = d_phidot_dot_d_v;
    j[38] = d_phidot_dot_d_w;
    j[39] = d_phidot_dot_d_phi;
    j[40] = d_phidot_dot_d_theta;
    j[41] = d_phidot_dot_d_phidot;
    j[42] = d_phidot_dot_d_thetadot;
    j[43] = d_phidot_dot_d_gammadot;
    j[44] = d_thetadot_dot_d_air_velocity_1; // d_thetadot_dot_d_u
    j[45] = d_thetadot_dot_d_v;
    j[46] = minus_inv_I_d * air_velocity_1_inv_sum; // d_thetadot_dot_d_w
    j[47] = d_thetadot_dot_d_phi;
    j[48] = minus_inv_I_d * part_of_d_thetadot_dot_d_theta_4; // d_thetadot_dot_d_theta
    j[49] = minus_inv_I_d * part_of_d_thetadot_dot_d_phidot; // d_thetadot_dot_d_phidot
    j[50] = d_thetadot_dot_d_thetadot;
    j[51] = d_thetadot_dot_d_gammadot;
    j[52] = d_gammadot_dot_d_u;
    j[53] = d_gammadot_dot_d_v;
    j[54] = d_gammadot_dot_d_w;
    j[55] = d_gammadot_dot_d_phi;
    j[56] = d_gammadot_dot_d_theta;
    j[57] = d_gammadot_dot_d_phidot;
    j[58] = d_gammadot_dot_d_thetadot;
    j[59] = d_gammadot_dot_d_gammadot;
}
