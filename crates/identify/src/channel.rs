//! Channels: what a flight's residuals are of, one vector or number per sample each.

use model_spec::compose::Instrument;

use crate::dataset::{Dataset, SensorKind};

/// What a channel measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChannelKind {
    /// Position of a point of the body in the inertial frame, m; of the marker with this index.
    Marker(usize),
    /// Position of a pose sensor in the inertial frame, m.
    Position,
    /// Attitude of the body, rad: its residual is a rotation vector in the inertial frame.
    Attitude,
    /// Quantity of an instrument, by its place in [`FitProblem::instruments`](crate::FitProblem).
    Instrument(usize),
}

/// One channel of the observations.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Name of the marker or sensor.
    pub name: String,
    /// What it measures.
    pub kind: ChannelKind,
    /// Where it sits, in the frame that markers are fixed in, m.
    pub position: [f64; 3],
    /// Number of components: 3, or 1 of a speed.
    pub components: usize,
    /// Group of channels whose noise is one process.
    pub group: usize,
    /// Standard deviation of a component that the dataset states, in the unit of the channel.
    pub sigma: Option<f64>,
    /// Metres per unit of the channel, by which its residuals are multiplied: 1 for markers. All channels then have about the
    /// same noise, so that one scale serves losses and tolerances.
    pub scale: f64,
    /// Unit of a component.
    pub unit: &'static str,
}

impl Channel {
    /// Whether the channel is a position of a point, m.
    pub fn is_position(&self) -> bool {
        matches!(self.kind, ChannelKind::Marker(_) | ChannelKind::Position)
    }
}

/// Channels of a dataset: its markers, then those of its sensors; and the instruments among them.
pub(crate) fn of_dataset(dataset: &Dataset) -> (Vec<Channel>, Vec<Instrument>) {
    let markers = dataset.markers.iter().enumerate();
    let mut channels: Vec<Channel> = markers
        .map(|(index, marker)| Channel {
            name: marker.name.clone(),
            kind: ChannelKind::Marker(index),
            position: marker.position,
            components: 3,
            group: 0,
            sigma: dataset.sigma,
            scale: 1.0,
            unit: "m",
        })
        .collect();
    let mut instruments: Vec<Instrument> = Vec::new();
    let mut group = usize::from(!channels.is_empty());
    for sensor in &dataset.sensors {
        let mut add = |kind, components, sigma, unit| {
            channels.push(Channel {
                name: sensor.name.clone(),
                kind,
                position: sensor.position,
                components,
                group,
                sigma,
                scale: 1.0,
                unit,
            });
            group += 1;
        };
        match sensor.kind {
            SensorKind::Pose => {
                add(ChannelKind::Position, 3, sensor.sigma, "m");
                add(ChannelKind::Attitude, 3, sensor.sigma_angle, "rad");
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
