// Written by `hyzer generate`; changes belong in the model.
//! `discus`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 350 operations: 104 add, 218 mul, 4 div, 14 neg, 2 sqrt, 7 call, 1 select.
/// `prepare` takes 20 operations for it.
#[inline(always)]
pub fn f_jac<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 29],
    dx: &mut [T; 12],
    j: &mut [T; 60],
) {
    let phi = state[6];
    let (sin_phi, cos_phi) = phi.sin_cos();
    j[4] = cos_phi; // d_y_dot_d_v
    j[9] = sin_phi; // d_z_dot_d_v
    let theta = state[7];
    let (sin_theta, cos_theta) = theta.sin_cos();
    j[0] = cos_theta; // d_x_dot_d_u
    j[1] = sin_theta; // d_x_dot_d_w
    let inv_I_d_I_a = prepared[4];
    let thetadot = state[10];
    let thetadot_inv_I_d_I_a = inv_I_d_I_a * thetadot;
    let phidot = state[9];
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
    let part_of_sin_theta_two_thetadot = T::splat(2.0) * sin_theta * thetadot;
    let cos_theta_phidot = cos_theta * phidot;
    let gammadot = state[11];

    // discus.hyz:102  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let u = state[3];

    // discus.hyz:64  position (x, y, z) in N;
    let x_dot = w.mul_add(sin_theta, u * cos_theta);
    dx[0] = x_dot;
    let wind_x = parameters[15];
    let d_minus_air_velocity_3_d_theta = sin_theta.mul_add(sin_phi_wind_y_sum, wind_x * cos_theta);
    let v = state[4];

    // discus.hyz:84  let air_velocity = velocity - in_B(air);
    let air_velocity_2 = v + d_minus_sin_phi_wind_y_sum_d_phi;
    let d_air_velocity_1_d_theta = cos_theta.neg_mul_add(sin_phi_wind_y_sum, wind_x * sin_theta);
    let minus_sin_theta_u_minus_w_cos_sum_2 = u.neg_mul_add(sin_theta, cos_theta * w);
    j[2] = minus_sin_theta_u_minus_w_cos_sum_2; // d_x_dot_d_theta
    j[25] = minus_sin_theta_u_minus_w_cos_sum_2; // d_v_dot_d_phidot
    let cos_phi_g_plus_v_phidot = v.mul_add(phidot, cos_phi_g);
    let d_y_dot_d_u = sin_theta * sin_phi;
    j[3] = d_y_dot_d_u;
    let d_y_dot_d_theta = x_dot * sin_phi;
    j[7] = d_y_dot_d_theta;
    let d_z_dot_d_w = cos_theta * cos_phi;
    j[10] = d_z_dot_d_w;
    let d_u_dot_d_phidot = sin_theta * v;
    j[18] = d_u_dot_d_phidot;
    let d_thetadot_dot_d_r = inv_I_d_I_a * cos_theta_phidot;
    j[51] = d_thetadot_dot_d_r; // d_thetadot_dot_d_gammadot
    let air_velocity_1 = u - d_minus_air_velocity_3_d_theta;
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let minus_air_velocity_3 = d_air_velocity_1_d_theta - w;
    let r_inv_I_d_I_a = inv_I_d_I_a * r;
    let part_of_d_w_dot_d_phi = air_velocity_2 * sin_phi_wind_y_sum;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let minus_one_plus_inv_I_d_I_a = prepared[12];
    let cos_theta_phidot_product = minus_one_plus_inv_I_d_I_a * cos_theta_phidot;
    let part_of_d_w_dot_d_phi_2 =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_add(sin_theta * air_velocity_1, part_of_d_w_dot_d_phi);
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);
    let two_inv_I_d_half_rho_A_d = prepared[10];
    let minus_air_velocity_product_3 = two_inv_I_d_half_rho_A_d * minus_air_velocity_3;
    let sin_theta_phidot_minus_sum = sin_theta_phidot - r_inv_I_d_I_a;
    let sin_theta_inv_cos_product = sin_theta_inv_cos_theta * thetadot_inv_I_d_I_a;
    let d_phidot_dot_d_gammadot = -(inv_cos_theta * thetadot_inv_I_d_I_a);
    j[43] = d_phidot_dot_d_gammadot;
    let C_Nr_inv_I_a = prepared[6];
    let d_gammadot_dot_d_gammadot = sin_theta_inv_cos_product + C_Nr_inv_I_a;
    j[59] = d_gammadot_dot_d_gammadot;

    // discus.hyz:86  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let half_rho_A_d_inv_I_d = prepared[5];
    let V_sq_half_rho_A_d_inv_part = half_rho_A_d_inv_I_d * V_sq;
    let sin_theta_cos_phi_g_product = sin_theta * cos_phi_g_plus_v_phidot;
    let cos_theta_cos_phi_g_product = cos_theta * cos_phi_g_plus_v_phidot;
    let part_of_v_dot = minus_sin_theta_u_minus_w_cos_sum_2 * phidot;
    let sin_phi_g = g * sin_phi;
    let part_of_thetadot_dot = cos_theta_phidot * sin_theta_phidot_minus_sum;
    let part_of_gammadot_dot = C_Nr_inv_I_a.mul_sub(r, thetadot * cos_theta_phidot);
    let C_Ms = parameters[12];
    let V_sq_half_rho_A_d_product = C_Ms * V_sq_half_rho_A_d_inv_part;
    let d_z_dot_d_theta = -(x_dot * cos_phi);
    j[12] = d_z_dot_d_theta;
    let part_of_d_thetadot_dot_d_theta = cos_theta * cos_theta_phidot_product;
    let part_of_d_thetadot_dot_d_phidot = sin_theta * cos_theta_phidot_product;
    let d_thetadot_dot_d_phidot =
        cos_theta.neg_mul_add(sin_theta_phidot_minus_sum, part_of_d_thetadot_dot_d_phidot);
    j[49] = d_thetadot_dot_d_phidot;
    let part_of_d_thetadot_dot_d_theta_2 =
        sin_theta.mul_add(sin_theta_phidot_minus_sum, part_of_d_thetadot_dot_d_theta);
    let z_dot = cos_phi.mul_add(minus_sin_theta_u_minus_w_cos_sum_2, v * sin_phi);
    dx[2] = z_dot;
    let d_y_dot_d_phi = -z_dot;
    j[6] = d_y_dot_d_phi;
    let y_dot = sin_phi.neg_mul_add(minus_sin_theta_u_minus_w_cos_sum_2, v * cos_phi);
    dx[1] = y_dot;
    j[11] = y_dot; // d_z_dot_d_phi
    let d_y_dot_d_w = -(cos_theta * sin_phi);
    j[5] = d_y_dot_d_w;
    let d_z_dot_d_u = -(sin_theta * cos_phi);
    j[8] = d_z_dot_d_u;
    let minus_r_inv_I_d_I_a_sum = sin_theta_phidot.mul_sub(T::splat(2.0), r_inv_I_d_I_a);
    let d_phidot_dot_d_thetadot = inv_cos_theta * minus_r_inv_I_d_I_a_sum;
    j[42] = d_phidot_dot_d_thetadot;

    // discus.hyz:91  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let alpha_two = T::splat(2.0) * alpha;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let C_Mq = parameters[13];
    let C_Mq_nonzero_air_velocity_12 = C_Mq * nonzero_air_velocity_12;
    let V_sq_half_rho_A_d_product_2 = V_sq_half_rho_A_d_inv_part * C_Mq_nonzero_air_velocity_12;
    j[50] = V_sq_half_rho_A_d_product_2; // d_thetadot_dot_d_thetadot
    let sin_theta_two_thetadot_sum =
        cos_theta.mul_add(V_sq_half_rho_A_d_product_2, part_of_sin_theta_two_thetadot);
    let d_minus_thetadot_r_product_d_phidot =
        sin_theta_two_thetadot_sum.mul_sub(inv_cos_theta, sin_theta_inv_cos_product);
    j[41] = d_minus_thetadot_r_product_d_phidot; // d_phidot_dot_d_phidot
    let part_of_minus_thetadot_r_inv_I = phidot * sin_theta_two_thetadot_sum;
    let part_of_thetadot_dot_2 =
        thetadot.mul_sub(V_sq_half_rho_A_d_product_2, part_of_thetadot_dot);
    let part_of_d_gammadot_dot_d_phidot = C_Nr_inv_I_a - d_minus_thetadot_r_product_d_phidot;
    let inv_V = V.recip_or_zero();
    let inv_m_half_rho_A = prepared[2];
    let V_inv_m_half_rho_A = inv_m_half_rho_A * V;
    let (sin_alpha_two, cos_alpha_two) = alpha_two.sin_cos();
    let two_cos_alpha_two = T::splat(2.0) * cos_alpha_two;
    let air_velocity_12_two_product = two_inv_I_d_half_rho_A_d * air_velocity_12;
    let d_gammadot_dot_d_phidot =
        sin_theta.mul_sub(part_of_d_gammadot_dot_d_phidot, cos_theta * thetadot);
    j[57] = d_gammadot_dot_d_phidot;
    let d_w_dot_d_phidot = -(cos_theta * v);
    j[31] = d_w_dot_d_phidot;
    let d_gammadot_dot_d_thetadot =
        minus_r_inv_I_d_I_a_sum.neg_mul_add(sin_theta_inv_cos_theta, -cos_theta_phidot);
    j[58] = d_gammadot_dot_d_thetadot;
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;
    let inv_s_stall = prepared[0];
    let inv_s_stall_minus_product = inv_s_stall * minus_air_velocity_3_inv_V;
    let inv_s_stall_minus_product_sq = inv_s_stall_minus_product * inv_s_stall_minus_product;
    let inv_s_stall_minus_product_2 = inv_s_stall_minus_product_sq * inv_s_stall_minus_product_sq;
    let n8_inv_s_stall_product = prepared[9];
    let part_of_n8_inv_s_stall_product_2 =
        n8_inv_s_stall_product * (inv_s_stall_minus_product * inv_s_stall_minus_product_sq);
    let inv_s_stall_minus_sum =
        inv_s_stall_minus_product_2.mul_add(inv_s_stall_minus_product_2, T::splat(1.0));
    let inv_inv_s_stall_minus_sum = T::splat(1.0) / inv_s_stall_minus_sum;
    let part_of_n8_inv_s_stall_product_2_2 =
        inv_s_stall_minus_product_2 * inv_inv_s_stall_minus_sum;
    let minus_air_velocity_product = minus_air_velocity_3_inv_V * minus_air_velocity_3_inv_V;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12;
    let two_C_Ds = prepared[8];
    let minus_air_velocity_product_2 = two_C_Ds * minus_air_velocity_3_inv_V;
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let V_inv_m_half_rho_A_product = V_inv_m_half_rho_A * minus_air_velocity_3_inv_V;
    let part_of_n8_inv_s_stall_product_2_3 =
        part_of_n8_inv_s_stall_product_2_2 * (inv_inv_s_stall_minus_sum * sin_alpha_two);
    let n8_inv_s_stall_product_2 =
        part_of_n8_inv_s_stall_product_2 * part_of_n8_inv_s_stall_product_2_3;
    let minus_C_Lp_plus_C_Ls = prepared[1];
    let C_Lp = parameters[8];
    let C_Lp_plus_minus_C_Lp_sum = minus_C_Lp_plus_C_Ls.mul_add(inv_inv_s_stall_minus_sum, C_Lp);
    let C_Ds = parameters[11];
    let C_D0 = parameters[10];

    // discus.hyz:97  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = C_Ds.mul_add(minus_air_velocity_product, C_D0);
    let part_of_inv_V_air_velocity = air_velocity_12 * minus_air_velocity_product_2;
    let part_of_inv_V_minus_air = minus_air_velocity_3 * minus_air_velocity_product_2;
    let part_of_inv_V_air_velocity_2 =
        minus_air_velocity_3.mul_add(n8_inv_s_stall_product_2, part_of_inv_V_air_velocity);
    let part_of_inv_V_minus_air_2 =
        air_velocity_12.neg_mul_add(n8_inv_s_stall_product_2, part_of_inv_V_minus_air);
    let inv_V_air_velocity_product = inv_V * part_of_inv_V_air_velocity_2;
    let inv_V_minus_air_velocity_sum = inv_V * part_of_inv_V_minus_air_2;
    let air_velocity_2_inv_product_3 = air_velocity_2_inv_product * inv_cos_theta;
    let inv_V_two_cos_alpha_two = inv_V * two_cos_alpha_two;
    let part_of_minus_d_C_D_air_sum =
        minus_air_velocity_product.mul_add(C_Lp_plus_minus_C_Lp_sum * two_cos_alpha_two, C_D);
    let air_velocity_12_inv_V = air_velocity_12 * inv_V;
    let part_of_minus_d_C_D_air_sum_2 = V_inv_m_half_rho_A * part_of_minus_d_C_D_air_sum;
    let part_of_d_w_dot_d_minus_air = C_D + inv_V_minus_air_velocity_sum;
    let inv_V_two_cos_alpha_product = inv_V_two_cos_alpha_two * V_sq_half_rho_A_d_product;
    let C_Lp_plus_minus_C_product = C_Lp_plus_minus_C_Lp_sum * inv_V_two_cos_alpha_two;
    let part_of_d_w_dot_d_minus_air_2 =
        C_Lp_plus_minus_C_product.mul_add(air_velocity_12_sq * inv_V, part_of_d_w_dot_d_minus_air);
    let air_velocity_12_V_product =
        air_velocity_12 * V_inv_m_half_rho_A_product * C_Lp_plus_minus_C_product;
    let sin_alpha_two_C_Lp_product = C_Lp_plus_minus_C_Lp_sum * sin_alpha_two;
    let C_D_air_velocity_12_sum =
        minus_air_velocity_3.neg_mul_add(sin_alpha_two_C_Lp_product, air_velocity_12 * C_D);
    let minus_air_velocity_3_C_sum =
        air_velocity_12.mul_add(sin_alpha_two_C_Lp_product, minus_air_velocity_3 * C_D);
    let V_sq_half_rho_A_d_product_3 = sin_alpha_two * V_sq_half_rho_A_d_product;

    // discus.hyz:57  frame B = A turned theta about 2; // does not spin with the discus
    let thetadot_dot =
        air_velocity_1_inv_product.mul_add(V_sq_half_rho_A_d_product_3, part_of_thetadot_dot_2);
    dx[10] = thetadot_dot;
    let sin_alpha_two_C_Ms = C_Ms * sin_alpha_two;
    let part_of_minus_thetadot_r_inv_I_2 = air_velocity_2_inv_product
        .neg_mul_add(V_sq_half_rho_A_d_product_3, part_of_minus_thetadot_r_inv_I);
    let minus_thetadot_r_inv_I_sum =
        thetadot.neg_mul_add(r_inv_I_d_I_a, part_of_minus_thetadot_r_inv_I_2);
    let minus_thetadot_r_product = minus_thetadot_r_inv_I_sum * inv_cos_theta;
    dx[9] = minus_thetadot_r_product;

    // discus.hyz:58  frame C = B turned gamma about 3; // fixed in the discus
    let gammadot_dot = sin_theta.neg_mul_add(minus_thetadot_r_product, part_of_gammadot_dot);
    dx[11] = gammadot_dot;
    let part_of_d_minus_thetadot_r =
        phidot.neg_mul_add(V_sq_half_rho_A_d_product_2, minus_thetadot_r_product);
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * C_Nr_inv_I_a.neg_mul_add(phidot, minus_thetadot_r_product);
    let sin_alpha_two_C_Ms_product = sin_alpha_two_C_Ms * air_velocity_2_inv_product_3;
    let air_velocity_1_inv_product_4 = air_velocity_1_inv_product * sin_alpha_two_C_Ms;
    let d_thetadot_dot_d_air_velocity_1 = inv_air_velocity_12 * V_sq_half_rho_A_d_product_3;
    let d_thetadot_dot_d_air_sum = minus_air_velocity_3_inv_V
        .mul_add(inv_V_two_cos_alpha_product, d_thetadot_dot_d_air_velocity_1);
    let air_velocity_12_inv_product = air_velocity_12_inv_V * inv_V_two_cos_alpha_product;
    let part_of_d_C_D_air_velocity_12 = inv_m_half_rho_A * C_D_air_velocity_12_sum;
    let C_D_air_velocity_12_product = V_inv_m_half_rho_A * C_D_air_velocity_12_sum;
    let d_C_D_air_velocity_12_product_d_V = inv_V_air_velocity_product
        .neg_mul_add(V_inv_m_half_rho_A_product, part_of_d_C_D_air_velocity_12);
    let part_of_minus_air_velocity_sum_2 = sin_alpha_two_C_Lp_product - inv_V_air_velocity_product;
    let part_of_minus_d_C_D_air_sum_3 = d_C_D_air_velocity_12_product_d_V
        .mul_add(air_velocity_12_inv_V, part_of_minus_d_C_D_air_sum_2);
    let part_of_minus_air_velocity_sum =
        minus_air_velocity_3_inv_V * d_C_D_air_velocity_12_product_d_V;
    let part_of_minus_air_velocity_sum_3 = V_inv_m_half_rho_A.neg_mul_add(
        part_of_minus_air_velocity_sum_2,
        part_of_minus_air_velocity_sum,
    );
    let minus_air_velocity_sum = part_of_minus_air_velocity_sum_3 - air_velocity_12_V_product;
    let part_of_v_dot_2 =
        C_D_air_velocity_12_product.neg_mul_add(air_velocity_2_inv_product, part_of_v_dot);

    // discus.hyz:65  velocity (u, v, w) in B;
    let v_dot = part_of_v_dot_2 - sin_phi_g;
    dx[4] = v_dot;
    let part_of_minus_air_velocity_2_sum =
        phidot.mul_sub(C_Mq_nonzero_air_velocity_12, sin_alpha_two_C_Ms_product);
    let part_of_air_velocity_1_inv_sum =
        thetadot.mul_add(C_Mq_nonzero_air_velocity_12, air_velocity_1_inv_product_4);
    let part_of_minus_air_velocity_2_sum_2 =
        part_of_minus_air_velocity_2_sum * minus_air_velocity_product_3;
    let minus_air_velocity_2_sum = air_velocity_2_inv_product_3.neg_mul_add(
        air_velocity_12_inv_product,
        part_of_minus_air_velocity_2_sum_2,
    );
    let part_of_air_velocity_1_inv_sum_2 =
        part_of_air_velocity_1_inv_sum * minus_air_velocity_product_3;
    let air_velocity_1_inv_sum = air_velocity_1_inv_product.mul_add(
        air_velocity_12_inv_product,
        part_of_air_velocity_1_inv_sum_2,
    );
    let part_of_minus_minus_part_part =
        C_Mq.neg_mul_add(phidot, sin_alpha_two_C_Ms_product) * air_velocity_12_two_product;
    let part_of_d_thetadot_dot_d_air =
        C_Mq.mul_add(thetadot, air_velocity_1_inv_product_4) * air_velocity_12_two_product;
    let d_thetadot_dot_d_air_velocity_12 = air_velocity_1_inv_product
        .neg_mul_add(d_thetadot_dot_d_air_sum, part_of_d_thetadot_dot_d_air);
    let part_of_minus_minus_part_part_2 = air_velocity_2_inv_product * d_thetadot_dot_d_air_sum;
    let minus_minus_part_part_sum = inv_cos_theta.mul_sub(
        part_of_minus_minus_part_part_2,
        part_of_minus_minus_part_part,
    );
    let part_of_d_phidot_dot_d_v = V_sq_half_rho_A_d_product_3 * inv_cos_theta;
    let part_of_d_phidot_dot_d_v_2 =
        air_velocity_2.mul_sub(minus_minus_part_part_sum, part_of_d_phidot_dot_d_v);
    let part_of_d_thetadot_dot_d_air_2 = air_velocity_1.mul_add(
        d_thetadot_dot_d_air_velocity_12,
        V_sq_half_rho_A_d_product_3,
    );
    let d_gammadot_dot_d_w = sin_theta * minus_air_velocity_2_sum;
    j[54] = d_gammadot_dot_d_w;
    let d_phidot_dot_d_w = -minus_air_velocity_2_sum;
    j[38] = d_phidot_dot_d_w;
    let d_thetadot_dot_d_air_velocity_2 =
        air_velocity_2_inv_product * d_thetadot_dot_d_air_velocity_12;
    j[45] = d_thetadot_dot_d_air_velocity_2; // d_thetadot_dot_d_v
    let d_thetadot_dot_d_w = -air_velocity_1_inv_sum;
    j[46] = d_thetadot_dot_d_w;
    let d_minus_thetadot_r_product_d_u = air_velocity_1_inv_product * minus_minus_part_part_sum;
    j[36] = d_minus_thetadot_r_product_d_u; // d_phidot_dot_d_u
    let d_phidot_dot_d_v = inv_air_velocity_12 * part_of_d_phidot_dot_d_v_2;
    j[37] = d_phidot_dot_d_v;
    let d_thetadot_dot_d_air_velocity_1_2 = inv_air_velocity_12 * part_of_d_thetadot_dot_d_air_2;
    j[44] = d_thetadot_dot_d_air_velocity_1_2; // d_thetadot_dot_d_u
    let part_of_d_thetadot_dot_d_phi_3 = sin_phi_wind_y_sum * d_thetadot_dot_d_air_velocity_2;
    let C_D_air_velocity_12_product_2 = C_D_air_velocity_12_product * inv_air_velocity_12;
    let part_of_u_dot = C_D_air_velocity_12_product
        .neg_mul_add(air_velocity_1_inv_product, sin_theta_cos_phi_g_product);
    let u_dot = w.neg_mul_add(thetadot, part_of_u_dot);
    dx[3] = u_dot;
    let minus_d_C_D_air_sum = C_D_air_velocity_12_product_2 - part_of_minus_d_C_D_air_sum_3;
    let part_of_d_w_dot_d_V = inv_m_half_rho_A * minus_air_velocity_3_C_sum;
    let d_w_dot_d_V =
        inv_V_minus_air_velocity_sum.neg_mul_add(V_inv_m_half_rho_A_product, part_of_d_w_dot_d_V);
    let part_of_d_w_dot_d_air_velocity =
        d_w_dot_d_V.mul_sub(air_velocity_12_inv_V, air_velocity_12_V_product);
    let d_w_dot_d_air_velocity_12 =
        V_inv_m_half_rho_A.mul_add(sin_alpha_two_C_Lp_product, part_of_d_w_dot_d_air_velocity);
    let part_of_d_w_dot_d_minus_air_3 = minus_air_velocity_3_inv_V * d_w_dot_d_V;
    let d_w_dot_d_minus_air_velocity_3 =
        V_inv_m_half_rho_A.mul_add(part_of_d_w_dot_d_minus_air_2, part_of_d_w_dot_d_minus_air_3);
    let part_of_w_dot =
        V_inv_m_half_rho_A.mul_sub(minus_air_velocity_3_C_sum, cos_theta_cos_phi_g_product);
    let w_dot = u.mul_add(thetadot, part_of_w_dot);
    dx[5] = w_dot;
    let part_of_d_w_dot_d_phi_3 =
        inv_air_velocity_12 * d_w_dot_d_air_velocity_12 * part_of_d_w_dot_d_phi_2;
    let d_w_dot_d_u = air_velocity_1_inv_product.mul_add(d_w_dot_d_air_velocity_12, thetadot);
    j[26] = d_w_dot_d_u;
    let d_w_dot_d_v =
        air_velocity_2_inv_product.mul_sub(d_w_dot_d_air_velocity_12, cos_theta_phidot);
    j[27] = d_w_dot_d_v;
    let d_w_dot_d_w = -d_w_dot_d_minus_air_velocity_3;
    j[28] = d_w_dot_d_w;
    let air_velocity_1_inv_product_3 = air_velocity_1_inv_product * d_air_velocity_1_d_theta;
    let part_of_d_w_dot_d_theta = d_w_dot_d_air_velocity_12
        .mul_add(air_velocity_1_inv_product_3, sin_theta_cos_phi_g_product);
    let d_w_dot_d_theta = d_minus_air_velocity_3_d_theta
        .mul_add(d_w_dot_d_minus_air_velocity_3, part_of_d_w_dot_d_theta);
    j[30] = d_w_dot_d_theta;
    let part_of_d_w_dot_d_phi_4 =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_add(d_w_dot_d_minus_air_velocity_3, sin_phi_g);
    let d_w_dot_d_phi = cos_theta.mul_add(part_of_d_w_dot_d_phi_4, part_of_d_w_dot_d_phi_3);
    j[29] = d_w_dot_d_phi;
    let part_of_d_minus_thetadot_r_2 = d_minus_air_velocity_3_d_theta * minus_air_velocity_2_sum;
    let part_of_d_minus_thetadot_r_3 = minus_minus_part_part_sum
        .mul_add(air_velocity_1_inv_product_3, part_of_d_minus_thetadot_r_2);
    let part_of_d_minus_thetadot_r_4 =
        sin_theta_inv_cos_theta.mul_add(part_of_d_minus_thetadot_r, part_of_d_minus_thetadot_r_3);
    let two_minus_inv_I_d_I_a = prepared[11];
    let d_minus_thetadot_r_product_d_theta =
        two_minus_inv_I_d_I_a.mul_add(phidot_thetadot, part_of_d_minus_thetadot_r_4);
    j[40] = d_minus_thetadot_r_product_d_theta; // d_phidot_dot_d_theta
    let part_of_d_gammadot_dot_d_theta_2 = phidot_thetadot - d_minus_thetadot_r_product_d_theta;
    let d_gammadot_dot_d_theta = sin_theta.mul_sub(
        part_of_d_gammadot_dot_d_theta_2,
        part_of_d_gammadot_dot_d_theta,
    );
    j[56] = d_gammadot_dot_d_theta;
    let sin_theta_air_product = sin_theta * air_velocity_1_inv_product;
    let minus_minus_part_product = minus_minus_part_part_sum * sin_theta_air_product;
    let part_of_d_minus_thetadot_r_5 =
        cos_theta.mul_add(minus_air_velocity_2_sum, minus_minus_part_product);
    let d_gammadot_dot_d_u = -minus_minus_part_product;
    j[52] = d_gammadot_dot_d_u;
    let part_of_d_u_dot_d_air_velocity_1 = air_velocity_1_inv_product * minus_d_C_D_air_sum;
    let part_of_d_v_dot_d_theta = air_velocity_2_inv_product * minus_d_C_D_air_sum;
    let part_of_d_v_dot_d_theta_2 =
        air_velocity_1_inv_product_3.mul_sub(part_of_d_v_dot_d_theta, x_dot * phidot);
    let part_of_d_v_dot_d_phi = part_of_d_v_dot_d_theta * sin_theta_air_product;
    let d_v_dot_d_u = air_velocity_1_inv_product.mul_sub(part_of_d_v_dot_d_theta, sin_theta_phidot);
    j[20] = d_v_dot_d_u;
    let d_v_dot_d_air_velocity_2 =
        air_velocity_2_inv_product.mul_sub(part_of_d_v_dot_d_theta, C_D_air_velocity_12_product_2);
    j[21] = d_v_dot_d_air_velocity_2; // d_v_dot_d_v
    let part_of_d_v_dot_d_phi_3 = sin_phi_wind_y_sum.mul_sub(d_v_dot_d_air_velocity_2, cos_phi_g);
    let d_u_dot_d_air_velocity_1 = air_velocity_1_inv_product.mul_sub(
        part_of_d_u_dot_d_air_velocity_1,
        C_D_air_velocity_12_product_2,
    );
    j[13] = d_u_dot_d_air_velocity_1; // d_u_dot_d_u
    let d_u_dot_d_air_velocity_2 = air_velocity_2_inv_product * part_of_d_u_dot_d_air_velocity_1;
    let d_u_dot_d_v = sin_theta_phidot + d_u_dot_d_air_velocity_2;
    j[14] = d_u_dot_d_v;
    let air_velocity_1_inv_product_2 = air_velocity_1_inv_product * minus_air_velocity_sum;
    let air_velocity_2_inv_product_2 = air_velocity_2_inv_product * minus_air_velocity_sum;
    let d_v_dot_d_w = cos_theta_phidot + air_velocity_2_inv_product_2;
    j[22] = d_v_dot_d_w;
    let d_v_dot_d_theta = d_minus_air_velocity_3_d_theta
        .neg_mul_add(air_velocity_2_inv_product_2, part_of_d_v_dot_d_theta_2);
    j[24] = d_v_dot_d_theta;
    let part_of_d_v_dot_d_phi_2 =
        cos_theta.neg_mul_add(air_velocity_2_inv_product_2, part_of_d_v_dot_d_phi);
    let part_of_d_minus_thetadot_r_6 = sin_phi_wind_y_sum * d_phidot_dot_d_v;
    let d_v_dot_d_phi =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_add(part_of_d_v_dot_d_phi_2, part_of_d_v_dot_d_phi_3);
    j[23] = d_v_dot_d_phi;
    let part_of_d_u_dot_d_phi_2 = sin_phi_wind_y_sum * d_u_dot_d_air_velocity_2;
    let part_of_d_u_dot_d_phi_3 = cos_theta * air_velocity_1_inv_product_2;
    let part_of_d_thetadot_dot_d_phi = cos_theta * air_velocity_1_inv_sum;
    let part_of_d_thetadot_dot_d_theta_3 = d_minus_air_velocity_3_d_theta * air_velocity_1_inv_sum;
    let part_of_d_u_dot_d_phi =
        d_u_dot_d_air_velocity_1.neg_mul_add(d_minus_sin_phi_wind_y_sum_d_phi, sin_phi_g);
    let d_minus_thetadot_r_product_d_phi = d_minus_sin_phi_wind_y_sum_d_phi
        .mul_add(part_of_d_minus_thetadot_r_5, part_of_d_minus_thetadot_r_6);
    j[39] = d_minus_thetadot_r_product_d_phi; // d_phidot_dot_d_phi
    let part_of_d_u_dot_d_theta =
        d_u_dot_d_air_velocity_1.mul_add(d_air_velocity_1_d_theta, cos_theta_cos_phi_g_product);
    let d_u_dot_d_w = air_velocity_1_inv_product_2 - thetadot;
    j[15] = d_u_dot_d_w;
    let part_of_d_u_dot_d_phi_4 = d_minus_sin_phi_wind_y_sum_d_phi
        .neg_mul_add(part_of_d_u_dot_d_phi_3, part_of_d_u_dot_d_phi_2);
    let part_of_d_thetadot_dot_d_phi_2 = sin_theta.mul_add(
        d_thetadot_dot_d_air_velocity_1_2,
        part_of_d_thetadot_dot_d_phi,
    );
    let part_of_d_thetadot_dot_d_theta_4 = d_air_velocity_1_d_theta.mul_add(
        d_thetadot_dot_d_air_velocity_1_2,
        part_of_d_thetadot_dot_d_theta_3,
    );
    let d_u_dot_d_theta = air_velocity_1_inv_product_2
        .neg_mul_add(d_minus_air_velocity_3_d_theta, part_of_d_u_dot_d_theta);
    j[17] = d_u_dot_d_theta;
    let d_gammadot_dot_d_v = -(sin_theta * d_phidot_dot_d_v);
    j[53] = d_gammadot_dot_d_v;
    let d_u_dot_d_phi = sin_theta.neg_mul_add(part_of_d_u_dot_d_phi, part_of_d_u_dot_d_phi_4);
    j[16] = d_u_dot_d_phi;
    let d_thetadot_dot_d_phi = d_minus_sin_phi_wind_y_sum_d_phi.mul_add(
        part_of_d_thetadot_dot_d_phi_2,
        part_of_d_thetadot_dot_d_phi_3,
    );
    j[47] = d_thetadot_dot_d_phi;
    let d_thetadot_dot_d_theta = phidot.mul_add(
        part_of_d_thetadot_dot_d_theta_2,
        part_of_d_thetadot_dot_d_theta_4,
    );
    j[48] = d_thetadot_dot_d_theta;
    let d_gammadot_dot_d_phi = -(sin_theta * d_minus_thetadot_r_product_d_phi);
    j[55] = d_gammadot_dot_d_phi;

    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
}
