//! Predicted observations, residuals, and normal equations with exact sensitivities S of the state: dS/dt = J S + [0 |
//! Jp] is integrated together with the state. Every residual is predicted − measured, m; reports use the opposite sign.

mod forcings;
mod jacobian_columns;
mod observed_point;
mod squares;
mod summary_pass;
mod term_products;
mod term_sums;
mod trajectory_pass;
mod weighted_rows;

use flight::BoundModel;
use model_spec::layout::ParamId;
use nalgebra::DVector;
use ode::DifferentiableRhs;

pub(crate) use self::forcings::{Added, Target, linearise_with_terms, targets};
pub(crate) use self::jacobian_columns::JacobianColumns;
pub use self::observed_point::Residuals;
pub(crate) use self::trajectory_pass::TrajectoryPass;
pub use self::trajectory_pass::robust_scale;
use self::weighted_rows::WeightedRows;
pub(crate) use self::weighted_rows::add_state_priors;
use crate::error::FlightError;
use crate::least_squares::{NormalBlock, Unknowns};
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::problem::{FitProblem, robust_tolerance};

/// Loss function of the residuals.
#[derive(Clone, Copy, Debug)]
pub enum Loss<'a> {
    /// Huber's loss of the magnitude of each residual vector, with this scale, m. Outliers are included.
    Huber(f64),
    /// Sum of squared innovations over their variances under this noise model, without outliers.
    Whitened(&'a NoiseModel),
}

/// A flight at values of its unknowns, from which its observations are predicted.
#[derive(Clone, Copy)]
pub struct FlightAt<'a> {
    /// The estimation problem.
    pub problem: &'a FitProblem,
    /// Samples of the flight.
    pub observations: &'a Observations,
    /// Global parameters, SI.
    pub global: &'a DVector<f64>,
    /// Initial state, SI.
    pub local: &'a DVector<f64>,
    /// Number of samples that are predicted, counted from the first one.
    pub samples: usize,
}

impl<'a> FlightAt<'a> {
    /// All samples of a flight, at global parameters and an initial state.
    pub fn new(
        problem: &'a FitProblem,
        observations: &'a Observations,
        (global, local): (&'a DVector<f64>, &'a DVector<f64>),
    ) -> Self {
        Self {
            problem,
            observations,
            global,
            local,
            samples: observations.times.len(),
        }
    }

    /// The first samples of the flight alone.
    pub fn first(self, samples: usize) -> Self {
        Self { samples, ..self }
    }

    /// The compiled model with the parameters of the flight.
    pub fn bound(self) -> BoundModel<'a> {
        self.observations.bound(self.problem, self.global)
    }

    /// Normal equations of the flight, with derivatives selected by `unknowns`.
    ///
    /// # Errors
    /// [`FlightError::Integration`] if the trajectory cannot be computed.
    pub fn linearise(self, unknowns: Unknowns, loss: Loss<'_>) -> Result<NormalBlock, FlightError> {
        let columns = match unknowns {
            Unknowns::Local => Vec::new(),
            Unknowns::All => self.problem.global_parameters(),
        };
        let accuracy = (loss, tolerance_of(self.problem, loss));
        self.linearise_within(accuracy, (&mut self.bound().rhs(), &columns), None)
    }

    /// [`linearise`](Self::linearise) with given equations of motion and indices of model parameters: derivatives are by
    /// the local parameters, followed by these. The first call with a `cache` stores the trajectory in it, and later ones
    /// reuse it; only the loss and the outliers may change between calls.
    ///
    /// # Errors
    /// [`FlightError::Integration`] if the trajectory cannot be computed.
    pub fn linearise_with(
        self,
        loss: Loss<'_>,
        by: (&mut dyn DifferentiableRhs, &[ParamId]),
        cache: Option<&mut Option<Vec<f64>>>,
    ) -> Result<NormalBlock, FlightError> {
        // Later calls may weight the trajectory in the cache by less noise.
        let tolerance = match loss {
            Loss::Huber(_) => tolerance_of(self.problem, loss),
            Loss::Whitened(_) => self.problem.tolerance * self.problem.sigma0,
        };
        self.linearise_within((loss, tolerance), by, cache)
    }

    /// [`linearise_with`](Self::linearise_with) within a given tolerance, m.
    fn linearise_within(
        self,
        (loss, tolerance): (Loss<'_>, f64),
        (motion, parameters): (&mut dyn DifferentiableRhs, &[ParamId]),
        cache: Option<&mut Option<Vec<f64>>>,
    ) -> Result<NormalBlock, FlightError> {
        let columns = JacobianColumns::new(self.observations, motion, parameters);
        let mut rows = WeightedRows::new(columns.accumulator(), &self.problem.channels, loss);
        let pass = TrajectoryPass {
            at: self,
            tolerance: tolerance * self.observations.tolerance_factor,
            with_outliers: matches!(loss, Loss::Huber(_)),
        };
        pass.each_point(motion, &columns, cache, |point| {
            rows.add(point.channel, point.time, point.rows, point.residual);
        })?;
        let mut block = rows.accumulator.block();
        weighted_rows::add_priors(self, &mut block);
        Ok(block)
    }

    /// Calls `each` with every residual of the flight, outliers included, sample by sample. Derivatives are by the local
    /// parameters, followed by `parameters`.
    ///
    /// # Errors
    /// [`FlightError::Integration`] if the trajectory cannot be computed.
    pub fn each_residual(
        self,
        parameters: &[ParamId],
        each: &mut dyn FnMut(PointResidual<'_>),
    ) -> Result<(), FlightError> {
        self.each_residual_with((&mut self.bound().rhs(), parameters), each)
    }

    /// [`each_residual`](Self::each_residual) with given equations of motion.
    ///
    /// # Errors
    /// [`FlightError::Integration`] if the trajectory cannot be computed.
    pub fn each_residual_with(
        self,
        (motion, parameters): (&mut dyn DifferentiableRhs, &[ParamId]),
        each: &mut dyn FnMut(PointResidual<'_>),
    ) -> Result<(), FlightError> {
        let columns = JacobianColumns::new(self.observations, motion, parameters);
        let pass = TrajectoryPass {
            at: self,
            tolerance: self.observations.residual_tolerance(self.problem),
            with_outliers: true,
        };
        pass.each_residual(motion, &columns, None, each)?;
        Ok(())
    }
}

/// Tolerance, m, of the integration for residuals under `loss`. Residuals far above the initial noise, of a model that does
/// not describe the flights, are divided by as large deviations, and need no more accuracy than these.
fn tolerance_of(problem: &FitProblem, loss: Loss<'_>) -> f64 {
    match loss {
        Loss::Huber(scale) => robust_tolerance(scale, problem.sigma0),
        Loss::Whitened(noise) => {
            let least = noise.least_innovation();
            let is_misfit = problem.is_misfit(least);
            problem.tolerance * if is_misfit { least } else { problem.sigma0 }
        }
    }
}

/// Residual of one channel in one sample, with its derivatives.
#[derive(Clone, Copy, Debug)]
pub struct PointResidual<'r> {
    /// Index of the measurement channel in `FitProblem::channels`.
    pub channel: usize,
    /// Index of the sample.
    pub sample: usize,
    /// (Predicted − measured) × scale of the channel along each axis, m. A scalar is repeated three times.
    pub residual: [f64; 3],
    /// Derivatives of the residual, one row per axis: by the local parameters, then by the selected ones.
    pub rows: &'r [Vec<f64>; 3],
}
