//! Horizon continuation: leads from initial guesses to the neighbourhood of the solution by robust losses of decreasing
//! scale over an increasing time horizon.

use super::FitError;
use super::exclusion::solve_flights;
use super::one_flight::{MAX_SCALES, MAX_SHRINKAGE};
use super::output_error::OutputError;
use super::residual_cache::ResidualCache;
use super::state::State;
use super::undistorted;
use crate::least_squares::{Constraint, SolveError, StoppingCriteria, solve};
use crate::predict::Loss;
use crate::problem::FitProblem;

/// First time horizon, s: duration of the initial part of each flight that is fitted first.
const FIRST_HORIZON: f64 = 0.4;

/// Ratio of the length of each time horizon to that of the previous one.
const HORIZON_GROWTH: f64 = 2.5;

/// A time horizon (duration of the initial part of each flight that is fitted) is used only if the longest flight is
/// longer than the horizon by more than this factor; otherwise, whole flights are fitted.
const MIN_REMAINING_GROWTH: f64 = 1.2;

/// Number of least-squares steps of a fit to the initial part of the flights, above which poor initial guesses are
/// suspected. Their cause may be that the measurement distorts the samples, for example by late recording.
const MANY_STEPS: usize = 15;

/// Maximum number of restarts from samples corrected for their distortion by the measurement, such as late recording.
/// Each restart uses a better estimate of the distortion.
const MAX_STARTS: usize = 3;

/// Residual scale, in units of the initial noise estimate `sigma0`, below which the fit of the present time horizon is
/// sufficient, so that a longer one is fitted next. The residual scale of a flight is the robust standard deviation of
/// its residuals.
const HORIZON_SCALE: f64 = 5.0;

/// Scale of the robust loss in a single trial step, after which the residuals may already be at noise level, in units
/// of the initial noise estimate `sigma0`. It is fixed because computing the scale of the residuals before the step
/// would cost another integration.
const STEP_SCALE: f64 = 2.0;

/// Maximum median over the flights of their residual scales, in units of the initial noise estimate `sigma0`, at which
/// the residuals are considered noise.
const MAX_MEDIAN_NOISE: f64 = 1.1;

/// Maximum residual scale of a single flight, in units of the initial noise estimate `sigma0`, at which its residuals
/// are considered noise.
const MAX_FLIGHT_NOISE: f64 = 2.0;

/// Maximum ratio of the median residual scale after a step to that before the step, for the step to be accepted. The
/// residual scale of a flight is the robust standard deviation of its residuals.
const MAX_GROWTH: f64 = 1.1;

/// Fits all flights over a time horizon that grows to their whole length. Far from the solution, long flights have
/// local minima that short ones do not have.
///
/// A flight that cannot be integrated to the horizon from the present unknowns is used up to a time before the failure
/// of its integration. Returns the residuals of the whole flights for the final values of the unknowns in `state`.
///
/// # Errors
/// [`FitError::NoUsableFlight`] if no flight is left; [`FitError::Interrupted`] if the work is cancelled.
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
        if step_to_noise(state, &until(horizon, &constraints))?.is_none() {
            fit_undistorted(state, horizon)?;
        }
        horizon *= HORIZON_GROWTH;
    }
    options.stage_started("whole flights", state.flights.len());
    if horizon > FIRST_HORIZON
        && !options.is_past_deadline()
        && let Some(cache) = step_to_noise(state, &|_, _| {})?
    {
        return Ok(cache);
    }
    anneal_scale(state)
}

/// Fits the samples of all flights up to the time `horizon`, s after their first samples. If the fit takes many steps,
/// the measurement probably distorts the samples, for example by late recording. The fit is then repeated from initial
/// states estimated from corrected samples, and the better one of the two fits is used.
fn fit_undistorted(state: &mut State<'_>, horizon: f64) -> Result<(), FitError> {
    let fit = |state: &mut State<'_>| {
        let steps = state.steps;
        fit_horizon(state, horizon, ResidualCache::median_scale)?;
        Ok::<bool, FitError>(state.steps - steps > MANY_STEPS)
    };
    let spread =
        |state: &State<'_>| ResidualCache::new(state, &state.samples_until(horizon)).rms_scale();
    let mut has_laboured = fit(state)?;
    for _ in 0..MAX_STARTS {
        if !has_laboured || state.options.is_past_deadline() {
            break;
        }
        let Some(mut started) = undistorted::start(state) else {
            break;
        };
        has_laboured = fit(&mut started)?;
        if spread(&started) > spread(state) {
            state.steps = started.steps;
            break;
        }
        *state = started;
    }
    Ok(())
}

/// Tries one least-squares step of all unknowns. Returns the residuals after the step if they are at noise level.
/// Otherwise undoes the step and returns `None`. The objective contains all samples unless `configure` changes it.
fn step_to_noise(
    state: &mut State<'_>,
    configure: &dyn Fn(&State<'_>, &mut OutputError<'_>),
) -> Result<Option<ResidualCache>, FitError> {
    let start = state.iterate();
    let sigma0 = state.problem.sigma0;
    let step = single_step(state, Loss::Huber(STEP_SCALE * sigma0), configure)?;
    let residuals = step.map(|step| step.residuals);
    let noise = residuals.filter(|residuals| are_noise(residuals, sigma0));
    if noise.is_none() {
        state.set(start);
    }
    Ok(noise)
}

/// Whether the residuals of all flights are at noise level, given the initial noise estimate `sigma0`, m.
fn are_noise(residuals: &ResidualCache, sigma0: f64) -> bool {
    let limit = MAX_FLIGHT_NOISE * sigma0;
    let mut scales = residuals.scales().into_iter();
    residuals.median_scale() <= MAX_MEDIAN_NOISE * sigma0
        && scales.all(|scale| scale.is_some_and(|scale| scale <= limit))
}

/// A least-squares step, with the residuals after it but without their derivatives, which would cost far more.
pub struct UnevaluatedStep {
    /// Residuals after the step.
    pub residuals: ResidualCache,
    /// Reduction of the sum of squares by the step that the linearised problem predicts; `None` if the solver predicts
    /// none.
    pub predicted_reduction: Option<f64>,
}

/// Performs one least-squares step of all unknowns. The objective contains all samples unless `configure` changes it.
/// `None` if a flight cannot be predicted before the step.
fn single_step(
    state: &mut State<'_>,
    loss: Loss<'_>,
    configure: &dyn Fn(&State<'_>, &mut OutputError<'_>),
) -> Result<Option<UnevaluatedStep>, FitError> {
    let mut objective = OutputError::of_all(state.problem, &state.flights, loss, state.options);
    configure(state, &mut objective);
    let samples = objective.samples.clone();
    let solution = match solve(&objective, state.iterate(), StoppingCriteria::SINGLE_STEP) {
        Ok(solution) => solution,
        Err(SolveError::Cancelled) => return Err(FitError::Interrupted),
        Err(SolveError::Start(_)) => return Ok(None),
    };
    state.take(&solution);
    Ok(Some(UnevaluatedStep {
        residuals: ResidualCache::new(state, &samples),
        predicted_reduction: solution.predicted_reduction,
    }))
}

/// Performs one least-squares step of all unknowns over whole flights. Undoes it and returns `None` if the robust
/// standard deviation of the residuals (median over the flights) grows by more than 10 %, or if a flight cannot be
/// predicted. `before` are the residuals before the step.
pub fn unevaluated_step(
    state: &mut State<'_>,
    loss: Loss<'_>,
    before: &ResidualCache,
) -> Result<Option<UnevaluatedStep>, FitError> {
    let start = state.iterate();
    let step = single_step(state, loss, &|_, _| {})?;
    let accepted = step.filter(|step| {
        let is_predicted = step.residuals.scales().iter().all(Option::is_some);
        is_predicted && step.residuals.median_scale() <= MAX_GROWTH * before.median_scale()
    });
    if accepted.is_none() {
        state.set(start);
    }
    Ok(accepted)
}

/// Bounds and priors of the global parameters. Parameters without a prior get a weak one (mean: the model's value,
/// standard deviation: the typical magnitude), because the short initial parts of the flights do not determine all
/// parameters.
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

/// Returns a function that restricts an objective to the samples up to `horizon`, s after the first sample, and sets
/// the bounds and priors `constraints` of the global parameters.
fn until(horizon: f64, constraints: &[Constraint]) -> impl Fn(&State<'_>, &mut OutputError<'_>) {
    move |state, objective| {
        objective.samples = state.samples_until(horizon);
        objective.constraints = constraints.to_vec();
    }
}

/// Fits the first samples of all flights, up to `horizon`, s. The fit is repeated with a smaller scale of the robust
/// loss until the residuals are small enough for a longer horizon, or no longer decrease. `spread` computes the scale
/// of the loss, m, from the residuals of all flights.
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
        if next > MAX_SHRINKAGE * scale {
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

/// Fits whole flights repeatedly with a robust loss whose scale decreases to that of the residuals. Returns the
/// residuals of the last fit; flights that cannot be integrated have none.
///
/// # Errors
/// The errors of [`continue_horizon`].
pub fn anneal_scale(state: &mut State<'_>) -> Result<ResidualCache, FitError> {
    let mut scale = f64::INFINITY;
    let mut cache = state.residuals();
    for _ in 0..MAX_SCALES {
        let next = cache.median_scale().max(state.problem.sigma0);
        if next > MAX_SHRINKAGE * scale {
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
