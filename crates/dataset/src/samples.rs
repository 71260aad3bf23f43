//! Plausibility checks of a flight's samples, for tables and C3D files.

use std::fmt::Display;
use std::path::Path;

use super::{Flight, Marker};
use crate::input_error::InputError;
use crate::pose::distance;
use crate::statistics::median_of;

const MAX_COORDINATE: f64 = 1e4;
/// Maximum duration of a measured flight, s; equal to the limit for simulated flights.
const MAX_SECONDS: f64 = flight::release::Release::MAX_DURATION;
/// Maximum median speed of a marker over half of a flight, m/s; larger values suggest millimetres.
const MAX_SPEED: f64 = 1e3;
/// Maximum plausible ratio of the measured distance between two markers to their distance according to `dataset.toml`.
const MAX_STRETCH: f64 = 30.0;
const MIN_REJECTED: f64 = 1.0;
/// Maximum product of the samples of a flight and its markers and sensor channels; it bounds the memory used.
const MAX_VALUES: usize = 1 << 23;

/// Texts of an input error: what was found in the file, and what was expected instead.
pub(super) type Unexpected = (String, String);

/// Maximum number of samples of a flight; `markers` is the total number of its markers and sensor channels.
pub(super) fn max_samples(markers: usize) -> usize {
    MAX_VALUES / markers.max(1)
}

/// An error if `time`, s, is not after the previous time, `before`, or is over [`MAX_SECONDS`] after the `first` one.
pub(super) fn check_time(
    first: Option<&f64>,
    before: Option<&f64>,
    time: f64,
) -> Result<(), Unexpected> {
    let (Some(&first), Some(&before)) = (first, before) else {
        return Ok(());
    };
    if time <= before {
        return Err((format!("t = {time}"), format!("a time after {before} s")));
    }
    if time - first > MAX_SECONDS {
        let expected = format!(
            "at most {MAX_SECONDS} s after the first sample (milliseconds given for seconds?)"
        );
        return Err((format!("t = {time}"), expected));
    }
    Ok(())
}

/// Returns an error if `value`, a coordinate of a marker position, m, exceeds [`MAX_COORDINATE`] in magnitude.
pub(super) fn check_coordinate(name: &dyn Display, value: f64) -> Result<(), Unexpected> {
    if value.abs() <= MAX_COORDINATE {
        return Ok(());
    }
    let expected =
        format!("at most {MAX_COORDINATE} m from the origin (millimetres given for metres?)");
    Err((format!("{name} = {value}"), expected))
}

/// Checks a flight that has been read: it must have a measured value, and plausible distances and speeds of markers.
pub(super) fn check_flight(
    file: &Path,
    flight: &Flight,
    markers: &[Marker],
) -> Result<(), InputError> {
    let wrong = |found: String, expected: &str| Err(InputError::of_file(file, found, expected));
    if super::measurements(flight) == 0 {
        return wrong(
            "dropouts alone".into(),
            "a marker that is seen at least once",
        );
    }
    if let Some((apart, declared)) = first_distance(flight, markers)
        && apart > MAX_STRETCH * declared
        && apart > MIN_REJECTED
    {
        let [first, second] = [0, 1].map(|marker: usize| &markers[marker].name);
        let found =
            format!("{first} and {second} {apart:.3} m apart, declared {declared:.3} m apart");
        return wrong(found, "positions in metres (millimetres given for metres?)");
    }
    match speed(flight) {
        Some(speed) if speed > MAX_SPEED => wrong(
            format!("a speed of {speed:.0} m/s"),
            "at most 1000 m/s (millimetres given for metres?)",
        ),
        _ => Ok(()),
    }
}

/// Median measured distance between the first two markers, and their distance according to `dataset.toml`, m.
fn first_distance(flight: &Flight, markers: &[Marker]) -> Option<(f64, f64)> {
    let [first, second, ..] = markers else {
        return None;
    };
    let seen = flight.positions.iter();
    let measured = median_of(seen.filter_map(|row| Some(distance(row[0]?, row[1]?))))?;
    Some((measured, distance(first.position, second.position)))
}

/// Median speed of the first marker, m/s, over samples half a flight apart; `None` if the flight is too short.
fn speed(flight: &Flight) -> Option<f64> {
    let half = flight.times.len() / 2;
    if half < 2 {
        return None;
    }
    let first = |i: usize| flight.positions[i].first().copied().flatten();
    let speeds = (half..flight.times.len()).filter_map(|i| {
        let moved = distance(first(i)?, first(i - half)?);
        Some(moved / (flight.times[i] - flight.times[i - half]))
    });
    median_of(speeds)
}
