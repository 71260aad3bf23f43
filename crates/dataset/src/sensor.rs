//! Sensors of a dataset other than markers, and the channels of their readings.

use model_spec::compose::Instrument;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::summary::{SummaryColumn, SummaryEvent, SummaryQuantity};

/// Distance, m, from a pose sensor of the virtual markers that represent its pose in computations with markers.
const REACH: f64 = 0.1;

/// Kind of quantity that a sensor measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SensorKind {
    /// Position and attitude of the body, for example from a fiducial tag or a rigid body of a motion-capture system.
    Pose,
    /// A quantity that the model predicts, other than the pose, such as an angular velocity.
    Instrument(Instrument),
    /// A column of a table of summaries, with one value for each flight.
    #[doc(hidden)]
    Summary(SummaryColumn),
}

/// A sensor whose measured values are columns of the flights' tables.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor {
    /// Name of the sensor; the names of its columns begin with it.
    pub name: String,
    /// Kind of quantity that the sensor measures.
    pub kind: SensorKind,
    /// Position of the sensor on the body, in the frame of the marker positions, m.
    pub position: [f64; 3],
    /// Whether the position of the sensor on the body is unknown and is estimated in the fit.
    pub position_is_unknown: bool,
    /// Standard deviation of one component of a reading (m, rad/s, m/s², m/s); `None` if unknown.
    pub sigma: Option<f64>,
    /// For a pose sensor: standard deviation of the attitude about one axis, rad; `None` if unknown.
    pub sigma_angle: Option<f64>,
}

/// One reading of a sensor channel, a quantity measured by the sensor: up to four values, unused ones 0. It is a
/// position, a vector in body axes, a speed, or the quaternion of an attitude (body to inertial, scalar part first).
pub type Reading = [f64; 4];

impl Sensor {
    /// Input of a ball that is its spin, rad/s.
    #[doc(hidden)]
    pub const SPIN: &str = "omega";

    /// Creates a sensor of unknown noise at a position on the body, m.
    pub fn new(name: &str, kind: SensorKind, position: [f64; 3]) -> Self {
        Self {
            name: name.to_owned(),
            kind,
            position,
            position_is_unknown: false,
            sigma: None,
            sigma_angle: None,
        }
    }

    /// Whether the sensor is a column of a table of summaries that tells what was seen after the release.
    #[doc(hidden)]
    pub fn is_outcome(&self) -> bool {
        matches!(self.kind, SensorKind::Summary(own) if own.quantity.event() != SummaryEvent::Release)
    }

    /// Whether the sensor is a column of a table of summaries that tells the spin at the release.
    #[doc(hidden)]
    pub fn is_spin(&self) -> bool {
        let of_spin = [SummaryQuantity::Spin, SummaryQuantity::SpinAxis];
        matches!(self.kind, SensorKind::Summary(own) if of_spin.contains(&own.quantity))
    }
}

impl SensorKind {
    /// Kinds of sensors under `[[sensors]]` by their names; not `marker`, which is read as a tracked point on the body.
    pub const ALL: [(Self, &'static str); 4] = [
        (Self::Pose, "pose"),
        (Self::Instrument(Instrument::Gyroscope), "gyroscope"),
        (Self::Instrument(Instrument::Accelerometer), "accelerometer"),
        (Self::Instrument(Instrument::Speed), "speed"),
    ];

    /// Name of the kind of sensor in `dataset.toml`, such as `gyroscope`.
    #[doc(hidden)]
    pub fn name(self) -> &'static str {
        match self {
            Self::Pose => "pose",
            Self::Instrument(instrument) => instrument.name(),
            Self::Summary(column) => column.quantity.name(),
        }
    }

    /// Unit of the components of a reading of this kind of sensor; for a pose, the unit of its position.
    #[doc(hidden)]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Pose => "m",
            Self::Instrument(Instrument::Gyroscope) => "rad/s",
            Self::Instrument(Instrument::Accelerometer) => "m/s^2",
            Self::Instrument(Instrument::Speed) => "m/s",
            Self::Summary(column) => column.unit.name(),
        }
    }

    /// For each channel (measured quantity) of this kind, the suffixes of its column names after the sensor's name.
    #[doc(hidden)]
    pub fn channels(self) -> &'static [&'static [&'static str]] {
        const VECTOR: &[&str] = &["_x", "_y", "_z"];
        const ATTITUDE: &[&str] = &["_qw", "_qx", "_qy", "_qz"];
        match self {
            Self::Pose => &[VECTOR, ATTITUDE],
            Self::Instrument(Instrument::Speed) | Self::Summary(_) => &[&[""]],
            Self::Instrument(_) => &[VECTOR],
        }
    }
}

/// Channels of all sensors, one after another: the sensor of each, and the suffixes of the names of its columns.
pub(super) fn channels(
    sensors: &[Sensor],
) -> impl Iterator<Item = (&Sensor, &'static [&'static str])> {
    let of = |sensor: &Sensor| sensor.kind.channels().iter();
    sensors
        .iter()
        .flat_map(move |sensor| of(sensor).map(move |endings| (sensor, *endings)))
}

/// The sensors, each with its first channel.
pub(super) fn with_channels(sensors: &[Sensor]) -> impl Iterator<Item = (&Sensor, usize)> {
    sensors.iter().scan(0, |next, sensor| {
        let channel = *next;
        *next += sensor.kind.channels().len();
        Some((sensor, channel))
    })
}

/// The pose sensors, each with the channel of its positions, which that of its attitudes follows.
pub(super) fn pose_sensors(sensors: &[Sensor]) -> impl Iterator<Item = (&Sensor, usize)> {
    with_channels(sensors).filter(|(sensor, _)| sensor.kind == SensorKind::Pose)
}

/// Rotation from body to inertial components for a reading of the attitude, a quaternion, scalar part first.
pub fn attitude([w, x, y, z]: Reading) -> UnitQuaternion<f64> {
    UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z))
}

/// Least share of the mean angular velocity, seen from the body, that is about an axis about which the body spins.
const SPIN_SHARE: f64 = 0.9;

/// Index of the body axis about which a body spins in flights, each given by its successive attitudes; `None` if it
/// turns by less than a turn, or about no axis of the body.
pub fn spin_axis<A>(flights: impl IntoIterator<Item = A>) -> Option<usize>
where
    A: IntoIterator<Item = UnitQuaternion<f64>>,
{
    let turned = turned(flights);
    let (axis, all) = (turned.iamax(), turned.norm());
    (all > std::f64::consts::TAU && turned[axis].abs() > SPIN_SHARE * all).then_some(axis)
}

/// Sum of the rotations between successive attitudes of flights, rad, in the axes of the body.
pub fn turned<A>(flights: impl IntoIterator<Item = A>) -> Vector3<f64>
where
    A: IntoIterator<Item = UnitQuaternion<f64>>,
{
    let mut turned = Vector3::zeros();
    for attitudes in flights {
        let mut before: Option<UnitQuaternion<f64>> = None;
        for attitude in attitudes {
            if let Some(before) = before.replace(attitude) {
                turned += (before.inverse() * attitude).scaled_axis();
            }
        }
    }
    turned
}

/// Three virtual marker points that represent a pose sensor at `position`, in the frame of the marker positions, m.
pub fn points_on_body(position: [f64; 3]) -> [[f64; 3]; 3] {
    let [x, y, z] = position;
    [
        [x + REACH, y, z],
        [x, y + REACH, z],
        [x - REACH, y - REACH, z],
    ]
}

/// Inertial positions, m, of the virtual markers of a pose sensor, from its two readings; `None` if one is missing.
pub fn points_seen(readings: &[Option<Reading>]) -> [Option<[f64; 3]>; 3] {
    let (Some(place), Some(turn)) = (readings[0], readings[1]) else {
        return [None; 3];
    };
    let turn = attitude(turn);
    let place = Vector3::new(place[0], place[1], place[2]);
    points_on_body([0.0; 3]).map(|point| Some((place + turn * Vector3::from(point)).into()))
}
