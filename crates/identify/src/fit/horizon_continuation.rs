//! From starts to the neighbourhood of the solution: by a robust loss whose scale shrinks, over a growing horizon.

use nalgebra::DVector;

use super::output_error::{OutputError, whole};
use super::residual_cache::{ResidualCache, size};
use super::{FitError, State, told};
use crate::least_squares::{Constraint, Iterate, Solution, SolveError, StoppingCriteria, solve};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::predict::Loss;
use crate::problem::FitProblem;

/// The first horizon, s, and by how much the next is longer.
const HORIZON: (f64, f64) = (0.4, 2.5);

/// How often the scale of the loss may shrink.
const SHRINKS: usize = 8;

/// Over how many times the noise's floor a scale is fine enough while the horizon still grows.
const FINE: f64 = 5.0;

/// Over how many times the noise's floor residuals are more than noise: the usual ones, and those of any flight.
const NOISE: (f64, f64) = (1.1, 2.0);

/// Residuals that grew by more than this made a flight worse, and not only less certain.
const WORSE: f64 = 1.1;

/// Fits all flights over a horizon that grows to their whole length: far from the solution a long flight has wrong
/// minima that a short one has not.
///
/// # Errors
/// [`FitError::Flight`] where a flight becomes impossible, [`FitError::Interrupted`].
pub fn continue_horizon(
    problem: &FitProblem,
    state: &mut State,
    options: &FitOptions<'_>,
) -> Result<ResidualCache, FitError> {
    let longest = state
        .observation_sets
        .iter()
        .filter_map(|observations| observations.times.last());
    let longest = longest.copied().fold(0.0, f64::max);
    let mut horizon = HORIZON.0;
    while horizon < longest / 1.2 {
        options.begins(
            &format!("first {horizon:.1} s"),
            state.observation_sets.len(),
        );
        let samples: Vec<usize> = state
            .observation_sets
            .iter()
            .map(|observations| observations.samples_until(horizon))
            .collect();
        approach(problem, state, &samples, options)?;
        horizon *= HORIZON.1;
    }
    options.begins("whole flights", state.observation_sets.len());
    if horizon > HORIZON.0
        && let Some(cache) = one_step(problem, state, options)?
    {
        return Ok(cache);
    }
    anneal_scale(problem, state, options)
}

/// Steps all flights once over their whole length; gives them as they then are where that leaves no more than the noise.
fn one_step(
    problem: &FitProblem,
    state: &mut State,
    options: &FitOptions<'_>,
) -> Result<Option<ResidualCache>, FitError> {
    let cache = ResidualCache::new(problem, state, &whole(&state.observation_sets), options);
    let loss = Loss::Huber(cache.usual().max(problem.sigma0));
    let stepped = accept_unevaluated(problem, state, loss, &cache, options)?;
    let limit = NOISE.1 * problem.sigma0;
    let good = |size: &Option<f64>| size.is_some_and(|size| size <= limit);
    Ok(stepped.map(|(cache, _)| cache).filter(|cache| {
        cache.usual() <= NOISE.0 * problem.sigma0 && cache.sizes().iter().all(good)
    }))
}

/// Steps all flights once, and judges the step by flying them, which costs far less than their derivatives would: gives
/// them as they then are, and what the step had promised. None where it made them worse, and was taken back.
pub fn accept_unevaluated(
    problem: &FitProblem,
    state: &mut State,
    loss: Loss<'_>,
    before: &ResidualCache,
    options: &FitOptions<'_>,
) -> Result<Option<(ResidualCache, Option<f64>)>, FitError> {
    let objective = OutputError::of_all(problem, &state.observation_sets, loss, options);
    let start = state.point();
    let solution = solve(&objective, start.clone(), StoppingCriteria::SINGLE_STEP);
    let solution = solution.map_err(|failure| told(failure, &state.observation_sets))?;
    state.take(&solution);
    let cache = ResidualCache::new(problem, state, &whole(&state.observation_sets), options);
    let flies = cache.sizes().iter().all(Option::is_some);
    if flies && cache.usual() <= WORSE * before.usual() {
        return Ok(Some((cache, solution.predicted_reduction)));
    }
    (state.global, state.local) = (start.global, start.local);
    Ok(None)
}

/// Fits the first samples of all flights, until residuals are as fine as they need be on the way. Short horizons leave
/// coefficients open, which must not run away before the long ones are seen.
fn approach(
    problem: &FitProblem,
    state: &mut State,
    samples: &[usize],
    options: &FitOptions<'_>,
) -> Result<(), FitError> {
    let mut constraints: Vec<Constraint> = problem
        .globals
        .iter()
        .map(|global| global.constraint)
        .collect();
    for (constraint, global) in constraints.iter_mut().zip(&problem.globals) {
        constraint.prior = constraint
            .prior
            .or(Some((global.model_value, global.x_scale)));
    }
    let mut scale = f64::INFINITY;
    for _ in 0..SHRINKS {
        let cache = ResidualCache::new(problem, state, samples, options);
        let shrunk = cache.usual().max(problem.sigma0);
        if shrunk > 0.7 * scale {
            break;
        }
        scale = shrunk;
        let mut objective = OutputError::of_all(
            problem,
            &state.observation_sets,
            Loss::Huber(scale),
            options,
        );
        objective.samples.copy_from_slice(samples);
        objective.constraints.clone_from(&constraints);
        let solution = solve(&objective, state.point(), StoppingCriteria::HORIZON);
        let solution = solution.map_err(|failure| told(failure, &state.observation_sets))?;
        state.take(&solution);
        if scale < FINE * problem.sigma0 {
            break;
        }
    }
    Ok(())
}

/// Fits all flights over their whole length by a loss whose scale shrinks to that of the residuals; and flies them as they
/// then are.
pub fn anneal_scale(
    problem: &FitProblem,
    state: &mut State,
    options: &FitOptions<'_>,
) -> Result<ResidualCache, FitError> {
    let samples = whole(&state.observation_sets);
    let mut scale = f64::INFINITY;
    let mut cache = ResidualCache::new(problem, state, &samples, options);
    for _ in 0..SHRINKS {
        let shrunk = cache.usual().max(problem.sigma0);
        if shrunk > 0.7 * scale {
            break;
        }
        scale = shrunk;
        let objective = OutputError::of_all(
            problem,
            &state.observation_sets,
            Loss::Huber(scale),
            options,
        );
        let solution = solve(&objective, state.point(), StoppingCriteria::COARSE);
        let solution = solution.map_err(|failure| told(failure, &state.observation_sets))?;
        state.take(&solution);
        cache = ResidualCache::new(problem, state, &samples, options);
    }
    Ok(cache)
}

/// Fits the first samples of one flight by its own unknowns; the loss that is left, over the noise's floor, and the
/// initial state.
///
/// # Errors
/// In words, where the samples do not determine the state, or the flight is impossible.
pub fn fit_initial_state(
    problem: &FitProblem,
    observations: &Observations,
    samples: usize,
    global: &DVector<f64>,
    start: DVector<f64>,
    options: &FitOptions<'_>,
) -> Result<(f64, DVector<f64>), String> {
    let (mut local, mut scale) = (start, f64::INFINITY);
    for _ in 0..SHRINKS {
        let shrunk = size(problem, observations, (global, &local), samples).unwrap_or(1.0);
        let shrunk = shrunk.max(problem.sigma0);
        // The last fit is by the floor's own scale.
        if shrunk > 0.7 * scale || 0.7 * shrunk < problem.sigma0 {
            break;
        }
        scale = shrunk;
        local = solve_local(
            problem,
            observations,
            samples,
            global,
            local,
            Loss::Huber(scale),
            options,
        )?
        .0;
    }
    let (local, solution) = solve_local(
        problem,
        observations,
        samples,
        global,
        local,
        Loss::Huber(problem.sigma0),
        options,
    )?;
    if !solution.blocks[0].determines_local() {
        return Err("its samples do not determine its initial state".into());
    }
    Ok((solution.squares, local))
}

/// One fit of one flight's own unknowns.
pub fn solve_local(
    problem: &FitProblem,
    observations: &Observations,
    samples: usize,
    global: &DVector<f64>,
    local: DVector<f64>,
    loss: Loss<'_>,
    options: &FitOptions<'_>,
) -> Result<(DVector<f64>, Solution), String> {
    let objective = OutputError::of_local(problem, observations, samples, loss, global, options);
    let start = Iterate {
        global: DVector::zeros(0),
        local: vec![local],
    };
    let solution =
        solve(&objective, start, StoppingCriteria::COARSE).map_err(|failure| match failure {
            SolveError::InitialGuess { reason, .. } => reason,
            other => other.to_string(),
        })?;
    Ok((solution.iterate.local[0].clone(), solution))
}
