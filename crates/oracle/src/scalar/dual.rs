//! Our own dual numbers over any scalar: over [`Tracked`](super::Tracked) they give a derivative
//! together with the magnitude of the terms that make it up.

use super::{Field, Real};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A value and its derivative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<T> {
    /// Value.
    pub value: T,
    /// Derivative.
    pub slope: T,
}

impl<T: Field> Dual<T> {
    /// A value that does not vary.
    pub fn constant(value: T) -> Self {
        Self {
            value,
            slope: T::zero(),
        }
    }

    /// A value that moves at `slope`.
    pub fn moving(value: T, slope: T) -> Self {
        Self { value, slope }
    }

    fn chain(self, value: T, slope: T) -> Self {
        Self {
            value,
            slope: slope * self.slope,
        }
    }
}

impl<T: Field> Add for Dual<T> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self {
            value: self.value + o.value,
            slope: self.slope + o.slope,
        }
    }
}

impl<T: Field> Sub for Dual<T> {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self {
            value: self.value - o.value,
            slope: self.slope - o.slope,
        }
    }
}

impl<T: Field> Mul for Dual<T> {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self {
            value: self.value * o.value,
            slope: self.slope * o.value + self.value * o.slope,
        }
    }
}

impl<T: Field> Div for Dual<T> {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        Self {
            value,
            slope: (self.slope - value * o.slope) / o.value,
        }
    }
}

impl<T: Field> Neg for Dual<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            slope: -self.slope,
        }
    }
}

super::assign_ops!([T: Field] Dual<T>);

impl<T: Field> Zero for Dual<T> {
    fn zero() -> Self {
        Self::constant(T::zero())
    }

    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.slope.is_zero()
    }
}

impl<T: Field> One for Dual<T> {
    fn one() -> Self {
        Self::constant(T::one())
    }
}

impl<T: Field> Field for Dual<T> {
    fn whole(value: i64) -> Self {
        Self::constant(T::whole(value))
    }

    fn literal(value: f64, exact: Option<(i64, i64)>) -> Option<Self> {
        T::literal(value, exact).map(Self::constant)
    }
}

impl<T: Real> Real for Dual<T> {
    fn lit(value: f64) -> Self {
        Self::constant(T::lit(value))
    }

    fn re(self) -> f64 {
        self.value.re()
    }

    fn sqrt(self) -> Self {
        if self.re() <= 0.0 {
            return Self::zero();
        }
        let root = self.value.sqrt();
        self.chain(root, T::one() / (root + root))
    }

    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }

    fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }

    fn asin(self) -> Self {
        let v = self.value;
        if v.re().abs() >= 1.0 {
            return Self::constant(v.asin());
        }
        self.chain(
            v.asin(),
            T::one() / ((T::one() - v) * (T::one() + v)).sqrt(),
        )
    }

    fn atan(self) -> Self {
        self.chain(
            self.value.atan(),
            T::one() / (T::one() + self.value * self.value),
        )
    }

    fn exp(self) -> Self {
        let e = self.value.exp();
        self.chain(e, e)
    }

    fn ln(self) -> Self {
        if self.re() <= 0.0 {
            return Self::zero();
        }
        self.chain(self.value.ln(), T::one() / self.value)
    }

    fn tanh(self) -> Self {
        let t = self.value.tanh();
        self.chain(t, (T::one() - t) * (T::one() + t))
    }

    fn atan2(self, x: Self) -> Self {
        if self.re() == 0.0 && x.re() == 0.0 {
            return Self::zero();
        }
        let square = self.value * self.value + x.value * x.value;
        Self {
            value: self.value.atan2(x.value),
            slope: (x.value * self.slope - self.value * x.slope) / square,
        }
    }
}
