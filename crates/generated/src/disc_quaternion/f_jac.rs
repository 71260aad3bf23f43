// Written by `hyzer generate`; changes belong in the model.
//! `disc_quaternion`: derivatives of the states, and theirs by the states.

use lanes::Real;

/// Derivatives `dx` of the states and the entries `j` of their Jacobian, see `J_PATTERN`.
///
/// 638 operations: 213 add, 393 mul, 2 div, 26 neg, 2 sqrt, 1 call, 1 select.
#[inline(always)]
pub fn f_jac<T: Real>(
    _time: T,
    state: &[T; 13],
    parameters: &[T; 18],
    prepared: &[T; 16],
    dx: &mut [T; 13],
    j: &mut [T; 69],
) {
    let vx = state[3];
    let vy = state[4];
    let vz = state[5];
    let q0 = state[6];
    let q1 = state[7];
    let q2 = state[8];
    let q3 = state[9];
    let p = state[10];
    let q = state[11];
    let r = state[12];
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
    let inv_p0_p5_p4 = prepared[0];
    let half_p3_inv_p2_p5_p4 = prepared[1];
    let n1_minus_inv_p2_p1 = prepared[2];
    let p14_inv_p1 = prepared[3];
    let p3_p4_p5_inv_p2 = prepared[4];
    let two_p10 = prepared[5];
    let const_p3_p4_p5_inv_p2 = prepared[6];
    let half_p12 = prepared[7];
    let q2_two = T::splat(2.0) * q2;
    let q2_q2_two = q2 * q2_two;
    let q1_two = T::splat(2.0) * q1;
    let q1_q1_two = q1 * q1_two;
    let q2_q2_two_plus_q1_q1_sum = q2_q2_two + q1_q1_two - T::splat(1.0);
    let vz_minus_wind_z = vz - wind_z;
    let vx_minus_wind_x = vx - wind_x;
    let q3_q1 = q3 * q1;
    let q2_q0 = q2 * q0;
    let q3_q1_plus_q2_q0 = q3_q1 + q2_q0;
    let q3_q2 = q3 * q2;
    let q1_q0 = q1 * q0;
    let q3_q2_minus_q1_q0 = q3_q2 - q1_q0;
    let vy_minus_wind_y = vy - wind_y;
    let part_of_q2_q2_two_plus_q1_sum =
        vx_minus_wind_x * q3_q1_plus_q2_q0 + q3_q2_minus_q1_q0 * vy_minus_wind_y;
    let q2_q2_two_plus_q1_sum =
        q2_q2_two_plus_q1_q1_sum * vz_minus_wind_z - T::splat(2.0) * part_of_q2_q2_two_plus_q1_sum;
    let q3_two = T::splat(2.0) * q3;
    let minus_n1_plus_q3_q3_two = q3 * q3_two - T::splat(1.0);
    let q2_q2_two_plus_minus_n1_sum = q2_q2_two + minus_n1_plus_q3_q3_two;
    let q1_q2 = q1 * q2;
    let q3_q0 = q3 * q0;
    let q1_q2_plus_q3_q0 = q1_q2 + q3_q0;
    let q3_q1_minus_q2_q0 = q3_q1 - q2_q0;
    let part_of_vx_minus_wind_x_q2_sum =
        vy_minus_wind_y * q1_q2_plus_q3_q0 + vz_minus_wind_z * q3_q1_minus_q2_q0;
    let part_of_vx_minus_wind_x_q2_sum_2 = T::splat(2.0) * part_of_vx_minus_wind_x_q2_sum;
    let vx_minus_wind_x_q2_sum =
        vx_minus_wind_x * q2_q2_two_plus_minus_n1_sum - part_of_vx_minus_wind_x_q2_sum_2;
    let q1_q1_two_plus_minus_n1_sum = q1_q1_two + minus_n1_plus_q3_q3_two;
    let q1_q2_minus_q3_q0 = q1_q2 - q3_q0;
    let q3_q2_plus_q1_q0 = q3_q2 + q1_q0;
    let part_of_air_velocity_2 =
        vx_minus_wind_x * q1_q2_minus_q3_q0 + vz_minus_wind_z * q3_q2_plus_q1_q0;

    // disc_quaternion.hyz:55  let air_velocity = in_C(velocity - wind);
    let air_velocity_2 =
        T::splat(2.0) * part_of_air_velocity_2 - vy_minus_wind_y * q1_q1_two_plus_minus_n1_sum;
    let vx_minus_wind_x_q2_sum_sum =
        vx_minus_wind_x_q2_sum * vx_minus_wind_x_q2_sum + air_velocity_2 * air_velocity_2;
    let q2_q2_two_plus_q1_sum_sum =
        q2_q2_two_plus_q1_sum * q2_q2_two_plus_q1_sum + vx_minus_wind_x_q2_sum_sum;
    let sqrt_q2_q2_two_plus_q1_of = q2_q2_two_plus_q1_sum_sum.sqrt();
    let sqrt_q2_q2_two_plus_product = inv_p0_p5_p4 * sqrt_q2_q2_two_plus_q1_of;
    let sqrt_vx_minus_wind_x_q2_of = vx_minus_wind_x_q2_sum_sum.sqrt();

    // disc_quaternion.hyz:62  let alpha = atan2(-dot(air_velocity, d3), dot(air_velocity, d1));
    let alpha = q2_q2_two_plus_q1_sum.atan2(sqrt_vx_minus_wind_x_q2_of);

    // disc_quaternion.hyz:66  let C_L = C_L0 + C_La*alpha;
    let C_L = C_L0 + C_La * alpha;

    // disc_quaternion.hyz:67  let C_D = C_D0 + C_Da*alpha^2;
    let C_D = C_D0 + C_Da * alpha * alpha;
    let part_of_minus_q2_q2_two_product =
        sqrt_vx_minus_wind_x_q2_of * C_D - q2_q2_two_plus_q1_sum * C_L;
    let inv_sqrt_vx_minus_wind_x_of = sqrt_vx_minus_wind_x_q2_of.recip_or_zero();
    let minus_q2_q2_two_product = part_of_minus_q2_q2_two_product * inv_sqrt_vx_minus_wind_x_of;
    let q2_q2_two_plus_product = T::splat(0.5) * q2_q2_two_plus_minus_n1_sum;
    let q1_q2_minus_q3_q0_sum =
        q1_q2_minus_q3_q0 * air_velocity_2 + vx_minus_wind_x_q2_sum * q2_q2_two_plus_product;
    let sqrt_vx_minus_wind_sum = sqrt_vx_minus_wind_x_q2_of * C_L + q2_q2_two_plus_q1_sum * C_D;
    let minus_minus_q2_q2_two_sum =
        q3_q1_plus_q2_q0 * sqrt_vx_minus_wind_sum - minus_q2_q2_two_product * q1_q2_minus_q3_q0_sum;

    // disc_quaternion.hyz:50  velocity (vx, vy, vz) in N;
    let vx_dot = sqrt_q2_q2_two_plus_product * minus_minus_q2_q2_two_sum;
    let q1_q1_two_plus_product = T::splat(0.5) * q1_q1_two_plus_minus_n1_sum;
    let q1_q2_plus_q3_q0_vx_sum =
        q1_q2_plus_q3_q0 * vx_minus_wind_x_q2_sum + air_velocity_2 * q1_q1_two_plus_product;
    let part_of_minus_q2_q2_two_product_sum = minus_q2_q2_two_product * q1_q2_plus_q3_q0_vx_sum;
    let minus_q2_q2_two_product_sum =
        part_of_minus_q2_q2_two_product_sum + q3_q2_minus_q1_q0 * sqrt_vx_minus_wind_sum;
    let vy_dot = sqrt_q2_q2_two_plus_product * minus_q2_q2_two_product_sum;
    let minus_q3_q1_minus_q2_q0_sum =
        q3_q2_plus_q1_q0 * air_velocity_2 - q3_q1_minus_q2_q0 * vx_minus_wind_x_q2_sum;
    let part_of_minus_q2_q2_two_product_sum_2 =
        minus_q2_q2_two_product * minus_q3_q1_minus_q2_q0_sum;
    let q2_q2_two_plus_q1_product = T::splat(0.5) * q2_q2_two_plus_q1_q1_sum;
    let minus_q2_q2_two_product_sum_2 =
        part_of_minus_q2_q2_two_product_sum_2 + sqrt_vx_minus_wind_sum * q2_q2_two_plus_q1_product;
    let vz_dot = -(sqrt_q2_q2_two_plus_product * minus_q2_q2_two_product_sum_2) - g;

    // disc_quaternion.hyz:43  frame C = N by quaternion (q0, q1, q2, q3); // fixed in the disc
    let minus_q0_dot = T::splat(0.5) * (q1 * p + q2 * q + q3 * r);
    let minus_q1_dot = T::splat(0.5) * (q3 * q - q0 * p - q2 * r);
    let minus_q2_dot = T::splat(0.5) * (q1 * r - q0 * q - q3 * p);
    let minus_q3_dot = T::splat(0.5) * (q2 * p - q0 * r - q1 * q);
    let r_n1_minus_I_a_inv_part = n1_minus_inv_p2_p1 * r;
    let q2_q2_two_plus_q1_product_2 =
        half_p3_inv_p2_p5_p4 * q2_q2_two_plus_q1_sum_sum * inv_sqrt_vx_minus_wind_x_of;
    let air_velocity_2_p_plus_sum = air_velocity_2 * p + vx_minus_wind_x_q2_sum * q;
    let inv_sqrt_vx_minus_product = C_Mq * inv_sqrt_vx_minus_wind_x_of;
    let alpha_C_Ma_minus_air_sum =
        C_Ma * alpha - air_velocity_2_p_plus_sum * inv_sqrt_vx_minus_product;
    let vx_minus_wind_x_q2_sum_sum_2 = vx_minus_wind_x_q2_sum * p - air_velocity_2 * q;
    let r_C_Rr_minus_inv_sqrt_sum =
        C_Rr * r - inv_sqrt_vx_minus_product * vx_minus_wind_x_q2_sum_sum_2;
    let part_of_air_velocity_2_product_sum = vx_minus_wind_x_q2_sum * r_C_Rr_minus_inv_sqrt_sum;
    let air_velocity_2_product_sum =
        air_velocity_2 * alpha_C_Ma_minus_air_sum + part_of_air_velocity_2_product_sum;

    // disc_quaternion.hyz:51  angular velocity (p, q, r) in C;
    let p_dot =
        q * r_n1_minus_I_a_inv_part - q2_q2_two_plus_q1_product_2 * air_velocity_2_product_sum;
    let part_of_minus_vx_minus_wind_x_sum = vx_minus_wind_x_q2_sum * alpha_C_Ma_minus_air_sum;
    let minus_vx_minus_wind_x_sum =
        air_velocity_2 * r_C_Rr_minus_inv_sqrt_sum - part_of_minus_vx_minus_wind_x_sum;
    let q_dot =
        q2_q2_two_plus_q1_product_2 * minus_vx_minus_wind_x_sum - p * r_n1_minus_I_a_inv_part;
    let r_dot = p14_inv_p1 * r;
    let alpha_two_C_Da = two_p10 * alpha;
    let C_La_sqrt_vx_minus_sum =
        C_La * sqrt_vx_minus_wind_x_q2_of + q2_q2_two_plus_q1_sum * alpha_two_C_Da;
    let inv_sqrt_q2_q2_two_plus_of = sqrt_q2_q2_two_plus_q1_of.recip_or_zero();
    let inv_sqrt_q2_q2_two_product = inv_sqrt_q2_q2_two_plus_of * inv_sqrt_q2_q2_two_plus_of;
    let q2_q2_two_plus_q1_product_3 = q2_q2_two_plus_q1_sum * inv_sqrt_q2_q2_two_product;
    let C_L_minus_C_La_sqrt_vx_sum = C_L - C_La_sqrt_vx_minus_sum * q2_q2_two_plus_q1_product_3;
    let q2_q2_two_plus_q1_sum_C_sum =
        C_La * q2_q2_two_plus_q1_sum - sqrt_vx_minus_wind_x_q2_of * alpha_two_C_Da;
    let part_of_inv_sqrt_vx_minus_product_2 =
        C_D - minus_q2_q2_two_product + q2_q2_two_plus_q1_sum_C_sum * q2_q2_two_plus_q1_product_3;
    let inv_sqrt_vx_minus_product_2 =
        inv_sqrt_vx_minus_wind_x_of * part_of_inv_sqrt_vx_minus_product_2;
    let part_of_minus_minus_part_part_sum = q1_q2_minus_q3_q0_sum * inv_sqrt_vx_minus_product_2;
    let part_of_minus_minus_part_part_sum_2 =
        part_of_minus_minus_part_part_sum - q3_q1_plus_q2_q0 * C_L_minus_C_La_sqrt_vx_sum;
    let sqrt_q2_q2_two_plus_product_2 = sqrt_q2_q2_two_plus_product * inv_sqrt_vx_minus_wind_x_of;
    let part_of_minus_minus_part_part_sum_3 =
        part_of_minus_minus_part_part_sum_2 * sqrt_q2_q2_two_plus_product_2;
    let inv_sqrt_q2_q2_two_product_2 = inv_p0_p5_p4 * inv_sqrt_q2_q2_two_plus_of;
    let part_of_minus_minus_part_part_sum_4 =
        minus_minus_q2_q2_two_sum * inv_sqrt_q2_q2_two_product_2;
    let minus_minus_part_part_sum =
        part_of_minus_minus_part_part_sum_4 - part_of_minus_minus_part_part_sum_3;
    let sqrt_q2_q2_two_plus_product_3 = sqrt_q2_q2_two_plus_product * minus_q2_q2_two_product;
    let part_of_minus_vx_minus_wind_x_sum_2 =
        sqrt_q2_q2_two_plus_product_3 * q2_q2_two_plus_product;
    let minus_vx_minus_wind_x_sum_2 =
        part_of_minus_vx_minus_wind_x_sum_2 - vx_minus_wind_x_q2_sum * minus_minus_part_part_sum;
    let q2_q2_two_plus_q1_product_4 = q2_q2_two_plus_q1_sum * inv_sqrt_q2_q2_two_product_2;
    let sqrt_vx_minus_wind_product = sqrt_vx_minus_wind_x_q2_of * inv_sqrt_q2_q2_two_product;
    let C_D_plus_C_La_sqrt_vx_sum = C_D + C_La_sqrt_vx_minus_sum * sqrt_vx_minus_wind_product;
    let nonzero_vx_minus_wind_x_of =
        vx_minus_wind_x_q2_sum_sum.if_zero(T::splat(0.0), T::splat(1.0));
    let part_of_nonzero_vx_minus_sum =
        nonzero_vx_minus_wind_x_of * q2_q2_two_plus_q1_sum_C_sum * inv_sqrt_q2_q2_two_product;
    let nonzero_vx_minus_sum = part_of_nonzero_vx_minus_sum + C_L * inv_sqrt_vx_minus_wind_x_of;
    let part_of_minus_minus_q2_q2_sum =
        q3_q1_plus_q2_q0 * C_D_plus_C_La_sqrt_vx_sum + q1_q2_minus_q3_q0_sum * nonzero_vx_minus_sum;
    let part_of_minus_minus_q2_q2_sum_2 =
        sqrt_q2_q2_two_plus_product * part_of_minus_minus_q2_q2_sum;
    let minus_minus_q2_q2_sum =
        minus_minus_q2_q2_two_sum * q2_q2_two_plus_q1_product_4 + part_of_minus_minus_q2_q2_sum_2;
    let part_of_minus_air_velocity_2_sum = q1_q2_minus_q3_q0 * sqrt_q2_q2_two_plus_product_3;
    let minus_air_velocity_2_sum =
        part_of_minus_air_velocity_2_sum - air_velocity_2 * minus_minus_part_part_sum;
    let part_of_d_vx_dot_d_vx =
        q3_q1_plus_q2_q0 * minus_minus_q2_q2_sum + q1_q2_minus_q3_q0 * minus_air_velocity_2_sum;
    let part_of_d_vx_dot_d_vx_2 = -(q2_q2_two_plus_minus_n1_sum * minus_vx_minus_wind_x_sum_2);
    let part_of_d_vx_dot_d_vy_2 = q1_q1_two_plus_minus_n1_sum * minus_air_velocity_2_sum;
    let part_of_d_vx_dot_d_vy =
        q3_q2_minus_q1_q0 * minus_minus_q2_q2_sum - q1_q2_plus_q3_q0 * minus_vx_minus_wind_x_sum_2;
    let part_of_d_vx_dot_d_vz = q3_q1_minus_q2_q0 * minus_vx_minus_wind_x_sum_2;
    let part_of_d_vx_dot_d_vz_2 =
        q3_q2_plus_q1_q0 * minus_air_velocity_2_sum - part_of_d_vx_dot_d_vz;
    let part_of_d_vx_dot_d_vz_3 =
        q2_q2_two_plus_q1_q1_sum * minus_minus_q2_q2_sum - T::splat(2.0) * part_of_d_vx_dot_d_vz_2;
    let q2_sqrt_vx_minus_wind_sum = q2 * sqrt_vx_minus_wind_sum;
    let air_velocity_2_product = air_velocity_2 * minus_q2_q2_two_product;
    let q3_air_velocity_2_product = q3 * air_velocity_2_product;
    let part_of_d_vx_dot_d_q0 =
        sqrt_q2_q2_two_plus_product * (q2_sqrt_vx_minus_wind_sum + q3_air_velocity_2_product);
    let q1_vy_minus_wind_y = q1 * vy_minus_wind_y;
    let vx_minus_wind_x_q2 = vx_minus_wind_x * q2;
    let minus_q1_vy_minus_wind_sum = vx_minus_wind_x_q2 - q1_vy_minus_wind_y;
    let q1_vz_minus_wind_z = q1 * vz_minus_wind_z;
    let vx_minus_wind_x_q3 = vx_minus_wind_x * q3;
    let minus_q1_vz_minus_wind_sum = vx_minus_wind_x_q3 - q1_vz_minus_wind_z;
    let part_of_d_vx_dot_d_q0_2 = minus_air_velocity_2_sum * minus_q1_vz_minus_wind_sum;
    let q2_vz_minus_wind_z = q2 * vz_minus_wind_z;
    let q3_vy_minus_wind_y = q3 * vy_minus_wind_y;
    let minus_q2_vz_minus_wind_sum = q3_vy_minus_wind_y - q2_vz_minus_wind_z;
    let part_of_d_vx_dot_d_q0_3 =
        minus_minus_q2_q2_sum * minus_q1_vy_minus_wind_sum - part_of_d_vx_dot_d_q0_2;
    let part_of_d_vx_dot_d_q0_4 =
        part_of_d_vx_dot_d_q0_3 - minus_vx_minus_wind_x_sum_2 * minus_q2_vz_minus_wind_sum;
    let q0_two = T::splat(2.0) * q0;
    let vy_minus_wind_y_q0_two = vy_minus_wind_y * q0_two;
    let vx_minus_wind_x_q3_two_sum =
        vx_minus_wind_x * q3_two - T::splat(4.0) * q1_vz_minus_wind_z - vy_minus_wind_y_q0_two;
    let vz_minus_wind_z_q0_two = vz_minus_wind_z * q0_two;
    let vx_minus_wind_x_q2_two_sum =
        vx_minus_wind_x * q2_two - T::splat(4.0) * q1_vy_minus_wind_y + vz_minus_wind_z_q0_two;
    let q3_sqrt_vx_minus_wind_sum = q3 * sqrt_vx_minus_wind_sum;
    let part_of_d_vx_dot_d_q1 =
        sqrt_q2_q2_two_plus_product * (q2 * air_velocity_2_product - q3_sqrt_vx_minus_wind_sum);
    let q3_vz_minus_wind_z = q3 * vz_minus_wind_z;
    let q2_vy_minus_wind_y = q2 * vy_minus_wind_y;
    let two_q3_vz_minus_product = T::splat(2.0) * (q3_vz_minus_wind_z + q2_vy_minus_wind_y);
    let part_of_d_vx_dot_d_q1_2 = minus_vx_minus_wind_x_sum_2 * two_q3_vz_minus_product;
    let part_of_d_vx_dot_d_q1_3 =
        part_of_d_vx_dot_d_q1_2 - minus_minus_q2_q2_sum * vx_minus_wind_x_q3_two_sum;
    let part_of_d_vx_dot_d_q1_4 =
        part_of_d_vx_dot_d_q1_3 - minus_air_velocity_2_sum * vx_minus_wind_x_q2_two_sum;
    let vx_minus_wind_x_q0_two = vx_minus_wind_x * q0_two;
    let vy_minus_wind_y_q3_two_sum =
        vy_minus_wind_y * q3_two - T::splat(4.0) * q2_vz_minus_wind_z + vx_minus_wind_x_q0_two;
    let vz_minus_wind_z_q0_two_sum =
        vz_minus_wind_z_q0_two + T::splat(4.0) * vx_minus_wind_x_q2 - vy_minus_wind_y * q1_two;
    let part_of_d_vx_dot_d_q2_3 = minus_vx_minus_wind_x_sum_2 * vz_minus_wind_z_q0_two_sum;
    let q0_sqrt_vx_minus_wind_sum = q0 * sqrt_vx_minus_wind_sum;
    let q1_air_velocity_2 = q1 * air_velocity_2;
    let part_of_d_vx_dot_d_q2 =
        minus_q2_q2_two_product * (q1_air_velocity_2 + vx_minus_wind_x_q2_sum * q2_two);
    let part_of_d_vx_dot_d_q2_2 =
        sqrt_q2_q2_two_plus_product * (part_of_d_vx_dot_d_q2 - q0_sqrt_vx_minus_wind_sum);
    let vx_minus_wind_x_q1 = vx_minus_wind_x * q1;
    let two_q3_vz_minus_product_2 = T::splat(2.0) * (q3_vz_minus_wind_z + vx_minus_wind_x_q1);
    let part_of_d_vx_dot_d_q2_5 = minus_air_velocity_2_sum * two_q3_vz_minus_product_2;
    let part_of_d_vx_dot_d_q2_4 =
        -(minus_minus_q2_q2_sum * vy_minus_wind_y_q3_two_sum) - part_of_d_vx_dot_d_q2_3;
    let part_of_d_vx_dot_d_q2_6 =
        part_of_d_vx_dot_d_q2_4 - part_of_d_vx_dot_d_q2_2 - part_of_d_vx_dot_d_q2_5;
    let vx_minus_wind_x_q0_two_sum =
        vx_minus_wind_x_q0_two + T::splat(4.0) * q3_vy_minus_wind_y - vz_minus_wind_z * q2_two;
    let minus_vy_minus_wind_y_sum =
        T::splat(4.0) * vx_minus_wind_x_q3 - vy_minus_wind_y_q0_two - vz_minus_wind_z * q1_two;
    let part_of_d_vx_dot_d_q3_2 = minus_vx_minus_wind_x_sum_2 * minus_vy_minus_wind_y_sum;
    let q0_air_velocity_2_product = q0 * air_velocity_2_product;
    let q1_sqrt_vx_minus_wind_sum = q1 * sqrt_vx_minus_wind_sum;
    let vx_minus_wind_x_q2_product = vx_minus_wind_x_q2_sum * minus_q2_q2_two_product;
    let part_of_d_vx_dot_d_q3 =
        q3_two * vx_minus_wind_x_q2_product - q0_air_velocity_2_product - q1_sqrt_vx_minus_wind_sum;
    let two_q2_vy_minus_product = T::splat(2.0) * (q2_vy_minus_wind_y + vx_minus_wind_x_q1);
    let part_of_d_vx_dot_d_q3_3 =
        minus_air_velocity_2_sum * vx_minus_wind_x_q0_two_sum - part_of_d_vx_dot_d_q3_2;
    let part_of_d_vx_dot_d_q3_4 =
        part_of_d_vx_dot_d_q3_3 - sqrt_q2_q2_two_plus_product * part_of_d_vx_dot_d_q3;
    let part_of_d_vx_dot_d_q3_5 =
        part_of_d_vx_dot_d_q3_4 - minus_minus_q2_q2_sum * two_q2_vy_minus_product;
    let part_of_part_part_plus_part_sum = q1_q2_plus_q3_q0_vx_sum * inv_sqrt_vx_minus_product_2;
    let part_of_part_part_plus_part_sum_2 =
        q3_q2_minus_q1_q0 * C_L_minus_C_La_sqrt_vx_sum + part_of_part_part_plus_part_sum;
    let part_of_part_part_plus_part_sum_3 =
        part_of_part_part_plus_part_sum_2 * sqrt_q2_q2_two_plus_product_2;
    let part_of_part_part_plus_part_sum_4 =
        minus_q2_q2_two_product_sum * inv_sqrt_q2_q2_two_product_2;
    let part_part_plus_part_sum =
        part_of_part_part_plus_part_sum_3 + part_of_part_part_plus_part_sum_4;
    let part_of_vx_minus_wind_x_q2_sum_2_2 = q1_q2_plus_q3_q0 * sqrt_q2_q2_two_plus_product_3;
    let vx_minus_wind_x_q2_sum_2 =
        vx_minus_wind_x_q2_sum * part_part_plus_part_sum + part_of_vx_minus_wind_x_q2_sum_2_2;
    let part_of_d_vy_dot_d_vx_3 = q2_q2_two_plus_minus_n1_sum * vx_minus_wind_x_q2_sum_2;
    let part_of_minus_minus_q2_q2_two_sum_2_4 =
        minus_q2_q2_two_product_sum * q2_q2_two_plus_q1_product_4;
    let part_of_minus_minus_q2_q2_two_sum_2 = q1_q2_plus_q3_q0_vx_sum * nonzero_vx_minus_sum;
    let part_of_minus_minus_q2_q2_two_sum_2_2 =
        part_of_minus_minus_q2_q2_two_sum_2 - q3_q2_minus_q1_q0 * C_D_plus_C_La_sqrt_vx_sum;
    let part_of_minus_minus_q2_q2_two_sum_2_3 =
        sqrt_q2_q2_two_plus_product * part_of_minus_minus_q2_q2_two_sum_2_2;
    let minus_minus_q2_q2_two_sum_2 =
        part_of_minus_minus_q2_q2_two_sum_2_3 - part_of_minus_minus_q2_q2_two_sum_2_4;
    let part_of_d_vy_dot_d_vx = q3_q1_plus_q2_q0 * minus_minus_q2_q2_two_sum_2;
    let part_of_air_velocity_2_part_sum = sqrt_q2_q2_two_plus_product_3 * q1_q1_two_plus_product;
    let air_velocity_2_part_sum =
        air_velocity_2 * part_part_plus_part_sum + part_of_air_velocity_2_part_sum;
    let part_of_d_vy_dot_d_vx_2 =
        part_of_d_vy_dot_d_vx + q1_q2_minus_q3_q0 * air_velocity_2_part_sum;
    let part_of_d_vy_dot_d_vx_4 = part_of_d_vy_dot_d_vx_3 + T::splat(2.0) * part_of_d_vy_dot_d_vx_2;
    let part_of_d_vy_dot_d_vy_3 = q1_q1_two_plus_minus_n1_sum * air_velocity_2_part_sum;
    let part_of_d_vy_dot_d_vy = q3_q2_minus_q1_q0 * minus_minus_q2_q2_two_sum_2;
    let part_of_d_vy_dot_d_vy_2 =
        part_of_d_vy_dot_d_vy - q1_q2_plus_q3_q0 * vx_minus_wind_x_q2_sum_2;
    let part_of_d_vy_dot_d_vy_4 = T::splat(2.0) * part_of_d_vy_dot_d_vy_2 - part_of_d_vy_dot_d_vy_3;
    let part_of_d_vy_dot_d_vz_2 = q2_q2_two_plus_q1_q1_sum * minus_minus_q2_q2_two_sum_2;
    let part_of_d_vy_dot_d_vz =
        q3_q2_plus_q1_q0 * air_velocity_2_part_sum - q3_q1_minus_q2_q0 * vx_minus_wind_x_q2_sum_2;
    let q3_vx_minus_wind_x_product = q3 * vx_minus_wind_x_q2_product;
    let part_of_d_vy_dot_d_q0 =
        sqrt_q2_q2_two_plus_product * (q3_vx_minus_wind_x_product - q1_sqrt_vx_minus_wind_sum);
    let part_of_d_vy_dot_d_q0_2 = minus_q1_vy_minus_wind_sum * minus_minus_q2_q2_two_sum_2;
    let part_of_d_vy_dot_d_q0_3 =
        part_of_d_vy_dot_d_q0_2 - minus_q1_vz_minus_wind_sum * air_velocity_2_part_sum;
    let part_of_d_vy_dot_d_q0_4 =
        part_of_d_vy_dot_d_q0_3 - minus_q2_vz_minus_wind_sum * vx_minus_wind_x_q2_sum_2;
    let part_of_d_vy_dot_d_q1_3 = vx_minus_wind_x_q3_two_sum * minus_minus_q2_q2_two_sum_2;
    let q2_vx_minus_wind_x_q2_sum = q2 * vx_minus_wind_x_q2_sum;
    let part_of_d_vy_dot_d_q1 =
        minus_q2_q2_two_product * (q2_vx_minus_wind_x_q2_sum + air_velocity_2 * q1_two);
    let part_of_d_vy_dot_d_q1_2 =
        sqrt_q2_q2_two_plus_product * (part_of_d_vy_dot_d_q1 - q0_sqrt_vx_minus_wind_sum);
    let part_of_d_vy_dot_d_q1_5 = vx_minus_wind_x_q2_sum_2 * two_q3_vz_minus_product;
    let part_of_d_vy_dot_d_q1_4 =
        part_of_d_vy_dot_d_q1_3 + vx_minus_wind_x_q2_two_sum * air_velocity_2_part_sum;
    let part_of_d_vy_dot_d_q1_6 =
        part_of_d_vy_dot_d_q1_4 + part_of_d_vy_dot_d_q1_2 - part_of_d_vy_dot_d_q1_5;
    let part_of_d_vy_dot_d_q2_2 = vy_minus_wind_y_q3_two_sum * minus_minus_q2_q2_two_sum_2;
    let part_of_d_vy_dot_d_q2 =
        sqrt_q2_q2_two_plus_product * (q3_sqrt_vx_minus_wind_sum + q1 * vx_minus_wind_x_q2_product);
    let part_of_d_vy_dot_d_q2_4 = air_velocity_2_part_sum * two_q3_vz_minus_product_2;
    let part_of_d_vy_dot_d_q2_3 =
        part_of_d_vy_dot_d_q2_2 + vz_minus_wind_z_q0_two_sum * vx_minus_wind_x_q2_sum_2;
    let part_of_d_vy_dot_d_q2_5 =
        part_of_d_vy_dot_d_q2_3 + part_of_d_vy_dot_d_q2 + part_of_d_vy_dot_d_q2_4;
    let part_of_d_vy_dot_d_q3_2 = vx_minus_wind_x_q0_two_sum * air_velocity_2_part_sum;
    let q0_vx_minus_wind_x_product = q0 * vx_minus_wind_x_q2_product;
    let part_of_d_vy_dot_d_q3 =
        q2_sqrt_vx_minus_wind_sum + q0_vx_minus_wind_x_product + q3_two * air_velocity_2_product;
    let part_of_d_vy_dot_d_q3_3 =
        minus_vy_minus_wind_y_sum * vx_minus_wind_x_q2_sum_2 - part_of_d_vy_dot_d_q3_2;
    let part_of_d_vy_dot_d_q3_4 =
        part_of_d_vy_dot_d_q3_3 + sqrt_q2_q2_two_plus_product * part_of_d_vy_dot_d_q3;
    let part_of_d_vy_dot_d_q3_5 =
        part_of_d_vy_dot_d_q3_4 + minus_minus_q2_q2_two_sum_2 * two_q2_vy_minus_product;
    let part_of_two_part_plus_part_sqrt_sum =
        T::splat(0.5) * minus_q3_q1_minus_q2_q0_sum * inv_sqrt_vx_minus_product_2;
    let part_of_two_part_plus_part_sqrt_sum_2 =
        T::splat(0.25) * q2_q2_two_plus_q1_q1_sum * C_L_minus_C_La_sqrt_vx_sum;
    let part_of_two_part_plus_part_sqrt_sum_3 =
        part_of_two_part_plus_part_sqrt_sum + part_of_two_part_plus_part_sqrt_sum_2;
    let part_of_two_part_plus_part_sqrt_sum_4 =
        part_of_two_part_plus_part_sqrt_sum_3 * sqrt_q2_q2_two_plus_product_2;
    let part_of_two_part_plus_part_sqrt_sum_5 =
        T::splat(0.5) * minus_q2_q2_two_product_sum_2 * inv_sqrt_q2_q2_two_product_2;
    let part_of_two_part_plus_part_sqrt_sum_6 =
        part_of_two_part_plus_part_sqrt_sum_4 + part_of_two_part_plus_part_sqrt_sum_5;
    let two_part_plus_part_sqrt_sum = T::splat(2.0) * part_of_two_part_plus_part_sqrt_sum_6;
    let part_of_q3_q1_minus_q2_q0_sum = vx_minus_wind_x_q2_sum * two_part_plus_part_sqrt_sum;
    let q3_q1_minus_q2_q0_sum =
        q3_q1_minus_q2_q0 * sqrt_q2_q2_two_plus_product_3 - part_of_q3_q1_minus_q2_q0_sum;
    let part_of_minus_minus_q2_q2_two_sum_3_4 =
        minus_q2_q2_two_product_sum_2 * q2_q2_two_plus_q1_product_4;
    let part_of_minus_minus_q2_q2_two_sum_3 = C_D_plus_C_La_sqrt_vx_sum * q2_q2_two_plus_q1_product;
    let part_of_minus_minus_q2_q2_two_sum_3_2 =
        minus_q3_q1_minus_q2_q0_sum * nonzero_vx_minus_sum - part_of_minus_minus_q2_q2_two_sum_3;
    let part_of_minus_minus_q2_q2_two_sum_3_3 =
        sqrt_q2_q2_two_plus_product * part_of_minus_minus_q2_q2_two_sum_3_2;
    let minus_minus_q2_q2_two_sum_3 =
        part_of_minus_minus_q2_q2_two_sum_3_3 - part_of_minus_minus_q2_q2_two_sum_3_4;
    let part_of_q3_q2_plus_q1_q0_sum = q3_q2_plus_q1_q0 * sqrt_q2_q2_two_plus_product_3;
    let q3_q2_plus_q1_q0_sum =
        part_of_q3_q2_plus_q1_q0_sum + air_velocity_2 * two_part_plus_part_sqrt_sum;
    let part_of_d_vz_dot_d_vx =
        q3_q1_plus_q2_q0 * minus_minus_q2_q2_two_sum_3 + q1_q2_minus_q3_q0 * q3_q2_plus_q1_q0_sum;
    let part_of_d_vz_dot_d_vx_2 =
        q2_q2_two_plus_minus_n1_sum * q3_q1_minus_q2_q0_sum - T::splat(2.0) * part_of_d_vz_dot_d_vx;
    let part_of_d_vz_dot_d_vy =
        q3_q2_minus_q1_q0 * minus_minus_q2_q2_two_sum_3 + q1_q2_plus_q3_q0 * q3_q1_minus_q2_q0_sum;
    let part_of_d_vz_dot_d_vy_2 =
        q1_q1_two_plus_minus_n1_sum * q3_q2_plus_q1_q0_sum - T::splat(2.0) * part_of_d_vz_dot_d_vy;
    let part_of_d_vz_dot_d_vz_2 = q2_q2_two_plus_q1_q1_sum * minus_minus_q2_q2_two_sum_3;
    let part_of_d_vz_dot_d_vz =
        q3_q2_plus_q1_q0 * q3_q2_plus_q1_q0_sum + q3_q1_minus_q2_q0 * q3_q1_minus_q2_q0_sum;
    let part_of_d_vz_dot_d_q0 =
        (q1_air_velocity_2 + q2_vx_minus_wind_x_q2_sum) * sqrt_q2_q2_two_plus_product_3;
    let part_of_d_vz_dot_d_q0_2 = minus_q1_vy_minus_wind_sum * minus_minus_q2_q2_two_sum_3;
    let part_of_d_vz_dot_d_q0_3 =
        part_of_d_vz_dot_d_q0_2 - minus_q1_vz_minus_wind_sum * q3_q2_plus_q1_q0_sum;
    let part_of_d_vz_dot_d_q0_4 =
        part_of_d_vz_dot_d_q0_3 + minus_q2_vz_minus_wind_sum * q3_q1_minus_q2_q0_sum;
    let part_of_d_vz_dot_d_q1_2 = vx_minus_wind_x_q3_two_sum * minus_minus_q2_q2_two_sum_3;
    let part_of_d_vz_dot_d_q1 =
        q3_vx_minus_wind_x_product - q0_air_velocity_2_product - sqrt_vx_minus_wind_sum * q1_two;
    let part_of_d_vz_dot_d_q1_3 =
        sqrt_q2_q2_two_plus_product * part_of_d_vz_dot_d_q1 - part_of_d_vz_dot_d_q1_2;
    let part_of_d_vz_dot_d_q1_4 =
        part_of_d_vz_dot_d_q1_3 - vx_minus_wind_x_q2_two_sum * q3_q2_plus_q1_q0_sum;
    let part_of_d_vz_dot_d_q1_5 =
        part_of_d_vz_dot_d_q1_4 - q3_q1_minus_q2_q0_sum * two_q3_vz_minus_product;
    let part_of_d_vz_dot_d_q2_2 = vy_minus_wind_y_q3_two_sum * minus_minus_q2_q2_two_sum_3;
    let part_of_d_vz_dot_d_q2 =
        q3_air_velocity_2_product + q0_vx_minus_wind_x_product + sqrt_vx_minus_wind_sum * q2_two;
    let part_of_d_vz_dot_d_q2_3 =
        vz_minus_wind_z_q0_two_sum * q3_q1_minus_q2_q0_sum - part_of_d_vz_dot_d_q2_2;
    let part_of_d_vz_dot_d_q2_4 =
        part_of_d_vz_dot_d_q2_3 - sqrt_q2_q2_two_plus_product * part_of_d_vz_dot_d_q2;
    let part_of_d_vz_dot_d_q2_5 =
        part_of_d_vz_dot_d_q2_4 - q3_q2_plus_q1_q0_sum * two_q3_vz_minus_product_2;
    let part_of_d_vz_dot_d_q3_2 = minus_vy_minus_wind_y_sum * q3_q1_minus_q2_q0_sum;
    let part_of_d_vz_dot_d_q3 =
        (q1 * vx_minus_wind_x_q2_sum - q2 * air_velocity_2) * sqrt_q2_q2_two_plus_product_3;
    let part_of_d_vz_dot_d_q3_4 = minus_minus_q2_q2_two_sum_3 * two_q2_vy_minus_product;
    let part_of_d_vz_dot_d_q3_3 =
        vx_minus_wind_x_q0_two_sum * q3_q2_plus_q1_q0_sum + part_of_d_vz_dot_d_q3_2;
    let part_of_d_vz_dot_d_q3_5 =
        part_of_d_vz_dot_d_q3_3 + part_of_d_vz_dot_d_q3 - part_of_d_vz_dot_d_q3_4;
    let half_p = T::splat(0.5) * p;
    let half_q = T::splat(0.5) * q;
    let half_r = T::splat(0.5) * r;
    let q1_half = T::splat(0.5) * q1;
    let q2_half = T::splat(0.5) * q2;
    let q3_half = T::splat(0.5) * q3;
    let q0_half = T::splat(0.5) * q0;
    let d_q_dot_d_air_velocity_2 = q2_q2_two_plus_q1_product_2 * r_C_Rr_minus_inv_sqrt_sum;
    let air_velocity_2_q2_product = air_velocity_2 * q2_q2_two_plus_q1_product_2;
    let inv_sqrt_vx_minus_product_3 = inv_sqrt_vx_minus_wind_x_of * inv_sqrt_vx_minus_wind_x_of;
    let part_of_half_minus_C_Ma_q2_product =
        C_Mq * air_velocity_2_p_plus_sum * inv_sqrt_vx_minus_product_3;
    let part_of_half_minus_C_Ma_q2_product_2 =
        part_of_half_minus_C_Ma_q2_product - C_Ma * q2_q2_two_plus_q1_product_3;
    let half_minus_C_Ma_q2_product = T::splat(0.5) * part_of_half_minus_C_Ma_q2_product_2;
    let part_of_minus_air_velocity_2_sum_2_6 =
        air_velocity_2_q2_product * half_minus_C_Ma_q2_product;
    let q2_q2_two_plus_q1_product_5 = const_p3_p4_p5_inv_p2 * q2_q2_two_plus_q1_sum_sum;
    let part_of_minus_air_velocity_2_sum_2_2 =
        air_velocity_2_product_sum * q2_q2_two_plus_q1_product_5;
    let vx_minus_wind_x_q2_product_2 = vx_minus_wind_x_q2_sum * q2_q2_two_plus_q1_product_2;
    let vx_minus_wind_x_q2_product_3 = half_p12 * vx_minus_wind_x_q2_sum_sum_2;
    let part_of_minus_air_velocity_2_sum_2 =
        vx_minus_wind_x_q2_product_2 * vx_minus_wind_x_q2_product_3;
    let part_of_minus_air_velocity_2_sum_2_3 =
        part_of_minus_air_velocity_2_sum_2_2 - part_of_minus_air_velocity_2_sum_2;
    let part_of_minus_air_velocity_2_sum_2_4 =
        part_of_minus_air_velocity_2_sum_2_3 * inv_sqrt_vx_minus_product_3;
    let part_of_minus_air_velocity_2_sum_2_5 =
        part_of_minus_air_velocity_2_sum_2_4 - half_p3_inv_p2_p5_p4 * air_velocity_2_product_sum;
    let minus_air_velocity_2_sum_2 =
        part_of_minus_air_velocity_2_sum_2_5 - part_of_minus_air_velocity_2_sum_2_6;
    let two_inv_sqrt_vx_product = T::splat(2.0) * inv_sqrt_vx_minus_wind_x_of;
    let vx_minus_wind_x_q2_product_4 = vx_minus_wind_x_q2_sum * two_inv_sqrt_vx_product;
    let q_inv_sqrt_vx_minus_product = q * inv_sqrt_vx_minus_product;
    let p_inv_sqrt_vx_minus_product = p * inv_sqrt_vx_minus_product;
    let part_of_air_velocity_2_q2_sum = vx_minus_wind_x_q2_product_2 * p_inv_sqrt_vx_minus_product;
    let air_velocity_2_q2_sum =
        air_velocity_2_q2_product * q_inv_sqrt_vx_minus_product + part_of_air_velocity_2_q2_sum;
    let part_of_d_q_dot_d_air_velocity_sum =
        d_q_dot_d_air_velocity_2 - minus_air_velocity_2_sum_2 * vx_minus_wind_x_q2_product_4;
    let d_q_dot_d_air_velocity_sum = part_of_d_q_dot_d_air_velocity_sum - air_velocity_2_q2_sum;
    let part_of_d_p_dot_d_vx_2 = q2_q2_two_plus_minus_n1_sum * d_q_dot_d_air_velocity_sum;
    let C_Ma_sqrt_vx_minus_product = C_Ma * sqrt_vx_minus_wind_product;
    let part_of_air_velocity_2_q2_sum_2 = air_velocity_2_q2_product * C_Ma_sqrt_vx_minus_product;
    let d_part_part_inv_product =
        p3_p4_p5_inv_p2 * (q2_q2_two_plus_q1_sum * inv_sqrt_vx_minus_wind_x_of);
    let air_velocity_2_q2_sum_2 =
        part_of_air_velocity_2_q2_sum_2 + air_velocity_2_product_sum * d_part_part_inv_product;
    let q2_q2_two_plus_q1_product_6 = q2_q2_two_plus_q1_product_2 * alpha_C_Ma_minus_air_sum;
    let air_velocity_2_two_product = air_velocity_2 * two_inv_sqrt_vx_product;
    let part_of_air_velocity_2_q2_sum_3 =
        vx_minus_wind_x_q2_product_2 * q_inv_sqrt_vx_minus_product;
    let air_velocity_2_q2_sum_3 =
        air_velocity_2_q2_product * p_inv_sqrt_vx_minus_product - part_of_air_velocity_2_q2_sum_3;
    let part_of_q2_q2_two_plus_q1_sum_2 =
        q2_q2_two_plus_q1_product_6 - minus_air_velocity_2_sum_2 * air_velocity_2_two_product;
    let q2_q2_two_plus_q1_sum_2 = part_of_q2_q2_two_plus_q1_sum_2 - air_velocity_2_q2_sum_3;
    let part_of_d_p_dot_d_vx =
        q3_q1_plus_q2_q0 * air_velocity_2_q2_sum_2 - q1_q2_minus_q3_q0 * q2_q2_two_plus_q1_sum_2;
    let part_of_d_p_dot_d_vy_2 = q1_q1_two_plus_minus_n1_sum * q2_q2_two_plus_q1_sum_2;
    let part_of_d_p_dot_d_vy =
        q3_q2_minus_q1_q0 * air_velocity_2_q2_sum_2 + q1_q2_plus_q3_q0 * d_q_dot_d_air_velocity_sum;
    let part_of_d_p_dot_d_vz =
        q3_q2_plus_q1_q0 * q2_q2_two_plus_q1_sum_2 - q3_q1_minus_q2_q0 * d_q_dot_d_air_velocity_sum;
    let part_of_d_p_dot_d_vz_2 = -(q2_q2_two_plus_q1_q1_sum * air_velocity_2_q2_sum_2);
    let part_of_d_p_dot_d_q0 = minus_q1_vz_minus_wind_sum * q2_q2_two_plus_q1_sum_2;
    let part_of_d_p_dot_d_q0_2 =
        minus_q1_vy_minus_wind_sum * air_velocity_2_q2_sum_2 + part_of_d_p_dot_d_q0;
    let part_of_d_p_dot_d_q0_3 =
        part_of_d_p_dot_d_q0_2 + minus_q2_vz_minus_wind_sum * d_q_dot_d_air_velocity_sum;
    let part_of_d_p_dot_d_q1 = vx_minus_wind_x_q2_two_sum * q2_q2_two_plus_q1_sum_2;
    let part_of_d_p_dot_d_q1_2 =
        vx_minus_wind_x_q3_two_sum * air_velocity_2_q2_sum_2 - part_of_d_p_dot_d_q1;
    let part_of_d_p_dot_d_q1_3 =
        part_of_d_p_dot_d_q1_2 + d_q_dot_d_air_velocity_sum * two_q3_vz_minus_product;
    let part_of_d_p_dot_d_q2 = vz_minus_wind_z_q0_two_sum * d_q_dot_d_air_velocity_sum;
    let part_of_d_p_dot_d_q2_2 =
        vy_minus_wind_y_q3_two_sum * air_velocity_2_q2_sum_2 - part_of_d_p_dot_d_q2;
    let part_of_d_p_dot_d_q2_3 =
        part_of_d_p_dot_d_q2_2 - q2_q2_two_plus_q1_sum_2 * two_q3_vz_minus_product_2;
    let part_of_d_p_dot_d_q3 = minus_vy_minus_wind_y_sum * d_q_dot_d_air_velocity_sum;
    let part_of_d_p_dot_d_q3_2 =
        vx_minus_wind_x_q0_two_sum * q2_q2_two_plus_q1_sum_2 - part_of_d_p_dot_d_q3;
    let part_of_d_p_dot_d_q3_3 =
        part_of_d_p_dot_d_q3_2 + air_velocity_2_q2_sum_2 * two_q2_vy_minus_product;
    let vx_minus_wind_x_q2_product_5 =
        vx_minus_wind_x_q2_sum_sum * q2_q2_two_plus_q1_product_2 * inv_sqrt_vx_minus_product;
    let part_of_minus_minus_vx_minus_sum_3 =
        vx_minus_wind_x_q2_product_2 * half_minus_C_Ma_q2_product;
    let part_of_minus_minus_vx_minus_sum = air_velocity_2_q2_product * vx_minus_wind_x_q2_product_3;
    let part_of_minus_minus_vx_minus_sum_2 =
        minus_vx_minus_wind_x_sum * q2_q2_two_plus_q1_product_5 - part_of_minus_minus_vx_minus_sum;
    let part_of_minus_minus_vx_minus_sum_5 =
        part_of_minus_minus_vx_minus_sum_2 * inv_sqrt_vx_minus_product_3;
    let part_of_minus_minus_vx_minus_sum_4 =
        part_of_minus_minus_vx_minus_sum_3 - half_p3_inv_p2_p5_p4 * minus_vx_minus_wind_x_sum;
    let minus_minus_vx_minus_sum =
        part_of_minus_minus_vx_minus_sum_4 + part_of_minus_minus_vx_minus_sum_5;
    let part_of_q2_q2_two_plus_q1_sum_3 =
        q2_q2_two_plus_q1_product_6 + minus_minus_vx_minus_sum * vx_minus_wind_x_q2_product_4;
    let q2_q2_two_plus_q1_sum_3 = part_of_q2_q2_two_plus_q1_sum_3 + air_velocity_2_q2_sum_3;
    let part_of_minus_vx_minus_wind_x_sum_3 =
        vx_minus_wind_x_q2_product_2 * C_Ma_sqrt_vx_minus_product;
    let minus_vx_minus_wind_x_sum_3 =
        minus_vx_minus_wind_x_sum * d_part_part_inv_product - part_of_minus_vx_minus_wind_x_sum_3;
    let part_of_d_q_dot_d_air_velocity_sum_2 =
        d_q_dot_d_air_velocity_2 - minus_minus_vx_minus_sum * air_velocity_2_two_product;
    let d_q_dot_d_air_velocity_sum_2 = part_of_d_q_dot_d_air_velocity_sum_2 + air_velocity_2_q2_sum;
    let part_of_d_q_dot_d_vx = q1_q2_minus_q3_q0 * d_q_dot_d_air_velocity_sum_2;
    let part_of_d_q_dot_d_vx_2 =
        q3_q1_plus_q2_q0 * minus_vx_minus_wind_x_sum_3 - part_of_d_q_dot_d_vx;
    let part_of_d_q_dot_d_vx_3 = -(q2_q2_two_plus_minus_n1_sum * q2_q2_two_plus_q1_sum_3);
    let part_of_d_q_dot_d_vy = q3_q2_minus_q1_q0 * minus_vx_minus_wind_x_sum_3;
    let part_of_d_q_dot_d_vy_2 = part_of_d_q_dot_d_vy - q1_q2_plus_q3_q0 * q2_q2_two_plus_q1_sum_3;
    let part_of_d_q_dot_d_vy_3 = -(q1_q1_two_plus_minus_n1_sum * d_q_dot_d_air_velocity_sum_2);
    let part_of_d_q_dot_d_vz_3 = q2_q2_two_plus_q1_q1_sum * minus_vx_minus_wind_x_sum_3;
    let part_of_d_q_dot_d_vz = q3_q2_plus_q1_q0 * d_q_dot_d_air_velocity_sum_2;
    let part_of_d_q_dot_d_vz_2 = part_of_d_q_dot_d_vz + q3_q1_minus_q2_q0 * q2_q2_two_plus_q1_sum_3;
    let part_of_minus_two_part_part_sum = minus_q1_vz_minus_wind_sum * d_q_dot_d_air_velocity_sum_2;
    let part_of_minus_two_part_part_sum_2 =
        minus_q1_vy_minus_wind_sum * minus_vx_minus_wind_x_sum_3 + part_of_minus_two_part_part_sum;
    let part_of_minus_two_part_part_sum_3 =
        part_of_minus_two_part_part_sum_2 - minus_q2_vz_minus_wind_sum * q2_q2_two_plus_q1_sum_3;
    let minus_two_part_part_sum = -(T::splat(2.0) * part_of_minus_two_part_part_sum_3);
    let part_of_d_q_dot_d_q1 = vx_minus_wind_x_q2_two_sum * d_q_dot_d_air_velocity_sum_2;
    let part_of_d_q_dot_d_q1_2 =
        part_of_d_q_dot_d_q1 - vx_minus_wind_x_q3_two_sum * minus_vx_minus_wind_x_sum_3;
    let part_of_d_q_dot_d_q1_3 =
        part_of_d_q_dot_d_q1_2 + q2_q2_two_plus_q1_sum_3 * two_q3_vz_minus_product;
    let part_of_d_q_dot_d_q2 = vy_minus_wind_y_q3_two_sum * minus_vx_minus_wind_x_sum_3;
    let part_of_d_q_dot_d_q2_2 =
        d_q_dot_d_air_velocity_sum_2 * two_q3_vz_minus_product_2 - part_of_d_q_dot_d_q2;
    let part_of_d_q_dot_d_q2_3 =
        part_of_d_q_dot_d_q2_2 - vz_minus_wind_z_q0_two_sum * q2_q2_two_plus_q1_sum_3;
    let part_of_d_q_dot_d_q3 = -(vx_minus_wind_x_q0_two_sum * d_q_dot_d_air_velocity_sum_2);
    let part_of_d_q_dot_d_q3_2 =
        part_of_d_q_dot_d_q3 - minus_vy_minus_wind_y_sum * q2_q2_two_plus_q1_sum_3;
    let part_of_d_q_dot_d_q3_3 =
        part_of_d_q_dot_d_q3_2 - minus_vx_minus_wind_x_sum_3 * two_q2_vy_minus_product;
    let minus_minus_q0_dot = -minus_q0_dot;
    let minus_minus_q1_dot = -minus_q1_dot;
    let minus_minus_q2_dot = -minus_q2_dot;
    let minus_minus_q3_dot = -minus_q3_dot;
    let minus_half_p = -half_p;
    let minus_half_q = -half_q;
    let minus_half_r = -half_r;
    let minus_q1_half = -q1_half;
    let minus_q2_half = -q2_half;
    let minus_q3_half = -q3_half;
    let minus_half_q_2 = -half_q;
    let minus_q3_half_2 = -q3_half;
    let minus_half_r_2 = -half_r;
    let minus_q1_half_2 = -q1_half;
    let minus_half_p_2 = -half_p;
    let minus_q2_half_2 = -q2_half;
    let minus_r_n1_minus_I_a_inv_part = -r_n1_minus_I_a_inv_part;

    dx[0] = vx;
    dx[1] = vy;
    dx[2] = vz;
    dx[3] = vx_dot;
    dx[4] = vy_dot;
    dx[5] = vz_dot;
    dx[6] = minus_minus_q0_dot;
    dx[7] = minus_minus_q1_dot;
    dx[8] = minus_minus_q2_dot;
    dx[9] = minus_minus_q3_dot;
    dx[10] = p_dot;
    dx[11] = q_dot;
    dx[12] = r_dot;

    j[0] = T::splat(1.0); // d_x_dot_d_vx
    j[1] = T::splat(1.0); // d_y_dot_d_vy
    j[2] = T::splat(1.0); // d_z_dot_d_vz
    j[3] = part_of_d_vx_dot_d_vx_2 - T::splat(2.0) * part_of_d_vx_dot_d_vx; // d_vx_dot_d_vx
    j[4] = part_of_d_vx_dot_d_vy_2 - T::splat(2.0) * part_of_d_vx_dot_d_vy; // d_vx_dot_d_vy
    j[5] = part_of_d_vx_dot_d_vz_3; // d_vx_dot_d_vz
    j[6] = part_of_d_vx_dot_d_q0 - T::splat(2.0) * part_of_d_vx_dot_d_q0_4; // d_vx_dot_d_q0
    j[7] = part_of_d_vx_dot_d_q1_4 - part_of_d_vx_dot_d_q1; // d_vx_dot_d_q1
    j[8] = part_of_d_vx_dot_d_q2_6; // d_vx_dot_d_q2
    j[9] = part_of_d_vx_dot_d_q3_5; // d_vx_dot_d_q3
    j[10] = part_of_d_vy_dot_d_vx_4; // d_vy_dot_d_vx
    j[11] = part_of_d_vy_dot_d_vy_4; // d_vy_dot_d_vy
    j[12] = T::splat(2.0) * part_of_d_vy_dot_d_vz - part_of_d_vy_dot_d_vz_2; // d_vy_dot_d_vz
    j[13] = part_of_d_vy_dot_d_q0 + T::splat(2.0) * part_of_d_vy_dot_d_q0_4; // d_vy_dot_d_q0
    j[14] = part_of_d_vy_dot_d_q1_6; // d_vy_dot_d_q1
    j[15] = part_of_d_vy_dot_d_q2_5; // d_vy_dot_d_q2
    j[16] = part_of_d_vy_dot_d_q3_5; // d_vy_dot_d_q3
    j[17] = part_of_d_vz_dot_d_vx_2; // d_vz_dot_d_vx
    j[18] = part_of_d_vz_dot_d_vy_2; // d_vz_dot_d_vy
    j[19] = part_of_d_vz_dot_d_vz_2 - T::splat(2.0) * part_of_d_vz_dot_d_vz; // d_vz_dot_d_vz
    j[20] = -part_of_d_vz_dot_d_q0 - T::splat(2.0) * part_of_d_vz_dot_d_q0_4; // d_vz_dot_d_q0
    j[21] = part_of_d_vz_dot_d_q1_5; // d_vz_dot_d_q1
    j[22] = part_of_d_vz_dot_d_q2_5; // d_vz_dot_d_q2
    j[23] = part_of_d_vz_dot_d_q3_5; // d_vz_dot_d_q3
    j[24] = minus_half_p; // d_q0_dot_d_q1
    j[25] = minus_half_q; // d_q0_dot_d_q2
    j[26] = minus_half_r; // d_q0_dot_d_q3
    j[27] = minus_q1_half; // d_q0_dot_d_p
    j[28] = minus_q2_half; // d_q0_dot_d_q
    j[29] = minus_q3_half; // d_q0_dot_d_r
    j[30] = half_p; // d_q1_dot_d_q0
    j[31] = half_r; // d_q1_dot_d_q2
    j[32] = minus_half_q_2; // d_q1_dot_d_q3
    j[33] = q0_half; // d_q1_dot_d_p
    j[34] = minus_q3_half_2; // d_q1_dot_d_q
    j[35] = q2_half; // d_q1_dot_d_r
    j[36] = half_q; // d_q2_dot_d_q0
    j[37] = minus_half_r_2; // d_q2_dot_d_q1
    j[38] = half_p; // d_q2_dot_d_q3
    j[39] = q3_half; // d_q2_dot_d_p
    j[40] = q0_half; // d_q2_dot_d_q
    j[41] = minus_q1_half_2; // d_q2_dot_d_r
    j[42] = half_r; // d_q3_dot_d_q0
    j[43] = half_q; // d_q3_dot_d_q1
    j[44] = minus_half_p_2; // d_q3_dot_d_q2
    j[45] = minus_q2_half_2; // d_q3_dot_d_p
    j[46] = q1_half; // d_q3_dot_d_q
    j[47] = q0_half; // d_q3_dot_d_r
    j[48] = T::splat(2.0) * part_of_d_p_dot_d_vx - part_of_d_p_dot_d_vx_2; // d_p_dot_d_vx
    j[49] = part_of_d_p_dot_d_vy_2 + T::splat(2.0) * part_of_d_p_dot_d_vy; // d_p_dot_d_vy
    j[50] = part_of_d_p_dot_d_vz_2 - T::splat(2.0) * part_of_d_p_dot_d_vz; // d_p_dot_d_vz
    j[51] = T::splat(2.0) * part_of_d_p_dot_d_q0_3; // d_p_dot_d_q0
    j[52] = part_of_d_p_dot_d_q1_3; // d_p_dot_d_q1
    j[53] = part_of_d_p_dot_d_q2_3; // d_p_dot_d_q2
    j[54] = part_of_d_p_dot_d_q3_3; // d_p_dot_d_q3
    j[55] = vx_minus_wind_x_q2_product_5; // d_p_dot_d_p
    j[56] = r_n1_minus_I_a_inv_part; // d_p_dot_d_q
    j[57] = n1_minus_inv_p2_p1 * q - C_Rr * vx_minus_wind_x_q2_product_2; // d_p_dot_d_r
    j[58] = part_of_d_q_dot_d_vx_3 - T::splat(2.0) * part_of_d_q_dot_d_vx_2; // d_q_dot_d_vx
    j[59] = part_of_d_q_dot_d_vy_3 - T::splat(2.0) * part_of_d_q_dot_d_vy_2; // d_q_dot_d_vy
    j[60] = part_of_d_q_dot_d_vz_3 + T::splat(2.0) * part_of_d_q_dot_d_vz_2; // d_q_dot_d_vz
    j[61] = minus_two_part_part_sum; // d_q_dot_d_q0
    j[62] = part_of_d_q_dot_d_q1_3; // d_q_dot_d_q1
    j[63] = part_of_d_q_dot_d_q2_3; // d_q_dot_d_q2
    j[64] = part_of_d_q_dot_d_q3_3; // d_q_dot_d_q3
    j[65] = minus_r_n1_minus_I_a_inv_part; // d_q_dot_d_p
    j[66] = vx_minus_wind_x_q2_product_5; // d_q_dot_d_q
    j[67] = C_Rr * air_velocity_2_q2_product - n1_minus_inv_p2_p1 * p; // d_q_dot_d_r
    j[68] = p14_inv_p1; // d_r_dot_d_r
}
