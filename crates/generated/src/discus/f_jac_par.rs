// Written by `hyzer generate`; changes belong in the model.
//! `discus`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 604 operations: 142 add, 398 mul, 4 div, 50 neg, 2 sqrt, 7 call, 1 select.
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
    let u = state[3];
    let v = state[4];
    let w = state[5];
    let phi = state[6];
    let theta = state[7];
    let phidot = state[9];
    let thetadot = state[10];
    let gammadot = state[11];
    let I_a = parameters[1];
    let d = parameters[3];
    let g = parameters[6];
    let C_Lp = parameters[8];
    let C_D0 = parameters[10];
    let C_Ds = parameters[11];
    let C_Ms = parameters[12];
    let C_Mq = parameters[13];
    let wind_x = parameters[15];
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let inv_p0_half_p5_p4 = prepared[0];
    let minus_p8_plus_p7 = prepared[1];
    let inv_p9 = prepared[2];
    let inv_p2_p1 = prepared[4];
    let p14_inv_p1 = prepared[5];
    let two_p11 = prepared[6];
    let minus_two_plus_p1_inv_p2 = prepared[8];
    let minus_n1_plus_p1_inv_p2 = prepared[9];
    let p4_half = prepared[10];
    let p5_p4_half = prepared[11];
    let inv_p0 = prepared[12];
    let inv_p2 = prepared[13];
    let inv_p1 = prepared[14];
    let half_p5_p4_half_inv_p0 = prepared[15];
    let p7_minus_p8_n4 = prepared[16];
    let p7_minus_p8_n8 = prepared[17];
    let p5_half = prepared[18];
    let inv_p2_sq = prepared[19];
    let inv_p1_d_gammadot_dot_d_r = prepared[20];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // discus.hyz:63  position (x, y, z) in N;
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

    // discus.hyz:70  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u + minus_cos_theta_wind_x_sum;
    let cos_phi_wind_y_plus_sin_sum = wind_y * cos_phi + wind_z * sin_phi;
    let air_velocity_2 = v - cos_phi_wind_y_plus_sin_sum;
    let air_velocity_2_sq = air_velocity_2 * air_velocity_2;
    let air_velocity_1_sq_plus_sum = air_velocity_1 * air_velocity_1 + air_velocity_2_sq;
    let cos_theta_cos_phi_sum = cos_theta * cos_phi_wind_z_minus_sum + wind_x * sin_theta;
    let minus_w_plus_cos_theta_sum = cos_theta_cos_phi_sum - w;
    let air_velocity_1_sq_plus_sum_2 =
        air_velocity_1_sq_plus_sum + minus_w_plus_cos_theta_sum * minus_w_plus_cos_theta_sum;
    let sqrt_air_velocity_1_sq_of = air_velocity_1_sq_plus_sum_2.sqrt();
    let sqrt_air_velocity_1_product = inv_p0 * sqrt_air_velocity_1_sq_of;
    let rho_A_half_sqrt_air_product = p5_p4_half * sqrt_air_velocity_1_product;
    let inv_sqrt_air_velocity_1_of = sqrt_air_velocity_1_sq_of.recip_or_zero();
    let minus_w_plus_cos_product = minus_w_plus_cos_theta_sum * inv_sqrt_air_velocity_1_of;
    let minus_w_plus_cos_product_2 = inv_p9 * minus_w_plus_cos_product;
    let minus_w_plus_cos_product_3 = minus_w_plus_cos_product_2 * minus_w_plus_cos_product_2;
    let minus_w_plus_cos_product_4 = minus_w_plus_cos_product_3 * minus_w_plus_cos_product_3;
    let part_of_inv_minus_w_plus_cos_sum =
        minus_w_plus_cos_product_4 * minus_w_plus_cos_product_4 + T::splat(1.0);
    let inv_minus_w_plus_cos_sum = T::splat(1.0) / part_of_inv_minus_w_plus_cos_sum;
    let C_Lp_plus_C_Ls_minus_C_sum = C_Lp + minus_p8_plus_p7 * inv_minus_w_plus_cos_sum;
    let sqrt_air_velocity_1_sq_of_2 = air_velocity_1_sq_plus_sum.sqrt();

    // discus.hyz:77  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_w_plus_cos_theta_sum.atan2(sqrt_air_velocity_1_sq_of_2);
    let alpha_two = T::splat(2.0) * alpha;
    let (sin_alpha_two, cos_alpha_two) = alpha_two.sin_cos();
    let C_Lp_plus_C_Ls_product = C_Lp_plus_C_Ls_minus_C_sum * sin_alpha_two;
    let minus_w_plus_cos_product_sq = minus_w_plus_cos_product * minus_w_plus_cos_product;

    // discus.hyz:83  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = C_D0 + C_Ds * minus_w_plus_cos_product_sq;
    let part_of_minus_minus_w_plus_product =
        sqrt_air_velocity_1_sq_of_2 * C_D - minus_w_plus_cos_theta_sum * C_Lp_plus_C_Ls_product;
    let inv_sqrt_air_velocity_1_of_2 = sqrt_air_velocity_1_sq_of_2.recip_or_zero();
    let minus_minus_w_plus_product =
        part_of_minus_minus_w_plus_product * inv_sqrt_air_velocity_1_of_2;
    let rho_A_half_sqrt_air_product_2 = rho_A_half_sqrt_air_product * minus_minus_w_plus_product;
    let part_of_u_dot = sin_theta_v_phidot_product - air_velocity_1 * rho_A_half_sqrt_air_product_2;

    // discus.hyz:64  velocity (u, v, w) in B;
    let u_dot = part_of_u_dot - w * thetadot;
    let sin_phi_g = g * sin_phi;
    let part_of_v_dot =
        cos_theta_w_minus_u_sin_sum * phidot - air_velocity_2 * rho_A_half_sqrt_air_product_2;
    let v_dot = part_of_v_dot - sin_phi_g;
    let cos_theta_v_phidot_product = cos_theta * v_phidot_plus_cos_phi_g;
    let sqrt_air_velocity_1_sum =
        sqrt_air_velocity_1_sq_of_2 * C_Lp_plus_C_Ls_product + minus_w_plus_cos_theta_sum * C_D;
    let part_of_w_dot =
        rho_A_half_sqrt_air_product * sqrt_air_velocity_1_sum - cos_theta_v_phidot_product;
    let w_dot = part_of_w_dot + u * thetadot;
    let sin_theta_phidot = sin_theta * phidot;

    // discus.hyz:88  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let r_I_a_inv_I_d = inv_p2_p1 * r;
    let r_I_a_inv_I_d_minus_two_sum = r_I_a_inv_I_d - T::splat(2.0) * sin_theta_phidot;
    let inv_sqrt_air_product = inv_p2 * inv_sqrt_air_velocity_1_of_2;
    let d_inv_sqrt_air_product = d * inv_sqrt_air_product;
    let air_velocity_1_sq_product = air_velocity_1_sq_plus_sum_2 * d_inv_sqrt_air_product;
    let rho_A_half_air_product = p5_p4_half * air_velocity_1_sq_product;
    let cos_theta_phidot = cos_theta * phidot;
    let air_velocity_2_cos_sum = air_velocity_2 * cos_theta_phidot - air_velocity_1 * thetadot;
    let inv_sqrt_air_product_2 = C_Mq * inv_sqrt_air_velocity_1_of_2;
    let sin_alpha_two_C_Ms_sum =
        C_Ms * sin_alpha_two - air_velocity_2_cos_sum * inv_sqrt_air_product_2;
    let air_velocity_1_cos_sum = air_velocity_1 * cos_theta_phidot + air_velocity_2 * thetadot;
    let inv_sqrt_air_product_3 = inv_sqrt_air_product_2 * air_velocity_1_cos_sum;
    let minus_air_velocity_2_sum =
        air_velocity_1 * inv_sqrt_air_product_3 - air_velocity_2 * sin_alpha_two_C_Ms_sum;
    let part_of_thetadot_r_I_a_inv_product =
        thetadot * r_I_a_inv_I_d_minus_two_sum - rho_A_half_air_product * minus_air_velocity_2_sum;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let thetadot_r_I_a_inv_product = part_of_thetadot_r_I_a_inv_product * inv_cos_theta;
    let air_velocity_1_sin_sum =
        air_velocity_1 * sin_alpha_two_C_Ms_sum + air_velocity_2 * inv_sqrt_air_product_3;
    let part_of_thetadot_dot = rho_A_half_air_product * air_velocity_1_sin_sum;
    let sin_theta_phidot_minus_sum = sin_theta_phidot - r_I_a_inv_I_d;

    // discus.hyz:56  frame B = A turned theta about 2; // does not spin with the discus
    let thetadot_dot = part_of_thetadot_dot - cos_theta_phidot * sin_theta_phidot_minus_sum;

    // discus.hyz:57  frame C = B turned gamma about 3; // fixed in the discus
    let gammadot_dot =
        p14_inv_p1 * r - thetadot * cos_theta_phidot + sin_theta * thetadot_r_I_a_inv_product;
    let sin_theta_sin_phi = sin_theta * sin_phi;
    let cos_theta_sin_phi = cos_theta * sin_phi;
    let minus_z_dot = -z_dot;
    let sin_theta_cos_phi = sin_theta * cos_phi;
    let cos_theta_cos_phi = cos_theta * cos_phi;
    let nonzero_air_velocity_1_of =
        air_velocity_1_sq_plus_sum.if_zero(T::splat(0.0), T::splat(1.0));
    let minus_w_plus_cos_product_5 = minus_w_plus_cos_product * rho_A_half_sqrt_air_product;
    let minus_w_plus_cos_product_6 = minus_w_plus_cos_product * minus_w_plus_cos_product_5;
    let nonzero_air_product = nonzero_air_velocity_1_of * minus_w_plus_cos_product_6;
    let part_of_inv_sqrt_air_product_sum = C_Ds * inv_sqrt_air_velocity_1_of * nonzero_air_product;
    let inv_sqrt_air_product_sum =
        part_of_inv_sqrt_air_product_sum - half_p5_p4_half_inv_p0 * minus_minus_w_plus_product;
    let part_of_inv_sqrt_air_product_sum_2_4 =
        inv_sqrt_air_velocity_1_of * inv_sqrt_air_product_sum;
    let part_of_minus_C_Lp_plus_C_Ls_sum =
        C_Lp_plus_C_Ls_minus_C_sum * inv_sqrt_air_velocity_1_of_2 * cos_alpha_two;
    let part_of_minus_w_plus_cos_product_7 =
        minus_w_plus_cos_product_2 * minus_w_plus_cos_product_3;
    let inv_s_stall_inv_product = inv_p9 * inv_minus_w_plus_cos_sum;
    let minus_w_plus_cos_product_7 =
        part_of_minus_w_plus_cos_product_7 * (minus_w_plus_cos_product_4 * inv_s_stall_inv_product);
    let inv_minus_w_plus_product = inv_minus_w_plus_cos_sum * sin_alpha_two;
    let part_of_minus_C_Lp_plus_C_Ls_sum_2 =
        p7_minus_p8_n4 * inv_sqrt_air_velocity_1_of * minus_w_plus_cos_product_7;
    let part_of_minus_C_Lp_plus_C_Ls_sum_3 =
        part_of_minus_C_Lp_plus_C_Ls_sum_2 * inv_minus_w_plus_product;
    let minus_C_Lp_plus_C_Ls_sum =
        part_of_minus_C_Lp_plus_C_Ls_sum_3 - part_of_minus_C_Lp_plus_C_Ls_sum;
    let part_of_inv_sqrt_air_product_sum_2 =
        T::splat(0.5) * inv_sqrt_air_velocity_1_of_2 * (C_D - minus_minus_w_plus_product);
    let part_of_inv_sqrt_air_product_sum_2_2 =
        minus_C_Lp_plus_C_Ls_sum * minus_w_plus_cos_product_sq - part_of_inv_sqrt_air_product_sum_2;
    let rho_A_half_sqrt_air_product_3 = rho_A_half_sqrt_air_product * inv_sqrt_air_velocity_1_of_2;
    let part_of_inv_sqrt_air_product_sum_2_3 =
        part_of_inv_sqrt_air_product_sum_2_2 * rho_A_half_sqrt_air_product_3;
    let inv_sqrt_air_product_sum_2 =
        part_of_inv_sqrt_air_product_sum_2_4 + part_of_inv_sqrt_air_product_sum_2_3;
    let air_velocity_1_two = T::splat(2.0) * air_velocity_1;
    let inv_sqrt_air_product_4 = inv_sqrt_air_product_sum_2 * air_velocity_1_two;
    let part_of_d_u_dot_d_u =
        air_velocity_1 * inv_sqrt_air_product_4 - rho_A_half_sqrt_air_product_2;
    let air_velocity_2_inv_product = air_velocity_2 * inv_sqrt_air_product_4;
    let part_of_minus_inv_sqrt_air_sum_3 =
        two_p11 * nonzero_air_velocity_1_of * minus_w_plus_cos_product_5;
    let inv_sqrt_air_product_5 = inv_sqrt_air_velocity_1_of * sqrt_air_velocity_1_sq_of_2;
    let cos_alpha_two_inv_product = cos_alpha_two * inv_sqrt_air_product_5;
    let part_of_minus_C_Lp_plus_C_Ls_sum_2_2 =
        T::splat(2.0) * C_Lp_plus_C_Ls_minus_C_sum * cos_alpha_two_inv_product;
    let C_Ls_minus_C_Lp_n8_product = p7_minus_p8_n8 * minus_w_plus_cos_product_7;
    let part_of_minus_C_Lp_plus_C_Ls_sum_2_3 =
        (T::splat(1.0) - minus_w_plus_cos_product_sq) * C_Ls_minus_C_Lp_n8_product;
    let part_of_minus_C_Lp_plus_C_Ls_sum_2_4 =
        part_of_minus_C_Lp_plus_C_Ls_sum_2_3 * inv_minus_w_plus_product;
    let minus_C_Lp_plus_C_Ls_sum_2 =
        part_of_minus_C_Lp_plus_C_Ls_sum_2_4 - part_of_minus_C_Lp_plus_C_Ls_sum_2_2;
    let part_of_minus_inv_sqrt_air_sum = minus_C_Lp_plus_C_Ls_sum_2 * rho_A_half_sqrt_air_product_3;
    let part_of_minus_inv_sqrt_air_sum_2 =
        part_of_minus_inv_sqrt_air_sum - T::splat(2.0) * inv_sqrt_air_product_sum;
    let part_of_minus_inv_sqrt_air_sum_4 =
        minus_w_plus_cos_theta_sum * part_of_minus_inv_sqrt_air_sum_2;
    let part_of_minus_inv_sqrt_air_sum_5 =
        part_of_minus_inv_sqrt_air_sum_3 + part_of_minus_inv_sqrt_air_sum_4;
    let C_Lp_plus_C_Ls_product_2 = C_Lp_plus_C_Ls_product * rho_A_half_sqrt_air_product_3;
    let minus_inv_sqrt_air_sum =
        C_Lp_plus_C_Ls_product_2 - inv_sqrt_air_velocity_1_of * part_of_minus_inv_sqrt_air_sum_5;
    let part_of_minus_cos_theta_minus_sum =
        cos_theta * minus_inv_sqrt_air_sum * cos_phi_wind_y_plus_sin_sum;
    let minus_cos_phi_wind_z_sum = -cos_phi_wind_z_minus_sum;
    let part_of_air_velocity_2_product_sum =
        sin_theta * air_velocity_1 * cos_phi_wind_y_plus_sin_sum;
    let air_velocity_2_product_sum =
        air_velocity_2 * minus_cos_phi_wind_z_sum - part_of_air_velocity_2_product_sum;
    let two_inv_sqrt_air_product = T::splat(2.0) * inv_sqrt_air_product_sum_2;
    let minus_cos_theta_minus_sum =
        air_velocity_2_product_sum * two_inv_sqrt_air_product - part_of_minus_cos_theta_minus_sum;
    let part_of_d_u_dot_d_phi =
        sin_phi_g - rho_A_half_sqrt_air_product_2 * cos_phi_wind_y_plus_sin_sum;
    let part_of_d_u_dot_d_phi_2 =
        air_velocity_1 * minus_cos_theta_minus_sum - sin_theta * part_of_d_u_dot_d_phi;
    let part_of_minus_inv_sqrt_air_sum_2_2 = minus_inv_sqrt_air_sum * minus_cos_theta_wind_x_sum;
    let minus_inv_sqrt_air_sum_2 =
        part_of_minus_inv_sqrt_air_sum_2_2 - cos_theta_cos_phi_sum * inv_sqrt_air_product_4;
    let part_of_d_u_dot_d_theta =
        cos_theta_v_phidot_product - air_velocity_1 * minus_inv_sqrt_air_sum_2;
    let part_of_d_u_dot_d_theta_2 =
        part_of_d_u_dot_d_theta - rho_A_half_sqrt_air_product_2 * cos_theta_cos_phi_sum;
    let part_of_d_v_dot_d_v =
        air_velocity_2_sq * two_inv_sqrt_air_product - rho_A_half_sqrt_air_product_2;
    let part_of_d_v_dot_d_phi = rho_A_half_sqrt_air_product_2 * minus_cos_phi_wind_z_sum;
    let part_of_d_v_dot_d_phi_2 =
        air_velocity_2 * minus_cos_theta_minus_sum - cos_phi_g - part_of_d_v_dot_d_phi;
    let part_of_minus_w_plus_cos_sum = C_Ds * minus_w_plus_cos_product * minus_w_plus_cos_product_6;
    let minus_w_plus_cos_sum =
        part_of_minus_w_plus_cos_sum - half_p5_p4_half_inv_p0 * sqrt_air_velocity_1_sum;
    let part_of_half_C_Lp_plus_C_Ls_sum =
        sqrt_air_velocity_1_sq_of_2 * minus_C_Lp_plus_C_Ls_sum * minus_w_plus_cos_product_5;
    let part_of_half_C_Lp_plus_C_Ls_sum_2 =
        inv_sqrt_air_velocity_1_of * (minus_w_plus_cos_sum - part_of_half_C_Lp_plus_C_Ls_sum);
    let half_C_Lp_plus_C_Ls_sum =
        T::splat(0.5) * C_Lp_plus_C_Ls_product_2 - part_of_half_C_Lp_plus_C_Ls_sum_2;
    let half_C_Lp_plus_C_Ls_product = half_C_Lp_plus_C_Ls_sum * air_velocity_1_two;
    let two_half_C_Lp_plus_C_Ls_sum = T::splat(2.0) * half_C_Lp_plus_C_Ls_sum;
    let part_of_minus_rho_A_half_sqrt_sum =
        rho_A_half_sqrt_air_product * (C_D - minus_C_Lp_plus_C_Ls_sum_2 * inv_sqrt_air_product_5);
    let minus_rho_A_half_sqrt_sum = -part_of_minus_rho_A_half_sqrt_sum;
    let part_of_minus_rho_A_half_sqrt_sum_2 =
        T::splat(2.0) * minus_w_plus_cos_product * minus_w_plus_cos_sum;
    let part_of_minus_rho_A_half_sqrt_sum_2_2 =
        two_p11 * minus_w_plus_cos_product_6 - part_of_minus_rho_A_half_sqrt_sum_2;
    let minus_rho_A_half_sqrt_sum_2 =
        minus_rho_A_half_sqrt_sum - part_of_minus_rho_A_half_sqrt_sum_2_2;
    let part_of_d_w_dot_d_phi_2 = air_velocity_2_product_sum * two_half_C_Lp_plus_C_Ls_sum;
    let minus_minus_rho_A_half_sum = -minus_rho_A_half_sqrt_sum_2;
    let part_of_d_w_dot_d_phi =
        sin_phi_g - cos_phi_wind_y_plus_sin_sum * minus_minus_rho_A_half_sum;
    let part_of_d_w_dot_d_theta =
        sin_theta_v_phidot_product - minus_cos_theta_wind_x_sum * minus_minus_rho_A_half_sum;
    let part_of_d_w_dot_d_theta_2 =
        part_of_d_w_dot_d_theta + cos_theta_cos_phi_sum * half_C_Lp_plus_C_Ls_product;
    let thetadot_inv_sqrt_product = thetadot * inv_sqrt_air_product_2;
    let inv_sqrt_air_product_6 = C_Ms * inv_sqrt_air_velocity_1_of;
    let part_of_minus_minus_w_plus_cos_sum =
        minus_w_plus_cos_product * cos_alpha_two * inv_sqrt_air_product_6;
    let inv_sqrt_air_product_7 = inv_sqrt_air_velocity_1_of_2 * inv_sqrt_air_velocity_1_of_2;
    let C_Mq_inv_sqrt_air_product_7 = C_Mq * inv_sqrt_air_product_7;
    let part_of_minus_minus_w_plus_cos_sum_2 =
        T::splat(0.5) * air_velocity_2_cos_sum * C_Mq_inv_sqrt_air_product_7;
    let minus_minus_w_plus_cos_sum =
        part_of_minus_minus_w_plus_cos_sum_2 - part_of_minus_minus_w_plus_cos_sum;
    let part_of_thetadot_inv_sqrt_sum =
        inv_sqrt_air_velocity_1_of_2 * minus_minus_w_plus_cos_sum * air_velocity_1_two;
    let thetadot_inv_sqrt_sum = thetadot_inv_sqrt_product + part_of_thetadot_inv_sqrt_sum;
    let air_velocity_2_rho_product = air_velocity_2 * rho_A_half_air_product;
    let d_thetadot_dot_d_air_velocity_2 = rho_A_half_air_product * inv_sqrt_air_product_3;
    let air_velocity_1_inv_product = air_velocity_1 * inv_sqrt_air_velocity_1_of_2;
    let air_velocity_1_cos_product = air_velocity_1_cos_sum * C_Mq_inv_sqrt_air_product_7;
    let cos_theta_phidot_product = cos_theta_phidot * inv_sqrt_air_product_2;
    let minus_air_velocity_1_sum =
        cos_theta_phidot_product - air_velocity_1_inv_product * air_velocity_1_cos_product;
    let rho_A_half_minus_product = p5_p4_half * minus_air_velocity_2_sum;
    let part_of_d_inv_sqrt_air_product_2 =
        T::splat(0.5) * air_velocity_1_sq_plus_sum_2 * inv_sqrt_air_product_7;
    let part_of_d_inv_sqrt_air_product_2_2 =
        T::splat(2.0) * (part_of_d_inv_sqrt_air_product_2 - T::splat(1.0));
    let d_inv_sqrt_air_product_2 = d_inv_sqrt_air_product * part_of_d_inv_sqrt_air_product_2_2;
    let rho_A_half_minus_product_2 = rho_A_half_minus_product * d_inv_sqrt_air_product_2;
    let part_of_minus_thetadot_inv_sqrt_sum =
        rho_A_half_air_product * minus_air_velocity_1_sum - rho_A_half_minus_product_2;
    let part_of_minus_thetadot_inv_sqrt_sum_3 =
        air_velocity_1 * part_of_minus_thetadot_inv_sqrt_sum;
    let part_of_minus_thetadot_inv_sqrt_sum_2 =
        d_thetadot_dot_d_air_velocity_2 - thetadot_inv_sqrt_sum * air_velocity_2_rho_product;
    let minus_thetadot_inv_sqrt_sum =
        part_of_minus_thetadot_inv_sqrt_sum_2 + part_of_minus_thetadot_inv_sqrt_sum_3;
    let air_velocity_2_inv_product_2 = air_velocity_2 * inv_sqrt_air_velocity_1_of_2;
    let thetadot_inv_sqrt_sum_2 =
        thetadot_inv_sqrt_product - air_velocity_2_inv_product_2 * air_velocity_1_cos_product;
    let air_velocity_1_rho_product = air_velocity_1 * rho_A_half_air_product;
    let d_thetadot_dot_d_air_velocity_1 = rho_A_half_air_product * sin_alpha_two_C_Ms_sum;
    let part_of_cos_theta_phidot_sum =
        T::splat(2.0) * minus_minus_w_plus_cos_sum * air_velocity_2_inv_product_2;
    let cos_theta_phidot_sum = cos_theta_phidot_product - part_of_cos_theta_phidot_sum;
    let part_of_minus_thetadot_inv_sqrt_sum_2_2 =
        rho_A_half_minus_product_2 - rho_A_half_air_product * cos_theta_phidot_sum;
    let part_of_minus_thetadot_inv_sqrt_sum_2_4 =
        air_velocity_2 * part_of_minus_thetadot_inv_sqrt_sum_2_2;
    let part_of_minus_thetadot_inv_sqrt_sum_2_3 =
        d_thetadot_dot_d_air_velocity_1 - thetadot_inv_sqrt_sum_2 * air_velocity_1_rho_product;
    let minus_thetadot_inv_sqrt_sum_2 =
        part_of_minus_thetadot_inv_sqrt_sum_2_3 + part_of_minus_thetadot_inv_sqrt_sum_2_4;
    let inv_sqrt_air_product_8 = inv_sqrt_air_product_6 * cos_alpha_two_inv_product;
    let minus_w_plus_cos_product_8 = minus_w_plus_cos_theta_sum * d_inv_sqrt_air_product;
    let part_of_two_minus_air_velocity_2_sum =
        rho_A_half_minus_product * minus_w_plus_cos_product_8;
    let part_of_two_minus_air_velocity_2_sum_2 =
        part_of_two_minus_air_velocity_2_sum - air_velocity_2_rho_product * inv_sqrt_air_product_8;
    let two_minus_air_velocity_2_sum = T::splat(2.0) * part_of_two_minus_air_velocity_2_sum_2;
    let sin_theta_minus_product_sum =
        sin_theta * minus_thetadot_inv_sqrt_sum + cos_theta * two_minus_air_velocity_2_sum;
    let part_of_minus_cos_phi_wind_sum = cos_phi_wind_y_plus_sin_sum * sin_theta_minus_product_sum;
    let minus_cos_phi_wind_sum =
        minus_cos_phi_wind_z_sum * minus_thetadot_inv_sqrt_sum_2 + part_of_minus_cos_phi_wind_sum;
    let part_of_inv_cos_theta_minus_product_2 =
        minus_cos_theta_wind_x_sum * two_minus_air_velocity_2_sum;
    let cos_theta_thetadot = cos_theta * thetadot;
    let inv_sqrt_air_product_9 =
        inv_sqrt_air_product_2 * (air_velocity_1_sq_plus_sum * rho_A_half_air_product);
    let part_of_inv_cos_theta_minus_product =
        minus_two_plus_p1_inv_p2 * cos_theta_thetadot + sin_theta * inv_sqrt_air_product_9;
    let part_of_inv_cos_theta_minus_product_3 =
        part_of_inv_cos_theta_minus_product_2 - cos_theta_cos_phi_sum * minus_thetadot_inv_sqrt_sum;
    let part_of_inv_cos_theta_minus_product_4 =
        part_of_inv_cos_theta_minus_product_3 + phidot * part_of_inv_cos_theta_minus_product;
    let inv_cos_theta_minus_product = inv_cos_theta * part_of_inv_cos_theta_minus_product_4;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let thetadot_r_I_a_inv_product_2 = thetadot_r_I_a_inv_product * sin_theta_inv_cos_theta;
    let part_of_inv_cos_theta_sin_product =
        minus_two_plus_p1_inv_p2 * sin_theta * thetadot - cos_theta * inv_sqrt_air_product_9;
    let inv_cos_theta_sin_product = inv_cos_theta * part_of_inv_cos_theta_sin_product;
    let thetadot_inv_cos_theta = thetadot * inv_cos_theta;
    let rho_A_half_air_product_2 = p5_p4_half * air_velocity_1_sin_sum;
    let rho_A_half_air_product_3 = rho_A_half_air_product_2 * d_inv_sqrt_air_product_2;
    let part_of_d_thetadot_dot_d_air_sum =
        rho_A_half_air_product * thetadot_inv_sqrt_sum - rho_A_half_air_product_3;
    let part_of_d_thetadot_dot_d_air_sum_2 =
        d_thetadot_dot_d_air_velocity_1 + minus_air_velocity_1_sum * air_velocity_2_rho_product;
    let d_thetadot_dot_d_air_sum =
        part_of_d_thetadot_dot_d_air_sum_2 + air_velocity_1 * part_of_d_thetadot_dot_d_air_sum;
    let part_of_d_thetadot_dot_d_air_sum_2_2 =
        rho_A_half_air_product_3 - rho_A_half_air_product * thetadot_inv_sqrt_sum_2;
    let part_of_d_thetadot_dot_d_air_sum_2_4 =
        air_velocity_2 * part_of_d_thetadot_dot_d_air_sum_2_2;
    let part_of_d_thetadot_dot_d_air_sum_2_3 =
        d_thetadot_dot_d_air_velocity_2 - cos_theta_phidot_sum * air_velocity_1_rho_product;
    let d_thetadot_dot_d_air_sum_2 =
        part_of_d_thetadot_dot_d_air_sum_2_3 - part_of_d_thetadot_dot_d_air_sum_2_4;
    let rho_A_half_air_product_4 = rho_A_half_air_product_2 * minus_w_plus_cos_product_8;
    let part_of_d_thetadot_dot_d_w =
        rho_A_half_air_product * air_velocity_1_two * inv_sqrt_air_product_8;
    let part_of_d_thetadot_dot_d_w_2 =
        -(T::splat(2.0) * rho_A_half_air_product_4) - part_of_d_thetadot_dot_d_w;
    let part_of_two_air_velocity_1_rho_sum =
        air_velocity_1_rho_product * inv_sqrt_air_product_8 + rho_A_half_air_product_4;
    let two_air_velocity_1_rho_sum = T::splat(2.0) * part_of_two_air_velocity_1_rho_sum;
    let sin_theta_d_product_sum =
        sin_theta * d_thetadot_dot_d_air_sum + cos_theta * two_air_velocity_1_rho_sum;
    let part_of_d_thetadot_dot_d_phi = cos_phi_wind_y_plus_sin_sum * sin_theta_d_product_sum;
    let part_of_d_thetadot_dot_d_phi_2 =
        minus_cos_phi_wind_z_sum * d_thetadot_dot_d_air_sum_2 - part_of_d_thetadot_dot_d_phi;
    let part_of_d_thetadot_dot_d_theta_2 = minus_cos_theta_wind_x_sum * two_air_velocity_1_rho_sum;
    let cos_theta_phidot_product_2 = minus_n1_plus_p1_inv_p2 * cos_theta_phidot;
    let part_of_d_thetadot_dot_d_theta =
        sin_theta * sin_theta_phidot_minus_sum + cos_theta * cos_theta_phidot_product_2;
    let part_of_d_thetadot_dot_d_theta_3 =
        cos_theta_cos_phi_sum * d_thetadot_dot_d_air_sum - part_of_d_thetadot_dot_d_theta_2;
    let part_of_d_thetadot_dot_d_theta_4 =
        part_of_d_thetadot_dot_d_theta_3 + phidot * part_of_d_thetadot_dot_d_theta;
    let part_of_d_thetadot_dot_d_phidot =
        sin_theta * cos_theta_phidot_product_2 - cos_theta * sin_theta_phidot_minus_sum;
    let cos_theta_phidot_I_a_inv_I_d = inv_p2_p1 * cos_theta_phidot;
    let part_of_d_gammadot_dot_d_theta_2 =
        cos_theta * (thetadot_r_I_a_inv_product + p14_inv_p1 * phidot);
    let part_of_d_gammadot_dot_d_theta =
        inv_cos_theta_minus_product + (thetadot_r_I_a_inv_product_2 + phidot * thetadot);
    let part_of_d_gammadot_dot_d_theta_3 =
        part_of_d_gammadot_dot_d_theta_2 + sin_theta * part_of_d_gammadot_dot_d_theta;
    let part_of_d_gammadot_dot_d_phidot =
        sin_theta * (inv_cos_theta_sin_product + p14_inv_p1) - cos_theta_thetadot;
    let part_of_d_gammadot_dot_d_thetadot =
        r_I_a_inv_I_d_minus_two_sum * sin_theta_inv_cos_theta - cos_theta_phidot;
    let thetadot_sin_theta_product = thetadot * sin_theta_inv_cos_theta;
    let minus_minus_w_plus_product_2 = minus_minus_w_plus_product * sqrt_air_velocity_1_product;
    let air_velocity_1_product = air_velocity_1 * minus_minus_w_plus_product_2;
    let minus_w_plus_cos_product_9 = minus_w_plus_cos_theta_sum * sin_alpha_two;
    let rho_A_half_sqrt_air_product_4 = rho_A_half_sqrt_air_product_3 * minus_w_plus_cos_product_9;
    let air_velocity_1_rho_product_2 = air_velocity_1 * rho_A_half_sqrt_air_product_4;
    let minus_n1_plus_inv_minus_sum = inv_minus_w_plus_cos_sum - T::splat(1.0);
    let C_Ls_minus_C_Lp_n8_product_2 =
        C_Ls_minus_C_Lp_n8_product * (minus_w_plus_cos_product_5 * inv_s_stall_inv_product);
    let minus_w_plus_cos_product_10 = minus_w_plus_cos_product_9 * C_Ls_minus_C_Lp_n8_product_2;
    let rho_A_half_sqrt_air_product_5 = rho_A_half_sqrt_air_product * nonzero_air_velocity_1_of;
    let sin_theta_minus_inv_sum =
        sin_theta * minus_inv_sqrt_air_sum - cos_theta * inv_sqrt_air_product_4;
    let part_of_d_u_dot_d_wind_x =
        air_velocity_1 * sin_theta_minus_inv_sum + cos_theta * rho_A_half_sqrt_air_product_2;
    let cos_phi_air_velocity_2_sum = cos_phi * air_velocity_2 + air_velocity_1 * sin_theta_sin_phi;
    let part_of_cos_theta_sin_phi_sum = cos_phi_air_velocity_2_sum * two_inv_sqrt_air_product;
    let cos_theta_sin_phi_sum =
        cos_theta_sin_phi * minus_inv_sqrt_air_sum + part_of_cos_theta_sin_phi_sum;
    let part_of_d_u_dot_d_wind_y =
        rho_A_half_sqrt_air_product_2 * sin_theta_sin_phi - air_velocity_1 * cos_theta_sin_phi_sum;
    let sin_phi_air_velocity_2_sum = sin_phi * air_velocity_2 - air_velocity_1 * sin_theta_cos_phi;
    let part_of_minus_cos_theta_cos_phi_sum = sin_phi_air_velocity_2_sum * two_inv_sqrt_air_product;
    let minus_cos_theta_cos_phi_sum =
        part_of_minus_cos_theta_cos_phi_sum - cos_theta_cos_phi * minus_inv_sqrt_air_sum;
    let part_of_d_u_dot_d_wind_z = rho_A_half_sqrt_air_product_2 * sin_theta_cos_phi;
    let part_of_d_u_dot_d_wind_z_2 =
        -(air_velocity_1 * minus_cos_theta_cos_phi_sum) - part_of_d_u_dot_d_wind_z;
    let air_velocity_2_product = air_velocity_2 * minus_minus_w_plus_product_2;
    let air_velocity_2_rho_product_2 = air_velocity_2 * rho_A_half_sqrt_air_product_4;
    let part_of_d_v_dot_d_wind_y =
        cos_phi * rho_A_half_sqrt_air_product_2 - air_velocity_2 * cos_theta_sin_phi_sum;
    let part_of_d_v_dot_d_wind_z =
        sin_phi * rho_A_half_sqrt_air_product_2 - air_velocity_2 * minus_cos_theta_cos_phi_sum;
    let sqrt_air_velocity_1_product_2 = sqrt_air_velocity_1_sum * sqrt_air_velocity_1_product;
    let part_of_d_w_dot_d_C_Ls =
        sqrt_air_velocity_1_sq_of_2 * rho_A_half_sqrt_air_product * inv_minus_w_plus_product;
    let sqrt_air_velocity_1_product_3 = sqrt_air_velocity_1_sq_of_2 * sin_alpha_two;
    let part_of_minus_rho_A_half_sqrt_air_product =
        rho_A_half_sqrt_air_product * minus_n1_plus_inv_minus_sum * sqrt_air_velocity_1_product_3;
    let d_w_dot_d_C_D = minus_w_plus_cos_theta_sum * rho_A_half_sqrt_air_product;
    let part_of_d_w_dot_d_wind_x =
        sin_theta * minus_minus_rho_A_half_sum - cos_theta * half_C_Lp_plus_C_Ls_product;
    let part_of_d_w_dot_d_wind_y = cos_phi_air_velocity_2_sum * two_half_C_Lp_plus_C_Ls_sum;
    let part_of_d_w_dot_d_wind_y_2 =
        -(cos_theta_sin_phi * minus_minus_rho_A_half_sum) - part_of_d_w_dot_d_wind_y;
    let part_of_d_w_dot_d_wind_z = sin_phi_air_velocity_2_sum * two_half_C_Lp_plus_C_Ls_sum;
    let part_of_d_w_dot_d_wind_z_2 =
        cos_theta_cos_phi * minus_minus_rho_A_half_sum - part_of_d_w_dot_d_wind_z;
    let r_inv_I_d = inv_p2 * r;
    let part_of_minus_air_velocity_product =
        d * air_velocity_1_sq_plus_sum_2 * inv_sqrt_air_velocity_1_of_2 * rho_A_half_minus_product;
    let minus_air_velocity_product =
        inv_p2_sq * (I_a * thetadot * r - part_of_minus_air_velocity_product);
    let air_velocity_1_sq_product_2 = air_velocity_1_sq_plus_sum_2 * inv_sqrt_air_product;
    let rho_A_half_minus_product_3 = rho_A_half_minus_product * air_velocity_1_sq_product_2;
    let minus_air_velocity_product_2 = minus_air_velocity_2_sum * air_velocity_1_sq_product;
    let inv_cos_theta_minus_product_2 = inv_cos_theta * minus_air_velocity_product_2;
    let sin_alpha_two_air_product = sin_alpha_two * air_velocity_2_rho_product;
    let part_of_air_velocity_2_air_product =
        air_velocity_2 * air_velocity_2_cos_sum + air_velocity_1 * air_velocity_1_cos_sum;
    let inv_sqrt_air_product_10 = inv_sqrt_air_velocity_1_of_2 * rho_A_half_air_product;
    let air_velocity_2_air_product = part_of_air_velocity_2_air_product * inv_sqrt_air_product_10;
    let minus_cos_theta_minus_sum_2 =
        sin_theta * two_minus_air_velocity_2_sum - cos_theta * minus_thetadot_inv_sqrt_sum;
    let cos_phi_minus_product_sum =
        cos_phi * minus_thetadot_inv_sqrt_sum_2 - sin_phi * sin_theta_minus_product_sum;
    let sin_phi_minus_product_sum =
        sin_phi * minus_thetadot_inv_sqrt_sum_2 + cos_phi * sin_theta_minus_product_sum;
    let part_of_d_thetadot_dot_d_I_d =
        -(inv_p2 * air_velocity_1_sq_product * rho_A_half_air_product_2);
    let part_of_d_thetadot_dot_d_I_d_2 =
        part_of_d_thetadot_dot_d_I_d - r_inv_I_d * cos_theta_phidot_I_a_inv_I_d;
    let air_velocity_1_sin_product = air_velocity_1_sin_sum * air_velocity_1_sq_product;
    let part_of_minus_part_part_minus_sum =
        air_velocity_1 * air_velocity_2_cos_sum - air_velocity_2 * air_velocity_1_cos_sum;
    let minus_part_part_minus_sum = -(part_of_minus_part_part_minus_sum * inv_sqrt_air_product_10);
    let part_of_d_thetadot_dot_d_wind_x =
        sin_theta * two_air_velocity_1_rho_sum - cos_theta * d_thetadot_dot_d_air_sum;
    let part_of_d_thetadot_dot_d_wind_y =
        -(cos_phi * d_thetadot_dot_d_air_sum_2) - sin_phi * sin_theta_d_product_sum;
    let part_of_d_thetadot_dot_d_wind_z =
        cos_phi * sin_theta_d_product_sum - sin_phi * d_thetadot_dot_d_air_sum_2;
    let part_of_d_gammadot_dot_d_I_a =
        r * (inv_p2 * thetadot_sin_theta_product - inv_p1_d_gammadot_dot_d_r);
    let sin_theta_inv_cos_product = sin_theta_inv_cos_theta * minus_air_velocity_product_2;
    let minus_thetadot_r_I_a_inv_product = -thetadot_r_I_a_inv_product;
    let minus_cos_theta_sin_phi = -cos_theta_sin_phi;
    let minus_sin_theta_cos_phi = -sin_theta_cos_phi;
    let minus_x_dot_cos_phi = -(x_dot * cos_phi);
    let minus_w = -w;
    let minus_cos_theta_v = -(cos_theta * v);
    let minus_inv_cos_theta_minus_product = -(inv_cos_theta * minus_thetadot_inv_sqrt_sum_2);
    let minus_inv_cos_theta_two_product = -(inv_cos_theta * two_minus_air_velocity_2_sum);
    let minus_inv_cos_theta_minus_product_2 = -(inv_cos_theta * minus_cos_phi_wind_sum);
    let minus_inv_cos_theta_sin_product = -inv_cos_theta_sin_product;
    let minus_r_I_a_inv_I_d_minus_product = -(r_I_a_inv_I_d_minus_two_sum * inv_cos_theta);
    let minus_I_a_inv_I_d_product = -(inv_p2_p1 * thetadot_inv_cos_theta);
    let minus_minus_thetadot_inv_product = -(minus_thetadot_inv_sqrt_sum * sin_theta_inv_cos_theta);
    let minus_rho_half_air_product = -(p5_half * air_velocity_1_product);
    let minus_A_half_air_velocity_product = -(p4_half * air_velocity_1_product);
    let minus_minus_n1_plus_inv_product =
        -(minus_n1_plus_inv_minus_sum * air_velocity_1_rho_product_2);
    let minus_air_velocity_1_rho_product = -(air_velocity_1 * rho_A_half_sqrt_air_product_5);
    let minus_air_velocity_1_product = -(air_velocity_1 * nonzero_air_product);
    let minus_rho_half_air_product_2 = -(p5_half * air_velocity_2_product);
    let minus_A_half_air_velocity_product_2 = -(p4_half * air_velocity_2_product);
    let minus_sin_phi = -sin_phi;
    let minus_minus_n1_plus_inv_product_2 =
        -(minus_n1_plus_inv_minus_sum * air_velocity_2_rho_product_2);
    let minus_air_velocity_2_rho_product = -(air_velocity_2 * rho_A_half_sqrt_air_product_5);
    let minus_air_velocity_2_product = -(air_velocity_2 * nonzero_air_product);
    let minus_rho_part_part_inv_m_product = -(inv_p0_half_p5_p4 * sqrt_air_velocity_1_product_2);
    let minus_cos_theta_cos_phi = -cos_theta_cos_phi;
    let minus_rho_A_half_sqrt_air_product = -part_of_minus_rho_A_half_sqrt_air_product;
    let minus_r_inv_I_d_thetadot_product = -(r_inv_I_d * thetadot_inv_cos_theta);
    let minus_inv_cos_theta_sin_product_2 = -(inv_cos_theta * sin_alpha_two_air_product);
    let minus_sin_theta_inv_cos_product = -(sin_theta_inv_cos_theta * minus_air_velocity_product);
    let minus_sin_theta_inv_cos_product_2 = -(sin_theta_inv_cos_theta * rho_A_half_minus_product_3);
    let minus_rho_half_sin_theta_product = -(p5_half * sin_theta_inv_cos_product);
    let minus_A_half_sin_theta_product = -(p4_half * sin_theta_inv_cos_product);
    let minus_sin_theta_inv_cos_product_3 = -(sin_theta_inv_cos_theta * air_velocity_2_air_product);
    let minus_minus_cos_theta_product = -(minus_cos_theta_minus_sum_2 * sin_theta_inv_cos_theta);
    let minus_cos_phi_minus_product = -(cos_phi_minus_product_sum * sin_theta_inv_cos_theta);
    let minus_sin_phi_minus_product = -(sin_phi_minus_product_sum * sin_theta_inv_cos_theta);

    dx[0] = x_dot;
    dx[1] = y_dot;
    dx[2] = z_dot;
    dx[3] = u_dot;
    dx[4] = v_dot;
    dx[5] = w_dot;
    dx[6] = phidot;
    dx[7] = thetadot;
    dx[8] = gammadot;
    dx[9] = minus_thetadot_r_I_a_inv_product;
    dx[10] = thetadot_dot;
    dx[11] = gammadot_dot;

    j[0] = cos_theta; // d_x_dot_d_u
    j[1] = sin_theta; // d_x_dot_d_w
    j[2] = cos_theta_w_minus_u_sin_sum; // d_x_dot_d_theta
    j[3] = sin_theta_sin_phi; // d_y_dot_d_u
    j[4] = cos_phi; // d_y_dot_d_v
    j[5] = minus_cos_theta_sin_phi; // d_y_dot_d_w
    j[6] = minus_z_dot; // d_y_dot_d_phi
    j[7] = x_dot * sin_phi; // d_y_dot_d_theta
    j[8] = minus_sin_theta_cos_phi; // d_z_dot_d_u
    j[9] = sin_phi; // d_z_dot_d_v
    j[10] = cos_theta_cos_phi; // d_z_dot_d_w
    j[11] = y_dot; // d_z_dot_d_phi
    j[12] = minus_x_dot_cos_phi; // d_z_dot_d_theta
    j[13] = part_of_d_u_dot_d_u; // d_u_dot_d_u
    j[14] = sin_theta_phidot + air_velocity_2_inv_product; // d_u_dot_d_v
    j[15] = -thetadot - air_velocity_1 * minus_inv_sqrt_air_sum; // d_u_dot_d_w
    j[16] = part_of_d_u_dot_d_phi_2; // d_u_dot_d_phi
    j[17] = part_of_d_u_dot_d_theta_2; // d_u_dot_d_theta
    j[18] = sin_theta * v; // d_u_dot_d_phidot
    j[19] = minus_w; // d_u_dot_d_thetadot
    j[20] = air_velocity_2_inv_product - sin_theta_phidot; // d_v_dot_d_u
    j[21] = part_of_d_v_dot_d_v; // d_v_dot_d_v
    j[22] = cos_theta_phidot - air_velocity_2 * minus_inv_sqrt_air_sum; // d_v_dot_d_w
    j[23] = part_of_d_v_dot_d_phi_2; // d_v_dot_d_phi
    j[24] = -(air_velocity_2 * minus_inv_sqrt_air_sum_2) - x_dot * phidot; // d_v_dot_d_theta
    j[25] = cos_theta_w_minus_u_sin_sum; // d_v_dot_d_phidot
    j[26] = thetadot + half_C_Lp_plus_C_Ls_product; // d_w_dot_d_u
    j[27] = air_velocity_2 * two_half_C_Lp_plus_C_Ls_sum - cos_theta_phidot; // d_w_dot_d_v
    j[28] = minus_rho_A_half_sqrt_sum_2; // d_w_dot_d_w
    j[29] = part_of_d_w_dot_d_phi_2 + cos_theta * part_of_d_w_dot_d_phi; // d_w_dot_d_phi
    j[30] = part_of_d_w_dot_d_theta_2; // d_w_dot_d_theta
    j[31] = minus_cos_theta_v; // d_w_dot_d_phidot
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
    j[36] = inv_cos_theta * minus_thetadot_inv_sqrt_sum; // d_phidot_dot_d_u
    j[37] = minus_inv_cos_theta_minus_product; // d_phidot_dot_d_v
    j[38] = minus_inv_cos_theta_two_product; // d_phidot_dot_d_w
    j[39] = minus_inv_cos_theta_minus_product_2; // d_phidot_dot_d_phi
    j[40] = -inv_cos_theta_minus_product - thetadot_r_I_a_inv_product_2; // d_phidot_dot_d_theta
    j[41] = minus_inv_cos_theta_sin_product; // d_phidot_dot_d_phidot
    j[42] = minus_r_I_a_inv_I_d_minus_product; // d_phidot_dot_d_thetadot
    j[43] = minus_I_a_inv_I_d_product; // d_phidot_dot_d_gammadot
    j[44] = d_thetadot_dot_d_air_sum; // d_thetadot_dot_d_u
    j[45] = d_thetadot_dot_d_air_sum_2; // d_thetadot_dot_d_v
    j[46] = part_of_d_thetadot_dot_d_w_2; // d_thetadot_dot_d_w
    j[47] = part_of_d_thetadot_dot_d_phi_2; // d_thetadot_dot_d_phi
    j[48] = part_of_d_thetadot_dot_d_theta_4; // d_thetadot_dot_d_theta
    j[49] = part_of_d_thetadot_dot_d_phidot; // d_thetadot_dot_d_phidot
    j[50] = inv_sqrt_air_product_9; // d_thetadot_dot_d_thetadot
    j[51] = cos_theta_phidot_I_a_inv_I_d; // d_thetadot_dot_d_gammadot
    j[52] = minus_minus_thetadot_inv_product; // d_gammadot_dot_d_u
    j[53] = minus_thetadot_inv_sqrt_sum_2 * sin_theta_inv_cos_theta; // d_gammadot_dot_d_v
    j[54] = sin_theta_inv_cos_theta * two_minus_air_velocity_2_sum; // d_gammadot_dot_d_w
    j[55] = minus_cos_phi_wind_sum * sin_theta_inv_cos_theta; // d_gammadot_dot_d_phi
    j[56] = part_of_d_gammadot_dot_d_theta_3; // d_gammadot_dot_d_theta
    j[57] = part_of_d_gammadot_dot_d_phidot; // d_gammadot_dot_d_phidot
    j[58] = part_of_d_gammadot_dot_d_thetadot; // d_gammadot_dot_d_thetadot
    j[59] = inv_p2_p1 * thetadot_sin_theta_product + p14_inv_p1; // d_gammadot_dot_d_gammadot

    jp[0] = inv_p0_half_p5_p4 * air_velocity_1_product; // d_u_dot_d_m
    jp[1] = minus_rho_half_air_product; // d_u_dot_d_A
    jp[2] = minus_A_half_air_velocity_product; // d_u_dot_d_rho
    jp[3] = sin_theta_cos_phi; // d_u_dot_d_g
    jp[4] = inv_minus_w_plus_cos_sum * air_velocity_1_rho_product_2; // d_u_dot_d_C_Ls
    jp[5] = minus_minus_n1_plus_inv_product; // d_u_dot_d_C_Lp
    jp[6] = air_velocity_1_inv_product * minus_w_plus_cos_product_10; // d_u_dot_d_s_stall
    jp[7] = minus_air_velocity_1_rho_product; // d_u_dot_d_C_D0
    jp[8] = minus_air_velocity_1_product; // d_u_dot_d_C_Ds
    jp[9] = part_of_d_u_dot_d_wind_x; // d_u_dot_d_wind_x
    jp[10] = part_of_d_u_dot_d_wind_y; // d_u_dot_d_wind_y
    jp[11] = part_of_d_u_dot_d_wind_z_2; // d_u_dot_d_wind_z
    jp[12] = inv_p0_half_p5_p4 * air_velocity_2_product; // d_v_dot_d_m
    jp[13] = minus_rho_half_air_product_2; // d_v_dot_d_A
    jp[14] = minus_A_half_air_velocity_product_2; // d_v_dot_d_rho
    jp[15] = minus_sin_phi; // d_v_dot_d_g
    jp[16] = inv_minus_w_plus_cos_sum * air_velocity_2_rho_product_2; // d_v_dot_d_C_Ls
    jp[17] = minus_minus_n1_plus_inv_product_2; // d_v_dot_d_C_Lp
    jp[18] = air_velocity_2_inv_product_2 * minus_w_plus_cos_product_10; // d_v_dot_d_s_stall
    jp[19] = minus_air_velocity_2_rho_product; // d_v_dot_d_C_D0
    jp[20] = minus_air_velocity_2_product; // d_v_dot_d_C_Ds
    jp[21] = air_velocity_2 * sin_theta_minus_inv_sum; // d_v_dot_d_wind_x
    jp[22] = part_of_d_v_dot_d_wind_y; // d_v_dot_d_wind_y
    jp[23] = part_of_d_v_dot_d_wind_z; // d_v_dot_d_wind_z
    jp[24] = minus_rho_part_part_inv_m_product; // d_w_dot_d_m
    jp[25] = p5_half * sqrt_air_velocity_1_product_2; // d_w_dot_d_A
    jp[26] = p4_half * sqrt_air_velocity_1_product_2; // d_w_dot_d_rho
    jp[27] = minus_cos_theta_cos_phi; // d_w_dot_d_g
    jp[28] = part_of_d_w_dot_d_C_Ls; // d_w_dot_d_C_Ls
    jp[29] = minus_rho_A_half_sqrt_air_product; // d_w_dot_d_C_Lp
    jp[30] = C_Ls_minus_C_Lp_n8_product_2 * sqrt_air_velocity_1_product_3; // d_w_dot_d_s_stall
    jp[31] = d_w_dot_d_C_D; // d_w_dot_d_C_D0
    jp[32] = minus_w_plus_cos_theta_sum * minus_w_plus_cos_product_6; // d_w_dot_d_C_Ds
    jp[33] = part_of_d_w_dot_d_wind_x; // d_w_dot_d_wind_x
    jp[34] = part_of_d_w_dot_d_wind_y_2; // d_w_dot_d_wind_y
    jp[35] = part_of_d_w_dot_d_wind_z_2; // d_w_dot_d_wind_z
    jp[36] = minus_r_inv_I_d_thetadot_product; // d_phidot_dot_d_I_a
    jp[37] = inv_cos_theta * minus_air_velocity_product; // d_phidot_dot_d_I_d
    jp[38] = inv_cos_theta * rho_A_half_minus_product_3; // d_phidot_dot_d_d
    jp[39] = p5_half * inv_cos_theta_minus_product_2; // d_phidot_dot_d_A
    jp[40] = p4_half * inv_cos_theta_minus_product_2; // d_phidot_dot_d_rho
    jp[41] = minus_inv_cos_theta_sin_product_2; // d_phidot_dot_d_C_Ms
    jp[42] = inv_cos_theta * air_velocity_2_air_product; // d_phidot_dot_d_C_Mq
    jp[43] = inv_cos_theta * minus_cos_theta_minus_sum_2; // d_phidot_dot_d_wind_x
    jp[44] = inv_cos_theta * cos_phi_minus_product_sum; // d_phidot_dot_d_wind_y
    jp[45] = inv_cos_theta * sin_phi_minus_product_sum; // d_phidot_dot_d_wind_z
    jp[46] = cos_theta_phidot * r_inv_I_d; // d_thetadot_dot_d_I_a
    jp[47] = part_of_d_thetadot_dot_d_I_d_2; // d_thetadot_dot_d_I_d
    jp[48] = rho_A_half_air_product_2 * air_velocity_1_sq_product_2; // d_thetadot_dot_d_d
    jp[49] = p5_half * air_velocity_1_sin_product; // d_thetadot_dot_d_A
    jp[50] = p4_half * air_velocity_1_sin_product; // d_thetadot_dot_d_rho
    jp[51] = sin_alpha_two * air_velocity_1_rho_product; // d_thetadot_dot_d_C_Ms
    jp[52] = minus_part_part_minus_sum; // d_thetadot_dot_d_C_Mq
    jp[53] = part_of_d_thetadot_dot_d_wind_x; // d_thetadot_dot_d_wind_x
    jp[54] = part_of_d_thetadot_dot_d_wind_y; // d_thetadot_dot_d_wind_y
    jp[55] = part_of_d_thetadot_dot_d_wind_z; // d_thetadot_dot_d_wind_z
    jp[56] = part_of_d_gammadot_dot_d_I_a; // d_gammadot_dot_d_I_a
    jp[57] = minus_sin_theta_inv_cos_product; // d_gammadot_dot_d_I_d
    jp[58] = minus_sin_theta_inv_cos_product_2; // d_gammadot_dot_d_d
    jp[59] = minus_rho_half_sin_theta_product; // d_gammadot_dot_d_A
    jp[60] = minus_A_half_sin_theta_product; // d_gammadot_dot_d_rho
    jp[61] = sin_theta_inv_cos_theta * sin_alpha_two_air_product; // d_gammadot_dot_d_C_Ms
    jp[62] = minus_sin_theta_inv_cos_product_3; // d_gammadot_dot_d_C_Mq
    jp[63] = inv_p1 * r; // d_gammadot_dot_d_C_Nr
    jp[64] = minus_minus_cos_theta_product; // d_gammadot_dot_d_wind_x
    jp[65] = minus_cos_phi_minus_product; // d_gammadot_dot_d_wind_y
    jp[66] = minus_sin_phi_minus_product; // d_gammadot_dot_d_wind_z
}
