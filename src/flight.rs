//! Simulated flights.

use flight::FlightParameters;
use flight::release::Release;
use ode::Trajectory;

use crate::Model;

/// Simulated flight of a model: states, marker positions and events from the release to the end.
#[derive(Clone, Debug)]
pub struct Flight {
    model: Model,
    parameters: FlightParameters,
    trajectory: Trajectory,
}

impl Flight {
    pub(crate) fn new(model: Model, release: &Release, trajectory: Trajectory) -> Flight {
        Flight {
            parameters: model.compiled().release_parameters(release),
            model,
            trajectory,
        }
    }

    /// Duration of the flight, s.
    pub fn duration(&self) -> f64 {
        self.trajectory.end - self.trajectory.start
    }

    /// Value of a state at time `t`, s; `None` for an unknown name or a time outside the flight.
    pub fn state(&self, name: &str, t: f64) -> Option<f64> {
        let state = self.model.compiled().layout().state(name)?;
        Some(self.trajectory.sample(t)?[state.index()])
    }

    /// Positions `[time][marker]` in the inertial frame, m, of markers at positions in the body frame, m. `None` for times
    /// outside the flight and for a model without a measurement equation.
    pub fn marker_positions(
        &self,
        times: &[f64],
        markers: &[[f64; 3]],
    ) -> Vec<Vec<Option<[f64; 3]>>> {
        let compiled = self.model.compiled();
        let is_observed = !compiled.layout().marker.is_empty();
        let bound = compiled.bind(self.parameters.clone());
        let mut observer = bound.observer();
        let sampled = times.iter().map(|&t| {
            let state = self.trajectory.sample(t).filter(|_| is_observed);
            let position = |marker| Some(observer.position(t, state.as_ref()?, marker));
            markers.iter().map(position).collect()
        });
        sampled.collect()
    }

    /// CSV table of time and states, SI, with `rate` rows per second and one at the end of the flight.
    ///
    /// # Panics
    /// If the rate is not positive.
    pub fn to_csv(&self, rate: f64) -> String {
        let names: Vec<&str> = self.model.states().collect();
        flight::trajectory_csv(&self.trajectory, &names, rate)
    }
}
