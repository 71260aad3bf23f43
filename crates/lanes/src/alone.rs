//! Code on one number at a time, compiled for the machine that it runs on.
//!
//! A plain build has 16 registers, overwrites one with every operation, and fuses none. Machines with wide vectors have up
//! to 32, operations that leave their arguments alone, and fused ones.

use crate::Single;

/// A computation on one number at a time, for [`alone`].
///
/// `run`, and what it calls, gains by it where it is `#[inline(always)]`.
pub trait Alone {
    /// The computation. `T` is `f64` where nothing fuses.
    fn run<T: Single>(self);
}

/// Runs a computation as compiled for this machine, or as plainly as [`Isa::best`](crate::Isa::best) is plain: with the
/// bits of [`dispatch`](crate::dispatch).
#[inline(always)]
pub fn alone<A: Alone>(computation: A) {
    #[cfg(target_arch = "x86_64")]
    crate::x86::run_alone(computation);
    #[cfg(not(target_arch = "x86_64"))]
    computation.run::<f64>();
}
