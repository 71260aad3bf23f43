//! Flights, unknowns and counters that the stages of a fit pass on.

use nalgebra::DVector;

use crate::error::{ExcludedFlight, FitError, FlightError};
use crate::ids::FlightId;
use crate::least_squares::{FailedFlight, Iterate, Solution};
use crate::observations::Observations;

/// Part of the time to the failure of a trajectory over which the flight is used.
const FLYABLE_PART: f64 = 0.7;

/// Flights that are fitted with the values of all unknowns, and flights that were excluded.
#[derive(Clone)]
pub(crate) struct State {
    /// Index in the dataset of each flight that is fitted.
    pub ids: Vec<FlightId>,
    /// Observations of these flights.
    pub flights: Vec<Observations>,
    /// Global parameters.
    pub global: DVector<f64>,
    /// Initial state of each flight.
    pub local: Vec<DVector<f64>>,
    /// Time up to which each flight is used, s from its first sample; infinite unless it cannot be flown further yet.
    pub limits: Vec<f64>,
    /// Flights that cannot be fitted.
    pub excluded: Vec<ExcludedFlight>,
    /// Median time between samples, s.
    pub interval: f64,
    /// Number of least-squares steps tried so far.
    pub steps: usize,
    /// Number of noise estimates so far.
    pub rounds: usize,
}

impl State {
    /// State without flights.
    pub fn new(global: DVector<f64>, interval: f64) -> Self {
        Self {
            ids: Vec::new(),
            flights: Vec::new(),
            global,
            local: Vec::new(),
            limits: Vec::new(),
            excluded: Vec::new(),
            interval,
            steps: 0,
            rounds: 0,
        }
    }

    /// Values of all unknowns.
    pub fn iterate(&self) -> Iterate {
        Iterate {
            global: self.global.clone(),
            local: self.local.clone(),
        }
    }

    /// Takes over the iterate and the step count of a solution.
    pub fn take(&mut self, solution: &Solution) {
        self.global.clone_from(&solution.iterate.global);
        self.local.clone_from(&solution.iterate.local);
        self.steps += solution.iterations;
    }

    /// Adds a flight with its initial state.
    pub fn push(&mut self, id: FlightId, observations: Observations, local: DVector<f64>) {
        self.ids.push(id);
        self.flights.push(observations);
        self.local.push(local);
        self.limits.push(f64::INFINITY);
    }

    /// Number of samples of each flight up to `horizon`, s, and its own limit.
    pub fn samples_until(&self, horizon: f64) -> Vec<usize> {
        let flights = self.flights.iter().zip(&self.limits);
        flights
            .map(|(flight, limit)| {
                let end = flight.times.first().copied().unwrap_or(0.0) + horizon.min(*limit);
                flight.samples_until(end).max(1)
            })
            .collect()
    }

    /// Limits each flight of `failures` to the part that can be flown; flights that are limited already and do not fail
    /// may be flown twice as far from now on.
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

    /// Excludes flights, by their positions in this state. The positions of later flights change.
    ///
    /// # Errors
    /// [`FitError::NoUsableFlight`] if no flight is left.
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
        retain(&mut self.limits, &is_kept);
        if self.flights.is_empty() {
            let mut excluded = std::mem::take(&mut self.excluded);
            excluded.sort_unstable_by_key(|excluded| excluded.flight);
            return Err(FitError::NoUsableFlight(excluded));
        }
        Ok(())
    }
}

/// Keeps the values whose flag is set.
pub(super) fn retain<T>(values: &mut Vec<T>, is_kept: &[bool]) {
    let mut flags = is_kept.iter();
    values.retain(|_| flags.next().is_none_or(|kept| *kept));
}
