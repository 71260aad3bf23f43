// Written by `hyzer generate`; changes belong in the model.
//! `discus`: the named quantities.

use lanes::Real;

/// Every named quantity, see `QUANTITIES`.
///
/// 72 operations: 16 add, 43 mul, 3 div, 2 neg, 2 sqrt, 6 call.
/// `prepare` takes 6 operations for it.
#[inline(always)]
pub fn quantities<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 28],
    values: &mut [T; 26],
) {
    let u = state[3];
    let v = state[4];
    let w = state[5];
    let phi = state[6];
    let theta = state[7];
    let phidot = state[9];
    let thetadot = state[10];
    let gammadot = state[11];
    let d = parameters[3];
    let C_Lp = parameters[8];
    let C_D0 = parameters[10];
    let C_Ds = parameters[11];
    let C_Ms = parameters[12];
    let C_Mq = parameters[13];
    let C_Nr = parameters[14];
    let wind_x = parameters[15];
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let minus_C_Lp_plus_C_Ls = prepared[0];
    let inv_s_stall = prepared[1];
    let half_rho_A = prepared[14];
    let rho_half = prepared[20];
    let C_Mq_d = prepared[27];
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let minus_sin_phi_wind_y_sum = wind_z * cos_phi - wind_y * sin_phi;

    // discus.hyz:71  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = sin_theta * minus_sin_phi_wind_y_sum - wind_x * cos_theta + u;
    let air_velocity_2 = v - wind_z * sin_phi - wind_y * cos_phi;
    let minus_air_velocity_3 = wind_x * sin_theta + minus_sin_phi_wind_y_sum * cos_theta - w;
    let air_velocity_12_sq = air_velocity_2 * air_velocity_2 + air_velocity_1 * air_velocity_1;
    let V_sq = minus_air_velocity_3 * minus_air_velocity_3 + air_velocity_12_sq;

    // discus.hyz:73  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();

    // discus.hyz:74  let d1 = unit(air_velocity - dot(air_velocity, d3)*d3);
    let d1_1 = air_velocity_1 * inv_air_velocity_12;
    let d1_2 = air_velocity_2 * inv_air_velocity_12;

    // discus.hyz:78  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    let inv_V = V.recip_or_zero();
    let minus_air_velocity_3_inv_V = minus_air_velocity_3 * inv_V;
    let inv_s_stall_minus_product = inv_s_stall * minus_air_velocity_3_inv_V;
    let inv_s_stall_minus_product_sq = inv_s_stall_minus_product * inv_s_stall_minus_product;
    let inv_s_stall_minus_product_2 = inv_s_stall_minus_product_sq * inv_s_stall_minus_product_sq;
    let part_of_attached =
        T::splat(1.0) + inv_s_stall_minus_product_2 * inv_s_stall_minus_product_2;
    let attached = T::splat(1.0) / part_of_attached;
    let sin_alpha_two = (T::splat(2.0) * alpha).sin_cos().0;

    // discus.hyz:83  let C_L = (C_Lp + (C_Ls - C_Lp)*attached)*sin(2*alpha);
    let C_L = sin_alpha_two * (C_Lp + minus_C_Lp_plus_C_Ls * attached);

    // discus.hyz:84  let C_D = C_D0 + C_Ds*sin(alpha)^2;
    let C_D = C_Ds * minus_air_velocity_3_inv_V * minus_air_velocity_3_inv_V + C_D0;
    let V_sq_half_rho_A = half_rho_A * V_sq;

    // discus.hyz:89  let r = dot(angular_velocity, d3);
    let r = sin_theta * phidot + gammadot;
    let cos_theta_phidot = cos_theta * phidot;

    // discus.hyz:90  let rate_1 = dot(angular_velocity, d1);
    let rate_1 =
        inv_air_velocity_12 * (air_velocity_2 * thetadot + air_velocity_1 * cos_theta_phidot);
    let air_velocity_1_thetadot_sum = air_velocity_1 * thetadot - air_velocity_2 * cos_theta_phidot;

    // discus.hyz:91  let rate_2 = dot(angular_velocity, d2);
    let rate_2 = inv_air_velocity_12 * air_velocity_1_thetadot_sum;
    let part_of_pitch =
        C_Mq * inv_air_velocity_12 * air_velocity_1_thetadot_sum + C_Ms * sin_alpha_two;

    // discus.hyz:94  let spin_down = C_Nr*r;
    let spin_down = C_Nr * r;
    let air_velocity_3 = -minus_air_velocity_3;
    let d2_1 = -d1_2;

    values[0] = air_velocity_1;
    values[1] = air_velocity_2;
    values[2] = air_velocity_3;
    values[3] = T::splat(0.0);
    values[4] = T::splat(0.0);
    values[5] = T::splat(1.0);
    values[6] = V;
    values[7] = d1_1;
    values[8] = d1_2;
    values[9] = T::splat(0.0);
    values[10] = d2_1;
    values[11] = d1_1;
    values[12] = T::splat(0.0);
    values[13] = alpha;
    values[14] = rho_half * V_sq;
    values[15] = attached;
    values[16] = C_L;
    values[17] = C_D;
    values[18] = C_L * V_sq_half_rho_A;
    values[19] = C_D * V_sq_half_rho_A;
    values[20] = r;
    values[21] = rate_1;
    values[22] = rate_2;
    values[23] = C_Mq_d * rate_1 * V_sq_half_rho_A;
    values[24] = d * part_of_pitch * V_sq_half_rho_A;
    values[25] = spin_down;
}
