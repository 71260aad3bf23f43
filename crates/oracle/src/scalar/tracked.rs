//! Numbers that remember how large the terms were that they were summed from.
//!
//! `size` is the sum of the magnitudes of the terms, carried to first order through every operation:
//! where nothing cancels it is |value|; where terms of size 1 cancel to 1e-9 it is still 2. An error is
//! judged against it, so that cancellation neither hides a fault nor looks like one.

use super::{Field, Real};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A value and the size of the terms that it was summed from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tracked {
    /// Value.
    pub value: f64,
    /// Sum of the magnitudes of the terms.
    pub size: f64,
}

impl Tracked {
    fn function(self, value: f64, slope: f64) -> Self {
        Self {
            value,
            size: value.abs() + slope.abs() * self.size,
        }
    }

    /// |`other` − value| against the size of the terms; infinite where `other` is no number.
    pub fn error_of(self, other: f64) -> f64 {
        let difference = (other - self.value).abs();
        if difference == 0.0 {
            0.0
        } else if difference.is_finite() {
            difference / self.size.max(f64::MIN_POSITIVE)
        } else {
            f64::INFINITY
        }
    }
}

impl Add for Tracked {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self {
            value: self.value + o.value,
            size: self.size + o.size,
        }
    }
}

impl Sub for Tracked {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self {
            value: self.value - o.value,
            size: self.size + o.size,
        }
    }
}

impl Mul for Tracked {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        let value = self.value * o.value;
        let size = self.value.abs() * o.size + o.value.abs() * self.size - value.abs();
        Self {
            value,
            size: size.max(value.abs()),
        }
    }
}

impl Div for Tracked {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        let size = (self.size + value.abs() * o.size) / o.value.abs() - value.abs();
        Self {
            value,
            size: size.max(value.abs()),
        }
    }
}

impl Neg for Tracked {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            size: self.size,
        }
    }
}

super::assign_ops!([] Tracked);

impl Zero for Tracked {
    fn zero() -> Self {
        Self {
            value: 0.0,
            size: 0.0,
        }
    }

    fn is_zero(&self) -> bool {
        self.value == 0.0
    }
}

impl One for Tracked {
    fn one() -> Self {
        Self::lit(1.0)
    }
}

impl Field for Tracked {
    fn whole(value: i64) -> Self {
        Self::lit(value as f64)
    }

    fn literal(value: f64, _exact: Option<(i64, i64)>) -> Option<Self> {
        Some(Self::lit(value))
    }
}

impl Real for Tracked {
    fn lit(value: f64) -> Self {
        Self {
            value,
            size: value.abs(),
        }
    }

    fn re(self) -> f64 {
        self.value
    }

    fn sqrt(self) -> Self {
        let root = Real::sqrt(self.value);
        if root == 0.0 {
            Self::zero()
        } else {
            self.function(root, 0.5 / root)
        }
    }

    fn sin(self) -> Self {
        self.function(self.value.sin(), self.value.cos())
    }

    fn cos(self) -> Self {
        self.function(self.value.cos(), self.value.sin())
    }

    fn asin(self) -> Self {
        let x = self.value.clamp(-1.0, 1.0);
        let room = ((1.0 - x) * (1.0 + x)).sqrt();
        self.function(x.asin(), if room == 0.0 { 0.0 } else { 1.0 / room })
    }

    fn atan(self) -> Self {
        self.function(self.value.atan(), 1.0 / (1.0 + self.value * self.value))
    }

    fn exp(self) -> Self {
        let e = self.value.exp();
        self.function(e, e)
    }

    fn ln(self) -> Self {
        if self.value <= 0.0 {
            Self::zero()
        } else {
            self.function(self.value.ln(), 1.0 / self.value)
        }
    }

    fn tanh(self) -> Self {
        let t = self.value.tanh();
        self.function(t, 1.0 - t * t)
    }

    fn atan2(self, x: Self) -> Self {
        let value = Real::atan2(self.value, x.value);
        let square = self.value * self.value + x.value * x.value;
        if square == 0.0 {
            return Self::zero();
        }
        let turn = (x.value.abs() * self.size + self.value.abs() * x.size) / square;
        Self {
            value,
            size: value.abs() + turn,
        }
    }
}
