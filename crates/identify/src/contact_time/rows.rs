//! Whitened residuals of a flight about its fitted trajectory, with their derivatives by the initial state.

use nalgebra::DVector;

use super::quadratic::Quadratic;
use super::trajectory::{Predicted, Trajectory};
use crate::noise::NoiseModel;
use crate::observations::Observations;

/// Residuals of one marker in one sample.
pub struct Point {
    /// Index of the marker.
    pub marker: usize,
    /// The sample before in which the marker is measured; `None` for the first.
    pub previous: Option<usize>,
    /// Residual of each coordinate.
    pub rows: [Row; 3],
}

/// Residual of one coordinate.
pub struct Row {
    /// Whitened residual, predicted − measured.
    pub residual: f64,
    /// Its derivatives by the initial state.
    pub derivatives: DVector<f64>,
    /// Its derivatives without what the sample before contributes.
    pub fresh: DVector<f64>,
}

impl Point {
    /// Squared residual after a change of the initial state.
    pub fn square(&self, change: &DVector<f64>) -> f64 {
        let each = self.rows.iter();
        each.map(|row| (row.residual + row.derivatives.dot(change)).powi(2))
            .sum()
    }

    /// Adds its squares to those of free motion.
    pub fn add_to(&self, sum: &mut Quadratic) {
        for row in &self.rows {
            sum.add(&row.derivatives, row.residual);
        }
    }
}

/// Residuals of the points that are no outliers, by sample.
pub fn whitened(
    observations: &Observations,
    trajectory: &Trajectory,
    noise: &NoiseModel,
) -> Vec<Vec<Point>> {
    let mut earlier: Vec<Option<(usize, &Predicted)>> = vec![None; observations.markers];
    let samples = (trajectory.first..).zip(&trajectory.samples);
    let each = samples.map(|(sample, markers)| {
        let mut points = Vec::with_capacity(markers.len());
        for (marker, predicted) in markers.iter().enumerate() {
            if observations.inlier(sample, marker).is_none() {
                continue;
            }
            let before = earlier[marker].replace((sample, predicted));
            let now = (sample, predicted);
            points.push(Point {
                marker,
                previous: before.map(|(sample, _)| sample),
                rows: [0, 1, 2].map(|axis| row(observations, (marker, axis), now, before, noise)),
            });
        }
        points
    });
    each.collect()
}

/// The row of a marker's coordinate in a sample, given the sample before in which it is measured.
fn row(
    observations: &Observations,
    (marker, axis): (usize, usize),
    now: (usize, &Predicted),
    before: Option<(usize, &Predicted)>,
    noise: &NoiseModel,
) -> Row {
    let residual = |(sample, predicted): (usize, &Predicted)| {
        let measured = observations.inlier(sample, marker);
        measured.map_or(0.0, |measured| predicted.position[axis] - measured[axis])
    };
    let derivatives = &now.1.derivatives[axis];
    let Some(before) = before else {
        let weight = noise.sigma[axis].recip();
        let derivatives = derivatives * weight;
        return Row {
            residual: residual(now) * weight,
            fresh: derivatives.clone(),
            derivatives,
        };
    };
    let gap = observations.times[now.0] - observations.times[before.0];
    let (kept, deviation) = noise.innovation(axis, gap);
    let fresh = derivatives / deviation;
    Row {
        residual: (residual(now) - kept * residual(before)) / deviation,
        derivatives: &fresh - &before.1.derivatives[axis] * (kept / deviation),
        fresh,
    }
}
