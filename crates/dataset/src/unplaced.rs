//! Estimates, from the flights, positions on the body that a dataset does not state.

use crate::takes::{EstimatedTemplate, FreeFlight, estimate_template};
use nalgebra::Vector3;

use super::sensor::attitude;
use super::{Flight, Marker, Sensor, SensorKind};
use crate::input_error::InputError;
use crate::pose::{fix_attitude, pose};
use crate::statistics::median_vector;

/// A marker with the position `"unknown"` in `dataset.toml`.
///
/// # Errors
/// [`InputError`], located at the first marker concerned, if the flights do not determine the positions.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Unplaced {
    pub marker: usize,
    /// Error located at the marker's entry in `dataset.toml`, for a position that cannot be estimated.
    pub place: InputError,
}

impl Unplaced {
    fn error(&self, found: impl Into<String>, expected: &str) -> InputError {
        InputError {
            found: found.into(),
            expected: expected.to_owned(),
            ..self.place.clone()
        }
    }
}

/// The condition under which unknown marker positions can be estimated, for messages.
const NEEDED: &str = "at least three markers with positions that are not on a line, or none";

/// Estimates the unknown positions of markers and pose sensors and writes them into `markers` and `sensors`. If all
/// positions of markers are unknown, returns the template that was estimated from the flights; otherwise `None`.
pub(super) fn estimate_positions(
    markers: &mut [Marker],
    (unplaced, vertical_is_known): (&[Unplaced], bool),
    sensors: &mut [Sensor],
    flights: &[Flight],
) -> Result<Option<EstimatedTemplate>, InputError> {
    let mut template = None;
    if let Some(first) = unplaced.first() {
        if unplaced.len() == markers.len() {
            if !vertical_is_known {
                let expected = "positions of the markers, or the direction up";
                return Err(first.error("no position of a marker and up = \"unknown\"", expected));
            }
            template = Some(estimate_all_markers(markers, first, flights)?);
        } else {
            estimate_some_markers(markers, unplaced, flights)?;
        }
    }
    estimate_pose_sensors(markers, sensors, flights);
    Ok(template)
}

fn estimate_all_markers(
    markers: &mut [Marker],
    first: &Unplaced,
    flights: &[Flight],
) -> Result<EstimatedTemplate, InputError> {
    let labels: Vec<String> = markers.iter().map(|marker| marker.name.clone()).collect();
    let free = flights.iter().map(|flight| FreeFlight {
        times: &flight.times,
        positions: &flight.positions,
    });
    let free: Vec<FreeFlight<'_>> = free.collect();
    let template = estimate_template(&labels, &free, None).map_err(|error| {
        let found = format!("flights that do not place the markers: {error}");
        let expected = "flights that tell the positions of the markers, or these positions";
        first.error(found, expected)
    })?;
    for (marker, found) in markers.iter_mut().zip(&template.markers) {
        marker.position = found.position;
    }
    Ok(template)
}

/// Estimates the unknown positions of some markers from the known positions of the remaining markers.
fn estimate_some_markers(
    markers: &mut [Marker],
    unplaced: &[Unplaced],
    flights: &[Flight],
) -> Result<(), InputError> {
    let is_placed = |marker: &usize| unplaced.iter().all(|own| own.marker != *marker);
    let placed: Vec<usize> = (0..markers.len()).filter(is_placed).collect();
    let known = placed.iter().map(|&marker| markers[marker].position);
    let known: Vec<[f64; 3]> = known.collect();
    if !fix_attitude(&known) {
        let found = format!(
            "{} of {} markers with a position",
            known.len(),
            markers.len()
        );
        return Err(unplaced[0].error(found, NEEDED));
    }
    for own in unplaced {
        let seen = flights.iter().flat_map(|flight| &flight.positions);
        let on_body = seen.filter_map(|row| {
            let own = row[own.marker]?;
            let others: Vec<_> = placed.iter().map(|&marker| row[marker]).collect();
            let body = pose(&known, &others)?;
            Some(body.attitude.inverse() * (Vector3::from(own) - body.position))
        });
        let marker = &mut markers[own.marker];
        let position = median_vector(&on_body.collect::<Vec<_>>()).ok_or_else(|| {
            let found = format!("{} never seen together with the others", marker.name);
            own.error(
                found,
                "samples that show it with three others, or its position",
            )
        })?;
        marker.position = position.into();
    }
    Ok(())
}

/// Estimates the unknown positions of pose sensors if the markers determine an attitude.
fn estimate_pose_sensors(markers: &[Marker], sensors: &mut [Sensor], flights: &[Flight]) {
    let known: Vec<[f64; 3]> = markers.iter().map(|marker| marker.position).collect();
    let mut channel = 0;
    for sensor in sensors {
        let at = channel;
        channel += sensor.kind.channels().len();
        if sensor.kind != SensorKind::Pose || !sensor.position_is_unknown || !fix_attitude(&known) {
            continue;
        }
        let rows = flights
            .iter()
            .flat_map(|flight| flight.positions.iter().zip(&flight.readings));
        let on_body = rows.filter_map(|(positions, readings)| {
            let (place, turn) = (readings[at]?, readings[at + 1]?);
            let body = pose(&known, positions)?;
            let place = Vector3::new(place[0], place[1], place[2]);
            Some(attitude(turn).inverse() * (place - body.position))
        });
        if let Some(position) = median_vector(&on_body.collect::<Vec<_>>()) {
            sensor.position = position.into();
            sensor.position_is_unknown = false;
        }
    }
}
