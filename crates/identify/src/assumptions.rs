//! What the release of a flight that is a summary has by assumption.

use dataset::{Flight, Sensor, SummaryQuantity as Q};
use model_spec::layout::StateId;

use crate::channel::ChannelKind;
use crate::problem::{FitProblem, KnownValues, StatePrior, wide_deviation};
use crate::summary::event;
use crate::summary_value::SummaryValue;

impl FitProblem {
    /// Adds what the release of a summary has by assumption to the values of its only sample, and to what is known of its
    /// states. Returns whether the flight is a summary.
    pub(crate) fn assume(
        &self,
        flight: &Flight,
        measured: &mut [Option<[f64; 3]>],
        known: &mut KnownValues,
    ) -> bool {
        let Some(summary) = &self.summary else {
            return false;
        };
        let is_measured = |kind: ChannelKind, measured: &[Option<[f64; 3]>]| {
            let channels = self.channels.iter().zip(measured);
            channels
                .into_iter()
                .any(|(own, seen)| own.kind == kind && seen.is_some())
        };
        let all = self.channels.iter().filter(|own| event(own.kind).is_some());
        if !all.into_iter().any(|own| is_measured(own.kind, measured)) {
            return false;
        }
        let hold = |state: usize, value: f64, known: &mut KnownValues| {
            let id = StateId::new(state);
            if known.states.iter().all(|(own, _)| *own != id) {
                known.states.push((id, value));
            }
        };
        let [x, y, z] = summary.position;
        let height = ChannelKind::Summary(SummaryValue::Column(Q::Height));
        for state in [x, y] {
            hold(state, 0.0, known);
        }
        if !is_measured(height, measured) {
            hold(z, 0.0, known);
        }
        for &state in &summary.held {
            hold(state, self.model.states[state].value, known);
        }
        for &state in &summary.constant {
            let own = &self.model.states[state];
            known.priors.push(StatePrior {
                state: StateId::new(state),
                mean: own.value,
                sigma: wide_deviation(&own.unit_text),
                is_measured: false,
            });
        }
        let spin_is_known = flight.known.contains_key(Sensor::SPIN);
        if let Some(spin) = summary.spin_states().filter(|_| !spin_is_known) {
            known.states.retain(|(own, _)| !spin.contains(&own.index()));
            known
                .priors
                .retain(|own| !spin.contains(&own.state.index()));
        }
        for (place, own) in self.channels.iter().enumerate() {
            let (Some(value), ChannelKind::Summary(of)) = (own.assumed, own.kind) else {
                continue;
            };
            if !(is_measured(own.kind, measured) || spin_is_known && summary.is_spin_of_point(of)) {
                measured[place] = Some([value; 3]);
            }
        }
        true
    }
}
