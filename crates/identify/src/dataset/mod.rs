//! A dataset: a folder with `dataset.toml` and one table per flight.

mod manifest;
mod table;

use std::collections::BTreeMap;
use std::path::Path;

pub use manifest::Role;

use crate::error::InputError;

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

/// One measured flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Flight {
    /// File name inside the folder.
    pub file: String,
    /// Whether it is fitted or held out.
    pub role: Role,
    /// Inputs of the model that are known for this flight, by name.
    pub known: BTreeMap<String, [f64; 3]>,
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
    let manifest = manifest::read(&folder.join("dataset.toml"))?;
    let names: Vec<&str> = manifest
        .markers
        .iter()
        .map(|marker| marker.name.as_str())
        .collect();
    let mut flights = Vec::with_capacity(manifest.flights.len());
    for entry in manifest.flights {
        let table = table::read(&folder.join(&entry.file), &names)?;
        flights.push(Flight {
            file: entry.file,
            role: entry.role,
            known: entry.known,
            times: table.times,
            positions: table.positions,
        });
    }
    Ok(Dataset {
        model: manifest.model,
        parameters: manifest.parameters,
        markers: manifest.markers,
        sigma: manifest.sigma,
        flights,
    })
}
