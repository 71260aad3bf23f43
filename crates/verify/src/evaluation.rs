//! Evaluates programs of the compiler with any scalar type of the oracle.

use codegen::functions::{BinaryFunction, MathFunction};
use codegen::program::{Binary, Function, Fused, Op, Operand, Program, Unary};
use codegen::table::{TableFunction, Tables};
use codegen::{Compiled, tape};
use num_traits::Zero;
use oracle::Point;
use oracle::scalar::{Big, Elementary, ErrorBound, Field, Real, with_numbers};

/// Inputs of a compiled program at a point, in the order of the compiled model's variables.
pub struct Inputs<T> {
    pub time: T,
    pub states: Vec<T>,
    pub parameters: Vec<T>,
    pub marker: Vec<T>,
    /// Results of `prepare`; empty for a program that does not read them.
    pub prepared: Vec<T>,
}

impl<T: Field> Inputs<T> {
    /// Inputs at a point, without prepared values.
    pub fn of(point: &Point<T>) -> Self {
        Self {
            time: point.time,
            states: point.states.clone(),
            parameters: point.parameters(),
            marker: point.marker.iter().copied().collect(),
            prepared: Vec::new(),
        }
    }
}

impl<T: Copy> Inputs<T> {
    /// The inputs as those of a tape.
    pub fn of_tape(&self) -> tape::Inputs<'_, T> {
        tape::Inputs {
            t: self.time,
            x: &self.states,
            p: &self.parameters,
            prepared: &self.prepared,
            marker: &self.marker,
        }
    }
}

/// A scalar type with which compiled programs are evaluated. The provided methods decide branches by the real value.
pub trait Arithmetic: Real {
    /// The scalar `then` if this scalar is 0, else the scalar `otherwise`.
    fn if_zero(self, then: Self, otherwise: Self) -> Self {
        if self.re() == 0.0 { then } else { otherwise }
    }

    fn call(self, function: MathFunction, tables: &Tables) -> Self {
        let number = |yes: bool| Self::lit(if yes { 1.0 } else { 0.0 });
        match function {
            MathFunction::Abs => self.abs(),
            MathFunction::Sign if self.re() < 0.0 => -Self::one(),
            MathFunction::Sign | MathFunction::Heaviside => number(self.re() > 0.0),
            MathFunction::NonZero => number(self.re() != 0.0),
            MathFunction::Table(function) => {
                let (origin, [c0, c1, c2, c3]) = tables.of(function).piece(self.re());
                let h = self - Self::lit(origin);
                let c = |c| Self::lit(c);
                ((c(c3) * h + c(c2)) * h + c(c1)) * h + c(c0)
            }
            _ => {
                let function = Elementary::named(function.name());
                self.elementary(function.expect("a function of the oracle"))
            }
        }
    }

    /// Value of a table of two arguments at (`self`, `other`), or of its derivative.
    fn looked_up(self, other: Self, function: TableFunction<2>, tables: &Tables) -> Self {
        let bicubic = tables.table(function.table()).bicubic();
        let ([x, y], cell) = bicubic.piece([self.re(), other.re()], function.orders());
        let (h, k) = (self - Self::lit(x), other - Self::lit(y));
        cell.rchunks(4).fold(Self::zero(), |value, row| {
            let powers = row.iter().rev();
            value * h + powers.fold(Self::zero(), |value, &c| value * k + Self::lit(c))
        })
    }

    fn least(self, other: Self) -> Self {
        if other.re() < self.re() { other } else { self }
    }

    fn greatest(self, other: Self) -> Self {
        if other.re() > self.re() { other } else { self }
    }
}

impl Arithmetic for Big {}
impl Arithmetic for ErrorBound {}

/// Evaluates a compiled program and returns its outputs.
pub fn outputs<T: Arithmetic>(program: &Program, inputs: &Inputs<T>) -> Vec<T> {
    let temps = evaluated(program, inputs);
    let outputs = program.outputs.iter();
    outputs
        .map(|&output| value(output, inputs, &temps))
        .collect()
}

/// Outputs of the given functions of a compiled model at a point.
pub fn results<'a, T: Arithmetic>(
    compiled: &Compiled,
    functions: impl IntoIterator<Item = &'a Function>,
    point: &Point<T>,
) -> Vec<(&'a Function, Vec<T>)> {
    let mut inputs = Inputs::of(point);
    inputs.prepared = outputs(&compiled.prepare.program, &inputs);
    let functions = functions.into_iter();
    functions
        .map(|function| (function, outputs(&function.program, &inputs)))
        .collect()
}

fn evaluated<T: Arithmetic>(program: &Program, inputs: &Inputs<T>) -> Vec<T> {
    let mut temps = Vec::with_capacity(program.statements.len());
    for statement in &program.statements {
        let next = step(&program.tables, statement.op, |operand| {
            value(operand, inputs, &temps)
        });
        temps.push(next);
    }
    temps
}

fn value<T: Real>(operand: Operand, inputs: &Inputs<T>, temps: &[T]) -> T {
    match operand {
        Operand::Time => inputs.time,
        Operand::State(i) => inputs.states[i as usize],
        Operand::Parameter(i) => inputs.parameters[i as usize],
        Operand::Prepared(i) => inputs.prepared[i as usize],
        Operand::Marker(i) => inputs.marker[i as usize],
        Operand::Constant(c) => T::lit(c),
        Operand::Temp(i) => temps[i as usize],
    }
}

fn step<T: Arithmetic>(tables: &Tables, op: Op, value: impl Fn(Operand) -> T) -> T {
    match op {
        Op::Unary(op, a) => {
            let a = value(a);
            match op {
                Unary::Neg => -a,
                Unary::Recip => T::one() / a,
                Unary::RecipOrZero => a.if_zero(T::zero(), T::one() / a),
                Unary::Call(function) => a.call(function, tables),
            }
        }
        Op::Binary(op, a, b) => {
            let (a, b) = (value(a), value(b));
            match op {
                Binary::Add => a + b,
                Binary::Sub => a - b,
                Binary::Mul => a * b,
                Binary::Div => a / b,
                Binary::Call(BinaryFunction::Atan2) => a.atan2(b),
                Binary::Call(BinaryFunction::Table(function)) => a.looked_up(b, function, tables),
                Binary::Call(BinaryFunction::Min) => a.least(b),
                Binary::Call(BinaryFunction::Max) => a.greatest(b),
            }
        }
        Op::Fused(op, a, b, c) => {
            let (product, c) = (value(a) * value(b), value(c));
            match op {
                Fused::MulAdd => product + c,
                Fused::MulSub => product - c,
                Fused::NegMulAdd => c - product,
            }
        }
        Op::IfZero(a, then, otherwise) => value(a).if_zero(value(then), value(otherwise)),
    }
}

/// Whether an exponential in one of the functions of a compiled model is a number beyond the range of `f64` at a point.
pub fn exponential_overflows(compiled: &Compiled, point: &Point<f64>) -> bool {
    let is_exponential = |op| matches!(op, Op::Unary(Unary::Call(MathFunction::Exp), _));
    let programs = compiled.functions().map(|function| &function.program);
    let prepare = &compiled.prepare.program;
    overflowing(prepare, programs, point, is_exponential).is_some()
}

/// Outputs of programs, which read the results of `prepare`, computed in 256 bits; `None` unless the result of one of the
/// operations `of` is a number beyond the range of `f64`, so that what `f64` gives may be anything.
pub fn overflowing<'a>(
    prepare: &Program,
    programs: impl IntoIterator<Item = &'a Program>,
    point: &Point<f64>,
    of: impl Fn(Op) -> bool,
) -> Option<Vec<Vec<f64>>> {
    with_numbers(|| {
        let mut inputs = Inputs::<Big>::of(&point.lift());
        inputs.prepared = outputs(prepare, &inputs);
        let mut overflows = false;
        let each = programs.into_iter().map(|program| {
            let temps = evaluated(program, &inputs);
            let mut steps = program.statements.iter().zip(&temps);
            overflows |= steps.any(|(statement, value)| {
                of(statement.op) && value.is_finite() && value.re().is_infinite()
            });
            let outputs = program.outputs.iter();
            outputs
                .map(|&output| self::value(output, &inputs, &temps).re())
                .collect()
        });
        let each: Vec<Vec<f64>> = each.collect();
        overflows.then_some(each)
    })
}

/// Minimum distance from a branch point, relative to the magnitude of the terms, at which rounding decides nothing.
const BRANCH_DISTANCE: f64 = 1e-9;

/// Quantity that is 0 at the branch point of an operation and changes sign there; `None` without branches.
fn gap<T: Real>(op: Op, of: impl Fn(Operand) -> T) -> Option<T> {
    match op {
        Op::Unary(Unary::RecipOrZero, a) | Op::IfZero(a, ..) => Some(of(a)),
        Op::Unary(Unary::Call(function), a) => match function {
            MathFunction::Abs
            | MathFunction::Sign
            | MathFunction::Heaviside
            | MathFunction::NonZero
            | MathFunction::Sqrt
            | MathFunction::Log => Some(of(a)),
            MathFunction::Asin => Some((T::one() - of(a)) * (T::one() + of(a))),
            _ => None,
        },
        Op::Binary(Binary::Call(BinaryFunction::Min | BinaryFunction::Max), a, b) => {
            Some(of(a) - of(b))
        }
        _ => None,
    }
}

/// Outputs in 256-bit arithmetic, with the magnitudes of their terms. `None` if rounding may decide a branch; if
/// `is_exact`, not at a branch point itself.
fn long_outputs(
    program: &Program,
    exact: &Inputs<Big>,
    bounds: &Inputs<ErrorBound>,
    is_exact: bool,
) -> Option<Vec<(Big, ErrorBound)>> {
    let (long, short) = (evaluated(program, exact), evaluated(program, bounds));
    let exactly = |operand| value(operand, exact, &long);
    let bounded = |operand| value(operand, bounds, &short);
    let is_near =
        |x: ErrorBound| x.magnitude > 0.0 && x.value.abs() <= BRANCH_DISTANCE * x.magnitude;
    let undecided = program.statements.iter().any(|statement| {
        let is_zero = || gap(statement.op, exactly).is_some_and(|gap| gap.is_zero());
        gap(statement.op, bounded).is_some_and(is_near) && !(is_exact && is_zero())
    });
    let outputs = program.outputs.iter();
    (!undecided).then(|| outputs.map(|&o| (exactly(o), bounded(o))).collect())
}

/// A function and its outputs in 256-bit arithmetic, with the magnitudes of their terms.
type LongResults<'a> = (&'a Function, Vec<(Big, ErrorBound)>);

/// Outputs of functions in 256-bit arithmetic, see [`long_outputs`].
pub fn long_results<'a>(
    compiled: &Compiled,
    functions: impl IntoIterator<Item = &'a Function>,
    point: &Point<f64>,
    is_exact: bool,
) -> Option<Vec<LongResults<'a>>> {
    let (mut exact, mut bounds) = (Inputs::of(&point.lift()), Inputs::of(&point.lift()));
    let prepare = &compiled.prepare.program;
    let prepared = long_outputs(prepare, &exact, &bounds, is_exact)?;
    (exact.prepared, bounds.prepared) = prepared.into_iter().unzip();
    let each = functions.into_iter().map(|function| {
        let values = long_outputs(&function.program, &exact, &bounds, is_exact)?;
        Some((function, values))
    });
    each.collect()
}
