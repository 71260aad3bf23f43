//! When an iteration stops, and why it did.

/// Termination criteria of the least squares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoppingCriteria {
    /// Predicted reduction of the sum of squares below which a step is negligible.
    pub ftol_abs: f64,
    /// Predicted reduction, as a fraction of the sum of squares, below which a step is negligible.
    pub ftol_rel: f64,
    /// Greatest predicted reduction, in multiples of a negligible one, of a final step accepted without evaluating
    /// its residuals; the next step must also be predicted to be negligible.
    pub accept_unevaluated: f64,
    /// Greatest number of steps.
    pub max_steps: usize,
    /// Sum of squares above which an iteration that advances slowly is given up; infinite for never.
    pub worthwhile_squares: f64,
}

/// Steps that an iteration may take before it is given up.
const MIN_STEPS: usize = 8;

/// Predicted reduction, as a fraction of the sum of squares, below which an iteration advances slowly.
const SLOW: f64 = 0.1;

impl StoppingCriteria {
    /// Criteria for whitened residuals: an unevaluated last step is at most one standard error long, which leaves an
    /// error of about 1/30 standard error.
    pub const CONVERGED: StoppingCriteria = StoppingCriteria {
        ftol_abs: 1e-3,
        ftol_rel: 1e-11,
        accept_unevaluated: 1e3,
        max_steps: 100,
        worthwhile_squares: f64::INFINITY,
    };
    /// Criteria for a model that leaves far more than the noise: its steps become small slowly, and where they end
    /// within a fraction of a standard error means nothing.
    pub const MISFIT: StoppingCriteria = StoppingCriteria {
        ftol_rel: 1e-4,
        max_steps: 40,
        ..StoppingCriteria::CONVERGED
    };
    /// Criteria for intermediate fits, after which the weights change.
    pub const COARSE: StoppingCriteria = StoppingCriteria {
        ftol_abs: 1e-2,
        ftol_rel: 1e-3,
        accept_unevaluated: 1e3,
        max_steps: 30,
        worthwhile_squares: f64::INFINITY,
    };
    /// Criteria for fits over a short horizon, before a longer one.
    pub const HORIZON: StoppingCriteria = StoppingCriteria {
        ftol_rel: 1e-2,
        accept_unevaluated: f64::INFINITY,
        ..StoppingCriteria::COARSE
    };
    /// Criteria for the local parameters at given global ones, between two steps of all.
    pub const REFINEMENT: StoppingCriteria = StoppingCriteria {
        max_steps: 8,
        ..StoppingCriteria::COARSE
    };
    /// Criteria for one step, accepted without evaluating its residuals.
    pub const SINGLE_STEP: StoppingCriteria = StoppingCriteria {
        ftol_abs: f64::INFINITY,
        max_steps: 1,
        ..StoppingCriteria::COARSE
    };

    /// Whether a predicted reduction is negligible relative to a sum of squares.
    pub(super) fn is_negligible(&self, predicted_reduction: f64, squares: f64) -> bool {
        predicted_reduction <= self.ftol_abs.max(self.ftol_rel * squares)
    }

    /// Whether to give up after some steps, far from a sum of squares that would be worthwhile.
    pub(super) fn is_hopeless(&self, steps: usize, predicted_reduction: f64, squares: f64) -> bool {
        steps >= MIN_STEPS
            && squares > self.worthwhile_squares
            && predicted_reduction < SLOW * squares
    }

    /// Whether a step may be accepted unevaluated as the last: its predicted reduction is negligible, or that of the
    /// next step will be, by extrapolating the ratio to the previous one.
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
    /// The iteration advanced slowly above [`StoppingCriteria::worthwhile_squares`].
    GivenUp,
    /// The deadline passed.
    Deadline,
}
