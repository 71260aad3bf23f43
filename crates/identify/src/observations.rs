//! Observations of one flight: its usable samples, its known values, and the free directions of its initial state.

use std::borrow::Cow;
use std::ops::Range;

use flight::{BoundModel, FlightParameters, InputsOverTime};
use model_spec::layout::StateId;
use nalgebra::DVector;
use serde::{Deserialize, Serialize};

use crate::channel::ChannelKind;
use crate::error::FlightError;
use crate::inputs;
use crate::problem::{FitProblem, RESIDUAL_TOLERANCE, StatePrior};
use crate::state_manifold::StateManifold;
use dataset::pose::{Pose, pose};
use dataset::statistics::median_of;
use dataset::{Flight, Role, attitude};

/// Truncation of a flight before the end of its table, such as at a ground contact.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Truncation {
    /// Time of the last sample that is used, s, as in the table of the flight.
    pub t: f64,
    /// Number of samples after the time `t`, which were dropped.
    pub samples: usize,
    /// Reason for the truncation of the flight, as text for the report.
    pub reason: String,
}

/// Samples of one flight from the first to the last measured value, with its known parameters and states.
#[derive(Clone, Debug)]
pub struct Observations {
    /// File name of the flight.
    pub file: String,
    /// Whether the flight is fitted or held out.
    pub role: Role,
    /// Time of the first used sample (the origin of `times`), as in the table of the flight, s.
    pub origin: f64,
    /// Times of the samples relative to the first one used, s.
    pub times: Vec<f64>,
    /// `measured[sample * channels + channel]`: position, inertial, m; rotation vector, rad; or reading in its unit. A
    /// scalar is repeated three times. `None` for a missing value.
    pub measured: Vec<Option<[f64; 3]>>,
    /// Whether a measured value is excluded as an outlier, as `outlier[sample * channels + channel]`.
    pub outlier: Vec<bool>,
    /// Whether the flight is a row of a table of summaries, with a single sample at its release.
    pub is_summary: bool,
    /// Number of channels; marker channels come first.
    pub channels: usize,
    /// Number of points from which the pose is determined, as in [`PosePoints`](dataset::PosePoints).
    pub markers: usize,
    /// `stand_ins[sample * markers + point]`, m: the markers, followed by body-fixed points whose positions are
    /// computed from the pose that a sensor measures or from the markers. Empty if all points are markers.
    pub stand_ins: Vec<Option<[f64; 3]>>,
    /// Parameters in the order of the compiled model, SI; global ones have their initial values.
    pub parameters: Vec<f64>,
    /// Inputs over time, with times relative to the first used sample.
    pub inputs: InputsOverTime,
    /// States whose values at the first sample are known, and these values, SI.
    pub known_states: Vec<(StateId, f64)>,
    /// Gaussian priors of states at the first sample.
    pub state_priors: Vec<StatePrior>,
    /// Directions in which the initial state of the flight may vary in a fit.
    pub manifold: StateManifold,
    /// Number of samples in the table of the flight, without those dropped by a truncation.
    pub samples: usize,
    /// Time and reason of the truncation of the flight at its end; `None` if it was not truncated.
    pub truncation: Option<Truncation>,
    /// Remarks on the flight for the report.
    pub notes: Vec<String>,
    /// Factor, at most 1, of the integration tolerances of the flight: long flights add up more errors.
    pub tolerance_factor: f64,
}

impl Observations {
    /// Extracts the samples of a flight from the first to the last measured value.
    ///
    /// # Errors
    /// [`FlightError::NoMeasurement`] if nothing is measured; [`FlightError::UnknownKnownValue`],
    /// [`FlightError::PartialQuaternion`] or [`FlightError::KnownAndEstimated`] if the known values do not match.
    pub fn new(problem: &FitProblem, flight: &Flight) -> Result<Self, FlightError> {
        let all = 0..flight.times.len();
        let is_measured =
            |sample: &usize| row(problem, flight, *sample).any(|value| value.is_some());
        let first = all.clone().find(is_measured);
        let first = first.ok_or(FlightError::NoMeasurement)?;
        let last = all.rev().find(is_measured).unwrap_or(first);
        let origin = flight.times[first];
        let mut known = problem.known_values(flight, &problem.unknown)?;
        let mut parameters = problem.parameters.clone();
        for &(id, value) in &known.parameters {
            parameters[id.index()] = value;
        }
        let (inputs, mut notes) = inputs::of_flight(problem, flight, (origin, flight.times[last]))?;
        let channels = problem.channels.len();
        let mut measured = Vec::with_capacity((last + 1 - first) * channels);
        for sample in first..=last {
            measured.extend(row(problem, flight, sample));
            // What releases have by assumption stands in no table.
            measured.resize((sample + 1 - first) * channels, None);
        }
        let is_summary = problem.assume(flight, &mut measured, &mut known);
        let known_states: Vec<StateId> = known.states.iter().map(|(state, _)| *state).collect();
        let stand_ins: Vec<_> = match problem.points.of(flight) {
            Cow::Borrowed(_) => Vec::new(),
            Cow::Owned(rows) => rows[first..=last].concat(),
        };
        let times = flight.times[first..=last].iter();
        if first > 0 {
            notes.push(format!(
                "no marker is measured in its first {first} samples"
            ));
        }
        Ok(Self {
            file: flight.file.clone(),
            role: flight.role,
            origin,
            times: times.map(|t| t - origin).collect(),
            outlier: vec![false; measured.len()],
            measured,
            is_summary,
            channels,
            markers: problem.points.markers.len(),
            stand_ins,
            manifold: StateManifold::new(&problem.model, &known_states)
                .held_by(&problem.body, &parameters),
            parameters,
            inputs,
            known_states: known.states,
            state_priors: known.priors,
            samples: flight.times.len(),
            truncation: None,
            notes,
            tolerance_factor: 1.0,
        })
    }

    /// Observations of `flight` with the samples, outliers, truncation and notes of `other`, those for another problem.
    /// `None` if channels or times differ, or the flight cannot be used.
    pub(crate) fn like(problem: &FitProblem, flight: &Flight, other: &Self) -> Option<Self> {
        let mut observations = Self::new(problem, flight).ok()?;
        let samples = other.times.len();
        let is_same = observations.channels == other.channels
            && observations.times.get(..samples)? == other.times.as_slice();
        if !is_same {
            return None;
        }
        observations.keep(samples);
        observations.samples = other.samples;
        observations.measured.clone_from(&other.measured);
        observations.stand_ins.clone_from(&other.stand_ins);
        observations.outlier.clone_from(&other.outlier);
        observations.truncation.clone_from(&other.truncation);
        observations.notes.clone_from(&other.notes);
        observations.tolerance_factor = other.tolerance_factor;
        Some(observations)
    }

    /// Measured positions of the points of the pose in one sample, in the order of [`PosePoints`](dataset::PosePoints), m; outliers
    /// are included.
    pub fn points(&self, sample: usize) -> &[Option<[f64; 3]>] {
        match self.stand_ins.is_empty() {
            true => &self.measured[sample * self.channels..][..self.markers],
            false => &self.stand_ins[sample * self.markers..][..self.markers],
        }
    }

    /// Pose in each sample, `None` where the points do not determine it; empty for a point mass.
    pub(crate) fn poses(&self, problem: &FitProblem) -> Vec<Option<Pose>> {
        let samples = 0..self.times.len() * usize::from(problem.points.has_attitude);
        let each = samples.map(|sample| pose(&problem.points.markers, self.points(sample)));
        each.collect()
    }

    pub(crate) fn is_outlier(&self, sample: usize, channel: usize) -> bool {
        self.outlier[sample * self.channels + channel]
    }

    /// Measured value of a channel in a sample, as in `measured`.
    pub fn value(&self, sample: usize, channel: usize) -> Option<[f64; 3]> {
        self.measured[sample * self.channels + channel]
    }

    /// [`value`](Self::value), or that [without outliers](Self::inlier).
    pub(crate) fn seen(
        &self,
        sample: usize,
        channel: usize,
        with_outliers: bool,
    ) -> Option<[f64; 3]> {
        match with_outliers {
            true => self.value(sample, channel),
            false => self.inlier(sample, channel),
        }
    }

    /// [`value`](Self::value) unless it is an outlier.
    pub fn inlier(&self, sample: usize, channel: usize) -> Option<[f64; 3]> {
        let value = self.value(sample, channel);
        value.filter(|_| !self.is_outlier(sample, channel))
    }

    /// Number of measured values that are excluded as outliers.
    pub fn outliers(&self) -> usize {
        self.outlier.iter().filter(|outlier| **outlier).count()
    }

    /// Number of samples up to and including `time`, s after the first sample.
    pub fn samples_until(&self, time: f64) -> usize {
        self.times.partition_point(|t| *t <= time)
    }

    /// Median time between consecutive samples, s; `None` for a single sample.
    pub fn interval(&self) -> Option<f64> {
        let pairs = self.times.windows(2);
        median_of(pairs.map(|pair| pair[1] - pair[0]))
    }

    /// Forgets what was measured in the first `samples` samples.
    pub fn forget_first(&mut self, samples: usize) {
        let first = &mut self.measured[..samples * self.channels];
        let seen = first
            .chunks(self.channels)
            .filter(|sample| sample.iter().any(Option::is_some));
        self.samples -= seen.count();
        first.fill(None);
        let points = self.stand_ins.len().min(samples * self.markers);
        self.stand_ins[..points].fill(None);
    }

    /// Drops all but the first `samples` samples, and records the time and the reason of the truncation.
    pub fn truncate(&mut self, samples: usize, reason: String) {
        let dropped = self.times.len() - samples;
        self.keep(samples);
        self.samples -= dropped;
        self.truncation = Some(Truncation {
            t: self.origin + self.times.last().copied().unwrap_or(0.0),
            samples: dropped
                + self
                    .truncation
                    .as_ref()
                    .map_or(0, |earlier| earlier.samples),
            reason,
        });
    }

    /// Copy that contains only the first `samples` samples.
    pub fn first_samples(&self, samples: usize) -> Observations {
        let mut first = self.clone();
        first.keep(samples);
        first
    }

    /// A range of samples as a separate flight. Known initial states apply only from the first sample; times remain
    /// relative to it.
    pub(crate) fn arc(&self, problem: &FitProblem, samples: Range<usize>) -> Observations {
        let is_first = samples.start == 0;
        let mut arc = self.longer(self, samples);
        if !is_first {
            arc.known_states = Vec::new();
            arc.state_priors = Vec::new();
            let free = StateManifold::new(&problem.model, &[]);
            arc.manifold = free.held_by(&problem.body, &arc.parameters);
        }
        arc
    }

    pub(crate) fn longer(&self, flight: &Observations, samples: Range<usize>) -> Observations {
        let points = samples.start * self.channels..samples.end * self.channels;
        let stand_ins = samples.start * self.markers..samples.end * self.markers;
        Observations {
            times: flight.times[samples].to_vec(),
            measured: flight.measured[points.clone()].to_vec(),
            outlier: flight.outlier[points].to_vec(),
            stand_ins: flight.stand_ins.get(stand_ins).unwrap_or_default().to_vec(),
            manifold: self.manifold.clone(),
            file: self.file.clone(),
            parameters: self.parameters.clone(),
            inputs: self.inputs.clone(),
            known_states: self.known_states.clone(),
            state_priors: self.state_priors.clone(),
            truncation: None,
            notes: Vec::new(),
            ..*self
        }
    }

    fn keep(&mut self, samples: usize) {
        self.times.truncate(samples);
        self.measured.truncate(samples * self.channels);
        self.outlier.truncate(samples * self.channels);
        self.stand_ins.truncate(samples * self.markers);
    }

    /// Takes priors of states that are neither known nor measured.
    pub(crate) fn adopt(&mut self, priors: &[StatePrior]) {
        for prior in priors {
            let is_same = |own: &StatePrior| own.state == prior.state;
            let is_known = self.known_states.iter().any(|(id, _)| *id == prior.state);
            if !is_known
                && !self
                    .state_priors
                    .iter()
                    .any(|own| own.is_measured && is_same(own))
            {
                self.state_priors.retain(|own| !is_same(own));
                self.state_priors.push(*prior);
            }
        }
    }

    /// Returns the initial state with its known components set to their known values, and those with a prior to its
    /// mean.
    pub fn with_known_states(&self, mut state: DVector<f64>) -> DVector<f64> {
        for prior in &self.state_priors {
            state[prior.state.index()] = prior.mean;
        }
        for &(id, value) in &self.known_states {
            state[id.index()] = value;
        }
        state
    }

    /// Tolerance, m, of the integration for residuals without derivatives.
    pub(crate) fn residual_tolerance(&self, problem: &FitProblem) -> f64 {
        RESIDUAL_TOLERANCE * problem.sigma0 * self.tolerance_factor
    }

    /// The compiled model with the parameters of the flight and the given values of the global ones.
    pub fn bound<'p>(&self, problem: &'p FitProblem, global: &DVector<f64>) -> BoundModel<'p> {
        problem.body.bind(self.parameters(problem, global))
    }

    /// Index, time, s, and state of each sample of a trajectory, whose states are concatenated.
    pub(crate) fn along<'s>(
        &'s self,
        states: &'s [f64],
    ) -> impl Iterator<Item = (usize, f64, &'s [f64])> {
        let states = states.chunks(self.manifold.states());
        let each = states.zip(&self.times).enumerate();
        each.map(|(sample, (state, time))| (sample, *time, state))
    }

    /// Parameters in the order of the compiled model, SI, with the given values of the global ones, and the inputs over
    /// time.
    pub fn parameters(&self, problem: &FitProblem, global: &DVector<f64>) -> FlightParameters {
        let mut constants = self.parameters.clone();
        for (parameter, &value) in problem.globals.iter().zip(global.iter()) {
            constants[parameter.param.index()] = value;
        }
        FlightParameters {
            constants,
            inputs: self.inputs.clone(),
        }
    }
}

/// Measured values of all channels in one sample, as in [`Observations::measured`].
fn row<'f>(
    problem: &'f FitProblem,
    flight: &'f Flight,
    sample: usize,
) -> impl Iterator<Item = Option<[f64; 3]>> + 'f {
    let positions = flight.positions[sample].iter().copied();
    let readings = flight.readings.get(sample).into_iter().flatten();
    let of_sensors = &problem.channels[flight.positions[sample].len()..];
    let readings = readings.zip(of_sensors);
    positions.chain(readings.map(|(reading, channel)| {
        reading.map(|reading| match (channel.kind, channel.components) {
            (ChannelKind::Attitude, _) => attitude(reading).scaled_axis().into(),
            (_, 1) => [reading[0]; 3],
            _ => [reading[0], reading[1], reading[2]],
        })
    }))
}

/// Median over flights of their sampling intervals, s; 1 if no flight has two samples.
pub fn median_interval<'o>(flights: impl IntoIterator<Item = &'o Observations>) -> f64 {
    let intervals = flights.into_iter().filter_map(Observations::interval);
    median_of(intervals).unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::FitOptions;

    /// A simulated flight of a ball.
    fn flight() -> Observations {
        let (model, dataset) = crate::fit::tests::balls(1, 0.4);
        let problem = FitProblem::new(&model, &dataset, &FitOptions::default()).unwrap();
        Observations::new(&problem, &dataset.flights[0]).unwrap()
    }

    #[test]
    fn a_part_of_a_flight_has_its_own_samples() {
        let mut flight = flight();
        let place = |sample: usize| Some([sample as f64, 0.0, 0.0]);
        flight.stand_ins = (0..flight.times.len()).map(place).collect();
        let part = flight.longer(&flight, 3..8);
        assert_eq!(part.times, flight.times[3..8]);
        assert_eq!(part.measured, flight.measured[3..8]);
        assert_eq!(part.stand_ins, (3..8).map(place).collect::<Vec<_>>());
    }

    #[test]
    fn a_flight_that_is_cut_twice_counts_all_samples_that_it_lost() {
        let mut flight = flight();
        let recorded = flight.times.len();
        flight.truncate(recorded - 5, "a net".to_owned());
        flight.truncate(recorded - 12, "a hand".to_owned());
        let cut = flight.truncation.expect("cut");
        assert_eq!((cut.samples, cut.reason.as_str()), (12, "a hand"));
        assert_eq!(flight.times.len(), recorded - 12);
    }
}
