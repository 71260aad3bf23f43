//! Where a rigid body is and how it is turned, from its markers in one frame.
//!
//! W. Kabsch, "A solution for the best rotation to relate two sets of vectors", Acta Crystallographica A 32 (1976).

use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

/// A body as seen in one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Where its origin is, m.
    pub position: Vector3<f64>,
    /// How it is turned: body-fixed components become inertial ones.
    pub attitude: UnitQuaternion<f64>,
    /// Sum of the squared distances of the markers from where a rigid body would have them, m².
    pub squares: f64,
    /// Markers that were seen.
    pub seen: usize,
}

impl Pose {
    /// The squares over the degrees of freedom that are left, m².
    pub fn variance(&self) -> f64 {
        self.squares / (3.0 * self.seen as f64 - 6.0)
    }
}

/// Markers whose spread across their best line is less than this part of their spread along it are in line.
const IN_LINE: f64 = 0.02;

/// Whether markers fix the attitude of a body: three of them at least, and not in line.
pub fn fix_attitude(markers: &[[f64; 3]]) -> bool {
    let points: Vec<Vector3<f64>> = markers.iter().map(|&marker| marker.into()).collect();
    if points.len() < 3 {
        return false;
    }
    let centre = points.iter().sum::<Vector3<f64>>() / points.len() as f64;
    let scatter: Matrix3<f64> = points
        .iter()
        .map(|p| (p - centre) * (p - centre).transpose())
        .sum();
    let [along, across] = two_greatest(&scatter);
    along > 0.0 && across.max(0.0).sqrt() > IN_LINE * along.sqrt()
}

/// The two greatest eigenvalues of a symmetric matrix, by the cosines of a third of an angle: it is asked of every frame.
fn two_greatest(matrix: &Matrix3<f64>) -> [f64; 2] {
    let mean = matrix.trace() / 3.0;
    let rest = matrix - Matrix3::from_diagonal_element(mean);
    let size = (rest.norm_squared() / 6.0).sqrt();
    if size == 0.0 {
        return [mean; 2];
    }
    let cosine = (rest / size).determinant() / 2.0;
    let third = cosine.clamp(-1.0, 1.0).acos() / 3.0;
    let greatest = mean + 2.0 * size * third.cos();
    let least = mean + 2.0 * size * (third + std::f64::consts::TAU / 3.0).cos();
    [greatest, 3.0 * mean - greatest - least]
}

/// The pose that brings the markers nearest to where they were seen; none where what was seen does not fix it.
pub fn pose(markers: &[[f64; 3]], seen: &[Option<[f64; 3]>]) -> Option<Pose> {
    let pairs: Vec<(Vector3<f64>, Vector3<f64>)> = markers
        .iter()
        .zip(seen)
        .filter_map(|(&marker, seen)| seen.map(|seen| (marker.into(), seen.into())))
        .collect();
    let visible: Vec<[f64; 3]> = pairs.iter().map(|(marker, _)| (*marker).into()).collect();
    if !fix_attitude(&visible) {
        return None;
    }
    let count = pairs.len() as f64;
    let (body, space) = pairs.iter().fold(
        (Vector3::zeros(), Vector3::zeros()),
        |(body, space), (b, s)| (body + b / count, space + s / count),
    );
    let covariance: Matrix3<f64> = pairs
        .iter()
        .map(|(b, s)| (s - space) * (b - body).transpose())
        .sum();
    let svd = covariance.svd(true, true);
    let (u, v_t) = (svd.u?, svd.v_t?);
    // A rotation, never a reflection: the least certain direction is turned over where needed.
    let sign = (u.determinant() * v_t.determinant()).signum();
    let least = svd.singular_values.imin();
    let mut turn = Matrix3::identity();
    turn[(least, least)] = sign;
    let rotation = Rotation3::from_matrix_unchecked(u * turn * v_t);
    let position = space - rotation * body;
    let squares = pairs
        .iter()
        .map(|(b, s)| (position + rotation * b - s).norm_squared())
        .sum();
    Some(Pose {
        position,
        attitude: UnitQuaternion::from_rotation_matrix(&rotation),
        squares,
        seen: pairs.len(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const MARKERS: [[f64; 3]; 3] = [
        [0.1, 0.0, 0.01],
        [-0.05, 0.0866, 0.01],
        [-0.04, -0.08, 0.01],
    ];

    #[test]
    fn a_moved_body_is_found_again() {
        let attitude = UnitQuaternion::from_euler_angles(2.0, -0.7, 3.0);
        let position = Vector3::new(1.0, -2.0, 3.0);
        let seen = MARKERS.map(|m| Some((position + attitude * Vector3::from(m)).into()));
        let pose = pose(&MARKERS, &seen).unwrap();
        assert!((pose.position - position).norm() < 1e-12);
        assert!(pose.attitude.angle_to(&attitude) < 1e-7);
        assert!(pose.squares < 1e-24);
    }

    #[test]
    fn two_markers_or_three_in_line_fix_no_attitude() {
        let mut seen = MARKERS.map(Some);
        seen[1] = None;
        assert_eq!(pose(&MARKERS, &seen), None);
        assert!(!fix_attitude(&[
            [0.0; 3],
            [0.1, 0.0, 0.0],
            [0.2, 0.0, 0.001]
        ]));
    }
}
