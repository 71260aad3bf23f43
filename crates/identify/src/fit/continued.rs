//! Starts a fit at the estimates of an earlier fit of the same flights.

use nalgebra::DVector;

use super::Fit;
use super::residual_cache::ResidualCache;
use super::state::State;
use crate::ids::FlightId;
use crate::observations::{Observations, median_interval};
use crate::options::FitOptions;
use crate::problem::FitProblem;
use dataset::Dataset;

/// Returns a fit in progress that starts at the estimates of an earlier fit, with its flights, their truncations and
/// the values marked as outliers. Also returns the residuals at these estimates. `None` if the earlier fit lacks a
/// flight, if its model has another number of states, or if a flight cannot be integrated from its estimates.
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
