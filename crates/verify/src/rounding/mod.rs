//! Measures rounding errors: f, J and Jp of every backend compared with the same programs in 256-bit arithmetic, and
//! the model statements that lose digits.
//!
//! Errors are measured in ulp of the magnitude of a value, that is, the spacing of f64 at the sum of the magnitudes of
//! the terms that make up the value ([`ErrorBound`]). Cancellation inherent in the formula is thus not counted as an
//! error of a backend. The model statement that causes it is listed separately, with the number of bits lost (see
//! [`statements`]).

mod points;
pub mod statements;
mod table;

use crate::checks::backends::{self, Run};
use crate::evaluation::long_results;
use crate::options::Options;
use crate::random::Random;
use crate::row::{Measure, Row, Verdict};
use crate::sample;
use crate::subject::Subject;
use codegen::Compiled;
use codegen::program::Function;
use oracle::Point;
use oracle::scalar::{Big, Real, with_numbers};
use serde::Serialize;
use statements::{Loss, REPORTED_BITS};

/// Name in reports of the check of rounding errors.
pub const ROUNDING: &str = "rounding";

/// Maximum allowed rounding error of a computed value, in units of the spacing of f64 numbers at the sum of the
/// magnitudes of a value's terms. It corresponds to 128 rounding errors of half a unit with the same sign.
pub const ALLOWED: f64 = 64.0;

/// Numbers of points at which the rounding errors of a model's code are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Number of random points.
    pub random: usize,
    /// Number of simulated flights, each starting from a random point.
    pub flights: usize,
    /// Maximum number of points sampled along each simulated flight.
    pub states: usize,
}

impl Effort {
    /// Numbers of points for the check of rounding errors that is part of every verification.
    pub const ROW: Effort = Effort {
        random: 12,
        flights: 2,
        states: 4,
    };
    /// Numbers of points for the detailed report of the command-line option `--rounding`.
    pub const DETAILS: Effort = Effort {
        random: 200,
        flights: 10,
        states: 20,
    };
}

/// Rounding errors of one group of outputs of a compiled function, such as its Jacobian, on one backend. The unit is
/// the spacing of f64 numbers (ulp) at the sum of the magnitudes of a value's terms.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Error {
    /// Name of the backend that computed the values.
    pub backend: String,
    /// Whether the backend computes with fused multiply-add operations.
    pub fuses: bool,
    /// Name of the compiled function whose results are compared.
    pub function: &'static str,
    /// Group of outputs of the function: `f` (state derivatives), `J`, `Jp` (their Jacobians with respect to states and
    /// parameters), `y` (observation), `dy/dx` or `dy/dp` (its Jacobians).
    pub values: &'static str,
    /// Number of values, over all outputs of the group and all points, that were compared with the exact values.
    pub compared: usize,
    /// Maximum error over the compared values, in units of the spacing of f64 numbers (ulp) at the sum of the
    /// magnitudes of a value's terms.
    pub worst: f64,
    /// Median error over the compared values, in units of the spacing of f64 numbers (ulp) at the sum of the magnitudes
    /// of a value's terms.
    pub median: f64,
    /// Name of the computed value with the maximum error.
    pub place: String,
}

/// Rounding errors of a model's compiled functions on all backends, and the bits that each statement of the model
/// loses.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rounding {
    /// Text that names the unit of the rounding errors in reports.
    pub measure: &'static str,
    /// Number of random points and number of states along flights that were drawn to measure rounding errors, including
    /// those counted in `left_out`.
    pub points: [usize; 2],
    /// Number of points left out because a value is not finite there, or because rounding may change the result of a
    /// branch, such as that of abs, whose argument is close to the branch point.
    pub left_out: usize,
    /// Rounding errors by backend, compiled function and group of outputs of the function, such as its Jacobian.
    pub errors: Vec<Error>,
    /// Statements of the model that lose bits, in descending order of the loss.
    pub losses: Vec<Loss>,
}

/// Text that names the unit of the rounding errors in reports.
const MEASURE: &str =
    "ulp of the magnitude: spacing of f64 at the sum of the magnitudes of the terms of a value";

/// Results of a compiled function at one point, computed with [`PRECISION`](oracle::scalar::PRECISION) bits.
struct Exact {
    /// Name of the function.
    name: &'static str,
    /// For each value: the f64 nearest to the exact value, the remainder exact − nearest, and the sum of the magnitudes
    /// of the value's terms.
    values: Vec<(f64, f64, f64)>,
}

/// Measures the rounding errors of every backend and the bits that every statement of the model loses.
pub fn measure(
    subject: &Subject<'_>,
    compiled: &Compiled,
    options: &Options,
    effort: Effort,
) -> Rounding {
    let mut random = Random::new(options.seed, ROUNDING);
    let mut at = sample::points(subject.model, effort.random, &mut random);
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

/// Rounding errors of each backend, by compiled function and group of its outputs, such as its Jacobian. Also returns
/// the number of points left out because a value is not finite there or because rounding may change the result of a
/// branch, such as that of abs.
pub fn errors(compiled: &Compiled, points: &[Point<f64>], runs: &[Run]) -> (Vec<Error>, usize) {
    let exact: Vec<Option<Vec<Exact>>> = points.iter().map(|p| exact(compiled, p)).collect();
    let left_out = exact.iter().filter(|e| e.is_none()).count();
    let mut errors = Vec::new();
    for run in runs {
        for function in compiled.functions() {
            for (values, range) in sections(function) {
                let points = exact.iter().zip(&run.results);
                let pairs = points.filter_map(|(exact, results)| {
                    let exact = exact.as_ref()?.iter().find(|e| e.name == function.name)?;
                    let results = backends::results_of(compiled, results, function.name);
                    Some(exact.values.iter().zip(results).enumerate())
                });
                let pairs = pairs.flatten().filter(|(k, _)| range.contains(k));
                let errors_of = pairs.map(|(k, (exact, &got))| (error(*exact, got), k));
                let mut all: Vec<(f64, usize)> = errors_of.collect();
                sort_largest_first(&mut all);
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

/// Sorts pairs (error, index) by decreasing error, and equal errors by index.
fn sort_largest_first(errors: &mut [(f64, usize)]) {
    errors.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
}

/// Creates the result of the check of rounding errors for the verification report. The check holds if no backend's
/// error exceeds [`ALLOWED`]. Statements of the model that lose digits are listed in a remark.
pub fn row(rounding: &Rounding) -> Row {
    let [random, flown] = rounding.points;
    let cases = random + flown - rounding.left_out;
    // `max_by` returns the last of equal elements; the reversal selects the first.
    let worst = rounding
        .errors
        .iter()
        .rev()
        .max_by(|a, b| a.worst.total_cmp(&b.worst));
    let Some(worst) = worst.filter(|_| cases > 0) else {
        return Row::unverified(ROUNDING, "rounding may decide a branch at every point");
    };
    let median = rounding.errors.iter().map(|e| e.median).fold(0.0, f64::max);
    let (place, backend) = (&worst.place, &worst.backend);
    let detail = format!("{place} by {backend}; medians up to {median:.2}");
    let row = Row {
        cases,
        worst: worst.worst,
        measure: Measure::Magnitude,
        tolerance: ALLOWED,
        verdict: Verdict::of(worst.worst <= ALLOWED),
        ..Row::skipped(ROUNDING, detail)
    };
    let lossy: Vec<String> = rounding
        .losses
        .iter()
        .filter(|loss| loss.bits >= REPORTED_BITS)
        .map(Loss::sentence)
        .collect();
    if lossy.is_empty() {
        row
    } else {
        row.with_remark(lossy.join("\n"))
    }
}

/// Evaluates in 256-bit arithmetic, at one point, the compiled functions whose rounding errors are measured: those of
/// the state derivatives, the observation and their Jacobians. `None` if a value is not finite, or if rounding may
/// change the result of a branch, such as that of abs.
fn exact(compiled: &Compiled, point: &Point<f64>) -> Option<Vec<Exact>> {
    let functions = compiled.functions().into_iter();
    let measured = functions.filter(|function| !sections(function).is_empty());
    with_numbers(|| {
        let all = long_results(compiled, measured, point, false)?.into_iter();
        let all = all.map(|(function, values)| {
            let values = values.into_iter().map(|(value, bound)| {
                let rounded = value.re();
                (rounded, (value - Big::lit(rounded)).re(), bound.magnitude)
            });
            let values: Vec<(f64, f64, f64)> = values.collect();
            let mut finite = values.iter().map(|v| v.0.is_finite() && v.2.is_finite());
            let name = function.name;
            finite.all(|f| f).then_some(Exact { name, values })
        });
        all.collect()
    })
}

/// Error of the computed result `got`, in units of the spacing of f64 numbers at the sum of the magnitudes of the
/// result's terms. The first argument describes the exact result as a tuple: (exact value rounded to f64, exact −
/// rounded, sum of the magnitudes of the terms).
fn error((rounded, rest, magnitude): (f64, f64, f64), got: f64) -> f64 {
    // The subtraction is exact for close values (Sterbenz); for others its rounding does not matter.
    let error = (got - rounded - rest).abs();
    if error == 0.0 {
        return 0.0;
    }
    let size = magnitude.max(rounded.abs()).max(f64::MIN_POSITIVE);
    let error = error / (size.next_up() - size);
    if error.is_nan() { f64::INFINITY } else { error }
}

/// Groups of outputs of a compiled function (such as state derivatives and Jacobian) whose rounding errors are
/// measured: name in tables, and index range in the outputs.
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
