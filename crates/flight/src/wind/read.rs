//! Parser of the table `[wind]` of a release file.

use std::path::Path;

use toml::de::DeTable;

use super::{GustStrength, Gusts, Profile, ReferenceWind, WindField};
use crate::toml_reader::{MAX_FILE_BYTES, Reader, ReleaseError, Value, number_of, read_text};

const MAX_ROWS: usize = 500;
const MAX_SPEED: f64 = 200.0;
/// Seeds and numbers of flights: whole numbers that `f64` represents exactly.
const SEEDS: (u64, u64) = (0, 1 << 53);
/// Default height of gusts, m: 10 ft, the minimum height of the low-altitude gust model.
const GUST_HEIGHT: f64 = 3.048;
const KEYS: [&str; 9] = [
    "constant",
    "gusts",
    "table",
    "profile",
    "speed",
    "direction",
    "reference_height",
    "roughness",
    "exponent",
];
const GUST_KEYS: [&str; 8] = [
    "model",
    "seed",
    "flight",
    "heading",
    "intensity",
    "height",
    "sd",
    "length",
];

/// Wind of a release file: constant in the inertial frame, m/s; and by height and gusts, if there are any.
pub type StatedWind = ([f64; 3], Option<WindField>);

/// Reads the table `[wind]` of a TOML file, to simulate one release in the wind of another.
///
/// # Errors
/// [`ReleaseError`] with all faults of the table, also if the file cannot be read or has no such table.
pub fn read_wind_file(path: &Path) -> Result<StatedWind, ReleaseError> {
    read_text(path, "a release", MAX_FILE_BYTES, |file, text| {
        let mut reader = Reader::new(text);
        let document = reader.document();
        let wind = document.and_then(|document| {
            let document = document.get_ref();
            if !document.contains_key("wind") {
                reader.missing(
                    "found no [wind]; expected one, as in [wind] with constant = [3.0, 0.0, 0.0]",
                );
                return None;
            }
            Some(reader.wind(document))
        });
        reader.finish(file, wind)
    })
}

impl<'t> Reader<'t> {
    /// Parses the table `[wind]` of a release file and records its faults; after a fault the result must not be used.
    pub(crate) fn wind(&mut self, document: &DeTable<'t>) -> StatedWind {
        let none = ([0.0; 3], None);
        let Some(value) = document.get("wind") else {
            return none;
        };
        let Some(table) = self.as_table(value, "wind") else {
            return none;
        };
        self.known_keys(table, " in [wind]", KEYS.into_iter());
        let constant = table.get("constant");
        let constant = constant.and_then(|value| self.vector(value, "constant wind"));
        let profile = self.profile(table);
        if let (Some(other), true) = (table.get("constant"), profile.is_some()) {
            self.fault(
                other.span(),
                "found a constant wind beside a profile or a table of the wind; expected one of them",
            );
        }
        let gusts = table.get("gusts").and_then(|value| {
            let heading = document.get("throw").and_then(|throw| {
                // Faults of this value are reported with [throw].
                number_of(throw.get_ref().as_table()?.get("heading")?)
            });
            self.gusts(value, heading.unwrap_or(0.0))
        });
        let field = (profile.is_some() || gusts.is_some()).then_some(WindField { profile, gusts });
        (constant.unwrap_or_default(), field)
    }

    fn profile(&mut self, table: &DeTable<'t>) -> Option<Profile> {
        let Some(value) = table.get("profile") else {
            let of_law = KEYS[4..]
                .iter()
                .filter_map(|key| Some((key, table.get(*key)?)));
            for (key, value) in of_law {
                let message = format!(
                    "found {key} without a profile; expected profile = \"log\" or profile = \"power\" with it"
                );
                self.fault(value.span(), message);
            }
            return self.wind_table(table.get("table")?);
        };
        if let Some(other) = table.get("table") {
            self.fault(
                other.span(),
                "found both a profile and a table of the wind; expected one of the two",
            );
        }
        let (law, own, other) = match value.get_ref().as_str() {
            Some("log") => ("log", "roughness", "exponent"),
            Some("power") => ("power", "exponent", "roughness"),
            _ => return self.refuse_type(value, "profile", "\"log\" or \"power\""),
        };
        if let Some(value) = table.get(other) {
            let message = format!("found {other} with the profile {law:?}; expected {own}");
            self.fault(value.span(), message);
        }
        let absent = format!(
            "found no speed with the profile {law:?}; expected one, as in speed = 4.0 (m/s)"
        );
        let speed = self.required(table, "speed", value.span(), absent)?;
        let at = ReferenceWind {
            speed: self.within(speed, "speed", (0.0, 100.0), "m/s")?,
            direction: self.number_or(table, "direction", 0.0, (-360.0, 360.0), "deg")?,
            height: self.number_or(table, "reference_height", 10.0, (0.1, 1000.0), "m")?,
        };
        Some(match law {
            "log" => Profile::Log {
                at,
                roughness: self.number_or(table, "roughness", 0.03, (1e-6, 10.0), "m")?,
            },
            _ => Profile::Power {
                at,
                exponent: self.number_or(table, "exponent", 1.0 / 7.0, (0.0, 2.0), "")?,
            },
        })
    }

    fn wind_table(&mut self, value: &Value<'t>) -> Option<Profile> {
        const EXPECTED: &str =
            "2 to 500 rows of height and wind, as in [[0.5, 1.0, 0.0, 0.0], [2.0, 2.5, 0.0, 0.0]]";
        let items = value.get_ref().as_array();
        let Some(items) = items.filter(|items| (2..=MAX_ROWS).contains(&items.len())) else {
            return self.refuse_type(value, "table", EXPECTED);
        };
        let mut rows: Vec<[f64; 4]> = Vec::new();
        for item in items {
            let numbers = item.get_ref().as_array().filter(|row| row.len() == 4);
            let Some(numbers) = numbers else {
                let expected = "four numbers: height (m), then the wind's components (m/s)";
                return self.refuse_type(item, "a row", expected);
            };
            let mut row = [0.0; 4];
            for (k, (slot, number)) in row.iter_mut().zip(numbers).enumerate() {
                *slot = match k {
                    0 => self.within(number, "the height", (0.0, 10000.0), "m")?,
                    _ => self.within(number, "the wind", (-MAX_SPEED, MAX_SPEED), "m/s")?,
                };
            }
            if let Some(last) = rows.last()
                && row[0] - last[0] < 1e-3
            {
                let message = format!(
                    "the height {} m follows {} m; expected heights that grow by 1 mm or more",
                    row[0], last[0]
                );
                return self.refuse(item.span(), message);
            }
            rows.push(row);
        }
        Some(Profile::Table { rows })
    }

    fn gusts(&mut self, value: &Value<'t>, heading: f64) -> Option<Gusts> {
        let Some(table) = value.get_ref().as_table() else {
            let expected = "a table, as in [wind.gusts] with model = \"dryden\"";
            return self.refuse_type(value, "gusts", expected);
        };
        self.known_keys(table, " in [wind.gusts]", GUST_KEYS.into_iter());
        let absent = "found no model of the gusts; expected model = \"dryden\"";
        let model = self.required(table, "model", value.span(), absent)?;
        if model.get_ref().as_str() != Some("dryden") {
            return self.refuse_type(model, "model", "\"dryden\"");
        }
        let absent = "found no seed of the gusts; expected one, as in seed = 7";
        let seed = self.required(table, "seed", value.span(), absent)?;
        let seed = self.whole(seed, "seed", SEEDS)?;
        let flight = match table.get("flight") {
            Some(value) => self.whole(value, "flight", SEEDS)?,
            None => 0,
        };
        let strength = match (table.get("sd"), table.get("length")) {
            (None, None) => GustStrength::LowAltitude,
            (Some(sd), Some(length)) => {
                let sd = self.three(sd, "sd", (0.0, 50.0), "m/s")?;
                let length = self.three(length, "length", (0.1, 10000.0), "m")?;
                GustStrength::Stated { sd, length }
            }
            (Some(one), None) | (None, Some(one)) => {
                return self.refuse(
                    one.span(),
                    "found sd or length alone; expected both, three numbers each, or none of them for the low-altitude model",
                );
            }
        };
        let heights = match strength {
            GustStrength::LowAltitude => (0.3048, 304.8),
            GustStrength::Stated { .. } => (0.0, 3048.0),
        };
        Some(Gusts {
            seed,
            flight,
            heading: self.number_or(table, "heading", heading, (-360.0, 360.0), "deg")?,
            intensity: self.number_or(table, "intensity", 1.0, (0.0, 100.0), "")?,
            height: self.number_or(table, "height", GUST_HEIGHT, heights, "m")?,
            strength,
        })
    }

    fn three(
        &mut self,
        value: &Value<'t>,
        name: &str,
        bounds: (f64, f64),
        unit: &str,
    ) -> Option<[f64; 3]> {
        let numbers = self.vector(value, name)?;
        if numbers.iter().any(|x| *x < bounds.0 || *x > bounds.1) {
            let message = format!(
                "{name} is {numbers:?}; expected numbers from {} to {} {unit}",
                bounds.0, bounds.1
            );
            return self.refuse(value.span(), message);
        }
        Some(numbers)
    }

    fn number_or(
        &mut self,
        table: &DeTable<'t>,
        key: &str,
        otherwise: f64,
        bounds: (f64, f64),
        unit: &str,
    ) -> Option<f64> {
        match table.get(key) {
            Some(value) => self.within(value, key, bounds, unit),
            None => Some(otherwise),
        }
    }

    fn within(
        &mut self,
        value: &Value<'t>,
        name: &str,
        (least, greatest): (f64, f64),
        unit: &str,
    ) -> Option<f64> {
        let number = self.number(value, name)?;
        if !(least..=greatest).contains(&number) {
            let unit = if unit.is_empty() { "" } else { " " }.to_owned() + unit;
            let message =
                format!("{name} is {number}; expected a number from {least} to {greatest}{unit}");
            return self.refuse(value.span(), message);
        }
        Some(number)
    }
}
