//! Butcher tableaux of Runge–Kutta methods, as sparse rows of weights for loops over stages.

use super::Method;

/// Sparse row of weights: (stage index, weight) of each nonzero.
pub(crate) type Row = &'static [(usize, f64)];

/// Butcher tableau of an explicit Runge–Kutta method whose last stage is the derivative at the end of the step.
pub(crate) struct Tableau {
    pub method: Method,
    /// Time of each stage as a fraction of the step.
    pub c: &'static [f64],
    /// Rows of the Runge–Kutta matrix: row k gives the argument of stage k + 1, counted from 0. The argument of the
    /// last stage is the state at the end of the step.
    pub rows: &'static [Row],
    /// Rows of the Runge–Kutta matrix for the additional stages that only dense output requires.
    pub dense_rows: &'static [Row],
    /// Weights of the error estimates: one row for Tsit5; for DOP853 the rows of orders 5 and 3.
    pub errors: &'static [Row],
    /// Order q of the error estimate, which is proportional to h^q, where h is the step size.
    pub error_order: i32,
    /// Exponent of the previous step's error norm in the PI step-size controller.
    pub pi_beta: f64,
    pub step_factor_bounds: (f64, f64),
}

impl Tableau {
    /// Number of stages of a step, including the derivative at the end of the step.
    pub(crate) fn stages(&self) -> usize {
        self.rows.len() + 1
    }
}
