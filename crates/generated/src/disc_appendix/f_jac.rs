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
    let phidot = state[9];
    let cos_theta_phidot = cos_theta * phidot;
    let sin_theta_phidot = sin_theta * phidot;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let g_m = prepared[3];
    let cos_phi_g_m = g_m * cos_phi;
    let wind_z = parameters[17];
    let wind_y = parameters[16];
    let sin_phi_wind_y_sum = wind_z.neg_mul_add(cos_phi, wind_y * sin_phi);
    let minus_wind_y = prepared[6];
    let d_minus_sin_phi_wind_y_sum_d_phi = wind_z.neg_mul_add(sin_phi, minus_wind_y * cos_phi);
    let sin_phi_g_m = g_m * sin_phi;
    let gammadot = state[11];

    // disc_appendix.hyz:64  let angular_velocity = (phidot*cos(theta), thetadot, phidot*sin(th …
    let angular_velocity_3 = sin_theta_phidot + gammadot;
    let inv_m = prepared[0];
    let v = state[4];
    let part_of_d_w_dot_d_theta_3 = inv_m.mul_add(cos_phi_g_m, v * phidot);
    let wind_x = parameters[15];
    let d_minus_air_velocity_3_d_theta = sin_theta.mul_add(sin_phi_wind_y_sum, wind_x * cos_theta);
    let d_air_velocity_1_d_theta = cos_theta.neg_mul_add(sin_phi_wind_y_sum, wind_x * sin_theta);
    let d_y_dot_d_u = sin_theta * sin_phi;
    j[3] = d_y_dot_d_u;
    let d_z_dot_d_w = cos_theta * cos_phi;
    j[10] = d_z_dot_d_w;
    let d_u_dot_d_phidot = sin_theta * v;
    j[18] = d_u_dot_d_phidot;
    let u = state[3];

    // disc_appendix.hyz:122  der(x) = u*cos(theta) + w*sin(theta);
    let x_dot = w.mul_add(sin_theta, u * cos_theta);
    dx[0] = x_dot;
    let d_w_cos_theta_minus_sin_sum_d_theta = -x_dot;
    let d_z_dot_d_theta = cos_phi * d_w_cos_theta_minus_sin_sum_d_theta;
    j[12] = d_z_dot_d_theta;

    // disc_appendix.hyz:67  let air_velocity = velocity - in_B(wind);
    let air_velocity_2 = v + d_minus_sin_phi_wind_y_sum_d_phi;
    let air_velocity_1 = u - d_minus_air_velocity_3_d_theta;
    let minus_air_velocity_3 = d_air_velocity_1_d_theta - w;
    let I_a = parameters[1];
    let angular_velocity_3_I_a = I_a * angular_velocity_3;
    let w_cos_theta_minus_sin_sum = u.neg_mul_add(sin_theta, cos_theta * w);
    j[2] = w_cos_theta_minus_sin_sum; // d_x_dot_d_theta
    j[25] = w_cos_theta_minus_sin_sum; // d_v_dot_d_phidot
    let cos_theta_cos_phi_g_m = cos_theta * cos_phi_g_m;
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let air_velocity_2_cos_product = air_velocity_2 * cos_theta_phidot;
    let thetadot = state[10];
    let air_velocity_1_thetadot = air_velocity_1 * thetadot;
    let air_velocity_1_cos_product = air_velocity_1 * cos_theta_phidot;
    let air_velocity_2_thetadot = air_velocity_2 * thetadot;
    let I_d_two = prepared[5];
    let angular_velocity_3_I_a_sum = I_d_two.neg_mul_add(sin_theta_phidot, angular_velocity_3_I_a);
    let I_d = parameters[2];
    let angular_velocity_3_I_a_sum_2 = I_d.neg_mul_add(sin_theta_phidot, angular_velocity_3_I_a);
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);
    let minus_thetadot_air_sum = air_velocity_2_cos_product - air_velocity_1_thetadot;
    let thetadot_air_velocity_2_sum = air_velocity_1_cos_product + air_velocity_2_thetadot;
    let part_of_air_velocity_1_product_3 = thetadot * angular_velocity_3_I_a_sum;
    let part_of_d_thetadot_dot_d_theta = sin_theta * angular_velocity_3_I_a_sum_2;
    let inv_I_d = prepared[1];
    let inv_cos_theta_inv_I_d = inv_I_d * inv_cos_theta;

    // disc_appendix.hyz:69  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let part_of_d_u_dot_d_phi = air_velocity_2 * sin_phi_wind_y_sum;
    let part_of_air_velocity_2_product_3 = cos_theta_phidot * angular_velocity_3_I_a_sum_2;
    let part_of_d_thetadot_dot_d_phidot = cos_theta * angular_velocity_3_I_a_sum_2;
    let C_Nr = parameters[14];

    // disc_appendix.hyz:88  let spin_down = C_Nr*r;
    let spin_down = C_Nr * angular_velocity_3;
    let air_velocity_2_inv_m = inv_m * air_velocity_2;
    let cos_theta_v = cos_theta * v;
    let d_w_dot_d_phidot = -cos_theta_v;
    j[31] = d_w_dot_d_phidot;

    // disc_appendix.hyz:124  der(z) = -u*sin(theta)*cos(phi) + v*sin(phi) + w*cos(theta)*cos(p …
    let z_dot = w_cos_theta_minus_sin_sum.mul_add(cos_phi, sin_phi * v);
    dx[2] = z_dot;
    let d_y_dot_d_phi = -z_dot;
    j[6] = d_y_dot_d_phi;
    let sin_theta_inv_cos_product = sin_theta * inv_cos_theta_inv_I_d;
    let d_gammadot_dot_d_thetadot =
        angular_velocity_3_I_a_sum.mul_sub(sin_theta_inv_cos_product, cos_theta_phidot);
    j[58] = d_gammadot_dot_d_thetadot;
    let d_phidot_dot_d_thetadot = -(angular_velocity_3_I_a_sum * inv_cos_theta_inv_I_d);
    j[42] = d_phidot_dot_d_thetadot;

    // disc_appendix.hyz:123  der(y) = u*sin(theta)*sin(phi) + v*cos(phi) - w*cos(theta)*sin(phi);
    let y_dot = w_cos_theta_minus_sin_sum.neg_mul_add(sin_phi, v * cos_phi);
    dx[1] = y_dot;
    j[11] = y_dot; // d_z_dot_d_phi
    let d_z_dot_d_u = -(sin_theta * cos_phi);
    j[8] = d_z_dot_d_u;

    // disc_appendix.hyz:74  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let part_of_d_v_dot_d_theta_3 = phidot * d_w_cos_theta_minus_sin_sum_d_theta;
    let d_y_dot_d_theta = -(sin_phi * d_w_cos_theta_minus_sin_sum_d_theta);
    j[7] = d_y_dot_d_theta;
    let d_y_dot_d_w = -(cos_theta * sin_phi);
    j[5] = d_y_dot_d_w;
    let inv_V = V.recip_or_zero();
    let C_Mq = parameters[12];
    let inv_air_velocity_12_C_Mq = C_Mq * inv_air_velocity_12;
    let minus_thetadot_air_product = minus_thetadot_air_sum * inv_air_velocity_12_C_Mq;
    let inv_air_velocity_12_product_3 = inv_air_velocity_12_C_Mq * thetadot_air_velocity_2_sum;
    let C_Rr = parameters[13];
    let thetadot_air_product_sum = C_Rr.mul_add(angular_velocity_3, inv_air_velocity_12_product_3);
    let inv_air_velocity_12_product_6 =
        inv_air_velocity_12_C_Mq * (air_velocity_1_cos_product - air_velocity_2_thetadot);
    let inv_air_velocity_12_product_7 =
        inv_air_velocity_12_C_Mq * (air_velocity_2_cos_product + air_velocity_1_thetadot);
    let half_rho_A = prepared[4];
    let inv_air_velocity_12_product = half_rho_A * inv_air_velocity_12;
    let d = parameters[3];
    let inv_air_velocity_12_product_3_2 = d * (V_sq * inv_air_velocity_12_product);
    let inv_air_velocity_12_product_8 =
        inv_air_velocity_12_C_Mq * (air_velocity_12_sq * inv_air_velocity_12_product_3_2);
    let d_thetadot_dot_d_thetadot = inv_I_d * inv_air_velocity_12_product_8;
    j[50] = d_thetadot_dot_d_thetadot;
    let part_of_air_velocity_1_product_2 = air_velocity_1 * thetadot_air_product_sum;
    let two_d = prepared[10];
    let inv_air_velocity_12_product_5 = two_d * inv_air_velocity_12_product;
    let part_of_air_velocity_1_product = thetadot_air_product_sum + inv_air_velocity_12_product_6;
    let part_of_air_velocity_2_product = thetadot_air_product_sum - inv_air_velocity_12_product_6;
    let part_of_air_velocity_2_product_2 = air_velocity_2 * thetadot_air_product_sum;
    let part_of_air_velocity_1_product_7 =
        part_of_air_velocity_1_product * inv_air_velocity_12_product_3_2;
    let part_of_air_velocity_2_product_7 =
        part_of_air_velocity_2_product * inv_air_velocity_12_product_3_2;
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let part_of_minus_C_Ma_minus_air_sum = inv_air_velocity_12 * minus_thetadot_air_product;
    let C_Ma = parameters[11];
    let minus_minus_thetadot_sum = C_Ma.mul_sub(alpha, minus_thetadot_air_product);
    let air_velocity_1_product_sum =
        air_velocity_2.neg_mul_add(minus_minus_thetadot_sum, part_of_air_velocity_1_product_2);
    let air_velocity_1_product_sum_2 = air_velocity_1_product_sum.mul_sub(
        inv_air_velocity_12_product_3_2,
        part_of_air_velocity_1_product_3,
    );
    let air_velocity_2_product_sum =
        air_velocity_1.mul_add(minus_minus_thetadot_sum, part_of_air_velocity_2_product_2);
    let air_velocity_2_product_sum_2 = air_velocity_2_product_sum.mul_add(
        inv_air_velocity_12_product_3_2,
        part_of_air_velocity_2_product_3,
    );

    // disc_appendix.hyz:115  der(thetadot) = (M_b2 - I_d*phidot^2*cos(theta)*sin(theta) + I_a* …
    let thetadot_dot = inv_I_d * air_velocity_2_product_sum_2;
    dx[10] = thetadot_dot;
    let inv_V_sq = inv_V * inv_V;
    let part_of_air_velocity_1_product_4 =
        inv_air_velocity_12_product_3 * air_velocity_1_inv_product;
    let part_of_minus_inv_air_velocity = air_velocity_12 * inv_air_velocity_12_product_5;
    let minus_air_velocity_product_4 = minus_air_velocity_3 * inv_air_velocity_12_product_5;
    let minus_inv_air_velocity_sum = inv_air_velocity_12.neg_mul_add(
        inv_air_velocity_12_product_3_2,
        part_of_minus_inv_air_velocity,
    );
    let air_velocity_2_inv_product_2 = air_velocity_2 * inv_air_velocity_12_product_3_2;
    let C_Rr_air_velocity_2_sum =
        C_Rr.mul_add(air_velocity_2_inv_product_2, I_a * cos_theta_phidot);
    let d_thetadot_dot_d_gammadot = inv_I_d * C_Rr_air_velocity_2_sum;
    j[51] = d_thetadot_dot_d_gammadot;
    let minus_C_Rr_air_velocity_sum = I_d.mul_sub(cos_theta_phidot, C_Rr_air_velocity_2_sum);
    let part_of_d_thetadot_dot_d_theta_2 =
        cos_theta.mul_add(minus_C_Rr_air_velocity_sum, part_of_d_thetadot_dot_d_theta);
    let part_of_d_thetadot_dot_d_phidot_2 =
        sin_theta.mul_sub(minus_C_Rr_air_velocity_sum, part_of_d_thetadot_dot_d_phidot);
    let minus_inv_I_d = prepared[11];
    j[49] = minus_inv_I_d * part_of_d_thetadot_dot_d_phidot_2; // d_thetadot_dot_d_phidot
    let part_of_d_thetadot_dot_d_theta_3 = phidot * part_of_d_thetadot_dot_d_theta_2;
    let minus_air_velocity_product = minus_air_velocity_3 * inv_V_sq;
    let air_velocity_12_inv_V_sq = air_velocity_12 * inv_V_sq;
    let minus_C_Ma_minus_air_sum =
        C_Ma.neg_mul_add(minus_air_velocity_product, part_of_minus_C_Ma_minus_air_sum);
    let part_of_air_velocity_1_product_5 =
        air_velocity_2.mul_add(minus_C_Ma_minus_air_sum, part_of_air_velocity_1_product_4);
    let part_of_air_velocity_1_product_6 =
        part_of_air_velocity_1_product_5 * inv_air_velocity_12_product_3_2;
    let air_velocity_1_product_sum_3 = air_velocity_1_product_sum
        .mul_sub(minus_inv_air_velocity_sum, part_of_air_velocity_1_product_6);
    let air_velocity_1_product_sum_4 = air_velocity_1_product_sum_3
        .mul_add(air_velocity_1_inv_product, part_of_air_velocity_1_product_7);
    let d_phidot_dot_d_u = air_velocity_1_product_sum_4 * inv_cos_theta_inv_I_d;
    j[36] = d_phidot_dot_d_u;
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;
    let air_velocity_12_inv_V = air_velocity_12 * inv_V;
    let C_Ma_air_velocity_product = C_Ma * air_velocity_12_inv_V_sq;
    let part_of_minus_air_velocity_2_sum = air_velocity_2_inv_product_2 * C_Ma_air_velocity_product;
    let minus_air_velocity_2_sum = air_velocity_1_product_sum.mul_sub(
        minus_air_velocity_product_4,
        part_of_minus_air_velocity_2_sum,
    );
    let d_gammadot_dot_d_w = minus_air_velocity_2_sum * sin_theta_inv_cos_product;
    j[54] = d_gammadot_dot_d_w;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12;
    let part_of_air_velocity_2_product_4 =
        inv_air_velocity_12_product_3 * air_velocity_2_inv_product;
    let part_of_air_velocity_2_product_5 =
        air_velocity_1.mul_sub(minus_C_Ma_minus_air_sum, part_of_air_velocity_2_product_4);
    let part_of_air_velocity_2_product_6 =
        part_of_air_velocity_2_product_5 * inv_air_velocity_12_product_3_2;
    let air_velocity_2_product_sum_3 = air_velocity_2_product_sum
        .mul_add(minus_inv_air_velocity_sum, part_of_air_velocity_2_product_6);
    let air_velocity_2_product_sum_5 = air_velocity_2_product_sum_3
        .mul_add(air_velocity_2_inv_product, part_of_air_velocity_2_product_7);
    let d_thetadot_dot_d_v = inv_I_d * air_velocity_2_product_sum_5;
    j[45] = d_thetadot_dot_d_v;
    let part_of_d_thetadot_dot_d_phi_3 = sin_phi_wind_y_sum * air_velocity_2_product_sum_5;
    let air_velocity_1_inv_product_3 = air_velocity_1 * inv_air_velocity_12_product_3_2;
    let C_Rr_air_velocity_1_sum = C_Rr.mul_sub(air_velocity_1_inv_product_3, I_a * thetadot);
    let part_of_air_velocity_1_inv_sum = air_velocity_1_inv_product_3 * C_Ma_air_velocity_product;
    let air_velocity_1_inv_sum = air_velocity_2_product_sum
        .mul_add(minus_air_velocity_product_4, part_of_air_velocity_1_inv_sum);
    let d_phidot_dot_d_gammadot = C_Rr_air_velocity_1_sum * inv_cos_theta_inv_I_d;
    j[43] = d_phidot_dot_d_gammadot;
    j[46] = minus_inv_I_d * air_velocity_1_inv_sum; // d_thetadot_dot_d_w
    let d_gammadot_dot_d_angular_velocity_3 = prepared[12];
    let d_gammadot_dot_d_gammadot = C_Rr_air_velocity_1_sum.neg_mul_add(
        sin_theta_inv_cos_product,
        d_gammadot_dot_d_angular_velocity_3,
    );
    j[59] = d_gammadot_dot_d_gammadot;
    let C_Rr_air_velocity_1_sum_sum = I_d_two.mul_add(thetadot, C_Rr_air_velocity_1_sum);
    let part_of_d_phidot_dot_d_theta = d_minus_air_velocity_3_d_theta * minus_air_velocity_2_sum;
    let part_of_d_phidot_dot_d_theta_2 = d_air_velocity_1_d_theta
        .mul_add(air_velocity_1_product_sum_4, part_of_d_phidot_dot_d_theta);
    let part_of_d_phidot_dot_d_theta_3 = sin_theta * inv_air_velocity_12_product_8;
    let part_of_d_phidot_dot_d_phidot = cos_theta * inv_air_velocity_12_product_8;
    let part_of_d_phidot_dot_d_theta_4 =
        cos_theta.mul_sub(C_Rr_air_velocity_1_sum_sum, part_of_d_phidot_dot_d_theta_3);
    let part_of_d_phidot_dot_d_theta_5 = phidot.mul_add(
        part_of_d_phidot_dot_d_theta_4,
        part_of_d_phidot_dot_d_theta_2,
    );
    let part_of_d_phidot_dot_d_phidot_2 =
        sin_theta.mul_add(C_Rr_air_velocity_1_sum_sum, part_of_d_phidot_dot_d_phidot);
    let d_phidot_dot_d_phidot = part_of_d_phidot_dot_d_phidot_2 * inv_cos_theta_inv_I_d;
    j[41] = d_phidot_dot_d_phidot;
    let part_of_d_gammadot_dot_d_phidot =
        d_gammadot_dot_d_angular_velocity_3 - d_phidot_dot_d_phidot;
    let d_gammadot_dot_d_phidot =
        sin_theta.mul_sub(part_of_d_gammadot_dot_d_phidot, cos_theta * thetadot);
    j[57] = d_gammadot_dot_d_phidot;
    let part_of_air_velocity_1_product_8 = minus_minus_thetadot_sum - inv_air_velocity_12_product_7;
    let part_of_air_velocity_2_product_8 = minus_minus_thetadot_sum + inv_air_velocity_12_product_7;
    let part_of_air_velocity_1_product_9 =
        part_of_air_velocity_1_product_8 * inv_air_velocity_12_product_3_2;
    let part_of_air_velocity_2_product_9 =
        part_of_air_velocity_2_product_8 * inv_air_velocity_12_product_3_2;
    let air_velocity_1_product_sum_5 = air_velocity_1_product_sum_3
        .mul_sub(air_velocity_2_inv_product, part_of_air_velocity_1_product_9);
    let air_velocity_2_product_sum_4 = air_velocity_2_product_sum_3
        .mul_add(air_velocity_1_inv_product, part_of_air_velocity_2_product_9);
    let part_of_d_thetadot_dot_d_theta_4 = d_air_velocity_1_d_theta.neg_mul_add(
        air_velocity_2_product_sum_4,
        part_of_d_thetadot_dot_d_theta_3,
    );
    let part_of_d_thetadot_dot_d_theta_5 = d_minus_air_velocity_3_d_theta
        .neg_mul_add(air_velocity_1_inv_sum, part_of_d_thetadot_dot_d_theta_4);
    j[48] = minus_inv_I_d * part_of_d_thetadot_dot_d_theta_5; // d_thetadot_dot_d_theta
    let part_of_d_thetadot_dot_d_phi = cos_theta * air_velocity_1_inv_sum;
    let part_of_d_thetadot_dot_d_phi_2 =
        sin_theta.mul_add(air_velocity_2_product_sum_4, part_of_d_thetadot_dot_d_phi);
    let part_of_d_thetadot_dot_d_phi_4 = d_minus_sin_phi_wind_y_sum_d_phi.mul_add(
        part_of_d_thetadot_dot_d_phi_2,
        part_of_d_thetadot_dot_d_phi_3,
    );
    let d_thetadot_dot_d_air_velocity_1 = inv_I_d * air_velocity_2_product_sum_4;
    j[44] = d_thetadot_dot_d_air_velocity_1; // d_thetadot_dot_d_u
    let d_thetadot_dot_d_phi = inv_I_d * part_of_d_thetadot_dot_d_phi_4;
    j[47] = d_thetadot_dot_d_phi;
    let d_phidot_dot_d_v = air_velocity_1_product_sum_5 * inv_cos_theta_inv_I_d;
    j[37] = d_phidot_dot_d_v;
    let C_La = parameters[8];
    let C_L0 = parameters[7];

    // disc_appendix.hyz:77  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La.mul_add(alpha, C_L0);
    let C_Da = parameters[10];
    let C_D0 = parameters[9];

    // disc_appendix.hyz:78  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = alpha.mul_add(C_Da * alpha, C_D0);
    let C_Da_two = prepared[8];
    let alpha_C_Da_two = C_Da_two * alpha;
    let d_air_velocity_12_C_D_sum_d_alpha =
        air_velocity_12.mul_sub(alpha_C_Da_two, C_La * minus_air_velocity_3);
    let air_velocity_12_C_La_sum =
        minus_air_velocity_3.mul_add(alpha_C_Da_two, C_La * air_velocity_12);
    let part_of_d_phidot_dot_d_theta_6 = sin_theta * air_velocity_1_product_sum_2;
    let part_of_d_phidot_dot_d_theta_7 = inv_cos_theta.mul_add(
        part_of_d_phidot_dot_d_theta_6,
        part_of_d_phidot_dot_d_theta_5,
    );

    // disc_appendix.hyz:112  der(phidot) = (M_b1 + 2*I_d*phidot*thetadot*sin(theta) - I_a*thet …
    let der_phidot = air_velocity_1_product_sum_2 * inv_cos_theta_inv_I_d;
    dx[9] = der_phidot;
    let thetadot_cos_theta_sum = sin_theta.mul_add(der_phidot, thetadot * cos_theta_phidot);
    let minus_I_a_thetadot_cos_sum = I_a.neg_mul_add(thetadot_cos_theta_sum, spin_down);
    let inv_I_a = prepared[2];

    // disc_appendix.hyz:119  der(gammadot) = (M_b3 - I_a*(der(phidot)*sin(theta) + phidot*thet …
    let gammadot_dot = inv_I_a * minus_I_a_thetadot_cos_sum;
    dx[11] = gammadot_dot;
    let d_phidot_dot_d_theta = part_of_d_phidot_dot_d_theta_7 * inv_cos_theta_inv_I_d;
    j[40] = d_phidot_dot_d_theta;
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * d_gammadot_dot_d_angular_velocity_3.mul_sub(phidot, der_phidot);
    let part_of_d_gammadot_dot_d_theta_2 = thetadot.neg_mul_add(phidot, d_phidot_dot_d_theta);
    let d_gammadot_dot_d_theta = sin_theta.neg_mul_add(
        part_of_d_gammadot_dot_d_theta_2,
        part_of_d_gammadot_dot_d_theta,
    );
    j[56] = d_gammadot_dot_d_theta;
    let air_velocity_12_C_D_sum = air_velocity_12.mul_sub(C_D, minus_air_velocity_3 * C_L);
    let minus_air_velocity_3_C_sum = minus_air_velocity_3.mul_add(C_D, air_velocity_12 * C_L);

    // disc_appendix.hyz:91  let force_b = (lift*sin(alpha) - drag*cos(alpha))*d1 + (lift*cos(a …
    let force_b_3 = minus_air_velocity_3_C_sum.mul_sub(half_rho_A * V, cos_theta_cos_phi_g_m);

    // disc_appendix.hyz:106  der(w) = F_b3/m + u*thetadot - v*phidot*cos(theta);
    let w_dot = v.neg_mul_add(cos_theta_phidot, inv_m.mul_add(force_b_3, u * thetadot));
    dx[5] = w_dot;
    let part_of_minus_air_velocity_12_C =
        d_air_velocity_12_C_D_sum_d_alpha.neg_mul_add(minus_air_velocity_product, C_D);
    let part_of_inv_air_velocity_12 =
        d_air_velocity_12_C_D_sum_d_alpha.neg_mul_add(air_velocity_12_inv_V_sq, C_L);
    let part_of_d_force_b_3_d_air =
        air_velocity_12_C_La_sum.neg_mul_add(minus_air_velocity_product, C_L);
    let part_of_minus_air_velocity_sum =
        air_velocity_12_C_La_sum.mul_add(air_velocity_12_inv_V_sq, C_D);
    let part_of_minus_air_velocity_12_C_2 =
        inv_air_velocity_12_product * part_of_minus_air_velocity_12_C;
    let air_velocity_12_C_D_product = air_velocity_12_C_D_sum * inv_air_velocity_12_product;
    let part_of_minus_air_velocity_12_C_3 = inv_air_velocity_12.mul_sub(
        air_velocity_12_C_D_product,
        part_of_minus_air_velocity_12_C_2,
    );
    let part_of_inv_air_velocity_12_2 = air_velocity_12_C_D_sum * minus_air_velocity_3_inv_V;
    let part_of_inv_air_velocity_12_3 =
        V.neg_mul_add(part_of_inv_air_velocity_12, part_of_inv_air_velocity_12_2);
    let inv_air_velocity_12_product_4 = inv_air_velocity_12_product * part_of_inv_air_velocity_12_3;
    let part_of_minus_air_velocity_sum_2 = minus_air_velocity_3_C_sum * minus_air_velocity_3_inv_V;
    let minus_air_velocity_sum = V.mul_add(
        part_of_minus_air_velocity_sum,
        part_of_minus_air_velocity_sum_2,
    );
    let part_of_d_force_b_3_d_air_2 = minus_air_velocity_3_C_sum * air_velocity_12_inv_V;
    let part_of_d_force_b_3_d_air_3 =
        V.mul_add(part_of_d_force_b_3_d_air, part_of_d_force_b_3_d_air_2);
    let part_of_minus_air_velocity_12_C_4 = air_velocity_12_C_D_product * air_velocity_12_inv_V;
    let minus_air_velocity_12_C_sum = V.mul_sub(
        part_of_minus_air_velocity_12_C_3,
        part_of_minus_air_velocity_12_C_4,
    );
    let inv_air_velocity_12_product_2 = V * air_velocity_12_C_D_product;
    let d_v_dot_d_w = inv_air_velocity_12_product_4.mul_add(air_velocity_2_inv_m, cos_theta_phidot);
    j[22] = d_v_dot_d_w;
    let part_of_d_w_dot_d_phi_3 = half_rho_A * cos_theta * minus_air_velocity_sum;
    let half_rho_A_inv_m = prepared[9];
    let d_w_dot_d_minus_air_velocity_3 = half_rho_A_inv_m * minus_air_velocity_sum;
    let d_force_b_3_d_air_velocity_12 = half_rho_A * part_of_d_force_b_3_d_air_3;
    let minus_force_b_1 =
        air_velocity_1.mul_sub(inv_air_velocity_12_product_2, sin_theta * cos_phi_g_m);
    let part_of_u_dot = inv_m.neg_mul_add(minus_force_b_1, v * sin_theta_phidot);

    // disc_appendix.hyz:102  der(u) = F_b1/m - w*thetadot + v*phidot*sin(theta);
    let u_dot = w.neg_mul_add(thetadot, part_of_u_dot);
    dx[3] = u_dot;
    let minus_force_b_2 = air_velocity_2.mul_add(inv_air_velocity_12_product_2, sin_phi_g_m);

    // disc_appendix.hyz:104  der(v) = F_b2/m + w*phidot*cos(theta) - u*phidot*sin(theta);
    let v_dot = inv_m.neg_mul_add(minus_force_b_2, w_cos_theta_minus_sin_sum * phidot);
    dx[4] = v_dot;
    let part_of_d_v_dot_d_phi = air_velocity_2 * minus_air_velocity_12_C_sum;
    let minus_air_velocity_product_2 = minus_air_velocity_12_C_sum * air_velocity_1_inv_product;
    let part_of_d_u_dot_d_phi_2 =
        minus_air_velocity_product_2.neg_mul_add(part_of_d_u_dot_d_phi, sin_theta * sin_phi_g_m);
    let d_w_dot_d_w = -d_w_dot_d_minus_air_velocity_3;
    j[28] = d_w_dot_d_w;
    let part_of_d_w_dot_d_theta = d_minus_air_velocity_3_d_theta * d_w_dot_d_minus_air_velocity_3;
    let part_of_d_v_dot_d_phi_2 = air_velocity_2_inv_product
        .neg_mul_add(part_of_d_v_dot_d_phi, inv_air_velocity_12_product_2);
    let inv_air_velocity_12_sum =
        air_velocity_1.neg_mul_add(minus_air_velocity_product_2, inv_air_velocity_12_product_2);
    let air_velocity_1_inv_product_2 = air_velocity_1 * inv_air_velocity_12_product_4;
    let part_of_d_u_dot_d_theta =
        inv_air_velocity_12_sum.neg_mul_add(d_air_velocity_1_d_theta, cos_theta_cos_phi_g_m);
    let minus_inv_m = prepared[7];
    j[21] = minus_inv_m * part_of_d_v_dot_d_phi_2; // d_v_dot_d_v
    let g = parameters[6];
    let part_of_d_v_dot_d_phi_3 =
        sin_phi_wind_y_sum.mul_sub(minus_inv_m * part_of_d_v_dot_d_phi_2, g * cos_phi);
    let part_of_d_u_dot_d_theta_2 = d_minus_air_velocity_3_d_theta
        .neg_mul_add(air_velocity_1_inv_product_2, part_of_d_u_dot_d_theta);
    let d_u_dot_d_theta = inv_m.mul_add(part_of_d_u_dot_d_theta_2, phidot * cos_theta_v);
    j[17] = d_u_dot_d_theta;
    let part_of_d_v_dot_d_theta = inv_air_velocity_12_product_4 * d_minus_air_velocity_3_d_theta;
    let part_of_d_v_dot_d_phi_4 = cos_theta * inv_air_velocity_12_product_4;
    j[13] = minus_inv_m * inv_air_velocity_12_sum; // d_u_dot_d_u
    let d_u_dot_d_w = inv_m.mul_sub(air_velocity_1_inv_product_2, thetadot);
    j[15] = d_u_dot_d_w;
    let part_of_d_u_dot_d_phi_3 = cos_theta * air_velocity_1_inv_product_2;
    let part_of_d_u_dot_d_phi_4 =
        sin_theta.mul_add(inv_air_velocity_12_sum, part_of_d_u_dot_d_phi_3);
    let part_of_d_u_dot_d_phi_5 =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_add(part_of_d_u_dot_d_phi_4, part_of_d_u_dot_d_phi_2);
    j[16] = minus_inv_m * part_of_d_u_dot_d_phi_5; // d_u_dot_d_phi
    let part_of_d_air_velocity_2_d_sum = cos_theta * minus_air_velocity_2_sum;
    let part_of_d_v_dot_d_phi_5 =
        sin_theta.neg_mul_add(minus_air_velocity_product_2, part_of_d_v_dot_d_phi_4);
    let part_of_d_v_dot_d_theta_2 =
        d_air_velocity_1_d_theta.neg_mul_add(minus_air_velocity_product_2, part_of_d_v_dot_d_theta);
    let d_v_dot_d_theta =
        air_velocity_2_inv_m.neg_mul_add(part_of_d_v_dot_d_theta_2, part_of_d_v_dot_d_theta_3);
    j[24] = d_v_dot_d_theta;
    let minus_air_velocity_product_3 = minus_air_velocity_product_2 * air_velocity_2_inv_m;
    let d_phidot_dot_d_w = -(minus_air_velocity_2_sum * inv_cos_theta_inv_I_d);
    j[38] = d_phidot_dot_d_w;
    let part_of_d_air_velocity_2_d_sum_2 =
        sin_theta.mul_add(air_velocity_1_product_sum_4, part_of_d_air_velocity_2_d_sum);
    let d_gammadot_dot_d_u = -(air_velocity_1_product_sum_4 * sin_theta_inv_cos_product);
    j[52] = d_gammadot_dot_d_u;
    let part_of_d_v_dot_d_phi_6 = d_minus_sin_phi_wind_y_sum_d_phi * part_of_d_v_dot_d_phi_5;
    let d_v_dot_d_phi =
        air_velocity_2_inv_m.neg_mul_add(part_of_d_v_dot_d_phi_6, part_of_d_v_dot_d_phi_3);
    j[23] = d_v_dot_d_phi;
    let inv_m_d_force_b_3_d_product = inv_m * d_force_b_3_d_air_velocity_12;
    let part_of_d_w_dot_d_phi = sin_phi_wind_y_sum * d_force_b_3_d_air_velocity_12;
    let part_of_d_w_dot_d_phi_2 =
        air_velocity_2_inv_product.mul_add(part_of_d_w_dot_d_phi, cos_theta * sin_phi_g_m);
    let part_of_d_w_dot_d_phi_4 = sin_theta * d_force_b_3_d_air_velocity_12;
    let part_of_d_air_velocity_2_d_sum_3 = sin_phi_wind_y_sum * air_velocity_1_product_sum_5;
    let d_u_dot_d_v = sin_theta_phidot + minus_air_velocity_product_3;
    j[14] = d_u_dot_d_v;
    let d_w_dot_d_air_velocity_1 = air_velocity_1_inv_product * inv_m_d_force_b_3_d_product;
    let d_w_dot_d_v =
        air_velocity_2_inv_product.mul_sub(inv_m_d_force_b_3_d_product, cos_theta_phidot);
    j[27] = d_w_dot_d_v;
    let d_v_dot_d_u = minus_air_velocity_product_3 - sin_theta_phidot;
    j[20] = d_v_dot_d_u;
    let part_of_d_w_dot_d_phi_5 =
        air_velocity_1_inv_product.mul_add(part_of_d_w_dot_d_phi_4, part_of_d_w_dot_d_phi_3);
    let d_air_velocity_2_d_sum = d_minus_sin_phi_wind_y_sum_d_phi.mul_add(
        part_of_d_air_velocity_2_d_sum_2,
        part_of_d_air_velocity_2_d_sum_3,
    );
    let d_gammadot_dot_d_v = -(air_velocity_1_product_sum_5 * sin_theta_inv_cos_product);
    j[53] = d_gammadot_dot_d_v;
    let part_of_d_w_dot_d_theta_2 =
        d_air_velocity_1_d_theta.mul_add(d_w_dot_d_air_velocity_1, part_of_d_w_dot_d_theta);
    let d_w_dot_d_u = thetadot + d_w_dot_d_air_velocity_1;
    j[26] = d_w_dot_d_u;
    let part_of_d_w_dot_d_phi_6 =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_add(part_of_d_w_dot_d_phi_5, part_of_d_w_dot_d_phi_2);
    let d_phidot_dot_d_phi = d_air_velocity_2_d_sum * inv_cos_theta_inv_I_d;
    j[39] = d_phidot_dot_d_phi;
    let d_w_dot_d_theta = sin_theta.mul_add(part_of_d_w_dot_d_theta_3, part_of_d_w_dot_d_theta_2);
    j[30] = d_w_dot_d_theta;
    let d_w_dot_d_phi = inv_m * part_of_d_w_dot_d_phi_6;
    j[29] = d_w_dot_d_phi;
    let d_gammadot_dot_d_phi = -(d_air_velocity_2_d_sum * sin_theta_inv_cos_product);
    j[55] = d_gammadot_dot_d_phi;

    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
}
