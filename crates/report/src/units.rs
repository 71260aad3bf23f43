//! Units of text for people; files are SI.

/// Units in which lengths and speeds are told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Units {
    /// Metres, and metres per second.
    #[default]
    Si,
    /// Feet, and miles per hour.
    Imperial,
}

/// Metres in a foot.
const FOOT: f64 = 0.3048;

/// Metres per second in a mile per hour.
const MILE_PER_HOUR: f64 = 0.44704;

impl Units {
    /// Units by their name in the option `--units`: `si` or `imperial`.
    pub fn parse(name: &str) -> Option<Units> {
        match name {
            "si" => Some(Units::Si),
            "imperial" => Some(Units::Imperial),
            _ => None,
        }
    }

    /// The unit that stands for the SI unit `unit`, and its size in that; only lengths and speeds have others.
    pub fn instead_of(self, unit: &str) -> (&str, f64) {
        match (self, unit) {
            (Units::Imperial, "m") => ("ft", FOOT),
            (Units::Imperial, "m/s") => ("mph", MILE_PER_HOUR),
            _ => (unit, 1.0),
        }
    }

    /// A value in the SI unit `unit`, converted.
    pub fn of(self, value: f64, unit: &str) -> f64 {
        value / self.instead_of(unit).1
    }

    /// Name of the unit of length.
    pub fn length(self) -> &'static str {
        self.instead_of("m").0
    }

    /// Name of the unit of speed.
    pub fn speed(self) -> &'static str {
        self.instead_of("m/s").0
    }

    /// A length in metres, converted.
    pub fn of_metres(self, value: f64) -> f64 {
        self.of(value, "m")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn feet_and_miles_per_hour() {
        let units = Units::parse("imperial").unwrap();
        assert_eq!(units.of_metres(30.48), 100.0);
        assert_eq!(units.of(26.8224, "m/s"), 60.0);
        assert_eq!(units.of(3.0, "deg"), 3.0);
        assert_eq!(units.instead_of("m/s").0, "mph");
        assert_eq!(Units::default().instead_of("m"), ("m", 1.0));
        assert_eq!(Units::parse("Imperial"), None);
    }
}
