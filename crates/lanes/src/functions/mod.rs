//! Elementary functions, each written once over the primitive operations.

pub(crate) mod exponential;
pub(crate) mod inverse_trigonometric;
pub(crate) mod piecewise;
pub(crate) mod trigonometric;

use crate::primitive::Primitive;

/// 1.5 · 2^52: adding and subtracting it rounds to the nearest integer, the low bits of the sum.
const ROUND_TO_INTEGER: f64 = 6_755_399_441_055_744.0;

/// Polynomial `c[0] + c[1] x + c[2] x² + …` by Estrin's scheme, whose two halves are evaluated independently.
#[inline(always)]
fn polynomial<T: Primitive, const N: usize>(x: T, c: [f64; N]) -> T {
    const { assert!(N >= 3 && N <= 16) };
    let x2 = x * x;
    let x4 = x2 * x2;
    if N > 8 {
        (x4 * x4).mul_add_op(eight(x, x2, x4, c, 8), eight(x, x2, x4, c, 0))
    } else {
        eight(x, x2, x4, c, 0)
    }
}

// Functions, since closures do not accept `inline(always)`.
#[inline(always)]
fn eight<T: Primitive, const N: usize>(x: T, x2: T, x4: T, c: [f64; N], i: usize) -> T {
    if N > i + 4 {
        x4.mul_add_op(four(x, x2, c, i + 4), four(x, x2, c, i))
    } else {
        four(x, x2, c, i)
    }
}

#[inline(always)]
fn four<T: Primitive, const N: usize>(x: T, x2: T, c: [f64; N], i: usize) -> T {
    if N > i + 2 {
        x2.mul_add_op(two(x, c, i + 2), two(x, c, i))
    } else {
        two(x, c, i)
    }
}

#[inline(always)]
fn two<T: Primitive, const N: usize>(x: T, c: [f64; N], i: usize) -> T {
    if N > i + 1 {
        x.mul_add_op(T::broadcast(c[i + 1]), T::broadcast(c[i]))
    } else {
        T::broadcast(c[i])
    }
}
