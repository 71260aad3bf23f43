//! Square root, comparisons, and guarded functions with defined values at singular points.

use crate::primitive::Primitive;
use std::hint::cold_path;

/// Threshold on |x| below which guarded functions, such as the reciprocal with value 0 at 0, treat x as 0. It is chosen
/// so that its square is still a normal number.
const ZERO: f64 = 1e-75;

#[inline(always)]
fn is_zero<T: Primitive>(x: T) -> T::Mask {
    x.magnitude().lt(T::broadcast(ZERO))
}

#[inline(always)]
pub(crate) fn sqrt<T: Primitive>(x: T) -> T {
    if T::WIDTH == 1 {
        // A well-predicted branch is cheaper than a select, which requires the results of both branches.
        if T::all_true(T::broadcast(0.0).lt(x)) {
            return x.ieee_sqrt();
        }
        cold_path();
    }
    T::select(x.le(T::broadcast(0.0)), T::broadcast(0.0), x.ieee_sqrt())
}

#[inline(always)]
pub(crate) fn recip_or_zero<T: Primitive>(x: T) -> T {
    if T::WIDTH == 1 {
        if T::all_true(T::broadcast(ZERO).le(x.magnitude())) {
            return T::broadcast(1.0) / x;
        }
        cold_path();
    }
    T::select(is_zero(x), T::broadcast(0.0), T::broadcast(1.0) / x)
}

#[inline(always)]
pub(crate) fn min<T: Primitive>(a: T, b: T) -> T {
    T::select(a.lt(b), a, b)
}

#[inline(always)]
pub(crate) fn max<T: Primitive>(a: T, b: T) -> T {
    T::select(b.lt(a), a, b)
}

#[inline(always)]
pub(crate) fn sign<T: Primitive>(x: T) -> T {
    let zero = T::broadcast(0.0);
    let negative = T::select(x.lt(zero), T::broadcast(-1.0), zero);
    T::select(zero.lt(x), T::broadcast(1.0), negative)
}

#[inline(always)]
pub(crate) fn heaviside<T: Primitive>(x: T) -> T {
    T::select(
        T::broadcast(0.0).lt(x),
        T::broadcast(1.0),
        T::broadcast(0.0),
    )
}

#[inline(always)]
pub(crate) fn if_zero<T: Primitive>(x: T, then: T, otherwise: T) -> T {
    T::select(is_zero(x), then, otherwise)
}
