//! Normal equations and residuals of the flights, with derivatives by all columns of the score-test model.

use std::sync::Mutex;

use flight::{BoundModel, parallel};
use identify::{
    FitError, FitProblem, FlightAt, FlightError, Iterate, Loss, NoiseModel, NormalBlock,
    PointResidual, Unknowns,
};
use model_spec::layout::ParamId;
use ode::DifferentiableRhs;

use super::library_terms::LibraryTerms;
use super::score_test_model::ScoreTestModel;

impl ScoreTestModel<'_> {
    /// Normal equations of every flight for local and global parameters, whitened by `noise`.
    pub fn normal_equations(
        &self,
        problem: &FitProblem,
        iterate: &Iterate,
        noise: &NoiseModel,
    ) -> Result<Vec<NormalBlock>, FitError> {
        self.each_flight(|flight| {
            let at = self.flight_at(problem, iterate, flight);
            at.linearise(Unknowns::All, Loss::Whitened(noise))
        })
    }

    /// Normal equations of every flight for local and global parameters and library terms, whitened by `noise`.
    pub fn normal_equations_with_terms(
        &self,
        at: LinearizationPoint<'_>,
        noise: &NoiseModel,
    ) -> Result<Vec<NormalBlock>, FitError> {
        let LinearizationPoint {
            problem,
            iterate,
            cache,
        } = at;
        let Some(terms) = &self.terms else {
            return self.normal_equations(problem, iterate, noise);
        };
        self.each_flight(|flight| {
            let at = self.flight_at(problem, iterate, flight);
            let conditions = at.bound();
            let (mut motion, parameters) = self.motion_with_terms(&conditions, terms);
            cache.with_flight(flight, |stored| {
                let by = (&mut motion as &mut dyn DifferentiableRhs, &*parameters);
                at.linearise_with(Loss::Whitened(noise), by, Some(stored))
            })
        })
    }

    /// Calls `each` with every residual of a flight, predicted − measured, m, not whitened, and its derivatives by
    /// initial state, global parameters and library terms.
    pub fn each_residual(
        &self,
        at: LinearizationPoint<'_>,
        flight: usize,
        each: &mut dyn FnMut(PointResidual<'_>),
    ) -> Result<(), FitError> {
        let LinearizationPoint {
            problem, iterate, ..
        } = at;
        let at = self.flight_at(problem, iterate, flight);
        let conditions = at.bound();
        let done = match &self.terms {
            Some(terms) => {
                let (mut motion, parameters) = self.motion_with_terms(&conditions, terms);
                at.each_residual_with((&mut motion, &parameters), each)
            }
            None => at.each_residual(&self.problem.global_parameters(), each),
        };
        done.map_err(|reason| self.flight_error(flight, reason))
    }

    /// Copy of the normal equations of one flight without the columns that belong to coefficients of library terms.
    pub fn without_terms(&self, block: &NormalBlock) -> NormalBlock {
        let locals = block.local.nrows();
        let all: Vec<usize> = (0..locals + self.global_columns()).collect();
        block.select(&all[..locals], &all[locals..])
    }

    /// Removes a flight from the model and from `iterate`; returns whether it was found.
    pub fn set_aside(&mut self, file: &str, iterate: &mut Iterate) -> bool {
        let Some(flight) = self.flights.iter().position(|flight| flight.file == file) else {
            return false;
        };
        self.flights.remove(flight);
        iterate.local.remove(flight);
        true
    }

    pub fn flight_error(&self, flight: usize, reason: FlightError) -> FitError {
        FitError::Flight {
            file: self.flights[flight].file.clone(),
            reason,
        }
    }

    fn each_flight<R: Send>(
        &self,
        work: impl Fn(usize) -> Result<R, FlightError> + Sync,
    ) -> Result<Vec<R>, FitError> {
        let done = parallel::each_on(self.threads(), self.flights.len(), |flight| {
            self.context.options.fit.check_cancelled()?;
            work(flight).map_err(|reason| self.flight_error(flight, reason))
        });
        done.into_iter().collect()
    }

    /// A flight at the values of an iterate.
    pub fn flight_at<'p>(
        &'p self,
        problem: &'p FitProblem,
        iterate: &'p Iterate,
        flight: usize,
    ) -> FlightAt<'p> {
        let unknowns = (&iterate.global, &iterate.local[flight]);
        FlightAt::new(problem, &self.flights[flight], unknowns)
    }

    /// Equations of motion with the library terms, and the parameter of each global column.
    fn motion_with_terms<'c>(
        &self,
        conditions: &'c BoundModel<'c>,
        terms: &'c LibraryTerms,
    ) -> (impl DifferentiableRhs + use<'c>, Vec<ParamId>) {
        let first = self.problem.body.layout().parameters.len();
        let mut parameters = self.problem.global_parameters();
        parameters.extend((first..first + terms.terms.len()).map(ParamId::new));
        (terms.motion(conditions, first), parameters)
    }
}

// Cache of trajectories with sensitivities, integrated once for each linearization point.

/// Maximum size of one cache, bytes; other trajectories are integrated at each use.
const MAX_CACHE_BYTES: usize = 128 << 20;

/// States and sensitivities of a flight in the layout of `identify::linearise_with`; `None` until computed.
pub(crate) type CachedTrajectory = Option<Vec<f64>>;

/// Cache of the trajectories of all flights at one linearization point, with library terms.
#[derive(Debug)]
pub(crate) struct TrajectoryCache {
    /// One cache slot for each flight, by its index; the vector is empty if the cache is disabled.
    slots: Vec<Mutex<CachedTrajectory>>,
}

/// An estimation problem, values of all its unknowns, and a trajectory cache.
#[derive(Clone, Copy)]
pub(crate) struct LinearizationPoint<'p> {
    pub problem: &'p FitProblem,
    /// Values of all unknowns of the estimation problem: global parameters and initial states of the flights.
    pub iterate: &'p Iterate,
    pub cache: &'p TrajectoryCache,
}

impl TrajectoryCache {
    pub const DISABLED: Self = Self { slots: Vec::new() };

    pub fn for_flights(flights: usize) -> Self {
        Self {
            slots: (0..flights).map(|_| Mutex::new(None)).collect(),
        }
    }

    /// Whether the cache is disabled, that is, stores no trajectories.
    pub fn is_disabled(&self) -> bool {
        self.slots.is_empty()
    }

    /// Calls `work` with the cached trajectory of a flight, which it may write; stored up to [`MAX_CACHE_BYTES`].
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
