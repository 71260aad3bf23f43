//! Runge–Kutta methods as rows of weights, for loops over stages.

use super::Method;

/// Sparse row of weights: (stage, weight).
pub(crate) type Row = &'static [(usize, f64)];

/// An explicit Runge–Kutta method whose last stage is the derivative at the end of the step.
pub(crate) struct Tableau {
    pub method: Method,
    /// Time of each stage as a fraction of the step.
    pub c: &'static [f64],
    /// Row k leads to the argument of stage k + 1; that of the last stage is the state at the end of the step.
    pub rows: &'static [Row],
    /// Rows of further stages, for dense output alone.
    pub dense_rows: &'static [Row],
    /// Weights of the error estimates: one, or those of orders 5 and 3 of DOP853.
    pub errors: &'static [Row],
    /// Order of the error estimate in the step size.
    pub error_order: i32,
    /// Exponent of the previous error in the PI controller.
    pub pi_beta: f64,
    /// Minimum and maximum ratio of successive step sizes.
    pub step_factor_bounds: (f64, f64),
}

impl Tableau {
    /// Stages of a step, that at its end included.
    pub(crate) fn stages(&self) -> usize {
        self.rows.len() + 1
    }
}
