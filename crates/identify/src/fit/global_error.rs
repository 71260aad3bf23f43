//! Integration tolerances by the global error. The tolerance of a step bounds the error that the step adds; over a long
//! flight, and where the motion amplifies them, these errors add up.

use flight::parallel;

use super::residual_cache::ResidualCache;
use super::state::State;
use crate::predict::residuals;

/// Maximum error of a predicted value by the integration, in units of the initial noise estimate `sigma0`, or of the
/// residual scale of the flight if that is greater: a model that does not describe a flight needs no accuracy.
const MAX_ERROR: f64 = 0.03;

/// Factor of the tolerance with which the reference trajectory is integrated.
const REFERENCE: f64 = 1e-2;

/// Minimum factor of the tolerance of a flight.
const MIN_FACTOR: f64 = 1e-4;

/// Reduces the tolerances of the flights whose predictions at the present estimates have larger errors than
/// [`MAX_ERROR`], and recomputes the residuals in `cache` if there are any. Flights that cannot be integrated are
/// unchanged.
pub fn bound_global_errors(state: &mut State<'_>, cache: ResidualCache) -> ResidualCache {
    let (problem, options) = (state.problem, state.options);
    let scales = cache.scales();
    let factors = parallel::each_on(options.threads(), state.flights.len(), |flight| {
        let observations = &state.flights[flight];
        let (unknowns, samples) = (
            (&state.global, &state.local[flight]),
            observations.times.len(),
        );
        let coarse = residuals(problem, observations, unknowns, samples).ok()?;
        let mut finely = observations.clone();
        finely.tolerance_factor *= REFERENCE;
        let fine = residuals(problem, &finely, unknowns, samples).ok()?;
        let pairs = coarse.iter().flatten().zip(fine.iter().flatten());
        let differences = pairs.filter_map(|(coarse, fine)| {
            let (coarse, fine) = ((*coarse)?, (*fine)?);
            Some(
                (0..3)
                    .map(|k| (coarse[k] - fine[k]).abs())
                    .fold(0.0, f64::max),
            )
        });
        let size = scales[flight]?.max(problem.sigma0);
        let error = differences.fold(0.0, f64::max) / size;
        (error > MAX_ERROR).then(|| (MAX_ERROR / error).max(MIN_FACTOR))
    });
    let is_refined = factors.iter().any(Option::is_some);
    for (flight, factor) in state.flights.iter_mut().zip(factors) {
        flight.tolerance_factor *= factor.unwrap_or(1.0);
    }
    if is_refined { state.residuals() } else { cache }
}
