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
    let p6_p0 = prepared[0];
    let half_p5_p4 = prepared[1];
    let inv_p0 = prepared[2];
    let p2_two = prepared[3];
    let inv_p2 = prepared[4];
    let inv_p1 = prepared[5];
    let p10_two = prepared[6];
    let minus_inv_p0 = prepared[7];
    let p4_p5_half_inv_p0 = prepared[8];
    let minus_p4_p5_half_inv_p0 = prepared[9];
    let two_p3 = prepared[10];
    let p4_p5_half_p3 = prepared[11];
    let p1_inv_p2 = prepared[12];
    let minus_two_plus_p1_inv_p2 = prepared[13];
    let minus_inv_p2 = prepared[14];
    let minus_n1_plus_p1_inv_p2 = prepared[15];
    let p13_inv_p2 = prepared[16];
    let p14_inv_p1 = prepared[17];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // disc_appendix.hyz:122  der(x) = u*cos(theta) + w*sin(theta);
    let x_dot = u * cos_theta + w * sin_theta;
    let minus_u_sin_theta_plus_sum = cos_theta * w - u * sin_theta;
    let (sin_phi, cos_phi) = phi.sin_cos();

    // disc_appendix.hyz:123  der(y) = u*sin(theta)*sin(phi) + v*cos(phi) - w*cos(theta)*sin(phi);
    let y_dot = v * cos_phi - minus_u_sin_theta_plus_sum * sin_phi;

    // disc_appendix.hyz:124  der(z) = -u*sin(theta)*cos(phi) + v*sin(phi) + w*cos(theta)*cos(p …
    let z_dot = minus_u_sin_theta_plus_sum * cos_phi + sin_phi * v;
    let cos_phi_wind_z_minus_sum = wind_z * cos_phi - wind_y * sin_phi;
    let minus_cos_theta_wind_x_sum = sin_theta * cos_phi_wind_z_minus_sum - wind_x * cos_theta;

    // disc_appendix.hyz:67  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u + minus_cos_theta_wind_x_sum;
    let cos_phi_wind_y_plus_sin_sum = wind_y * cos_phi + wind_z * sin_phi;
    let air_velocity_2 = v - cos_phi_wind_y_plus_sin_sum;
    let air_velocity_1_sq_plus_sum =
        air_velocity_1 * air_velocity_1 + air_velocity_2 * air_velocity_2;
    let sqrt_air_velocity_1_sq_of = air_velocity_1_sq_plus_sum.sqrt();
    let inv_sqrt_air_velocity_1_of = sqrt_air_velocity_1_sq_of.recip_or_zero();
    let A_rho_half_inv_sqrt_product = half_p5_p4 * inv_sqrt_air_velocity_1_of;
    let cos_theta_cos_phi_sum = cos_theta * cos_phi_wind_z_minus_sum + wind_x * sin_theta;
    let minus_w_plus_cos_theta_sum = cos_theta_cos_phi_sum - w;
    let minus_w_plus_cos_sum =
        minus_w_plus_cos_theta_sum * minus_w_plus_cos_theta_sum + air_velocity_1_sq_plus_sum;

    // disc_appendix.hyz:69  let V = norm(air_velocity);
    let V = minus_w_plus_cos_sum.sqrt();

    // disc_appendix.hyz:74  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_w_plus_cos_theta_sum.atan2(sqrt_air_velocity_1_sq_of);

    // disc_appendix.hyz:77  let C_L = C_L0 + C_La*alpha;
    let C_L = C_L0 + C_La * alpha;

    // disc_appendix.hyz:78  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_D0 + C_Da * alpha * alpha;
    let minus_minus_w_plus_cos_sum =
        sqrt_air_velocity_1_sq_of * C_D - minus_w_plus_cos_theta_sum * C_L;
    let V_minus_minus_w_plus_cos_sum = V * minus_minus_w_plus_cos_sum;
    let A_rho_half_inv_sqrt_product_2 = A_rho_half_inv_sqrt_product * V_minus_minus_w_plus_cos_sum;
    let cos_phi_m_g = p6_p0 * cos_phi;
    let part_of_u_dot = air_velocity_1 * A_rho_half_inv_sqrt_product_2 - sin_theta * cos_phi_m_g;
    let sin_theta_phidot = sin_theta * phidot;

    // disc_appendix.hyz:102  der(u) = F_b1/m - w*thetadot + v*phidot*sin(theta);
    let u_dot = v * sin_theta_phidot - inv_p0 * part_of_u_dot - w * thetadot;
    let sin_phi_m_g = p6_p0 * sin_phi;
    let part_of_v_dot = inv_p0 * (air_velocity_2 * A_rho_half_inv_sqrt_product_2 + sin_phi_m_g);

    // disc_appendix.hyz:104  der(v) = F_b2/m + w*phidot*cos(theta) - u*phidot*sin(theta);
    let v_dot = minus_u_sin_theta_plus_sum * phidot - part_of_v_dot;
    let sqrt_air_velocity_1_sum =
        sqrt_air_velocity_1_sq_of * C_L + minus_w_plus_cos_theta_sum * C_D;
    let cos_theta_cos_phi_m_g = cos_theta * cos_phi_m_g;

    // disc_appendix.hyz:91  let force_b = (lift*sin(alpha) - drag*cos(alpha))*d1 + (lift*cos(a …
    let force_b_3 = half_p5_p4 * V * sqrt_air_velocity_1_sum - cos_theta_cos_phi_m_g;
    let cos_theta_phidot = cos_theta * phidot;
    let v_cos_theta_phidot = v * cos_theta_phidot;

    // disc_appendix.hyz:106  der(w) = F_b3/m + u*thetadot - v*phidot*cos(theta);
    let w_dot = inv_p0 * force_b_3 + u * thetadot - v_cos_theta_phidot;

    // disc_appendix.hyz:64  let angular_velocity = (phidot*cos(theta), thetadot, phidot*sin(th …
    let angular_velocity_3 = sin_theta_phidot + gammadot;
    let I_a_angular_velocity_3 = I_a * angular_velocity_3;
    let I_a_angular_velocity_3_sum = I_a_angular_velocity_3 - p2_two * sin_theta_phidot;
    let minus_w_plus_cos_product = d * minus_w_plus_cos_sum * A_rho_half_inv_sqrt_product;
    let air_velocity_2_cos_product = air_velocity_2 * cos_theta_phidot;
    let air_velocity_1_thetadot = air_velocity_1 * thetadot;
    let air_velocity_2_cos_sum = air_velocity_2_cos_product - air_velocity_1_thetadot;
    let inv_sqrt_air_product = C_Mq * inv_sqrt_air_velocity_1_of;
    let alpha_C_Ma_minus_air_sum = C_Ma * alpha - air_velocity_2_cos_sum * inv_sqrt_air_product;
    let air_velocity_1_cos_product = air_velocity_1 * cos_theta_phidot;
    let air_velocity_2_thetadot = air_velocity_2 * thetadot;
    let air_velocity_1_cos_sum = air_velocity_1_cos_product + air_velocity_2_thetadot;
    let angular_velocity_3_C_Rr_sum =
        C_Rr * angular_velocity_3 + inv_sqrt_air_product * air_velocity_1_cos_sum;
    let minus_air_velocity_2_sum =
        air_velocity_1 * angular_velocity_3_C_Rr_sum - air_velocity_2 * alpha_C_Ma_minus_air_sum;
    let minus_thetadot_I_a_sum =
        minus_w_plus_cos_product * minus_air_velocity_2_sum - thetadot * I_a_angular_velocity_3_sum;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let inv_cos_theta_inv_I_d = inv_p2 * inv_cos_theta;

    // disc_appendix.hyz:112  der(phidot) = (M_b1 + 2*I_d*phidot*thetadot*sin(theta) - I_a*thet …
    let der_phidot = minus_thetadot_I_a_sum * inv_cos_theta_inv_I_d;
    let minus_sin_theta_phidot_sum = I_a_angular_velocity_3 - I_d * sin_theta_phidot;
    let air_velocity_1_product_sum =
        air_velocity_1 * alpha_C_Ma_minus_air_sum + air_velocity_2 * angular_velocity_3_C_Rr_sum;
    let part_of_thetadot_dot = minus_w_plus_cos_product * air_velocity_1_product_sum;
    let part_of_thetadot_dot_2 =
        cos_theta_phidot * minus_sin_theta_phidot_sum + part_of_thetadot_dot;

    // disc_appendix.hyz:115  der(thetadot) = (M_b2 - I_d*phidot^2*cos(theta)*sin(theta) + I_a* …
    let thetadot_dot = inv_p2 * part_of_thetadot_dot_2;

    // disc_appendix.hyz:88  let spin_down = C_Nr*r;
    let spin_down = C_Nr * angular_velocity_3;
    let part_of_gammadot_dot =
        spin_down - I_a * (sin_theta * der_phidot + thetadot * cos_theta_phidot);

    // disc_appendix.hyz:119  der(gammadot) = (M_b3 - I_a*(der(phidot)*sin(theta) + phidot*thet …
    let gammadot_dot = inv_p1 * part_of_gammadot_dot;
    let cos_theta_sin_phi = cos_theta * sin_phi;
    let inv_sqrt_air_product_2 = inv_sqrt_air_velocity_1_of * inv_sqrt_air_velocity_1_of;
    let part_of_part_part_half_inv_sum =
        half_p5_p4 * inv_sqrt_air_product_2 * V_minus_minus_w_plus_cos_sum;
    let V_C_D = V * C_D;
    let inv_V = V.recip_or_zero();
    let part_of_part_part_half_inv_sum_2 = sqrt_air_velocity_1_sq_of * minus_minus_w_plus_cos_sum;
    let alpha_C_Da_two = p10_two * alpha;
    let minus_w_plus_cos_sum_2 =
        C_La * minus_w_plus_cos_theta_sum - sqrt_air_velocity_1_sq_of * alpha_C_Da_two;
    let part_of_part_part_half_inv_sum_3 =
        part_of_part_part_half_inv_sum_2 + minus_w_plus_cos_theta_sum * minus_w_plus_cos_sum_2;
    let part_of_part_part_half_inv_sum_4 =
        A_rho_half_inv_sqrt_product * (V_C_D + inv_V * part_of_part_part_half_inv_sum_3);
    let part_part_half_inv_sum = part_of_part_part_half_inv_sum - part_of_part_part_half_inv_sum_4;
    let air_velocity_1_inv_product = air_velocity_1 * inv_sqrt_air_velocity_1_of;
    let part_part_half_inv_product = part_part_half_inv_sum * air_velocity_1_inv_product;
    let air_velocity_1_inv_m = inv_p0 * air_velocity_1;
    let A_rho_half_inv_sqrt_product_3 = inv_p0 * A_rho_half_inv_sqrt_product_2;
    let part_of_d_u_dot_d_u =
        part_part_half_inv_product * air_velocity_1_inv_m - A_rho_half_inv_sqrt_product_3;
    let air_velocity_2_inv_m = inv_p0 * air_velocity_2;
    let air_velocity_2_inv_product = air_velocity_2_inv_m * part_part_half_inv_product;
    let V_C_L = V * C_L;
    let part_of_A_rho_half_inv_sqrt_product_4 =
        minus_w_plus_cos_theta_sum * minus_minus_w_plus_cos_sum;
    let part_of_A_rho_half_inv_sqrt_product_4_2 =
        part_of_A_rho_half_inv_sqrt_product_4 - sqrt_air_velocity_1_sq_of * minus_w_plus_cos_sum_2;
    let A_rho_half_inv_sqrt_product_4 =
        A_rho_half_inv_sqrt_product * (V_C_L - inv_V * part_of_A_rho_half_inv_sqrt_product_4_2);
    let sin_theta_cos_phi_product = sin_theta * cos_phi_wind_y_plus_sin_sum;
    let minus_cos_phi_wind_z_sum = -cos_phi_wind_z_minus_sum;
    let part_of_inv_sqrt_air_product_3 =
        air_velocity_2 * minus_cos_phi_wind_z_sum - air_velocity_1 * sin_theta_cos_phi_product;
    let inv_sqrt_air_product_3 = inv_sqrt_air_velocity_1_of * part_of_inv_sqrt_air_product_3;
    let cos_theta_cos_phi_product = cos_theta * cos_phi_wind_y_plus_sin_sum;
    let part_of_minus_part_part_half_sum =
        A_rho_half_inv_sqrt_product_4 * cos_theta_cos_phi_product;
    let minus_part_part_half_sum =
        part_of_minus_part_part_half_sum - part_part_half_inv_sum * inv_sqrt_air_product_3;
    let part_of_d_u_dot_d_phi =
        sin_phi_m_g - A_rho_half_inv_sqrt_product_2 * cos_phi_wind_y_plus_sin_sum;
    let part_of_d_u_dot_d_phi_2 =
        air_velocity_1 * minus_part_part_half_sum + sin_theta * part_of_d_u_dot_d_phi;
    let part_of_cos_theta_cos_phi_sum_2 =
        minus_cos_theta_wind_x_sum * A_rho_half_inv_sqrt_product_4;
    let cos_theta_cos_phi_sum_2 =
        cos_theta_cos_phi_sum * part_part_half_inv_product - part_of_cos_theta_cos_phi_sum_2;
    let part_of_d_u_dot_d_theta =
        cos_theta_cos_phi_m_g - A_rho_half_inv_sqrt_product_2 * cos_theta_cos_phi_sum;
    let part_of_d_u_dot_d_theta_2 =
        part_of_d_u_dot_d_theta + air_velocity_1 * cos_theta_cos_phi_sum_2;
    let air_velocity_2_inv_product_2 = air_velocity_2 * inv_sqrt_air_velocity_1_of;
    let part_of_d_v_dot_d_v =
        part_part_half_inv_sum * air_velocity_2_inv_product_2 * air_velocity_2_inv_m;
    let part_of_d_v_dot_d_w =
        cos_theta_phidot - air_velocity_2_inv_m * A_rho_half_inv_sqrt_product_4;
    let part_of_d_v_dot_d_phi =
        cos_phi_m_g + A_rho_half_inv_sqrt_product_2 * minus_cos_phi_wind_z_sum;
    let part_of_d_v_dot_d_phi_2 = part_of_d_v_dot_d_phi + air_velocity_2 * minus_part_part_half_sum;
    let sqrt_air_velocity_1_sum_2 =
        C_La * sqrt_air_velocity_1_sq_of + minus_w_plus_cos_theta_sum * alpha_C_Da_two;
    let part_of_V_C_L_plus_inv_V_part_sum = minus_w_plus_cos_theta_sum * sqrt_air_velocity_1_sum_2;
    let part_of_V_C_L_plus_inv_V_part_sum_2 =
        sqrt_air_velocity_1_sq_of * sqrt_air_velocity_1_sum - part_of_V_C_L_plus_inv_V_part_sum;
    let V_C_L_plus_inv_V_part_sum = V_C_L + inv_V * part_of_V_C_L_plus_inv_V_part_sum_2;
    let V_C_L_plus_inv_V_product = V_C_L_plus_inv_V_part_sum * air_velocity_1_inv_product;
    let part_of_d_w_dot_d_v =
        p4_p5_half_inv_p0 * V_C_L_plus_inv_V_part_sum * air_velocity_2_inv_product_2;
    let part_of_V_C_D_plus_inv_V_part_sum = sqrt_air_velocity_1_sq_of * sqrt_air_velocity_1_sum_2;
    let part_of_V_C_D_plus_inv_V_part_sum_2 =
        minus_w_plus_cos_theta_sum * sqrt_air_velocity_1_sum + part_of_V_C_D_plus_inv_V_part_sum;
    let V_C_D_plus_inv_V_part_sum = V_C_D + inv_V * part_of_V_C_D_plus_inv_V_part_sum_2;
    let part_of_d_w_dot_d_phi = V_C_D_plus_inv_V_part_sum * cos_theta_cos_phi_product;
    let part_of_d_w_dot_d_phi_2 =
        V_C_L_plus_inv_V_part_sum * inv_sqrt_air_product_3 - part_of_d_w_dot_d_phi;
    let part_of_d_w_dot_d_phi_3 =
        g * cos_theta_sin_phi + p4_p5_half_inv_p0 * part_of_d_w_dot_d_phi_2;
    let part_of_d_w_dot_d_theta_3 = sin_theta * (v * phidot + inv_p0 * cos_phi_m_g);
    let part_of_d_w_dot_d_theta = minus_cos_theta_wind_x_sum * V_C_D_plus_inv_V_part_sum;
    let part_of_d_w_dot_d_theta_2 =
        cos_theta_cos_phi_sum * V_C_L_plus_inv_V_product - part_of_d_w_dot_d_theta;
    let part_of_d_w_dot_d_theta_4 =
        part_of_d_w_dot_d_theta_3 + p4_p5_half_inv_p0 * part_of_d_w_dot_d_theta_2;
    let inv_sqrt_air_product_4 =
        inv_sqrt_air_product * (air_velocity_1_cos_product - air_velocity_2_thetadot);
    let angular_velocity_3_C_Rr_sum_2 = angular_velocity_3_C_Rr_sum + inv_sqrt_air_product_4;
    let minus_w_plus_cos_product_2 = minus_w_plus_cos_product * angular_velocity_3_C_Rr_sum_2;
    let inv_V_C_Ma_inv_V = inv_V * (C_Ma * inv_V);
    let part_of_minus_minus_w_plus_cos_sum_2 =
        C_Mq * air_velocity_2_cos_sum * inv_sqrt_air_product_2;
    let minus_minus_w_plus_cos_sum_2 =
        part_of_minus_minus_w_plus_cos_sum_2 - minus_w_plus_cos_theta_sum * inv_V_C_Ma_inv_V;
    let air_velocity_2_product = air_velocity_2 * minus_w_plus_cos_product;
    let A_rho_half_inv_sqrt_product_5 = two_p3 * A_rho_half_inv_sqrt_product;
    let sqrt_air_velocity_1_product = sqrt_air_velocity_1_sq_of * A_rho_half_inv_sqrt_product_5;
    let part_of_minus_minus_w_plus_sum_3 = minus_air_velocity_2_sum * sqrt_air_velocity_1_product;
    let air_velocity_1_product = air_velocity_1 * minus_w_plus_cos_product;
    let C_Mq_air_velocity_1_cos_sum = C_Mq * air_velocity_1_cos_sum;
    let minus_w_plus_cos_product_3 = p4_p5_half_p3 * minus_w_plus_cos_sum;
    let part_of_minus_minus_w_plus_sum = minus_air_velocity_2_sum * minus_w_plus_cos_product_3;
    let part_of_minus_minus_w_plus_sum_2 =
        air_velocity_1_product * C_Mq_air_velocity_1_cos_sum + part_of_minus_minus_w_plus_sum;
    let part_of_minus_minus_w_plus_sum_5 =
        part_of_minus_minus_w_plus_sum_2 * inv_sqrt_air_product_2;
    let part_of_minus_minus_w_plus_sum_4 =
        minus_minus_w_plus_cos_sum_2 * air_velocity_2_product - part_of_minus_minus_w_plus_sum_3;
    let minus_minus_w_plus_sum =
        part_of_minus_minus_w_plus_sum_4 + part_of_minus_minus_w_plus_sum_5;
    let minus_minus_w_plus_product = minus_minus_w_plus_sum * air_velocity_1_inv_product;
    let minus_minus_w_plus_cos_sum_3 = minus_minus_w_plus_product - minus_w_plus_cos_product_2;
    let minus_minus_minus_w_sum = -(minus_minus_w_plus_cos_sum_3 * inv_cos_theta_inv_I_d);
    let air_velocity_2_inv_product_3 = air_velocity_2 * inv_sqrt_air_product;
    let air_velocity_1_inv_product_2 = air_velocity_1 * inv_sqrt_air_product;
    let cos_theta_phidot_sum =
        cos_theta_phidot * air_velocity_2_inv_product_3 + thetadot * air_velocity_1_inv_product_2;
    let part_of_minus_minus_w_plus_sum_2_2 =
        minus_w_plus_cos_product * (alpha_C_Ma_minus_air_sum - cos_theta_phidot_sum);
    let minus_minus_w_plus_sum_2 =
        minus_minus_w_plus_sum * air_velocity_2_inv_product_2 + part_of_minus_minus_w_plus_sum_2_2;
    let minus_minus_minus_w_sum_2 = -(minus_minus_w_plus_sum_2 * inv_cos_theta_inv_I_d);
    let sqrt_air_velocity_1_product_2 = sqrt_air_velocity_1_sq_of * inv_V_C_Ma_inv_V;
    let part_of_minus_air_velocity_2_sum_2 = air_velocity_2_product * sqrt_air_velocity_1_product_2;
    let minus_w_plus_cos_product_4 = minus_w_plus_cos_theta_sum * A_rho_half_inv_sqrt_product_5;
    let minus_air_velocity_2_sum_2 =
        minus_air_velocity_2_sum * minus_w_plus_cos_product_4 - part_of_minus_air_velocity_2_sum_2;
    let minus_air_velocity_product = minus_air_velocity_2_sum_2 * inv_cos_theta_inv_I_d;
    let part_of_inv_I_d_cos_phi_product_7 =
        cos_phi_wind_y_plus_sin_sum * minus_air_velocity_2_sum_2;
    let part_of_inv_I_d_cos_phi_product_3 =
        angular_velocity_3_C_Rr_sum_2 * sin_theta_cos_phi_product;
    let part_of_inv_I_d_cos_phi_product =
        inv_sqrt_air_product * (air_velocity_2_cos_product + air_velocity_1_thetadot);
    let part_of_inv_I_d_cos_phi_product_2 =
        minus_cos_phi_wind_z_sum * (alpha_C_Ma_minus_air_sum - part_of_inv_I_d_cos_phi_product);
    let part_of_inv_I_d_cos_phi_product_4 =
        part_of_inv_I_d_cos_phi_product_3 + part_of_inv_I_d_cos_phi_product_2;
    let part_of_inv_I_d_cos_phi_product_5 =
        minus_w_plus_cos_product * part_of_inv_I_d_cos_phi_product_4;
    let part_of_inv_I_d_cos_phi_product_6 =
        minus_minus_w_plus_sum * inv_sqrt_air_product_3 + part_of_inv_I_d_cos_phi_product_5;
    let part_of_inv_I_d_cos_phi_product_8 =
        part_of_inv_I_d_cos_phi_product_7 + inv_cos_theta * part_of_inv_I_d_cos_phi_product_6;
    let inv_I_d_cos_phi_product = inv_p2 * part_of_inv_I_d_cos_phi_product_8;
    let minus_inv_I_d_cos_phi_sum = -inv_I_d_cos_phi_product;
    let sin_theta_inv_cos_product = sin_theta * inv_cos_theta_inv_I_d;
    let air_velocity_2_product_2 = air_velocity_2_product * air_velocity_2_inv_product_3;
    let part_of_minus_part_part_part_sum =
        phidot * sin_theta_inv_cos_product * air_velocity_2_product_2;
    let thetadot_phidot = thetadot * phidot;
    let part_of_minus_part_part_part_sum_2 =
        part_of_minus_part_part_part_sum + minus_two_plus_p1_inv_p2 * thetadot_phidot;
    let part_of_minus_part_part_part_sum_3 =
        minus_thetadot_I_a_sum * inv_cos_theta * sin_theta_inv_cos_product;
    let cos_theta_cos_phi_product_2 = cos_theta_cos_phi_sum * inv_cos_theta_inv_I_d;
    let part_of_minus_part_part_part_sum_5 =
        minus_w_plus_cos_product_2 * cos_theta_cos_phi_product_2;
    let sin_theta_air_product = sin_theta * air_velocity_1_inv_product_2;
    let minus_cos_theta_C_Rr_sum = sin_theta_air_product - C_Rr * cos_theta;
    let inv_cos_theta_inv_I_product = inv_cos_theta_inv_I_d * air_velocity_1_product;
    let part_of_minus_part_part_part_sum_4 =
        phidot * minus_cos_theta_C_Rr_sum * inv_cos_theta_inv_I_product;
    let part_of_minus_part_part_part_sum_6 =
        part_of_minus_part_part_part_sum_5 - part_of_minus_part_part_part_sum_4;
    let part_of_minus_part_part_part_sum_7 =
        part_of_minus_part_part_part_sum_3 + part_of_minus_part_part_part_sum_6;
    let part_of_minus_part_part_part_sum_8 =
        part_of_minus_part_part_part_sum_7 - part_of_minus_part_part_part_sum_2;
    let part_of_minus_part_part_part_sum_9 =
        cos_theta_cos_phi_product_2 * minus_minus_w_plus_product;
    let part_of_minus_part_part_part_sum_10 =
        minus_cos_theta_wind_x_sum * minus_air_velocity_product;
    let part_of_minus_part_part_part_sum_11 =
        part_of_minus_part_part_part_sum_9 + part_of_minus_part_part_part_sum_10;
    let minus_part_part_part_sum =
        part_of_minus_part_part_part_sum_8 - part_of_minus_part_part_part_sum_11;
    let part_of_minus_sin_theta_sum_2 =
        minus_two_plus_p1_inv_p2 * sin_theta * thetadot * inv_cos_theta;
    let cos_theta_air_product = cos_theta * air_velocity_1_inv_product_2;
    let sin_theta_C_Rr_plus_cos_sum = C_Rr * sin_theta + cos_theta_air_product;
    let inv_I_d_air_product = inv_p2 * air_velocity_2_product_2;
    let part_of_minus_sin_theta_sum =
        sin_theta_C_Rr_plus_cos_sum * inv_cos_theta_inv_I_product + inv_I_d_air_product;
    let minus_sin_theta_sum = part_of_minus_sin_theta_sum - part_of_minus_sin_theta_sum_2;
    let C_Rr_air_velocity_1_sum = C_Rr * air_velocity_1_product - I_a * thetadot;
    let part_of_minus_minus_minus_w_sum_3_5 =
        air_velocity_1_product_sum * sqrt_air_velocity_1_product;
    let part_of_minus_minus_minus_w_sum_3 = air_velocity_1_product_sum * minus_w_plus_cos_product_3;
    let part_of_minus_minus_minus_w_sum_3_2 =
        air_velocity_2_product * C_Mq_air_velocity_1_cos_sum + part_of_minus_minus_minus_w_sum_3;
    let part_of_minus_minus_minus_w_sum_3_3 =
        part_of_minus_minus_minus_w_sum_3_2 * inv_sqrt_air_product_2;
    let part_of_minus_minus_minus_w_sum_3_4 =
        part_of_minus_minus_minus_w_sum_3_3 - minus_minus_w_plus_cos_sum_2 * air_velocity_1_product;
    let minus_minus_minus_w_sum_3 =
        part_of_minus_minus_minus_w_sum_3_4 - part_of_minus_minus_minus_w_sum_3_5;
    let part_of_minus_minus_minus_w_sum_4 = minus_minus_minus_w_sum_3 * air_velocity_1_inv_product;
    let alpha_C_Ma_minus_air_sum_2 = alpha_C_Ma_minus_air_sum + cos_theta_phidot_sum;
    let minus_minus_minus_w_sum_4 =
        part_of_minus_minus_minus_w_sum_4 - minus_w_plus_cos_product * alpha_C_Ma_minus_air_sum_2;
    let angular_velocity_3_C_Rr_sum_3 = angular_velocity_3_C_Rr_sum - inv_sqrt_air_product_4;
    let part_of_d_thetadot_dot_d_v = minus_w_plus_cos_product * angular_velocity_3_C_Rr_sum_3;
    let part_of_d_thetadot_dot_d_v_2 =
        minus_minus_minus_w_sum_3 * air_velocity_2_inv_product_2 - part_of_d_thetadot_dot_d_v;
    let part_of_air_velocity_1_product_sum_2_2 =
        air_velocity_1_product * sqrt_air_velocity_1_product_2;
    let part_of_air_velocity_1_product_sum_2 =
        air_velocity_1_product_sum * minus_w_plus_cos_product_4;
    let air_velocity_1_product_sum_2 =
        part_of_air_velocity_1_product_sum_2_2 + part_of_air_velocity_1_product_sum_2;
    let part_of_d_thetadot_dot_d_phi_3 = air_velocity_1_product_sum_2 * cos_theta_cos_phi_product;
    let part_of_d_thetadot_dot_d_phi = minus_cos_phi_wind_z_sum * angular_velocity_3_C_Rr_sum_3;
    let part_of_d_thetadot_dot_d_phi_2 =
        alpha_C_Ma_minus_air_sum_2 * sin_theta_cos_phi_product - part_of_d_thetadot_dot_d_phi;
    let part_of_d_thetadot_dot_d_phi_4 =
        minus_minus_minus_w_sum_3 * inv_sqrt_air_product_3 + part_of_d_thetadot_dot_d_phi_3;
    let part_of_d_thetadot_dot_d_phi_5 =
        part_of_d_thetadot_dot_d_phi_4 + minus_w_plus_cos_product * part_of_d_thetadot_dot_d_phi_2;
    let cos_theta_phidot_product = minus_n1_plus_p1_inv_p2 * cos_theta_phidot;
    let part_of_d_thetadot_dot_d_theta_3 =
        minus_cos_theta_wind_x_sum * air_velocity_1_product_sum_2;
    let part_of_d_thetadot_dot_d_theta =
        (sin_theta_air_product - minus_cos_theta_C_Rr_sum) * air_velocity_2_product;
    let part_of_d_thetadot_dot_d_theta_2 =
        sin_theta * minus_sin_theta_phidot_sum - part_of_d_thetadot_dot_d_theta;
    let part_of_d_thetadot_dot_d_theta_4 =
        part_of_d_thetadot_dot_d_theta_3 + phidot * part_of_d_thetadot_dot_d_theta_2;
    let part_of_d_thetadot_dot_d_theta_5 =
        part_of_d_thetadot_dot_d_theta_4 + cos_theta_cos_phi_sum * minus_minus_minus_w_sum_4;
    let part_of_d_thetadot_dot_d_theta_6 =
        cos_theta_phidot * cos_theta_phidot_product - inv_p2 * part_of_d_thetadot_dot_d_theta_5;
    let part_of_d_thetadot_dot_d_phidot =
        (cos_theta_air_product - sin_theta_C_Rr_plus_cos_sum) * air_velocity_2_product;
    let part_of_d_thetadot_dot_d_phidot_2 =
        cos_theta * minus_sin_theta_phidot_sum - part_of_d_thetadot_dot_d_phidot;
    let part_of_d_thetadot_dot_d_phidot_3 =
        sin_theta * cos_theta_phidot_product + inv_p2 * part_of_d_thetadot_dot_d_phidot_2;
    let part_of_d_thetadot_dot_d_thetadot =
        inv_I_d_air_product + inv_p2 * air_velocity_1_product * air_velocity_1_inv_product_2;
    let part_of_d_thetadot_dot_d_gammadot =
        p13_inv_p2 * air_velocity_2_product + p1_inv_p2 * cos_theta_phidot;
    let part_of_d_gammadot_dot_d_theta = sin_theta * (thetadot_phidot - minus_part_part_part_sum);
    let part_of_d_gammadot_dot_d_theta_2 =
        part_of_d_gammadot_dot_d_theta - cos_theta * (der_phidot - p14_inv_p1 * phidot);
    let part_of_d_gammadot_dot_d_phidot =
        sin_theta * (p14_inv_p1 - minus_sin_theta_sum) - cos_theta * thetadot;
    let part_of_d_gammadot_dot_d_thetadot =
        I_a_angular_velocity_3_sum * sin_theta_inv_cos_product - cos_theta_phidot;
    let minus_cos_theta_sin_phi = -cos_theta_sin_phi;
    let minus_z_dot = -z_dot;
    let minus_sin_theta_cos_phi = -(sin_theta * cos_phi);
    let minus_x_dot_cos_phi = -(x_dot * cos_phi);
    let minus_w = -w;
    let minus_cos_theta_v = -(cos_theta * v);
    let minus_minus_air_velocity_product = -minus_air_velocity_product;
    let minus_I_a_angular_product = -(I_a_angular_velocity_3_sum * inv_cos_theta_inv_I_d);

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
    j[2] = minus_u_sin_theta_plus_sum; // d_x_dot_d_theta
    j[3] = sin_theta * sin_phi; // d_y_dot_d_u
    j[4] = cos_phi; // d_y_dot_d_v
    j[5] = minus_cos_theta_sin_phi; // d_y_dot_d_w
    j[6] = minus_z_dot; // d_y_dot_d_phi
    j[7] = x_dot * sin_phi; // d_y_dot_d_theta
    j[8] = minus_sin_theta_cos_phi; // d_z_dot_d_u
    j[9] = sin_phi; // d_z_dot_d_v
    j[10] = cos_theta * cos_phi; // d_z_dot_d_w
    j[11] = y_dot; // d_z_dot_d_phi
    j[12] = minus_x_dot_cos_phi; // d_z_dot_d_theta
    j[13] = part_of_d_u_dot_d_u; // d_u_dot_d_u
    j[14] = sin_theta_phidot + air_velocity_2_inv_product; // d_u_dot_d_v
    j[15] = -thetadot - A_rho_half_inv_sqrt_product_4 * air_velocity_1_inv_m; // d_u_dot_d_w
    j[16] = minus_inv_p0 * part_of_d_u_dot_d_phi_2; // d_u_dot_d_phi
    j[17] = v_cos_theta_phidot + inv_p0 * part_of_d_u_dot_d_theta_2; // d_u_dot_d_theta
    j[18] = sin_theta * v; // d_u_dot_d_phidot
    j[19] = minus_w; // d_u_dot_d_thetadot
    j[20] = air_velocity_2_inv_product - sin_theta_phidot; // d_v_dot_d_u
    j[21] = part_of_d_v_dot_d_v - A_rho_half_inv_sqrt_product_3; // d_v_dot_d_v
    j[22] = part_of_d_v_dot_d_w; // d_v_dot_d_w
    j[23] = minus_inv_p0 * part_of_d_v_dot_d_phi_2; // d_v_dot_d_phi
    j[24] = cos_theta_cos_phi_sum_2 * air_velocity_2_inv_m - x_dot * phidot; // d_v_dot_d_theta
    j[25] = minus_u_sin_theta_plus_sum; // d_v_dot_d_phidot
    j[26] = thetadot + p4_p5_half_inv_p0 * V_C_L_plus_inv_V_product; // d_w_dot_d_u
    j[27] = part_of_d_w_dot_d_v - cos_theta_phidot; // d_w_dot_d_v
    j[28] = minus_p4_p5_half_inv_p0 * V_C_D_plus_inv_V_part_sum; // d_w_dot_d_w
    j[29] = part_of_d_w_dot_d_phi_3; // d_w_dot_d_phi
    j[30] = part_of_d_w_dot_d_theta_4; // d_w_dot_d_theta
    j[31] = minus_cos_theta_v; // d_w_dot_d_phidot
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
    j[36] = minus_minus_minus_w_sum; // d_phidot_dot_d_u
    j[37] = minus_minus_minus_w_sum_2; // d_phidot_dot_d_v
    j[38] = minus_minus_air_velocity_product; // d_phidot_dot_d_w
    j[39] = minus_inv_I_d_cos_phi_sum; // d_phidot_dot_d_phi
    j[40] = minus_part_part_part_sum; // d_phidot_dot_d_theta
    j[41] = minus_sin_theta_sum; // d_phidot_dot_d_phidot
    j[42] = minus_I_a_angular_product; // d_phidot_dot_d_thetadot
    j[43] = C_Rr_air_velocity_1_sum * inv_cos_theta_inv_I_d; // d_phidot_dot_d_gammadot
    j[44] = minus_inv_p2 * minus_minus_minus_w_sum_4; // d_thetadot_dot_d_u
    j[45] = minus_inv_p2 * part_of_d_thetadot_dot_d_v_2; // d_thetadot_dot_d_v
    j[46] = minus_inv_p2 * air_velocity_1_product_sum_2; // d_thetadot_dot_d_w
    j[47] = minus_inv_p2 * part_of_d_thetadot_dot_d_phi_5; // d_thetadot_dot_d_phi
    j[48] = part_of_d_thetadot_dot_d_theta_6; // d_thetadot_dot_d_theta
    j[49] = part_of_d_thetadot_dot_d_phidot_3; // d_thetadot_dot_d_phidot
    j[50] = part_of_d_thetadot_dot_d_thetadot; // d_thetadot_dot_d_thetadot
    j[51] = part_of_d_thetadot_dot_d_gammadot; // d_thetadot_dot_d_gammadot
    j[52] = minus_minus_w_plus_cos_sum_3 * sin_theta_inv_cos_product; // d_gammadot_dot_d_u
    j[53] = minus_minus_w_plus_sum_2 * sin_theta_inv_cos_product; // d_gammadot_dot_d_v
    j[54] = minus_air_velocity_2_sum_2 * sin_theta_inv_cos_product; // d_gammadot_dot_d_w
    j[55] = sin_theta * inv_I_d_cos_phi_product; // d_gammadot_dot_d_phi
    j[56] = part_of_d_gammadot_dot_d_theta_2; // d_gammadot_dot_d_theta
    j[57] = part_of_d_gammadot_dot_d_phidot; // d_gammadot_dot_d_phidot
    j[58] = part_of_d_gammadot_dot_d_thetadot; // d_gammadot_dot_d_thetadot
    // d_gammadot_dot_d_gammadot
    j[59] = p14_inv_p1 - C_Rr_air_velocity_1_sum * sin_theta_inv_cos_product;
}
