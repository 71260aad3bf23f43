//! `f64` as a scalar type of the oracle.

use super::{Elementary, Field, Real};

impl Field for f64 {
    fn integer(value: i64) -> Self {
        value as f64
    }
}

impl Real for f64 {
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
