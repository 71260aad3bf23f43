//! The few operations from which every function is made, so that `f64` and all lanes share one text.

use crate::Lanes;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Most lanes that any type has.
pub(crate) const WIDEST: usize = 8;

/// What a machine does in one instruction, on `f64` or on all lanes at once.
///
/// Bits are those of the IEEE representation; a mask holds true or false for each lane.
pub(crate) trait Primitive:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    type Mask: Copy;
    const WIDTH: usize;

    fn all(value: f64) -> Self;
    /// Square root by IEEE: NaN below 0.
    fn root(self) -> Self;
    /// `self < other`; false where either is NaN.
    fn below(self, other: Self) -> Self::Mask;
    /// `self <= other`; false where either is NaN.
    fn at_most(self, other: Self) -> Self::Mask;
    /// True where the top bit is set.
    fn top_bit(self) -> Self::Mask;
    fn select(mask: Self::Mask, then: Self, otherwise: Self) -> Self;
    /// Whether the mask is true in every lane.
    fn everywhere(mask: Self::Mask) -> bool;
    fn bits_and(self, other: Self) -> Self;
    fn bits_or(self, other: Self) -> Self;
    fn bits_xor(self, other: Self) -> Self;
    /// Bits moved up by `N`.
    fn bits_up<const N: u32>(self) -> Self;
    /// Bits moved down by `N`, zeros coming in at the top.
    fn bits_down<const N: u32>(self) -> Self;
    fn read(from: &[f64]) -> Self;
    fn write(self, to: &mut [f64]);

    /// `self * b + c`; with one rounding where the type fuses, and then so do the next two.
    #[inline(always)]
    fn times_plus(self, b: Self, c: Self) -> Self {
        self * b + c
    }
    /// `self * b - c`.
    #[inline(always)]
    fn times_minus(self, b: Self, c: Self) -> Self {
        self * b - c
    }
    /// `c - self * b`.
    #[inline(always)]
    fn times_from(self, b: Self, c: Self) -> Self {
        c - self * b
    }

    /// Bits given as an integer, in every lane.
    #[inline(always)]
    fn bits(bits: u64) -> Self {
        Self::all(f64::from_bits(bits))
    }

    /// The top bit alone: the sign.
    #[inline(always)]
    fn sign_bit(self) -> Self {
        self.bits_and(Self::bits(1 << 63))
    }

    /// All but the top bit.
    #[inline(always)]
    fn magnitude(self) -> Self {
        self.bits_and(Self::bits(!(1 << 63)))
    }
}

/// `f` in every lane, one after the other: the way out where polynomials do not reach.
#[cold]
#[inline(never)]
pub(crate) fn one_by_one<T: Primitive>(a: T, b: T, result: T, f: fn(f64, f64, f64) -> f64) -> T {
    let (mut a_lanes, mut b_lanes, mut lanes) = ([0.0; WIDEST], [0.0; WIDEST], [0.0; WIDEST]);
    a.write(&mut a_lanes);
    b.write(&mut b_lanes);
    result.write(&mut lanes);
    for i in 0..T::WIDTH {
        lanes[i] = f(a_lanes[i], b_lanes[i], lanes[i]);
    }
    T::read(&lanes)
}

/// Implements [`crate::Real`] and [`Lanes`] for a type by the shared text.
macro_rules! real_by_primitives {
    ($($type:ty),*) => {$(
        impl $crate::Real for $type {
            #[inline(always)]
            fn splat(value: f64) -> Self { <Self as $crate::primitive::Primitive>::all(value) }
            #[inline(always)]
            fn mul_add(self, b: Self, c: Self) -> Self { $crate::primitive::Primitive::times_plus(self, b, c) }
            #[inline(always)]
            fn mul_sub(self, b: Self, c: Self) -> Self { $crate::primitive::Primitive::times_minus(self, b, c) }
            #[inline(always)]
            fn mul_from(self, b: Self, c: Self) -> Self { $crate::primitive::Primitive::times_from(self, b, c) }
            #[inline(always)]
            fn sqrt(self) -> Self { $crate::functions::basic::sqrt(self) }
            #[inline(always)]
            fn recip_or_zero(self) -> Self { $crate::functions::basic::recip_or_zero(self) }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) { $crate::functions::circular::sin_cos(self) }
            #[inline(always)]
            fn atan2(self, x: Self) -> Self { $crate::functions::inverse::atan2(self, x) }
            #[inline(always)]
            fn exp(self) -> Self { $crate::functions::exponential::exp(self) }
            #[inline(always)]
            fn log(self) -> Self { $crate::functions::exponential::log(self) }
            #[inline(always)]
            fn tanh(self) -> Self { $crate::functions::exponential::tanh(self) }
            #[inline(always)]
            fn asin(self) -> Self { $crate::functions::inverse::asin(self) }
            #[inline(always)]
            fn abs(self) -> Self { $crate::primitive::Primitive::magnitude(self) }
            #[inline(always)]
            fn min(self, other: Self) -> Self { $crate::functions::basic::min(self, other) }
            #[inline(always)]
            fn max(self, other: Self) -> Self { $crate::functions::basic::max(self, other) }
            #[inline(always)]
            fn sign(self) -> Self { $crate::functions::basic::sign(self) }
            #[inline(always)]
            fn step(self) -> Self { $crate::functions::basic::step(self) }
            #[inline(always)]
            fn if_zero(self, then: Self, otherwise: Self) -> Self {
                $crate::functions::basic::if_zero(self, then, otherwise)
            }
        }

        impl $crate::Lanes for $type {
            const WIDTH: usize = <Self as $crate::primitive::Primitive>::WIDTH;
            #[inline(always)]
            fn load(from: &[f64]) -> Self { $crate::primitive::Primitive::read(from) }
            #[inline(always)]
            fn store(self, to: &mut [f64]) { $crate::primitive::Primitive::write(self, to); }
            #[inline(always)]
            fn from_fn(value: impl FnMut(usize) -> f64) -> Self { $crate::primitive::from_fn(value) }
            #[inline(always)]
            fn lane(self, lane: usize) -> f64 { $crate::primitive::lane(self, lane) }
        }
    )*};
}
pub(crate) use real_by_primitives;

#[inline(always)]
pub(crate) fn from_fn<T: Lanes>(mut value: impl FnMut(usize) -> f64) -> T {
    let mut lanes = [0.0; WIDEST];
    for (i, lane) in lanes.iter_mut().take(T::WIDTH).enumerate() {
        *lane = value(i);
    }
    T::load(&lanes)
}

#[inline(always)]
pub(crate) fn lane<T: Lanes>(of: T, lane: usize) -> f64 {
    let mut lanes = [0.0; WIDEST];
    of.store(&mut lanes);
    lanes[..T::WIDTH][lane]
}
