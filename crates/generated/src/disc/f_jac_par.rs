// Written by `hyzer generate`; changes belong in the model.
//! `disc`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 486 operations: 128 add, 313 mul, 3 div, 34 neg, 2 sqrt, 5 call, 1 select.
#[inline(always)]
pub fn f_jac_par<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 26],
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
    let g = parameters[6];
    let C_L0 = parameters[7];
    let C_La = parameters[8];
    let C_D0 = parameters[9];
    let C_Da = parameters[10];
    let C_Ma = parameters[11];
    let C_Mq = parameters[12];
    let C_Rr = parameters[13];
    let wind_x = parameters[15];
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let inv_p0_half_p5_p4 = prepared[0];
    let half_p5_p4_p3_inv_p2 = prepared[2];
    let inv_p2_p1 = prepared[3];
    let p14_inv_p1 = prepared[4];
    let p10_two = prepared[5];
    let two_p3_part_part_half_inv_p2 = prepared[6];
    let p4_half = prepared[7];
    let p5_p4_half = prepared[8];
    let inv_p0 = prepared[9];
    let inv_p2 = prepared[10];
    let inv_p1 = prepared[11];
    let p5_half = prepared[12];
    let minus_p5_half = prepared[13];
    let minus_p4_half = prepared[14];
    let minus_p5_p4_half_inv_p0 = prepared[15];
    let p5_p4_half_p3 = prepared[16];
    let inv_p2_sq = prepared[17];
    let p5_p4_half_inv_p2 = prepared[18];
    let inv_p2_p3_p5_half = prepared[19];
    let inv_p2_p3_p4_half = prepared[20];
    let minus_inv_p2_p5_part_sum = prepared[21];
    let inv_p1_d_gammadot_dot_d_r = prepared[22];
    let minus_p5_p4_half_inv_p2 = prepared[23];
    let minus_inv_p2_p3_p5_half = prepared[24];
    let minus_inv_p2_p3_p4_half = prepared[25];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // disc.hyz:55  position (x, y, z) in N;
    let x_dot = u * cos_theta + w * sin_theta;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let cos_theta_w_minus_u_sin_sum = cos_theta * w - u * sin_theta;
    let y_dot = v * cos_phi - sin_phi * cos_theta_w_minus_u_sin_sum;
    let z_dot = cos_phi * cos_theta_w_minus_u_sin_sum + v * sin_phi;
    let cos_phi_g = g * cos_phi;
    let v_phidot_plus_cos_phi_g = v * phidot + cos_phi_g;
    let sin_theta_v_phidot_product = sin_theta * v_phidot_plus_cos_phi_g;
    let cos_phi_wind_z_minus_sum = wind_z * cos_phi - wind_y * sin_phi;
    let minus_cos_theta_wind_x_sum = sin_theta * cos_phi_wind_z_minus_sum - wind_x * cos_theta;

    // disc.hyz:62  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u + minus_cos_theta_wind_x_sum;
    let cos_phi_wind_y_plus_sin_sum = wind_y * cos_phi + wind_z * sin_phi;
    let air_velocity_2 = v - cos_phi_wind_y_plus_sin_sum;
    let air_velocity_1_sq_plus_sum =
        air_velocity_1 * air_velocity_1 + air_velocity_2 * air_velocity_2;
    let cos_theta_cos_phi_sum = cos_theta * cos_phi_wind_z_minus_sum + wind_x * sin_theta;
    let minus_w_plus_cos_theta_sum = cos_theta_cos_phi_sum - w;
    let air_velocity_1_sq_plus_sum_2 =
        air_velocity_1_sq_plus_sum + minus_w_plus_cos_theta_sum * minus_w_plus_cos_theta_sum;

    // disc.hyz:64  let V = norm(air_velocity);
    let V = air_velocity_1_sq_plus_sum_2.sqrt();
    let V_inv_m = inv_p0 * V;
    let rho_A_half_V_inv_m = p5_p4_half * V_inv_m;
    let sqrt_air_velocity_1_sq_of = air_velocity_1_sq_plus_sum.sqrt();

    // disc.hyz:69  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_w_plus_cos_theta_sum.atan2(sqrt_air_velocity_1_sq_of);

    // disc.hyz:72  let C_L = C_L0 + C_La*alpha;
    let C_L = C_L0 + C_La * alpha;
    let alpha_sq = alpha * alpha;

    // disc.hyz:73  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_D0 + C_Da * alpha_sq;
    let minus_minus_w_plus_cos_sum =
        sqrt_air_velocity_1_sq_of * C_D - minus_w_plus_cos_theta_sum * C_L;
    let inv_sqrt_air_velocity_1_of = sqrt_air_velocity_1_sq_of.recip_or_zero();
    let minus_minus_w_plus_product = minus_minus_w_plus_cos_sum * inv_sqrt_air_velocity_1_of;
    let rho_A_half_V_inv_m_product = rho_A_half_V_inv_m * minus_minus_w_plus_product;
    let part_of_u_dot = sin_theta_v_phidot_product - air_velocity_1 * rho_A_half_V_inv_m_product;

    // disc.hyz:56  velocity (u, v, w) in B;
    let u_dot = part_of_u_dot - w * thetadot;
    let sin_phi_g = g * sin_phi;
    let part_of_v_dot =
        cos_theta_w_minus_u_sin_sum * phidot - air_velocity_2 * rho_A_half_V_inv_m_product;
    let v_dot = part_of_v_dot - sin_phi_g;
    let cos_theta_v_phidot_product = cos_theta * v_phidot_plus_cos_phi_g;
    let sqrt_air_velocity_1_sum =
        sqrt_air_velocity_1_sq_of * C_L + minus_w_plus_cos_theta_sum * C_D;
    let part_of_w_dot = rho_A_half_V_inv_m * sqrt_air_velocity_1_sum - cos_theta_v_phidot_product;
    let w_dot = part_of_w_dot + u * thetadot;
    let sin_theta_phidot = sin_theta * phidot;

    // disc.hyz:78  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let r_I_a_inv_I_d = inv_p2_p1 * r;
    let r_I_a_inv_I_d_minus_sin_sum = r_I_a_inv_I_d - T::splat(2.0) * sin_theta_phidot;
    let air_velocity_1_sq_product = half_p5_p4_p3_inv_p2 * air_velocity_1_sq_plus_sum_2;
    let alpha_C_Ma = C_Ma * alpha;
    let r_C_Rr = C_Rr * r;
    let inv_sqrt_air_product =
        inv_sqrt_air_velocity_1_of * (air_velocity_1 * r_C_Rr - air_velocity_2 * alpha_C_Ma);
    let nonzero_sqrt_air_of = sqrt_air_velocity_1_sq_of.if_zero(T::splat(0.0), T::splat(1.0));
    let C_Mq_nonzero_sqrt_air_of = C_Mq * nonzero_sqrt_air_of;
    let cos_theta_phidot = cos_theta * phidot;
    let inv_sqrt_air_product_sum =
        inv_sqrt_air_product + C_Mq_nonzero_sqrt_air_of * cos_theta_phidot;
    let part_of_minus_thetadot_r_I_product = air_velocity_1_sq_product * inv_sqrt_air_product_sum;
    let part_of_minus_thetadot_r_I_product_2 =
        part_of_minus_thetadot_r_I_product - thetadot * r_I_a_inv_I_d_minus_sin_sum;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let minus_thetadot_r_I_product = part_of_minus_thetadot_r_I_product_2 * inv_cos_theta;
    let inv_sqrt_air_product_2 =
        inv_sqrt_air_velocity_1_of * (air_velocity_1 * alpha_C_Ma + air_velocity_2 * r_C_Rr);
    let inv_sqrt_air_product_2_sum = inv_sqrt_air_product_2 + thetadot * C_Mq_nonzero_sqrt_air_of;
    let part_of_thetadot_dot = air_velocity_1_sq_product * inv_sqrt_air_product_2_sum;
    let sin_theta_phidot_minus_sum = sin_theta_phidot - r_I_a_inv_I_d;

    // disc.hyz:48  frame B = A turned theta about 2; // does not spin with the disc
    let thetadot_dot = part_of_thetadot_dot - cos_theta_phidot * sin_theta_phidot_minus_sum;

    // disc.hyz:49  frame C = B turned gamma about 3; // fixed in the disc
    let gammadot_dot =
        p14_inv_p1 * r - thetadot * cos_theta_phidot - sin_theta * minus_thetadot_r_I_product;
    let cos_theta_sin_phi = cos_theta * sin_phi;
    let sin_theta_cos_phi = sin_theta * cos_phi;
    let cos_theta_cos_phi = cos_theta * cos_phi;
    let inv_V = V.recip_or_zero();
    let inv_V_rho_part_part_inv_m = inv_p0_half_p5_p4 * inv_V;
    let C_La_minus_w_plus_product = C_La * minus_w_plus_cos_theta_sum * inv_sqrt_air_velocity_1_of;
    let alpha_C_Da_two = p10_two * alpha;
    let part_of_minus_minus_minus_w_sum =
        C_La_minus_w_plus_product - nonzero_sqrt_air_of * alpha_C_Da_two;
    let inv_V_sq = inv_V * inv_V;
    let minus_w_plus_cos_product = minus_w_plus_cos_theta_sum * inv_V_sq;
    let part_of_minus_minus_minus_w_sum_3 =
        part_of_minus_minus_minus_w_sum * minus_w_plus_cos_product;
    let part_of_minus_minus_minus_w_sum_2 =
        inv_sqrt_air_velocity_1_of * (C_D - minus_minus_w_plus_product);
    let part_of_minus_minus_minus_w_sum_4 =
        part_of_minus_minus_minus_w_sum_3 + part_of_minus_minus_minus_w_sum_2;
    let part_of_minus_minus_minus_w_sum_5 =
        -(minus_minus_w_plus_cos_sum * inv_V_rho_part_part_inv_m);
    let minus_minus_minus_w_sum =
        part_of_minus_minus_minus_w_sum_5 - rho_A_half_V_inv_m * part_of_minus_minus_minus_w_sum_4;
    let air_velocity_1_inv_product = air_velocity_1 * inv_sqrt_air_velocity_1_of;
    let minus_minus_minus_w_product = minus_minus_minus_w_sum * air_velocity_1_inv_product;
    let minus_rho_A_half_V_inv_sum =
        air_velocity_1 * minus_minus_minus_w_product - rho_A_half_V_inv_m_product;
    let air_velocity_2_product = air_velocity_2 * minus_minus_minus_w_product;
    let minus_w_plus_cos_product_2 = minus_w_plus_cos_theta_sum * inv_V_rho_part_part_inv_m;
    let part_of_minus_minus_w_plus_sum_3 = minus_minus_w_plus_product * minus_w_plus_cos_product_2;
    let part_of_minus_minus_w_plus_sum =
        sqrt_air_velocity_1_sq_of * (alpha_C_Da_two - C_La_minus_w_plus_product);
    let part_of_minus_minus_w_plus_sum_2 =
        part_of_minus_minus_w_plus_sum * inv_V_sq - C_L * inv_sqrt_air_velocity_1_of;
    let minus_minus_w_plus_sum =
        part_of_minus_minus_w_plus_sum_3 + rho_A_half_V_inv_m * part_of_minus_minus_w_plus_sum_2;
    let air_velocity_1_product = air_velocity_1 * minus_minus_w_plus_sum;
    let minus_minus_rho_A_half_sum = -minus_rho_A_half_V_inv_sum;
    let part_of_d_u_dot_d_phi =
        minus_minus_rho_A_half_sum * cos_phi_wind_y_plus_sin_sum - sin_phi_g;
    let cos_theta_minus_product = cos_theta * minus_minus_w_plus_sum;
    let air_velocity_2_inv_product = air_velocity_2 * inv_sqrt_air_velocity_1_of;
    let minus_minus_minus_w_product_2 = minus_minus_minus_w_sum * air_velocity_2_inv_product;
    let part_of_d_u_dot_d_phi_2 = cos_phi_wind_z_minus_sum * minus_minus_minus_w_product_2;
    let part_of_d_u_dot_d_phi_3 =
        part_of_d_u_dot_d_phi_2 - cos_phi_wind_y_plus_sin_sum * cos_theta_minus_product;
    let part_of_d_u_dot_d_phi_4 =
        sin_theta * part_of_d_u_dot_d_phi - air_velocity_1 * part_of_d_u_dot_d_phi_3;
    let part_of_d_u_dot_d_theta =
        cos_theta_v_phidot_product - minus_minus_rho_A_half_sum * cos_theta_cos_phi_sum;
    let part_of_d_u_dot_d_theta_2 =
        part_of_d_u_dot_d_theta + air_velocity_1_product * minus_cos_theta_wind_x_sum;
    let minus_rho_A_half_V_inv_sum_2 =
        air_velocity_2 * minus_minus_minus_w_product_2 - rho_A_half_V_inv_m_product;
    let minus_minus_rho_A_half_sum_2 = -minus_rho_A_half_V_inv_sum_2;
    let sin_theta_minus_product_sum =
        sin_theta * minus_minus_minus_w_product - cos_theta_minus_product;
    let part_of_d_v_dot_d_phi =
        air_velocity_2 * cos_phi_wind_y_plus_sin_sum * sin_theta_minus_product_sum;
    let part_of_d_v_dot_d_phi_2 =
        cos_phi_wind_z_minus_sum * minus_minus_rho_A_half_sum_2 - cos_phi_g;
    let part_of_d_v_dot_d_theta = minus_minus_w_plus_sum * minus_cos_theta_wind_x_sum;
    let part_of_d_v_dot_d_theta_2 =
        cos_theta_cos_phi_sum * minus_minus_minus_w_product + part_of_d_v_dot_d_theta;
    let part_of_sqrt_air_velocity_1_sum_2 =
        sqrt_air_velocity_1_sq_of * sqrt_air_velocity_1_sum * inv_V_rho_part_part_inv_m;
    let C_La_sqrt_air_product_sum =
        C_La * sqrt_air_velocity_1_sq_of + minus_w_plus_cos_theta_sum * alpha_C_Da_two;
    let part_of_sqrt_air_velocity_1_sum_2_2 =
        rho_A_half_V_inv_m * (C_L - C_La_sqrt_air_product_sum * minus_w_plus_cos_product);
    let sqrt_air_velocity_1_sum_2 =
        part_of_sqrt_air_velocity_1_sum_2 + part_of_sqrt_air_velocity_1_sum_2_2;
    let sqrt_air_velocity_1_product = sqrt_air_velocity_1_sum_2 * air_velocity_1_inv_product;
    let part_of_d_w_dot_d_v =
        sqrt_air_velocity_1_sum_2 * air_velocity_2_inv_product - cos_theta_phidot;
    let d_w_dot_d_C_L = sqrt_air_velocity_1_sq_of * rho_A_half_V_inv_m;
    let part_of_C_D_rho_A_half_V_inv_m_sum = C_La_sqrt_air_product_sum * d_w_dot_d_C_L * inv_V_sq;
    let part_of_C_D_rho_A_half_V_inv_m_sum_2 =
        sqrt_air_velocity_1_sum * minus_w_plus_cos_product_2 + part_of_C_D_rho_A_half_V_inv_m_sum;
    let C_D_rho_A_half_V_inv_m_sum =
        C_D * rho_A_half_V_inv_m + part_of_C_D_rho_A_half_V_inv_m_sum_2;
    let sin_theta_air_velocity_1 = sin_theta * air_velocity_1;
    let part_of_d_w_dot_d_phi = cos_phi_wind_y_plus_sin_sum * sin_theta_air_velocity_1;
    let part_of_d_w_dot_d_phi_2 = part_of_d_w_dot_d_phi + air_velocity_2 * cos_phi_wind_z_minus_sum;
    let inv_sqrt_air_product_3 = inv_sqrt_air_velocity_1_of * sqrt_air_velocity_1_sum_2;
    let part_of_d_w_dot_d_phi_3 =
        sin_phi_g - cos_phi_wind_y_plus_sin_sum * C_D_rho_A_half_V_inv_m_sum;
    let part_of_d_w_dot_d_phi_4 =
        cos_theta * part_of_d_w_dot_d_phi_3 - part_of_d_w_dot_d_phi_2 * inv_sqrt_air_product_3;
    let part_of_d_w_dot_d_theta =
        sin_theta_v_phidot_product + cos_theta_cos_phi_sum * sqrt_air_velocity_1_product;
    let part_of_d_w_dot_d_theta_2 =
        part_of_d_w_dot_d_theta - minus_cos_theta_wind_x_sum * C_D_rho_A_half_V_inv_m_sum;
    let inv_sqrt_air_product_4 = two_p3_part_part_half_inv_p2 * inv_sqrt_air_product_sum;
    let air_velocity_2_C_Ma = C_Ma * air_velocity_2;
    let inv_sqrt_air_product_sum_2 =
        inv_sqrt_air_product - minus_w_plus_cos_product * air_velocity_2_C_Ma;
    let inv_sqrt_air_product_5 = inv_sqrt_air_velocity_1_of * air_velocity_1_sq_product;
    let part_of_air_velocity_1_inv_sum =
        inv_sqrt_air_product_sum_2 * air_velocity_1_inv_product * inv_sqrt_air_product_5;
    let d_thetadot_dot_d_air_velocity_2 = r_C_Rr * inv_sqrt_air_product_5;
    let part_of_air_velocity_1_inv_sum_2 =
        part_of_air_velocity_1_inv_sum - d_thetadot_dot_d_air_velocity_2;
    let air_velocity_1_inv_sum =
        air_velocity_1 * inv_sqrt_air_product_4 - part_of_air_velocity_1_inv_sum_2;
    let inv_cos_theta_air_product = inv_cos_theta * air_velocity_1_inv_sum;
    let d_thetadot_dot_d_air_velocity_1 = alpha_C_Ma * inv_sqrt_air_product_5;
    let inv_sqrt_air_product_6 = inv_sqrt_air_velocity_1_of * inv_sqrt_air_product_5;
    let part_of_d_thetadot_dot_d_air_sum =
        inv_sqrt_air_product_sum_2 * inv_sqrt_air_product_6 - inv_sqrt_air_product_4;
    let d_thetadot_dot_d_air_sum =
        d_thetadot_dot_d_air_velocity_1 + air_velocity_2 * part_of_d_thetadot_dot_d_air_sum;
    let inv_cos_theta_d_product = inv_cos_theta * d_thetadot_dot_d_air_sum;
    let air_velocity_1_sq_product_2 = air_velocity_1_sq_product * inv_V_sq;
    let part_of_air_velocity_2_C_Ma_sum = minus_w_plus_cos_theta_sum * inv_sqrt_air_product_4;
    let air_velocity_2_C_Ma_sum =
        air_velocity_2_C_Ma * air_velocity_1_sq_product_2 - part_of_air_velocity_2_C_Ma_sum;
    let inv_cos_theta_air_product_2 = inv_cos_theta * air_velocity_2_C_Ma_sum;
    let part_of_cos_phi_wind_y_plus_sum_3 = cos_phi_wind_y_plus_sin_sum * air_velocity_2_C_Ma_sum;
    let part_of_cos_phi_wind_y_plus_sum =
        sin_theta * cos_phi_wind_y_plus_sin_sum * air_velocity_1_inv_sum;
    let part_of_cos_phi_wind_y_plus_sum_2 =
        part_of_cos_phi_wind_y_plus_sum - cos_phi_wind_z_minus_sum * d_thetadot_dot_d_air_sum;
    let cos_phi_wind_y_plus_sum =
        part_of_cos_phi_wind_y_plus_sum_3 - inv_cos_theta * part_of_cos_phi_wind_y_plus_sum_2;
    let air_velocity_1_sq_product_3 = air_velocity_1_sq_product * air_velocity_1_inv_product;
    let minus_thetadot_I_a_inv_sum = C_Rr * air_velocity_1_sq_product_3 - inv_p2_p1 * thetadot;
    let air_velocity_1_sq_product_4 = air_velocity_1_sq_product * C_Mq_nonzero_sqrt_air_of;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let part_of_phidot_part_minus_part_sum =
        minus_thetadot_I_a_inv_sum - air_velocity_1_sq_product_4 * sin_theta_inv_cos_theta;
    let phidot_thetadot = phidot * thetadot;
    let part_of_phidot_part_minus_part_sum_2 =
        minus_thetadot_r_I_product * sin_theta_inv_cos_theta + T::splat(2.0) * phidot_thetadot;
    let part_of_phidot_part_minus_part_sum_3 =
        phidot * part_of_phidot_part_minus_part_sum + part_of_phidot_part_minus_part_sum_2;
    let part_of_phidot_part_minus_part_sum_4 =
        minus_cos_theta_wind_x_sum * inv_cos_theta_air_product_2;
    let part_of_phidot_part_minus_part_sum_5 =
        cos_theta_cos_phi_sum * inv_cos_theta_air_product + part_of_phidot_part_minus_part_sum_4;
    let phidot_part_minus_part_sum =
        part_of_phidot_part_minus_part_sum_3 + part_of_phidot_part_minus_part_sum_5;
    let minus_thetadot_I_a_product = minus_thetadot_I_a_inv_sum * sin_theta_inv_cos_theta;
    let thetadot_sin_theta_product = thetadot * sin_theta_inv_cos_theta;
    let part_of_minus_thetadot_I_a_sum = minus_thetadot_I_a_product + air_velocity_1_sq_product_4;
    let minus_thetadot_I_a_sum =
        part_of_minus_thetadot_I_a_sum + T::splat(2.0) * thetadot_sin_theta_product;
    let air_velocity_1_C_Ma = C_Ma * air_velocity_1;
    let part_of_inv_sqrt_air_product_sum_3 =
        inv_sqrt_air_product_2 + minus_w_plus_cos_product * air_velocity_1_C_Ma;
    let inv_sqrt_air_product_7 = two_p3_part_part_half_inv_p2 * inv_sqrt_air_product_2_sum;
    let inv_sqrt_air_product_sum_3 =
        part_of_inv_sqrt_air_product_sum_3 * inv_sqrt_air_product_6 - inv_sqrt_air_product_7;
    let d_thetadot_dot_d_air_sum_2 =
        d_thetadot_dot_d_air_velocity_1 - air_velocity_1 * inv_sqrt_air_product_sum_3;
    let minus_d_thetadot_dot_d_sum =
        air_velocity_2 * inv_sqrt_air_product_sum_3 - d_thetadot_dot_d_air_velocity_2;
    let part_of_air_velocity_1_C_Ma_sum = minus_w_plus_cos_theta_sum * inv_sqrt_air_product_7;
    let air_velocity_1_C_Ma_sum =
        air_velocity_1_C_Ma * air_velocity_1_sq_product_2 + part_of_air_velocity_1_C_Ma_sum;
    let sin_theta_d_product_sum =
        sin_theta * d_thetadot_dot_d_air_sum_2 + cos_theta * air_velocity_1_C_Ma_sum;
    let part_of_d_thetadot_dot_d_phi = cos_phi_wind_y_plus_sin_sum * sin_theta_d_product_sum;
    let part_of_d_thetadot_dot_d_phi_2 =
        cos_phi_wind_z_minus_sum * minus_d_thetadot_dot_d_sum - part_of_d_thetadot_dot_d_phi;
    let part_of_d_thetadot_dot_d_theta_2 = minus_cos_theta_wind_x_sum * air_velocity_1_C_Ma_sum;
    let air_velocity_1_sq_product_5 = air_velocity_1_sq_product * air_velocity_2_inv_product;
    let cos_theta_phidot_I_a_inv_I_d = inv_p2_p1 * cos_theta_phidot;
    let C_Rr_air_velocity_1_sum = C_Rr * air_velocity_1_sq_product_5 + cos_theta_phidot_I_a_inv_I_d;
    let minus_cos_theta_phidot_sum = C_Rr_air_velocity_1_sum - cos_theta_phidot;
    let part_of_d_thetadot_dot_d_theta =
        sin_theta * sin_theta_phidot_minus_sum + cos_theta * minus_cos_theta_phidot_sum;
    let part_of_d_thetadot_dot_d_theta_3 =
        cos_theta_cos_phi_sum * d_thetadot_dot_d_air_sum_2 - part_of_d_thetadot_dot_d_theta_2;
    let part_of_d_thetadot_dot_d_theta_4 =
        part_of_d_thetadot_dot_d_theta_3 + phidot * part_of_d_thetadot_dot_d_theta;
    let part_of_d_thetadot_dot_d_phidot =
        sin_theta * minus_cos_theta_phidot_sum - cos_theta * sin_theta_phidot_minus_sum;
    let air_velocity_1_inv_product_2 = air_velocity_1_inv_sum * sin_theta_inv_cos_theta;
    let air_velocity_2_C_Ma_product = air_velocity_2_C_Ma_sum * sin_theta_inv_cos_theta;
    let minus_cos_phi_wind_y_sum = -cos_phi_wind_y_plus_sum;
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * (minus_thetadot_r_I_product - p14_inv_p1 * phidot);
    let part_of_d_gammadot_dot_d_theta_2 =
        sin_theta * (phidot_thetadot - phidot_part_minus_part_sum) - part_of_d_gammadot_dot_d_theta;
    let part_of_d_gammadot_dot_d_phidot =
        sin_theta * (p14_inv_p1 - minus_thetadot_I_a_sum) - cos_theta * thetadot;
    let part_of_d_gammadot_dot_d_thetadot =
        r_I_a_inv_I_d_minus_sin_sum * sin_theta_inv_cos_theta - cos_theta_phidot;
    let minus_minus_w_plus_product_2 = minus_minus_w_plus_cos_sum * V_inv_m;
    let air_velocity_1_inv_product_3 = air_velocity_1_inv_product * minus_minus_w_plus_product_2;
    let d_w_dot_d_C_D = minus_w_plus_cos_theta_sum * rho_A_half_V_inv_m;
    let alpha_d_w_dot_d_C_D = alpha * d_w_dot_d_C_D;
    let air_velocity_1_rho_product = air_velocity_1 * rho_A_half_V_inv_m;
    let part_of_d_u_dot_d_wind_x =
        cos_theta * minus_minus_rho_A_half_sum - minus_minus_w_plus_sum * sin_theta_air_velocity_1;
    let cos_phi_air_velocity_2 = cos_phi * air_velocity_2;
    let part_of_d_u_dot_d_wind_y = cos_phi_air_velocity_2 * minus_minus_minus_w_product;
    let sin_theta_minus_product_sum_2 =
        sin_theta * minus_minus_rho_A_half_sum + air_velocity_1 * cos_theta_minus_product;
    let part_of_d_u_dot_d_wind_y_2 =
        sin_phi * sin_theta_minus_product_sum_2 - part_of_d_u_dot_d_wind_y;
    let sin_phi_air_velocity_2 = sin_phi * air_velocity_2;
    let part_of_d_u_dot_d_wind_z = -(sin_phi_air_velocity_2 * minus_minus_minus_w_product);
    let part_of_d_u_dot_d_wind_z_2 =
        part_of_d_u_dot_d_wind_z - cos_phi * sin_theta_minus_product_sum_2;
    let air_velocity_2_inv_product_2 = air_velocity_2_inv_product * minus_minus_w_plus_product_2;
    let air_velocity_2_rho_product = air_velocity_2 * rho_A_half_V_inv_m;
    let part_of_minus_air_velocity_2_sum =
        cos_theta * minus_minus_minus_w_product + sin_theta * minus_minus_w_plus_sum;
    let minus_air_velocity_2_sum = -(air_velocity_2 * part_of_minus_air_velocity_2_sum);
    let part_of_d_v_dot_d_wind_y = sin_theta_minus_product_sum * sin_phi_air_velocity_2;
    let part_of_d_v_dot_d_wind_y_2 =
        cos_phi * minus_minus_rho_A_half_sum_2 - part_of_d_v_dot_d_wind_y;
    let part_of_d_v_dot_d_wind_z = sin_theta_minus_product_sum * cos_phi_air_velocity_2;
    let part_of_d_v_dot_d_wind_z_2 =
        sin_phi * minus_minus_rho_A_half_sum_2 + part_of_d_v_dot_d_wind_z;
    let sqrt_air_velocity_1_product_2 = sqrt_air_velocity_1_sum * V_inv_m;
    let part_of_d_w_dot_d_wind_x =
        sin_theta * C_D_rho_A_half_V_inv_m_sum - cos_theta * sqrt_air_velocity_1_product;
    let part_of_d_w_dot_d_wind_y =
        (sin_phi * sin_theta_air_velocity_1 + cos_phi_air_velocity_2) * inv_sqrt_air_product_3;
    let part_of_d_w_dot_d_wind_y_2 =
        -(cos_theta_sin_phi * C_D_rho_A_half_V_inv_m_sum) - part_of_d_w_dot_d_wind_y;
    let part_of_d_w_dot_d_wind_z =
        (cos_phi * sin_theta_air_velocity_1 - sin_phi_air_velocity_2) * inv_sqrt_air_product_3;
    let part_of_d_w_dot_d_wind_z_2 =
        cos_theta_cos_phi * C_D_rho_A_half_V_inv_m_sum + part_of_d_w_dot_d_wind_z;
    let r_inv_I_d = inv_p2 * r;
    let air_velocity_1_sq_product_6 = air_velocity_1_sq_plus_sum_2 * inv_sqrt_air_product_sum;
    let minus_air_velocity_product =
        inv_p2_sq * (I_a * thetadot * r - p5_p4_half_p3 * air_velocity_1_sq_product_6);
    let inv_cos_theta_air_product_3 = inv_cos_theta * air_velocity_1_sq_product_6;
    let alpha_air_velocity_product = alpha * air_velocity_1_sq_product_5;
    let air_velocity_1_sq_product_7 = air_velocity_1_sq_product * nonzero_sqrt_air_of;
    let cos_theta_phidot_product = cos_theta_phidot * air_velocity_1_sq_product_7;
    let r_air_velocity_1_sq_product = r * air_velocity_1_sq_product_3;
    let air_velocity_1_inv_sum_sum = air_velocity_1_inv_sum + air_velocity_2_C_Ma_product;
    let air_velocity_2_C_Ma_sum_sum = air_velocity_2_C_Ma_sum - air_velocity_1_inv_product_2;
    let cos_phi_inv_cos_product_sum =
        cos_phi * inv_cos_theta_d_product + sin_phi * air_velocity_2_C_Ma_sum_sum;
    let sin_phi_inv_cos_product_sum =
        sin_phi * inv_cos_theta_d_product - cos_phi * air_velocity_2_C_Ma_sum_sum;
    let air_velocity_1_sq_product_8 = air_velocity_1_sq_plus_sum_2 * inv_sqrt_air_product_2_sum;
    let part_of_d_thetadot_dot_d_I_d = minus_inv_p2_p5_part_sum * air_velocity_1_sq_product_8;
    let part_of_d_thetadot_dot_d_I_d_2 =
        part_of_d_thetadot_dot_d_I_d - r_inv_I_d * cos_theta_phidot_I_a_inv_I_d;
    let part_of_d_thetadot_dot_d_wind_x =
        sin_theta * air_velocity_1_C_Ma_sum - cos_theta * d_thetadot_dot_d_air_sum_2;
    let part_of_d_thetadot_dot_d_wind_y =
        cos_phi * minus_d_thetadot_dot_d_sum - sin_phi * sin_theta_d_product_sum;
    let part_of_d_thetadot_dot_d_wind_z =
        sin_phi * minus_d_thetadot_dot_d_sum + cos_phi * sin_theta_d_product_sum;
    let part_of_d_gammadot_dot_d_I_a =
        r * (inv_p2 * thetadot_sin_theta_product - inv_p1_d_gammadot_dot_d_r);
    let sin_theta_inv_cos_product = sin_theta_inv_cos_theta * air_velocity_1_sq_product_6;
    let minus_cos_phi_inv_cos_sum = -cos_phi_inv_cos_product_sum;
    let minus_sin_theta_sin_phi_sum = -(sin_theta * sin_phi_inv_cos_product_sum);
    let minus_cos_theta_sin_phi = -cos_theta_sin_phi;
    let minus_z_dot = -z_dot;
    let minus_sin_theta_cos_phi = -sin_theta_cos_phi;
    let minus_x_dot_cos_phi = -(x_dot * cos_phi);
    let minus_w = -w;
    let minus_C_D_rho_A_half_V_inv_m_sum = -C_D_rho_A_half_V_inv_m_sum;
    let minus_cos_theta_v = -(cos_theta * v);
    let minus_inv_cos_theta_d_product = -inv_cos_theta_d_product;
    let minus_r_I_a_inv_I_d_minus_product = -(r_I_a_inv_I_d_minus_sin_sum * inv_cos_theta);
    let minus_minus_d_thetadot_dot_d_sum = -minus_d_thetadot_dot_d_sum;
    let minus_air_velocity_1_C_Ma_sum = -air_velocity_1_C_Ma_sum;
    let minus_air_velocity_1_inv_product_2 = -air_velocity_1_inv_product_2;
    let minus_air_velocity_2_C_Ma_product = -air_velocity_2_C_Ma_product;
    let minus_air_velocity_1_rho_product = -air_velocity_1_rho_product;
    let minus_air_velocity_1_rho_product_2 = -(air_velocity_1_rho_product * alpha_sq);
    let minus_sin_phi = -sin_phi;
    let minus_air_velocity_2_rho_product = -air_velocity_2_rho_product;
    let minus_air_velocity_2_rho_product_2 = -(air_velocity_2_rho_product * alpha_sq);
    let minus_cos_theta_cos_phi = -cos_theta_cos_phi;
    let minus_thetadot_inv_cos_product = -(thetadot * inv_cos_theta * r_inv_I_d);
    let minus_inv_cos_theta_alpha_product = -(inv_cos_theta * alpha_air_velocity_product);
    let minus_air_velocity_1_inv_sum_sum = -air_velocity_1_inv_sum_sum;
    let minus_sin_theta_inv_cos_product = -(sin_theta_inv_cos_theta * minus_air_velocity_product);
    let minus_sin_theta_inv_cos_product_2 = -(sin_theta_inv_cos_theta * cos_theta_phidot_product);
    let minus_sin_theta_inv_cos_product_3 =
        -(sin_theta_inv_cos_theta * r_air_velocity_1_sq_product);

    dx[0] = x_dot;
    dx[1] = y_dot;
    dx[2] = z_dot;
    dx[3] = u_dot;
    dx[4] = v_dot;
    dx[5] = w_dot;
    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    dx[9] = minus_thetadot_r_I_product;
    dx[10] = thetadot_dot;
    dx[11] = gammadot_dot;

    j[0] = cos_theta; // d_x_dot_d_u
    j[1] = sin_theta; // d_x_dot_d_w
    j[2] = cos_theta_w_minus_u_sin_sum; // d_x_dot_d_theta
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
    j[13] = minus_rho_A_half_V_inv_sum; // d_u_dot_d_u
    j[14] = sin_theta_phidot + air_velocity_2_product; // d_u_dot_d_v
    j[15] = air_velocity_1_product - thetadot; // d_u_dot_d_w
    j[16] = part_of_d_u_dot_d_phi_4; // d_u_dot_d_phi
    j[17] = part_of_d_u_dot_d_theta_2; // d_u_dot_d_theta
    j[18] = sin_theta * v; // d_u_dot_d_phidot
    j[19] = minus_w; // d_u_dot_d_thetadot
    j[20] = air_velocity_2_product - sin_theta_phidot; // d_v_dot_d_u
    j[21] = minus_rho_A_half_V_inv_sum_2; // d_v_dot_d_v
    j[22] = cos_theta_phidot + air_velocity_2 * minus_minus_w_plus_sum; // d_v_dot_d_w
    j[23] = part_of_d_v_dot_d_phi_2 - part_of_d_v_dot_d_phi; // d_v_dot_d_phi
    j[24] = air_velocity_2 * part_of_d_v_dot_d_theta_2 - x_dot * phidot; // d_v_dot_d_theta
    j[25] = cos_theta_w_minus_u_sin_sum; // d_v_dot_d_phidot
    j[26] = thetadot + sqrt_air_velocity_1_product; // d_w_dot_d_u
    j[27] = part_of_d_w_dot_d_v; // d_w_dot_d_v
    j[28] = minus_C_D_rho_A_half_V_inv_m_sum; // d_w_dot_d_w
    j[29] = part_of_d_w_dot_d_phi_4; // d_w_dot_d_phi
    j[30] = part_of_d_w_dot_d_theta_2; // d_w_dot_d_theta
    j[31] = minus_cos_theta_v; // d_w_dot_d_phidot
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
    j[36] = inv_cos_theta_air_product; // d_phidot_dot_d_u
    j[37] = minus_inv_cos_theta_d_product; // d_phidot_dot_d_v
    j[38] = inv_cos_theta_air_product_2; // d_phidot_dot_d_w
    j[39] = cos_phi_wind_y_plus_sum; // d_phidot_dot_d_phi
    j[40] = phidot_part_minus_part_sum; // d_phidot_dot_d_theta
    j[41] = minus_thetadot_I_a_sum; // d_phidot_dot_d_phidot
    j[42] = minus_r_I_a_inv_I_d_minus_product; // d_phidot_dot_d_thetadot
    j[43] = inv_cos_theta * minus_thetadot_I_a_inv_sum; // d_phidot_dot_d_gammadot
    j[44] = d_thetadot_dot_d_air_sum_2; // d_thetadot_dot_d_u
    j[45] = minus_minus_d_thetadot_dot_d_sum; // d_thetadot_dot_d_v
    j[46] = minus_air_velocity_1_C_Ma_sum; // d_thetadot_dot_d_w
    j[47] = part_of_d_thetadot_dot_d_phi_2; // d_thetadot_dot_d_phi
    j[48] = part_of_d_thetadot_dot_d_theta_4; // d_thetadot_dot_d_theta
    j[49] = part_of_d_thetadot_dot_d_phidot; // d_thetadot_dot_d_phidot
    j[50] = air_velocity_1_sq_product_4; // d_thetadot_dot_d_thetadot
    j[51] = C_Rr_air_velocity_1_sum; // d_thetadot_dot_d_gammadot
    j[52] = minus_air_velocity_1_inv_product_2; // d_gammadot_dot_d_u
    j[53] = d_thetadot_dot_d_air_sum * sin_theta_inv_cos_theta; // d_gammadot_dot_d_v
    j[54] = minus_air_velocity_2_C_Ma_product; // d_gammadot_dot_d_w
    j[55] = sin_theta * minus_cos_phi_wind_y_sum; // d_gammadot_dot_d_phi
    j[56] = part_of_d_gammadot_dot_d_theta_2; // d_gammadot_dot_d_theta
    j[57] = part_of_d_gammadot_dot_d_phidot; // d_gammadot_dot_d_phidot
    j[58] = part_of_d_gammadot_dot_d_thetadot; // d_gammadot_dot_d_thetadot
    j[59] = p14_inv_p1 - minus_thetadot_I_a_product; // d_gammadot_dot_d_gammadot

    jp[0] = inv_p0_half_p5_p4 * air_velocity_1_inv_product_3; // d_u_dot_d_m
    jp[1] = minus_p5_half * air_velocity_1_inv_product_3; // d_u_dot_d_A
    jp[2] = minus_p4_half * air_velocity_1_inv_product_3; // d_u_dot_d_rho
    jp[3] = sin_theta_cos_phi; // d_u_dot_d_g
    jp[4] = d_w_dot_d_C_D * air_velocity_1_inv_product; // d_u_dot_d_C_L0
    jp[5] = air_velocity_1_inv_product * alpha_d_w_dot_d_C_D; // d_u_dot_d_C_La
    jp[6] = minus_air_velocity_1_rho_product; // d_u_dot_d_C_D0
    jp[7] = minus_air_velocity_1_rho_product_2; // d_u_dot_d_C_Da
    jp[8] = part_of_d_u_dot_d_wind_x; // d_u_dot_d_wind_x
    jp[9] = part_of_d_u_dot_d_wind_y_2; // d_u_dot_d_wind_y
    jp[10] = part_of_d_u_dot_d_wind_z_2; // d_u_dot_d_wind_z
    jp[11] = inv_p0_half_p5_p4 * air_velocity_2_inv_product_2; // d_v_dot_d_m
    jp[12] = minus_p5_half * air_velocity_2_inv_product_2; // d_v_dot_d_A
    jp[13] = minus_p4_half * air_velocity_2_inv_product_2; // d_v_dot_d_rho
    jp[14] = minus_sin_phi; // d_v_dot_d_g
    jp[15] = d_w_dot_d_C_D * air_velocity_2_inv_product; // d_v_dot_d_C_L0
    jp[16] = air_velocity_2_inv_product * alpha_d_w_dot_d_C_D; // d_v_dot_d_C_La
    jp[17] = minus_air_velocity_2_rho_product; // d_v_dot_d_C_D0
    jp[18] = minus_air_velocity_2_rho_product_2; // d_v_dot_d_C_Da
    jp[19] = minus_air_velocity_2_sum; // d_v_dot_d_wind_x
    jp[20] = part_of_d_v_dot_d_wind_y_2; // d_v_dot_d_wind_y
    jp[21] = part_of_d_v_dot_d_wind_z_2; // d_v_dot_d_wind_z
    jp[22] = minus_p5_p4_half_inv_p0 * sqrt_air_velocity_1_product_2; // d_w_dot_d_m
    jp[23] = p5_half * sqrt_air_velocity_1_product_2; // d_w_dot_d_A
    jp[24] = p4_half * sqrt_air_velocity_1_product_2; // d_w_dot_d_rho
    jp[25] = minus_cos_theta_cos_phi; // d_w_dot_d_g
    jp[26] = d_w_dot_d_C_L; // d_w_dot_d_C_L0
    jp[27] = alpha * d_w_dot_d_C_L; // d_w_dot_d_C_La
    jp[28] = d_w_dot_d_C_D; // d_w_dot_d_C_D0
    jp[29] = d_w_dot_d_C_D * alpha_sq; // d_w_dot_d_C_Da
    jp[30] = part_of_d_w_dot_d_wind_x; // d_w_dot_d_wind_x
    jp[31] = part_of_d_w_dot_d_wind_y_2; // d_w_dot_d_wind_y
    jp[32] = part_of_d_w_dot_d_wind_z_2; // d_w_dot_d_wind_z
    jp[33] = minus_thetadot_inv_cos_product; // d_phidot_dot_d_I_a
    jp[34] = inv_cos_theta * minus_air_velocity_product; // d_phidot_dot_d_I_d
    jp[35] = p5_p4_half_inv_p2 * inv_cos_theta_air_product_3; // d_phidot_dot_d_d
    jp[36] = inv_p2_p3_p5_half * inv_cos_theta_air_product_3; // d_phidot_dot_d_A
    jp[37] = inv_p2_p3_p4_half * inv_cos_theta_air_product_3; // d_phidot_dot_d_rho
    jp[38] = minus_inv_cos_theta_alpha_product; // d_phidot_dot_d_C_Ma
    jp[39] = inv_cos_theta * cos_theta_phidot_product; // d_phidot_dot_d_C_Mq
    jp[40] = inv_cos_theta * r_air_velocity_1_sq_product; // d_phidot_dot_d_C_Rr
    jp[41] = minus_air_velocity_1_inv_sum_sum; // d_phidot_dot_d_wind_x
    jp[42] = cos_phi_inv_cos_product_sum; // d_phidot_dot_d_wind_y
    jp[43] = sin_phi_inv_cos_product_sum; // d_phidot_dot_d_wind_z
    jp[44] = cos_theta_phidot * r_inv_I_d; // d_thetadot_dot_d_I_a
    jp[45] = part_of_d_thetadot_dot_d_I_d_2; // d_thetadot_dot_d_I_d
    jp[46] = p5_p4_half_inv_p2 * air_velocity_1_sq_product_8; // d_thetadot_dot_d_d
    jp[47] = inv_p2_p3_p5_half * air_velocity_1_sq_product_8; // d_thetadot_dot_d_A
    jp[48] = inv_p2_p3_p4_half * air_velocity_1_sq_product_8; // d_thetadot_dot_d_rho
    jp[49] = alpha * air_velocity_1_sq_product_3; // d_thetadot_dot_d_C_Ma
    jp[50] = thetadot * air_velocity_1_sq_product_7; // d_thetadot_dot_d_C_Mq
    jp[51] = r * air_velocity_1_sq_product_5; // d_thetadot_dot_d_C_Rr
    jp[52] = part_of_d_thetadot_dot_d_wind_x; // d_thetadot_dot_d_wind_x
    jp[53] = part_of_d_thetadot_dot_d_wind_y; // d_thetadot_dot_d_wind_y
    jp[54] = part_of_d_thetadot_dot_d_wind_z; // d_thetadot_dot_d_wind_z
    jp[55] = part_of_d_gammadot_dot_d_I_a; // d_gammadot_dot_d_I_a
    jp[56] = minus_sin_theta_inv_cos_product; // d_gammadot_dot_d_I_d
    jp[57] = minus_p5_p4_half_inv_p2 * sin_theta_inv_cos_product; // d_gammadot_dot_d_d
    jp[58] = minus_inv_p2_p3_p5_half * sin_theta_inv_cos_product; // d_gammadot_dot_d_A
    jp[59] = minus_inv_p2_p3_p4_half * sin_theta_inv_cos_product; // d_gammadot_dot_d_rho
    jp[60] = sin_theta_inv_cos_theta * alpha_air_velocity_product; // d_gammadot_dot_d_C_Ma
    jp[61] = minus_sin_theta_inv_cos_product_2; // d_gammadot_dot_d_C_Mq
    jp[62] = minus_sin_theta_inv_cos_product_3; // d_gammadot_dot_d_C_Rr
    jp[63] = inv_p1 * r; // d_gammadot_dot_d_C_Nr
    jp[64] = sin_theta * air_velocity_1_inv_sum_sum; // d_gammadot_dot_d_wind_x
    jp[65] = sin_theta * minus_cos_phi_inv_cos_sum; // d_gammadot_dot_d_wind_y
    jp[66] = minus_sin_theta_sin_phi_sum; // d_gammadot_dot_d_wind_z
}
