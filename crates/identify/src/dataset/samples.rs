//! What samples of a flight may be, whichever file they come from.

use std::fmt::Display;
use std::path::Path;

use super::{Flight, Marker};
use crate::input_error::InputError;
use crate::statistics::median;

/// Farthest coordinate, m.
const FARTHEST: f64 = 1e4;
/// Longest flight, s: as long as the program itself follows one.
const LONGEST: f64 = flight::release::Release::MAX_DURATION;
/// Greatest speed over half of a flight, m/s.
const FASTEST: f64 = 1e3;
/// Two markers farther apart than so many times what is declared, and than `WIDEST` m, are not in metres.
const STRETCHED: f64 = 30.0;
const WIDEST: f64 = 1.0;
/// Most points of a flight: they bound the memory that it takes.
const MOST: usize = 1 << 23;

/// What was found and what was expected.
type Wrong = (String, String);

/// Most samples of a flight with so many markers.
pub(super) fn most(markers: usize) -> usize {
    MOST / markers.max(1)
}

/// Checks the time of a sample that comes after others.
pub(super) fn time(first: Option<&f64>, before: Option<&f64>, time: f64) -> Result<(), Wrong> {
    let (Some(&first), Some(&before)) = (first, before) else {
        return Ok(());
    };
    if time <= before {
        return Err((format!("t = {time}"), format!("a time after {before} s")));
    }
    if time - first > LONGEST {
        let expected =
            format!("at most {LONGEST} s after the first sample (milliseconds given for seconds?)");
        return Err((format!("t = {time}"), expected));
    }
    Ok(())
}

/// Checks a coordinate.
pub(super) fn coordinate(name: &dyn Display, value: f64) -> Result<(), Wrong> {
    if value.abs() <= FARTHEST {
        return Ok(());
    }
    let expected = format!("at most {FARTHEST} m from the origin (millimetres given for metres?)");
    Err((format!("{name} = {value}"), expected))
}

/// Checks what only the whole flight shows: that something was seen, in metres and seconds.
pub(super) fn whole(file: &Path, flight: &Flight, markers: &[Marker]) -> Result<(), InputError> {
    let wrong = |found: String, expected: &str| Err(InputError::of_file(file, found, expected));
    if flight.positions.iter().flatten().all(Option::is_none) {
        return wrong(
            "dropouts alone".into(),
            "a marker that is seen at least once",
        );
    }
    if let Some((apart, declared)) = apart(flight, markers)
        && apart > STRETCHED * declared
        && apart > WIDEST
    {
        return wrong(
            format!(
                "{} and {} {apart:.3} m apart, declared {declared:.3} m apart",
                markers[0].name, markers[1].name
            ),
            "positions in metres (millimetres given for metres?)",
        );
    }
    if let Some(speed) = speed(flight)
        && speed > FASTEST
    {
        return wrong(
            format!("a speed of {speed:.0} m/s"),
            "at most 1000 m/s (millimetres given for metres?)",
        );
    }
    Ok(())
}

/// The median distance between the first two markers, and the declared one.
fn apart(flight: &Flight, markers: &[Marker]) -> Option<(f64, f64)> {
    let [first, second, ..] = markers else {
        return None;
    };
    let seen = flight.positions.iter();
    let measured = seen.filter_map(|row| Some(distance(row[0]?, row[1]?)));
    let mut measured: Vec<f64> = measured.collect();
    let declared = distance(first.position, second.position);
    (!measured.is_empty()).then(|| (median(&mut measured), declared))
}

/// The median speed of the first marker from each sample to the one half a flight later: one outlier does not move it.
fn speed(flight: &Flight) -> Option<f64> {
    let half = flight.times.len() / 2;
    if half < 2 {
        return None;
    }
    let speeds = (half..flight.times.len()).filter_map(|i| {
        let moved = distance(flight.positions[i][0]?, flight.positions[i - half][0]?);
        Some(moved / (flight.times[i] - flight.times[i - half]))
    });
    let mut speeds: Vec<f64> = speeds.collect();
    (!speeds.is_empty()).then(|| median(&mut speeds))
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b).powi(2));
    squares.sum::<f64>().sqrt()
}
