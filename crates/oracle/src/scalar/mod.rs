//! The numbers that an oracle is evaluated in.

mod complex;
mod dual;
mod num_dual;
mod ops;
mod prime;
mod real;
mod tracked;

pub use complex::{ComplexStep, STEP};
pub use dual::Dual;
pub use num_dual::NumDual;
pub use prime::{PRIME, Prime};
pub use tracked::Tracked;

use ::num_traits::{One, Zero};
use ops::{assign_ops, wrapped_ops};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// What sums, products and quotients need: a field.
pub trait Field:
    nalgebra::Scalar
    + Copy
    + Zero
    + One
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    /// A whole number.
    fn whole(value: i64) -> Self;

    /// A number of the model: exact where it is written exactly.
    fn literal(value: f64, exact: Option<(i64, i64)>) -> Option<Self>;
}

/// A field with the functions of the language, at their stated behaviour in singular points.
pub trait Real: Field {
    /// A number.
    fn lit(value: f64) -> Self;
    /// Its value, whatever else it carries.
    fn re(self) -> f64;
    /// Square root; 0 with derivative 0 where the argument is 0 or less.
    fn sqrt(self) -> Self;
    /// Sine.
    fn sin(self) -> Self;
    /// Cosine.
    fn cos(self) -> Self;
    /// Arcsine of the argument held within -1 .. 1; derivative 0 beyond.
    fn asin(self) -> Self;
    /// Arctangent.
    fn atan(self) -> Self;
    /// Exponential.
    fn exp(self) -> Self;
    /// Natural logarithm; 0 with derivative 0 where the argument is 0 or less.
    fn ln(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// Angle of the point (`x`, `self`); 0 with derivative 0 at the origin.
    fn atan2(self, x: Self) -> Self;

    /// Absolute value; derivative 0 at 0.
    fn abs(self) -> Self {
        match self.re() {
            v if v > 0.0 => self,
            v if v < 0.0 => -self,
            _ => Self::zero(),
        }
    }

    /// Whole power.
    fn powi(self, n: i32) -> Self {
        let mut product = Self::one();
        for _ in 0..n.unsigned_abs() {
            product *= self;
        }
        if n < 0 {
            Self::one() / product
        } else {
            product
        }
    }
}
