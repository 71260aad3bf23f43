// Written by `hyzer generate`; changes belong in the model.
//! `discus`: the named quantities.

use lanes::Real;

/// Every named quantity, see `QUANTITIES`.
///
/// 74 operations: 16 add, 45 mul, 3 div, 2 neg, 2 sqrt, 6 call.
/// `prepare` takes 7 operations for it.
#[inline(always)]
pub fn quantities<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 29],
    values: &mut [T; 36],
) {
    let phi = state[6];
    let (sin_phi, cos_phi) = phi.sin_cos();
    let theta = state[7];
    let (sin_theta, cos_theta) = theta.sin_cos();
    let phidot = state[9];
    let cos_theta_phidot = cos_theta * phidot;
    let gammadot = state[11];

    // discus.hyz:102  let r = dot(angular_velocity, d3);
    let r = sin_theta.mul_add(phidot, gammadot);
    values[29] = r;
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let minus_wind_y_sin_phi_sum = wind_y.neg_mul_add(sin_phi, wind_z * cos_phi);
    let v = state[4];

    // discus.hyz:84  let air_velocity = velocity - in_B(air);
    let air_velocity_2 = wind_y.neg_mul_add(cos_phi, wind_z.neg_mul_add(sin_phi, v));
    values[10] = air_velocity_2;
    let C_Nr = parameters[14];

    // discus.hyz:109  let spin_down = C_Nr*r;
    let spin_down = C_Nr * r;
    values[35] = spin_down;
    let wind_x = parameters[15];
    let u = state[3];
    let air_velocity_1 = sin_theta.mul_sub(minus_wind_y_sin_phi_sum, wind_x * cos_theta) + u;
    values[9] = air_velocity_1;
    let w = state[5];
    let minus_air_velocity_3 = minus_wind_y_sin_phi_sum.mul_add(cos_theta, wind_x * sin_theta) - w;
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let thetadot = state[10];
    let air_velocity_1_thetadot_sum =
        air_velocity_1.mul_sub(thetadot, air_velocity_2 * cos_theta_phidot);
    let part_of_rate_1 = air_velocity_1.mul_add(cos_theta_phidot, air_velocity_2 * thetadot);
    let air_velocity_3 = -minus_air_velocity_3;
    values[11] = air_velocity_3;
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);

    // discus.hyz:86  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    values[15] = V;
    let half_rho_A = prepared[17];
    let V_sq_half_rho_A = half_rho_A * V_sq;
    let rho_half = prepared[20];
    values[23] = rho_half * V_sq;

    // discus.hyz:91  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    values[22] = alpha;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let inv_V = V.recip_or_zero();

    // discus.hyz:103  let rate_1 = dot(angular_velocity, d1);
    let rate_1 = inv_air_velocity_12 * part_of_rate_1;
    values[30] = rate_1;

    // discus.hyz:87  let d1 = unit(air_velocity - dot(air_velocity, d3)*d3);
    let d1_2 = air_velocity_2 * inv_air_velocity_12;
    values[17] = d1_2;
    let d1_1 = air_velocity_1 * inv_air_velocity_12;
    values[16] = d1_1;
    values[20] = d1_1;

    // discus.hyz:104  let rate_2 = dot(angular_velocity, d2);
    let rate_2 = inv_air_velocity_12 * air_velocity_1_thetadot_sum;
    values[31] = rate_2;
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;
    let C_Mq = parameters[13];
    let part_of_pitch = C_Mq * inv_air_velocity_12 * air_velocity_1_thetadot_sum;
    let d2_1 = -d1_2;
    values[19] = d2_1;
    let inv_s_stall = prepared[0];
    let inv_s_stall_minus_product = inv_s_stall * minus_air_velocity_3_inv_V;
    let half_d = prepared[27];
    values[32] = half_d * inv_V * r;
    let d_C_Mq = prepared[28];
    values[33] = d_C_Mq * rate_1 * V_sq_half_rho_A;
    let inv_s_stall_minus_product_sq = inv_s_stall_minus_product * inv_s_stall_minus_product;
    let C_Ds = parameters[11];
    let C_D0 = parameters[10];

    // discus.hyz:97  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = minus_air_velocity_3_inv_V.mul_add(C_Ds * minus_air_velocity_3_inv_V, C_D0);
    values[26] = C_D;
    let inv_s_stall_minus_product_2 = inv_s_stall_minus_product_sq * inv_s_stall_minus_product_sq;
    values[28] = C_D * V_sq_half_rho_A;
    let part_of_attached =
        inv_s_stall_minus_product_2.mul_add(inv_s_stall_minus_product_2, T::splat(1.0));
    let attached = T::splat(1.0) / part_of_attached;
    values[24] = attached;
    let sin_alpha_two = (T::splat(2.0) * alpha).sin_cos().0;
    let minus_C_Lp_plus_C_Ls = prepared[1];
    let C_Lp = parameters[8];

    // discus.hyz:96  let C_L = (C_Lp + (C_Ls - C_Lp)*attached)*sin(2*alpha);
    let C_L = sin_alpha_two * minus_C_Lp_plus_C_Ls.mul_add(attached, C_Lp);
    values[25] = C_L;
    values[27] = C_L * V_sq_half_rho_A;
    let d = parameters[3];
    let C_Ms = parameters[12];
    values[34] = d * C_Ms.mul_add(sin_alpha_two, part_of_pitch) * V_sq_half_rho_A;

    values[0] = wind_x;
    values[1] = wind_y;
    values[2] = wind_z;
    let rho = parameters[5];
    values[3] = rho;
    let g = parameters[6];
    values[4] = g;
    let I_d = parameters[2];
    values[5] = I_d;
    values[6] = I_d;
    values[7] = T::splat(0.0);
    values[8] = T::splat(0.0);
    values[12] = T::splat(0.0);
    values[13] = T::splat(0.0);
    values[14] = T::splat(1.0);
    values[18] = T::splat(0.0);
    values[21] = T::splat(0.0);
}
