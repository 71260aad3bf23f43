//! Complex-step differentiation: f'(x) = Im f(x + ih) / h without cancellation.

use super::{Elementary, Field, Real};
use nalgebra::Complex;
use num_traits::{One, Zero};

/// Imaginary step h of the complex-step method; h² is negligible against every value of a model.
pub const STEP: f64 = 1e-120;

/// A complex number whose imaginary part is [`STEP`] times a derivative; comparisons use the real part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComplexStep(pub Complex<f64>);

impl ComplexStep {
    /// Complex number that represents a value and its derivative.
    pub fn new(value: f64, derivative: f64) -> Self {
        Self(Complex::new(value, derivative * STEP))
    }

    /// Derivative: imaginary part divided by [`STEP`].
    pub fn derivative(self) -> f64 {
        self.0.im / STEP
    }
}

crate::wrapped_ops!(ComplexStep(Complex<f64>));

impl Zero for ComplexStep {
    fn zero() -> Self {
        Self::lit(0.0)
    }

    fn is_zero(&self) -> bool {
        self.0.re == 0.0 && self.0.im == 0.0
    }
}

super::rounded_literals!(ComplexStep);

impl Real for ComplexStep {
    fn lit(value: f64) -> Self {
        Self(Complex::new(value, 0.0))
    }

    fn re(self) -> f64 {
        self.0.re
    }

    fn elementary(self, function: Elementary) -> Self {
        let x = self.0.re;
        if function.is_constant_at(x) {
            return Self::lit(function.value(x));
        }
        Self(match function {
            Elementary::Sqrt => self.0.sqrt(),
            Elementary::Sin => self.0.sin(),
            Elementary::Cos => self.0.cos(),
            Elementary::Exp => self.0.exp(),
            Elementary::Log => self.0.ln(),
            // Complex versions of the other functions use logarithms or quotients that lose a step of 1e-120.
            _ => {
                let value = function.value(x);
                Complex::new(value, function.derivative(x, value) * self.0.im)
            }
        })
    }

    fn atan2(self, x: Self) -> Self {
        let (y, x) = (self.0, x.0);
        if y.re == 0.0 && x.re == 0.0 {
            return Self::zero();
        }
        let derivative = (x.re * y.im - y.re * x.im) / (x.re * x.re + y.re * y.re);
        Self(Complex::new(y.re.atan2(x.re), derivative))
    }
}
