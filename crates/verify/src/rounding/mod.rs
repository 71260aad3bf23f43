//! Rounding: f, J and Jp of every backend against the same programs in 256 bits, and the statements that lose digits.
//!
//! An error is measured in ulp of the magnitude of a value: the spacing of f64 at the sum of the magnitudes of the terms
//! that make it up ([`ErrorBound`]). Cancellation that the formula asks for is no fault of a backend; the statement of
//! the model that does it is named apart, with the bits that it loses (see [`statements`]).

pub(crate) mod big;
mod points;
pub(crate) mod program;
pub mod statements;
mod table;

use crate::Options;
use crate::checks::backends::{self, Run};
use crate::random::Random;
use crate::row::{Measure, Row, Verdict};
use crate::subject::Subject;
use big::{Big, with_numbers};
use codegen::Compiled;
use codegen::program::Function;
use oracle::Point;
use oracle::scalar::{ErrorBound, Real};
use program::{Inputs, magnitudes, outputs};
use serde::Serialize;
use statements::{LOSES, Loss};

/// Name of the check.
pub const ROUNDING: &str = "rounding";

/// Largest allowed error, ulp of the magnitude: 128 roundings of half an ulp, all in one direction.
pub const ALLOWED: f64 = 64.0;

/// Numbers of points of a measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Random points.
    pub random: usize,
    /// Flights from random points.
    pub flights: usize,
    /// States of each flight.
    pub states: usize,
}

impl Effort {
    /// Points of the row of every verification.
    pub const ROW: Effort = Effort {
        random: 12,
        flights: 2,
        states: 4,
    };
    /// Points of `--rounding`.
    pub const DETAILS: Effort = Effort {
        random: 200,
        flights: 10,
        states: 20,
    };
}

/// Rounding errors of one function of one backend, in ulp of the magnitude of each value.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Error {
    /// Name of the backend.
    pub backend: String,
    /// Whether the backend fuses multiply and add.
    pub fuses: bool,
    /// Name of the function.
    pub function: &'static str,
    /// Values: `f`, `J`, `Jp`, `y` or `dy`.
    pub values: &'static str,
    /// Number of compared values.
    pub compared: usize,
    /// Largest error.
    pub worst: f64,
    /// Median error.
    pub median: f64,
    /// Name of the value with the largest error.
    pub place: String,
}

/// Rounding errors of a model.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rounding {
    /// Meaning of the errors.
    pub measure: &'static str,
    /// Number of random points and of states of flights.
    pub points: [usize; 2],
    /// Number of points that were left out: rounding may decide a branch there, or a value is not finite.
    pub left_out: usize,
    /// Errors by backend and function.
    pub errors: Vec<Error>,
    /// Statements of the model that lose bits, the worst first.
    pub losses: Vec<Loss>,
}

/// Meaning of the errors, in words.
const MEASURE: &str =
    "ulp of the magnitude: spacing of f64 at the sum of the magnitudes of the terms of a value";

/// Values of a function in [`big::PRECISION`] bits at one point.
struct Exact {
    /// Place of the function among [`Compiled::functions`].
    function: usize,
    /// Of each value: rounded to f64, what this rounding left, and the magnitude of its terms.
    values: Vec<(f64, f64, f64)>,
}

/// Measures the rounding errors of every backend and of every statement.
pub fn measure(
    subject: &Subject<'_>,
    compiled: &Compiled,
    options: &Options,
    effort: Effort,
) -> Rounding {
    let mut random = Random::new(options.seed, ROUNDING);
    let mut at = points::random(subject, effort.random, &mut random);
    let flown = points::flown(subject, effort.flights, effort.states, &mut random);
    let counts = [at.len(), flown.len()];
    let named = |what: &str, points: &[Point<f64>]| -> Vec<(String, Point<f64>)> {
        let each = points.iter().enumerate();
        each.map(|(k, point)| (format!("{what} {}", k + 1), point.clone()))
            .collect()
    };
    let mut places = named("random point", &at);
    places.extend(named("state of a flight", &flown));
    places.extend(points::near_zero(subject, &mut random));
    at.extend(flown);
    let runs = backends::runs(subject.model, compiled, &at);
    let (errors, left_out) = errors(compiled, &at, &runs);
    Rounding {
        measure: MEASURE,
        points: counts,
        left_out,
        errors,
        losses: statements::losses(subject.model, &places),
    }
}

/// Errors of runs at the points, and the number of points that were left out.
pub fn errors(compiled: &Compiled, points: &[Point<f64>], runs: &[Run]) -> (Vec<Error>, usize) {
    let exact: Vec<Option<Vec<Exact>>> = points.iter().map(|p| exact(compiled, p)).collect();
    let left_out = exact.iter().filter(|e| e.is_none()).count();
    let mut errors = Vec::new();
    for run in runs {
        for (index, function) in compiled.functions().into_iter().enumerate() {
            for (values, range) in sections(function) {
                let mut all: Vec<(f64, usize)> = Vec::new();
                for (exact, results) in exact.iter().zip(&run.results) {
                    let Some(exact) = exact else { continue };
                    let Some(exact) = exact.iter().find(|e| e.function == index) else {
                        continue;
                    };
                    let start = offset(compiled, index);
                    for k in range.clone() {
                        let Some(&got) = results.get(start + k) else {
                            continue;
                        };
                        all.push((error(exact.values[k], got), k));
                    }
                }
                all.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
                let Some(&(worst, place)) = all.first() else {
                    continue;
                };
                errors.push(Error {
                    backend: run.backend.clone(),
                    fuses: run.fuses,
                    function: function.name,
                    values,
                    compared: all.len(),
                    worst,
                    median: all[all.len() / 2].0,
                    place: function.results.get(place).cloned().unwrap_or_default(),
                });
            }
        }
    }
    (errors, left_out)
}

/// Row of the measured errors: holds where no backend exceeds [`ALLOWED`]; statements that lose digits are a remark.
pub fn row(rounding: &Rounding) -> Row {
    let [random, flown] = rounding.points;
    let cases = random + flown - rounding.left_out;
    // The first of equal ones.
    let worst = rounding
        .errors
        .iter()
        .rev()
        .max_by(|a, b| a.worst.total_cmp(&b.worst));
    let Some(worst) = worst.filter(|_| cases > 0) else {
        return Row::unverified(ROUNDING, "rounding may decide a branch at every point");
    };
    let median = rounding.errors.iter().map(|e| e.median).fold(0.0, f64::max);
    let row = Row {
        check: ROUNDING,
        cases,
        worst: worst.worst,
        measure: Measure::Magnitude,
        tolerance: ALLOWED,
        verdict: if worst.worst <= ALLOWED {
            Verdict::Holds
        } else {
            Verdict::Refuted
        },
        detail: format!(
            "{} by {}; medians up to {median:.2}",
            worst.place, worst.backend
        ),
        remark: None,
    };
    let lossy: Vec<String> = rounding
        .losses
        .iter()
        .filter(|loss| loss.bits >= LOSES)
        .map(Loss::sentence)
        .collect();
    if lossy.is_empty() {
        row
    } else {
        row.remarking(lossy.join("\n"))
    }
}

/// Values of the functions that are compared; `None` where a value is not finite or rounding may decide a branch.
fn exact(compiled: &Compiled, point: &Point<f64>) -> Option<Vec<Exact>> {
    with_numbers(|| {
        let mut bounds: Inputs<ErrorBound> = Inputs::of(point);
        let (prepared, undecided) = magnitudes(&compiled.prepare.program, &bounds, None);
        bounds.prepared = prepared;
        if undecided {
            return None;
        }
        let mut inputs: Inputs<Big> = Inputs::of(point);
        inputs.prepared = outputs(&compiled.prepare.program, &inputs);
        let mut all = Vec::new();
        for (index, function) in compiled.functions().into_iter().enumerate() {
            if sections(function).is_empty() {
                continue;
            }
            let (bounds, undecided) = magnitudes(&function.program, &bounds, None);
            if undecided {
                return None;
            }
            let values = outputs(&function.program, &inputs);
            let values: Vec<(f64, f64, f64)> = values
                .into_iter()
                .zip(bounds)
                .map(|(value, bound)| {
                    let rounded = value.re();
                    (rounded, (value - Big::lit(rounded)).re(), bound.magnitude)
                })
                .collect();
            let finite = |v: &(f64, f64, f64)| v.0.is_finite() && v.2.is_finite();
            if !values.iter().all(finite) {
                return None;
            }
            all.push(Exact {
                function: index,
                values,
            });
        }
        Some(all)
    })
}

/// Error of a result, ulp of the magnitude of its terms.
fn error((rounded, rest, magnitude): (f64, f64, f64), got: f64) -> f64 {
    // Exact for neighbours, by Sterbenz; farther away the rounding does not matter.
    let error = (got - rounded - rest).abs();
    if error == 0.0 {
        return 0.0;
    }
    let size = magnitude.max(rounded.abs()).max(f64::MIN_POSITIVE);
    let error = error / (size.next_up() - size);
    if error.is_nan() { f64::INFINITY } else { error }
}

/// Sections of a function that are compared: what they are called, and their places among the results.
fn sections(function: &Function) -> Vec<(&'static str, std::ops::Range<usize>)> {
    let names: &[(&'static str, &str)] = match function.name {
        "f" => &[("f", "dx")],
        "f_jac" => &[("f", "dx"), ("J", "j")],
        "f_jac_par" => &[("f", "dx"), ("J", "j"), ("Jp", "jp")],
        "observe" => &[("y", "y")],
        "observe_jac" => &[("y", "y"), ("dy/dx", "dy_dx"), ("dy/dp", "dy_dp")],
        _ => &[],
    };
    let ranges = names
        .iter()
        .map(|&(says, name)| (says, function.range(name)));
    ranges.filter(|(_, range)| !range.is_empty()).collect()
}

/// Place of the first result of a function among the concatenated results.
fn offset(compiled: &Compiled, index: usize) -> usize {
    let before = compiled.functions().into_iter().take(index);
    before.map(|f| f.program.outputs.len()).sum()
}
