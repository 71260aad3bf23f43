//! The field of the integers modulo 2^61 − 1.
//!
//! Two different rational functions agree at a random point of this field with probability at most degree / 2^61
//! (Schwartz–Zippel lemma).

/// Modulus of the prime field in which [`Prime`] numbers compute: 2^61 − 1, a Mersenne prime.
pub const PRIME: u64 = (1 << 61) - 1;

/// An integer modulo [`PRIME`], stored as its representative below [`PRIME`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Prime(u64);

impl Prime {
    /// Residue class of `value` modulo [`PRIME`].
    pub fn new(value: u64) -> Self {
        Self(value % PRIME)
    }

    /// Integer representative of the residue class, in 0..[`PRIME`].
    pub fn value(self) -> u64 {
        self.0
    }

    /// Multiplicative inverse; 0 for 0, by convention.
    pub fn inverse(self) -> Self {
        // The inverse is the power 2^61 − 3 = 4·(2^59 − 1) + 1. From the powers 2^m − 1 and 2^n − 1 follows the power
        // 2^(m+n) − 1, by n squarings and one product.
        let joined = |high: Self, low: Self, squarings: u32| high.squared(squarings) * low;
        let of_2 = joined(self, self, 1);
        let of_3 = joined(of_2, self, 1);
        let of_6 = joined(of_3, of_3, 3);
        let of_7 = joined(of_6, self, 1);
        let of_14 = joined(of_7, of_7, 7);
        let of_28 = joined(of_14, of_14, 14);
        let of_29 = joined(of_28, self, 1);
        let of_58 = joined(of_29, of_29, 29);
        let of_59 = joined(of_58, self, 1);
        joined(of_59, self, 2)
    }

    /// Product with the inverse of `divisor`.
    fn quotient(self, divisor: Self) -> Self {
        self * divisor.inverse()
    }

    /// Returns `self` raised to the power 2^`times`.
    fn squared(self, times: u32) -> Self {
        (0..times).fold(self, |power, _| power * power)
    }

    /// Residue class, modulo [`PRIME`], of an integer below twice [`PRIME`].
    #[inline]
    fn reduced(value: u64) -> Self {
        Self(if value < PRIME { value } else { value - PRIME })
    }
}

crate::operators!([] Prime {
    Add add(a, b) => Self::reduced(a.0 + b.0),
    Sub sub(a, b) => Self::reduced(a.0 + PRIME - b.0),
    Mul mul(a, b) => {
        let product = u128::from(a.0) * u128::from(b.0);
        Self::reduced((product as u64 & PRIME) + (product >> 61) as u64)
    },
    Div div(a, b) => a.quotient(b),
    -a => Self::reduced(PRIME - a.0),
});

crate::constants!([] Prime {
    zero => Self(0),
    is_zero(a) => a.0 == 0,
    one => Self(1),
    integer(n) => {
        let size = Self::new(n.unsigned_abs());
        if n < 0 { -size } else { size }
    },
});

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::{One, Zero};

    #[test]
    fn every_element_but_zero_has_an_inverse() {
        for v in [1, 2, 3, 0x1234_5678_9abc_def0, PRIME - 1] {
            assert_eq!(Prime::new(v) * Prime::new(v).inverse(), Prime::one());
        }
        assert_eq!(Prime::zero().inverse(), Prime::zero());
    }

    #[test]
    fn it_is_a_ring() {
        let (a, b, c) = (
            Prime::new(u64::MAX),
            Prime::new(PRIME - 7),
            Prime::new(1 << 60),
        );
        assert_eq!(a * (b + c), a * b + a * c);
        assert_eq!(a - b, -(b - a));
    }
}
