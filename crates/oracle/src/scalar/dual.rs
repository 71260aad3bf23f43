//! Scalars that carry a derivative: dual numbers over any scalar, which over [`ErrorBound`](super::ErrorBound) yield its
//! error bound, those of the crate `num-dual`, and complex steps, f'(x) = Im f(x + ih) / h without cancellation.

use super::table::Interpolant;
use super::{Elementary, Field, Real, Surface};
use nalgebra::Complex;
use num_dual::{Dual64, DualNum};
use num_traits::Zero;
use std::f64::consts::FRAC_PI_2;

/// Dual number: a value and its derivative in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<T> {
    /// Value of the dual number, without the derivative.
    pub value: T,
    /// Derivative of the value in the direction given by the derivatives of the arguments.
    pub derivative: T,
}

impl<T: Field> Dual<T> {
    /// Dual number of a constant, with derivative 0.
    pub fn constant(value: T) -> Self {
        Self {
            value,
            derivative: T::zero(),
        }
    }

    /// Creates a dual number from a value and its derivative.
    pub fn new(value: T, derivative: T) -> Self {
        Self { value, derivative }
    }
}

crate::operators!([T: Field] Dual<T> {
    Add add(a, b) => Self::new(a.value + b.value, a.derivative + b.derivative),
    Sub sub(a, b) => Self::new(a.value - b.value, a.derivative - b.derivative),
    Mul mul(a, b) => Self {
        value: a.value * b.value,
        derivative: moved(a.derivative, b.value) + moved(b.derivative, a.value),
    },
    Div div(a, b) => {
        let value = a.value / b.value;
        let derivative = (a.derivative - value * b.derivative) / b.value;
        Self { value, derivative }
    },
    -a => Self::new(-a.value, -a.derivative),
});

crate::constants!([T: Field] Dual<T> {
    zero => Self::constant(T::zero()),
    is_zero(a) => a.value.is_zero() && a.derivative.is_zero(),
    one => Self::constant(T::one()),
    integer(n) => Self::constant(T::integer(n)),
    is_nothing(a) => a.derivative.is_nothing() && a.value.is_nothing(),
});

impl<T: Real> Real for Dual<T> {
    crate::jet!();

    fn lit(value: f64) -> Self {
        Self::constant(T::lit(value))
    }

    fn re(self) -> f64 {
        self.value.re()
    }

    fn elementary(self, function: Elementary) -> Self {
        let value = self.value.elementary(function);
        if self.derivative.is_nothing() || function.is_constant_at(self.re()) {
            return Self::constant(value);
        }
        Self {
            value,
            derivative: function.derivative(self.value, value) * self.derivative,
        }
    }

    fn interpolated(self, table: &Interpolant, order: u8) -> Self {
        Self {
            value: self.value.interpolated(table, order),
            derivative: self.value.interpolated(table, order + 1) * self.derivative,
        }
    }

    fn on_surface(self, other: Self, table: &Surface, orders: [u8; 2]) -> Self {
        let of = |orders| self.value.on_surface(other.value, table, orders);
        let [first, second] = orders;
        Self {
            value: of(orders),
            derivative: of([first + 1, second]) * self.derivative
                + of([first, second + 1]) * other.derivative,
        }
    }

    fn atan2(self, x: Self) -> Self {
        if self.re() == 0.0 && x.re() == 0.0 {
            return Self::zero();
        }
        let square = self.value * self.value + x.value * x.value;
        Self {
            value: self.value.atan2(x.value),
            derivative: (x.value * self.derivative - self.value * x.derivative) / square,
        }
    }
}

/// A derivative times a factor. Most derivatives of nested dual numbers are 0, and their products are what costs.
fn moved<T: Field>(derivative: T, factor: T) -> T {
    match derivative.is_nothing() {
        true => derivative,
        false => derivative * factor,
    }
}

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

crate::constants!([] NumDual {
    zero => Self::lit(0.0),
    is_zero(a) => a.0.re == 0.0 && a.0.eps == 0.0,
    one => Self::lit(1.0),
    integer(n) => Self::lit(n as f64),
});

impl Real for NumDual {
    crate::jet!();

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

crate::constants!([] ComplexStep {
    zero => Self::lit(0.0),
    is_zero(a) => a.0.re == 0.0 && a.0.im == 0.0,
    one => Self::lit(1.0),
    integer(n) => Self::lit(n as f64),
});

impl Real for ComplexStep {
    crate::jet!();

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
