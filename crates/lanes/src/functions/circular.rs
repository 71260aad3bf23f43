//! Sine and cosine together.

use super::{ROUNDER, polynomial};
use crate::primitive::{Primitive, one_by_one};
use std::hint::cold_path;

/// Up to here the products of the reduction below are exact: the count of quarter turns has 16 bits.
const FARTHEST: f64 = 1e5;

/// A quarter turn in three parts (Cody & Waite): 37 bits, the next 37, and the rest.
const QUARTER: [f64; 3] = [
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

/// Up to here, a little less than an eighth of a turn, no quarter turns are to be taken off.
const NEAR: f64 = 0.785;

#[inline(always)]
pub(crate) fn sin_cos<T: Primitive>(x: T) -> (T, T) {
    // The angles of a flight mostly are small. The bits are those of the way around, which would take off 0.
    if T::everywhere(x.magnitude().below(T::all(NEAR))) {
        return near(x);
    }
    if T::WIDTH == 1 {
        cold_path();
    }
    around(x)
}

/// For `|x|` below `NEAR`.
#[inline(always)]
fn near<T: Primitive>(x: T) -> (T, T) {
    let z = x * x;
    let sine = (z * x).times_plus(polynomial(z, SINE), x);
    let one_less_half = z.times_from(T::all(0.5), T::all(1.0));
    let cosine = (z * z).times_plus(polynomial(z, COSINE), one_less_half);
    (sine, cosine)
}

#[inline(always)]
fn around<T: Primitive>(x: T) -> (T, T) {
    let rounded = x.times_plus(T::all(std::f64::consts::FRAC_2_PI), T::all(ROUNDER));
    let quarters = rounded - T::all(ROUNDER);

    // What is left of x, as head + tail: near a multiple of a quarter turn the tail carries the digits.
    let [most, more, rest] = QUARTER.map(T::all);
    let first = quarters.times_from(most, x);
    let second = quarters.times_from(more, first);
    let second_tail = quarters.times_from(more, first - second);
    let head = quarters.times_from(rest, second);
    let tail = quarters.times_from(rest, second - head) + second_tail;

    // To first order in the tail; where that is 0, these are the bits of `near`.
    let (sine, cosine) = near(head);
    let (sine, cosine) = (tail.times_plus(cosine, sine), tail.times_from(sine, cosine));

    // Bit 0 of the count of quarters exchanges the two, bits 0 and 1 give their signs.
    let (odd, upper) = (rounded.bits_up::<63>(), rounded.bits_up::<62>());
    let exchange = odd.top_bit();
    let s = T::select(exchange, cosine, sine).bits_xor(upper.sign_bit());
    let c = T::select(exchange, sine, cosine).bits_xor(upper.bits_xor(odd).sign_bit());

    if T::everywhere(x.magnitude().at_most(T::all(FARTHEST))) {
        (s, c)
    } else {
        (
            one_by_one(x, x, s, far_sine),
            one_by_one(x, x, c, far_cosine),
        )
    }
}

fn far_sine(x: f64, _: f64, near: f64) -> f64 {
    if x.abs() <= FARTHEST { near } else { x.sin() }
}

fn far_cosine(x: f64, _: f64, near: f64) -> f64 {
    if x.abs() <= FARTHEST { near } else { x.cos() }
}
