//! The body that stated equations are claimed to describe, moving as these equations state.

use crate::TOLERANCE;
use crate::row::Worst;
use crate::subject::Subject;
use nalgebra::Vector3;
use oracle::scalar::{Dual, ErrorBound, Field};
use oracle::{ClaimedBody, Point, Tree, derivatives_of, moving};

/// Dual numbers along the motion: a value and its derivative with respect to the time of flight, each with an error
/// bound.
pub type Bounded = Dual<ErrorBound>;

/// The claimed body at a point, with the rates implied by the model's own equations; `None` if the model claims no body
/// or has no equations to evaluate. The values of the rates are from the equations under test, the magnitudes from the
/// terms in the vector tree.
pub fn along(subject: &Subject<'_>, point: &Point<f64>) -> Option<ClaimedBody<Bounded>> {
    subject.model.claim.as_ref()?;
    let lifted = point.lift::<ErrorBound>();
    let tree = Tree::new(subject.model, &lifted);
    let pace = tree.clock();
    let bounds = derivatives_of(&tree).ok()?;
    let rates = subject.equations.rates(point);
    if rates.len() != bounds.len() {
        return None;
    }
    let rates: Vec<ErrorBound> = rates
        .into_iter()
        .zip(bounds)
        .map(|(value, bound)| {
            let magnitude = bound.magnitude.max(value.abs());
            ErrorBound { value, magnitude } / pace
        })
        .collect();
    let point = moving(&lifted, &rates, ErrorBound::integer(1) / pace);
    ClaimedBody::of(&Tree::new(subject.model, &point))
}

/// Compares a change with its cause by component, relative to the magnitudes of their terms, and updates `worst`.
/// `what` is the name of the law.
pub fn see(
    worst: &mut Worst,
    change: &Vector3<ErrorBound>,
    cause: &Vector3<ErrorBound>,
    what: &str,
) {
    for (change, cause) in change.iter().zip(cause.iter()) {
        worst.see(relative(*change - *cause), || what.to_owned());
    }
}

/// Absolute value of a difference relative to the magnitude of its terms; infinite if it is NaN.
pub fn relative(difference: ErrorBound) -> f64 {
    if difference.value == 0.0 {
        return 0.0;
    }
    let error = difference.value.abs() / difference.magnitude.max(f64::MIN_POSITIVE);
    if error.is_nan() { f64::INFINITY } else { error }
}

/// Whether a relative error is larger than rounding explains.
pub fn is_fault(error: f64) -> bool {
    error.is_nan() || error > TOLERANCE
}
