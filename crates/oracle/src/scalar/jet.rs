//! Numbers with derivatives within one another, for `der(…)`, `partial(…)` and the unknowns of systems: infinitesimals ε
//! whose squares are 0.

use super::table::Interpolant;
use super::{Dual, Elementary, Field, Infinitesimals, Real};

type Nested<T> = Dual<Dual<Dual<Dual<T>>>>;

/// A number with up to four derivatives within one another, each along an infinitesimal of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet<T>(Nested<T>);

impl<T: Field> Jet<T> {
    /// A number without derivatives.
    pub fn constant(value: T) -> Self {
        let inner = Dual::constant(Dual::constant(value));
        Self(Dual::constant(Dual::constant(inner)))
    }

    /// The number without its derivatives.
    pub fn value(self) -> T {
        self.part(0)
    }

    /// The number of which `part` gives the factor of each product of infinitesimals, whose bits are those of
    /// [`bit`].
    fn of_parts(part: impl Fn(usize) -> T) -> Self {
        let one = |of| Dual::new(part(of), part(of | 1));
        let two = |of| Dual::new(one(of), one(of | 2));
        let three = |of| Dual::new(two(of), two(of | 4));
        Self(Dual::new(three(0), three(8)))
    }

    /// Factor of a product of infinitesimals, whose bits are those of [`bit`].
    fn part(self, of: usize) -> T {
        fn side<U>(of: Dual<U>, is_derivative: bool) -> U {
            if is_derivative {
                of.derivative
            } else {
                of.value
            }
        }
        let three = side(self.0, of & 8 != 0);
        let two = side(three, of & 4 != 0);
        let one = side(two, of & 2 != 0);
        side(one, of & 1 != 0)
    }
}

/// The bit of an infinitesimal; the first one is that of the outermost derivative.
fn bit(level: usize) -> usize {
    8 >> level
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
    const UNKNOWN: usize = 3;

    fn epsilon(level: usize) -> Self {
        Self::of_parts(|of| {
            if of == bit(level) {
                T::one()
            } else {
                T::zero()
            }
        })
    }

    fn coefficient(self, level: usize) -> Self {
        let bit = bit(level);
        Self::of_parts(|of| {
            if of & bit == 0 {
                self.part(of | bit)
            } else {
                T::zero()
            }
        })
    }
}
