//! Reader of marker positions from a C3D file (motion capture), for the markers that a dataset declares.
//!
//! Labels that the dataset does not declare are ignored. A file that contradicts itself is refused; `hyzer import`
//! reads more of such files and reports how it interpreted them.

use std::path::Path;

use crate::takes::c3d::Recording;
use flight::table::{listed, shown};

use super::AXES;
use super::samples::{self, Unexpected};
use super::table::Table;
use crate::input_error::InputError;
use crate::takes::Fault;

pub(super) fn parse(file: &Path, bytes: &[u8], markers: &[&str]) -> Result<Table, InputError> {
    table(bytes, markers).map_err(|(found, expected)| InputError::of_file(file, found, expected))
}

fn texts(error: Fault) -> Unexpected {
    (error.found, error.expected)
}

fn table(bytes: &[u8], markers: &[&str]) -> Result<Table, Unexpected> {
    let recording = Recording::open(bytes).map_err(texts)?;
    if let Some(deviation) = recording.deviations.first() {
        return Err(texts(deviation.contradiction.clone()));
    }
    let (unit, text) = recording.unit().map_err(texts)?;
    if !["m", "cm", "mm"].contains(&text.to_ascii_lowercase().as_str()) {
        let found = format!("the unit {}", shown(&text));
        return Err((found, "m, cm or mm in POINT:UNITS".into()));
    }
    let rate = recording.rate().map_err(texts)?;
    if recording.frames() > samples::max_samples(markers.len()) {
        let expected = format!("at most {}", samples::max_samples(markers.len()));
        return Err((format!("{} frames", recording.frames()), expected));
    }
    let points = markers.iter().map(|marker| point_index(&recording, marker));
    let points = points.collect::<Result<Vec<usize>, Unexpected>>()?;
    let mut table = Table::default();
    for frame in 0..recording.frames() {
        let time = (f64::from(recording.first_frame()) + frame as f64) / rate;
        samples::check_time(table.times.first(), table.times.last(), time)?;
        let mut row = Vec::with_capacity(markers.len());
        for (&point, marker) in points.iter().zip(markers) {
            let position = recording.position(frame, point);
            let position = position.map(|raw| raw.map(|x| x * unit.metres()));
            let number = u64::from(recording.first_frame()) + frame as u64;
            for (value, axis) in position.into_iter().flatten().zip(AXES) {
                let name = format_args!("{marker}_{axis} of frame {number}");
                samples::check_coordinate(&name, value)?;
            }
            row.push(position);
        }
        table.positions.push(row);
        table.times.push(time);
    }
    Ok(table)
}

/// Index, among the points in each frame of a C3D recording, of the point with the label `marker`.
fn point_index(recording: &Recording<'_>, marker: &str) -> Result<usize, Unexpected> {
    let labels = &recording.labels;
    let mut found =
        (0..recording.points.min(labels.len())).filter(|&point| labels[point] == marker);
    match (found.next(), found.next()) {
        (Some(point), None) => Ok(point),
        (Some(_), Some(_)) => Err((
            format!("two points {}", shown(marker)),
            "each declared marker once in POINT:LABELS".into(),
        )),
        (None, _) => {
            let labels = labels.iter().map(|label| shown(label));
            Err((
                format!("the labels {}", listed(labels)),
                format!("every declared marker among them, as {}", shown(marker)),
            ))
        }
    }
}
