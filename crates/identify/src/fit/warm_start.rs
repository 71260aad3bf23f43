//! Least squares from given initial values of the unknowns, with a given noise model and the outliers of an earlier
//! fit.

use nalgebra::DVector;

use super::output_error::OutputError;
use super::{Fit, FitError, solve_error};
use crate::least_squares::{Iterate, Solution, StoppingCriteria, solve};
use crate::noise::NoiseModel;
use crate::options::FitOptions;
use crate::predict::Loss;

impl Fit {
    /// Minimises the sum of squared residuals, whitened by `noise`, over the fitted flights, starting from the given
    /// global parameters (in the order of [`FitProblem::globals`]) and initial states of the fitted flights (in the
    /// order of the dataset). Outliers of this fit remain excluded. Returns the least-squares solution; `self` does not
    /// change.
    ///
    /// [`FitProblem::globals`]: crate::FitProblem::globals
    ///
    /// # Errors
    /// [`FitError::WarmStartSize`] if the numbers of values and unknowns differ; [`FitError::Flight`] if a flight
    /// cannot be predicted from the values; [`FitError::Interrupted`] if the work is cancelled.
    pub fn warm_start(
        &self,
        global: &DVector<f64>,
        local: &[DVector<f64>],
        noise: &NoiseModel,
        options: &FitOptions<'_>,
    ) -> Result<Solution, FitError> {
        let fitted = self.fitted().map(|flight| &flight.observations);
        let objective = OutputError::of_all(&self.problem, fitted, Loss::Whitened(noise), options);
        let flights = objective.flights.iter();
        let states: Vec<usize> = flights.map(|flight| flight.manifold.states()).collect();
        let globals = objective.constraints.len();
        if global.len() != globals || !local.iter().map(DVector::len).eq(states.iter().copied()) {
            return Err(FitError::WarmStartSize { globals, states });
        }
        let start = Iterate {
            global: global.clone(),
            local: local.to_vec(),
        };
        let solution = solve(&objective, start, StoppingCriteria::CONVERGED);
        solution.map_err(|error| solve_error(error, &objective.flights))
    }
}
