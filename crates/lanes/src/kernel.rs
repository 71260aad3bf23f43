//! Computations that are generic over the number type.

use crate::fused::ScalarLane;
use crate::real::Lanes;

/// A computation that is generic over the lane type (type with one number per SIMD lane).
///
/// `run` and all its callees over `T` must be `#[inline(always)]`: functions that are not inlined are compiled for
/// the baseline processor, where every operation on wide lanes becomes a call.
pub trait Kernel {
    /// Result of the computation.
    type Output;
    /// Runs the computation on SIMD lanes of type `T`.
    fn run<T: Lanes>(self) -> Self::Output;
}

/// A computation on single numbers (one lane). [`dispatch_scalar`](crate::dispatch_scalar) runs it, compiled for the
/// widest supported instruction set that is not wider than [`Isa::best`](crate::Isa::best).
///
/// `run` and its callees should be `#[inline(always)]`; otherwise they are compiled for the baseline processor.
pub trait ScalarKernel {
    /// Runs the computation on a type with fused multiply-add if the processor supports it, else on `f64`.
    fn run<T: ScalarLane>(self);
}
