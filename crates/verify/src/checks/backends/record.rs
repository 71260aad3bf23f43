//! Records generated code as programs of the intermediate representation.
//!
//! Generated functions are generic over [`Real`], which has no comparison that returns a `bool`, so every scalar type
//! performs the same operations in the same order. Evaluating a function on [`Recorded`] therefore yields the
//! operations for all scalar types. Replayed by a [`Tape`](codegen::tape::Tape), the recording gives the results of the
//! function itself on any lanes. This needs one instantiation per model instead of one per model and instruction set; a
//! test compares the replay with the native instantiations.

use codegen::functions::MathFunction;
use codegen::program::{Binary, Fused, Op, Operand, Program, Statement, Unary};
use codegen::table::{PiecewiseCubic, TableFunction, TableId, Tables};
use lanes::{ElementaryFunction, Real};
use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

thread_local! {
    static RECORDING: RefCell<Recording> = const { RefCell::new(Recording::new()) };
}

/// Recorded program: the operations on [`Recorded`] numbers that this thread has executed, in order.
struct Recording {
    statements: Vec<Statement>,
    /// Inputs, constants and results of the recorded operations, in order of appearance.
    operands: Vec<Operand>,
    /// Interpolated tables, as piecewise cubics, that the recorded operations evaluate, in order of appearance.
    tables: Vec<PiecewiseCubic>,
}

impl Recording {
    const fn new() -> Self {
        Self {
            statements: Vec::new(),
            operands: Vec::new(),
            tables: Vec::new(),
        }
    }

    fn operand(&mut self, operand: Operand) -> Recorded {
        self.operands.push(operand);
        Recorded(index(self.operands.len() - 1))
    }
}

fn index(k: usize) -> u32 {
    u32::try_from(k).expect("fewer than 2^32 operands")
}

/// Scalar type that appends every operation on it to a program, which is recorded per thread. The number itself is an
/// index into the operands of that program.
///
/// The small size and the calls that are not inlined make the instantiation of a model's functions cheap to compile.
#[derive(Clone, Copy)]
struct Recorded(u32);

#[inline(never)]
fn input(operand: Operand) -> Recorded {
    RECORDING.with_borrow_mut(|recording| recording.operand(operand))
}

#[inline(never)]
fn push<const N: usize>(arguments: [Recorded; N], op: impl FnOnce([Operand; N]) -> Op) -> Recorded {
    RECORDING.with_borrow_mut(|recording| {
        let arguments = arguments.map(|argument| recording.operands[argument.0 as usize]);
        recording.statements.push(Statement {
            op: op(arguments),
            name: None,
            about: None,
        });
        let result = Operand::Temp(index(recording.statements.len() - 1));
        recording.operand(result)
    })
}

#[inline(never)]
fn unary(op: Unary, a: Recorded) -> Recorded {
    push([a], |[a]| Op::Unary(op, a))
}

fn call(function: MathFunction, a: Recorded) -> Recorded {
    unary(Unary::Call(function), a)
}

#[inline(never)]
fn binary(op: Binary, a: Recorded, b: Recorded) -> Recorded {
    push([a, b], |[a, b]| Op::Binary(op, a, b))
}

#[inline(never)]
fn fused(op: Fused, a: Recorded, b: Recorded, c: Recorded) -> Recorded {
    push([a, b, c], |[a, b, c]| Op::Fused(op, a, b, c))
}

macro_rules! binary {
    ($($trait:ident $method:ident)*) => {$(
        impl $trait for Recorded {
            type Output = Self;
            fn $method(self, b: Self) -> Self {
                binary(Binary::$trait, self, b)
            }
        }
    )*};
}
binary!(Add add Sub sub Mul mul Div div);

impl Neg for Recorded {
    type Output = Self;
    fn neg(self) -> Self {
        unary(Unary::Neg, self)
    }
}

impl Real for Recorded {
    fn splat(value: f64) -> Self {
        input(Operand::Constant(value))
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

    fn elementary(self, function: ElementaryFunction) -> Self {
        call(function.into(), self)
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
        push([self, then, otherwise], |[a, b, c]| Op::IfZero(a, b, c))
    }

    fn piecewise_cubic(self, knots: &[f64], cubics: &[[f64; 4]]) -> Self {
        let cubic = PiecewiseCubic::new(knots.to_vec(), cubics.to_vec());
        let known = RECORDING.with_borrow_mut(|recording| {
            let known = recording.tables.iter().position(|known| *known == cubic);
            known.unwrap_or_else(|| {
                recording.tables.push(cubic);
                recording.tables.len() - 1
            })
        });
        let function = TableFunction::new(TableId::new(known), 0);
        call(MathFunction::Table(function), self)
    }
}

/// Records the functions of a generated model as programs, in the order of [`codegen::Compiled::functions`]; `None` if
/// no generated model has that name.
pub(super) fn programs(model: &str) -> Option<[Program; 8]> {
    generated::visit(model, Recorder)
}

struct Recorder;

impl generated::Visitor for Recorder {
    type Output = [Program; 8];

    fn visit<E: generated::Equations>(self) -> [Program; 8] {
        let m = E::MODEL;
        RECORDING.set(Recording::new());
        // The operands remain after a function is recorded, because all functions share the inputs.
        let time = input(Operand::Time);
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
                E::f_jac_par(time, x, p, k, dx, j, jp);
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
                E::quantities(time, x, p, k, q);
            }),
            record([m.limit_bounds.len()], |[l]| E::limits(time, x, p, k, l)),
        ]
    }
}

fn inputs(count: usize, operand: fn(u32) -> Operand) -> Vec<Recorded> {
    (0..index(count)).map(|k| input(operand(k))).collect()
}

/// Calls `function` and returns the operations that it executes, recorded as a program. `lengths` are the lengths of
/// the slices into which `function` writes its results; these are the outputs of the program.
fn record<const N: usize>(
    lengths: [usize; N],
    function: impl FnOnce([&mut [Recorded]; N]),
) -> Program {
    let unwritten = Recorded::splat(f64::INFINITY);
    let mut results = lengths.map(|len| vec![unwritten; len]);
    function(results.each_mut().map(Vec::as_mut_slice));
    RECORDING.with_borrow_mut(|recording| Program {
        statements: std::mem::take(&mut recording.statements),
        tables: Tables::of_cubics(recording.tables.clone()),
        outputs: results
            .into_iter()
            .flatten()
            .map(|result| recording.operands[result.0 as usize])
            .collect(),
    })
}
