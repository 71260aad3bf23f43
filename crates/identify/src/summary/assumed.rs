//! What a release has where no column tells it, as further channels with values and standard deviations of their own.

use dataset::{Flight, SummaryQuantity as Q};
use model_spec::layout::StateId;

use super::{SPIN, SummaryModel, SummaryValue, event};
use crate::channel::{Channel, ChannelKind};
use crate::problem::{FitProblem, KnownValues, StatePrior, wide_deviation};

/// Standard deviations of what is taken as exact, in the unit of its dimension: m/s, rad, rad/s, m. They are far below
/// what the path of a flight tells.
const EXACT: [(&str, f64); 4] = [("m/s", 0.02), ("rad", 3e-4), ("rad/s", 0.2), ("m", 1e-3)];

/// The same of what is taken as exact without being stated: the directions of a release bend with the attitude.
const ASSUMED: [(&str, f64); 4] = [("m/s", 0.02), ("rad", 2e-3), ("rad/s", 1.0), ("m", 1e-3)];

/// Standard deviation, SI, of a quantity of the release that a column states without one: it is taken as exact.
pub(crate) fn exact_deviation(unit: &str) -> f64 {
    of_unit(&EXACT, unit)
}

fn of_unit(deviations: &[(&str, f64)], unit: &str) -> f64 {
    let own = deviations.iter().find(|(of, _)| *of == unit);
    own.map_or(1e-3, |(_, sigma)| *sigma)
}

/// Value and standard deviation of what is unknown, SI; the value where no flight tells another.
const SPEED: (f64, f64) = (30.0, 100.0);
const LAUNCH: (f64, f64) = (0.2, 0.6);
const NOSE: (f64, f64) = (0.0, 0.2);
const HYZER: (f64, f64) = (0.0, 0.5);
const BALL_SPIN: (f64, f64) = (200.0, 300.0);
const BODY_SPIN: (f64, f64) = (0.0, 200.0);

impl SummaryModel {
    /// Channels for what releases of the model's body have by assumption; their noise groups begin at `group`. `usual` is
    /// what the flights that tell a quantity have, SI.
    pub(crate) fn assumed(&self, group: usize, usual: impl Fn(Q) -> Option<f64>) -> Vec<Channel> {
        let exact =
            |value: SummaryValue, unit: &'static str| (value, unit, 0.0, of_unit(&ASSUMED, unit));
        let told = |quantity: Q| exact(SummaryValue::Told(quantity), quantity.si_unit());
        let unknown = |quantity: Q, (value, sigma): (f64, f64)| {
            let value = usual(quantity).unwrap_or(value);
            (
                SummaryValue::Told(quantity),
                quantity.si_unit(),
                value,
                sigma,
            )
        };
        let mut all = vec![
            unknown(Q::Speed, SPEED),
            unknown(Q::Launch, LAUNCH),
            told(Q::Heading),
        ];
        if self.thrown.has_attitude() {
            all.extend([
                unknown(Q::Nose, NOSE),
                unknown(Q::Hyzer, HYZER),
                unknown(Q::Spin, BODY_SPIN),
                told(Q::Wobble),
                exact(SummaryValue::SideWobble, "rad"),
            ]);
            if self.vectors.iter().any(|(k, _)| *k == 4) {
                all.push(exact(SummaryValue::Turn, "rad"));
            }
        }
        if self.spin.is_some() {
            all.extend([
                unknown(Q::Spin, BALL_SPIN),
                told(Q::SpinAxis),
                exact(SummaryValue::Rifle, "rad/s"),
            ]);
        }
        let channels = all.into_iter().enumerate();
        channels
            .map(|(index, (value, unit, assumed, sigma))| Channel {
                name: String::new(),
                kind: ChannelKind::Summary(value),
                position: [0.0; 3],
                components: 1,
                group: group + index,
                sigma: Some(sigma),
                scale: 1.0,
                unit,
                to_si: 1.0,
                is_exact: true,
                assumed: Some(assumed),
            })
            .collect()
    }

    /// Whether the quantity of an assumption is the spin of a point mass.
    pub(crate) fn is_spin_of_point(&self, value: SummaryValue) -> bool {
        let of_spin = [Q::Spin, Q::SpinAxis].map(SummaryValue::Told);
        self.spin.is_some() && (of_spin.contains(&value) || value == SummaryValue::Rifle)
    }

    /// States that are the spin of a point mass, if it is estimated.
    pub(crate) fn spin_states(&self) -> Option<[usize; 3]> {
        self.spin
    }
}

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
        let told = |kind: ChannelKind, measured: &[Option<[f64; 3]>]| {
            let channels = self.channels.iter().zip(measured);
            channels
                .into_iter()
                .any(|(own, seen)| own.kind == kind && seen.is_some())
        };
        let all = self.channels.iter().filter(|own| event(own.kind).is_some());
        if !all.into_iter().any(|own| told(own.kind, measured)) {
            return false;
        }
        let hold = |state: usize, value: f64, known: &mut KnownValues| {
            let id = StateId::new(state);
            if known.states.iter().all(|(own, _)| *own != id) {
                known.states.push((id, value));
            }
        };
        let [x, y, z] = summary.position;
        let height = ChannelKind::Summary(SummaryValue::Told(Q::Height));
        for state in [x, y] {
            hold(state, 0.0, known);
        }
        if !told(height, measured) {
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
        let spin_is_known = flight.known.contains_key(SPIN);
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
            if !(told(own.kind, measured) || spin_is_known && summary.is_spin_of_point(of)) {
                measured[place] = Some([value; 3]);
            }
        }
        true
    }
}
