//! Axes, units and frames of gyroscopes and accelerometers, compared with the motion that measured attitudes show.

use model_spec::compose::Instrument;
use nalgebra::{Matrix3, Rotation3, Vector3};

use super::meaning::Meaning;
use super::momentum::is_clearly_better;
use super::motion::{Comparison, comparisons};
use super::other_meaning::OtherMeaning;
use super::readings::series;
use super::signed_axes::SignedAxes;
use super::track::Track;
use crate::fault::FaultKind;
use crate::levels::{AS_GOOD, MAX_DELAY};
use crate::statistics::median_of;
use crate::{Dataset, Sensor};

/// Steps to the rotation of an instrument, and the longest of them, rad.
const TURNS: usize = 12;
const MAX_TURN: f64 = 0.5;

/// Kind, message and correction of readings that follow the motion of the body only with another meaning.
pub fn check(
    dataset: &Dataset,
    (sensor, channel, instrument): (&Sensor, usize, Instrument),
    (tracks, gravity): (&[Option<Track>], Option<Vector3<f64>>),
) -> Option<(FaultKind, (String, String))> {
    let compared = |delay: f64| -> Vec<Comparison> {
        let flights = dataset.flights.iter().zip(tracks);
        let each = flights.filter_map(|(flight, track)| {
            let readings = series(flight, channel).map(|(time, own)| (time - delay, own));
            Some(comparisons(
                track.as_ref()?,
                readings,
                sensor,
                instrument,
                gravity,
            ))
        });
        each.flatten().collect()
    };
    let size = |compared: &[Comparison]| -> f64 {
        compared.iter().map(|own| own.expected.norm_squared()).sum()
    };
    let misfit = |compared: &[Comparison], meaning: &Meaning| {
        let unit = meaning.unit.value(instrument);
        let squares = compared.iter().map(|own| own.misfit(meaning, unit));
        squares.sum::<f64>() / size(compared)
    };
    let as_they_are = compared(0.0);
    if as_they_are.is_empty() {
        return None;
    }
    let meanings = Meaning::all(instrument);
    let stated = meanings[0];
    let (meaning, is_alone) = clearly_best(meanings, |own| misfit(&as_they_are, own))?;
    // A delay turns what rotates with the body, as other axes do, and so does an oblique mounting: the fit tells them.
    let left = misfit(&as_they_are, &meaning);
    let is_late = |delay: f64| misfit(&compared(delay), &stated) < left;
    let (turn, if_turned) = best_turn(&as_they_are);
    let is_oblique = AS_GOOD * if_turned < left * size(&as_they_are)
        && SignedAxes::nearest(&turn) != meaning.axes;
    if !meaning.axes.is_identity() && (is_oblique || delays(dataset, channel).any(is_late)) {
        return None;
    }
    let why = "only so do the readings follow the motion of the body";
    let meaning = OtherMeaning::new(&[(sensor, channel, instrument)], meaning);
    Some(meaning.fault(why, is_alone))
}

/// The rotation from the axes of an instrument to those of the body with which its readings are nearest to what is expected,
/// by Gauss and Newton's method, and the squared differences that it leaves.
fn best_turn(compared: &[Comparison]) -> (Matrix3<f64>, f64) {
    let mut turn = Matrix3::identity();
    for _ in 0..TURNS {
        let (mut normal, mut gradient) = (Matrix3::zeros(), Vector3::zeros());
        for own in compared {
            let by = [0, 1, 2].map(|axis| {
                let about = Vector3::ith(axis, 1.0).cross_matrix();
                own.turned(&(about * turn))
            });
            let by = Matrix3::from_columns(&by);
            normal += by.transpose() * by;
            gradient += by.transpose() * (own.expected - own.turned(&turn));
        }
        let Some(step) = normal.lu().solve(&gradient) else {
            break;
        };
        // Far from the solution a step may be of several turns.
        let step = step.cap_magnitude(MAX_TURN);
        turn = Rotation3::from_scaled_axis(step).matrix() * turn;
    }
    let left = compared.iter().map(|own| own.expected - own.turned(&turn));
    (turn, left.map(|left| left.norm_squared()).sum())
}

/// Times, s, by which readings may be late or, negative, early.
fn delays(dataset: &Dataset, channel: usize) -> impl Iterator<Item = f64> {
    let intervals = dataset.flights.iter().filter_map(|flight| {
        let mut times = series(flight, channel).map(|(time, _)| time);
        let (first, second) = (times.next()?, times.next()?);
        Some(second - first)
    });
    let interval = median_of(intervals).unwrap_or_default();
    (1..=MAX_DELAY).flat_map(move |k| [k, -k].map(|k| f64::from(k) * interval))
}

/// The simplest of the best meanings, and whether no other is as good, if it is clearly better than the first.
fn clearly_best(
    meanings: Vec<Meaning>,
    misfit: impl Fn(&Meaning) -> f64,
) -> Option<(Meaning, bool)> {
    let misfits: Vec<f64> = meanings.iter().map(misfit).collect();
    let least = misfits.iter().copied().fold(f64::INFINITY, f64::min);
    if !is_clearly_better(least, misfits[0]) {
        return None;
    }
    let each = meanings.iter().zip(&misfits);
    let good = each.filter(|(_, misfit)| **misfit <= AS_GOOD * least);
    let mut good = good.map(|(meaning, _)| meaning);
    let best = good.next()?;
    Some((*best, good.next().is_none()))
}
