//! SIMD real numbers: code generic over [`Real`] runs on `f64` and on SIMD vectors of `f64`.
//!
//! A computation over [`Lanes`] (a [`Real`] with loads and stores), passed to [`dispatch`] as a [`Kernel`], runs on
//! the widest lanes that the processor supports:
//!
//! ```
//! use lanes::{dispatch, Kernel, Lanes};
//!
//! struct Sines<'a>(&'a [f64], &'a mut [f64]);
//!
//! impl Kernel for Sines<'_> {
//!     type Output = ();
//!     // `inline(always)`, here and in all callees, compiles the body for the instruction set of `T`.
//!     #[inline(always)]
//!     fn run<T: Lanes>(self) {
//!         for (from, to) in self.0.chunks(T::WIDTH).zip(self.1.chunks_mut(T::WIDTH)) {
//!             T::load_part(from, 0.0).sin_cos().0.store_part(to);
//!         }
//!     }
//! }
//!
//! let (angles, mut sines) = ([0.0, 0.5, 1.0, 1.5, 2.0], [0.0; 5]);
//! dispatch(Sines(&angles, &mut sines));
//! for (angle, sine) in angles.iter().zip(sines) {
//!     assert!((angle.sin() - sine).abs() < 1e-15);
//! }
//! ```

#![deny(unsafe_code)]

mod dispatch;
mod enclosure;
mod functions;
mod fused;
mod isa;
mod kernel;
mod portable;
mod primitive;
mod real;
mod scalar;
mod switch;
#[cfg(target_arch = "x86_64")]
mod x86;

pub use dispatch::{dispatch, dispatch_scalar, dispatch_widest, dispatch_with};
pub use enclosure::Enclosure;
pub use fused::ScalarLane;
pub use isa::Isa;
pub use kernel::{Kernel, ScalarKernel};
pub use primitive::LaneKernel;
pub use real::{ElementaryFunction, Lanes, Real};
pub use switch::{Level, Switch};
