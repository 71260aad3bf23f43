//! Real numbers one at a time or many at once: one text for `f64` and for the machine's widest vectors.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number, or one number in each of several lanes. Generated code and the tape are written once, over this.
///
/// Every implementation gives the same bits in every lane: no operation is contracted (no fused
/// multiply-add), and the functions are computed by the same polynomials everywhere.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The same number in every lane.
    fn splat(value: f64) -> Self;
    /// Square root; 0 where the argument is 0 or less.
    fn sqrt(self) -> Self;
    /// `1 / self`, and 0 where `|self| < 1e-75`: the stated behaviour at singular points.
    fn recip_or_zero(self) -> Self;
    /// Sine and cosine, within 2 ulp for arguments up to 1e5 and correct beyond.
    fn sin_cos(self) -> (Self, Self);
    /// Angle of the point (`x`, `self`), within 2 ulp; 0 at the origin.
    fn atan2(self, x: Self) -> Self;
    /// Exponential.
    fn exp(self) -> Self;
    /// Natural logarithm; 0 where the argument is 0 or less.
    fn log(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// Arcsine of the argument held within -1 .. 1.
    fn asin(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// The smaller of two.
    fn min(self, other: Self) -> Self;
    /// The greater of two.
    fn max(self, other: Self) -> Self;
    /// -1, 0 or 1.
    fn sign(self) -> Self;
    /// 1 where above 0, else 0.
    fn step(self) -> Self;
    /// `then` where `|self| < 1e-75`, else `otherwise`.
    fn if_zero(self, then: Self, otherwise: Self) -> Self;
}
