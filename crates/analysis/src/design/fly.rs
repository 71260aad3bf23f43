//! Integrates flights of throws, with and without derivatives.

use flight::release::Release;
use flight::throw::Throw;
use ode::{AlignedVec, Event, IntegrationOptions, Sensitivities};

use crate::design::path::Path;
use crate::design::throw_flight::{By, ThrowFlightError, ThrowFlights};

impl ThrowFlights<'_> {
    /// Integrates the flight of a throw to the ground. `near` is the release state of a similar throw, or none.
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
        Ok(Path {
            flights: self,
            layout: None,
            trajectory,
            columns: Vec::new(),
        })
    }

    /// Integrates the flight of a throw to the ground with the derivatives of its path with respect to the quantities
    /// `by`, exact up to the integration tolerance. `near` is the release state of a similar throw, or none.
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
        flight::cancellation::stop_if_cancelled();
        let state = self.state(throw, near)?;
        let thrown = self.body.thrown.bind(&self.parameters);
        let start = thrown.state_by_throw(throw, &state);
        let throws = by.iter().filter(|by| matches!(by, By::Throw(_))).count();
        let (mut columns, mut of_parameters, mut entries) = (Vec::new(), Vec::new(), Vec::new());
        for by in by {
            let (column, moved): (usize, Vec<f64>) = match *by {
                By::Throw(field) => {
                    let moved = start.column(field).iter().copied().collect();
                    (columns.len() - of_parameters.len(), moved)
                }
                By::Parameter(parameter) => {
                    of_parameters.push(parameter);
                    let moved = self.state_by_parameter(throw, &state, parameter);
                    (throws + of_parameters.len() - 1, moved)
                }
            };
            let moved = moved.into_iter().enumerate();
            entries.extend(moved.map(|(s, value)| (s, column, value)));
            columns.push(column);
        }
        let mut rhs = self.bound.rhs();
        // The first columns start along directions of the throw.
        let mut rhs = Sensitivities::new(&mut rhs, throws, &of_parameters);
        let augmented = rhs.initial_state(&state, &entries);
        let mut events = self.bound.limits_on::<AlignedVec>();
        events.push(Event::falls_to("ground", self.body.position[2], 0.0).terminal());
        let end = Release::MAX_DURATION;
        let trajectory = rhs.integrate_to_event((0.0, &augmented), end, options, &mut events)?;
        Ok(Path {
            flights: self,
            layout: Some(rhs.layout()),
            trajectory,
            columns,
        })
    }
}
