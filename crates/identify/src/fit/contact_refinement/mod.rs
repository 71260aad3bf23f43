//! Refines the times of contacts with the fitted model, before the noise is estimated and all flights are fitted to
//! their ends.
//!
//! The first search for contacts, before the fit, uses poses alone: it is late for weak contacts and if markers are
//! hidden. The fitted model predicts how the body would have continued its free flight. A flight whose end was found
//! before is searched near that end. Other flights are searched only if their residuals are larger than those of the
//! flights that the fit predicts, so that flights without contacts cost nothing.

mod search;

use flight::parallel;

use self::search::Search;
use super::FitError;
use super::exclusion::exclude_failed;
use super::horizon_continuation::{UnevaluatedStep, anneal_scale, unevaluated_step};
use super::residual_cache::ResidualCache;
use super::reweighting::estimate_noise;
use super::state::State;
use crate::error::{ExcludedFlight, FlightError};
use crate::ids::FlightId;
use crate::predict::Loss;
use crate::problem::FitProblem;
use dataset::Dataset;

/// Ratio of a flight's residual scale to the median over the flights, above which the flight is left out of the
/// reference fit, because it may contain a ground contact. The whole length of a truncated flight is restored if the
/// ratio for the whole length is at most this value.
const LEFT_OUT_RATIO: f64 = 1.2;
/// Minimum number of standard errors by which the residual scale of a flight must exceed the median over the flights,
/// for the flight to be left out of the reference fit. The limit `LEFT_OUT_RATIO` must be exceeded too.
const LEFT_OUT_SIGNIFICANCE: f64 = 4.0;
/// Limits for a flight's residual scale in the reference fit, which leaves out flights that may contain ground
/// contacts. The first value is the ratio to the median scale, the second the excess over the median scale in standard
/// errors. A flight that exceeds both limits is searched for a ground contact.
const SUSPECT_LIMITS: (f64, f64) = (1.05, 3.0);
/// Maximum median over the flights of their residual scales, in units of the initial noise estimate `sigma0`, at which
/// the model is considered accurate. Only an accurate model reveals ground contacts that were not found from the poses.
const ACCURATE_RATIO: f64 = 1.3;

/// Uses the fitted model to search the flights for ground contacts, and truncates each flight at its contact or
/// restores its whole length. `cache` contains the residuals for the present values of the unknowns in `state`, which
/// were fitted to the flights as truncated before. Returns the residuals for the new values, and the predicted reduction
/// of the sum of squares by the step that led to them, if its residuals were weighted by their noise.
///
/// # Errors
/// [`FitError::NoUsableFlight`] if no flight is left; [`FitError::Interrupted`] if the work is cancelled.
pub fn refine_contacts(
    dataset: &Dataset,
    state: &mut State<'_>,
    cache: ResidualCache,
) -> Result<(ResidualCache, Option<f64>), FitError> {
    let (problem, options) = (state.problem, state.options);
    if !problem.sees_markers_alone() {
        return Ok((cache, None));
    }
    let usual = |cache: &ResidualCache| cache.median_scale().max(problem.sigma0);
    let (cache, predicted_reduction) = match converge_further(state, &cache, usual)? {
        Some(step) => (step.residuals, step.predicted_reduction),
        None => (cache, None),
    };
    // Flights with contacts bias the global parameters and inflate the noise estimate.
    let others = fitted_without(state, &cache, usual(&cache))?;
    let (others, of_others) = match &others {
        Some((others, cache)) => (others, cache),
        None => (&*state, &cache),
    };
    let usual = usual(of_others);
    // The residuals of a wrong model resemble contacts in places.
    let flies = is_accurate(problem, of_others);
    let stands_out = |id: FlightId| {
        let place = others.ids.iter().position(|other| *other == id);
        place.is_none_or(|place| {
            of_others.stands_out(place, usual, SUSPECT_LIMITS.0, SUSPECT_LIMITS.1)
        })
    };
    let is_suspect = |index: &usize| {
        state.flights[*index].truncation.is_some() || flies && stands_out(state.ids[*index])
    };
    let suspects: Vec<usize> = (0..state.flights.len()).filter(is_suspect).collect();
    let is_unlike = |excluded: &&ExcludedFlight| {
        matches!(
            excluded.reason,
            FlightError::UnlikeTheOthers { .. } | FlightError::Integration(_)
        )
    };
    let unlike: Vec<ExcludedFlight> = state.excluded.iter().filter(is_unlike).cloned().collect();
    if suspects.is_empty() && unlike.is_empty() || options.is_past_deadline() {
        return Ok((cache, predicted_reduction));
    }
    options.stage_started("contacts", suspects.len() + unlike.len());
    let (noise, _) = estimate_noise(&mut others.clone(), of_others)?;
    let search = Search {
        at: others.fixed_global(),
        noise: &noise,
        usual,
    };
    let of_fitted = parallel::each_on(options.threads(), suspects.len(), |index| {
        let index = suspects[index];
        let flight = &dataset.flights[state.ids[index].index()];
        let found = search.retruncated(flight, &state.flights[index], &state.local[index]);
        options.flight_done();
        found
    });
    let of_unlike = parallel::each_on(options.threads(), unlike.len(), |index| {
        let flight = &dataset.flights[unlike[index].flight.index()];
        let found = search.excluded_until_contact(flight);
        options.flight_done();
        found
    });
    if options.is_cancelled() {
        return Err(FitError::Interrupted);
    }
    if of_fitted.iter().chain(&of_unlike).all(Option::is_none) {
        return Ok((cache, predicted_reduction));
    }
    let (ids, global) = (others.ids.clone(), others.global.clone());
    for (id, local) in ids.into_iter().zip(others.local.clone()) {
        if let Some(index) = state.ids.iter().position(|own| *own == id) {
            state.local[index] = local;
        }
    }
    state.global = global;
    for (index, moved) in suspects.into_iter().zip(of_fitted) {
        if let Some(moved) = moved {
            state.flights[index] = moved.observations;
            state.local[index] = moved.local;
        }
    }
    for (excluded, moved) in unlike.iter().zip(of_unlike) {
        if let Some(moved) = moved {
            state
                .excluded
                .retain(|other| other.flight != excluded.flight);
            state.push(excluded.flight, moved.observations, moved.local);
        }
    }
    let residuals = state.residuals();
    Ok((exclude_failed(state, residuals)?, None))
}

/// Performs one step of all unknowns if flights that were not truncated have larger residuals than the others, although
/// most residuals are at the noise level. The reason may be that the fit has not converged, rather than contacts.
/// `cache` contains the residuals for the present values of the unknowns in `state`, and `usual` returns the residual
/// scale that is typical of the flights, m. Returns the step; `None` if there was none.
fn converge_further(
    state: &mut State<'_>,
    cache: &ResidualCache,
    usual: impl Fn(&ResidualCache) -> f64,
) -> Result<Option<UnevaluatedStep>, FitError> {
    let usual = usual(cache);
    let mut places = 0..state.flights.len();
    let stands_out = |place: usize| {
        state.flights[place].truncation.is_none()
            && cache.stands_out(place, usual, SUSPECT_LIMITS.0, SUSPECT_LIMITS.1)
    };
    let is_late = state.options.is_past_deadline();
    if is_late || !is_accurate(state.problem, cache) || !places.any(stands_out) {
        return Ok(None);
    }
    let (noise, _) = estimate_noise(state, cache)?;
    unevaluated_step(state, Loss::Whitened(&noise), cache)
}

/// Reference fit: fits only the flights whose residual scale is not far above `usual`, m, a typical scale of the
/// flights. Returns these flights with their residuals; `None` if no flight or more than half of the flights would be
/// left out.
fn fitted_without<'a>(
    state: &State<'a>,
    cache: &ResidualCache,
    usual: f64,
) -> Result<Option<(State<'a>, ResidualCache)>, FitError> {
    let mut others = state.without_flights();
    let flights = state.ids.iter().zip(&state.flights).zip(&state.local);
    for (place, ((id, flight), local)) in flights.enumerate() {
        if !cache.stands_out(place, usual, LEFT_OUT_RATIO, LEFT_OUT_SIGNIFICANCE) {
            others.push(*id, flight.clone(), local.clone());
        }
    }
    if others.ids.len() == state.ids.len() || 2 * others.ids.len() < state.ids.len() {
        return Ok(None);
    }
    // At the noise level, the flights that are left out hardly change the fit: one step is enough.
    let step = match is_accurate(state.problem, cache) {
        true => unevaluated_step(&mut others, Loss::Huber(usual), cache)?,
        false => None,
    };
    let residuals = match step {
        Some(step) => step.residuals,
        None => anneal_scale(&mut others)?,
    };
    let residuals = exclude_failed(&mut others, residuals)?;
    Ok(Some((others, residuals)))
}

fn is_accurate(problem: &FitProblem, residuals: &ResidualCache) -> bool {
    residuals.median_scale() <= ACCURATE_RATIO * problem.sigma0
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use crate::fit::fit;
    use crate::fit::tests::{pushed, simulated};
    use crate::options::FitOptions;
    use dataset::synthesize::Plan;

    /// Number of samples that a fit to six flights of a disc uses of each flight, if the velocity of the first flight
    /// jumps by `push`, m/s.
    fn used(push: Vector3<f64>) -> Vec<usize> {
        let model = model_spec::load::load("disc", &[]).unwrap();
        let plan = Plan {
            flights: 6,
            duration: Some(0.5),
            ..Plan::default()
        };
        let mut dataset = simulated(&model, "backhand", &plan);
        dataset.flights[0] = pushed(&dataset.flights[0], 40.5, push);
        let fitted = fit(&model, &dataset, &FitOptions::default()).unwrap();
        let flights = fitted.report.flights.iter();
        flights.map(|flight| flight.samples).collect()
    }

    #[test]
    fn a_touch_that_poses_alone_do_not_show_ends_its_flight() {
        let free = used(Vector3::zeros());
        let touched = used(Vector3::new(-0.1, 0.0, 0.4));
        assert!(free.iter().all(|samples| *samples > 55), "{free:?}");
        assert!(touched[0].abs_diff(41) <= 2, "{touched:?}");
        assert_eq!(free[1..], touched[1..]);
    }
}
