//! Nonlinear least squares with global parameters shared by all flights and local parameters of each flight.

mod constrained_step;
mod constraint;
mod gram_accumulator;
mod levenberg_marquardt;
mod linearization;
mod local_refinement;
mod normal_equations;
mod problem;
mod scaled_cholesky;
mod stopping_criteria;
mod watchdog;

pub use constrained_step::constrained_step;
pub use constraint::Constraint;
pub(crate) use gram_accumulator::GramAccumulator;
pub use levenberg_marquardt::{Solution, solve, solve_after};
pub(crate) use normal_equations::SchurComplement;
pub use normal_equations::{NormalBlock, ReducedSystem, UndeterminedFlight, eliminate};
pub use problem::{FailedFlight, Iterate, LeastSquaresProblem, SolveError, Unknowns};
pub use scaled_cholesky::pseudo_inverse;
pub(crate) use scaled_cholesky::{ScaledCholesky, floored_inverse};
pub use stopping_criteria::{StopReason, StoppingCriteria};
pub use watchdog::solve_with_watchdog;

#[cfg(test)]
mod tests;
