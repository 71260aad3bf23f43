// Written by `hyzer generate`; changes belong in the model.
//! `disc`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 339 operations: 103 add, 212 mul, 3 div, 13 neg, 2 sqrt, 5 call, 1 select.
/// `prepare` takes 13 operations for it.
#[inline(always)]
pub fn f_jac<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 22],
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
    let w = state[5];
    let d_u_dot_d_thetadot = -w;
    j[19] = d_u_dot_d_thetadot;
    let phidot = state[9];
    let sin_theta_phidot = sin_theta * phidot;
    let cos_theta_phidot = cos_theta * phidot;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let wind_z = parameters[17];
    let wind_y = parameters[16];
    let sin_phi_wind_y_sum = wind_z.neg_mul_add(cos_phi, wind_y * sin_phi);
    let minus_wind_y = prepared[5];
    let d_minus_sin_phi_wind_y_sum_d_phi = wind_z.neg_mul_add(sin_phi, minus_wind_y * cos_phi);
    let g = parameters[6];
    let cos_phi_g = g * cos_phi;
    let gammadot = state[11];

    // disc.hyz:91  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let inv_I_d_I_a = prepared[3];
    let part_of_d_thetadot_dot_d_r = inv_I_d_I_a * cos_theta_phidot;
    let u = state[3];
    let minus_sin_theta_u_minus_w_cos_sum_2 = u.neg_mul_add(sin_theta, cos_theta * w);
    j[2] = minus_sin_theta_u_minus_w_cos_sum_2; // d_x_dot_d_theta
    j[25] = minus_sin_theta_u_minus_w_cos_sum_2; // d_v_dot_d_phidot
    let sin_phi_g = g * sin_phi;
    let wind_x = parameters[15];
    let d_minus_air_velocity_3_d_theta = sin_theta.mul_add(sin_phi_wind_y_sum, wind_x * cos_theta);
    let v = state[4];

    // disc.hyz:75  let air_velocity = velocity - in_B(air);
    let air_velocity_2 = v + d_minus_sin_phi_wind_y_sum_d_phi;
    let d_air_velocity_1_d_theta = cos_theta.neg_mul_add(sin_phi_wind_y_sum, wind_x * sin_theta);
    let sin_theta_d_minus_product = sin_theta * d_minus_sin_phi_wind_y_sum_d_phi;

    // disc.hyz:55  position (x, y, z) in N;
    let x_dot = w.mul_add(sin_theta, u * cos_theta);
    dx[0] = x_dot;
    let d_y_dot_d_u = sin_theta * sin_phi;
    j[3] = d_y_dot_d_u;
    let d_z_dot_d_w = cos_theta * cos_phi;
    j[10] = d_z_dot_d_w;
    let d_u_dot_d_phidot = sin_theta * v;
    j[18] = d_u_dot_d_phidot;
    let d_y_dot_d_theta = x_dot * sin_phi;
    j[7] = d_y_dot_d_theta;
    let air_velocity_1 = u - d_minus_air_velocity_3_d_theta;
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let minus_air_velocity_3 = d_air_velocity_1_d_theta - w;
    let C_Rr = parameters[13];
    let r_C_Rr = C_Rr * r;
    let r_inv_I_d_I_a = inv_I_d_I_a * r;
    let cos_phi_g_plus_v_phidot = v.mul_add(phidot, cos_phi_g);
    let part_of_v_dot = minus_sin_theta_u_minus_w_cos_sum_2 * phidot;
    let C_Nr_inv_I_a = prepared[4];
    let thetadot = state[10];
    let part_of_gammadot_dot = C_Nr_inv_I_a.mul_sub(r, thetadot * cos_theta_phidot);
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);
    let r_inv_I_d_I_a_minus_sin_sum = sin_theta_phidot.neg_mul_add(T::splat(2.0), r_inv_I_d_I_a);
    let sin_theta_phidot_minus_sum = sin_theta_phidot - r_inv_I_d_I_a;
    let two_d_half_rho_A_inv_I_d = prepared[7];
    let minus_air_velocity_product_2 = two_d_half_rho_A_inv_I_d * minus_air_velocity_3;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let d_gammadot_dot_d_thetadot =
        r_inv_I_d_I_a_minus_sin_sum.mul_sub(sin_theta_inv_cos_theta, cos_theta_phidot);
    j[58] = d_gammadot_dot_d_thetadot;

    // disc.hyz:77  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let half_rho_A_d_inv_I_d = prepared[2];
    let V_sq_half_rho_A_d_inv_part = half_rho_A_d_inv_I_d * V_sq;
    let V_sq_half_rho_A_d_product = V_sq_half_rho_A_d_inv_part * r_C_Rr;
    let part_of_cos_theta_phidot_sum_2 = thetadot * r_inv_I_d_I_a_minus_sin_sum;
    let d_phidot_dot_d_thetadot = -(r_inv_I_d_I_a_minus_sin_sum * inv_cos_theta);
    j[42] = d_phidot_dot_d_thetadot;
    let sin_theta_cos_phi_g_product = sin_theta * cos_phi_g_plus_v_phidot;
    let cos_theta_cos_phi_g_product = cos_theta * cos_phi_g_plus_v_phidot;
    let part_of_d_w_dot_d_phi = air_velocity_2 * sin_phi_wind_y_sum;
    let part_of_d_w_dot_d_phi_2 =
        air_velocity_1.mul_add(sin_theta_d_minus_product, part_of_d_w_dot_d_phi);
    let V_sq_half_rho_A_d_product_3 = C_Rr * V_sq_half_rho_A_d_inv_part;
    let part_of_d_thetadot_dot_d_theta_3 = sin_theta * sin_theta_phidot_minus_sum;
    let z_dot = cos_phi.mul_add(minus_sin_theta_u_minus_w_cos_sum_2, v * sin_phi);
    dx[2] = z_dot;
    let d_y_dot_d_phi = -z_dot;
    j[6] = d_y_dot_d_phi;
    let y_dot = sin_phi.neg_mul_add(minus_sin_theta_u_minus_w_cos_sum_2, v * cos_phi);
    dx[1] = y_dot;
    j[11] = y_dot; // d_z_dot_d_phi
    let d_y_dot_d_w = -(cos_theta * sin_phi);
    j[5] = d_y_dot_d_w;
    let part_of_thetadot_dot = cos_theta_phidot * sin_theta_phidot_minus_sum;
    let part_of_d_thetadot_dot_d_phidot = cos_theta * sin_theta_phidot_minus_sum;
    let part_of_d_v_dot_d_phi_3 = air_velocity_2 * d_minus_sin_phi_wind_y_sum_d_phi;
    let d_z_dot_d_theta = -(x_dot * cos_phi);
    j[12] = d_z_dot_d_theta;
    let d_z_dot_d_u = -(sin_theta * cos_phi);
    j[8] = d_z_dot_d_u;

    // disc.hyz:82  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let C_La = parameters[8];
    let part_of_minus_part_part_air_sum = C_La * minus_air_velocity_3 * inv_air_velocity_12;
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let air_velocity_12_two_product = two_d_half_rho_A_inv_I_d * air_velocity_12;
    let inv_V = V.recip_or_zero();
    let inv_m_half_rho_A = prepared[0];
    let V_inv_m_half_rho_A = inv_m_half_rho_A * V;
    let d_w_dot_d_phidot = -(cos_theta * v);
    j[31] = d_w_dot_d_phidot;
    let C_Mq = parameters[12];
    let nonzero_air_velocity_12_C_Mq = C_Mq * nonzero_air_velocity_12;
    let C_Ma = parameters[11];
    let alpha_C_Ma = C_Ma * alpha;
    let air_velocity_1_r_C_Rr_sum = air_velocity_2.neg_mul_add(alpha_C_Ma, air_velocity_1 * r_C_Rr);
    let inv_air_velocity_12_product = inv_air_velocity_12 * air_velocity_1_r_C_Rr_sum;
    let air_velocity_2_r_C_Rr_sum = air_velocity_1.mul_add(alpha_C_Ma, air_velocity_2 * r_C_Rr);
    let inv_air_velocity_12_product_2 = inv_air_velocity_12 * air_velocity_2_r_C_Rr_sum;
    let V_sq_half_rho_A_d_product_2 = V_sq_half_rho_A_d_inv_part * alpha_C_Ma;
    let C_L0 = parameters[7];

    // disc.hyz:85  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La.mul_add(alpha, C_L0);
    let d_thetadot_dot_d_thetadot = V_sq_half_rho_A_d_inv_part * nonzero_air_velocity_12_C_Mq;
    j[50] = d_thetadot_dot_d_thetadot;
    let C_Da = parameters[10];
    let C_D0 = parameters[9];

    // disc.hyz:86  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = alpha.mul_add(C_Da * alpha, C_D0);
    let C_Da_two = prepared[6];
    let alpha_C_Da_two = C_Da_two * alpha;
    let part_of_minus_part_part_air_sum_2 =
        nonzero_air_velocity_12.neg_mul_add(alpha_C_Da_two, part_of_minus_part_part_air_sum);
    let C_La_air_velocity_12_sum =
        minus_air_velocity_3.mul_add(alpha_C_Da_two, C_La * air_velocity_12);
    let air_velocity_12_C_D_sum = air_velocity_12.mul_sub(C_D, minus_air_velocity_3 * C_L);
    let cos_theta_phidot_sum =
        nonzero_air_velocity_12_C_Mq.mul_add(cos_theta_phidot, inv_air_velocity_12_product);
    let thetadot_nonzero_sum =
        thetadot.mul_add(nonzero_air_velocity_12_C_Mq, inv_air_velocity_12_product_2);

    // disc.hyz:48  frame B = A turned theta about 2; // does not spin with the disc
    let thetadot_dot =
        V_sq_half_rho_A_d_inv_part.mul_sub(thetadot_nonzero_sum, part_of_thetadot_dot);
    dx[10] = thetadot_dot;
    let cos_theta_phidot_sum_2 =
        V_sq_half_rho_A_d_inv_part.mul_sub(cos_theta_phidot_sum, part_of_cos_theta_phidot_sum_2);
    let cos_theta_phidot_product = cos_theta_phidot_sum_2 * inv_cos_theta;
    dx[9] = cos_theta_phidot_product;

    // disc.hyz:49  frame C = B turned gamma about 3; // fixed in the disc
    let gammadot_dot = sin_theta.neg_mul_add(cos_theta_phidot_product, part_of_gammadot_dot);
    dx[11] = gammadot_dot;
    let inv_V_sq = inv_V * inv_V;
    let air_velocity_12_C_D_product = air_velocity_12_C_D_sum * inv_air_velocity_12;
    let air_velocity_12_C_D_product_2 = inv_m_half_rho_A * air_velocity_12_C_D_sum;
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;
    let part_of_minus_part_part_air_sum_3 =
        minus_air_velocity_3_inv_V.mul_sub(air_velocity_12_C_D_product_2, C_L * V_inv_m_half_rho_A);
    let inv_air_velocity_12_product_3 = inv_air_velocity_12 * V_sq_half_rho_A_d_inv_part;
    let part_of_minus_inv_air_velocity_2 = cos_theta_phidot_sum * air_velocity_12_two_product;
    let part_of_d_thetadot_dot_d_air_2 = thetadot_nonzero_sum * air_velocity_12_two_product;
    let C_Ma_inv_V_sq = C_Ma * inv_V_sq;
    let air_velocity_12_inv_V_sq = air_velocity_12 * inv_V_sq;
    let part_of_d_w_dot_d_air_velocity_3 = air_velocity_12 * inv_V;
    let minus_air_velocity_3_C_sum = minus_air_velocity_3.mul_add(C_D, air_velocity_12 * C_L);
    let V_inv_m_half_rho_A_product = V_inv_m_half_rho_A * air_velocity_12_C_D_product;
    let part_of_minus_part_part_air_sum_4 =
        V_inv_m_half_rho_A * part_of_minus_part_part_air_sum_2 * air_velocity_12_inv_V_sq;
    let minus_part_part_air_sum = inv_air_velocity_12.mul_sub(
        part_of_minus_part_part_air_sum_3,
        part_of_minus_part_part_air_sum_4,
    );
    let part_of_V_inv_m_half_rho_A_sum =
        V_inv_m_half_rho_A * part_of_minus_part_part_air_sum_2 * minus_air_velocity_3_inv_V;
    let part_of_V_inv_m_half_rho_A_sum_2 = nonzero_air_velocity_12.mul_add(
        air_velocity_12_C_D_product_2,
        part_of_V_inv_m_half_rho_A_sum,
    );
    let part_of_d_w_dot_d_air_velocity =
        inv_V_sq.neg_mul_add(minus_air_velocity_3 * C_La_air_velocity_12_sum, C_L);
    let part_of_d_w_dot_d_minus_air =
        V_inv_m_half_rho_A * C_La_air_velocity_12_sum.mul_add(air_velocity_12_inv_V_sq, C_D);
    let part_of_v_dot_2 = air_velocity_2.neg_mul_add(V_inv_m_half_rho_A_product, part_of_v_dot);

    // disc.hyz:56  velocity (u, v, w) in B;
    let v_dot = part_of_v_dot_2 - sin_phi_g;
    dx[4] = v_dot;
    let d_v_dot_d_w = air_velocity_2.mul_add(minus_part_part_air_sum, cos_theta_phidot);
    j[22] = d_v_dot_d_w;
    let part_of_d_w_dot_d_air_velocity_2 = V_inv_m_half_rho_A * part_of_d_w_dot_d_air_velocity;
    let air_velocity_2_C_Ma_inv_V_sq = air_velocity_2 * C_Ma_inv_V_sq;
    let air_velocity_1_C_Ma_inv_V_sq = air_velocity_1 * C_Ma_inv_V_sq;
    let part_of_minus_inv_air_velocity =
        minus_air_velocity_3.neg_mul_add(air_velocity_2_C_Ma_inv_V_sq, inv_air_velocity_12_product);
    let minus_inv_air_velocity_sum = inv_air_velocity_12_product_3.neg_mul_add(
        part_of_minus_inv_air_velocity,
        part_of_minus_inv_air_velocity_2,
    );
    let part_of_d_thetadot_dot_d_air =
        minus_air_velocity_3.mul_add(air_velocity_1_C_Ma_inv_V_sq, inv_air_velocity_12_product_2);
    let d_thetadot_dot_d_air_velocity_12 = inv_air_velocity_12_product_3
        .neg_mul_add(part_of_d_thetadot_dot_d_air, part_of_d_thetadot_dot_d_air_2);
    let part_of_V_sq_half_rho_A_d_sum = V_sq_half_rho_A_d_inv_part * air_velocity_2_C_Ma_inv_V_sq;
    let V_sq_half_rho_A_d_sum = cos_theta_phidot_sum
        .neg_mul_add(minus_air_velocity_product_2, part_of_V_sq_half_rho_A_d_sum);
    let part_of_V_sq_half_rho_A_d_sum_4 = V_sq_half_rho_A_d_inv_part * air_velocity_1_C_Ma_inv_V_sq;
    let V_sq_half_rho_A_d_sum_4 = thetadot_nonzero_sum.mul_add(
        minus_air_velocity_product_2,
        part_of_V_sq_half_rho_A_d_sum_4,
    );
    let part_of_d_thetadot_dot_d_phi =
        cos_theta * d_minus_sin_phi_wind_y_sum_d_phi * V_sq_half_rho_A_d_sum_4;
    let d_cos_theta_phidot_product_d_w = inv_cos_theta * V_sq_half_rho_A_d_sum;
    j[38] = d_cos_theta_phidot_product_d_w; // d_phidot_dot_d_w
    let d_thetadot_dot_d_w = -V_sq_half_rho_A_d_sum_4;
    j[46] = d_thetadot_dot_d_w;
    let part_of_d_thetadot_dot_d_theta = d_minus_air_velocity_3_d_theta * V_sq_half_rho_A_d_sum_4;
    let part_of_V_inv_m_half_rho_A_sum_3 =
        V_inv_m_half_rho_A * inv_air_velocity_12 * (air_velocity_12_C_D_product - C_D);
    let V_inv_m_half_rho_A_sum = inv_V.neg_mul_add(
        part_of_V_inv_m_half_rho_A_sum_2,
        part_of_V_inv_m_half_rho_A_sum_3,
    );
    let part_of_w_dot =
        V_inv_m_half_rho_A.mul_sub(minus_air_velocity_3_C_sum, cos_theta_cos_phi_g_product);
    let w_dot = u.mul_add(thetadot, part_of_w_dot);
    dx[5] = w_dot;
    let minus_air_velocity_product = inv_m_half_rho_A * minus_air_velocity_3_C_sum;
    let d_w_dot_d_air_velocity_12 = minus_air_velocity_product.mul_add(
        part_of_d_w_dot_d_air_velocity_3,
        part_of_d_w_dot_d_air_velocity_2,
    );
    let d_w_dot_d_minus_air_velocity_3 =
        minus_air_velocity_3_inv_V.mul_add(minus_air_velocity_product, part_of_d_w_dot_d_minus_air);
    let d_w_dot_d_w = -d_w_dot_d_minus_air_velocity_3;
    j[28] = d_w_dot_d_w;
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let d_cos_theta_phidot_sum_2_d_r =
        air_velocity_1_inv_product.mul_sub(V_sq_half_rho_A_d_product_3, inv_I_d_I_a * thetadot);
    let d_phidot_dot_d_gammadot = inv_cos_theta * d_cos_theta_phidot_sum_2_d_r;
    j[43] = d_phidot_dot_d_gammadot;
    let d_gammadot_dot_d_gammadot =
        d_cos_theta_phidot_sum_2_d_r.neg_mul_add(sin_theta_inv_cos_theta, C_Nr_inv_I_a);
    j[59] = d_gammadot_dot_d_gammadot;
    let d_cos_theta_phidot_sum_sum = thetadot.mul_add(T::splat(2.0), d_cos_theta_phidot_sum_2_d_r);
    let air_velocity_1_product_sum =
        air_velocity_1.mul_add(minus_inv_air_velocity_sum, V_sq_half_rho_A_d_product);
    let minus_air_velocity_2_sum =
        air_velocity_2.neg_mul_add(minus_inv_air_velocity_sum, V_sq_half_rho_A_d_product_2);
    let V_sq_half_rho_A_d_sum_2 = air_velocity_1.mul_add(
        d_thetadot_dot_d_air_velocity_12,
        V_sq_half_rho_A_d_product_2,
    );
    let V_sq_half_rho_A_d_sum_3 =
        air_velocity_2.mul_add(d_thetadot_dot_d_air_velocity_12, V_sq_half_rho_A_d_product);
    let d_thetadot_dot_d_air_velocity_1 = inv_air_velocity_12 * V_sq_half_rho_A_d_sum_2;
    j[44] = d_thetadot_dot_d_air_velocity_1; // d_thetadot_dot_d_u
    let d_thetadot_dot_d_air_velocity_2 = inv_air_velocity_12 * V_sq_half_rho_A_d_sum_3;
    j[45] = d_thetadot_dot_d_air_velocity_2; // d_thetadot_dot_d_v
    let inv_air_velocity_12_product_5 = inv_air_velocity_12 * d_air_velocity_1_d_theta;
    let part_of_d_thetadot_dot_d_theta_2 = V_sq_half_rho_A_d_sum_2.mul_add(
        inv_air_velocity_12_product_5,
        part_of_d_thetadot_dot_d_theta,
    );
    let part_of_d_thetadot_dot_d_phi_2 = V_sq_half_rho_A_d_sum_2 * sin_theta_d_minus_product;
    let part_of_d_thetadot_dot_d_phi_3 =
        sin_phi_wind_y_sum.mul_add(V_sq_half_rho_A_d_sum_3, part_of_d_thetadot_dot_d_phi_2);
    let d_thetadot_dot_d_phi =
        inv_air_velocity_12.mul_add(part_of_d_thetadot_dot_d_phi_3, part_of_d_thetadot_dot_d_phi);
    j[47] = d_thetadot_dot_d_phi;
    let part_of_d_cos_theta_phidot = air_velocity_1_product_sum * sin_theta_d_minus_product;
    let part_of_d_cos_theta_phidot_2 =
        sin_phi_wind_y_sum.neg_mul_add(minus_air_velocity_2_sum, part_of_d_cos_theta_phidot);
    let part_of_d_cos_theta_phidot_3 = d_minus_air_velocity_3_d_theta * V_sq_half_rho_A_d_sum;
    let part_of_d_cos_theta_phidot_4 = air_velocity_1_product_sum
        .mul_sub(inv_air_velocity_12_product_5, part_of_d_cos_theta_phidot_3);
    let cos_theta_minus_product = cos_theta * minus_part_part_air_sum;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12;
    let d_thetadot_dot_d_r =
        air_velocity_2_inv_product.mul_add(V_sq_half_rho_A_d_product_3, part_of_d_thetadot_dot_d_r);
    j[51] = d_thetadot_dot_d_r; // d_thetadot_dot_d_gammadot
    let d_thetadot_dot_d_sin_theta_phidot = d_thetadot_dot_d_r - cos_theta_phidot;
    let d_w_dot_d_v =
        d_w_dot_d_air_velocity_12.mul_sub(air_velocity_2_inv_product, cos_theta_phidot);
    j[27] = d_w_dot_d_v;
    let d_thetadot_dot_d_phidot = sin_theta.mul_sub(
        d_thetadot_dot_d_sin_theta_phidot,
        part_of_d_thetadot_dot_d_phidot,
    );
    j[49] = d_thetadot_dot_d_phidot;
    let part_of_d_thetadot_dot_d_theta_4 = cos_theta.mul_add(
        d_thetadot_dot_d_sin_theta_phidot,
        part_of_d_thetadot_dot_d_theta_3,
    );
    let d_thetadot_dot_d_theta = phidot.mul_add(
        part_of_d_thetadot_dot_d_theta_4,
        part_of_d_thetadot_dot_d_theta_2,
    );
    j[48] = d_thetadot_dot_d_theta;
    let V_inv_m_half_rho_A_product_3 = V_inv_m_half_rho_A_sum * air_velocity_2_inv_product;
    let V_inv_m_half_rho_A_product_2 = V_inv_m_half_rho_A_sum * air_velocity_1_inv_product;
    let d_w_dot_d_air_velocity_1 = d_w_dot_d_air_velocity_12 * air_velocity_1_inv_product;
    let part_of_d_w_dot_d_phi_4 = inv_air_velocity_12 * d_w_dot_d_air_velocity_12;
    let d_w_dot_d_u = thetadot + d_w_dot_d_air_velocity_1;
    j[26] = d_w_dot_d_u;
    let part_of_d_w_dot_d_theta =
        d_air_velocity_1_d_theta.mul_add(d_w_dot_d_air_velocity_1, sin_theta_cos_phi_g_product);
    let d_w_dot_d_theta = d_minus_air_velocity_3_d_theta
        .mul_add(d_w_dot_d_minus_air_velocity_3, part_of_d_w_dot_d_theta);
    j[30] = d_w_dot_d_theta;
    let part_of_d_w_dot_d_phi_3 =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_add(d_w_dot_d_minus_air_velocity_3, sin_phi_g);
    let part_of_u_dot =
        air_velocity_1.neg_mul_add(V_inv_m_half_rho_A_product, sin_theta_cos_phi_g_product);
    let u_dot = w.neg_mul_add(thetadot, part_of_u_dot);
    dx[3] = u_dot;
    let part_of_d_w_dot_d_phi_5 = cos_theta * part_of_d_w_dot_d_phi_3;
    let d_w_dot_d_phi =
        part_of_d_w_dot_d_phi_4.mul_add(part_of_d_w_dot_d_phi_2, part_of_d_w_dot_d_phi_5);
    j[29] = d_w_dot_d_phi;
    let part_of_d_cos_theta_phidot_5 =
        phidot.neg_mul_add(d_thetadot_dot_d_thetadot, cos_theta_phidot_product);
    let part_of_d_cos_theta_phidot_6 =
        sin_theta.mul_add(part_of_d_cos_theta_phidot_5, part_of_d_cos_theta_phidot_4);
    let d_cos_theta_phidot_product_d_phidot =
        d_cos_theta_phidot_sum_sum.mul_add(sin_theta_inv_cos_theta, d_thetadot_dot_d_thetadot);
    j[41] = d_cos_theta_phidot_product_d_phidot; // d_phidot_dot_d_phidot
    let part_of_d_cos_theta_phidot_7 = phidot * d_cos_theta_phidot_sum_sum;
    let d_cos_theta_phidot_product_d_theta =
        inv_cos_theta.mul_add(part_of_d_cos_theta_phidot_6, part_of_d_cos_theta_phidot_7);
    j[40] = d_cos_theta_phidot_product_d_theta; // d_phidot_dot_d_theta
    let inv_air_velocity_12_product_4 = inv_air_velocity_12 * inv_cos_theta;
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * C_Nr_inv_I_a.mul_sub(phidot, cos_theta_phidot_product);
    let inv_air_velocity_12_product_6 = inv_air_velocity_12 * sin_theta_inv_cos_theta;
    let d_gammadot_dot_d_w = -(V_sq_half_rho_A_d_sum * sin_theta_inv_cos_theta);
    j[54] = d_gammadot_dot_d_w;
    let part_of_d_cos_theta_phidot_8 = d_minus_sin_phi_wind_y_sum_d_phi * V_sq_half_rho_A_d_sum;
    let d_cos_theta_phidot_product_d_phi = inv_air_velocity_12_product_4
        .mul_sub(part_of_d_cos_theta_phidot_2, part_of_d_cos_theta_phidot_8);
    j[39] = d_cos_theta_phidot_product_d_phi; // d_phidot_dot_d_phi
    let part_of_d_gammadot_dot_d_theta_2 =
        phidot.neg_mul_add(thetadot, d_cos_theta_phidot_product_d_theta);
    let d_gammadot_dot_d_theta = sin_theta.neg_mul_add(
        part_of_d_gammadot_dot_d_theta_2,
        part_of_d_gammadot_dot_d_theta,
    );
    j[56] = d_gammadot_dot_d_theta;
    let part_of_d_gammadot_dot_d_phidot = C_Nr_inv_I_a - d_cos_theta_phidot_product_d_phidot;
    let d_gammadot_dot_d_phidot =
        sin_theta.mul_sub(part_of_d_gammadot_dot_d_phidot, cos_theta * thetadot);
    j[57] = d_gammadot_dot_d_phidot;
    let d_cos_theta_phidot_product_d_u = air_velocity_1_product_sum * inv_air_velocity_12_product_4;
    j[36] = d_cos_theta_phidot_product_d_u; // d_phidot_dot_d_u
    let d_gammadot_dot_d_v = minus_air_velocity_2_sum * inv_air_velocity_12_product_6;
    j[53] = d_gammadot_dot_d_v;
    let d_phidot_dot_d_v = -(minus_air_velocity_2_sum * inv_air_velocity_12_product_4);
    j[37] = d_phidot_dot_d_v;
    let d_gammadot_dot_d_u = -(air_velocity_1_product_sum * inv_air_velocity_12_product_6);
    j[52] = d_gammadot_dot_d_u;
    let part_of_d_u_dot_d_phi_2 = d_minus_sin_phi_wind_y_sum_d_phi * cos_theta_minus_product;
    let part_of_d_v_dot_d_phi =
        sin_theta.neg_mul_add(V_inv_m_half_rho_A_product_2, cos_theta_minus_product);
    let d_gammadot_dot_d_phi = -(sin_theta * d_cos_theta_phidot_product_d_phi);
    j[55] = d_gammadot_dot_d_phi;
    let d_u_dot_d_air_velocity_1 =
        air_velocity_1.mul_sub(V_inv_m_half_rho_A_product_2, V_inv_m_half_rho_A_product);
    j[13] = d_u_dot_d_air_velocity_1; // d_u_dot_d_u
    let part_of_d_u_dot_d_phi =
        d_u_dot_d_air_velocity_1.mul_sub(d_minus_sin_phi_wind_y_sum_d_phi, sin_phi_g);
    let d_v_dot_d_air_velocity_2 =
        air_velocity_2.mul_sub(V_inv_m_half_rho_A_product_3, V_inv_m_half_rho_A_product);
    j[21] = d_v_dot_d_air_velocity_2; // d_v_dot_d_v
    let part_of_d_u_dot_d_phi_3 =
        sin_phi_wind_y_sum.neg_mul_add(V_inv_m_half_rho_A_product_3, part_of_d_u_dot_d_phi_2);
    let part_of_d_v_dot_d_theta = minus_part_part_air_sum * d_minus_air_velocity_3_d_theta;
    let air_velocity_1_product = air_velocity_1 * minus_part_part_air_sum;
    let air_velocity_2_V_product = air_velocity_2 * V_inv_m_half_rho_A_product_2;
    let part_of_d_v_dot_d_phi_2 = sin_phi_wind_y_sum.mul_sub(d_v_dot_d_air_velocity_2, cos_phi_g);
    let part_of_d_u_dot_d_theta =
        d_u_dot_d_air_velocity_1.mul_add(d_air_velocity_1_d_theta, cos_theta_cos_phi_g_product);
    let part_of_d_v_dot_d_theta_2 =
        d_air_velocity_1_d_theta.mul_sub(V_inv_m_half_rho_A_product_2, part_of_d_v_dot_d_theta);
    let part_of_d_u_dot_d_phi_4 = air_velocity_1 * part_of_d_u_dot_d_phi_3;
    let d_u_dot_d_v = sin_theta_phidot + air_velocity_2_V_product;
    j[14] = d_u_dot_d_v;
    let d_v_dot_d_u = air_velocity_2_V_product - sin_theta_phidot;
    j[20] = d_v_dot_d_u;
    let d_v_dot_d_phi =
        part_of_d_v_dot_d_phi_3.neg_mul_add(part_of_d_v_dot_d_phi, part_of_d_v_dot_d_phi_2);
    j[23] = d_v_dot_d_phi;
    let d_u_dot_d_theta =
        air_velocity_1_product.neg_mul_add(d_minus_air_velocity_3_d_theta, part_of_d_u_dot_d_theta);
    j[17] = d_u_dot_d_theta;
    let d_u_dot_d_w = air_velocity_1_product - thetadot;
    j[15] = d_u_dot_d_w;
    let d_u_dot_d_phi = sin_theta.mul_sub(part_of_d_u_dot_d_phi, part_of_d_u_dot_d_phi_4);
    j[16] = d_u_dot_d_phi;
    let d_v_dot_d_theta = air_velocity_2.mul_sub(part_of_d_v_dot_d_theta_2, x_dot * phidot);
    j[24] = d_v_dot_d_theta;

    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
}
