//! Alternating estimation of noise and unknowns (iterated feasible generalised least squares): the noise is estimated
//! from the residuals, and the residuals are weighted by the noise.

use flight::parallel;

use super::FitError;
use super::exclusion::{exclude_failed, solve_flights};
use super::horizon_continuation::unevaluated_step;
use super::residual_cache::ResidualCache;
use super::state::State;
use crate::error::FlightError;
use crate::least_squares::{FailedFlight, Solution, StopReason, StoppingCriteria};
use crate::noise::NoiseModel;
use crate::outliers;
use crate::predict::Loss;
use crate::report::FitStatus;

/// Number of values per changed outlier flag: at convergence, at most one in this number of values may still change its
/// flag. Among very many values, a few are always near the outlier threshold.
const POINTS_PER_CHANGED_MARK: usize = 10_000;

/// Maximum number of rounds, each of which estimates the noise from the residuals and then fits by least squares again.
const MAX_ROUNDS: usize = 8;

/// Maximum difference at which two noise estimates count as equal: relative for standard deviations, absolute for
/// autocorrelations.
const SAME_NOISE: f64 = 0.005;

/// Number of least-squares solutions that may end at the maximum number of steps. If it is reached, the alternation of
/// noise estimates and least squares ends without convergence.
const MAX_UNFINISHED: usize = 2;

/// Number of least-squares solutions with residuals far above the noise, after which the alternation of noise estimates
/// and least squares ends, because the weights of such residuals need not converge precisely.
const MAX_MISFITS: usize = 3;

/// Result of alternating noise estimates and least squares: the converged noise model and unknowns, or the last ones if
/// the alternation did not converge.
pub struct Reweighted {
    /// Noise model by which the residuals are weighted.
    pub noise: NoiseModel,
    /// Least-squares solution for residuals weighted according to `noise`.
    pub solution: Solution,
    /// Residuals at the least-squares solution, with the trajectories of the flights.
    pub cache: ResidualCache,
    /// Convergence status, which states whether the least squares converged and whether the noise model agrees with the
    /// residuals.
    pub status: FitStatus,
}

/// Alternates noise estimates and least squares until the noise estimated from the residuals equals the noise by which
/// they were weighted. `cache` contains the residuals for the present values of the unknowns in `state`; it must
/// contain no flight whose trajectory could not be computed. `predicted_reduction` is the reduction of the sum of
/// squares that was predicted for the step that led to these values, if its residuals were weighted by their noise.
/// Flights whose samples do not determine their initial state are excluded.
///
/// # Errors
/// [`FitError::NoUsableFlight`] if no flight is left; [`FitError::Interrupted`] if the work is cancelled.
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
        let residuals = state.residuals();
        cache = exclude_failed(state, residuals)?;
    }
}

/// Flights whose initial state (local parameters) is not determined by their residuals, as indices among the fitted
/// flights, with the reason.
fn undetermined_flights(solution: &Solution) -> Vec<FailedFlight> {
    let blocks = solution.blocks.iter().enumerate();
    let undetermined = blocks.filter(|(_, block)| !block.determines_local());
    undetermined
        .map(|(flight, _)| (flight, FlightError::SingularInitialState))
        .collect()
}

/// Alternates noise estimates and least squares until the noise estimated from the residuals equals the noise by which
/// they were weighted, within a tolerance, or a limit of the number of rounds is reached. `None` if a flight was
/// excluded in the process. `predicted_reduction` is the reduction of the sum of squares that was predicted for the step
/// before, if its residuals were weighted by their noise.
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
    for round in 0..MAX_ROUNDS {
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
            && let Some(step) = unevaluated_step(state, loss, &cache)?
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
        let residuals = state.residuals();
        cache = exclude_failed(state, residuals)?;
        if state.flights.len() < flights {
            return Ok(None);
        }
        unfinished += usize::from(found.stop_reason == StopReason::MaxSteps);
        misfits += usize::from(is_misfit);
        if found.stop_reason == StopReason::Deadline || unfinished >= MAX_UNFINISHED {
            return Ok(Some(Reweighted::new(noise, found, cache, false)));
        }
        // Weights of residuals that are not noise need not converge precisely.
        if misfits >= MAX_MISFITS {
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

/// Marks outliers among the measured values, and estimates the noise of the remaining values. Returns the noise, and
/// whether more outlier flags changed than is allowed at convergence.
pub fn estimate_noise(
    state: &mut State<'_>,
    cache: &ResidualCache,
) -> Result<(NoiseModel, bool), FitError> {
    let (problem, options) = (state.problem, state.options);
    let judged = outlier_candidates(state, cache)?;
    let group_of = problem.noise_groups();
    let own: Vec<Vec<[f64; 3]>> = judged.iter().map(|flight| flight.scales.clone()).collect();
    let scales = outliers::judged_scales(&own);
    let marked = parallel::each_on(options.threads(), state.flights.len(), |flight| {
        let residuals = &cache.path(&state.flights, flight)?.residuals;
        let observations = &state.flights[flight];
        // The candidates of a flight that is noisier than the others are judged by its own scale.
        let mut outlier = vec![false; observations.measured.len()];
        for (point, local_residual) in &judged[flight].candidates {
            let scale = scales[flight][group_of[point % observations.channels]];
            outlier[*point] = outliers::is_outlier(local_residual, scale);
        }
        let mut moments = problem.no_moments();
        for (channel, series) in residuals.iter().enumerate() {
            let inliers = series.iter().enumerate().map(|(sample, residual)| {
                residual.filter(|_| !outlier[sample * observations.channels + channel])
            });
            let inliers: Vec<Option<[f64; 3]>> = inliers.collect();
            moments[group_of[channel]].add(&observations.times, &inliers, state.interval);
        }
        Ok((outlier, moments))
    });
    let mut sums = problem.no_moments();
    let mut changed = 0;
    for (observations, marked) in state.flights.iter_mut().zip(marked) {
        let (outlier, moments) = marked?;
        let marks = observations.outlier.iter().zip(&outlier);
        changed += marks.filter(|(before, now)| before != now).count();
        observations.outlier = outlier;
        for (sum, of_flight) in sums.iter_mut().zip(&moments) {
            sum.join(of_flight);
        }
    }
    let flights = state.flights.iter();
    let local: usize = flights.map(|flight| flight.manifold.dimension()).sum();
    let unknowns = local + problem.globals.len();
    let points: usize = sums.iter().map(|sum| sum.count).sum();
    Ok((
        problem.noise_of(&sums, unknowns, state.interval),
        changed > points / POINTS_PER_CHANGED_MARK,
    ))
}

/// Possible outliers of one flight, found from local residuals. A local residual is the difference of a residual from
/// the line through the residuals of the neighbouring samples.
struct FlightOutliers {
    /// Robust standard deviation of the flight's local residuals (deviations of the residuals from the line through the
    /// neighbouring ones), for each noise group (channels that share one noise process) along each axis, m.
    scales: Vec<[f64; 3]>,
    /// Index and local residual (deviation of the residual from the line through the neighbouring ones), m, of each
    /// value that is an outlier for the standard deviations `scales`. The index counts the values of all channels,
    /// sample by sample. Larger standard deviations make no further value an outlier.
    candidates: Vec<(usize, [f64; 3])>,
}

fn outlier_candidates(
    state: &State<'_>,
    cache: &ResidualCache,
) -> Result<Vec<FlightOutliers>, FitError> {
    let group_of = state.problem.noise_groups();
    let each = parallel::each_on(state.options.threads(), state.flights.len(), |flight| {
        let residuals = &cache.path(&state.flights, flight)?.residuals;
        let local_residuals = outliers::local_residuals(&state.flights[flight].times, residuals);
        let scales = outliers::group_scales(&local_residuals, &group_of);
        let candidates = outliers::outlier_candidates(&local_residuals, &scales, &group_of);
        Ok(FlightOutliers { scales, candidates })
    });
    each.into_iter().collect()
}
