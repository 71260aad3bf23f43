//! Helpers to construct motions of a disc before its release and after its catch.

use dataset::Flight;
use nalgebra::Vector3;

/// Positions of all markers in one sample, m; `None` for a marker that is not seen.
pub(super) type Row = Vec<Option<[f64; 3]>>;

/// Mean position of the visible markers in one sample, m; the origin if none is visible.
pub(super) fn centre(row: &Row) -> Vector3<f64> {
    let seen: Vec<Vector3<f64>> = row.iter().flatten().map(|p| Vector3::from(*p)).collect();
    seen.iter().sum::<Vector3<f64>>() / seen.len().max(1) as f64
}

/// Mean velocity of the markers' centre from sample `from` to `to`, m/s.
pub(super) fn velocity(flight: &Flight, from: usize, to: usize) -> Vector3<f64> {
    let path = centre(&flight.positions[to]) - centre(&flight.positions[from]);
    path / (flight.times[to] - flight.times[from])
}

/// Returns the marker positions of one sample, translated by a vector (m).
pub(super) fn moved(row: &Row, by: Vector3<f64>) -> Row {
    let each = row
        .iter()
        .map(|point| point.map(|p| (Vector3::from(p) + by).into()));
    each.collect()
}

/// Returns the marker positions of one sample, rotated by an angle (rad) about the vertical through their mean.
pub(super) fn turned(row: &Row, angle: f64) -> Row {
    let middle = centre(row);
    let turn = nalgebra::Rotation3::from_axis_angle(&Vector3::z_axis(), angle);
    let each = row
        .iter()
        .map(|point| point.map(|p| (middle + turn * (Vector3::from(p) - middle)).into()));
    each.collect()
}
