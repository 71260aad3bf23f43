//! A nonlinear least-squares problem over flights.

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

    /// Normal equations of a flight's residuals. `unknowns` contains the values of the global parameters and of the
    /// flight's local parameters (initial state) at which they are evaluated. `by` selects the parameters with respect
    /// to which the residuals are differentiated. A problem with fixed global parameters differentiates with respect to
    /// the local parameters only.
    ///
    /// # Errors
    /// [`FlightError`] if the flight cannot be predicted from these values.
    fn linearise(
        &self,
        flight: usize,
        unknowns: (&DVector<f64>, &DVector<f64>),
        by: Unknowns,
    ) -> Result<NormalBlock, FlightError>;

    /// Returns the local parameters `local` (initial state) of a flight after the step `step`.
    fn plus(&self, flight: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64>;

    /// Bounds and prior of each global parameter.
    fn constraints(&self) -> &[Constraint];

    /// Number of threads to use.
    fn threads(&self) -> usize {
        1
    }

    /// Whether the iteration is to stop with an error because it was cancelled.
    fn is_cancelled(&self) -> bool {
        false
    }

    /// Whether the iteration is to stop and return its present iterate, because the deadline of the fit has passed.
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

/// Reason why a least-squares iteration has no solution.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// Some flights cannot be predicted from their initial values. Contains these flights with the reasons.
    #[error("{} flights cannot be predicted from their initial values, the first because: {}", .0.len(), first(.0))]
    Start(Vec<FailedFlight>),
    /// The iteration was cancelled.
    #[error("interrupted")]
    Cancelled,
}
