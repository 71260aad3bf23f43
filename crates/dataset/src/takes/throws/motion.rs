//! Height, speed and rate of rotation of a followed body over a whole take, for figures.

use nalgebra::Vector3;

use super::track::Track;
use crate::takes::take::Take;

/// Maximum time between two samples, in sampling intervals, for the speed between them; a longer one is a gap.
const GAP: f64 = 1.5;

/// Time series of the motion of a body in a recording; values are not finite where the body is not seen.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    /// Times, s: of the samples that show the body, and the middle of each gap, where the other values are NaN.
    pub times: Vec<f64>,
    /// Height (z coordinate in the recording) of the centroid of the tracked points at each of `times`, m.
    pub heights: Vec<f64>,
    /// Speed of the centroid of the tracked points at each of `times`, m/s.
    pub speeds: Vec<f64>,
    /// Rate of rotation, rad/s, from consecutive attitudes; `None` without these. Above π per interval it is aliased.
    pub rotation: Option<Vec<f64>>,
}

/// Motion of the points or bodies named in `labels`, with z up; `None` if fewer than two samples show all of them.
pub fn motion(take: &Take, labels: &[&str]) -> Option<Motion> {
    let track = Track::new(take, labels, &mut Vec::new())?;
    let (mut motion, mut rates) = (Motion::default(), Vec::new());
    let times = &track.times;
    let near = |i: usize, j: usize| times[j] - times[i] <= GAP * track.step;
    let last = times.len() - 1;
    let mut push = |time: f64, height: f64, speed: f64, rate: f64| {
        motion.times.push(time);
        motion.heights.push(height);
        motion.speeds.push(speed);
        rates.push(rate);
    };
    for i in 0..=last {
        let (before, next) = (i.saturating_sub(1), (i + 1).min(last));
        let from = if near(before, i) { before } else { i };
        let to = if near(i, next) { next } else { i };
        let moved = (track.centres[to] - track.centres[from]).norm();
        let turned = match next > i && near(i, next) {
            true => turn(&track, i, next) / (times[next] - times[i]),
            false => f64::NAN,
        };
        push(
            times[i],
            track.centres[i].z,
            moved / (times[to] - times[from]),
            turned,
        );
        if next > i && !near(i, next) {
            push(0.5 * (times[i] + times[next]), f64::NAN, f64::NAN, f64::NAN);
        }
    }
    motion.rotation = track.has_attitude().then_some(rates);
    Some(motion)
}

/// Angle of the rotation between the attitudes of the body at two indices of the track, rad.
fn turn(track: &Track, i: usize, j: usize) -> f64 {
    let relative = track.rotation(j) * track.rotation(i).transpose();
    // The sine determines the angle accurately near 0, where the cosine alone does not.
    let sine = Vector3::new(
        relative[(2, 1)] - relative[(1, 2)],
        relative[(0, 2)] - relative[(2, 0)],
        relative[(1, 0)] - relative[(0, 1)],
    );
    sine.norm().atan2(relative.trace() - 1.0)
}
