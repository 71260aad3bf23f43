//! `f64` itself: one lane, which fuses nothing.

use crate::primitive::{Primitive, real_by_primitives};

impl Primitive for f64 {
    // All ones or all zeros, not a bool: selections stay free of branches, whose outcome nobody can predict.
    type Mask = u64;
    const WIDTH: usize = 1;

    #[inline(always)]
    fn all(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn root(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn below(self, other: Self) -> u64 {
        u64::from(self < other).wrapping_neg()
    }
    #[inline(always)]
    fn at_most(self, other: Self) -> u64 {
        u64::from(self <= other).wrapping_neg()
    }
    #[inline(always)]
    fn top_bit(self) -> u64 {
        ((self.to_bits() as i64) >> 63) as u64
    }
    #[inline(always)]
    fn select(mask: u64, then: Self, otherwise: Self) -> Self {
        f64::from_bits((then.to_bits() & mask) | (otherwise.to_bits() & !mask))
    }
    #[inline(always)]
    fn everywhere(mask: u64) -> bool {
        mask != 0
    }
    #[inline(always)]
    fn bits_and(self, other: Self) -> Self {
        f64::from_bits(self.to_bits() & other.to_bits())
    }
    #[inline(always)]
    fn bits_or(self, other: Self) -> Self {
        f64::from_bits(self.to_bits() | other.to_bits())
    }
    #[inline(always)]
    fn bits_xor(self, other: Self) -> Self {
        f64::from_bits(self.to_bits() ^ other.to_bits())
    }
    #[inline(always)]
    fn bits_up<const N: u32>(self) -> Self {
        f64::from_bits(self.to_bits() << N)
    }
    #[inline(always)]
    fn bits_down<const N: u32>(self) -> Self {
        f64::from_bits(self.to_bits() >> N)
    }
    #[inline(always)]
    fn read(from: &[f64]) -> Self {
        from[0]
    }
    #[inline(always)]
    fn write(self, to: &mut [f64]) {
        to[0] = self;
    }
}

real_by_primitives!(f64);
