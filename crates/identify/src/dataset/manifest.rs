//! `dataset.toml`: what was measured, with what is known of it.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::{Component, Path};

use serde::Deserialize;
use toml::Spanned;

use super::Marker;
use crate::error::{InputError, line_and_column, utf8};

/// What a flight is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// Coefficients are fitted to it.
    #[default]
    Fit,
    /// It is kept to judge predictions.
    HeldOut,
}

/// The checked contents of `dataset.toml`.
#[derive(Debug)]
pub(super) struct Manifest {
    pub model: String,
    pub parameters: BTreeMap<String, f64>,
    pub markers: Vec<Marker>,
    pub sigma: Option<f64>,
    pub flights: Vec<Entry>,
}

/// A flight as the manifest names it.
#[derive(Debug)]
pub(super) struct Entry {
    pub file: String,
    pub role: Role,
    pub known: BTreeMap<String, [f64; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Raw {
    model: String,
    #[serde(default)]
    parameters: BTreeMap<String, Spanned<f64>>,
    #[serde(default)]
    markers: Vec<RawMarker>,
    noise: Option<RawNoise>,
    #[serde(default)]
    flights: Vec<RawFlight>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawMarker {
    name: Spanned<String>,
    position: Spanned<[f64; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawNoise {
    sigma: Spanned<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawFlight {
    file: Spanned<String>,
    #[serde(default)]
    role: Role,
    #[serde(default)]
    known: BTreeMap<String, Spanned<[f64; 3]>>,
}

/// Constants that are physically positive in every model of the contract.
const POSITIVE: [&str; 7] = ["m", "I_a", "I_d", "d", "A", "radius", "rho"];

pub(super) fn read(file: &Path) -> Result<Manifest, InputError> {
    let bytes = std::fs::read(file)
        .map_err(|error| InputError::of_file(file, error.to_string(), "a readable dataset.toml"))?;
    let text = utf8(file, &bytes)?;
    let raw: Raw = toml::from_str(text).map_err(|error| syntax(file, text, &error))?;
    Checker { file, text }.manifest(raw)
}

fn syntax(file: &Path, text: &str, error: &toml::de::Error) -> InputError {
    // The reader's own words say "…, expected …"; they are taken apart so that the sentence has one of each.
    let message = error.message().trim().replace('\n', " ");
    let (found, expected) = message.split_once(", expected ").unwrap_or((
        &message,
        "model, [parameters], [[markers]], [noise] and [[flights]] with their keys",
    ));
    match error.span() {
        Some(span) => InputError::at(file, line_and_column(text, span.start), found, expected),
        None => InputError::of_file(file, found, expected),
    }
}

/// Checks values with the text at hand, for places.
struct Checker<'a> {
    file: &'a Path,
    text: &'a str,
}

impl Checker<'_> {
    fn fault(
        &self,
        span: Range<usize>,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> InputError {
        InputError::at(
            self.file,
            line_and_column(self.text, span.start),
            found,
            expected,
        )
    }

    fn manifest(&self, raw: Raw) -> Result<Manifest, InputError> {
        let mut parameters = BTreeMap::new();
        for (name, value) in raw.parameters {
            self.finite(&value, std::slice::from_ref(value.get_ref()))?;
            if POSITIVE.contains(&name.as_str()) && *value.get_ref() <= 0.0 {
                return Err(self.fault(
                    value.span(),
                    format!("{name} = {}", value.get_ref()),
                    "a number above 0",
                ));
            }
            parameters.insert(name, value.into_inner());
        }
        if raw.markers.is_empty() {
            return Err(InputError::of_file(
                self.file,
                "no [[markers]]",
                "at least one marker: what was tracked",
            ));
        }
        if raw.flights.is_empty() {
            return Err(InputError::of_file(
                self.file,
                "no [[flights]]",
                "at least one flight",
            ));
        }
        Ok(Manifest {
            model: raw.model,
            parameters,
            markers: self.markers(raw.markers)?,
            sigma: raw.noise.map(|noise| self.sigma(&noise)).transpose()?,
            flights: raw
                .flights
                .into_iter()
                .map(|flight| self.flight(flight))
                .collect::<Result<_, _>>()?,
        })
    }

    fn finite<T>(&self, place: &Spanned<T>, values: &[f64]) -> Result<(), InputError> {
        match values.iter().find(|value| !value.is_finite()) {
            Some(value) => Err(self.fault(place.span(), value.to_string(), "a finite number")),
            None => Ok(()),
        }
    }

    fn markers(&self, raw: Vec<RawMarker>) -> Result<Vec<Marker>, InputError> {
        let mut seen = BTreeSet::new();
        let mut markers = Vec::with_capacity(raw.len());
        for marker in raw {
            self.finite(&marker.position, marker.position.get_ref())?;
            let name = marker.name.get_ref();
            if name.is_empty()
                || name
                    .chars()
                    .any(|c| c.is_whitespace() || c == ',' || c == ';')
            {
                return Err(self.fault(
                    marker.name.span(),
                    format!("the marker name {name:?}"),
                    "a name without spaces",
                ));
            }
            if !seen.insert(name.clone()) {
                return Err(self.fault(
                    marker.name.span(),
                    format!("a second marker {name:?}"),
                    "each marker once",
                ));
            }
            markers.push(Marker {
                position: *marker.position.get_ref(),
                name: marker.name.into_inner(),
            });
        }
        Ok(markers)
    }

    fn sigma(&self, noise: &RawNoise) -> Result<f64, InputError> {
        self.finite(&noise.sigma, std::slice::from_ref(noise.sigma.get_ref()))?;
        match *noise.sigma.get_ref() {
            sigma if sigma > 0.0 => Ok(sigma),
            sigma => Err(self.fault(
                noise.sigma.span(),
                format!("sigma = {sigma}"),
                "a standard deviation above 0, m",
            )),
        }
    }

    fn flight(&self, raw: RawFlight) -> Result<Entry, InputError> {
        let inside = Path::new(raw.file.get_ref())
            .components()
            .all(|part| matches!(part, Component::Normal(_)));
        if !inside || raw.file.get_ref().is_empty() {
            let found = format!("{:?}", raw.file.get_ref());
            return Err(self.fault(raw.file.span(), found, "a file inside the dataset's folder"));
        }
        let mut known = BTreeMap::new();
        for (name, value) in raw.known {
            self.finite(&value, value.get_ref())?;
            known.insert(name, value.into_inner());
        }
        Ok(Entry {
            file: raw.file.into_inner(),
            role: raw.role,
            known,
        })
    }
}
