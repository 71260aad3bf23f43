//! Whether a deviation from a followed flight ends it. A strong lift that changes with the attitude, a wobble or a fast spin
//! deviates from a local prediction too: the flight ends where the motion beyond is none that air can cause.

use nalgebra::DVector;

use super::cut::{CUBIC, Fit, HINGES, JUMPS, best, fit, places};
use super::norm;
use super::track::Track;
use super::windows::{GRAVITY, SLOW, allowed};

/// Standard errors by which a bound must be exceeded.
const CERTAIN: f64 = 4.5;
/// Least jump of the velocity at an impact, m/s; air changes the velocity less within a sample or two.
const IMPACT: f64 = 1.0;
/// Least jump upwards at the ground, m/s: a body that touches it with its edge begins to turn more than to rise.
const TOUCH: f64 = 0.2;
/// Height above the lowest that a body reaches in the take below which it may touch the ground, m: the part of a thrown body
/// below its middle.
const REACH: f64 = 0.15;
/// Height above the lowest level at which a body is held up rather than flies if a change acts upwards, m.
const LOW: f64 = 0.05;
/// Least jump upwards of a body that low, m/s, and the standard errors by which it must be exceeded.
const SLIGHT: f64 = 0.1;
const LIKELY: f64 = 2.0;
/// Time between two descents to the ground, s.
const APART: f64 = 0.5;
/// Samples that may lie below the lowest level without counting, such as ghosts.
const BELOW: usize = 3;

/// Whether the samples beyond a place, at the beginning (`early`) or end of a followed flight, are no free flight that goes on;
/// `ground` is the lowest level, m.
pub(super) fn is_break(
    track: &Track,
    path: &[[f64; 3]],
    last: usize,
    ground: f64,
    early: bool,
) -> bool {
    let (places, near) = places(track, path, last, early);
    let Some(changed) = best(track, path, (&places, &near), early, &HINGES) else {
        return false;
    };
    let outmost = match early {
        true => track.times[places.start],
        false => track.times[places.end - 1],
    };
    let smooth = fit(track, path, places, track.times[last], early, &[]);
    let motion = match smooth {
        Some(smooth) if smooth.criterion <= changed.criterion => smooth,
        _ => changed,
    };
    if let Some((jump, error)) = velocity_jump(&motion) {
        let bound = match !early && is_touch(path[last][2] - ground, &motion, jump) {
            true => TOUCH,
            false => IMPACT,
        };
        if norm(jump) > bound + CERTAIN * error {
            return true;
        }
    }
    let beyond = 0.5 * (outmost - motion.time).abs();
    let (velocity, _) = derivative(&motion, early, beyond, 1);
    let (acceleration, error) = derivative(&motion, early, beyond, 2);
    let air = [acceleration[0], acceleration[1], acceleration[2] + GRAVITY];
    let rests = norm(velocity) <= SLOW && norm(air) >= 0.5 * GRAVITY;
    rests || !allowed(velocity, air, CERTAIN * error)
}

/// Jump of the velocity in a fitted motion, m/s, outwards from the flight, with its standard error on one axis; `None` where
/// it does not jump.
fn velocity_jump(motion: &Fit) -> Option<([f64; 3], f64)> {
    (motion.hinge.first() == Some(&1)).then(|| {
        let jump = [0, 1, 2].map(|axis| motion.coefficients[(CUBIC, axis)]);
        (jump, motion.covariance[(CUBIC, CUBIC)].max(0.0).sqrt())
    })
}

/// Whether a body that falls is thrown upwards, by its height above the lowest level, m: as low as the ground may be.
fn is_touch(height: f64, motion: &Fit, jump: [f64; 3]) -> bool {
    let falls = motion.coefficients[(1, 2)] < 0.0;
    falls && jump[2] > 0.5 * norm(jump) && height < REACH
}

/// Whether a body that falls is held up at a place of the track that is as low as the body comes: small touches one after
/// another deviate too little from their prediction to be strange.
pub(super) fn touches(track: &Track, path: &[[f64; 3]], last: usize, ground: f64) -> bool {
    if path[last][2] > ground + LOW {
        return false;
    }
    let (places, near) = places(track, path, last, false);
    let Some(changed) = best(track, path, (&places, &near), false, &JUMPS) else {
        return false;
    };
    let smooth = fit(track, path, places, track.times[last], false, &[]);
    if smooth.is_some_and(|smooth| smooth.criterion <= changed.criterion) {
        return false;
    }
    velocity_jump(&changed).is_some_and(|(jump, error)| {
        is_touch(path[last][2] - ground, &changed, jump) && jump[2] > SLIGHT + LIKELY * error
    })
}

/// Lowest level of a path, m.
pub(super) fn lowest(path: &[[f64; 3]]) -> f64 {
    let mut heights: Vec<f64> = path.iter().map(|position| position[2]).collect();
    let place = BELOW.min(heights.len() - 1);
    *heights.select_nth_unstable_by(place, f64::total_cmp).1
}

/// Whether the lowest level is that of the ground: the body comes down to it several times. Where it does once, that may be where
/// a flight turns upwards.
pub(super) fn is_ground(times: &[f64], path: &[[f64; 3]], lowest: f64) -> bool {
    let low = times.iter().zip(path);
    let low = low.filter(|(_, at)| at[2] < lowest + REACH);
    let mut before = f64::NEG_INFINITY;
    let visits = low.filter(|(time, _)| {
        let is_new = **time > before + APART;
        before = **time;
        is_new
    });
    visits.count() > 1
}

/// A derivative of a fitted motion, a time `beyond` the change, with its standard error on one axis.
fn derivative(motion: &Fit, early: bool, beyond: f64, order: i32) -> ([f64; 3], f64) {
    let sign: f64 = if early { -1.0 } else { 1.0 };
    let term = |power: i32, time: f64| -> f64 {
        let factors: f64 = (0..order).map(|k| f64::from(power - k)).product();
        if power < order {
            0.0
        } else {
            factors * time.powi(power - order)
        }
    };
    let own = (0..CUBIC as i32).map(|power| term(power, sign * beyond));
    // The hinge grows with the time beyond, which runs against the time at a beginning.
    let hinge = motion
        .hinge
        .iter()
        .map(|&power| sign.powi(order) * term(power, beyond));
    let row = DVector::from_iterator(CUBIC + motion.hinge.len(), own.chain(hinge));
    let value = motion.coefficients.transpose() * &row;
    let variance = row.dot(&(&motion.covariance * &row));
    ([value[0], value[1], value[2]], variance.max(0.0).sqrt())
}
