//! Compares all of f, J, Jp and the observation in 256-bit arithmetic: the compiled functions with the vector tree of
//! the declared law and its dual numbers, at states of the model. Only constants that the code rounds to f64 may cause
//! differences.

use super::function_rows::{differences, functions, law, variables};
use crate::evaluation::long_results;
use crate::random::Random;
use crate::sample;
use codegen::Compiled;
use codegen::program::Function;
use model_spec::model::Model;
use oracle::Point;
use oracle::scalar::{Big, Dual, ErrorBound, Lockstep, Real, with_numbers};

/// Number of points, so that functions are likely to be compared on every branch.
const POINTS: usize = 8;
const MAX_DRAWS: usize = 30;
/// Maximum difference, relative to the magnitude of the terms: a thousand times that of a constant rounded to f64.
const TOLERANCE: f64 = 1e-13;

/// A 256-bit number with the sum of the magnitudes of its terms.
type Bounded = Lockstep<Big, ErrorBound>;

/// Names of the values and derivatives that differ; `None` if rounding may decide a branch at every drawn point.
pub fn faults(model: &Model, compiled: &Compiled, random: &mut Random) -> Option<Vec<String>> {
    let (mut faults, mut compared) = (Vec::new(), 0);
    for _ in 0..MAX_DRAWS {
        if compared == POINTS || !faults.is_empty() {
            break;
        }
        let point = sample::point(model, random);
        if let Some(found) = with_numbers(|| at(model, compiled, &point)) {
            compared += 1;
            faults.extend(found);
        }
    }
    faults.sort();
    faults.dedup();
    (compared > 0).then_some(faults)
}

/// Names of the values and derivatives that differ at a point; `None` if rounding may decide a branch there.
fn at(model: &Model, compiled: &Compiled, point: &Point<f64>) -> Option<Vec<String>> {
    let results = long_results(compiled, functions(compiled), point, true)?.into_iter();
    let results = results.map(|(function, values)| {
        let values = values.into_iter().map(bounded);
        (function, values.collect())
    });
    let results: Vec<(&Function, Vec<Bounded>)> = results.collect();
    let (exact, bounds) = (point.lift::<Big>(), point.lift::<ErrorBound>());
    let exact_variables = variables(model, compiled, &exact.states);
    let bound_variables = variables(model, compiled, &bounds.states);
    let mut faults = Vec::new();
    for (exact_variable, bound_variable) in exact_variables.into_iter().zip(bound_variables) {
        let values = law(model, &exact, &exact_variable)?;
        let terms = law(model, &bounds, &bound_variable)?;
        let expected = values.into_iter().zip(terms).map(|(value, terms)| Dual {
            value: bounded((value.value, terms.value)),
            derivative: bounded((value.derivative, terms.derivative)),
        });
        let directions = { exact_variable.direction.iter() }.zip(&bound_variable.direction);
        let directions = directions.map(|(&value, &terms)| bounded((value, terms)));
        let variable = exact_variable.along(directions.collect());
        let expected: Vec<Dual<Bounded>> = expected.collect();
        faults.extend(differences(model, &results, &variable, &expected, &differ));
    }
    Some(faults)
}

fn bounded((first, second): (Big, ErrorBound)) -> Bounded {
    Lockstep { first, second }
}

fn differ(found: Bounded, expected: Bounded) -> bool {
    let terms = [found.second, expected.second];
    if !terms.iter().all(|terms| terms.value.is_finite()) {
        // Terms beyond the range of `f64` may cancel by more than 256 bits.
        return false;
    }
    let difference = (found.first - expected.first).re().abs();
    let size = expected.first.re().abs();
    let size = size.max(found.second.magnitude);
    let size = size.max(expected.second.magnitude);
    difference.is_nan() || difference > TOLERANCE * size.max(ErrorBound::NEGLIGIBLE)
}
