//! Conversion of a table to SI units and right-handed axes with z up, if the vertical is known.

use super::recording::Recording;
use super::sensor::{Reading, Sensor, SensorKind, channels};
use super::table::Table;

/// Converts the marker positions (m), poses and readings of a flight's table to right-handed axes with z up and SI
/// units; an unknown vertical leaves the direction of z unchanged.
pub(super) fn upright(recording: &Recording, mut table: Table, sensors: &[Sensor]) -> Table {
    let up = recording.third_axis();
    let turned = |position: [f64; 3]| up.upright(recording.left_handed, position);
    for position in table.positions.iter_mut().flatten() {
        *position = position.map(turned);
    }
    let kinds = channels(sensors).map(|(sensor, parts)| (sensor.kind, parts.len()));
    let kinds: Vec<(SensorKind, usize)> = kinds.collect();
    for row in &mut table.readings {
        for (reading, &(kind, parts)) in row.iter_mut().zip(&kinds) {
            let change = |[a, b, c, d]: Reading| match (kind, parts) {
                (SensorKind::Pose, 4) => {
                    up.upright_attitude(recording.body_to_inertial([a, b, c, d]))
                }
                (SensorKind::Pose, _) => {
                    let [x, y, z] = turned([a, b, c].map(|part| recording.metres(part)));
                    [x, y, z, d]
                }
                (SensorKind::Instrument(instrument), _) => {
                    recording.instrument_reading(instrument, [a, b, c, d])
                }
                (SensorKind::Summary(_), _) => [a, b, c, d],
            };
            *reading = reading.map(change);
        }
    }
    table
}
