// Written by `hyzer generate`; changes belong in the model.
//! `disc_appendix`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 608 operations: 154 add, 418 mul, 3 div, 26 neg, 2 sqrt, 5 call.
#[inline(always)]
pub fn f_jac_par<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 28],
    dx: &mut [T; 12],
    j: &mut [T; 60],
    jp: &mut [T; 67],
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
    let minus_two_plus_p1_inv_p2 = prepared[13];
    let minus_inv_p2 = prepared[14];
    let minus_n1_plus_p1_inv_p2 = prepared[15];
    let p14_inv_p1 = prepared[17];
    let p4_half = prepared[18];
    let p6_inv_p0 = prepared[19];
    let inv_p0_sq = prepared[20];
    let p5_half = prepared[21];
    let minus_p5_half = prepared[22];
    let minus_p4_half = prepared[23];
    let minus_p6_inv_p0 = prepared[24];
    let minus_inv_p2_sq = prepared[25];
    let inv_p1_sq = prepared[26];
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
    let rho_A_half_inv_sqrt_product = half_p5_p4 * inv_sqrt_air_velocity_1_of;
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
    let rho_A_half_inv_sqrt_product_2 = rho_A_half_inv_sqrt_product * V_minus_minus_w_plus_cos_sum;
    let cos_phi_m_g = p6_p0 * cos_phi;
    let air_velocity_1_rho_sum =
        air_velocity_1 * rho_A_half_inv_sqrt_product_2 - sin_theta * cos_phi_m_g;
    let sin_theta_phidot = sin_theta * phidot;

    // disc_appendix.hyz:102  der(u) = F_b1/m - w*thetadot + v*phidot*sin(theta);
    let u_dot = v * sin_theta_phidot - inv_p0 * air_velocity_1_rho_sum - w * thetadot;
    let sin_phi_m_g = p6_p0 * sin_phi;
    let air_velocity_2_rho_sum = air_velocity_2 * rho_A_half_inv_sqrt_product_2 + sin_phi_m_g;

    // disc_appendix.hyz:104  der(v) = F_b2/m + w*phidot*cos(theta) - u*phidot*sin(theta);
    let v_dot = minus_u_sin_theta_plus_sum * phidot - inv_p0 * air_velocity_2_rho_sum;
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
    let minus_w_plus_cos_product = d * minus_w_plus_cos_sum * rho_A_half_inv_sqrt_product;
    let air_velocity_2_cos_sum = air_velocity_2 * cos_theta_phidot - air_velocity_1 * thetadot;
    let inv_sqrt_air_product = C_Mq * inv_sqrt_air_velocity_1_of;
    let alpha_C_Ma_minus_air_sum = C_Ma * alpha - air_velocity_2_cos_sum * inv_sqrt_air_product;
    let air_velocity_1_cos_sum = air_velocity_1 * cos_theta_phidot + air_velocity_2 * thetadot;
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
    let part_of_cos_theta_phidot_sum = minus_w_plus_cos_product * air_velocity_1_product_sum;
    let cos_theta_phidot_sum =
        cos_theta_phidot * minus_sin_theta_phidot_sum + part_of_cos_theta_phidot_sum;

    // disc_appendix.hyz:115  der(thetadot) = (M_b2 - I_d*phidot^2*cos(theta)*sin(theta) + I_a* …
    let thetadot_dot = inv_p2 * cos_theta_phidot_sum;

    // disc_appendix.hyz:88  let spin_down = C_Nr*r;
    let spin_down = C_Nr * angular_velocity_3;
    let sin_theta_der_phidot_sum = sin_theta * der_phidot + thetadot * cos_theta_phidot;
    let spin_down_minus_I_a_sin_sum = spin_down - I_a * sin_theta_der_phidot_sum;

    // disc_appendix.hyz:119  der(gammadot) = (M_b3 - I_a*(der(phidot)*sin(theta) + phidot*thet …
    let gammadot_dot = inv_p1 * spin_down_minus_I_a_sin_sum;
    let cos_theta_sin_phi = cos_theta * sin_phi;
    let sin_theta_cos_phi = sin_theta * cos_phi;
    let cos_theta_cos_phi = cos_theta * cos_phi;
    let inv_sqrt_air_product_2 = inv_sqrt_air_velocity_1_of * inv_sqrt_air_velocity_1_of;
    let rho_A_half_inv_sqrt_product_3 = half_p5_p4 * inv_sqrt_air_product_2;
    let part_of_minus_V_minus_minus_w_sum_4 =
        V_minus_minus_w_plus_cos_sum * rho_A_half_inv_sqrt_product_3;
    let V_C_D = V * C_D;
    let inv_V = V.recip_or_zero();
    let part_of_minus_V_minus_minus_w_sum = sqrt_air_velocity_1_sq_of * minus_minus_w_plus_cos_sum;
    let sqrt_air_velocity_1_product = sqrt_air_velocity_1_sq_of * alpha;
    let minus_w_plus_cos_sum_2 =
        C_La * minus_w_plus_cos_theta_sum - p10_two * sqrt_air_velocity_1_product;
    let part_of_minus_V_minus_minus_w_sum_2 =
        part_of_minus_V_minus_minus_w_sum + minus_w_plus_cos_theta_sum * minus_w_plus_cos_sum_2;
    let part_of_minus_V_minus_minus_w_sum_3 =
        rho_A_half_inv_sqrt_product * (V_C_D + inv_V * part_of_minus_V_minus_minus_w_sum_2);
    let minus_V_minus_minus_w_sum =
        part_of_minus_V_minus_minus_w_sum_3 - part_of_minus_V_minus_minus_w_sum_4;
    let air_velocity_1_inv_product = air_velocity_1 * inv_sqrt_air_velocity_1_of;
    let minus_V_minus_minus_product = minus_V_minus_minus_w_sum * air_velocity_1_inv_product;
    let rho_A_half_inv_sqrt_sum =
        rho_A_half_inv_sqrt_product_2 + air_velocity_1 * minus_V_minus_minus_product;
    let air_velocity_2_inv_m = inv_p0 * air_velocity_2;
    let minus_V_minus_minus_product_2 = minus_V_minus_minus_product * air_velocity_2_inv_m;
    let V_C_L = V * C_L;
    let part_of_rho_A_half_inv_sqrt_product_4 =
        minus_w_plus_cos_theta_sum * minus_minus_w_plus_cos_sum;
    let part_of_rho_A_half_inv_sqrt_product_4_2 =
        part_of_rho_A_half_inv_sqrt_product_4 - sqrt_air_velocity_1_sq_of * minus_w_plus_cos_sum_2;
    let rho_A_half_inv_sqrt_product_4 =
        rho_A_half_inv_sqrt_product * (V_C_L - inv_V * part_of_rho_A_half_inv_sqrt_product_4_2);
    let air_velocity_1_rho_product = air_velocity_1 * rho_A_half_inv_sqrt_product_4;
    let cos_theta_rho_A_product = cos_theta * rho_A_half_inv_sqrt_product_4;
    let air_velocity_2_inv_product = air_velocity_2 * inv_sqrt_air_velocity_1_of;
    let minus_V_minus_minus_product_3 = minus_V_minus_minus_w_sum * air_velocity_2_inv_product;
    let part_of_d_u_dot_d_phi = cos_phi_wind_z_minus_sum * minus_V_minus_minus_product_3;
    let part_of_d_u_dot_d_phi_2 =
        cos_phi_wind_y_plus_sin_sum * cos_theta_rho_A_product - part_of_d_u_dot_d_phi;
    let part_of_d_u_dot_d_phi_3 =
        sin_phi_m_g - rho_A_half_inv_sqrt_sum * cos_phi_wind_y_plus_sin_sum;
    let part_of_d_u_dot_d_phi_4 =
        air_velocity_1 * part_of_d_u_dot_d_phi_2 + sin_theta * part_of_d_u_dot_d_phi_3;
    let part_of_d_u_dot_d_theta =
        cos_theta_cos_phi_m_g - rho_A_half_inv_sqrt_sum * cos_theta_cos_phi_sum;
    let part_of_d_u_dot_d_theta_2 =
        part_of_d_u_dot_d_theta - minus_cos_theta_wind_x_sum * air_velocity_1_rho_product;
    let rho_A_half_inv_sqrt_sum_2 =
        rho_A_half_inv_sqrt_product_2 + air_velocity_2 * minus_V_minus_minus_product_3;
    let part_of_d_v_dot_d_w =
        cos_theta_phidot - rho_A_half_inv_sqrt_product_4 * air_velocity_2_inv_m;
    let sin_theta_minus_V_sum = sin_theta * minus_V_minus_minus_product - cos_theta_rho_A_product;
    let part_of_d_v_dot_d_phi =
        air_velocity_2 * cos_phi_wind_y_plus_sin_sum * sin_theta_minus_V_sum;
    let part_of_d_v_dot_d_phi_2 =
        cos_phi_m_g - cos_phi_wind_z_minus_sum * rho_A_half_inv_sqrt_sum_2;
    let part_of_d_v_dot_d_theta = minus_cos_theta_wind_x_sum * rho_A_half_inv_sqrt_product_4;
    let part_of_d_v_dot_d_theta_2 =
        cos_theta_cos_phi_sum * minus_V_minus_minus_product + part_of_d_v_dot_d_theta;
    let part_of_d_v_dot_d_theta_3 =
        -(x_dot * phidot) - part_of_d_v_dot_d_theta_2 * air_velocity_2_inv_m;
    let minus_w_plus_cos_product_2 = minus_w_plus_cos_theta_sum * alpha;
    let sqrt_air_velocity_1_sum_2 =
        C_La * sqrt_air_velocity_1_sq_of + p10_two * minus_w_plus_cos_product_2;
    let part_of_V_C_L_plus_inv_V_part_sum = minus_w_plus_cos_theta_sum * sqrt_air_velocity_1_sum_2;
    let part_of_V_C_L_plus_inv_V_part_sum_2 =
        sqrt_air_velocity_1_sq_of * sqrt_air_velocity_1_sum - part_of_V_C_L_plus_inv_V_part_sum;
    let V_C_L_plus_inv_V_part_sum = V_C_L + inv_V * part_of_V_C_L_plus_inv_V_part_sum_2;
    let V_C_L_plus_inv_V_product = V_C_L_plus_inv_V_part_sum * air_velocity_1_inv_product;
    let part_of_d_w_dot_d_v =
        p4_p5_half_inv_p0 * V_C_L_plus_inv_V_part_sum * air_velocity_2_inv_product;
    let part_of_V_C_D_plus_inv_V_part_sum = sqrt_air_velocity_1_sq_of * sqrt_air_velocity_1_sum_2;
    let part_of_V_C_D_plus_inv_V_part_sum_2 =
        minus_w_plus_cos_theta_sum * sqrt_air_velocity_1_sum + part_of_V_C_D_plus_inv_V_part_sum;
    let V_C_D_plus_inv_V_part_sum = V_C_D + inv_V * part_of_V_C_D_plus_inv_V_part_sum_2;
    let part_of_d_w_dot_d_phi = cos_theta * cos_phi_wind_y_plus_sin_sum * V_C_D_plus_inv_V_part_sum;
    let sin_theta_air_velocity_1 = sin_theta * air_velocity_1;
    let part_of_d_w_dot_d_phi_2 = cos_phi_wind_y_plus_sin_sum * sin_theta_air_velocity_1;
    let part_of_d_w_dot_d_phi_3 =
        part_of_d_w_dot_d_phi_2 + air_velocity_2 * cos_phi_wind_z_minus_sum;
    let inv_sqrt_air_product_3 = inv_sqrt_air_velocity_1_of * V_C_L_plus_inv_V_part_sum;
    let part_of_d_w_dot_d_phi_4 =
        part_of_d_w_dot_d_phi + part_of_d_w_dot_d_phi_3 * inv_sqrt_air_product_3;
    let part_of_d_w_dot_d_phi_5 =
        g * cos_theta_sin_phi - p4_p5_half_inv_p0 * part_of_d_w_dot_d_phi_4;
    let part_of_d_w_dot_d_theta_3 = sin_theta * (v * phidot + inv_p0 * cos_phi_m_g);
    let part_of_d_w_dot_d_theta = minus_cos_theta_wind_x_sum * V_C_D_plus_inv_V_part_sum;
    let part_of_d_w_dot_d_theta_2 =
        cos_theta_cos_phi_sum * V_C_L_plus_inv_V_product - part_of_d_w_dot_d_theta;
    let part_of_d_w_dot_d_theta_4 =
        part_of_d_w_dot_d_theta_3 + p4_p5_half_inv_p0 * part_of_d_w_dot_d_theta_2;
    let inv_V_C_Ma_inv_V = inv_V * (C_Ma * inv_V);
    let C_Mq_inv_sqrt_air_product_2 = C_Mq * inv_sqrt_air_product_2;
    let part_of_minus_minus_w_plus_cos_sum_2 = air_velocity_2_cos_sum * C_Mq_inv_sqrt_air_product_2;
    let minus_minus_w_plus_cos_sum_2 =
        part_of_minus_minus_w_plus_cos_sum_2 - minus_w_plus_cos_theta_sum * inv_V_C_Ma_inv_V;
    let thetadot_inv_sqrt_product = thetadot * inv_sqrt_air_product;
    let minus_minus_w_plus_sum =
        minus_minus_w_plus_cos_sum_2 * air_velocity_1_inv_product + thetadot_inv_sqrt_product;
    let air_velocity_2_product = air_velocity_2 * minus_w_plus_cos_product;
    let minus_w_plus_cos_product_3 = minus_w_plus_cos_product * angular_velocity_3_C_Rr_sum;
    let air_velocity_1_cos_product = air_velocity_1_cos_sum * C_Mq_inv_sqrt_air_product_2;
    let cos_theta_phidot_product = cos_theta_phidot * inv_sqrt_air_product;
    let minus_air_velocity_1_sum =
        cos_theta_phidot_product - air_velocity_1_inv_product * air_velocity_1_cos_product;
    let part_of_minus_minus_w_plus_cos_sum_3 =
        T::splat(2.0) * sqrt_air_velocity_1_sq_of * rho_A_half_inv_sqrt_product;
    let minus_minus_w_plus_cos_sum_3 =
        part_of_minus_minus_w_plus_cos_sum_3 - minus_w_plus_cos_sum * rho_A_half_inv_sqrt_product_3;
    let inv_sqrt_air_velocity_1_of_d = d * inv_sqrt_air_velocity_1_of;
    let minus_air_velocity_product =
        minus_air_velocity_2_sum * minus_minus_w_plus_cos_sum_3 * inv_sqrt_air_velocity_1_of_d;
    let part_of_minus_minus_minus_w_sum =
        minus_w_plus_cos_product * minus_air_velocity_1_sum + minus_air_velocity_product;
    let part_of_minus_minus_minus_w_sum_2 =
        minus_w_plus_cos_product_3 - minus_minus_w_plus_sum * air_velocity_2_product;
    let minus_minus_minus_w_sum =
        part_of_minus_minus_minus_w_sum_2 + air_velocity_1 * part_of_minus_minus_minus_w_sum;
    let minus_minus_minus_w_product = minus_minus_minus_w_sum * inv_cos_theta_inv_I_d;
    let thetadot_inv_sqrt_sum =
        thetadot_inv_sqrt_product - air_velocity_2_inv_product * air_velocity_1_cos_product;
    let air_velocity_1_product = air_velocity_1 * minus_w_plus_cos_product;
    let minus_w_plus_cos_product_4 = minus_w_plus_cos_product * alpha_C_Ma_minus_air_sum;
    let cos_theta_phidot_sum_2 =
        cos_theta_phidot_product - minus_minus_w_plus_cos_sum_2 * air_velocity_2_inv_product;
    let part_of_minus_thetadot_inv_sqrt_sum =
        minus_air_velocity_product + minus_w_plus_cos_product * cos_theta_phidot_sum_2;
    let part_of_minus_thetadot_inv_sqrt_sum_3 =
        air_velocity_2 * part_of_minus_thetadot_inv_sqrt_sum;
    let part_of_minus_thetadot_inv_sqrt_sum_2 =
        minus_w_plus_cos_product_4 - thetadot_inv_sqrt_sum * air_velocity_1_product;
    let minus_thetadot_inv_sqrt_sum =
        part_of_minus_thetadot_inv_sqrt_sum_2 - part_of_minus_thetadot_inv_sqrt_sum_3;
    let sqrt_air_velocity_1_product_2 = sqrt_air_velocity_1_sq_of * inv_V_C_Ma_inv_V;
    let part_of_minus_air_velocity_2_sum_2 = air_velocity_2_product * sqrt_air_velocity_1_product_2;
    let two_d_minus_w_plus_product =
        two_p3 * (minus_w_plus_cos_theta_sum * rho_A_half_inv_sqrt_product);
    let minus_air_velocity_2_sum_2 =
        minus_air_velocity_2_sum * two_d_minus_w_plus_product - part_of_minus_air_velocity_2_sum_2;
    let minus_air_velocity_product_2 = minus_air_velocity_2_sum_2 * inv_cos_theta_inv_I_d;
    let part_of_cos_phi_wind_y_plus_sum_3 =
        cos_phi_wind_y_plus_sin_sum * minus_air_velocity_2_sum_2;
    let part_of_cos_phi_wind_y_plus_sum =
        sin_theta * cos_phi_wind_y_plus_sin_sum * minus_minus_minus_w_sum;
    let part_of_cos_phi_wind_y_plus_sum_2 =
        part_of_cos_phi_wind_y_plus_sum - cos_phi_wind_z_minus_sum * minus_thetadot_inv_sqrt_sum;
    let cos_phi_wind_y_plus_sum =
        part_of_cos_phi_wind_y_plus_sum_3 + inv_cos_theta * part_of_cos_phi_wind_y_plus_sum_2;
    let inv_sqrt_air_product_4 = inv_sqrt_air_product * sin_theta_air_velocity_1;
    let minus_cos_theta_C_Rr_sum = inv_sqrt_air_product_4 - C_Rr * cos_theta;
    let inv_cos_theta_inv_I_product = inv_cos_theta_inv_I_d * air_velocity_1_product;
    let sin_theta_inv_cos_product = sin_theta * inv_cos_theta_inv_I_d;
    let air_velocity_2_inv_product_2 = air_velocity_2 * inv_sqrt_air_product;
    let part_of_minus_phidot_part_plus_sum =
        sin_theta_inv_cos_product * air_velocity_2_product * air_velocity_2_inv_product_2;
    let part_of_minus_phidot_part_plus_sum_2 =
        minus_cos_theta_C_Rr_sum * inv_cos_theta_inv_I_product + part_of_minus_phidot_part_plus_sum;
    let thetadot_phidot = thetadot * phidot;
    let part_of_minus_phidot_part_plus_sum_3 =
        minus_thetadot_I_a_sum * inv_cos_theta * sin_theta_inv_cos_product;
    let part_of_minus_phidot_part_plus_sum_4 =
        minus_two_plus_p1_inv_p2 * thetadot_phidot - part_of_minus_phidot_part_plus_sum_3;
    let part_of_minus_phidot_part_plus_sum_5 =
        phidot * part_of_minus_phidot_part_plus_sum_2 + part_of_minus_phidot_part_plus_sum_4;
    let part_of_minus_phidot_part_plus_sum_6 =
        minus_cos_theta_wind_x_sum * minus_air_velocity_product_2;
    let part_of_minus_phidot_part_plus_sum_7 =
        cos_theta_cos_phi_sum * minus_minus_minus_w_product - part_of_minus_phidot_part_plus_sum_6;
    let minus_phidot_part_plus_sum =
        part_of_minus_phidot_part_plus_sum_7 - part_of_minus_phidot_part_plus_sum_5;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let part_of_minus_thetadot_minus_sum_2 =
        minus_two_plus_p1_inv_p2 * thetadot * sin_theta_inv_cos_theta;
    let air_velocity_1_inv_product_2 = air_velocity_1 * inv_sqrt_air_product;
    let cos_theta_air_product = cos_theta * air_velocity_1_inv_product_2;
    let sin_theta_C_Rr_plus_cos_sum = C_Rr * sin_theta + cos_theta_air_product;
    let inv_I_d_air_product = inv_p2 * air_velocity_2_product;
    let inv_I_d_air_product_product = inv_I_d_air_product * air_velocity_2_inv_product_2;
    let part_of_minus_thetadot_minus_sum =
        sin_theta_C_Rr_plus_cos_sum * inv_cos_theta_inv_I_product + inv_I_d_air_product_product;
    let minus_thetadot_minus_sum =
        part_of_minus_thetadot_minus_sum - part_of_minus_thetadot_minus_sum_2;
    let C_Rr_air_velocity_1_sum = C_Rr * air_velocity_1_product - I_a * thetadot;
    let air_velocity_1_product_2 = air_velocity_1_product_sum * inv_sqrt_air_velocity_1_of_d;
    let minus_minus_w_plus_product = minus_minus_w_plus_cos_sum_3 * air_velocity_1_product_2;
    let part_of_minus_w_plus_cos_sum_3 =
        minus_w_plus_cos_product * minus_minus_w_plus_sum + minus_minus_w_plus_product;
    let part_of_minus_w_plus_cos_sum_3_2 =
        minus_w_plus_cos_product_4 + minus_air_velocity_1_sum * air_velocity_2_product;
    let minus_w_plus_cos_sum_3 =
        part_of_minus_w_plus_cos_sum_3_2 + air_velocity_1 * part_of_minus_w_plus_cos_sum_3;
    let part_of_minus_w_plus_cos_sum_4 =
        minus_minus_w_plus_product + minus_w_plus_cos_product * thetadot_inv_sqrt_sum;
    let part_of_minus_w_plus_cos_sum_4_2 =
        minus_w_plus_cos_product_3 - cos_theta_phidot_sum_2 * air_velocity_1_product;
    let minus_w_plus_cos_sum_4 =
        part_of_minus_w_plus_cos_sum_4_2 + air_velocity_2 * part_of_minus_w_plus_cos_sum_4;
    let part_of_air_velocity_1_product_sum_2_2 =
        air_velocity_1_product * sqrt_air_velocity_1_product_2;
    let part_of_air_velocity_1_product_sum_2 =
        air_velocity_1_product_sum * two_d_minus_w_plus_product;
    let air_velocity_1_product_sum_2 =
        part_of_air_velocity_1_product_sum_2_2 + part_of_air_velocity_1_product_sum_2;
    let sin_theta_minus_w_sum =
        sin_theta * minus_w_plus_cos_sum_3 + cos_theta * air_velocity_1_product_sum_2;
    let part_of_d_thetadot_dot_d_phi = cos_phi_wind_y_plus_sin_sum * sin_theta_minus_w_sum;
    let part_of_d_thetadot_dot_d_phi_2 =
        cos_phi_wind_z_minus_sum * minus_w_plus_cos_sum_4 + part_of_d_thetadot_dot_d_phi;
    let cos_theta_phidot_product_2 = minus_n1_plus_p1_inv_p2 * cos_theta_phidot;
    let part_of_d_thetadot_dot_d_theta_3 =
        minus_cos_theta_wind_x_sum * air_velocity_1_product_sum_2;
    let part_of_d_thetadot_dot_d_theta =
        (inv_sqrt_air_product_4 - minus_cos_theta_C_Rr_sum) * air_velocity_2_product;
    let part_of_d_thetadot_dot_d_theta_2 =
        sin_theta * minus_sin_theta_phidot_sum - part_of_d_thetadot_dot_d_theta;
    let part_of_d_thetadot_dot_d_theta_4 =
        cos_theta_cos_phi_sum * minus_w_plus_cos_sum_3 - part_of_d_thetadot_dot_d_theta_3;
    let part_of_d_thetadot_dot_d_theta_5 =
        part_of_d_thetadot_dot_d_theta_4 - phidot * part_of_d_thetadot_dot_d_theta_2;
    let part_of_d_thetadot_dot_d_theta_6 =
        cos_theta_phidot * cos_theta_phidot_product_2 + inv_p2 * part_of_d_thetadot_dot_d_theta_5;
    let part_of_d_thetadot_dot_d_phidot =
        (cos_theta_air_product - sin_theta_C_Rr_plus_cos_sum) * air_velocity_2_product;
    let part_of_d_thetadot_dot_d_phidot_2 =
        cos_theta * minus_sin_theta_phidot_sum - part_of_d_thetadot_dot_d_phidot;
    let part_of_d_thetadot_dot_d_phidot_3 =
        sin_theta * cos_theta_phidot_product_2 + inv_p2 * part_of_d_thetadot_dot_d_phidot_2;
    let inv_I_d_air_product_2 = inv_p2 * air_velocity_1_product;
    let part_of_d_thetadot_dot_d_thetadot =
        inv_I_d_air_product_product + air_velocity_1_inv_product_2 * inv_I_d_air_product_2;
    let cos_theta_phidot_inv_I_d = inv_p2 * cos_theta_phidot;
    let minus_air_velocity_product_3 = minus_air_velocity_2_sum_2 * sin_theta_inv_cos_product;
    let sin_theta_inv_I_d = inv_p2 * sin_theta;
    let part_of_d_gammadot_dot_d_theta = sin_theta * (thetadot_phidot - minus_phidot_part_plus_sum);
    let part_of_d_gammadot_dot_d_theta_2 =
        part_of_d_gammadot_dot_d_theta - cos_theta * (der_phidot - p14_inv_p1 * phidot);
    let part_of_d_gammadot_dot_d_phidot =
        sin_theta * (p14_inv_p1 - minus_thetadot_minus_sum) - cos_theta * thetadot;
    let part_of_d_gammadot_dot_d_thetadot =
        I_a_angular_velocity_3_sum * sin_theta_inv_cos_product - cos_theta_phidot;
    let part_of_d_u_dot_d_m = p6_inv_p0 * sin_theta_cos_phi + inv_p0_sq * air_velocity_1_rho_sum;
    let V_inv_m = inv_p0 * V;
    let minus_minus_w_plus_product_2 = minus_minus_w_plus_cos_sum * V_inv_m;
    let air_velocity_1_inv_product_3 = air_velocity_1_inv_product * minus_minus_w_plus_product_2;
    let rho_A_half_inv_sqrt_product_5 = rho_A_half_inv_sqrt_product * V_inv_m;
    let air_velocity_1_rho_product_2 = air_velocity_1 * rho_A_half_inv_sqrt_product_5;
    let alpha_sqrt_air_product = alpha * sqrt_air_velocity_1_product;
    let part_of_d_u_dot_d_wind_x = rho_A_half_inv_sqrt_product_4 * sin_theta_air_velocity_1;
    let part_of_d_u_dot_d_wind_x_2 =
        inv_p0 * (cos_theta * rho_A_half_inv_sqrt_sum + part_of_d_u_dot_d_wind_x);
    let cos_phi_air_velocity_2 = cos_phi * air_velocity_2;
    let part_of_d_u_dot_d_wind_y = cos_phi_air_velocity_2 * minus_V_minus_minus_product;
    let sin_theta_rho_A_product_sum =
        sin_theta * rho_A_half_inv_sqrt_sum - air_velocity_1 * cos_theta_rho_A_product;
    let part_of_d_u_dot_d_wind_y_2 =
        inv_p0 * (part_of_d_u_dot_d_wind_y + sin_phi * sin_theta_rho_A_product_sum);
    let sin_phi_air_velocity_2 = sin_phi * air_velocity_2;
    let part_of_d_u_dot_d_wind_z = sin_phi_air_velocity_2 * minus_V_minus_minus_product;
    let part_of_d_u_dot_d_wind_z_2 =
        inv_p0 * (part_of_d_u_dot_d_wind_z - cos_phi * sin_theta_rho_A_product_sum);
    let air_velocity_2_inv_product_3 = air_velocity_2_inv_product * minus_minus_w_plus_product_2;
    let air_velocity_2_rho_product = air_velocity_2 * rho_A_half_inv_sqrt_product_5;
    let part_of_d_v_dot_d_wind_x =
        cos_theta * minus_V_minus_minus_product + sin_theta * rho_A_half_inv_sqrt_product_4;
    let part_of_d_v_dot_d_wind_y =
        cos_phi * rho_A_half_inv_sqrt_sum_2 + sin_theta_minus_V_sum * sin_phi_air_velocity_2;
    let part_of_d_v_dot_d_wind_z =
        sin_phi * rho_A_half_inv_sqrt_sum_2 - sin_theta_minus_V_sum * cos_phi_air_velocity_2;
    let sqrt_air_velocity_1_product_3 = sqrt_air_velocity_1_sum * V_inv_m;
    let rho_A_half_V_inv_m = half_p5_p4 * V_inv_m;
    let d_w_dot_d_C_L = sqrt_air_velocity_1_sq_of * rho_A_half_V_inv_m;
    let d_w_dot_d_C_D = minus_w_plus_cos_theta_sum * rho_A_half_V_inv_m;
    let part_of_d_w_dot_d_wind_x =
        cos_theta * V_C_L_plus_inv_V_product - sin_theta * V_C_D_plus_inv_V_part_sum;
    let part_of_d_w_dot_d_wind_y =
        (sin_phi * sin_theta_air_velocity_1 + cos_phi_air_velocity_2) * inv_sqrt_air_product_3;
    let part_of_d_w_dot_d_wind_y_2 =
        cos_theta_sin_phi * V_C_D_plus_inv_V_part_sum + part_of_d_w_dot_d_wind_y;
    let part_of_d_w_dot_d_wind_z =
        (cos_phi * sin_theta_air_velocity_1 - sin_phi_air_velocity_2) * inv_sqrt_air_product_3;
    let part_of_d_w_dot_d_wind_z_2 =
        cos_theta_cos_phi * V_C_D_plus_inv_V_part_sum + part_of_d_w_dot_d_wind_z;
    let thetadot_angular_velocity_3 = thetadot * angular_velocity_3;
    let minus_thetadot_I_a_sum_2 =
        inv_p2 * minus_thetadot_I_a_sum - T::splat(2.0) * thetadot * sin_theta_phidot;
    let minus_w_plus_cos_product_5 = minus_w_plus_cos_sum * minus_air_velocity_2_sum;
    let rho_A_half_inv_sqrt_product_6 = rho_A_half_inv_sqrt_product * minus_w_plus_cos_product_5;
    let inv_sqrt_air_product_5 = inv_sqrt_air_velocity_1_of_d * minus_w_plus_cos_product_5;
    let inv_cos_theta_inv_I_product_2 = inv_cos_theta_inv_I_d * inv_sqrt_air_product_5;
    let alpha_air_velocity_2_product = alpha * air_velocity_2_product;
    let part_of_air_velocity_1_air_product =
        air_velocity_1 * air_velocity_1_cos_sum + air_velocity_2 * air_velocity_2_cos_sum;
    let inv_sqrt_air_product_6 = inv_sqrt_air_velocity_1_of * minus_w_plus_cos_product;
    let air_velocity_1_air_product = part_of_air_velocity_1_air_product * inv_sqrt_air_product_6;
    let inv_cos_theta_minus_product = inv_cos_theta * minus_thetadot_inv_sqrt_sum;
    let minus_air_velocity_2_sum_3 =
        minus_air_velocity_2_sum_2 + minus_minus_minus_w_sum * sin_theta_inv_cos_theta;
    let cos_phi_inv_cos_product_sum =
        cos_phi * inv_cos_theta_minus_product - sin_phi * minus_air_velocity_2_sum_3;
    let sin_phi_inv_cos_product_sum =
        sin_phi * inv_cos_theta_minus_product + cos_phi * minus_air_velocity_2_sum_3;
    let part_of_d_thetadot_dot_d_I_d =
        minus_inv_p2_sq * cos_theta_phidot_sum - sin_theta_phidot * cos_theta_phidot_inv_I_d;
    let minus_w_plus_cos_sum_inv_I_d = inv_p2 * minus_w_plus_cos_sum;
    let part_of_d_thetadot_dot_d_d =
        rho_A_half_inv_sqrt_product * air_velocity_1_product_sum * minus_w_plus_cos_sum_inv_I_d;
    let minus_w_plus_cos_product_6 = minus_w_plus_cos_sum_inv_I_d * air_velocity_1_product_2;
    let part_of_d_thetadot_dot_d_C_Mq =
        air_velocity_2 * air_velocity_1_cos_sum - air_velocity_1 * air_velocity_2_cos_sum;
    let part_of_d_thetadot_dot_d_wind_x =
        cos_theta * minus_w_plus_cos_sum_3 - sin_theta * air_velocity_1_product_sum_2;
    let part_of_d_thetadot_dot_d_wind_y =
        cos_phi * minus_w_plus_cos_sum_4 + sin_phi * sin_theta_minus_w_sum;
    let part_of_d_thetadot_dot_d_wind_z =
        sin_phi * minus_w_plus_cos_sum_4 - cos_phi * sin_theta_minus_w_sum;
    let part_of_d_gammadot_dot_d_I_a =
        sin_theta_inv_cos_product * thetadot_angular_velocity_3 - inv_p1 * sin_theta_der_phidot_sum;
    let part_of_d_gammadot_dot_d_I_a_2 =
        part_of_d_gammadot_dot_d_I_a - inv_p1_sq * spin_down_minus_I_a_sin_sum;
    let sin_theta_inv_cos_product_2 = sin_theta_inv_cos_product * inv_sqrt_air_product_5;
    let part_of_minus_angular_velocity_3_product =
        angular_velocity_3 * sin_theta_inv_cos_product * air_velocity_1_product;
    let part_of_d_gammadot_dot_d_wind_x =
        minus_minus_minus_w_sum - minus_air_velocity_2_sum_2 * sin_theta_inv_cos_theta;
    let minus_cos_phi_inv_cos_sum = -(cos_phi_inv_cos_product_sum * sin_theta_inv_I_d);
    let minus_sin_phi_inv_cos_sum = -(sin_phi_inv_cos_product_sum * sin_theta_inv_I_d);
    let minus_cos_theta_sin_phi = -cos_theta_sin_phi;
    let minus_z_dot = -z_dot;
    let minus_sin_theta_cos_phi = -sin_theta_cos_phi;
    let minus_x_dot_cos_phi = -(x_dot * cos_phi);
    let minus_w = -w;
    let minus_cos_theta_v = -(cos_theta * v);
    let minus_minus_thetadot_inv_product = -(minus_thetadot_inv_sqrt_sum * inv_cos_theta_inv_I_d);
    let minus_minus_air_velocity_product_2 = -minus_air_velocity_product_2;
    let minus_I_a_angular_product = -(I_a_angular_velocity_3_sum * inv_cos_theta_inv_I_d);
    let minus_minus_minus_minus_w_product = -(minus_minus_minus_w_sum * sin_theta_inv_cos_product);
    let minus_sqrt_air_velocity_1_product =
        -(sqrt_air_velocity_1_sq_of * air_velocity_1_rho_product_2);
    let minus_air_velocity_1_rho_product = -(air_velocity_1_rho_product_2 * alpha_sqrt_air_product);
    let minus_sin_phi = -sin_phi;
    let minus_sqrt_air_velocity_1_product_2 =
        -(sqrt_air_velocity_1_sq_of * air_velocity_2_rho_product);
    let minus_air_velocity_2_rho_product = -(air_velocity_2_rho_product * alpha_sqrt_air_product);
    let minus_cos_theta_cos_phi = -cos_theta_cos_phi;
    let minus_inv_cos_theta_inv_I_product = -(inv_cos_theta_inv_I_d * thetadot_angular_velocity_3);
    let minus_minus_thetadot_I_a_product = -(minus_thetadot_I_a_sum_2 * inv_cos_theta_inv_I_d);
    let minus_inv_cos_theta_inv_I_product_2 =
        -(inv_cos_theta_inv_I_d * alpha_air_velocity_2_product);
    let minus_sin_theta_inv_cos_product =
        -(sin_theta_inv_cos_product * rho_A_half_inv_sqrt_product_6);
    let minus_sin_theta_inv_cos_product_2 =
        -(sin_theta_inv_cos_product * air_velocity_1_air_product);
    let minus_angular_velocity_3_product = -part_of_minus_angular_velocity_3_product;

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
    j[10] = cos_theta_cos_phi; // d_z_dot_d_w
    j[11] = y_dot; // d_z_dot_d_phi
    j[12] = minus_x_dot_cos_phi; // d_z_dot_d_theta
    j[13] = minus_inv_p0 * rho_A_half_inv_sqrt_sum; // d_u_dot_d_u
    j[14] = sin_theta_phidot - minus_V_minus_minus_product_2; // d_u_dot_d_v
    j[15] = minus_inv_p0 * air_velocity_1_rho_product - thetadot; // d_u_dot_d_w
    j[16] = minus_inv_p0 * part_of_d_u_dot_d_phi_4; // d_u_dot_d_phi
    j[17] = v_cos_theta_phidot + inv_p0 * part_of_d_u_dot_d_theta_2; // d_u_dot_d_theta
    j[18] = sin_theta * v; // d_u_dot_d_phidot
    j[19] = minus_w; // d_u_dot_d_thetadot
    j[20] = -sin_theta_phidot - minus_V_minus_minus_product_2; // d_v_dot_d_u
    j[21] = minus_inv_p0 * rho_A_half_inv_sqrt_sum_2; // d_v_dot_d_v
    j[22] = part_of_d_v_dot_d_w; // d_v_dot_d_w
    j[23] = minus_inv_p0 * (part_of_d_v_dot_d_phi_2 - part_of_d_v_dot_d_phi); // d_v_dot_d_phi
    j[24] = part_of_d_v_dot_d_theta_3; // d_v_dot_d_theta
    j[25] = minus_u_sin_theta_plus_sum; // d_v_dot_d_phidot
    j[26] = thetadot + p4_p5_half_inv_p0 * V_C_L_plus_inv_V_product; // d_w_dot_d_u
    j[27] = part_of_d_w_dot_d_v - cos_theta_phidot; // d_w_dot_d_v
    j[28] = minus_p4_p5_half_inv_p0 * V_C_D_plus_inv_V_part_sum; // d_w_dot_d_w
    j[29] = part_of_d_w_dot_d_phi_5; // d_w_dot_d_phi
    j[30] = part_of_d_w_dot_d_theta_4; // d_w_dot_d_theta
    j[31] = minus_cos_theta_v; // d_w_dot_d_phidot
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
    j[36] = minus_minus_minus_w_product; // d_phidot_dot_d_u
    j[37] = minus_minus_thetadot_inv_product; // d_phidot_dot_d_v
    j[38] = minus_minus_air_velocity_product_2; // d_phidot_dot_d_w
    j[39] = minus_inv_p2 * cos_phi_wind_y_plus_sum; // d_phidot_dot_d_phi
    j[40] = minus_phidot_part_plus_sum; // d_phidot_dot_d_theta
    j[41] = minus_thetadot_minus_sum; // d_phidot_dot_d_phidot
    j[42] = minus_I_a_angular_product; // d_phidot_dot_d_thetadot
    j[43] = C_Rr_air_velocity_1_sum * inv_cos_theta_inv_I_d; // d_phidot_dot_d_gammadot
    j[44] = inv_p2 * minus_w_plus_cos_sum_3; // d_thetadot_dot_d_u
    j[45] = inv_p2 * minus_w_plus_cos_sum_4; // d_thetadot_dot_d_v
    j[46] = minus_inv_p2 * air_velocity_1_product_sum_2; // d_thetadot_dot_d_w
    j[47] = minus_inv_p2 * part_of_d_thetadot_dot_d_phi_2; // d_thetadot_dot_d_phi
    j[48] = part_of_d_thetadot_dot_d_theta_6; // d_thetadot_dot_d_theta
    j[49] = part_of_d_thetadot_dot_d_phidot_3; // d_thetadot_dot_d_phidot
    j[50] = part_of_d_thetadot_dot_d_thetadot; // d_thetadot_dot_d_thetadot
    // d_thetadot_dot_d_gammadot
    j[51] = C_Rr * inv_I_d_air_product + I_a * cos_theta_phidot_inv_I_d;
    j[52] = minus_minus_minus_minus_w_product; // d_gammadot_dot_d_u
    j[53] = minus_thetadot_inv_sqrt_sum * sin_theta_inv_cos_product; // d_gammadot_dot_d_v
    j[54] = minus_air_velocity_product_3; // d_gammadot_dot_d_w
    j[55] = cos_phi_wind_y_plus_sum * sin_theta_inv_I_d; // d_gammadot_dot_d_phi
    j[56] = part_of_d_gammadot_dot_d_theta_2; // d_gammadot_dot_d_theta
    j[57] = part_of_d_gammadot_dot_d_phidot; // d_gammadot_dot_d_phidot
    j[58] = part_of_d_gammadot_dot_d_thetadot; // d_gammadot_dot_d_thetadot
    // d_gammadot_dot_d_gammadot
    j[59] = p14_inv_p1 - C_Rr_air_velocity_1_sum * sin_theta_inv_cos_product;

    jp[0] = part_of_d_u_dot_d_m; // d_u_dot_d_m
    jp[1] = minus_p5_half * air_velocity_1_inv_product_3; // d_u_dot_d_A
    jp[2] = minus_p4_half * air_velocity_1_inv_product_3; // d_u_dot_d_rho
    jp[3] = sin_theta_cos_phi; // d_u_dot_d_g
    jp[4] = minus_w_plus_cos_theta_sum * air_velocity_1_rho_product_2; // d_u_dot_d_C_L0
    jp[5] = minus_w_plus_cos_product_2 * air_velocity_1_rho_product_2; // d_u_dot_d_C_La
    jp[6] = minus_sqrt_air_velocity_1_product; // d_u_dot_d_C_D0
    jp[7] = minus_air_velocity_1_rho_product; // d_u_dot_d_C_Da
    jp[8] = part_of_d_u_dot_d_wind_x_2; // d_u_dot_d_wind_x
    jp[9] = part_of_d_u_dot_d_wind_y_2; // d_u_dot_d_wind_y
    jp[10] = part_of_d_u_dot_d_wind_z_2; // d_u_dot_d_wind_z
    jp[11] = inv_p0_sq * air_velocity_2_rho_sum - p6_inv_p0 * sin_phi; // d_v_dot_d_m
    jp[12] = minus_p5_half * air_velocity_2_inv_product_3; // d_v_dot_d_A
    jp[13] = minus_p4_half * air_velocity_2_inv_product_3; // d_v_dot_d_rho
    jp[14] = minus_sin_phi; // d_v_dot_d_g
    jp[15] = minus_w_plus_cos_theta_sum * air_velocity_2_rho_product; // d_v_dot_d_C_L0
    jp[16] = minus_w_plus_cos_product_2 * air_velocity_2_rho_product; // d_v_dot_d_C_La
    jp[17] = minus_sqrt_air_velocity_1_product_2; // d_v_dot_d_C_D0
    jp[18] = minus_air_velocity_2_rho_product; // d_v_dot_d_C_Da
    jp[19] = part_of_d_v_dot_d_wind_x * air_velocity_2_inv_m; // d_v_dot_d_wind_x
    jp[20] = inv_p0 * part_of_d_v_dot_d_wind_y; // d_v_dot_d_wind_y
    jp[21] = inv_p0 * part_of_d_v_dot_d_wind_z; // d_v_dot_d_wind_z
    jp[22] = minus_p6_inv_p0 * cos_theta_cos_phi - inv_p0_sq * force_b_3; // d_w_dot_d_m
    jp[23] = p5_half * sqrt_air_velocity_1_product_3; // d_w_dot_d_A
    jp[24] = p4_half * sqrt_air_velocity_1_product_3; // d_w_dot_d_rho
    jp[25] = minus_cos_theta_cos_phi; // d_w_dot_d_g
    jp[26] = d_w_dot_d_C_L; // d_w_dot_d_C_L0
    jp[27] = sqrt_air_velocity_1_product * rho_A_half_V_inv_m; // d_w_dot_d_C_La
    jp[28] = d_w_dot_d_C_D; // d_w_dot_d_C_D0
    jp[29] = alpha * minus_w_plus_cos_product_2 * rho_A_half_V_inv_m; // d_w_dot_d_C_Da
    jp[30] = minus_p4_p5_half_inv_p0 * part_of_d_w_dot_d_wind_x; // d_w_dot_d_wind_x
    jp[31] = minus_p4_p5_half_inv_p0 * part_of_d_w_dot_d_wind_y_2; // d_w_dot_d_wind_y
    jp[32] = p4_p5_half_inv_p0 * part_of_d_w_dot_d_wind_z_2; // d_w_dot_d_wind_z
    jp[33] = minus_inv_cos_theta_inv_I_product; // d_phidot_dot_d_I_a
    jp[34] = minus_minus_thetadot_I_a_product; // d_phidot_dot_d_I_d
    jp[35] = inv_cos_theta_inv_I_d * rho_A_half_inv_sqrt_product_6; // d_phidot_dot_d_d
    jp[36] = p5_half * inv_cos_theta_inv_I_product_2; // d_phidot_dot_d_A
    jp[37] = p4_half * inv_cos_theta_inv_I_product_2; // d_phidot_dot_d_rho
    jp[38] = minus_inv_cos_theta_inv_I_product_2; // d_phidot_dot_d_C_Ma
    jp[39] = inv_cos_theta_inv_I_d * air_velocity_1_air_product; // d_phidot_dot_d_C_Mq
    jp[40] = angular_velocity_3 * inv_cos_theta_inv_I_product; // d_phidot_dot_d_C_Rr
    // d_phidot_dot_d_wind_x
    jp[41] = minus_air_velocity_product_3 - inv_p2 * minus_minus_minus_w_sum;
    jp[42] = inv_p2 * cos_phi_inv_cos_product_sum; // d_phidot_dot_d_wind_y
    jp[43] = inv_p2 * sin_phi_inv_cos_product_sum; // d_phidot_dot_d_wind_z
    jp[44] = angular_velocity_3 * cos_theta_phidot_inv_I_d; // d_thetadot_dot_d_I_a
    jp[45] = part_of_d_thetadot_dot_d_I_d; // d_thetadot_dot_d_I_d
    jp[46] = part_of_d_thetadot_dot_d_d; // d_thetadot_dot_d_d
    jp[47] = p5_half * minus_w_plus_cos_product_6; // d_thetadot_dot_d_A
    jp[48] = p4_half * minus_w_plus_cos_product_6; // d_thetadot_dot_d_rho
    jp[49] = alpha * inv_I_d_air_product_2; // d_thetadot_dot_d_C_Ma
    // d_thetadot_dot_d_C_Mq
    jp[50] = inv_p2 * part_of_d_thetadot_dot_d_C_Mq * inv_sqrt_air_product_6;
    jp[51] = angular_velocity_3 * inv_I_d_air_product; // d_thetadot_dot_d_C_Rr
    jp[52] = minus_inv_p2 * part_of_d_thetadot_dot_d_wind_x; // d_thetadot_dot_d_wind_x
    jp[53] = minus_inv_p2 * part_of_d_thetadot_dot_d_wind_y; // d_thetadot_dot_d_wind_y
    jp[54] = minus_inv_p2 * part_of_d_thetadot_dot_d_wind_z; // d_thetadot_dot_d_wind_z
    jp[55] = part_of_d_gammadot_dot_d_I_a_2; // d_gammadot_dot_d_I_a
    jp[56] = minus_thetadot_I_a_sum_2 * sin_theta_inv_cos_product; // d_gammadot_dot_d_I_d
    jp[57] = minus_sin_theta_inv_cos_product; // d_gammadot_dot_d_d
    jp[58] = minus_p5_half * sin_theta_inv_cos_product_2; // d_gammadot_dot_d_A
    jp[59] = minus_p4_half * sin_theta_inv_cos_product_2; // d_gammadot_dot_d_rho
    jp[60] = sin_theta_inv_cos_product * alpha_air_velocity_2_product; // d_gammadot_dot_d_C_Ma
    jp[61] = minus_sin_theta_inv_cos_product_2; // d_gammadot_dot_d_C_Mq
    jp[62] = minus_angular_velocity_3_product; // d_gammadot_dot_d_C_Rr
    jp[63] = inv_p1 * angular_velocity_3; // d_gammadot_dot_d_C_Nr
    jp[64] = part_of_d_gammadot_dot_d_wind_x * sin_theta_inv_I_d; // d_gammadot_dot_d_wind_x
    jp[65] = minus_cos_phi_inv_cos_sum; // d_gammadot_dot_d_wind_y
    jp[66] = minus_sin_phi_inv_cos_sum; // d_gammadot_dot_d_wind_z
}
