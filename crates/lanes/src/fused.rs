//! Single-lane types: `f64`, and `f64` with fused multiply-add.

use crate::Lanes;
use crate::primitive::{LaneKernel, Primitive};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A single-lane [`Lanes`] type with the layout of `f64`: slices of `f64` are reinterpreted without copying.
pub trait ScalarLane: Lanes {
    /// Reinterprets a slice of `f64` as a slice of lanes, without copying.
    fn slice(of: &[f64]) -> &[Self];
    /// Reinterprets a mutable slice of `f64` as a mutable slice of lanes, without copying.
    fn slice_mut(of: &mut [f64]) -> &mut [Self];
}

impl ScalarLane for f64 {
    #[inline(always)]
    fn slice(of: &[f64]) -> &[f64] {
        of
    }
    #[inline(always)]
    fn slice_mut(of: &mut [f64]) -> &mut [f64] {
        of
    }
}

/// An `f64` whose multiply-add is fused. [`dispatch_scalar`](crate::dispatch_scalar) selects it only where
/// `f64::mul_add` compiles to one instruction; elsewhere that would be a slow library call.
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

    // Inlined: a function of its own would be compiled for the baseline processor.
    #[inline(always)]
    fn run_outlined<K: LaneKernel<Self>>(kernel: K) {
        kernel.run();
    }

    #[inline(always)]
    fn mul_add_op(self, b: Self, c: Self) -> Self {
        Fused(f64::mul_add(self.0, b.0, c.0))
    }
    #[inline(always)]
    fn mul_sub_op(self, b: Self, c: Self) -> Self {
        Fused(f64::mul_add(self.0, b.0, -c.0))
    }
    #[inline(always)]
    fn neg_mul_add_op(self, b: Self, c: Self) -> Self {
        Fused(f64::mul_add(-self.0, b.0, c.0))
    }

    #[inline(always)]
    fn broadcast(value: f64) -> Self {
        Fused(value)
    }
    #[inline(always)]
    fn ieee_sqrt(self) -> Self {
        Fused(self.0.ieee_sqrt())
    }
    #[inline(always)]
    fn lt(self, other: Self) -> u64 {
        self.0.lt(other.0)
    }
    #[inline(always)]
    fn le(self, other: Self) -> u64 {
        self.0.le(other.0)
    }
    #[inline(always)]
    fn sign_mask(self) -> u64 {
        self.0.sign_mask()
    }
    #[inline(always)]
    fn select(mask: u64, then: Self, otherwise: Self) -> Self {
        Fused(f64::select(mask, then.0, otherwise.0))
    }
    #[inline(always)]
    fn all_true(mask: u64) -> bool {
        mask != 0
    }
    #[inline(always)]
    fn and_bits(self, other: Self) -> Self {
        Fused(self.0.and_bits(other.0))
    }
    #[inline(always)]
    fn or_bits(self, other: Self) -> Self {
        Fused(self.0.or_bits(other.0))
    }
    #[inline(always)]
    fn xor_bits(self, other: Self) -> Self {
        Fused(self.0.xor_bits(other.0))
    }
    #[inline(always)]
    fn shl_bits<const N: u32>(self) -> Self {
        Fused(self.0.shl_bits::<N>())
    }
    #[inline(always)]
    fn shr_bits<const N: u32>(self) -> Self {
        Fused(self.0.shr_bits::<N>())
    }
    #[inline(always)]
    fn load_lanes(from: &[f64]) -> Self {
        Fused(from[0])
    }
    #[inline(always)]
    fn store_lanes(self, to: &mut [f64]) {
        to[0] = self.0;
    }
}
