//! Jumps of a whole track within one sampling interval: another body, or frames that are missing.

use nalgebra::Vector3;

use super::track::Track;
use crate::data_fault::{DataFault, FaultKind};
use crate::ground_contact::PathPoint;
use dataset::Flight;
use dataset::statistics::{median_of, median_vector};

/// Number of points of the measured path that are used on each side of a possible jump of the position. A line is
/// fitted to the points before it and another to the points after it; the jump is the distance between the two lines at
/// the middle of the sampling interval between them.
const SIDE: usize = 8;
/// Minimum size of a jump in a measured path that is reported: the larger of the first number times the noise of the
/// path and the second number in m.
const JUMP: (f64, f64) = (15.0, 0.08);
/// Minimum size of a jump by whole frames ahead that is reported, in units of the noise of the path: no motion of a body
/// looks like a missing frame.
const FRAMES: f64 = 10.0;
/// Maximum difference between a jump and the motion in whole frames, in frames.
const WHOLE: f64 = 0.2;
/// Minimum size of a jump in a measured path that is reported, in units of the distance that the body moves in the
/// sampling interval of the jump.
const STEPS: f64 = 0.5;
/// Maximum ratio of a sampling interval to the median interval at which the interval is examined for a jump of the
/// position; longer intervals are gaps in the data.
const GAP: f64 = 1.5;
/// Minimum cosine of the angle between a jump of the position and the velocity at which the jump counts as forward
/// along the path. A forward jump suggests missing frames.
const AHEAD: f64 = 0.97;

/// Data fault for the first jump in the measured path of a body: an offset between the position extrapolated from the
/// points before a sampling interval and that extrapolated from the points after it. `None` if there is no jump.
pub fn check(track: &Track, flight: &Flight) -> Option<DataFault> {
    let points = &track.points;
    if points.len() < 2 * SIDE {
        return None;
    }
    let usual = median_of(points.windows(2).map(|w| w[1].time - w[0].time))?;
    let least = (JUMP.0 * track.noise).max(JUMP.1);
    for index in SIDE..=points.len() - SIDE {
        let interval = points[index].time - points[index - 1].time;
        if interval > GAP * usual {
            continue;
        }
        if let Some(ahead) = missing_frames(points, index, FRAMES * track.noise) {
            return Some(frames_are_missing(flight, ahead, points[index].time));
        }
        if !may_jump(points, index, least) {
            continue;
        }
        let time = points[index - 1].time + 0.5 * interval;
        let (from, before) = line(&points[index - SIDE..index], time);
        let (to, after) = line(&points[index..index + SIDE], time);
        let jump = to - from;
        let step = 0.5 * (before + after) * interval;
        // Lines fitted to a curved path miss its end points, by equal amounts on both sides if these are equally
        // long.
        let span = |side: &[PathPoint]| side[SIDE - 1].time - side[0].time;
        let longest = span(&points[index - SIDE..index]).max(span(&points[index..index + SIDE]));
        let curved = (after - before).norm() * longest / 6.0;
        if jump.norm() < least.max(STEPS * step.norm()) + curved {
            continue;
        }
        let size = jump.norm();
        let time = points[index].time;
        if jump.dot(&step) > AHEAD * size * step.norm() {
            return Some(frames_are_missing(flight, size, time));
        }
        return Some(DataFault::new(
            flight,
            FaultKind::Other,
            format!("the track jumps by {size:.2} m at t = {time:.3} s"),
            "end the table there, or check that the track is of one body",
        ));
    }
    None
}

fn frames_are_missing(flight: &Flight, ahead: f64, time: f64) -> DataFault {
    DataFault::new(
        flight,
        FaultKind::Other,
        format!(
            "the body jumps ahead by {ahead:.2} m at t = {time:.3} s, as where frames are missing and the times do not say so"
        ),
        "write the times at which the frames were recorded",
    )
}

/// Length, m, by which the body moves farther just before the path point with the index `index` than in the two adjacent
/// sampling intervals, if that is the motion of whole frames and more than `least`, m.
fn missing_frames(points: &[PathPoint], index: usize, least: f64) -> Option<f64> {
    let moved = |k: usize| points[k].position - points[k - 1].position;
    let (before, after) = (moved(index - 1), moved(index + 1));
    let step = 0.5 * (before + after);
    let ahead = moved(index) - step;
    let frames = (ahead.dot(&step) / step.norm_squared()).round();
    let is_whole = (ahead - frames * step).norm() < WHOLE * step.norm();
    let is_steady = (after - before).norm() < WHOLE * step.norm();
    let size = ahead.norm();
    (frames >= 1.0 && is_whole && is_steady && size > least).then_some(size)
}

/// Quick test for a possible jump of at least `least`, m, between the path point with the index `index` and the
/// previous one. Returns whether the displacement between them deviates enough from the displacements in the two
/// adjacent sampling intervals.
fn may_jump(points: &[PathPoint], index: usize, least: f64) -> bool {
    let time = |k: usize| points[k].time - points[k - 1].time;
    let rate = |k: usize| (points[k].position - points[k - 1].position) / time(k);
    let rough = rate(index) - 0.5 * (rate(index - 1) + rate(index + 1));
    rough.norm() * time(index) > 0.5 * least
}

/// Fits a Theil–Sen line, which is robust to a few outliers, to the positions of points as a function of time. Returns
/// its position at the time `time`, s, and its velocity, m/s.
fn line(points: &[PathPoint], time: f64) -> (Vector3<f64>, Vector3<f64>) {
    let slope = |axis: usize| {
        let pairs = points.iter().enumerate().flat_map(|(i, a)| {
            let later = points[i + 1..].iter();
            later.map(move |b| (b.position[axis] - a.position[axis]) / (b.time - a.time))
        });
        median_of(pairs).unwrap_or(0.0)
    };
    let velocity = Vector3::new(slope(0), slope(1), slope(2));
    let at = points
        .iter()
        .map(|point| point.position + velocity * (time - point.time));
    let position = median_vector(&at.collect::<Vec<_>>());
    (position.unwrap_or_default(), velocity)
}
