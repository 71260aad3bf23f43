//! Flights that landed in a wrong minimum are noticed, and started anew.

use flight::batch;
use nalgebra::DVector;

use super::begin::{FIRST, spin_note};
use super::flown::{Flown, size};
use super::settle::{own_only, settle};
use super::{FitError, State};
use crate::noise::median;
use crate::options::Options;
use crate::setting::Setting;
use crate::start;
use crate::track::Track;

/// A flight whose residuals are so much greater than is usual is suspected.
const SUSPECT: f64 = 3.0;

/// A new start is taken where it leaves residuals smaller than this part of the old.
const BETTER: f64 = 0.7;

/// Starts flights anew whose residuals are far greater than the others' and than the noise, and fits all again where
/// that helped. Takes and gives the flights as they are flown.
///
/// # Errors
/// As [`settle`](super::settle::settle).
pub fn recover(
    setting: &Setting,
    state: &mut State,
    flown: Flown,
    options: &Options<'_>,
) -> Result<Flown, FitError> {
    let sizes: Vec<f64> = flown
        .sizes()
        .into_iter()
        .map(|size| size.unwrap_or(f64::INFINITY))
        .collect();
    let usual = median(&mut sizes.clone());
    // Where most flights are far off the model is wrong, or most starts are: the noise's floor tells that.
    let limit = SUSPECT
        * if usual > 10.0 * setting.floor {
            setting.floor
        } else {
            usual.max(setting.floor)
        };
    let suspects: Vec<usize> = (0..sizes.len())
        .filter(|&flight| sizes[flight] > limit)
        .collect();
    if suspects.is_empty() {
        return Ok(flown);
    }
    options.begins("flights that stand out", suspects.len());
    let found = batch::each_on(options.threads(), suspects.len(), |index| {
        let flight = suspects[index];
        let found = again(setting, state, flight, sizes[flight], options);
        options.part_done();
        found
    });
    if options.is_stopped() {
        return Err(FitError::Interrupted);
    }
    let mut helped = false;
    for (&flight, found) in suspects.iter().zip(found) {
        if let Some((own, note)) = found {
            state.own[flight] = own;
            state.tracks[flight].notes.push(note);
            helped = true;
        }
    }
    if helped {
        return settle(setting, state, options);
    }
    Ok(flown)
}

/// A better initial state of a flight, with the coefficients as they are, and what is to be said of it.
fn again(
    setting: &Setting,
    state: &State,
    flight: usize,
    before: f64,
    options: &Options<'_>,
) -> Option<(DVector<f64>, String)> {
    let track = &state.tracks[flight];
    let mut best: Option<(f64, DVector<f64>, i32)> = None;
    for start in start::starts(setting, track).ok()? {
        let Some(own) = grown(setting, state, track, start.state, options) else {
            continue;
        };
        let Some(size) = size(setting, track, (&state.shared, &own), track.times.len()) else {
            continue;
        };
        if best.as_ref().is_none_or(|(least, ..)| size < *least) {
            best = Some((size, own, start.turns));
        }
    }
    let (size, own, turns) = best.filter(|(size, ..)| *size < BETTER * before)?;
    let mut note = format!(
        "its first fit had ended in a wrong minimum (residuals of {:.1} mm, now {:.1} mm); it was started anew",
        1e3 * before,
        1e3 * size
    );
    if turns != 0 {
        note = format!("{note}; {}", spin_note(turns));
    }
    Some((own, note))
}

/// Fits one flight over a horizon that doubles.
fn grown(
    setting: &Setting,
    state: &State,
    track: &Track,
    start: DVector<f64>,
    options: &Options<'_>,
) -> Option<DVector<f64>> {
    let all = track.times.len();
    let mut samples = track.until(FIRST.0).max(FIRST.1).min(all);
    let mut own = start;
    loop {
        let fitted = own_only(setting, track, samples, &state.shared, own, options);
        own = fitted.ok()?.1;
        if samples == all {
            return Some(own);
        }
        samples = (2 * samples).min(all);
    }
}
