//! Flights, unknowns and counters that are passed between the stages of a fit.

use nalgebra::DVector;

use crate::error::{ExcludedFlight, FitError, FlightError};
use crate::ids::FlightId;
use crate::initial_state::InitialGuess;
use crate::least_squares::{FailedFlight, Iterate, Solution};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::problem::FitProblem;

/// Part of the time before the failure of its integration up to which a flight is used.
const FLYABLE_PART: f64 = 0.7;

/// A fit in progress: the flights that are fitted, with the values of all unknowns, and excluded flights.
#[derive(Clone)]
pub(crate) struct State<'a> {
    pub problem: &'a FitProblem,
    pub options: &'a FitOptions<'a>,
    pub ids: Vec<FlightId>,
    pub flights: Vec<Observations>,
    pub global: DVector<f64>,
    pub local: Vec<DVector<f64>>,
    /// All initial guesses of each flight; several if its samples do not determine its motion.
    pub guesses: Vec<Vec<InitialGuess>>,
    /// Time after the first sample up to which each flight is used, s; infinite if the whole flight is used.
    pub limits: Vec<f64>,
    pub excluded: Vec<ExcludedFlight>,
    /// Median time between successive samples of the flights, s.
    pub interval: f64,
    /// Number of least-squares steps that the fit has tried so far.
    pub steps: usize,
    /// Number of times that the noise has been estimated so far.
    pub rounds: usize,
    /// What the fit has found against its own estimates, one sentence each.
    pub doubts: Vec<String>,
}

impl<'a> State<'a> {
    /// A fit in progress without flights, at the parameters `global`, SI; `interval` is that between samples, s.
    pub fn new(
        problem: &'a FitProblem,
        options: &'a FitOptions<'a>,
        global: DVector<f64>,
        interval: f64,
    ) -> Self {
        Self {
            problem,
            options,
            ids: Vec::new(),
            flights: Vec::new(),
            global,
            local: Vec::new(),
            guesses: Vec::new(),
            limits: Vec::new(),
            excluded: Vec::new(),
            interval,
            steps: 0,
            rounds: 0,
            doubts: Vec::new(),
        }
    }

    /// Copy of this fit in progress that has the same global parameters but no flights.
    pub fn without_flights(&self) -> Self {
        Self::new(
            self.problem,
            self.options,
            self.global.clone(),
            self.interval,
        )
    }

    /// The present global parameters and initial states, as an iterate (starting point) of the least-squares solver.
    pub fn iterate(&self) -> Iterate {
        Iterate {
            global: self.global.clone(),
            local: self.local.clone(),
        }
    }

    /// Sets the values of all unknowns: the global parameters and the initial states.
    pub fn set(&mut self, iterate: Iterate) {
        (self.global, self.local) = (iterate.global, iterate.local);
    }

    /// Sets the unknowns to those of a solution and counts its steps.
    pub fn take(&mut self, solution: &Solution) {
        self.global.clone_from(&solution.iterate.global);
        self.local.clone_from(&solution.iterate.local);
        self.steps += solution.iterations;
    }

    /// Adds a flight with its initial state. All samples of the flight are used: its entry in `limits` is infinite.
    pub fn push(&mut self, id: FlightId, observations: Observations, local: DVector<f64>) {
        self.ids.push(id);
        self.flights.push(observations);
        self.local.push(local);
        self.guesses.push(Vec::new());
        self.limits.push(f64::INFINITY);
    }

    /// Adds a flight of another fit in progress, with its present initial state and its guesses.
    pub fn push_from(&mut self, other: &Self, flight: usize) {
        let (observations, local) = (&other.flights[flight], &other.local[flight]);
        self.push(other.ids[flight], observations.clone(), local.clone());
        self.guesses[self.ids.len() - 1].clone_from(&other.guesses[flight]);
    }

    /// Place of a flight among those that are fitted.
    pub fn place(&self, id: FlightId) -> Option<usize> {
        self.ids.iter().position(|own| *own == id)
    }

    /// Moves flights to other initial states, where there are any; returns whether one moved.
    pub fn move_to(&mut self, found: Vec<Option<DVector<f64>>>) -> bool {
        let has_moved = found.iter().any(Option::is_some);
        for (local, found) in self.local.iter_mut().zip(found) {
            if let Some(found) = found {
                *local = found;
            }
        }
        has_moved
    }

    /// Number of samples of each flight up to `horizon`, s after its first sample, or up to its time limit.
    pub fn samples_until(&self, horizon: f64) -> Vec<usize> {
        let flights = self.flights.iter().zip(&self.limits);
        flights
            .map(|(flight, limit)| {
                let end = flight.times.first().copied().unwrap_or(0.0) + horizon.min(*limit);
                flight.samples_until(end).max(1)
            })
            .collect()
    }

    /// Limits flights that failed to a part of the time before their failure; doubles the limits of the others.
    pub fn limit_to_flyable(&mut self, failures: &[FailedFlight]) {
        for limit in &mut self.limits {
            *limit *= 2.0;
        }
        for (flight, reason) in failures {
            if let FlightError::Integration(failure) = reason {
                let start = self.flights[*flight].times.first().copied().unwrap_or(0.0);
                self.limits[*flight] = FLYABLE_PART * (failure.time - start).max(0.0);
            }
        }
    }

    pub fn exclude(&mut self, failures: Vec<FailedFlight>) -> Result<(), FitError> {
        let mut is_kept = vec![true; self.flights.len()];
        for (flight, reason) in failures {
            if std::mem::replace(&mut is_kept[flight], false) {
                self.excluded.push(ExcludedFlight {
                    flight: self.ids[flight],
                    file: self.flights[flight].file.clone(),
                    reason,
                });
            }
        }
        retain(&mut self.ids, &is_kept);
        retain(&mut self.flights, &is_kept);
        retain(&mut self.local, &is_kept);
        retain(&mut self.guesses, &is_kept);
        retain(&mut self.limits, &is_kept);
        if self.flights.is_empty() {
            let mut excluded = std::mem::take(&mut self.excluded);
            excluded.sort_unstable_by_key(|excluded| excluded.flight);
            return Err(FitError::NoUsableFlight(excluded));
        }
        Ok(())
    }
}

pub(super) fn retain<T>(values: &mut Vec<T>, is_kept: &[bool]) {
    let mut flags = is_kept.iter();
    values.retain(|_| flags.next().is_none_or(|kept| *kept));
}
