//! Position and attitude of a rigid body from the measured positions of its markers in one sample.
//!
//! B. K. P. Horn, "Closed-form solution of absolute orientation using unit quaternions", Journal of the Optical Society
//! of America A 4 (1987). The largest eigenvalue is computed by D. L. Theobald, Acta Crystallographica A 61 (2005).

use nalgebra::{Matrix3, Matrix4, Quaternion, UnitQuaternion, Vector3};

/// Least-squares position and attitude of a rigid body in one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Position of the body's origin in the inertial frame, m.
    pub position: Vector3<f64>,
    /// Attitude: rotation from body components to inertial components.
    pub attitude: UnitQuaternion<f64>,
    /// Sum of squared distances between measured and fitted marker positions, m².
    pub squares: f64,
    /// Number of measured markers in the sample.
    pub markers: usize,
}

impl Pose {
    /// Residual variance of a marker coordinate, m²: sum of the squared distances by the degrees of freedom.
    pub fn variance(&self) -> f64 {
        self.squares / (3.0 * self.markers as f64 - 6.0)
    }
}

/// Rigid-body motion at one instant, in inertial components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidMotion {
    /// Position of the body's origin in the inertial frame, m.
    pub position: Vector3<f64>,
    /// Velocity of the body's origin in inertial components, m/s.
    pub velocity: Vector3<f64>,
    /// Attitude: rotation from body components to inertial components; `None` for a point mass.
    pub attitude: Option<UnitQuaternion<f64>>,
    /// Angular velocity in inertial components, rad/s; `None` for a point mass.
    pub rates: Option<Vector3<f64>>,
}

impl RigidMotion {
    /// The motion with `turns` more turns per interval about its axis; `whole` is the rate of one, rad/s.
    pub fn with_turns(&self, turns: i32, whole: f64) -> RigidMotion {
        let rates = self.rates.map(|rates| {
            let axis = rates.try_normalize(1e-9).unwrap_or_else(Vector3::z);
            if turns == 0 {
                rates
            } else {
                rates + axis * (f64::from(turns) * whole)
            }
        });
        RigidMotion { rates, ..*self }
    }
}

/// Ratio of the markers' spread normal to the best-fit line to their total spread, below which they are collinear.
const COLLINEAR: f64 = 0.005;

/// Whether the markers determine the attitude of a body: there are at least three, and they are not collinear.
pub fn fix_attitude(markers: &[[f64; 3]]) -> bool {
    are_not_collinear(markers.iter().map(|&marker| marker.into()))
}

fn are_not_collinear(points: impl Iterator<Item = Vector3<f64>> + Clone) -> bool {
    let count = points.clone().count();
    if count < 3 {
        return false;
    }
    let centre = points.clone().sum::<Vector3<f64>>() / count as f64;
    let scatter: Matrix3<f64> = points
        .map(|p| (p - centre) * (p - centre).transpose())
        .sum();
    // Sum and second symmetric function of the eigenvalues: for collinear points only one of them differs from 0.
    let sum = scatter.trace();
    let product = (sum * sum - scatter.norm_squared()) / 2.0;
    sum > 0.0 && product > (COLLINEAR * sum).powi(2)
}

/// Least-squares pose from the body coordinates `markers` and the measured positions `seen`, m; `None` if collinear.
#[inline] // compiled at the optimisation level of the caller
pub fn pose(markers: &[[f64; 3]], seen: &[Option<[f64; 3]>]) -> Option<Pose> {
    let pairs = markers.iter().zip(seen).filter_map(|(&marker, &seen)| {
        let pair: (Vector3<f64>, Vector3<f64>) = (marker.into(), seen?.into());
        Some(pair)
    });
    if !are_not_collinear(pairs.clone().map(|(marker, _)| marker)) {
        return None;
    }
    let (position, attitude) = rigid_motion(pairs.clone())?;
    let markers = pairs.clone().count();
    let squares = pairs
        .map(|(b, s)| (position + attitude * b - s).norm_squared())
        .sum();
    Some(Pose {
        position,
        attitude,
        squares,
        markers,
    })
}

/// Translation and rotation that map the first points of `pairs` to the second ones, by least squares.
#[inline] // as `pose`
pub(crate) fn rigid_motion(
    pairs: impl Iterator<Item = (Vector3<f64>, Vector3<f64>)> + Clone,
) -> Option<(Vector3<f64>, UnitQuaternion<f64>)> {
    let count = pairs.clone().count() as f64;
    let (body, space) = pairs.clone().fold(
        (Vector3::zeros(), Vector3::zeros()),
        |(body, space), (b, s)| (body + b / count, space + s / count),
    );
    let about = pairs.map(|(b, s)| (b - body, s - space));
    let covariance = about.clone().map(|(b, s)| s * b.transpose()).sum();
    let spread = about.map(|(b, s)| b.norm_squared() + s.norm_squared());
    let attitude = nearest_rotation(&covariance, spread.sum::<f64>() / 2.0)?;
    Some((space - attitude * body, attitude))
}

/// Euclidean distance between two points, in the unit of their coordinates.
pub fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b).powi(2));
    squares.sum::<f64>().sqrt()
}

/// Position of a point mass in the inertial frame, m: mean of (measured position − offset); `None` without a marker.
pub fn point_position(markers: &[[f64; 3]], measured: &[Option<[f64; 3]>]) -> Option<Vector3<f64>> {
    let pairs = measured.iter().zip(markers);
    let origins = pairs.filter_map(|(measured, marker)| {
        Some(Vector3::from((*measured)?) - Vector3::from(*marker))
    });
    let (sum, count) = origins.fold((Vector3::zeros(), 0_usize), |(sum, count), origin| {
        (sum + origin, count + 1)
    });
    (count > 0).then(|| sum / count as f64)
}

/// Maximum number of Newton steps for the largest eigenvalue of Horn's 4 × 4 matrix, whose eigenvector is the attitude.
const MAX_STEPS: usize = 100;

/// Least-squares rotation that maps vectors b to s, from `c` = Σ s bᵀ; `None` for collinear vectors. Newton's method
/// starts at `bound`, half the sum of the squared lengths, which is above the largest eigenvalue of Horn's matrix.
#[inline] // as `pose`
pub fn nearest_rotation(c: &Matrix3<f64>, bound: f64) -> Option<UnitQuaternion<f64>> {
    #[rustfmt::skip]
    let key = Matrix4::new(
        c[(0, 0)] + c[(1, 1)] + c[(2, 2)], c[(2, 1)] - c[(1, 2)], c[(0, 2)] - c[(2, 0)], c[(1, 0)] - c[(0, 1)],
        c[(2, 1)] - c[(1, 2)], c[(0, 0)] - c[(1, 1)] - c[(2, 2)], c[(1, 0)] + c[(0, 1)], c[(0, 2)] + c[(2, 0)],
        c[(0, 2)] - c[(2, 0)], c[(1, 0)] + c[(0, 1)], c[(1, 1)] - c[(0, 0)] - c[(2, 2)], c[(2, 1)] + c[(1, 2)],
        c[(1, 0)] - c[(0, 1)], c[(0, 2)] + c[(2, 0)], c[(2, 1)] + c[(1, 2)], c[(2, 2)] - c[(0, 0)] - c[(1, 1)],
    );
    // The largest root of the characteristic polynomial by Newton's method, from above.
    let (two, one) = (-2.0 * c.norm_squared(), -8.0 * c.determinant());
    let none = key.determinant();
    let mut greatest = bound;
    for _ in 0..MAX_STEPS {
        let value = ((greatest * greatest + two) * greatest + one) * greatest + none;
        let slope = (4.0 * greatest * greatest + 2.0 * two) * greatest + one;
        let next = greatest - value / slope;
        if next.is_nan() || next >= greatest {
            break;
        }
        greatest = next;
    }
    // Each column of the adjugate is the eigenvector times one of its components; the column with the largest one is
    // the most accurate.
    let rest = key - Matrix4::from_diagonal_element(greatest);
    let cofactor = |row: usize, column: usize| {
        let sign = if (row + column).is_multiple_of(2) {
            1.0
        } else {
            -1.0
        };
        sign * rest.remove_row(row).remove_column(column).determinant()
    };
    let sizes = [0, 1, 2, 3].map(|place| cofactor(place, place).abs());
    let most = (0..4).max_by(|&a, &b| sizes[a].total_cmp(&sizes[b]))?;
    let [w, i, j, k] = [0, 1, 2, 3].map(|row| cofactor(row, most));
    UnitQuaternion::try_new(Quaternion::new(w, i, j, k), f64::MIN_POSITIVE)
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

    /// Markers of a body that is much longer than wide.
    const SLENDER: [[f64; 3]; 3] = [[0.3, 0.0, 0.0], [-0.3, 0.0, 0.0], [0.0, 0.03, 0.0]];

    #[test]
    fn no_other_pose_is_nearer() {
        for markers in [MARKERS, SLENDER] {
            for turn in 0..12 {
                let attitude = UnitQuaternion::from_euler_angles(0.5 * f64::from(turn), -0.7, 3.0);
                let mut seen = markers.map(|m| Some((attitude * Vector3::from(m)).into()));
                for (k, seen) in seen.iter_mut().flatten().enumerate() {
                    let seen: &mut [f64; 3] = seen;
                    seen[k] += 0.004;
                    seen[(k + turn as usize) % 3] -= 0.007;
                }
                is_nearest(&markers, &seen);
            }
        }
    }

    #[track_caller]
    fn is_nearest(markers: &[[f64; 3]; 3], seen: &[Option<[f64; 3]>; 3]) {
        let pose = pose(markers, seen).unwrap();
        let squares = |attitude: UnitQuaternion<f64>, position: Vector3<f64>| -> f64 {
            let pairs = markers.iter().zip(seen.iter().flatten());
            let gap = |(m, s): (&[f64; 3], &[f64; 3])| {
                (position + attitude * Vector3::from(*m) - Vector3::from(*s)).norm_squared()
            };
            pairs.map(gap).sum()
        };
        assert!((squares(pose.attitude, pose.position) - pose.squares).abs() < 1e-15);
        for axis in 0..6 {
            for size in [-1e-4, 1e-4] {
                let mut step = [0.0; 6];
                step[axis] = size;
                let turned = UnitQuaternion::new(Vector3::from_column_slice(&step[..3]));
                let plus = pose.position + Vector3::from_column_slice(&step[3..]);
                assert!(squares(turned * pose.attitude, plus) > pose.squares);
            }
        }
    }

    #[test]
    fn each_marker_of_a_point_mass_counts_with_its_own_offset() {
        let origin = Vector3::new(1.0, -2.0, 3.0);
        let at = |k: usize| Some((origin + Vector3::from(MARKERS[k])).into());
        for seen in [
            [at(0), at(1), at(2)],
            [None, at(1), None],
            [None, at(1), at(2)],
        ] {
            let position = point_position(&MARKERS, &seen).unwrap();
            assert!((position - origin).norm() < 1e-12);
        }
        assert_eq!(point_position(&MARKERS, &[None; 3]), None);
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
