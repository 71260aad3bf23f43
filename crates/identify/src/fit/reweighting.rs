//! The noise is estimated from the residuals, and the residuals are weighed by the noise, in turn.

use flight::batch;

use super::horizon_continuation::accept_unevaluated;
use super::output_error::{OutputError, whole};
use super::residual_cache::ResidualCache;
use super::{FitError, State, told, white};
use crate::least_squares::{Solution, StoppingCriteria, solve_after};
use crate::noise::{Moments, NoiseModel};
use crate::options::FitOptions;
use crate::outliers;
use crate::predict::Loss;
use crate::problem::FitProblem;

/// One changed mark in so many points is none.
const MANY: usize = 10_000;

/// How often the noise is estimated at most.
const ROUNDS: usize = 8;

/// Brings noise and unknowns to agree. Takes and gives the flights as they are flown.
///
/// # Errors
/// [`FitError::Flight`] where a flight becomes impossible, [`FitError::Interrupted`].
pub fn reweight(
    problem: &FitProblem,
    state: &mut State,
    mut cache: ResidualCache,
    options: &FitOptions<'_>,
) -> Result<(NoiseModel, Solution, ResidualCache), FitError> {
    let mut noise = white(problem, state);
    let mut solution: Option<Solution> = None;
    let mut predicted_reduction = None;
    for round in 0..ROUNDS {
        let (estimated, marks_changed) = estimate(problem, state, &cache, options)?;
        let settled = !marks_changed && estimated.is_close_to(&noise);
        if let Some(solution) = solution.take_if(|_| settled) {
            return Ok((noise, solution, cache));
        }
        noise = estimated;
        state.rounds = round + 1;
        options.begins(
            &format!("noise, round {}", round + 1),
            state.observation_sets.len(),
        );
        let loss = Loss::Whitened(&noise);
        // The noise is known better after one step, and that step need not be seen for it.
        if round == 0
            && let Some(there) = accept_unevaluated(problem, state, loss, &cache, options)?
        {
            (cache, predicted_reduction) = there;
            continue;
        }
        let objective = OutputError::of_all(problem, &state.observation_sets, loss, options);
        let found = solve_after(
            &objective,
            state.point(),
            StoppingCriteria::CONVERGED,
            predicted_reduction.take(),
        );
        let found = found.map_err(|failure| told(failure, &state.observation_sets))?;
        state.take(&found);
        // Where nothing was left to gain another look would show the same residuals, and the same noise in them.
        if found.iterations == 1 && found.is_there(StoppingCriteria::CONVERGED) {
            return Ok((noise, found, cache));
        }
        cache = ResidualCache::new(problem, state, &whole(&state.observation_sets), options);
        solution = Some(found);
    }
    solution
        .map(|solution| (noise, solution, cache))
        .ok_or(FitError::Interrupted)
}

/// Marks outliers and estimates the noise of the rest; and whether marks changed.
fn estimate(
    problem: &FitProblem,
    state: &mut State,
    cache: &ResidualCache,
    options: &FitOptions<'_>,
) -> Result<(NoiseModel, bool), FitError> {
    let scales = batch::each_on(options.threads(), state.observation_sets.len(), |flight| {
        let residuals = &cache.path(&state.observation_sets, flight)?.residuals;
        let local_residuals =
            outliers::local_residuals(&state.observation_sets[flight].times, residuals);
        // What does not stand out in its own flight will not at a scale that is no smaller.
        let scale = outliers::scale(&local_residuals);
        Ok((scale, outliers::outlier_candidates(&local_residuals, scale)))
    });
    let judged: Vec<_> = scales.into_iter().collect::<Result<_, FitError>>()?;
    let scales: Vec<[f64; 3]> = judged.iter().map(|(scale, _)| *scale).collect();
    let usual = outliers::usual(&scales);
    let marked = batch::each_on(options.threads(), state.observation_sets.len(), |flight| {
        let residuals = &cache.path(&state.observation_sets, flight)?.residuals;
        let observations = &state.observation_sets[flight];
        // A flight that is noisier than the others is judged by its own noise.
        let (local, outlier_candidates) = &judged[flight];
        let scale = [0, 1, 2].map(|axis| usual[axis].max(local[axis]));
        let mut outlier = vec![false; observations.measured.len()];
        for (place, local_residual) in outlier_candidates {
            outlier[*place] = outliers::is_outlier(local_residual, scale);
        }
        let mut moments = Moments::default();
        for (marker, series) in residuals.iter().enumerate() {
            let good = series.iter().enumerate().map(|(sample, residual)| {
                residual.filter(|_| !outlier[sample * observations.markers + marker])
            });
            let good: Vec<Option<[f64; 3]>> = good.collect();
            moments.add(&observations.times, &good, state.interval);
        }
        Ok((outlier, moments))
    });
    let mut sum = Moments::default();
    let mut changed = 0;
    for (observations, marked) in state.observation_sets.iter_mut().zip(marked) {
        let (outlier, moments) = marked?;
        let outlier_mask = observations.outlier.iter().zip(&outlier);
        changed += outlier_mask.filter(|(before, now)| before != now).count();
        observations.outlier = outlier;
        sum.join(&moments);
    }
    let local: usize = state
        .observation_sets
        .iter()
        .map(|observations| observations.manifold.dimension())
        .sum();
    let unknowns = local + problem.globals.len();
    Ok((
        sum.noise(unknowns, state.interval, problem.sigma),
        // Among very many points a few always lie at the limit.
        changed > sum.count / MANY,
    ))
}
