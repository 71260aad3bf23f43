//! Units and axes of a dataset's tables, from the section `[recording]` of `dataset.toml`. The reader converts the
//! tables to SI units, right-handed axes with z up, and attitudes from body to inertial axes.

use std::f64::consts::PI;

use crate::takes::{Axis, LengthUnit, TimeUnit};
use toml::de::DeTable;

use super::fields::{Fields, Value};
use super::sensor::{Reading, Sensor, SensorKind};
use super::words::{meant, shown};
use crate::input_error::InputError;
use model_spec::compose::Instrument;

const LENGTHS: [&str; 5] = ["m", "cm", "mm", "in", "ft"];
const TIMES: [&str; 4] = ["s", "ms", "us", "ns"];
const UPS: [&str; 7] = ["+z", "-z", "+y", "-y", "+x", "-x", UNKNOWN];
/// Units of the readings of gyroscopes, with their values in rad/s; the first is that of a dataset.
pub const ANGULAR_RATES: [(&str, f64); 5] = [
    ("rad/s", 1.0),
    ("deg/s", PI / 180.0),
    ("rpm", PI / 30.0),
    ("mdeg/s", PI / 180e3),
    ("rev/s", 2.0 * PI),
];
/// Units of the readings of accelerometers, with their values in m/s²; the first is that of a dataset.
pub const ACCELERATIONS: [(&str, f64); 3] = [("m/s^2", 1.0), ("g", 9.80665), ("mg", 9.80665e-3)];
/// Units of the readings of speeds, with their values in m/s; the first is that of a dataset.
pub const SPEEDS: [(&str, f64); 5] = [
    ("m/s", 1.0),
    ("km/h", 1.0 / 3.6),
    ("mph", 0.44704),
    ("ft/s", 0.3048),
    ("kn", 1852.0 / 3600.0),
];
const ATTITUDES: [&str; 2] = ["body_to_inertial", INVERSE];
/// Value of the key `attitude` if quaternions turn inertial to body components.
const INVERSE: &str = "inertial_to_body";
/// Value of the key `up` if the direction of the vertical is unknown.
const UNKNOWN: &str = "unknown";

/// The +z axis of the flights' tables: upwards by default, and the third axis if the vertical is unknown.
const UP_Z: Axis = axis(2);

/// Keys of the axes of gyroscopes and accelerometers.
const AXES: [&str; 2] = ["gyroscope_axes", "accelerometer_axes"];

/// Axes of an instrument that are the body axes.
const OWN_AXES: [Axis; 3] = [axis(0), axis(1), axis(2)];

const fn axis(index: usize) -> Axis {
    Axis {
        index,
        negative: false,
    }
}

/// Direction of the vertical relative to the axes in which the flights' tables state coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Up {
    Axis(Axis),
    Unknown,
}

/// Units and axes of the values in the flights' tables of a dataset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Recording {
    pub length: LengthUnit,
    pub time: TimeUnit,
    pub up: Up,
    pub left_handed: bool,
    /// Unit of the readings of gyroscopes, rad/s.
    angular_rate: f64,
    /// Unit of the readings of accelerometers, m/s².
    acceleration: f64,
    /// Unit of the readings of speeds, m/s.
    speed: f64,
    inverse_attitude: bool,
    /// Axis of the tracked body that is the third body axis of the model.
    body_up: Axis,
    /// Axes of gyroscopes and accelerometers along the body axes of the model.
    axes: [[Axis; 3]; 2],
}

impl Default for Recording {
    fn default() -> Self {
        Self {
            length: LengthUnit::Metre,
            time: TimeUnit::Second,
            up: Up::Axis(UP_Z),
            left_handed: false,
            angular_rate: 1.0,
            acceleration: 1.0,
            speed: 1.0,
            inverse_attitude: false,
            body_up: UP_Z,
            axes: [OWN_AXES; 2],
        }
    }
}

impl Recording {
    /// Reads the TOML table `[recording]` of `dataset.toml`; keys that are absent have their default values.
    pub fn read(
        fields: &Fields<'_>,
        document: &DeTable<'_>,
        sensors: &[Sensor],
    ) -> Result<Self, InputError> {
        let mut recording = Self::default();
        let Some(table) = fields.table(document, "recording")? else {
            return Ok(recording);
        };
        let keys = [
            "length",
            "time",
            "up",
            "left_handed",
            "angular_rate",
            "acceleration",
            "speed",
            "attitude",
            "body_up",
            AXES[0],
            AXES[1],
        ];
        fields.keys(table, " in [recording]", &keys)?;
        let choice = |key, choices: &[&str]| choice(fields, table, key, choices);
        let unit = |key, known: &[(&str, f64)]| {
            let names: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
            let stated = choice(key, &names)?;
            let mut known = known.iter();
            let found = stated.and_then(|text| known.find(|(name, _)| *name == text));
            Ok(found.map_or(1.0, |(_, unit)| *unit))
        };
        recording.angular_rate = unit("angular_rate", &ANGULAR_RATES)?;
        recording.acceleration = unit("acceleration", &ACCELERATIONS)?;
        recording.speed = unit("speed", &SPEEDS)?;
        if let Some(text) = choice("attitude", &ATTITUDES)? {
            recording.inverse_attitude = text == INVERSE;
        }
        if let Some(text) = choice("body_up", &UPS[..6])? {
            recording.body_up = Axis::parse(&text).unwrap_or(UP_Z);
        }
        for (key, axes) in AXES.into_iter().zip(&mut recording.axes) {
            if let Some(value) = table.get(key) {
                *axes = three_axes(fields, value, key)?;
            }
        }
        if let Some(text) = choice("length", &LENGTHS)? {
            recording.length = LengthUnit::parse(&text).unwrap_or(recording.length);
        }
        if let Some(text) = choice("time", &TIMES)? {
            recording.time = TimeUnit::parse(&text).unwrap_or(recording.time);
        }
        if let Some(text) = choice("up", &UPS)? {
            recording.up = Axis::parse(&text).map_or(Up::Unknown, Up::Axis);
        }
        if let Some(value) = table.get("left_handed") {
            recording.left_handed = fields.truth(value, "left_handed")?;
            let pose = sensors.iter().find(|it| it.kind == SensorKind::Pose);
            if let (true, Some(pose)) = (recording.left_handed, pose) {
                let found = format!("left_handed = true with the pose {}", shown(&pose.name));
                let expected = "poses with respect to right-handed axes";
                return Err(fields.fault(value.span(), found, expected));
            }
        }
        Ok(recording)
    }

    /// The axis of the tables that becomes the third one of the dataset: the upward axis, or +z if that is unknown.
    pub fn third_axis(&self) -> Axis {
        match self.up {
            Up::Axis(axis) => axis,
            Up::Unknown => UP_Z,
        }
    }

    /// Converts a time from the unit of the tables to s.
    pub fn seconds(&self, time: f64) -> f64 {
        time * self.time.seconds()
    }

    /// Converts the reading of an instrument to SI units and the body axes of the model.
    pub fn instrument_reading(&self, instrument: Instrument, reading: Reading) -> Reading {
        let [of_gyroscope, of_accelerometer] = &self.axes;
        let (unit, axes) = match instrument {
            Instrument::Gyroscope => (self.angular_rate, of_gyroscope),
            Instrument::Accelerometer => (self.acceleration, of_accelerometer),
            Instrument::Speed => return reading.map(|part| part * self.speed),
        };
        let [x, y, z] = axes.map(|axis| unit * axis.part_of(reading));
        [x, y, z, reading[3]]
    }

    /// Converts the quaternion of a pose so that it turns components along the model's body axes to inertial ones.
    pub fn body_to_inertial(&self, [w, x, y, z]: Reading) -> Reading {
        let sign = if self.inverse_attitude { -1.0 } else { 1.0 };
        self.body_up
            .third_body_axis([w, sign * x, sign * y, sign * z])
    }

    /// Converts a coordinate from the unit of the tables to m.
    pub fn metres(&self, coordinate: f64) -> f64 {
        coordinate * self.length.metres()
    }
}

/// Reads the axes of an instrument along the three body axes: each of its axes once.
fn three_axes(fields: &Fields<'_>, value: &Value<'_>, key: &str) -> Result<[Axis; 3], InputError> {
    let expected = "the axes of the instrument along the first, second and third body axis, each once, such as [\"+y\", \"-x\", \"+z\"]";
    let texts = value.get_ref().as_array().map(|texts| texts.iter());
    let axes = texts.map(|texts| texts.map(|text| Axis::parse(text.get_ref().as_str()?)));
    let axes = axes.and_then(Iterator::collect::<Option<Vec<Axis>>>);
    let axes = axes.and_then(|axes| <[Axis; 3]>::try_from(axes).ok());
    let is_once = |axes: &[Axis; 3]| (0..3).all(|k| axes.iter().any(|axis| axis.index == k));
    axes.filter(is_once)
        .ok_or_else(|| fields.refused(value, key, "another value", expected))
}

/// Reads the text under a key of `table`, which must be one of `choices`; `None` if the key is absent.
pub(super) fn choice(
    fields: &Fields<'_>,
    table: &DeTable<'_>,
    key: &str,
    choices: &[&str],
) -> Result<Option<String>, InputError> {
    let Some(value) = table.get(key) else {
        return Ok(None);
    };
    let quoted: Vec<String> = choices.iter().map(|choice| format!("{choice:?}")).collect();
    let expected = quoted.join(", ");
    let text = fields.text(value, key, &expected)?;
    if choices.contains(&text.as_str()) {
        return Ok(Some(text));
    }
    let expected = format!("{expected}{}", meant(&text, choices.iter().copied()));
    Err(fields.refused(value, key, shown(&text), expected))
}
