//! Exclusion of flights whose motion differs from that of the other flights.

use nalgebra::DVector;

use super::FitError;
use super::exclusion::exclude_failed;
use super::horizon_continuation::anneal_scale;
use super::one_flight::FixedGlobal;
use super::residual_cache::ResidualCache;
use super::state::State;
use crate::error::{ExcludedFlight, FlightError};
use crate::least_squares::FailedFlight;
use crate::observations::Observations;

/// Ratio of a flight's residual scale to the median over all flights, or to the initial noise estimate `sigma0` if that
/// is greater. Flights above this ratio are suspects, without which the other flights are fitted.
const SUSPECT_RATIO: f64 = 3.0;

/// Ratio of a flight's residual scale to that of the other flights, fitted without it, above which the flight is
/// excluded, because it would bias the fit of all others.
const UNLIKE_RATIO: f64 = 10.0;

/// Maximum number of passes, each of which may exclude flights and fits the remaining ones again.
const MAX_PASSES: usize = 4;

/// Excludes a minority of flights whose residuals remain far above those of the other flights, even if the global
/// parameters are fitted to the other flights alone. `cache` contains the residuals for the present values of the
/// unknowns in `state`. Returns the residuals for the new values.
///
/// # Errors
/// [`FitError::NoUsableFlight`] if no flight is left; [`FitError::Interrupted`] if the work is cancelled.
pub fn exclude_unlike_flights(
    state: &mut State<'_>,
    cache: ResidualCache,
) -> Result<ResidualCache, FitError> {
    let options = state.options;
    let mut cache = exclude_failed(state, cache)?;
    for _ in 0..MAX_PASSES {
        let limit = SUSPECT_RATIO * cache.median_scale().max(state.problem.sigma0);
        let scales = cache.scales().into_iter().enumerate();
        let above = scales.filter(|(_, scale)| scale.is_some_and(|scale| scale > limit));
        let suspects: Vec<usize> = above.map(|(flight, _)| flight).collect();
        let is_minority = 2 * suspects.len() < state.flights.len();
        if suspects.is_empty() || !is_minority || options.is_past_deadline() {
            break;
        }
        options.stage_started("without the flights that stand out", state.flights.len());
        match fit_without(state, &suspects)? {
            Some((without, residuals)) => (*state, cache) = (without, residuals),
            None => break,
        }
    }
    Ok(cache)
}

/// Fits the flights that are not in `suspects`, and then the initial state of each suspect with the resulting global
/// parameters. Suspects with far larger residuals than the other flights are excluded, and the remaining suspects are
/// included again. `None` if no suspect is excluded.
fn fit_without<'a>(
    state: &State<'a>,
    suspects: &[usize],
) -> Result<Option<(State<'a>, ResidualCache)>, FitError> {
    let removed: Vec<FailedFlight> = suspects
        .iter()
        .map(|&flight| (flight, FlightError::SingularInitialState))
        .collect();
    let mut without = state.clone();
    without.exclude(removed)?;
    without.excluded.clone_from(&state.excluded);
    let annealed = anneal_scale(&mut without)?;
    let residuals = exclude_failed(&mut without, annealed)?;
    let usual = residuals.median_scale().max(state.problem.sigma0);
    let (mut has_excluded, mut has_returned) = (false, false);
    for &flight in suspects {
        let (observations, local) = (&state.flights[flight], &state.local[flight]);
        let (scale, local) = refitted(without.fixed_global(), observations, local)?;
        if scale > UNLIKE_RATIO * usual {
            has_excluded = true;
            without.excluded.push(ExcludedFlight {
                flight: state.ids[flight],
                file: observations.file.clone(),
                reason: FlightError::UnlikeTheOthers { scale, usual },
            });
        } else {
            has_returned = true;
            without.push(state.ids[flight], observations.clone(), local);
        }
    }
    if !has_excluded {
        return Ok(None);
    }
    let residuals = match has_returned {
        true => {
            let annealed = anneal_scale(&mut without)?;
            exclude_failed(&mut without, annealed)?
        }
        false => residuals,
    };
    Ok(Some((without, residuals)))
}

/// Fits the initial state of a flight at fixed global parameters. Returns the residual scale (robust standard deviation
/// of the residuals, m; infinite if the flight cannot be integrated) and the initial state.
fn refitted(
    at: FixedGlobal<'_>,
    observations: &Observations,
    start: &DVector<f64>,
) -> Result<(f64, DVector<f64>), FitError> {
    let samples = observations.times.len();
    let local = match at.fit_initial_state(observations, samples, start.clone()) {
        Ok((_, local)) => local,
        Err(FlightError::Interrupted) => return Err(FitError::Interrupted),
        Err(_) => start.clone(),
    };
    let scale = at.residual_scale(observations, &local, samples);
    Ok((scale.unwrap_or(f64::INFINITY), local))
}
