//! Exact arithmetic for all of f, J, Jp and the observation: the compiled functions are compared with the vector tree
//! of the declared law and its dual numbers, at random points of the field of integers modulo 2^61 − 1. Roots, polar
//! angles, sines and cosines satisfy their algebraic relations in the field; other functions are uninterpreted symbols
//! of their arguments. Branches and rounded constants, which the field cannot decide, are compared in 256-bit
//! arithmetic at states of the model.

use super::exact::POINTS;
use super::function_rows::{differences, functions, law, variables};
use super::long_functions;
use crate::evaluation::results;
use crate::field::{self, FieldPoint};
use crate::options::Options;
use crate::random::Random;
use crate::row::Row;
use crate::symbolic::{Symbolic, evaluate};
use codegen::Compiled;
use codegen::functions::MathFunction;
use codegen::program::{Binary, Op, Operand, Unary};
use model_spec::model::Model;
use oracle::scalar::Dual;

/// Name of this check in reports: compiled state derivatives f, Jacobians J (states) and Jp (parameters) and
/// observation, compared in exact arithmetic with the model's vector expressions.
pub const FUNCTIONS: &str = "f, J and Jp, exact";

/// Maximum number of random trial points of the prime field. A trial point is usable only if the argument of every
/// square root is a square in the field.
const MAX_TRIALS: usize = 4096;

/// Upper bound of the total degree of the compared functions, as polynomials in variables and transcendental function
/// values. The probability that different functions agree at a random point of the prime field follows from it
/// (Schwartz-Zippel lemma).
const DEGREE: f64 = 1e4;
/// Number of random points of the prime field after which the compiled code is reported to contain another square root
/// than the model. Only points are counted at which all square roots in the model's vector expressions exist in the
/// field, but one in the compiled code does not.
const LACKING: usize = 64;

/// Compares the state derivatives f, the Jacobians J (states) and Jp (parameters) and the observation of a compiled
/// model with the model's vector expressions, and returns the result of this check.
pub fn check(model: &Model, compiled: &Compiled, options: &Options) -> Row {
    let mut random = Random::new(options.seed, FUNCTIONS);
    let mut faults: Vec<String> = Vec::new();
    let (mut good, mut lacking) = (0, 0);
    for _ in 0..MAX_TRIALS {
        if good == POINTS || lacking == LACKING || !faults.is_empty() {
            break;
        }
        let mut spot = FieldPoint::random(model, &mut random);
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

/// Result of the check for functions that cannot be compared in the prime field, for the reason `why`. The result is
/// refuted if the compiled code and the model's vector expressions differ in 256-bit arithmetic. Otherwise it is
/// skipped, with `why` as the detail.
fn in_long_arithmetic(model: &Model, compiled: &Compiled, options: &Options, why: &str) -> Row {
    let mut random = Random::new(options.seed, "f, J and Jp in 256 bits");
    match long_functions::faults(model, compiled, &mut random) {
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
    /// Names of the values and derivatives in which the compiled code and the model's vector expressions differ; empty
    /// if all agree.
    At(Vec<String>),
    /// The model's vector expressions have no value in the prime field, because the argument of a square root is not a
    /// square there.
    NoLaw,
    /// The compiled code has no value in the prime field, because the argument of a square root is not a square there,
    /// although the model's vector expressions have values.
    NoCode,
}

fn compare(model: &Model, compiled: &Compiled, spot: &FieldPoint) -> Compared {
    evaluate(spot, true, |point| {
        let results = results(compiled, functions(compiled), point);
        let exists = |value: Symbolic| value.0.is_some();
        let is_complete = results.iter().all(|(_, v)| v.iter().all(|&v| exists(v)));
        let mut faults = Vec::new();
        for variable in variables(model, compiled, &point.states) {
            let expected = law(model, point, &variable).unwrap_or_default();
            let both = |row: &Dual<Symbolic>| exists(row.value) && exists(row.derivative);
            if expected.is_empty() || !expected.iter().all(both) {
                return Compared::NoLaw;
            }
            if !is_complete {
                return Compared::NoCode;
            }
            let differ = |found, expected| found != expected;
            faults.extend(differences(model, &results, &variable, &expected, &differ));
        }
        faults.sort();
        faults.dedup();
        Compared::At(faults)
    })
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
