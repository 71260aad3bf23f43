//! Numbers with derivatives within one another, for `der(…)` and `partial(…)`: three infinitesimals ε whose squares are 0.

use super::table::Interpolant;
use super::{Dual, Elementary, Field, Infinitesimals, Real};
use num_traits::One;

type Nested<T> = Dual<Dual<Dual<T>>>;

/// A number with up to three derivatives within one another, each along an infinitesimal of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet<T>(pub Nested<T>);

impl<T: Field> Jet<T> {
    /// A number without derivatives.
    pub fn constant(value: T) -> Self {
        Self(Dual::constant(Dual::constant(Dual::constant(value))))
    }

    /// The number without its derivatives.
    pub fn value(self) -> T {
        self.0.value.value.value
    }
}

crate::operators!([T: Field] Jet<T> {
    Add add(a, b) => Self(a.0 + b.0),
    Sub sub(a, b) => Self(a.0 - b.0),
    Mul mul(a, b) => Self(a.0 * b.0),
    Div div(a, b) => Self(a.0 / b.0),
    -a => Self(-a.0),
});

crate::constants!([T: Field] Jet<T> {
    zero => Self::constant(T::zero()),
    is_zero(a) => a.0.is_zero(),
    one => Self::constant(T::one()),
    integer(n) => Self::constant(T::integer(n)),
    is_nothing(a) => a.0.is_nothing(),
});

impl<T: Real> Real for Jet<T> {
    type Jet = Self;

    fn jet(self) -> Self {
        self
    }

    fn of_jet(jet: Self) -> Self {
        jet
    }

    fn lit(value: f64) -> Self {
        Self::constant(T::lit(value))
    }

    fn re(self) -> f64 {
        self.0.re()
    }

    fn elementary(self, function: Elementary) -> Self {
        Self(self.0.elementary(function))
    }

    fn interpolated(self, table: &Interpolant, order: u8) -> Self {
        Self(self.0.interpolated(table, order))
    }

    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(x.0))
    }
}

impl<T: Real> Infinitesimals for Jet<T> {
    fn epsilon(level: usize) -> Self {
        let (zero, one) = (Dual::constant(T::zero()), T::one());
        Self(match level {
            0 => Dual::new(Dual::constant(zero), Dual::one()),
            1 => Dual::constant(Dual::new(zero, Dual::one())),
            _ => Dual::constant(Dual::constant(Dual::new(T::zero(), one))),
        })
    }

    fn coefficient(self, level: usize) -> Self {
        let Dual { value, derivative } = self.0;
        let inner = |of: Dual<Dual<T>>| Dual::constant(of.derivative);
        let innermost = |of: Dual<Dual<T>>| {
            let part = |of: Dual<T>| Dual::constant(of.derivative);
            Dual::new(part(of.value), part(of.derivative))
        };
        Self(match level {
            0 => Dual::constant(derivative),
            1 => Dual::new(inner(value), inner(derivative)),
            _ => Dual::new(innermost(value), innermost(derivative)),
        })
    }
}
