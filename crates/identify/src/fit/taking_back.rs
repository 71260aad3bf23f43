//! Tries excluded flights again with the parameters estimated from the others. Far from the solution, a flight may seem
//! unlike the others, or its samples may seem not to determine its initial state.

use flight::parallel;
use nalgebra::DVector;

use super::FitError;
use super::exclusion::exclude_failed;
use super::horizon_continuation::anneal_scale;
use super::initial_guess;
use super::multistart::fly_to_the_end;
use super::one_flight::FixedGlobal;
use super::reweighting::{Reweighted, reweight};
use super::state::State;
use crate::data_fault::FaultKind;
use crate::error::{ExcludedFlight, FlightError};
use crate::observations::Observations;
use dataset::{Dataset, Flight};

/// Maximum ratio of a flight's residual scale to that of the other flights, at which the flight is considered similar
/// to them.
pub const LIKE_RATIO: f64 = 3.0;

/// Maximum number of passes over the excluded flights. Flights that one pass includes improve the parameters, so that
/// the next pass may include further flights.
const MAX_PASSES: usize = 2;

/// Includes excluded flights again if the model predicts them about as well as the fitted flights, and fits all flights
/// again. Returns the new solution, or the present one, `reweighted`, if no flight is included again.
///
/// # Errors
/// [`FitError::NoUsableFlight`] if no flight is left; [`FitError::Interrupted`] if the work is cancelled.
pub fn take_back(
    dataset: &Dataset,
    state: &mut State<'_>,
    mut reweighted: Reweighted,
) -> Result<Reweighted, FitError> {
    let options = state.options;
    for _ in 0..MAX_PASSES {
        let (tried, kept): (Vec<ExcludedFlight>, Vec<ExcludedFlight>) =
            state.excluded.iter().cloned().partition(may_come_back);
        if tried.is_empty() || options.is_past_deadline() {
            break;
        }
        options.stage_started("flights left out", tried.len());
        let usual = reweighted.cache.median_scale().max(state.problem.sigma0);
        let at = FixedGlobal {
            global: &reweighted.solution.iterate.global,
            ..state.fixed_global()
        };
        let found = parallel::each_on(options.threads(), tried.len(), |index| {
            let flight = &dataset.flights[tried[index].flight.index()];
            let found = like_the_others(at, flight, usual);
            options.flight_done();
            found
        });
        if options.is_cancelled() {
            return Err(FitError::Interrupted);
        }
        let mut with = state.clone();
        with.excluded = kept;
        let mut has_returned = false;
        for (excluded, found) in tried.into_iter().zip(found) {
            match found {
                Some((observations, local)) => {
                    has_returned = true;
                    with.push(excluded.flight, observations, local);
                }
                None => with.excluded.push(excluded),
            }
        }
        if !has_returned {
            break;
        }
        let residuals = anneal_scale(&mut with)?;
        let residuals = exclude_failed(&mut with, residuals)?;
        let again = reweight(&mut with, residuals, None)?;
        // A flight that changes the fit of all others remains excluded.
        if with.flights.len() <= state.flights.len()
            || again.noise.overall() > LIKE_RATIO * reweighted.noise.overall()
        {
            break;
        }
        (*state, reweighted) = (with, again);
    }
    Ok(reweighted)
}

/// Whether an excluded flight may be included again. It may if it was excluded because of its fit, but not if it was
/// excluded because of its samples. A flight with a suspected wrong unit of time is an exception and may be included,
/// because an acceleration that occurs in one flight only can cause the same suspicion.
pub fn may_come_back(excluded: &ExcludedFlight) -> bool {
    match &excluded.reason {
        FlightError::UnlikeTheOthers { .. }
        | FlightError::SingularInitialState
        | FlightError::Integration(_) => true,
        FlightError::DataFault(fault) => fault.fault == FaultKind::TimeUnit,
        _ => false,
    }
}

/// Observations and fitted initial state of an excluded flight, if its residual scale is at most `LIKE_RATIO` ×
/// `usual`, the residual scale of the other flights, m; `None` otherwise.
fn like_the_others(
    at: FixedGlobal<'_>,
    flight: &Flight,
    usual: f64,
) -> Option<(Observations, DVector<f64>)> {
    let found = initial_guess::observations_and_poses(at.problem, flight, None);
    let (observations, _) = found.ok()?;
    let (scale, local, _) = fly_to_the_end(at, &observations)?;
    (scale <= LIKE_RATIO * usual).then_some((observations, local))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::tests::simulated;
    use crate::fit::{flights_of, spin_aliases};
    use crate::options::FitOptions;
    use crate::problem::FitProblem;
    use crate::tolerance;
    use dataset::Role;
    use dataset::synthesize::Plan;

    /// Number of flights that remain excluded after the fit tried to include excluded flights again, if one of four
    /// similar simulated flights was excluded for the given reason.
    fn excluded_after(reason: FlightError) -> usize {
        let model = model_spec::load::load("ball", &[]).unwrap();
        let plan = Plan {
            flights: 4,
            duration: Some(0.4),
            ..Plan::default()
        };
        let dataset = simulated(&model, "serve", &plan);
        let options = FitOptions::default();
        let mut problem = FitProblem::new(&model, &dataset, &options).unwrap();
        let fitted = flights_of(&dataset, Role::Fit);
        let observed = initial_guess::observe(&problem, &dataset, &fitted, &[], &options);
        problem.sigma0 = observed.sigma0.unwrap();
        problem.tolerance = tolerance::whitened(&model, fitted.len());
        let guesses = initial_guess::initial_guesses(&problem, &dataset, observed, &options);
        let guesses = guesses.unwrap();
        let alternatives = &guesses.alternatives;
        let (mut state, _) =
            spin_aliases::resolve_spin_aliases(guesses.state, alternatives).unwrap();
        state.exclude(vec![(1, reason)]).unwrap();
        let residuals = state.residuals();
        let found = reweight(&mut state, residuals, None).unwrap();
        let found = take_back(&dataset, &mut state, found).unwrap();
        assert_eq!(found.solution.iterate.local.len(), state.flights.len());
        assert_eq!(state.flights.len() + state.excluded.len(), fitted.len());
        state.excluded.len()
    }

    #[test]
    fn a_flight_comes_back_unless_its_samples_were_the_reason() {
        assert_eq!(excluded_after(FlightError::SingularInitialState), 0);
        assert_eq!(excluded_after(FlightError::NoMeasurement), 1);
    }
}
