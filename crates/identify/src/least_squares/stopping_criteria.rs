//! When an iteration stops, and why it did.

/// Termination criteria of the least squares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoppingCriteria {
    /// Predicted reduction of the sum of squares below which a step is negligible.
    pub ftol_abs: f64,
    /// The same as a fraction of the sum of squares.
    pub ftol_rel: f64,
    /// A step is accepted without evaluating the residuals after it if its predicted reduction is at most this many
    /// times negligible, and that of the following step would be negligible.
    pub accept_unevaluated: f64,
    /// Steps after which the iteration stops.
    pub max_steps: usize,
}

impl StoppingCriteria {
    /// For whitened residuals: an unevaluated last step is at most one standard error long, and the remaining error
    /// about a thirtieth of one.
    pub const CONVERGED: StoppingCriteria = StoppingCriteria {
        ftol_abs: 1e-3,
        ftol_rel: 1e-11,
        accept_unevaluated: 1e3,
        max_steps: 100,
    };
    /// For intermediate fits, after which the weights change.
    pub const COARSE: StoppingCriteria = StoppingCriteria {
        ftol_abs: 1e-2,
        ftol_rel: 1e-3,
        accept_unevaluated: 1e3,
        max_steps: 30,
    };
    /// For fits over a short horizon, before a longer one.
    pub const HORIZON: StoppingCriteria = StoppingCriteria {
        ftol_rel: 1e-2,
        accept_unevaluated: f64::INFINITY,
        ..StoppingCriteria::COARSE
    };
    /// One step, accepted without evaluating the residuals after it.
    pub const SINGLE_STEP: StoppingCriteria = StoppingCriteria {
        ftol_abs: f64::INFINITY,
        max_steps: 1,
        ..StoppingCriteria::COARSE
    };

    /// Whether a predicted reduction is negligible against a sum of squares.
    pub(super) fn is_negligible(&self, predicted_reduction: f64, squares: f64) -> bool {
        predicted_reduction <= self.ftol_abs.max(self.ftol_rel * squares)
    }

    /// Whether a step may be accepted unevaluated as the last: it is negligible, or the next will be, extrapolating the
    /// ratio of this predicted reduction to the previous one.
    pub(super) fn is_reached(
        &self,
        predicted_reduction: f64,
        previous: Option<f64>,
        squares: f64,
    ) -> bool {
        let next = previous.map_or(f64::INFINITY, |previous| {
            predicted_reduction * (predicted_reduction / previous)
        });
        self.is_negligible(predicted_reduction, squares)
            || self.is_negligible(predicted_reduction / self.accept_unevaluated, squares)
                && self.is_negligible(next, squares)
    }
}

/// Why an iteration stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// The predicted reduction of the last step was negligible.
    Converged,
    /// [`StoppingCriteria::max_steps`] was reached.
    MaxSteps,
    /// No step decreased the sum of squares, even with the greatest damping.
    NoDescent,
}
