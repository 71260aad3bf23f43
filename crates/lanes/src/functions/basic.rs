//! Roots, comparisons and the stated behaviour at singular points.

use crate::primitive::Primitive;
use std::hint::cold_path;

/// Magnitudes below this count as zero: its square is still a normal number.
const ZERO: f64 = 1e-75;

#[inline(always)]
fn is_zero<T: Primitive>(x: T) -> T::Mask {
    x.magnitude().below(T::all(ZERO))
}

#[inline(always)]
pub(crate) fn sqrt<T: Primitive>(x: T) -> T {
    if T::WIDTH == 1 {
        // A branch that is foreseen costs less than a selection, which waits.
        if T::everywhere(T::all(0.0).below(x)) {
            return x.root();
        }
        cold_path();
    }
    T::select(x.at_most(T::all(0.0)), T::all(0.0), x.root())
}

#[inline(always)]
pub(crate) fn recip_or_zero<T: Primitive>(x: T) -> T {
    if T::WIDTH == 1 {
        if T::everywhere(T::all(ZERO).at_most(x.magnitude())) {
            return T::all(1.0) / x;
        }
        cold_path();
    }
    T::select(is_zero(x), T::all(0.0), T::all(1.0) / x)
}

#[inline(always)]
pub(crate) fn min<T: Primitive>(a: T, b: T) -> T {
    T::select(a.below(b), a, b)
}

#[inline(always)]
pub(crate) fn max<T: Primitive>(a: T, b: T) -> T {
    T::select(b.below(a), a, b)
}

#[inline(always)]
pub(crate) fn sign<T: Primitive>(x: T) -> T {
    let zero = T::all(0.0);
    let negative = T::select(x.below(zero), T::all(-1.0), zero);
    T::select(zero.below(x), T::all(1.0), negative)
}

#[inline(always)]
pub(crate) fn step<T: Primitive>(x: T) -> T {
    T::select(T::all(0.0).below(x), T::all(1.0), T::all(0.0))
}

#[inline(always)]
pub(crate) fn if_zero<T: Primitive>(x: T, then: T, otherwise: T) -> T {
    T::select(is_zero(x), then, otherwise)
}
