//! Construction of the body frame, and the marker positions in it with their standard errors.

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

use super::centre::Centre;
use super::shape::Shape;
use super::{CentreHeight, EstimatedMarker, EstimatedTemplate};

/// Maximum standard error of the estimated height of the centre of mass, m, for the estimate to be used.
const WORST_HEIGHT: f64 = 0.01;
/// Minimum distance from the spin axis (third body axis), m, of the marker that the first body axis points to.
const OFF_AXIS: f64 = 0.005;
/// Parameters of the body frame beside the markers: point (3), direction (3), height of the centre (1).
const MORE: usize = 7;

/// Assembles the template (marker positions in the body frame) from the shape (marker positions relative to their mean)
/// and the centre of mass. If it is `None`, the estimated height is used if it is accurate enough, otherwise 0.
pub(super) fn template(
    labels: &[String],
    shape: &Shape,
    centre: &Centre,
    stated: Option<f64>,
) -> EstimatedTemplate {
    let shown = centre.height;
    let source = match (stated, shown) {
        (Some(height), shown) => CentreHeight::Stated { height, shown },
        (None, Some((height, std_error))) if std_error <= WORST_HEIGHT => {
            CentreHeight::Estimated { height, std_error }
        }
        (None, shown) => CentreHeight::Assumed {
            std_error: shown.map(|(_, std_error)| std_error),
        },
    };
    let (height, height_error) = match source {
        CentreHeight::Estimated { height, std_error } => (height, std_error),
        CentreHeight::Stated { height, .. } => (height, 0.0),
        CentreHeight::Assumed { .. } => (0.0, 0.0),
    };
    let size = 3 * shape.points.len();
    let mut values = DVector::<f64>::zeros(size + MORE);
    for (k, point) in shape.points.iter().enumerate() {
        values.rows_mut(3 * k, 3).copy_from(point);
    }
    values.rows_mut(size, 3).copy_from(&centre.foot);
    values.rows_mut(size + 3, 3).copy_from(&centre.axis);
    values[size + 6] = height;
    let mut covariance = DMatrix::<f64>::zeros(size + MORE, size + MORE);
    covariance
        .view_mut((0, 0), (size, size))
        .copy_from(&shape.covariance);
    covariance
        .view_mut((size, size), (3, 3))
        .copy_from(&centre.foot_covariance);
    covariance
        .view_mut((size + 3, size + 3), (3, 3))
        .copy_from(&centre.axis_covariance);
    covariance[(size + 6, size + 6)] = height_error * height_error;

    let first = first_marker(shape, centre, height);
    let map = |values: &DVector<f64>| placed(values, size, centre, first);
    let positions = map(&values);
    let mut jacobian = DMatrix::<f64>::zeros(size, size + MORE);
    for column in 0..size + MORE {
        // The map is smooth at the scale of the body, which is about 0.1 m.
        let step = 1e-6;
        let (mut more, mut less) = (values.clone(), values.clone());
        more[column] += step;
        less[column] -= step;
        jacobian.set_column(column, &((map(&more) - map(&less)) / (2.0 * step)));
    }
    let covariance = &jacobian * covariance * jacobian.transpose();
    let markers = labels.iter().enumerate().map(|(k, label)| EstimatedMarker {
        label: label.clone(),
        position: [0, 1, 2].map(|axis| positions[3 * k + axis]),
        std_error: [0, 1, 2].map(|axis| covariance[(3 * k + axis, 3 * k + axis)].max(0.0).sqrt()),
    });
    EstimatedTemplate {
        markers: markers.collect(),
        sigma: shape.sigma,
        height: source,
        tilt_error: greatest(&centre.axis_covariance),
        up: centre.up,
        first,
        flights: shape.poses.iter().filter(|poses| !poses.is_empty()).count(),
        samples: shape.poses.iter().map(Vec::len).sum(),
        outliers: shape.outliers,
        turns: centre.turns,
    }
}

/// Square root of the greatest eigenvalue of a covariance matrix: the greatest standard deviation in any direction.
fn greatest(covariance: &Matrix3<f64>) -> f64 {
    covariance.symmetric_eigenvalues().max().max(0.0).sqrt()
}

/// Marker that the first body axis points to: the first farther than [`OFF_AXIS`] from the spin axis, or the farthest.
fn first_marker(shape: &Shape, centre: &Centre, height: f64) -> usize {
    let foot = centre.foot + centre.slope * height;
    let distance = |point: &Vector3<f64>| {
        let arm = point - foot;
        (arm - centre.axis * arm.dot(&centre.axis)).norm()
    };
    let off = shape.points.iter().position(|p| distance(p) > OFF_AXIS);
    let farthest = || {
        let each = shape.points.iter().enumerate();
        let most = each.max_by(|a, b| distance(a.1).total_cmp(&distance(b.1)));
        most.map_or(0, |(k, _)| k)
    };
    off.unwrap_or_else(farthest)
}

/// Marker positions, m, in the body frame whose first axis points to the marker `first`. `values` has `size` marker
/// coordinates, then the point of the spin axis at the mean height of the markers, its direction, and the height of the
/// centre of mass. Of `centre`, only `slope` is used.
fn placed(values: &DVector<f64>, size: usize, centre: &Centre, first: usize) -> DVector<f64> {
    let vector = |at: usize| Vector3::new(values[at], values[at + 1], values[at + 2]);
    let third = vector(size + 3).normalize();
    let height = values[size + 6];
    let origin = vector(size) + centre.slope * height + third * height;
    let towards = vector(3 * first) - origin;
    let one = (towards - third * towards.dot(&third)).normalize();
    let two = third.cross(&one);
    let mut positions = DVector::zeros(size);
    for k in 0..size / 3 {
        let arm = vector(3 * k) - origin;
        let own = Vector3::new(arm.dot(&one), arm.dot(&two), arm.dot(&third));
        positions.rows_mut(3 * k, 3).copy_from(&own);
    }
    positions
}
