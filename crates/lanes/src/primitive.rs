//! Primitive operations over which every function is written, so that `f64` and all vector types share one source.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A computation on SIMD lanes of type `T` that [`Lanes::outlined`](crate::Lanes::outlined) runs in a function that is
/// not inlined.
///
/// `run` and all its callees over `T` must be `#[inline(always)]`, as in a [`Kernel`](crate::Kernel).
pub trait LaneKernel<T> {
    /// Runs the computation, in a function of its own by [`Lanes::outlined`](crate::Lanes::outlined).
    fn run(self);
}

pub(crate) const MAX_WIDTH: usize = 8;

/// Operations of about one machine instruction, on `f64` or on all lanes at once.
///
/// Bit operations act on the IEEE 754 representation; a mask holds one truth value per lane.
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

    fn broadcast(value: f64) -> Self;
    /// IEEE 754 square root: NaN for negative arguments.
    fn ieee_sqrt(self) -> Self;
    /// `self < other`; false where either is NaN.
    fn lt(self, other: Self) -> Self::Mask;
    /// `self <= other`; false where either is NaN.
    fn le(self, other: Self) -> Self::Mask;
    /// Mask that is true in the lanes whose sign bit is set.
    fn sign_mask(self) -> Self::Mask;
    fn select(mask: Self::Mask, then: Self, otherwise: Self) -> Self;
    fn all_true(mask: Self::Mask) -> bool;
    fn and_bits(self, other: Self) -> Self;
    fn or_bits(self, other: Self) -> Self;
    fn xor_bits(self, other: Self) -> Self;
    /// Logical left shift by `N` bits.
    fn shl_bits<const N: u32>(self) -> Self;
    /// Logical right shift by `N` bits.
    fn shr_bits<const N: u32>(self) -> Self;
    fn load_lanes(from: &[f64]) -> Self;
    fn store_lanes(self, to: &mut [f64]);

    /// Runs a computation in a separate function that is not inlined, compiled for the instruction set of this type.
    fn run_outlined<K: LaneKernel<Self>>(kernel: K);

    /// `self * b + c`, rounded once if the type fuses multiply-adds, else twice.
    #[inline(always)]
    fn mul_add_op(self, b: Self, c: Self) -> Self {
        self * b + c
    }
    /// `self * b - c`, rounded once if the type fuses multiply-adds, else twice.
    #[inline(always)]
    fn mul_sub_op(self, b: Self, c: Self) -> Self {
        self * b - c
    }
    /// `c - self * b`, rounded once if the type fuses multiply-adds, else twice.
    #[inline(always)]
    fn neg_mul_add_op(self, b: Self, c: Self) -> Self {
        c - self * b
    }

    /// The `f64` with the given IEEE 754 bits, in every lane.
    #[inline(always)]
    fn bit_pattern(bits: u64) -> Self {
        Self::broadcast(f64::from_bits(bits))
    }

    /// Sign bit of each lane, all other bits 0.
    #[inline(always)]
    fn sign_bit(self) -> Self {
        self.and_bits(Self::bit_pattern(1 << 63))
    }

    #[inline(always)]
    fn magnitude(self) -> Self {
        self.and_bits(Self::bit_pattern(!(1 << 63)))
    }
}

/// Returns `f(a, b, result)`, computed lane by lane.
#[cold]
#[inline(never)]
pub(crate) fn map_lanes<T: Primitive>(a: T, b: T, result: T, f: fn(f64, f64, f64) -> f64) -> T {
    let (mut a_lanes, mut b_lanes, mut lanes) =
        ([0.0; MAX_WIDTH], [0.0; MAX_WIDTH], [0.0; MAX_WIDTH]);
    a.store_lanes(&mut a_lanes);
    b.store_lanes(&mut b_lanes);
    result.store_lanes(&mut lanes);
    for i in 0..T::WIDTH {
        lanes[i] = f(a_lanes[i], b_lanes[i], lanes[i]);
    }
    T::load_lanes(&lanes)
}
