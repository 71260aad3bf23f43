//! The prime field as a scalar of the oracle and of compiled programs; functions of the model language yield the symbols
//! of [`crate::field`].
//!
//! The sine of an angle depends on how the angle was computed. Known angles are recorded in a thread-local context while
//! [`evaluate`] runs.

use crate::evaluation::{self, Arithmetic, Inputs};
use crate::field::{self, Angle, FieldPoint};
use codegen::functions::MathFunction;
use codegen::program::Program;
use codegen::table::{TableFunction, Tables};
use num_traits::{One, Zero};
use oracle::scalar::{Elementary, Prime, Real};
use oracle::{Interpolant, Point, Surface};
use std::cell::RefCell;

/// An element of the prime field, with the functions of the model language; `None` for a value that does not exist in
/// the field, such as the square root of a non-square.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symbolic(pub Option<Prime>);

#[derive(Default)]
struct Context {
    angles: Vec<Angle>,
    /// Numbers with their logarithms: 1, and those of the exponentials and logarithms computed so far.
    logarithms: Vec<(Prime, Prime)>,
    /// Whether the value of a function that is not rational is a symbol, see [`crate::field`]. If false, such a function
    /// has no value, except sine and cosine of a known angle.
    has_symbols: bool,
}

thread_local! {
    static CONTEXT: RefCell<Context> = RefCell::new(Context::default());
}

/// Evaluates `task`, which computes with [`Symbolic`] numbers, at a point. Sine and cosine of the states and of their
/// small integer multiples are those of the point. If `has_symbols`, functions that are not rational yield symbols,
/// otherwise no value.
pub fn evaluate<R>(
    spot: &FieldPoint,
    has_symbols: bool,
    task: impl FnOnce(&Point<Symbolic>) -> R,
) -> R {
    let states = spot.point.states.iter().zip(&spot.circles);
    CONTEXT.set(Context {
        angles: states.map(|(&state, &circle)| (state, circle)).collect(),
        logarithms: vec![(Prime::one(), Prime::zero())],
        has_symbols,
    });
    let result = task(&spot.point.map(Symbolic::from));
    CONTEXT.take();
    result
}

/// Outputs of a compiled program at a point, with symbols; `None` for an output without a value in the prime field.
pub fn outputs(program: &Program, spot: &FieldPoint) -> Vec<Option<Prime>> {
    let outputs = evaluate(spot, true, |point| {
        evaluation::outputs(program, &Inputs::of(point))
    });
    outputs.into_iter().map(|output| output.0).collect()
}

/// The value that `value` returns, if functions that are not rational have values.
fn symbol<R>(value: impl FnOnce() -> R) -> Option<R> {
    CONTEXT
        .with_borrow(|context| context.has_symbols)
        .then(value)
}

fn circle(angle: Prime) -> Option<(Prime, Prime)> {
    let known = CONTEXT.with_borrow(|context| field::known(angle, &context.angles));
    known.or_else(|| symbol(|| field::circle(angle)))
}

fn polar(y: Prime, x: Prime) -> Option<Prime> {
    let found = symbol(|| field::angle(y, x))??;
    CONTEXT.with_borrow_mut(|context| context.angles.push(found));
    Some(found.0)
}

/// e^`a`, the number if `a` is the logarithm of one or its opposite.
fn exponential(a: Prime) -> Prime {
    CONTEXT.with_borrow_mut(|context| {
        for &(number, logarithm) in &context.logarithms {
            if a == logarithm {
                return number;
            }
            if a == -logarithm {
                return number.inverse();
            }
        }
        let number = field::call(MathFunction::Exp, a);
        context.logarithms.push((number, a));
        number
    })
}

/// Logarithm of `a`, the exponent if `a` is a power of e.
fn logarithm(a: Prime) -> Prime {
    CONTEXT.with_borrow_mut(|context| {
        let mut known = context.logarithms.iter();
        if let Some((_, logarithm)) = known.find(|(number, _)| *number == a) {
            return *logarithm;
        }
        let logarithm = field::call(MathFunction::Log, a);
        context.logarithms.push((a, logarithm));
        logarithm
    })
}

impl From<Prime> for Symbolic {
    fn from(value: Prime) -> Self {
        Self(Some(value))
    }
}

impl Symbolic {
    fn map(self, f: impl FnOnce(Prime) -> Option<Prime>) -> Self {
        Self(self.0.and_then(f))
    }

    fn with(self, other: Self, f: impl FnOnce(Prime, Prime) -> Option<Prime>) -> Self {
        Self(self.0.zip(other.0).and_then(|(a, b)| f(a, b)))
    }

    /// Symbol of a function of two scalars whose order does not matter.
    fn unordered(self, other: Self, function: u64) -> Self {
        let of = |a: Prime, b: Prime| field::symbol(function, &[a.min(b), a.max(b)]);
        self.with(other, |a, b| symbol(|| of(a, b)))
    }
}

oracle::operators!([] Symbolic {
    Add add(a, b) => a.with(b, |a, b| Some(a + b)),
    Sub sub(a, b) => a.with(b, |a, b| Some(a - b)),
    Mul mul(a, b) => a.with(b, |a, b| Some(a * b)),
    Div div(a, b) => a.with(b, |a, b| Some(a / b)),
    -a => a.map(|a| Some(-a)),
});

oracle::constants!([] Symbolic {
    zero => Prime::zero().into(),
    is_zero(a) => a.0.is_some_and(|value| value.is_zero()),
    one => Prime::one().into(),
    integer(n) => Prime::integer(n).into(),
});

impl Real for Symbolic {
    oracle::jet!();

    fn lit(value: f64) -> Self {
        Self(field::constant(value).or_else(|| symbol(|| field::literal(value))))
    }

    /// Value in comparisons: that of a number such as −1.5; for any other element of the prime field, which has none, one
    /// that is inside the domain of every function and not a singular point.
    fn re(self) -> f64 {
        self.0.and_then(field::small_number).unwrap_or(0.5)
    }

    fn elementary(self, function: Elementary) -> Self {
        match function {
            Elementary::Sqrt => self.map(|a| symbol(|| field::root(a))?),
            Elementary::Sin => self.map(|a| Some(circle(a)?.0)),
            Elementary::Cos => self.map(|a| Some(circle(a)?.1)),
            Elementary::Atan => self.map(|a| polar(a, Prime::one())),
            Elementary::Exp => self.map(|a| symbol(|| exponential(a))),
            Elementary::Log => self.map(|a| symbol(|| logarithm(a))),
            _ => {
                let function =
                    MathFunction::named(function.name()).expect("a function of the compiler");
                self.map(|a| symbol(|| field::call(function, a)))
            }
        }
    }

    fn interpolated(self, table: &Interpolant, order: u8) -> Self {
        self.map(|a| symbol(|| field::table(table.fingerprint(), order, a)))
    }

    fn on_surface(self, other: Self, table: &Surface, orders: [u8; 2]) -> Self {
        self.with(other, |a, b| {
            symbol(|| field::surface(table.fingerprint(), orders, [a, b]))
        })
    }

    fn atan2(self, x: Self) -> Self {
        self.with(x, polar)
    }
}

impl Arithmetic for Symbolic {
    fn if_zero(self, then: Self, otherwise: Self) -> Self {
        match self.0 {
            None => self,
            Some(value) if value.is_zero() => then,
            Some(_) => otherwise,
        }
    }

    fn call(self, function: MathFunction, tables: &Tables) -> Self {
        match (function, Elementary::named(function.name())) {
            (_, Some(function)) => self.elementary(function),
            (MathFunction::NonZero, _) => self.if_zero(Self::zero(), Self::one()),
            (MathFunction::Table(function), _) => {
                let of = tables.table(function.table()).fingerprint;
                self.map(|a| symbol(|| field::table(of, function.orders()[0], a)))
            }
            _ => self.map(|a| symbol(|| field::call(function, a))),
        }
    }

    fn looked_up(self, other: Self, function: TableFunction<2>, tables: &Tables) -> Self {
        let of = tables.table(function.table()).fingerprint;
        self.with(other, |a, b| {
            symbol(|| field::surface(of, function.orders(), [a, b]))
        })
    }

    fn least(self, other: Self) -> Self {
        self.unordered(other, 1)
    }

    fn greatest(self, other: Self) -> Self {
        self.unordered(other, 2)
    }
}
