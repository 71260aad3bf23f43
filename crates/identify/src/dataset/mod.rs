//! A dataset: a folder with `dataset.toml` and one table, or one C3D file, per flight.
//!
//! What comes in is read whole or refused with its place; what a fit can make of it, the fit says: a flight of one
//! sample, or a dataset whose flights are all held out, is a dataset.

mod c3d;
mod fields;
mod file;
mod header;
mod in_memory;
mod lines;
mod manifest;
mod names;
mod number;
mod place;
mod samples;
mod table;
mod words;
mod write;

use std::collections::BTreeMap;
use std::path::Path;

pub use write::{manifest_text, table_text, write, write_with};

use crate::input_error::InputError;

/// Largest table or C3D file that is read, bytes.
const LARGEST: u64 = 1 << 30;

/// Measured flights of one body.
#[derive(Clone, Debug, PartialEq)]
pub struct Dataset {
    /// The model by name or path, as the file says.
    pub model: String,
    /// Known constants that override the model's defaults, SI.
    pub parameters: BTreeMap<String, f64>,
    /// What was tracked.
    pub markers: Vec<Marker>,
    /// Standard deviation of one axis of a measured position, m, where it is known.
    pub sigma: Option<f64>,
    /// The flights, in the file's order.
    pub flights: Vec<Flight>,
}

/// A tracked point.
#[derive(Clone, Debug, PartialEq)]
pub struct Marker {
    /// Its name, the first part of its columns' names.
    pub name: String,
    /// Its position in the frame that the model's marker is fixed in, m.
    pub position: [f64; 3],
}

/// What a flight is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// Coefficients are fitted to it.
    #[default]
    Fit,
    /// It is kept to judge predictions.
    HeldOut,
}

/// A quantity of one flight that was measured by other means, by the model's own name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum KnownValue {
    /// A parameter of this flight, or a state at its first sample.
    Scalar(f64),
    /// An input of the model.
    Vector([f64; 3]),
}

/// One measured flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Flight {
    /// File name inside the folder.
    pub file: String,
    /// Whether it is fitted or held out.
    pub role: Role,
    /// What else is known of this flight, by name.
    pub known: BTreeMap<String, KnownValue>,
    /// Times of the samples, s, increasing.
    pub times: Vec<f64>,
    /// `positions[sample][marker]`, m, in the inertial frame; `None` where the marker was not seen.
    pub positions: Vec<Vec<Option<[f64; 3]>>>,
}

impl Flight {
    /// How many coordinates were measured.
    pub fn measurements(&self) -> usize {
        3 * self
            .positions
            .iter()
            .flatten()
            .filter(|seen| seen.is_some())
            .count()
    }
}

/// Reads a dataset folder.
///
/// # Errors
/// The first fault found, with its file and place: nothing is guessed.
pub fn load(folder: &Path) -> Result<Dataset, InputError> {
    if !folder.is_dir() {
        let found = if folder.exists() {
            "a file"
        } else {
            "no such folder"
        };
        let expected = "a dataset: a folder with dataset.toml";
        return Err(InputError::of_file(folder, found, expected));
    }
    let manifest = manifest::read(&folder.join("dataset.toml"))?;
    assemble(manifest, |entry, markers| {
        let path = folder.join(&entry.file);
        let names: Vec<&str> = markers.iter().map(|marker| marker.name.as_str()).collect();
        if names::is_c3d(&entry.file) {
            let bytes = file::bytes(&path, LARGEST, "a C3D file")?;
            c3d::parse(&path, &bytes, &names)
        } else {
            let bytes = file::bytes(&path, LARGEST, "a table")?;
            table::parse(&path, file::text(&path, &bytes)?, &names)
        }
        .map(|table| (path, table))
    })
}

/// Puts the flights' samples to what the manifest says of them.
fn assemble(
    manifest: manifest::Manifest,
    mut samples: impl FnMut(
        &manifest::Entry,
        &[Marker],
    ) -> Result<(std::path::PathBuf, table::Table), InputError>,
) -> Result<Dataset, InputError> {
    let mut flights = Vec::with_capacity(manifest.flights.len());
    for entry in manifest.flights {
        let (path, table) = samples(&entry, &manifest.markers)?;
        let flight = Flight {
            file: entry.file,
            role: entry.role,
            known: entry.known,
            times: table.times,
            positions: table.positions,
        };
        samples::whole(&path, &flight, &manifest.markers)?;
        flights.push(flight);
    }
    Ok(Dataset {
        model: manifest.model,
        parameters: manifest.parameters,
        markers: manifest.markers,
        sigma: manifest.sigma,
        flights,
    })
}
