//! Running code on the widest lanes that the machine has.

use crate::Lanes;
use crate::portable::Four;
use std::sync::OnceLock;

/// A computation that is written once and run on whatever lanes there are.
///
/// `run` and all that it calls over `T` must be `#[inline(always)]`: what is not inlined is compiled
/// for the plain machine, where every operation on wide lanes becomes a call.
pub trait Kernel {
    /// What it gives.
    type Output;
    /// The computation.
    fn run<T: Lanes>(self) -> Self::Output;
}

/// Instructions that lanes are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Isa {
    /// Eight lanes, by AVX-512 (F and DQ); fused.
    Avx512,
    /// Four lanes, by AVX2 and FMA; fused.
    Avx2,
    /// Four lanes, by whatever the compiler makes of an array; not fused, and so the same on every machine.
    Portable,
    /// One lane: `f64` itself; not fused.
    Scalar,
}

impl Isa {
    /// All, the widest first.
    pub const ALL: [Isa; 4] = [Isa::Avx512, Isa::Avx2, Isa::Portable, Isa::Scalar];

    /// Whether this machine has it.
    #[inline]
    pub fn is_supported(self) -> bool {
        // Every kernel asks: the machine is asked once.
        static WIDE: OnceLock<(bool, bool)> = OnceLock::new();
        let (avx2, avx512) = *WIDE.get_or_init(wide);
        match self {
            Isa::Avx512 => avx512,
            Isa::Avx2 => avx2,
            Isa::Portable | Isa::Scalar => true,
        }
    }

    /// Whether [`Real::mul_add`](crate::Real::mul_add) and its like round once. All that do give the same bits, and all
    /// that do not.
    pub fn fuses(self) -> bool {
        matches!(self, Isa::Avx512 | Isa::Avx2)
    }

    /// The one that [`dispatch`] takes: that named by the environment variable `HYZER_LANES` (`avx512`,
    /// `avx2`, `portable`, `scalar`) where the machine has it, else the widest.
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

    /// Its name, as in `HYZER_LANES`.
    pub fn name(self) -> &'static str {
        match self {
            Isa::Avx512 => "avx512",
            Isa::Avx2 => "avx2",
            Isa::Portable => "portable",
            Isa::Scalar => "scalar",
        }
    }
}

/// Whether the machine has AVX2, and AVX-512.
#[cfg(target_arch = "x86_64")]
fn wide() -> (bool, bool) {
    let avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
    let avx512 = is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq");
    // Where wide vectors are, the narrower are too; `alone` counts on it.
    (avx2, avx2 && avx512)
}

#[cfg(not(target_arch = "x86_64"))]
fn wide() -> (bool, bool) {
    (false, false)
}

/// Runs a kernel on the widest lanes that this machine has.
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    run_on(Isa::best(), kernel)
}

/// Runs a kernel on lanes of one kind; none where the machine does not have them.
pub fn dispatch_with<K: Kernel>(isa: Isa, kernel: K) -> Option<K::Output> {
    isa.is_supported().then(|| run_on(isa, kernel))
}

/// Runs on `isa`, which is supported.
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
