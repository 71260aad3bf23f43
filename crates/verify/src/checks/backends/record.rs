//! Generated code recorded as programs.
//!
//! Generated functions are generic over [`Real`], which has no comparison that returns a `bool`: every scalar type
//! goes through the same operations in the same order. Evaluating a function on [`Recorded`] therefore yields its
//! operations for all scalar types at once; replayed by a [`Tape`](codegen::tape::Tape), they give what the function
//! itself gives on any lanes. One instantiation per model replaces one per model and instruction set; a test compares
//! the replay with the native instantiations.

use codegen::functions::MathFunction;
use codegen::program::{Binary, Fused, Op, Operand, Program, Statement, Unary};
use lanes::Real;
use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

thread_local! {
    static STATEMENTS: RefCell<Vec<Statement>> = const { RefCell::new(Vec::new()) };
}

/// A scalar whose operations are appended to the program being recorded on this thread.
#[derive(Clone, Copy)]
struct Recorded(Operand);

#[inline(never)]
fn push(op: Op) -> Recorded {
    STATEMENTS.with_borrow_mut(|statements| {
        let index = u32::try_from(statements.len()).expect("fewer than 2^32 operations");
        statements.push(Statement {
            op,
            name: None,
            about: None,
        });
        Recorded(Operand::Temp(index))
    })
}

fn unary(op: Unary, a: Recorded) -> Recorded {
    push(Op::Unary(op, a.0))
}

fn call(function: MathFunction, a: Recorded) -> Recorded {
    unary(Unary::Call(function), a)
}

fn binary(op: Binary, a: Recorded, b: Recorded) -> Recorded {
    push(Op::Binary(op, a.0, b.0))
}

fn fused(op: Fused, a: Recorded, b: Recorded, c: Recorded) -> Recorded {
    push(Op::Fused(op, a.0, b.0, c.0))
}

impl Add for Recorded {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        binary(Binary::Add, self, b)
    }
}

impl Sub for Recorded {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        binary(Binary::Sub, self, b)
    }
}

impl Mul for Recorded {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        binary(Binary::Mul, self, b)
    }
}

impl Div for Recorded {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        binary(Binary::Div, self, b)
    }
}

impl Neg for Recorded {
    type Output = Self;
    fn neg(self) -> Self {
        unary(Unary::Neg, self)
    }
}

impl Real for Recorded {
    fn splat(value: f64) -> Self {
        Self(Operand::Constant(value))
    }

    fn mul_add(self, b: Self, c: Self) -> Self {
        fused(Fused::MulAdd, self, b, c)
    }

    fn mul_sub(self, b: Self, c: Self) -> Self {
        fused(Fused::MulSub, self, b, c)
    }

    fn neg_mul_add(self, b: Self, c: Self) -> Self {
        fused(Fused::NegMulAdd, self, b, c)
    }

    fn sqrt(self) -> Self {
        call(MathFunction::Sqrt, self)
    }

    fn recip_or_zero(self) -> Self {
        unary(Unary::RecipOrZero, self)
    }

    fn sin_cos(self) -> (Self, Self) {
        (call(MathFunction::Sin, self), call(MathFunction::Cos, self))
    }

    fn atan2(self, x: Self) -> Self {
        binary(Binary::Atan2, self, x)
    }

    fn exp(self) -> Self {
        call(MathFunction::Exp, self)
    }

    fn log(self) -> Self {
        call(MathFunction::Log, self)
    }

    fn tanh(self) -> Self {
        call(MathFunction::Tanh, self)
    }

    fn asin(self) -> Self {
        call(MathFunction::Asin, self)
    }

    fn abs(self) -> Self {
        call(MathFunction::Abs, self)
    }

    fn min(self, other: Self) -> Self {
        binary(Binary::Min, self, other)
    }

    fn max(self, other: Self) -> Self {
        binary(Binary::Max, self, other)
    }

    fn sign(self) -> Self {
        call(MathFunction::Sign, self)
    }

    fn heaviside(self) -> Self {
        call(MathFunction::Heaviside, self)
    }

    fn if_zero(self, then: Self, otherwise: Self) -> Self {
        push(Op::IfZero(self.0, then.0, otherwise.0))
    }
}

/// The functions of a generated model as programs, in the order of [`codegen::Compiled::functions`]; `None` if no
/// generated model has that name.
pub(super) fn programs(model: &str) -> Option<[Program; 8]> {
    generated::visit(model, Recorder)
}

struct Recorder;

impl generated::Visitor for Recorder {
    type Output = [Program; 8];

    fn visit<E: generated::Equations>(self) -> [Program; 8] {
        let m = E::MODEL;
        let time = Recorded(Operand::Time);
        let x = &inputs(m.states.len(), Operand::State);
        let p = &inputs(m.parameters.len(), Operand::Parameter);
        let k = &inputs(m.prepared.len(), Operand::Prepared);
        let marker = &inputs(3, Operand::Marker);
        let n = m.states.len();
        let (j, jp) = (m.j_pattern.len(), m.jp_pattern.len());
        let observed = |len: usize| if m.observed { len } else { 0 };
        let [by_x, by_p, by_marker] = [m.dy_dx_pattern, m.dy_dp_pattern, m.dy_dmarker_pattern]
            .map(|pattern| observed(pattern.len()));
        [
            record([m.prepared.len()], |[k]| E::prepare(p, k)),
            record([n], |[dx]| E::f(time, x, p, k, dx)),
            record([n, j], |[dx, j]| E::f_jac(time, x, p, k, dx, j)),
            record([n, j, jp], |[dx, j, jp]| {
                E::f_jac_par(time, x, p, k, dx, j, jp)
            }),
            record([observed(3)], |[y]| {
                if m.observed {
                    E::observe(time, x, p, k, marker, y);
                }
            }),
            record([observed(3), by_x, by_p, by_marker], |[y, x_, p_, m_]| {
                if m.observed {
                    E::observe_jac(time, x, p, k, marker, y, x_, p_, m_);
                }
            }),
            record([m.quantity_names.len()], |[q]| {
                E::quantities(time, x, p, k, q)
            }),
            record([m.limit_bounds.len()], |[l]| E::limits(time, x, p, k, l)),
        ]
    }
}

fn inputs(count: usize, operand: fn(u32) -> Operand) -> Vec<Recorded> {
    let count = u32::try_from(count).expect("fewer than 2^32 inputs");
    (0..count).map(|k| Recorded(operand(k))).collect()
}

/// Records one function with result slices of the given lengths.
fn record<const N: usize>(
    lengths: [usize; N],
    function: impl FnOnce([&mut [Recorded]; N]),
) -> Program {
    let mut results = lengths.map(|len| vec![Recorded::splat(f64::INFINITY); len]);
    STATEMENTS.with_borrow_mut(Vec::clear);
    function(results.each_mut().map(Vec::as_mut_slice));
    Program {
        statements: STATEMENTS.take(),
        outputs: results.into_iter().flatten().map(|value| value.0).collect(),
    }
}
