//! Integrates flights of throws, with and without derivatives.

use flight::release::Release;
use flight::throw::Throw;
use ode::{AlignedVec, Event, IntegrationOptions};

use crate::design::path::Path;
use crate::design::throw_flight::{By, ThrowFlightError, ThrowFlights};

impl ThrowFlights<'_> {
    /// Integrates the flight of a throw to the ground. `near` is the release state (initial state) of a similar throw,
    /// which speeds up the search for the release state of this throw.
    ///
    /// # Errors
    /// [`ThrowFlightError`] if no state has the motion of the throw, or if the flight leaves the model's limits or
    /// does not end.
    pub fn fly(
        &self,
        throw: &Throw,
        near: Option<&[f64]>,
        options: &IntegrationOptions,
    ) -> Result<Path<'_>, ThrowFlightError> {
        let state = self.state(throw, near)?;
        let trajectory = self.trajectory(&state, options)?;
        Ok(Path::new(self, None, trajectory, Vec::new()))
    }

    /// Integrates the flight of a throw to the ground, with the derivatives of its path with respect to the quantities
    /// in `by`, exact up to the integration tolerance. `near` is the release state (initial state) of a similar throw,
    /// which speeds up the search for the release state of this throw.
    ///
    /// # Errors
    /// [`ThrowFlightError`] if no state has the motion of the throw, or if the flight leaves the model's limits or
    /// does not end.
    pub fn fly_with_derivatives(
        &self,
        throw: &Throw,
        near: Option<&[f64]>,
        by: &[By],
        options: &IntegrationOptions,
    ) -> Result<Path<'_>, ThrowFlightError> {
        let state = self.state(throw, near)?;
        let of_throw: Vec<usize> = by
            .iter()
            .filter_map(|by| match by {
                By::Throw(field) => Some(*field),
                By::Parameter(_) => None,
            })
            .collect();
        let of_parameters: Vec<usize> = by
            .iter()
            .filter_map(|by| match by {
                By::Parameter(index) => Some(*index),
                By::Throw(_) => None,
            })
            .collect();
        let start = self
            .body
            .thrown
            .bind(&self.parameters)
            .state_by_throw(throw, &state);
        let mut rhs = self.sensitivities(of_throw.len(), &of_parameters);
        let mut entries = Vec::new();
        for (column, field) in of_throw.iter().enumerate() {
            entries.extend((0..state.len()).map(|s| (s, column, start[(s, *field)])));
        }
        for (column, parameter) in of_parameters.iter().enumerate() {
            let moved = self.state_by_parameter(throw, &state, *parameter);
            let column = of_throw.len() + column;
            entries.extend(
                moved
                    .into_iter()
                    .enumerate()
                    .map(|(s, value)| (s, column, value)),
            );
        }
        let augmented = rhs.initial_state_with(&state, &entries);
        let mut events = self.bound.limits_on::<AlignedVec>();
        events.push(Event::falls_to("ground", self.body.position[2], 0.0).terminal());
        let end = Release::MAX_DURATION;
        let trajectory = rhs.integrate_to_event((0.0, &augmented), end, options, &mut events)?;
        let mut throws = 0..of_throw.len();
        let mut parameters = of_throw.len()..by.len();
        let columns = by.iter().map(|by| match by {
            By::Throw(_) => throws.next(),
            By::Parameter(_) => parameters.next(),
        });
        let columns = columns.flatten().collect();
        Ok(Path::new(self, Some(rhs.layout()), trajectory, columns))
    }
}
