//! The bootstrap over flights: refits to samples of flights drawn with replacement.

use nalgebra::DVector;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use super::output_error::OutputError;
use super::{Fit, FitError, solve_error};
use crate::least_squares::{Iterate, StoppingCriteria, solve};
use crate::options::FitOptions;
use crate::predict::Loss;

impl Fit {
    /// Refits the model to a bootstrap sample: as many flights as were fitted, drawn from them with replacement. The
    /// sample depends only on `seed` and on `number`, the index of the refit. The refit starts at the estimates of this
    /// fit and uses its noise model and outliers. Returns the estimated global parameters in the order of
    /// [`FitProblem::globals`], SI; `None` if the refit does not converge, for example because the drawn flights do not
    /// determine a parameter.
    ///
    /// The scatter of the estimates over many refits is their error if flights differ by more than the noise of their
    /// samples (Efron & Tibshirani, An introduction to the bootstrap, 1993, chapter 6).
    ///
    /// [`FitProblem::globals`]: crate::FitProblem::globals
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
        match solve(&objective, start, StoppingCriteria::CONVERGED) {
            Ok(solution) => Ok(solution.converged().then_some(solution.iterate.global)),
            Err(error) => match solve_error(error, &objective.flights) {
                FitError::Interrupted => Err(FitError::Interrupted),
                _ => Ok(None),
            },
        }
    }
}
