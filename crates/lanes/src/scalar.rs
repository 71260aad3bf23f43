//! `f64` as a single, non-fusing lane.

use crate::primitive::{LaneKernel, Primitive};

impl Primitive for f64 {
    // All ones or all zeros instead of `bool`, so that `select` compiles without unpredictable branches.
    type Mask = u64;
    const WIDTH: usize = 1;

    #[inline(never)]
    fn run_outlined<K: LaneKernel<Self>>(kernel: K) {
        kernel.run();
    }

    #[inline(always)]
    fn broadcast(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn ieee_sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> u64 {
        u64::from(self < other).wrapping_neg()
    }
    #[inline(always)]
    fn le(self, other: Self) -> u64 {
        u64::from(self <= other).wrapping_neg()
    }
    #[inline(always)]
    fn sign_mask(self) -> u64 {
        ((self.to_bits() as i64) >> 63) as u64
    }
    #[inline(always)]
    fn select(mask: u64, then: Self, otherwise: Self) -> Self {
        f64::from_bits((then.to_bits() & mask) | (otherwise.to_bits() & !mask))
    }
    #[inline(always)]
    fn all_true(mask: u64) -> bool {
        mask != 0
    }
    #[inline(always)]
    fn and_bits(self, other: Self) -> Self {
        f64::from_bits(self.to_bits() & other.to_bits())
    }
    #[inline(always)]
    fn or_bits(self, other: Self) -> Self {
        f64::from_bits(self.to_bits() | other.to_bits())
    }
    #[inline(always)]
    fn xor_bits(self, other: Self) -> Self {
        f64::from_bits(self.to_bits() ^ other.to_bits())
    }
    #[inline(always)]
    fn shl_bits<const N: u32>(self) -> Self {
        f64::from_bits(self.to_bits() << N)
    }
    #[inline(always)]
    fn shr_bits<const N: u32>(self) -> Self {
        f64::from_bits(self.to_bits() >> N)
    }
    #[inline(always)]
    fn load_lanes(from: &[f64]) -> Self {
        from[0]
    }
    #[inline(always)]
    fn store_lanes(self, to: &mut [f64]) {
        to[0] = self;
    }
}
