//! Conversion of a table to right-handed axes with z up, if the vertical is known.

use super::recording::Recording;
use super::sensor::{Reading, Sensor, SensorKind, channels};
use super::table::Table;

/// Converts the marker positions and poses of a flight's table to right-handed axes with z up; an unknown vertical
/// leaves the direction of z unchanged. Times and marker positions must already be in s and m; positions measured by
/// pose sensors are converted to m.
pub(super) fn upright(recording: &Recording, mut table: Table, sensors: &[Sensor]) -> Table {
    let up = recording.third_axis();
    let turned = |position: [f64; 3]| up.upright(recording.left_handed, position);
    for position in table.positions.iter_mut().flatten() {
        *position = position.map(turned);
    }
    let poses = channels(sensors);
    let poses = poses.map(|(sensor, parts)| (sensor.kind == SensorKind::Pose, parts.len()));
    let poses: Vec<(bool, usize)> = poses.collect();
    for row in &mut table.readings {
        for (reading, &(is_pose, parts)) in row.iter_mut().zip(&poses) {
            let change = |[a, b, c, d]: Reading| match (is_pose, parts) {
                (true, 4) => up.upright_attitude([a, b, c, d]),
                (true, _) => {
                    let [x, y, z] = turned([a, b, c].map(|part| recording.metres(part)));
                    [x, y, z, d]
                }
                (false, _) => [a, b, c, d],
            };
            *reading = reading.map(change);
        }
    }
    table
}
