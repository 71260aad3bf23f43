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
    let C_L0 = parameters[7];
    let C_La = parameters[8];
    let C_D0 = parameters[9];
    let C_Da = parameters[10];
    let C_Ma = parameters[11];
    let C_Mq = parameters[12];
    let C_Rr = parameters[13];
    let C_Nr = parameters[14];
    let wind_x = parameters[15];
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let g_m = prepared[0];
    let half_rho_A = prepared[1];
    let I_d_two = prepared[3];
    let inv_I_d = prepared[4];
    let rho_half = prepared[17];
    let minus_g_m = prepared[24];
    let (sin_theta, cos_theta) = theta.sin_cos();

    // disc_appendix.hyz:64  let angular_velocity = (phidot*cos(theta), thetadot, phidot*sin(th …
    let angular_velocity_1 = cos_theta * phidot;
    let phidot_sin_theta = phidot * sin_theta;
    let angular_velocity_3 = phidot_sin_theta + gammadot;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let minus_sin_phi_wind_y_sum = wind_z * cos_phi - wind_y * sin_phi;

    // disc_appendix.hyz:67  let air_velocity = velocity - in_B(wind);
    let air_velocity_1 = u + sin_theta * minus_sin_phi_wind_y_sum - wind_x * cos_theta;
    let air_velocity_2 = v - wind_z * sin_phi - wind_y * cos_phi;
    let minus_air_velocity_3 = wind_x * sin_theta - w + cos_theta * minus_sin_phi_wind_y_sum;
    let air_velocity_12_sq = air_velocity_2 * air_velocity_2 + air_velocity_1 * air_velocity_1;
    let V_sq = minus_air_velocity_3 * minus_air_velocity_3 + air_velocity_12_sq;

    // disc_appendix.hyz:69  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();

    // disc_appendix.hyz:70  let d1 = unit(air_velocity - dot(air_velocity, d3)*d3);
    let d1_1 = air_velocity_1 * inv_air_velocity_12;
    let d1_2 = air_velocity_2 * inv_air_velocity_12;

    // disc_appendix.hyz:74  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);

    // disc_appendix.hyz:77  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La * alpha + C_L0;

    // disc_appendix.hyz:78  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_Da * alpha * alpha + C_D0;
    let V_sq_half_rho_A = half_rho_A * V_sq;

    // disc_appendix.hyz:84  let rate_1 = dot(angular_velocity, d1);
    let rate_1 =
        inv_air_velocity_12 * (thetadot * air_velocity_2 + angular_velocity_1 * air_velocity_1);
    let thetadot_air_velocity_1_sum =
        thetadot * air_velocity_1 - angular_velocity_1 * air_velocity_2;

    // disc_appendix.hyz:85  let rate_2 = dot(angular_velocity, d2);
    let rate_2 = inv_air_velocity_12 * thetadot_air_velocity_1_sum;
    let C_Mq_rate_1_plus_sum = C_Mq * rate_1 + C_Rr * angular_velocity_3;
    let d_V_sq_half_rho_A = d * V_sq_half_rho_A;
    let roll = C_Mq_rate_1_plus_sum * d_V_sq_half_rho_A;
    let inv_air_velocity_12_sum =
        C_Mq * inv_air_velocity_12 * thetadot_air_velocity_1_sum + C_Ma * alpha;
    let pitch = inv_air_velocity_12_sum * d_V_sq_half_rho_A;

    // disc_appendix.hyz:88  let spin_down = C_Nr*r;
    let spin_down = C_Nr * angular_velocity_3;
    let cos_phi_g_m = g_m * cos_phi;
    let V_half_rho_A = half_rho_A * V;
    let air_velocity_12_C_D_product =
        (air_velocity_12 * C_D - minus_air_velocity_3 * C_L) * V_half_rho_A;

    // disc_appendix.hyz:91  let force_b = (lift*sin(alpha) - drag*cos(alpha))*d1 + (lift*cos(a …
    let force_b_1 = sin_theta * cos_phi_g_m - d1_1 * air_velocity_12_C_D_product;
    let force_b_2 = minus_g_m * sin_phi - d1_2 * air_velocity_12_C_D_product;
    let part_of_force_b_3 = (minus_air_velocity_3 * C_D + air_velocity_12 * C_L) * V_half_rho_A;
    let force_b_3 = part_of_force_b_3 - cos_theta * cos_phi_g_m;

    // disc_appendix.hyz:92  let moment_b = roll*d1 + pitch*d2 + spin_down*d3;
    let moment_b_1 = d1_1 * roll - d1_2 * pitch;
    let part_of_moment_b_2 =
        air_velocity_2 * C_Mq_rate_1_plus_sum + air_velocity_1 * inv_air_velocity_12_sum;
    let moment_b_2 = inv_air_velocity_12 * part_of_moment_b_2 * d_V_sq_half_rho_A;
    let part_of_der_phidot = thetadot * (I_a * angular_velocity_3 - I_d_two * phidot_sin_theta);

    // disc_appendix.hyz:112  der(phidot) = (M_b1 + 2*I_d*phidot*thetadot*sin(theta) - I_a*thet …
    let der_phidot = inv_I_d * (moment_b_1 - part_of_der_phidot) / cos_theta;
    let air_velocity_3 = -minus_air_velocity_3;
    let d2_1 = -d1_2;

    values[0] = u;
    values[1] = v;
    values[2] = w;
    values[3] = angular_velocity_1;
    values[4] = thetadot;
    values[5] = angular_velocity_3;
    values[6] = air_velocity_1;
    values[7] = air_velocity_2;
    values[8] = air_velocity_3;
    values[9] = T::splat(0.0);
    values[10] = T::splat(0.0);
    values[11] = T::splat(1.0);
    values[12] = V;
    values[13] = d1_1;
    values[14] = d1_2;
    values[15] = T::splat(0.0);
    values[16] = d2_1;
    values[17] = d1_1;
    values[18] = T::splat(0.0);
    values[19] = alpha;
    values[20] = rho_half * V_sq;
    values[21] = C_L;
    values[22] = C_D;
    values[23] = C_L * V_sq_half_rho_A;
    values[24] = C_D * V_sq_half_rho_A;
    values[25] = angular_velocity_3;
    values[26] = rate_1;
    values[27] = rate_2;
    values[28] = roll;
    values[29] = pitch;
    values[30] = spin_down;
    values[31] = force_b_1;
    values[32] = force_b_2;
    values[33] = force_b_3;
    values[34] = moment_b_1;
    values[35] = moment_b_2;
    values[36] = spin_down;
    values[37] = force_b_1;
    values[38] = force_b_2;
    values[39] = force_b_3;
    values[40] = moment_b_1;
    values[41] = moment_b_2;
    values[42] = spin_down;
    values[43] = der_phidot;
}
