// Written by `hyzer generate`; changes belong in the model.
//! `disc_appendix`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 423 operations: 128 add, 272 mul, 3 div, 13 neg, 2 sqrt, 5 call.
#[inline(always)]
pub fn f_jac<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 28],
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
    let C_Da_two = prepared[6];
    let minus_inv_m = prepared[7];
    let half_rho_A_inv_m = prepared[8];
    let minus_half_rho_A_inv_m = prepared[9];
    let two_d = prepared[10];
    let half_rho_A_d = prepared[11];
    let I_a_inv_I_d = prepared[12];
    let minus_two_plus_I_a_inv_I_d = prepared[13];
    let minus_inv_I_d = prepared[14];
    let minus_one_plus_I_a_inv_I_d = prepared[15];
    let C_Rr_inv_I_d = prepared[16];
    let d_gammadot_dot_d_angular_velocity_3 = prepared[17];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // disc_appendix.hyz:122  der(x) = u*cos(theta) + w*sin(theta);
    let x_dot = u * cos_theta + w * sin_theta;
    let w_cos_theta_minus_sin_sum = cos_theta * w - u * sin_theta;
    let (sin_phi, cos_phi) = phi.sin_cos();

    // disc_appendix.hyz:123  der(y) = u*sin(theta)*sin(phi) + v*cos(phi) - w*cos(theta)*sin(phi);
    let y_dot = v * cos_phi - w_cos_theta_minus_sin_sum * sin_phi;

    // disc_appendix.hyz:124  der(z) = -u*sin(theta)*cos(phi) + v*sin(phi) + w*cos(theta)*cos(p …
    let z_dot = w_cos_theta_minus_sin_sum * cos_phi + sin_phi * v;
    let minus_sin_phi_wind_y_sum = wind_z * cos_phi - wind_y * sin_phi;
    let minus_d_minus_air_velocity_3_d_theta =
        sin_theta * minus_sin_phi_wind_y_sum - wind_x * cos_theta;

    // disc_appendix.hyz:67  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u + minus_d_minus_air_velocity_3_d_theta;
    let minus_d_minus_sin_phi_wind_y_sum_d_phi = wind_y * cos_phi + wind_z * sin_phi;
    let air_velocity_2 = v - minus_d_minus_sin_phi_wind_y_sum_d_phi;
    let air_velocity_12_sq = air_velocity_1 * air_velocity_1 + air_velocity_2 * air_velocity_2;
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let inv_air_velocity_12_product = half_rho_A * inv_air_velocity_12;
    let d_air_velocity_1_d_theta = cos_theta * minus_sin_phi_wind_y_sum + wind_x * sin_theta;
    let minus_air_velocity_3 = d_air_velocity_1_d_theta - w;
    let V_sq = minus_air_velocity_3 * minus_air_velocity_3 + air_velocity_12_sq;

    // disc_appendix.hyz:69  let V = norm(air_velocity);
    let V = V_sq.sqrt();

    // disc_appendix.hyz:74  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);

    // disc_appendix.hyz:77  let C_L = C_L0 + C_La*alpha;
    let C_L = C_L0 + C_La * alpha;

    // disc_appendix.hyz:78  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_D0 + C_Da * alpha * alpha;
    let air_velocity_12_C_D_sum = air_velocity_12 * C_D - minus_air_velocity_3 * C_L;
    let V_air_velocity_12_C_D_sum = V * air_velocity_12_C_D_sum;
    let inv_air_velocity_12_product_2 = inv_air_velocity_12_product * V_air_velocity_12_C_D_sum;
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
    let v_cos_theta_phidot = v * cos_theta_phidot;

    // disc_appendix.hyz:106  der(w) = F_b3/m + u*thetadot - v*phidot*cos(theta);
    let w_dot = inv_m * force_b_3 + u * thetadot - v_cos_theta_phidot;

    // disc_appendix.hyz:64  let angular_velocity = (phidot*cos(theta), thetadot, phidot*sin(th …
    let angular_velocity_3 = sin_theta_phidot + gammadot;
    let angular_velocity_3_I_a = I_a * angular_velocity_3;
    let angular_velocity_3_I_a_sum = angular_velocity_3_I_a - I_d_two * sin_theta_phidot;
    let inv_air_velocity_12_product_3 = d * V_sq * inv_air_velocity_12_product;
    let air_velocity_2_cos_product = air_velocity_2 * cos_theta_phidot;
    let air_velocity_1_thetadot = air_velocity_1 * thetadot;
    let minus_thetadot_air_sum = air_velocity_2_cos_product - air_velocity_1_thetadot;
    let inv_air_velocity_12_C_Mq = C_Mq * inv_air_velocity_12;
    let minus_minus_thetadot_sum = C_Ma * alpha - minus_thetadot_air_sum * inv_air_velocity_12_C_Mq;
    let air_velocity_1_cos_product = air_velocity_1 * cos_theta_phidot;
    let air_velocity_2_thetadot = air_velocity_2 * thetadot;
    let thetadot_air_velocity_2_sum = air_velocity_1_cos_product + air_velocity_2_thetadot;
    let thetadot_air_product_sum =
        C_Rr * angular_velocity_3 + inv_air_velocity_12_C_Mq * thetadot_air_velocity_2_sum;
    let air_velocity_1_product_sum =
        air_velocity_1 * thetadot_air_product_sum - air_velocity_2 * minus_minus_thetadot_sum;
    let part_of_air_velocity_1_product = inv_air_velocity_12_product_3 * air_velocity_1_product_sum;
    let air_velocity_1_product_sum_2 =
        part_of_air_velocity_1_product - thetadot * angular_velocity_3_I_a_sum;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let inv_cos_theta_inv_I_d = inv_I_d * inv_cos_theta;

    // disc_appendix.hyz:112  der(phidot) = (M_b1 + 2*I_d*phidot*thetadot*sin(theta) - I_a*thet …
    let der_phidot = air_velocity_1_product_sum_2 * inv_cos_theta_inv_I_d;
    let angular_velocity_3_I_a_sum_2 = angular_velocity_3_I_a - I_d * sin_theta_phidot;
    let air_velocity_2_product_sum =
        air_velocity_1 * minus_minus_thetadot_sum + air_velocity_2 * thetadot_air_product_sum;
    let part_of_air_velocity_2_product = inv_air_velocity_12_product_3 * air_velocity_2_product_sum;
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
    let cos_theta_sin_phi = cos_theta * sin_phi;
    let d_y_dot_d_theta = x_dot * sin_phi;
    let d_z_dot_d_w = cos_theta * cos_phi;
    let inv_air_velocity_12_sq = inv_air_velocity_12 * inv_air_velocity_12;
    let part_of_half_rho_A_inv_air_sum_4 =
        half_rho_A * inv_air_velocity_12_sq * V_air_velocity_12_C_D_sum;
    let V_C_D = V * C_D;
    let inv_V = V.recip_or_zero();
    let alpha_C_Da_two = C_Da_two * alpha;
    let minus_d_air_velocity_12_C_D_sum_d_alpha =
        C_La * minus_air_velocity_3 - air_velocity_12 * alpha_C_Da_two;
    let part_of_half_rho_A_inv_air_sum =
        minus_air_velocity_3 * minus_d_air_velocity_12_C_D_sum_d_alpha;
    let part_of_half_rho_A_inv_air_sum_2 =
        air_velocity_12 * air_velocity_12_C_D_sum + part_of_half_rho_A_inv_air_sum;
    let part_of_half_rho_A_inv_air_sum_3 =
        inv_air_velocity_12_product * (V_C_D + inv_V * part_of_half_rho_A_inv_air_sum_2);
    let half_rho_A_inv_air_sum =
        part_of_half_rho_A_inv_air_sum_4 - part_of_half_rho_A_inv_air_sum_3;
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let half_rho_A_inv_air_product = half_rho_A_inv_air_sum * air_velocity_1_inv_product;
    let air_velocity_1_inv_m = inv_m * air_velocity_1;
    let inv_air_velocity_12_product_4 = inv_m * inv_air_velocity_12_product_2;
    let d_u_dot_d_u =
        half_rho_A_inv_air_product * air_velocity_1_inv_m - inv_air_velocity_12_product_4;
    let air_velocity_2_inv_m = inv_m * air_velocity_2;
    let air_velocity_2_inv_product = air_velocity_2_inv_m * half_rho_A_inv_air_product;
    let d_u_dot_d_v = sin_theta_phidot + air_velocity_2_inv_product;
    let V_C_L = V * C_L;
    let part_of_inv_air_velocity_12 = air_velocity_12 * minus_d_air_velocity_12_C_D_sum_d_alpha;
    let part_of_inv_air_velocity_12_2 =
        minus_air_velocity_3 * air_velocity_12_C_D_sum - part_of_inv_air_velocity_12;
    let inv_air_velocity_12_product_5 =
        inv_air_velocity_12_product * (V_C_L - inv_V * part_of_inv_air_velocity_12_2);
    let d_u_dot_d_w = -thetadot - inv_air_velocity_12_product_5 * air_velocity_1_inv_m;
    let sin_theta_minus_d_product = sin_theta * minus_d_minus_sin_phi_wind_y_sum_d_phi;
    let d_air_velocity_2_d_phi = -minus_sin_phi_wind_y_sum;
    let part_of_inv_air_velocity_12_3 =
        air_velocity_2 * d_air_velocity_2_d_phi - air_velocity_1 * sin_theta_minus_d_product;
    let inv_air_velocity_12_product_6 = inv_air_velocity_12 * part_of_inv_air_velocity_12_3;
    let cos_theta_minus_d_product = cos_theta * minus_d_minus_sin_phi_wind_y_sum_d_phi;
    let part_of_minus_half_rho_A_inv_sum =
        inv_air_velocity_12_product_5 * cos_theta_minus_d_product;
    let minus_half_rho_A_inv_sum =
        part_of_minus_half_rho_A_inv_sum - half_rho_A_inv_air_sum * inv_air_velocity_12_product_6;
    let part_of_d_u_dot_d_phi =
        inv_air_velocity_12_product_2 * minus_d_minus_sin_phi_wind_y_sum_d_phi;
    let part_of_d_u_dot_d_phi_2 = sin_theta * (sin_phi_g_m - part_of_d_u_dot_d_phi);
    let part_of_d_u_dot_d_phi_3 =
        air_velocity_1 * minus_half_rho_A_inv_sum + part_of_d_u_dot_d_phi_2;
    let part_of_d_air_velocity_1_d_sum =
        minus_d_minus_air_velocity_3_d_theta * inv_air_velocity_12_product_5;
    let d_air_velocity_1_d_sum =
        d_air_velocity_1_d_theta * half_rho_A_inv_air_product - part_of_d_air_velocity_1_d_sum;
    let part_of_d_u_dot_d_theta =
        cos_theta_cos_phi_g_m - inv_air_velocity_12_product_2 * d_air_velocity_1_d_theta;
    let part_of_d_u_dot_d_theta_2 =
        part_of_d_u_dot_d_theta + air_velocity_1 * d_air_velocity_1_d_sum;
    let d_u_dot_d_theta = v_cos_theta_phidot + inv_m * part_of_d_u_dot_d_theta_2;
    let d_u_dot_d_phidot = sin_theta * v;
    let d_v_dot_d_u = air_velocity_2_inv_product - sin_theta_phidot;
    let air_velocity_2_inv_product_2 = air_velocity_2 * inv_air_velocity_12;
    let part_of_d_v_dot_d_v =
        half_rho_A_inv_air_sum * air_velocity_2_inv_product_2 * air_velocity_2_inv_m;
    let d_v_dot_d_v = part_of_d_v_dot_d_v - inv_air_velocity_12_product_4;
    let d_v_dot_d_w = cos_theta_phidot - air_velocity_2_inv_m * inv_air_velocity_12_product_5;
    let part_of_d_v_dot_d_phi =
        cos_phi_g_m + inv_air_velocity_12_product_2 * d_air_velocity_2_d_phi;
    let part_of_d_v_dot_d_phi_2 = part_of_d_v_dot_d_phi + air_velocity_2 * minus_half_rho_A_inv_sum;
    let d_v_dot_d_theta = d_air_velocity_1_d_sum * air_velocity_2_inv_m - x_dot * phidot;
    let air_velocity_12_C_La_sum = C_La * air_velocity_12 + minus_air_velocity_3 * alpha_C_Da_two;
    let part_of_V_C_L_plus_inv_V_part = minus_air_velocity_3 * air_velocity_12_C_La_sum;
    let part_of_V_C_L_plus_inv_V_part_2 =
        air_velocity_12 * minus_air_velocity_3_C_sum - part_of_V_C_L_plus_inv_V_part;
    let V_C_L_plus_inv_V_part_sum = V_C_L + inv_V * part_of_V_C_L_plus_inv_V_part_2;
    let V_C_L_plus_inv_V_product = V_C_L_plus_inv_V_part_sum * air_velocity_1_inv_product;
    let d_w_dot_d_u = thetadot + half_rho_A_inv_m * V_C_L_plus_inv_V_product;
    let part_of_d_w_dot_d_v =
        half_rho_A_inv_m * V_C_L_plus_inv_V_part_sum * air_velocity_2_inv_product_2;
    let d_w_dot_d_v = part_of_d_w_dot_d_v - cos_theta_phidot;
    let part_of_V_C_D_plus_inv_V_part = minus_air_velocity_3 * minus_air_velocity_3_C_sum;
    let part_of_V_C_D_plus_inv_V_part_2 =
        part_of_V_C_D_plus_inv_V_part + air_velocity_12 * air_velocity_12_C_La_sum;
    let V_C_D_plus_inv_V_part_sum = V_C_D + inv_V * part_of_V_C_D_plus_inv_V_part_2;
    let part_of_d_w_dot_d_phi = V_C_L_plus_inv_V_part_sum * inv_air_velocity_12_product_6;
    let part_of_d_w_dot_d_phi_2 =
        part_of_d_w_dot_d_phi - V_C_D_plus_inv_V_part_sum * cos_theta_minus_d_product;
    let d_w_dot_d_phi = g * cos_theta_sin_phi + half_rho_A_inv_m * part_of_d_w_dot_d_phi_2;
    let part_of_d_w_dot_d_theta_3 = sin_theta * (v * phidot + inv_m * cos_phi_g_m);
    let part_of_d_w_dot_d_theta = minus_d_minus_air_velocity_3_d_theta * V_C_D_plus_inv_V_part_sum;
    let part_of_d_w_dot_d_theta_2 =
        d_air_velocity_1_d_theta * V_C_L_plus_inv_V_product - part_of_d_w_dot_d_theta;
    let d_w_dot_d_theta = part_of_d_w_dot_d_theta_3 + half_rho_A_inv_m * part_of_d_w_dot_d_theta_2;
    let inv_air_velocity_12_product_7 =
        inv_air_velocity_12_C_Mq * (air_velocity_1_cos_product - air_velocity_2_thetadot);
    let thetadot_air_product_sum_2 = thetadot_air_product_sum + inv_air_velocity_12_product_7;
    let inv_air_velocity_12_product_8 = inv_air_velocity_12_product_3 * thetadot_air_product_sum_2;
    let inv_V_C_Ma_inv_V = inv_V * (C_Ma * inv_V);
    let part_of_minus_minus_air_sum = C_Mq * minus_thetadot_air_sum * inv_air_velocity_12_sq;
    let minus_minus_air_sum = part_of_minus_minus_air_sum - minus_air_velocity_3 * inv_V_C_Ma_inv_V;
    let air_velocity_2_inv_product_3 = air_velocity_2 * inv_air_velocity_12_product_3;
    let inv_air_velocity_12_product_9 = two_d * inv_air_velocity_12_product;
    let air_velocity_12_inv_product = air_velocity_12 * inv_air_velocity_12_product_9;
    let part_of_minus_minus_air_sum_sum_3 =
        air_velocity_1_product_sum * air_velocity_12_inv_product;
    let air_velocity_1_inv_product_2 = air_velocity_1 * inv_air_velocity_12_product_3;
    let C_Mq_thetadot_air_product = C_Mq * thetadot_air_velocity_2_sum;
    let part_of_minus_minus_air_sum_sum = air_velocity_1_inv_product_2 * C_Mq_thetadot_air_product;
    let V_sq_half_rho_A_d = half_rho_A_d * V_sq;
    let part_of_minus_minus_air_sum_sum_2 =
        part_of_minus_minus_air_sum_sum + air_velocity_1_product_sum * V_sq_half_rho_A_d;
    let part_of_minus_minus_air_sum_sum_5 =
        part_of_minus_minus_air_sum_sum_2 * inv_air_velocity_12_sq;
    let part_of_minus_minus_air_sum_sum_4 =
        minus_minus_air_sum * air_velocity_2_inv_product_3 - part_of_minus_minus_air_sum_sum_3;
    let minus_minus_air_sum_sum =
        part_of_minus_minus_air_sum_sum_4 + part_of_minus_minus_air_sum_sum_5;
    let minus_minus_air_sum_product = minus_minus_air_sum_sum * air_velocity_1_inv_product;
    let minus_inv_air_velocity_sum = minus_minus_air_sum_product - inv_air_velocity_12_product_8;
    let d_phidot_dot_d_u = -(minus_inv_air_velocity_sum * inv_cos_theta_inv_I_d);
    let air_velocity_2_inv_product_4 = air_velocity_2 * inv_air_velocity_12_C_Mq;
    let air_velocity_1_inv_product_3 = air_velocity_1 * inv_air_velocity_12_C_Mq;
    let cos_theta_phidot_sum =
        cos_theta_phidot * air_velocity_2_inv_product_4 + thetadot * air_velocity_1_inv_product_3;
    let part_of_minus_minus_air_sum_sum_6 =
        inv_air_velocity_12_product_3 * (minus_minus_thetadot_sum - cos_theta_phidot_sum);
    let minus_minus_air_sum_sum_2 =
        minus_minus_air_sum_sum * air_velocity_2_inv_product_2 + part_of_minus_minus_air_sum_sum_6;
    let d_phidot_dot_d_v = -(minus_minus_air_sum_sum_2 * inv_cos_theta_inv_I_d);
    let air_velocity_12_inv_product_2 = air_velocity_12 * inv_V_C_Ma_inv_V;
    let part_of_minus_air_velocity_2_sum =
        air_velocity_2_inv_product_3 * air_velocity_12_inv_product_2;
    let minus_air_velocity_product = minus_air_velocity_3 * inv_air_velocity_12_product_9;
    let minus_air_velocity_2_sum =
        air_velocity_1_product_sum * minus_air_velocity_product - part_of_minus_air_velocity_2_sum;
    let d_phidot_dot_d_minus_air_velocity_3 = minus_air_velocity_2_sum * inv_cos_theta_inv_I_d;
    let part_of_inv_I_d_minus_d_product =
        minus_d_minus_sin_phi_wind_y_sum_d_phi * minus_air_velocity_2_sum;
    let part_of_inv_I_d_minus_d_product_2 =
        inv_air_velocity_12_C_Mq * (air_velocity_2_cos_product + air_velocity_1_thetadot);
    let part_of_inv_I_d_minus_d_product_3 =
        d_air_velocity_2_d_phi * (minus_minus_thetadot_sum - part_of_inv_I_d_minus_d_product_2);
    let part_of_inv_I_d_minus_d_product_4 =
        thetadot_air_product_sum_2 * sin_theta_minus_d_product + part_of_inv_I_d_minus_d_product_3;
    let part_of_inv_I_d_minus_d_product_5 =
        inv_air_velocity_12_product_3 * part_of_inv_I_d_minus_d_product_4;
    let part_of_inv_I_d_minus_d_product_6 =
        minus_minus_air_sum_sum * inv_air_velocity_12_product_6 + part_of_inv_I_d_minus_d_product_5;
    let part_of_inv_I_d_minus_d_product_7 =
        part_of_inv_I_d_minus_d_product + inv_cos_theta * part_of_inv_I_d_minus_d_product_6;
    let inv_I_d_minus_d_product = inv_I_d * part_of_inv_I_d_minus_d_product_7;
    let d_phidot_dot_d_phi = -inv_I_d_minus_d_product;
    let sin_theta_inv_cos_product = sin_theta * inv_cos_theta_inv_I_d;
    let air_velocity_2_inv_product_5 = air_velocity_2_inv_product_3 * air_velocity_2_inv_product_4;
    let part_of_d_der_phidot_d_theta =
        phidot * sin_theta_inv_cos_product * air_velocity_2_inv_product_5;
    let thetadot_phidot = thetadot * phidot;
    let part_of_d_der_phidot_d_theta_2 =
        part_of_d_der_phidot_d_theta + minus_two_plus_I_a_inv_I_d * thetadot_phidot;
    let part_of_d_der_phidot_d_theta_3 =
        air_velocity_1_product_sum_2 * inv_cos_theta * sin_theta_inv_cos_product;
    let d_air_velocity_1_d_product = d_air_velocity_1_d_theta * inv_cos_theta_inv_I_d;
    let sin_theta_air_product = sin_theta * air_velocity_1_inv_product_3;
    let minus_cos_theta_C_Rr_sum = sin_theta_air_product - C_Rr * cos_theta;
    let inv_cos_theta_inv_I_product = inv_cos_theta_inv_I_d * air_velocity_1_inv_product_2;
    let part_of_d_der_phidot_d_theta_4 =
        phidot * minus_cos_theta_C_Rr_sum * inv_cos_theta_inv_I_product;
    let part_of_d_der_phidot_d_theta_5 =
        inv_air_velocity_12_product_8 * d_air_velocity_1_d_product - part_of_d_der_phidot_d_theta_4;
    let part_of_d_der_phidot_d_theta_6 =
        part_of_d_der_phidot_d_theta_3 + part_of_d_der_phidot_d_theta_5;
    let d_der_phidot_d_theta = part_of_d_der_phidot_d_theta_6 - part_of_d_der_phidot_d_theta_2;
    let part_of_d_phidot_dot_d_theta =
        minus_d_minus_air_velocity_3_d_theta * d_phidot_dot_d_minus_air_velocity_3;
    let part_of_d_phidot_dot_d_theta_2 =
        d_air_velocity_1_d_product * minus_minus_air_sum_product + part_of_d_phidot_dot_d_theta;
    let d_phidot_dot_d_theta = d_der_phidot_d_theta - part_of_d_phidot_dot_d_theta_2;
    let part_of_d_der_phidot_d_phidot =
        minus_two_plus_I_a_inv_I_d * sin_theta * thetadot * inv_cos_theta;
    let cos_theta_air_product = cos_theta * air_velocity_1_inv_product_3;
    let d_thetadot_air_product_sum_d_phidot = C_Rr * sin_theta + cos_theta_air_product;
    let part_of_d_der_phidot_d_phidot_2 =
        d_thetadot_air_product_sum_d_phidot * inv_cos_theta_inv_I_product;
    let inv_I_d_air_product = inv_I_d * air_velocity_2_inv_product_5;
    let d_der_phidot_d_phidot =
        part_of_d_der_phidot_d_phidot_2 + inv_I_d_air_product - part_of_d_der_phidot_d_phidot;
    let C_Rr_air_velocity_1_sum = C_Rr * air_velocity_1_inv_product_2 - I_a * thetadot;
    let part_of_minus_minus_minus_air = air_velocity_2_inv_product_3 * C_Mq_thetadot_air_product;
    let part_of_minus_minus_minus_air_2 =
        part_of_minus_minus_minus_air + air_velocity_2_product_sum * V_sq_half_rho_A_d;
    let part_of_minus_minus_minus_air_3 = part_of_minus_minus_minus_air_2 * inv_air_velocity_12_sq;
    let part_of_minus_minus_minus_air_4 =
        part_of_minus_minus_minus_air_3 - minus_minus_air_sum * air_velocity_1_inv_product_2;
    let minus_minus_minus_air_sum =
        part_of_minus_minus_minus_air_4 - air_velocity_2_product_sum * air_velocity_12_inv_product;
    let minus_minus_thetadot_sum_2 = minus_minus_thetadot_sum + cos_theta_phidot_sum;
    let part_of_minus_minus_minus_sum = inv_air_velocity_12_product_3 * minus_minus_thetadot_sum_2;
    let minus_minus_minus_sum =
        minus_minus_minus_air_sum * air_velocity_1_inv_product - part_of_minus_minus_minus_sum;
    let thetadot_air_product_sum_3 = thetadot_air_product_sum - inv_air_velocity_12_product_7;
    let part_of_d_thetadot_dot_d_v = inv_air_velocity_12_product_3 * thetadot_air_product_sum_3;
    let part_of_d_thetadot_dot_d_v_2 =
        minus_minus_minus_air_sum * air_velocity_2_inv_product_2 - part_of_d_thetadot_dot_d_v;
    let part_of_air_velocity_1_inv_sum =
        air_velocity_1_inv_product_2 * air_velocity_12_inv_product_2;
    let air_velocity_1_inv_sum =
        part_of_air_velocity_1_inv_sum + air_velocity_2_product_sum * minus_air_velocity_product;
    let part_of_d_thetadot_dot_d_phi_3 = minus_minus_minus_air_sum * inv_air_velocity_12_product_6;
    let part_of_d_thetadot_dot_d_phi = minus_minus_thetadot_sum_2 * sin_theta_minus_d_product;
    let part_of_d_thetadot_dot_d_phi_2 =
        part_of_d_thetadot_dot_d_phi - d_air_velocity_2_d_phi * thetadot_air_product_sum_3;
    let part_of_d_thetadot_dot_d_phi_5 =
        inv_air_velocity_12_product_3 * part_of_d_thetadot_dot_d_phi_2;
    let part_of_d_thetadot_dot_d_phi_4 =
        part_of_d_thetadot_dot_d_phi_3 + air_velocity_1_inv_sum * cos_theta_minus_d_product;
    let part_of_d_thetadot_dot_d_phi_6 =
        minus_inv_I_d * (part_of_d_thetadot_dot_d_phi_4 + part_of_d_thetadot_dot_d_phi_5);
    let cos_theta_phidot_product = minus_one_plus_I_a_inv_I_d * cos_theta_phidot;
    let part_of_d_thetadot_dot_d_theta_3 =
        minus_d_minus_air_velocity_3_d_theta * air_velocity_1_inv_sum;
    let part_of_d_thetadot_dot_d_theta =
        (sin_theta_air_product - minus_cos_theta_C_Rr_sum) * air_velocity_2_inv_product_3;
    let part_of_d_thetadot_dot_d_theta_2 =
        sin_theta * angular_velocity_3_I_a_sum_2 - part_of_d_thetadot_dot_d_theta;
    let part_of_d_thetadot_dot_d_theta_4 =
        part_of_d_thetadot_dot_d_theta_3 + phidot * part_of_d_thetadot_dot_d_theta_2;
    let part_of_d_thetadot_dot_d_theta_5 =
        part_of_d_thetadot_dot_d_theta_4 + d_air_velocity_1_d_theta * minus_minus_minus_sum;
    let d_thetadot_dot_d_theta =
        cos_theta_phidot * cos_theta_phidot_product - inv_I_d * part_of_d_thetadot_dot_d_theta_5;
    let part_of_d_thetadot_dot_d_phidot =
        cos_theta_air_product - d_thetadot_air_product_sum_d_phidot;
    let part_of_d_thetadot_dot_d_phidot_2 =
        part_of_d_thetadot_dot_d_phidot * air_velocity_2_inv_product_3;
    let part_of_d_thetadot_dot_d_phidot_3 =
        cos_theta * angular_velocity_3_I_a_sum_2 - part_of_d_thetadot_dot_d_phidot_2;
    let d_thetadot_dot_d_phidot =
        sin_theta * cos_theta_phidot_product + inv_I_d * part_of_d_thetadot_dot_d_phidot_3;
    let part_of_d_thetadot_dot_d =
        inv_I_d * air_velocity_1_inv_product_2 * air_velocity_1_inv_product_3;
    let d_thetadot_dot_d_thetadot = inv_I_d_air_product + part_of_d_thetadot_dot_d;
    let d_thetadot_dot_d_angular_velocity_3 = I_a_inv_I_d * cos_theta_phidot;
    let d_thetadot_dot_d_gammadot =
        C_Rr_inv_I_d * air_velocity_2_inv_product_3 + d_thetadot_dot_d_angular_velocity_3;
    let d_gammadot_dot_d_u = minus_inv_air_velocity_sum * sin_theta_inv_cos_product;
    let d_gammadot_dot_d_v = minus_minus_air_sum_sum_2 * sin_theta_inv_cos_product;
    let d_gammadot_dot_d_w = minus_air_velocity_2_sum * sin_theta_inv_cos_product;
    let d_gammadot_dot_d_phi = sin_theta * inv_I_d_minus_d_product;
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * (der_phidot - d_gammadot_dot_d_angular_velocity_3 * phidot);
    let d_gammadot_dot_d_theta =
        sin_theta * (thetadot_phidot - d_phidot_dot_d_theta) - part_of_d_gammadot_dot_d_theta;
    let part_of_d_gammadot_dot_d_phidot =
        sin_theta * (d_gammadot_dot_d_angular_velocity_3 - d_der_phidot_d_phidot);
    let d_gammadot_dot_d_phidot = part_of_d_gammadot_dot_d_phidot - cos_theta * thetadot;
    let d_gammadot_dot_d_thetadot =
        angular_velocity_3_I_a_sum * sin_theta_inv_cos_product - cos_theta_phidot;
    let d_gammadot_dot_d_gammadot =
        d_gammadot_dot_d_angular_velocity_3 - C_Rr_air_velocity_1_sum * sin_theta_inv_cos_product;
    let d_y_dot_d_w = -cos_theta_sin_phi;
    let d_y_dot_d_phi = -z_dot;
    let d_z_dot_d_u = -(sin_theta * cos_phi);
    let d_z_dot_d_theta = -(x_dot * cos_phi);
    let d_u_dot_d_thetadot = -w;
    let d_w_dot_d_phidot = -(cos_theta * v);
    let d_phidot_dot_d_w = -d_phidot_dot_d_minus_air_velocity_3;
    let d_phidot_dot_d_thetadot = -(angular_velocity_3_I_a_sum * inv_cos_theta_inv_I_d);

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
    j[13] = d_u_dot_d_u;
    j[14] = d_u_dot_d_v;
    j[15] = d_u_dot_d_w;
    j[16] = minus_inv_m * part_of_d_u_dot_d_phi_3; // d_u_dot_d_phi
    j[17] = d_u_dot_d_theta;
    j[18] = d_u_dot_d_phidot;
    j[19] = d_u_dot_d_thetadot;
    j[20] = d_v_dot_d_u;
    j[21] = d_v_dot_d_v;
    j[22] = d_v_dot_d_w;
    j[23] = minus_inv_m * part_of_d_v_dot_d_phi_2; // d_v_dot_d_phi
    j[24] = d_v_dot_d_theta;
    j[25] = w_cos_theta_minus_sin_sum; // d_v_dot_d_phidot
    j[26] = d_w_dot_d_u;
    j[27] = d_w_dot_d_v;
    j[28] = minus_half_rho_A_inv_m * V_C_D_plus_inv_V_part_sum; // d_w_dot_d_w
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
    j[41] = d_der_phidot_d_phidot; // d_phidot_dot_d_phidot
    j[42] = d_phidot_dot_d_thetadot;
    j[43] = C_Rr_air_velocity_1_sum * inv_cos_theta_inv_I_d; // d_phidot_dot_d_gammadot
    j[44] = minus_inv_I_d * minus_minus_minus_sum; // d_thetadot_dot_d_u
    j[45] = minus_inv_I_d * part_of_d_thetadot_dot_d_v_2; // d_thetadot_dot_d_v
    j[46] = minus_inv_I_d * air_velocity_1_inv_sum; // d_thetadot_dot_d_w
    j[47] = part_of_d_thetadot_dot_d_phi_6; // d_thetadot_dot_d_phi
    j[48] = d_thetadot_dot_d_theta;
    j[49] = d_thetadot_dot_d_phidot;
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
