//! Dual numbers of the crate `num-dual`: an independent implementation of forward differentiation.

use super::{Elementary, Field, Real};
use num_dual::{Dual64, DualNum};
use num_traits::{One, Zero};
use std::f64::consts::FRAC_PI_2;

/// A dual number of the crate `num-dual`, as one of the scalar types with which models are evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NumDual(pub Dual64);

impl NumDual {
    /// Creates a dual number from a value and its derivative.
    pub fn new(value: f64, derivative: f64) -> Self {
        Self(Dual64::new(value, derivative))
    }

    /// Derivative part of the dual number.
    pub fn derivative(self) -> f64 {
        self.0.eps
    }
}

crate::wrapped_ops!(NumDual(Dual64));

impl Zero for NumDual {
    fn zero() -> Self {
        Self::lit(0.0)
    }

    fn is_zero(&self) -> bool {
        self.0.re == 0.0 && self.0.eps == 0.0
    }
}

super::rounded_literals!(NumDual);

impl Real for NumDual {
    fn lit(value: f64) -> Self {
        Self(Dual64::new(value, 0.0))
    }

    fn re(self) -> f64 {
        self.0.re
    }

    fn elementary(self, function: Elementary) -> Self {
        if function.is_constant_at(self.0.re) {
            return Self::lit(function.value(self.0.re));
        }
        Self(function.inside_domain(self.0))
    }

    fn atan2(self, x: Self) -> Self {
        let (y, x) = (self.0, x.0);
        if y.re == 0.0 && x.re == 0.0 {
            Self::zero()
        } else if y.re.abs() > x.re.abs() {
            // num-dual divides by x, which may be 0.
            let quarter = Dual64::from_re(FRAC_PI_2.copysign(y.re));
            Self(quarter - (x / y).atan())
        } else {
            Self(y.atan2(x))
        }
    }
}
