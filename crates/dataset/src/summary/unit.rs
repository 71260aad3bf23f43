//! Units of the columns of summaries.

/// Unit of a column of summaries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SummaryUnit(usize);

/// What a quantity of a summary is measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dimension {
    Speed,
    Angle,
    Rate,
    Length,
    Time,
}

impl Dimension {
    /// The SI unit.
    pub fn si(self) -> &'static str {
        match self {
            Self::Speed => "m/s",
            Self::Angle => "rad",
            Self::Rate => "rad/s",
            Self::Length => "m",
            Self::Time => "s",
        }
    }
}

use Dimension::{Angle, Length, Rate, Speed, Time};
use std::f64::consts::{PI, TAU};

/// Dimension, name, other spellings, and value of each unit in SI.
const UNITS: [(Dimension, &str, &str, f64); 19] = [
    (Speed, "m/s", "mps m/sec", 1.0),
    (Speed, "mph", "mi/h", 0.44704),
    (Speed, "km/h", "kph kmh", 1.0 / 3.6),
    (Speed, "ft/s", "fps", 0.3048),
    (Speed, "kn", "kt knots", 1852.0 / 3600.0),
    (Angle, "rad", "", 1.0),
    (Angle, "deg", "° degree degrees", PI / 180.0),
    (Rate, "rad/s", "", 1.0),
    (Rate, "rpm", "1/min", PI / 30.0),
    (Rate, "deg/s", "°/s", PI / 180.0),
    (Rate, "rev/s", "rps 1/s", TAU),
    (Length, "m", "meters metres", 1.0),
    (Length, "yd", "yds yards", 0.9144),
    (Length, "ft", "feet foot", 0.3048),
    (Length, "in", "inch inches", 0.0254),
    (Length, "cm", "", 0.01),
    (Length, "mm", "", 0.001),
    (Time, "s", "sec seconds", 1.0),
    (Time, "ms", "msec", 0.001),
];

impl SummaryUnit {
    /// The unit that `text` names, by its own or another spelling, in any case.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim().to_lowercase();
        let is = |(_, name, others, _): &(_, &str, &str, _)| {
            *name == text
                || others
                    .split(' ')
                    .any(|other| other == text && !other.is_empty())
        };
        UNITS.iter().position(is).map(SummaryUnit)
    }

    /// Name of the unit.
    pub fn name(self) -> &'static str {
        UNITS[self.0].1
    }

    /// Value of the unit in SI.
    pub fn si(self) -> f64 {
        UNITS[self.0].3
    }

    pub(crate) fn dimension(self) -> Dimension {
        UNITS[self.0].0
    }

    /// Names of the units of a dimension.
    pub(crate) fn of(dimension: Dimension) -> impl Iterator<Item = &'static str> + Clone {
        let own = UNITS.iter().filter(move |unit| unit.0 == dimension);
        own.map(|unit| unit.1)
    }
}
