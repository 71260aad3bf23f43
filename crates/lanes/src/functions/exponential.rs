//! Exponential, logarithm and hyperbolic tangent.

use super::{ROUND_TO_INTEGER, polynomial};
use crate::primitive::Primitive;
use std::f64::consts::LOG2_E;

/// ln 2 as head and tail: the head has 42 bits, so that its products with integers of 11 bits are exact.
const LN_2: [f64; 2] = [
    f64::from_bits(0x3fe6_2e42_fefa_3800),
    5.497_923_018_708_371e-14,
];

/// Polynomial coefficients of (exp(r) - 1 - r)/r² for |r| up to ln(2)/2, by Remez exchange; relative error 4e-18.
const EXPONENTIAL: [f64; 10] = [
    0.5000000000000012,
    0.166666666666667,
    0.041666666666521864,
    0.008333333333307887,
    0.001388888894557187,
    0.00019841269916111664,
    2.4801491261949098e-05,
    2.755721730485079e-06,
    2.763085589515106e-07,
    2.5117575382082537e-08,
];

/// Computes 2 to the power of an integer from -1022 to 1023.
#[inline(always)]
fn exp2_integer<T: Primitive>(integer: T) -> T {
    (integer + T::broadcast(ROUND_TO_INTEGER + 1023.0)).shl_bits::<52>()
}

#[inline(always)]
pub(crate) fn exp<T: Primitive>(x: T) -> T {
    // Outside [-746, 710] the result is 0 or infinite; NaN passes both selections.
    let x = T::select(x.lt(T::broadcast(-746.0)), T::broadcast(-746.0), x);
    let x = T::select(T::broadcast(710.0).lt(x), T::broadcast(710.0), x);
    let twos = x.mul_add_op(T::broadcast(LOG2_E), T::broadcast(ROUND_TO_INTEGER))
        - T::broadcast(ROUND_TO_INTEGER);
    let r = twos.neg_mul_add_op(
        T::broadcast(LN_2[1]),
        twos.neg_mul_add_op(T::broadcast(LN_2[0]), x),
    );
    let e = T::broadcast(1.0) + (r * r).mul_add_op(polynomial(r, EXPONENTIAL), r);
    // In two factors, for results that are subnormal or nearly too large.
    let some = twos.mul_add_op(T::broadcast(0.5), T::broadcast(ROUND_TO_INTEGER))
        - T::broadcast(ROUND_TO_INTEGER);
    e * exp2_integer(some) * exp2_integer(twos - some)
}

// Coefficients of Sun's fdlibm (1993): (log(1+f) - 2s)/s in powers of s², s = f/(2+f).
const LOGARITHM: [f64; 7] = [
    6.666_666_666_666_735e-1,
    3.999_999_999_940_942e-1,
    2.857_142_874_366_239e-1,
    2.222_219_843_214_978_4e-1,
    1.818_357_216_161_805e-1,
    1.531_383_769_920_937_3e-1,
    1.479_819_860_511_658_6e-1,
];

#[inline(always)]
pub(crate) fn log<T: Primitive>(x: T) -> T {
    let one = T::broadcast(1.0);
    // Subnormal numbers are first made normal.
    let tiny = x.lt(T::broadcast(f64::MIN_POSITIVE));
    let scaled = T::select(tiny, x * T::broadcast(18_014_398_509_481_984.0), x); // 2^54
    let start = T::select(tiny, T::broadcast(-54.0 - 1023.0), T::broadcast(-1023.0));

    // x = 2^twos (1 + f), with 1 + f between √½ and √2.
    let two_52 = T::broadcast(4_503_599_627_370_496.0);
    let exponent = scaled.shr_bits::<52>().or_bits(two_52) - two_52;
    let mantissa = scaled.and_bits(T::bit_pattern((1 << 52) - 1)).or_bits(one);
    let upper = T::broadcast(std::f64::consts::SQRT_2).lt(mantissa);
    let f = T::select(upper, mantissa * T::broadcast(0.5), mantissa) - one;
    let twos = exponent + start + T::select(upper, one, T::broadcast(0.0));

    let s = f / (T::broadcast(2.0) + f);
    let z = s * s;
    let r = z * polynomial(z, LOGARITHM);
    let half_square = T::broadcast(0.5) * f * f;
    let small = s.mul_add_op(half_square + r, twos * T::broadcast(LN_2[1]));
    let log = twos.mul_sub_op(T::broadcast(LN_2[0]), (half_square - small) - f);

    let log = T::select(x.lt(T::broadcast(f64::INFINITY)), log, x);
    T::select(x.le(T::broadcast(0.0)), T::broadcast(0.0), log)
}

// Coefficients of Moshier's Cephes (1989): (tanh(x)/x - 1)/x² for |x| up to 0.625.
const TANH_OVER: [f64; 3] = [
    -1.614_687_684_417_084_5e3,
    -9.928_772_310_019_185e1,
    -9.643_991_794_250_523e-1,
];
const TANH_UNDER: [f64; 4] = [
    4.844_063_053_251_255e3,
    2.235_488_390_601_004_5e3,
    1.128_116_784_916_319_4e2,
    1.0,
];

#[inline(always)]
pub(crate) fn tanh<T: Primitive>(x: T) -> T {
    let one = T::broadcast(1.0);
    let size = x.magnitude();
    let upper = T::broadcast(0.625).lt(size);
    let z = x * x;
    // One division serves both formulas: x + x z P/Q near 0, and 1 - 2/(exp 2x + 1) elsewhere.
    let over = T::select(
        upper,
        T::broadcast(-2.0),
        size * z * polynomial(z, TANH_OVER),
    );
    let under = T::select(upper, exp(size + size) + one, polynomial(z, TANH_UNDER));
    let near = T::select(upper, one, size) + over / under;
    near.xor_bits(x.sign_bit())
}
