//! Measurement channels: a vector or a scalar per sample of a flight, with one residual for each value.

use model_spec::compose::Instrument;

use crate::noise::overall;
use crate::summary_value::{SummaryValue, exact_deviation};
use dataset::{Dataset, SensorKind};

/// Kind of sensor of measured positions: of markers or, without them, of pose sensors.
pub const MARKER: &str = "marker";

/// What the positions of pose sensors are called among what is measured.
pub(crate) const POSITION: &str = "position";

/// Key of the attitudes of poses in the maps by kind of sensor.
pub(crate) const ATTITUDE: &str = "attitude";

/// Quantity that a channel measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChannelKind {
    /// Position of a marker in the inertial frame, m; contains the index of the marker in the dataset.
    Marker(usize),
    /// Position of a pose sensor in the inertial frame, m.
    Position,
    /// Attitude of the body as a rotation vector, rad. The residual is a rotation vector in the inertial frame.
    Attitude,
    /// Value measured by an instrument; contains its index in [`FitProblem::instruments`](crate::FitProblem).
    Instrument(usize),
    /// Value of a summary: of the release, or at an event of the flight.
    Summary(SummaryValue),
}

/// A measurement channel of the observations: a marker, or one quantity of a sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Name of the marker or sensor.
    pub name: String,
    /// Quantity that the channel measures.
    pub kind: ChannelKind,
    /// Position of the marker or sensor in the frame in which the markers are fixed (usually the body frame), m.
    pub position: [f64; 3],
    /// Number of components of a measured value: 3 for a vector, 1 for a speed.
    pub components: usize,
    /// Index of the noise group of the channel. All channels of a group share the parameters of one noise process.
    pub group: usize,
    /// Standard deviation of the noise of one component, in `unit`; `None` if the dataset does not give it.
    pub sigma: Option<f64>,
    /// Factor by which residuals are multiplied, m per `unit`; 1 for markers. One noise level then serves all channels.
    pub scale: f64,
    /// Unit of one component of the measured value.
    pub unit: &'static str,
    /// Value of `unit` in SI, with a sign where the channel counts the other way than its quantity.
    pub to_si: f64,
    /// Whether the value is taken as exact, with a standard deviation far below what the flights tell.
    pub is_exact: bool,
    /// For a quantity of the release that no column states in some flight: its value there.
    pub assumed: Option<f64>,
    /// Standard deviation of the rounding errors of the values along each axis, in `unit`; 0 if they are not rounded.
    pub(crate) rounding: [f64; 3],
    /// Whether the values of some axis stay the same from most samples to the next, so that rounding errors may be as slow
    /// as the motion.
    pub(crate) repeats: bool,
}

impl Channel {
    /// A channel whose noise is not known, in the first noise group.
    pub(crate) fn new(
        name: &str,
        kind: ChannelKind,
        components: usize,
        unit: &'static str,
    ) -> Self {
        Self {
            name: name.to_owned(),
            kind,
            position: [0.0; 3],
            components,
            group: 0,
            sigma: None,
            scale: 1.0,
            unit,
            to_si: 1.0,
            is_exact: false,
            assumed: None,
            rounding: [0.0; 3],
            repeats: false,
        }
    }

    pub(crate) fn is_marker(&self) -> bool {
        matches!(self.kind, ChannelKind::Marker(_))
    }

    /// Name of the quantity of a column of summaries that is compared with its prediction.
    pub fn summary(&self) -> Option<&'static str> {
        match self.kind {
            ChannelKind::Summary(SummaryValue::Column(quantity)) => {
                (self.assumed.is_none() && !self.is_exact).then(|| quantity.name())
            }
            _ => None,
        }
    }

    /// Root mean square over the axes of the standard deviations of the rounding errors, in `unit`.
    pub(crate) fn overall_rounding(&self) -> f64 {
        overall(self.rounding)
    }

    /// Whether the channel measures the position of a point, m.
    pub fn is_position(&self) -> bool {
        self.is_marker() || self.kind == ChannelKind::Position
    }
}

/// Returns the channels of a dataset, markers first, and the different kinds of instruments among the sensors.
pub(crate) fn of_dataset(dataset: &Dataset) -> (Vec<Channel>, Vec<Instrument>) {
    let markers = dataset.markers.iter().enumerate();
    let mut channels: Vec<Channel> = markers
        .map(|(index, marker)| Channel {
            position: marker.position,
            sigma: dataset.sigma,
            ..Channel::new(&marker.name, ChannelKind::Marker(index), 3, "m")
        })
        .collect();
    let mut instruments: Vec<Instrument> = Vec::new();
    let mut group = usize::from(!channels.is_empty());
    for sensor in &dataset.sensors {
        let to_si = match sensor.kind {
            SensorKind::Summary(column) => column.to_si(),
            _ => 1.0,
        };
        let mut add = |kind, components, sigma, unit| {
            channels.push(Channel {
                position: sensor.position,
                group,
                sigma,
                to_si,
                ..Channel::new(&sensor.name, kind, components, unit)
            });
            group += 1;
        };
        match sensor.kind {
            SensorKind::Pose => {
                add(ChannelKind::Position, 3, sensor.sigma, "m");
                add(ChannelKind::Attitude, 3, sensor.sigma_angle, "rad");
            }
            SensorKind::Summary(column) => {
                let exact = exact_deviation(column.quantity.si_unit()) / to_si.abs();
                let sigma = sensor.sigma.or((!sensor.is_outcome()).then_some(exact));
                let kind = ChannelKind::Summary(SummaryValue::Column(column.quantity));
                add(kind, 1, sigma, column.unit.name());
                if let Some(own) = channels.last_mut() {
                    own.is_exact = sensor.sigma.is_none() && !sensor.is_outcome();
                }
            }
            SensorKind::Instrument(instrument) => {
                let known = instruments.iter().position(|own| *own == instrument);
                let place = known.unwrap_or_else(|| {
                    instruments.push(instrument);
                    instruments.len() - 1
                });
                let kind = ChannelKind::Instrument(place);
                let (components, unit) = (instrument.components(), sensor.kind.unit());
                add(kind, components, sensor.sigma, unit);
            }
        }
    }
    (channels, instruments)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn what_is_taken_as_exact_is_as_exact_in_any_unit() {
        let deviation = |unit: &str| {
            let manifest = format!(
                "model = \"golf_ball\"\n[[summaries]]\nfile = \"a.csv\"\n[summaries.columns]\n\
                 v = {{ is = \"speed\", unit = \"{unit}\" }}\nc = {{ is = \"carry\", unit = \"m\" }}\n"
            );
            let tables = BTreeMap::from([("a.csv".to_owned(), "v,c\n60,150\n".to_owned())]);
            let dataset = dataset::from_texts(&manifest, &tables).expect("a dataset");
            let channels = of_dataset(&dataset).0;
            let speed = channels
                .iter()
                .find(|own| own.name == "v")
                .expect("the speed");
            speed.sigma.expect("exact") * speed.to_si
        };
        let expected = deviation("m/s");
        assert!(expected > 0.0 && (deviation("mph") / expected - 1.0).abs() < 1e-12);
    }
}
