//! Compares the equations under test with expected values that have error bounds.

use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::scalar::ErrorBound;

/// Callback that receives the error of a value and the name of the value. The error is relative to the sum of the
/// magnitudes of the terms that sum to the value.
pub(super) type ErrorSink<'a> = &'a mut dyn FnMut(f64, String);

/// Passes the error of each state derivative in `rates` to `errors`: its difference from the expected value, relative
/// to the sum of the magnitudes of the terms of the expected value. States with the indices in `except` are left out.
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

/// Passes the error of each component of the observation to `errors`: its difference from the expected value, relative
/// to the sum of the magnitudes of the terms of the expected value.
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
