//! Datasets that are simulated or imported, and tables from arrays.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::Arc;

use dataset::Marker;
use dataset::synthesize::{Corruption, Plan, Spread, flights};
use flight::release::Release;
use pyo3::prelude::*;

use crate::array::{in_order, labels, numbers, shape_text};
use crate::dataset::Dataset;
use crate::errors::{self, input, raise, raise_or, with_keywords};
use crate::flight::released;
use crate::model::Model;
use crate::work;

/// Options of a synthetic dataset, as Python states them.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Options {
    flights: usize,
    held_out: usize,
    spread: f64,
    duration: Option<f64>,
    rate: f64,
    markers: Vec<(String, [f64; 3])>,
    noise_sigma: f64,
    noise_ar1: f64,
    outliers: f64,
    outlier_size: f64,
    dropouts: f64,
    seed: u64,
}

impl Options {
    fn plan(self) -> Plan {
        let markers = self.markers.into_iter();
        Plan {
            flights: self.flights,
            held_out: self.held_out,
            duration: self.duration,
            rate: self.rate,
            markers: markers
                .map(|(name, position)| Marker { name, position })
                .collect(),
            spread: Spread {
                fraction: self.spread,
                ..Spread::default()
            },
            noise: Corruption {
                sigma: self.noise_sigma,
                ar1: self.noise_ar1,
                outliers: self.outliers,
                outlier_size: self.outlier_size,
                dropouts: self.dropouts,
            },
            seed: self.seed,
            ..Plan::default()
        }
    }
}

/// Makes a dataset of simulated flights; releases are pairs of name and text.
#[pyfunction]
pub fn synthesize(
    py: Python<'_>,
    model: &Bound<'_, Model>,
    releases: Vec<(String, String)>,
    options: &Bound<'_, PyAny>,
) -> PyResult<Dataset> {
    let options: Options = errors::options(options)?;
    let model = model.get();
    let read = releases.iter().map(|(name, text)| {
        let (_, _, release) = released(py, model, name, text, &[])?;
        match release.wind_field {
            Some(_) => Err(input(format!(
                "{name}: found a wind by height or gusts, expected a constant wind"
            ))),
            None => Ok(release),
        }
    });
    let mut releases: Vec<Release> = read.collect::<PyResult<_>>()?;
    if releases.is_empty() {
        return Err(input("found no release, expected at least one"));
    }
    let shown = model.shown();
    for release in &mut releases {
        release.model.clone_from(&shown);
    }
    let (checked, plan) = (Arc::clone(&model.checked), options.plan());
    let made = work::run(py, None, move |_| flights(&checked, &releases, &plan))?;
    let made = made.map_err(raise)?;
    let mut beside = vec![("truth.toml".to_owned(), made.truth.text())];
    let mut data = made.dataset;
    if !model.is_built_in() {
        let file = format!("{}.hyz", model.checked.name);
        beside.push((file.clone(), model.model_text()));
        data.model = file;
    }
    Ok(Dataset {
        beside,
        ..Dataset::of(data, "synthetic".into(), None)
    })
}

/// Recordings, with the files of the flights that were cut from each.
type Recordings = Vec<(PathBuf, Vec<String>)>;

/// Imports recordings by the arguments of `hyzer import`, with known constants.
#[pyfunction]
pub fn import_takes(
    py: Python<'_>,
    arguments: Vec<OsString>,
    parameters: BTreeMap<String, f64>,
) -> PyResult<(Dataset, Recordings)> {
    let made = work::run(py, None, move |_| hyzer::program::import_takes(&arguments))?;
    let mut made = made.map_err(|error| raise_or("InputError", error))?;
    if !parameters.is_empty() {
        made.dataset.parameters.extend(parameters);
        // Constants are checked as those of a file are.
        let data = &made.dataset;
        let tables = data.flights.iter().map(|flight| {
            let text = dataset::table_text(flight, &data.markers, &data.sensors);
            (flight.file.clone(), text)
        });
        let checked = dataset::from_texts(&dataset::manifest_text(data), &tables.collect());
        checked.map_err(raise)?;
    }
    let dataset = Dataset {
        beside: made.beside,
        comments: made.comments,
        decisions: with_keywords(&made.decisions),
        ..Dataset::of(made.dataset, String::new(), None)
    };
    Ok((dataset, made.recordings))
}

/// Text of a table from the arrays of its columns: name in messages, endings of the columns' names, numbers.
#[pyfunction]
pub fn table_text(columns: Vec<(String, Vec<String>, Bound<'_, PyAny>)>) -> PyResult<String> {
    let (mut heads, mut parts) = (Vec::new(), Vec::new());
    let mut rows: Option<usize> = None;
    for (what, names, array) in columns {
        // Columns of a DataFrame may be named as in a table, or x, y, z.
        let array = match labels(&array)? {
            Some(own) if names.len() > 1 => {
                let short = |name: &String| name.rsplit('_').next().unwrap_or(name).to_owned();
                let short: Vec<String> = names.iter().map(short).collect();
                let is_short = own.iter().flatten().any(|own| short.contains(own));
                in_order(&array, &what, if is_short { &short } else { &names })?
            }
            _ => array,
        };
        let (values, shape) = numbers(&array, &what)?;
        let (found, width) = match shape[..] {
            [found] => (found, 1),
            [found, width] => (found, width),
            _ => (0, 0),
        };
        let expected = *rows.get_or_insert(found);
        if width != names.len() || found != expected {
            let (names, found) = (names.len(), shape_text(&shape));
            return Err(input(format!(
                "{what} has the shape {found}, expected {expected} rows of {names}"
            )));
        }
        heads.extend(names);
        parts.push((values, width));
    }
    let mut text = heads.join(",") + "\n";
    for row in 0..rows.unwrap_or(0) {
        let cells = parts
            .iter()
            .flat_map(|(values, width)| &values.values()[row * width..][..*width]);
        let cells = cells.map(|value| {
            if value.is_nan() {
                String::new()
            } else {
                value.to_string()
            }
        });
        text += &cells.collect::<Vec<_>>().join(",");
        text.push('\n');
    }
    Ok(text)
}

impl Model {
    /// Whether the model is a built-in one as it stands.
    pub fn is_built_in(&self) -> bool {
        !self.is_text() && self.added.is_empty() && self.replaced.is_empty() && !self.is_of_files
    }

    /// Name of the model in files that are written: of a built-in one its name, else that of a file.
    pub fn shown(&self) -> String {
        match self.is_built_in() {
            true => self.source.clone(),
            false => format!("{}.hyz", self.checked.name),
        }
    }
}
