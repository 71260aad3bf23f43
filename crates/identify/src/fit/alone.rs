//! The least squares alone, from values of one's own: starts, noise and outliers are what they are said to be.

use nalgebra::DVector;

use super::problem::Squares;
use super::{FitError, Fitted, told};
use crate::dataset::Role;
use crate::levenberg::{Point, Solution, Until, solve};
use crate::noise::Noise;
use crate::options::Options;
use crate::predict::Loss;

impl Fitted {
    /// Minimises the sum of squares over the flights that were fitted, weighed by this noise, until a step would be
    /// negligible. It begins at these values of the shared unknowns, in the order of [`Setting::shared`], and at these
    /// initial states, a flight each, in the dataset's order. Points that the fit had left out as outliers stay out.
    ///
    /// [`Setting::shared`]: crate::setting::Setting::shared
    ///
    /// # Errors
    /// [`FitError::Mismatch`] where the values are not as many as the unknowns, else as [`fit`](super::fit).
    pub fn solve_from(
        &self,
        shared: &DVector<f64>,
        own: &[DVector<f64>],
        noise: &Noise,
        options: &Options<'_>,
    ) -> Result<Solution, FitError> {
        let fitted = self.tracks.iter().flatten().map(|(track, _)| track);
        let fitted = fitted.filter(|track| track.role == Role::Fit);
        let problem = Squares::of_all(&self.setting, fitted, Loss::Whitened(noise), options);
        let states = problem.tracks.iter().map(|track| track.chart.states());
        if shared.len() != problem.known.len() || !own.iter().map(DVector::len).eq(states) {
            let reason = "values to begin from are not as many as the unknowns".to_owned();
            return Err(FitError::Mismatch(reason));
        }
        let start = Point {
            shared: shared.clone(),
            own: own.to_vec(),
        };
        let found = solve(&problem, start, Until::DONE);
        found.map_err(|failure| told(failure, &problem.tracks))
    }
}
