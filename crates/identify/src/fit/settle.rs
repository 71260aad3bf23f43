//! From starts to the neighbourhood of the solution: by a robust loss whose scale shrinks, over a growing horizon.

use nalgebra::DVector;

use super::flown::{Flown, size};
use super::problem::{Squares, whole};
use super::{FitError, State, told};
use crate::levenberg::{Failure, Known, Point, Solution, Until, solve};
use crate::options::Options;
use crate::predict::Loss;
use crate::setting::Setting;
use crate::track::Track;

/// The first horizon, s, and by how much the next is longer.
const HORIZON: (f64, f64) = (0.4, 2.5);

/// How often the scale of the loss may shrink.
const SHRINKS: usize = 8;

/// Over how many times the noise's floor a scale is fine enough while the horizon still grows.
const FINE: f64 = 5.0;

/// Over how many times the noise's floor residuals are more than noise: the usual ones, and those of any flight.
const NOISE: (f64, f64) = (1.1, 2.0);

/// Residuals that grew by more than this made a flight worse, and not only less certain.
const WORSE: f64 = 1.1;

/// Fits all flights over a horizon that grows to their whole length: far from the solution a long flight has wrong
/// minima that a short one has not.
///
/// # Errors
/// [`FitError::Flight`] where a flight becomes impossible, [`FitError::Interrupted`].
pub fn grow(
    setting: &Setting,
    state: &mut State,
    options: &Options<'_>,
) -> Result<Flown, FitError> {
    let longest = state.tracks.iter().filter_map(|track| track.times.last());
    let longest = longest.copied().fold(0.0, f64::max);
    let mut horizon = HORIZON.0;
    while horizon < longest / 1.2 {
        options.begins(&format!("first {horizon:.1} s"), state.tracks.len());
        let samples: Vec<usize> = state
            .tracks
            .iter()
            .map(|track| track.until(horizon))
            .collect();
        approach(setting, state, &samples, options)?;
        horizon *= HORIZON.1;
    }
    options.begins("whole flights", state.tracks.len());
    if horizon > HORIZON.0
        && let Some(flown) = one_step(setting, state, options)?
    {
        return Ok(flown);
    }
    settle(setting, state, options)
}

/// Steps all flights once over their whole length; gives them as they then are where that leaves no more than the noise.
fn one_step(
    setting: &Setting,
    state: &mut State,
    options: &Options<'_>,
) -> Result<Option<Flown>, FitError> {
    let flown = Flown::new(setting, state, &whole(&state.tracks), options);
    let loss = Loss::Huber(flown.usual().max(setting.floor));
    let stepped = step_unseen(setting, state, loss, &flown, options)?;
    let limit = NOISE.1 * setting.floor;
    let good = |size: &Option<f64>| size.is_some_and(|size| size <= limit);
    Ok(stepped
        .map(|(flown, _)| flown)
        .filter(|flown| flown.usual() <= NOISE.0 * setting.floor && flown.sizes().iter().all(good)))
}

/// Steps all flights once, and judges the step by flying them, which costs far less than their derivatives would: gives
/// them as they then are, and what the step had promised. None where it made them worse, and was taken back.
pub fn step_unseen(
    setting: &Setting,
    state: &mut State,
    loss: Loss<'_>,
    before: &Flown,
    options: &Options<'_>,
) -> Result<Option<(Flown, Option<f64>)>, FitError> {
    let problem = Squares::of_all(setting, &state.tracks, loss, options);
    let start = state.point();
    let solution = solve(&problem, start.clone(), Until::ONCE);
    let solution = solution.map_err(|failure| told(failure, &state.tracks))?;
    state.take(&solution);
    let flown = Flown::new(setting, state, &whole(&state.tracks), options);
    let flies = flown.sizes().iter().all(Option::is_some);
    if flies && flown.usual() <= WORSE * before.usual() {
        return Ok(Some((flown, solution.promised)));
    }
    (state.shared, state.own) = (start.shared, start.own);
    Ok(None)
}

/// Fits the first samples of all flights, until residuals are as fine as they need be on the way. Short horizons leave
/// coefficients open, which must not run away before the long ones are seen.
fn approach(
    setting: &Setting,
    state: &mut State,
    samples: &[usize],
    options: &Options<'_>,
) -> Result<(), FitError> {
    let mut known: Vec<Known> = setting.shared.iter().map(|shared| shared.known).collect();
    for (known, shared) in known.iter_mut().zip(&setting.shared) {
        known.prior = known.prior.or(Some((shared.model_value, shared.usual)));
    }
    let mut scale = f64::INFINITY;
    for _ in 0..SHRINKS {
        let flown = Flown::new(setting, state, samples, options);
        let shrunk = flown.usual().max(setting.floor);
        if shrunk > 0.7 * scale {
            break;
        }
        scale = shrunk;
        let mut problem = Squares::of_all(setting, &state.tracks, Loss::Huber(scale), options);
        problem.samples.copy_from_slice(samples);
        problem.known.clone_from(&known);
        let solution = solve(&problem, state.point(), Until::NEAR);
        let solution = solution.map_err(|failure| told(failure, &state.tracks))?;
        state.take(&solution);
        if scale < FINE * setting.floor {
            break;
        }
    }
    Ok(())
}

/// Fits all flights over their whole length by a loss whose scale shrinks to that of the residuals; and flies them as they
/// then are.
pub fn settle(
    setting: &Setting,
    state: &mut State,
    options: &Options<'_>,
) -> Result<Flown, FitError> {
    let samples = whole(&state.tracks);
    let mut scale = f64::INFINITY;
    let mut flown = Flown::new(setting, state, &samples, options);
    for _ in 0..SHRINKS {
        let shrunk = flown.usual().max(setting.floor);
        if shrunk > 0.7 * scale {
            break;
        }
        scale = shrunk;
        let problem = Squares::of_all(setting, &state.tracks, Loss::Huber(scale), options);
        let solution = solve(&problem, state.point(), Until::ROUGHLY);
        let solution = solution.map_err(|failure| told(failure, &state.tracks))?;
        state.take(&solution);
        flown = Flown::new(setting, state, &samples, options);
    }
    Ok(flown)
}

/// Fits the first samples of one flight by its own unknowns; the loss that is left, over the noise's floor, and the
/// initial state.
///
/// # Errors
/// In words, where the samples do not determine the state, or the flight is impossible.
pub fn own_only(
    setting: &Setting,
    track: &Track,
    samples: usize,
    shared: &DVector<f64>,
    start: DVector<f64>,
    options: &Options<'_>,
) -> Result<(f64, DVector<f64>), String> {
    let (mut own, mut scale) = (start, f64::INFINITY);
    for _ in 0..SHRINKS {
        let shrunk = size(setting, track, (shared, &own), samples).unwrap_or(1.0);
        let shrunk = shrunk.max(setting.floor);
        // The last fit is by the floor's own scale.
        if shrunk > 0.7 * scale || 0.7 * shrunk < setting.floor {
            break;
        }
        scale = shrunk;
        own = solve_own(
            setting,
            track,
            samples,
            shared,
            own,
            Loss::Huber(scale),
            options,
        )?
        .0;
    }
    let (own, solution) = solve_own(
        setting,
        track,
        samples,
        shared,
        own,
        Loss::Huber(setting.floor),
        options,
    )?;
    if !solution.blocks[0].determines_own() {
        return Err("its samples do not determine its initial state".into());
    }
    Ok((solution.squares, own))
}

/// One fit of one flight's own unknowns.
pub fn solve_own(
    setting: &Setting,
    track: &Track,
    samples: usize,
    shared: &DVector<f64>,
    own: DVector<f64>,
    loss: Loss<'_>,
    options: &Options<'_>,
) -> Result<(DVector<f64>, Solution), String> {
    let problem = Squares::of_own(setting, track, samples, loss, shared, options);
    let start = Point {
        shared: DVector::zeros(0),
        own: vec![own],
    };
    let solution = solve(&problem, start, Until::ROUGHLY).map_err(|failure| match failure {
        Failure::Start { reason, .. } => reason,
        other => other.to_string(),
    })?;
    Ok((solution.point.own[0].clone(), solution))
}
