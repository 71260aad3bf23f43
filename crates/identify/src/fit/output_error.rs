//! The output-error objective: sum of squared residuals over all or the first samples of some flights.

use nalgebra::DVector;

use crate::error::FlightError;
use crate::least_squares::{Constraint, LeastSquaresProblem, NormalBlock, Unknowns};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::predict::{Loss, linearise};
use crate::problem::FitProblem;

/// Objective of a fit: the sum of squared residuals, or of a loss function of them, over the first samples of the
/// flights in `flights`.
pub struct OutputError<'a> {
    /// Estimation problem with the model, the channels and the parameters.
    pub problem: &'a FitProblem,
    /// Observations of each flight in the sum.
    pub flights: Vec<&'a Observations>,
    /// Number of samples of each flight that are used, counted from its first sample.
    pub samples: Vec<usize>,
    /// Loss function of the residuals.
    pub loss: Loss<'a>,
    /// Values of the global parameters if they are fixed; `None` if they are estimated.
    pub fixed_global: Option<&'a DVector<f64>>,
    /// Bounds and priors of the estimated global parameters.
    pub constraints: Vec<Constraint>,
    /// Number of threads on which the flights are processed.
    pub threads: usize,
    /// Options, used for progress reports, cancellation and deadline.
    pub options: &'a FitOptions<'a>,
}

impl<'a> OutputError<'a> {
    /// Creates the sum of squared residuals (or of their `loss`) over all samples of the given flights, as a function
    /// of the global parameters and the initial state of each flight.
    pub fn of_all(
        problem: &'a FitProblem,
        flights: impl IntoIterator<Item = &'a Observations>,
        loss: Loss<'a>,
        options: &'a FitOptions<'a>,
    ) -> Self {
        let flights: Vec<&Observations> = flights.into_iter().collect();
        let globals = problem.globals.iter();
        Self {
            problem,
            samples: flights.iter().map(|flight| flight.times.len()).collect(),
            flights,
            loss,
            fixed_global: None,
            constraints: globals.map(|global| global.constraint).collect(),
            threads: options.threads(),
            options,
        }
    }
}

impl LeastSquaresProblem for OutputError<'_> {
    fn flights(&self) -> usize {
        self.flights.len()
    }

    fn linearise(
        &self,
        flight: usize,
        (global, local): (&DVector<f64>, &DVector<f64>),
        by: Unknowns,
    ) -> Result<NormalBlock, FlightError> {
        let (global, by) = match self.fixed_global {
            Some(fixed) => (fixed, Unknowns::Local),
            None => (global, by),
        };
        let (observations, samples) = (self.flights[flight], self.samples[flight]);
        let unknowns = (global, local);
        let block = linearise(self.problem, observations, unknowns, samples, by, self.loss);
        if by == Unknowns::All {
            self.options.flight_done();
        }
        block
    }

    fn plus(&self, flight: usize, local: &DVector<f64>, step: &DVector<f64>) -> DVector<f64> {
        self.flights[flight].manifold.plus(local, step)
    }

    fn constraints(&self) -> &[Constraint] {
        &self.constraints
    }

    fn threads(&self) -> usize {
        self.threads
    }

    fn is_cancelled(&self) -> bool {
        self.options.is_cancelled()
    }

    fn is_past_deadline(&self) -> bool {
        self.options.is_past_deadline()
    }
}
