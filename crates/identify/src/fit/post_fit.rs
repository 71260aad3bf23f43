//! One flight once it is fitted: its residuals, where it went, and what figures are drawn from.

use nalgebra::DVector;

use super::residual_cache::Path;
use crate::marker_observers::MarkerConditions;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::predict::states;
use crate::problem::FitProblem;
use crate::report::{FlightEvidence, residuals::ResidualPool};

/// What one flight shows.
pub struct PostFit {
    /// Root mean square of its residuals, m.
    pub rms: f64,
    /// Points that were left out of it.
    pub outliers: usize,
    /// Its residuals.
    pub pool: ResidualPool,
    /// The least and the greatest of each of the model's quantities, and then of its states.
    pub support: Vec<(f64, f64)>,
}

/// Samples of which the quantities are looked at, in each flight.
const LOOKS: usize = 12;

/// The range of no values.
pub const NOTHING: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);

/// The range over two.
pub fn joined(one: (f64, f64), other: (f64, f64)) -> (f64, f64) {
    (one.0.min(other.0), one.1.max(other.1))
}

/// Looks at a flight by its states, sample after sample.
pub fn post_fit(
    problem: &FitProblem,
    observations: &Observations,
    noise: &NoiseModel,
    global: &DVector<f64>,
    path: &Path,
) -> PostFit {
    let mut pool = ResidualPool::default();
    for (marker, series) in path.residuals.iter().enumerate() {
        let outlier = |sample: usize| observations.outlier[sample * observations.markers + marker];
        let good = series.iter().enumerate();
        let good: Vec<_> = good
            .map(|(sample, r)| r.filter(|_| !outlier(sample)))
            .collect();
        pool.add(&observations.times, &good, noise);
    }
    let conditions = problem.body.bind(observations.parameters(problem, global));
    let mut observer = conditions.observer();
    let layout = problem.body.layout();
    let mut support = vec![NOTHING; layout.quantities.len() + layout.states.len()];
    let width = observations.manifold.states();
    let every = (observations.times.len() / LOOKS).max(1);
    for (sample, state) in path.states.chunks(width).enumerate().step_by(every) {
        let quantities = observer.quantities(observations.times[sample], state);
        let values = quantities.iter().chain(state);
        for (range, &value) in support.iter_mut().zip(values) {
            if value.is_finite() {
                *range = joined(*range, (value, value));
            }
        }
    }
    PostFit {
        rms: pool.rms(),
        outliers: observations
            .outlier
            .iter()
            .filter(|outlier| **outlier)
            .count(),
        pool,
        support,
    }
}

/// A flight as measured and as predicted; none where it cannot be flown.
pub fn evidence(
    problem: &FitProblem,
    names: &[String],
    observations: &Observations,
    unknowns: (&DVector<f64>, &DVector<f64>),
) -> Option<FlightEvidence> {
    let cache = states(problem, observations, unknowns, observations.times.len()).ok()?;
    let parameters = observations.parameters(problem, unknowns.0);
    let sight = MarkerConditions::new(&problem.body, &parameters, observations.markers);
    let mut observers = sight.observers();
    let layout = problem.body.layout();
    let mut evidence = FlightEvidence {
        file: observations.file.clone(),
        role: observations.role,
        markers: names.to_vec(),
        times: observations.times.clone(),
        measured: observations
            .measured
            .chunks(observations.markers)
            .map(<[_]>::to_vec)
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
    for (&time, state) in observations
        .times
        .iter()
        .zip(cache.chunks(observations.manifold.states()))
    {
        let markers = problem.markers.iter().enumerate();
        let predicted = markers.map(|marker| observers.position(time, state, marker));
        evidence.predicted.push(predicted.collect());
        evidence.quantities.push(observers.quantities(time, state));
        evidence.states.push(state.to_vec());
    }
    Some(evidence)
}
