//! Real numbers one at a time or many at once: one text for `f64` and for the machine's widest vectors.
//!
//! Code that is written once over [`Real`] (or [`Lanes`], which adds loading and storing) runs on `f64`,
//! and, handed to [`dispatch`] as a [`Kernel`], on the widest lanes that this machine has:
//!
//! ```
//! use lanes::{dispatch, Kernel, Lanes};
//!
//! struct Sines<'a>(&'a [f64], &'a mut [f64]);
//!
//! impl Kernel for Sines<'_> {
//!     type Output = ();
//!     // Always inlined, and so must be whatever it calls: only so is it compiled for the wide lanes.
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

mod alone;
mod dispatch;
mod functions;
mod portable;
mod primitive;
mod scalar;
mod single;
#[cfg(target_arch = "x86_64")]
mod x86;

use std::ops::{Add, Div, Mul, Neg, Sub};

pub use alone::{Alone, alone};
pub use dispatch::{Isa, Kernel, dispatch, dispatch_with};
pub use single::Single;

/// A number, or one number in each of several lanes. Generated code and the tape are written once, over this.
///
/// Which operations are fused is said by the code, never by the compiler: [`mul_add`](Real::mul_add) and its like may
/// be, nothing else is. The lanes of AVX-512 and AVX2, and [`alone`] where it stands in for them, fuse; [`Isa::Portable`]
/// and `f64` itself do not, for want of an instruction that is on every machine. The functions are computed by the same
/// polynomials everywhere. So all that fuse give the same bits in every lane, and all that do not; the two differ by
/// roundings.
/// A NaN goes in and a NaN comes out, of no particular sign; where a function below states a value
/// for "0 or less", a NaN is neither.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The same number in every lane.
    fn splat(value: f64) -> Self;
    /// `self * b + c`: with one rounding where the lanes fuse ([`Isa::fuses`]), with two where they do not.
    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        self * b + c
    }
    /// `self * b - c`, fused as [`mul_add`](Real::mul_add) is.
    #[inline(always)]
    fn mul_sub(self, b: Self, c: Self) -> Self {
        self * b - c
    }
    /// `c - self * b`, fused as [`mul_add`](Real::mul_add) is.
    #[inline(always)]
    fn mul_from(self, b: Self, c: Self) -> Self {
        c - self * b
    }
    /// Square root; 0 where the argument is 0 or less.
    fn sqrt(self) -> Self;
    /// `1 / self`, and 0 where `|self| < 1e-75`: the stated behaviour at singular points.
    fn recip_or_zero(self) -> Self;
    /// Sine and cosine, within 2 ulp for arguments up to 1e5 and correct beyond.
    fn sin_cos(self) -> (Self, Self);
    /// Angle of the point (`x`, `self`), within 2 ulp; 0 at the origin.
    fn atan2(self, x: Self) -> Self;
    /// Exponential, within 2 ulp.
    fn exp(self) -> Self;
    /// Natural logarithm, within 2 ulp; 0 where the argument is 0 or less.
    fn log(self) -> Self;
    /// Hyperbolic tangent, within 3 ulp.
    fn tanh(self) -> Self;
    /// Arcsine of the argument held within -1 .. 1, within 3 ulp.
    fn asin(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// The smaller of two; `other` where they cannot be compared.
    fn min(self, other: Self) -> Self;
    /// The greater of two; `other` where they cannot be compared.
    fn max(self, other: Self) -> Self;
    /// -1, 0 or 1.
    fn sign(self) -> Self;
    /// 1 where above 0, else 0.
    fn step(self) -> Self;
    /// `then` where `|self| < 1e-75`, else `otherwise`.
    fn if_zero(self, then: Self, otherwise: Self) -> Self;
}

/// [`Real`] numbers that are loaded from and stored to slices, [`WIDTH`](Lanes::WIDTH) at a time.
pub trait Lanes: Real {
    /// How many lanes.
    const WIDTH: usize;
    /// The first `WIDTH` numbers of a slice.
    ///
    /// # Panics
    /// Where the slice is shorter.
    fn load(from: &[f64]) -> Self;
    /// Writes the lanes to the first `WIDTH` places of a slice.
    ///
    /// # Panics
    /// Where the slice is shorter.
    fn store(self, to: &mut [f64]);
    /// The number that `value` gives for each lane.
    fn from_fn(value: impl FnMut(usize) -> f64) -> Self;
    /// One lane.
    ///
    /// # Panics
    /// Where there is no such lane.
    fn lane(self, lane: usize) -> f64;

    /// Up to `WIDTH` numbers of a slice, and `fill` in the lanes beyond its end.
    #[inline(always)]
    fn load_part(from: &[f64], fill: f64) -> Self {
        if from.len() >= Self::WIDTH {
            Self::load(from)
        } else {
            Self::from_fn(|lane| from.get(lane).copied().unwrap_or(fill))
        }
    }

    /// Writes as many lanes as the slice has room for.
    #[inline(always)]
    fn store_part(self, to: &mut [f64]) {
        if to.len() >= Self::WIDTH {
            self.store(to);
        } else {
            for (lane, place) in to.iter_mut().enumerate() {
                *place = self.lane(lane);
            }
        }
    }
}
