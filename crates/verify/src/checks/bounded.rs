//! Compares the equations under test with expected values that have error bounds.

use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::scalar::ErrorBound;

/// Receives errors, each relative to the sum of the magnitudes of the terms of a value, with the name of the value.
pub(super) type ErrorSink<'a> = &'a mut dyn FnMut(f64, String);

/// Passes the error of each state derivative in `rates`, relative to its expected value with error bound, to `errors`.
/// The states with indices `except` are left out.
pub(super) fn compare_rates(
    model: &Model,
    expected: &[ErrorBound],
    rates: &[f64],
    except: &[usize],
    errors: ErrorSink<'_>,
) {
    for (i, expected) in expected.iter().enumerate() {
        if !except.contains(&i) {
            let rate = rates.get(i);
            let error = rate.map_or(f64::INFINITY, |&rate| expected.relative_error(rate));
            errors(error, format!("der({})", model.states[i].name));
        }
    }
}

/// Passes the error of each component of the observation, relative to its expected value with error bound, to `errors`.
pub(super) fn compare_observation(
    expected: &Vector3<ErrorBound>,
    observed: &Vector3<f64>,
    errors: ErrorSink<'_>,
) {
    for (expected, observed) in expected.iter().zip(observed) {
        let error = expected.relative_error(*observed);
        errors(error, String::from("the observation"));
    }
}
