//! Integration of a state with its sensitivities: the functions of the crate, compiled here instead of in each crate that
//! calls them.

use std::ops::Range;

use super::Sensitivities;
use crate::aligned::AlignedVec;
use crate::error::IntegrationError;
use crate::event::Event;
use crate::options::IntegrationOptions;
use crate::solver::Endpoint;
use crate::trajectory::Trajectory;

impl Sensitivities<'_> {
    /// Integrates as [`integrate_at`](crate::integrate_at), from the time `start.0` and the augmented state `start.1`.
    ///
    /// # Errors
    /// [`IntegrationError`] if the integration fails; its `cause` is the return code.
    ///
    /// # Panics
    /// Under the conditions for which [`integrate_at`](crate::integrate_at) panics.
    pub fn integrate_at(
        &mut self,
        start: (f64, &AlignedVec),
        times: &[f64],
        options: &IntegrationOptions,
        events: &mut [Event<'_, AlignedVec>],
        states: &mut [f64],
    ) -> Result<Endpoint<AlignedVec>, IntegrationError> {
        crate::integrate_at(self, start, times, options, events, states)
    }

    /// Integrates as [`integrate_to_event`](crate::integrate_to_event), from the time `start.0` and the augmented state
    /// `start.1`.
    ///
    /// # Errors
    /// [`IntegrationError`] if the integration fails, or no terminal event occurs before the time `t_end`.
    pub fn integrate_to_event(
        &mut self,
        start: (f64, &AlignedVec),
        t_end: f64,
        options: &IntegrationOptions,
        events: &mut [Event<'_, AlignedVec>],
    ) -> Result<Trajectory, IntegrationError> {
        crate::integrate_to_event(self, start, t_end, options, events)
    }

    /// Integrates as [`integrate_with_callback`](crate::integrate_with_callback), from the time `start.0` and the
    /// augmented state `start.1`.
    ///
    /// # Errors
    /// [`IntegrationError`] if the integration fails; its `cause` is the return code.
    ///
    /// # Panics
    /// Under the conditions for which [`integrate_with_callback`](crate::integrate_with_callback) panics.
    pub fn integrate_with_callback(
        &mut self,
        start: (f64, &AlignedVec),
        times: &[f64],
        options: &IntegrationOptions,
        ranges: &[Range<usize>],
        callback: &mut dyn FnMut(usize, &[f64]),
    ) -> Result<(), IntegrationError> {
        crate::integrate_with_callback(self, start, times, options, ranges, callback)
    }
}
