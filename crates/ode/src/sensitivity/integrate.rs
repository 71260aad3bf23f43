//! Integration of a state with its sensitivities: the functions of the crate, compiled here instead of in each crate that
//! calls them.

use std::ops::Range;

use super::Sensitivities;
use crate::{AlignedVec, Endpoint, Event, IntegrationError, IntegrationOptions, Trajectory};

impl Sensitivities<'_> {
    /// [`integrate_at`](crate::integrate_at) from the time `start.0` and the augmented state `start.1`.
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

    /// [`integrate_to_event`](crate::integrate_to_event) of the augmented state.
    pub fn integrate_to_event(
        &mut self,
        start: (f64, &AlignedVec),
        t_end: f64,
        options: &IntegrationOptions,
        events: &mut [Event<'_, AlignedVec>],
    ) -> Result<Trajectory, IntegrationError> {
        crate::integrate_to_event(self, start, t_end, options, events)
    }

    /// [`integrate_with_callback`](crate::integrate_with_callback) of the augmented state.
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
