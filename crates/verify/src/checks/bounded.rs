//! Compares the equations under test with expected values that have error bounds.

use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::scalar::ErrorBound;

/// Receives errors, each relative to the sum of the magnitudes of the terms of a value, with the name of the value.
pub(super) type ErrorSink<'a> = &'a mut dyn FnMut(f64, String);

/// Compares the derivatives `rates` of the states with the expected ones. The states `except` are left out.
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

/// Compares the components of an observation with the expected ones.
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
