//! Termination criteria of an iteration, and the reason why it stopped.

/// Criteria by which the least-squares iteration stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoppingCriteria {
    /// Predicted reduction of the sum of squares by a step, below which the step is negligible.
    pub ftol_abs: f64,
    /// Predicted reduction of the sum of squares by a step, as a fraction of the sum of squares, below which the step
    /// is negligible.
    pub ftol_rel: f64,
    /// Upper limit of the predicted reduction of a last step that is accepted without evaluating its residuals, in
    /// units of the negligible reduction (see `ftol_abs` and `ftol_rel`). The step after it must be predicted to be
    /// negligible.
    pub accept_unevaluated: f64,
    /// Maximum number of least-squares steps.
    pub max_steps: usize,
    /// Sum of squares above which an iteration with slow progress is stopped; infinite if it is never stopped for this
    /// reason.
    pub worthwhile_squares: f64,
}

/// Minimum number of steps before an iteration is stopped because of slow progress.
const MIN_STEPS: usize = 8;

/// Predicted reduction by a step, as a fraction of the sum of squares, below which the progress of an iteration is
/// considered slow.
const SLOW: f64 = 0.1;

impl StoppingCriteria {
    /// Criteria for the final fit of whitened residuals. An unevaluated last step has a length of at most one standard
    /// error, which leaves an error of about 1/30 standard error.
    pub const CONVERGED: StoppingCriteria = StoppingCriteria {
        ftol_abs: 1e-3,
        ftol_rel: 1e-11,
        accept_unevaluated: 1e3,
        max_steps: 100,
        worthwhile_squares: f64::INFINITY,
    };
    /// Criteria for a model whose residuals are far larger than the noise. The steps of its fit decrease slowly, and
    /// the exact solution, within a fraction of a standard error, is meaningless.
    pub const MISFIT: StoppingCriteria = StoppingCriteria {
        ftol_rel: 1e-4,
        max_steps: 40,
        ..StoppingCriteria::CONVERGED
    };
    /// Criteria for intermediate fits, after which the weights of the residuals are computed again.
    pub const COARSE: StoppingCriteria = StoppingCriteria {
        ftol_abs: 1e-2,
        ftol_rel: 1e-3,
        accept_unevaluated: 1e3,
        max_steps: 30,
        worthwhile_squares: f64::INFINITY,
    };
    /// Criteria for fits whose result is the starting point of another fit, to a longer part of the flights or with a
    /// smaller scale of the robust loss.
    pub const HORIZON: StoppingCriteria = StoppingCriteria {
        ftol_rel: 1e-2,
        accept_unevaluated: f64::INFINITY,
        ..StoppingCriteria::COARSE
    };
    /// Criteria for a refinement of the local parameters at fixed global parameters, between two steps of all unknowns.
    pub const REFINEMENT: StoppingCriteria = StoppingCriteria {
        max_steps: 8,
        ..StoppingCriteria::COARSE
    };
    /// Criteria for a single step that is accepted without evaluating its residuals.
    pub const SINGLE_STEP: StoppingCriteria = StoppingCriteria {
        ftol_abs: f64::INFINITY,
        max_steps: 1,
        ..StoppingCriteria::COARSE
    };

    /// Whether a predicted reduction is negligible relative to a sum of squares.
    pub(super) fn is_negligible(&self, predicted_reduction: f64, squares: f64) -> bool {
        predicted_reduction <= self.ftol_abs.max(self.ftol_rel * squares)
    }

    /// Whether to stop the iteration without convergence: after a minimum number of steps, progress is slow and the sum
    /// of squares is above `worthwhile_squares`.
    pub(super) fn is_hopeless(&self, steps: usize, predicted_reduction: f64, squares: f64) -> bool {
        steps >= MIN_STEPS
            && squares > self.worthwhile_squares
            && predicted_reduction < SLOW * squares
    }

    /// Whether a step may be accepted as the last one without evaluating its residuals. This is so if its predicted
    /// reduction is negligible. It is also so if its predicted reduction is at most `accept_unevaluated` × the
    /// negligible one, and that of the next step is negligible. The latter is extrapolated from `predicted_reduction`
    /// and from `previous`, the predicted reduction of the preceding step.
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

/// Reason why an iteration stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// The predicted reduction of the sum of squares by the last step was negligible.
    Converged,
    /// The iteration reached its maximum number of steps.
    MaxSteps,
    /// No step decreased the sum of squares, even with the maximum damping.
    NoDescent,
    /// The iteration was stopped because its progress was slow at a sum of squares above
    /// [`StoppingCriteria::worthwhile_squares`].
    GivenUp,
    /// The deadline of the fit passed.
    Deadline,
}
