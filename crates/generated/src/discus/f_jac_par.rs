// Written by `hyzer generate`; changes belong in the model.
//! `discus`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 503 operations: 126 add, 330 mul, 4 div, 33 neg, 2 sqrt, 7 call, 1 select.
/// `prepare` takes 24 operations for it.
#[inline(always)]
pub fn f_jac_par<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 29],
    dx: &mut [T; 12],
    j: &mut [T; 60],
    jp: &mut [T; 67],
) {
    let phi = state[6];
    let (sin_phi, cos_phi) = phi.sin_cos();
    j[4] = cos_phi; // d_y_dot_d_v
    j[9] = sin_phi; // d_z_dot_d_v
    let theta = state[7];
    let (sin_theta, cos_theta) = theta.sin_cos();
    j[0] = cos_theta; // d_x_dot_d_u
    j[1] = sin_theta; // d_x_dot_d_w
    let phidot = state[9];
    let thetadot = state[10];
    let phidot_thetadot = phidot * thetadot;
    let w = state[5];
    let d_u_dot_d_thetadot = -w;
    j[19] = d_u_dot_d_thetadot;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let sin_theta_phidot = sin_theta * phidot;
    let wind_z = parameters[17];
    let wind_y = parameters[16];
    let sin_phi_wind_y_sum = wind_z.neg_mul_add(cos_phi, wind_y * sin_phi);
    let minus_wind_y = prepared[7];
    let d_minus_sin_phi_wind_y_sum_d_phi = wind_z.neg_mul_add(sin_phi, minus_wind_y * cos_phi);
    let g = parameters[6];
    let cos_phi_g = g * cos_phi;
    let cos_theta_phidot = cos_theta * phidot;
    let part_of_sin_theta_two_thetadot = T::splat(2.0) * sin_theta * thetadot;
    let sin_phi_g = g * sin_phi;
    let gammadot = state[11];

    // discus.hyz:102  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let u = state[3];
    let minus_sin_theta_u_minus_w_cos_sum_2 = u.neg_mul_add(sin_theta, cos_theta * w);
    j[2] = minus_sin_theta_u_minus_w_cos_sum_2; // d_x_dot_d_theta
    j[25] = minus_sin_theta_u_minus_w_cos_sum_2; // d_v_dot_d_phidot
    let wind_x = parameters[15];
    let d_minus_air_velocity_3_d_theta = sin_theta.mul_add(sin_phi_wind_y_sum, wind_x * cos_theta);
    let v = state[4];

    // discus.hyz:84  let air_velocity = velocity - in_B(air);
    let air_velocity_2 = v + d_minus_sin_phi_wind_y_sum_d_phi;
    let d_air_velocity_1_d_theta = cos_theta.neg_mul_add(sin_phi_wind_y_sum, wind_x * sin_theta);
    let cos_phi_g_plus_v_phidot = v.mul_add(phidot, cos_phi_g);
    let d_y_dot_d_u = sin_theta * sin_phi;
    j[3] = d_y_dot_d_u;
    let d_u_dot_d_phidot = sin_theta * v;
    j[18] = d_u_dot_d_phidot;
    let inv_I_a = prepared[15];
    let d_gammadot_dot_d_C_Nr = inv_I_a * r;
    jp[63] = d_gammadot_dot_d_C_Nr;
    let d_v_dot_d_g = -sin_phi;
    jp[15] = d_v_dot_d_g;
    let air_velocity_1 = u - d_minus_air_velocity_3_d_theta;
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let minus_air_velocity_3 = d_air_velocity_1_d_theta - w;
    let inv_I_d_I_a = prepared[4];
    let r_inv_I_d_I_a = inv_I_d_I_a * r;
    let inv_I_d = prepared[14];
    let inv_I_d_r = inv_I_d * r;
    let d_thetadot_dot_d_I_a = cos_theta_phidot * inv_I_d_r;
    jp[46] = d_thetadot_dot_d_I_a;
    let minus_one_plus_inv_I_d_I_a = prepared[12];
    let cos_theta_phidot_product = minus_one_plus_inv_I_d_I_a * cos_theta_phidot;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);
    let two_inv_I_d_half_rho_A_d = prepared[10];
    let minus_air_velocity_product_4 = two_inv_I_d_half_rho_A_d * minus_air_velocity_3;
    let thetadot_inv_cos_theta = thetadot * inv_cos_theta;
    let sin_theta_phidot_minus_sum = sin_theta_phidot - r_inv_I_d_I_a;

    // discus.hyz:64  position (x, y, z) in N;
    let x_dot = w.mul_add(sin_theta, u * cos_theta);
    dx[0] = x_dot;
    let d_y_dot_d_theta = x_dot * sin_phi;
    j[7] = d_y_dot_d_theta;

    // discus.hyz:86  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let d_inv_I_d = prepared[18];
    let V_sq_d_inv_I_d = d_inv_I_d * V_sq;
    let half_rho_A_inv_I_d = prepared[24];
    let V_sq_half_rho_A_inv_I_d = half_rho_A_inv_I_d * V_sq;
    let thetadot_sin_theta_product = thetadot * sin_theta_inv_cos_theta;
    let inv_I_d_I_a_product_2 = inv_I_d_I_a * thetadot_inv_cos_theta;
    let d_phidot_dot_d_I_a = -(inv_I_d_r * thetadot_inv_cos_theta);
    jp[36] = d_phidot_dot_d_I_a;
    let d_phidot_dot_d_gammadot = -inv_I_d_I_a_product_2;
    j[43] = d_phidot_dot_d_gammadot;
    let part_of_d_minus_thetadot_r_2 = inv_I_d_r * inv_I_d_I_a_product_2;
    let half_rho_A = prepared[17];
    let V_sq_half_rho_A_d_inv_part = half_rho_A * V_sq_d_inv_I_d;
    let inv_I_d_I_a_product = inv_I_d_I_a * thetadot_sin_theta_product;
    let inv_I_a_d_gammadot_dot_d_r = prepared[26];
    let part_of_d_gammadot_dot_d_I_a =
        inv_I_d.mul_sub(thetadot_sin_theta_product, inv_I_a_d_gammadot_dot_d_r);
    let d_gammadot_dot_d_I_a = r * part_of_d_gammadot_dot_d_I_a;
    jp[56] = d_gammadot_dot_d_I_a;
    let C_Nr_inv_I_a = prepared[6];
    let d_gammadot_dot_d_gammadot = inv_I_d_I_a_product + C_Nr_inv_I_a;
    j[59] = d_gammadot_dot_d_gammadot;
    let cos_theta_sin_phi = cos_theta * sin_phi;
    let d_y_dot_d_w = -cos_theta_sin_phi;
    j[5] = d_y_dot_d_w;
    let C_Ms = parameters[12];
    let V_sq_half_rho_A_d_product = C_Ms * V_sq_half_rho_A_d_inv_part;
    let d_w_dot_d_theta = sin_theta * cos_phi_g_plus_v_phidot;
    let cos_theta_cos_phi_g_product = cos_theta * cos_phi_g_plus_v_phidot;
    let part_of_v_dot = minus_sin_theta_u_minus_w_cos_sum_2 * phidot;
    let part_of_thetadot_dot = cos_theta_phidot * sin_theta_phidot_minus_sum;
    let part_of_gammadot_dot = C_Nr_inv_I_a.mul_sub(r, thetadot * cos_theta_phidot);
    let d_minus_air_velocity_3_d_wind_z = cos_theta * cos_phi;
    j[10] = d_minus_air_velocity_3_d_wind_z; // d_z_dot_d_w
    let d_w_dot_d_g = -d_minus_air_velocity_3_d_wind_z;
    jp[27] = d_w_dot_d_g;
    let sin_theta_air_velocity_1 = sin_theta * air_velocity_1;
    let part_of_d_w_dot_d_phi = air_velocity_2 * sin_phi_wind_y_sum;
    let part_of_d_w_dot_d_phi_2 =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_add(sin_theta_air_velocity_1, part_of_d_w_dot_d_phi);

    // discus.hyz:91  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let alpha_two = T::splat(2.0) * alpha;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let air_velocity_12_two_product = two_inv_I_d_half_rho_A_d * air_velocity_12;
    let part_of_d_thetadot_dot_d_theta = cos_theta * cos_theta_phidot_product;
    let part_of_d_thetadot_dot_d_phidot = sin_theta * cos_theta_phidot_product;
    let d_thetadot_dot_d_phidot =
        cos_theta.neg_mul_add(sin_theta_phidot_minus_sum, part_of_d_thetadot_dot_d_phidot);
    j[49] = d_thetadot_dot_d_phidot;
    let part_of_d_thetadot_dot_d_theta_2 =
        sin_theta.mul_add(sin_theta_phidot_minus_sum, part_of_d_thetadot_dot_d_theta);
    let inv_V = V.recip_or_zero();
    let inv_m = prepared[13];
    let V_inv_m = inv_m * V;
    let part_of_minus_C_D_air_velocity_4 = air_velocity_12_sq * inv_V * inv_V;
    let (sin_alpha_two, cos_alpha_two) = alpha_two.sin_cos();
    let nonzero_air_product = nonzero_air_velocity_12 * V_sq_half_rho_A_d_inv_part;
    let C_Mq = parameters[13];
    let C_Mq_nonzero_air_velocity_12 = C_Mq * nonzero_air_velocity_12;
    let d_minus_thetadot_r_product_d_C_Mq = phidot * nonzero_air_product;
    jp[42] = d_minus_thetadot_r_product_d_C_Mq; // d_phidot_dot_d_C_Mq
    let d_thetadot_dot_d_C_Mq = thetadot * nonzero_air_product;
    jp[52] = d_thetadot_dot_d_C_Mq;
    let V_inv_m_half_rho_A = half_rho_A * V_inv_m;
    let d_thetadot_dot_d_gammadot = inv_I_d_I_a * cos_theta_phidot;
    j[51] = d_thetadot_dot_d_gammadot;
    let part_of_d_thetadot_dot_d_I_d = inv_I_d_r * d_thetadot_dot_d_gammadot;
    let part_of_d_w_dot_d_wind_y =
        sin_phi.mul_add(sin_theta_air_velocity_1, cos_phi * air_velocity_2);
    let V_sq_half_rho_A_d_product_2 = C_Mq * nonzero_air_product;
    j[50] = V_sq_half_rho_A_d_product_2; // d_thetadot_dot_d_thetadot
    let d_gammadot_dot_d_C_Mq = -(sin_theta_phidot * nonzero_air_product);
    jp[62] = d_gammadot_dot_d_C_Mq;
    let sin_theta_two_thetadot_sum =
        cos_theta.mul_add(V_sq_half_rho_A_d_product_2, part_of_sin_theta_two_thetadot);
    let d_minus_thetadot_r_product_d_phidot =
        sin_theta_two_thetadot_sum.mul_sub(inv_cos_theta, inv_I_d_I_a_product);
    j[41] = d_minus_thetadot_r_product_d_phidot; // d_phidot_dot_d_phidot
    let part_of_minus_thetadot_r_inv_I = phidot * sin_theta_two_thetadot_sum;
    let part_of_thetadot_dot_2 =
        thetadot.mul_sub(V_sq_half_rho_A_d_product_2, part_of_thetadot_dot);
    let part_of_d_gammadot_dot_d_phidot = C_Nr_inv_I_a - d_minus_thetadot_r_product_d_phidot;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12;
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let part_of_minus_C_Ms_inv_cos_sum = phidot * C_Mq_nonzero_air_velocity_12;
    let part_of_C_Ms_sin_alpha_two_sum = thetadot * C_Mq_nonzero_air_velocity_12;
    let air_velocity_12_V_product = air_velocity_12 * V_inv_m_half_rho_A;
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;
    let inv_V_two = T::splat(2.0) * inv_V;
    let air_velocity_12_inv_V = air_velocity_12 * inv_V;
    let inv_m_half_rho_A = prepared[2];
    let inv_V_inv_m_half_rho_A = inv_m_half_rho_A * inv_V;
    let d_w_dot_d_C_D = minus_air_velocity_3 * V_inv_m_half_rho_A;
    jp[31] = d_w_dot_d_C_D; // d_w_dot_d_C_D0
    let part_of_d_w_dot_d_wind_z =
        cos_phi.mul_sub(sin_theta_air_velocity_1, sin_phi * air_velocity_2);
    let inv_s_stall = prepared[0];
    let inv_s_stall_minus_product = inv_s_stall * minus_air_velocity_3_inv_V;
    let minus_air_velocity_product = minus_air_velocity_3_inv_V * minus_air_velocity_3_inv_V;
    let d_w_dot_d_C_Ds = d_w_dot_d_C_D * minus_air_velocity_product;
    jp[32] = d_w_dot_d_C_Ds;
    let minus_air_velocity_product_2 = minus_air_velocity_3_inv_V * inv_V_two;
    let inv_V_two_air_product = inv_V_two * air_velocity_12_inv_V;
    let z_dot = cos_phi.mul_add(minus_sin_theta_u_minus_w_cos_sum_2, v * sin_phi);
    dx[2] = z_dot;
    let d_y_dot_d_phi = -z_dot;
    j[6] = d_y_dot_d_phi;
    let inv_s_stall_minus_product_sq = inv_s_stall_minus_product * inv_s_stall_minus_product;
    let inv_s_stall_minus_product_2 = inv_s_stall_minus_product_sq * inv_s_stall_minus_product_sq;
    let minus_C_Lp_plus_C_Ls_n8 = prepared[19];
    let part_of_inv_s_stall_minus =
        minus_C_Lp_plus_C_Ls_n8 * (inv_s_stall_minus_product * inv_s_stall_minus_product_sq);
    let C_Ds = parameters[11];
    let C_D0 = parameters[10];

    // discus.hyz:97  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = C_Ds.mul_add(minus_air_velocity_product, C_D0);
    let one_minus_minus_air_sum = T::splat(1.0) - minus_air_velocity_product;
    let C_Ds_minus_air_product = C_Ds * minus_air_velocity_product_2;
    let air_velocity_1_inv_product_5 = air_velocity_1_inv_product * air_velocity_12_V_product;
    let d_u_dot_d_C_D0 = -air_velocity_1_inv_product_5;
    jp[7] = d_u_dot_d_C_D0;
    let d_u_dot_d_C_Ds = -(minus_air_velocity_product * air_velocity_1_inv_product_5);
    jp[8] = d_u_dot_d_C_Ds;
    let inv_s_stall_minus_sum =
        inv_s_stall_minus_product_2.mul_add(inv_s_stall_minus_product_2, T::splat(1.0));
    let inv_inv_s_stall_minus_sum = T::splat(1.0) / inv_s_stall_minus_sum;
    let d_w_dot_d_minus_air_velocity_3 = V_inv_m_half_rho_A * C_D;
    let d_C_D_d_minus_air_velocity_3 = one_minus_minus_air_sum * C_Ds_minus_air_product;
    let air_velocity_2_inv_product_5 = air_velocity_2_inv_product * air_velocity_12_V_product;
    let d_v_dot_d_C_D0 = -air_velocity_2_inv_product_5;
    jp[19] = d_v_dot_d_C_D0;
    let d_v_dot_d_C_Ds = -(minus_air_velocity_product * air_velocity_2_inv_product_5);
    jp[20] = d_v_dot_d_C_Ds;
    let V_sq_half_rho_A_d_product_3 = sin_alpha_two * V_sq_half_rho_A_d_product;

    // discus.hyz:57  frame B = A turned theta about 2; // does not spin with the discus
    let thetadot_dot =
        air_velocity_1_inv_product.mul_add(V_sq_half_rho_A_d_product_3, part_of_thetadot_dot_2);
    dx[10] = thetadot_dot;
    let cos_alpha_two_V_sq_product = cos_alpha_two * V_sq_half_rho_A_d_product;
    let part_of_minus_thetadot_r_inv_I_2 = air_velocity_2_inv_product
        .neg_mul_add(V_sq_half_rho_A_d_product_3, part_of_minus_thetadot_r_inv_I);
    let minus_thetadot_r_inv_I_sum =
        thetadot.neg_mul_add(r_inv_I_d_I_a, part_of_minus_thetadot_r_inv_I_2);
    let minus_r_inv_I_d_I_a_sum = sin_theta_phidot.mul_sub(T::splat(2.0), r_inv_I_d_I_a);
    let minus_thetadot_r_product = minus_thetadot_r_inv_I_sum * inv_cos_theta;
    dx[9] = minus_thetadot_r_product;

    // discus.hyz:58  frame C = B turned gamma about 3; // fixed in the discus
    let gammadot_dot = sin_theta.neg_mul_add(minus_thetadot_r_product, part_of_gammadot_dot);
    dx[11] = gammadot_dot;
    let part_of_d_minus_thetadot_r =
        phidot.neg_mul_add(V_sq_half_rho_A_d_product_2, minus_thetadot_r_product);
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * C_Nr_inv_I_a.neg_mul_add(phidot, minus_thetadot_r_product);
    let d_phidot_dot_d_thetadot = inv_cos_theta * minus_r_inv_I_d_I_a_sum;
    j[42] = d_phidot_dot_d_thetadot;
    let sin_alpha_two_air_product = sin_alpha_two * air_velocity_2_inv_product;
    let minus_C_Ms_inv_cos_sum =
        sin_alpha_two_air_product.neg_mul_add(C_Ms * inv_cos_theta, part_of_minus_C_Ms_inv_cos_sum);
    let inv_air_velocity_12_product_2 = inv_air_velocity_12 * V_sq_half_rho_A_d_product_3;
    let air_velocity_2_inv_product_3 = air_velocity_2_inv_product * cos_alpha_two_V_sq_product;
    let air_velocity_1_inv_product_3 = air_velocity_1_inv_product * cos_alpha_two_V_sq_product;
    let sin_alpha_two_air_product_2 = sin_alpha_two * air_velocity_1_inv_product;
    let C_Ms_sin_alpha_two_sum =
        C_Ms.mul_add(sin_alpha_two_air_product_2, part_of_C_Ms_sin_alpha_two_sum);
    let d_thetadot_dot_d_d = C_Ms_sin_alpha_two_sum * V_sq_half_rho_A_inv_I_d;
    jp[48] = d_thetadot_dot_d_d;
    let d_minus_thetadot_r_product_d_d = minus_C_Ms_inv_cos_sum * V_sq_half_rho_A_inv_I_d;
    jp[38] = d_minus_thetadot_r_product_d_d; // d_phidot_dot_d_d
    let d_gammadot_dot_d_d = -(sin_theta * d_minus_thetadot_r_product_d_d);
    jp[58] = d_gammadot_dot_d_d;
    let d_thetadot_dot_d_C_Ms = V_sq_half_rho_A_d_inv_part * sin_alpha_two_air_product_2;
    jp[51] = d_thetadot_dot_d_C_Ms;
    let V_sq_half_rho_A_d_product_4 = V_sq_half_rho_A_d_inv_part * sin_alpha_two_air_product;
    let d_w_dot_d_C_D_sin_product = d_w_dot_d_C_D * sin_alpha_two_air_product_2;
    let d_w_dot_d_C_D_sin_product_2 = d_w_dot_d_C_D * sin_alpha_two_air_product;
    let d_u_dot_d_C_Ls = inv_inv_s_stall_minus_sum * d_w_dot_d_C_D_sin_product;
    jp[4] = d_u_dot_d_C_Ls;
    let d_v_dot_d_C_Ls = inv_inv_s_stall_minus_sum * d_w_dot_d_C_D_sin_product_2;
    jp[16] = d_v_dot_d_C_Ls;
    let d_gammadot_dot_d_C_Ms = sin_theta_inv_cos_theta * V_sq_half_rho_A_d_product_4;
    jp[61] = d_gammadot_dot_d_C_Ms;
    let d_phidot_dot_d_C_Ms = -(inv_cos_theta * V_sq_half_rho_A_d_product_4);
    jp[41] = d_phidot_dot_d_C_Ms;
    let inv_s_stall_inv_inv_product = inv_s_stall * inv_inv_s_stall_minus_sum;
    let inv_s_stall_minus_product_3 =
        inv_s_stall_minus_product_2 * inv_s_stall_inv_inv_product * part_of_inv_s_stall_minus;
    let inv_s_stall_minus_product_5 =
        inv_s_stall_minus_product_3 * (minus_air_velocity_3_inv_V * inv_s_stall_inv_inv_product);
    jp[6] = d_w_dot_d_C_D_sin_product * inv_s_stall_minus_product_5; // d_u_dot_d_s_stall
    jp[18] = d_w_dot_d_C_D_sin_product_2 * inv_s_stall_minus_product_5; // d_v_dot_d_s_stall
    let minus_C_Lp_plus_C_Ls = prepared[1];
    let C_Lp = parameters[8];
    let C_Lp_plus_minus_C_Lp_sum = minus_C_Lp_plus_C_Ls.mul_add(inv_inv_s_stall_minus_sum, C_Lp);
    let C_Lp_plus_minus_C_product = C_Lp_plus_minus_C_Lp_sum * cos_alpha_two;
    let sin_alpha_two_C_Lp_product = C_Lp_plus_minus_C_Lp_sum * sin_alpha_two;
    let part_of_inv_V_air_velocity = air_velocity_12 * inv_V_two * C_Lp_plus_minus_C_product;
    let part_of_minus_C_D_air_velocity = T::splat(2.0) * C_Lp_plus_minus_C_product;
    let C_D_air_velocity_12_sum =
        minus_air_velocity_3.neg_mul_add(sin_alpha_two_C_Lp_product, air_velocity_12 * C_D);
    let minus_air_velocity_3_C_sum =
        air_velocity_12.mul_add(sin_alpha_two_C_Lp_product, minus_air_velocity_3 * C_D);
    let d_w_dot_d_air_velocity_12 = V_inv_m_half_rho_A * sin_alpha_two_C_Lp_product;
    let inv_inv_s_stall_product = inv_inv_s_stall_minus_sum * sin_alpha_two;
    let one_minus_inv_inv_s_sum = T::splat(1.0) - inv_inv_s_stall_minus_sum;
    jp[5] = one_minus_inv_inv_s_sum * d_w_dot_d_C_D_sin_product; // d_u_dot_d_C_Lp
    jp[17] = one_minus_inv_inv_s_sum * d_w_dot_d_C_D_sin_product_2; // d_v_dot_d_C_Lp
    let sin_alpha_two_air_product_3 = sin_alpha_two * air_velocity_12_V_product;
    jp[29] = one_minus_inv_inv_s_sum * sin_alpha_two_air_product_3; // d_w_dot_d_C_Lp
    jp[30] = inv_s_stall_minus_product_5 * sin_alpha_two_air_product_3; // d_w_dot_d_s_stall
    let inv_s_stall_minus_product_4 = inv_s_stall_minus_product_3 * inv_inv_s_stall_product;
    let d_w_dot_d_C_Ls = air_velocity_12_V_product * inv_inv_s_stall_product;
    jp[28] = d_w_dot_d_C_Ls;
    let part_of_inv_V_air_velocity_2 = one_minus_minus_air_sum
        .neg_mul_add(inv_s_stall_minus_product_4, part_of_inv_V_air_velocity);
    let part_of_minus_C_D_air_velocity_2 =
        air_velocity_12_inv_V.mul_sub(inv_s_stall_minus_product_4, part_of_minus_C_D_air_velocity);
    let part_of_minus_C_D_air_velocity_3 =
        inv_V * minus_air_velocity_3_inv_V * part_of_minus_C_D_air_velocity_2;
    let inv_V_air_velocity_product = inv_V * part_of_inv_V_air_velocity_2;
    let part_of_minus_C_D_air_velocity_5 = C_Ds_minus_air_product.mul_add(
        part_of_minus_C_D_air_velocity_4,
        part_of_minus_C_D_air_velocity_3,
    );
    let part_of_d_w_dot_d_air_velocity = minus_air_velocity_product
        .neg_mul_add(C_Ds_minus_air_product, part_of_minus_C_D_air_velocity_3);
    let part_of_minus_C_Ms_inv_cos_sum_2 =
        air_velocity_2_inv_product * inv_air_velocity_12_product_2;
    let part_of_minus_C_Ms_inv_cos_sum_2_2 = minus_air_velocity_product_2.mul_add(
        air_velocity_2_inv_product_3,
        part_of_minus_C_Ms_inv_cos_sum_2,
    );
    let part_of_minus_inv_cos_theta_air_2 = inv_cos_theta * air_velocity_2_inv_product_3;
    let part_of_minus_C_D_air_velocity_6 = inv_m_half_rho_A * C_D_air_velocity_12_sum;
    let part_of_minus_C_D_air_velocity_7 = air_velocity_12_inv_V.mul_add(
        part_of_minus_C_D_air_velocity_6,
        d_w_dot_d_minus_air_velocity_3,
    );
    let part_of_minus_C_D_air_velocity_8 = d_w_dot_d_C_D.neg_mul_add(
        part_of_minus_C_D_air_velocity_5,
        part_of_minus_C_D_air_velocity_7,
    );
    let part_of_d_w_dot_d_minus_air = inv_V_air_velocity_product
        .mul_add(air_velocity_12_V_product, d_w_dot_d_minus_air_velocity_3);
    let part_of_minus_d_C_D_d_minus_air = d_C_D_d_minus_air_velocity_3
        .neg_mul_add(air_velocity_12_V_product, d_w_dot_d_air_velocity_12);
    let part_of_minus_d_C_D_d_minus_air_2 = C_D_air_velocity_12_sum * inv_V_inv_m_half_rho_A;
    let part_of_minus_d_C_D_d_minus_air_3 = V_inv_m_half_rho_A.mul_sub(
        inv_V_air_velocity_product,
        part_of_minus_d_C_D_d_minus_air_2,
    );
    let minus_d_C_D_d_minus_air_sum = minus_air_velocity_3.mul_add(
        part_of_minus_d_C_D_d_minus_air_3,
        part_of_minus_d_C_D_d_minus_air,
    );
    let minus_air_velocity_product_3 = minus_air_velocity_3_C_sum * inv_V_inv_m_half_rho_A;
    let part_of_d_w_dot_d_air_velocity_2 =
        V_inv_m_half_rho_A.mul_add(part_of_d_w_dot_d_air_velocity, minus_air_velocity_product_3);
    let d_w_dot_d_air_velocity_12_2 =
        air_velocity_12.mul_add(part_of_d_w_dot_d_air_velocity_2, d_w_dot_d_air_velocity_12);
    let part_of_d_w_dot_d_minus_air_2 =
        V_inv_m_half_rho_A.mul_add(d_C_D_d_minus_air_velocity_3, minus_air_velocity_product_3);
    let d_w_dot_d_minus_air_velocity_3_2 =
        minus_air_velocity_3.mul_add(part_of_d_w_dot_d_minus_air_2, part_of_d_w_dot_d_minus_air);
    let part_of_d_w_dot_d_wind_z_2 =
        d_minus_air_velocity_3_d_wind_z * d_w_dot_d_minus_air_velocity_3_2;
    let part_of_d_w_dot_d_wind_y_2 = -(cos_theta_sin_phi * d_w_dot_d_minus_air_velocity_3_2);
    let d_w_dot_d_v =
        air_velocity_2_inv_product.mul_sub(d_w_dot_d_air_velocity_12_2, cos_theta_phidot);
    j[27] = d_w_dot_d_v;
    let d_w_dot_d_w = -d_w_dot_d_minus_air_velocity_3_2;
    j[28] = d_w_dot_d_w;
    let part_of_minus_C_Ms_inv_cos_sum_2_3 = minus_C_Ms_inv_cos_sum * air_velocity_12_two_product;
    let minus_C_Ms_inv_cos_sum_2 = inv_cos_theta.mul_add(
        part_of_minus_C_Ms_inv_cos_sum_2_2,
        part_of_minus_C_Ms_inv_cos_sum_2_3,
    );
    let part_of_d_thetadot_dot_d_air = C_Ms_sin_alpha_two_sum * air_velocity_12_two_product;
    let part_of_d_thetadot_dot_d_air_2 = air_velocity_1_inv_product
        .neg_mul_add(inv_air_velocity_12_product_2, part_of_d_thetadot_dot_d_air);
    let d_thetadot_dot_d_air_velocity_12 = minus_air_velocity_product_2
        .neg_mul_add(air_velocity_1_inv_product_3, part_of_d_thetadot_dot_d_air_2);
    let part_of_d_phidot_dot_d_v = V_sq_half_rho_A_d_product_3 * inv_cos_theta;
    let part_of_d_phidot_dot_d_v_2 =
        air_velocity_2.mul_sub(minus_C_Ms_inv_cos_sum_2, part_of_d_phidot_dot_d_v);
    let part_of_d_thetadot_dot_d_air_3 = air_velocity_1.mul_add(
        d_thetadot_dot_d_air_velocity_12,
        V_sq_half_rho_A_d_product_3,
    );
    let d_minus_thetadot_r_product_d_u = air_velocity_1_inv_product * minus_C_Ms_inv_cos_sum_2;
    j[36] = d_minus_thetadot_r_product_d_u; // d_phidot_dot_d_u
    let part_of_air_velocity_1_inv_sum = air_velocity_1_inv_product_3 * inv_V_two_air_product;
    let d_phidot_dot_d_v = inv_air_velocity_12 * part_of_d_phidot_dot_d_v_2;
    j[37] = d_phidot_dot_d_v;
    let air_velocity_1_inv_sum = C_Ms_sin_alpha_two_sum
        .mul_add(minus_air_velocity_product_4, part_of_air_velocity_1_inv_sum);
    let part_of_minus_inv_cos_theta_air = minus_C_Ms_inv_cos_sum * minus_air_velocity_product_4;
    let minus_inv_cos_theta_air_sum = inv_V_two_air_product.neg_mul_add(
        part_of_minus_inv_cos_theta_air_2,
        part_of_minus_inv_cos_theta_air,
    );
    let d_thetadot_dot_d_air_velocity_2 =
        air_velocity_2_inv_product * d_thetadot_dot_d_air_velocity_12;
    j[45] = d_thetadot_dot_d_air_velocity_2; // d_thetadot_dot_d_v
    let minus_C_Ms_inv_cos_product = minus_C_Ms_inv_cos_sum * V_sq_d_inv_I_d;
    let C_Ms_sin_alpha_two_product = C_Ms_sin_alpha_two_sum * V_sq_d_inv_I_d;
    let minus_half_rho_A_inv_I_d = prepared[25];
    let d_thetadot_dot_d_I_d =
        minus_half_rho_A_inv_I_d.mul_sub(C_Ms_sin_alpha_two_product, part_of_d_thetadot_dot_d_I_d);
    jp[47] = d_thetadot_dot_d_I_d;
    let d_thetadot_dot_d_air_velocity_1 = inv_air_velocity_12 * part_of_d_thetadot_dot_d_air_3;
    j[44] = d_thetadot_dot_d_air_velocity_1; // d_thetadot_dot_d_u
    let d_thetadot_dot_d_w = -air_velocity_1_inv_sum;
    j[46] = d_thetadot_dot_d_w;
    let d_phidot_dot_d_w = -minus_inv_cos_theta_air_sum;
    j[38] = d_phidot_dot_d_w;
    let d_minus_thetadot_r_product_d_I_d =
        half_rho_A_inv_I_d.neg_mul_add(minus_C_Ms_inv_cos_product, part_of_d_minus_thetadot_r_2);
    jp[37] = d_minus_thetadot_r_product_d_I_d; // d_phidot_dot_d_I_d
    let rho_half = prepared[20];
    jp[39] = rho_half * minus_C_Ms_inv_cos_product; // d_phidot_dot_d_A
    let A_half = prepared[16];
    jp[40] = A_half * minus_C_Ms_inv_cos_product; // d_phidot_dot_d_rho
    let sin_theta_minus_C_product = sin_theta * minus_C_Ms_inv_cos_product;
    jp[49] = rho_half * C_Ms_sin_alpha_two_product; // d_thetadot_dot_d_A
    jp[50] = A_half * C_Ms_sin_alpha_two_product; // d_thetadot_dot_d_rho
    let d_gammadot_dot_d_I_d = -(sin_theta * d_minus_thetadot_r_product_d_I_d);
    jp[57] = d_gammadot_dot_d_I_d;
    let minus_rho_half = prepared[21];
    jp[59] = minus_rho_half * sin_theta_minus_C_product; // d_gammadot_dot_d_A
    let minus_A_half = prepared[22];
    jp[60] = minus_A_half * sin_theta_minus_C_product; // d_gammadot_dot_d_rho
    let C_D_air_velocity_12_product = V_inv_m_half_rho_A * C_D_air_velocity_12_sum;
    let C_D_air_velocity_12_product_3 = C_D_air_velocity_12_sum * V_inv_m;
    let part_of_w_dot =
        V_inv_m_half_rho_A.mul_sub(minus_air_velocity_3_C_sum, cos_theta_cos_phi_g_product);
    let minus_air_velocity_product_5 = minus_air_velocity_3_C_sum * V_inv_m;

    // discus.hyz:65  velocity (u, v, w) in B;
    let w_dot = u.mul_add(thetadot, part_of_w_dot);
    dx[5] = w_dot;
    let part_of_v_dot_2 =
        C_D_air_velocity_12_product.neg_mul_add(air_velocity_2_inv_product, part_of_v_dot);
    let v_dot = part_of_v_dot_2 - sin_phi_g;
    dx[4] = v_dot;
    let minus_half_rho_A_inv_m = prepared[23];
    jp[24] = minus_half_rho_A_inv_m * minus_air_velocity_product_5; // d_w_dot_d_m
    jp[25] = rho_half * minus_air_velocity_product_5; // d_w_dot_d_A
    jp[26] = A_half * minus_air_velocity_product_5; // d_w_dot_d_rho
    let C_D_air_velocity_12_product_2 = C_D_air_velocity_12_product * inv_air_velocity_12;
    let part_of_u_dot =
        C_D_air_velocity_12_product.neg_mul_add(air_velocity_1_inv_product, d_w_dot_d_theta);
    let u_dot = w.neg_mul_add(thetadot, part_of_u_dot);
    dx[3] = u_dot;
    let inv_air_velocity_12_product = inv_air_velocity_12 * d_w_dot_d_air_velocity_12_2;
    let d_w_dot_d_wind_y = inv_air_velocity_12_product
        .neg_mul_add(part_of_d_w_dot_d_wind_y, part_of_d_w_dot_d_wind_y_2);
    jp[34] = d_w_dot_d_wind_y;
    let d_w_dot_d_wind_z =
        inv_air_velocity_12_product.mul_add(part_of_d_w_dot_d_wind_z, part_of_d_w_dot_d_wind_z_2);
    jp[35] = d_w_dot_d_wind_z;
    let d_w_dot_d_air_velocity_1 = air_velocity_1_inv_product * d_w_dot_d_air_velocity_12_2;
    let minus_C_D_air_velocity_sum =
        C_D_air_velocity_12_product_2 - part_of_minus_C_D_air_velocity_8;
    let part_of_d_u_dot_d_v =
        air_velocity_1_inv_product * air_velocity_2_inv_product * minus_C_D_air_velocity_sum;
    let part_of_d_w_dot_d_theta_2 =
        d_air_velocity_1_d_theta.mul_add(d_w_dot_d_air_velocity_1, d_w_dot_d_theta);
    let d_w_dot_d_theta_2 = d_minus_air_velocity_3_d_theta
        .mul_add(d_w_dot_d_minus_air_velocity_3_2, part_of_d_w_dot_d_theta_2);
    j[30] = d_w_dot_d_theta_2; // d_w_dot_d_theta
    let d_u_dot_d_v = sin_theta_phidot + part_of_d_u_dot_d_v;
    j[14] = d_u_dot_d_v;
    let d_v_dot_d_u = part_of_d_u_dot_d_v - sin_theta_phidot;
    j[20] = d_v_dot_d_u;
    let d_w_dot_d_u = thetadot + d_w_dot_d_air_velocity_1;
    j[26] = d_w_dot_d_u;
    let part_of_d_minus_thetadot_r_3 = d_minus_air_velocity_3_d_theta * minus_inv_cos_theta_air_sum;
    let part_of_d_minus_thetadot_r_4 = d_air_velocity_1_d_theta
        .mul_add(d_minus_thetadot_r_product_d_u, part_of_d_minus_thetadot_r_3);
    let part_of_d_minus_thetadot_r_5 =
        sin_theta_inv_cos_theta.mul_add(part_of_d_minus_thetadot_r, part_of_d_minus_thetadot_r_4);
    let two_minus_inv_I_d_I_a = prepared[11];
    let d_minus_thetadot_r_product_d_theta =
        two_minus_inv_I_d_I_a.mul_add(phidot_thetadot, part_of_d_minus_thetadot_r_5);
    j[40] = d_minus_thetadot_r_product_d_theta; // d_phidot_dot_d_theta
    let part_of_d_gammadot_dot_d_theta_2 = phidot_thetadot - d_minus_thetadot_r_product_d_theta;
    let d_gammadot_dot_d_theta = sin_theta.mul_sub(
        part_of_d_gammadot_dot_d_theta_2,
        part_of_d_gammadot_dot_d_theta,
    );
    j[56] = d_gammadot_dot_d_theta;
    let air_velocity_1_inv_product_2 = air_velocity_1_inv_product * minus_d_C_D_d_minus_air_sum;
    let d_u_dot_d_w = -thetadot - air_velocity_1_inv_product_2;
    j[15] = d_u_dot_d_w;
    let air_velocity_2_inv_product_2 = air_velocity_2_inv_product * minus_d_C_D_d_minus_air_sum;
    let d_v_dot_d_w = cos_theta_phidot - air_velocity_2_inv_product_2;
    j[22] = d_v_dot_d_w;
    let d_gammadot_dot_d_thetadot =
        minus_r_inv_I_d_I_a_sum.neg_mul_add(sin_theta_inv_cos_theta, -cos_theta_phidot);
    j[58] = d_gammadot_dot_d_thetadot;
    let sin_theta_d_minus_product = sin_theta * d_minus_thetadot_r_product_d_u;
    let d_gammadot_dot_d_u = -sin_theta_d_minus_product;
    j[52] = d_gammadot_dot_d_u;
    let sin_theta_d_minus_sum =
        cos_theta.mul_add(minus_inv_cos_theta_air_sum, sin_theta_d_minus_product);
    let d_gammadot_dot_d_w = sin_theta * minus_inv_cos_theta_air_sum;
    j[54] = d_gammadot_dot_d_w;
    let d_minus_thetadot_r_product_d_wind_x =
        cos_theta.neg_mul_add(d_minus_thetadot_r_product_d_u, d_gammadot_dot_d_w);
    jp[43] = d_minus_thetadot_r_product_d_wind_x; // d_phidot_dot_d_wind_x
    let d_gammadot_dot_d_wind_x = -(sin_theta * d_minus_thetadot_r_product_d_wind_x);
    jp[64] = d_gammadot_dot_d_wind_x;
    let part_of_d_u_dot_d_air_velocity_1 = air_velocity_1_inv_product * minus_C_D_air_velocity_sum;
    let part_of_minus_d_v_dot_d_air = air_velocity_2_inv_product * minus_C_D_air_velocity_sum;
    let d_u_dot_d_air_velocity_1 = air_velocity_1_inv_product.mul_sub(
        part_of_d_u_dot_d_air_velocity_1,
        C_D_air_velocity_12_product_2,
    );
    j[13] = d_u_dot_d_air_velocity_1; // d_u_dot_d_u
    let minus_d_v_dot_d_air_velocity_2 = air_velocity_2_inv_product
        .neg_mul_add(part_of_minus_d_v_dot_d_air, C_D_air_velocity_12_product_2);
    let air_velocity_1_inv_product_4 = air_velocity_1_inv_product * C_D_air_velocity_12_product_3;
    let air_velocity_2_inv_product_4 = air_velocity_2_inv_product * C_D_air_velocity_12_product_3;
    let part_of_d_u_dot_d_theta =
        d_u_dot_d_air_velocity_1.mul_add(d_air_velocity_1_d_theta, cos_theta_cos_phi_g_product);
    let d_u_dot_d_theta = air_velocity_1_inv_product_2
        .mul_add(d_minus_air_velocity_3_d_theta, part_of_d_u_dot_d_theta);
    j[17] = d_u_dot_d_theta;
    let d_u_dot_d_m = inv_m_half_rho_A * air_velocity_1_inv_product_4;
    jp[0] = d_u_dot_d_m;
    jp[1] = minus_rho_half * air_velocity_1_inv_product_4; // d_u_dot_d_A
    jp[2] = minus_A_half * air_velocity_1_inv_product_4; // d_u_dot_d_rho
    let d_v_dot_d_v = -minus_d_v_dot_d_air_velocity_2;
    j[21] = d_v_dot_d_v;
    let d_v_dot_d_m = inv_m_half_rho_A * air_velocity_2_inv_product_4;
    jp[12] = d_v_dot_d_m;
    jp[13] = minus_rho_half * air_velocity_2_inv_product_4; // d_v_dot_d_A
    jp[14] = minus_A_half * air_velocity_2_inv_product_4; // d_v_dot_d_rho
    let cos_theta_air_product = cos_theta * air_velocity_1_inv_product_2;
    let part_of_d_u_dot_d_wind_x = sin_theta * air_velocity_1_inv_product_2;
    let d_u_dot_d_wind_x =
        cos_theta.neg_mul_add(d_u_dot_d_air_velocity_1, part_of_d_u_dot_d_wind_x);
    jp[9] = d_u_dot_d_wind_x;
    let part_of_sin_theta_d_u_dot_d_sum = cos_theta * air_velocity_2_inv_product_2;
    let sin_theta_d_u_dot_d_sum =
        sin_theta.mul_add(part_of_d_u_dot_d_v, part_of_sin_theta_d_u_dot_d_sum);
    let part_of_d_v_dot_d_phi =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_sub(sin_theta_d_u_dot_d_sum, cos_phi_g);
    let d_v_dot_d_phi =
        sin_phi_wind_y_sum.neg_mul_add(minus_d_v_dot_d_air_velocity_2, part_of_d_v_dot_d_phi);
    j[23] = d_v_dot_d_phi;
    let part_of_d_minus_thetadot_r_6 = sin_phi_wind_y_sum * d_phidot_dot_d_v;
    let d_minus_thetadot_r_product_d_phi = d_minus_sin_phi_wind_y_sum_d_phi
        .mul_add(sin_theta_d_minus_sum, part_of_d_minus_thetadot_r_6);
    j[39] = d_minus_thetadot_r_product_d_phi; // d_phidot_dot_d_phi
    let d_gammadot_dot_d_phi = -(sin_theta * d_minus_thetadot_r_product_d_phi);
    j[55] = d_gammadot_dot_d_phi;
    let d_minus_thetadot_r_product_d_wind_z =
        cos_phi.mul_sub(sin_theta_d_minus_sum, sin_phi * d_phidot_dot_d_v);
    jp[45] = d_minus_thetadot_r_product_d_wind_z; // d_phidot_dot_d_wind_z
    let d_gammadot_dot_d_wind_z = -(sin_theta * d_minus_thetadot_r_product_d_wind_z);
    jp[66] = d_gammadot_dot_d_wind_z;
    let part_of_d_u_dot_d_phi_2 = d_minus_sin_phi_wind_y_sum_d_phi * cos_theta_air_product;
    let sin_theta_d_u_dot_d_sum_2 =
        sin_theta.mul_add(d_u_dot_d_air_velocity_1, cos_theta_air_product);
    let part_of_d_u_dot_d_phi =
        d_u_dot_d_air_velocity_1.neg_mul_add(d_minus_sin_phi_wind_y_sum_d_phi, sin_phi_g);
    let part_of_d_w_dot_d_phi_3 =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_add(d_w_dot_d_minus_air_velocity_3_2, sin_phi_g);
    let part_of_d_w_dot_d_wind_x = sin_theta * d_w_dot_d_minus_air_velocity_3_2;
    let d_w_dot_d_wind_x =
        cos_theta.neg_mul_add(d_w_dot_d_air_velocity_1, part_of_d_w_dot_d_wind_x);
    jp[33] = d_w_dot_d_wind_x;
    let part_of_d_u_dot_d_phi_3 =
        sin_phi_wind_y_sum.mul_add(part_of_d_u_dot_d_v, part_of_d_u_dot_d_phi_2);
    let d_u_dot_d_phi = sin_theta.neg_mul_add(part_of_d_u_dot_d_phi, part_of_d_u_dot_d_phi_3);
    j[16] = d_u_dot_d_phi;
    let part_of_d_thetadot_dot_d_phi = sin_phi_wind_y_sum * d_thetadot_dot_d_air_velocity_2;
    let part_of_d_w_dot_d_phi_4 = cos_theta * part_of_d_w_dot_d_phi_3;
    let d_w_dot_d_phi =
        inv_air_velocity_12_product.mul_add(part_of_d_w_dot_d_phi_2, part_of_d_w_dot_d_phi_4);
    j[29] = d_w_dot_d_phi;
    let part_of_d_v_dot_d_theta = d_minus_air_velocity_3_d_theta * air_velocity_2_inv_product_2;
    let part_of_d_thetadot_dot_d_theta_3 = d_minus_air_velocity_3_d_theta * air_velocity_1_inv_sum;
    let part_of_d_v_dot_d_wind_x = sin_theta * air_velocity_2_inv_product_2;
    let d_v_dot_d_wind_x = cos_theta.neg_mul_add(part_of_d_u_dot_d_v, part_of_d_v_dot_d_wind_x);
    jp[21] = d_v_dot_d_wind_x;
    let part_of_d_v_dot_d_theta_2 =
        d_air_velocity_1_d_theta.mul_add(part_of_d_u_dot_d_v, part_of_d_v_dot_d_theta);
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
    let d_v_dot_d_theta = x_dot.neg_mul_add(phidot, part_of_d_v_dot_d_theta_2);
    j[24] = d_v_dot_d_theta;
    let minus_d_minus_thetadot_r_product_d_wind_y =
        sin_phi.mul_add(sin_theta_d_minus_sum, cos_phi * d_phidot_dot_d_v);
    let d_u_dot_d_wind_z =
        cos_phi.mul_sub(sin_theta_d_u_dot_d_sum_2, sin_phi * part_of_d_u_dot_d_v);
    jp[11] = d_u_dot_d_wind_z;
    let sin_theta_d_product_sum = sin_theta.mul_add(
        d_thetadot_dot_d_air_velocity_1,
        part_of_sin_theta_d_product_sum,
    );
    let d_thetadot_dot_d_phi = d_minus_sin_phi_wind_y_sum_d_phi
        .mul_add(sin_theta_d_product_sum, part_of_d_thetadot_dot_d_phi);
    j[47] = d_thetadot_dot_d_phi;
    let part_of_d_thetadot_dot_d_wind_x = sin_theta * air_velocity_1_inv_sum;
    let part_of_d_thetadot_dot_d_wind_z = sin_phi * d_thetadot_dot_d_air_velocity_2;
    let y_dot = sin_phi.neg_mul_add(minus_sin_theta_u_minus_w_cos_sum_2, v * cos_phi);
    dx[1] = y_dot;
    j[11] = y_dot; // d_z_dot_d_phi
    let part_of_d_v_dot_d_wind_y = cos_phi * minus_d_v_dot_d_air_velocity_2;
    let part_of_d_v_dot_d_wind_z = sin_phi * minus_d_v_dot_d_air_velocity_2;
    let part_of_d_thetadot_dot_d_wind_y = -(cos_phi * d_thetadot_dot_d_air_velocity_2);
    let d_air_velocity_1_d_wind_z = sin_theta * cos_phi;
    jp[3] = d_air_velocity_1_d_wind_z; // d_u_dot_d_g
    let d_gammadot_dot_d_phidot =
        sin_theta.mul_sub(part_of_d_gammadot_dot_d_phidot, cos_theta * thetadot);
    j[57] = d_gammadot_dot_d_phidot;
    let d_thetadot_dot_d_wind_x = cos_theta.neg_mul_add(
        d_thetadot_dot_d_air_velocity_1,
        part_of_d_thetadot_dot_d_wind_x,
    );
    jp[53] = d_thetadot_dot_d_wind_x;
    let d_u_dot_d_wind_y =
        sin_phi.neg_mul_add(sin_theta_d_u_dot_d_sum_2, -(cos_phi * part_of_d_u_dot_d_v));
    jp[10] = d_u_dot_d_wind_y;
    let d_v_dot_d_wind_y = sin_phi.neg_mul_add(sin_theta_d_u_dot_d_sum, part_of_d_v_dot_d_wind_y);
    jp[22] = d_v_dot_d_wind_y;
    let d_v_dot_d_wind_z = cos_phi.mul_add(sin_theta_d_u_dot_d_sum, part_of_d_v_dot_d_wind_z);
    jp[23] = d_v_dot_d_wind_z;
    let d_thetadot_dot_d_wind_y =
        sin_phi.neg_mul_add(sin_theta_d_product_sum, part_of_d_thetadot_dot_d_wind_y);
    jp[54] = d_thetadot_dot_d_wind_y;
    let d_thetadot_dot_d_wind_z =
        cos_phi.mul_sub(sin_theta_d_product_sum, part_of_d_thetadot_dot_d_wind_z);
    jp[55] = d_thetadot_dot_d_wind_z;
    jp[65] = sin_theta * minus_d_minus_thetadot_r_product_d_wind_y; // d_gammadot_dot_d_wind_y
    let d_z_dot_d_u = -d_air_velocity_1_d_wind_z;
    j[8] = d_z_dot_d_u;
    let d_z_dot_d_theta = -(x_dot * cos_phi);
    j[12] = d_z_dot_d_theta;
    let d_w_dot_d_phidot = -(cos_theta * v);
    j[31] = d_w_dot_d_phidot;
    let d_gammadot_dot_d_v = -(sin_theta * d_phidot_dot_d_v);
    j[53] = d_gammadot_dot_d_v;
    let d_phidot_dot_d_wind_y = -minus_d_minus_thetadot_r_product_d_wind_y;
    jp[44] = d_phidot_dot_d_wind_y;

    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
}
