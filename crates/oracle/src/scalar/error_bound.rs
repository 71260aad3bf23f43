//! Numbers with a running error bound.
//!
//! `magnitude` is the sum of the absolute values of all summed terms, propagated to first order through every
//! operation. Without cancellation it is |value|; where terms of size 1 cancel to 1e-9 it stays 2. An error relative to
//! the magnitude is therefore comparable with the rounding unit, whether or not terms cancel.

use super::table::Interpolant;
use super::{Elementary, Real, Surface};
use num_traits::Zero;

/// A number and the scale of its rounding error: the sum of the absolute values of its terms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorBound {
    /// Computed value.
    pub value: f64,
    /// Sum of the absolute values of the terms that sum to the value; at least |value|.
    pub magnitude: f64,
}

impl ErrorBound {
    /// Magnitude, SI, below which an error is compared with this magnitude instead: far above what underflow leaves of a
    /// value, and far below every quantity of a flight.
    pub const NEGLIGIBLE: f64 = 1e-100;

    /// Error of `other`, |`other` − value| / magnitude; infinite if `other` or the value is NaN.
    pub fn relative_error(self, other: f64) -> f64 {
        let difference = (other - self.value).abs();
        if difference == 0.0 {
            0.0
        } else if difference.is_finite() {
            difference / self.magnitude.max(Self::NEGLIGIBLE)
        } else {
            f64::INFINITY
        }
    }
}

crate::operators!([] ErrorBound {
    Add add(a, b) => Self {
        value: a.value + b.value,
        magnitude: a.magnitude + b.magnitude,
    },
    Sub sub(a, b) => Self {
        value: a.value - b.value,
        magnitude: a.magnitude + b.magnitude,
    },
    Mul mul(a, b) => {
        let value = a.value * b.value;
        let magnitude = a.value.abs() * b.magnitude + b.value.abs() * a.magnitude - value.abs();
        let magnitude = magnitude.max(value.abs());
        Self { value, magnitude }
    },
    Div div(a, b) => {
        let value = a.value / b.value;
        let magnitude = (a.magnitude + value.abs() * b.magnitude) / b.value.abs() - value.abs();
        let magnitude = magnitude.max(value.abs());
        Self { value, magnitude }
    },
    -a => Self { value: -a.value, ..a },
});

crate::constants!([] ErrorBound {
    zero => Self::lit(0.0),
    is_zero(a) => a.value == 0.0,
    one => Self::lit(1.0),
    integer(n) => Self::lit(n as f64),
    is_nothing(a) => a.magnitude == 0.0,
});

impl Real for ErrorBound {
    crate::jet!();

    fn lit(value: f64) -> Self {
        Self {
            value,
            magnitude: value.abs(),
        }
    }

    fn re(self) -> f64 {
        self.value
    }

    fn elementary(self, function: Elementary) -> Self {
        let value = function.value(self.value);
        if function.is_constant_at(self.value) {
            return Self::lit(value);
        }
        let derivative: f64 = function.derivative(self.value, value);
        Self {
            value,
            magnitude: value.abs() + derivative.abs() * self.magnitude,
        }
    }

    fn interpolated(self, table: &Interpolant, order: u8) -> Self {
        let value: f64 = table.at(self.value, order);
        let derivative: f64 = table.at(self.value, order + 1);
        let terms = match order {
            0 => table.magnitude_near(self.value),
            _ => value.abs(),
        };
        Self {
            value,
            magnitude: value.abs() + terms + derivative.abs() * self.magnitude,
        }
    }

    fn on_surface(self, other: Self, table: &Surface, orders: [u8; 2]) -> Self {
        let arguments = [self.value, other.value];
        let [first, second] = orders;
        let slope = |orders| table.at::<f64>(arguments, orders).abs();
        let value: f64 = table.at(arguments, orders);
        Self {
            value,
            magnitude: value.abs()
                + table.magnitude(arguments, orders)
                + slope([first + 1, second]) * self.magnitude
                + slope([first, second + 1]) * other.magnitude,
        }
    }

    fn atan2(self, x: Self) -> Self {
        let value = Real::atan2(self.value, x.value);
        let square = self.value * self.value + x.value * x.value;
        if square == 0.0 {
            return Self::zero();
        }
        let angle = (x.value.abs() * self.magnitude + self.value.abs() * x.magnitude) / square;
        Self {
            value,
            magnitude: value.abs() + angle,
        }
    }
}
