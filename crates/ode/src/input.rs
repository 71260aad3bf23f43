//! Validation of the arguments of an integration, and construction of integration errors.

use crate::method::combine;
use crate::method::simd::{AllFinite, MIN_SIMD_LEN};
use crate::{IntegrationError, IntegrationFailure, IntegrationOptions, OdeRhs, StateVector};

pub(crate) fn first_non_finite<X: StateVector>(x: &X) -> Option<usize> {
    let x = x.as_ref();
    // First a test without branches, since this function runs for every step.
    let is_finite = match x.len() < MIN_SIMD_LEN {
        true => x.iter().fold(true, |all, v| all & v.is_finite()),
        false => lanes::dispatch(AllFinite(x)),
    };
    if is_finite {
        return None;
    }
    x.iter().position(|v| !v.is_finite())
}

/// Checks an integration's input: finite initial state and times, forward time, positive tolerances and step bounds.
#[cold]
pub(crate) fn check_input<D: OdeRhs>(
    rhs: &D,
    t: f64,
    x: &D::State,
    t_end: f64,
    options: &IntegrationOptions,
) -> Result<(), IntegrationError> {
    let invalid = |what: String, value: f64| {
        Err(IntegrationError {
            time: t,
            states: Vec::new(),
            cause: IntegrationFailure::InvalidInput { what, value },
        })
    };
    if let Some(i) = first_non_finite(x) {
        return invalid(format!("the initial {}", rhs.state_name(i)), x.as_ref()[i]);
    }
    for (what, value) in [("the initial time (s)", t), ("the final time (s)", t_end)] {
        if !value.is_finite() {
            return invalid(what.into(), value);
        }
    }
    match invalid_option(options, t_end - t) {
        Some((what, value)) => invalid(what.into(), value),
        None => Ok(()),
    }
}

/// Name and value of the first quantity among the duration, the tolerances and the step bounds that is not positive.
fn invalid_option(options: &IntegrationOptions, duration: f64) -> Option<(&'static str, f64)> {
    let positive = [
        ("the time from start to end (s)", duration),
        ("rtol", options.rtol),
        ("atol", options.atol),
        ("max_step (s)", options.max_step),
        ("first_step (s)", options.first_step.unwrap_or(1.0)),
    ];
    positive.into_iter().find(|(_, v)| v.is_nan() || *v <= 0.0)
}

pub(crate) fn is_valid(options: &IntegrationOptions, duration: f64) -> bool {
    invalid_option(options, duration).is_none()
}

/// Builds an integration error from the return code `cause`, the time and the state `x`.
#[cold]
pub(crate) fn failure<D: OdeRhs>(
    rhs: &D,
    time: f64,
    x: &[f64],
    cause: IntegrationFailure,
) -> IntegrationError {
    let components = x.iter().enumerate().take(rhs.error_controlled_len());
    IntegrationError {
        time,
        states: components
            .map(|(i, v)| (rhs.state_name(i).into_owned(), *v))
            .collect(),
        cause,
    }
}

#[cold]
pub(crate) fn non_finite_derivative<D: OdeRhs>(
    rhs: &D,
    t: f64,
    x: &D::State,
    i: usize,
    rate: f64,
) -> IntegrationError {
    let state = rhs.state_name(i).into_owned();
    failure(
        rhs,
        t,
        x.as_ref(),
        IntegrationFailure::NonFiniteDerivative { state, rate },
    )
}

/// Error for a step size `h` below the minimum. It is `NonFiniteDerivative` if the derivative is NaN or infinite after
/// an Euler step of size `h` or 1000 `h`.
#[cold]
pub(crate) fn step_too_small<D: OdeRhs>(
    rhs: &mut D,
    t: f64,
    x: &D::State,
    dx: &D::State,
    h: f64,
) -> IntegrationError {
    let (mut ahead, mut rate) = (x.clone(), dx.clone());
    for step in [h, 1e3 * h] {
        combine(&mut ahead, x, step, &[(0, 1.0)], std::slice::from_ref(dx));
        rhs.derivative(t + step, &ahead, &mut rate);
        if let Some(i) = first_non_finite(&rate) {
            return non_finite_derivative(rhs, t, x, i, rate.as_ref()[i]);
        }
    }
    let speed = |i: &usize| dx.as_ref()[*i].abs() / (x.as_ref()[*i].abs() + 1.0);
    let fastest = (0..dx.as_ref().len())
        .max_by(|a, b| speed(a).total_cmp(&speed(b)))
        .unwrap_or(0);
    let state = (rhs.state_name(fastest).into_owned(), dx.as_ref()[fastest]);
    failure(
        rhs,
        t,
        x.as_ref(),
        IntegrationFailure::StepTooSmall { step: h, state },
    )
}
