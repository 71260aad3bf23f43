//! Evaluates programs of the compiler with any scalar type of the oracle.

use codegen::functions::MathFunction;
use codegen::program::{Binary, Fused, Op, Operand, Program, Unary};
use num_traits::Zero;
use oracle::Point;
use oracle::scalar::{Big, Elementary, ErrorBound, Real};

/// Inputs of a compiled program at a point, in the order of the compiled model's variables: time, states, parameters,
/// marker position.
pub struct Inputs<T> {
    time: T,
    states: Vec<T>,
    parameters: Vec<T>,
    marker: Vec<T>,
    /// Results of the program `prepare`, which computes values that depend on parameters only; empty for a program that
    /// does not read them.
    pub prepared: Vec<T>,
}

impl<T: Real> Inputs<T> {
    /// Converts the values of a point exactly to the scalar type `T`.
    pub fn of(point: &Point<f64>) -> Self {
        let all = |values: &[f64]| values.iter().map(|&v| T::lit(v)).collect();
        Self {
            time: T::lit(point.time),
            states: all(&point.states),
            parameters: all(&point.parameters()),
            marker: all(point.marker.as_slice()),
            prepared: Vec::new(),
        }
    }

    /// Returns the inputs with the parameter vector replaced by `parameters`.
    pub fn with_parameters(self, parameters: Vec<T>) -> Self {
        Self { parameters, ..self }
    }
}

/// Evaluates a compiled program with scalars of type `T` and returns its outputs.
pub fn outputs<T: Real>(program: &Program, inputs: &Inputs<T>) -> Vec<T> {
    let temps = evaluated(program, inputs);
    let outputs = program.outputs.iter();
    outputs
        .map(|&output| value(output, inputs, &temps))
        .collect()
}

/// Evaluates a compiled program with scalars of type `T` and returns the result of every statement of the program.
fn evaluated<T: Real>(program: &Program, inputs: &Inputs<T>) -> Vec<T> {
    let mut temps = Vec::with_capacity(program.statements.len());
    for statement in &program.statements {
        let next = step(program, statement.op, |operand| {
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

fn step<T: Real>(program: &Program, op: Op, value: impl Fn(Operand) -> T) -> T {
    match op {
        Op::Unary(op, a) => unary(program, op, value(a)),
        Op::Binary(op, a, b) => {
            let (a, b) = (value(a), value(b));
            match op {
                Binary::Add => a + b,
                Binary::Sub => a - b,
                Binary::Mul => a * b,
                Binary::Div => a / b,
                Binary::Atan2 => a.atan2(b),
                Binary::Min if b.re() < a.re() => b,
                Binary::Max if b.re() > a.re() => b,
                Binary::Min | Binary::Max => a,
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
        Op::IfZero(a, then, _) if value(a).re() == 0.0 => value(then),
        Op::IfZero(_, _, otherwise) => value(otherwise),
    }
}

fn unary<T: Real>(program: &Program, op: Unary, a: T) -> T {
    let number = |yes: bool| T::lit(if yes { 1.0 } else { 0.0 });
    match op {
        Unary::Neg => -a,
        Unary::RecipOrZero if a.re() == 0.0 => T::zero(),
        Unary::Recip | Unary::RecipOrZero => T::one() / a,
        Unary::Call(function) => match function {
            MathFunction::Abs => a.abs(),
            MathFunction::Sign if a.re() < 0.0 => -T::one(),
            MathFunction::Sign | MathFunction::Heaviside => number(a.re() > 0.0),
            MathFunction::NonZero => number(a.re() != 0.0),
            MathFunction::Table(function) => {
                let (origin, [c0, c1, c2, c3]) = program.tables.of(function).piece(a.re());
                let h = a - T::lit(origin);
                ((T::lit(c3) * h + T::lit(c2)) * h + T::lit(c1)) * h + T::lit(c0)
            }
            _ => {
                a.elementary(Elementary::named(function.name()).expect("a function of the oracle"))
            }
        },
    }
}

/// Minimum distance of an operation's argument from the branch point (such as 0 for abs) at which rounding cannot
/// change the result of the branch. It is relative to the magnitude of the argument's terms.
const BRANCH_DISTANCE: f64 = 1e-9;

/// Quantity that is 0 at the branch point of an operation and has different signs on its two sides: the argument for
/// abs and similar functions, a − b for the minimum or maximum of a and b, 1 − a² for asin a. `None` for an operation
/// without branches. `of` returns the value of an operand.
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
        Op::Binary(Binary::Min | Binary::Max, a, b) => Some(of(a) - of(b)),
        _ => None,
    }
}

/// Evaluates a program and returns its outputs with the magnitudes of their terms. `None` if rounding may change the
/// result of a branch, such as that of abs, because its argument is close to the branch point. If `exact` contains the
/// inputs for 256-bit arithmetic, arguments that equal the branch point in this arithmetic do not count as close.
pub fn magnitudes(
    program: &Program,
    inputs: &Inputs<ErrorBound>,
    exact: Option<&Inputs<Big>>,
) -> Option<Vec<ErrorBound>> {
    let temps = evaluated(program, inputs);
    let of = |operand| value(operand, inputs, &temps);
    let exact = exact.map(|exact| (exact, evaluated(program, exact)));
    let is_exactly_zero = |op| {
        exact.as_ref().is_some_and(|(inputs, temps)| {
            gap(op, |operand| value(operand, inputs, temps)).is_some_and(|gap| gap.is_zero())
        })
    };
    let undecided = program.statements.iter().any(|statement| {
        let is_near =
            |x: ErrorBound| x.magnitude > 0.0 && x.value.abs() <= BRANCH_DISTANCE * x.magnitude;
        gap(statement.op, of).is_some_and(is_near) && !is_exactly_zero(statement.op)
    });
    (!undecided).then(|| program.outputs.iter().map(|&output| of(output)).collect())
}
