//! Exact arithmetic for all of f, J, Jp and the observation: the compiled functions are compared with the vector tree
//! of the declared law and its dual numbers, at random points of the field of integers modulo 2^61 − 1. Roots, polar
//! angles, sines and cosines satisfy their algebraic relations in the field; other functions are uninterpreted symbols
//! of their arguments. Branches and rounded constants, which the field cannot decide, are compared in 256-bit
//! arithmetic at states of the model.

use super::derivatives::tree_column;
use super::exact::{POINTS, Spot};
use super::function_rows::{along, direction, row_name, sections};
use super::long_functions;
use crate::Options;
use crate::field::{self, Angle, Machine};
use crate::random::Random;
use crate::row::Row;
use crate::symbolic::{Symbolic, evaluate};
use codegen::Compiled;
use codegen::functions::MathFunction;
use codegen::program::{Binary, Function, Op, Operand, Unary};
use model_spec::model::Model;
use num_traits::One;
use oracle::Point;
use oracle::scalar::{Dual, Prime};

/// Name of this check in reports: state derivatives f, Jacobians J (states) and Jp (parameters) and the observation in
/// exact arithmetic.
pub const FUNCTIONS: &str = "f, J and Jp, exact";

/// Maximum number of random trial points of the prime field. A trial point is usable only if the argument of every
/// square root is a square in the field.
const MAX_TRIALS: usize = 4096;

/// Upper bound of the total degree of the compared functions, as polynomials in variables and transcendental function
/// values. The probability that different functions agree at a random point of the prime field follows from it
/// (Schwartz-Zippel lemma).
const DEGREE: f64 = 1e4;
/// Number of trial points after which the compiled code is reported to contain a root that differs from those of the
/// model's vector expressions. Only points are counted at which all square roots of the vector expressions exist in the
/// prime field, but one of the compiled code does not.
const LACKING: usize = 64;

/// Compares the state derivatives f, the Jacobians J (states) and Jp (parameters) and the observation of a compiled
/// model with the model's vector expressions, and returns the row of the report.
pub fn check(model: &Model, compiled: &Compiled, options: &Options) -> Row {
    let mut random = Random::new(options.seed, FUNCTIONS);
    let mut faults: Vec<String> = Vec::new();
    let (mut good, mut lacking) = (0, 0);
    for _ in 0..MAX_TRIALS {
        if good == POINTS || lacking == LACKING || !faults.is_empty() {
            break;
        }
        let mut spot = Spot::random(model, &mut random);
        let circles = spot.point.states.iter().map(|&s| field::circle(s));
        spot.circles = circles.collect();
        match compare(model, compiled, &spot) {
            Compared::At(found) => {
                good += 1;
                faults = found;
            }
            Compared::NoCode => lacking += 1,
            Compared::NoLaw => {}
        }
    }
    if faults.is_empty() && good < POINTS {
        if lacking < LACKING {
            let why = "roots exist together at too few points of the field";
            return in_long_arithmetic(model, compiled, options, why);
        }
        faults.push(String::from(
            "roots in the code do not exist where those of the law do",
        ));
    }
    if let Some(why) = undecided(compiled).filter(|_| !faults.is_empty()) {
        return in_long_arithmetic(model, compiled, options, why);
    }
    // The fraction of points at which all roots exist is at least 1 / MAX_TRIALS.
    let chance = DEGREE * MAX_TRIALS as f64 / 2f64.powi(61);
    let chance = POINTS as f64 * chance.log10();
    let says = format!("identical but for a chance below 1e{chance:.0}");
    Row::counted(FUNCTIONS, good, &faults, &says)
}

/// Row of the report for functions that cannot be compared in the prime field, for the reason `why`. The row is refuted
/// if the compiled code and the model's vector expressions differ in 256-bit arithmetic. Otherwise it is skipped, with
/// `why` as the detail.
fn in_long_arithmetic(model: &Model, compiled: &Compiled, options: &Options, why: &str) -> Row {
    let mut random = Random::new(options.seed, "f, J and Jp in 256 bits");
    match long_functions::differences(model, compiled, &mut random) {
        Some(faults) if !faults.is_empty() => Row::counted(FUNCTIONS, 1, &faults, ""),
        Some(_) => Row::skipped(
            FUNCTIONS,
            format!("not decided exactly, by {why}; equal in 256 bits but for rounded constants"),
        ),
        None => Row::skipped(FUNCTIONS, format!("not decided, by {why}")),
    }
}

/// Result of comparing compiled code with the model's vector expressions (the law) at one point of the prime field.
enum Compared {
    /// Names of the values and Jacobian entries in which compiled code and law differ; empty if all agree.
    At(Vec<String>),
    /// A value of the model's vector expressions (the law) does not exist in the field.
    NoLaw,
    /// A value of the compiled code does not exist in the field, although all values of the model's vector expressions
    /// do.
    NoCode,
}

fn compare(model: &Model, compiled: &Compiled, spot: &Spot) -> Compared {
    let mut machine = Machine::new(&spot.point, &spot.circles, true);
    machine.prepared = machine.run(&compiled.prepare.program);
    let functions = [
        &compiled.f,
        &compiled.f_jac,
        &compiled.f_jac_par,
        &compiled.observe,
        &compiled.observe_jac,
    ];
    let states = model.states.len();
    let values: Option<Vec<(&Function, Vec<Prime>)>> = functions
        .into_iter()
        .map(|function| {
            let values = machine.run(&function.program);
            Some((function, values.into_iter().collect::<Option<_>>()?))
        })
        .collect();
    let variables = compiled
        .layout
        .states
        .iter()
        .chain(&compiled.layout.parameters);
    let mut faults = Vec::new();
    for (j, name) in variables.enumerate() {
        let direction = direction(model, &spot.point.states, j);
        let Some(expected) = law(model, spot, j, &direction) else {
            return Compared::NoLaw;
        };
        let Some(values) = &values else {
            return Compared::NoCode;
        };
        for (function, values) in values {
            let (rows, section, jacobians) = sections(function, states, expected.len());
            let first = function.range(section).start;
            for (k, row) in rows.enumerate() {
                let (value, derivative) = expected[row];
                let row = row_name(model, row);
                if values[first + k] != value {
                    faults.push(format!("{row} in {}", function.name));
                }
                let found = along(function, values, jacobians, k, j, &direction);
                if found.is_some_and(|found| found != derivative) {
                    faults.push(format!("∂{row}/∂{name} in {}", function.name));
                }
            }
        }
    }
    faults.sort();
    faults.dedup();
    Compared::At(faults)
}

/// Every state derivative and component of the observation, from the model's vector expressions over the prime field,
/// each as (value, derivative with respect to the variable with the given index: states first, then parameters; for a
/// state, along `direction` in state space). `None` if a value does not exist in the field.
fn law(
    model: &Model,
    spot: &Spot,
    variable: usize,
    direction: &[Prime],
) -> Option<Vec<(Prime, Prime)>> {
    type T = Dual<Symbolic>;
    let mut point: Point<T> = spot.point.map(|v| Dual::constant(Symbolic(v)));
    for (state, &d) in point.states.iter_mut().zip(direction) {
        state.derivative = Symbolic(d);
    }
    if let Some(k) = variable.checked_sub(model.states.len())
        && let Some(value) = point.parameters_mut().nth(k)
    {
        value.derivative = Symbolic(Prime::one());
    }
    let states = spot.point.states.iter().zip(&spot.circles);
    let angles: Vec<Angle> = states.map(|(&s, &circle)| (s, circle)).collect();
    let rows = evaluate(angles, || tree_column(model, &point))??;
    Some(
        rows.iter()
            .map(|row| (row.value.0, row.derivative.0))
            .collect(),
    )
}

/// Reason why different values in the prime field do not prove that the compiled code and the model's vector
/// expressions differ; `None` if they prove it. The reason is that the code contains branches or rounded constants. The
/// field represents these by pseudo-random elements, so that equal functions may have different values.
fn undecided(compiled: &Compiled) -> Option<&'static str> {
    let statements = compiled
        .functions()
        .into_iter()
        .flat_map(|f| &f.program.statements);
    for statement in statements {
        let branches = match statement.op {
            Op::Unary(Unary::Call(function), _) => matches!(
                function,
                MathFunction::Abs
                    | MathFunction::Sign
                    | MathFunction::Heaviside
                    | MathFunction::Asin
            ),
            Op::Binary(op, ..) => matches!(op, Binary::Min | Binary::Max),
            _ => false,
        };
        if branches {
            return Some("functions with branches");
        }
        let is_rounded = |operand| match operand {
            Operand::Constant(c) => !field::is_exact(c),
            _ => false,
        };
        if statement.op.operands().into_iter().any(is_rounded) {
            return Some("numbers that are rounded");
        }
    }
    None
}
