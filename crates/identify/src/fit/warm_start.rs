//! The least squares alone, from values of one's own: starts, noise and outliers are what they are said to be.

use nalgebra::DVector;

use super::output_error::OutputError;
use super::{Fit, FitError, told};
use crate::dataset::Role;
use crate::least_squares::{Iterate, Solution, StoppingCriteria, solve};
use crate::noise::NoiseModel;
use crate::options::FitOptions;
use crate::predict::Loss;

impl Fit {
    /// Minimises the sum of squares over the flights that were fitted, weighed by this noise, until a step would be
    /// negligible. It begins at these values of the shared unknowns, in the order of [`FitProblem::shared`], and at these
    /// initial states, a flight each, in the dataset's order. Points that the fit had left out as outliers stay out.
    ///
    /// [`FitProblem::shared`]: crate::setting::Setting::shared
    ///
    /// # Errors
    /// [`FitError::Mismatch`] where the values are not as many as the unknowns, else as [`fit`](super::fit).
    pub fn warm_start(
        &self,
        global: &DVector<f64>,
        local: &[DVector<f64>],
        noise: &NoiseModel,
        options: &FitOptions<'_>,
    ) -> Result<Solution, FitError> {
        let fitted = self
            .observation_sets
            .iter()
            .flatten()
            .map(|(observations, _)| observations);
        let fitted = fitted.filter(|observations| observations.role == Role::Fit);
        let objective = OutputError::of_all(&self.problem, fitted, Loss::Whitened(noise), options);
        let states = objective
            .observation_sets
            .iter()
            .map(|observations| observations.manifold.states());
        if global.len() != objective.constraints.len() || !local.iter().map(DVector::len).eq(states)
        {
            let reason = "values to begin from are not as many as the unknowns".to_owned();
            return Err(FitError::Mismatch(reason));
        }
        let start = Iterate {
            global: global.clone(),
            local: local.to_vec(),
        };
        let found = solve(&objective, start, StoppingCriteria::CONVERGED);
        found.map_err(|failure| told(failure, &objective.observation_sets))
    }
}
