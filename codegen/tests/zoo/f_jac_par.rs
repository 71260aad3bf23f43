// Written by `hyzer generate`; changes belong in the model.
//! `zoo`: derivatives of the states, and theirs by states and parameters.

use lanes::Real;

/// `dx`, `j`, and the entries `jp` of the Jacobian by the parameters, see `JP_PATTERN`.
///
/// 208 operations: 68 add, 94 mul, 11 div, 1 neg, 8 sqrt, 12 call, 14 select.
/// `prepare` takes 14 operations for it.
#[inline(always)]
pub fn f_jac_par<T: Real>(
    time: T,
    state: &[T; 3],
    parameters: &[T; 3],
    prepared: &[T; 13],
    dx: &mut [T; 3],
    j: &mut [T; 8],
    jp: &mut [T; 7],
) {
    let a = state[0];
    let a_sq = a * a;
    let e = state[2];
    let e_sq = e * e;
    let b = state[1];
    let b_sq = b * b;
    let k = parameters[0];
    let k_e = k * e;
    let b_const = T::splat(0.3333333333333333) * b;
    let k_a = k * a;

    // zoo:17  let sum = a + b;
    let sum = a + b;
    let angle_k_e_one = k_e.atan2(T::splat(1.0));
    let (sin_b_const, cos_b_const) = b_const.sin_cos();
    let asin_b_half = (T::splat(0.5) * b).asin();
    let (sin_a_k, cos_k_a) = k_a.sin_cos();
    let sqrt_a_sq_plus_e_sq = (a_sq + e_sq).sqrt();
    let sqrt_one_plus_b_sq = (T::splat(1.0) + b_sq).sqrt();
    let (sin_sum, cos_sum) = sum.sin_cos();
    let a_plus_two = a + T::splat(2.0);
    let asin_a_half = (T::splat(0.5) * a).asin();
    let inv_b = b.recip_or_zero();
    let sin_b_const_inv_cos_b_const = sin_b_const / cos_b_const;
    let c_sq = prepared[1];

    // zoo:15  let size = norm(v);
    let size = (c_sq.mul_add(e_sq, a_sq) + b_sq).sqrt();
    let sqrt_sum = sum.sqrt();
    let c = parameters[2];
    let tanh_sum_c = (c * sum).tanh();
    let sqrt_one_minus_b_sq_const = b_sq.neg_mul_add(T::splat(0.25), T::splat(1.0)).sqrt();
    let inv_sqrt_one_plus_b_sq = T::splat(1.0) / sqrt_one_plus_b_sq;
    let pi_half = prepared[3];
    let asin_b_half_minus_pi_half = asin_b_half - pi_half;
    let inv_sqrt_one_minus_b_sq_of = sqrt_one_minus_b_sq_const.recip_or_zero();
    let inv_one_plus_k_e_sq = T::splat(1.0) / k_e.mul_add(k_e, T::splat(1.0));
    let part_of_minus_a_inv_sqrt_a_sq =
        asin_a_half.mul_sub(asin_b_half_minus_pi_half, angle_k_e_one);
    let inv_tau_two = prepared[5];
    let part_of_d_a_dot_d_sum = inv_tau_two * cos_sum * sin_sum;
    let log_a_plus_two = a_plus_two.log();
    let inv_tau_half = prepared[8];
    let part_of_d_b_dot_d_a_2 = inv_tau_half * asin_b_half_minus_pi_half;
    let part_of_minus_a_inv_sqrt_a_sq_2 =
        log_a_plus_two.neg_mul_add(sqrt_sum, part_of_minus_a_inv_sqrt_a_sq);
    let part_of_d_b_dot_d_b = inv_tau_half * asin_a_half;
    let part_of_d_a_dot_d_b =
        sin_b_const_inv_cos_b_const.mul_add(sin_b_const_inv_cos_b_const, T::splat(1.0));
    let one_minus_a_sq_const = a_sq.neg_mul_add(T::splat(0.1111111111111111), T::splat(1.0));
    let sqrt_one_minus_a_sq_const = one_minus_a_sq_const.sqrt();
    let sqrt_one_minus_a_sq_const_2 = a_sq.neg_mul_add(T::splat(0.25), T::splat(1.0)).sqrt();
    let inv_sqrt_one_minus_a_sq_of = sqrt_one_minus_a_sq_const_2.recip_or_zero();
    let inv_sqrt_a_sq_plus_e_sq = sqrt_a_sq_plus_e_sq.recip_or_zero();
    let nonzero_sqrt_a_sq_plus_e_sq = sqrt_a_sq_plus_e_sq.if_zero(T::splat(0.0), T::splat(1.0));
    let minus_a_sq = -a_sq;
    let exp_minus_a_sq = minus_a_sq.exp();
    let part_of_tanh_sum_c_plus_exp_sum =
        cos_sum.mul_add(cos_sum, sin_a_k) + sin_b_const_inv_cos_b_const + exp_minus_a_sq;
    let tanh_sum_c_plus_exp_sum = part_of_tanh_sum_c_plus_exp_sum + tanh_sum_c;
    let minus_one_plus_tanh_sum_c_sq = tanh_sum_c.mul_sub(tanh_sum_c, T::splat(1.0));
    let minus_c_inv_tau = prepared[4];
    let d_a_dot_d_sum =
        minus_c_inv_tau.mul_sub(minus_one_plus_tanh_sum_c_sq, part_of_d_a_dot_d_sum);
    let const_inv_tau = prepared[7];
    let d_a_dot_d_b = const_inv_tau.mul_add(part_of_d_a_dot_d_b, d_a_dot_d_sum);
    j[1] = d_a_dot_d_b;
    let k_inv_tau = prepared[6];
    let part_of_d_a_dot_d_a = k_inv_tau.mul_add(cos_k_a, d_a_dot_d_sum);
    let inv_tau = prepared[0];

    // zoo:19  der(a) = (sin(a*k) + cos(sum)^2 + tan(b/3) + exp(-a^2) + tanh(sum*c))/tau;
    let a_dot = inv_tau * tanh_sum_c_plus_exp_sum;
    dx[0] = a_dot;
    let minus_inv_tau_sq = prepared[12];
    jp[1] = minus_inv_tau_sq * tanh_sum_c_plus_exp_sum; // d_a_dot_d_tau
    let inv_size = size.recip_or_zero();
    let min_a_b = a.min(b);
    let max_sum_e = sum.max(e);
    let a_inv_b = a * inv_b;
    let e_minus_const = e - T::splat(0.1);
    let step_e_minus_const = e_minus_const.heaviside();
    let nonzero_size = size.if_zero(T::splat(0.0), T::splat(1.0));
    let minus_inv_tau = prepared[2];
    jp[2] = minus_inv_tau * sum * minus_one_plus_tanh_sum_c_sq; // d_a_dot_d_c
    let step_sum_minus_e = (sum - e).heaviside();
    let unless_b = b.if_zero(c, a_inv_b);
    let abs_b = b.abs();
    let d_sqrt_a_sq_plus_e_sq_d_e = e * inv_sqrt_a_sq_plus_e_sq;
    let d_sqrt_a_sq_plus_e_sq_d_a = a * inv_sqrt_a_sq_plus_e_sq;
    let sqrt_abs_b = abs_b.sqrt();
    let minus_a_inv_sqrt_a_sq_sum =
        abs_b.neg_mul_add(sqrt_abs_b, part_of_minus_a_inv_sqrt_a_sq_2) - d_sqrt_a_sq_plus_e_sq_d_a;
    dx[1] = minus_inv_tau * minus_a_inv_sqrt_a_sq_sum;
    let inv_tau_sq = prepared[11];
    let d_b_dot_d_tau = inv_tau_sq * minus_a_inv_sqrt_a_sq_sum;
    jp[4] = d_b_dot_d_tau;
    let one_minus_nonzero_sqrt_sum =
        T::splat(1.0) + d_sqrt_a_sq_plus_e_sq_d_e - nonzero_sqrt_a_sq_plus_e_sq;
    let sign_a = a.sign();
    let step_minus_a_plus_b = (b - a).heaviside();
    let inv_sqrt_a_sq_plus_e_sq_size = inv_sqrt_a_sq_plus_e_sq * size;
    let a_inv_size = a * inv_size;
    let part_of_d_e_dot_d_a = d_sqrt_a_sq_plus_e_sq_d_a * d_sqrt_a_sq_plus_e_sq_d_e;
    let part_of_d_e_dot_d_a_2 =
        inv_sqrt_a_sq_plus_e_sq_size.neg_mul_add(part_of_d_e_dot_d_a, inv_b + nonzero_size);
    let part_of_d_b_dot_d_a =
        d_sqrt_a_sq_plus_e_sq_d_a.neg_mul_add(d_sqrt_a_sq_plus_e_sq_d_a, T::splat(1.0));
    let inv_sqrt_sum = sqrt_sum.recip_or_zero();
    let log_a_plus_two_inv_product = inv_tau_half * log_a_plus_two * inv_sqrt_sum;
    let part_of_d_b_dot_d_a_3 =
        inv_sqrt_one_minus_a_sq_of.neg_mul_add(part_of_d_b_dot_d_a_2, log_a_plus_two_inv_product);
    let part_of_d_b_dot_d_b_2 =
        inv_sqrt_one_minus_b_sq_of.neg_mul_add(part_of_d_b_dot_d_b, log_a_plus_two_inv_product);

    // zoo:16  let along = unit(v, N.3);
    let along_x = size.if_zero(T::splat(0.0), a_inv_size);
    let one_minus_nonzero_sqrt_sum_2 = along_x + one_minus_nonzero_sqrt_sum;
    let part_of_a_sq_plus_one_plus_a_sum =
        size.mul_add(one_minus_nonzero_sqrt_sum_2, a_sq + T::splat(1.0));
    let part_of_a_sq_plus_one_plus_a_sum_2 =
        min_a_b.mul_add(max_sum_e, part_of_a_sq_plus_one_plus_a_sum) + unless_b;
    let part_of_a_sq_plus_one_plus_a_sum_3 =
        sign_a.mul_add(step_e_minus_const, part_of_a_sq_plus_one_plus_a_sum_2);
    let inv_size_d_e_dot_d_size =
        inv_size * (minus_inv_tau * (a_inv_size - one_minus_nonzero_sqrt_sum_2));
    let inv_a_plus_two = a_plus_two.recip_or_zero();
    let step_a_plus_two = a_plus_two.heaviside();
    let part_of_d_b_dot_d_a_4 = sqrt_sum * step_a_plus_two * inv_a_plus_two;
    let part_of_d_b_dot_d_a_5 =
        inv_sqrt_a_sq_plus_e_sq.mul_add(part_of_d_b_dot_d_a, part_of_d_b_dot_d_a_4);
    let d_b_dot_d_a = inv_tau.mul_add(part_of_d_b_dot_d_a_5, part_of_d_b_dot_d_a_3);
    j[2] = d_b_dot_d_a;
    let part_of_d_b_dot_d_e =
        inv_sqrt_a_sq_plus_e_sq * inv_sqrt_a_sq_plus_e_sq * d_sqrt_a_sq_plus_e_sq_d_e;
    let part_of_d_e_dot_d_e =
        d_sqrt_a_sq_plus_e_sq_d_e.neg_mul_add(d_sqrt_a_sq_plus_e_sq_d_e, T::splat(1.0));
    let b_inv_sqrt_one_plus_b_sq = b * inv_sqrt_one_plus_b_sq;
    let part_of_a_sq_plus_one_plus_a_sum_4 =
        part_of_a_sq_plus_one_plus_a_sum_3 + b_inv_sqrt_one_plus_b_sq + sqrt_one_minus_a_sq_const;
    let inv_sqrt_one_minus_a_sq_of_2 = sqrt_one_minus_a_sq_const.recip_or_zero();
    let min_a_b_step_sum_minus_e = min_a_b * step_sum_minus_e;
    let part_of_d_e_dot_d_e_2 = min_a_b * (step_sum_minus_e - T::splat(1.0));
    let part_of_d_e_dot_d_e_3 =
        inv_sqrt_a_sq_plus_e_sq_size.neg_mul_add(part_of_d_e_dot_d_e, part_of_d_e_dot_d_e_2);
    let part_of_d_e_dot_d_a_3 = part_of_d_e_dot_d_a_2 + min_a_b_step_sum_minus_e;
    let part_of_d_e_dot_d_b = inv_sqrt_one_plus_b_sq + min_a_b_step_sum_minus_e;
    let part_of_d_e_dot_d_a_4 = max_sum_e.mul_add(step_minus_a_plus_b, part_of_d_e_dot_d_a_3);
    let part_of_d_e_dot_d_b_2 =
        max_sum_e.neg_mul_add(step_minus_a_plus_b - T::splat(1.0), part_of_d_e_dot_d_b);
    let a_inv_tau = inv_tau * a;
    let nonzero_b = b.if_zero(T::splat(0.0), T::splat(1.0));
    let part_of_d_e_dot_d_a_sq = inv_size_d_e_dot_d_size.mul_add(T::splat(0.5), inv_tau);
    let d_a_dot_d_a = a_inv_tau.neg_mul_add(T::splat(2.0) * exp_minus_a_sq, part_of_d_a_dot_d_a);
    j[0] = d_a_dot_d_a;
    let time_a_inv_tau = time * a_inv_tau;
    let part_of_d_e_dot_d_b_5 = inv_tau * inv_b.neg_mul_add(a_inv_b, part_of_d_e_dot_d_b_2);
    let part_of_d_e_dot_d_b_3 = inv_tau * inv_sqrt_one_plus_b_sq * inv_sqrt_one_plus_b_sq;
    let sign_b = b.sign();
    let part_of_d_e_dot_d_a_5 = inv_tau * inv_tau.mul_add(time, part_of_d_e_dot_d_a_4);
    let inv_tau_const = prepared[9];
    let d_b_dot_d_b = sign_b.mul_add(inv_tau_const * sqrt_abs_b, part_of_d_b_dot_d_b_2);
    j[3] = d_b_dot_d_b;
    let a_sq_plus_one_plus_a_sum = part_of_a_sq_plus_one_plus_a_sum_4 + time_a_inv_tau;
    let inv_tau_const_2 = prepared[10];
    let d_e_dot_d_a_sq =
        inv_tau_const_2.neg_mul_add(inv_sqrt_one_minus_a_sq_of_2, part_of_d_e_dot_d_a_sq);
    let part_of_d_e_dot_d_b_4 =
        b_inv_sqrt_one_plus_b_sq.neg_mul_add(part_of_d_e_dot_d_b_3, inv_size_d_e_dot_d_size);
    let d_b_dot_d_e = a_inv_tau.neg_mul_add(part_of_d_b_dot_d_e, k_inv_tau * inv_one_plus_k_e_sq);
    j[4] = d_b_dot_d_e;
    let d_a_dot_d_k = cos_k_a * a_inv_tau;
    jp[0] = d_a_dot_d_k;
    let d_e_dot_d_c =
        inv_size_d_e_dot_d_size.mul_sub(c * e_sq, inv_tau * (nonzero_b - T::splat(1.0)));
    jp[6] = d_e_dot_d_c;
    let d_e_dot_d_a = d_e_dot_d_a_sq.mul_add(T::splat(2.0) * a, part_of_d_e_dot_d_a_5);
    j[5] = d_e_dot_d_a;
    let d_e_dot_d_b = b.mul_add(part_of_d_e_dot_d_b_4, part_of_d_e_dot_d_b_5);
    j[6] = d_e_dot_d_b;
    let d_e_dot_d_e = inv_size_d_e_dot_d_size.mul_sub(c_sq * e, inv_tau * part_of_d_e_dot_d_e_3);
    j[7] = d_e_dot_d_e;
    jp[3] = inv_tau * e * inv_one_plus_k_e_sq; // d_b_dot_d_k

    // zoo:21  der(e) = (min(a, b)*max(sum, e) + ratio(a, b, c) + sign(a)*step(e - 0.1) + size* …
    let e_dot = inv_tau * a_sq_plus_one_plus_a_sum;
    dx[2] = e_dot;
    jp[5] = minus_inv_tau_sq * (a_sq_plus_one_plus_a_sum + time_a_inv_tau); // d_e_dot_d_tau
}
