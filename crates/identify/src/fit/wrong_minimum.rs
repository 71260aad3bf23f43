//! Detects fits that may have ended in a wrong minimum, and tries other initial values.

use super::FitError;
use super::horizon_continuation::continue_horizon;
use super::residual_cache::ResidualCache;
use super::state::State;
use super::undistorted;

/// Maximum ratio of the residual scale of a new fit (root mean square over the flights) to that of the present fit, for
/// the new fit to be accepted. The residual scale of a flight is the robust standard deviation of its residuals.
const ACCEPTED_RATIO: f64 = 0.98;

/// Maximum number of restarts from samples corrected for their distortion by the measurement, such as late recording.
/// Each restart uses a better estimate of the distortion.
const MAX_STARTS: usize = 3;

/// If the present fit may have ended in a wrong minimum, fits all flights again from samples corrected for distortions
/// by the measurement (such as late recording) that the present parameters predict. `cache` contains the residuals for
/// the present values of the unknowns in `state`, which are replaced if the new fit is better. Returns the residuals
/// for the final values.
///
/// # Errors
/// The errors of [`continue_horizon`].
pub fn start_undistorted(
    state: &mut State<'_>,
    mut cache: ResidualCache,
) -> Result<ResidualCache, FitError> {
    for _ in 0..MAX_STARTS {
        if state.options.is_past_deadline() || !is_suspect(state, &cache) {
            break;
        }
        let Some(mut tried) = undistorted::start(state) else {
            break;
        };
        state
            .options
            .stage_started("undistorted samples", state.flights.len());
        let found = continue_horizon(&mut tried)?;
        if !is_better(&found, &cache) {
            state.steps = tried.steps;
            break;
        }
        (*state, cache) = (tried, found);
    }
    Ok(cache)
}

/// Whether a fit may have ended in a wrong minimum: residuals are above the noise, a flight cannot be integrated, or a
/// parameter has reached a bound.
pub fn is_suspect(state: &State<'_>, cache: &ResidualCache) -> bool {
    let problem = state.problem;
    let mut globals = problem.globals.iter().zip(state.global.iter());
    let is_driven_to_bound = globals.any(|(global, &value)| {
        let (low, high) = global.constraint.bounds;
        (value <= low && global.model_value > low) || (value >= high && global.model_value < high)
    });
    is_driven_to_bound || !cache.failures().is_empty() || problem.is_misfit(cache.median_scale())
}

/// Whether the fit with the residuals `found` is better than that with the residuals `before`: fewer trajectories fail
/// to integrate, or equally many fail and the residuals are clearly smaller.
pub fn is_better(found: &ResidualCache, before: &ResidualCache) -> bool {
    let (failed, failed_before) = (found.failures().len(), before.failures().len());
    failed < failed_before
        || failed == failed_before && found.rms_scale() < ACCEPTED_RATIO * before.rms_scale()
}
