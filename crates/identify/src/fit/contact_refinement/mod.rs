//! Refines the times of contacts with the fitted model, before the noise is estimated. The first search uses poses
//! alone and is late for weak contacts. Flights whose end was found before are searched near it; others only if their
//! residuals are larger than those of the flights that the fit predicts.

mod search;

use self::search::Search;
use super::FitError;
use super::horizon_continuation::{UnevaluatedStep, anneal_scale, unevaluated_step};
use super::residual_cache::{ResidualCache, exclude_failed};
use super::reweighting::estimate_noise;
use super::state::State;
use crate::error::{ExcludedFlight, FlightError};
use crate::ids::FlightId;
use crate::predict::Loss;
use crate::problem::FitProblem;
use dataset::Dataset;
use dataset::levels::NEAR_NOISE;

/// Ratio to the median residual scale, and excess in standard errors, above which a flight is left out of the reference
/// fit; a truncated flight gets its whole length back up to this ratio.
const LEFT_OUT: (f64, f64) = (1.2, 4.0);

/// Ratio to the median scale of the reference fit, and excess in standard errors, above which a flight is searched.
const SUSPECT_LIMITS: (f64, f64) = (1.05, 3.0);

/// Searches flights for contacts with the fitted model, and truncates each at its contact or restores its length.
/// `cache` contains the residuals at the present values. Returns those at the new values, and the predicted reduction
/// of the sum of squares by the step that led to them, if its residuals were weighted by their noise.
pub fn refine_contacts(
    dataset: &Dataset,
    state: &mut State<'_>,
    cache: ResidualCache,
) -> Result<(ResidualCache, Option<f64>), FitError> {
    let (problem, options) = (state.problem, state.options);
    if !problem.sees_markers_alone() {
        return Ok((cache, None));
    }
    let (cache, predicted_reduction) = match converge_further(state, &cache)? {
        Some(step) => (step.residuals, step.predicted_reduction),
        None => (cache, None),
    };
    // Flights with contacts bias the global parameters and inflate the noise estimate.
    let others = fitted_without(state, &cache)?;
    let (others, of_others) = match &others {
        Some((others, cache)) => (others, cache),
        None => (&*state, &cache),
    };
    let usual = of_others.usual_scale(problem);
    // The residuals of a wrong model resemble contacts in places.
    let flies = is_accurate(problem, of_others);
    let stands_out = |id: FlightId| {
        others.place(id).is_none_or(|place| {
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
    let (noise, _) = estimate_noise(&mut others.clone(), of_others)?;
    let search = Search {
        at: others.fixed_global(),
        noise: &noise,
        usual,
    };
    let count = suspects.len() + unlike.len();
    let mut moved = options.each_flight("contacts", count, |index| match suspects.get(index) {
        Some(&place) => {
            let flight = &dataset.flights[state.ids[place].index()];
            search.retruncated(flight, &state.flights[place], &state.local[place])
        }
        None => {
            let excluded = &unlike[index - suspects.len()];
            search.excluded_until_contact(&dataset.flights[excluded.flight.index()])
        }
    });
    if moved.iter().all(Option::is_none) {
        return Ok((cache, predicted_reduction));
    }
    let (ids, global) = (others.ids.clone(), others.global.clone());
    for (id, local) in ids.into_iter().zip(others.local.clone()) {
        if let Some(place) = state.place(id) {
            state.local[place] = local;
        }
    }
    state.global = global;
    let of_unlike = moved.split_off(suspects.len());
    for (place, moved) in suspects.into_iter().zip(moved) {
        if let Some(moved) = moved {
            (state.flights[place], state.local[place]) = (moved.observations, moved.state);
        }
    }
    for (excluded, moved) in unlike.iter().zip(of_unlike) {
        if let Some(moved) = moved {
            state
                .excluded
                .retain(|other| other.flight != excluded.flight);
            state.push(excluded.flight, moved.observations, moved.state);
        }
    }
    Ok((state.flown_residuals()?, None))
}

/// One step of all unknowns if flights that were not truncated have larger residuals than the others, although most
/// residuals are noise: the fit may not have converged.
fn converge_further(
    state: &mut State<'_>,
    cache: &ResidualCache,
) -> Result<Option<UnevaluatedStep>, FitError> {
    let usual = cache.usual_scale(state.problem);
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
    Ok(unevaluated_step(state, Loss::Whitened(&noise), cache))
}

/// Reference fit to the flights whose residual scale is not far above the usual; `None` if no flight or more than half
/// of the flights would be left out.
fn fitted_without<'a>(
    state: &State<'a>,
    cache: &ResidualCache,
) -> Result<Option<(State<'a>, ResidualCache)>, FitError> {
    let usual = cache.usual_scale(state.problem);
    let mut others = state.without_flights();
    for place in 0..state.flights.len() {
        if !cache.stands_out(place, usual, LEFT_OUT.0, LEFT_OUT.1) {
            others.push_from(state, place);
        }
    }
    if others.ids.len() == state.ids.len() || 2 * others.ids.len() < state.ids.len() {
        return Ok(None);
    }
    // At the noise level, the flights that are left out hardly change the fit: one step is enough.
    let step = match is_accurate(state.problem, cache) {
        true => unevaluated_step(&mut others, Loss::Huber(usual), cache),
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
    residuals.median_scale() <= NEAR_NOISE * problem.sigma0
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
