//! All flights as the unknowns of the moment have them: flown once, and looked at as often as is needed.

use flight::batch;
use nalgebra::DVector;

use super::{FitError, State};
use crate::noise::{median, robust_sigma};
use crate::options::Options;
use crate::predict::{Residuals, residuals, residuals_of, states};
use crate::setting::Setting;
use crate::track::Track;

/// Every flight, flown.
pub struct Flown(Vec<One>);

/// One flight, flown.
struct One {
    /// The states at its first samples, sample after sample; in words why it is impossible.
    states: Result<Vec<f64>, String>,
    /// The usual size of its residuals, m; none where it is impossible or nothing was seen.
    size: Option<f64>,
}

impl Flown {
    /// Flies the first samples of all flights.
    pub fn new(setting: &Setting, state: &State, samples: &[usize], options: &Options<'_>) -> Self {
        let count = state.tracks.len();
        Self(batch::each_on(options.threads(), count, |flight| {
            let (track, shared) = (&state.tracks[flight], &state.shared);
            let states = states(
                setting,
                track,
                (shared, &state.own[flight]),
                samples[flight],
            );
            let residuals = states
                .as_ref()
                .map(|states| residuals_of(setting, track, shared, states));
            let size = residuals.ok().and_then(|residuals| usual(&residuals));
            One { states, size }
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

    /// The states of a flight at its samples, sample after sample.
    ///
    /// # Errors
    /// Where it is impossible.
    pub fn states(&self, state: &State, flight: usize) -> Result<&[f64], FitError> {
        let states = self.0[flight].states.as_deref();
        states.map_err(|reason| FitError::Flight {
            file: state.tracks[flight].file.clone(),
            reason: reason.clone(),
        })
    }

    /// The residuals of a flight.
    ///
    /// # Errors
    /// Where it is impossible.
    pub fn residuals(
        &self,
        setting: &Setting,
        state: &State,
        flight: usize,
    ) -> Result<Residuals, FitError> {
        let states = self.states(state, flight)?;
        let track = &state.tracks[flight];
        Ok(residuals_of(setting, track, &state.shared, states))
    }
}

/// The usual size of one flight's residuals, m; none where it cannot be flown.
pub fn size(
    setting: &Setting,
    track: &Track,
    unknowns: (&DVector<f64>, &DVector<f64>),
    samples: usize,
) -> Option<f64> {
    usual(&residuals(setting, track, unknowns, samples).ok()?)
}

/// The usual size of residuals, m; none where there are none.
fn usual(residuals: &Residuals) -> Option<f64> {
    let all = residuals.iter().flatten().flatten().flatten();
    let mut sizes: Vec<f64> = all.map(|residual| residual.abs()).collect();
    (!sizes.is_empty()).then(|| robust_sigma(&mut sizes))
}
