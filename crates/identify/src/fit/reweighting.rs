//! Alternating estimation of noise and unknowns (iterated feasible generalised least squares).

use super::FitError;
use super::horizon_continuation::unevaluated_step;
use super::residual_cache::{ResidualCache, solve_flights};
use super::state::State;
use super::{flight_error, summary_noise};
use crate::error::FlightError;
use crate::least_squares::{FailedFlight, Solution, StopReason, StoppingCriteria};
use crate::noise::NoiseModel;
use crate::outliers;
use crate::predict::Loss;
use crate::report::FitStatus;

/// Maximum number of rounds, each of which estimates the noise from the residuals and then fits by least squares again.
const MAX_ROUNDS: usize = 8;

/// The same number for summaries, whose columns are traded against each other slowly, and whose rounds are short.
const MAX_ROUNDS_OF_SUMMARIES: usize = 60;

/// Maximum difference of equal noise estimates: relative for standard deviations, absolute for autocorrelations.
const SAME_NOISE: f64 = 0.005;

/// Numbers of solutions after which the alternation ends: of those that ended at the maximum number of steps, and of those
/// with residuals far above the noise, whose weights need not converge.
const ENDLESS: (usize, usize) = (2, 3);

/// Noise model and unknowns that agree, or the last ones if the alternation did not converge.
pub struct Reweighted {
    pub noise: NoiseModel,
    pub solution: Solution,
    pub cache: ResidualCache,
    pub status: FitStatus,
}

/// Alternates noise estimates and least squares until the noise of the residuals is that by which they were weighted.
/// `cache` contains the residuals at the present values, without failed flights. `predicted_reduction` is that of the
/// step that led there, if its residuals were weighted. Flights whose samples do not determine their initial state are
/// excluded.
pub fn reweight(
    state: &mut State<'_>,
    mut cache: ResidualCache,
    mut predicted_reduction: Option<f64>,
) -> Result<Reweighted, FitError> {
    loop {
        if let Some(found) = agree(state, cache, predicted_reduction.take())? {
            let undetermined = undetermined_flights(&found.solution);
            if undetermined.is_empty() {
                return Ok(found);
            }
            state.exclude(undetermined)?;
        }
        // Every pass except the last one excludes a flight.
        cache = state.flown_residuals()?;
    }
}

/// Flights whose residuals do not determine their initial state.
fn undetermined_flights(solution: &Solution) -> Vec<FailedFlight> {
    let blocks = solution.blocks.iter().enumerate();
    let undetermined = blocks.filter(|(_, block)| !block.determines_local());
    undetermined
        .map(|(flight, _)| (flight, FlightError::SingularInitialState))
        .collect()
}

/// As [`reweight`], but `None` if a flight was excluded in the process.
fn agree(
    state: &mut State<'_>,
    mut cache: ResidualCache,
    mut predicted_reduction: Option<f64>,
) -> Result<Option<Reweighted>, FitError> {
    let (problem, options) = (state.problem, state.options);
    let flights = state.flights.len();
    let mut noise = NoiseModel::white(problem.sigma0, state.interval);
    let mut solution: Option<Solution> = None;
    let (mut unfinished, mut misfits) = (0, 0);
    let rounds = match problem.summary {
        Some(_) => MAX_ROUNDS_OF_SUMMARIES,
        None => MAX_ROUNDS,
    };
    for round in 0..rounds {
        let (estimated, marks_changed) = estimate_noise(state, &cache)?;
        let agrees = !marks_changed && estimated.is_within(&noise, SAME_NOISE);
        if let Some(solution) = solution.take_if(|_| agrees) {
            return Ok(Some(Reweighted::new(noise, solution, cache, true)));
        }
        noise = estimated;
        state.rounds = round + 1;
        options.stage_started(&format!("noise, round {}", round + 1), state.flights.len());
        let loss = Loss::Whitened(&noise);
        // One step improves the noise estimate, which needs only the residuals after the step.
        if round == 0
            && predicted_reduction.is_none()
            && !options.is_past_deadline()
            && let Some(step) = unevaluated_step(state, loss, &cache)
        {
            (cache, predicted_reduction) = (step.residuals, step.predicted_reduction);
            continue;
        }
        let is_misfit = problem.is_misfit(noise.overall());
        let criteria = match is_misfit {
            true => StoppingCriteria::MISFIT,
            false => StoppingCriteria::CONVERGED,
        };
        let previous = predicted_reduction.take();
        let found = solve_flights(state, (loss, criteria), previous, &|_, _| {})?;
        state.take(&found);
        if state.flights.len() < flights {
            return Ok(None);
        }
        // After a negligible step, the residuals and the noise estimate are unchanged.
        if found.iterations == 1 && found.last_step_is_negligible(criteria) {
            return Ok(Some(Reweighted::new(noise, found, cache, true)));
        }
        cache = state.flown_residuals()?;
        if state.flights.len() < flights {
            return Ok(None);
        }
        unfinished += usize::from(found.stop_reason == StopReason::MaxSteps);
        misfits += usize::from(is_misfit);
        if found.stop_reason == StopReason::Deadline || unfinished >= ENDLESS.0 {
            return Ok(Some(Reweighted::new(noise, found, cache, false)));
        }
        // Weights of residuals that are not noise need not converge precisely.
        if misfits >= ENDLESS.1 {
            return Ok(Some(Reweighted::new(noise, found, cache, true)));
        }
        solution = Some(found);
    }
    Ok(solution.map(|solution| Reweighted::new(noise, solution, cache, false)))
}

impl Reweighted {
    fn new(noise: NoiseModel, solution: Solution, cache: ResidualCache, agrees: bool) -> Self {
        Self {
            status: FitStatus::of(solution.stop_reason, agrees),
            noise,
            solution,
            cache,
        }
    }
}

/// Marks outliers, and estimates the noise of the other values. Returns it, and whether more flags changed than at
/// convergence.
pub fn estimate_noise(
    state: &mut State<'_>,
    cache: &ResidualCache,
) -> Result<(NoiseModel, bool), FitError> {
    let (problem, threads) = (state.problem, state.options.threads());
    let paths = (0..state.flights.len()).map(|flight| cache.path(&state.flights, flight));
    let paths = paths.collect::<Result<Vec<_>, _>>()?;
    let residuals: Vec<_> = paths.iter().map(|path| &path.residuals[..]).collect();
    let local = state
        .flights
        .iter()
        .map(|flight| flight.manifold.dimension());
    let unknowns = local.sum::<usize>() + problem.globals.len();
    let after = (unknowns, state.interval);
    let flights = &mut state.flights;
    let (mut noise, changed) =
        outliers::estimate_noise(problem, flights, &residuals, after, threads);
    if let Err(reason) = summary_noise::estimate(state, &mut noise) {
        return Err(flight_error(&state.flights[0], reason));
    }
    Ok((noise, changed))
}
