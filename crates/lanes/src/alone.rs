//! Code on `f64`, compiled for the machine that it runs on.
//!
//! A plain build has 16 registers, and overwrites one with every operation. Machines with wide vectors have up to 32, and
//! operations that leave their arguments alone. The operations are the same, each with its rounding, and so are the bits.

/// A computation on `f64`, for [`alone`].
///
/// `run`, and what it calls, gains by it where it is `#[inline(always)]`.
pub trait Alone {
    /// The computation.
    fn run(self);
}

/// Runs a computation as compiled for this machine, or as plainly as [`Isa::best`](crate::Isa::best) is plain.
#[inline(always)]
pub fn alone<A: Alone>(computation: A) {
    #[cfg(target_arch = "x86_64")]
    crate::x86::run_alone(computation);
    #[cfg(not(target_arch = "x86_64"))]
    computation.run();
}
