//! Fits of the initial state of one flight at fixed global parameters.

use nalgebra::DVector;

use super::output_error::OutputError;
use super::residual_cache::robust_scale;
use super::state::State;
use crate::error::FlightError;
use crate::least_squares::{Iterate, Solution, SolveError, StoppingCriteria, solve};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::predict::{Loss, residuals};
use crate::problem::FitProblem;

/// Maximum number of fits of one flight with a robust loss whose scale decreases from fit to fit.
pub const MAX_SCALES: usize = 8;

/// Maximum ratio of the next scale of the robust loss to the present one. If the ratio is greater, the fit is not
/// repeated with the next scale.
pub const MAX_SHRINKAGE: f64 = 0.7;

/// Global parameters held at fixed values, so that the initial state of each flight can be fitted separately.
#[derive(Clone, Copy)]
pub struct FixedGlobal<'a> {
    /// Estimation problem with the model, the channels and the parameters.
    pub problem: &'a FitProblem,
    /// Values of the global parameters, SI.
    pub global: &'a DVector<f64>,
    /// Options of the fit.
    pub options: &'a FitOptions<'a>,
}

impl State<'_> {
    /// The present values of the global parameters, held fixed so that the initial states of single flights can be
    /// fitted.
    pub fn fixed_global(&self) -> FixedGlobal<'_> {
        FixedGlobal {
            problem: self.problem,
            global: &self.global,
            options: self.options,
        }
    }
}

impl FixedGlobal<'_> {
    /// Fits the initial state of one flight to its first `samples` samples, from the initial guess `start`. Returns the
    /// minimum of the robust loss with scale `sigma0`, and the initial state.
    ///
    /// # Errors
    /// [`FlightError::SingularInitialState`] if the samples do not determine the initial state;
    /// [`FlightError::Integration`] if the trajectory cannot be computed.
    pub fn fit_initial_state(
        self,
        observations: &Observations,
        samples: usize,
        start: DVector<f64>,
    ) -> Result<(f64, DVector<f64>), FlightError> {
        let sigma0 = self.problem.sigma0;
        let solve = |local: DVector<f64>, scale: f64, criteria: StoppingCriteria| {
            self.solve(observations, samples, local, Loss::Huber(scale), criteria)
        };
        let (mut local, mut scale) = (start, f64::INFINITY);
        for _ in 0..MAX_SCALES {
            let next = self.residual_scale(observations, &local, samples);
            let next = next.unwrap_or(1.0).max(sigma0);
            // The last fit uses the scale sigma0.
            if next > MAX_SHRINKAGE * scale || MAX_SHRINKAGE * next < sigma0 {
                break;
            }
            scale = next;
            local = solve(local, scale, StoppingCriteria::HORIZON)?.0;
        }
        let (local, solution) = solve(local, sigma0, StoppingCriteria::COARSE)?;
        if !solution.blocks[0].determines_local() {
            return Err(FlightError::SingularInitialState);
        }
        Ok((solution.squares, local))
    }

    /// Fits the initial state of one flight to its first `samples` samples under the loss function `loss`, from the
    /// initial guess `local`. Returns the fitted initial state and the least-squares solution.
    ///
    /// # Errors
    /// The errors of [`fit_initial_state`](Self::fit_initial_state).
    pub fn solve(
        self,
        observations: &Observations,
        samples: usize,
        local: DVector<f64>,
        loss: Loss<'_>,
        criteria: StoppingCriteria,
    ) -> Result<(DVector<f64>, Solution), FlightError> {
        let objective = OutputError {
            samples: vec![samples],
            fixed_global: Some(self.global),
            constraints: Vec::new(),
            threads: 1,
            ..OutputError::of_all(self.problem, [observations], loss, self.options)
        };
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
            SolveError::Cancelled => FlightError::Interrupted,
        })?;
        Ok((solution.iterate.local[0].clone(), solution))
    }

    /// Robust standard deviation of one flight's residuals over its first `samples` samples, m, if `local` is its
    /// initial state; `None` if the flight cannot be integrated or has no residuals.
    pub fn residual_scale(
        self,
        observations: &Observations,
        local: &DVector<f64>,
        samples: usize,
    ) -> Option<f64> {
        let unknowns = (self.global, local);
        robust_scale(&residuals(self.problem, observations, unknowns, samples).ok()?)
    }
}
