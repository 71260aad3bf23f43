//! Target-feature dispatch: runs a kernel compiled for the instruction set of the processor.
//!
//! A baseline x86-64 build has 16 vector registers, two-operand instructions and no FMA. Functions compiled with AVX2
//! or AVX-512 enabled have up to 32 registers, three-operand instructions and FMA, which also make scalar code faster.

use crate::isa::Isa;
use crate::kernel::{Kernel, ScalarKernel};
use crate::portable::Four;

/// Runs a kernel in SIMD lanes of the instruction set [`Isa::best`], by default the widest that the processor supports.
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    run_on(Isa::best(), kernel)
}

/// Runs a kernel in SIMD lanes of the instruction set `isa`. Returns `None` if the processor does not support `isa`.
pub fn dispatch_with<K: Kernel>(isa: Isa, kernel: K) -> Option<K::Output> {
    isa.is_supported().then(|| run_on(isa, kernel))
}

/// Runs a kernel in SIMD lanes of the instruction set `isa`. Returns `None` if the processor does not support `isa`, or
/// if `isa` is not one of the widest instruction sets of the architecture: AVX-512 and AVX2 on x86-64, portable lanes
/// elsewhere. Intended for large kernels, which would take long to compile for every instruction set.
pub fn dispatch_widest<K: Kernel>(isa: Isa, kernel: K) -> Option<K::Output> {
    if !isa.is_supported() {
        return None;
    }
    match isa {
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => Some(crate::x86::run_avx512(kernel)),
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => Some(crate::x86::run_avx2(kernel)),
        #[cfg(not(target_arch = "x86_64"))]
        Isa::Portable => Some(kernel.run::<Four>()),
        _ => None,
    }
}

fn run_on<K: Kernel>(isa: Isa, kernel: K) -> K::Output {
    match isa {
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => crate::x86::run_avx512(kernel),
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => crate::x86::run_avx2(kernel),
        Isa::Scalar => kernel.run::<f64>(),
        _ => kernel.run::<Four>(),
    }
}

/// Runs a scalar kernel, compiled for the widest supported instruction set that is not wider than
/// [`Isa::best`](crate::Isa::best). Results are bit-identical to those of [`dispatch`](crate::dispatch).
#[inline(always)]
pub fn dispatch_scalar<K: ScalarKernel>(kernel: K) {
    #[cfg(target_arch = "x86_64")]
    crate::x86::run_scalar(kernel);
    #[cfg(not(target_arch = "x86_64"))]
    kernel.run::<f64>();
}
