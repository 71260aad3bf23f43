//! Computations that are compiled as functions of their own.

/// A computation on SIMD lanes of type `T` that [`Lanes::outlined`](crate::Lanes::outlined) runs in a function that is
/// not inlined.
///
/// `run` and all its callees over `T` must be `#[inline(always)]`, as in a [`Kernel`](crate::Kernel).
pub trait LaneKernel<T> {
    /// Runs the computation. [`Lanes::outlined`](crate::Lanes::outlined) calls this method in a function that is not
    /// inlined.
    fn run(self);
}
