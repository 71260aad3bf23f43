//! Least squares over the flights of a state; flights that cannot be predicted are excluded.

use super::FitError;
use super::output_error::OutputError;
use super::residual_cache::ResidualCache;
use super::state::State;
use crate::error::FlightError;
use crate::least_squares::{Solution, SolveError, StoppingCriteria, solve_after};
use crate::options::FitOptions;
use crate::predict::Loss;
use crate::problem::FitProblem;

/// Minimises the sum of squares over the flights of a state, and returns the solution, which the caller applies with
/// [`State::take`]. Flights that cannot be predicted from their values in the state are excluded first. `configure` may
/// change the objective, and `previous` is the predicted reduction of the last step of a preceding iteration.
///
/// # Errors
/// [`FitError::NoUsableFlight`] if no flight is left; [`FitError::Interrupted`] if the work is cancelled.
pub fn solve_flights(
    problem: &FitProblem,
    state: &mut State,
    (loss, criteria): (Loss<'_>, StoppingCriteria),
    previous: Option<f64>,
    options: &FitOptions<'_>,
    configure: impl Fn(&State, &mut OutputError<'_>),
) -> Result<Solution, FitError> {
    loop {
        let mut objective = OutputError::of_all(problem, &state.flights, loss, options);
        configure(state, &mut objective);
        let solved = solve_after(&objective, state.iterate(), criteria, previous);
        drop(objective);
        match solved {
            Ok(solution) => return Ok(solution),
            Err(SolveError::Start(failures)) => state.exclude(failures)?,
            Err(SolveError::Undetermined(flight)) => {
                state.exclude(vec![(flight.0, FlightError::SingularInitialState)])?;
            }
            Err(SolveError::Cancelled) => return Err(FitError::Interrupted),
        }
    }
}

/// Excludes the flights whose trajectories could not be computed, from `state` and from the residuals `cache`.
///
/// # Errors
/// [`FitError::NoUsableFlight`] if no flight is left; [`FitError::Interrupted`] if the work is cancelled.
pub fn exclude_failed(
    state: &mut State,
    mut cache: ResidualCache,
    options: &FitOptions<'_>,
) -> Result<ResidualCache, FitError> {
    if options.is_cancelled() {
        return Err(FitError::Interrupted);
    }
    let failures = cache.failures();
    if !failures.is_empty() {
        cache.remove(&failures);
        state.exclude(failures)?;
    }
    Ok(cache)
}
