//! Horizon continuation: from initial guesses to the neighbourhood of the solution by robust losses of decreasing scale
//! over an increasing time horizon.

use super::FitError;
use super::output_error::{MAX_SCALES, OutputError};
use super::residual_cache::{ResidualCache, solve_flights};
use super::state::State;
use crate::least_squares::{Constraint, StoppingCriteria, solve};
use crate::predict::Loss;
use crate::problem::FitProblem;
use dataset::levels::{AT_NOISE, CLEARLY_SMALLER, ROUGHLY_NOISE};

/// First time horizon, s: duration of the initial part of each flight that is fitted first.
const FIRST_HORIZON: f64 = 0.4;

const HORIZON_GROWTH: f64 = 2.5;

/// A horizon is used only if the longest flight is longer by more than this factor.
const MIN_REMAINING_GROWTH: f64 = 1.2;

/// Residual scale, in units of `sigma0`, below which a longer horizon is fitted next.
const HORIZON_SCALE: f64 = 5.0;

/// Fits all flights over a time horizon that grows to their whole length: far from the solution, long flights have
/// local minima that short ones do not have. A flight that cannot be integrated to the horizon is used up to a time
/// before its failure. Returns the residuals of the whole flights.
pub fn continue_horizon(state: &mut State<'_>) -> Result<ResidualCache, FitError> {
    let options = state.options;
    let lengths = state
        .flights
        .iter()
        .filter_map(|flight| flight.times.last());
    let longest = lengths.copied().fold(0.0, f64::max);
    let mut horizon = FIRST_HORIZON;
    let constraints = weak_constraints(state.problem);
    while horizon < longest / MIN_REMAINING_GROWTH && !options.is_past_deadline() {
        options.stage_started(&format!("first {horizon:.1} s"), state.flights.len());
        // From good initial guesses, one step is enough.
        if step_to_noise(state, &until(horizon, &constraints)).is_none() {
            fit_horizon(state, horizon, ResidualCache::median_scale)?;
        }
        horizon *= HORIZON_GROWTH;
    }
    options.stage_started("whole flights", state.flights.len());
    if horizon > FIRST_HORIZON
        && !options.is_past_deadline()
        && let Some(cache) = step_to_noise(state, &|_, _| {})
    {
        return Ok(cache);
    }
    anneal_scale(state)
}

/// One step of all unknowns. Returns the residuals after it if they are at noise level; otherwise undoes it.
fn step_to_noise(
    state: &mut State<'_>,
    configure: &dyn Fn(&State<'_>, &mut OutputError<'_>),
) -> Option<ResidualCache> {
    let start = state.iterate();
    let sigma0 = state.problem.sigma0;
    // Another scale would cost an integration of the residuals before the step.
    let step = single_step(state, Loss::Huber(ROUGHLY_NOISE * sigma0), configure);
    let residuals = step.map(|step| step.residuals);
    let noise = residuals.filter(|residuals| are_noise(residuals, sigma0));
    if noise.is_none() {
        state.set(start);
    }
    noise
}

/// Whether the residuals of all flights are at noise level, given the initial noise estimate `sigma0`, m.
fn are_noise(residuals: &ResidualCache, sigma0: f64) -> bool {
    let limit = ROUGHLY_NOISE * sigma0;
    let mut scales = residuals.scales().into_iter();
    residuals.median_scale() <= AT_NOISE * sigma0
        && scales.all(|scale| scale.is_some_and(|scale| scale <= limit))
}

/// A least-squares step, with the residuals after it but without their derivatives, which would cost far more.
pub struct UnevaluatedStep {
    pub residuals: ResidualCache,
    pub predicted_reduction: Option<f64>,
}

/// One step of all unknowns; `None` if a flight cannot be predicted before it.
fn single_step(
    state: &mut State<'_>,
    loss: Loss<'_>,
    configure: &dyn Fn(&State<'_>, &mut OutputError<'_>),
) -> Option<UnevaluatedStep> {
    let mut objective = OutputError::of_all(state.problem, &state.flights, loss, state.options);
    configure(state, &mut objective);
    let samples = objective.samples.clone();
    let solution = solve(&objective, state.iterate(), StoppingCriteria::SINGLE_STEP).ok()?;
    state.take(&solution);
    Some(UnevaluatedStep {
        residuals: ResidualCache::new(state, &samples),
        predicted_reduction: solution.predicted_reduction,
    })
}

/// One step over whole flights, undone if the median residual scale grows by more than 10 % or a flight cannot be
/// predicted after it. `before` are the residuals before it.
pub fn unevaluated_step(
    state: &mut State<'_>,
    loss: Loss<'_>,
    before: &ResidualCache,
) -> Option<UnevaluatedStep> {
    let start = state.iterate();
    let step = single_step(state, loss, &|_, _| {});
    let accepted = step.filter(|step| {
        let is_predicted = step.residuals.scales().iter().all(Option::is_some);
        is_predicted && step.residuals.median_scale() <= AT_NOISE * before.median_scale()
    });
    if accepted.is_none() {
        state.set(start);
    }
    accepted
}

/// Bounds and priors of the global parameters. Those without a prior get a weak one, as short parts of flights do not
/// determine all parameters.
fn weak_constraints(problem: &FitProblem) -> Vec<Constraint> {
    let constraints = problem.globals.iter().map(|global| {
        let weak = Some((global.model_value, global.x_scale));
        let prior = global.constraint.prior.or(weak);
        Constraint {
            prior,
            ..global.constraint
        }
    });
    constraints.collect()
}

/// Restricts an objective to the samples up to `horizon`, s, under the bounds and priors `constraints`.
fn until(horizon: f64, constraints: &[Constraint]) -> impl Fn(&State<'_>, &mut OutputError<'_>) {
    move |state, objective| {
        objective.samples = state.samples_until(horizon);
        objective.constraints = constraints.to_vec();
    }
}

/// Fits up to `horizon`, s, with decreasing scales of the loss until the residuals are small enough for a longer
/// horizon or decrease no more. `spread` computes the scale, m, from the residuals.
pub fn fit_horizon(
    state: &mut State<'_>,
    horizon: f64,
    spread: fn(&ResidualCache) -> f64,
) -> Result<(), FitError> {
    let constraints = weak_constraints(state.problem);
    let sigma0 = state.problem.sigma0;
    let mut scale = f64::INFINITY;
    for _ in 0..MAX_SCALES {
        let cache = ResidualCache::new(state, &state.samples_until(horizon));
        state.limit_to_flyable(&cache.failures());
        let next = spread(&cache).max(sigma0);
        if next > CLEARLY_SMALLER * scale {
            break;
        }
        scale = next;
        let by = (Loss::Huber(scale), StoppingCriteria::HORIZON);
        let solution = solve_flights(state, by, None, &until(horizon, &constraints))?;
        state.take(&solution);
        if scale < HORIZON_SCALE * sigma0 {
            break;
        }
    }
    Ok(())
}

/// Fits whole flights with a robust loss whose scale decreases to that of the residuals, which are returned.
pub fn anneal_scale(state: &mut State<'_>) -> Result<ResidualCache, FitError> {
    let mut scale = f64::INFINITY;
    let mut cache = state.residuals();
    for _ in 0..MAX_SCALES {
        let next = cache.median_scale().max(state.problem.sigma0);
        if next > CLEARLY_SMALLER * scale {
            break;
        }
        scale = next;
        state.limit_to_flyable(&cache.failures());
        let by = (Loss::Huber(scale), StoppingCriteria::COARSE);
        let solution = solve_flights(state, by, None, &|state, objective| {
            objective.samples = state.samples_until(f64::INFINITY);
        })?;
        state.take(&solution);
        cache = state.residuals();
    }
    Ok(cache)
}
