//! Quantities of one flight after the fit: statistics of residuals, excitation ranges, values for figures.

use nalgebra::DVector;

use super::residual_cache::Path;
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::observers::ChannelConditions;
use crate::predict::{FlightAt, Residuals};
use crate::problem::FitProblem;
use crate::report::{FlightEvidence, ResidualPool, SensorEvidence, SquareSums};

/// Residual statistics of one flight, and the ranges of the states and auxiliary variables.
pub struct PostFit {
    pub pool: ResidualPool,
    pub channels: Vec<ChannelSum>,
    /// Minimum and maximum over the flight of each of the model's auxiliary variables, followed by those of its states.
    pub ranges: Vec<(f64, f64)>,
}

/// Sum of squared residuals of one channel, in its unit, and its numbers of values and outliers.
#[derive(Clone, Copy, Debug, Default)]
pub struct ChannelSum {
    /// Sum of squared residuals over all components, outliers excluded, in the square of the channel's unit.
    pub squares: f64,
    pub count: usize,
    pub outliers: usize,
}

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
        let Some(kind) = problem.kind(index) else {
            continue;
        };
        let unit = (own.unit, own.to_si.abs());
        sums.add(kind, unit, sum.squares, own.components * sum.count);
    }
    sums
}

/// Approximate number of samples of a flight at which auxiliary variables are evaluated.
const EVALUATED_SAMPLES: usize = 12;

/// Range (minimum, maximum) that contains no value: the initial value when the union of several ranges is computed.
pub const EMPTY_RANGE: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);

/// Smallest range (minimum, maximum) that contains both ranges.
pub fn joined(one: (f64, f64), other: (f64, f64)) -> (f64, f64) {
    (one.0.min(other.0), one.1.max(other.1))
}

/// Residual statistics and ranges of a flight from its trajectory `path`.
pub fn post_fit(
    problem: &FitProblem,
    observations: &Observations,
    noise: &NoiseModel,
    global: &DVector<f64>,
    path: &Path,
) -> PostFit {
    let mut pool = ResidualPool::default();
    let series = path.residuals.iter().enumerate();
    // Values of summaries have no axes.
    let is_scored = |channel: usize| problem.is_scored(channel) && !observations.is_summary;
    for (channel, series) in series.filter(|(channel, _)| is_scored(*channel)) {
        let inliers = series.iter().enumerate();
        let inliers: Vec<_> = inliers
            .map(|(sample, residual)| {
                residual.filter(|_| !observations.is_outlier(sample, channel))
            })
            .collect();
        pool.add(&observations.times, &inliers, noise.of(channel));
    }
    let conditions = observations.bound(problem, global);
    let mut observer = conditions.observer();
    let layout = problem.body.layout();
    let mut ranges = vec![EMPTY_RANGE; layout.quantities.len() + layout.states.len()];
    let every = (observations.times.len() / EVALUATED_SAMPLES).max(1);
    for (_, time, state) in observations.along(&path.states).step_by(every) {
        let quantities = observer.quantities(time, state);
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
pub fn evidence(at: FlightAt<'_>) -> Option<FlightEvidence> {
    let (problem, observations) = (at.problem, at.observations);
    // What summaries tell is no motion over time.
    if observations.is_summary {
        return None;
    }
    let trajectory = at.states().ok()?;
    let parameters = observations.parameters(problem, at.global);
    let conditions = ChannelConditions::new(problem, &parameters);
    let mut observers = conditions.observers();
    let bound = problem.body.bind(parameters);
    let mut observer = bound.observer();
    let layout = problem.body.layout();
    let named = |channel: usize| problem.channels[channel].name.clone();
    let (positions, others): (Vec<usize>, Vec<usize>) =
        (0..problem.channels.len()).partition(|k| problem.channels[*k].is_position());
    let sensors = others.into_iter().map(|channel| SensorEvidence {
        name: named(channel),
        channel,
        unit: problem.channels[channel].unit.to_owned(),
        components: problem.channels[channel].components,
        ..SensorEvidence::default()
    });
    let inputs: Vec<_> = observations.inputs.series().collect();
    let names = inputs.iter().map(|(id, _)| &layout.parameters[id.index()]);
    let unit = |name: &String| {
        let mut declared = problem.model.params.iter();
        let declared = declared.find(|own| own.name == *name);
        declared.map_or_else(String::new, |own| own.unit_text.clone())
    };
    let mut evidence = FlightEvidence {
        file: observations.file.clone(),
        role: observations.role,
        markers: positions.iter().map(|&channel| named(channel)).collect(),
        times: observations.times.clone(),
        sensors: sensors.collect(),
        state_names: layout.states.clone(),
        quantity_names: layout.quantities.clone(),
        input_names: names.clone().cloned().collect(),
        input_units: names.map(unit).collect(),
        ..FlightEvidence::default()
    };
    for (sample, time, state) in observations.along(&trajectory) {
        let mut residual = |channel: usize, measured: [f64; 3]| {
            let residual = observers.residual(time, state, channel, measured);
            residual.map(|residual| residual / problem.channels[channel].scale)
        };
        let value = |channel: usize| observations.value(sample, channel);
        let is_outlier = |channel: usize| observations.is_outlier(sample, channel);
        let places = positions.iter().copied();
        evidence.measured.push(places.clone().map(value).collect());
        evidence
            .outlier
            .push(places.clone().map(is_outlier).collect());
        // The residual of a measured value 0 is the predicted value.
        let predicted = places.map(|own| residual(own, [0.0; 3]));
        evidence.predicted.push(predicted.collect());
        for sensor in &mut evidence.sensors {
            let measured = value(sensor.channel);
            let residual = measured.map(|seen| residual(sensor.channel, seen).map(|own| -own));
            sensor.measured.push(measured);
            sensor.outlier.push(is_outlier(sensor.channel));
            sensor.residuals.push(residual);
        }
        evidence.quantities.push(observer.quantities(time, state));
        evidence.states.push(state.to_vec());
        let inputs = inputs.iter().map(|(_, series)| series.at(time));
        evidence.inputs.push(inputs.collect());
    }
    Some(evidence)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::FitOptions;

    #[test]
    fn residuals_are_summed_in_the_unit_of_their_channel_without_outliers() {
        let (model, dataset) = crate::fit::tests::balls(1, 0.2);
        let mut problem = FitProblem::new(&model, &dataset, &FitOptions::default()).unwrap();
        problem.channels[0].scale = 0.5;
        let mut observations = Observations::new(&problem, &dataset.flights[0]).unwrap();
        observations.outlier[4] = true;
        let residuals = vec![vec![Some([1.0, 2.0, 2.0]); observations.times.len()]];
        let [sum] = channel_sums(&problem, &observations, &residuals, 2)[..] else {
            panic!("one channel");
        };
        let count = observations.times.len() - 3;
        assert_eq!((sum.count, sum.outliers), (count, 1));
        assert_eq!(sum.squares, 36.0 * count as f64);
    }

    #[test]
    fn ranges_are_joined_to_one_that_holds_them() {
        let all = [(2.0, 3.0), (-1.0, 0.5), (2.5, 2.6)]
            .into_iter()
            .fold(EMPTY_RANGE, joined);
        assert_eq!(all, (-1.0, 3.0));
    }
}
