//! Cache of the trajectories and residuals of all flights at one iterate, computed once for all stages that use them.

use flight::parallel;

use super::state::{State, retain};
use super::{FitError, flight_error};
use crate::error::FlightError;
use crate::least_squares::FailedFlight;
use crate::observations::Observations;
use crate::predict::{Residuals, residuals_of, states};
use dataset::statistics::{median_of, robust_sigma};

/// Trajectories and residuals of all flights for one set of values of the unknowns.
pub struct ResidualCache(Vec<CachedFlight>);

/// Standard error of a robust standard deviation s, computed from n normally distributed values, in units of s/√n.
const SCALE_ERROR: f64 = 1.17;

/// Size at which residuals are clipped in the deviance, in units of the residual scale: outliers tell nothing.
const CLIPPED: f64 = 4.0;

struct CachedFlight {
    path: Result<Path, FlightError>,
    /// Robust standard deviation of the flight's residuals, m; `None` if there are no residuals.
    scale: Option<f64>,
}

/// Trajectory and residuals of one flight.
pub struct Path {
    /// States of the model at the samples over which the flight was integrated, concatenated sample by sample.
    pub states: Vec<f64>,
    /// Residuals of the values measured in the samples over which the flight was integrated, (predicted − measured) ×
    /// scale of the channel, m.
    pub residuals: Residuals,
}

impl State<'_> {
    /// Computes the trajectories and residuals of all fitted flights, over their whole lengths, for the present values
    /// of the unknowns.
    pub fn residuals(&self) -> ResidualCache {
        let samples = self.flights.iter().map(|flight| flight.times.len());
        ResidualCache::new(self, &samples.collect::<Vec<usize>>())
    }
}

impl ResidualCache {
    /// Integrates each fitted flight over its first samples and computes the residuals in these samples.
    /// `samples[flight]` is the number of samples of a flight that are used.
    pub fn new(state: &State<'_>, samples: &[usize]) -> Self {
        let (problem, options) = (state.problem, state.options);
        let count = state.flights.len();
        Self(parallel::each_on(options.threads(), count, |flight| {
            if options.is_cancelled() {
                return CachedFlight {
                    path: Err(FlightError::Interrupted),
                    scale: None,
                };
            }
            let (observations, global) = (&state.flights[flight], &state.global);
            let unknowns = (global, &state.local[flight]);
            let path =
                states(problem, observations, unknowns, samples[flight]).map(|states| Path {
                    residuals: residuals_of(problem, observations, global, &states),
                    states,
                });
            let scale = path.as_ref().ok();
            let scale = scale.and_then(|path| robust_scale(&path.residuals));
            CachedFlight { path, scale }
        }))
    }

    /// Robust standard deviation of each flight's residuals, m; `None` if the flight cannot be integrated or has no
    /// residuals.
    pub fn scales(&self) -> Vec<Option<f64>> {
        self.0.iter().map(|flight| flight.scale).collect()
    }

    /// Whether a flight's residual scale exceeds the reference scale `usual`, m, by more than the factor `ratio` and by
    /// more than `errors` standard errors. `true` if the flight has no residual scale.
    pub fn stands_out(&self, flight: usize, usual: f64, ratio: f64, errors: f64) -> bool {
        let CachedFlight { path, scale } = &self.0[flight];
        let (Some(scale), Ok(path)) = (scale, path) else {
            return true;
        };
        let values = 3 * path.residuals.iter().flatten().flatten().count();
        let by_chance = 1.0 + errors * SCALE_ERROR / (values.max(1) as f64).sqrt();
        *scale > usual * ratio.max(by_chance)
    }

    /// Median over the flights of their residual scales, m; 0 if no flight has a residual scale.
    pub fn median_scale(&self) -> f64 {
        let scales = self.0.iter().filter_map(|flight| flight.scale);
        median_of(scales).unwrap_or(0.0)
    }

    /// Sum of the squares of all residuals, m², clipped at [`CLIPPED`] times the residual scale `scale`, m, and their
    /// number.
    pub fn clipped_squares(&self, scale: f64) -> (f64, usize) {
        let limit = CLIPPED * scale;
        let paths = self.0.iter().filter_map(|flight| flight.path.as_ref().ok());
        let residuals = paths.flat_map(|path| path.residuals.iter().flatten().flatten().flatten());
        residuals.fold((0.0, 0), |(squares, count), residual| {
            (squares + residual.abs().min(limit).powi(2), count + 1)
        })
    }

    /// Root mean square over the flights of their residual scales, m; 0 if no flight has a residual scale.
    pub fn rms_scale(&self) -> f64 {
        let scales: Vec<f64> = self.0.iter().filter_map(|flight| flight.scale).collect();
        let squares: f64 = scales.iter().map(|scale| scale * scale).sum();
        (squares / scales.len().max(1) as f64).sqrt()
    }

    /// Flights whose trajectories could not be computed, as indices among the fitted flights, with the reasons.
    pub fn failures(&self) -> Vec<FailedFlight> {
        let flights = self.0.iter().enumerate();
        flights
            .filter_map(|(flight, found)| Some((flight, found.path.as_ref().err()?.clone())))
            .collect()
    }

    /// Removes the residuals and trajectories of the flights listed in `failures`, whose indices refer to the flights
    /// in this cache.
    pub fn remove(&mut self, failures: &[FailedFlight]) {
        let mut is_kept = vec![true; self.0.len()];
        for (flight, _) in failures {
            is_kept[*flight] = false;
        }
        retain(&mut self.0, &is_kept);
    }

    /// Trajectory and residuals of a flight.
    ///
    /// # Errors
    /// [`FitError::Flight`] if the flight cannot be integrated.
    pub fn path(&self, flights: &[Observations], flight: usize) -> Result<&Path, FitError> {
        let path = self.0[flight].path.as_ref();
        path.map_err(|reason| flight_error(&flights[flight], reason.clone()))
    }
}

/// Robust standard deviation of one flight's residuals, m; `None` if there are no residuals.
pub fn robust_scale(residuals: &Residuals) -> Option<f64> {
    let all = residuals.iter().flatten().flatten().flatten();
    let mut sizes = Vec::with_capacity(3 * residuals.iter().map(Vec::len).sum::<usize>());
    sizes.extend(all.map(|residual| residual.abs()));
    (!sizes.is_empty()).then(|| robust_sigma(&mut sizes))
}
