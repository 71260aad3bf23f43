//! Cache of trajectories with sensitivities, integrated once for each linearization point.

use std::sync::Mutex;

use identify::{FitProblem, Iterate};

/// Maximum size of one cache in bytes; trajectories of flights for which the cache has no space are integrated again at
/// each use.
const MAX_CACHE_BYTES: usize = 128 << 20;

/// States of one flight at its sample times, and their sensitivities to all unknowns, as one flat vector in the layout
/// that `identify::linearise_with` writes and reads. `None` until they are first computed.
pub(crate) type CachedTrajectory = Option<Vec<f64>>;

/// Cache of the trajectories of all flights at one linearization point. Sensitivities to the coefficients of library
/// terms are included.
#[derive(Debug)]
pub(crate) struct TrajectoryCache {
    /// One cache slot for each flight, by its index; the vector is empty if the cache is disabled.
    slots: Vec<Mutex<CachedTrajectory>>,
}

/// Linearization point of the normal equations: an estimation problem, values of all its unknowns, and a trajectory
/// cache.
#[derive(Clone, Copy)]
pub(crate) struct LinearizationPoint<'p> {
    /// Estimation problem whose residuals are linearized.
    pub problem: &'p FitProblem,
    /// Values of all unknowns of the estimation problem: global parameters and initial states of the flights.
    pub iterate: &'p Iterate,
    /// Cache of the trajectories computed from `iterate`.
    pub cache: &'p TrajectoryCache,
}

impl TrajectoryCache {
    /// A cache that stores no trajectory.
    pub const DISABLED: Self = Self { slots: Vec::new() };

    /// Creates an empty cache with slots for `flights` flights.
    pub fn for_flights(flights: usize) -> Self {
        Self {
            slots: (0..flights).map(|_| Mutex::new(None)).collect(),
        }
    }

    /// Whether the cache is disabled, that is, stores no trajectories.
    pub fn is_disabled(&self) -> bool {
        self.slots.is_empty()
    }

    /// Calls `work` with the cached trajectory of a flight, `None` if there is none, and returns the result of `work`.
    /// A trajectory that `work` writes to its argument is stored unless the cache would exceed [`MAX_CACHE_BYTES`].
    pub fn with_flight<R>(
        &self,
        flight: usize,
        work: impl FnOnce(&mut CachedTrajectory) -> R,
    ) -> R {
        let Some(slot) = self.slots.get(flight) else {
            return work(&mut None);
        };
        let mut slot = slot
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner);
        let result = work(&mut slot);
        // Trajectories have similar lengths, so the size of this one estimates the size of those stored before.
        let bytes = slot
            .as_ref()
            .map_or(0, |values| size_of_val(values.as_slice()));
        if (flight + 1).saturating_mul(bytes) > MAX_CACHE_BYTES {
            *slot = None;
        }
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_support::fixture;
    use identify::{NoiseModel, NormalBlock};

    #[test]
    fn a_cached_trajectory_gives_the_same_equations_as_a_new_integration() {
        let fixture = fixture();
        let model = &fixture.model;
        let evaluate = |cache: &TrajectoryCache, noise: &NoiseModel| {
            let at = LinearizationPoint {
                problem: &model.problem,
                iterate: &fixture.iterate,
                cache,
            };
            model.normal_equations_with_terms(at, noise).unwrap()
        };
        let (one, other) = (fixture.fit.noise(), NoiseModel::white(0.01, 0.01));
        let cache = TrajectoryCache::for_flights(model.flights.len());
        let none = TrajectoryCache::DISABLED;
        assert_eq!(evaluate(&cache, one), evaluate(&none, one));
        let is_stored = |slot: &Mutex<CachedTrajectory>| slot.lock().unwrap().is_some();
        assert!(cache.slots.iter().all(is_stored));
        assert_eq!(evaluate(&cache, &other), evaluate(&none, &other));
        // Columns of the terms follow those of the global parameters.
        let with_terms = evaluate(&cache, one);
        let globals = fixture.iterate.global.len();
        assert!(with_terms[0].global.nrows() > globals);
        let without: Vec<NormalBlock> = with_terms
            .iter()
            .map(|block| model.without_terms(block))
            .collect();
        let direct = model.normal_equations(&model.problem, &fixture.iterate, one);
        assert_eq!(without, direct.unwrap());
    }

    #[test]
    fn trajectories_beyond_the_limit_are_not_stored() {
        let cache = TrajectoryCache::for_flights(2);
        let half = MAX_CACHE_BYTES / 8 - 1;
        for flight in [0, 1] {
            cache.with_flight(flight, |stored| *stored = Some(vec![0.0; half]));
        }
        assert!(cache.with_flight(0, |stored| stored.is_some()));
        assert!(cache.with_flight(1, |stored| stored.is_none()));
    }
}
