//! The body that stated equations are claimed to describe, moving as these equations state.

use crate::options::TOLERANCE;
use crate::subject::Subject;
use oracle::scalar::{Dual, ErrorBound, Field};
use oracle::{Balance, ClaimedBody, Point, Tree, derivatives_of, moving};

/// A value and its derivative with respect to true time, with bounds of the rounding error.
pub type Bounded = Dual<ErrorBound>;

/// The claimed body moving as the equations under test state; bounds of the derivatives are those of the vector tree.
/// `None` without a claim or equations.
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

/// Difference between both sides of a law, by component, relative to the magnitudes of the terms.
pub fn errors(balance: &Balance<ErrorBound>) -> [f64; 3] {
    let difference = balance.change - balance.cause;
    difference.map(|d| d.relative_error(0.0)).into()
}

/// Whether a relative error is too large to be due to rounding, or NaN.
pub fn is_fault(error: f64) -> bool {
    error.is_nan() || error > TOLERANCE
}
