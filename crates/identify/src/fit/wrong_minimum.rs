//! Whether a fit may have ended in a wrong minimum, and whether another start led to a better one.

use super::FitError;
use super::horizon_continuation::continue_horizon;
use super::residual_cache::ResidualCache;
use super::state::State;
use super::undistorted;
use crate::options::FitOptions;
use crate::problem::FitProblem;

/// Ratio of the new residual scale to the old one below which the new start is taken.
const ACCEPTED_RATIO: f64 = 0.98;

/// Greatest number of starts from samples without the distortion by the measurement: each knows it better.
const MAX_STARTS: usize = 3;

/// Fits all flights again from samples without the distortion by the present parameters of the measurement, where the present
/// fit may have ended in a wrong minimum. Takes the residuals at the state and returns those at the new state, which is the
/// present one unless the new one is better.
///
/// # Errors
/// Those of [`continue_horizon`].
pub fn start_undistorted(
    problem: &FitProblem,
    state: &mut State,
    mut cache: ResidualCache,
    options: &FitOptions<'_>,
) -> Result<ResidualCache, FitError> {
    for _ in 0..MAX_STARTS {
        if options.is_past_deadline() || !is_suspect(problem, state, &cache) {
            break;
        }
        let Some(mut tried) = undistorted::start(problem, state, options) else {
            break;
        };
        options.stage_started("undistorted samples", state.flights.len());
        let found = continue_horizon(problem, &mut tried, options)?;
        if !is_better(&found, &cache) {
            state.steps = tried.steps;
            break;
        }
        (*state, cache) = (tried, found);
    }
    Ok(cache)
}

/// Whether residuals are above the noise, a flight cannot be flown, or a parameter went to a bound.
pub fn is_suspect(problem: &FitProblem, state: &State, cache: &ResidualCache) -> bool {
    let mut globals = problem.globals.iter().zip(state.global.iter());
    let is_driven_to_bound = globals.any(|(global, &value)| {
        let (low, high) = global.constraint.bounds;
        (value <= low && global.model_value > low) || (value >= high && global.model_value < high)
    });
    is_driven_to_bound || !cache.failures().is_empty() || problem.is_misfit(cache.median_scale())
}

/// Whether a fit predicts more flights, or as many with smaller residuals.
pub fn is_better(found: &ResidualCache, before: &ResidualCache) -> bool {
    let (failed, failed_before) = (found.failures().len(), before.failures().len());
    failed < failed_before
        || failed == failed_before && found.rms_scale() < ACCEPTED_RATIO * before.rms_scale()
}
