//! Decision whether a deviation from a followed flight ends the flight.
//!
//! A strong lift that changes with the attitude, a wobble or a fast spin deviates from a local prediction too. The
//! flight therefore ends only where the motion outside it is one that air cannot cause.

use nalgebra::DVector;

use super::cut::{CUBIC, Fit, FlightEnd, HINGES, JUMPS};
use super::windows::{SLOW, allowed};
use super::{GRAVITY, norm};

/// Number of standard errors by which a fitted jump of the velocity or a fitted acceleration must exceed its bound,
/// such as [`TOUCH`] or [`IMPACT`], for the flight to end there.
const CERTAIN: f64 = 4.5;
/// Minimum jump of the velocity at an impact, m/s; air changes the velocity by less within a sample or two.
const IMPACT: f64 = 1.0;
/// Minimum upward jump of the velocity at the ground, m/s. It is small because a body that touches the ground with its
/// edge begins to turn more than to rise.
const TOUCH: f64 = 0.2;
/// Maximum height of the body above the lowest level of its trajectory at which it may touch the ground, m: the extent
/// of a thrown body below its centre.
const REACH: f64 = 0.15;
/// Height above the lowest level of the trajectory, m, below which an upward jump of the velocity means that the ground
/// supports the body.
const LOW: f64 = 0.05;
/// Minimum upward jump of the velocity, m/s, that counts as support by the ground at heights below `LOW`. The jump must
/// exceed this bound by `LIKELY` standard errors.
const SLIGHT: f64 = 0.1;
const LIKELY: f64 = 2.0;
/// Minimum time between two descents to the ground that count as separate, s.
const APART: f64 = 0.5;
/// Number of lowest samples of a trajectory that are ignored as possible false (ghost) points when its lowest level is
/// determined.
const BELOW: usize = 3;

/// Whether a flight ends at `end`, its supposed beginning or end, because the body moves beyond it in a way that the
/// air cannot cause. `ground` is the height of the lowest level of the trajectory, m.
pub(super) fn is_break(end: &FlightEnd<'_>, ground: f64) -> bool {
    let Some(changed) = end.best(&HINGES) else {
        return false;
    };
    let early = end.early;
    let outmost = match early {
        true => end.track.times[end.samples.start],
        false => end.track.times[end.samples.end - 1],
    };
    let motion = match end.smooth() {
        Some(smooth) if smooth.criterion <= changed.criterion => smooth,
        _ => changed,
    };
    if let Some((jump, error)) = velocity_jump(&motion) {
        let bound = match !early && is_touch(end.path[end.last][2] - ground, &motion, jump) {
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

/// Jump of the velocity at the change of motion that `motion` fits, m/s, and its standard error on one axis, m/s;
/// `None` if the fitted velocity does not jump. The velocity is the derivative with respect to the time counted
/// outwards from the flight; at the beginning of a flight this time runs backwards.
fn velocity_jump(motion: &Fit) -> Option<([f64; 3], f64)> {
    (motion.hinge.first() == Some(&1)).then(|| {
        let jump = [0, 1, 2].map(|axis| motion.coefficients[(CUBIC, axis)]);
        (jump, motion.covariance[(CUBIC, CUBIC)].max(0.0).sqrt())
    })
}

/// Whether a falling body is pushed upwards by the `jump` of its velocity (m/s) at a `height` (above the lowest level
/// of the trajectory, m) at which it may touch the ground.
fn is_touch(height: f64, motion: &Fit, jump: [f64; 3]) -> bool {
    let falls = motion.coefficients[(1, 2)] < 0.0;
    falls && jump[2] > 0.5 * norm(jump) && height < REACH
}

/// Whether the ground supports a falling body at `end`; true only near the lowest level of the trajectory, whose height
/// is `ground`, m. This detects slight touches in succession, each of which deviates too little from the prediction to
/// end the flight.
pub(super) fn touches(end: &FlightEnd<'_>, ground: f64) -> bool {
    let height = end.path[end.last][2];
    if height > ground + LOW {
        return false;
    }
    let Some(changed) = end.best(&JUMPS) else {
        return false;
    };
    let smooth = end.smooth();
    if smooth.is_some_and(|smooth| smooth.criterion <= changed.criterion) {
        return false;
    }
    velocity_jump(&changed).is_some_and(|(jump, error)| {
        is_touch(height - ground, &changed, jump) && jump[2] > SLIGHT + LIKELY * error
    })
}

/// Lowest height of a trajectory, m, apart from a few lower samples that may be false (ghost) points.
pub(super) fn lowest(path: &[[f64; 3]]) -> f64 {
    let mut heights: Vec<f64> = path.iter().map(|position| position[2]).collect();
    let place = BELOW.min(heights.len() - 1);
    *heights.select_nth_unstable_by(place, f64::total_cmp).1
}

/// Whether the height `lowest` of the lowest level of the trajectory `path`, m, is that of the ground, because the body
/// comes down to it more than once. A single low point may be where a flight turns upwards.
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

/// Derivative of the given `order` with respect to time of the fitted motion `motion`, evaluated outside the flight,
/// and the standard error of one component of this derivative; both in m/s for order 1 and in m/s² for order 2. It is
/// evaluated `beyond` seconds (≥ 0) before the beginning of the flight if `early` is true, otherwise `beyond` seconds
/// after its end.
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
    // The hinge grows with the time outside the flight, which runs against `t` at the beginning of a flight.
    let hinge = motion
        .hinge
        .iter()
        .map(|&power| sign.powi(order) * term(power, beyond));
    let row = DVector::from_iterator(CUBIC + motion.hinge.len(), own.chain(hinge));
    let value = motion.coefficients.transpose() * &row;
    let variance = row.dot(&(&motion.covariance * &row));
    ([value[0], value[1], value[2]], variance.max(0.0).sqrt())
}
