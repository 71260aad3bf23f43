//! Bounds and prior of a global parameter.

/// Box constraint and Gaussian prior of a global parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// Least and greatest value; infinite if unbounded.
    pub bounds: (f64, f64),
    /// Mean and standard deviation of the Gaussian prior; `None` without a prior.
    pub prior: Option<(f64, f64)>,
}

impl Constraint {
    /// No bounds and no prior.
    pub const NONE: Constraint = Constraint {
        bounds: (f64::NEG_INFINITY, f64::INFINITY),
        prior: None,
    };

    /// Squared residual of the prior at a value; 0 without a prior.
    pub(super) fn squares(&self, value: f64) -> f64 {
        let squares = |(mean, sigma): (f64, f64)| ((value - mean) / sigma).powi(2);
        self.prior.map_or(0.0, squares)
    }
}
