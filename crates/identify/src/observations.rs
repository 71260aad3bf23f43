//! Observations of one flight: its usable samples, its known values, and the directions of its initial state.

use std::ops::Range;

use model_spec::layout::StateId;
use nalgebra::DVector;

use crate::dataset::{Flight, Role};
use crate::error::FlightError;
use crate::problem::FitProblem;
use crate::report::Truncation;
use crate::state_manifold::StateManifold;
use crate::statistics::median;

/// Samples of one flight from the first to the last with a measured marker, and what is known of the flight.
#[derive(Clone, Debug)]
pub struct Observations {
    /// File name of the flight.
    pub file: String,
    /// Whether the flight is fitted or held out.
    pub role: Role,
    /// Time of the first sample in the table, s.
    pub origin: f64,
    /// Times of the samples since the first, s.
    pub times: Vec<f64>,
    /// `measured[sample * markers + marker]`: position, m, inertial frame; `None` for a missing value.
    pub measured: Vec<Option<[f64; 3]>>,
    /// `outlier[sample * markers + marker]`: whether the point is excluded as an outlier.
    pub outlier: Vec<bool>,
    /// Number of markers.
    pub markers: usize,
    /// Parameters of the flight in the order of the layout, SI; global parameters still have their initial values.
    pub parameters: Vec<f64>,
    /// Known states at the first sample, SI.
    pub known_states: Vec<(StateId, f64)>,
    /// Directions in which the initial state may be varied.
    pub manifold: StateManifold,
    /// Number of samples in the table, without those that were truncated.
    pub samples: usize,
    /// Where and why the samples were truncated, if they were.
    pub truncation: Option<Truncation>,
    /// Messages for the report.
    pub notes: Vec<String>,
}

impl Observations {
    /// Extracts the samples of a flight from the first to the last measured marker.
    ///
    /// # Errors
    /// [`FlightError::NoMeasurement`]; [`FlightError::UnknownKnownValue`] or [`FlightError::KnownAndEstimated`] for
    /// known values that do not match the problem.
    pub fn new(problem: &FitProblem, flight: &Flight) -> Result<Self, FlightError> {
        let has_measurement = |row: &Vec<Option<[f64; 3]>>| row.iter().any(Option::is_some);
        let first = flight.positions.iter().position(has_measurement);
        let first = first.ok_or(FlightError::NoMeasurement)?;
        let last = flight.positions.iter().rposition(has_measurement);
        let last = last.unwrap_or(first);
        let origin = flight.times[first];
        let known = problem.known_values(&flight.known)?;
        let mut parameters = problem.parameters.clone();
        for (id, value) in known.parameters {
            parameters[id.index()] = value;
        }
        let known_states: Vec<StateId> = known.states.iter().map(|(state, _)| *state).collect();
        let rows = &flight.positions[first..=last];
        let measured: Vec<_> = rows.iter().flatten().copied().collect();
        let times = flight.times[first..=last].iter();
        let mut notes = Vec::new();
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
            markers: problem.markers.len(),
            parameters,
            manifold: StateManifold::new(&problem.model, &known_states),
            known_states: known.states,
            samples: flight.times.len(),
            truncation: None,
            notes,
        })
    }

    /// Observations of the flight with the samples and the outliers of those of another problem; `None` if they do not match.
    pub(crate) fn like(problem: &FitProblem, flight: &Flight, other: &Self) -> Option<Self> {
        let mut observations = Self::new(problem, flight).ok()?;
        let samples = other.times.len();
        let is_same = observations.markers == other.markers
            && observations.times.get(..samples)? == other.times.as_slice();
        if !is_same {
            return None;
        }
        observations.keep(samples);
        observations.samples = other.samples;
        observations.outlier.clone_from(&other.outlier);
        observations.truncation.clone_from(&other.truncation);
        observations.notes.clone_from(&other.notes);
        Some(observations)
    }

    /// Measured positions of all markers in one sample, m.
    pub fn points(&self, sample: usize) -> &[Option<[f64; 3]>] {
        &self.measured[sample * self.markers..][..self.markers]
    }

    /// Measured position of a marker, m; `None` if missing or an outlier.
    pub fn inlier(&self, sample: usize, marker: usize) -> Option<[f64; 3]> {
        let index = sample * self.markers + marker;
        self.measured[index].filter(|_| !self.outlier[index])
    }

    /// Number of points that are excluded as outliers.
    pub fn outliers(&self) -> usize {
        self.outlier.iter().filter(|outlier| **outlier).count()
    }

    /// Number of samples up to `time`, s after the first sample.
    pub fn samples_until(&self, time: f64) -> usize {
        self.times.partition_point(|t| *t <= time)
    }

    /// Median time between neighbouring samples, s; `None` for a single sample.
    pub fn interval(&self) -> Option<f64> {
        let pairs = self.times.windows(2);
        let mut intervals: Vec<f64> = pairs.map(|pair| pair[1] - pair[0]).collect();
        (!intervals.is_empty()).then(|| median(&mut intervals))
    }

    /// Drops all but the first `samples` samples, and records the reason.
    pub fn truncate(&mut self, samples: usize, why: String) {
        let dropped = self.times.len() - samples;
        self.keep(samples);
        self.samples -= dropped;
        self.truncation = Some(Truncation {
            t: self.origin + self.times.last().copied().unwrap_or(0.0),
            samples: dropped,
            why,
        });
    }

    /// A copy with only the first `samples` samples.
    pub fn first_samples(&self, samples: usize) -> Observations {
        let mut first = self.clone();
        first.keep(samples);
        first
    }

    /// The samples of a range as a flight of their own, whose initial state is not known. Times stay as they are.
    pub(crate) fn arc(&self, problem: &FitProblem, samples: Range<usize>) -> Observations {
        let is_first = samples.start == 0;
        let mut arc = self.longer(self, samples);
        if !is_first {
            arc.known_states = Vec::new();
            arc.manifold = StateManifold::new(&problem.model, &[]);
        }
        arc
    }

    /// This arc of a flight, with the samples of another range of the flight.
    pub(crate) fn longer(&self, flight: &Observations, samples: Range<usize>) -> Observations {
        let points = samples.start * self.markers..samples.end * self.markers;
        Observations {
            times: flight.times[samples].to_vec(),
            measured: flight.measured[points.clone()].to_vec(),
            outlier: flight.outlier[points].to_vec(),
            manifold: self.manifold.clone(),
            file: self.file.clone(),
            parameters: self.parameters.clone(),
            known_states: self.known_states.clone(),
            truncation: None,
            notes: Vec::new(),
            ..*self
        }
    }

    fn keep(&mut self, samples: usize) {
        self.times.truncate(samples);
        self.measured.truncate(samples * self.markers);
        self.outlier.truncate(samples * self.markers);
    }

    /// Overwrites the known states of an initial state with their known values.
    pub fn with_known_states(&self, mut state: DVector<f64>) -> DVector<f64> {
        for &(id, value) in &self.known_states {
            state[id.index()] = value;
        }
        state
    }

    /// Parameters of the flight in the order of the layout, SI, with the given values of the global parameters.
    pub fn parameters(&self, problem: &FitProblem, global: &DVector<f64>) -> Vec<f64> {
        let mut parameters = self.parameters.clone();
        for (parameter, &value) in problem.globals.iter().zip(global.iter()) {
            parameters[parameter.param.index()] = value;
        }
        parameters
    }
}

/// Median of the flights' sampling intervals, s; 1 if none has two samples.
pub fn median_interval<'o>(flights: impl IntoIterator<Item = &'o Observations>) -> f64 {
    let intervals = flights.into_iter().filter_map(Observations::interval);
    let mut intervals: Vec<f64> = intervals.collect();
    match intervals.is_empty() {
        true => 1.0,
        false => median(&mut intervals),
    }
}
