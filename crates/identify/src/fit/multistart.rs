//! Multistart: detects flights that converged to a wrong minimum and fits them again from other initial guesses.

use flight::parallel;
use nalgebra::DVector;

use super::FitError;
use super::horizon_continuation::anneal_scale;
use super::initial_guess::{first_segment, spin_note};
use super::one_flight::FixedGlobal;
use super::residual_cache::ResidualCache;
use super::state::State;
use super::undistorted;
use crate::observations::Observations;
use dataset::statistics::median;

/// When a flight is fitted again, and when the new fit is accepted.
struct Limits {
    /// Ratio of the flight's residual scale to a reference value, which is usually the median over the flights, above
    /// which the flight is fitted again.
    suspect: f64,
    /// Number of standard errors by which the residual scale must exceed the reference value too.
    errors: f64,
    /// Maximum ratio of the new residual scale of a flight to the old one, for the new initial state to be accepted.
    accepted: f64,
}

/// Limits for flights with measured positions.
const SEEN: Limits = Limits {
    suspect: 3.0,
    errors: 0.0,
    accepted: 0.7,
};

/// Limits for flights without measured positions, whose initial attitude is guessed: a wrong minimum may be nearly as
/// good.
const BLIND: Limits = Limits {
    suspect: 1.2,
    errors: 6.0,
    accepted: 0.95,
};

impl Limits {
    fn of(state: &State<'_>) -> Limits {
        match state.problem.sees_positions() {
            true => SEEN,
            false => BLIND,
        }
    }
}

/// Median over the flights of their residual scales, in units of the initial noise estimate `sigma0`, above which the
/// model or most initial guesses are wrong. The residual scale of a flight is then compared with `sigma0` instead of
/// this median.
const MISFIT_RATIO: f64 = 10.0;

/// Refits flights whose residual scale is far above that of the other flights and of the noise. If a refit improves a
/// flight, all flights are fitted again together. `cache` contains the residuals for the present values of the unknowns
/// in `state`. Returns the residuals for the new values.
///
/// # Errors
/// The errors of [`anneal_scale`].
pub fn multistart(state: &mut State<'_>, cache: ResidualCache) -> Result<ResidualCache, FitError> {
    let options = state.options;
    let scales = cache.scales().into_iter();
    let scales: Vec<f64> = scales.map(|s| s.unwrap_or(f64::INFINITY)).collect();
    let usual = reference_scale(&scales, state.problem.sigma0);
    let limits = Limits::of(state);
    let is_suspect =
        |flight: &usize| cache.stands_out(*flight, usual, limits.suspect, limits.errors);
    let suspects: Vec<usize> = (0..scales.len()).filter(is_suspect).collect();
    if suspects.is_empty() || options.is_past_deadline() {
        return Ok(cache);
    }
    options.stage_started("flights that stand out", suspects.len());
    let found = parallel::each_on(options.threads(), suspects.len(), |index| {
        let flight = suspects[index];
        let found = restart(state, flight, scales[flight]);
        options.flight_done();
        found
    });
    if options.is_cancelled() {
        return Err(FitError::Interrupted);
    }
    let mut has_improved = false;
    for (&flight, found) in suspects.iter().zip(found) {
        if let Some((local, note)) = found {
            state.local[flight] = local;
            state.flights[flight].notes.push(note);
            has_improved = true;
        }
    }
    match has_improved {
        true => anneal_scale(state),
        false => Ok(cache),
    }
}

/// Reference value, m, with which the residual scale of each flight is compared. It is the median of all flights'
/// `scales`, or `sigma0` if the median is below `sigma0` or more than `MISFIT_RATIO` × `sigma0`.
fn reference_scale(scales: &[f64], sigma0: f64) -> f64 {
    let median = median(&mut scales.to_vec());
    match median > MISFIT_RATIO * sigma0 {
        true => sigma0,
        false => median.max(sigma0),
    }
}

/// Better initial state of a flight at the present global parameters, with a note for the report; `None` if no initial
/// guess leads to a residual scale clearly below `before`, m. `flight` is an index among the fitted flights.
fn restart(state: &State<'_>, flight: usize, before: f64) -> Option<(DVector<f64>, String)> {
    let best = fly_to_the_end(state.fixed_global(), &state.flights[flight]);
    let accepted = Limits::of(state).accepted;
    let (scale, local, turns) = best.filter(|(scale, ..)| *scale < accepted * before)?;
    let mut note = format!(
        "its first fit had ended in a wrong minimum (residuals of {:.1} mm, now {:.1} mm); it was started anew",
        1e3 * before,
        1e3 * scale
    );
    if turns != 0 {
        note = format!("{note}; {}", spin_note(turns));
    }
    Some((local, note))
}

/// Fits the initial state of one flight, once from each of its initial guesses. Each fit starts with a short initial
/// segment of the flight, which is extended step by step to the whole flight. Returns the fit with the smallest
/// residual scale: this scale (m), the initial state, and the number of additional turns per sampling interval. `None`
/// if every fit fails.
pub fn fly_to_the_end(
    at: FixedGlobal<'_>,
    observations: &Observations,
) -> Option<(f64, DVector<f64>, i32)> {
    let samples = observations.times.len();
    let mut best: Option<(f64, DVector<f64>, i32)> = None;
    for guess in undistorted::initial_guesses(at, observations).ok()? {
        let Some(local) = continue_horizon(at, observations, guess.state) else {
            continue;
        };
        let Some(scale) = at.residual_scale(observations, &local, samples) else {
            continue;
        };
        if best.as_ref().is_none_or(|(least, ..)| scale < *least) {
            best = Some((scale, local, guess.turns));
        }
    }
    best
}

/// Fits the initial state of one flight to a short initial segment of the flight, whose number of samples is then
/// doubled for each further fit, up to the whole flight. Returns the initial state fitted to the whole flight; `None`
/// if a fit fails.
fn continue_horizon(
    at: FixedGlobal<'_>,
    observations: &Observations,
    start: DVector<f64>,
) -> Option<DVector<f64>> {
    let all = observations.times.len();
    let mut samples = first_segment(observations);
    let mut local = start;
    loop {
        local = at.fit_initial_state(observations, samples, local).ok()?.1;
        if samples == all {
            return Some(local);
        }
        samples = (2 * samples).min(all);
    }
}
