//! Four lanes in an array, for processors without a vector type of their own in this crate.

use crate::primitive::{LaneKernel, Primitive};
use std::ops::{Add, Div, Mul, Neg, Sub};

#[derive(Clone, Copy)]
pub(crate) struct Four([f64; 4]);

impl Four {
    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        let [a, b, c, d] = self.0;
        Four([f(a), f(b), f(c), f(d)])
    }
    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let ([a, b, c, d], [i, j, k, l]) = (self.0, other.0);
        Four([f(a, i), f(b, j), f(c, k), f(d, l)])
    }
    #[inline(always)]
    fn compare(self, other: Self, f: impl Fn(f64, f64) -> u64) -> [u64; 4] {
        let ([a, b, c, d], [i, j, k, l]) = (self.0, other.0);
        [f(a, i), f(b, j), f(c, k), f(d, l)]
    }
}

macro_rules! operator {
    ($($trait:ident $method:ident)*) => {$(
        impl $trait for Four {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.with(other, f64::$method)
            }
        }
    )*};
}
operator!(Add add Sub sub Mul mul Div div);

impl Neg for Four {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(f64::neg)
    }
}

impl Primitive for Four {
    type Mask = [u64; 4];
    const WIDTH: usize = 4;

    #[inline(never)]
    fn run_outlined<K: LaneKernel<Self>>(kernel: K) {
        kernel.run();
    }

    #[inline(always)]
    fn broadcast(value: f64) -> Self {
        Four([value; 4])
    }
    #[inline(always)]
    fn ieee_sqrt(self) -> Self {
        self.each(Primitive::ieee_sqrt)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> [u64; 4] {
        self.compare(other, Primitive::lt)
    }
    #[inline(always)]
    fn le(self, other: Self) -> [u64; 4] {
        self.compare(other, Primitive::le)
    }
    #[inline(always)]
    fn sign_mask(self) -> [u64; 4] {
        self.0.map(Primitive::sign_mask)
    }
    #[inline(always)]
    fn select([a, b, c, d]: [u64; 4], then: Self, otherwise: Self) -> Self {
        let ([i, j, k, l], [m, n, o, p]) = (then.0, otherwise.0);
        Four([
            f64::select(a, i, m),
            f64::select(b, j, n),
            f64::select(c, k, o),
            f64::select(d, l, p),
        ])
    }
    #[inline(always)]
    fn all_true([a, b, c, d]: [u64; 4]) -> bool {
        a & b & c & d != 0
    }
    #[inline(always)]
    fn and_bits(self, other: Self) -> Self {
        self.with(other, Primitive::and_bits)
    }
    #[inline(always)]
    fn or_bits(self, other: Self) -> Self {
        self.with(other, Primitive::or_bits)
    }
    #[inline(always)]
    fn xor_bits(self, other: Self) -> Self {
        self.with(other, Primitive::xor_bits)
    }
    #[inline(always)]
    fn shl_bits<const N: u32>(self) -> Self {
        self.each(Primitive::shl_bits::<N>)
    }
    #[inline(always)]
    fn shr_bits<const N: u32>(self) -> Self {
        self.each(Primitive::shr_bits::<N>)
    }
    #[inline(always)]
    fn load_lanes(from: &[f64]) -> Self {
        Four([from[0], from[1], from[2], from[3]])
    }
    #[inline(always)]
    fn store_lanes(self, to: &mut [f64]) {
        to[..4].copy_from_slice(&self.0);
    }
}
