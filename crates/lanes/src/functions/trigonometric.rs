//! Sine and cosine, computed together.

use super::{ROUND_TO_INTEGER, polynomial};
use crate::primitive::{Primitive, map_lanes};
use std::hint::cold_path;

/// Maximum argument of the Cody–Waite reduction, rad. Up to this argument the number of quadrants fits in 16 bits, so
/// that the products of the reduction are exact.
const MAX_REDUCED: f64 = 1e5;

/// π/2 as three summands (Cody & Waite): 37 bits, the next 37, and the remainder.
const HALF_PI: [f64; 3] = [
    f64::from_bits(0x3ff9_21fb_5444_0000),
    f64::from_bits(0x3d86_8c23_4c4c_0000),
    f64::from_bits(0x3b29_8a2e_0370_7345),
];

// Coefficients of Sun's fdlibm (1993), errors below 2^-58.
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Largest argument used without reduction, rad: just below π/4.
const MAX_UNREDUCED: f64 = 0.785;

#[inline(always)]
pub(crate) fn sin_cos<T: Primitive>(x: T) -> (T, T) {
    // Fast path: the same bits as the general path, whose reduction would subtract 0.
    if T::all_true(x.magnitude().lt(T::broadcast(MAX_UNREDUCED))) {
        return kernel(x);
    }
    if T::WIDTH == 1 {
        cold_path();
    }
    reduced(x)
}

/// Sine and cosine by polynomials, for `|x| < MAX_UNREDUCED`.
#[inline(always)]
fn kernel<T: Primitive>(x: T) -> (T, T) {
    let z = x * x;
    let sine = (z * x).mul_add_op(polynomial(z, SINE), x);
    let one_less_half = z.neg_mul_add_op(T::broadcast(0.5), T::broadcast(1.0));
    let cosine = (z * z).mul_add_op(polynomial(z, COSINE), one_less_half);
    (sine, cosine)
}

#[inline(always)]
fn reduced<T: Primitive>(x: T) -> (T, T) {
    let rounded = x.mul_add_op(
        T::broadcast(std::f64::consts::FRAC_2_PI),
        T::broadcast(ROUND_TO_INTEGER),
    );
    let quarters = rounded - T::broadcast(ROUND_TO_INTEGER);

    // Reduced argument as head + tail; near a multiple of π/2 the tail carries the significant digits.
    let [most, more, rest] = HALF_PI.map(T::broadcast);
    let first = quarters.neg_mul_add_op(most, x);
    let second = quarters.neg_mul_add_op(more, first);
    let second_tail = quarters.neg_mul_add_op(more, first - second);
    let head = quarters.neg_mul_add_op(rest, second);
    let tail = quarters.neg_mul_add_op(rest, second - head) + second_tail;

    // To first order in the tail; where that is 0, these are the bits of `kernel`.
    let (sine, cosine) = kernel(head);
    let (sine, cosine) = (
        tail.mul_add_op(cosine, sine),
        tail.neg_mul_add_op(sine, cosine),
    );

    // Bit 0 of the quadrant count swaps sine and cosine, bits 0 and 1 give their signs.
    let (odd, upper) = (rounded.shl_bits::<63>(), rounded.shl_bits::<62>());
    let exchange = odd.sign_mask();
    let s = T::select(exchange, cosine, sine).xor_bits(upper.sign_bit());
    let c = T::select(exchange, sine, cosine).xor_bits(upper.xor_bits(odd).sign_bit());

    if T::all_true(x.magnitude().le(T::broadcast(MAX_REDUCED))) {
        (s, c)
    } else {
        (map_lanes(x, x, s, far_sine), map_lanes(x, x, c, far_cosine))
    }
}

fn far_sine(x: f64, _: f64, near: f64) -> f64 {
    if x.abs() <= MAX_REDUCED {
        near
    } else {
        x.sin()
    }
}

fn far_cosine(x: f64, _: f64, near: f64) -> f64 {
    if x.abs() <= MAX_REDUCED {
        near
    } else {
        x.cos()
    }
}
