//! How fast the bodies spin where the samples are too far apart to tell: all flights are fitted by the least spin, and by
//! a whole turn more or less between samples, and the fit that meets them best is taken.

use super::horizon_continuation::continue_horizon;
use super::initial_guess::{InitialGuesses, spin_note};
use super::residual_cache::ResidualCache;
use super::{FitError, State};
use crate::options::FitOptions;
use crate::problem::FitProblem;

/// Whole turns that are tried, the likeliest first.
const TURNS: [i32; 3] = [0, -1, 1];

/// A less likely spin is taken where its residuals are smaller than this part of those of a likelier one.
const CLEARLY: f64 = 0.9;

/// Fits all flights over a growing horizon, from the starts that lead to the smallest residuals.
///
/// # Errors
/// As [`grow`].
pub fn resolve_spin_aliases(
    problem: &FitProblem,
    begun: InitialGuesses,
    options: &FitOptions<'_>,
) -> Result<(State, ResidualCache), FitError> {
    let InitialGuesses {
        state,
        alternatives,
        ..
    } = begun;
    let has = |turns: i32| {
        alternatives
            .iter()
            .flatten()
            .any(|start| start.turns == turns)
    };
    let hypotheses: Vec<i32> = TURNS.into_iter().filter(|&turns| has(turns)).collect();
    if hypotheses.is_empty() || hypotheses == [0] {
        let mut state = state;
        let cache = continue_horizon(problem, &mut state, options)?;
        return Ok((state, cache));
    }
    let mut best: Option<(f64, State, ResidualCache)> = None;
    let mut failed = None;
    for turns in hypotheses {
        let mut tried = state.clone();
        for (index, starts) in alternatives.iter().enumerate() {
            if let Some(start) = starts
                .iter()
                .find(|start| start.turns == turns && turns != 0)
            {
                tried.local[index].clone_from(&start.state);
                tried.observation_sets[index].notes.push(spin_note(turns));
            }
        }
        let cache = match continue_horizon(problem, &mut tried, options) {
            Ok(cache) => cache,
            Err(FitError::Interrupted) => return Err(FitError::Interrupted),
            Err(error) => {
                failed = failed.or(Some(error));
                continue;
            }
        };
        let left = left(&cache);
        if best
            .as_ref()
            .is_none_or(|(least, ..)| left < CLEARLY * least)
        {
            best = Some((left, tried, cache));
        }
    }
    match (best, failed) {
        (Some((_, state, cache)), _) => Ok((state, cache)),
        (None, failed) => Err(failed.unwrap_or(FitError::Interrupted)),
    }
}

/// Root of the mean squared size of the flights' residuals, m.
fn left(cache: &ResidualCache) -> f64 {
    let sizes = cache.sizes();
    let all = sizes.iter().map(|size| size.unwrap_or(f64::INFINITY));
    let squares: f64 = all.map(|size| size * size).sum();
    (squares / sizes.len().max(1) as f64).sqrt()
}
