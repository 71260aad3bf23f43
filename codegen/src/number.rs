//! Rational constants: exact fractions while numerator and denominator fit `i64`, `f64` otherwise.

use std::hash::{Hash, Hasher};

/// Numerical constant, exact or floating-point.
#[derive(Clone, Copy, Debug)]
pub enum Number {
    /// Exact fraction: numerator and positive denominator, in lowest terms.
    Exact(i64, i64),
    /// Floating-point value that has no exact fraction.
    Float(f64),
}

impl Number {
    /// The constant 0, exact.
    pub const ZERO: Number = Number::Exact(0, 1);
    /// The constant 1, exact.
    pub const ONE: Number = Number::Exact(1, 1);
    /// The constant -1, exact.
    pub const MINUS_ONE: Number = Number::Exact(-1, 1);

    /// -1 if `minus`, else 1.
    pub fn sign(minus: bool) -> Number {
        if minus {
            Number::MINUS_ONE
        } else {
            Number::ONE
        }
    }

    /// Exact constant of an integer value.
    pub fn whole(value: i64) -> Number {
        Number::Exact(value, 1)
    }

    /// A fraction in lowest terms; `Float` beyond `i64`, or if the denominator is 0.
    pub fn fraction(numerator: i128, denominator: i128) -> Number {
        if denominator == 0 {
            return Number::Float(numerator as f64 / denominator as f64);
        }
        let divisor = gcd(numerator.unsigned_abs(), denominator.unsigned_abs()).max(1) as i128;
        let sign = if denominator < 0 { -1 } else { 1 };
        let (n, d) = (sign * numerator / divisor, sign * denominator / divisor);
        match (i64::try_from(n), i64::try_from(d)) {
            (Ok(n), Ok(d)) => Number::Exact(n, d),
            _ => Number::Float(n as f64 / d as f64),
        }
    }

    /// A literal: its exact fraction, else an integer below 1e15, else `Float`.
    pub fn literal(value: f64, exact: Option<(i64, i64)>) -> Number {
        match exact {
            Some((n, d)) => Number::fraction(n.into(), d.into()),
            None if value == value.trunc() && value.abs() < 1e15 => Number::whole(value as i64),
            None => Number::Float(value),
        }
    }

    /// Value of the constant as `f64`, rounded if necessary.
    pub fn value(self) -> f64 {
        match self {
            Number::Exact(n, d) => n as f64 / d as f64,
            Number::Float(x) => x,
        }
    }

    /// Whether the value is 0.
    pub fn is_zero(self) -> bool {
        self.value() == 0.0
    }

    /// Whether the constant is the exact fraction 1; false for `Float(1.0)`.
    pub fn is_one(self) -> bool {
        self == Number::ONE
    }

    /// Whether the value is below 0.
    pub fn is_negative(self) -> bool {
        self.value() < 0.0
    }

    /// Absolute value of the constant.
    pub fn abs(self) -> Number {
        if self.is_negative() {
            self.opposite()
        } else {
            self
        }
    }

    /// Negated value, `-self`.
    pub fn opposite(self) -> Number {
        Number::MINUS_ONE.times(self)
    }

    /// Sum `self + other`; exact if both constants are exact and the result fits.
    pub fn plus(self, other: Number) -> Number {
        match (self, other) {
            (Number::Exact(a, b), Number::Exact(c, d)) => {
                let (a, b, c, d) = (i128::from(a), i128::from(b), i128::from(c), i128::from(d));
                Number::fraction(a * d + c * b, b * d)
            }
            (a, b) => Number::Float(a.value() + b.value()),
        }
    }

    /// Product `self * other`; exact if both constants are exact and the result fits.
    pub fn times(self, other: Number) -> Number {
        match (self, other) {
            (Number::Exact(a, b), Number::Exact(c, d)) => {
                Number::fraction(i128::from(a) * i128::from(c), i128::from(b) * i128::from(d))
            }
            (a, b) => Number::Float(a.value() * b.value()),
        }
    }

    /// Reciprocal `1 / self`; infinite for 0.
    pub fn recip(self) -> Number {
        match self {
            Number::Exact(n, d) => Number::fraction(d.into(), n.into()),
            Number::Float(x) => Number::Float(1.0 / x),
        }
    }

    /// `self` to an integer power; infinite if the base is 0 and the exponent negative.
    pub fn power(self, exponent: i32) -> Number {
        let base = if exponent < 0 { self.recip() } else { self };
        (0..exponent.unsigned_abs()).fold(Number::ONE, |product, _| product.times(base))
    }

    /// Square root; exact if numerator and denominator are perfect squares, 0 for negative values.
    pub fn sqrt(self) -> Number {
        if self.is_negative() {
            return Number::ZERO;
        }
        if let Number::Exact(n, d) = self {
            let (rn, rd) = ((n as f64).sqrt() as i64, (d as f64).sqrt() as i64);
            if rn.checked_mul(rn) == Some(n) && rd.checked_mul(rd) == Some(d) {
                return Number::Exact(rn, rd);
            }
        }
        Number::Float(self.value().sqrt())
    }

    fn key(self) -> (u8, u64, u64) {
        match self {
            Number::Exact(n, d) => (0, n as u64, d as u64),
            // -0.0 and 0.0 compare equal
            Number::Float(x) => (1, if x == 0.0 { 0 } else { x.to_bits() }, 0),
        }
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Number) -> bool {
        self.key() == other.key()
    }
}

impl Eq for Number {}

impl Hash for Number {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.key().hash(state);
    }
}

fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_stay_exact() {
        let third = Number::fraction(1, 3);
        assert_eq!(third.plus(third).plus(third), Number::ONE);
        assert_eq!(Number::fraction(4, -6), Number::Exact(-2, 3));
        assert_eq!(Number::fraction(4, 9).sqrt(), Number::Exact(2, 3));
        assert_eq!(Number::whole(2).power(-3), Number::Exact(1, 8));
    }

    #[test]
    fn overflow_falls_back_to_floats() {
        let big = Number::whole(i64::MAX);
        assert_eq!(
            big.times(big),
            Number::Float(i64::MAX as f64 * i64::MAX as f64)
        );
    }
}
