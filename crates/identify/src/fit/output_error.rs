//! The least squares of some flights, or of their first samples.

use nalgebra::DVector;

use crate::least_squares::NormalBlock;
use crate::least_squares::{Constraint, LeastSquaresProblem};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::predict::{Loss, Unknowns, linearise};
use crate::problem::FitProblem;

/// The sum of squares over the first samples of some flights.
pub struct OutputError<'a> {
    /// The model.
    pub problem: &'a FitProblem,
    /// The flights.
    pub observation_sets: Vec<&'a Observations>,
    /// How many samples of each count.
    pub samples: Vec<usize>,
    /// How residuals count.
    pub loss: Loss<'a>,
    /// The shared unknowns where they are held, and not among the unknowns.
    pub held: Option<&'a DVector<f64>>,
    /// What is known of the shared unknowns.
    pub constraints: Vec<Constraint>,
    /// Flights worked on at once.
    pub threads: usize,
    /// Who looks on.
    pub options: &'a FitOptions<'a>,
}

/// How many samples each flight has.
pub fn whole(observation_sets: &[Observations]) -> Vec<usize> {
    observation_sets
        .iter()
        .map(|observations| observations.times.len())
        .collect()
}

impl<'a> OutputError<'a> {
    /// All samples of all flights, by all unknowns.
    pub fn of_all(
        problem: &'a FitProblem,
        observation_sets: impl IntoIterator<Item = &'a Observations>,
        loss: Loss<'a>,
        options: &'a FitOptions<'a>,
    ) -> Self {
        let observation_sets: Vec<&Observations> = observation_sets.into_iter().collect();
        Self {
            problem,
            samples: observation_sets
                .iter()
                .map(|observations| observations.times.len())
                .collect(),
            observation_sets,
            loss,
            held: None,
            constraints: problem
                .globals
                .iter()
                .map(|global| global.constraint)
                .collect(),
            threads: options.threads(),
            options,
        }
    }

    /// The first samples of one flight, by its own unknowns.
    pub fn of_local(
        problem: &'a FitProblem,
        observations: &'a Observations,
        samples: usize,
        loss: Loss<'a>,
        global: &'a DVector<f64>,
        options: &'a FitOptions<'a>,
    ) -> Self {
        Self {
            problem,
            observation_sets: vec![observations],
            samples: vec![samples],
            loss,
            held: Some(global),
            constraints: Vec::new(),
            threads: 1,
            options,
        }
    }
}

impl LeastSquaresProblem for OutputError<'_> {
    fn flights(&self) -> usize {
        self.observation_sets.len()
    }

    fn linearise(
        &self,
        flight: usize,
        global: &DVector<f64>,
        local: &DVector<f64>,
    ) -> Result<NormalBlock, String> {
        let (global, by) = match self.held {
            Some(held) => (held, Unknowns::Local),
            None => (global, Unknowns::All),
        };
        let samples = self.samples[flight];
        let observations = self.observation_sets[flight];
        let block = linearise(
            self.problem,
            observations,
            (global, local),
            samples,
            by,
            self.loss,
        );
        if self.held.is_none() {
            self.options.part_done();
        }
        block
    }

    fn plus(&self, flight: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        self.observation_sets[flight].manifold.plus(local, step)
    }

    fn constraints(&self) -> &[Constraint] {
        &self.constraints
    }

    fn threads(&self) -> usize {
        self.threads
    }

    fn is_stopped(&self) -> bool {
        self.options.is_stopped()
    }
}
