//! Quantities of one flight after the fit: residual statistics, excitation ranges, and measured and predicted values
//! for figures.

use nalgebra::DVector;

use super::residual_cache::Path;
use crate::channel::ChannelKind;
use crate::channel_observers::ChannelConditions;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::predict::{Residuals, states};
use crate::problem::FitProblem;
use crate::report::{FlightEvidence, MARKER, ResidualPool, SensorEvidence, SquareSums};

/// Residual statistics of one flight, and the minimum and maximum over the flight of each state and auxiliary variable
/// of the model.
pub struct PostFit {
    /// Sums of lagged products of the flight's residuals, and histograms of its whitened residuals, from which the
    /// report states the autocorrelation and the distribution of the residuals.
    pub pool: ResidualPool,
    /// For each channel, the sum of squared residuals and the numbers of values and outliers, in the order of the
    /// channels.
    pub channels: Vec<ChannelSum>,
    /// Minimum and maximum over the flight of each of the model's auxiliary variables, followed by those of its states.
    pub ranges: Vec<(f64, f64)>,
}

/// Sum of squared residuals of one channel, and its numbers of values and outliers. Residuals are in the unit of the
/// channel: the factor `Channel::scale` is not applied.
#[derive(Clone, Copy, Debug, Default)]
pub struct ChannelSum {
    /// Sum of squared residuals over all components, outliers excluded, in the square of the channel's unit.
    pub squares: f64,
    /// Number of measured values of the channel, outliers excluded. A vector counts as one value.
    pub count: usize,
    /// Number of measured values of the channel that are excluded as outliers. A vector counts as one value.
    pub outliers: usize,
}

/// For each channel of a flight, the sum of its squared residuals in the samples from `first` on, and the numbers of
/// values and outliers.
pub fn channel_sums(
    problem: &FitProblem,
    observations: &Observations,
    residuals: &Residuals,
    first: usize,
) -> Vec<ChannelSum> {
    let series = residuals.iter().zip(&problem.channels).enumerate();
    let sums = series.map(|(channel, (series, own))| {
        let mut sum = ChannelSum::default();
        for (sample, residual) in series.iter().enumerate().skip(first) {
            let Some(residual) = residual else { continue };
            if observations.is_outlier(sample, channel) {
                sum.outliers += 1;
                continue;
            }
            sum.count += 1;
            let components = residual[..own.components].iter();
            sum.squares += components.map(|r| (r / own.scale).powi(2)).sum::<f64>();
        }
        sum
    });
    sums.collect()
}

/// Squared residuals by kind of sensor. Where markers are tracked, positions of pose sensors are not counted.
pub fn square_sums(problem: &FitProblem, channels: &[ChannelSum]) -> SquareSums {
    let mut sums = SquareSums::default();
    for (index, (sum, own)) in channels.iter().zip(&problem.channels).enumerate() {
        let kind = match own.kind {
            ChannelKind::Marker(_) => MARKER,
            ChannelKind::Position if problem.is_scored(index) => MARKER,
            ChannelKind::Position => continue,
            ChannelKind::Attitude => "attitude",
            ChannelKind::Instrument(place) => problem.instruments[place].0.name(),
        };
        sums.add(kind, own.unit, sum.squares, own.components * sum.count);
    }
    sums
}

/// Approximate number of samples of a flight at which the model's auxiliary variables are evaluated to find their
/// minimum and maximum.
const EVALUATED_SAMPLES: usize = 12;

/// Range (minimum, maximum) that contains no value: the initial value when the union of several ranges is computed.
pub const EMPTY_RANGE: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);

/// Smallest range (minimum, maximum) that contains both ranges.
pub fn joined(one: (f64, f64), other: (f64, f64)) -> (f64, f64) {
    (one.0.min(other.0), one.1.max(other.1))
}

/// Computes the residual statistics of a flight, and the minimum and maximum of its states and auxiliary variables,
/// from its trajectory `path`.
pub fn post_fit(
    problem: &FitProblem,
    observations: &Observations,
    noise: &NoiseModel,
    global: &DVector<f64>,
    path: &Path,
) -> PostFit {
    let mut pool = ResidualPool::default();
    let series = path.residuals.iter().enumerate();
    for (channel, series) in series.filter(|(channel, _)| problem.is_scored(*channel)) {
        let inliers = series.iter().enumerate();
        let inliers: Vec<_> = inliers
            .map(|(sample, residual)| {
                residual.filter(|_| !observations.is_outlier(sample, channel))
            })
            .collect();
        pool.add(&observations.times, &inliers, noise.of(channel));
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
        channels: channel_sums(problem, observations, &path.residuals, 0),
        pool,
        ranges,
    }
}

/// Measured and predicted values of a flight, for figures; `None` if its trajectory cannot be computed.
pub fn evidence(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
) -> Option<FlightEvidence> {
    let samples = observations.times.len();
    let trajectory = states(problem, observations, (global, local), samples).ok()?;
    let parameters = observations.parameters(problem, global);
    let conditions = ChannelConditions::new(problem, &parameters);
    let mut observers = conditions.observers();
    let bound = problem.body.bind(parameters.clone());
    let mut observer = bound.observer();
    let layout = problem.body.layout();
    let channels = problem.channels.iter().enumerate();
    let positions: Vec<usize> = channels
        .clone()
        .filter_map(|(index, channel)| channel.is_position().then_some(index))
        .collect();
    let sensors = channels.filter(|(_, channel)| !channel.is_position());
    let sensors = sensors.map(|(index, channel)| SensorEvidence {
        name: channel.name.clone(),
        channel: index,
        unit: channel.unit.to_owned(),
        components: channel.components,
        measured: (0..samples).map(|k| observations.value(k, index)).collect(),
        outlier: (0..samples)
            .map(|k| observations.is_outlier(k, index))
            .collect(),
        residuals: Vec::new(),
    });
    let mut sensors: Vec<SensorEvidence> = sensors.collect();
    let mut evidence = FlightEvidence {
        file: observations.file.clone(),
        role: observations.role,
        markers: positions
            .iter()
            .map(|&channel| problem.channels[channel].name.clone())
            .collect(),
        times: observations.times.clone(),
        measured: (0..samples)
            .map(|k| {
                positions
                    .iter()
                    .map(|&c| observations.value(k, c))
                    .collect()
            })
            .collect(),
        outlier: (0..samples)
            .map(|k| {
                positions
                    .iter()
                    .map(|&c| observations.is_outlier(k, c))
                    .collect()
            })
            .collect(),
        sensors: Vec::new(),
        predicted: Vec::new(),
        state_names: layout.states.clone(),
        states: Vec::new(),
        quantity_names: layout.quantities.clone(),
        quantities: Vec::new(),
    };
    let states = trajectory.chunks(observations.manifold.states());
    for (sample, (&time, state)) in observations.times.iter().zip(states).enumerate() {
        // The residual of a measured value 0 is the predicted value times the scale of the channel.
        let mut position = |channel: usize| {
            let scale = problem.channels[channel].scale;
            observers
                .residual(time, state, channel, [0.0; 3])
                .map(|y| y / scale)
        };
        let predicted = positions.iter().map(|&channel| position(channel));
        evidence.predicted.push(predicted.collect());
        for sensor in &mut sensors {
            let residual = observations.value(sample, sensor.channel).map(|seen| {
                let scale = problem.channels[sensor.channel].scale;
                let residual = observers.residual(time, state, sensor.channel, seen);
                residual.map(|predicted_less_measured| -predicted_less_measured / scale)
            });
            sensor.residuals.push(residual);
        }
        evidence.quantities.push(observer.quantities(time, state));
        evidence.states.push(state.to_vec());
    }
    evidence.sensors = sensors;
    Some(evidence)
}
