// Written by `hyzer generate`; changes belong in the model.
//! `disc`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 347 operations: 106 add, 214 mul, 3 div, 16 neg, 2 sqrt, 5 call, 1 select.
#[inline(always)]
pub fn f_jac<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 26],
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
    let air_velocity_2_sq = air_velocity_2 * air_velocity_2;
    let air_velocity_1_sq_plus_sum = air_velocity_1 * air_velocity_1 + air_velocity_2_sq;
    let cos_theta_cos_phi_sum = cos_theta * cos_phi_wind_z_minus_sum + wind_x * sin_theta;
    let minus_w_plus_cos_theta_sum = cos_theta_cos_phi_sum - w;
    let air_velocity_1_sq_plus_sum_2 =
        air_velocity_1_sq_plus_sum + minus_w_plus_cos_theta_sum * minus_w_plus_cos_theta_sum;

    // disc.hyz:64  let V = norm(air_velocity);
    let V = air_velocity_1_sq_plus_sum_2.sqrt();
    let V_part_part_half_inv_m = inv_p0_half_p5_p4 * V;
    let sqrt_air_velocity_1_sq_of = air_velocity_1_sq_plus_sum.sqrt();

    // disc.hyz:69  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_w_plus_cos_theta_sum.atan2(sqrt_air_velocity_1_sq_of);

    // disc.hyz:72  let C_L = C_L0 + C_La*alpha;
    let C_L = C_L0 + C_La * alpha;

    // disc.hyz:73  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_D0 + C_Da * alpha * alpha;
    let minus_w_plus_cos_sum = minus_w_plus_cos_theta_sum * C_L - sqrt_air_velocity_1_sq_of * C_D;
    let inv_sqrt_air_velocity_1_of = sqrt_air_velocity_1_sq_of.recip_or_zero();
    let minus_w_plus_cos_product = minus_w_plus_cos_sum * inv_sqrt_air_velocity_1_of;
    let V_part_part_half_product = V_part_part_half_inv_m * minus_w_plus_cos_product;
    let part_of_u_dot = sin_theta_v_phidot_product + air_velocity_1 * V_part_part_half_product;

    // disc.hyz:56  velocity (u, v, w) in B;
    let u_dot = part_of_u_dot - w * thetadot;
    let sin_phi_g = g * sin_phi;
    let part_of_v_dot =
        cos_theta_w_minus_u_sin_sum * phidot + air_velocity_2 * V_part_part_half_product;
    let v_dot = part_of_v_dot - sin_phi_g;
    let cos_theta_v_phidot_product = cos_theta * v_phidot_plus_cos_phi_g;
    let sqrt_air_velocity_1_sum =
        sqrt_air_velocity_1_sq_of * C_L + minus_w_plus_cos_theta_sum * C_D;
    let part_of_w_dot =
        V_part_part_half_inv_m * sqrt_air_velocity_1_sum - cos_theta_v_phidot_product;
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
    let inv_V = V.recip_or_zero();
    let inv_V_part_part_half_inv_m = inv_p0_half_p5_p4 * inv_V;
    let alpha_C_Da_two = p10_two * alpha;
    let C_La_minus_w_plus_sum =
        C_La * minus_w_plus_cos_theta_sum - sqrt_air_velocity_1_sq_of * alpha_C_Da_two;
    let inv_V_sq = inv_V * inv_V;
    let minus_w_plus_cos_product_2 = minus_w_plus_cos_theta_sum * inv_V_sq;
    let part_of_minus_w_plus_cos_sum_2 =
        C_D + C_La_minus_w_plus_sum * minus_w_plus_cos_product_2 + minus_w_plus_cos_product;
    let part_of_minus_w_plus_cos_sum_2_2 =
        V_part_part_half_inv_m * inv_sqrt_air_velocity_1_of * part_of_minus_w_plus_cos_sum_2;
    let minus_w_plus_cos_sum_2 =
        minus_w_plus_cos_sum * inv_V_part_part_half_inv_m - part_of_minus_w_plus_cos_sum_2_2;
    let air_velocity_1_inv_product = air_velocity_1 * inv_sqrt_air_velocity_1_of;
    let minus_w_plus_cos_product_3 = minus_w_plus_cos_sum_2 * air_velocity_1_inv_product;
    let part_of_d_u_dot_d_u =
        V_part_part_half_product + air_velocity_1 * minus_w_plus_cos_product_3;
    let air_velocity_2_product = air_velocity_2 * minus_w_plus_cos_product_3;
    let minus_w_plus_cos_product_4 = minus_w_plus_cos_theta_sum * inv_V_part_part_half_inv_m;
    let part_of_minus_w_plus_cos_sum_3 =
        nonzero_sqrt_air_of * C_La_minus_w_plus_sum * inv_V_sq + C_L * inv_sqrt_air_velocity_1_of;
    let part_of_minus_w_plus_cos_sum_3_2 = V_part_part_half_inv_m * part_of_minus_w_plus_cos_sum_3;
    let minus_w_plus_cos_sum_3 =
        minus_w_plus_cos_product * minus_w_plus_cos_product_4 + part_of_minus_w_plus_cos_sum_3_2;
    let part_of_d_u_dot_d_phi = sin_phi_g + V_part_part_half_product * cos_phi_wind_y_plus_sin_sum;
    let sin_theta_cos_phi_product = sin_theta * cos_phi_wind_y_plus_sin_sum;
    let minus_cos_phi_wind_z_sum = -cos_phi_wind_z_minus_sum;
    let minus_air_velocity_1_sum =
        air_velocity_2 * minus_cos_phi_wind_z_sum - air_velocity_1 * sin_theta_cos_phi_product;
    let inv_sqrt_air_product_3 = inv_sqrt_air_velocity_1_of * minus_w_plus_cos_sum_2;
    let cos_theta_cos_phi_product = cos_theta * cos_phi_wind_y_plus_sin_sum;
    let part_of_minus_air_velocity_sum = minus_w_plus_cos_sum_3 * cos_theta_cos_phi_product;
    let minus_air_velocity_sum =
        minus_air_velocity_1_sum * inv_sqrt_air_product_3 - part_of_minus_air_velocity_sum;
    let part_of_d_u_dot_d_phi_2 =
        air_velocity_1 * minus_air_velocity_sum - sin_theta * part_of_d_u_dot_d_phi;
    let part_of_cos_theta_cos_phi_sum_2 = minus_w_plus_cos_sum_3 * minus_cos_theta_wind_x_sum;
    let cos_theta_cos_phi_sum_2 =
        cos_theta_cos_phi_sum * minus_w_plus_cos_product_3 - part_of_cos_theta_cos_phi_sum_2;
    let part_of_d_u_dot_d_theta =
        cos_theta_v_phidot_product + V_part_part_half_product * cos_theta_cos_phi_sum;
    let part_of_d_u_dot_d_theta_2 =
        part_of_d_u_dot_d_theta + air_velocity_1 * cos_theta_cos_phi_sum_2;
    let part_of_d_v_dot_d_v = V_part_part_half_product + air_velocity_2_sq * inv_sqrt_air_product_3;
    let part_of_d_v_dot_d_phi = V_part_part_half_product * minus_cos_phi_wind_z_sum - cos_phi_g;
    let part_of_sqrt_air_velocity_1_sum_2 =
        sqrt_air_velocity_1_sq_of * sqrt_air_velocity_1_sum * inv_V_part_part_half_inv_m;
    let C_La_sqrt_air_product_sum =
        C_La * sqrt_air_velocity_1_sq_of + minus_w_plus_cos_theta_sum * alpha_C_Da_two;
    let part_of_sqrt_air_velocity_1_sum_2_2 =
        V_part_part_half_inv_m * (C_L - C_La_sqrt_air_product_sum * minus_w_plus_cos_product_2);
    let sqrt_air_velocity_1_sum_2 =
        part_of_sqrt_air_velocity_1_sum_2 + part_of_sqrt_air_velocity_1_sum_2_2;
    let sqrt_air_velocity_1_product = sqrt_air_velocity_1_sum_2 * air_velocity_1_inv_product;
    let inv_sqrt_air_product_4 = inv_sqrt_air_velocity_1_of * sqrt_air_velocity_1_sum_2;
    let part_of_C_D_V_part_part_half_sum_2 = sqrt_air_velocity_1_sum * minus_w_plus_cos_product_4;
    let part_of_C_D_V_part_part_half_sum =
        sqrt_air_velocity_1_sq_of * V_part_part_half_inv_m * C_La_sqrt_air_product_sum;
    let part_of_C_D_V_part_part_half_sum_3 =
        part_of_C_D_V_part_part_half_sum_2 + part_of_C_D_V_part_part_half_sum * inv_V_sq;
    let C_D_V_part_part_half_sum =
        C_D * V_part_part_half_inv_m + part_of_C_D_V_part_part_half_sum_3;
    let part_of_d_w_dot_d_phi = sin_phi_g - cos_phi_wind_y_plus_sin_sum * C_D_V_part_part_half_sum;
    let part_of_d_w_dot_d_phi_2 =
        minus_air_velocity_1_sum * inv_sqrt_air_product_4 + cos_theta * part_of_d_w_dot_d_phi;
    let part_of_d_w_dot_d_theta =
        sin_theta_v_phidot_product + cos_theta_cos_phi_sum * sqrt_air_velocity_1_product;
    let part_of_d_w_dot_d_theta_2 =
        part_of_d_w_dot_d_theta - minus_cos_theta_wind_x_sum * C_D_V_part_part_half_sum;
    let sqrt_air_velocity_1_product_2 = two_p3_part_part_half_inv_p2 * sqrt_air_velocity_1_sq_of;
    let part_of_minus_inv_sqrt_air_sum_2 = inv_sqrt_air_product_sum * sqrt_air_velocity_1_product_2;
    let air_velocity_2_C_Ma = C_Ma * air_velocity_2;
    let part_of_minus_inv_sqrt_air_sum =
        inv_sqrt_air_product - minus_w_plus_cos_product_2 * air_velocity_2_C_Ma;
    let inv_sqrt_air_product_5 = inv_sqrt_air_velocity_1_of * air_velocity_1_sq_product;
    let minus_inv_sqrt_air_sum =
        part_of_minus_inv_sqrt_air_sum * inv_sqrt_air_product_5 - part_of_minus_inv_sqrt_air_sum_2;
    let air_velocity_1_sq_product_2 = air_velocity_1_sq_product * r_C_Rr;
    let air_velocity_1_product_sum =
        air_velocity_1 * minus_inv_sqrt_air_sum - air_velocity_1_sq_product_2;
    let inv_sqrt_air_product_6 = inv_sqrt_air_velocity_1_of * inv_cos_theta;
    let minus_air_velocity_1_product = -(air_velocity_1_product_sum * inv_sqrt_air_product_6);
    let air_velocity_1_sq_product_3 = air_velocity_1_sq_product * alpha_C_Ma;
    let air_velocity_2_product_sum =
        air_velocity_2 * minus_inv_sqrt_air_sum + air_velocity_1_sq_product_3;
    let minus_air_velocity_2_product = -(air_velocity_2_product_sum * inv_sqrt_air_product_6);
    let air_velocity_1_sq_product_4 = air_velocity_1_sq_product * inv_V_sq;
    let minus_w_plus_cos_product_5 = two_p3_part_part_half_inv_p2 * minus_w_plus_cos_theta_sum;
    let part_of_air_velocity_2_C_Ma_sum = inv_sqrt_air_product_sum * minus_w_plus_cos_product_5;
    let air_velocity_2_C_Ma_sum =
        air_velocity_2_C_Ma * air_velocity_1_sq_product_4 - part_of_air_velocity_2_C_Ma_sum;
    let inv_cos_theta_air_product = inv_cos_theta * air_velocity_2_C_Ma_sum;
    let part_of_cos_phi_wind_y_plus_sum =
        r_C_Rr * sin_theta_cos_phi_product + alpha_C_Ma * minus_cos_phi_wind_z_sum;
    let part_of_cos_phi_wind_y_plus_sum_2 =
        air_velocity_1_sq_product * part_of_cos_phi_wind_y_plus_sum;
    let part_of_cos_phi_wind_y_plus_sum_3 =
        minus_air_velocity_1_sum * minus_inv_sqrt_air_sum + part_of_cos_phi_wind_y_plus_sum_2;
    let part_of_cos_phi_wind_y_plus_sum_4 =
        part_of_cos_phi_wind_y_plus_sum_3 * inv_sqrt_air_product_6;
    let cos_phi_wind_y_plus_sum =
        cos_phi_wind_y_plus_sin_sum * air_velocity_2_C_Ma_sum - part_of_cos_phi_wind_y_plus_sum_4;
    let sin_theta_inv_cos_theta = sin_theta * inv_cos_theta;
    let air_velocity_1_sq_product_5 = air_velocity_1_sq_product * C_Mq_nonzero_sqrt_air_of;
    let part_of_part_part_plus_part_sum_sum =
        minus_thetadot_r_I_product - phidot * air_velocity_1_sq_product_5;
    let part_of_part_part_plus_part_sum_sum_5 =
        sin_theta_inv_cos_theta * part_of_part_part_plus_part_sum_sum;
    let phidot_thetadot = phidot * thetadot;
    let inv_cos_theta_cos_product = inv_cos_theta * cos_theta_cos_phi_sum;
    let part_of_part_part_plus_part_sum_sum_2 =
        r_C_Rr * inv_sqrt_air_product_5 * inv_cos_theta_cos_product;
    let air_velocity_1_sq_sum =
        C_Rr * air_velocity_1_sq_product * air_velocity_1_inv_product - inv_p2_p1 * thetadot;
    let part_of_part_part_plus_part_sum_sum_3 =
        part_of_part_part_plus_part_sum_sum_2 + phidot * air_velocity_1_sq_sum;
    let part_of_part_part_plus_part_sum_sum_4 =
        T::splat(2.0) * phidot_thetadot + part_of_part_part_plus_part_sum_sum_3;
    let part_of_part_part_plus_part_sum_sum_6 =
        part_of_part_part_plus_part_sum_sum_5 + part_of_part_part_plus_part_sum_sum_4;
    let part_of_part_part_plus_part_sum_sum_7 =
        minus_inv_sqrt_air_sum * air_velocity_1_inv_product * inv_cos_theta_cos_product;
    let part_of_part_part_plus_part_sum_sum_8 =
        minus_cos_theta_wind_x_sum * inv_cos_theta_air_product;
    let part_of_part_part_plus_part_sum_sum_9 =
        part_of_part_part_plus_part_sum_sum_7 - part_of_part_part_plus_part_sum_sum_8;
    let part_part_plus_part_sum_sum =
        part_of_part_part_plus_part_sum_sum_6 - part_of_part_part_plus_part_sum_sum_9;
    let air_velocity_1_sq_product_6 = air_velocity_1_sq_sum * sin_theta_inv_cos_theta;
    let part_of_air_velocity_1_sq_sum_2 = air_velocity_1_sq_product_6 + air_velocity_1_sq_product_5;
    let air_velocity_1_sq_sum_2 =
        part_of_air_velocity_1_sq_sum_2 + T::splat(2.0) * thetadot * sin_theta_inv_cos_theta;
    let part_of_minus_inv_sqrt_air_sum_2_4 =
        inv_sqrt_air_product_2_sum * sqrt_air_velocity_1_product_2;
    let air_velocity_1_C_Ma = C_Ma * air_velocity_1;
    let part_of_minus_inv_sqrt_air_sum_2_2 =
        inv_sqrt_air_product_2 + minus_w_plus_cos_product_2 * air_velocity_1_C_Ma;
    let part_of_minus_inv_sqrt_air_sum_2_3 =
        part_of_minus_inv_sqrt_air_sum_2_2 * inv_sqrt_air_product_5;
    let minus_inv_sqrt_air_sum_2 =
        part_of_minus_inv_sqrt_air_sum_2_3 - part_of_minus_inv_sqrt_air_sum_2_4;
    let part_of_inv_sqrt_air_product_7 =
        air_velocity_1_sq_product_3 - air_velocity_1 * minus_inv_sqrt_air_sum_2;
    let inv_sqrt_air_product_7 = inv_sqrt_air_velocity_1_of * part_of_inv_sqrt_air_product_7;
    let part_of_d_thetadot_dot_d_v =
        air_velocity_1_sq_product_2 - air_velocity_2 * minus_inv_sqrt_air_sum_2;
    let part_of_air_velocity_1_C_Ma_sum = inv_sqrt_air_product_2_sum * minus_w_plus_cos_product_5;
    let air_velocity_1_C_Ma_sum =
        air_velocity_1_C_Ma * air_velocity_1_sq_product_4 + part_of_air_velocity_1_C_Ma_sum;
    let part_of_d_thetadot_dot_d_phi =
        alpha_C_Ma * sin_theta_cos_phi_product - r_C_Rr * minus_cos_phi_wind_z_sum;
    let part_of_d_thetadot_dot_d_phi_2 = air_velocity_1_sq_product * part_of_d_thetadot_dot_d_phi;
    let part_of_d_thetadot_dot_d_phi_3 =
        minus_air_velocity_1_sum * minus_inv_sqrt_air_sum_2 + part_of_d_thetadot_dot_d_phi_2;
    let part_of_d_thetadot_dot_d_phi_4 =
        inv_sqrt_air_velocity_1_of * part_of_d_thetadot_dot_d_phi_3;
    let part_of_d_thetadot_dot_d_phi_5 =
        -(air_velocity_1_C_Ma_sum * cos_theta_cos_phi_product) - part_of_d_thetadot_dot_d_phi_4;
    let part_of_d_thetadot_dot_d_theta_2 = minus_cos_theta_wind_x_sum * air_velocity_1_C_Ma_sum;
    let air_velocity_2_C_Rr_sum =
        C_Rr * air_velocity_2 * inv_sqrt_air_product_5 + inv_p2_p1 * cos_theta_phidot;
    let minus_cos_theta_phidot_sum = air_velocity_2_C_Rr_sum - cos_theta_phidot;
    let part_of_d_thetadot_dot_d_theta =
        sin_theta * sin_theta_phidot_minus_sum + cos_theta * minus_cos_theta_phidot_sum;
    let part_of_d_thetadot_dot_d_theta_3 =
        cos_theta_cos_phi_sum * inv_sqrt_air_product_7 - part_of_d_thetadot_dot_d_theta_2;
    let part_of_d_thetadot_dot_d_theta_4 =
        part_of_d_thetadot_dot_d_theta_3 + phidot * part_of_d_thetadot_dot_d_theta;
    let part_of_d_thetadot_dot_d_phidot =
        sin_theta * minus_cos_theta_phidot_sum - cos_theta * sin_theta_phidot_minus_sum;
    let inv_sqrt_air_product_8 = inv_sqrt_air_velocity_1_of * sin_theta_inv_cos_theta;
    let minus_sin_theta_cos_phi_sum = -(sin_theta * cos_phi_wind_y_plus_sum);
    let part_of_d_gammadot_dot_d_theta_2 =
        sin_theta * (phidot_thetadot - part_part_plus_part_sum_sum);
    let part_of_d_gammadot_dot_d_theta =
        cos_theta * (minus_thetadot_r_I_product - p14_inv_p1 * phidot);
    let part_of_d_gammadot_dot_d_theta_3 =
        part_of_d_gammadot_dot_d_theta_2 - part_of_d_gammadot_dot_d_theta;
    let part_of_d_gammadot_dot_d_phidot =
        sin_theta * (p14_inv_p1 - air_velocity_1_sq_sum_2) - cos_theta * thetadot;
    let part_of_d_gammadot_dot_d_thetadot =
        r_I_a_inv_I_d_minus_sin_sum * sin_theta_inv_cos_theta - cos_theta_phidot;
    let minus_cos_theta_sin_phi = -(cos_theta * sin_phi);
    let minus_z_dot = -z_dot;
    let minus_sin_theta_cos_phi = -(sin_theta * cos_phi);
    let minus_x_dot_cos_phi = -(x_dot * cos_phi);
    let minus_w = -w;
    let minus_C_D_V_part_part_half_sum = -C_D_V_part_part_half_sum;
    let minus_cos_theta_v = -(cos_theta * v);
    let minus_r_I_a_inv_I_d_minus_product = -(r_I_a_inv_I_d_minus_sin_sum * inv_cos_theta);
    let minus_air_velocity_1_C_Ma_sum = -air_velocity_1_C_Ma_sum;
    let minus_air_velocity_2_C_Ma_product = -(air_velocity_2_C_Ma_sum * sin_theta_inv_cos_theta);

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
    j[10] = cos_theta * cos_phi; // d_z_dot_d_w
    j[11] = y_dot; // d_z_dot_d_phi
    j[12] = minus_x_dot_cos_phi; // d_z_dot_d_theta
    j[13] = part_of_d_u_dot_d_u; // d_u_dot_d_u
    j[14] = sin_theta_phidot + air_velocity_2_product; // d_u_dot_d_v
    j[15] = -thetadot - air_velocity_1 * minus_w_plus_cos_sum_3; // d_u_dot_d_w
    j[16] = part_of_d_u_dot_d_phi_2; // d_u_dot_d_phi
    j[17] = part_of_d_u_dot_d_theta_2; // d_u_dot_d_theta
    j[18] = sin_theta * v; // d_u_dot_d_phidot
    j[19] = minus_w; // d_u_dot_d_thetadot
    j[20] = air_velocity_2_product - sin_theta_phidot; // d_v_dot_d_u
    j[21] = part_of_d_v_dot_d_v; // d_v_dot_d_v
    j[22] = cos_theta_phidot - air_velocity_2 * minus_w_plus_cos_sum_3; // d_v_dot_d_w
    j[23] = part_of_d_v_dot_d_phi + air_velocity_2 * minus_air_velocity_sum; // d_v_dot_d_phi
    j[24] = air_velocity_2 * cos_theta_cos_phi_sum_2 - x_dot * phidot; // d_v_dot_d_theta
    j[25] = cos_theta_w_minus_u_sin_sum; // d_v_dot_d_phidot
    j[26] = thetadot + sqrt_air_velocity_1_product; // d_w_dot_d_u
    j[27] = air_velocity_2 * inv_sqrt_air_product_4 - cos_theta_phidot; // d_w_dot_d_v
    j[28] = minus_C_D_V_part_part_half_sum; // d_w_dot_d_w
    j[29] = part_of_d_w_dot_d_phi_2; // d_w_dot_d_phi
    j[30] = part_of_d_w_dot_d_theta_2; // d_w_dot_d_theta
    j[31] = minus_cos_theta_v; // d_w_dot_d_phidot
    j[32] = u; // d_w_dot_d_thetadot
    j[33] = T::splat(1.0); // d_phi_dot_d_phidot
    j[34] = T::splat(1.0); // d_theta_dot_d_thetadot
    j[35] = T::splat(1.0); // d_gamma_dot_d_gammadot
    j[36] = minus_air_velocity_1_product; // d_phidot_dot_d_u
    j[37] = minus_air_velocity_2_product; // d_phidot_dot_d_v
    j[38] = inv_cos_theta_air_product; // d_phidot_dot_d_w
    j[39] = cos_phi_wind_y_plus_sum; // d_phidot_dot_d_phi
    j[40] = part_part_plus_part_sum_sum; // d_phidot_dot_d_theta
    j[41] = air_velocity_1_sq_sum_2; // d_phidot_dot_d_phidot
    j[42] = minus_r_I_a_inv_I_d_minus_product; // d_phidot_dot_d_thetadot
    j[43] = inv_cos_theta * air_velocity_1_sq_sum; // d_phidot_dot_d_gammadot
    j[44] = inv_sqrt_air_product_7; // d_thetadot_dot_d_u
    j[45] = inv_sqrt_air_velocity_1_of * part_of_d_thetadot_dot_d_v; // d_thetadot_dot_d_v
    j[46] = minus_air_velocity_1_C_Ma_sum; // d_thetadot_dot_d_w
    j[47] = part_of_d_thetadot_dot_d_phi_5; // d_thetadot_dot_d_phi
    j[48] = part_of_d_thetadot_dot_d_theta_4; // d_thetadot_dot_d_theta
    j[49] = part_of_d_thetadot_dot_d_phidot; // d_thetadot_dot_d_phidot
    j[50] = air_velocity_1_sq_product_5; // d_thetadot_dot_d_thetadot
    j[51] = air_velocity_2_C_Rr_sum; // d_thetadot_dot_d_gammadot
    j[52] = air_velocity_1_product_sum * inv_sqrt_air_product_8; // d_gammadot_dot_d_u
    j[53] = air_velocity_2_product_sum * inv_sqrt_air_product_8; // d_gammadot_dot_d_v
    j[54] = minus_air_velocity_2_C_Ma_product; // d_gammadot_dot_d_w
    j[55] = minus_sin_theta_cos_phi_sum; // d_gammadot_dot_d_phi
    j[56] = part_of_d_gammadot_dot_d_theta_3; // d_gammadot_dot_d_theta
    j[57] = part_of_d_gammadot_dot_d_phidot; // d_gammadot_dot_d_phidot
    j[58] = part_of_d_gammadot_dot_d_thetadot; // d_gammadot_dot_d_thetadot
    j[59] = p14_inv_p1 - air_velocity_1_sq_product_6; // d_gammadot_dot_d_gammadot
}
