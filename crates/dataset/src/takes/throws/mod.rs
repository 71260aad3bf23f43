//! Detection of the throws in a take: the release from the hand, and the end of the free flight.
//!
//! No model of the body is used. The motion of a rigid cluster of points, or of a tracked pose, is free flight if it is
//! smooth, the body moves, and its acceleration without gravity is one that air can cause: not along the velocity, as
//! that of a hand, and not greater than the bound in [`windows`]. From the middle of such a run the flight is followed
//! in both directions as long as the samples agree with their prediction, or deviate in a way that air can cause. The
//! flight is then cut at the time at which a change of velocity or acceleration best explains the samples on both
//! sides.

mod breaks;
mod cluster;
mod cut;
mod follow;
mod motion;
mod path;
mod track;
mod windows;

use std::ops::Range;

use nalgebra::Vector3;

use crate::takes::take::Take;
use cut::{Change, Stop};
pub use motion::{Motion, motion};
use path::Path;
use track::Track;
pub(crate) use track::{centred, fitted, moments};
use windows::{Window, windows};

/// Acceleration of gravity that is assumed for recordings, m/s².
pub(crate) const GRAVITY: f64 = 9.81;
/// Lower bound to which an estimated standard deviation of a measured position is raised, m.
const FINEST: f64 = 5e-5;

/// Limits on the duration of flights and of gaps in them, for the search for throws in a recording.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThrowOptions {
    /// Minimum duration of a free flight that counts as a throw, s.
    pub shortest: f64,
    /// Maximum duration of a gap in the measurements across which a flight is followed, s.
    pub longest_gap: f64,
}

impl Default for ThrowOptions {
    fn default() -> Self {
        Self {
            shortest: 0.2,
            longest_gap: 0.15,
        }
    }
}

/// Cause of the beginning or the end of a throw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    /// The hand releases the body, with this jump of the acceleration, m/s²; 0 if the velocity was fitted to jump.
    Hand(f64),
    /// The body hits the ground: its vertical velocity jumps upwards by this amount, m/s.
    Ground(f64),
    /// The body is stopped, as by a net or a hand.
    Stopped(f64),
    /// The body hits an obstacle: its velocity jumps by this amount, m/s, against the direction of flight.
    Struck(f64),
    /// The velocity or the acceleration changes in a way that fits none of the other causes.
    Disturbed,
    /// The body is not seen for a while; the value is the time between the samples before and after this gap, s.
    Gap(f64),
    /// The recording begins or ends during the flight.
    Recording,
}

/// Beginning or end of a free flight in a recording, with its cause.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Index, in the recording, of the first or the last sample of the free flight.
    pub sample: usize,
    /// Time of the change of motion (release, impact) that begins or ends the free flight, s.
    pub time: f64,
    /// Cause of the change of motion that begins or ends the free flight, such as the hand or the ground.
    pub cause: Cause,
}

/// A throw: one free flight of a body in a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Throw {
    /// Beginning of the free flight, with its cause.
    pub release: Cut,
    /// End of the free flight, with its cause.
    pub end: Cut,
    /// Number of samples within the flight in which the body is not seen.
    pub unseen: usize,
    /// Mean acceleration over the flight, m/s², along the axes of the recording.
    pub acceleration: [f64; 3],
}

impl Throw {
    /// Range of the indices, in the recording, of the samples of the free flight.
    pub fn samples(&self) -> Range<usize> {
        self.release.sample..self.end.sample + 1
    }
}

/// Throws found in a recording, and notes on the search for them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Throws {
    /// Throws in the order of time.
    pub throws: Vec<Throw>,
    /// Labels of the points that move as one body, or of the tracked body.
    pub labels: Vec<String>,
    /// Notes on motions that do not count as throws, such as free motion of too short a duration, with the reason.
    pub notes: Vec<String>,
}

/// Finds the throws in a recording with z up. The moving body is that of the points or the body named in `labels`;
/// without any, the first tracked body or else the largest set of points that move as one.
pub fn find_throws(take: &Take, labels: &[&str], options: &ThrowOptions) -> Throws {
    let mut found = Throws::default();
    let Some(track) = Track::new(take, labels, &mut found.notes) else {
        return found;
    };
    found.labels = track.labels.clone();
    let windows = windows(&track);
    let mut runs = runs(&track, &windows, options);
    // The longest runs come first, so that a short run at the edge of a flight becomes part of it.
    runs.sort_by(|a, b| b.len().cmp(&a.len()).then(a.start.cmp(&b.start)));
    let mut taken: Vec<Range<usize>> = Vec::new();
    for run in runs {
        if taken
            .iter()
            .any(|other| run.start < other.end && other.start < run.end)
        {
            continue;
        }
        if let Some((range, throw)) = throw(&track, &windows, &run, options) {
            taken.push(range);
            found.throws.push(throw);
        }
    }
    found.throws.sort_by_key(|throw| throw.release.sample);
    select(&mut found, options);
    found
}

/// Ranges, in the track, of at least 3 consecutive samples in free flight by the local quadratic fits `windows`.
fn runs(track: &Track, windows: &[Option<Window>], options: &ThrowOptions) -> Vec<Range<usize>> {
    let noise = windows::noise(windows);
    let mut runs: Vec<Range<usize>> = Vec::new();
    for (i, window) in windows.iter().enumerate() {
        if !window.as_ref().is_some_and(|window| window.is_free(noise)) {
            continue;
        }
        match runs.last_mut() {
            Some(run)
                if run.end == i && track.times[i] - track.times[i - 1] <= options.longest_gap =>
            {
                run.end = i + 1;
            }
            _ => runs.push(i..i + 1),
        }
    }
    runs.retain(|run| run.len() >= 3);
    runs
}

/// Locates the ends of the free flight around `run`, a range of samples in free flight.
fn throw(
    track: &Track,
    windows: &[Option<Window>],
    run: &Range<usize>,
    options: &ThrowOptions,
) -> Option<(Range<usize>, Throw)> {
    let path = Path::new(track, windows::offset(windows, run));
    let (start, end) = path.follow(run, options);
    let (early, late) = (path.change(&start, true), path.change(&end, false));
    let (first, last) = (early.inside, late.inside);
    if first >= last {
        return None;
    }
    let samples = [track.samples[first], track.samples[last]];
    let (quadratic, _) = path.quadratic(first..=last, track.times[first], 1.0)?;
    let cut = |change: &Change, sample: usize, cause: Cause| Cut {
        sample,
        time: change.time,
        cause,
    };
    let throw = Throw {
        release: cut(&early, samples[0], cause(track, &start, &early, true)),
        end: cut(&late, samples[1], cause(track, &end, &late, false)),
        unseen: samples[1] + 1 - samples[0] - (last + 1 - first),
        acceleration: [0, 1, 2].map(|axis| 2.0 * quadratic[(2, axis)]),
    };
    Some((first..last + 1, throw))
}

/// Cause of the `change` of motion at the beginning (if `early` is true) or at the end of a flight.
fn cause(track: &Track, stop: &Stop, change: &Change, early: bool) -> Cause {
    let jump = match stop {
        Stop::Data => return Cause::Recording,
        Stop::Gap { from, to } => {
            return Cause::Gap((track.times[*to] - track.times[*from]).abs());
        }
        Stop::Deviation { .. } | Stop::Touch { .. } => change.velocity_jump,
    };
    let course = change.velocity.try_normalize(0.0).unwrap_or_default();
    let along = |v: Vector3<f64>| v.dot(&course);
    let (pull, strength) = (along(change.acceleration), change.acceleration.norm());
    // Over few samples, the hand's acceleration may look like a jump; an upward jump is a bounce.
    let is_pushed = jump.map_or(pull > 0.0, |jump| {
        along(jump) > 0.0 && jump.z.abs() < 0.7 * jump.norm()
    });
    match jump {
        _ if early && is_pushed => Cause::Hand(strength),
        _ if early => Cause::Disturbed,
        Some(jump) if jump.z > 0.5 * jump.norm() && change.velocity.z < 0.0 => {
            Cause::Ground(jump.z)
        }
        Some(jump) if along(jump) < 0.0 => Cause::Struck(jump.norm()),
        None if pull < 0.0 => Cause::Stopped(strength),
        _ => Cause::Disturbed,
    }
}

/// Removes flights that are too short and flights that only follow the impact of an earlier flight.
fn select(found: &mut Throws, options: &ThrowOptions) {
    let mut kept: Vec<Throw> = Vec::new();
    let mut last_end: Option<Cut> = None;
    for throw in std::mem::take(&mut found.throws) {
        let seconds = throw.end.time - throw.release.time;
        // A hand needs time: motion that continues at once after an impact is a bounce, whatever its beginning looks
        // like.
        let long =
            |cause: Cause| matches!(cause, Cause::Gap(seconds) if seconds > options.longest_gap);
        let bounced = last_end.is_some_and(|end| {
            let near = throw.release.time - end.time < options.shortest;
            let seen = !matches!(throw.release.cause, Cause::Hand(_) | Cause::Gap(_));
            near && (seen || !long(end.cause))
        });
        last_end = Some(throw.end);
        let why = if bounced {
            "it follows the end of a flight without a hand"
        } else if seconds < options.shortest {
            "it is too short"
        } else {
            kept.push(throw);
            continue;
        };
        found.notes.push(format!(
            "free motion from {:.3} s to {:.3} s is no throw: {why}",
            throw.release.time, throw.end.time
        ));
    }
    found.throws = kept;
}

impl std::fmt::Display for Cause {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Hand(acceleration) => write!(
                f,
                "the hand lets go: its acceleration of {acceleration:.0} m/s² along the velocity ends"
            ),
            Self::Ground(jump) => write!(
                f,
                "the ground: the vertical velocity jumps upwards by {jump:.1} m/s"
            ),
            Self::Stopped(acceleration) => write!(
                f,
                "stopped, as by a net or a hand: {acceleration:.0} m/s² against the velocity"
            ),
            Self::Struck(jump) => {
                write!(f, "struck: the velocity changes by {jump:.1} m/s at once")
            }
            Self::Disturbed => f.write_str("the motion changes suddenly"),
            Self::Gap(seconds) => write!(f, "not seen for {seconds:.3} s"),
            Self::Recording => f.write_str("the recording has no more"),
        }
    }
}
