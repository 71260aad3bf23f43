//! A nonlinear least-squares problem over flights.

use nalgebra::DVector;

use super::{Constraint, NormalBlock, UndeterminedFlight};
use crate::error::FlightError;

/// Unknowns by which residuals are differentiated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknowns {
    /// The local parameters: the flight's initial state.
    Local,
    /// The local and the global parameters.
    All,
}

/// Sum of squares over flights, as a function of global parameters and of local parameters of each flight.
pub trait LeastSquaresProblem: Sync {
    /// Number of flights.
    fn flights(&self) -> usize;

    /// Normal equations of a flight's residuals at these global and local parameters; by the local ones alone where the
    /// global ones are fixed.
    ///
    /// # Errors
    /// [`FlightError`] if the flight cannot be predicted from these values.
    fn linearise(
        &self,
        flight: usize,
        unknowns: (&DVector<f64>, &DVector<f64>),
        by: Unknowns,
    ) -> Result<NormalBlock, FlightError>;

    /// A flight's local parameters after a step (the retraction of its manifold).
    fn plus(&self, flight: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64>;

    /// Bounds and prior of each global parameter.
    fn constraints(&self) -> &[Constraint];

    /// Number of threads used.
    fn threads(&self) -> usize {
        1
    }

    /// Whether the iteration is to be cancelled.
    fn is_cancelled(&self) -> bool {
        false
    }

    /// Whether the iteration is to stop at its present iterate.
    fn is_past_deadline(&self) -> bool {
        false
    }
}

/// Values of all unknowns.
#[derive(Clone, Debug, PartialEq)]
pub struct Iterate {
    /// Global parameters, SI.
    pub global: DVector<f64>,
    /// Local parameters of each flight: its initial state, SI.
    pub local: Vec<DVector<f64>>,
}

/// Position of a flight in the problem, and the reason why it cannot be predicted.
pub type FailedFlight = (usize, FlightError);

fn first(failures: &[FailedFlight]) -> String {
    let reason = failures.first().map(|(_, reason)| reason.to_string());
    reason.unwrap_or_default()
}

/// Why there is no solution.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// Flights cannot be predicted from their initial values.
    #[error("{} flights cannot be predicted from their initial values, the first because: {}", .0.len(), first(.0))]
    Start(Vec<FailedFlight>),
    /// The local normal equations of a flight are singular.
    #[error(transparent)]
    Undetermined(#[from] UndeterminedFlight),
    /// The iteration was cancelled.
    #[error("interrupted")]
    Cancelled,
}
