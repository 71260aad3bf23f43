// Written by `hyzer generate`; changes belong in the model.
//! `disc_appendix`: the named quantities.

use lanes::Real;

/// Every named quantity, see `QUANTITIES`.
///
/// 96 operations: 25 add, 60 mul, 2 div, 2 neg, 2 sqrt, 5 call.
/// `prepare` takes 7 operations for it.
#[inline(always)]
pub fn quantities<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 25],
    values: &mut [T; 44],
) {
    let phi = state[6];
    let (sin_phi, cos_phi) = phi.sin_cos();
    let theta = state[7];
    let (sin_theta, cos_theta) = theta.sin_cos();
    let phidot = state[9];

    // disc_appendix.hyz:64  let angular_velocity = (phidot*cos(theta), thetadot, phidot*sin(th …
    let angular_velocity_1 = cos_theta * phidot;
    values[3] = angular_velocity_1;
    let phidot_sin_theta = phidot * sin_theta;
    let g_m = prepared[3];
    let cos_phi_g_m = g_m * cos_phi;
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let minus_sin_phi_wind_y_sum = wind_y.neg_mul_add(sin_phi, wind_z * cos_phi);
    let v = state[4];

    // disc_appendix.hyz:67  let air_velocity = velocity - in_B(wind);
    let air_velocity_2 = wind_y.neg_mul_add(cos_phi, wind_z.neg_mul_add(sin_phi, v));
    values[7] = air_velocity_2;
    let gammadot = state[11];
    let angular_velocity_3 = phidot_sin_theta + gammadot;
    values[5] = angular_velocity_3;
    values[25] = angular_velocity_3;
    let wind_x = parameters[15];
    let w = state[5];
    let minus_air_velocity_3 =
        cos_theta.mul_add(minus_sin_phi_wind_y_sum, wind_x.mul_sub(sin_theta, w));
    let I_a = parameters[1];
    let I_d_two = prepared[5];
    let part_of_der_phidot = I_a.mul_sub(angular_velocity_3, I_d_two * phidot_sin_theta);
    let C_Nr = parameters[14];

    // disc_appendix.hyz:88  let spin_down = C_Nr*r;
    let spin_down = C_Nr * angular_velocity_3;
    values[30] = spin_down;
    values[36] = spin_down;
    values[42] = spin_down;
    let u = state[3];
    let air_velocity_1 =
        wind_x.neg_mul_add(cos_theta, sin_theta.mul_add(minus_sin_phi_wind_y_sum, u));
    values[6] = air_velocity_1;
    let air_velocity_3 = -minus_air_velocity_3;
    values[8] = air_velocity_3;
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let thetadot = state[10];
    let part_of_rate_1 = angular_velocity_1.mul_add(air_velocity_1, thetadot * air_velocity_2);
    let thetadot_air_velocity_1_sum =
        thetadot.mul_sub(air_velocity_1, angular_velocity_1 * air_velocity_2);
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);
    let half_rho_A = prepared[4];
    let V_sq_half_rho_A = half_rho_A * V_sq;

    // disc_appendix.hyz:69  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    values[12] = V;
    let rho_half = prepared[17];
    values[20] = rho_half * V_sq;
    let d = parameters[3];
    let d_V_sq_half_rho_A = d * V_sq_half_rho_A;

    // disc_appendix.hyz:74  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    values[19] = alpha;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let V_half_rho_A = half_rho_A * V;

    // disc_appendix.hyz:84  let rate_1 = dot(angular_velocity, d1);
    let rate_1 = inv_air_velocity_12 * part_of_rate_1;
    values[26] = rate_1;

    // disc_appendix.hyz:70  let d1 = unit(air_velocity - dot(air_velocity, d3)*d3);
    let d1_1 = air_velocity_1 * inv_air_velocity_12;
    values[13] = d1_1;
    values[17] = d1_1;
    let d1_2 = air_velocity_2 * inv_air_velocity_12;
    values[14] = d1_2;
    let C_Mq = parameters[12];
    let C_Rr = parameters[13];
    let C_Mq_rate_1_plus_sum = C_Mq.mul_add(rate_1, C_Rr * angular_velocity_3);

    // disc_appendix.hyz:85  let rate_2 = dot(angular_velocity, d2);
    let rate_2 = inv_air_velocity_12 * thetadot_air_velocity_1_sum;
    values[27] = rate_2;
    let part_of_inv_air_velocity_12_sum = C_Mq * inv_air_velocity_12 * thetadot_air_velocity_1_sum;
    let d2_1 = -d1_2;
    values[16] = d2_1;
    let roll = C_Mq_rate_1_plus_sum * d_V_sq_half_rho_A;
    values[28] = roll;
    let part_of_moment_b_2 = air_velocity_2 * C_Mq_rate_1_plus_sum;
    let C_Ma = parameters[11];
    let inv_air_velocity_12_sum = C_Ma.mul_add(alpha, part_of_inv_air_velocity_12_sum);
    let C_La = parameters[8];
    let C_L0 = parameters[7];

    // disc_appendix.hyz:77  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La.mul_add(alpha, C_L0);
    values[21] = C_L;
    let C_Da = parameters[10];
    let C_D0 = parameters[9];

    // disc_appendix.hyz:78  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = alpha.mul_add(C_Da * alpha, C_D0);
    values[22] = C_D;
    let pitch = inv_air_velocity_12_sum * d_V_sq_half_rho_A;
    values[29] = pitch;
    let part_of_moment_b_2_2 = air_velocity_1.mul_add(inv_air_velocity_12_sum, part_of_moment_b_2);
    values[23] = C_L * V_sq_half_rho_A;
    values[24] = C_D * V_sq_half_rho_A;

    // disc_appendix.hyz:92  let moment_b = roll*d1 + pitch*d2 + spin_down*d3;
    let moment_b_1 = d1_2.neg_mul_add(pitch, d1_1 * roll);
    values[34] = moment_b_1;
    values[40] = moment_b_1;
    let part_of_force_b_3 = minus_air_velocity_3.mul_add(C_D, air_velocity_12 * C_L);
    let moment_b_2 = inv_air_velocity_12 * part_of_moment_b_2_2 * d_V_sq_half_rho_A;
    values[35] = moment_b_2;
    values[41] = moment_b_2;
    let air_velocity_12_C_D_product =
        air_velocity_12.mul_sub(C_D, minus_air_velocity_3 * C_L) * V_half_rho_A;

    // disc_appendix.hyz:91  let force_b = (lift*sin(alpha) - drag*cos(alpha))*d1 + (lift*cos(a …
    let force_b_3 = V_half_rho_A.mul_sub(part_of_force_b_3, cos_theta * cos_phi_g_m);
    values[33] = force_b_3;
    values[39] = force_b_3;
    let force_b_1 = d1_1.neg_mul_add(air_velocity_12_C_D_product, sin_theta * cos_phi_g_m);
    values[31] = force_b_1;
    values[37] = force_b_1;
    let minus_g_m = prepared[24];
    let force_b_2 = d1_2.neg_mul_add(air_velocity_12_C_D_product, minus_g_m * sin_phi);
    values[32] = force_b_2;
    values[38] = force_b_2;
    let inv_I_d = prepared[1];

    // disc_appendix.hyz:112  der(phidot) = (M_b1 + 2*I_d*phidot*thetadot*sin(theta) - I_a*thet …
    let der_phidot = inv_I_d * thetadot.neg_mul_add(part_of_der_phidot, moment_b_1) / cos_theta;
    values[43] = der_phidot;

    values[0] = u;
    values[1] = v;
    values[2] = w;
    values[4] = thetadot;
    values[9] = T::splat(0.0);
    values[10] = T::splat(0.0);
    values[11] = T::splat(1.0);
    values[15] = T::splat(0.0);
    values[18] = T::splat(0.0);
}
