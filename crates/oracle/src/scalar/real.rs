//! Plain numbers.

use super::{Field, Real};

impl Field for f64 {
    fn whole(value: i64) -> Self {
        value as f64
    }

    fn literal(value: f64, _exact: Option<(i64, i64)>) -> Option<Self> {
        Some(value)
    }
}

impl Real for f64 {
    fn lit(value: f64) -> Self {
        value
    }

    fn re(self) -> f64 {
        self
    }

    fn sqrt(self) -> Self {
        if self > 0.0 { f64::sqrt(self) } else { 0.0 }
    }

    fn sin(self) -> Self {
        f64::sin(self)
    }

    fn cos(self) -> Self {
        f64::cos(self)
    }

    fn asin(self) -> Self {
        f64::asin(self.clamp(-1.0, 1.0))
    }

    fn atan(self) -> Self {
        f64::atan(self)
    }

    fn exp(self) -> Self {
        f64::exp(self)
    }

    fn ln(self) -> Self {
        if self > 0.0 { f64::ln(self) } else { 0.0 }
    }

    fn tanh(self) -> Self {
        f64::tanh(self)
    }

    fn atan2(self, x: Self) -> Self {
        if self == 0.0 && x == 0.0 {
            0.0
        } else {
            f64::atan2(self, x)
        }
    }
}
