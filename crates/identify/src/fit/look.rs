//! One flight once it is fitted: its residuals, where it went, and what figures are drawn from.

use nalgebra::DVector;

use super::flown::Path;
use crate::noise::Noise;
use crate::predict::states;
use crate::report::{FlightEvidence, residuals::Pool};
use crate::setting::Setting;
use crate::sight::Sight;
use crate::track::Track;

/// What one flight shows.
pub struct Looked {
    /// Root mean square of its residuals, m.
    pub rms: f64,
    /// Points that were left out of it.
    pub outliers: usize,
    /// Its residuals.
    pub pool: Pool,
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
pub fn look(
    setting: &Setting,
    track: &Track,
    noise: &Noise,
    shared: &DVector<f64>,
    path: &Path,
) -> Looked {
    let mut pool = Pool::default();
    for (marker, series) in path.residuals.iter().enumerate() {
        let outlier = |sample: usize| track.outlier[sample * track.markers + marker];
        let good = series.iter().enumerate();
        let good: Vec<_> = good
            .map(|(sample, r)| r.filter(|_| !outlier(sample)))
            .collect();
        pool.add(&track.times, &good, noise);
    }
    let conditions = setting.body.with(track.parameters(setting, shared));
    let mut observer = conditions.observer();
    let layout = setting.body.layout();
    let mut support = vec![NOTHING; layout.quantities.len() + layout.states.len()];
    let width = track.chart.states();
    let every = (track.times.len() / LOOKS).max(1);
    for (sample, state) in path.states.chunks(width).enumerate().step_by(every) {
        let quantities = observer.quantities(track.times[sample], state);
        let values = quantities.iter().chain(state);
        for (range, &value) in support.iter_mut().zip(values) {
            if value.is_finite() {
                *range = joined(*range, (value, value));
            }
        }
    }
    Looked {
        rms: pool.rms(),
        outliers: track.outlier.iter().filter(|outlier| **outlier).count(),
        pool,
        support,
    }
}

/// A flight as measured and as predicted; none where it cannot be flown.
pub fn evidence(
    setting: &Setting,
    names: &[String],
    track: &Track,
    unknowns: (&DVector<f64>, &DVector<f64>),
) -> Option<FlightEvidence> {
    let flown = states(setting, track, unknowns, track.times.len()).ok()?;
    let parameters = track.parameters(setting, unknowns.0);
    let sight = Sight::new(&setting.body, &parameters, track.markers);
    let mut observers = sight.observers();
    let layout = setting.body.layout();
    let mut evidence = FlightEvidence {
        file: track.file.clone(),
        role: track.role,
        markers: names.to_vec(),
        times: track.times.clone(),
        measured: track
            .seen
            .chunks(track.markers)
            .map(<[_]>::to_vec)
            .collect(),
        outlier: track
            .outlier
            .chunks(track.markers)
            .map(<[_]>::to_vec)
            .collect(),
        predicted: Vec::new(),
        state_names: layout.states.clone(),
        states: Vec::new(),
        quantity_names: layout.quantities.clone(),
        quantities: Vec::new(),
    };
    for (&time, state) in track.times.iter().zip(flown.chunks(track.chart.states())) {
        let markers = setting.markers.iter().enumerate();
        let predicted = markers.map(|marker| observers.position(time, state, marker));
        evidence.predicted.push(predicted.collect());
        evidence.quantities.push(observers.quantities(time, state));
        evidence.states.push(state.to_vec());
    }
    Some(evidence)
}
