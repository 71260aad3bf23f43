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
use codegen::functions::{BinaryFunction, MathFunction};
use codegen::program::{Binary, Op, Operand, Unary};
use model_spec::model::Model;
use oracle::scalar::Dual;

/// Name of this check in reports.
pub const FUNCTIONS: &str = "f, J and Jp, exact";

/// Maximum number of trial points of the prime field: roots do not exist at all of them.
const MAX_TRIALS: usize = 4096;

/// Upper bound of the total degree of the compared functions.
const DEGREE: f64 = 1e4;
/// Number of points, at which roots of the law exist but one of the code does not, after which the code is refuted.
const LACKING: usize = 64;

/// Compares f, J, Jp and the observation of a compiled model with its vector expressions.
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

/// Comparison in 256-bit arithmetic where the prime field cannot decide, for the reason `why`: refuted or skipped.
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

/// Comparison at one point of the prime field.
enum Compared {
    /// Names of the values and derivatives that differ.
    At(Vec<String>),
    /// A root of the vector expressions does not exist.
    NoLaw,
    /// A root of the code does not exist, but those of the vector expressions do.
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

/// Why different values prove nothing: branches and rounded constants are symbols in the field.
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
            Op::Binary(Binary::Call(function), ..) => {
                matches!(function, BinaryFunction::Min | BinaryFunction::Max)
            }
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
