//! Nonlinear least squares with parameters global to all flights and parameters local to each.

mod constrained_step;
mod gram_accumulator;
mod levenberg_marquardt;
mod normal_equations;

pub use constrained_step::constrained_step;
pub use gram_accumulator::GramAccumulator;
pub use levenberg_marquardt::{
    Constraint, Iterate, LeastSquaresProblem, Solution, SolveError, StoppingCriteria, solve,
    solve_after,
};
pub use normal_equations::{
    NormalBlock, ReducedSystem, SchurComplement, UndeterminedFlight, eliminate,
};

#[cfg(test)]
mod tests;
