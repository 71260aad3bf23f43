//! Parser of `dataset.toml`: model, known parameters, markers, sensors, noise and flights of a dataset.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::Path;

use model_spec::location::line_and_column;
use toml::Spanned;
use toml::de::DeTable;

use super::fields::{Fields, Value};
use super::recording::Recording;
use super::unplaced::Unplaced;
use super::words::{meant, shown};
use super::{KnownValue, Marker, Role, Sensor, file, names};
use crate::input_error::InputError;
use crate::pose::distance;

/// Maximum size of `dataset.toml`, bytes.
pub(super) const MAX_BYTES: u64 = 4 << 20;
/// Maximum number of markers, and of sensors, of a dataset.
pub(super) const MAX_MARKERS: usize = 1000;
/// Maximum absolute coordinate of a marker in the body frame, m; larger values suggest millimetres.
const MAX_COORDINATE: f64 = 10.0;
/// Distance between the declared positions of two markers below which the markers count as identical, m.
const MIN_DISTANCE: f64 = 1e-6;
/// Maximum standard deviation of a measured coordinate, m; larger values suggest millimetres.
const MAX_SIGMA: f64 = 1.0;
/// Maximum standard error of the direction of an axis, rad; larger values suggest degrees.
const MAX_AXIS_ERROR: f64 = 0.5;

/// The checked contents of `dataset.toml`.
#[derive(Debug, PartialEq)]
pub(super) struct Manifest {
    pub model: String,
    pub recording: Recording,
    /// Standard errors of the origin of the markers' positions along the body axes, m.
    pub origin_error: Option<[f64; 3]>,
    /// Standard error of the direction of the third body axis relative to the markers, rad.
    pub axis_error: Option<f64>,
    pub parameters: BTreeMap<String, f64>,
    pub markers: Vec<Marker>,
    /// Markers whose positions on the body are unknown.
    pub unplaced: Vec<Unplaced>,
    pub sensors: Vec<Sensor>,
    pub sigma: Option<f64>,
    pub flights: Vec<Entry>,
}

/// One `[[flights]]` entry of `dataset.toml`: the file of a flight, whether it is fitted or held out, and its known
/// values.
#[derive(Debug, PartialEq)]
pub(super) struct Entry {
    pub file: String,
    pub role: Role,
    pub known: BTreeMap<String, KnownValue>,
}

pub(super) fn read(path: &Path) -> Result<Manifest, InputError> {
    let bytes = file::bytes(path, MAX_BYTES, "a dataset.toml")?;
    parse(path, file::text(path, &bytes)?)
}

pub(super) fn parse(file: &Path, text: &str) -> Result<Manifest, InputError> {
    let document = parsed(file, text)?;
    Checker(Fields { file, text }).manifest(document.get_ref())
}

/// Parses the text of a file as TOML.
pub(super) fn parsed<'t>(file: &Path, text: &'t str) -> Result<Spanned<DeTable<'t>>, InputError> {
    DeTable::parse(text).map_err(|error| syntax(file, text, &error))
}

fn syntax(file: &Path, text: &str, error: &toml::de::Error) -> InputError {
    // The TOML parser's message has the form "…, expected …"; it is split so that the final message states each part
    // once.
    let message = error.message().trim().replace('\n', " ");
    let (found, expected) = message
        .split_once(", expected ")
        .unwrap_or((&message, "TOML"));
    let place = error
        .span()
        .map_or((1, 1), |span| line_and_column(text, span.start));
    InputError::at(file, place, found, expected)
}

/// Converter of the parsed `dataset.toml` to checked values; it reports the location of each invalid value.
pub(super) struct Checker<'a>(pub(super) Fields<'a>);

impl Checker<'_> {
    fn manifest(&self, document: &DeTable<'_>) -> Result<Manifest, InputError> {
        let fields = &self.0;
        const KEYS: [&str; 8] = [
            "model",
            "recording",
            "template",
            "parameters",
            "markers",
            "sensors",
            "noise",
            "flights",
        ];
        fields.keys(document, "", &KEYS)?;
        let model = self.model(document)?;
        let parameters = self.parameters(document)?;
        let mut unplaced = Vec::new();
        let mut markers = self.markers(document, &mut unplaced)?;
        let mut sigma = self.sigma(document)?;
        let sensors = self.sensors(document, (&mut markers, &mut unplaced), &mut sigma)?;
        let recording = Recording::read(fields, document, &sensors)?;
        let (origin_error, axis_error) = self.template_errors(document)?;
        let flights = self.flights(document)?;
        Ok(Manifest {
            model,
            recording,
            origin_error,
            axis_error,
            parameters,
            markers,
            unplaced,
            sensors,
            sigma,
            flights,
        })
    }

    /// Reads the known constants of the table `[parameters]`.
    pub(super) fn parameters(
        &self,
        document: &DeTable<'_>,
    ) -> Result<BTreeMap<String, f64>, InputError> {
        let table = self.0.table(document, "parameters")?;
        let constants = table.into_iter().flatten().map(|(name, value)| {
            let name = name.get_ref().to_string();
            let number = self.constant(&name, value)?;
            Ok((name, number))
        });
        constants.collect()
    }

    pub(super) fn model(&self, document: &DeTable<'_>) -> Result<String, InputError> {
        let expected = "a name or a path, as in model = \"disc\"";
        let Some(value) = document.get("model") else {
            return Err(self.0.fault(0..0, "no model", expected));
        };
        let model = self.0.text(value, "model", expected)?;
        if model.trim().is_empty() || model.chars().any(char::is_control) {
            return Err(self.0.refused(value, "model", shown(&model), expected));
        }
        Ok(model)
    }

    /// Reads the value of the known constant `name`, and checks it by the rules for parameters in a release file.
    fn constant(&self, name: &str, value: &Value<'_>) -> Result<f64, InputError> {
        let number = self.0.number(value, name)?;
        let rule = flight::release::Name {
            name: name.to_owned(),
            bounds: None,
        };
        match rule.expected_instead_of(number) {
            Some(expected) => Err(self.0.refused(value, name, number, expected)),
            None => Ok(number),
        }
    }

    /// The value under the required key `key` of a TOML table, whose byte range is `span`. Returns an error, in which
    /// `expected` describes the value, if the key is absent.
    pub(super) fn needed<'d, 't>(
        &self,
        (span, table): &(Range<usize>, &'d DeTable<'t>),
        key: &str,
        expected: &str,
    ) -> Result<&'d Value<'t>, InputError> {
        table
            .get(key)
            .ok_or_else(|| self.0.fault(span.clone(), format!("no {key}"), expected))
    }

    pub(super) fn markers(
        &self,
        document: &DeTable<'_>,
        unplaced: &mut Vec<Unplaced>,
    ) -> Result<Vec<Marker>, InputError> {
        let fields = &self.0;
        let tables = fields.tables(document, "markers")?;
        if tables.is_empty() && !document.contains_key("sensors") {
            let expected = "at least one marker: what was tracked";
            return Err(fields.fault(0..0, "no [[markers]]", expected));
        }
        if tables.len() > MAX_MARKERS {
            let found = format!("{} markers", tables.len());
            let expected = format!("at most {MAX_MARKERS}");
            return Err(fields.fault(tables[MAX_MARKERS].0.clone(), found, expected));
        }
        let mut markers: Vec<Marker> = Vec::with_capacity(tables.len());
        let mut seen = BTreeSet::new();
        for entry in &tables {
            fields.keys(entry.1, " in [[markers]]", &["name", "position"])?;
            let value = self.needed(entry, "name", "the marker's name")?;
            let name = fields.text(value, "name", "the marker's name in quotes")?;
            if let Some(expected) = names::wrong_with_marker(&name) {
                let found = format!("the marker name {}", shown(&name));
                return Err(fields.fault(value.span(), found, expected));
            }
            if !seen.insert(name.clone()) {
                let found = format!("a second marker {}", shown(&name));
                return Err(fields.fault(value.span(), found, "each marker once"));
            }
            let value = self.needed(entry, "position", "the marker's position on the body, m")?;
            let Some(position) = self.position(value, "marker")? else {
                unplaced.push(self.unplaced(markers.len(), value));
                let position = [0.0; 3];
                markers.push(Marker { name, position });
                continue;
            };
            let near = |other: &Marker| distance(position, other.position) < MIN_DISTANCE;
            let mut others = markers.iter().enumerate();
            let is_placed = |index: usize| unplaced.iter().all(|own| own.marker != index);
            if let Some((_, other)) = others.find(|(index, other)| is_placed(*index) && near(other))
            {
                let found = format!("{name} at the place of {}", other.name);
                return Err(fields.fault(value.span(), found, "each marker at a place of its own"));
            }
            markers.push(Marker { name, position });
        }
        Ok(markers)
    }

    /// Reads the TOML table `[template]`: the standard errors of the origin of the markers' positions along the body
    /// axes, m, and that of the direction of the third axis, rad. `None` for a key that is absent.
    fn template_errors(
        &self,
        document: &DeTable<'_>,
    ) -> Result<(Option<[f64; 3]>, Option<f64>), InputError> {
        const KEYS: [&str; 2] = ["origin_error", "axis_error"];
        let Some(template) = self.0.table(document, "template")? else {
            return Ok((None, None));
        };
        self.0.keys(template, " in [template]", &KEYS)?;
        let [origin, axis] = KEYS.map(|key| template.get(key));
        let origin = origin.map(|value| {
            let errors = self.0.vector(value, KEYS[0])?;
            let is_valid = errors.iter().all(|error| (0.0..=MAX_SIGMA).contains(error));
            let expected = format!("standard errors from 0 to {MAX_SIGMA} m");
            let refused = || {
                self.0
                    .refused(value, KEYS[0], format!("{errors:?}"), expected)
            };
            is_valid.then_some(errors).ok_or_else(refused)
        });
        let axis = axis.map(|value| {
            let error = self.0.number(value, KEYS[1])?;
            let is_valid = (0.0..=MAX_AXIS_ERROR).contains(&error);
            let expected = format!("a standard error from 0 to {MAX_AXIS_ERROR} rad");
            let refused = || self.0.refused(value, KEYS[1], error, expected);
            is_valid.then_some(error).ok_or_else(refused)
        });
        Ok((origin.transpose()?, axis.transpose()?))
    }

    /// Creates the record of the marker with the index `marker`, whose position is unknown. `value` is its entry in
    /// `dataset.toml`, to which error messages refer.
    pub(super) fn unplaced(&self, marker: usize, value: &Value<'_>) -> Unplaced {
        Unplaced {
            marker,
            place: self.0.fault(value.span(), "", ""),
        }
    }

    /// Reads a position on the body, m; `None` for the text "unknown". `what` names the object in messages, a marker
    /// or a sensor.
    pub(super) fn position(
        &self,
        value: &Value<'_>,
        what: &str,
    ) -> Result<Option<[f64; 3]>, InputError> {
        if value.get_ref().as_str().is_some() {
            let expected = "three numbers, as in [0.0, 0.0, 0.0], or \"unknown\"";
            let word = self.0.text(value, "position", expected)?;
            if word == "unknown" {
                return Ok(None);
            }
            let found = format!("the text {}", shown(&word));
            return Err(self.0.refused(value, "position", found, expected));
        }
        let position = self.0.vector(value, "position")?;
        match position.iter().find(|axis| axis.abs() > MAX_COORDINATE) {
            None => Ok(Some(position)),
            Some(far) => {
                let expected = format!(
                    "at most {MAX_COORDINATE} m from the body's origin (millimetres given for metres?)"
                );
                let found = format!("a {what} at {far} m");
                Err(self.0.fault(value.span(), found, expected))
            }
        }
    }

    fn sigma(&self, document: &DeTable<'_>) -> Result<Option<f64>, InputError> {
        let Some(noise) = self.0.table(document, "noise")? else {
            return Ok(None);
        };
        self.0.keys(noise, " in [noise]", &["sigma"])?;
        let Some(value) = noise.get("sigma") else {
            return Ok(None);
        };
        let sigma = self.0.number(value, "sigma")?;
        if sigma > 0.0 && sigma <= MAX_SIGMA {
            return Ok(Some(sigma));
        }
        let hint = if sigma > MAX_SIGMA {
            " (millimetres given for metres?)"
        } else {
            ""
        };
        let expected = format!("a standard deviation above 0 and up to {MAX_SIGMA} m{hint}");
        Err(self.0.refused(value, "sigma", sigma, expected))
    }

    fn flights(&self, document: &DeTable<'_>) -> Result<Vec<Entry>, InputError> {
        let tables = self.0.tables(document, "flights")?;
        if tables.is_empty() {
            return Err(self.0.fault(0..0, "no [[flights]]", "at least one flight"));
        }
        let mut seen = BTreeSet::new();
        let mut flights = Vec::with_capacity(tables.len());
        for entry in &tables {
            self.0
                .keys(entry.1, " in [[flights]]", &["file", "role", "known"])?;
            let value = self.needed(entry, "file", "the flight's table")?;
            let file = self.0.text(value, "file", "the flight's table in quotes")?;
            if let Some(expected) = names::wrong_with_file(&file) {
                return Err(self.0.fault(value.span(), shown(&file), expected));
            }
            if !seen.insert(file.clone()) {
                let found = format!("a second flight {}", shown(&file));
                return Err(self.0.fault(value.span(), found, "each file once"));
            }
            flights.push(Entry {
                file,
                role: self.role(entry.1)?,
                known: self.known(entry.1)?,
            });
        }
        Ok(flights)
    }

    fn role(&self, flight: &DeTable<'_>) -> Result<Role, InputError> {
        let Some(value) = flight.get("role") else {
            return Ok(Role::Fit);
        };
        let expected = "\"fit\" or \"held-out\"";
        match self.0.text(value, "role", expected)?.as_str() {
            "fit" => Ok(Role::Fit),
            "held-out" => Ok(Role::HeldOut),
            other => {
                let expected = format!("{expected}{}", meant(other, ["fit", "held-out"]));
                Err(self.0.refused(value, "role", shown(other), expected))
            }
        }
    }

    fn known(&self, flight: &DeTable<'_>) -> Result<BTreeMap<String, KnownValue>, InputError> {
        let mut known = BTreeMap::new();
        let Some(table) = self.0.table(flight, "known")? else {
            return Ok(known);
        };
        for (name, value) in table {
            let name = name.get_ref().to_string();
            let found = if value.get_ref().is_array() {
                KnownValue::Vector(self.0.vector(value, &name)?)
            } else {
                KnownValue::Scalar(self.constant(&name, value)?)
            };
            known.insert(name, found);
        }
        Ok(known)
    }
}
