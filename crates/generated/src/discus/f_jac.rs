// Written by `hyzer generate`; changes belong in the model.
//! `discus`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 446 operations: 128 add, 276 mul, 4 div, 28 neg, 2 sqrt, 7 call, 1 select.
#[inline(always)]
pub fn f_jac<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 22],
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
    let half_p5_p4_p3_inv_p2 = prepared[3];
    let inv_p2_p1 = prepared[4];
    let p14_inv_p1 = prepared[5];
    let two_p11 = prepared[6];
    let n8_inv_p9_p7_minus_p8 = prepared[7];
    let minus_two_plus_p1_inv_p2 = prepared[8];
    let minus_n1_plus_p1_inv_p2 = prepared[9];
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
    let air_velocity_1_sq = air_velocity_1 * air_velocity_1;
    let cos_phi_wind_y_plus_sin_sum = wind_y * cos_phi + wind_z * sin_phi;
    let air_velocity_2 = v - cos_phi_wind_y_plus_sin_sum;
    let air_velocity_2_sq = air_velocity_2 * air_velocity_2;
    let air_velocity_1_sq_plus_sum = air_velocity_1_sq + air_velocity_2_sq;
    let cos_theta_cos_phi_sum = cos_theta * cos_phi_wind_z_minus_sum + wind_x * sin_theta;
    let minus_w_plus_cos_theta_sum = cos_theta_cos_phi_sum - w;
    let air_velocity_1_sq_plus_sum_2 =
        air_velocity_1_sq_plus_sum + minus_w_plus_cos_theta_sum * minus_w_plus_cos_theta_sum;
    let sqrt_air_velocity_1_sq_of = air_velocity_1_sq_plus_sum_2.sqrt();
    let sqrt_air_velocity_1_product = inv_p0_half_p5_p4 * sqrt_air_velocity_1_sq_of;
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

    // discus.hyz:83  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = C_D0 + C_Ds * minus_w_plus_cos_product * minus_w_plus_cos_product;
    let part_of_minus_minus_w_plus_product =
        sqrt_air_velocity_1_sq_of_2 * C_D - minus_w_plus_cos_theta_sum * C_Lp_plus_C_Ls_product;
    let inv_sqrt_air_velocity_1_of_2 = sqrt_air_velocity_1_sq_of_2.recip_or_zero();
    let minus_minus_w_plus_product =
        part_of_minus_minus_w_plus_product * inv_sqrt_air_velocity_1_of_2;
    let sqrt_air_velocity_1_product_2 = sqrt_air_velocity_1_product * minus_minus_w_plus_product;
    let part_of_u_dot = sin_theta_v_phidot_product - air_velocity_1 * sqrt_air_velocity_1_product_2;

    // discus.hyz:64  velocity (u, v, w) in B;
    let u_dot = part_of_u_dot - w * thetadot;
    let sin_phi_g = g * sin_phi;
    let part_of_v_dot =
        cos_theta_w_minus_u_sin_sum * phidot - air_velocity_2 * sqrt_air_velocity_1_product_2;
    let v_dot = part_of_v_dot - sin_phi_g;
    let cos_theta_v_phidot_product = cos_theta * v_phidot_plus_cos_phi_g;
    let sqrt_air_velocity_1_sum =
        sqrt_air_velocity_1_sq_of_2 * C_Lp_plus_C_Ls_product + minus_w_plus_cos_theta_sum * C_D;
    let part_of_w_dot =
        sqrt_air_velocity_1_product * sqrt_air_velocity_1_sum - cos_theta_v_phidot_product;
    let w_dot = part_of_w_dot + u * thetadot;
    let sin_theta_phidot = sin_theta * phidot;

    // discus.hyz:88  let r = dot(angular_velocity, d3);
    let r = gammadot + sin_theta_phidot;
    let r_I_a_inv_I_d = inv_p2_p1 * r;
    let r_I_a_inv_I_d_minus_two_sum = r_I_a_inv_I_d - T::splat(2.0) * sin_theta_phidot;
    let air_velocity_1_sq_product =
        half_p5_p4_p3_inv_p2 * air_velocity_1_sq_plus_sum_2 * inv_sqrt_air_velocity_1_of_2;
    let cos_theta_phidot = cos_theta * phidot;
    let air_velocity_2_cos_sum = air_velocity_2 * cos_theta_phidot - air_velocity_1 * thetadot;
    let inv_sqrt_air_product = C_Mq * inv_sqrt_air_velocity_1_of_2;
    let sin_alpha_two_C_Ms_sum =
        C_Ms * sin_alpha_two - air_velocity_2_cos_sum * inv_sqrt_air_product;
    let air_velocity_1_cos_sum = air_velocity_1 * cos_theta_phidot + air_velocity_2 * thetadot;
    let inv_sqrt_air_product_2 = inv_sqrt_air_product * air_velocity_1_cos_sum;
    let minus_air_velocity_2_sum =
        air_velocity_1 * inv_sqrt_air_product_2 - air_velocity_2 * sin_alpha_two_C_Ms_sum;
    let part_of_thetadot_r_I_a_inv_product = air_velocity_1_sq_product * minus_air_velocity_2_sum;
    let part_of_thetadot_r_I_a_inv_product_2 =
        thetadot * r_I_a_inv_I_d_minus_two_sum - part_of_thetadot_r_I_a_inv_product;
    let inv_cos_theta = T::splat(1.0) / cos_theta;
    let thetadot_r_I_a_inv_product = part_of_thetadot_r_I_a_inv_product_2 * inv_cos_theta;
    let air_velocity_1_sin_sum =
        air_velocity_1 * sin_alpha_two_C_Ms_sum + air_velocity_2 * inv_sqrt_air_product_2;
    let part_of_thetadot_dot = air_velocity_1_sq_product * air_velocity_1_sin_sum;
    let sin_theta_phidot_minus_sum = sin_theta_phidot - r_I_a_inv_I_d;

    // discus.hyz:56  frame B = A turned theta about 2; // does not spin with the discus
    let thetadot_dot = part_of_thetadot_dot - cos_theta_phidot * sin_theta_phidot_minus_sum;
    let thetadot_cos_theta_phidot = thetadot * cos_theta_phidot;

    // discus.hyz:57  frame C = B turned gamma about 3; // fixed in the discus
    let gammadot_dot =
        p14_inv_p1 * r - thetadot_cos_theta_phidot + sin_theta * thetadot_r_I_a_inv_product;
    let minus_z_dot = -z_dot;
    let minus_w_plus_cos_product_5 = minus_w_plus_cos_product * C_Lp_plus_C_Ls_minus_C_sum;
    let part_of_sqrt_air_velocity_1_sum_2 =
        minus_w_plus_cos_product * cos_alpha_two * minus_w_plus_cos_product_5;
    let part_of_sqrt_air_velocity_1_sum_2_2 =
        part_of_sqrt_air_velocity_1_sum_2 + T::splat(0.5) * (C_D - minus_minus_w_plus_product);
    let part_of_sqrt_air_velocity_1_sum_2_3 =
        sqrt_air_velocity_1_product * inv_sqrt_air_velocity_1_of_2 * inv_sqrt_air_velocity_1_of_2;
    let part_of_sqrt_air_velocity_1_sum_2_4 =
        part_of_sqrt_air_velocity_1_sum_2_3 * part_of_sqrt_air_velocity_1_sum_2_2;
    let nonzero_air_velocity_1_of =
        air_velocity_1_sq_plus_sum.if_zero(T::splat(0.0), T::splat(1.0));
    let minus_w_plus_cos_product_6 = two_p11 * minus_w_plus_cos_product;
    let minus_w_plus_cos_product_7 = minus_w_plus_cos_theta_sum * inv_sqrt_air_velocity_1_of_2;
    let part_of_n8_part_part_minus_product =
        n8_inv_p9_p7_minus_p8 * (minus_w_plus_cos_product_2 * minus_w_plus_cos_product_3);
    let part_of_n8_part_part_minus_product_2 =
        minus_w_plus_cos_product_4 * inv_minus_w_plus_cos_sum;
    let part_of_n8_part_part_minus_product_3 =
        part_of_n8_part_part_minus_product_2 * (inv_minus_w_plus_cos_sum * sin_alpha_two);
    let n8_part_part_minus_product =
        part_of_n8_part_part_minus_product * part_of_n8_part_part_minus_product_3;
    let part_of_nonzero_air_product_sum = minus_w_plus_cos_product_7 * n8_part_part_minus_product;
    let nonzero_air_product_sum =
        nonzero_air_velocity_1_of * minus_w_plus_cos_product_6 + part_of_nonzero_air_product_sum;
    let sqrt_air_velocity_1_product_3 =
        sqrt_air_velocity_1_product * (inv_sqrt_air_velocity_1_of * minus_w_plus_cos_product);
    let part_of_minus_nonzero_air_sum = nonzero_air_product_sum * sqrt_air_velocity_1_product_3;
    let minus_nonzero_air_sum =
        inv_p0_half_p5_p4 * minus_minus_w_plus_product - part_of_minus_nonzero_air_sum;
    let inv_sqrt_air_product_3 = T::splat(0.5) * inv_sqrt_air_velocity_1_of;
    let sqrt_air_velocity_1_sum_2 =
        part_of_sqrt_air_velocity_1_sum_2_4 + minus_nonzero_air_sum * inv_sqrt_air_product_3;
    let air_velocity_1_two = T::splat(2.0) * air_velocity_1;
    let sqrt_air_velocity_1_product_4 = sqrt_air_velocity_1_sum_2 * air_velocity_1_two;
    let part_of_d_u_dot_d_u =
        -sqrt_air_velocity_1_product_2 - air_velocity_1 * sqrt_air_velocity_1_product_4;
    let air_velocity_2_sqrt_product = air_velocity_2 * sqrt_air_velocity_1_product_4;
    let part_of_minus_minus_w_plus_cos_sum_3 =
        C_Lp_plus_C_Ls_product * inv_sqrt_air_velocity_1_of_2;
    let nonzero_air_product = nonzero_air_velocity_1_of * minus_w_plus_cos_product_5;
    let part_of_minus_minus_w_plus_cos_sum =
        nonzero_air_product_sum - T::splat(2.0) * cos_alpha_two * nonzero_air_product;
    let part_of_minus_minus_w_plus_cos_sum_2 =
        inv_sqrt_air_velocity_1_of * part_of_minus_minus_w_plus_cos_sum;
    let part_of_minus_minus_w_plus_cos_sum_4 =
        part_of_minus_minus_w_plus_cos_sum_3 - part_of_minus_minus_w_plus_cos_sum_2;
    let part_of_minus_minus_w_plus_cos_sum_5 =
        sqrt_air_velocity_1_product * part_of_minus_minus_w_plus_cos_sum_4;
    let minus_minus_w_plus_cos_sum =
        part_of_minus_minus_w_plus_cos_sum_5 - minus_w_plus_cos_product * minus_nonzero_air_sum;
    let part_of_d_u_dot_d_phi =
        sin_phi_g - sqrt_air_velocity_1_product_2 * cos_phi_wind_y_plus_sin_sum;
    let cos_theta_cos_phi_product = cos_theta * cos_phi_wind_y_plus_sin_sum;
    let part_of_minus_minus_w_plus_sum = minus_minus_w_plus_cos_sum * cos_theta_cos_phi_product;
    let sin_theta_cos_phi_product = sin_theta * cos_phi_wind_y_plus_sin_sum;
    let minus_cos_phi_wind_z_sum = -cos_phi_wind_z_minus_sum;
    let minus_air_velocity_1_sum =
        air_velocity_2 * minus_cos_phi_wind_z_sum - air_velocity_1 * sin_theta_cos_phi_product;
    let two_sqrt_air_product = T::splat(2.0) * sqrt_air_velocity_1_sum_2;
    let minus_minus_w_plus_sum =
        part_of_minus_minus_w_plus_sum + minus_air_velocity_1_sum * two_sqrt_air_product;
    let part_of_d_u_dot_d_phi_2 =
        -(sin_theta * part_of_d_u_dot_d_phi) - air_velocity_1 * minus_minus_w_plus_sum;
    let part_of_minus_minus_w_plus_sum_2 = minus_minus_w_plus_cos_sum * minus_cos_theta_wind_x_sum;
    let minus_minus_w_plus_sum_2 =
        part_of_minus_minus_w_plus_sum_2 + cos_theta_cos_phi_sum * sqrt_air_velocity_1_product_4;
    let part_of_d_u_dot_d_theta =
        cos_theta_v_phidot_product - sqrt_air_velocity_1_product_2 * cos_theta_cos_phi_sum;
    let part_of_d_u_dot_d_theta_2 =
        part_of_d_u_dot_d_theta - air_velocity_1 * minus_minus_w_plus_sum_2;
    let part_of_d_v_dot_d_v =
        -sqrt_air_velocity_1_product_2 - air_velocity_2_sq * two_sqrt_air_product;
    let part_of_d_v_dot_d_phi =
        -cos_phi_g - sqrt_air_velocity_1_product_2 * minus_cos_phi_wind_z_sum;
    let inv_sqrt_air_product_4 = inv_sqrt_air_velocity_1_of * cos_alpha_two;
    let half_inv_sqrt_air_product = T::splat(0.5) * inv_sqrt_air_velocity_1_of_2;
    let part_of_sqrt_air_velocity_1_sum_3 = C_Lp_plus_C_Ls_product * half_inv_sqrt_air_product;
    let part_of_sqrt_air_velocity_1_sum_3_2 =
        part_of_sqrt_air_velocity_1_sum_3 - inv_sqrt_air_product_4 * nonzero_air_product;
    let part_of_sqrt_air_velocity_1_sum_3_3 =
        sqrt_air_velocity_1_product * part_of_sqrt_air_velocity_1_sum_3_2;
    let part_of_minus_w_plus_cos_sum = sqrt_air_velocity_1_sq_of_2 * n8_part_part_minus_product;
    let minus_w_plus_cos_sum =
        minus_w_plus_cos_theta_sum * minus_w_plus_cos_product_6 - part_of_minus_w_plus_cos_sum;
    let part_of_minus_minus_w_plus_cos_sum_2_2 =
        minus_w_plus_cos_sum * sqrt_air_velocity_1_product_3;
    let minus_minus_w_plus_cos_sum_2 =
        inv_p0_half_p5_p4 * sqrt_air_velocity_1_sum - part_of_minus_minus_w_plus_cos_sum_2_2;
    let sqrt_air_velocity_1_sum_3 =
        part_of_sqrt_air_velocity_1_sum_3_3 + minus_minus_w_plus_cos_sum_2 * inv_sqrt_air_product_3;
    let two_sqrt_air_product_2 = T::splat(2.0) * sqrt_air_velocity_1_sum_3;
    let part_of_minus_minus_w_plus_cos_sum_3_2 =
        T::splat(2.0) * air_velocity_1_sq_plus_sum * C_Lp_plus_C_Ls_minus_C_sum;
    let part_of_minus_minus_w_plus_cos_sum_3_3 =
        minus_w_plus_cos_sum + part_of_minus_minus_w_plus_cos_sum_3_2 * inv_sqrt_air_product_4;
    let part_of_minus_minus_w_plus_cos_sum_3_4 =
        inv_sqrt_air_velocity_1_of * part_of_minus_minus_w_plus_cos_sum_3_3;
    let part_of_minus_minus_w_plus_cos_sum_3_5 =
        sqrt_air_velocity_1_product * (C_D + part_of_minus_minus_w_plus_cos_sum_3_4);
    let part_of_minus_minus_w_plus_cos_sum_3_6 =
        -(minus_w_plus_cos_product * minus_minus_w_plus_cos_sum_2);
    let minus_minus_w_plus_cos_sum_3 =
        part_of_minus_minus_w_plus_cos_sum_3_6 - part_of_minus_minus_w_plus_cos_sum_3_5;
    let minus_minus_minus_w_sum = -minus_minus_w_plus_cos_sum_3;
    let part_of_d_w_dot_d_phi = sin_phi_g - cos_phi_wind_y_plus_sin_sum * minus_minus_minus_w_sum;
    let part_of_d_w_dot_d_phi_2 =
        minus_air_velocity_1_sum * two_sqrt_air_product_2 + cos_theta * part_of_d_w_dot_d_phi;
    let cos_theta_cos_phi_product_2 = cos_theta_cos_phi_sum * air_velocity_1_two;
    let part_of_d_w_dot_d_theta =
        sin_theta_v_phidot_product - minus_cos_theta_wind_x_sum * minus_minus_minus_w_sum;
    let part_of_d_w_dot_d_theta_2 =
        part_of_d_w_dot_d_theta + sqrt_air_velocity_1_sum_3 * cos_theta_cos_phi_product_2;
    let air_velocity_2_inv_product = air_velocity_2 * inv_sqrt_air_product;
    let thetadot_air_product = thetadot * air_velocity_2_inv_product;
    let air_velocity_1_inv_product = air_velocity_1 * inv_sqrt_air_product;
    let cos_theta_phidot_product = cos_theta_phidot * air_velocity_1_inv_product;
    let inv_sqrt_air_product_2_sum = inv_sqrt_air_product_2 + cos_theta_phidot_product;
    let part_of_air_velocity_1_sq_sum =
        air_velocity_1_sq_product * (inv_sqrt_air_product_2_sum - thetadot_air_product);
    let C_Ms_inv_sqrt_air_product_4 = C_Ms * inv_sqrt_air_product_4;
    let part_of_minus_minus_w_plus_cos_sum_4_2 =
        minus_w_plus_cos_product * C_Ms_inv_sqrt_air_product_4;
    let inv_sqrt_air_product_5 = inv_sqrt_air_velocity_1_of_2 * half_inv_sqrt_air_product;
    let part_of_minus_minus_w_plus_cos_sum_4_3 =
        C_Mq * air_velocity_2_cos_sum * inv_sqrt_air_product_5;
    let minus_minus_w_plus_cos_sum_4 =
        part_of_minus_minus_w_plus_cos_sum_4_3 - part_of_minus_minus_w_plus_cos_sum_4_2;
    let air_velocity_2_air_product = air_velocity_2 * air_velocity_1_sq_product;
    let part_of_minus_minus_w_plus_sum_3_4 =
        minus_minus_w_plus_cos_sum_4 * air_velocity_2_air_product;
    let minus_air_velocity_product = half_p5_p4_p3_inv_p2 * minus_air_velocity_2_sum;
    let part_of_minus_minus_w_plus_sum_3 =
        air_velocity_1_sq_plus_sum_2 * minus_air_velocity_product;
    let air_velocity_1_air_product = air_velocity_1 * air_velocity_1_sq_product;
    let C_Mq_air_velocity_1_cos_sum = C_Mq * air_velocity_1_cos_sum;
    let part_of_minus_minus_w_plus_sum_3_2 =
        part_of_minus_minus_w_plus_sum_3 + air_velocity_1_air_product * C_Mq_air_velocity_1_cos_sum;
    let part_of_minus_minus_w_plus_sum_3_3 =
        part_of_minus_minus_w_plus_sum_3_2 * inv_sqrt_air_product_5;
    let part_of_minus_minus_w_plus_sum_3_5 =
        part_of_minus_minus_w_plus_sum_3_4 + part_of_minus_minus_w_plus_sum_3_3;
    let minus_minus_w_plus_sum_3 = part_of_minus_minus_w_plus_sum_3_5 - minus_air_velocity_product;
    let inv_sqrt_air_product_6 = inv_sqrt_air_velocity_1_of_2 * minus_minus_w_plus_sum_3;
    let air_velocity_1_sq_sum =
        part_of_air_velocity_1_sq_sum - air_velocity_1_two * inv_sqrt_air_product_6;
    let cos_theta_phidot_product_2 = cos_theta_phidot * air_velocity_2_inv_product;
    let sin_alpha_two_C_Ms_sum_sum = sin_alpha_two_C_Ms_sum - thetadot * air_velocity_1_inv_product;
    let part_of_air_velocity_1_sq_sum_2 =
        air_velocity_1_sq_product * (sin_alpha_two_C_Ms_sum_sum - cos_theta_phidot_product_2);
    let two_inv_sqrt_air_product = T::splat(2.0) * inv_sqrt_air_velocity_1_of_2;
    let minus_minus_w_plus_product_2 = minus_minus_w_plus_sum_3 * two_inv_sqrt_air_product;
    let air_velocity_1_sq_sum_2 =
        part_of_air_velocity_1_sq_sum_2 + air_velocity_2 * minus_minus_w_plus_product_2;
    let minus_inv_cos_theta_air_sum = -(inv_cos_theta * air_velocity_1_sq_sum_2);
    let C_Ms_inv_sqrt_air_product =
        C_Ms_inv_sqrt_air_product_4 * (inv_sqrt_air_velocity_1_of * sqrt_air_velocity_1_sq_of_2);
    let part_of_two_minus_air_velocity_2_sum_2 =
        air_velocity_2_air_product * C_Ms_inv_sqrt_air_product;
    let part_of_two_minus_air_velocity_2_sum =
        minus_w_plus_cos_product_7 * minus_air_velocity_product;
    let part_of_two_minus_air_velocity_2_sum_3 =
        part_of_two_minus_air_velocity_2_sum - part_of_two_minus_air_velocity_2_sum_2;
    let two_minus_air_velocity_2_sum = T::splat(2.0) * part_of_two_minus_air_velocity_2_sum_3;
    let part_of_two_minus_air_product_sum_5 =
        two_minus_air_velocity_2_sum * cos_theta_cos_phi_product;
    let thetadot_sin_theta_sum =
        thetadot * sin_theta_cos_phi_product + cos_theta_phidot * minus_cos_phi_wind_z_sum;
    let part_of_two_minus_air_product_sum = inv_sqrt_air_product_2_sum * sin_theta_cos_phi_product;
    let part_of_two_minus_air_product_sum_2 =
        thetadot_sin_theta_sum * air_velocity_2_inv_product - part_of_two_minus_air_product_sum;
    let part_of_two_minus_air_product_sum_3 =
        part_of_two_minus_air_product_sum_2 - minus_cos_phi_wind_z_sum * sin_alpha_two_C_Ms_sum_sum;
    let part_of_two_minus_air_product_sum_4 =
        air_velocity_1_sq_product * part_of_two_minus_air_product_sum_3;
    let part_of_two_minus_air_product_sum_6 =
        part_of_two_minus_air_product_sum_5 - part_of_two_minus_air_product_sum_4;
    let part_of_two_minus_air_product_sum_7 =
        minus_air_velocity_1_sum * minus_minus_w_plus_product_2;
    let two_minus_air_product_sum =
        part_of_two_minus_air_product_sum_6 + part_of_two_minus_air_product_sum_7;
    let minus_inv_cos_theta_two_sum = -(inv_cos_theta * two_minus_air_product_sum);
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let thetadot_r_I_a_inv_product_2 = thetadot_r_I_a_inv_product * sin_theta_inv_cos_theta;
    let part_of_inv_cos_theta_part_product_4 =
        minus_cos_theta_wind_x_sum * two_minus_air_velocity_2_sum;
    let air_velocity_2_sin_product = air_velocity_2 * sin_theta_phidot;
    let thetadot_cos_theta_sum = thetadot * cos_theta_cos_phi_sum + air_velocity_2_sin_product;
    let part_of_inv_cos_theta_part_product =
        air_velocity_2 * thetadot_cos_theta_sum + air_velocity_1_sq * sin_theta_phidot;
    let part_of_inv_cos_theta_part_product_2 =
        inv_sqrt_air_product * part_of_inv_cos_theta_part_product;
    let part_of_inv_cos_theta_part_product_3 =
        part_of_inv_cos_theta_part_product_2 - cos_theta_cos_phi_sum * inv_sqrt_air_product_2_sum;
    let part_of_inv_cos_theta_part_product_6 =
        air_velocity_1_sq_product * part_of_inv_cos_theta_part_product_3;
    let part_of_inv_cos_theta_part_product_5 =
        minus_two_plus_p1_inv_p2 * thetadot_cos_theta_phidot + part_of_inv_cos_theta_part_product_4;
    let part_of_inv_cos_theta_part_product_7 =
        part_of_inv_cos_theta_part_product_5 + part_of_inv_cos_theta_part_product_6;
    let part_of_inv_cos_theta_part_product_8 =
        part_of_inv_cos_theta_part_product_7 + inv_sqrt_air_product_6 * cos_theta_cos_phi_product_2;
    let inv_cos_theta_part_product = inv_cos_theta * part_of_inv_cos_theta_part_product_8;
    let air_velocity_1_sq_product_2 = air_velocity_1_sq_product * inv_sqrt_air_product;
    let air_velocity_1_sq_product_3 = air_velocity_1_sq_plus_sum * air_velocity_1_sq_product_2;
    let part_of_inv_cos_theta_sin_product =
        minus_two_plus_p1_inv_p2 * sin_theta * thetadot - cos_theta * air_velocity_1_sq_product_3;
    let inv_cos_theta_sin_product = inv_cos_theta * part_of_inv_cos_theta_sin_product;
    let thetadot_I_a_inv_I_d = inv_p2_p1 * thetadot;
    let sin_alpha_two_C_Ms_sum_sum_2 = sin_alpha_two_C_Ms_sum + cos_theta_phidot_product_2;
    let air_velocity_1_sq_product_4 = air_velocity_1_sq_product * sin_alpha_two_C_Ms_sum_sum_2;
    let part_of_minus_minus_minus_w_sum_2_5 =
        minus_minus_w_plus_cos_sum_4 * air_velocity_1_air_product;
    let air_velocity_1_sin_product = half_p5_p4_p3_inv_p2 * air_velocity_1_sin_sum;
    let part_of_minus_minus_minus_w_sum_2 =
        air_velocity_1_sq_plus_sum_2 * air_velocity_1_sin_product;
    let part_of_minus_minus_minus_w_sum_2_2 =
        air_velocity_2_air_product * C_Mq_air_velocity_1_cos_sum;
    let part_of_minus_minus_minus_w_sum_2_3 =
        part_of_minus_minus_minus_w_sum_2 + part_of_minus_minus_minus_w_sum_2_2;
    let part_of_minus_minus_minus_w_sum_2_4 =
        part_of_minus_minus_minus_w_sum_2_3 * inv_sqrt_air_product_5;
    let part_of_minus_minus_minus_w_sum_2_6 =
        part_of_minus_minus_minus_w_sum_2_4 - part_of_minus_minus_minus_w_sum_2_5;
    let minus_minus_minus_w_sum_2 =
        part_of_minus_minus_minus_w_sum_2_6 - air_velocity_1_sin_product;
    let minus_minus_minus_w_product = minus_minus_minus_w_sum_2 * two_inv_sqrt_air_product;
    let part_of_d_thetadot_dot_d_u =
        thetadot * air_velocity_1_sq_product_2 - minus_minus_minus_w_product;
    let part_of_d_thetadot_dot_d_u_2 =
        air_velocity_1_sq_product_4 + air_velocity_1 * part_of_d_thetadot_dot_d_u;
    let inv_sqrt_air_product_2_sum_2 = inv_sqrt_air_product_2 + thetadot_air_product;
    let part_of_d_thetadot_dot_d_v =
        air_velocity_1_sq_product * (cos_theta_phidot_product - inv_sqrt_air_product_2_sum_2);
    let part_of_d_thetadot_dot_d_v_2 =
        -(air_velocity_2 * minus_minus_minus_w_product) - part_of_d_thetadot_dot_d_v;
    let part_of_d_thetadot_dot_d_w =
        minus_w_plus_cos_theta_sum * two_inv_sqrt_air_product * air_velocity_1_sin_product;
    let part_of_d_thetadot_dot_d_w_2 =
        air_velocity_1_sq_product * air_velocity_1_two * C_Ms_inv_sqrt_air_product;
    let part_of_d_thetadot_dot_d_phi = sin_alpha_two_C_Ms_sum_sum_2 * sin_theta_cos_phi_product;
    let part_of_d_thetadot_dot_d_phi_2 =
        thetadot_sin_theta_sum * air_velocity_1_inv_product + part_of_d_thetadot_dot_d_phi;
    let part_of_d_thetadot_dot_d_phi_3 =
        part_of_d_thetadot_dot_d_phi_2 - minus_cos_phi_wind_z_sum * inv_sqrt_air_product_2_sum_2;
    let part_of_d_thetadot_dot_d_phi_4 =
        inv_sqrt_air_velocity_1_of_2 * minus_air_velocity_1_sum * minus_minus_minus_w_sum_2;
    let part_of_air_velocity_1_air_sum = air_velocity_1_sin_product * minus_w_plus_cos_product_7;
    let air_velocity_1_air_sum =
        air_velocity_1_air_product * C_Ms_inv_sqrt_air_product + part_of_air_velocity_1_air_sum;
    let part_of_d_thetadot_dot_d_phi_5 =
        part_of_d_thetadot_dot_d_phi_4 + air_velocity_1_air_sum * cos_theta_cos_phi_product;
    let part_of_d_thetadot_dot_d_phi_6 =
        -(air_velocity_1_sq_product * part_of_d_thetadot_dot_d_phi_3);
    let part_of_d_thetadot_dot_d_phi_7 =
        part_of_d_thetadot_dot_d_phi_6 - T::splat(2.0) * part_of_d_thetadot_dot_d_phi_5;
    let part_of_d_thetadot_dot_d_theta =
        T::splat(2.0) * minus_cos_theta_wind_x_sum * air_velocity_1_air_sum;
    let cos_theta_phidot_product_3 = minus_n1_plus_p1_inv_p2 * cos_theta_phidot;
    let part_of_d_thetadot_dot_d_theta_2 =
        sin_theta * sin_theta_phidot_minus_sum + cos_theta * cos_theta_phidot_product_3;
    let part_of_d_thetadot_dot_d_theta_3 =
        (air_velocity_2_sin_product - thetadot_cos_theta_sum) * air_velocity_1_sq_product_2;
    let part_of_d_thetadot_dot_d_theta_4 =
        cos_theta_cos_phi_sum * minus_minus_minus_w_product + part_of_d_thetadot_dot_d_theta_3;
    let part_of_d_thetadot_dot_d_theta_5 =
        cos_theta_cos_phi_sum * air_velocity_1_sq_product_4 - part_of_d_thetadot_dot_d_theta;
    let part_of_d_thetadot_dot_d_theta_6 =
        part_of_d_thetadot_dot_d_theta_5 + phidot * part_of_d_thetadot_dot_d_theta_2;
    let part_of_d_thetadot_dot_d_theta_7 =
        part_of_d_thetadot_dot_d_theta_6 - air_velocity_1 * part_of_d_thetadot_dot_d_theta_4;
    let part_of_d_thetadot_dot_d_phidot =
        sin_theta * cos_theta_phidot_product_3 - cos_theta * sin_theta_phidot_minus_sum;
    let d_thetadot_dot_d_r = inv_p2_p1 * cos_theta_phidot;
    let minus_air_velocity_1_sq_sum = -(air_velocity_1_sq_sum * sin_theta_inv_cos_theta);
    let part_of_d_gammadot_dot_d_theta_2 =
        cos_theta * (thetadot_r_I_a_inv_product + p14_inv_p1 * phidot);
    let part_of_d_gammadot_dot_d_theta =
        thetadot_r_I_a_inv_product_2 + phidot * thetadot + inv_cos_theta_part_product;
    let part_of_d_gammadot_dot_d_theta_3 =
        part_of_d_gammadot_dot_d_theta_2 + sin_theta * part_of_d_gammadot_dot_d_theta;
    let part_of_d_gammadot_dot_d_phidot =
        sin_theta * (inv_cos_theta_sin_product + p14_inv_p1) - cos_theta * thetadot;
    let part_of_d_gammadot_dot_d_thetadot =
        r_I_a_inv_I_d_minus_two_sum * sin_theta_inv_cos_theta - cos_theta_phidot;
    let minus_thetadot_r_I_a_inv_product = -thetadot_r_I_a_inv_product;
    let minus_cos_theta_sin_phi = -(cos_theta * sin_phi);
    let minus_sin_theta_cos_phi = -(sin_theta * cos_phi);
    let minus_x_dot_cos_phi = -(x_dot * cos_phi);
    let minus_w = -w;
    let minus_cos_theta_v = -(cos_theta * v);
    let minus_inv_cos_theta_two_product = -(inv_cos_theta * two_minus_air_velocity_2_sum);
    let minus_inv_cos_theta_sin_product = -inv_cos_theta_sin_product;
    let minus_r_I_a_inv_I_d_minus_product = -(r_I_a_inv_I_d_minus_two_sum * inv_cos_theta);
    let minus_inv_cos_theta_product = -(inv_cos_theta * thetadot_I_a_inv_I_d);

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
    j[14] = sin_theta_phidot - air_velocity_2_sqrt_product; // d_u_dot_d_v
    j[15] = -thetadot - air_velocity_1 * minus_minus_w_plus_cos_sum; // d_u_dot_d_w
    j[16] = part_of_d_u_dot_d_phi_2; // d_u_dot_d_phi
    j[17] = part_of_d_u_dot_d_theta_2; // d_u_dot_d_theta
    j[18] = sin_theta * v; // d_u_dot_d_phidot
    j[19] = minus_w; // d_u_dot_d_thetadot
    j[20] = -sin_theta_phidot - air_velocity_2_sqrt_product; // d_v_dot_d_u
    j[21] = part_of_d_v_dot_d_v; // d_v_dot_d_v
    j[22] = cos_theta_phidot - air_velocity_2 * minus_minus_w_plus_cos_sum; // d_v_dot_d_w
    j[23] = part_of_d_v_dot_d_phi - air_velocity_2 * minus_minus_w_plus_sum; // d_v_dot_d_phi
    j[24] = -(x_dot * phidot) - air_velocity_2 * minus_minus_w_plus_sum_2; // d_v_dot_d_theta
    j[25] = cos_theta_w_minus_u_sin_sum; // d_v_dot_d_phidot
    j[26] = thetadot + sqrt_air_velocity_1_sum_3 * air_velocity_1_two; // d_w_dot_d_u
    j[27] = air_velocity_2 * two_sqrt_air_product_2 - cos_theta_phidot; // d_w_dot_d_v
    j[28] = minus_minus_w_plus_cos_sum_3; // d_w_dot_d_w
    j[29] = part_of_d_w_dot_d_phi_2; // d_w_dot_d_phi
    j[30] = part_of_d_w_dot_d_theta_2; // d_w_dot_d_theta
    j[31] = minus_cos_theta_v; // d_w_dot_d_phidot
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
    j[36] = inv_cos_theta * air_velocity_1_sq_sum; // d_phidot_dot_d_u
    j[37] = minus_inv_cos_theta_air_sum; // d_phidot_dot_d_v
    j[38] = minus_inv_cos_theta_two_product; // d_phidot_dot_d_w
    j[39] = minus_inv_cos_theta_two_sum; // d_phidot_dot_d_phi
    j[40] = -thetadot_r_I_a_inv_product_2 - inv_cos_theta_part_product; // d_phidot_dot_d_theta
    j[41] = minus_inv_cos_theta_sin_product; // d_phidot_dot_d_phidot
    j[42] = minus_r_I_a_inv_I_d_minus_product; // d_phidot_dot_d_thetadot
    j[43] = minus_inv_cos_theta_product; // d_phidot_dot_d_gammadot
    j[44] = part_of_d_thetadot_dot_d_u_2; // d_thetadot_dot_d_u
    j[45] = part_of_d_thetadot_dot_d_v_2; // d_thetadot_dot_d_v
    j[46] = -part_of_d_thetadot_dot_d_w - part_of_d_thetadot_dot_d_w_2; // d_thetadot_dot_d_w
    j[47] = part_of_d_thetadot_dot_d_phi_7; // d_thetadot_dot_d_phi
    j[48] = part_of_d_thetadot_dot_d_theta_7; // d_thetadot_dot_d_theta
    j[49] = part_of_d_thetadot_dot_d_phidot; // d_thetadot_dot_d_phidot
    j[50] = air_velocity_1_sq_product_3; // d_thetadot_dot_d_thetadot
    j[51] = d_thetadot_dot_d_r; // d_thetadot_dot_d_gammadot
    j[52] = minus_air_velocity_1_sq_sum; // d_gammadot_dot_d_u
    j[53] = air_velocity_1_sq_sum_2 * sin_theta_inv_cos_theta; // d_gammadot_dot_d_v
    j[54] = sin_theta_inv_cos_theta * two_minus_air_velocity_2_sum; // d_gammadot_dot_d_w
    j[55] = two_minus_air_product_sum * sin_theta_inv_cos_theta; // d_gammadot_dot_d_phi
    j[56] = part_of_d_gammadot_dot_d_theta_3; // d_gammadot_dot_d_theta
    j[57] = part_of_d_gammadot_dot_d_phidot; // d_gammadot_dot_d_phidot
    j[58] = part_of_d_gammadot_dot_d_thetadot; // d_gammadot_dot_d_thetadot
    // d_gammadot_dot_d_gammadot
    j[59] = sin_theta_inv_cos_theta * thetadot_I_a_inv_I_d + p14_inv_p1;
}
