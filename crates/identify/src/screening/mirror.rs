//! Left-handed axes: the markers match the mirror image of the template but not the template. Markers in a plane
//! cannot be judged, because turning them over gives their mirror image.

use nalgebra::{Matrix3, Vector3};

use crate::data_fault::{DataFault, FaultKind};
use dataset::Flight;
use dataset::pose::pose;
use dataset::statistics::median;

/// Maximum number of samples of a flight in which the measured markers are compared with their declared positions and
/// with the mirror image of these positions.
const SAMPLES: usize = 20;
/// Minimum ratio of the smallest to the largest principal extent (root mean square about the centroid) of a set of
/// marker positions at which the set can be distinguished from its mirror image.
const THICKNESS: f64 = 0.05;
/// Limit for reporting a flight as mirrored: minimum ratio of the mean squared distance of the measured markers from
/// the fitted template to that from the fitted mirror image of the template.
const RATIO: f64 = 10.0;
/// Minimum root mean square distance of the measured markers from their declared positions in the best-fitting pose, m,
/// at which a flight is reported as mirrored.
const MIN_DISTANCE: f64 = 0.003;

/// Instruction for correcting left-handed axes, for the user.
pub const MEND: &str = "change the sign of one horizontal axis (write -y for y)";

/// Whether the mirror image of the template can be distinguished from the template, which requires four markers not in
/// a plane.
pub fn is_decided_by(markers: &[[f64; 3]]) -> bool {
    if markers.len() < 4 {
        return false;
    }
    let scatter = scatter(markers);
    let sizes = scatter.symmetric_eigenvalues();
    sizes.min().max(0.0).sqrt() > THICKNESS * sizes.max().sqrt()
}

/// Unit normal of the best-fitting plane of the markers, in body components. Its sign is arbitrary, but the same for
/// the same marker positions.
pub fn normal(markers: &[[f64; 3]]) -> Vector3<f64> {
    let eigen = scatter(markers).symmetric_eigen();
    eigen.eigenvectors.column(eigen.eigenvalues.imin()).into()
}

/// Scatter matrix of the marker positions: the sums, over the markers, of squares and products of the coordinates
/// relative to the centroid, m².
fn scatter(markers: &[[f64; 3]]) -> Matrix3<f64> {
    let each = || markers.iter().map(|marker| Vector3::from(*marker));
    let centre = each().sum::<Vector3<f64>>() / markers.len() as f64;
    each()
        .map(|marker| (marker - centre) * (marker - centre).transpose())
        .sum()
}

/// Data fault of a flight whose measured markers fit the mirror image of the declared marker positions, `markers`, much
/// better than the declared positions; otherwise `None`.
pub fn check(markers: &[[f64; 3]], flight: &Flight) -> Option<DataFault> {
    let mirrored: Vec<[f64; 3]> = markers.iter().map(|&[x, y, z]| [-x, y, z]).collect();
    let complete = flight
        .positions
        .iter()
        .filter(|row| row.iter().flatten().count() >= 4);
    let rows: Vec<_> = complete.collect();
    let step = rows.len().div_ceil(SAMPLES).max(1);
    let (mut plain, mut mirror) = (Vec::new(), Vec::new());
    for row in rows.into_iter().step_by(step) {
        let (Some(one), Some(other)) = (pose(markers, row), pose(&mirrored, row)) else {
            continue;
        };
        plain.push(one.variance());
        mirror.push(other.variance());
    }
    let (plain, mirror) = (median(&mut plain), median(&mut mirror));
    (plain > RATIO * mirror && plain.sqrt() > MIN_DISTANCE).then(|| DataFault::new(flight, FaultKind::Mirrored, format!(
            "the markers fit the mirror image of the template ({:.1} mm) and not the template ({:.1} mm): the axes seem left-handed",
            1e3 * mirror.sqrt(),
            1e3 * plain.sqrt()
        ), MEND))
}
