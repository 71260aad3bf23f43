//! Sensors of a dataset other than markers, and the channels that their readings have.

use model_spec::compose::Instrument;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// Distance from a pose's origin of the points that stand for it where a motion is found by points, m.
const REACH: f64 = 0.1;

/// What a sensor measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SensorKind {
    /// Position and attitude of the body, such as from a tag or a rigid body of a motion-capture system.
    Pose,
    /// A quantity of the model.
    Instrument(Instrument),
}

/// A sensor whose readings are columns of the tables.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor {
    /// Name of the sensor, which begins the names of its columns.
    pub name: String,
    /// What it measures.
    pub kind: SensorKind,
    /// Where it sits, in the frame that markers are fixed in, m.
    pub position: [f64; 3],
    /// Whether that is not known, and estimated with the rest.
    pub position_is_unknown: bool,
    /// Standard deviation of one component in its unit (m, rad/s, m/s², m/s); `None` if unknown.
    pub sigma: Option<f64>,
    /// Of a pose: standard deviation of the attitude about one axis, rad; `None` if unknown.
    pub sigma_angle: Option<f64>,
}

/// One reading of a channel: up to four numbers, the unused ones 0. A position, a vector in the body's axes, a speed, or the
/// quaternion of an attitude (body to inertial, scalar part first).
pub type Reading = [f64; 4];

impl Sensor {
    /// A sensor whose noise is not stated, at a place on the body, m.
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
}

impl SensorKind {
    /// All kinds, with their names in `dataset.toml`; markers have a name of their own.
    pub const ALL: [(Self, &'static str); 4] = [
        (Self::Pose, "pose"),
        (Self::Instrument(Instrument::Gyroscope), "gyroscope"),
        (Self::Instrument(Instrument::Accelerometer), "accelerometer"),
        (Self::Instrument(Instrument::Speed), "speed"),
    ];

    /// Name in `dataset.toml`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pose => "pose",
            Self::Instrument(instrument) => instrument.name(),
        }
    }

    /// Unit of a reading's components; of a pose, that of its position.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Pose => "m",
            Self::Instrument(Instrument::Gyroscope) => "rad/s",
            Self::Instrument(Instrument::Accelerometer) => "m/s^2",
            Self::Instrument(Instrument::Speed) => "m/s",
        }
    }

    /// Endings of the columns of each channel; the whole name is that of a sensor with an empty ending.
    pub fn channels(self) -> &'static [&'static [&'static str]] {
        const VECTOR: &[&str] = &["_x", "_y", "_z"];
        const ATTITUDE: &[&str] = &["_qw", "_qx", "_qy", "_qz"];
        match self {
            Self::Pose => &[VECTOR, ATTITUDE],
            Self::Instrument(Instrument::Speed) => &[&[""]],
            Self::Instrument(_) => &[VECTOR],
        }
    }
}

/// Attitude of a reading.
pub(crate) fn attitude([w, x, y, z]: Reading) -> UnitQuaternion<f64> {
    UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z))
}

/// Points of the body that stand for a pose sensor at `position`, in the frame of the markers, m.
pub(crate) fn points_on_body(position: [f64; 3]) -> [[f64; 3]; 3] {
    let [x, y, z] = position;
    [
        [x + REACH, y, z],
        [x, y + REACH, z],
        [x - REACH, y - REACH, z],
    ]
}

/// Where these points are, m, by the readings of the pose's two channels.
pub(crate) fn points_seen(readings: &[Option<Reading>]) -> [Option<[f64; 3]>; 3] {
    let (Some(place), Some(turn)) = (readings[0], readings[1]) else {
        return [None; 3];
    };
    let turn = attitude(turn);
    let place = Vector3::new(place[0], place[1], place[2]);
    points_on_body([0.0; 3]).map(|point| Some((place + turn * Vector3::from(point)).into()))
}
