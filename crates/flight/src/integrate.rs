//! Integration of a bound model: the functions of the crate `ode`, compiled here instead of in each crate that calls them.

use ode::{Endpoint, Event, IntegrationError, IntegrationOptions, Trajectory};

use crate::{BoundModel, ModelState};

impl BoundModel<'_> {
    /// Integrates the model from the time `start.0` (s) and the state `start.1`: [`ode::integrate`].
    ///
    /// # Errors
    /// [`IntegrationError`] if the integration fails; those of the other methods are the same.
    pub fn integrate(
        &self,
        start: (f64, &ModelState),
        t_end: f64,
        options: &IntegrationOptions,
        events: &mut [Event<'_, ModelState>],
    ) -> Result<Trajectory, IntegrationError> {
        ode::integrate(&mut self.rhs(), start, t_end, options, events)
    }

    /// Integrates the model to the first terminal event: [`ode::integrate_to_event`].
    pub fn integrate_to_event(
        &self,
        start: (f64, &ModelState),
        t_end: f64,
        options: &IntegrationOptions,
        events: &mut [Event<'_, ModelState>],
    ) -> Result<Trajectory, IntegrationError> {
        ode::integrate_to_event(&mut self.rhs(), start, t_end, options, events)
    }

    /// Integrates the model without dense output: [`ode::integrate_to_end`].
    pub fn integrate_to_end(
        &self,
        start: (f64, &ModelState),
        t_end: f64,
        options: &IntegrationOptions,
        events: &mut [Event<'_, ModelState>],
    ) -> Result<Endpoint<ModelState>, IntegrationError> {
        ode::integrate_to_end(&mut self.rhs(), start, t_end, options, events)
    }

    /// Integrates the model and writes the states at `times` (s), concatenated, to `states`: [`ode::integrate_at`].
    pub fn integrate_at(
        &self,
        start: (f64, &ModelState),
        times: &[f64],
        options: &IntegrationOptions,
        events: &mut [Event<'_, ModelState>],
        states: &mut [f64],
    ) -> Result<Endpoint<ModelState>, IntegrationError> {
        ode::integrate_at(&mut self.rhs(), start, times, options, events, states)
    }
}
