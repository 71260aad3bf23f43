//! From starts to the neighbourhood of the solution: by a robust loss whose scale shrinks, over a growing horizon.

use nalgebra::DVector;

use super::problem::{Squares, whole};
use super::{FitError, State, told};
use crate::levenberg::{Failure, Point, Solution, Until, solve};
use crate::noise::{median, robust_sigma};
use crate::options::Options;
use crate::predict::{Loss, residuals};
use crate::setting::Setting;
use crate::track::Track;

/// The first horizon, s, and by how much the next is longer.
const HORIZON: (f64, f64) = (0.4, 2.5);

/// How often the scale of the loss may shrink.
const SHRINKS: usize = 8;

/// Fits all flights over a horizon that grows to their whole length: far from the solution a long flight has wrong
/// minima that a short one has not.
///
/// # Errors
/// [`FitError::Flight`] where a flight becomes impossible, [`FitError::Interrupted`].
pub fn grow(setting: &Setting, state: &mut State, options: &Options<'_>) -> Result<(), FitError> {
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
        settle(setting, state, samples, true, options)?;
        horizon *= HORIZON.1;
    }
    options.begins("whole flights", state.tracks.len());
    settle(setting, state, whole(&state.tracks), false, options)
}

/// Fits the first samples of all flights by a loss whose scale shrinks to that of the residuals.
pub fn settle(
    setting: &Setting,
    state: &mut State,
    samples: Vec<usize>,
    bridled: bool,
    options: &Options<'_>,
) -> Result<(), FitError> {
    let mut scale = f64::INFINITY;
    for _ in 0..SHRINKS {
        let sizes = sizes(setting, state, &samples, options);
        let mut sizes: Vec<f64> = sizes.into_iter().flatten().collect();
        let shrunk = median(&mut sizes).max(setting.floor);
        if shrunk > 0.7 * scale {
            break;
        }
        scale = shrunk;
        let loss = Loss::Huber(scale);
        let mut problem = Squares::of_all(setting, &state.tracks, loss, options);
        problem.samples.clone_from(&samples);
        if bridled {
            // Short horizons leave coefficients open, which must not run away before the long ones are seen.
            for (known, shared) in problem.known.iter_mut().zip(&setting.shared) {
                known.prior = known.prior.or(Some((shared.model_value, shared.usual)));
            }
        }
        let start = Point {
            shared: state.shared.clone(),
            own: state.own.clone(),
        };
        let solution = solve(&problem, start, Until::ROUGHLY);
        let solution = solution.map_err(|failure| told(failure, &state.tracks))?;
        state.take(&solution);
    }
    Ok(())
}

/// The usual size of the residuals of each flight's first samples, m; none where it cannot be flown.
pub fn sizes(
    setting: &Setting,
    state: &State,
    samples: &[usize],
    options: &Options<'_>,
) -> Vec<Option<f64>> {
    flight::batch::each_on(options.threads(), state.tracks.len(), |flight| {
        let unknowns = (&state.shared, &state.own[flight]);
        size(setting, &state.tracks[flight], unknowns, samples[flight])
    })
}

/// The usual size of a flight's residuals, m; none where it cannot be flown.
pub fn size(
    setting: &Setting,
    track: &Track,
    unknowns: (&DVector<f64>, &DVector<f64>),
    samples: usize,
) -> Option<f64> {
    let residuals = residuals(setting, track, unknowns, samples).ok()?;
    let all = residuals.iter().flatten().flatten().flatten();
    let mut sizes: Vec<f64> = all.map(|residual| residual.abs()).collect();
    (!sizes.is_empty()).then(|| robust_sigma(&mut sizes))
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
        if shrunk > 0.7 * scale {
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
