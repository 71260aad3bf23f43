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

use model_spec::layout::ParamId;
use nalgebra::DVector;
use ode::DifferentiableRhs;

pub(crate) use self::forcings::{Target, linearise_with_terms, targets};
pub(crate) use self::jacobian_columns::JacobianColumns;
pub use self::observed_point::Residuals;
pub use self::squares::squares;
pub(crate) use self::trajectory_pass::TrajectoryPass;
pub use self::trajectory_pass::{residuals, residuals_of, robust_scale, states};
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

/// Normal equations of the first `samples` samples of a flight at the given global and local parameters, with
/// derivatives selected by `unknowns`.
///
/// # Errors
/// [`FlightError::Integration`] if the trajectory cannot be computed.
pub fn linearise(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
    samples: usize,
    unknowns: Unknowns,
    loss: Loss<'_>,
) -> Result<NormalBlock, FlightError> {
    let conditions = problem.body.bind(observations.parameters(problem, global));
    let columns: Vec<ParamId> = match unknowns {
        Unknowns::Local => Vec::new(),
        Unknowns::All => problem.globals.iter().map(|global| global.param).collect(),
    };
    let mut motion = conditions.rhs();
    let by: (&mut dyn DifferentiableRhs, _) = (&mut motion, columns.as_slice());
    let unknowns = (global, local);
    let accuracy = (loss, tolerance_of(problem, loss));
    linearise_within(problem, observations, unknowns, samples, accuracy, by, None)
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

/// [`linearise`] with given equations of motion and indices of model parameters in `by`: derivatives are by the local
/// parameters, followed by these. The first call with a `cache` stores the trajectory in it, and later ones reuse it;
/// only the loss and the outliers may change between calls.
///
/// # Errors
/// [`FlightError::Integration`] if the trajectory cannot be computed.
pub fn linearise_with(
    problem: &FitProblem,
    observations: &Observations,
    unknowns: (&DVector<f64>, &DVector<f64>),
    samples: usize,
    loss: Loss<'_>,
    (motion, parameters): (&mut dyn DifferentiableRhs, &[ParamId]),
    cache: Option<&mut Option<Vec<f64>>>,
) -> Result<NormalBlock, FlightError> {
    // Later calls may weight the trajectory in the cache by less noise.
    let tolerance = match loss {
        Loss::Huber(_) => tolerance_of(problem, loss),
        Loss::Whitened(_) => problem.tolerance * problem.sigma0,
    };
    let (accuracy, by) = ((loss, tolerance), (motion, parameters));
    linearise_within(
        problem,
        observations,
        unknowns,
        samples,
        accuracy,
        by,
        cache,
    )
}

/// [`linearise_with`] within a given tolerance, m.
fn linearise_within(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
    samples: usize,
    (loss, tolerance): (Loss<'_>, f64),
    (motion, parameters): (&mut dyn DifferentiableRhs, &[ParamId]),
    cache: Option<&mut Option<Vec<f64>>>,
) -> Result<NormalBlock, FlightError> {
    let columns = JacobianColumns::new(observations, motion.jacobian_pattern(), parameters);
    let mut rows = WeightedRows::new(columns.accumulator(), &problem.channels, loss);
    let pass = TrajectoryPass {
        problem,
        observations,
        global,
        local,
        samples,
        tolerance: tolerance * observations.tolerance_factor,
        with_outliers: matches!(loss, Loss::Huber(_)),
    };
    pass.each_point(motion, &columns, cache, |point| {
        rows.add(point.channel, point.time, point.rows, point.residual);
    })?;
    let mut block = rows.accumulator.block();
    weighted_rows::add_priors(problem, observations, local, &mut block);
    Ok(block)
}

/// Calls `each` with every residual of a flight, outliers included, sample by sample. Derivatives are by the local
/// parameters, followed by `parameters`.
///
/// # Errors
/// [`FlightError::Integration`] if the trajectory cannot be computed.
pub fn each_residual(
    problem: &FitProblem,
    observations: &Observations,
    (global, local): (&DVector<f64>, &DVector<f64>),
    motion: &mut dyn DifferentiableRhs,
    parameters: &[ParamId],
    each: &mut dyn FnMut(PointResidual<'_>),
) -> Result<(), FlightError> {
    let columns = JacobianColumns::new(observations, motion.jacobian_pattern(), parameters);
    let pass = TrajectoryPass {
        problem,
        observations,
        global,
        local,
        samples: observations.times.len(),
        tolerance: observations.residual_tolerance(problem),
        with_outliers: true,
    };
    pass.each_residual(motion, &columns, None, each)?;
    Ok(())
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
