//! Measured flights of a body, as a dataset: a folder with `dataset.toml` and, for each flight, one table or C3D file.
//!
//! Reading returns the complete dataset or an error with its location. Whether the dataset can be fitted is checked
//! later by the fit: a flight of one sample, or a dataset whose flights are all held out, is a valid dataset.
//! [`synthesize`] creates datasets whose true coefficients are known.

mod body_template;
mod c3d;
pub mod contact;
mod even_times;
mod fault;
mod fields;
mod file;
mod header;
mod in_memory;
mod input_error;
mod inputs;
mod launch_monitor;
pub mod levels;
mod lines;
mod manifest;
mod manifest_sensors;
mod names;
pub mod pose;
mod pose_points;
mod recording;
mod samples;
pub mod screening;
mod seen_path;
mod sensor;
mod stated;
pub mod statistics;
mod summary;
mod summary_columns;
mod summary_table;
mod summary_text;
pub mod synthesize;
mod table;
pub mod takes;
mod toml_text;
mod unplaced;
mod upright;
mod words;
mod write;

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

pub use body_template::BodyTemplate;
pub use fault::{DataFault, FaultKind};
use flight::{InputInterpolation, InputSeries, parallel};
pub use in_memory::from_texts;
pub use input_error::InputError;
pub use launch_monitor::{ImportedShots, ShotOptions, import_shots, read_shots, table_rows};
pub use pose_points::PosePoints;
pub use recording::{ACCELERATIONS, ANGULAR_RATES, SPEEDS};
pub use seen_path::{Seen, path_noise, seen_path};
pub use sensor::{
    Reading, Sensor, SensorKind, attitude, points_on_body, points_seen, spin_axis, turned,
};
pub use summary::{SummaryColumn, SummaryEvent, SummaryQuantity, SummaryUnit};
use toml_text::quoted;
pub use write::{manifest_text, table_text, write, write_commented, write_with};

/// Names of the inertial axes, as in the columns `NAME_x`, `NAME_y` and `NAME_z` of a marker.
pub const AXES: [&str; 3] = ["x", "y", "z"];

const MAX_BYTES: u64 = 1 << 30;

/// Measured flights of one body. The default has no flights, no sensors and no known values.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dataset {
    /// Name or path of the model, as in `dataset.toml`.
    pub model: String,
    /// Known constants of the body or its environment, by name, that replace the model's defaults, SI.
    pub parameters: BTreeMap<String, f64>,
    /// Tracked points of the body (markers), with their names and their positions on the body.
    pub markers: Vec<Marker>,
    /// Sensors other than markers, such as gyroscopes.
    pub sensors: Vec<Sensor>,
    /// Whether the direction of the vertical relative to the axes is unknown; otherwise the z axis points up.
    pub unknown_vertical: bool,
    /// Standard errors of the origin along the body axes, m; it is then estimated in the fit. `None` if it is exact.
    pub origin_error: Option<[f64; 3]>,
    /// Standard error of the direction of the third axis, rad; it is then estimated in the fit. `None` if it is exact.
    pub axis_error: Option<f64>,
    /// Standard deviation of one coordinate of a measured position, m; `None` if unknown.
    pub sigma: Option<f64>,
    /// Inputs, coefficients or constants of the model that are estimated for each flight by itself.
    pub unknown: Vec<String>,
    /// Interpolation of the inputs over time.
    pub input_interpolation: InputInterpolation,
    /// What the reports say of the recordings, such as that a device did not measure what it tells.
    #[doc(hidden)]
    pub notes: Vec<String>,
    /// The measured flights, in the order of their entries in `dataset.toml`.
    pub flights: Vec<Flight>,
}

/// A point of the body whose position is tracked.
#[derive(Clone, Debug, PartialEq)]
pub struct Marker {
    /// Name of the marker; the names of its columns begin with it (`m1` in `m1_x`).
    pub name: String,
    /// Position of the marker in the model's marker frame, usually the body frame, m.
    pub position: [f64; 3],
}

/// Use of a flight: for the estimation of parameters (fitted), or only to test predictions (held out).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// The parameters of the model are estimated from the flight.
    #[default]
    Fit,
    /// The flight is excluded from the estimation and used to test predictions.
    HeldOut,
}

impl Role {
    /// The role as `dataset.toml` spells it.
    #[doc(hidden)]
    pub fn name(self) -> &'static str {
        match self {
            Role::Fit => "fit",
            Role::HeldOut => "held-out",
        }
    }
}

/// Value, for one flight, of a quantity of the model that was measured independently or was set, such as the wind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum KnownValue {
    /// Value of a parameter, or of a state at the first sample, SI.
    Scalar(f64),
    /// Value of a vector input of the model, such as `wind`, SI.
    Vector([f64; 3]),
}

impl KnownValue {
    /// End of the name under which the standard deviation of a known value is stated.
    #[doc(hidden)]
    pub const SIGMA: &str = "_sigma";
}

/// One measured flight. The default is a fitted flight without samples.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Flight {
    /// File name of the flight, relative to the dataset's folder.
    pub file: String,
    /// Whether the flight is fitted or held out.
    pub role: Role,
    /// Values of model quantities in this flight that are known from elsewhere, such as the wind, by name.
    ///
    /// `NAME_sigma` is the standard deviation with which `NAME` was measured, which is then estimated with it.
    pub known: BTreeMap<String, KnownValue>,
    /// Inputs, coefficients or constants of the model that are estimated for this flight by itself.
    pub unknown: Vec<String>,
    /// Inputs of the model that were recorded over time, by name; times are those of the samples.
    pub inputs: Vec<(String, InputSeries)>,
    /// Times of the samples, s, increasing.
    pub times: Vec<f64>,
    /// `positions[sample][marker]`, m, in the inertial frame; `None` if the marker was not measured.
    pub positions: Vec<Vec<Option<[f64; 3]>>>,
    /// `readings[sample][channel]`, the channels of all sensors one after another; `None` for a missing reading.
    pub readings: Vec<Vec<Option<Reading>>>,
}

impl Dataset {
    /// Whether a flight of the dataset is a row of a table of summaries, and no track.
    #[doc(hidden)]
    pub fn is_summary(&self, flight: &Flight) -> bool {
        summary_text::is_of(flight, &self.sensors)
    }

    /// Values of a column of summaries, in its unit.
    #[doc(hidden)]
    pub fn values_of(&self, column: &Sensor) -> impl Iterator<Item = f64> {
        let place = sensor::channels(&self.sensors).position(|(own, _)| own == column);
        let rows = self
            .flights
            .iter()
            .filter_map(|flight| flight.readings.first());
        rows.filter_map(move |row| row.get(place?).copied().flatten().map(|own| own[0]))
    }
}

/// Number of measured positions of markers and readings of sensors in a flight.
pub fn measurements(flight: &Flight) -> usize {
    let positions = flight.positions.iter().flatten().flatten().count();
    positions + flight.readings.iter().flatten().flatten().count()
}

/// Reads and checks a dataset folder (`dataset.toml` and the tables of the flights), with one thread per processor.
///
/// # Errors
/// [`InputError`] for the first fault, with its file and location.
pub fn load(folder: &Path) -> Result<Dataset, InputError> {
    load_on(folder, None)
}

/// Reads and checks a dataset folder on `threads` threads; `None` for one thread per processor.
///
/// # Errors
/// As for [`load`].
pub fn load_on(folder: &Path, threads: Option<usize>) -> Result<Dataset, InputError> {
    if !folder.is_dir() {
        let found = match folder.exists() {
            true => "a file",
            false => "no such folder",
        };
        let expected = "a dataset: a folder with dataset.toml";
        return Err(InputError::of_file(folder, found, expected));
    }
    let manifest = manifest::read(&folder.join("dataset.toml"))?;
    let threads = threads.unwrap_or_else(parallel::threads);
    assemble(manifest, threads, |file| {
        let path = folder.join(file);
        let is_c3d = names::is_c3d(&path);
        let what = if is_c3d { "a C3D file" } else { "a table" };
        let bytes = file::bytes(&path, MAX_BYTES, what)?;
        Ok((path, bytes.into(), is_c3d))
    })
}

/// Combines the checked contents of `dataset.toml` with the samples of each flight.
fn assemble<'t>(
    manifest: manifest::Manifest,
    threads: usize,
    read: impl Fn(&str) -> Result<(PathBuf, Cow<'t, [u8]>, bool), InputError> + Sync,
) -> Result<Dataset, InputError> {
    let (mut flights, mut paths) = (Vec::with_capacity(manifest.flights.len()), Vec::new());
    let mut rounded: Vec<(String, f64)> = Vec::new();
    let mut dataset = manifest.dataset;
    let names = dataset.markers.iter().map(|marker| marker.name.as_str());
    let names: Vec<&str> = names.collect();
    let (recording, sensors) = (&manifest.recording, &dataset.sensors[..]);
    let interpolation = dataset.input_interpolation;
    let tables = parallel::each_on(threads, manifest.flights.len(), |index| {
        let entry = &manifest.flights[index];
        let (path, bytes, is_c3d) = read(&entry.flight.file)?;
        let table = if !is_c3d {
            table::parse(
                &path,
                &file::table_text(&path, &bytes)?,
                (&names, sensors),
                recording,
            )?
        } else if let Some(sensor) = sensors.first() {
            let found = format!("the sensor {} with a C3D file", sensor.name);
            let expected = "a table: C3D has only points";
            return Err(InputError::of_file(&path, found, expected));
        } else {
            c3d::parse(&path, &bytes, &names)?
        };
        let mut table = upright::upright(recording, table, sensors);
        let mut inputs = std::mem::take(&mut table.inputs).series(&path, interpolation)?;
        stated::check_inputs(&entry.stated, &entry.flight.file, &inputs)?;
        if let Some(file) = &entry.inputs {
            let (path, bytes, _) = read(file)?;
            let text = file::text(&path, &bytes)?;
            let own = inputs::parse(&path, text, recording, interpolation)?;
            if let Some((name, _)) = own
                .iter()
                .find(|(name, _)| inputs.iter().any(|i| i.0 == *name))
            {
                let found = format!("the input {name}, which the flight's own table has too");
                return Err(InputError::of_file(&path, found, "each input once"));
            }
            stated::check_inputs(&entry.stated, file, &own)?;
            inputs.extend(own);
        }
        Ok((path, table, inputs))
    });
    for (entry, table) in manifest.flights.into_iter().zip(tables) {
        let (path, table, inputs) = table?;
        paths.push(path);
        rounded.extend(table.rounded.map(|unit| (entry.flight.file.clone(), unit)));
        flights.push(Flight {
            inputs,
            times: table.times,
            positions: table.positions,
            readings: table.readings,
            ..entry.flight
        });
    }
    let notes = manifest.summaries.iter().flat_map(|own| own.notes.clone());
    dataset.notes = notes.chain(even_times::note(&rounded)).collect();
    let (markers, sensors) = (&mut dataset.markers, &mut dataset.sensors);
    let rows = summary_flights(&manifest.summaries, markers.len(), sensors, &read)?;
    fill_readings(&mut flights, sensors);
    for (path, flight) in rows {
        paths.push(path);
        flights.push(flight);
    }
    dataset.unknown_vertical = manifest.recording.up == recording::Up::Unknown;
    let unplaced = (&manifest.unplaced[..], !dataset.unknown_vertical);
    if let Some(found) = unplaced::estimate_positions(markers, unplaced, sensors, &flights)? {
        dataset.origin_error.get_or_insert(found.origin_error());
        dataset.axis_error.get_or_insert(found.axis_error());
    }
    for (path, flight) in paths.iter().zip(&flights) {
        samples::check_flight(path, flight, markers)?;
    }
    Ok(Dataset { flights, ..dataset })
}

/// Flights that are rows of tables of summaries, each with its table's path; adds their columns to `sensors` once.
fn summary_flights<'t>(
    entries: &[summary_columns::SummariesEntry],
    markers: usize,
    sensors: &mut Vec<Sensor>,
    read: impl Fn(&str) -> Result<(PathBuf, Cow<'t, [u8]>, bool), InputError>,
) -> Result<Vec<(PathBuf, Flight)>, InputError> {
    let before = sensor::channels(sensors).count();
    let first = sensors.len();
    let mut flights = Vec::new();
    for entry in entries {
        let (path, bytes, _) = read(&entry.file)?;
        let rows = summary_table::parse(&path, &file::table_text(&path, &bytes)?, entry)?;
        let places = entry.columns.iter().map(|column| {
            let known = sensors[first..].iter().position(|own| own == column);
            known.unwrap_or_else(|| {
                sensors.push(column.clone());
                sensors.len() - 1 - first
            })
        });
        let places: Vec<usize> = places.collect();
        for (line, values) in rows {
            let mut readings = vec![None; before + sensors.len() - first];
            for (place, value) in places.iter().zip(values) {
                readings[before + place] = value.map(|value| [value, 0.0, 0.0, 0.0]);
            }
            let role = match entry.held_out.contains(&line) {
                true => Role::HeldOut,
                false => Role::Fit,
            };
            let flight = Flight {
                file: format!("{}:{line}", entry.file),
                role,
                known: entry.known.clone(),
                unknown: entry.unknown.clone(),
                times: vec![0.0],
                positions: vec![vec![None; markers]],
                readings: vec![readings],
                ..Flight::default()
            };
            flights.push((path.clone(), flight));
        }
    }
    let channels = before + sensors.len() - first;
    for (_, flight) in &mut flights {
        flight.readings[0].resize(channels, None);
    }
    Ok(flights)
}

/// Adds missing readings of the columns of summaries to the tracks.
fn fill_readings(flights: &mut [Flight], sensors: &[Sensor]) {
    let channels = sensor::channels(sensors).count();
    if !sensors
        .iter()
        .any(|sensor| matches!(sensor.kind, SensorKind::Summary(_)))
    {
        return;
    }
    for flight in flights {
        flight.readings.resize(flight.times.len(), Vec::new());
        for row in &mut flight.readings {
            row.resize(channels, None);
        }
    }
}
