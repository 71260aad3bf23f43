//! Fit of a quadratic in time to a part of a trajectory.

use nalgebra::{Cholesky, Const, Matrix3, Vector3};

use super::track::Track;

/// Fits a quadratic in (t − `t0`) / `scale` to the trajectory `path` (m) on each axis, over the samples with the given
/// indices in the track; `t0` and `scale` are in s. Returns the coefficients (m), one row per power 0, 1 and 2 and one
/// column per axis, and the Cholesky factor of the normal matrix; `None` if there are too few samples.
pub(super) fn quadratic(
    track: &Track,
    path: &[[f64; 3]],
    samples: impl IntoIterator<Item = usize>,
    t0: f64,
    scale: f64,
) -> Option<(Matrix3<f64>, Cholesky<f64, Const<3>>)> {
    let mut normal = Matrix3::zeros();
    let mut right = Matrix3::zeros();
    for i in samples {
        let s = (track.times[i] - t0) / scale;
        let row = Vector3::new(1.0, s, s * s);
        normal += row * row.transpose();
        right += row * Vector3::from(path[i]).transpose();
    }
    let factor = normal.cholesky()?;
    Some((factor.solve(&right), factor))
}
