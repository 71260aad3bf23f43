//! Measures rounding errors: f, J and Jp of every backend compared with the same programs in 256-bit arithmetic, and
//! the model statements that lose digits.
//!
//! Errors are measured in ulp of the magnitude of a value, that is, the spacing of f64 at the sum of the magnitudes of
//! the terms that make up the value. Cancellation inherent in the formula is thus not counted as an
//! error of a backend. The model statement that causes it is listed separately, with the number of bits lost (see
//! [`statements`]).

pub mod statements;

use crate::checks::backends::{self, Run};
use crate::evaluation::long_results;
use crate::integration;
pub use crate::options::ALLOWED;
use crate::options::Options;
use crate::random::Random;
use crate::row::{Measure, Row, Verdict, plain_table};
use crate::sample::{self, is_valid, typical};
use crate::subject::Subject;
use codegen::Compiled;
use codegen::program::Function;
use ode::IntegrationOptions;
use oracle::Point;
use oracle::scalar::{Big, ErrorBound, Real, with_numbers};
use serde::Serialize;
use statements::{Loss, REPORTED_BITS};

/// Name in reports of the check of rounding errors.
pub const ROUNDING: &str = "rounding";

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
    /// Numbers of points of the row of a report.
    pub const ROW: Effort = Effort {
        random: 12,
        flights: 2,
        states: 4,
    };
    /// Numbers of points of the option `--rounding`.
    pub const DETAILS: Effort = Effort {
        random: 200,
        flights: 10,
        states: 20,
    };
}

/// Rounding errors of one group of outputs of a compiled function on one backend, ulp of the magnitude.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Error {
    /// Name of the backend that computed the values.
    pub backend: String,
    /// Whether the backend computes with fused multiply-add operations.
    pub fuses: bool,
    /// Name of the compiled function whose results are compared.
    pub function: &'static str,
    /// Group of outputs: `f`, `J`, `Jp` (Jacobians by states and parameters), `y` (observation), `dy/dx` or `dy/dp`.
    pub values: &'static str,
    /// Number of compared values, over all outputs and points.
    pub compared: usize,
    /// Maximum error, ulp of the magnitude.
    pub worst: f64,
    /// Median error, ulp of the magnitude.
    pub median: f64,
    /// Name of the computed value with the maximum error.
    pub place: String,
}

/// Rounding errors of a model on all backends, and the bits that each statement loses.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rounding {
    /// Text that names the unit of the rounding errors in reports.
    pub measure: &'static str,
    /// Numbers of random points and of states along flights, those in `left_out` included.
    pub points: [usize; 2],
    /// Number of points left out because a value is not finite or rounding may decide a branch.
    pub left_out: usize,
    /// Rounding errors by backend, function and group of outputs.
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
    /// For each value: the nearest f64, exact − nearest, and the sum of the magnitudes of the terms.
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
    let flown = flown(subject, effort.flights, effort.states, &mut random);
    let counts = [at.len(), flown.len()];
    let named = |what: &str, points: &[Point<f64>]| -> Vec<(String, Point<f64>)> {
        let each = points.iter().enumerate();
        each.map(|(k, point)| (format!("{what} {}", k + 1), point.clone()))
            .collect()
    };
    let mut places = named("random point", &at);
    places.extend(named("state of a flight", &flown));
    places.extend(near_zero(subject, &mut random));
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

/// Rounding errors of each backend, and the number of points left out for infinities and undecided branches.
pub fn errors(compiled: &Compiled, points: &[Point<f64>], runs: &[Run]) -> (Vec<Error>, usize) {
    let at_points = |is_exact: bool| -> Vec<Option<Vec<Exact>>> {
        let each = points.iter().map(|point| exact(compiled, point, is_exact));
        each.collect()
    };
    let mut exact = at_points(false);
    if exact.iter().all(Option::is_none) {
        // A saturated function is at its branch point everywhere; there both are exact.
        exact = at_points(true);
    }
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

/// Row of a report: holds if no error exceeds [`ALLOWED`]; a remark lists statements that lose digits.
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

/// Measured functions in 256-bit arithmetic; `None` if a value is not finite or rounding may decide a branch; if
/// `is_exact`, not at a branch point itself.
fn exact(compiled: &Compiled, point: &Point<f64>, is_exact: bool) -> Option<Vec<Exact>> {
    let functions = compiled.functions().into_iter();
    let measured = functions.filter(|function| !sections(function).is_empty());
    with_numbers(|| {
        let all = long_results(compiled, measured, point, is_exact)?.into_iter();
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

/// Error of the result `got`, ulp of the magnitude; the other argument is one of [`Exact::values`].
fn error((rounded, rest, magnitude): (f64, f64, f64), got: f64) -> f64 {
    // The subtraction is exact for close values (Sterbenz); for others its rounding does not matter.
    let error = (got - rounded - rest).abs();
    if error == 0.0 {
        return 0.0;
    }
    let size = magnitude.max(rounded.abs()).max(ErrorBound::NEGLIGIBLE);
    let error = error / (size.next_up() - size);
    if error.is_nan() { f64::INFINITY } else { error }
}

/// Measured groups of outputs of a function: name in tables, and index range.
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

const LISTED: usize = 10;

impl Loss {
    /// Sentence on the loss: file, line, name, bits and point.
    pub fn sentence(&self) -> String {
        format!(
            "{}, line {}: `{}` loses {:.0} of 53 bits at {} (median {:.0}): {}",
            self.source, self.line, self.name, self.bits, self.place, self.median_bits, self.text
        )
    }
}

impl Rounding {
    /// Tables of the rounding errors, one for backends with equal errors, and the statements that lose digits.
    pub fn table(&self) -> String {
        let [random, flown] = self.points;
        let mut text = format!(
            "Rounding errors against arithmetic of {} bits, in {MEASURE}.\n{random} random points and {flown} states of \
             flights; {} left out, where rounding may decide a branch.\n",
            oracle::scalar::PRECISION,
            self.left_out
        );
        let mut groups: Vec<(Vec<&str>, Vec<&Error>)> = Vec::new();
        let mut rest = self.errors.as_slice();
        while let Some(first) = rest.first() {
            let (own, after) = rest.split_at(rest.partition_point(|e| e.backend == first.backend));
            rest = after;
            let same = groups.iter_mut().find(|(_, errors)| {
                errors.len() == own.len() && errors.iter().zip(own).all(|(a, b)| is_same(a, b))
            });
            match same {
                Some((backends, _)) => backends.push(&first.backend),
                None => groups.push((vec![&first.backend], own.iter().collect())),
            }
        }
        for (backends, errors) in groups {
            let mut table = plain_table(&[
                "function", "values", "compared", "worst", "median", "worst at",
            ]);
            for error in errors {
                table.add_row(vec![
                    error.function.to_owned(),
                    error.values.to_owned(),
                    error.compared.to_string(),
                    format!("{:.2}", error.worst),
                    format!("{:.3}", error.median),
                    error.place.clone(),
                ]);
            }
            text.push_str(&format!("\n{}\n{table}\n", backends.join(", ")));
        }
        if self.losses.is_empty() {
            text.push_str("\nNo statement of the model loses a bit.\n");
            return text;
        }
        text.push_str(&format!(
            "\nStatements by the bits that they lose (named in the report from {REPORTED_BITS} bits):\n"
        ));
        for loss in self.losses.iter().take(LISTED) {
            text.push_str(&format!("  {}\n", loss.sentence()));
        }
        text
    }
}

/// Whether two records of rounding errors are equal except for the name of the backend.
fn is_same(a: &Error, b: &Error) -> bool {
    let without = |e: &Error| Error {
        backend: String::new(),
        ..e.clone()
    };
    without(a) == without(b)
}

/// Duration of each flight along which states are sampled, s.
const DURATION: f64 = 0.5;
const MAX_STEPS: usize = 2_000;
const MAX_STARTS: usize = 4;
/// Values of a state near 0, relative to its typical magnitude.
const NEAR_ZERO: [f64; 2] = [1e-3, 1e-7];

/// Points along flights from random points, at most `each` per flight, within the validity limits.
fn flown(
    subject: &Subject<'_>,
    flights: usize,
    each: usize,
    random: &mut Random,
) -> Vec<Point<f64>> {
    let mut points = Vec::new();
    for _ in 0..flights {
        let flight = (0..MAX_STARTS)
            .map(|_| flight(subject, sample::near(subject.model, random), each))
            .find(|flight| !flight.is_empty());
        points.extend(flight.unwrap_or_default());
    }
    points
}

/// Points along a flight at intervals of `DURATION / count`, without the start, until it fails or leaves the limits.
fn flight(subject: &Subject<'_>, mut at: Point<f64>, count: usize) -> Vec<Point<f64>> {
    let points = (0..count).map_while(|_| {
        at = flown_on(subject, &at, DURATION / count as f64)?;
        is_valid(subject.model, &at).then(|| at.clone())
    });
    points.collect()
}

/// Point reached after `seconds`; `None` if the integration fails or a state is not finite.
fn flown_on(subject: &Subject<'_>, from: &Point<f64>, seconds: f64) -> Option<Point<f64>> {
    let options = IntegrationOptions {
        max_steps: MAX_STEPS,
        ..IntegrationOptions::with_tolerance(1e-6)
    };
    let rates = |at: &Point<f64>| subject.equations.rates(at);
    let end = integration::fly(&rates, from, seconds, &options).ok()?;
    end.states.iter().all(|v| v.is_finite()).then_some(end)
}

/// Random points, with descriptions, at which one state is near 0.
fn near_zero(subject: &Subject<'_>, random: &mut Random) -> Vec<(String, Point<f64>)> {
    let mut points = Vec::new();
    for (index, state) in subject.model.states.iter().enumerate() {
        for small in NEAR_ZERO {
            let mut point = sample::near(subject.model, random);
            let value = small * typical(state.unit) * random.between(0.5, 1.0);
            point.states[index] = value;
            if is_valid(subject.model, &point) {
                points.push((format!("{} = {value:.1e}", state.name), point));
            }
        }
    }
    points
}
