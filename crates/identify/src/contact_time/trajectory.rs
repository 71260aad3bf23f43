//! Fitted trajectory of a flight at its samples, with derivatives with respect to the initial state.

use std::ops::Range;

use nalgebra::{DVector, Matrix3xX};

use crate::error::FlightError;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::predict::FlightAt;
use crate::problem::FitProblem;
use crate::state_manifold::StateManifold;

/// Predicted marker positions of a flight, with derivatives with respect to the initial state.
pub struct Trajectory {
    /// Number of directions in which the initial state may vary.
    pub dimension: usize,
    pub first: usize,
    pub samples: Vec<Vec<Predicted>>,
}

/// Predicted position of one marker at one time.
#[derive(Clone, Debug)]
pub struct Predicted {
    pub position: [f64; 3],
    pub derivatives: [DVector<f64>; 3],
}

impl Trajectory {
    /// Computes the trajectory at the samples `seen`. `unknowns` are the global parameters and the initial state.
    pub fn new(
        problem: &FitProblem,
        observations: &Observations,
        unknowns: (&DVector<f64>, &DVector<f64>),
        seen: Range<usize>,
    ) -> Result<Self, FlightError> {
        let manifold = StateManifold::new(&problem.model, &[]);
        let manifold = manifold.held_by(&problem.body, &observations.parameters);
        let (dimension, markers) = (manifold.dimension(), observations.markers);
        let evaluated = Observations {
            measured: vec![Some([0.0; 3]); seen.end * markers],
            manifold,
            known_states: Vec::new(),
            ..observations.first_samples(seen.end)
        };
        let mut samples = vec![Vec::with_capacity(markers); seen.len()];
        FlightAt::new(problem, &evaluated, unknowns).each_residual(&[], &mut |point| {
            if point.sample >= seen.start {
                let rows = point.rows.each_ref();
                samples[point.sample - seen.start].push(Predicted {
                    position: point.residual,
                    derivatives: rows.map(|row| DVector::from_column_slice(row)),
                });
            }
        })?;
        Ok(Self {
            dimension,
            first: seen.start,
            samples,
        })
    }

    pub fn markers(&self, sample: usize) -> &[Predicted] {
        &self.samples[sample - self.first]
    }

    /// Derivatives of the mean predicted marker position with respect to the initial state, one row per coordinate.
    pub fn centre(&self, sample: usize) -> Matrix3xX<f64> {
        let markers = self.markers(sample);
        Matrix3xX::from_fn(self.dimension, |axis, column| {
            let each = markers
                .iter()
                .map(|marker| marker.derivatives[axis][column]);
            each.sum::<f64>() / markers.len() as f64
        })
    }
}

// Whitened residuals of a flight about its fitted trajectory, with derivatives with respect to the initial state.

/// Whitened residuals of the three coordinates of one marker in one sample.
pub struct Point {
    pub marker: usize,
    /// Index of the preceding sample in which the marker is measured; `None` for the first one.
    pub previous: Option<usize>,
    pub rows: [Row; 3],
}

/// Whitened residual of one marker coordinate in one sample, with its derivatives.
pub struct Row {
    /// Whitened residual, predicted − measured, in standard deviations.
    pub residual: f64,
    pub derivatives: DVector<f64>,
    /// Derivatives without the part of the marker's preceding position, which whitening subtracts.
    pub fresh: DVector<f64>,
}

impl Point {
    /// Sum of the squared residuals if the initial state changes by `change`.
    pub fn square(&self, change: &DVector<f64>) -> f64 {
        let each = self.rows.iter();
        each.map(|row| (row.residual + row.derivatives.dot(change)).powi(2))
            .sum()
    }
}

/// Whitened residuals of all measured marker positions that are not outliers, by sample of `trajectory`.
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

/// Whitened residual of one coordinate of a marker in the sample `now`; `before` is the preceding sample in which it is
/// measured. Both contain the index of the sample and the predicted position.
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
    let times = &observations.times;
    let gap = before.map(|(sample, _)| times[now.0] - times[sample]);
    let (kept, deviation) = noise.of(marker).innovation(axis, gap);
    let fresh = &now.1.derivatives[axis] / deviation;
    let mut derivatives = fresh.clone();
    if let Some((_, predicted)) = before {
        derivatives.axpy(-kept / deviation, &predicted.derivatives[axis], 1.0);
    }
    Row {
        residual: (residual(now) - kept * before.map_or(0.0, residual)) / deviation,
        derivatives,
        fresh,
    }
}
