//! Pairs of scalars evaluated in one pass.

use super::table::Interpolant;
use super::{Elementary, Field, Real, Surface};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A pair of scalars on which every operation acts separately; comparisons use `first`.
///
/// With such a pair, a single evaluation of a model yields derivatives of two kinds, and the code of the evaluation is
/// compiled only once for both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lockstep<A, B> {
    /// First scalar, whose real value decides comparisons.
    pub first: A,
    /// Second scalar, without influence on comparisons.
    pub second: B,
}

impl<A, B> Lockstep<A, B> {
    fn map<C, D>(self, first: impl FnOnce(A) -> C, second: impl FnOnce(B) -> D) -> Lockstep<C, D> {
        Lockstep {
            first: first(self.first),
            second: second(self.second),
        }
    }
}

macro_rules! binary {
    ($($trait:ident $method:ident)*) => {$(
        impl<A: Field, B: Field> $trait for Lockstep<A, B> {
            type Output = Self;
            // A call keeps the code of an instantiation small; the code of the operations is long.
            #[inline(never)]
            fn $method(self, o: Self) -> Self {
                self.map(|a| a.$method(o.first), |b| b.$method(o.second))
            }
        }
    )*};
}
binary!(Add add Sub sub Mul mul Div div);

impl<A: Field, B: Field> Neg for Lockstep<A, B> {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(|a| -a, |b| -b)
    }
}

crate::assign_ops!([A: Field, B: Field] Lockstep<A, B>);

crate::constants!([A: Field, B: Field] Lockstep<A, B> {
    zero => Self { first: A::zero(), second: B::zero() },
    is_zero(a) => a.first.is_zero() && a.second.is_zero(),
    one => Self { first: A::one(), second: B::one() },
    integer(n) => Self { first: A::integer(n), second: B::integer(n) },
    is_nothing(a) => a.first.is_nothing() && a.second.is_nothing(),
});

impl<A: Real, B: Real> Real for Lockstep<A, B> {
    crate::jet!();

    fn lit(value: f64) -> Self {
        Self {
            first: A::lit(value),
            second: B::lit(value),
        }
    }

    fn re(self) -> f64 {
        self.first.re()
    }

    #[inline(never)]
    fn elementary(self, function: Elementary) -> Self {
        self.map(|a| a.elementary(function), |b| b.elementary(function))
    }

    fn interpolated(self, table: &Interpolant, order: u8) -> Self {
        self.map(
            |a| a.interpolated(table, order),
            |b| b.interpolated(table, order),
        )
    }

    fn on_surface(self, other: Self, table: &Surface, orders: [u8; 2]) -> Self {
        self.map(
            |a| a.on_surface(other.first, table, orders),
            |b| b.on_surface(other.second, table, orders),
        )
    }

    #[inline(never)]
    fn atan2(self, x: Self) -> Self {
        self.map(|a| a.atan2(x.first), |b| b.atan2(x.second))
    }
}
