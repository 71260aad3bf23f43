//! Throws in a take: where the hand lets go, and where the free flight ends.
//!
//! No model of the body is used. The motion of a rigid cluster of points, or of a tracked pose, is free flight where it is
//! smooth, moves, and its acceleration without gravity is one that air can cause: not along the velocity, which is the
//! hand's, and not greater than the bound of [`windows`]. From the middle of such a run the flight is followed in both
//! directions for as long as the samples agree with their prediction, or deviate as air may make them; the cut is then
//! where a change of velocity or acceleration explains the samples on both sides best.

mod breaks;
mod cluster;
mod cut;
mod follow;
mod motion;
mod track;
mod windows;

use std::ops::Range;

use crate::take::Take;
use cut::{Change, changes};
use follow::{Checks, Stop, follow};
pub use motion::{Motion, motion};
use track::Track;
pub(crate) use track::fitted;
use windows::{Window, windows};

/// Limits of the search for throws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThrowOptions {
    /// Shortest free flight, s.
    pub shortest: f64,
    /// Longest gap that a flight is followed across, s.
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

/// What is at the beginning or the end of a throw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    /// The hand: its acceleration, m/s², ends here.
    Hand(f64),
    /// The vertical velocity jumps upwards by so much, m/s: the ground.
    Ground(f64),
    /// The body is stopped: its acceleration, m/s², jumps against its velocity, as in a net or a hand.
    Stopped(f64),
    /// The velocity jumps against itself by so much, m/s: an obstacle.
    Struck(f64),
    /// The velocity or the acceleration changes otherwise.
    Disturbed,
    /// The body is not seen for so long, s.
    Gap(f64),
    /// The recording begins or ends here.
    Recording,
}

/// A cut of a take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Sample of the take: the first or the last of the free flight.
    pub sample: usize,
    /// Time of the change, s.
    pub time: f64,
    /// What changes there.
    pub cause: Cause,
}

/// A free flight in a take.
#[derive(Clone, Debug, PartialEq)]
pub struct Throw {
    /// Its beginning.
    pub release: Cut,
    /// Its end.
    pub end: Cut,
    /// Samples within the flight where the body is not seen.
    pub unseen: usize,
    /// Mean acceleration over the flight, m/s², along the axes of the take.
    pub acceleration: [f64; 3],
}

impl Throw {
    /// Samples of the flight.
    pub fn samples(&self) -> Range<usize> {
        self.release.sample..self.end.sample + 1
    }
}

/// The throws of a take, and what was decided in looking for them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Throws {
    /// The throws, in the order of time.
    pub throws: Vec<Throw>,
    /// Labels of the points that move as one body.
    pub labels: Vec<String>,
    /// What was left out, and why.
    pub notes: Vec<String>,
}

/// Finds the throws of a take with z up. The points or bodies of `labels` are followed, or where it is empty the largest set
/// of points that move as one.
pub fn find_throws(take: &Take, labels: &[&str], options: &ThrowOptions) -> Throws {
    let mut found = Throws::default();
    let Some(track) = Track::new(take, labels, &mut found.notes) else {
        return found;
    };
    found.labels = track.labels.clone();
    let windows = windows(&track);
    let mut runs = runs(&track, &windows, options);
    // The longest first, so that a short run at a flight's edge becomes part of it.
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

/// Runs of windows that are free flight.
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

/// The throw around a run, with its range of the track.
fn throw(
    track: &Track,
    windows: &[Option<Window>],
    run: &Range<usize>,
    options: &ThrowOptions,
) -> Option<(Range<usize>, Throw)> {
    let path = track.path(windows::offset(windows, run));
    let ground = breaks::lowest(&path);
    let is_ground = breaks::is_ground(&track.times, &path, ground);
    let checks = Checks {
        is_break: &|last, early| breaks::is_break(track, &path, last, ground, early),
        touches: &|last| is_ground && breaks::touches(track, &path, last, ground),
    };
    let (start, end) = follow(track, &path, run, options, &checks);
    let early = changes(track, &path, &start, true);
    let late = changes(track, &path, &end, false);
    let (first, last) = (early.inside, late.inside);
    if first >= last {
        return None;
    }
    let samples = [track.samples[first], track.samples[last]];
    let unseen = samples[1] + 1 - samples[0] - (last + 1 - first);
    let acceleration = cut::mean_acceleration(track, &path, first..last + 1)?;
    let make = |change: &Change, sample: usize, cause: Cause| Cut {
        sample,
        time: change.time,
        cause,
    };
    let release = make(&early, samples[0], cause(track, &start, &early, true));
    let end = make(&late, samples[1], cause(track, &end, &late, false));
    let throw = Throw {
        release,
        end,
        unseen,
        acceleration,
    };
    Some((first..last + 1, throw))
}

/// What a change at the beginning (`early`) or end of a flight is.
fn cause(track: &Track, stop: &Stop, change: &Change, early: bool) -> Cause {
    match stop {
        Stop::Data => Cause::Recording,
        Stop::Gap { from, to } => Cause::Gap((track.times[*to] - track.times[*from]).abs()),
        Stop::Deviation { .. } | Stop::Touch { .. } => {
            let speed = norm(change.velocity);
            let along = |v: [f64; 3]| match speed > 0.0 {
                true => dot(v, change.velocity) / speed,
                false => 0.0,
            };
            let pull = along(change.acceleration);
            // Over few samples, the hand's acceleration may look like a jump; one upwards is a bounce.
            let pushed = match change.velocity_jump {
                Some(jump) => along(jump) > 0.0 && jump[2].abs() < 0.7 * norm(jump),
                None => pull > 0.0,
            };
            if early && pushed {
                return Cause::Hand(norm(change.acceleration));
            }
            match change.velocity_jump {
                Some(jump) if !early && jump[2] > 0.5 * norm(jump) && change.velocity[2] < 0.0 => {
                    Cause::Ground(jump[2])
                }
                Some(jump) if !early && along(jump) < 0.0 => Cause::Struck(norm(jump)),
                None if !early && pull < 0.0 => Cause::Stopped(norm(change.acceleration)),
                _ => Cause::Disturbed,
            }
        }
    }
}

/// Keeps the flights that are long enough and do not follow an impact of an earlier one.
fn select(found: &mut Throws, options: &ThrowOptions) {
    let mut kept: Vec<Throw> = Vec::new();
    let mut last_end: Option<Cut> = None;
    for throw in std::mem::take(&mut found.throws) {
        let seconds = throw.end.time - throw.release.time;
        // A hand takes its time: what goes on at once after an impact is a bounce, whatever its beginning looks like.
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

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn norm(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
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
