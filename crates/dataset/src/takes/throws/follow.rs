//! Following of a free flight sample by sample: each sample is compared with its prediction from the preceding ones.

use std::ops::Range;

use super::quadratic::quadratic;
use super::track::Track;
use super::windows::half;
use super::{FINEST, ThrowOptions, median};

/// Difference between a measured position and its prediction, in standard deviations, above which the sample counts as
/// deviating.
const STRANGE: f64 = 4.5;
/// Number of consecutive samples that must all deviate from their prediction before it is examined whether the flight
/// ends there.
const CONSECUTIVE: usize = 2;
/// Rate of change of the acceleration in free flight, m/s³, that is tolerated when a measured position is compared with
/// its prediction from a quadratic in time.
const JERK: f64 = 60.0;

/// Reason why a flight was not followed further in time. All indices refer to the track.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Stop {
    /// The recording has no further samples in which the body is seen.
    Data,
    /// The body is not seen between the samples with the indices `from` and `to`, neighbours in the track. The gap is
    /// longer than [`ThrowOptions::longest_gap`], or the samples after it do not continue the flight. If the flight is
    /// followed backwards in time, `to` is earlier than `from`.
    Gap { from: usize, to: usize },
    /// The samples after the one with the index `last` in the track deviate from their prediction. If the flight is
    /// followed backwards in time, "after" means earlier.
    Deviation { last: usize },
    /// The ground supports the body near the sample `last`, an index in the track.
    Touch { last: usize },
}

impl Stop {
    /// Index, in the track, of the last sample of the flight, or of its first sample if the flight was followed
    /// backwards in time. `data` is the index returned for [`Stop::Data`]: the last index of the track, or 0 if the
    /// flight was followed backwards.
    pub fn last(&self, data: usize) -> usize {
        match self {
            Self::Data => data,
            Self::Gap { from, .. } => *from,
            Self::Deviation { last } | Self::Touch { last } => *last,
        }
    }
}

/// Predicates that decide whether a flight ends. Each is called with the index, in the track, of the last sample that
/// agreed with its prediction.
pub(super) struct Checks<'c> {
    /// Predicate that is called when samples deviate from their prediction: whether the flight ends at the track index
    /// given by the first argument. The second argument is true if the samples are examined backwards in time.
    pub is_break: &'c dyn Fn(usize, bool) -> bool,
    /// Whether the ground supports the body at a track index. Called at every sample that is followed forwards in time,
    /// since a slight touch may cause no deviation from the prediction.
    pub touches: &'c dyn Fn(usize) -> bool,
}

/// Follows a flight along the trajectory `path` (m) of a body point, backwards and forwards in time, until `checks` end
/// it. It starts from the middle of `run`, a range of track indices in free flight. Returns the reasons why the flight
/// was not followed further at its beginning and at its end.
pub(super) fn follow(
    track: &Track,
    path: &[[f64; 3]],
    run: &Range<usize>,
    options: &ThrowOptions,
    checks: &Checks<'_>,
) -> (Stop, Stop) {
    let noise = noise(track, path, run);
    let middle = (run.start + run.end) / 2;
    let half = half(track);
    let around = middle.saturating_sub(half)..(middle + half + 1).min(path.len());
    let side = |forward: bool| {
        let mut inside: Vec<usize> = around.clone().collect();
        if !forward {
            inside.reverse();
        }
        extend(track, path, inside, forward, noise, options, checks)
    };
    (side(false), side(true))
}

fn extend(
    track: &Track,
    path: &[[f64; 3]],
    mut inside: Vec<usize>,
    forward: bool,
    noise: f64,
    options: &ThrowOptions,
    checks: &Checks<'_>,
) -> Stop {
    let length = inside.len();
    let step = |i: usize, by: usize| match forward {
        true => Some(i + by).filter(|&next| next < path.len()),
        false => i.checked_sub(by),
    };
    loop {
        let Some(&last) = inside.last() else {
            return Stop::Data;
        };
        let Some(next) = step(last, 1) else {
            return Stop::Data;
        };
        if forward && (checks.touches)(last) {
            return Stop::Touch { last };
        }
        let recent = &inside[inside.len() - length.min(inside.len())..];
        let gap = (track.times[next] - track.times[last]).abs();
        let is_gap = gap > 1.5 * track.step;
        if gap > options.longest_gap {
            return Stop::Gap {
                from: last,
                to: next,
            };
        }
        let follows = |index: usize| is_predicted(track, path, recent, index, noise);
        let following = (1..=CONSECUTIVE).filter_map(|by| step(last, by));
        let good = following.clone().find(|&index| follows(index));
        let good = good.or_else(|| (!(checks.is_break)(last, !forward)).then_some(next));
        let Some(good) = good else {
            return match is_gap {
                true => Stop::Gap {
                    from: last,
                    to: next,
                },
                false => Stop::Deviation { last },
            };
        };
        inside.push(good);
    }
}

/// Whether the sample of the trajectory `path` (m) at the track index `index` agrees with its prediction: the
/// extrapolation of a quadratic in time fitted to the samples with the track indices `recent`. `noise` is the standard
/// deviation of a measured position, m.
fn is_predicted(
    track: &Track,
    path: &[[f64; 3]],
    recent: &[usize],
    index: usize,
    noise: f64,
) -> bool {
    let t0 = track.times[index];
    let ends = [recent[0], recent[recent.len() - 1]];
    let scale = (track.times[ends[0]] - track.times[ends[1]])
        .abs()
        .max(track.step);
    let fitted = quadratic(track, path, recent.iter().copied(), t0, scale);
    let Some((coefficients, factor)) = fitted else {
        return false;
    };
    let leverage = factor.inverse()[(0, 0)];
    let ahead = (t0 - track.times[ends[1]]).abs();
    let allowed = STRANGE * noise * (1.0 + leverage).sqrt() + JERK * ahead.powi(3) / 6.0;
    (0..3).all(|axis| (coefficients[(0, axis)] - path[index][axis]).abs() <= allowed)
}

/// Robust standard deviation of a measured position in a range of track indices, m, from third differences of
/// consecutive samples.
fn noise(track: &Track, path: &[[f64; 3]], run: &Range<usize>) -> f64 {
    let half = half(track);
    let wide = run.start.saturating_sub(half / 2)..(run.end + half / 2).min(path.len());
    let mut sizes: Vec<f64> = Vec::new();
    for i in wide.start + 3..wide.end {
        let span = track.times[i] - track.times[i - 3];
        if span > 3.5 * track.step {
            continue;
        }
        let [a, b, c, d] = [path[i], path[i - 1], path[i - 2], path[i - 3]];
        // The variance of a third difference is 20 times that of a sample.
        let third = |axis: usize| a[axis] - 3.0 * b[axis] + 3.0 * c[axis] - d[axis];
        sizes.extend([0, 1, 2].map(|axis| third(axis).abs() / 20.0_f64.sqrt()));
    }
    (1.4826 * median(&mut sizes)).max(FINEST)
}
