//! Ranges of functions and of their derivatives over an interval.

use super::interval::{Interval, UNBOUNDED, hull, product, reach, sum};
use crate::real::{ElementaryFunction, Real};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Difference of two pieces at their knot, relative to their values, above which a function jumps there.
const JUMP: f64 = 1e-9;

/// Ranges of sine and cosine.
pub(super) fn sin_cos([low, high]: Interval) -> [Interval; 2] {
    // A maximum of the sine is a quarter turn, and of the cosine none, after a whole number of turns.
    let has_maximum = |turned: f64| {
        let next = ((low - turned) / TAU).ceil() * TAU + turned;
        // Unknown bounds have a maximum.
        let is_beyond = next > high;
        !is_beyond
    };
    let [at_low, at_high] = [low, high].map(|angle| {
        let (sine, cosine) = Real::sin_cos(angle);
        [sine, cosine]
    });
    [0, 1].map(|k| {
        let maximum = FRAC_PI_2 * (1 - k) as f64;
        let (a, b) = (at_low[k], at_high[k]);
        let least = if has_maximum(maximum - 2.0 * FRAC_PI_2) {
            -1.0
        } else {
            a.min(b)
        };
        let greatest = if has_maximum(maximum) { 1.0 } else { a.max(b) };
        [least, greatest]
    })
}

/// Range of the polar angle of the points of a rectangle; `None` if it holds the origin or touches where the angle jumps.
pub(super) fn angle(y: Interval, x: Interval) -> Option<Interval> {
    if x[0] <= 0.0 && y[0] <= 0.0 && y[1] >= 0.0 {
        return None;
    }
    let corners = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| Real::atan2(y[i], x[j]));
    let least = corners.into_iter().fold(f64::INFINITY, f64::min);
    let greatest = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
    Some([least, greatest])
}

/// Range of an elementary function and of its derivative; `None` if it jumps.
pub(super) fn elementary(
    function: ElementaryFunction,
    [low, high]: Interval,
) -> Option<(Interval, Interval)> {
    use ElementaryFunction as F;
    // All are monotone.
    let range = [low, high].map(|value| value.elementary(function));
    let nearest = match low <= 0.0 && high >= 0.0 {
        true => 0.0,
        false => low.abs().min(high.abs()),
    };
    // The derivative of an odd function falls or rises with the distance from 0.
    let distances = [nearest, reach([low, high])];
    let derivative = match function {
        F::Exp => range,
        F::Log if high <= 0.0 => [0.0; 2],
        F::Log if low <= 0.0 => return None,
        F::Log => [1.0 / high, 1.0 / low],
        F::Tanh => {
            let [greatest, least] = distances.map(|x| 1.0 - x.tanh() * x.tanh());
            [least, greatest]
        }
        F::Asin => {
            let [least, greatest] = distances.map(|x| 1.0 / (1.0 - x * x).max(0.0).sqrt());
            match distances[1] > 1.0 {
                true => [0.0, f64::INFINITY],
                false => [least, greatest],
            }
        }
    };
    Some((range, derivative))
}

/// Range of a piecewise cubic and of its derivative, which is unbounded at a jump.
pub(super) fn piecewise_cubic(
    [low, high]: Interval,
    knots: &[f64],
    cubics: &[[f64; 4]],
) -> (Interval, Interval) {
    let below = |x: f64| knots.partition_point(|knot| *knot <= x);
    let (first, last) = (below(low), below(high));
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    let mut derivative = range;
    for k in first..=last {
        let origin = knots[k.saturating_sub(1)];
        let from = if k == first { low } else { knots[k - 1] };
        let until = if k == last { high } else { knots[k] };
        let h = [from - origin, until - origin];
        let [a, b, c, d] = cubics[k];
        range = hull(range, horner(h, &[a, b, c, d]));
        derivative = hull(derivative, horner(h, &[b, 2.0 * c, 3.0 * d]));
        if k < last && jumps(until - origin, cubics[k], cubics[k + 1][0]) {
            derivative = UNBOUNDED;
        }
    }
    (range, derivative)
}

/// Whether a cubic differs at the distance `h` from the value of the next one there.
fn jumps(h: f64, [a, b, c, d]: [f64; 4], next: f64) -> bool {
    let end = a + h * (b + h * (c + h * d));
    (end - next).abs() > JUMP * (a.abs() + end.abs() + next.abs())
}

/// Range of a polynomial over an interval.
fn horner(h: Interval, coefficients: &[f64]) -> Interval {
    let mut value = [0.0; 2];
    for coefficient in coefficients.iter().rev() {
        value = sum(product(value, h), [*coefficient; 2]);
    }
    value
}
