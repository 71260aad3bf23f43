//! Left-handed axes: the markers fit the template only as its mirror image. Markers in a plane are their own mirror
//! image, turned over; they do not decide.

use nalgebra::{Matrix3, Vector3};

use super::fault::{DataFault, FaultKind};
use crate::dataset::Flight;
use crate::pose::pose;
use crate::statistics::median;

/// Greatest number of samples that are compared.
const SAMPLES: usize = 20;
/// Least ratio of the thickness of a template to its size that decides.
const THICKNESS: f64 = 0.05;
/// Least ratio of squared distances from the template to those from its mirror image.
const RATIO: f64 = 10.0;
/// Least distance of the markers from the template, m.
const LEAST_DISTANCE: f64 = 0.003;

/// What to do about left-handed axes.
pub const MEND: &str = "change the sign of one horizontal axis (write -y for y)";

/// Whether the mirror image of the template differs from the template.
pub fn is_decided_by(markers: &[[f64; 3]]) -> bool {
    if markers.len() < 4 {
        return false;
    }
    let scatter = scatter(markers);
    let sizes = scatter.symmetric_eigenvalues();
    sizes.min().max(0.0).sqrt() > THICKNESS * sizes.max().sqrt()
}

/// Normal of the plane that the markers are nearest to, in body components.
pub fn normal(markers: &[[f64; 3]]) -> Vector3<f64> {
    let eigen = scatter(markers).symmetric_eigen();
    eigen.eigenvectors.column(eigen.eigenvalues.imin()).into()
}

/// Sum of squares and products of the markers' coordinates about their centre, m².
fn scatter(markers: &[[f64; 3]]) -> Matrix3<f64> {
    let each = || markers.iter().map(|marker| Vector3::from(*marker));
    let centre = each().sum::<Vector3<f64>>() / markers.len() as f64;
    each()
        .map(|marker| (marker - centre) * (marker - centre).transpose())
        .sum()
}

/// A flight whose markers fit the mirror image of the template.
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
    (plain > RATIO * mirror && plain.sqrt() > LEAST_DISTANCE).then(|| DataFault {
        file: flight.file.clone(),
        fault: FaultKind::Mirrored,
        detail: format!(
            "the markers fit the mirror image of the template ({:.1} mm) and not the template ({:.1} mm): the axes seem left-handed",
            1e3 * mirror.sqrt(),
            1e3 * plain.sqrt()
        ),
        mend: MEND.into(),
    })
}
