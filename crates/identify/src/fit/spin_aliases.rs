//! Aliasing of the spin. If samples are far apart, all flights are fitted with the slowest spin compatible with the
//! samples and with one turn per sampling interval more or less; the fit with the smallest residuals is used.

use super::FitError;
use super::horizon_continuation::{anneal_scale, continue_horizon};
use super::initial_guess::spin_note;
use super::residual_cache::ResidualCache;
use super::state::State;
use crate::initial_state::InitialGuess;
use dataset::statistics::median_of;

/// Numbers of turns per sampling interval that are added to the slowest spin compatible with the samples, in order of
/// decreasing probability.
const ALIASES: [i32; 3] = [0, -1, 1];

/// Maximum ratio of the residual scale of a fit to that of the best fit so far, for the new fit to be preferred. Each
/// fit assumes another spin alias (number of additional turns between samples). The residual scale of a fit is the
/// median over the flights of the robust standard deviations of their residuals.
const ACCEPTED_RATIO: f64 = 0.9;

/// Decrease of the deviance, −2 ln of the likelihood, at which another spin is preferred although the residual scales
/// are alike: odds of 150 to 1 against the slower spin.
const MIN_DEVIANCE: f64 = 10.0;

/// Greatest residual scale, in units of the initial noise estimate, at which the likelihood decides between spins:
/// residuals of a model that does not describe the flights are no noise.
const MAX_SCALE: f64 = 2.0;

/// Fits all flights by horizon continuation once for each spin alias (number of additional turns between samples), and
/// returns the fit with the smallest residuals.
///
/// # Errors
/// The errors of [`continue_horizon`], if it fails for every alias.
pub fn resolve_spin_aliases<'a>(
    mut state: State<'a>,
    alternatives: &[Vec<InitialGuess>],
) -> Result<(State<'a>, ResidualCache), FitError> {
    let guesses = || alternatives.iter().flatten();
    let exists = |alias: &i32| guesses().any(|guess| guess.turns == *alias);
    let aliases: Vec<i32> = ALIASES.into_iter().filter(exists).collect();
    if aliases.is_empty() || aliases == [0] {
        let cache = continue_horizon(&mut state)?;
        return Ok((state, cache));
    }
    let mut best: Option<(f64, State<'_>, ResidualCache)> = None;
    let (mut failure, mut is_doubtful) = (None, false);
    for alias in aliases {
        let mut tried = with_alias(&state, alternatives, alias);
        let cache = match converged(&mut tried) {
            Ok(cache) => cache,
            Err(FitError::Interrupted) => return Err(FitError::Interrupted),
            Err(error) => {
                failure.get_or_insert(error);
                continue;
            }
        };
        let scale = median_scale(&cache, tried.excluded.len() - state.excluded.len());
        let is_better = best.as_ref().is_none_or(|(least, _, before)| {
            scale < ACCEPTED_RATIO * least
                || (ACCEPTED_RATIO * scale < *least
                    && *least < MAX_SCALE * state.problem.sigma0
                    && is_likelier(&cache, before, *least))
        });
        // Another spin that fits as well, or one that fits as badly, at residuals that are noise.
        if let Some((least, other, before)) = &best
            && is_another(&tried, other)
            && (ACCEPTED_RATIO * scale..scale / ACCEPTED_RATIO).contains(least)
            && scale < MAX_SCALE * state.problem.sigma0
        {
            let is_alike =
                !is_likelier(&cache, before, *least) && !is_likelier(before, &cache, *least);
            is_doubtful = is_alike || is_doubtful && !is_better;
        } else {
            is_doubtful &= !is_better;
        }
        if is_better {
            best = Some((scale, tried, cache));
        }
    }
    match best {
        Some((_, mut state, cache)) => {
            state.doubts.extend(is_doubtful.then(|| {
                "the spin is not determined: with a turn more or less per sampling interval the flights fit as well".to_owned()
            }));
            Ok((state, cache))
        }
        None => Err(failure.unwrap_or(FitError::Interrupted)),
    }
}

/// Fits all flights by horizon continuation, which ends after one step that reaches the noise, and from there to the
/// minimum: likelihoods are compared at minima.
///
/// # Errors
/// The errors of [`continue_horizon`].
fn converged(state: &mut State<'_>) -> Result<ResidualCache, FitError> {
    let cache = continue_horizon(state)?;
    match cache.median_scale() < MAX_SCALE * state.problem.sigma0 {
        true => anneal_scale(state),
        false => Ok(cache),
    }
}

/// Least relative difference of the initial states of a flight in which two fits count as different: a turn more per
/// sampling interval is most of a state.
const ANOTHER: f64 = 0.1;

/// Whether a flight has another initial state in another fit: with a gyroscope both may arrive at the same spin.
fn is_another(one: &State<'_>, other: &State<'_>) -> bool {
    let mut pairs = one.local.iter().zip(&other.local);
    one.local.len() == other.local.len()
        && pairs.any(|(one, other)| (one - other).norm() > ANOTHER * other.norm())
}

/// Whether the residuals `new` are likelier than `before` by [`MIN_DEVIANCE`], for noise of unknown size; `scale` is the
/// residual scale, m.
fn is_likelier(new: &ResidualCache, before: &ResidualCache, scale: f64) -> bool {
    let [(new, count), (before, other)] = [new, before].map(|cache| cache.clipped_squares(scale));
    count >= other && count as f64 * (before / new).ln() > MIN_DEVIANCE
}

/// Copy of a fit in progress in which the initial state of each flight is its initial guess with `alias` additional
/// turns per sampling interval. Flights without such a guess retain their initial state, as do all flights if `alias`
/// is 0.
fn with_alias<'a>(state: &State<'a>, alternatives: &[Vec<InitialGuess>], alias: i32) -> State<'a> {
    let mut state = state.clone();
    for (index, guesses) in alternatives.iter().enumerate() {
        let mut guesses = guesses.iter();
        let guess = guesses.find(|guess| guess.turns == alias && alias != 0);
        if let Some(guess) = guess {
            state.local[index].clone_from(&guess.state);
            state.flights[index].notes.push(spin_note(alias));
        }
    }
    state
}

/// Median over the flights of their residual scales, m. The scale of a flight that cannot be integrated counts as
/// infinite, as do those of the flights that were excluded, whose number is `excluded`. The median is used because
/// single flights may still be in a wrong minimum.
fn median_scale(cache: &ResidualCache, excluded: usize) -> f64 {
    let scales = cache.scales().into_iter();
    let flown = scales.map(|scale| scale.unwrap_or(f64::INFINITY));
    let without = std::iter::repeat_n(f64::INFINITY, excluded);
    median_of(flown.chain(without)).unwrap_or(0.0)
}
