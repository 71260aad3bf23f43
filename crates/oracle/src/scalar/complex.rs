//! Complex step: a derivative is the imaginary part that a tiny imaginary step leaves.

use super::{Field, Real};
use nalgebra::Complex;
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// The imaginary step: its square vanishes beside any number of ours.
pub const STEP: f64 = 1e-120;

/// A complex number; decisions are made by the real part alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComplexStep(pub Complex<f64>);

impl ComplexStep {
    /// A value that moves at `slope`, a step away from the real line.
    pub fn moving(value: f64, slope: f64) -> Self {
        Self(Complex::new(value, slope * STEP))
    }

    /// The derivative that the step has left.
    pub fn slope(self) -> f64 {
        self.0.im / STEP
    }

    fn first_order(self, value: f64, slope: f64) -> Self {
        Self(Complex::new(value, slope * self.0.im))
    }
}

super::wrapped_ops!(ComplexStep(Complex<f64>));
super::assign_ops!([] ComplexStep);

impl Zero for ComplexStep {
    fn zero() -> Self {
        Self::lit(0.0)
    }

    fn is_zero(&self) -> bool {
        self.0.re == 0.0 && self.0.im == 0.0
    }
}

impl One for ComplexStep {
    fn one() -> Self {
        Self::lit(1.0)
    }
}

impl Field for ComplexStep {
    fn whole(value: i64) -> Self {
        Self::lit(value as f64)
    }

    fn literal(value: f64, _exact: Option<(i64, i64)>) -> Option<Self> {
        Some(Self::lit(value))
    }
}

impl Real for ComplexStep {
    fn lit(value: f64) -> Self {
        Self(Complex::new(value, 0.0))
    }

    fn re(self) -> f64 {
        self.0.re
    }

    fn sqrt(self) -> Self {
        if self.0.re <= 0.0 {
            Self::zero()
        } else {
            Self(self.0.sqrt())
        }
    }

    fn sin(self) -> Self {
        Self(self.0.sin())
    }

    fn cos(self) -> Self {
        Self(self.0.cos())
    }

    // The inverse functions of complex numbers go through logarithms, in which a step of 1e-120 is lost.
    fn asin(self) -> Self {
        let x = self.0.re;
        if x.abs() >= 1.0 {
            return Self::lit(Real::asin(x));
        }
        self.first_order(x.asin(), 1.0 / (1.0 - x * x).sqrt())
    }

    fn atan(self) -> Self {
        let x = self.0.re;
        self.first_order(x.atan(), 1.0 / (1.0 + x * x))
    }

    fn exp(self) -> Self {
        Self(self.0.exp())
    }

    fn ln(self) -> Self {
        if self.0.re <= 0.0 {
            Self::zero()
        } else {
            Self(self.0.ln())
        }
    }

    fn tanh(self) -> Self {
        let t = self.0.re.tanh();
        self.first_order(t, 1.0 - t * t)
    }

    fn atan2(self, x: Self) -> Self {
        let (y, x) = (self.0, x.0);
        if y.re == 0.0 && x.re == 0.0 {
            return Self::zero();
        }
        let turn = (x.re * y.im - y.re * x.im) / (x.re * x.re + y.re * y.re);
        Self(Complex::new(y.re.atan2(x.re), turn))
    }
}
