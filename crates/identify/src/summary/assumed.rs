//! What a release has where no column tells it, as further channels with values and standard deviations of their own.

use dataset::SummaryQuantity as Q;

use super::SummaryModel;
use crate::channel::{Channel, ChannelKind};
use crate::summary_value::{ASSUMED, SummaryValue, of_unit};

/// Value and standard deviation of what is unknown, SI; the value where no flight tells another.
const SPEED: (f64, f64) = (30.0, 100.0);
const LAUNCH: (f64, f64) = (0.2, 0.6);
const NOSE: (f64, f64) = (0.0, 0.2);
const HYZER: (f64, f64) = (0.0, 0.5);
const BALL_SPIN: (f64, f64) = (200.0, 300.0);
const BODY_SPIN: (f64, f64) = (0.0, 200.0);

impl SummaryModel {
    /// Channels for what releases of the model's body have by assumption; their noise groups begin at `group`. `usual` is
    /// the median of a quantity over the flights that measure it, SI.
    pub(crate) fn assumed(&self, group: usize, usual: impl Fn(Q) -> Option<f64>) -> Vec<Channel> {
        let exact =
            |value: SummaryValue, unit: &'static str| (value, unit, 0.0, of_unit(&ASSUMED, unit));
        let taken = |quantity: Q| exact(SummaryValue::Column(quantity), quantity.si_unit());
        let unknown = |quantity: Q, (value, sigma): (f64, f64)| {
            let value = usual(quantity).unwrap_or(value);
            (
                SummaryValue::Column(quantity),
                quantity.si_unit(),
                value,
                sigma,
            )
        };
        let mut all = vec![
            unknown(Q::Speed, SPEED),
            unknown(Q::Launch, LAUNCH),
            taken(Q::Heading),
        ];
        if self.thrown.has_attitude() {
            all.extend([
                unknown(Q::Nose, NOSE),
                unknown(Q::Hyzer, HYZER),
                unknown(Q::Spin, BODY_SPIN),
                taken(Q::Wobble),
                exact(SummaryValue::SideWobble, "rad"),
            ]);
            if self.vectors.iter().any(|(k, _)| *k == 4) {
                all.push(exact(SummaryValue::Turn, "rad"));
            }
        }
        if self.spin.is_some() {
            all.extend([
                unknown(Q::Spin, BALL_SPIN),
                taken(Q::SpinAxis),
                exact(SummaryValue::Rifle, "rad/s"),
            ]);
        }
        let channels = all.into_iter().enumerate();
        channels
            .map(|(index, (value, unit, assumed, sigma))| Channel {
                group: group + index,
                sigma: Some(sigma),
                is_exact: true,
                assumed: Some(assumed),
                ..Channel::new("", ChannelKind::Summary(value), 1, unit)
            })
            .collect()
    }

    /// Whether the quantity of an assumption is the spin of a point mass.
    pub(crate) fn is_spin_of_point(&self, value: SummaryValue) -> bool {
        let of_spin = [Q::Spin, Q::SpinAxis].map(SummaryValue::Column);
        self.spin.is_some() && (of_spin.contains(&value) || value == SummaryValue::Rifle)
    }

    /// States that are the spin of a point mass, if it is estimated.
    pub(crate) fn spin_states(&self) -> Option<[usize; 3]> {
        self.spin
    }
}
