//! Plausibility checks of a flight's samples, for tables and C3D files.

use std::fmt::Display;
use std::path::Path;

use super::{Flight, Marker};
use crate::input_error::InputError;
use crate::pose::distance;
use crate::statistics::median_of;
use crate::takes::LengthUnit;

const MAX_COORDINATE: f64 = 1e4;
/// Maximum duration of a measured flight, s; equal to the limit for simulated flights.
const MAX_SECONDS: f64 = flight::release::Release::MAX_DURATION;
/// Maximum median speed of a marker over half of a flight, m/s; larger values suggest millimetres.
const MAX_SPEED: f64 = 1e3;
/// Maximum plausible ratio of the measured distance between two markers to their distance according to `dataset.toml`.
const MAX_STRETCH: f64 = 30.0;
const MIN_REJECTED: f64 = 1.0;
/// Maximum relative deviation of such a ratio from that of a unit that is named.
const UNIT_TOLERANCE: f64 = 0.03;
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
    if let Some((apart, declared)) = distance_of(flight, markers, 1) {
        let is_far = apart > MAX_STRETCH * declared && apart > MIN_REJECTED;
        let unit = unit_of(apart / declared);
        if is_far || is_in_feet(flight, markers) {
            let [first, second] = [0, 1].map(|marker: usize| &markers[marker].name);
            let found =
                format!("{first} and {second} {apart:.3} m apart, declared {declared:.3} m apart");
            let note = match unit {
                None => "another unit given for metres?".to_owned(),
                Some(unit) => format!(
                    "{} given for metres? then length = \"{unit}\" of [recording]",
                    unit.plural()
                ),
            };
            return wrong(found, &format!("positions in metres ({note})"));
        }
    }
    match speed(flight) {
        Some(speed) if speed > MAX_SPEED => wrong(
            format!("a speed of {speed:.0} m/s"),
            "at most 1000 m/s (millimetres given for metres?)",
        ),
        _ => Ok(()),
    }
}

/// Unit in which lengths are `ratio` times as many as in metres.
fn unit_of(ratio: f64) -> Option<LengthUnit> {
    use LengthUnit::{Centimetre, Foot, Inch, Millimetre};
    let fits = |unit: &LengthUnit| (ratio * unit.metres() - 1.0).abs() < UNIT_TOLERANCE;
    [Foot, Inch, Centimetre, Millimetre].into_iter().find(fits)
}

/// Whether at least three markers are all as far from the first as they were in feet, which noise does not explain.
fn is_in_feet(flight: &Flight, markers: &[Marker]) -> bool {
    let pairs = (1..markers.len()).filter_map(|second| distance_of(flight, markers, second));
    let units: Vec<_> = pairs
        .map(|(apart, declared)| unit_of(apart / declared))
        .collect();
    units.len() > 1 && units.iter().all(|unit| *unit == Some(LengthUnit::Foot))
}

/// Median measured distance of a marker from the first one, and their distance according to `dataset.toml`, m.
fn distance_of(flight: &Flight, markers: &[Marker], second: usize) -> Option<(f64, f64)> {
    let declared = distance(markers.first()?.position, markers.get(second)?.position);
    let seen = flight.positions.iter();
    let measured = median_of(seen.filter_map(|row| Some(distance(row[0]?, row[second]?))))?;
    Some((measured, declared))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_name_a_unit() {
        for (ratio, unit) in [
            (100.4, Some(LengthUnit::Centimetre)),
            (39.2, Some(LengthUnit::Inch)),
            (3.29, Some(LengthUnit::Foot)),
            (995.0, Some(LengthUnit::Millimetre)),
            (300.0, None),
            (1.0, None),
        ] {
            assert_eq!(unit_of(ratio), unit, "{ratio}");
        }
    }
}
