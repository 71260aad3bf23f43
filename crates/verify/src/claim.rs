//! The body that stated equations are claimed to describe, moving as these equations state.

use crate::options::TOLERANCE;
use crate::subject::Subject;
use oracle::scalar::{Dual, ErrorBound, Field};
use oracle::{Balance, ClaimedBody, Point, Tree, derivatives_of, moving};

/// A value and its derivative with respect to the time of flight, each with a bound of the rounding error.
pub type Bounded = Dual<ErrorBound>;

/// Quantities, at a point, of the body that the model claims to describe, with their time derivatives according to the
/// equations under test. `None` if the model makes no such claim or its equations cannot be evaluated. The error bounds
/// of the derivatives are computed from the terms of the model's vector expressions.
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

/// Difference between both sides of a law of motion, component by component, relative to the magnitudes of the terms.
pub fn errors(balance: &Balance<ErrorBound>) -> [f64; 3] {
    let difference = balance.change - balance.cause;
    difference.map(|d| d.relative_error(0.0)).into()
}

/// Whether an error, relative to the sum of the magnitudes of the terms of a value, is too large to be due to rounding,
/// or is NaN.
pub fn is_fault(error: f64) -> bool {
    error.is_nan() || error > TOLERANCE
}
