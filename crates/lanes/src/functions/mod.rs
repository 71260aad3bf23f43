//! The functions, each written once over the primitive operations.

pub(crate) mod basic;
pub(crate) mod circular;
pub(crate) mod exponential;
pub(crate) mod inverse;

use crate::primitive::Primitive;

/// Adding this and taking it away again rounds to the nearest integer, which the low bits then hold.
const ROUNDER: f64 = 6_755_399_441_055_744.0; // 1.5 * 2^52

/// `c[0] + c[1] x + c[2] x² + …` in halves that do not wait for each other (Estrin's order).
#[inline(always)]
fn polynomial<T: Primitive, const N: usize>(x: T, c: [f64; N]) -> T {
    const { assert!(N >= 3 && N <= 16) };
    let x2 = x * x;
    let x4 = x2 * x2;
    if N > 8 {
        (x4 * x4).times_plus(eight(x, x2, x4, c, 8), eight(x, x2, x4, c, 0))
    } else {
        eight(x, x2, x4, c, 0)
    }
}

// Functions and not closures, which could not be told to be inlined always.
#[inline(always)]
fn eight<T: Primitive, const N: usize>(x: T, x2: T, x4: T, c: [f64; N], i: usize) -> T {
    if N > i + 4 {
        x4.times_plus(four(x, x2, c, i + 4), four(x, x2, c, i))
    } else {
        four(x, x2, c, i)
    }
}

#[inline(always)]
fn four<T: Primitive, const N: usize>(x: T, x2: T, c: [f64; N], i: usize) -> T {
    if N > i + 2 {
        x2.times_plus(two(x, c, i + 2), two(x, c, i))
    } else {
        two(x, c, i)
    }
}

#[inline(always)]
fn two<T: Primitive, const N: usize>(x: T, c: [f64; N], i: usize) -> T {
    if N > i + 1 {
        x.times_plus(T::all(c[i + 1]), T::all(c[i]))
    } else {
        T::all(c[i])
    }
}
