//! Relations of what is observed: a mark on a body is shifted and turned as the body is.

use nalgebra::{Matrix3, Vector3};
use oracle::Point;

use crate::subject::Subject;

/// Difference between the observation at `seen` and that at `point`, turned and then shifted, relative to both; `None`
/// without an observation.
pub fn difference(
    subject: &Subject<'_>,
    (point, seen): (&Point<f64>, &Point<f64>),
    turn: &Matrix3<f64>,
    shift: &Vector3<f64>,
) -> Option<f64> {
    let expected: Vector3<f64> = turn * subject.equations.observation(point)? + shift;
    let found = subject.equations.observation(seen)?;
    Some(relative(&(found - expected), &[found, expected, *shift]))
}

/// Difference between the distance of two observed marks and their distance on the body, relative to both; `None` without
/// an observation of marks.
pub fn distance_difference(subject: &Subject<'_>, point: &Point<f64>) -> Option<f64> {
    subject.model.marker.as_ref()?;
    let apart = Vector3::new(0.3, -0.5, 0.4);
    let mut other = point.clone();
    other.marker += apart;
    let here = subject.equations.observation(point)?;
    let there = subject.equations.observation(&other)?;
    let difference = Vector3::x() * ((there - here).norm() - apart.norm());
    Some(relative(&difference, &[here, there, apart]))
}

fn relative(difference: &Vector3<f64>, of: &[Vector3<f64>]) -> f64 {
    let sizes = of.iter().map(Vector3::norm);
    difference.norm() / sizes.fold(0.0, f64::max)
}
