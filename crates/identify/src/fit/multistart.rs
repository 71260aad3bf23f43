//! Flights that landed in a wrong minimum are noticed, and started anew.

use flight::batch;
use nalgebra::DVector;

use super::horizon_continuation::{anneal_scale, fit_initial_state};
use super::initial_guess::{FIRST, spin_note};
use super::residual_cache::{ResidualCache, size};
use super::{FitError, State};
use crate::initial_state;
use crate::noise::median;
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::problem::FitProblem;

/// A flight whose residuals are so much greater than is usual is suspected.
const SUSPECT: f64 = 3.0;

/// A new start is taken where it leaves residuals smaller than this part of the old.
const BETTER: f64 = 0.7;

/// Starts flights anew whose residuals are far greater than the others' and than the noise, and fits all again where
/// that helped. Takes and gives the flights as they are flown.
///
/// # Errors
/// As [`settle`](super::settle::settle).
pub fn multistart(
    problem: &FitProblem,
    state: &mut State,
    cache: ResidualCache,
    options: &FitOptions<'_>,
) -> Result<ResidualCache, FitError> {
    let sizes: Vec<f64> = cache
        .sizes()
        .into_iter()
        .map(|size| size.unwrap_or(f64::INFINITY))
        .collect();
    let usual = median(&mut sizes.clone());
    // Where most flights are far off the model is wrong, or most starts are: the noise's floor tells that.
    let limit = SUSPECT
        * if usual > 10.0 * problem.sigma0 {
            problem.sigma0
        } else {
            usual.max(problem.sigma0)
        };
    let outlier_candidates: Vec<usize> = (0..sizes.len())
        .filter(|&flight| sizes[flight] > limit)
        .collect();
    if outlier_candidates.is_empty() {
        return Ok(cache);
    }
    options.begins("flights that stand out", outlier_candidates.len());
    let found = batch::each_on(options.threads(), outlier_candidates.len(), |index| {
        let flight = outlier_candidates[index];
        let found = again(problem, state, flight, sizes[flight], options);
        options.part_done();
        found
    });
    if options.is_stopped() {
        return Err(FitError::Interrupted);
    }
    let mut helped = false;
    for (&flight, found) in outlier_candidates.iter().zip(found) {
        if let Some((local, note)) = found {
            state.local[flight] = local;
            state.observation_sets[flight].notes.push(note);
            helped = true;
        }
    }
    if helped {
        return anneal_scale(problem, state, options);
    }
    Ok(cache)
}

/// A better initial state of a flight, with the coefficients as they are, and what is to be said of it.
fn again(
    problem: &FitProblem,
    state: &State,
    flight: usize,
    before: f64,
    options: &FitOptions<'_>,
) -> Option<(DVector<f64>, String)> {
    let observations = &state.observation_sets[flight];
    let mut best: Option<(f64, DVector<f64>, i32)> = None;
    for start in initial_state::initial_guesses(problem, observations).ok()? {
        let Some(local) = continued(problem, state, observations, start.state, options) else {
            continue;
        };
        let Some(size) = size(
            problem,
            observations,
            (&state.global, &local),
            observations.times.len(),
        ) else {
            continue;
        };
        if best.as_ref().is_none_or(|(least, ..)| size < *least) {
            best = Some((size, local, start.turns));
        }
    }
    let (size, local, turns) = best.filter(|(size, ..)| *size < BETTER * before)?;
    let mut note = format!(
        "its first fit had ended in a wrong minimum (residuals of {:.1} mm, now {:.1} mm); it was started anew",
        1e3 * before,
        1e3 * size
    );
    if turns != 0 {
        note = format!("{note}; {}", spin_note(turns));
    }
    Some((local, note))
}

/// Fits one flight over a horizon that doubles.
fn continued(
    problem: &FitProblem,
    state: &State,
    observations: &Observations,
    start: DVector<f64>,
    options: &FitOptions<'_>,
) -> Option<DVector<f64>> {
    let all = observations.times.len();
    let mut samples = observations.samples_until(FIRST.0).max(FIRST.1).min(all);
    let mut local = start;
    loop {
        let fitted = fit_initial_state(
            problem,
            observations,
            samples,
            &state.global,
            local,
            options,
        );
        local = fitted.ok()?.1;
        if samples == all {
            return Some(local);
        }
        samples = (2 * samples).min(all);
    }
}
