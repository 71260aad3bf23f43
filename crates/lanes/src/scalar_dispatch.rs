//! Target-feature dispatch for code on one number at a time.
//!
//! A baseline x86-64 build has 16 vector registers, two-operand instructions and no FMA. Functions compiled with
//! AVX2 or AVX-512 enabled have up to 32 registers, three-operand instructions and FMA.

use crate::ScalarLane;

/// A computation on one number at a time, for [`dispatch_scalar`].
///
/// `run` and its callees should be `#[inline(always)]`; otherwise they are compiled for the baseline processor.
pub trait ScalarKernel {
    /// Runs the computation. `T` is `f64` on machines without FMA.
    fn run<T: ScalarLane>(self);
}

/// Runs a computation compiled for the processor at hand, limited by [`Isa::best`](crate::Isa::best). The results are
/// bit-identical to those of [`dispatch`](crate::dispatch).
#[inline(always)]
pub fn dispatch_scalar<K: ScalarKernel>(kernel: K) {
    #[cfg(target_arch = "x86_64")]
    crate::x86::run_scalar(kernel);
    #[cfg(not(target_arch = "x86_64"))]
    kernel.run::<f64>();
}
