//! All flights as the unknowns of the moment have them: flown once, and looked at as often as is needed.

use flight::batch;
use nalgebra::DVector;

use super::{FitError, State};
use crate::noise::{median, robust_sigma};
use crate::observations::Observations;
use crate::options::FitOptions;
use crate::predict::{Residuals, residuals, residuals_of, states};
use crate::problem::FitProblem;

/// Every flight, flown.
pub struct ResidualCache(Vec<One>);

/// One flight, flown.
struct One {
    /// What was flown; in words why it is impossible.
    path: Result<Path, String>,
    /// The usual size of its residuals, m; none where it is impossible or nothing was seen.
    size: Option<f64>,
}

/// Where a flight went.
pub struct Path {
    /// The states at its first samples, sample after sample.
    pub states: Vec<f64>,
    /// Predicted less measured there.
    pub residuals: Residuals,
}

impl ResidualCache {
    /// Flies the first samples of all flights.
    pub fn new(
        problem: &FitProblem,
        state: &State,
        samples: &[usize],
        options: &FitOptions<'_>,
    ) -> Self {
        let count = state.observation_sets.len();
        Self(batch::each_on(options.threads(), count, |flight| {
            let (observations, global) = (&state.observation_sets[flight], &state.global);
            let unknowns = (global, &state.local[flight]);
            let path =
                states(problem, observations, unknowns, samples[flight]).map(|states| Path {
                    residuals: residuals_of(problem, observations, global, &states),
                    states,
                });
            let size = path.as_ref().ok().and_then(|path| usual(&path.residuals));
            One { path, size }
        }))
    }

    /// The usual size of the residuals of each flight, m; none where it is impossible or nothing was seen.
    pub fn sizes(&self) -> Vec<Option<f64>> {
        self.0.iter().map(|one| one.size).collect()
    }

    /// The usual size over the flights, m; 0 where there is none.
    pub fn usual(&self) -> f64 {
        let mut sizes: Vec<f64> = self.0.iter().filter_map(|one| one.size).collect();
        median(&mut sizes)
    }

    /// Where a flight of these tracks went.
    ///
    /// # Errors
    /// Where it is impossible.
    pub fn path(
        &self,
        observation_sets: &[Observations],
        flight: usize,
    ) -> Result<&Path, FitError> {
        let path = self.0[flight].path.as_ref();
        path.map_err(|reason| FitError::Flight {
            file: observation_sets[flight].file.clone(),
            reason: reason.clone(),
        })
    }
}

/// The usual size of one flight's residuals, m; none where it cannot be flown.
pub fn size(
    problem: &FitProblem,
    observations: &Observations,
    unknowns: (&DVector<f64>, &DVector<f64>),
    samples: usize,
) -> Option<f64> {
    usual(&residuals(problem, observations, unknowns, samples).ok()?)
}

/// The usual size of residuals, m; none where there are none.
fn usual(residuals: &Residuals) -> Option<f64> {
    let all = residuals.iter().flatten().flatten().flatten();
    let mut sizes = Vec::with_capacity(3 * residuals.iter().map(Vec::len).sum::<usize>());
    sizes.extend(all.map(|residual| residual.abs()));
    (!sizes.is_empty()).then(|| robust_sigma(&mut sizes))
}
