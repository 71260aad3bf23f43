//! Lanes of x86's wide vectors. All the `unsafe` of this crate is here.
//!
//! **Why it is sound.** Every `unsafe` block below, but for two that look at a slice of numbers as one of numbers with
//! another name, is a call of a vector instruction that the machine may lack.
//! The two types are private to the crate and no function hands them out: code outside can name them
//! only as the `T` of [`Kernel::run`], and that is called with them only by [`run_avx512`] and [`run_avx2`],
//! which first ask the machine ([`Isa::is_supported`], asked again in each). So wherever a value of
//! either type exists, its instructions do. Memory is read and written through slices whose length is
//! checked first; unaligned addresses are fine for the instructions used.
#![allow(unsafe_code)]

use crate::dispatch::{Isa, Kernel};
use crate::primitive::{Primitive, real_by_primitives};
use crate::single::{Fused, Single};
use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::OnceLock;

/// Eight lanes.
#[derive(Clone, Copy)]
pub(crate) struct Eight(__m512d);

/// Four lanes.
#[derive(Clone, Copy)]
pub(crate) struct Four(__m256d);

/// Runs a kernel on eight lanes.
pub(crate) fn run_avx512<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx512f,avx512dq")]
    fn run<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Eight>()
    }
    assert!(Isa::Avx512.is_supported());
    // SAFETY: the machine has just been asked.
    unsafe { run(kernel) }
}

/// Runs a kernel on four lanes.
pub(crate) fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx2,fma")]
    fn run<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Four>()
    }
    assert!(Isa::Avx2.is_supported());
    // SAFETY: the machine has just been asked.
    unsafe { run(kernel) }
}

/// What a number alone is compiled for.
#[derive(Clone, Copy)]
enum Alone {
    Avx512,
    Avx2,
    Plain,
}

impl Alone {
    #[inline(always)]
    fn best() -> Alone {
        static BEST: OnceLock<Alone> = OnceLock::new();
        *BEST.get_or_init(|| match Isa::best() {
            Isa::Avx512 if is_x86_feature_detected!("avx512vl") => Alone::Avx512,
            Isa::Avx512 | Isa::Avx2 => Alone::Avx2,
            _ => Alone::Plain,
        })
    }
}

/// Runs a computation on one number at a time with what this machine has.
#[inline(always)]
pub(crate) fn run_alone<A: crate::Alone>(computation: A) {
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,fma")]
    fn avx512<A: crate::Alone>(computation: A) {
        computation.run::<Fused>();
    }
    #[target_feature(enable = "avx2,fma")]
    fn avx2<A: crate::Alone>(computation: A) {
        computation.run::<Fused>();
    }
    match Alone::best() {
        // SAFETY: the machine was asked.
        Alone::Avx512 => unsafe { avx512(computation) },
        // SAFETY: the machine was asked.
        Alone::Avx2 => unsafe { avx2(computation) },
        Alone::Plain => computation.run::<f64>(),
    }
}

/// A call of an instruction, which is there since a value of the type is (see the head of this file).
macro_rules! instruction {
    ($e:expr) => {{
        // SAFETY: as the head of this file says.
        unsafe { $e }
    }};
}

macro_rules! operators {
    ($type:ident, $($trait:ident $method:ident $instruction:ident),*) => {
        $(impl $trait for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                $type(instruction!($instruction(self.0, other.0)))
            }
        })*

        impl Neg for $type {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                self.bits_xor(Self::all(-0.0))
            }
        }
    };
}
operators!(Eight, Add add _mm512_add_pd, Sub sub _mm512_sub_pd, Mul mul _mm512_mul_pd, Div div _mm512_div_pd);
operators!(Four, Add add _mm256_add_pd, Sub sub _mm256_sub_pd, Mul mul _mm256_mul_pd, Div div _mm256_div_pd);

impl Single for Fused {
    #[inline(always)]
    fn slice(of: &[f64]) -> &[Fused] {
        // SAFETY: a `Fused` is an `f64` and nothing else (`repr(transparent)`).
        unsafe { &*(of as *const [f64] as *const [Fused]) }
    }
    #[inline(always)]
    fn slice_mut(of: &mut [f64]) -> &mut [Fused] {
        // SAFETY: as above, and every `Fused` is a good `f64`.
        unsafe { &mut *(of as *mut [f64] as *mut [Fused]) }
    }
}

/// The three fused operations, by instructions of that name.
macro_rules! fused {
    ($type:ident, $plus:ident $minus:ident $from:ident) => {
        #[inline(always)]
        fn times_plus(self, b: Self, c: Self) -> Self {
            $type(instruction!($plus(self.0, b.0, c.0)))
        }
        #[inline(always)]
        fn times_minus(self, b: Self, c: Self) -> Self {
            $type(instruction!($minus(self.0, b.0, c.0)))
        }
        #[inline(always)]
        fn times_from(self, b: Self, c: Self) -> Self {
            $type(instruction!($from(self.0, b.0, c.0)))
        }
    };
}

impl Primitive for Eight {
    type Mask = __mmask8;
    const WIDTH: usize = 8;
    fused!(Eight, _mm512_fmadd_pd _mm512_fmsub_pd _mm512_fnmadd_pd);

    #[inline(always)]
    fn all(value: f64) -> Self {
        Eight(instruction!(_mm512_set1_pd(value)))
    }
    #[inline(always)]
    fn root(self) -> Self {
        Eight(instruction!(_mm512_sqrt_pd(self.0)))
    }
    #[inline(always)]
    fn below(self, other: Self) -> __mmask8 {
        instruction!(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn at_most(self, other: Self) -> __mmask8 {
        instruction!(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn top_bit(self) -> __mmask8 {
        instruction!(_mm512_movepi64_mask(_mm512_castpd_si512(self.0)))
    }
    #[inline(always)]
    fn select(mask: __mmask8, then: Self, otherwise: Self) -> Self {
        Eight(instruction!(_mm512_mask_blend_pd(
            mask,
            otherwise.0,
            then.0
        )))
    }
    #[inline(always)]
    fn everywhere(mask: __mmask8) -> bool {
        mask == 0xff
    }
    #[inline(always)]
    fn bits_and(self, other: Self) -> Self {
        Eight(instruction!(_mm512_and_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn bits_or(self, other: Self) -> Self {
        Eight(instruction!(_mm512_or_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn bits_xor(self, other: Self) -> Self {
        Eight(instruction!(_mm512_xor_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn bits_up<const N: u32>(self) -> Self {
        Eight(instruction!(_mm512_castsi512_pd(_mm512_slli_epi64::<N>(
            _mm512_castpd_si512(self.0)
        ))))
    }
    #[inline(always)]
    fn bits_down<const N: u32>(self) -> Self {
        Eight(instruction!(_mm512_castsi512_pd(_mm512_srli_epi64::<N>(
            _mm512_castpd_si512(self.0)
        ))))
    }
    #[inline(always)]
    fn read(from: &[f64]) -> Self {
        let from: &[f64; 8] = from.first_chunk().expect("at least eight numbers");
        // SAFETY: eight numbers are there, and the instruction as the head of this file says.
        Eight(unsafe { _mm512_loadu_pd(from.as_ptr()) })
    }
    #[inline(always)]
    fn write(self, to: &mut [f64]) {
        let to: &mut [f64; 8] = to.first_chunk_mut().expect("room for eight numbers");
        // SAFETY: eight places are there, and the instruction as the head of this file says.
        unsafe { _mm512_storeu_pd(to.as_mut_ptr(), self.0) }
    }
}

impl Primitive for Four {
    // Each lane's top bit is what selections look at.
    type Mask = __m256d;
    const WIDTH: usize = 4;
    fused!(Four, _mm256_fmadd_pd _mm256_fmsub_pd _mm256_fnmadd_pd);

    #[inline(always)]
    fn all(value: f64) -> Self {
        Four(instruction!(_mm256_set1_pd(value)))
    }
    #[inline(always)]
    fn root(self) -> Self {
        Four(instruction!(_mm256_sqrt_pd(self.0)))
    }
    #[inline(always)]
    fn below(self, other: Self) -> __m256d {
        instruction!(_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn at_most(self, other: Self) -> __m256d {
        instruction!(_mm256_cmp_pd::<_CMP_LE_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn top_bit(self) -> __m256d {
        self.0
    }
    #[inline(always)]
    fn select(mask: __m256d, then: Self, otherwise: Self) -> Self {
        Four(instruction!(_mm256_blendv_pd(otherwise.0, then.0, mask)))
    }
    #[inline(always)]
    fn everywhere(mask: __m256d) -> bool {
        instruction!(_mm256_movemask_pd(mask)) == 0b1111
    }
    #[inline(always)]
    fn bits_and(self, other: Self) -> Self {
        Four(instruction!(_mm256_and_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn bits_or(self, other: Self) -> Self {
        Four(instruction!(_mm256_or_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn bits_xor(self, other: Self) -> Self {
        Four(instruction!(_mm256_xor_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn bits_up<const N: u32>(self) -> Self {
        let shift = instruction!(_mm_cvtsi64_si128(i64::from(N)));
        Four(instruction!(_mm256_castsi256_pd(_mm256_sll_epi64(
            _mm256_castpd_si256(self.0),
            shift
        ))))
    }
    #[inline(always)]
    fn bits_down<const N: u32>(self) -> Self {
        let shift = instruction!(_mm_cvtsi64_si128(i64::from(N)));
        Four(instruction!(_mm256_castsi256_pd(_mm256_srl_epi64(
            _mm256_castpd_si256(self.0),
            shift
        ))))
    }
    #[inline(always)]
    fn read(from: &[f64]) -> Self {
        let from: &[f64; 4] = from.first_chunk().expect("at least four numbers");
        // SAFETY: four numbers are there, and the instruction as the head of this file says.
        Four(unsafe { _mm256_loadu_pd(from.as_ptr()) })
    }
    #[inline(always)]
    fn write(self, to: &mut [f64]) {
        let to: &mut [f64; 4] = to.first_chunk_mut().expect("room for four numbers");
        // SAFETY: four places are there, and the instruction as the head of this file says.
        unsafe { _mm256_storeu_pd(to.as_mut_ptr(), self.0) }
    }
}

real_by_primitives!(Eight, Four);
