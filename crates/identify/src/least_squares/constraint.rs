//! Bounds and prior of a global parameter.

/// Bounds and Gaussian prior of a global parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// Lower and upper bound; infinite if the parameter is unbounded.
    pub bounds: (f64, f64),
    /// Mean and standard deviation of the Gaussian prior; `None` without a prior.
    pub prior: Option<(f64, f64)>,
}

impl Constraint {
    /// Constraint without bounds and prior.
    pub const NONE: Constraint = Constraint {
        bounds: (f64::NEG_INFINITY, f64::INFINITY),
        prior: None,
    };

    /// Squared distance of a value from the prior mean, in prior standard deviations; 0 without a prior.
    pub(super) fn squares(&self, value: f64) -> f64 {
        let squares = |(mean, sigma): (f64, f64)| ((value - mean) / sigma).powi(2);
        self.prior.map_or(0.0, squares)
    }
}
