//! Integration of a bound model: the functions of the crate `ode`, compiled here instead of in each crate that calls them.

use ode::{Endpoint, Event, IntegrationError, IntegrationOptions, Trajectory};

use crate::bound_model::BoundModel;
use crate::compiled_model::ModelState;

impl BoundModel<'_> {
    /// Integrates the model as [`ode::integrate`] from the time `start.0` (s) and the state `start.1`.
    ///
    /// # Errors
    /// [`IntegrationError`] if the integration fails; its `cause` is the return code.
    pub fn integrate(
        &self,
        start: (f64, &ModelState),
        t_end: f64,
        options: &IntegrationOptions,
        events: &mut [Event<'_, ModelState>],
    ) -> Result<Trajectory, IntegrationError> {
        ode::integrate(&mut self.rhs(), start, t_end, options, events)
    }

    /// Integrates the model as [`ode::integrate_to_event`] from the time `start.0` (s) and the state `start.1`.
    ///
    /// # Errors
    /// [`IntegrationError`] if the integration fails, or no terminal event occurs before the time `t_end` (s).
    pub fn integrate_to_event(
        &self,
        start: (f64, &ModelState),
        t_end: f64,
        options: &IntegrationOptions,
        events: &mut [Event<'_, ModelState>],
    ) -> Result<Trajectory, IntegrationError> {
        ode::integrate_to_event(&mut self.rhs(), start, t_end, options, events)
    }

    /// Integrates the model as [`ode::integrate_to_end`] from the time `start.0` (s) and the state `start.1`.
    ///
    /// # Errors
    /// [`IntegrationError`] if the integration fails; its `cause` is the return code.
    pub fn integrate_to_end(
        &self,
        start: (f64, &ModelState),
        t_end: f64,
        options: &IntegrationOptions,
        events: &mut [Event<'_, ModelState>],
    ) -> Result<Endpoint<ModelState>, IntegrationError> {
        ode::integrate_to_end(&mut self.rhs(), start, t_end, options, events)
    }

    /// Integrates the model as [`ode::integrate_at`] from the time `start.0` (s) and the state `start.1`, and writes the
    /// states at `times` (s), concatenated, to `states`.
    ///
    /// # Errors
    /// [`IntegrationError`] if the integration fails; its `cause` is the return code.
    ///
    /// # Panics
    /// Under the conditions for which [`ode::integrate_at`] panics.
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
