//! AVX2 and AVX-512 lanes. All `unsafe` code of the crate is in this file.
//!
//! # Soundness
//!
//! *Intrinsics.* [`Eight`] and [`Four`] are private to the crate, and the only values of them are created inside
//! [`run_avx512`] and [`run_avx2`], which assert [`Isa::is_supported`] first. The existence of a value therefore proves
//! that the processor has the instructions that its methods use.
//!
//! *Target features.* Functions with `#[target_feature]` are called only after the corresponding detection; those of
//! `run_outlined` by code that names [`Eight`] or [`Four`], which only [`run_avx512`] and [`run_avx2`] give to kernels.
//!
//! *Memory.* Loads and stores go through arrays of checked length; the instructions allow unaligned addresses. The
//! reinterpretation of `&[f64]` as `&[Fused]` is valid since [`Fused`] is `repr(transparent)` over `f64`.
#![allow(unsafe_code)]

use crate::fused::{Fused, ScalarLane};
use crate::isa::Isa;
use crate::kernel::{Kernel, ScalarKernel};
use crate::primitive::{LaneKernel, Primitive};
use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::OnceLock;

#[derive(Clone, Copy)]
pub(crate) struct Eight(__m512d);

#[derive(Clone, Copy)]
pub(crate) struct Four(__m256d);

/// Runs a kernel in eight AVX-512 lanes.
///
/// # Panics
/// If the processor does not support AVX-512 F and DQ.
pub(crate) fn run_avx512<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx512f,avx512dq")]
    fn run<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Eight>()
    }
    assert!(Isa::Avx512.is_supported());
    // SAFETY: support asserted above.
    unsafe { run(kernel) }
}

/// Runs a kernel in four AVX2 lanes.
///
/// # Panics
/// If the processor does not support AVX2 and FMA.
pub(crate) fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx2,fma")]
    fn run<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Four>()
    }
    assert!(Isa::Avx2.is_supported());
    // SAFETY: support asserted above.
    unsafe { run(kernel) }
}

/// Instruction set for which a scalar kernel (computation on single numbers) is compiled.
#[derive(Clone, Copy)]
enum ScalarIsa {
    Avx512,
    Avx2,
    Plain,
}

impl ScalarIsa {
    #[inline(always)]
    fn best() -> ScalarIsa {
        static BEST: OnceLock<ScalarIsa> = OnceLock::new();
        *BEST.get_or_init(|| match Isa::best() {
            Isa::Avx512 if is_x86_feature_detected!("avx512vl") => ScalarIsa::Avx512,
            Isa::Avx512 | Isa::Avx2 => ScalarIsa::Avx2,
            _ => ScalarIsa::Plain,
        })
    }
}

/// Runs a scalar kernel, compiled for the widest instruction set that is not wider than [`Isa::best`].
#[inline(always)]
pub(crate) fn run_scalar<K: ScalarKernel>(kernel: K) {
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,fma")]
    fn avx512<K: ScalarKernel>(kernel: K) {
        kernel.run::<Fused>();
    }
    #[target_feature(enable = "avx2,fma")]
    fn avx2<K: ScalarKernel>(kernel: K) {
        kernel.run::<Fused>();
    }
    match ScalarIsa::best() {
        // SAFETY: support detected by `ScalarIsa::best`.
        ScalarIsa::Avx512 => unsafe { avx512(kernel) },
        // SAFETY: support detected by `ScalarIsa::best`.
        ScalarIsa::Avx2 => unsafe { avx2(kernel) },
        ScalarIsa::Plain => kernel.run::<f64>(),
    }
}

/// Calls a SIMD intrinsic of the processor. This is sound because a value of the lane type exists only if the processor
/// supports the intrinsic; see "Soundness" in the documentation of this module.
macro_rules! instruction {
    ($e:expr) => {{
        // SAFETY: see Soundness, Intrinsics.
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
                self.xor_bits(Self::broadcast(-0.0))
            }
        }
    };
}
operators!(Eight, Add add _mm512_add_pd, Sub sub _mm512_sub_pd, Mul mul _mm512_mul_pd, Div div _mm512_div_pd);
operators!(Four, Add add _mm256_add_pd, Sub sub _mm256_sub_pd, Mul mul _mm256_mul_pd, Div div _mm256_div_pd);

impl ScalarLane for Fused {
    #[inline(always)]
    fn slice(of: &[f64]) -> &[Fused] {
        // SAFETY: `Fused` is `repr(transparent)` over `f64`.
        unsafe { &*(of as *const [f64] as *const [Fused]) }
    }
    #[inline(always)]
    fn slice_mut(of: &mut [f64]) -> &mut [Fused] {
        // SAFETY: as above, and every bit pattern is valid for both types.
        unsafe { &mut *(of as *mut [f64] as *mut [Fused]) }
    }
}

/// Implements the methods `mul_add_op`, `mul_sub_op` and `neg_mul_add_op` of a lane type by the given intrinsics.
macro_rules! fused {
    ($type:ident, $plus:ident $minus:ident $from:ident) => {
        #[inline(always)]
        fn mul_add_op(self, b: Self, c: Self) -> Self {
            $type(instruction!($plus(self.0, b.0, c.0)))
        }
        #[inline(always)]
        fn mul_sub_op(self, b: Self, c: Self) -> Self {
            $type(instruction!($minus(self.0, b.0, c.0)))
        }
        #[inline(always)]
        fn neg_mul_add_op(self, b: Self, c: Self) -> Self {
            $type(instruction!($from(self.0, b.0, c.0)))
        }
    };
}

impl Primitive for Eight {
    type Mask = __mmask8;
    const WIDTH: usize = 8;

    #[inline(always)]
    fn run_outlined<K: LaneKernel<Self>>(kernel: K) {
        #[target_feature(enable = "avx512f,avx512dq")]
        #[inline(never)]
        fn run<K: LaneKernel<Eight>>(kernel: K) {
            kernel.run();
        }
        // SAFETY: see Soundness, Target features.
        unsafe { run(kernel) }
    }
    fused!(Eight, _mm512_fmadd_pd _mm512_fmsub_pd _mm512_fnmadd_pd);

    #[inline(always)]
    fn broadcast(value: f64) -> Self {
        Eight(instruction!(_mm512_set1_pd(value)))
    }
    #[inline(always)]
    fn ieee_sqrt(self) -> Self {
        Eight(instruction!(_mm512_sqrt_pd(self.0)))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> __mmask8 {
        instruction!(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn le(self, other: Self) -> __mmask8 {
        instruction!(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn sign_mask(self) -> __mmask8 {
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
    fn all_true(mask: __mmask8) -> bool {
        mask == 0xff
    }
    #[inline(always)]
    fn and_bits(self, other: Self) -> Self {
        Eight(instruction!(_mm512_and_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn or_bits(self, other: Self) -> Self {
        Eight(instruction!(_mm512_or_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn xor_bits(self, other: Self) -> Self {
        Eight(instruction!(_mm512_xor_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn shl_bits<const N: u32>(self) -> Self {
        Eight(instruction!(_mm512_castsi512_pd(_mm512_slli_epi64::<N>(
            _mm512_castpd_si512(self.0)
        ))))
    }
    #[inline(always)]
    fn shr_bits<const N: u32>(self) -> Self {
        Eight(instruction!(_mm512_castsi512_pd(_mm512_srli_epi64::<N>(
            _mm512_castpd_si512(self.0)
        ))))
    }
    #[inline(always)]
    fn load_lanes(from: &[f64]) -> Self {
        let from: &[f64; 8] = from.first_chunk().expect("at least eight numbers");
        // SAFETY: the array holds eight numbers; see Soundness for the intrinsic.
        Eight(unsafe { _mm512_loadu_pd(from.as_ptr()) })
    }
    #[inline(always)]
    fn store_lanes(self, to: &mut [f64]) {
        let to: &mut [f64; 8] = to.first_chunk_mut().expect("room for eight numbers");
        // SAFETY: the array holds eight elements; see Soundness for the intrinsic.
        unsafe { _mm512_storeu_pd(to.as_mut_ptr(), self.0) }
    }
}

impl Primitive for Four {
    // `blendv` selects by the sign bit of each lane.
    type Mask = __m256d;
    const WIDTH: usize = 4;

    #[inline(always)]
    fn run_outlined<K: LaneKernel<Self>>(kernel: K) {
        #[target_feature(enable = "avx2,fma")]
        #[inline(never)]
        fn run<K: LaneKernel<Four>>(kernel: K) {
            kernel.run();
        }
        // SAFETY: see Soundness, Target features.
        unsafe { run(kernel) }
    }
    fused!(Four, _mm256_fmadd_pd _mm256_fmsub_pd _mm256_fnmadd_pd);

    #[inline(always)]
    fn broadcast(value: f64) -> Self {
        Four(instruction!(_mm256_set1_pd(value)))
    }
    #[inline(always)]
    fn ieee_sqrt(self) -> Self {
        Four(instruction!(_mm256_sqrt_pd(self.0)))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> __m256d {
        instruction!(_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn le(self, other: Self) -> __m256d {
        instruction!(_mm256_cmp_pd::<_CMP_LE_OQ>(self.0, other.0))
    }
    #[inline(always)]
    fn sign_mask(self) -> __m256d {
        self.0
    }
    #[inline(always)]
    fn select(mask: __m256d, then: Self, otherwise: Self) -> Self {
        Four(instruction!(_mm256_blendv_pd(otherwise.0, then.0, mask)))
    }
    #[inline(always)]
    fn all_true(mask: __m256d) -> bool {
        instruction!(_mm256_movemask_pd(mask)) == 0b1111
    }
    #[inline(always)]
    fn and_bits(self, other: Self) -> Self {
        Four(instruction!(_mm256_and_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn or_bits(self, other: Self) -> Self {
        Four(instruction!(_mm256_or_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn xor_bits(self, other: Self) -> Self {
        Four(instruction!(_mm256_xor_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn shl_bits<const N: u32>(self) -> Self {
        let shift = instruction!(_mm_cvtsi64_si128(i64::from(N)));
        Four(instruction!(_mm256_castsi256_pd(_mm256_sll_epi64(
            _mm256_castpd_si256(self.0),
            shift
        ))))
    }
    #[inline(always)]
    fn shr_bits<const N: u32>(self) -> Self {
        let shift = instruction!(_mm_cvtsi64_si128(i64::from(N)));
        Four(instruction!(_mm256_castsi256_pd(_mm256_srl_epi64(
            _mm256_castpd_si256(self.0),
            shift
        ))))
    }
    #[inline(always)]
    fn load_lanes(from: &[f64]) -> Self {
        let from: &[f64; 4] = from.first_chunk().expect("at least four numbers");
        // SAFETY: the array holds four numbers; see Soundness for the intrinsic.
        Four(unsafe { _mm256_loadu_pd(from.as_ptr()) })
    }
    #[inline(always)]
    fn store_lanes(self, to: &mut [f64]) {
        let to: &mut [f64; 4] = to.first_chunk_mut().expect("room for four numbers");
        // SAFETY: the array holds four elements; see Soundness for the intrinsic.
        unsafe { _mm256_storeu_pd(to.as_mut_ptr(), self.0) }
    }
}
