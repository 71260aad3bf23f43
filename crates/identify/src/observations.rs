//! A flight made ready to be fitted: its samples from the first that shows something, with what is known of it.

use nalgebra::DVector;

use crate::dataset::{Flight, Role};
use crate::noise::median;
use crate::problem::FitProblem;
use crate::report::Truncation;
use crate::state_manifold::StateManifold;

/// One flight's samples.
#[derive(Clone, Debug)]
pub struct Observations {
    /// Its file.
    pub file: String,
    /// What it is for.
    pub role: Role,
    /// Time of the first sample used, s, as in the table.
    pub origin: f64,
    /// Times since then, s.
    pub times: Vec<f64>,
    /// `seen[sample * markers + marker]`, m.
    pub measured: Vec<Option<[f64; 3]>>,
    /// Whether the point is left out as an outlier.
    pub outlier: Vec<bool>,
    /// How many markers there are.
    pub markers: usize,
    /// Parameters before the shared unknowns are put in.
    pub parameters: Vec<f64>,
    /// States that are known, and their values.
    pub known_states: Vec<(usize, f64)>,
    /// How its initial state may be varied.
    pub manifold: StateManifold,
    /// Samples in its table.
    pub samples: usize,
    /// Where the table was cut.
    pub truncation: Option<Truncation>,
    /// What has to be said of it.
    pub notes: Vec<String>,
}

impl Observations {
    /// Takes a flight's samples, from the first in which a marker was seen to the last.
    ///
    /// # Errors
    /// In words, where nothing was seen.
    pub fn new(problem: &FitProblem, flight: &Flight) -> Result<Self, String> {
        let shows = |row: &Vec<Option<[f64; 3]>>| row.iter().any(Option::is_some);
        let first = flight.positions.iter().position(shows);
        let first = first.ok_or("no marker was seen in it")?;
        let last = flight.positions.iter().rposition(shows).unwrap_or(first);
        let origin = flight.times[first];
        let [places, states] = problem.known(&flight.known)?;
        let mut parameters = problem.parameters.clone();
        for (place, value) in places {
            parameters[place] = value;
        }
        let known: Vec<usize> = states.iter().map(|(state, _)| *state).collect();
        let seen: Vec<_> = flight.positions[first..=last]
            .iter()
            .flatten()
            .copied()
            .collect();
        let mut notes = Vec::new();
        if first > 0 {
            notes.push(format!("nothing was seen in its first {first} samples"));
        }
        Ok(Self {
            file: flight.file.clone(),
            role: flight.role,
            origin,
            times: flight.times[first..=last]
                .iter()
                .map(|t| t - origin)
                .collect(),
            outlier: vec![false; seen.len()],
            measured: seen,
            markers: problem.markers.len(),
            parameters,
            manifold: StateManifold::new(&problem.model, &known),
            known_states: states,
            samples: flight.times.len(),
            truncation: None,
            notes,
        })
    }

    /// The points of one sample.
    pub fn points(&self, sample: usize) -> &[Option<[f64; 3]>] {
        &self.measured[sample * self.markers..][..self.markers]
    }

    /// A point that was seen and is no outlier.
    pub fn inlier(&self, sample: usize, marker: usize) -> Option<[f64; 3]> {
        let index = sample * self.markers + marker;
        self.measured[index].filter(|_| !self.outlier[index])
    }

    /// How many samples begin the flight, up to a time (s).
    pub fn samples_until(&self, time: f64) -> usize {
        self.times.partition_point(|t| *t <= time)
    }

    /// The usual time between samples, s; none for a single one.
    pub fn interval(&self) -> Option<f64> {
        let mut gaps: Vec<f64> = self
            .times
            .windows(2)
            .map(|pair| pair[1] - pair[0])
            .collect();
        (!gaps.is_empty()).then(|| median(&mut gaps))
    }

    /// Drops the samples from this one on.
    pub fn truncate(&mut self, samples: usize, why: String) {
        let left_out = self.times.len() - samples;
        self.times.truncate(samples);
        self.measured.truncate(samples * self.markers);
        self.outlier.truncate(samples * self.markers);
        self.truncation = Some(Truncation {
            t: self.origin + self.times.last().copied().unwrap_or(0.0),
            samples: left_out,
            why,
        });
    }

    /// The first samples of it as a flight of their own.
    pub fn first_samples(&self, samples: usize) -> Observations {
        let mut head = self.clone();
        head.times.truncate(samples);
        head.measured.truncate(samples * self.markers);
        head.outlier.truncate(samples * self.markers);
        head
    }

    /// Puts what is known of the initial state into it.
    pub fn with_known_states(&self, mut state: DVector<f64>) -> DVector<f64> {
        for &(place, value) in &self.known_states {
            state[place] = value;
        }
        state
    }

    /// The parameters of the flight with these values of the shared unknowns.
    pub fn parameters(&self, problem: &FitProblem, global: &DVector<f64>) -> Vec<f64> {
        let mut parameters = self.parameters.clone();
        for (unknown, &value) in problem.globals.iter().zip(global.iter()) {
            parameters[unknown.param] = value;
        }
        parameters
    }
}
