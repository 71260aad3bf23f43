//! Whitened residuals of a flight about its fitted trajectory, with derivatives with respect to the initial state.

use nalgebra::DVector;

use super::trajectory::{Predicted, Trajectory};
use crate::noise::NoiseModel;
use crate::observations::Observations;

/// Whitened residuals of the three coordinates of one marker in one sample.
pub struct Point {
    /// Index of the marker.
    pub marker: usize,
    /// Index of the preceding sample in which the marker is measured; `None` for the first one.
    pub previous: Option<usize>,
    /// Whitened residual of each coordinate of the marker, with its derivatives with respect to the initial state.
    pub rows: [Row; 3],
}

/// Whitened residual of one marker coordinate in one sample, with its derivatives.
pub struct Row {
    /// Whitened residual, predicted − measured, in standard deviations.
    pub residual: f64,
    /// Derivatives of the whitened residual with respect to the initial state of the flight.
    pub derivatives: DVector<f64>,
    /// Derivatives of the residual with respect to the initial state through the position in this sample only. The
    /// AR(1) contribution of the marker's preceding position, which whitening subtracts, is left out.
    pub fresh: DVector<f64>,
}

impl Point {
    /// Sum of the squared residuals of the three coordinates, if the initial state of the predicted trajectory changes
    /// by `change`. The residuals are linearised in `change`.
    pub fn square(&self, change: &DVector<f64>) -> f64 {
        let each = self.rows.iter();
        each.map(|row| (row.residual + row.derivatives.dot(change)).powi(2))
            .sum()
    }
}

/// Whitened residuals of all measured marker positions that are not outliers: one vector of marker positions for each
/// sample of `trajectory`.
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

/// Whitened residual of one coordinate of a marker in the sample `now`, with its derivatives. `before` is the preceding
/// sample in which the marker is measured; `None` if there is none. Both contain the index of the sample and the
/// predicted position.
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
