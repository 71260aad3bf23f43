//! Quantities of one flight after the fit: residual statistics, excitation ranges, and the evidence for figures.

use nalgebra::DVector;

use super::residual_cache::Path;
use crate::marker_observers::MarkerConditions;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::predict::states;
use crate::problem::FitProblem;
use crate::report::{FlightEvidence, ResidualPool};

/// Residual statistics and excitation ranges of one flight.
pub struct PostFit {
    /// Root mean square residual of one coordinate, m.
    pub rms: f64,
    /// Number of outliers.
    pub outliers: usize,
    /// Sums over the flight's residuals for the residual diagnostics.
    pub pool: ResidualPool,
    /// Least and greatest value of each of the model's quantities, followed by those of its states.
    pub ranges: Vec<(f64, f64)>,
}

/// Number of samples at which quantities are evaluated.
const EVALUATED_SAMPLES: usize = 12;

/// Empty range: (∞, −∞).
pub const EMPTY_RANGE: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);

/// Smallest range that contains both ranges.
pub fn joined(one: (f64, f64), other: (f64, f64)) -> (f64, f64) {
    (one.0.min(other.0), one.1.max(other.1))
}

/// Evaluates a flight on its trajectory.
pub fn post_fit(
    problem: &FitProblem,
    observations: &Observations,
    noise: &NoiseModel,
    global: &DVector<f64>,
    path: &Path,
) -> PostFit {
    let mut pool = ResidualPool::default();
    for (marker, series) in path.residuals.iter().enumerate() {
        let is_outlier =
            |sample: usize| observations.outlier[sample * observations.markers + marker];
        let inliers = series.iter().enumerate();
        let inliers: Vec<_> = inliers
            .map(|(sample, residual)| residual.filter(|_| !is_outlier(sample)))
            .collect();
        pool.add(&observations.times, &inliers, noise);
    }
    let conditions = problem.body.bind(observations.parameters(problem, global));
    let mut observer = conditions.observer();
    let layout = problem.body.layout();
    let mut ranges = vec![EMPTY_RANGE; layout.quantities.len() + layout.states.len()];
    let width = observations.manifold.states();
    let every = (observations.times.len() / EVALUATED_SAMPLES).max(1);
    for (sample, state) in path.states.chunks(width).enumerate().step_by(every) {
        let quantities = observer.quantities(observations.times[sample], state);
        let values = quantities.iter().chain(state);
        for (range, &value) in ranges.iter_mut().zip(values) {
            if value.is_finite() {
                *range = joined(*range, (value, value));
            }
        }
    }
    PostFit {
        rms: pool.rms(),
        outliers: observations.outliers(),
        pool,
        ranges,
    }
}

/// Measured and predicted values of a flight; `None` if its trajectory cannot be computed.
pub fn evidence(
    problem: &FitProblem,
    marker_names: &[String],
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
) -> Option<FlightEvidence> {
    let samples = observations.times.len();
    let trajectory = states(problem, observations, (global, local), samples).ok()?;
    let parameters = observations.parameters(problem, global);
    let conditions = MarkerConditions::new(&problem.body, &parameters, observations.markers);
    let mut observers = conditions.observers();
    let layout = problem.body.layout();
    let rows = |points: &[Option<[f64; 3]>]| points.to_vec();
    let mut evidence = FlightEvidence {
        file: observations.file.clone(),
        role: observations.role,
        markers: marker_names.to_vec(),
        times: observations.times.clone(),
        measured: observations
            .measured
            .chunks(observations.markers)
            .map(rows)
            .collect(),
        outlier: observations
            .outlier
            .chunks(observations.markers)
            .map(<[_]>::to_vec)
            .collect(),
        predicted: Vec::new(),
        state_names: layout.states.clone(),
        states: Vec::new(),
        quantity_names: layout.quantities.clone(),
        quantities: Vec::new(),
    };
    let states = trajectory.chunks(observations.manifold.states());
    for (&time, state) in observations.times.iter().zip(states) {
        let markers = problem.markers.iter().enumerate();
        let predicted = markers.map(|marker| observers.position(time, state, marker));
        evidence.predicted.push(predicted.collect());
        evidence.quantities.push(observers.quantities(time, state));
        evidence.states.push(state.to_vec());
    }
    Some(evidence)
}
