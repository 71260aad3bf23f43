//! Trajectories and residuals of all flights at one iterate, computed once for all stages that use them, and least
//! squares over the flights that can be computed.

use flight::parallel;
use nalgebra::DVector;

use super::output_error::OutputError;
use super::state::{State, retain};
use super::{Fit, FitError, flight_error};
use crate::error::FlightError;
use crate::ids::FlightId;
use crate::least_squares::{FailedFlight, Solution, SolveError, StoppingCriteria, solve_after};
use crate::observations::{Observations, median_interval};
use crate::options::FitOptions;
use crate::predict::{FlightAt, Loss, Residuals, robust_scale};
use crate::problem::FitProblem;
use dataset::Dataset;
use dataset::levels::{ROBUST_ERROR, UNLIKE};
use dataset::statistics::median_of;

/// Trajectories and residuals of all flights for one set of values of the unknowns.
#[derive(Default)]
pub struct ResidualCache {
    flights: Vec<CachedFlight>,
    /// Whether the errors of the integration are known to be small.
    is_accurate: bool,
}

struct CachedFlight {
    path: Result<Path, FlightError>,
    /// Robust standard deviation of the flight's residuals, m; `None` if there are no residuals.
    scale: Option<f64>,
}

/// Trajectory and residuals of one flight.
pub struct Path {
    /// States of the model at the samples over which the flight was integrated, concatenated sample by sample.
    pub states: Vec<f64>,
    pub residuals: Residuals,
}

impl Path {
    /// Residual of a channel in a sample; `None` if it is not measured, or beyond the end of the path.
    pub fn residual(&self, sample: usize, channel: usize) -> Option<[f64; 3]> {
        *self.residuals[channel].get(sample)?
    }
}

impl State<'_> {
    /// A flight at the present values of the unknowns.
    pub fn at(&self, flight: usize) -> FlightAt<'_> {
        let unknowns = (&self.global, &self.local[flight]);
        FlightAt::new(self.problem, &self.flights[flight], unknowns)
    }

    /// Trajectories and residuals of all fitted flights over their whole lengths, at the present values.
    pub fn residuals(&self) -> ResidualCache {
        let samples = self.flights.iter().map(|flight| flight.times.len());
        ResidualCache::new(self, &samples.collect::<Vec<usize>>())
    }

    /// [`residuals`](Self::residuals) of the flights that can be integrated; the others are excluded.
    pub fn flown_residuals(&mut self) -> Result<ResidualCache, FitError> {
        let residuals = self.residuals();
        exclude_failed(self, residuals)
    }
}

impl ResidualCache {
    /// Residuals of each flight in its first `samples[flight]` samples.
    pub fn new(state: &State<'_>, samples: &[usize]) -> Self {
        let (threads, count) = (state.options.threads(), state.flights.len());
        let flights = parallel::each_on(threads, count, |flight| {
            let at = state.at(flight).first(samples[flight]);
            let states = state.options.check_flight().and_then(|()| at.states());
            let path = states.and_then(|states| {
                Ok(Path {
                    residuals: at.residuals_along(&states)?,
                    states,
                })
            });
            let scale = path.as_ref().ok();
            let scale = scale.and_then(|path| robust_scale(&path.residuals));
            CachedFlight { path, scale }
        });
        Self {
            flights,
            is_accurate: false,
        }
    }

    /// Robust standard deviation of each flight's residuals, m; `None` if it cannot be integrated or has none.
    pub fn scales(&self) -> Vec<Option<f64>> {
        self.flights.iter().map(|flight| flight.scale).collect()
    }

    /// Whether a flight has no residual scale, or one above `usual`, m, by more than the factor `ratio` and `errors`
    /// standard errors.
    pub fn stands_out(&self, flight: usize, usual: f64, ratio: f64, errors: f64) -> bool {
        let CachedFlight { path, scale } = &self.flights[flight];
        let (Some(scale), Ok(path)) = (scale, path) else {
            return true;
        };
        let values = 3 * path.residuals.iter().flatten().flatten().count();
        let by_chance = 1.0 + errors * ROBUST_ERROR / (values.max(1) as f64).sqrt();
        *scale > usual * ratio.max(by_chance)
    }

    /// Median over the flights of their residual scales, m; 0 if no flight has a residual scale.
    pub fn median_scale(&self) -> f64 {
        let scales = self.flights.iter().filter_map(|flight| flight.scale);
        median_of(scales).unwrap_or(0.0)
    }

    /// Residual scale that is typical of the flights, m: their median, or the initial noise if that is greater.
    pub fn usual_scale(&self, problem: &FitProblem) -> f64 {
        self.median_scale().max(problem.sigma0)
    }

    /// Sum of the squares of all residuals, m², clipped at [`UNLIKE`] times `scale`, m, and their number.
    pub fn clipped_squares(&self, scale: f64) -> (f64, usize) {
        let limit = UNLIKE * scale;
        let paths = self
            .flights
            .iter()
            .filter_map(|flight| flight.path.as_ref().ok());
        let residuals = paths.flat_map(|path| path.residuals.iter().flatten().flatten().flatten());
        residuals.fold((0.0, 0), |(squares, count), residual| {
            (squares + residual.abs().min(limit).powi(2), count + 1)
        })
    }

    /// Root mean square over the flights of their residual scales, m; 0 if no flight has a residual scale.
    pub fn rms_scale(&self) -> f64 {
        let scales: Vec<f64> = self
            .flights
            .iter()
            .filter_map(|flight| flight.scale)
            .collect();
        let squares: f64 = scales.iter().map(|scale| scale * scale).sum();
        (squares / scales.len().max(1) as f64).sqrt()
    }

    /// Flights whose trajectories could not be computed, as indices among the fitted flights, with the reasons.
    pub fn failures(&self) -> Vec<FailedFlight> {
        let flights = self.flights.iter().enumerate();
        flights
            .filter_map(|(flight, found)| Some((flight, found.path.as_ref().err()?.clone())))
            .collect()
    }

    pub fn remove(&mut self, failures: &[FailedFlight]) {
        let mut is_kept = vec![true; self.flights.len()];
        for (flight, _) in failures {
            is_kept[*flight] = false;
        }
        retain(&mut self.flights, &is_kept);
    }

    pub fn path(&self, flights: &[Observations], flight: usize) -> Result<&Path, FitError> {
        let path = self.flights[flight].path.as_ref();
        path.map_err(|reason| flight_error(&flights[flight], reason.clone()))
    }
}

/// Minimises the sum of squares over the flights of `state`; the caller applies the solution. Flights that cannot be
/// predicted are excluded first. `configure` may change the objective. `previous` is the predicted reduction of the
/// last step of a preceding iteration.
pub fn solve_flights(
    state: &mut State<'_>,
    (loss, criteria): (Loss<'_>, StoppingCriteria),
    previous: Option<f64>,
    configure: &dyn Fn(&State<'_>, &mut OutputError<'_>),
) -> Result<Solution, FitError> {
    loop {
        let mut objective = OutputError::of_all(state.problem, &state.flights, loss, state.options);
        configure(state, &mut objective);
        let solved = solve_after(&objective, state.iterate(), criteria, previous);
        drop(objective);
        match solved {
            Ok(solution) => return Ok(solution),
            Err(SolveError(failures)) => state.exclude(failures)?,
        }
    }
}

/// Excludes the flights whose trajectories could not be computed, from `state` and `cache`.
pub fn exclude_failed(
    state: &mut State<'_>,
    mut cache: ResidualCache,
) -> Result<ResidualCache, FitError> {
    let failures = cache.failures();
    if !failures.is_empty() {
        cache.remove(&failures);
        state.exclude(failures)?;
    }
    Ok(cache)
}

/// A fit in progress at the estimates, truncations and outliers of an earlier fit, with its residuals. `None` if the
/// earlier fit lacks a flight, its model has another number of states, or a flight cannot be integrated.
pub fn continued<'a>(
    problem: &'a FitProblem,
    dataset: &Dataset,
    fitted: &[FlightId],
    earlier: &Fit,
    options: &'a FitOptions<'a>,
) -> Option<(State<'a>, ResidualCache)> {
    let values = problem.globals.iter().map(|global| {
        let mut estimates = earlier.problem.globals.iter().zip(earlier.global.iter());
        let estimate = estimates.find(|(estimated, _)| estimated.name == global.name);
        let (low, high) = global.constraint.bounds;
        estimate.map_or(global.model_value, |(_, value)| value.clamp(low, high))
    });
    let global = DVector::from_iterator(problem.globals.len(), values);
    let mut state = State::new(problem, options, global, 1.0);
    for &flight in fitted {
        let mut left_out = earlier.excluded.iter();
        if let Some(excluded) = left_out.find(|excluded| excluded.flight == flight) {
            state.excluded.push(excluded.clone());
            continue;
        }
        let (before, local) = earlier.flight(flight)?;
        let observations = Observations::like(problem, &dataset.flights[flight.index()], before)?;
        if observations.manifold.states() != local.len() {
            return None;
        }
        state.push(flight, observations, local.clone());
    }
    state.interval = median_interval(&state.flights);
    let cache = state.residuals();
    let is_flown = !state.flights.is_empty() && cache.failures().is_empty();
    is_flown.then_some((state, cache))
}

/// Maximum integration error of a prediction, in units of `sigma0` or of the flight's residual scale if that is
/// greater.
const MAX_ERROR: f64 = 0.03;

/// Factors of the tolerance of a flight: of the reference trajectory, and the least.
const FACTORS: (f64, f64) = (1e-2, 1e-4);

/// Reduces the tolerances of the flights whose predictions have larger errors than [`MAX_ERROR`], and recomputes the
/// residuals if there are any.
pub fn bound_global_errors(state: &mut State<'_>, mut cache: ResidualCache) -> ResidualCache {
    if cache.is_accurate {
        return cache;
    }
    let (problem, options) = (state.problem, state.options);
    let factors = parallel::each_on(options.threads(), state.flights.len(), |flight| {
        let CachedFlight { path, scale } = &cache.flights[flight];
        let coarse = &path.as_ref().ok()?.residuals;
        let at = state.at(flight);
        let mut finely = at.observations.clone();
        finely.tolerance_factor *= FACTORS.0;
        let observations = &finely;
        let fine = &FlightAt { observations, ..at }.residuals().ok()?;
        let [coarse, fine] = [coarse, fine].map(|all| all.iter().flatten().flatten().flatten());
        let differences = coarse.zip(fine).map(|(coarse, fine)| (coarse - fine).abs());
        let size = scale.as_ref()?.max(problem.sigma0);
        let error = differences.fold(0.0, f64::max) / size;
        (error > MAX_ERROR).then(|| (MAX_ERROR / error).max(FACTORS.1))
    });
    if factors.iter().any(Option::is_some) {
        for (flight, factor) in state.flights.iter_mut().zip(factors) {
            flight.tolerance_factor *= factor.unwrap_or(1.0);
        }
        return state.residuals();
    }
    cache.is_accurate = true;
    cache
}
