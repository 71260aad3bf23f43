//! The noise is estimated from the residuals, and the residuals are weighed by the noise, in turn.

use flight::batch;

use super::flown::Flown;
use super::problem::{Squares, whole};
use super::settle::step_unseen;
use super::{FitError, State, told, white};
use crate::levenberg::{Solution, Until, solve_after};
use crate::noise::{Moments, Noise};
use crate::options::Options;
use crate::outlier;
use crate::predict::Loss;
use crate::setting::Setting;

/// One changed mark in so many points is none.
const MANY: usize = 10_000;

/// How often the noise is estimated at most.
const ROUNDS: usize = 8;

/// Brings noise and unknowns to agree. Takes and gives the flights as they are flown.
///
/// # Errors
/// [`FitError::Flight`] where a flight becomes impossible, [`FitError::Interrupted`].
pub fn rounds(
    setting: &Setting,
    state: &mut State,
    mut flown: Flown,
    options: &Options<'_>,
) -> Result<(Noise, Solution, Flown), FitError> {
    let mut noise = white(setting, state);
    let mut solution: Option<Solution> = None;
    let mut promised = None;
    for round in 0..ROUNDS {
        let (estimated, marks_changed) = estimate(setting, state, &flown, options)?;
        let settled = !marks_changed && estimated.is_close_to(&noise);
        if let Some(solution) = solution.take_if(|_| settled) {
            return Ok((noise, solution, flown));
        }
        noise = estimated;
        state.rounds = round + 1;
        options.begins(&format!("noise, round {}", round + 1), state.tracks.len());
        let loss = Loss::Whitened(&noise);
        // The noise is known better after one step, and that step need not be seen for it.
        if round == 0
            && let Some(there) = step_unseen(setting, state, loss, &flown, options)?
        {
            (flown, promised) = there;
            continue;
        }
        let problem = Squares::of_all(setting, &state.tracks, loss, options);
        let found = solve_after(&problem, state.point(), Until::DONE, promised.take());
        let found = found.map_err(|failure| told(failure, &state.tracks))?;
        state.take(&found);
        // Where nothing was left to gain another look would show the same residuals, and the same noise in them.
        if found.iterations == 1 && found.is_there(Until::DONE) {
            return Ok((noise, found, flown));
        }
        flown = Flown::new(setting, state, &whole(&state.tracks), options);
        solution = Some(found);
    }
    solution
        .map(|solution| (noise, solution, flown))
        .ok_or(FitError::Interrupted)
}

/// Marks outliers and estimates the noise of the rest; and whether marks changed.
fn estimate(
    setting: &Setting,
    state: &mut State,
    flown: &Flown,
    options: &Options<'_>,
) -> Result<(Noise, bool), FitError> {
    let scales = batch::each_on(options.threads(), state.tracks.len(), |flight| {
        let residuals = &flown.path(&state.tracks, flight)?.residuals;
        let departures = outlier::departures(&state.tracks[flight].times, residuals);
        // What does not stand out in its own flight will not at a scale that is no smaller.
        let scale = outlier::scale(&departures);
        Ok((scale, outlier::suspects(&departures, scale)))
    });
    let judged: Vec<_> = scales.into_iter().collect::<Result<_, FitError>>()?;
    let scales: Vec<[f64; 3]> = judged.iter().map(|(scale, _)| *scale).collect();
    let usual = outlier::usual(&scales);
    let marked = batch::each_on(options.threads(), state.tracks.len(), |flight| {
        let residuals = &flown.path(&state.tracks, flight)?.residuals;
        let track = &state.tracks[flight];
        // A flight that is noisier than the others is judged by its own noise.
        let (own, suspects) = &judged[flight];
        let scale = [0, 1, 2].map(|axis| usual[axis].max(own[axis]));
        let mut outlier = vec![false; track.seen.len()];
        for (place, departure) in suspects {
            outlier[*place] = outlier::stands_out(departure, scale);
        }
        let mut moments = Moments::default();
        for (marker, series) in residuals.iter().enumerate() {
            let good = series.iter().enumerate().map(|(sample, residual)| {
                residual.filter(|_| !outlier[sample * track.markers + marker])
            });
            let good: Vec<Option<[f64; 3]>> = good.collect();
            moments.add(&track.times, &good, state.interval);
        }
        Ok((outlier, moments))
    });
    let mut sum = Moments::default();
    let mut changed = 0;
    for (track, marked) in state.tracks.iter_mut().zip(marked) {
        let (outlier, moments) = marked?;
        let marks = track.outlier.iter().zip(&outlier);
        changed += marks.filter(|(before, now)| before != now).count();
        track.outlier = outlier;
        sum.join(&moments);
    }
    let own: usize = state
        .tracks
        .iter()
        .map(|track| track.chart.dimension())
        .sum();
    let unknowns = own + setting.shared.len();
    Ok((
        sum.noise(unknowns, state.interval, setting.sigma),
        // Among very many points a few always lie at the limit.
        changed > sum.count / MANY,
    ))
}
