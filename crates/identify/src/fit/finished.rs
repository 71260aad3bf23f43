//! What a finished fit offers: least squares from given values, the bootstrap over flights, and the text of its model.

use model_spec::compose::ValueError;
use model_spec::layout::Layout;
use model_spec::model::Model;
use nalgebra::DVector;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use super::output_error::OutputError;
use super::{Fit, FitError, solve_error};
use crate::least_squares::{
    Iterate, Solution, SolveError, StoppingCriteria, solve, solve_with_watchdog,
};
use crate::noise::NoiseModel;
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::predict::Loss;
use crate::problem::FitProblem;
use dataset::Dataset;

impl Fit {
    /// Minimises the sum of squared residuals, whitened by `noise`, over the fitted flights, from global parameters (in
    /// the order of [`FitProblem::globals`](crate::FitProblem::globals)) and initial states (in that of the dataset).
    /// Outliers of this fit, which does not change, remain excluded.
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
        options.check_cancelled()?;
        solution.map_err(|error| solve_error(error, &objective.flights))
    }

    /// Refits the model to as many flights as were fitted, drawn from them with replacement, as `seed` and `number`,
    /// the index of the refit, say. It starts at the estimates of this fit and uses its noise model and outliers.
    /// Returns the global parameters, in the order of [`FitProblem::globals`](crate::FitProblem::globals), SI; `None`
    /// if the refit does not converge.
    ///
    /// The scatter over many refits is the error of the estimates if flights differ by more than the noise of their
    /// samples (Efron & Tibshirani, An introduction to the bootstrap, 1993, chapter 6).
    ///
    /// # Errors
    /// [`FitError::Interrupted`] if the work is cancelled.
    pub fn bootstrap(
        &self,
        seed: u64,
        number: u64,
        options: &FitOptions<'_>,
    ) -> Result<Option<DVector<f64>>, FitError> {
        let fitted: Vec<_> = self.fitted().collect();
        let mut random = ChaCha12Rng::seed_from_u64(seed);
        random.set_stream(number);
        let drawn = (0..fitted.len()).map(|_| fitted[random.random_range(0..fitted.len())]);
        let drawn: Vec<_> = drawn.collect();
        let loss = Loss::Whitened(&self.noise);
        let observations = drawn.iter().map(|flight| &flight.observations);
        let objective = OutputError::of_all(&self.problem, observations, loss, options);
        let start = Iterate {
            global: self.global.clone(),
            local: drawn.iter().map(|flight| flight.state.clone()).collect(),
        };
        let solution = solve(&objective, start, StoppingCriteria::CONVERGED).ok();
        options.check_cancelled()?;
        let converged = solution.filter(Solution::converged);
        Ok(converged.map(|solution| solution.iterate.global))
    }

    /// Text of `model` whose default values are the known parameters of the dataset and the estimates; `note`
    /// is appended to its first comment.
    ///
    /// # Errors
    /// [`ValueError`] if the model lacks a parameter of the dataset.
    pub fn fitted_text(
        &self,
        model: &Model,
        dataset: &Dataset,
        note: &str,
    ) -> Result<String, ValueError> {
        let given = dataset.parameters.iter();
        let given = given.map(|(name, value)| (name.as_str(), *value));
        // Estimates that belong to the measurement, such as the vertical, are no parameters of the model.
        let layout = Layout::new(model);
        let found = self.report.coefficients.iter();
        let found = found.filter(|(name, _)| layout.parameter(name).is_some());
        let found = found.map(|(name, coefficient)| (name.as_str(), coefficient.value));
        Ok(model.with_values(given.chain(found))?.to_text(note))
    }
}

/// Minimises the sum of squared residuals of `flights`, whitened by `noise`, from `start`, as [`solve_with_watchdog`].
///
/// # Errors
/// The errors of [`solve`](crate::solve).
pub fn fit_observations(
    problem: &FitProblem,
    flights: &[Observations],
    noise: &NoiseModel,
    start: Iterate,
    (criteria, options): (StoppingCriteria, &FitOptions<'_>),
) -> Result<Solution, SolveError> {
    let options = FitOptions {
        progress: None,
        ..*options
    };
    let objective = OutputError::of_all(problem, flights, Loss::Whitened(noise), &options);
    solve_with_watchdog(&objective, start, criteria)
}
