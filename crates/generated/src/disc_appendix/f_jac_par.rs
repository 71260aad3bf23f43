// Written by `hyzer generate`; changes belong in the model.
//! `disc_appendix`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 552 operations: 144 add, 363 mul, 3 div, 35 neg, 2 sqrt, 5 call.
/// `prepare` takes 27 operations for it.
#[inline(always)]
pub fn f_jac_par<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 25],
    dx: &mut [T; 12],
    j: &mut [T; 60],
    jp: &mut [T; 67],
) {
    let phi = state[6];
    let (sin_phi, cos_phi) = phi.sin_cos();
    j[9] = sin_phi; // d_z_dot_d_v
    j[4] = cos_phi; // d_y_dot_d_v
    let theta = state[7];
    let (sin_theta, cos_theta) = theta.sin_cos();
    j[0] = cos_theta; // d_x_dot_d_u
    j[1] = sin_theta; // d_x_dot_d_w
    let w = state[5];
    let d_u_dot_d_thetadot = -w;
    j[19] = d_u_dot_d_thetadot;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let phidot = state[9];
    let cos_theta_phidot = cos_theta * phidot;
    let sin_theta_phidot = sin_theta * phidot;
    let g_m = prepared[3];
    let cos_phi_g_m = g_m * cos_phi;
    let wind_z = parameters[17];
    let wind_y = parameters[16];
    let sin_phi_wind_y_sum = wind_z.neg_mul_add(cos_phi, wind_y * sin_phi);
    let minus_wind_y = prepared[6];
    let d_minus_sin_phi_wind_y_sum_d_phi = wind_z.neg_mul_add(sin_phi, minus_wind_y * cos_phi);
    let inv_I_d = prepared[1];
    let cos_theta_phidot_inv_I_d = inv_I_d * cos_theta_phidot;
    let gammadot = state[11];

    // disc_appendix.hyz:64  let angular_velocity = (phidot*cos(theta), thetadot, phidot*sin(th …
    let angular_velocity_3 = sin_theta_phidot + gammadot;
    let inv_m = prepared[0];
    let v = state[4];
    let v_phidot_plus_cos_phi_g_sum = inv_m.mul_add(cos_phi_g_m, v * phidot);
    let wind_x = parameters[15];
    let d_minus_air_velocity_3_d_theta = sin_theta.mul_add(sin_phi_wind_y_sum, wind_x * cos_theta);
    let d_air_velocity_1_d_theta = cos_theta.neg_mul_add(sin_phi_wind_y_sum, wind_x * sin_theta);
    let u = state[3];

    // disc_appendix.hyz:122  der(x) = u*cos(theta) + w*sin(theta);
    let x_dot = w.mul_add(sin_theta, u * cos_theta);
    dx[0] = x_dot;
    let d_u_dot_d_phidot = sin_theta * v;
    j[18] = d_u_dot_d_phidot;
    let d_v_dot_d_g = -sin_phi;
    jp[14] = d_v_dot_d_g;
    let d_w_cos_theta_minus_sin_sum_d_theta = -x_dot;
    let d_z_dot_d_theta = cos_phi * d_w_cos_theta_minus_sin_sum_d_theta;
    j[12] = d_z_dot_d_theta;
    let d_thetadot_dot_d_I_a = angular_velocity_3 * cos_theta_phidot_inv_I_d;
    jp[44] = d_thetadot_dot_d_I_a;
    let inv_I_a = prepared[2];
    let d_gammadot_dot_d_C_Nr = inv_I_a * angular_velocity_3;
    jp[63] = d_gammadot_dot_d_C_Nr;

    // disc_appendix.hyz:67  let air_velocity = velocity - in_B(wind);
    let air_velocity_2 = v + d_minus_sin_phi_wind_y_sum_d_phi;
    let air_velocity_1 = u - d_minus_air_velocity_3_d_theta;
    let minus_air_velocity_3 = d_air_velocity_1_d_theta - w;
    let I_a = parameters[1];
    let angular_velocity_3_I_a = I_a * angular_velocity_3;
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let air_velocity_1_cos_product = air_velocity_1 * cos_theta_phidot;
    let thetadot = state[10];
    let air_velocity_2_thetadot = air_velocity_2 * thetadot;
    let air_velocity_2_cos_product = air_velocity_2 * cos_theta_phidot;
    let air_velocity_1_thetadot = air_velocity_1 * thetadot;
    let inv_cos_theta_inv_I_d = inv_I_d * inv_cos_theta;
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);
    let thetadot_air_velocity_2_sum = air_velocity_1_cos_product + air_velocity_2_thetadot;
    let minus_thetadot_air_sum = air_velocity_2_cos_product - air_velocity_1_thetadot;
    let I_d_two = prepared[5];
    let angular_velocity_3_I_a_sum = I_d_two.neg_mul_add(sin_theta_phidot, angular_velocity_3_I_a);
    let I_d = parameters[2];
    let angular_velocity_3_I_a_sum_2 = I_d.neg_mul_add(sin_theta_phidot, angular_velocity_3_I_a);

    // disc_appendix.hyz:69  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let d = parameters[3];
    let V_sq_d = d * V_sq;
    let part_of_d_der_phidot_d_C_Mq = air_velocity_1 * thetadot_air_velocity_2_sum;
    let part_of_d_der_phidot_d_C_Mq_2 =
        air_velocity_2.mul_add(minus_thetadot_air_sum, part_of_d_der_phidot_d_C_Mq);
    let part_of_d_thetadot_dot_d_C_Mq = air_velocity_2 * thetadot_air_velocity_2_sum;
    let part_of_d_thetadot_dot_d_C_Mq_2 =
        air_velocity_1.neg_mul_add(minus_thetadot_air_sum, part_of_d_thetadot_dot_d_C_Mq);
    let thetadot_inv_cos_product = thetadot * inv_cos_theta_inv_I_d;
    let part_of_air_velocity_1_product_2 = thetadot * angular_velocity_3_I_a_sum;
    let angular_velocity_3_product = angular_velocity_3_I_a_sum * inv_cos_theta_inv_I_d;
    let d_gammadot_dot_d_thetadot = sin_theta.mul_sub(angular_velocity_3_product, cos_theta_phidot);
    j[58] = d_gammadot_dot_d_thetadot;
    let d_phidot_dot_d_thetadot = -angular_velocity_3_product;
    j[42] = d_phidot_dot_d_thetadot;
    let air_velocity_1_inv_m = inv_m * air_velocity_1;
    let part_of_d_thetadot_dot_d_I_d = sin_theta_phidot * cos_theta_phidot_inv_I_d;
    let air_velocity_2_inv_m = inv_m * air_velocity_2;
    let part_of_d_der_phidot_d_I_d = T::splat(2.0) * sin_theta_phidot * thetadot_inv_cos_product;
    let g = parameters[6];
    let sin_phi_g_m_inv_m = g * sin_phi;
    let part_of_d_w_dot_d_phi = air_velocity_2 * sin_phi_wind_y_sum;
    let part_of_d_w_dot_d_phi_2 =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_add(sin_theta * air_velocity_1, part_of_d_w_dot_d_phi);
    let inv_I_d_angular_product = inv_I_d * angular_velocity_3_I_a_sum_2;
    let part_of_air_velocity_2_product_2 = cos_theta_phidot * angular_velocity_3_I_a_sum_2;
    let sin_theta_angular_velocity_3 = sin_theta * angular_velocity_3;
    let w_cos_theta_minus_sin_sum = u.neg_mul_add(sin_theta, cos_theta * w);
    j[2] = w_cos_theta_minus_sin_sum; // d_x_dot_d_theta
    j[25] = w_cos_theta_minus_sin_sum; // d_v_dot_d_phidot

    // disc_appendix.hyz:74  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let minus_C_Da_two = prepared[14];
    let part_of_minus_inv_air_velocity_7 = minus_C_Da_two * air_velocity_12_sq * alpha;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let C_La = parameters[8];
    let air_velocity_12_C_La = C_La * air_velocity_12;
    let cos_theta_sin_phi = cos_theta * sin_phi;
    let d_y_dot_d_w = -cos_theta_sin_phi;
    j[5] = d_y_dot_d_w;
    let C_Nr = parameters[14];

    // disc_appendix.hyz:88  let spin_down = C_Nr*r;
    let spin_down = C_Nr * angular_velocity_3;
    let inv_V = V.recip_or_zero();
    let C_La_half_rho_A_inv_m = prepared[15];
    let part_of_d_w_dot_d_minus_air_2 = C_La_half_rho_A_inv_m * air_velocity_12_sq * inv_V;
    let V_inv_m = inv_m * V;
    let d_y_dot_d_u = sin_theta * sin_phi;
    j[3] = d_y_dot_d_u;
    let d_u_dot_d_g = sin_theta * cos_phi;
    jp[3] = d_u_dot_d_g;
    let d_z_dot_d_u = -d_u_dot_d_g;
    j[8] = d_z_dot_d_u;
    let d_minus_air_velocity_3_d_wind_z = cos_theta * cos_phi;
    j[10] = d_minus_air_velocity_3_d_wind_z; // d_z_dot_d_w
    let d_w_dot_d_g = -d_minus_air_velocity_3_d_wind_z;
    jp[25] = d_w_dot_d_g;
    let part_of_d_thetadot_dot_d_theta = sin_theta * inv_I_d_angular_product;
    let part_of_d_thetadot_dot_d_phidot = cos_theta * inv_I_d_angular_product;
    let part_of_d_w_dot_d_wind_y = air_velocity_1.mul_add(d_y_dot_d_u, cos_phi * air_velocity_2);
    let part_of_d_w_dot_d_wind_z_2 = air_velocity_1.mul_sub(d_u_dot_d_g, sin_phi * air_velocity_2);
    let part_of_d_gammadot_dot_d_I_a = thetadot_inv_cos_product * sin_theta_angular_velocity_3;
    let d_phidot_dot_d_I_a = -(angular_velocity_3 * thetadot_inv_cos_product);
    jp[33] = d_phidot_dot_d_I_a;

    // disc_appendix.hyz:124  der(z) = -u*sin(theta)*cos(phi) + v*sin(phi) + w*cos(theta)*cos(p …
    let z_dot = w_cos_theta_minus_sin_sum.mul_add(cos_phi, sin_phi * v);
    dx[2] = z_dot;
    let d_y_dot_d_phi = -z_dot;
    j[6] = d_y_dot_d_phi;
    let half_rho_A = prepared[4];
    let inv_air_velocity_12_product = half_rho_A * inv_air_velocity_12;
    let V_sq_inv_air_product = V_sq * inv_air_velocity_12_product;
    let C_Mq = parameters[12];
    let inv_air_velocity_12_C_Mq = C_Mq * inv_air_velocity_12;
    let C_Rr = parameters[13];
    let thetadot_air_product_sum =
        inv_air_velocity_12_C_Mq.mul_add(thetadot_air_velocity_2_sum, C_Rr * angular_velocity_3);
    let C_Ma = parameters[11];
    let minus_minus_thetadot_sum =
        C_Ma.mul_sub(alpha, minus_thetadot_air_sum * inv_air_velocity_12_C_Mq);
    let inv_air_velocity_12_product_8 =
        inv_air_velocity_12_C_Mq * (air_velocity_1_cos_product - air_velocity_2_thetadot);
    let inv_air_velocity_12_product_9 =
        inv_air_velocity_12_C_Mq * (air_velocity_2_cos_product + air_velocity_1_thetadot);
    let air_velocity_12_sq_product = air_velocity_12_sq * inv_air_velocity_12_C_Mq;
    let inv_air_velocity_12_product_3 = inv_air_velocity_12_product * V_sq_d;
    let inv_air_velocity_12_V_sq_d = inv_air_velocity_12 * V_sq_d;
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;
    let C_Ma_inv_V = C_Ma * inv_V;
    let part_of_air_velocity_1_product = air_velocity_1 * thetadot_air_product_sum;
    let air_velocity_1_product_sum =
        air_velocity_2.neg_mul_add(minus_minus_thetadot_sum, part_of_air_velocity_1_product);
    let air_velocity_1_product_sum_2 = inv_air_velocity_12_product_3
        .mul_sub(air_velocity_1_product_sum, part_of_air_velocity_1_product_2);

    // disc_appendix.hyz:112  der(phidot) = (M_b1 + 2*I_d*phidot*thetadot*sin(theta) - I_a*thet …
    let der_phidot = air_velocity_1_product_sum_2 * inv_cos_theta_inv_I_d;
    dx[9] = der_phidot;
    let thetadot_cos_theta_sum = sin_theta.mul_add(der_phidot, thetadot * cos_theta_phidot);
    let d_der_phidot_d_I_d = inv_I_d.neg_mul_add(der_phidot, part_of_d_der_phidot_d_I_d);
    jp[34] = d_der_phidot_d_I_d; // d_phidot_dot_d_I_d
    let minus_I_a_thetadot_cos_sum = I_a.neg_mul_add(thetadot_cos_theta_sum, spin_down);
    let part_of_d_gammadot_dot_d_I_a_2 =
        inv_I_a.neg_mul_add(thetadot_cos_theta_sum, part_of_d_gammadot_dot_d_I_a);
    let inv_I_a_sq = prepared[23];
    let d_gammadot_dot_d_I_a =
        inv_I_a_sq.neg_mul_add(minus_I_a_thetadot_cos_sum, part_of_d_gammadot_dot_d_I_a_2);
    jp[55] = d_gammadot_dot_d_I_a;

    // disc_appendix.hyz:119  der(gammadot) = (M_b3 - I_a*(der(phidot)*sin(theta) + phidot*thet …
    let gammadot_dot = inv_I_a * minus_I_a_thetadot_cos_sum;
    dx[11] = gammadot_dot;
    let d_gammadot_dot_d_I_d = -(sin_theta * d_der_phidot_d_I_d);
    jp[56] = d_gammadot_dot_d_I_d;
    let inv_air_velocity_12_product_6 = inv_air_velocity_12_product_3 * inv_cos_theta_inv_I_d;
    let d_der_phidot_d_C_Mq =
        inv_air_velocity_12 * (part_of_d_der_phidot_d_C_Mq_2 * inv_air_velocity_12_product_6);
    jp[39] = d_der_phidot_d_C_Mq; // d_phidot_dot_d_C_Mq
    let air_velocity_12_inv_V = air_velocity_12 * inv_V;
    let minus_air_velocity_product = minus_air_velocity_3_inv_V * C_Ma_inv_V;
    let air_velocity_12_inv_product = air_velocity_12_inv_V * C_Ma_inv_V;
    let part_of_d_der_phidot_d_air =
        air_velocity_2 * inv_air_velocity_12_product_3 * minus_air_velocity_product;
    let part_of_minus_inv_air_velocity = inv_air_velocity_12_product * inv_air_velocity_12_V_sq_d;
    let two_d = prepared[10];
    let inv_air_velocity_12_product_7 = two_d * inv_air_velocity_12_product;
    let minus_inv_air_velocity_sum_3 = air_velocity_12.mul_sub(
        inv_air_velocity_12_product_7,
        part_of_minus_inv_air_velocity,
    );
    let part_of_d_der_phidot_d_air_2 = air_velocity_1_product_sum
        .mul_add(minus_inv_air_velocity_sum_3, part_of_d_der_phidot_d_air);
    let air_velocity_1_product = air_velocity_1_product_sum * inv_cos_theta_inv_I_d;
    let minus_air_velocity_product_2 = minus_air_velocity_3 * inv_air_velocity_12_product_7;
    let air_velocity_2_inv_product_3 = air_velocity_2 * inv_air_velocity_12_product_6;
    let part_of_air_velocity_2_product = air_velocity_2 * thetadot_air_product_sum;
    let air_velocity_2_product_sum =
        air_velocity_1.mul_add(minus_minus_thetadot_sum, part_of_air_velocity_2_product);
    let air_velocity_2_product_sum_2 = inv_air_velocity_12_product_3
        .mul_add(air_velocity_2_product_sum, part_of_air_velocity_2_product_2);
    let minus_inv_I_d_sq = prepared[22];
    let d_thetadot_dot_d_I_d =
        minus_inv_I_d_sq.mul_sub(air_velocity_2_product_sum_2, part_of_d_thetadot_dot_d_I_d);
    jp[45] = d_thetadot_dot_d_I_d;

    // disc_appendix.hyz:115  der(thetadot) = (M_b2 - I_d*phidot^2*cos(theta)*sin(theta) + I_a* …
    let thetadot_dot = inv_I_d * air_velocity_2_product_sum_2;
    dx[10] = thetadot_dot;
    let inv_air_velocity_12_product_10 = inv_I_d * inv_air_velocity_12_product_3;
    let inv_I_d_air_product = inv_I_d * air_velocity_2_product_sum;
    let d_thetadot_dot_d_C_Mq =
        inv_air_velocity_12 * (part_of_d_thetadot_dot_d_C_Mq_2 * inv_air_velocity_12_product_10);
    jp[50] = d_thetadot_dot_d_C_Mq;
    let d_thetadot_dot_d_thetadot = inv_air_velocity_12_product_10 * air_velocity_12_sq_product;
    j[50] = d_thetadot_dot_d_thetadot;
    let d_der_phidot_d_cos_theta_phidot =
        inv_air_velocity_12_product_6 * air_velocity_12_sq_product;
    let d_thetadot_dot_d_d = inv_I_d_air_product * V_sq_inv_air_product;
    jp[46] = d_thetadot_dot_d_d;
    let d_der_phidot_d_d = air_velocity_1_product * V_sq_inv_air_product;
    jp[35] = d_der_phidot_d_d; // d_phidot_dot_d_d
    let d_gammadot_dot_d_d = -(sin_theta * d_der_phidot_d_d);
    jp[57] = d_gammadot_dot_d_d;
    let part_of_d_der_phidot_d_air_3 = inv_air_velocity_12_C_Mq * d_der_phidot_d_C_Mq;
    let d_der_phidot_d_air_velocity_12 =
        inv_cos_theta_inv_I_d.mul_sub(part_of_d_der_phidot_d_air_2, part_of_d_der_phidot_d_air_3);
    let d_gammadot_dot_d_C_Mq = -(sin_theta * d_der_phidot_d_C_Mq);
    jp[61] = d_gammadot_dot_d_C_Mq;
    let part_of_d_der_phidot_d_air_4 =
        (thetadot_air_product_sum + inv_air_velocity_12_product_8) * inv_air_velocity_12_product_6;
    let part_of_d_thetadot_dot_d_air =
        (thetadot_air_product_sum - inv_air_velocity_12_product_8) * inv_air_velocity_12_product_10;
    let part_of_d_der_phidot_d_minus = air_velocity_2_inv_product_3 * air_velocity_12_inv_product;
    let d_der_phidot_d_minus_air_velocity_3 =
        air_velocity_1_product.mul_sub(minus_air_velocity_product_2, part_of_d_der_phidot_d_minus);
    let inv_air_velocity_12_product_12 = inv_air_velocity_12_V_sq_d * air_velocity_1_product;
    let inv_air_velocity_12_product_13 = inv_air_velocity_12_V_sq_d * inv_I_d_air_product;
    let alpha_air_velocity_product = alpha * air_velocity_2_inv_product_3;
    let rho_half = prepared[17];
    jp[36] = rho_half * inv_air_velocity_12_product_12; // d_phidot_dot_d_A
    let A_half = prepared[13];
    jp[37] = A_half * inv_air_velocity_12_product_12; // d_phidot_dot_d_rho
    let sin_theta_inv_air_product = sin_theta * inv_air_velocity_12_product_12;
    let d_phidot_dot_d_w = -d_der_phidot_d_minus_air_velocity_3;
    j[38] = d_phidot_dot_d_w;
    jp[47] = rho_half * inv_air_velocity_12_product_13; // d_thetadot_dot_d_A
    jp[48] = A_half * inv_air_velocity_12_product_13; // d_thetadot_dot_d_rho
    let minus_rho_half = prepared[18];
    jp[58] = minus_rho_half * sin_theta_inv_air_product; // d_gammadot_dot_d_A
    let minus_A_half = prepared[19];
    jp[59] = minus_A_half * sin_theta_inv_air_product; // d_gammadot_dot_d_rho
    let d_gammadot_dot_d_C_Ma = sin_theta * alpha_air_velocity_product;
    jp[60] = d_gammadot_dot_d_C_Ma;
    let d_phidot_dot_d_C_Ma = -alpha_air_velocity_product;
    jp[38] = d_phidot_dot_d_C_Ma;
    let C_L0 = parameters[7];

    // disc_appendix.hyz:77  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La.mul_add(alpha, C_L0);
    let C_Da = parameters[10];
    let C_D0 = parameters[9];

    // disc_appendix.hyz:78  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = alpha.mul_add(C_Da * alpha, C_D0);
    let air_velocity_12_alpha = air_velocity_12 * alpha;
    let C_Da_two = prepared[8];
    let part_of_minus_inv_air_velocity_2 =
        C_Da_two.neg_mul_add(air_velocity_12_alpha, C_La * minus_air_velocity_3);
    let part_of_minus_inv_air_velocity_3 = minus_air_velocity_3 * part_of_minus_inv_air_velocity_2;
    let air_velocity_1_inv_product_3 = air_velocity_1 * inv_air_velocity_12_product_10;
    let part_of_d_thetadot_dot_d_air_2 = air_velocity_1_inv_product_3 * minus_air_velocity_product;
    let part_of_d_thetadot_dot_d_air_3 =
        minus_inv_air_velocity_sum_3.mul_sub(inv_I_d_air_product, part_of_d_thetadot_dot_d_air_2);
    let d_thetadot_dot_d_air_velocity_12 =
        inv_air_velocity_12_C_Mq.neg_mul_add(d_thetadot_dot_d_C_Mq, part_of_d_thetadot_dot_d_air_3);
    let part_of_air_velocity_1_inv_sum = air_velocity_1_inv_product_3 * air_velocity_12_inv_product;
    let air_velocity_1_inv_sum =
        inv_I_d_air_product.mul_add(minus_air_velocity_product_2, part_of_air_velocity_1_inv_sum);
    let d_thetadot_dot_d_C_Ma = alpha * air_velocity_1_inv_product_3;
    jp[49] = d_thetadot_dot_d_C_Ma;
    let d_thetadot_dot_d_w = -air_velocity_1_inv_sum;
    j[46] = d_thetadot_dot_d_w;
    let air_velocity_12_C_D_sum = air_velocity_12.mul_sub(C_D, minus_air_velocity_3 * C_L);
    let part_of_minus_inv_air_velocity_4 =
        air_velocity_12.mul_add(air_velocity_12_C_D_sum, part_of_minus_inv_air_velocity_3);
    let part_of_minus_inv_air_velocity_5 =
        inv_air_velocity_12_product * inv_V * part_of_minus_inv_air_velocity_4;
    let V_C_L = V * C_L;
    let minus_air_velocity_3_C_sum = minus_air_velocity_3.mul_add(C_D, air_velocity_12 * C_L);

    // disc_appendix.hyz:91  let force_b = (lift*sin(alpha) - drag*cos(alpha))*d1 + (lift*cos(a …
    let force_b_3 = minus_air_velocity_3_C_sum.mul_sub(half_rho_A * V, cos_theta * cos_phi_g_m);

    // disc_appendix.hyz:106  der(w) = F_b3/m + u*thetadot - v*phidot*cos(theta);
    let w_dot = v.neg_mul_add(cos_theta_phidot, inv_m.mul_add(force_b_3, u * thetadot));
    dx[5] = w_dot;
    let part_of_minus_inv_air_velocity_6 = air_velocity_12_C_D_sum - air_velocity_12_C_La;
    let part_of_minus_inv_air_velocity_8 = minus_air_velocity_3.neg_mul_add(
        part_of_minus_inv_air_velocity_6,
        part_of_minus_inv_air_velocity_7,
    );
    let part_of_d_w_dot_d_air_velocity_2 =
        minus_air_velocity_3_C_sum.mul_add(air_velocity_12_inv_V, V_C_L);
    let part_of_minus_inv_air_velocity_9 =
        inv_air_velocity_12_product * inv_V.mul_add(part_of_minus_inv_air_velocity_8, V_C_L);
    let minus_inv_air_velocity_sum_2 = -part_of_minus_inv_air_velocity_9;
    let d_v_dot_d_w = minus_inv_air_velocity_sum_2.mul_add(air_velocity_2_inv_m, cos_theta_phidot);
    j[22] = d_v_dot_d_w;
    let air_velocity_12_C_D_product = air_velocity_12_C_D_sum * inv_air_velocity_12_product;
    let air_velocity_12_C_D_product_2 = air_velocity_12_C_D_sum * V_inv_m;
    let part_of_minus_inv_air_velocity_10 = C_D * inv_air_velocity_12_product;
    let inv_air_velocity_12_product_11 = inv_air_velocity_12_product * V_inv_m;
    let part_of_minus_inv_air_velocity_11 = inv_air_velocity_12.mul_sub(
        air_velocity_12_C_D_product,
        part_of_minus_inv_air_velocity_10,
    );
    let minus_inv_air_velocity_sum = V.mul_sub(
        part_of_minus_inv_air_velocity_11,
        part_of_minus_inv_air_velocity_5,
    );
    let inv_air_velocity_12_product_2 = V * air_velocity_12_C_D_product;
    let part_of_d_w_dot_d_minus_air =
        minus_air_velocity_3_C_sum.mul_add(minus_air_velocity_3_inv_V, V * C_D);
    let half_rho_A_inv_m = prepared[9];
    let part_of_d_w_dot_d_minus_air_3 =
        half_rho_A_inv_m.mul_add(part_of_d_w_dot_d_minus_air, part_of_d_w_dot_d_minus_air_2);
    let minus_air_velocity_product_3 = minus_air_velocity_3_C_sum * V_inv_m;
    let half_rho_A_V_inv_m = half_rho_A * V_inv_m;
    let minus_force_b_1 =
        air_velocity_1.mul_sub(inv_air_velocity_12_product_2, sin_theta * cos_phi_g_m);
    let minus_force_b_2 = air_velocity_2.mul_add(inv_air_velocity_12_product_2, g_m * sin_phi);
    let inv_air_velocity_12_product_4 = inv_m * inv_air_velocity_12_product_2;
    let minus_force_b_1_inv_m = inv_m * minus_force_b_1;
    let inv_m_minus_force_b_2 = inv_m * minus_force_b_2;

    // disc_appendix.hyz:104  der(v) = F_b2/m + w*phidot*cos(theta) - u*phidot*sin(theta);
    let v_dot = w_cos_theta_minus_sin_sum.mul_sub(phidot, inv_m_minus_force_b_2);
    dx[4] = v_dot;
    jp[23] = rho_half * minus_air_velocity_product_3; // d_w_dot_d_A
    jp[24] = A_half * minus_air_velocity_product_3; // d_w_dot_d_rho
    let d_w_dot_d_C_L = air_velocity_12 * half_rho_A_V_inv_m;
    jp[26] = d_w_dot_d_C_L; // d_w_dot_d_C_L0
    let d_w_dot_d_C_La = air_velocity_12_alpha * half_rho_A_V_inv_m;
    jp[27] = d_w_dot_d_C_La;
    let alpha_air_velocity_12_alpha = alpha * air_velocity_12_alpha;
    let d_w_dot_d_C_D = minus_air_velocity_3 * half_rho_A_V_inv_m;
    jp[28] = d_w_dot_d_C_D; // d_w_dot_d_C_D0
    let d_v_dot_d_m = inv_m * g.neg_mul_add(sin_phi, inv_m_minus_force_b_2);
    jp[11] = d_v_dot_d_m;
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let d_der_phidot_d_air_velocity_1 = d_der_phidot_d_air_velocity_12
        .mul_add(air_velocity_1_inv_product, part_of_d_der_phidot_d_air_4);
    j[36] = d_der_phidot_d_air_velocity_1; // d_phidot_dot_d_u
    let minus_air_velocity_3_alpha = minus_air_velocity_3 * alpha;
    let part_of_d_w_dot_d_air_velocity =
        C_Da_two.mul_add(minus_air_velocity_3_alpha, air_velocity_12_C_La);
    let part_of_d_w_dot_d_air_velocity_3 = minus_air_velocity_3_inv_V.neg_mul_add(
        part_of_d_w_dot_d_air_velocity,
        part_of_d_w_dot_d_air_velocity_2,
    );
    let d_w_dot_d_air_velocity_12 = half_rho_A_inv_m * part_of_d_w_dot_d_air_velocity_3;
    let d_w_dot_d_C_Da = alpha * minus_air_velocity_3_alpha * half_rho_A_V_inv_m;
    jp[29] = d_w_dot_d_C_Da;
    let air_velocity_1_inv_product_2 = air_velocity_1 * inv_air_velocity_12_product_6;
    let air_velocity_1_inv_product_5 = air_velocity_1 * inv_air_velocity_12_product_11;
    let air_velocity_2_inv_product_6 = air_velocity_2 * inv_air_velocity_12_product_11;
    let d_der_phidot_d_angular_velocity_3 =
        C_Rr.mul_sub(air_velocity_1_inv_product_2, I_a * thetadot_inv_cos_product);
    j[43] = d_der_phidot_d_angular_velocity_3; // d_phidot_dot_d_gammadot
    let d_der_phidot_d_sin_theta_phidot =
        inv_cos_theta.mul_add(T::splat(2.0) * thetadot, d_der_phidot_d_angular_velocity_3);
    let d_gammadot_dot_d_angular_velocity_3 = prepared[12];
    let d_gammadot_dot_d_gammadot = sin_theta.neg_mul_add(
        d_der_phidot_d_angular_velocity_3,
        d_gammadot_dot_d_angular_velocity_3,
    );
    j[59] = d_gammadot_dot_d_gammadot;
    let d_der_phidot_d_C_Rr = angular_velocity_3 * air_velocity_1_inv_product_2;
    jp[40] = d_der_phidot_d_C_Rr; // d_phidot_dot_d_C_Rr
    let d_gammadot_dot_d_C_Rr = -(air_velocity_1_inv_product_2 * sin_theta_angular_velocity_3);
    jp[62] = d_gammadot_dot_d_C_Rr;
    let d_u_dot_d_C_L0 = minus_air_velocity_3 * air_velocity_1_inv_product_5;
    jp[4] = d_u_dot_d_C_L0;
    let d_v_dot_d_C_L0 = minus_air_velocity_3 * air_velocity_2_inv_product_6;
    jp[15] = d_v_dot_d_C_L0;
    let d_u_dot_d_C_La = minus_air_velocity_3_alpha * air_velocity_1_inv_product_5;
    jp[5] = d_u_dot_d_C_La;
    let d_v_dot_d_C_La = minus_air_velocity_3_alpha * air_velocity_2_inv_product_6;
    jp[16] = d_v_dot_d_C_La;
    let C_Da_two_half_rho_A_inv_m = prepared[16];
    let part_of_d_w_dot_d_minus_air_4 = C_Da_two_half_rho_A_inv_m * minus_air_velocity_3_alpha;
    let d_w_dot_d_minus_air_velocity_3 =
        air_velocity_12_inv_V.mul_add(part_of_d_w_dot_d_minus_air_4, part_of_d_w_dot_d_minus_air_3);
    let d_w_dot_d_w = -d_w_dot_d_minus_air_velocity_3;
    j[28] = d_w_dot_d_w;
    let part_of_minus_d_der_phidot_d =
        (minus_minus_thetadot_sum - inv_air_velocity_12_product_9) * inv_air_velocity_12_product_6;
    let part_of_d_thetadot_dot_d_air_4 =
        (minus_minus_thetadot_sum + inv_air_velocity_12_product_9) * inv_air_velocity_12_product_10;
    let air_velocity_2_inv_product_4 = air_velocity_2 * inv_air_velocity_12_product_10;
    let d_thetadot_dot_d_C_Rr = angular_velocity_3 * air_velocity_2_inv_product_4;
    jp[51] = d_thetadot_dot_d_C_Rr;
    let d_thetadot_dot_d_angular_velocity_3 =
        C_Rr.mul_add(air_velocity_2_inv_product_4, I_a * cos_theta_phidot_inv_I_d);
    j[51] = d_thetadot_dot_d_angular_velocity_3; // d_thetadot_dot_d_gammadot
    let air_velocity_2_inv_product_2 = air_velocity_2 * inv_air_velocity_12;
    let minus_d_der_phidot_d_air_velocity_2 = d_der_phidot_d_air_velocity_12
        .neg_mul_add(air_velocity_2_inv_product_2, part_of_minus_d_der_phidot_d);
    let inv_air_velocity_12_product_5 = inv_air_velocity_12 * d_w_dot_d_air_velocity_12;
    let d_thetadot_dot_d_air_velocity_1 = d_thetadot_dot_d_air_velocity_12
        .mul_add(air_velocity_1_inv_product, part_of_d_thetadot_dot_d_air_4);
    j[44] = d_thetadot_dot_d_air_velocity_1; // d_thetadot_dot_d_u
    let d_thetadot_dot_d_air_velocity_2 = d_thetadot_dot_d_air_velocity_12
        .mul_add(air_velocity_2_inv_product_2, part_of_d_thetadot_dot_d_air);
    j[45] = d_thetadot_dot_d_air_velocity_2; // d_thetadot_dot_d_v
    let d_thetadot_dot_d_sin_theta_phidot = d_thetadot_dot_d_angular_velocity_3 - cos_theta_phidot;
    let d_thetadot_dot_d_phidot = sin_theta.mul_add(
        d_thetadot_dot_d_sin_theta_phidot,
        part_of_d_thetadot_dot_d_phidot,
    );
    j[49] = d_thetadot_dot_d_phidot;
    let part_of_d_thetadot_dot_d_theta_2 = cos_theta.mul_sub(
        d_thetadot_dot_d_sin_theta_phidot,
        part_of_d_thetadot_dot_d_theta,
    );
    let d_w_dot_d_v =
        d_w_dot_d_air_velocity_12.mul_sub(air_velocity_2_inv_product_2, cos_theta_phidot);
    j[27] = d_w_dot_d_v;
    let d_w_dot_d_air_velocity_1 = d_w_dot_d_air_velocity_12 * air_velocity_1_inv_product;
    let part_of_d_w_dot_d_phi_4 = part_of_d_w_dot_d_phi_2 * inv_air_velocity_12_product_5;
    j[53] = sin_theta * minus_d_der_phidot_d_air_velocity_2; // d_gammadot_dot_d_v
    let d_phidot_dot_d_v = -minus_d_der_phidot_d_air_velocity_2;
    j[37] = d_phidot_dot_d_v;
    let d_w_dot_d_u = thetadot + d_w_dot_d_air_velocity_1;
    j[26] = d_w_dot_d_u;
    let part_of_d_der_phidot_d_theta =
        d_minus_air_velocity_3_d_theta * d_der_phidot_d_minus_air_velocity_3;
    let part_of_d_der_phidot_d_theta_2 = d_air_velocity_1_d_theta
        .mul_add(d_der_phidot_d_air_velocity_1, part_of_d_der_phidot_d_theta);
    let part_of_d_der_phidot_d_theta_3 = cos_theta_phidot.mul_add(
        d_der_phidot_d_sin_theta_phidot,
        part_of_d_der_phidot_d_theta_2,
    );
    let minus_inv_air_product = minus_inv_air_velocity_sum * air_velocity_1_inv_product;
    let minus_inv_air_product_3 = minus_inv_air_velocity_sum * air_velocity_2_inv_product_2;
    let air_velocity_1_inv_product_4 = air_velocity_1_inv_product * air_velocity_12_C_D_product_2;
    let air_velocity_2_inv_product_5 = air_velocity_2_inv_product_2 * air_velocity_12_C_D_product_2;
    jp[1] = minus_rho_half * air_velocity_1_inv_product_4; // d_u_dot_d_A
    jp[2] = minus_A_half * air_velocity_1_inv_product_4; // d_u_dot_d_rho
    jp[12] = minus_rho_half * air_velocity_2_inv_product_5; // d_v_dot_d_A
    jp[13] = minus_A_half * air_velocity_2_inv_product_5; // d_v_dot_d_rho
    let part_of_d_der_phidot_d_theta_4 =
        inv_cos_theta.neg_mul_add(der_phidot, phidot * d_der_phidot_d_cos_theta_phidot);
    let d_der_phidot_d_theta = sin_theta.neg_mul_add(
        part_of_d_der_phidot_d_theta_4,
        part_of_d_der_phidot_d_theta_3,
    );
    j[40] = d_der_phidot_d_theta; // d_phidot_dot_d_theta
    let part_of_d_der_phidot_d_phidot = cos_theta * d_der_phidot_d_cos_theta_phidot;
    let d_der_phidot_d_phidot = sin_theta.mul_add(
        d_der_phidot_d_sin_theta_phidot,
        part_of_d_der_phidot_d_phidot,
    );
    j[41] = d_der_phidot_d_phidot; // d_phidot_dot_d_phidot
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * d_gammadot_dot_d_angular_velocity_3.mul_sub(phidot, der_phidot);
    let part_of_d_gammadot_dot_d_theta_2 = thetadot.neg_mul_add(phidot, d_der_phidot_d_theta);
    let d_gammadot_dot_d_theta = sin_theta.neg_mul_add(
        part_of_d_gammadot_dot_d_theta_2,
        part_of_d_gammadot_dot_d_theta,
    );
    j[56] = d_gammadot_dot_d_theta;
    let part_of_d_gammadot_dot_d_phidot =
        d_gammadot_dot_d_angular_velocity_3 - d_der_phidot_d_phidot;
    let sin_theta_d_der_product = sin_theta * d_der_phidot_d_air_velocity_1;
    let d_gammadot_dot_d_u = -sin_theta_d_der_product;
    j[52] = d_gammadot_dot_d_u;
    let sin_theta_d_der_product_sum =
        cos_theta.mul_add(d_der_phidot_d_minus_air_velocity_3, sin_theta_d_der_product);
    let d_gammadot_dot_d_w = sin_theta * d_der_phidot_d_minus_air_velocity_3;
    j[54] = d_gammadot_dot_d_w;
    let d_der_phidot_d_wind_x =
        cos_theta.neg_mul_add(d_der_phidot_d_air_velocity_1, d_gammadot_dot_d_w);
    jp[41] = d_der_phidot_d_wind_x; // d_phidot_dot_d_wind_x
    let d_gammadot_dot_d_wind_x = -(sin_theta * d_der_phidot_d_wind_x);
    jp[64] = d_gammadot_dot_d_wind_x;
    let d_u_dot_d_air_velocity_1 =
        air_velocity_1_inv_m.mul_sub(minus_inv_air_product, inv_air_velocity_12_product_4);
    j[13] = d_u_dot_d_air_velocity_1; // d_u_dot_d_u
    let d_v_dot_d_air_velocity_2 =
        air_velocity_2_inv_m.mul_sub(minus_inv_air_product_3, inv_air_velocity_12_product_4);
    j[21] = d_v_dot_d_air_velocity_2; // d_v_dot_d_v
    let part_of_d_v_dot_d_phi = sin_phi_wind_y_sum.mul_sub(d_v_dot_d_air_velocity_2, g * cos_phi);
    let part_of_d_u_dot_d_wind_y_3 = d_y_dot_d_u * d_u_dot_d_air_velocity_1;
    let cos_theta_minus_inv_product = cos_theta * minus_inv_air_velocity_sum_2;
    let part_of_d_der_phidot_d_phi = sin_phi_wind_y_sum * minus_d_der_phidot_d_air_velocity_2;
    let d_der_phidot_d_phi = d_minus_sin_phi_wind_y_sum_d_phi
        .mul_sub(sin_theta_d_der_product_sum, part_of_d_der_phidot_d_phi);
    j[39] = d_der_phidot_d_phi; // d_phidot_dot_d_phi
    let d_gammadot_dot_d_phi = -(sin_theta * d_der_phidot_d_phi);
    j[55] = d_gammadot_dot_d_phi;
    let part_of_d_v_dot_d_wind_x = -(cos_theta * minus_inv_air_product);
    let part_of_d_v_dot_d_wind_x_2 =
        sin_theta.neg_mul_add(minus_inv_air_velocity_sum_2, part_of_d_v_dot_d_wind_x);
    let d_v_dot_d_wind_x = part_of_d_v_dot_d_wind_x_2 * air_velocity_2_inv_m;
    jp[19] = d_v_dot_d_wind_x;
    let part_of_d_der_phidot_d_wind_y = cos_phi * minus_d_der_phidot_d_air_velocity_2;
    let part_of_d_der_phidot_d_wind_z = sin_phi * minus_d_der_phidot_d_air_velocity_2;
    let d_der_phidot_d_wind_y =
        sin_phi.neg_mul_add(sin_theta_d_der_product_sum, part_of_d_der_phidot_d_wind_y);
    jp[42] = d_der_phidot_d_wind_y; // d_phidot_dot_d_wind_y
    let d_der_phidot_d_wind_z =
        cos_phi.mul_add(sin_theta_d_der_product_sum, part_of_d_der_phidot_d_wind_z);
    jp[43] = d_der_phidot_d_wind_z; // d_phidot_dot_d_wind_z
    let d_gammadot_dot_d_wind_y = -(sin_theta * d_der_phidot_d_wind_y);
    jp[65] = d_gammadot_dot_d_wind_y;
    let d_gammadot_dot_d_wind_z = -(sin_theta * d_der_phidot_d_wind_z);
    jp[66] = d_gammadot_dot_d_wind_z;
    let minus_inv_air_product_2 = minus_inv_air_velocity_sum_2 * air_velocity_1_inv_m;
    let d_u_dot_d_w = minus_inv_air_product_2 - thetadot;
    j[15] = d_u_dot_d_w;
    let part_of_d_u_dot_d_phi = sin_phi_wind_y_sum * minus_inv_air_product_3;
    let part_of_d_thetadot_dot_d_phi = sin_phi_wind_y_sum * d_thetadot_dot_d_air_velocity_2;
    let part_of_d_u_dot_d_phi_2 = d_minus_sin_phi_wind_y_sum_d_phi
        .mul_sub(cos_theta_minus_inv_product, part_of_d_u_dot_d_phi);
    let part_of_minus_sin_theta_product =
        sin_theta.neg_mul_add(minus_inv_air_product, cos_theta_minus_inv_product);
    let minus_sin_theta_product = part_of_minus_sin_theta_product * air_velocity_2_inv_m;
    let d_v_dot_d_phi = d_minus_sin_phi_wind_y_sum_d_phi
        .neg_mul_add(minus_sin_theta_product, part_of_d_v_dot_d_phi);
    j[23] = d_v_dot_d_phi;
    let part_of_d_u_dot_d_phi_3 =
        d_u_dot_d_air_velocity_1.mul_sub(d_minus_sin_phi_wind_y_sum_d_phi, sin_phi_g_m_inv_m);
    let part_of_d_w_dot_d_phi_3 =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_add(d_w_dot_d_minus_air_velocity_3, sin_phi_g_m_inv_m);
    let d_w_dot_d_phi = cos_theta.mul_add(part_of_d_w_dot_d_phi_3, part_of_d_w_dot_d_phi_4);
    j[29] = d_w_dot_d_phi;
    let part_of_d_u_dot_d_phi_4 = sin_theta * part_of_d_u_dot_d_phi_3;
    let d_u_dot_d_phi =
        air_velocity_1_inv_m.neg_mul_add(part_of_d_u_dot_d_phi_2, part_of_d_u_dot_d_phi_4);
    j[16] = d_u_dot_d_phi;
    let part_of_d_u_dot_d_theta = d_u_dot_d_air_velocity_1 * d_air_velocity_1_d_theta;
    let part_of_d_u_dot_d_theta_2 = d_minus_air_velocity_3_d_theta
        .neg_mul_add(minus_inv_air_product_2, part_of_d_u_dot_d_theta);
    let d_u_dot_d_theta = cos_theta.mul_add(v_phidot_plus_cos_phi_g_sum, part_of_d_u_dot_d_theta_2);
    j[17] = d_u_dot_d_theta;
    let part_of_d_v_dot_d_theta = d_air_velocity_1_d_theta * minus_inv_air_product;
    let air_velocity_2_inv_product = air_velocity_2_inv_m * minus_inv_air_product;
    let part_of_d_v_dot_d_theta_2 = minus_inv_air_velocity_sum_2
        .mul_sub(d_minus_air_velocity_3_d_theta, part_of_d_v_dot_d_theta);
    let d_u_dot_d_v = sin_theta_phidot + air_velocity_2_inv_product;
    j[14] = d_u_dot_d_v;
    let d_v_dot_d_u = air_velocity_2_inv_product - sin_theta_phidot;
    j[20] = d_v_dot_d_u;

    // disc_appendix.hyz:102  der(u) = F_b1/m - w*thetadot + v*phidot*sin(theta);
    let u_dot = w.neg_mul_add(thetadot, v.mul_sub(sin_theta_phidot, minus_force_b_1_inv_m));
    dx[3] = u_dot;
    let d_u_dot_d_m = inv_m * g.mul_add(d_u_dot_d_g, minus_force_b_1_inv_m);
    jp[0] = d_u_dot_d_m;
    let part_of_d_u_dot_d_wind_z_3 = d_u_dot_d_g * d_u_dot_d_air_velocity_1;
    let part_of_d_u_dot_d_wind_x = -(cos_theta * d_u_dot_d_air_velocity_1);
    let d_u_dot_d_wind_x = sin_theta.neg_mul_add(minus_inv_air_product_2, part_of_d_u_dot_d_wind_x);
    jp[8] = d_u_dot_d_wind_x;
    let part_of_d_w_dot_d_theta = d_minus_air_velocity_3_d_theta * d_w_dot_d_minus_air_velocity_3;
    let part_of_d_thetadot_dot_d_theta_3 = d_minus_air_velocity_3_d_theta * air_velocity_1_inv_sum;
    let part_of_d_w_dot_d_theta_2 =
        d_air_velocity_1_d_theta.mul_add(d_w_dot_d_air_velocity_1, part_of_d_w_dot_d_theta);
    let d_w_dot_d_theta = sin_theta.mul_add(v_phidot_plus_cos_phi_g_sum, part_of_d_w_dot_d_theta_2);
    j[30] = d_w_dot_d_theta;
    let part_of_d_thetadot_dot_d_theta_4 = d_air_velocity_1_d_theta.mul_add(
        d_thetadot_dot_d_air_velocity_1,
        part_of_d_thetadot_dot_d_theta_3,
    );
    let d_thetadot_dot_d_theta = phidot.mul_add(
        part_of_d_thetadot_dot_d_theta_2,
        part_of_d_thetadot_dot_d_theta_4,
    );
    j[48] = d_thetadot_dot_d_theta;
    let part_of_sin_theta_d_product_sum = cos_theta * air_velocity_1_inv_sum;
    let part_of_d_thetadot_dot_d_wind_x = sin_theta * air_velocity_1_inv_sum;
    let d_thetadot_dot_d_wind_x = cos_theta.neg_mul_add(
        d_thetadot_dot_d_air_velocity_1,
        part_of_d_thetadot_dot_d_wind_x,
    );
    jp[52] = d_thetadot_dot_d_wind_x;
    let sin_theta_d_product_sum = sin_theta.mul_add(
        d_thetadot_dot_d_air_velocity_1,
        part_of_sin_theta_d_product_sum,
    );
    let d_thetadot_dot_d_phi = d_minus_sin_phi_wind_y_sum_d_phi
        .mul_add(sin_theta_d_product_sum, part_of_d_thetadot_dot_d_phi);
    j[47] = d_thetadot_dot_d_phi;
    let part_of_d_u_dot_d_wind_y = cos_phi * minus_inv_air_product_3;
    let part_of_d_u_dot_d_wind_z = sin_phi * minus_inv_air_product_3;
    let part_of_d_u_dot_d_wind_y_2 =
        cos_theta_sin_phi.mul_sub(minus_inv_air_velocity_sum_2, part_of_d_u_dot_d_wind_y);
    let d_u_dot_d_wind_y =
        air_velocity_1_inv_m.mul_sub(part_of_d_u_dot_d_wind_y_2, part_of_d_u_dot_d_wind_y_3);
    jp[9] = d_u_dot_d_wind_y;
    let part_of_d_u_dot_d_wind_z_2 = d_minus_air_velocity_3_d_wind_z
        .mul_add(minus_inv_air_velocity_sum_2, part_of_d_u_dot_d_wind_z);
    let d_u_dot_d_wind_z =
        air_velocity_1_inv_m.neg_mul_add(part_of_d_u_dot_d_wind_z_2, part_of_d_u_dot_d_wind_z_3);
    jp[10] = d_u_dot_d_wind_z;
    let part_of_d_w_dot_d_wind_y_2 = -(cos_theta_sin_phi * d_w_dot_d_minus_air_velocity_3);
    let d_w_dot_d_wind_y = inv_air_velocity_12_product_5
        .neg_mul_add(part_of_d_w_dot_d_wind_y, part_of_d_w_dot_d_wind_y_2);
    jp[31] = d_w_dot_d_wind_y;
    let d_v_dot_d_wind_y =
        sin_phi.mul_sub(minus_sin_theta_product, cos_phi * d_v_dot_d_air_velocity_2);
    jp[20] = d_v_dot_d_wind_y;
    let part_of_d_v_dot_d_wind_z = -(sin_phi * d_v_dot_d_air_velocity_2);
    let d_v_dot_d_wind_z = cos_phi.neg_mul_add(minus_sin_theta_product, part_of_d_v_dot_d_wind_z);
    jp[21] = d_v_dot_d_wind_z;
    let part_of_d_thetadot_dot_d_wind_z = sin_phi * d_thetadot_dot_d_air_velocity_2;
    let d_thetadot_dot_d_wind_z =
        cos_phi.mul_sub(sin_theta_d_product_sum, part_of_d_thetadot_dot_d_wind_z);
    jp[54] = d_thetadot_dot_d_wind_z;

    // disc_appendix.hyz:123  der(y) = u*sin(theta)*sin(phi) + v*cos(phi) - w*cos(theta)*sin(phi);
    let y_dot = w_cos_theta_minus_sin_sum.neg_mul_add(sin_phi, v * cos_phi);
    dx[1] = y_dot;
    j[11] = y_dot; // d_z_dot_d_phi
    let part_of_d_v_dot_d_theta_3 = phidot * d_w_cos_theta_minus_sin_sum_d_theta;
    let d_v_dot_d_theta =
        air_velocity_2_inv_m.neg_mul_add(part_of_d_v_dot_d_theta_2, part_of_d_v_dot_d_theta_3);
    j[24] = d_v_dot_d_theta;
    let part_of_d_w_dot_d_wind_z = d_minus_air_velocity_3_d_wind_z * d_w_dot_d_minus_air_velocity_3;
    let part_of_d_w_dot_d_wind_x = sin_theta * d_w_dot_d_minus_air_velocity_3;
    let part_of_d_thetadot_dot_d_wind_y = -(cos_phi * d_thetadot_dot_d_air_velocity_2);
    let d_gammadot_dot_d_phidot =
        sin_theta.mul_sub(part_of_d_gammadot_dot_d_phidot, cos_theta * thetadot);
    j[57] = d_gammadot_dot_d_phidot;
    let d_w_dot_d_wind_x =
        cos_theta.neg_mul_add(d_w_dot_d_air_velocity_1, part_of_d_w_dot_d_wind_x);
    jp[30] = d_w_dot_d_wind_x;
    let d_w_dot_d_wind_z =
        inv_air_velocity_12_product_5.mul_add(part_of_d_w_dot_d_wind_z_2, part_of_d_w_dot_d_wind_z);
    jp[32] = d_w_dot_d_wind_z;
    let d_thetadot_dot_d_wind_y =
        sin_phi.neg_mul_add(sin_theta_d_product_sum, part_of_d_thetadot_dot_d_wind_y);
    jp[53] = d_thetadot_dot_d_wind_y;
    let inv_m_sq = prepared[21];
    let minus_g_inv_m = prepared[20];
    let d_w_dot_d_m =
        inv_m_sq.neg_mul_add(force_b_3, minus_g_inv_m * d_minus_air_velocity_3_d_wind_z);
    jp[22] = d_w_dot_d_m;
    let d_y_dot_d_theta = -(sin_phi * d_w_cos_theta_minus_sin_sum_d_theta);
    j[7] = d_y_dot_d_theta;
    let d_w_dot_d_phidot = -(cos_theta * v);
    j[31] = d_w_dot_d_phidot;
    let d_u_dot_d_C_D0 = -(air_velocity_12 * air_velocity_1_inv_product_5);
    jp[6] = d_u_dot_d_C_D0;
    let d_u_dot_d_C_Da = -(air_velocity_1_inv_product_5 * alpha_air_velocity_12_alpha);
    jp[7] = d_u_dot_d_C_Da;
    let d_v_dot_d_C_D0 = -(air_velocity_12 * air_velocity_2_inv_product_6);
    jp[17] = d_v_dot_d_C_D0;
    let d_v_dot_d_C_Da = -(air_velocity_2_inv_product_6 * alpha_air_velocity_12_alpha);
    jp[18] = d_v_dot_d_C_Da;

    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
}
