// Written by `hyzer generate`; changes belong in the model.
//! `disc`: the named quantities.

use lanes::Real;

/// Every named quantity, see `QUANTITIES`.
///
/// 66 operations: 16 add, 39 mul, 2 div, 2 neg, 2 sqrt, 5 call.
/// `prepare` takes 4 operations for it.
#[inline(always)]
pub fn quantities<T: Real>(
    _time: T,
    state: &[T; 12],
    parameters: &[T; 18],
    prepared: &[T; 22],
    values: &mut [T; 35],
) {
    let phi = state[6];
    let (sin_phi, cos_phi) = phi.sin_cos();
    let theta = state[7];
    let (sin_theta, cos_theta) = theta.sin_cos();
    let phidot = state[9];
    let cos_theta_phidot = cos_theta * phidot;
    let gammadot = state[11];

    // disc.hyz:91  let r = dot(angular_velocity, d3);
    let r = sin_theta.mul_add(phidot, gammadot);
    values[28] = r;
    let wind_y = parameters[16];
    let wind_z = parameters[17];
    let minus_wind_y_sin_phi_sum = wind_y.neg_mul_add(sin_phi, wind_z * cos_phi);
    let v = state[4];

    // disc.hyz:75  let air_velocity = velocity - in_B(air);
    let air_velocity_2 = wind_y.neg_mul_add(cos_phi, wind_z.neg_mul_add(sin_phi, v));
    values[10] = air_velocity_2;
    let C_Nr = parameters[14];

    // disc.hyz:98  let spin_down = C_Nr*r;
    let spin_down = C_Nr * r;
    values[34] = spin_down;
    let wind_x = parameters[15];
    let u = state[3];
    let air_velocity_1 = sin_theta.mul_sub(minus_wind_y_sin_phi_sum, wind_x * cos_theta) + u;
    values[9] = air_velocity_1;
    let w = state[5];
    let minus_air_velocity_3 = minus_wind_y_sin_phi_sum.mul_add(cos_theta, wind_x * sin_theta) - w;
    let air_velocity_12_sq =
        air_velocity_1.mul_add(air_velocity_1, air_velocity_2 * air_velocity_2);
    let thetadot = state[10];
    let part_of_rate_1 = air_velocity_1.mul_add(cos_theta_phidot, air_velocity_2 * thetadot);
    let air_velocity_1_thetadot_sum =
        air_velocity_1.mul_sub(thetadot, air_velocity_2 * cos_theta_phidot);
    let air_velocity_3 = -minus_air_velocity_3;
    values[11] = air_velocity_3;
    let air_velocity_12 = air_velocity_12_sq.sqrt();
    let V_sq = minus_air_velocity_3.mul_add(minus_air_velocity_3, air_velocity_12_sq);

    // disc.hyz:77  let V = norm(air_velocity);
    let V = V_sq.sqrt();
    values[15] = V;
    let half_rho_A = prepared[12];
    let V_sq_half_rho_A = half_rho_A * V_sq;
    let rho_half = prepared[14];
    values[23] = rho_half * V_sq;
    let d = parameters[3];
    let d_V_sq_half_rho_A = d * V_sq_half_rho_A;

    // disc.hyz:82  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = minus_air_velocity_3.atan2(air_velocity_12);
    values[22] = alpha;
    let inv_air_velocity_12 = air_velocity_12.recip_or_zero();
    let inv_V = V.recip_or_zero();

    // disc.hyz:92  let rate_1 = dot(angular_velocity, d1);
    let rate_1 = inv_air_velocity_12 * part_of_rate_1;
    values[29] = rate_1;

    // disc.hyz:78  let d1 = unit(air_velocity - dot(air_velocity, d3)*d3);
    let d1_2 = air_velocity_2 * inv_air_velocity_12;
    values[17] = d1_2;
    let d1_1 = air_velocity_1 * inv_air_velocity_12;
    values[16] = d1_1;
    values[20] = d1_1;

    // disc.hyz:93  let rate_2 = dot(angular_velocity, d2);
    let rate_2 = inv_air_velocity_12 * air_velocity_1_thetadot_sum;
    values[30] = rate_2;
    let C_Mq = parameters[12];
    let part_of_pitch = C_Mq * inv_air_velocity_12 * air_velocity_1_thetadot_sum;
    let half_d = prepared[21];
    values[31] = half_d * r * inv_V;
    let d2_1 = -d1_2;
    values[19] = d2_1;
    let C_Rr = parameters[13];
    values[32] = C_Mq.mul_add(rate_1, C_Rr * r) * d_V_sq_half_rho_A;
    let C_La = parameters[8];
    let C_L0 = parameters[7];

    // disc.hyz:85  let C_L = C_L0 + C_La*alpha;
    let C_L = C_La.mul_add(alpha, C_L0);
    values[24] = C_L;
    let C_Da = parameters[10];
    let C_D0 = parameters[9];

    // disc.hyz:86  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = alpha.mul_add(C_Da * alpha, C_D0);
    values[25] = C_D;
    let C_Ma = parameters[11];
    values[33] = C_Ma.mul_add(alpha, part_of_pitch) * d_V_sq_half_rho_A;
    values[26] = C_L * V_sq_half_rho_A;
    values[27] = C_D * V_sq_half_rho_A;

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
