//! Fits of the initial state of one flight at fixed global parameters.

use nalgebra::DVector;

use super::output_error::OutputError;
use super::residual_cache::residual_scale;
use crate::error::FlightError;
use crate::least_squares::{Iterate, Solution, SolveError, StoppingCriteria, solve};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::predict::Loss;
use crate::problem::FitProblem;

/// Maximum number of decreasing scales of the robust loss with which a fit is repeated.
pub const MAX_SCALES: usize = 8;

/// Maximum ratio of the next scale of the robust loss to the present one for the fit to be repeated with the next
/// scale.
pub const MAX_SHRINKAGE: f64 = 0.7;

/// Fits the initial state of one flight to its first `samples` samples at fixed global parameters. Returns the minimum
/// of the robust loss with scale `sigma0`, and the initial state.
///
/// # Errors
/// [`FlightError::SingularInitialState`] if the samples do not determine the initial state;
/// [`FlightError::Integration`] if the trajectory cannot be computed.
pub fn fit_initial_state(
    problem: &FitProblem,
    observations: &Observations,
    samples: usize,
    global: &DVector<f64>,
    start: DVector<f64>,
    options: &FitOptions<'_>,
) -> Result<(f64, DVector<f64>), FlightError> {
    let solve = |local: DVector<f64>, scale: f64, criteria: StoppingCriteria| {
        let by = (Loss::Huber(scale), criteria);
        solve_local(problem, observations, samples, global, local, by, options)
    };
    let (mut local, mut scale) = (start, f64::INFINITY);
    for _ in 0..MAX_SCALES {
        let next = residual_scale(problem, observations, (global, &local), samples);
        let next = next.unwrap_or(1.0).max(problem.sigma0);
        // The last fit uses the scale sigma0.
        if next > MAX_SHRINKAGE * scale || MAX_SHRINKAGE * next < problem.sigma0 {
            break;
        }
        scale = next;
        local = solve(local, scale, StoppingCriteria::HORIZON)?.0;
    }
    let (local, solution) = solve(local, problem.sigma0, StoppingCriteria::COARSE)?;
    if !solution.blocks[0].determines_local() {
        return Err(FlightError::SingularInitialState);
    }
    Ok((solution.squares, local))
}

/// Fits the initial state of one flight to its first `samples` samples under the given loss, until the given termination
/// criteria are met. Returns the initial state and the least-squares solution.
///
/// # Errors
/// The errors of [`fit_initial_state`].
pub fn solve_local(
    problem: &FitProblem,
    observations: &Observations,
    samples: usize,
    global: &DVector<f64>,
    local: DVector<f64>,
    (loss, criteria): (Loss<'_>, StoppingCriteria),
    options: &FitOptions<'_>,
) -> Result<(DVector<f64>, Solution), FlightError> {
    let objective = OutputError::of_local(problem, observations, samples, loss, global, options);
    let start = Iterate {
        global: DVector::zeros(0),
        local: vec![local],
    };
    let solution = solve(&objective, start, criteria);
    let solution = solution.map_err(|error| match error {
        SolveError::Start(failures) => {
            let first = failures.into_iter().next();
            first.map_or(FlightError::NoMatchingState, |(_, reason)| reason)
        }
        SolveError::Undetermined(_) => FlightError::SingularInitialState,
        SolveError::Cancelled => FlightError::Interrupted,
    })?;
    Ok((solution.iterate.local[0].clone(), solution))
}
