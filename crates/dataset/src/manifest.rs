//! Parser of `dataset.toml`: model, known parameters, markers, sensors, noise and flights of a dataset.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::Path;

use flight::InputInterpolation;
use model_spec::location::line_and_column;
use toml::Spanned;
use toml::de::DeTable;

use super::fields::{Entry, Fields, Value};
use super::recording::{Recording, choice};
use super::stated::Stated;
use super::summary_columns::SummariesEntry;
use super::unplaced::Unplaced;
use super::words::{meant, shown};
use super::{Dataset, Flight, KnownValue, Marker, Role, file, names};
use crate::input_error::InputError;
use crate::pose::distance;

pub(super) const MAX_BYTES: u64 = 4 << 20;
/// Maximum number of markers, and of sensors, of a dataset.
const MAX_MARKERS: usize = 1000;
/// Maximum absolute coordinate of a marker in the body frame, m; larger values suggest millimetres.
const MAX_COORDINATE: f64 = 10.0;
/// Distance between the declared positions of two markers below which the markers count as identical, m.
const MIN_DISTANCE: f64 = 1e-6;
/// Maximum standard deviation of a measured coordinate, m; larger values suggest millimetres.
const MAX_SIGMA: f64 = 1.0;
/// Maximum standard error of the direction of an axis, rad; larger values suggest degrees.
const MAX_AXIS_ERROR: f64 = 0.5;

#[derive(Debug, PartialEq)]
pub(super) struct Manifest {
    /// What it states of the dataset, without flights.
    pub dataset: Dataset,
    /// Units and axes of the files.
    pub recording: Recording,
    /// Markers whose positions are to be estimated.
    pub unplaced: Vec<Unplaced>,
    pub flights: Vec<FlightEntry>,
    /// Tables of summaries.
    pub summaries: Vec<SummariesEntry>,
}

/// One `[[flights]]` entry of `dataset.toml`: the file, whether it is fitted or held out, and its known values.
#[derive(Debug, PartialEq)]
pub(super) struct FlightEntry {
    /// What it states of the flight, without samples.
    pub flight: Flight,
    /// The quantities that are known or unknown, with their places.
    pub stated: Vec<Stated>,
    /// Table of the inputs over time.
    pub inputs: Option<String>,
}

pub(super) fn read(path: &Path) -> Result<Manifest, InputError> {
    let bytes = file::bytes(path, MAX_BYTES, "a dataset.toml")?;
    parse(path, file::text(path, &bytes)?)
}

pub(super) fn parse(file: &Path, text: &str) -> Result<Manifest, InputError> {
    let document = parsed(file, text)?;
    Fields { file, text }.manifest(document.get_ref())
}

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

impl Fields<'_> {
    fn manifest(&self, document: &DeTable<'_>) -> Result<Manifest, InputError> {
        const KEYS: [&str; 11] = [
            "model",
            "recording",
            "template",
            "parameters",
            "markers",
            "sensors",
            "noise",
            "unknown",
            "inputs",
            "flights",
            "summaries",
        ];
        self.keys(document, "", &KEYS)?;
        let mut dataset = Dataset {
            model: self.model(document)?,
            parameters: self.parameters(document)?,
            ..Dataset::default()
        };
        let mut unplaced = Vec::new();
        dataset.markers = self.markers(document, &mut unplaced)?;
        dataset.sigma = self.sigma(document)?;
        let markers = (&mut dataset.markers, &mut unplaced);
        dataset.sensors = self.sensors(document, markers, &mut dataset.sigma)?;
        let recording = Recording::read(self, document, &dataset.sensors)?;
        (dataset.origin_error, dataset.axis_error) = self.template_errors(document)?;
        dataset.unknown = self.unknown(document)?;
        dataset.input_interpolation = self.interpolation(document)?;
        Ok(Manifest {
            dataset,
            recording,
            unplaced,
            flights: self.flights(document)?,
            summaries: self.summaries(document)?,
        })
    }

    pub(super) fn parameters(
        &self,
        document: &DeTable<'_>,
    ) -> Result<BTreeMap<String, f64>, InputError> {
        let table = self.table(document, "parameters")?;
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
            return Err(self.fault(0..0, "no model", expected));
        };
        let model = self.text(value, "model", expected)?;
        if model.trim().is_empty() || model.chars().any(char::is_control) {
            return Err(self.refused(value, "model", shown(&model), expected));
        }
        Ok(model)
    }

    /// Reads the value of the known constant `name`, and checks it by the rules for parameters in a release file.
    fn constant(&self, name: &str, value: &Value<'_>) -> Result<f64, InputError> {
        let number = self.number(value, name)?;
        let rule = flight::release::Name {
            name: name.to_owned(),
            bounds: None,
        };
        match rule.expected_instead_of(number) {
            Some(expected) => Err(self.refused(value, name, number, expected)),
            None => Ok(number),
        }
    }

    /// Entries of `[[markers]]` or `[[sensors]]`, at most [`MAX_MARKERS`].
    pub(super) fn entries<'d, 't>(
        &self,
        document: &'d DeTable<'t>,
        key: &str,
    ) -> Result<Vec<Entry<'d, 't>>, InputError> {
        let tables = self.tables(document, key)?;
        let Some((span, _)) = tables.get(MAX_MARKERS) else {
            return Ok(tables);
        };
        let (found, most) = (
            format!("{} {key}", tables.len()),
            format!("at most {MAX_MARKERS}"),
        );
        Err(self.fault(span.clone(), found, most))
    }

    /// Name of a marker or sensor, as `what` calls it, and its place.
    pub(super) fn name(
        &self,
        entry: &Entry<'_, '_>,
        what: &str,
    ) -> Result<(String, Range<usize>), InputError> {
        let value = self.needed(entry, "name", &format!("the {what}'s name"))?;
        let name = self.text(value, "name", &format!("the {what}'s name in quotes"))?;
        match names::wrong_with_marker(&name) {
            None => Ok((name, value.span())),
            Some(expected) => {
                let found = format!("the {what} name {}", shown(&name));
                Err(self.fault(value.span(), found, expected))
            }
        }
    }

    pub(super) fn markers(
        &self,
        document: &DeTable<'_>,
        unplaced: &mut Vec<Unplaced>,
    ) -> Result<Vec<Marker>, InputError> {
        let tables = self.entries(document, "markers")?;
        let others = ["sensors", "summaries"];
        if tables.is_empty() && !others.iter().any(|key| document.contains_key(*key)) {
            let expected = "at least one marker: what was tracked";
            return Err(self.fault(0..0, "no [[markers]]", expected));
        }
        let mut markers: Vec<Marker> = Vec::with_capacity(tables.len());
        let mut seen = BTreeSet::new();
        for entry in &tables {
            self.keys(entry.1, " in [[markers]]", &["name", "position"])?;
            let (name, span) = self.name(entry, "marker")?;
            if !seen.insert(name.clone()) {
                let found = format!("a second marker {}", shown(&name));
                return Err(self.fault(span, found, "each marker once"));
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
                return Err(self.fault(value.span(), found, "each marker at a place of its own"));
            }
            markers.push(Marker { name, position });
        }
        Ok(markers)
    }

    /// Reads the table `[template]`: standard errors of the origin along the body axes, m, and of the third axis, rad.
    fn template_errors(
        &self,
        document: &DeTable<'_>,
    ) -> Result<(Option<[f64; 3]>, Option<f64>), InputError> {
        const KEYS: [&str; 2] = ["origin_error", "axis_error"];
        let Some(template) = self.table(document, "template")? else {
            return Ok((None, None));
        };
        self.keys(template, " in [template]", &KEYS)?;
        let origin = template.get(KEYS[0]).map(|value| {
            let errors = self.vector(value, KEYS[0])?;
            if errors.iter().all(|error| (0.0..=MAX_SIGMA).contains(error)) {
                return Ok(errors);
            }
            let expected = format!("standard errors from 0 to {MAX_SIGMA} m");
            Err(self.refused(value, KEYS[0], format!("{errors:?}"), expected))
        });
        let axis = template.get(KEYS[1]).map(|value| {
            let error = self.number(value, KEYS[1])?;
            if (0.0..=MAX_AXIS_ERROR).contains(&error) {
                return Ok(error);
            }
            let expected = format!("a standard error from 0 to {MAX_AXIS_ERROR} rad");
            Err(self.refused(value, KEYS[1], error, expected))
        });
        Ok((origin.transpose()?, axis.transpose()?))
    }

    pub(super) fn unplaced(&self, marker: usize, value: &Value<'_>) -> Unplaced {
        Unplaced {
            marker,
            place: self.fault(value.span(), "", ""),
        }
    }

    /// Reads a position on the body, m; `None` for the text "unknown".
    pub(super) fn position(
        &self,
        value: &Value<'_>,
        what: &str,
    ) -> Result<Option<[f64; 3]>, InputError> {
        if value.get_ref().as_str().is_some() {
            let expected = "three numbers, as in [0.0, 0.0, 0.0], or \"unknown\"";
            let word = self.text(value, "position", expected)?;
            if word == "unknown" {
                return Ok(None);
            }
            let found = format!("the text {}", shown(&word));
            return Err(self.refused(value, "position", found, expected));
        }
        let position = self.vector(value, "position")?;
        match position.iter().find(|axis| axis.abs() > MAX_COORDINATE) {
            None => Ok(Some(position)),
            Some(far) => {
                let expected = format!(
                    "at most {MAX_COORDINATE} m from the body's origin (millimetres given for metres?)"
                );
                let found = format!("a {what} at {far} m");
                Err(self.fault(value.span(), found, expected))
            }
        }
    }

    fn sigma(&self, document: &DeTable<'_>) -> Result<Option<f64>, InputError> {
        let Some(noise) = self.table(document, "noise")? else {
            return Ok(None);
        };
        self.keys(noise, " in [noise]", &["sigma"])?;
        let Some(value) = noise.get("sigma") else {
            return Ok(None);
        };
        let sigma = self.number(value, "sigma")?;
        if sigma > 0.0 && sigma <= MAX_SIGMA {
            return Ok(Some(sigma));
        }
        let hint = if sigma > MAX_SIGMA {
            " (millimetres given for metres?)"
        } else {
            ""
        };
        let expected = format!("a standard deviation above 0 and up to {MAX_SIGMA} m{hint}");
        Err(self.refused(value, "sigma", sigma, expected))
    }

    fn flights(&self, document: &DeTable<'_>) -> Result<Vec<FlightEntry>, InputError> {
        let tables = self.tables(document, "flights")?;
        if tables.is_empty() && !document.contains_key("summaries") {
            return Err(self.fault(0..0, "no [[flights]]", "at least one flight"));
        }
        let mut seen = BTreeSet::new();
        let mut flights = Vec::with_capacity(tables.len());
        for entry in &tables {
            let keys = ["file", "role", "known", "unknown", "inputs"];
            self.keys(entry.1, " in [[flights]]", &keys)?;
            let value = self.needed(entry, "file", "the flight's table")?;
            let file = self.file_name(value, "file", "the flight's table in quotes")?;
            if !seen.insert(file.clone()) {
                let found = format!("a second flight {}", shown(&file));
                return Err(self.fault(value.span(), found, "each file once"));
            }
            let flight = Flight {
                file,
                role: self.role(entry.1)?,
                known: self.known(entry.1)?,
                unknown: self.unknown(entry.1)?,
                ..Flight::default()
            };
            flights.push(FlightEntry {
                flight,
                stated: self.stated(entry.1)?,
                inputs: entry
                    .1
                    .get("inputs")
                    .map(|value| self.file_name(value, "inputs", "a table of inputs in quotes"))
                    .transpose()?,
            });
        }
        Ok(flights)
    }

    /// Reads the name of a file of the dataset under the key `key`.
    pub(super) fn file_name(
        &self,
        value: &Value<'_>,
        key: &str,
        expected: &str,
    ) -> Result<String, InputError> {
        let file = self.text(value, key, expected)?;
        match names::wrong_with_file(&file) {
            None => Ok(file),
            Some(expected) => Err(self.fault(value.span(), shown(&file), expected)),
        }
    }

    /// Reads the names under the key `unknown` of the document or of a flight.
    pub(super) fn unknown(&self, table: &DeTable<'_>) -> Result<Vec<String>, InputError> {
        let expected = "a list of names, as in [\"omega\"]";
        let items = self.items(table, "unknown", expected)?;
        let mut names: Vec<String> = Vec::with_capacity(items.len());
        for item in items {
            let name = self.text(item, "unknown", expected)?;
            if names.contains(&name) {
                let found = format!("a second {}", shown(&name));
                return Err(self.fault(item.span(), found, "each name once"));
            }
            names.push(name);
        }
        Ok(names)
    }

    /// Reads how inputs are interpolated from the table `[inputs]`.
    fn interpolation(&self, document: &DeTable<'_>) -> Result<InputInterpolation, InputError> {
        let Some(table) = self.table(document, "inputs")? else {
            return Ok(InputInterpolation::default());
        };
        self.keys(table, " in [inputs]", &["interpolation"])?;
        let words = InputInterpolation::NAMES.map(|(word, _)| word);
        let word = choice(self, table, "interpolation", &words)?;
        let known = InputInterpolation::NAMES.iter();
        let known = known.filter(|(own, _)| Some(*own) == word.as_deref());
        Ok(known.map(|(_, own)| *own).next().unwrap_or_default())
    }

    fn role(&self, flight: &DeTable<'_>) -> Result<Role, InputError> {
        let Some(value) = flight.get("role") else {
            return Ok(Role::Fit);
        };
        let expected = "\"fit\" or \"held-out\"";
        match self.text(value, "role", expected)?.as_str() {
            "fit" => Ok(Role::Fit),
            "held-out" => Ok(Role::HeldOut),
            other => {
                let expected = format!("{expected}{}", meant(other, ["fit", "held-out"]));
                Err(self.refused(value, "role", shown(other), expected))
            }
        }
    }

    /// Checks the entry `name` of `known` if it is the standard deviation of another entry.
    fn check_sigma(
        &self,
        table: &DeTable<'_>,
        name: &str,
        value: &Value<'_>,
        read: &KnownValue,
    ) -> Result<(), InputError> {
        let Some(of) = name.strip_suffix(KnownValue::SIGMA) else {
            return Ok(());
        };
        let Some(measured) = table.get(of) else {
            let expected = format!("the measured value beside it, as in {of} = …");
            return Err(self.refused(value, name, "a standard deviation alone", expected));
        };
        if measured.get_ref().is_array() != value.get_ref().is_array() {
            let expected = format!("as many numbers as {of} has");
            return Err(self.refused(
                value,
                name,
                "a standard deviation of another shape",
                expected,
            ));
        }
        let all = match read {
            KnownValue::Scalar(sigma) => vec![*sigma],
            KnownValue::Vector(sigmas) => sigmas.to_vec(),
        };
        match all.iter().find(|sigma| **sigma <= 0.0) {
            None => Ok(()),
            Some(sigma) => Err(self.refused(value, name, sigma, "standard deviations above 0")),
        }
    }

    pub(super) fn known(
        &self,
        flight: &DeTable<'_>,
    ) -> Result<BTreeMap<String, KnownValue>, InputError> {
        let mut known = BTreeMap::new();
        let Some(table) = self.table(flight, "known")? else {
            return Ok(known);
        };
        for (name, value) in table {
            let name = name.get_ref().to_string();
            let found = if value.get_ref().is_array() {
                KnownValue::Vector(self.vector(value, &name)?)
            } else {
                KnownValue::Scalar(self.constant(&name, value)?)
            };
            self.check_sigma(table, &name, value, &found)?;
            known.insert(name, found);
        }
        Ok(known)
    }
}
