//! Flights that do not fit with the others: they are started again, excluded if they remain unlike the others, and
//! taken back if the final parameters describe them.

use nalgebra::DVector;

use super::horizon_continuation::anneal_scale;
use super::initial_guess::{first_segment, observations_and_poses, spin_note};
use super::output_error::{FixedGlobal, FlightAlone};
use super::residual_cache::{ResidualCache, exclude_failed};
use super::reweighting::{Reweighted, reweight};
use super::starts::distinct;
use super::state::State;
use super::{FitError, restarts};
use crate::error::{ExcludedFlight, FlightError};
use crate::numbers::significant;
use crate::observations::Observations;
use dataset::FaultKind;
use dataset::levels::{CLEARLY_SMALLER, FAR_ABOVE, HOPELESS};
use dataset::statistics::median;
use dataset::{Dataset, Flight};

/// Ratio of a flight's residual scale to the reference and standard errors above it, from which it is fitted again, and
/// maximum ratio of the new scale to the old one. Without measured positions, attitudes are guessed, and a wrong
/// minimum may be nearly as good.
fn limits(state: &State<'_>) -> (f64, f64, f64) {
    if state.problem.sees_positions() {
        (FAR_ABOVE, 0.0, CLEARLY_SMALLER)
    } else {
        (1.2, 6.0, 0.95)
    }
}

/// Maximum numbers of passes in which unlike flights are excluded, and flights return; these improve the parameters for
/// others.
const PASSES: (usize, usize) = (4, 2);

/// Refits flights whose residual scale is far above that of the others. If one improves, all are fitted again.
pub fn multistart(state: &mut State<'_>, cache: ResidualCache) -> Result<ResidualCache, FitError> {
    let options = state.options;
    let scales = cache.scales().into_iter();
    let scales: Vec<f64> = scales.map(|s| s.unwrap_or(f64::INFINITY)).collect();
    let sigma0 = state.problem.sigma0;
    // Where the model or most guesses are wrong, a flight is compared with the noise.
    let usual = Some(median(&mut scales.clone())).filter(|usual| *usual <= HOPELESS * sigma0);
    let usual = usual.unwrap_or(sigma0).max(sigma0);
    let (ratio, errors, _) = limits(state);
    let is_suspect = |flight: &usize| cache.stands_out(*flight, usual, ratio, errors);
    let suspects: Vec<usize> = (0..scales.len()).filter(is_suspect).collect();
    if suspects.is_empty() || options.is_past_deadline() {
        return Ok(cache);
    }
    let found = options.each_flight("flights that stand out", suspects.len(), |index| {
        restart(state, suspects[index], scales[suspects[index]])
    });
    let has_improved = found.iter().any(Option::is_some);
    for (&flight, found) in suspects.iter().zip(found) {
        if let Some((local, note)) = found {
            state.local[flight] = local;
            state.flights[flight].notes.push(note);
        }
    }
    if has_improved {
        return anneal_scale(state);
    }
    Ok(cache)
}

/// Better initial state of a flight at the present parameters, with a note; `None` if none has a scale clearly below
/// `before`, m.
fn restart(state: &State<'_>, flight: usize, before: f64) -> Option<(DVector<f64>, String)> {
    let best = fly_to_the_end(state.alone(flight));
    let (.., accepted) = limits(state);
    let (scale, local, turns) = best.filter(|(scale, ..)| *scale < accepted * before)?;
    let mut note = format!(
        "its first fit had ended in a wrong minimum with residuals {} times as large; it was started anew",
        significant(before / scale, 2)
    );
    if turns != 0 {
        note = format!("{note}; {}", spin_note(turns));
    }
    Some((local, note))
}

/// Fits the initial state of one flight from its guesses over a short initial segment, which is doubled until it is the whole
/// flight; guesses that lead to one motion are followed once. Returns the residual scale, m, of the best initial state, this
/// state and its number of additional turns.
fn fly_to_the_end(flight: FlightAlone<'_>) -> Option<(f64, DVector<f64>, i32)> {
    let guesses = restarts::initial_guesses(flight).ok()?;
    let mut followed: Vec<(DVector<f64>, i32)> = guesses
        .into_iter()
        .map(|own| (own.state, own.turns))
        .collect();
    let mut samples = first_segment(flight.observations);
    loop {
        let fitted = followed.into_iter().filter_map(|(start, turns)| {
            let (squares, local) = flight.first(samples).fit(start).ok()?;
            Some((squares, local, turns))
        });
        let distinct = distinct(&flight.at.problem.model, fitted.collect());
        followed = distinct.map(|(_, local, turns)| (local, turns)).collect();
        if samples == flight.samples {
            break;
        }
        samples = (2 * samples).min(flight.samples);
    }
    let (local, turns) = followed.into_iter().next()?;
    Some((flight.scale(&local)?, local, turns))
}

/// Excludes a minority of flights whose residuals remain far above those of the others, even if these are fitted alone.
pub fn exclude_unlike_flights(
    state: &mut State<'_>,
    cache: ResidualCache,
) -> Result<ResidualCache, FitError> {
    let options = state.options;
    let mut cache = exclude_failed(state, cache)?;
    for _ in 0..PASSES.0 {
        let limit = FAR_ABOVE * cache.usual_scale(state.problem);
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

/// Fits the flights without `suspects`, then the initial state of each suspect. Those far above the others are
/// excluded, the rest returns. `None` if none is excluded.
fn fit_without<'a>(
    state: &State<'a>,
    suspects: &[usize],
) -> Result<Option<(State<'a>, ResidualCache)>, FitError> {
    let mut without = state.clone();
    let removed = suspects.iter();
    let removed = removed.map(|&flight| (flight, FlightError::SingularInitialState));
    without.exclude(removed.collect())?;
    without.excluded.clone_from(&state.excluded);
    let annealed = anneal_scale(&mut without)?;
    let residuals = exclude_failed(&mut without, annealed)?;
    let usual = residuals.usual_scale(state.problem);
    let mut has_returned = false;
    let before = without.excluded.len();
    for &flight in suspects {
        let (observations, local) = (&state.flights[flight], &state.local[flight]);
        let (scale, local) = refitted(without.fixed_global().flight(observations), local);
        if scale > HOPELESS * usual {
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
    if without.excluded.len() == before {
        return Ok(None);
    }
    if !has_returned {
        return Ok(Some((without, residuals)));
    }
    let annealed = anneal_scale(&mut without)?;
    let residuals = exclude_failed(&mut without, annealed)?;
    Ok(Some((without, residuals)))
}

/// Residual scale, m, and initial state of a flight fitted at fixed parameters; infinite if it cannot be integrated.
fn refitted(flight: FlightAlone<'_>, start: &DVector<f64>) -> (f64, DVector<f64>) {
    let fitted = flight.fit(start.clone());
    let local = fitted.map_or_else(|_| start.clone(), |(_, local)| local);
    let scale = flight.scale(&local);
    (scale.unwrap_or(f64::INFINITY), local)
}

/// Includes excluded flights that the model predicts about as well as the others, and fits all again. Far from the
/// solution, a flight may have seemed unlike the others.
pub fn take_back(
    dataset: &Dataset,
    state: &mut State<'_>,
    mut reweighted: Reweighted,
) -> Result<Reweighted, FitError> {
    let options = state.options;
    for _ in 0..PASSES.1 {
        let (tried, kept): (Vec<ExcludedFlight>, Vec<ExcludedFlight>) =
            state.excluded.iter().cloned().partition(may_come_back);
        if tried.is_empty() || options.is_past_deadline() {
            break;
        }
        let usual = reweighted.cache.usual_scale(state.problem);
        let at = FixedGlobal {
            global: &reweighted.solution.iterate.global,
            ..state.fixed_global()
        };
        let found = options.each_flight("flights left out", tried.len(), |index| {
            let flight = &dataset.flights[tried[index].flight.index()];
            like_the_others(at, flight, usual)
        });
        let mut with = state.clone();
        with.excluded = kept;
        for (excluded, found) in tried.into_iter().zip(found) {
            match found {
                Some((observations, local)) => with.push(excluded.flight, observations, local),
                None => with.excluded.push(excluded),
            }
        }
        if with.flights.len() == state.flights.len() {
            break;
        }
        let residuals = anneal_scale(&mut with)?;
        let residuals = exclude_failed(&mut with, residuals)?;
        let again = reweight(&mut with, residuals, None)?;
        // A flight that changes the fit of all others remains excluded.
        if with.flights.len() <= state.flights.len()
            || again.noise.overall() > FAR_ABOVE * reweighted.noise.overall()
        {
            break;
        }
        (*state, reweighted) = (with, again);
    }
    Ok(reweighted)
}

/// Whether an excluded flight may return: if its fit was the reason, or a suspected unit of time, which a load that
/// occurs in one flight only feigns.
pub fn may_come_back(excluded: &ExcludedFlight) -> bool {
    match &excluded.reason {
        FlightError::UnlikeTheOthers { .. }
        | FlightError::SingularInitialState
        | FlightError::Integration(_) => true,
        FlightError::DataFault(fault) => fault.fault == FaultKind::TimeUnit,
        _ => false,
    }
}

/// An excluded flight with its initial state, if its residual scale is not far above `usual`, m.
fn like_the_others(
    at: FixedGlobal<'_>,
    flight: &Flight,
    usual: f64,
) -> Option<(Observations, DVector<f64>)> {
    let (observations, _) = observations_and_poses(at.problem, flight, None).ok()?;
    let (scale, local, _) = fly_to_the_end(at.flight(&observations))?;
    (scale <= FAR_ABOVE * usual).then_some((observations, local))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::tests::balls;
    use crate::fit::{flights_of, initial_guess, spin_aliases};
    use crate::options::FitOptions;
    use crate::problem::{FitProblem, whitened_tolerance};
    use dataset::Role;

    /// Begins a fit of four similar simulated flights.
    fn begun<R>(then: impl FnOnce(&Dataset, State<'_>) -> R) -> R {
        let (model, dataset) = balls(4, 0.4);
        let options = FitOptions::default();
        let mut problem = FitProblem::new(&model, &dataset, &options).unwrap();
        let fitted = flights_of(&dataset, Role::Fit);
        let observed = initial_guess::observe(&problem, &dataset, &fitted, &[], &options);
        problem.sigma0 = observed.sigma0.unwrap();
        problem.tolerance = whitened_tolerance(&model, fitted.len());
        let guesses = initial_guess::from_guesses(&problem, &dataset, observed, &options);
        let (state, _) = spin_aliases::resolve(guesses.unwrap()).unwrap();
        then(&dataset, state)
    }

    /// Number of flights that remain excluded after the fit tried to include excluded flights again, if one of four was
    /// excluded for the given reason.
    fn excluded_after(reason: FlightError) -> usize {
        begun(|dataset, mut state| {
            state.exclude(vec![(1, reason)]).unwrap();
            let residuals = state.residuals();
            let found = reweight(&mut state, residuals, None).unwrap();
            let found = take_back(dataset, &mut state, found).unwrap();
            assert_eq!(found.solution.iterate.local.len(), state.flights.len());
            assert_eq!(state.flights.len() + state.excluded.len(), 4);
            state.excluded.len()
        })
    }

    #[test]
    fn a_flight_far_off_is_started_anew_and_then_all_are_fitted() {
        begun(|_, mut state| {
            let cache = state.residuals();
            anneal_scale(&mut state).unwrap();
            let (drag, usual) = (state.global[0], cache.median_scale());
            state.global[0] *= 1.2;
            let velocity = state.local[2].len() - 1;
            state.local[2][velocity] += 5.0;
            let cache = state.residuals();
            let cache = multistart(&mut state, cache).unwrap();
            assert!(
                (state.global[0] / drag - 1.0).abs() < 0.02,
                "{}",
                state.global[0] / drag
            );
            assert!(cache.median_scale() < 2.0 * usual);
            let is_anew = |flight: &Observations| {
                flight
                    .notes
                    .iter()
                    .any(|note| note.contains("it was started anew"))
            };
            let anew: Vec<bool> = state.flights.iter().map(is_anew).collect();
            assert_eq!(anew, [false, false, true, false]);
        });
    }

    #[test]
    fn a_flight_comes_back_unless_its_samples_were_the_reason() {
        assert_eq!(excluded_after(FlightError::SingularInitialState), 0);
        assert_eq!(excluded_after(FlightError::NoMeasurement), 1);
    }
}
