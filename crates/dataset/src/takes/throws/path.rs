//! Trajectory of one point of a body, and fits of a quadratic in time to parts of it.

use nalgebra::{Cholesky, Const, Matrix3, Vector3};

use super::track::Track;

/// Maximum height above the lowest level at which the body may touch the ground, m: its extent below its centre.
pub(super) const REACH: f64 = 0.15;
const APART: f64 = 0.5;
/// Number of lowest samples that are ignored as possible false (ghost) points when the lowest level is determined.
const BELOW: usize = 3;

pub(super) struct Path<'t> {
    pub track: &'t Track,
    pub points: Vec<Vector3<f64>>,
    pub lowest: f64,
    /// Whether that level is the ground, since the body comes down to it more than once.
    pub is_ground: bool,
}

impl<'t> Path<'t> {
    /// Trajectory of the point at `offset` from the centroid, in the body-fixed axes of the tracked points, m.
    pub fn new(track: &'t Track, offset: Vector3<f64>) -> Self {
        let centres = track.centres.iter().enumerate();
        let points = centres.map(|(i, centre)| centre + track.rotation(i) * offset);
        let points: Vec<Vector3<f64>> = points.collect();
        let mut heights: Vec<f64> = points.iter().map(|point| point.z).collect();
        let place = BELOW.min(heights.len() - 1);
        let lowest = *heights.select_nth_unstable_by(place, f64::total_cmp).1;
        let mut before = f64::NEG_INFINITY;
        let low = track.times.iter().zip(&points);
        let low = low.filter(|(_, point)| point.z < lowest + REACH);
        let visits =
            low.filter(|(time, _)| **time > std::mem::replace(&mut before, **time) + APART);
        let is_ground = visits.count() > 1;
        Self {
            track,
            points,
            lowest,
            is_ground,
        }
    }

    /// Fits a quadratic in (t − `t0`) / `scale` on each axis to samples. Returns the coefficients (m), one row per
    /// power and one column per axis, and the Cholesky factor; `None` for too few samples.
    pub fn quadratic(
        &self,
        samples: impl IntoIterator<Item = usize>,
        t0: f64,
        scale: f64,
    ) -> Option<(Matrix3<f64>, Cholesky<f64, Const<3>>)> {
        let mut normal = Matrix3::zeros();
        let mut right = Matrix3::zeros();
        for i in samples {
            let s = (self.track.times[i] - t0) / scale;
            let row = Vector3::new(1.0, s, s * s);
            normal += row * row.transpose();
            right += row * self.points[i].transpose();
        }
        let factor = normal.cholesky()?;
        Some((factor.solve(&right), factor))
    }
}
