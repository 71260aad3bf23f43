//! Least squares over the flights of a state; flights that cannot be predicted are excluded.

use super::FitError;
use super::output_error::OutputError;
use super::residual_cache::ResidualCache;
use super::state::State;
use crate::least_squares::{Solution, SolveError, StoppingCriteria, solve_after};
use crate::predict::Loss;

/// Minimises the sum of squares over the flights of `state`, a fit in progress, and returns the solution, which the
/// caller applies with [`State::take`]. Flights that cannot be predicted from their values in `state` are excluded
/// first. `configure` may change the objective, for example restrict it to the first samples of each flight. `previous`
/// is the reduction of the sum of squares that was predicted for the last step of a preceding iteration.
///
/// # Errors
/// [`FitError::NoUsableFlight`] if no flight is left; [`FitError::Interrupted`] if the work is cancelled.
pub fn solve_flights(
    state: &mut State<'_>,
    (loss, criteria): (Loss<'_>, StoppingCriteria),
    previous: Option<f64>,
    configure: &dyn Fn(&State<'_>, &mut OutputError<'_>),
) -> Result<Solution, FitError> {
    loop {
        let mut objective = OutputError::of_all(state.problem, &state.flights, loss, state.options);
        configure(state, &mut objective);
        let solved = solve_after(&objective, state.iterate(), criteria, previous);
        drop(objective);
        match solved {
            Ok(solution) => return Ok(solution),
            Err(SolveError::Start(failures)) => state.exclude(failures)?,
            Err(SolveError::Cancelled) => return Err(FitError::Interrupted),
        }
    }
}

/// Excludes the flights whose trajectories could not be computed, from the fit in progress `state` and from the
/// residuals `cache`.
///
/// # Errors
/// [`FitError::NoUsableFlight`] if no flight is left; [`FitError::Interrupted`] if the work is cancelled.
pub fn exclude_failed(
    state: &mut State<'_>,
    mut cache: ResidualCache,
) -> Result<ResidualCache, FitError> {
    if state.options.is_cancelled() {
        return Err(FitError::Interrupted);
    }
    let failures = cache.failures();
    if !failures.is_empty() {
        cache.remove(&failures);
        state.exclude(failures)?;
    }
    Ok(cache)
}
