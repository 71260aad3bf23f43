// Written by `hyzer generate`; changes belong in the model.
//! `disc`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 493 operations: 125 add, 323 mul, 3 div, 34 neg, 2 sqrt, 5 call, 1 select.
/// `prepare` takes 20 operations for it.
#[inline(always)]
pub fn f_jac_par<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 22],
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
    let thetadot = state[10];
    let thetadot_two = T::splat(2.0) * thetadot;
    let w = state[5];
    let d_u_dot_d_thetadot = -w;
    j[19] = d_u_dot_d_thetadot;
    let phidot = state[9];
    let sin_theta_phidot = sin_theta * phidot;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let cos_theta_phidot = cos_theta * phidot;
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
    let cos_theta_sin_phi = cos_theta * sin_phi;
    let inv_I_d_I_a = prepared[3];
    let cos_theta_phidot_inv_I_d_I_a = inv_I_d_I_a * cos_theta_phidot;
    let u = state[3];
    let minus_sin_theta_u_minus_w_cos_sum_2 = u.neg_mul_add(sin_theta, cos_theta * w);
    j[2] = minus_sin_theta_u_minus_w_cos_sum_2; // d_x_dot_d_theta
    j[25] = minus_sin_theta_u_minus_w_cos_sum_2; // d_v_dot_d_phidot
    let wind_x = parameters[15];
    let d_minus_air_velocity_3_d_theta = sin_theta.mul_add(sin_phi_wind_y_sum, wind_x * cos_theta);
    let d_air_velocity_1_d_theta = cos_theta.neg_mul_add(sin_phi_wind_y_sum, wind_x * sin_theta);

    // disc.hyz:55  position (x, y, z) in N;
    let x_dot = w.mul_add(sin_theta, u * cos_theta);
    dx[0] = x_dot;
    let d_y_dot_d_u = sin_theta * sin_phi;
    j[3] = d_y_dot_d_u;
    let v = state[4];
    let d_u_dot_d_phidot = sin_theta * v;
    j[18] = d_u_dot_d_phidot;
    let inv_I_a = prepared[10];
    let d_gammadot_dot_d_C_Nr = inv_I_a * r;
    jp[63] = d_gammadot_dot_d_C_Nr;
    let d_v_dot_d_g = -sin_phi;
    jp[14] = d_v_dot_d_g;
    let d_y_dot_d_w = -cos_theta_sin_phi;
    j[5] = d_y_dot_d_w;
    let d_y_dot_d_theta = x_dot * sin_phi;
    j[7] = d_y_dot_d_theta;

    // disc.hyz:75  let air_velocity = velocity - in_B(air);
    let air_velocity_2 = v + d_minus_sin_phi_wind_y_sum_d_phi;
    let air_velocity_1 = u - d_minus_air_velocity_3_d_theta;
    let minus_air_velocity_3 = d_air_velocity_1_d_theta - w;
    let C_Rr = parameters[13];
    let r_C_Rr = C_Rr * r;
    let r_inv_I_d_I_a = inv_I_d_I_a * r;
    let inv_I_d = prepared[9];
    let r_inv_I_d = inv_I_d * r;
    let d_thetadot_dot_d_I_a = cos_theta_phidot * r_inv_I_d;
    jp[44] = d_thetadot_dot_d_I_a;
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let two_d_half_rho_A_inv_I_d = prepared[7];
    let minus_air_velocity_product_2 = two_d_half_rho_A_inv_I_d * minus_air_velocity_3;
    let r_inv_I_d_I_a_minus_sin_sum = sin_theta_phidot.neg_mul_add(T::splat(2.0), r_inv_I_d_I_a);
    let sin_theta_phidot_minus_sum = sin_theta_phidot - r_inv_I_d_I_a;
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);
    let r_inv_I_d_thetadot_product = r_inv_I_d * (thetadot * inv_cos_theta);
    let part_of_d_thetadot_dot_d_I_d = r_inv_I_d * cos_theta_phidot_inv_I_d_I_a;
    let d_phidot_dot_d_I_a = -r_inv_I_d_thetadot_product;
    jp[33] = d_phidot_dot_d_I_a;
    let part_of_d_cos_theta_phidot_6 = inv_I_d_I_a * r_inv_I_d_thetadot_product;
    let part_of_cos_theta_phidot_sum_2 = thetadot * r_inv_I_d_I_a_minus_sin_sum;

    // disc.hyz:77  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let inv_I_d_d = prepared[13];
    let V_sq_inv_I_d_d = inv_I_d_d * V_sq;
    let half_rho_A_inv_I_d = prepared[18];
    let V_sq_half_rho_A_inv_I_d = half_rho_A_inv_I_d * V_sq;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let inv_I_a_d_gammadot_dot_d_r = prepared[20];
    let part_of_d_gammadot_dot_d_I_a =
        sin_theta_inv_cos_theta.mul_sub(inv_I_d * thetadot, inv_I_a_d_gammadot_dot_d_r);
    let d_gammadot_dot_d_I_a = r * part_of_d_gammadot_dot_d_I_a;
    jp[55] = d_gammadot_dot_d_I_a;
    let d_gammadot_dot_d_thetadot =
        r_inv_I_d_I_a_minus_sin_sum.mul_sub(sin_theta_inv_cos_theta, cos_theta_phidot);
    j[58] = d_gammadot_dot_d_thetadot;
    let d_phidot_dot_d_thetadot = -(r_inv_I_d_I_a_minus_sin_sum * inv_cos_theta);
    j[42] = d_phidot_dot_d_thetadot;
    let half_rho_A = prepared[12];
    let V_sq_half_rho_A_d_inv_part = half_rho_A * V_sq_inv_I_d_d;
    let cos_phi_g_plus_v_phidot = v.mul_add(phidot, cos_phi_g);
    let sin_theta_air_velocity_1 = sin_theta * air_velocity_1;
    let part_of_d_w_dot_d_phi = air_velocity_2 * sin_phi_wind_y_sum;
    let part_of_d_w_dot_d_phi_2 =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_add(sin_theta_air_velocity_1, part_of_d_w_dot_d_phi);
    let cos_phi_air_velocity_2 = cos_phi * air_velocity_2;
    let part_of_v_dot = minus_sin_theta_u_minus_w_cos_sum_2 * phidot;
    let V_sq_half_rho_A_d_product = V_sq_half_rho_A_d_inv_part * inv_cos_theta;
    let part_of_d_thetadot_dot_d_air_3 = V_sq_half_rho_A_d_inv_part * r_C_Rr;
    let part_of_d_phidot_dot_d_u = r_C_Rr * V_sq_half_rho_A_d_product;
    let sin_theta_cos_phi_g_product = sin_theta * cos_phi_g_plus_v_phidot;
    let cos_theta_cos_phi_g_product = cos_theta * cos_phi_g_plus_v_phidot;
    let sin_phi_g = g * sin_phi;
    let C_Nr_inv_I_a = prepared[4];
    let part_of_gammadot_dot = C_Nr_inv_I_a.mul_sub(r, thetadot * cos_theta_phidot);
    let d_minus_air_velocity_3_d_wind_z = cos_theta * cos_phi;
    j[10] = d_minus_air_velocity_3_d_wind_z; // d_z_dot_d_w
    let d_w_dot_d_g = -d_minus_air_velocity_3_d_wind_z;
    jp[25] = d_w_dot_d_g;
    let part_of_d_thetadot_dot_d_theta = sin_theta * sin_theta_phidot_minus_sum;
    let sin_phi_air_velocity_2 = sin_phi * air_velocity_2;

    // disc.hyz:82  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let C_La = parameters[8];
    let part_of_minus_V_inv_m_half_rho = C_La * minus_air_velocity_3 * inv_air_velocity_12;
    let nonzero_air_velocity_12 = air_velocity_12.if_zero(T::splat(0.0), T::splat(1.0));
    let air_velocity_12_two_product = two_d_half_rho_A_inv_I_d * air_velocity_12;
    let z_dot = cos_phi.mul_add(minus_sin_theta_u_minus_w_cos_sum_2, v * sin_phi);
    dx[2] = z_dot;
    let d_y_dot_d_phi = -z_dot;
    j[6] = d_y_dot_d_phi;
    let inv_V = V.recip_or_zero();
    let inv_m = prepared[8];
    let V_inv_m = inv_m * V;
    let C_Mq = parameters[12];
    let nonzero_air_velocity_12_C_Mq = C_Mq * nonzero_air_velocity_12;
    let V_sq_half_rho_A_d_product_5 = V_sq_half_rho_A_d_inv_part * nonzero_air_velocity_12;
    let d_thetadot_dot_d_C_Mq = thetadot * V_sq_half_rho_A_d_product_5;
    jp[50] = d_thetadot_dot_d_C_Mq;
    let part_of_d_gammadot_dot_d_C_Mq =
        cos_theta_phidot * sin_theta_inv_cos_theta * V_sq_half_rho_A_d_product_5;
    let d_gammadot_dot_d_C_Mq = -part_of_d_gammadot_dot_d_C_Mq;
    jp[61] = d_gammadot_dot_d_C_Mq;
    let V_inv_m_half_rho_A = half_rho_A * V_inv_m;
    let d_thetadot_dot_d_thetadot = V_sq_half_rho_A_d_inv_part * nonzero_air_velocity_12_C_Mq;
    j[50] = d_thetadot_dot_d_thetadot;
    let y_dot = sin_phi.neg_mul_add(minus_sin_theta_u_minus_w_cos_sum_2, v * cos_phi);
    dx[1] = y_dot;
    j[11] = y_dot; // d_z_dot_d_phi
    let part_of_thetadot_dot = cos_theta_phidot * sin_theta_phidot_minus_sum;
    let part_of_d_thetadot_dot_d_phidot = cos_theta * sin_theta_phidot_minus_sum;
    let part_of_d_v_dot_d_phi_2 = air_velocity_2 * d_minus_sin_phi_wind_y_sum_d_phi;
    let d_z_dot_d_theta = -(x_dot * cos_phi);
    j[12] = d_z_dot_d_theta;
    let air_velocity_1_inv_product = air_velocity_1 * inv_air_velocity_12;
    let inv_air_velocity_12_product_4 = inv_air_velocity_12 * V_sq_half_rho_A_d_inv_part;
    let part_of_minus_V_inv_m_half_rho_7 = V_inv_m_half_rho_A * inv_air_velocity_12;
    let air_velocity_2_inv_product = air_velocity_2 * inv_air_velocity_12;
    let d_w_dot_d_C_D = minus_air_velocity_3 * V_inv_m_half_rho_A;
    jp[28] = d_w_dot_d_C_D; // d_w_dot_d_C_D0
    let d_v_dot_d_C_L0 = d_w_dot_d_C_D * air_velocity_2_inv_product;
    jp[15] = d_v_dot_d_C_L0;
    let air_velocity_1_V_product = air_velocity_1 * V_inv_m_half_rho_A;
    let d_u_dot_d_C_D0 = -air_velocity_1_V_product;
    jp[6] = d_u_dot_d_C_D0;
    let C_Ma = parameters[11];
    let C_Ma_inv_V = C_Ma * inv_V;
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;
    let V_sq_half_rho_A_d_product_2 = V_sq_half_rho_A_d_inv_part * inv_V;
    let V_sq_half_rho_A_d_product_3 = V_sq_half_rho_A_d_inv_part * air_velocity_1_inv_product;
    let part_of_d_cos_theta_phidot =
        C_Rr.mul_sub(V_sq_half_rho_A_d_product_3, inv_I_d_I_a * thetadot);
    j[43] = inv_cos_theta * part_of_d_cos_theta_phidot; // d_phidot_dot_d_gammadot
    let d_thetadot_dot_d_C_Ma = alpha * V_sq_half_rho_A_d_product_3;
    jp[49] = d_thetadot_dot_d_C_Ma;
    let d_gammadot_dot_d_C_Rr = -(r * sin_theta_inv_cos_theta * V_sq_half_rho_A_d_product_3);
    jp[62] = d_gammadot_dot_d_C_Rr;
    let air_velocity_2_C_Ma_inv_V = air_velocity_2 * C_Ma_inv_V;
    let air_velocity_1_C_Ma_inv_V = air_velocity_1 * C_Ma_inv_V;
    let air_velocity_12_inv_V = air_velocity_12 * inv_V;
    let part_of_d_cos_theta_phidot_2 =
        cos_theta.mul_add(inv_cos_theta * part_of_d_cos_theta_phidot, thetadot_two);
    let sin_theta_d_cos_product = sin_theta * (inv_cos_theta * part_of_d_cos_theta_phidot);
    let part_of_d_cos_theta_phidot_5 = phidot * part_of_d_cos_theta_phidot_2;
    let d_gammadot_dot_d_gammadot = C_Nr_inv_I_a - sin_theta_d_cos_product;
    j[59] = d_gammadot_dot_d_gammadot;
    let part_of_d_cos_theta_phidot_3 = sin_theta_d_cos_product + d_thetadot_dot_d_thetadot;
    let d_cos_theta_phidot_product_d_phidot =
        thetadot_two.mul_add(sin_theta_inv_cos_theta, part_of_d_cos_theta_phidot_3);
    j[41] = d_cos_theta_phidot_product_d_phidot; // d_phidot_dot_d_phidot
    let part_of_d_gammadot_dot_d_phidot = C_Nr_inv_I_a - d_cos_theta_phidot_product_d_phidot;
    let part_of_d_phidot_dot_d_w = air_velocity_2_C_Ma_inv_V * V_sq_half_rho_A_d_product_2;
    let part_of_air_velocity_1_C_Ma_sum = air_velocity_1_C_Ma_inv_V * V_sq_half_rho_A_d_product_2;
    let V_sq_half_rho_A_d_product_4 = V_sq_half_rho_A_d_inv_part * air_velocity_2_inv_product;
    let d_thetadot_dot_d_r =
        C_Rr.mul_add(V_sq_half_rho_A_d_product_4, cos_theta_phidot_inv_I_d_I_a);
    j[51] = d_thetadot_dot_d_r; // d_thetadot_dot_d_gammadot
    let d_thetadot_dot_d_C_Rr = r * V_sq_half_rho_A_d_product_4;
    jp[51] = d_thetadot_dot_d_C_Rr;
    let d_cos_theta_phidot_product_d_C_Rr =
        r * air_velocity_1_inv_product * V_sq_half_rho_A_d_product;
    jp[40] = d_cos_theta_phidot_product_d_C_Rr; // d_phidot_dot_d_C_Rr
    let minus_cos_theta_phidot_sum = d_thetadot_dot_d_r - cos_theta_phidot;
    let d_thetadot_dot_d_phidot =
        sin_theta.mul_sub(minus_cos_theta_phidot_sum, part_of_d_thetadot_dot_d_phidot);
    j[49] = d_thetadot_dot_d_phidot;
    let part_of_d_thetadot_dot_d_theta_2 =
        cos_theta.mul_add(minus_cos_theta_phidot_sum, part_of_d_thetadot_dot_d_theta);
    let air_velocity_2_V_product = air_velocity_2 * V_inv_m_half_rho_A;
    let d_v_dot_d_C_D0 = -air_velocity_2_V_product;
    jp[17] = d_v_dot_d_C_D0;
    let d_gammadot_dot_d_phidot =
        sin_theta.mul_sub(part_of_d_gammadot_dot_d_phidot, cos_theta * thetadot);
    j[57] = d_gammadot_dot_d_phidot;
    let d_u_dot_d_C_L0 = d_w_dot_d_C_D * air_velocity_1_inv_product;
    jp[4] = d_u_dot_d_C_L0;
    let d_u_dot_d_C_La = alpha * d_u_dot_d_C_L0;
    jp[5] = d_u_dot_d_C_La;
    let d_w_dot_d_C_L = air_velocity_12 * V_inv_m_half_rho_A;
    jp[26] = d_w_dot_d_C_L; // d_w_dot_d_C_L0
    let d_w_dot_d_C_La = alpha * d_w_dot_d_C_L;
    jp[27] = d_w_dot_d_C_La;
    let part_of_d_w_dot_d_wind_y =
        sin_phi.mul_add(sin_theta_air_velocity_1, cos_phi_air_velocity_2);
    let part_of_d_w_dot_d_wind_z =
        cos_phi.mul_sub(sin_theta_air_velocity_1, sin_phi_air_velocity_2);
    let d_cos_theta_phidot_product_d_C_Mq =
        nonzero_air_velocity_12 * cos_theta_phidot * V_sq_half_rho_A_d_product;
    jp[39] = d_cos_theta_phidot_product_d_C_Mq; // d_phidot_dot_d_C_Mq
    let d_air_velocity_1_d_wind_z = sin_theta * cos_phi;
    jp[3] = d_air_velocity_1_d_wind_z; // d_u_dot_d_g
    let d_z_dot_d_u = -d_air_velocity_1_d_wind_z;
    j[8] = d_z_dot_d_u;
    let d_w_dot_d_phidot = -(cos_theta * v);
    j[31] = d_w_dot_d_phidot;
    let alpha_C_Ma = C_Ma * alpha;
    let air_velocity_1_r_C_Rr_sum = air_velocity_2.neg_mul_add(alpha_C_Ma, air_velocity_1 * r_C_Rr);
    let inv_air_velocity_12_product = inv_air_velocity_12 * air_velocity_1_r_C_Rr_sum;
    let air_velocity_2_r_C_Rr_sum = air_velocity_1.mul_add(alpha_C_Ma, air_velocity_2 * r_C_Rr);
    let part_of_inv_cos_theta_cos = minus_air_velocity_3_inv_V
        .neg_mul_add(air_velocity_2_C_Ma_inv_V, inv_air_velocity_12_product);
    let cos_theta_phidot_sum =
        nonzero_air_velocity_12_C_Mq.mul_add(cos_theta_phidot, inv_air_velocity_12_product);
    let inv_air_velocity_12_product_2 = inv_air_velocity_12 * air_velocity_2_r_C_Rr_sum;
    let thetadot_nonzero_sum =
        thetadot.mul_add(nonzero_air_velocity_12_C_Mq, inv_air_velocity_12_product_2);
    let part_of_d_thetadot_dot_d_air = minus_air_velocity_3_inv_V
        .mul_add(air_velocity_1_C_Ma_inv_V, inv_air_velocity_12_product_2);

    // disc.hyz:48  frame B = A turned theta about 2; // does not spin with the disc
    let thetadot_dot =
        V_sq_half_rho_A_d_inv_part.mul_sub(thetadot_nonzero_sum, part_of_thetadot_dot);
    dx[10] = thetadot_dot;
    let cos_theta_phidot_sum_2 =
        V_sq_half_rho_A_d_inv_part.mul_sub(cos_theta_phidot_sum, part_of_cos_theta_phidot_sum_2);
    let part_of_d_thetadot_dot_d_air_5 = V_sq_half_rho_A_d_inv_part * alpha_C_Ma;
    let part_of_d_phidot_dot_d_w_2 =
        cos_theta_phidot_sum.mul_sub(minus_air_velocity_product_2, part_of_d_phidot_dot_d_w);
    let air_velocity_1_C_Ma_sum = thetadot_nonzero_sum.mul_add(
        minus_air_velocity_product_2,
        part_of_air_velocity_1_C_Ma_sum,
    );
    let part_of_d_phidot_dot_d_v = alpha_C_Ma * V_sq_half_rho_A_d_product;
    let d_thetadot_dot_d_d = thetadot_nonzero_sum * V_sq_half_rho_A_inv_I_d;
    jp[46] = d_thetadot_dot_d_d;
    let cos_theta_phidot_product_3 = cos_theta_phidot_sum * V_sq_half_rho_A_inv_I_d;
    let cos_theta_phidot_product = cos_theta_phidot_sum_2 * inv_cos_theta;
    dx[9] = cos_theta_phidot_product;

    // disc.hyz:49  frame C = B turned gamma about 3; // fixed in the disc
    let gammadot_dot = sin_theta.neg_mul_add(cos_theta_phidot_product, part_of_gammadot_dot);
    dx[11] = gammadot_dot;
    let part_of_d_phidot_dot_d_w_3 = inv_cos_theta * part_of_d_phidot_dot_d_w_2;
    let d_thetadot_dot_d_w = -air_velocity_1_C_Ma_sum;
    j[46] = d_thetadot_dot_d_w;
    let part_of_d_cos_theta_phidot_4 =
        phidot.neg_mul_add(d_thetadot_dot_d_thetadot, cos_theta_phidot_product);
    let d_cos_theta_phidot_product_d_theta =
        sin_theta_inv_cos_theta.mul_add(part_of_d_cos_theta_phidot_4, part_of_d_cos_theta_phidot_5);
    let d_cos_theta_phidot_product_d_d = inv_cos_theta * cos_theta_phidot_product_3;
    jp[35] = d_cos_theta_phidot_product_d_d; // d_phidot_dot_d_d
    let d_gammadot_dot_d_d = -(sin_theta_inv_cos_theta * cos_theta_phidot_product_3);
    jp[57] = d_gammadot_dot_d_d;
    let d_phidot_dot_d_w = -part_of_d_phidot_dot_d_w_3;
    j[38] = d_phidot_dot_d_w;
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * C_Nr_inv_I_a.neg_mul_add(phidot, cos_theta_phidot_product);
    let C_L0 = parameters[7];

    // disc.hyz:85  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La.mul_add(alpha, C_L0);
    let alpha_sq = alpha * alpha;
    let d_u_dot_d_C_Da = -(air_velocity_1_V_product * alpha_sq);
    jp[7] = d_u_dot_d_C_Da;
    let d_v_dot_d_C_Da = -(air_velocity_2_V_product * alpha_sq);
    jp[18] = d_v_dot_d_C_Da;
    let d_w_dot_d_C_Da = d_w_dot_d_C_D * alpha_sq;
    jp[29] = d_w_dot_d_C_Da;
    let C_Da = parameters[10];
    let C_D0 = parameters[9];

    // disc.hyz:86  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_Da.mul_add(alpha_sq, C_D0);
    let C_Da_two = prepared[6];
    let alpha_C_Da_two = C_Da_two * alpha;
    let alpha_air_velocity_product = alpha * air_velocity_2_inv_product;
    let d_v_dot_d_C_La = d_w_dot_d_C_D * alpha_air_velocity_product;
    jp[16] = d_v_dot_d_C_La;
    let d_gammadot_dot_d_C_Ma =
        V_sq_half_rho_A_d_inv_part * sin_theta_inv_cos_theta * alpha_air_velocity_product;
    jp[60] = d_gammadot_dot_d_C_Ma;
    let d_phidot_dot_d_C_Ma = -(V_sq_half_rho_A_d_product * alpha_air_velocity_product);
    jp[38] = d_phidot_dot_d_C_Ma;
    let part_of_minus_V_inv_m_half_rho_2 =
        nonzero_air_velocity_12.mul_sub(alpha_C_Da_two, part_of_minus_V_inv_m_half_rho);
    let part_of_d_w_dot_d_alpha =
        minus_air_velocity_3.mul_add(alpha_C_Da_two, C_La * air_velocity_12);
    let d_w_dot_d_alpha = V_inv_m_half_rho_A * part_of_d_w_dot_d_alpha;
    let air_velocity_12_C_D_sum = air_velocity_12.mul_sub(C_D, minus_air_velocity_3 * C_L);
    let part_of_inv_cos_theta_cos_2 = cos_theta_phidot_sum * air_velocity_12_two_product;
    let part_of_inv_cos_theta_cos_3 = inv_air_velocity_12_product_4
        .neg_mul_add(part_of_inv_cos_theta_cos, part_of_inv_cos_theta_cos_2);
    let part_of_d_thetadot_dot_d_air_2 = thetadot_nonzero_sum * air_velocity_12_two_product;
    let d_thetadot_dot_d_air_velocity_12 = inv_air_velocity_12_product_4
        .neg_mul_add(part_of_d_thetadot_dot_d_air, part_of_d_thetadot_dot_d_air_2);
    let cos_theta_phidot_product_2 = cos_theta_phidot_sum * V_sq_inv_I_d_d;
    let thetadot_nonzero_product = thetadot_nonzero_sum * V_sq_inv_I_d_d;
    let minus_half_rho_A_inv_I_d = prepared[19];
    let d_thetadot_dot_d_I_d =
        minus_half_rho_A_inv_I_d.mul_sub(thetadot_nonzero_product, part_of_d_thetadot_dot_d_I_d);
    jp[45] = d_thetadot_dot_d_I_d;
    let inv_cos_theta_cos_product = inv_cos_theta * part_of_inv_cos_theta_cos_3;
    let part_of_d_phidot_dot_d_u_2 =
        air_velocity_1.mul_add(inv_cos_theta_cos_product, part_of_d_phidot_dot_d_u);
    let part_of_d_phidot_dot_d_v_2 =
        air_velocity_2.mul_sub(inv_cos_theta_cos_product, part_of_d_phidot_dot_d_v);
    let d_phidot_dot_d_u = inv_air_velocity_12 * part_of_d_phidot_dot_d_u_2;
    j[36] = d_phidot_dot_d_u;
    let part_of_d_thetadot_dot_d_air_4 = air_velocity_2.mul_add(
        d_thetadot_dot_d_air_velocity_12,
        part_of_d_thetadot_dot_d_air_3,
    );
    let part_of_d_thetadot_dot_d_air_6 = air_velocity_1.mul_add(
        d_thetadot_dot_d_air_velocity_12,
        part_of_d_thetadot_dot_d_air_5,
    );
    let inv_cos_theta_cos_product_2 = inv_cos_theta * cos_theta_phidot_product_2;
    let sin_theta_inv_cos_product = sin_theta_inv_cos_theta * cos_theta_phidot_product_2;
    let rho_half = prepared[14];
    jp[47] = rho_half * thetadot_nonzero_product; // d_thetadot_dot_d_A
    let A_half = prepared[11];
    jp[48] = A_half * thetadot_nonzero_product; // d_thetadot_dot_d_rho
    let d_phidot_dot_d_v = inv_air_velocity_12 * part_of_d_phidot_dot_d_v_2;
    j[37] = d_phidot_dot_d_v;
    let d_thetadot_dot_d_air_velocity_2 = inv_air_velocity_12 * part_of_d_thetadot_dot_d_air_4;
    j[45] = d_thetadot_dot_d_air_velocity_2; // d_thetadot_dot_d_v
    let d_thetadot_dot_d_air_velocity_1 = inv_air_velocity_12 * part_of_d_thetadot_dot_d_air_6;
    j[44] = d_thetadot_dot_d_air_velocity_1; // d_thetadot_dot_d_u
    let d_cos_theta_phidot_product_d_I_d =
        half_rho_A_inv_I_d.neg_mul_add(inv_cos_theta_cos_product_2, part_of_d_cos_theta_phidot_6);
    jp[34] = d_cos_theta_phidot_product_d_I_d; // d_phidot_dot_d_I_d
    jp[36] = rho_half * inv_cos_theta_cos_product_2; // d_phidot_dot_d_A
    jp[37] = A_half * inv_cos_theta_cos_product_2; // d_phidot_dot_d_rho
    let minus_rho_half = prepared[15];
    jp[58] = minus_rho_half * sin_theta_inv_cos_product; // d_gammadot_dot_d_A
    let minus_A_half = prepared[16];
    jp[59] = minus_A_half * sin_theta_inv_cos_product; // d_gammadot_dot_d_rho
    let d_gammadot_dot_d_I_d = -(sin_theta * d_cos_theta_phidot_product_d_I_d);
    jp[56] = d_gammadot_dot_d_I_d;
    let part_of_minus_V_inv_m_half_rho_3 =
        V_inv_m_half_rho_A * part_of_minus_V_inv_m_half_rho_2 * minus_air_velocity_3_inv_V;
    let part_of_part_part_inv_V_air_sum =
        V_inv_m_half_rho_A * part_of_minus_V_inv_m_half_rho_2 * inv_V * air_velocity_12_inv_V;
    let part_of_d_w_dot_d_minus_air = d_w_dot_d_alpha * air_velocity_12_inv_V;
    let part_of_d_w_dot_d_air_velocity = d_w_dot_d_alpha * minus_air_velocity_3_inv_V;
    let inv_m_half_rho_A = prepared[0];
    let air_velocity_12_C_D_product_2 = inv_m_half_rho_A * air_velocity_12_C_D_sum;
    let part_of_minus_V_inv_m_half_rho_4 = nonzero_air_velocity_12.neg_mul_add(
        air_velocity_12_C_D_product_2,
        part_of_minus_V_inv_m_half_rho_3,
    );
    let part_of_minus_V_inv_m_half_rho_5 = inv_V * part_of_minus_V_inv_m_half_rho_4;
    let C_L_V_inv_m_half_rho_A = C_L * V_inv_m_half_rho_A;
    let part_of_part_part_inv_V_air_sum_2 = minus_air_velocity_3_inv_V
        .neg_mul_add(air_velocity_12_C_D_product_2, C_L_V_inv_m_half_rho_A);
    let part_part_inv_V_air_sum = inv_air_velocity_12.neg_mul_add(
        part_of_part_part_inv_V_air_sum_2,
        part_of_part_part_inv_V_air_sum,
    );
    let minus_air_velocity_3_C_sum = minus_air_velocity_3.mul_add(C_D, air_velocity_12 * C_L);
    let d_v_dot_d_w = air_velocity_2.mul_add(part_part_inv_V_air_sum, cos_theta_phidot);
    j[22] = d_v_dot_d_w;
    let air_velocity_12_C_D_product = air_velocity_12_C_D_sum * inv_air_velocity_12;
    let air_velocity_12_C_D_product_3 = air_velocity_12_C_D_sum * V_inv_m;
    let minus_air_velocity_product_3 = minus_air_velocity_3_C_sum * V_inv_m;
    let minus_half_rho_A_inv_m = prepared[17];
    jp[22] = minus_half_rho_A_inv_m * minus_air_velocity_product_3; // d_w_dot_d_m
    jp[23] = rho_half * minus_air_velocity_product_3; // d_w_dot_d_A
    jp[24] = A_half * minus_air_velocity_product_3; // d_w_dot_d_rho
    let minus_air_velocity_product = inv_m_half_rho_A * minus_air_velocity_3_C_sum;
    let part_of_d_w_dot_d_air_velocity_2 =
        air_velocity_12.neg_mul_add(minus_air_velocity_product, part_of_d_w_dot_d_air_velocity);
    let part_of_d_w_dot_d_minus_air_2 =
        minus_air_velocity_3.mul_add(minus_air_velocity_product, part_of_d_w_dot_d_minus_air);
    let d_w_dot_d_air_velocity_12 =
        inv_V.neg_mul_add(part_of_d_w_dot_d_air_velocity_2, C_L_V_inv_m_half_rho_A);
    let d_w_dot_d_v =
        d_w_dot_d_air_velocity_12.mul_sub(air_velocity_2_inv_product, cos_theta_phidot);
    j[27] = d_w_dot_d_v;
    let part_of_w_dot =
        V_inv_m_half_rho_A.mul_sub(minus_air_velocity_3_C_sum, cos_theta_cos_phi_g_product);

    // disc.hyz:56  velocity (u, v, w) in B;
    let w_dot = u.mul_add(thetadot, part_of_w_dot);
    dx[5] = w_dot;
    let inv_air_velocity_12_product_3 = inv_air_velocity_12 * d_w_dot_d_air_velocity_12;
    let d_w_dot_d_air_velocity_1 = d_w_dot_d_air_velocity_12 * air_velocity_1_inv_product;
    let part_of_d_w_dot_d_phi_4 = part_of_d_w_dot_d_phi_2 * inv_air_velocity_12_product_3;
    let d_w_dot_d_u = thetadot + d_w_dot_d_air_velocity_1;
    j[26] = d_w_dot_d_u;
    let part_of_minus_V_inv_m_half_rho_6 = C_D - air_velocity_12_C_D_product;
    let minus_V_inv_m_half_rho_sum = part_of_minus_V_inv_m_half_rho_7.neg_mul_add(
        part_of_minus_V_inv_m_half_rho_6,
        part_of_minus_V_inv_m_half_rho_5,
    );
    let V_inv_m_half_rho_A_product = V_inv_m_half_rho_A * air_velocity_12_C_D_product;
    let d_w_dot_d_minus_air_velocity_3 =
        inv_V.mul_add(part_of_d_w_dot_d_minus_air_2, C_D * V_inv_m_half_rho_A);
    let part_of_v_dot_2 = air_velocity_2.neg_mul_add(V_inv_m_half_rho_A_product, part_of_v_dot);
    let v_dot = part_of_v_dot_2 - sin_phi_g;
    dx[4] = v_dot;
    let part_of_d_w_dot_d_wind_z_2 =
        d_minus_air_velocity_3_d_wind_z * d_w_dot_d_minus_air_velocity_3;
    let d_w_dot_d_wind_z =
        inv_air_velocity_12_product_3.mul_add(part_of_d_w_dot_d_wind_z, part_of_d_w_dot_d_wind_z_2);
    jp[32] = d_w_dot_d_wind_z;
    let part_of_d_w_dot_d_wind_y_2 = -(cos_theta_sin_phi * d_w_dot_d_minus_air_velocity_3);
    let d_w_dot_d_wind_y = inv_air_velocity_12_product_3
        .neg_mul_add(part_of_d_w_dot_d_wind_y, part_of_d_w_dot_d_wind_y_2);
    jp[31] = d_w_dot_d_wind_y;
    let d_w_dot_d_w = -d_w_dot_d_minus_air_velocity_3;
    j[28] = d_w_dot_d_w;
    let cos_theta_part_part_product = cos_theta * part_part_inv_V_air_sum;
    let part_of_d_phidot_dot_d_theta = d_minus_air_velocity_3_d_theta * part_of_d_phidot_dot_d_w_3;
    let part_of_d_phidot_dot_d_theta_2 =
        d_air_velocity_1_d_theta.mul_add(d_phidot_dot_d_u, part_of_d_phidot_dot_d_theta);
    let d_phidot_dot_d_theta = d_cos_theta_phidot_product_d_theta + part_of_d_phidot_dot_d_theta_2;
    j[40] = d_phidot_dot_d_theta;
    let part_of_d_gammadot_dot_d_theta_2 = phidot.mul_sub(thetadot, d_phidot_dot_d_theta);
    let d_gammadot_dot_d_theta = sin_theta.mul_sub(
        part_of_d_gammadot_dot_d_theta_2,
        part_of_d_gammadot_dot_d_theta,
    );
    j[56] = d_gammadot_dot_d_theta;
    let minus_V_inv_m_half_product = minus_V_inv_m_half_rho_sum * air_velocity_1_inv_product;
    let minus_V_inv_m_half_product_2 = minus_V_inv_m_half_rho_sum * air_velocity_2_inv_product;
    let air_velocity_1_inv_product_2 = air_velocity_1_inv_product * air_velocity_12_C_D_product_3;
    let air_velocity_2_inv_product_2 = air_velocity_2_inv_product * air_velocity_12_C_D_product_3;
    let d_u_dot_d_m = inv_m_half_rho_A * air_velocity_1_inv_product_2;
    jp[0] = d_u_dot_d_m;
    jp[1] = minus_rho_half * air_velocity_1_inv_product_2; // d_u_dot_d_A
    jp[2] = minus_A_half * air_velocity_1_inv_product_2; // d_u_dot_d_rho
    let d_v_dot_d_m = inv_m_half_rho_A * air_velocity_2_inv_product_2;
    jp[11] = d_v_dot_d_m;
    jp[12] = minus_rho_half * air_velocity_2_inv_product_2; // d_v_dot_d_A
    jp[13] = minus_A_half * air_velocity_2_inv_product_2; // d_v_dot_d_rho
    let sin_theta_d_phidot_dot_d_u = sin_theta * d_phidot_dot_d_u;
    let d_gammadot_dot_d_u = -sin_theta_d_phidot_dot_d_u;
    j[52] = d_gammadot_dot_d_u;
    let sin_theta_d_phidot_dot_sum =
        cos_theta.mul_add(part_of_d_phidot_dot_d_w_3, sin_theta_d_phidot_dot_d_u);
    let d_gammadot_dot_d_w = sin_theta * part_of_d_phidot_dot_d_w_3;
    j[54] = d_gammadot_dot_d_w;
    let d_phidot_dot_d_wind_x = cos_theta.neg_mul_add(d_phidot_dot_d_u, d_gammadot_dot_d_w);
    jp[41] = d_phidot_dot_d_wind_x;
    let d_gammadot_dot_d_wind_x = -(sin_theta * d_phidot_dot_d_wind_x);
    jp[64] = d_gammadot_dot_d_wind_x;
    let part_of_d_u_dot_d_phi = d_minus_sin_phi_wind_y_sum_d_phi * cos_theta_part_part_product;
    let part_of_d_u_dot_d_phi_2 =
        sin_phi_wind_y_sum.neg_mul_add(minus_V_inv_m_half_product_2, part_of_d_u_dot_d_phi);
    let d_v_dot_d_air_velocity_2 =
        air_velocity_2.mul_sub(minus_V_inv_m_half_product_2, V_inv_m_half_rho_A_product);
    j[21] = d_v_dot_d_air_velocity_2; // d_v_dot_d_v
    let part_of_d_u_dot_d_phi_4 = air_velocity_1 * part_of_d_u_dot_d_phi_2;
    let part_of_d_v_dot_d_phi = sin_phi_wind_y_sum.mul_sub(d_v_dot_d_air_velocity_2, cos_phi_g);
    let d_u_dot_d_air_velocity_1 =
        air_velocity_1.mul_sub(minus_V_inv_m_half_product, V_inv_m_half_rho_A_product);
    j[13] = d_u_dot_d_air_velocity_1; // d_u_dot_d_u
    let part_of_u_dot =
        air_velocity_1.neg_mul_add(V_inv_m_half_rho_A_product, sin_theta_cos_phi_g_product);
    let u_dot = w.neg_mul_add(thetadot, part_of_u_dot);
    dx[3] = u_dot;
    let part_of_d_w_dot_d_theta =
        d_air_velocity_1_d_theta.mul_add(d_w_dot_d_air_velocity_1, sin_theta_cos_phi_g_product);
    let d_w_dot_d_theta = d_minus_air_velocity_3_d_theta
        .mul_add(d_w_dot_d_minus_air_velocity_3, part_of_d_w_dot_d_theta);
    j[30] = d_w_dot_d_theta;
    let part_of_d_u_dot_d_theta =
        d_u_dot_d_air_velocity_1.mul_add(d_air_velocity_1_d_theta, cos_theta_cos_phi_g_product);
    let part_of_d_phidot_dot_d_phi = sin_phi_wind_y_sum * d_phidot_dot_d_v;
    let part_of_d_thetadot_dot_d_phi = sin_phi_wind_y_sum * d_thetadot_dot_d_air_velocity_2;
    let d_phidot_dot_d_phi = d_minus_sin_phi_wind_y_sum_d_phi
        .mul_add(sin_theta_d_phidot_dot_sum, part_of_d_phidot_dot_d_phi);
    j[39] = d_phidot_dot_d_phi;
    let d_gammadot_dot_d_phi = -(sin_theta * d_phidot_dot_d_phi);
    j[55] = d_gammadot_dot_d_phi;
    let part_of_d_v_dot_d_wind_x = -(cos_theta * minus_V_inv_m_half_product);
    let part_of_d_v_dot_d_wind_x_2 =
        sin_theta.neg_mul_add(part_part_inv_V_air_sum, part_of_d_v_dot_d_wind_x);
    let d_v_dot_d_wind_x = air_velocity_2 * part_of_d_v_dot_d_wind_x_2;
    jp[19] = d_v_dot_d_wind_x;
    let d_phidot_dot_d_wind_z =
        cos_phi.mul_sub(sin_theta_d_phidot_dot_sum, sin_phi * d_phidot_dot_d_v);
    jp[43] = d_phidot_dot_d_wind_z;
    let d_gammadot_dot_d_wind_z = -(sin_theta * d_phidot_dot_d_wind_z);
    jp[66] = d_gammadot_dot_d_wind_z;
    let minus_sin_theta_minus_V_sum =
        sin_theta.neg_mul_add(minus_V_inv_m_half_product, cos_theta_part_part_product);
    let d_v_dot_d_phi =
        minus_sin_theta_minus_V_sum.neg_mul_add(part_of_d_v_dot_d_phi_2, part_of_d_v_dot_d_phi);
    j[23] = d_v_dot_d_phi;
    let part_of_sin_theta_d_u_dot_d_sum = air_velocity_1 * cos_theta_part_part_product;
    let air_velocity_1_part_product = air_velocity_1 * part_part_inv_V_air_sum;
    let d_u_dot_d_theta = air_velocity_1_part_product
        .neg_mul_add(d_minus_air_velocity_3_d_theta, part_of_d_u_dot_d_theta);
    j[17] = d_u_dot_d_theta;
    let d_u_dot_d_w = air_velocity_1_part_product - thetadot;
    j[15] = d_u_dot_d_w;
    let sin_theta_d_u_dot_d_sum =
        sin_theta.mul_sub(d_u_dot_d_air_velocity_1, part_of_sin_theta_d_u_dot_d_sum);
    let part_of_d_v_dot_d_theta = part_part_inv_V_air_sum * d_minus_air_velocity_3_d_theta;
    let part_of_d_thetadot_dot_d_theta_3 = d_minus_air_velocity_3_d_theta * air_velocity_1_C_Ma_sum;
    let part_of_d_v_dot_d_theta_2 =
        d_air_velocity_1_d_theta.mul_sub(minus_V_inv_m_half_product, part_of_d_v_dot_d_theta);
    let d_v_dot_d_theta = air_velocity_2.mul_sub(part_of_d_v_dot_d_theta_2, x_dot * phidot);
    j[24] = d_v_dot_d_theta;
    let part_of_d_thetadot_dot_d_theta_4 = d_air_velocity_1_d_theta.mul_add(
        d_thetadot_dot_d_air_velocity_1,
        part_of_d_thetadot_dot_d_theta_3,
    );
    let d_thetadot_dot_d_theta = phidot.mul_add(
        part_of_d_thetadot_dot_d_theta_2,
        part_of_d_thetadot_dot_d_theta_4,
    );
    j[48] = d_thetadot_dot_d_theta;
    let air_velocity_2_product = air_velocity_2 * minus_V_inv_m_half_product;
    let d_u_dot_d_v = sin_theta_phidot + air_velocity_2_product;
    j[14] = d_u_dot_d_v;
    let d_v_dot_d_u = air_velocity_2_product - sin_theta_phidot;
    j[20] = d_v_dot_d_u;
    let part_of_sin_theta_d_product_sum = cos_theta * air_velocity_1_C_Ma_sum;
    let part_of_d_thetadot_dot_d_wind_x = sin_theta * air_velocity_1_C_Ma_sum;
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
    let minus_d_phidot_dot_d_wind_y =
        sin_phi.mul_add(sin_theta_d_phidot_dot_sum, cos_phi * d_phidot_dot_d_v);
    let d_gammadot_dot_d_v = -(sin_theta * d_phidot_dot_d_v);
    j[53] = d_gammadot_dot_d_v;
    let d_gammadot_dot_d_wind_y = sin_theta * minus_d_phidot_dot_d_wind_y;
    jp[65] = d_gammadot_dot_d_wind_y;
    let d_phidot_dot_d_wind_y = -minus_d_phidot_dot_d_wind_y;
    jp[42] = d_phidot_dot_d_wind_y;
    let part_of_d_u_dot_d_phi_3 =
        d_u_dot_d_air_velocity_1.mul_sub(d_minus_sin_phi_wind_y_sum_d_phi, sin_phi_g);
    let d_u_dot_d_phi = sin_theta.mul_sub(part_of_d_u_dot_d_phi_3, part_of_d_u_dot_d_phi_4);
    j[16] = d_u_dot_d_phi;
    let part_of_d_w_dot_d_phi_3 =
        d_minus_sin_phi_wind_y_sum_d_phi.mul_add(d_w_dot_d_minus_air_velocity_3, sin_phi_g);
    let d_w_dot_d_phi = cos_theta.mul_add(part_of_d_w_dot_d_phi_3, part_of_d_w_dot_d_phi_4);
    j[29] = d_w_dot_d_phi;
    let part_of_d_w_dot_d_wind_x = sin_theta * d_w_dot_d_minus_air_velocity_3;
    let part_of_d_u_dot_d_wind_z = sin_phi_air_velocity_2 * minus_V_inv_m_half_product;
    let part_of_d_v_dot_d_wind_y = minus_sin_theta_minus_V_sum * sin_phi_air_velocity_2;
    let part_of_d_thetadot_dot_d_wind_z = sin_phi * d_thetadot_dot_d_air_velocity_2;
    let part_of_d_u_dot_d_wind_x = -(cos_theta * d_u_dot_d_air_velocity_1);
    let part_of_d_u_dot_d_wind_y = -(cos_phi_air_velocity_2 * minus_V_inv_m_half_product);
    let part_of_d_v_dot_d_wind_z = -(sin_phi * d_v_dot_d_air_velocity_2);
    let part_of_d_thetadot_dot_d_wind_y = -(cos_phi * d_thetadot_dot_d_air_velocity_2);
    let d_u_dot_d_wind_x =
        part_part_inv_V_air_sum.neg_mul_add(sin_theta_air_velocity_1, part_of_d_u_dot_d_wind_x);
    jp[8] = d_u_dot_d_wind_x;
    let d_v_dot_d_wind_z =
        minus_sin_theta_minus_V_sum.neg_mul_add(cos_phi_air_velocity_2, part_of_d_v_dot_d_wind_z);
    jp[21] = d_v_dot_d_wind_z;
    let d_w_dot_d_wind_x =
        cos_theta.neg_mul_add(d_w_dot_d_air_velocity_1, part_of_d_w_dot_d_wind_x);
    jp[30] = d_w_dot_d_wind_x;
    let d_v_dot_d_wind_y = cos_phi.neg_mul_add(d_v_dot_d_air_velocity_2, part_of_d_v_dot_d_wind_y);
    jp[20] = d_v_dot_d_wind_y;
    let d_u_dot_d_wind_y = sin_phi.neg_mul_add(sin_theta_d_u_dot_d_sum, part_of_d_u_dot_d_wind_y);
    jp[9] = d_u_dot_d_wind_y;
    let d_u_dot_d_wind_z = cos_phi.mul_sub(sin_theta_d_u_dot_d_sum, part_of_d_u_dot_d_wind_z);
    jp[10] = d_u_dot_d_wind_z;
    let d_thetadot_dot_d_wind_y =
        sin_phi.neg_mul_add(sin_theta_d_product_sum, part_of_d_thetadot_dot_d_wind_y);
    jp[53] = d_thetadot_dot_d_wind_y;
    let d_thetadot_dot_d_wind_z =
        cos_phi.mul_sub(sin_theta_d_product_sum, part_of_d_thetadot_dot_d_wind_z);
    jp[54] = d_thetadot_dot_d_wind_z;

    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
}
