//! The prime field as a scalar of the oracle; functions of the model language yield the symbols of [`crate::field`].
//!
//! A function value may not exist in the field, and the sine of an angle depends on how the angle was computed. Missing
//! values and known angles are recorded in a thread-local context while [`evaluate`] runs.

use crate::field::{self, Angle};
use codegen::functions::MathFunction;
use num_traits::{One, Zero};
use oracle::Interpolant;
use oracle::scalar::{Elementary, Field, Prime, Real};
use std::cell::RefCell;

/// An element of the prime field, with the functions of the model language.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symbolic(pub Prime);

#[derive(Default)]
struct Context {
    angles: Vec<Angle>,
    is_missing: bool,
}

thread_local! {
    static CONTEXT: RefCell<Context> = RefCell::new(Context::default());
}

/// Evaluates `task`, which computes with [`Symbolic`] numbers. Each entry of `angles` consists of an angle and its
/// (sine, cosine); these determine the sines and cosines of the angle and of its small integer multiples in the task.
/// `None` if the task takes a square root of a non-square of the prime field.
pub fn evaluate<R>(angles: Vec<Angle>, task: impl FnOnce() -> R) -> Option<R> {
    let fresh = Context {
        angles,
        is_missing: false,
    };
    CONTEXT.with_borrow_mut(|context| *context = fresh);
    let result = task();
    let context = CONTEXT.take();
    (!context.is_missing).then_some(result)
}

fn or_missing(value: Option<Prime>) -> Symbolic {
    Symbolic(value.unwrap_or_else(|| {
        CONTEXT.with_borrow_mut(|context| context.is_missing = true);
        Prime::zero()
    }))
}

fn circle(angle: Prime) -> (Prime, Prime) {
    CONTEXT.with_borrow(|context| {
        field::known(angle, &context.angles).unwrap_or_else(|| field::circle(angle))
    })
}

fn polar(y: Prime, x: Prime) -> Symbolic {
    or_missing(field::angle(y, x).map(|found| {
        CONTEXT.with_borrow_mut(|context| context.angles.push(found));
        found.0
    }))
}

oracle::wrapped_ops!(Symbolic(Prime));

impl Zero for Symbolic {
    fn zero() -> Self {
        Self(Prime::zero())
    }

    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl One for Symbolic {
    fn one() -> Self {
        Self(Prime::one())
    }
}

impl Field for Symbolic {
    fn integer(value: i64) -> Self {
        Self(Prime::integer(value))
    }

    fn literal(value: f64, exact: Option<(i64, i64)>) -> Option<Self> {
        let fraction = exact.map(|(n, d)| Prime::integer(n) / Prime::integer(d));
        Some(Self(fraction.unwrap_or_else(|| field::literal(value))))
    }
}

impl Real for Symbolic {
    fn lit(value: f64) -> Self {
        Self(field::literal(value))
    }

    /// Constant that replaces the real value in comparisons, because an element of the prime field has none. It is
    /// inside the domain of every function and not a singular point.
    fn re(self) -> f64 {
        0.5
    }

    fn elementary(self, function: Elementary) -> Self {
        match function {
            Elementary::Sqrt => or_missing(field::root(self.0)),
            Elementary::Sin => Self(circle(self.0).0),
            Elementary::Cos => Self(circle(self.0).1),
            Elementary::Atan => polar(self.0, Prime::one()),
            _ => {
                let function =
                    MathFunction::named(function.name()).expect("a function of the compiler");
                Self(field::call(function, self.0))
            }
        }
    }

    fn interpolated(self, table: &Interpolant, order: u8) -> Self {
        Self(field::table(table.fingerprint, order, self.0))
    }

    fn atan2(self, x: Self) -> Self {
        polar(self.0, x.0)
    }
}
