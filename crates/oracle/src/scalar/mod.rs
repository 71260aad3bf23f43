//! Scalar types of the oracle: real numbers, derivatives, error bounds, 256-bit numbers, and a prime field.

mod big;
mod dual;
mod error_bound;
mod function;
mod jet;
mod lockstep;
mod ops;
mod prime;
mod surface;
mod table;

use ::num_traits::{One, Zero};
pub use big::{Big, PRECISION, with_numbers};
pub use dual::{ComplexStep, Dual, NumDual, STEP};
pub use error_bound::ErrorBound;
pub use function::Elementary;
pub(crate) use function::call;
pub use jet::Jet;
pub use lockstep::Lockstep;
pub use prime::{PRIME, Prime};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
pub use surface::Surface;
pub use table::Interpolant;

/// An algebraic field: scalars with sums, differences, products and quotients.
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
    /// The integer `value` as a scalar of this type.
    fn integer(value: i64) -> Self;

    /// Whether the scalar is 0 in each part: no term of it has cancelled, and it has no derivative.
    #[inline]
    fn is_nothing(&self) -> bool {
        self.is_zero()
    }
}

/// A [`Field`] with the functions of the model language and their defined values at singular points.
pub trait Real: Field {
    /// This number with derivatives within one another; the same type if it has them.
    type Jet: Infinitesimals;
    /// The number without derivatives.
    fn jet(self) -> Self::Jet;
    /// The number without its derivatives, unless it is one with derivatives itself.
    fn of_jet(jet: Self::Jet) -> Self;
    /// The constant `value`, with derivative 0.
    fn lit(value: f64) -> Self;
    /// The real value of the scalar, without derivatives or error bounds.
    fn re(self) -> f64;
    /// Value of an elementary function at `self`; see [`Elementary`] for its values at singular points.
    fn elementary(self, function: Elementary) -> Self;
    /// Polar angle of the point (`x`, `self`), rad; 0 with derivative 0 at the origin.
    fn atan2(self, x: Self) -> Self;

    /// Value of a table at `self` (`order` 0), or its derivative of the given order.
    fn interpolated(self, table: &Interpolant, order: u8) -> Self {
        table.at(self, order)
    }

    /// Value of a table of two arguments at (`self`, `other`), or its partial derivative of the given orders.
    fn on_surface(self, other: Self, table: &Surface, orders: [u8; 2]) -> Self {
        table.at([self, other], orders)
    }

    /// Square root; 0 with derivative 0 for arguments ≤ 0.
    fn sqrt(self) -> Self {
        self.elementary(Elementary::Sqrt)
    }

    /// Sine.
    fn sin(self) -> Self {
        self.elementary(Elementary::Sin)
    }

    /// Cosine.
    fn cos(self) -> Self {
        self.elementary(Elementary::Cos)
    }

    /// Exponential function.
    fn exp(self) -> Self {
        self.elementary(Elementary::Exp)
    }

    /// Natural logarithm; 0 with derivative 0 for arguments ≤ 0.
    fn ln(self) -> Self {
        self.elementary(Elementary::Log)
    }

    /// Absolute value; derivative 0 at 0.
    fn abs(self) -> Self {
        match self.re() {
            v if v > 0.0 => self,
            v if v < 0.0 => -self,
            _ => Self::zero(),
        }
    }

    /// Integer power `self`ⁿ; for n < 0 the reciprocal of the positive power.
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

/// A [`Real`] with infinitesimals, numbered from 0, whose squares are 0.
pub trait Infinitesimals: Real<Jet = Self> {
    /// Number of the last infinitesimal, that of an unknown of a system; those before it are for derivatives.
    const UNKNOWN: usize;
    /// The infinitesimal with the number `level`.
    fn epsilon(level: usize) -> Self;
    /// Factor of the infinitesimal with the number `level`.
    fn coefficient(self, level: usize) -> Self;
}

/// Items of [`Real`] for a type without infinitesimals.
#[macro_export]
macro_rules! jet {
    () => {
        type Jet = $crate::scalar::Jet<Self>;

        fn jet(self) -> Self::Jet {
            $crate::scalar::Jet::constant(self)
        }

        fn of_jet(jet: Self::Jet) -> Self {
            jet.value()
        }
    };
}

impl Field for f64 {
    fn integer(value: i64) -> Self {
        value as f64
    }
}

impl Real for f64 {
    crate::jet!();

    fn lit(value: f64) -> Self {
        value
    }

    fn re(self) -> f64 {
        self
    }

    fn elementary(self, function: Elementary) -> Self {
        function.value(self)
    }

    fn atan2(self, x: Self) -> Self {
        if self == 0.0 && x == 0.0 {
            0.0
        } else {
            f64::atan2(self, x)
        }
    }
}
