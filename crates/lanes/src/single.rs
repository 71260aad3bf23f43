//! One lane that fuses, and the numbers of a slice as lanes of their own.

use crate::Lanes;
use crate::primitive::{Primitive, real_by_primitives};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// [`Lanes`] of one: `f64`, or the same number with operations that fuse. A slice of `f64` is a slice of these.
pub trait Single: Lanes {
    /// The numbers of a slice.
    fn slice(of: &[f64]) -> &[Self];
    /// The places of a slice.
    fn slice_mut(of: &mut [f64]) -> &mut [Self];
}

impl Single for f64 {
    #[inline(always)]
    fn slice(of: &[f64]) -> &[f64] {
        of
    }
    #[inline(always)]
    fn slice_mut(of: &mut [f64]) -> &mut [f64] {
        of
    }
}

/// A number that fuses. `f64::mul_add` is one instruction where it is compiled for a machine that has it, which is
/// where [`alone`](crate::alone) takes it; elsewhere it would be a call, slow but right.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub(crate) struct Fused(pub(crate) f64);

macro_rules! operators {
    ($($trait:ident $method:ident)*) => {$(
        impl $trait for Fused {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Fused(self.0.$method(other.0))
            }
        }
    )*};
}
operators!(Add add Sub sub Mul mul Div div);

impl Neg for Fused {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Fused(-self.0)
    }
}

impl Primitive for Fused {
    type Mask = u64;
    const WIDTH: usize = 1;

    #[inline(always)]
    fn times_plus(self, b: Self, c: Self) -> Self {
        Fused(f64::mul_add(self.0, b.0, c.0))
    }
    #[inline(always)]
    fn times_minus(self, b: Self, c: Self) -> Self {
        Fused(f64::mul_add(self.0, b.0, -c.0))
    }
    #[inline(always)]
    fn times_from(self, b: Self, c: Self) -> Self {
        Fused(f64::mul_add(-self.0, b.0, c.0))
    }

    #[inline(always)]
    fn all(value: f64) -> Self {
        Fused(value)
    }
    #[inline(always)]
    fn root(self) -> Self {
        Fused(self.0.root())
    }
    #[inline(always)]
    fn below(self, other: Self) -> u64 {
        self.0.below(other.0)
    }
    #[inline(always)]
    fn at_most(self, other: Self) -> u64 {
        self.0.at_most(other.0)
    }
    #[inline(always)]
    fn top_bit(self) -> u64 {
        self.0.top_bit()
    }
    #[inline(always)]
    fn select(mask: u64, then: Self, otherwise: Self) -> Self {
        Fused(f64::select(mask, then.0, otherwise.0))
    }
    #[inline(always)]
    fn everywhere(mask: u64) -> bool {
        mask != 0
    }
    #[inline(always)]
    fn bits_and(self, other: Self) -> Self {
        Fused(self.0.bits_and(other.0))
    }
    #[inline(always)]
    fn bits_or(self, other: Self) -> Self {
        Fused(self.0.bits_or(other.0))
    }
    #[inline(always)]
    fn bits_xor(self, other: Self) -> Self {
        Fused(self.0.bits_xor(other.0))
    }
    #[inline(always)]
    fn bits_up<const N: u32>(self) -> Self {
        Fused(self.0.bits_up::<N>())
    }
    #[inline(always)]
    fn bits_down<const N: u32>(self) -> Self {
        Fused(self.0.bits_down::<N>())
    }
    #[inline(always)]
    fn read(from: &[f64]) -> Self {
        Fused(from[0])
    }
    #[inline(always)]
    fn write(self, to: &mut [f64]) {
        to[0] = self.0;
    }
}

real_by_primitives!(Fused);
