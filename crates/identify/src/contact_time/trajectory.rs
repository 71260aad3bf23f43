//! Fitted trajectory of a flight at and between samples, with derivatives with respect to the initial state.

use std::ops::Range;

use nalgebra::{DVector, Matrix3xX};

use crate::error::FlightError;
use crate::observations::Observations;
use crate::predict::each_residual;
use crate::problem::FitProblem;
use crate::state_manifold::StateManifold;

/// Trial times of a velocity jump between two successive samples, as fractions of the interval from the earlier to the
/// later sample.
const PARTS: [f64; 4] = [0.125, 0.375, 0.625, 0.875];

/// Predicted marker positions of a flight, with derivatives with respect to the initial state.
pub struct Trajectory {
    /// Number of independent directions in which the initial state may vary (see [`StateManifold`]); smaller than the
    /// number of its components if it contains a quaternion.
    pub dimension: usize,
    /// Index of the first sample at which the trajectory is evaluated.
    pub first: usize,
    /// Index of the first sample for which a velocity jump in the preceding interval is tried.
    pub tried: usize,
    /// Predicted markers at each sample from `first` on, indexed by the sample counted from `first`, and the marker.
    pub samples: Vec<Vec<Predicted>>,
    /// Predicted markers between samples: at the fractions `PARTS` of the interval before each sample from `tried` on,
    /// indexed by the sample counted from `tried`, the fraction, and the marker.
    pub contacts: Vec<Vec<Vec<Predicted>>>,
}

/// A part of a [`Trajectory`] in which a contact is searched. The fields have the meaning of those of the trajectory.
#[derive(Clone, Copy)]
pub struct Part<'t> {
    pub dimension: usize,
    pub first: usize,
    pub tried: usize,
    pub samples: &'t [Vec<Predicted>],
    pub contacts: &'t [Vec<Vec<Predicted>>],
}

/// Predicted position of one marker at one time.
#[derive(Clone, Debug)]
pub struct Predicted {
    /// Predicted position in the inertial frame, m.
    pub position: [f64; 3],
    /// Derivatives of each coordinate of `position` with respect to the initial state, one entry for each direction in
    /// which the state may vary (see [`StateManifold`]).
    pub derivatives: [DVector<f64>; 3],
}

/// A time at which the predicted trajectory is evaluated: its initial time, the time of a sample, or a time between two
/// samples.
#[derive(Clone, Copy)]
enum EvaluationTime {
    Start,
    Sample,
    /// A time between two samples at which a velocity jump is tried; contains the index of the later sample, counted
    /// from the first sample before which a jump is tried.
    Before(usize),
}

impl Trajectory {
    /// Part of the trajectory at the samples `seen`, in which velocity jumps are tried before the samples from `tried` on.
    /// The trajectory must contain these samples and times.
    pub fn part(&self, seen: Range<usize>, tried: usize) -> Part<'_> {
        Part {
            dimension: self.dimension,
            first: seen.start,
            tried,
            samples: &self.samples[seen.start - self.first..seen.end - self.first],
            contacts: &self.contacts[tried - self.tried..seen.end - self.tried],
        }
    }

    /// Computes the trajectory at the samples `seen`, and, for each of these samples from `tried` on, at the fractions
    /// `PARTS` of the interval before the sample. `unknowns` are the global parameters and the initial state.
    ///
    /// # Errors
    /// [`FlightError::Integration`] if the trajectory cannot be computed.
    pub fn new(
        problem: &FitProblem,
        observations: &Observations,
        unknowns: (&DVector<f64>, &DVector<f64>),
        seen: Range<usize>,
        tried: usize,
    ) -> Result<Self, FlightError> {
        let times = &observations.times;
        let mut evaluations = Vec::new();
        if seen.start > 0 {
            evaluations.push((EvaluationTime::Start, times[0]));
        }
        for sample in seen.clone() {
            if sample >= tried.max(1) {
                let (before, time) = (times[sample - 1], times[sample]);
                let at = PARTS.map(|part| before + part * (time - before));
                evaluations.extend(at.map(|time| (EvaluationTime::Before(sample - tried), time)));
            }
            evaluations.push((EvaluationTime::Sample, times[sample]));
        }
        let manifold = StateManifold::new(&problem.model, &[]);
        let (dimension, markers) = (manifold.dimension(), observations.markers);
        let points = evaluations.len() * markers;
        let evaluated = Observations {
            times: evaluations.iter().map(|(_, time)| *time).collect(),
            measured: vec![Some([0.0; 3]); points],
            outlier: vec![false; points],
            stand_ins: Vec::new(),
            manifold,
            file: String::new(),
            parameters: observations.parameters.clone(),
            known_states: Vec::new(),
            truncation: None,
            notes: Vec::new(),
            ..*observations
        };
        let conditions = problem.body.bind(evaluated.parameters(problem, unknowns.0));
        let mut motion = conditions.differentiable_rhs();
        let mut trajectory = Self {
            dimension,
            first: seen.start,
            tried,
            samples: Vec::with_capacity(seen.len()),
            contacts: vec![Vec::new(); seen.end.saturating_sub(tried)],
        };
        let mut all = Vec::with_capacity(markers);
        each_residual(
            problem,
            &evaluated,
            unknowns,
            &mut motion,
            &[],
            &mut |point| {
                all.push(Predicted {
                    position: point.residual,
                    derivatives: point
                        .rows
                        .each_ref()
                        .map(|row| DVector::from_column_slice(row)),
                });
                if all.len() < markers {
                    return;
                }
                let all = std::mem::take(&mut all);
                match evaluations[point.sample].0 {
                    EvaluationTime::Start => {}
                    EvaluationTime::Before(index) => trajectory.contacts[index].push(all),
                    EvaluationTime::Sample => trajectory.samples.push(all),
                }
            },
        )?;
        Ok(trajectory)
    }
}

impl Part<'_> {
    /// Derivatives of the mean predicted position of the markers in a sample with respect to the initial state of the
    /// flight: one row per coordinate.
    pub fn centre(&self, sample: usize) -> Matrix3xX<f64> {
        let markers = &self.samples[sample - self.first];
        Matrix3xX::from_fn(self.dimension, |axis, column| {
            let each = markers
                .iter()
                .map(|marker| marker.derivatives[axis][column]);
            each.sum::<f64>() / markers.len() as f64
        })
    }
}
