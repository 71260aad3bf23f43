//! Nonlinear least squares with global parameters shared by all flights and local parameters of each flight.

mod constrained_step;
mod gram_accumulator;
mod levenberg_marquardt;
mod linearization;
mod normal_equations;
mod problem;
mod scaled_cholesky;

pub use constrained_step::{Constraint, add_priors, constrained_step};
pub(crate) use gram_accumulator::{GramAccumulator, LANES};
pub use levenberg_marquardt::{Solution, solve, solve_after, solve_with_watchdog};
pub use normal_equations::{NormalBlock, ReducedSystem, UndeterminedFlight, eliminate};
pub(crate) use normal_equations::{SchurComplement, TestedParameters};
pub use problem::{
    FailedFlight, Iterate, LeastSquaresProblem, SolveError, StopReason, StoppingCriteria, Unknowns,
};
pub use scaled_cholesky::pseudo_inverse;
pub(crate) use scaled_cholesky::{ScaledCholesky, floored_inverse};

#[cfg(test)]
mod tests;
