//! A nonlinear least-squares problem over flights, and the criteria by which its iteration stops.

use nalgebra::DVector;

use super::{Constraint, NormalBlock};
use crate::error::FlightError;

/// Selects the unknowns with respect to which residuals are differentiated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknowns {
    /// The local parameters only: the initial state of the flight.
    Local,
    /// The local parameters and the global parameters.
    All,
}

/// Sum of squared residuals of all flights, as a function of global parameters and of local parameters of each flight.
pub trait LeastSquaresProblem: Sync {
    /// Number of flights.
    fn flights(&self) -> usize;

    /// Normal equations of a flight at `unknowns`, its global and local parameters, with derivatives selected by `by`.
    /// A problem with fixed global parameters differentiates by the local ones only.
    ///
    /// # Errors
    /// [`FlightError`] if the flight cannot be predicted from these values.
    fn linearise(
        &self,
        flight: usize,
        unknowns: (&DVector<f64>, &DVector<f64>),
        by: Unknowns,
    ) -> Result<NormalBlock, FlightError>;

    /// Sum of squares of a flight at `unknowns`, that of [`linearise`](Self::linearise).
    ///
    /// # Errors
    /// [`FlightError`] if the flight cannot be predicted from these values.
    fn squares(
        &self,
        flight: usize,
        unknowns: (&DVector<f64>, &DVector<f64>),
    ) -> Result<f64, FlightError> {
        Ok(self.linearise(flight, unknowns, Unknowns::Local)?.squares)
    }

    /// Returns the local parameters `local` (initial state) of a flight after the step `step`.
    fn plus(&self, flight: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64>;

    /// Bounds and prior of each global parameter.
    fn constraints(&self) -> &[Constraint];

    /// Number of threads to use.
    fn threads(&self) -> usize {
        1
    }

    /// Whether the iteration is to stop and return its present iterate, because the deadline of the fit has passed or it was
    /// cancelled.
    fn is_past_deadline(&self) -> bool {
        false
    }
}

/// Values of all unknowns of a least-squares problem.
#[derive(Clone, Debug, PartialEq)]
pub struct Iterate {
    /// Values of the global parameters, SI.
    pub global: DVector<f64>,
    /// Local parameters of each flight, SI: its initial state.
    pub local: Vec<DVector<f64>>,
}

/// Index of a flight in the problem, and the reason why the flight cannot be predicted.
pub type FailedFlight = (usize, FlightError);

fn first(failures: &[FailedFlight]) -> String {
    let reason = failures.first().map(|(_, reason)| reason.to_string());
    reason.unwrap_or_default()
}

/// Flights that cannot be predicted from their initial values, with the reasons: a least-squares iteration with them has no
/// solution.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{} flights cannot be predicted from their initial values, the first because: {}", .0.len(), first(.0))]
pub struct SolveError(pub Vec<FailedFlight>);

// Termination criteria of an iteration, and the reason why it stopped.

/// Criteria by which the least-squares iteration stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoppingCriteria {
    /// Predicted reduction of the sum of squares by a step, below which the step is negligible.
    pub ftol_abs: f64,
    /// The same as a fraction of the sum of squares; the larger of both applies.
    pub ftol_rel: f64,
    /// Upper limit of the predicted reduction of a last step whose residuals are not evaluated, in units of the
    /// negligible one; the step after it must be negligible.
    pub accept_unevaluated: f64,
    /// Maximum number of least-squares steps.
    pub max_steps: usize,
    /// Sum of squares above which an iteration with slow progress is stopped; infinite for never.
    pub worthwhile_squares: f64,
}

/// Progress is slow after this number of steps, if the predicted reduction is below this part of the sum of squares.
const SLOW_AFTER: (usize, f64) = (8, 0.1);

impl StoppingCriteria {
    /// For the final fit of whitened residuals. An unevaluated last step has at most one standard error, which leaves
    /// an error of about 1/30 of it.
    pub const CONVERGED: StoppingCriteria = StoppingCriteria {
        ftol_abs: 1e-3,
        ftol_rel: 1e-11,
        accept_unevaluated: 1e3,
        max_steps: 100,
        worthwhile_squares: f64::INFINITY,
    };
    /// For a model whose residuals are far larger than the noise: its exact solution is meaningless.
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
    /// For fits from whose result another starts, to longer parts of the flights or with a smaller loss scale.
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

    pub(super) fn is_negligible(&self, predicted_reduction: f64, squares: f64) -> bool {
        predicted_reduction <= self.ftol_abs.max(self.ftol_rel * squares)
    }

    /// Whether to give up: after enough steps, progress is slow at a sum of squares above `worthwhile_squares`.
    pub(super) fn is_hopeless(&self, steps: usize, predicted_reduction: f64, squares: f64) -> bool {
        steps >= SLOW_AFTER.0
            && squares > self.worthwhile_squares
            && predicted_reduction < SLOW_AFTER.1 * squares
    }

    /// Whether a step may be the last one without evaluating its residuals: it is negligible, or it is small and the
    /// next one, extrapolated from `previous`, is negligible.
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
    /// Progress was slow at a sum of squares above [`StoppingCriteria::worthwhile_squares`].
    GivenUp,
    /// The deadline of the fit passed.
    Deadline,
}
