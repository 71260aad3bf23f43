//! Dual numbers over any scalar; over [`ErrorBound`](super::ErrorBound) they yield a derivative with its error bound.

use super::table::Interpolant;
use super::{Elementary, Field, Real};
use num_traits::{One, Zero};

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
        derivative: a.derivative * b.value + a.value * b.derivative,
    },
    Div div(a, b) => {
        let value = a.value / b.value;
        let derivative = (a.derivative - value * b.derivative) / b.value;
        Self { value, derivative }
    },
    -a => Self::new(-a.value, -a.derivative),
});

impl<T: Field> Zero for Dual<T> {
    fn zero() -> Self {
        Self::constant(T::zero())
    }

    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.derivative.is_zero()
    }
}

impl<T: Field> One for Dual<T> {
    fn one() -> Self {
        Self::constant(T::one())
    }
}

impl<T: Field> Field for Dual<T> {
    fn integer(value: i64) -> Self {
        Self::constant(T::integer(value))
    }
}

impl<T: Real> Real for Dual<T> {
    fn lit(value: f64) -> Self {
        Self::constant(T::lit(value))
    }

    fn re(self) -> f64 {
        self.value.re()
    }

    fn elementary(self, function: Elementary) -> Self {
        let value = self.value.elementary(function);
        if function.is_constant_at(self.re()) {
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
