//! Instruction sets, and detection of the instruction sets that the processor supports.

use std::sync::OnceLock;

/// SIMD instruction set with which a lane type computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Isa {
    /// Eight lanes with the instruction sets AVX-512 F and DQ; multiply-adds are fused (rounded once).
    Avx512,
    /// Four lanes with the instruction sets AVX2 and FMA; multiply-adds are fused (rounded once).
    Avx2,
    /// Four lanes in an array, vectorized by the compiler; multiply-adds are not fused, for equal bits everywhere.
    Portable,
    /// One lane, an `f64`; multiply-adds are not fused.
    Scalar,
}

impl Isa {
    /// All instruction sets, widest first.
    pub const ALL: [Isa; 4] = [Isa::Avx512, Isa::Avx2, Isa::Portable, Isa::Scalar];

    /// Whether the processor supports this instruction set.
    #[inline]
    pub fn is_supported(self) -> bool {
        // Queried by every kernel, hence cached.
        static WIDE: OnceLock<(bool, bool)> = OnceLock::new();
        let (avx2, avx512) = *WIDE.get_or_init(wide);
        match self {
            Isa::Avx512 => avx512,
            Isa::Avx2 => avx2,
            Isa::Portable | Isa::Scalar => true,
        }
    }

    /// Whether [`Real::mul_add`](crate::Real::mul_add) rounds once. Results are bit-identical among all instruction
    /// sets that fuse, and among all instruction sets that do not.
    pub fn fuses(self) -> bool {
        matches!(self, Isa::Avx512 | Isa::Avx2)
    }

    /// Returns the instruction set used by [`dispatch`](crate::dispatch): the one named by the environment variable
    /// `HYZER_LANES` (`avx512`, `avx2`, `portable`, `scalar`) if it is supported, else the widest supported one. The
    /// result is cached at first use.
    #[inline]
    pub fn best() -> Isa {
        static BEST: OnceLock<Isa> = OnceLock::new();
        *BEST.get_or_init(|| {
            let wanted = std::env::var("HYZER_LANES").ok();
            let named = Isa::ALL
                .into_iter()
                .find(|isa| wanted.as_deref() == Some(isa.name()));
            named
                .into_iter()
                .chain(Isa::ALL)
                .find(|isa| isa.is_supported())
                .unwrap_or(Isa::Portable)
        })
    }

    /// Number of lanes of the vectors with which [`dispatch`](crate::dispatch) runs a kernel.
    pub fn width(self) -> usize {
        match self {
            Isa::Avx512 => 8,
            Isa::Avx2 | Isa::Portable => 4,
            Isa::Scalar => 1,
        }
    }

    /// Lower-case name of the instruction set, as in the environment variable `HYZER_LANES`.
    pub fn name(self) -> &'static str {
        match self {
            Isa::Avx512 => "avx512",
            Isa::Avx2 => "avx2",
            Isa::Portable => "portable",
            Isa::Scalar => "scalar",
        }
    }
}

/// Returns whether the processor supports AVX2 with FMA, and whether it supports AVX-512 F and DQ.
#[cfg(target_arch = "x86_64")]
fn wide() -> (bool, bool) {
    let avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
    let avx512 = is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq");
    // AVX-512 implies AVX2 here; `dispatch_scalar` relies on it.
    (avx2, avx2 && avx512)
}

#[cfg(not(target_arch = "x86_64"))]
fn wide() -> (bool, bool) {
    (false, false)
}
