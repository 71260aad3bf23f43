//! Faults of the recorded values themselves: repeated coordinates, dropouts written as zeros, a copied flight, jumps.

use nalgebra::Vector3;

use super::Body;
use super::track::Track;
use crate::contact::PathPoint;
use crate::fault::{DataFault, FaultKind};
use crate::levels::MAX_GAP;
use crate::pose::distance;
use crate::statistics::{median_of, median_vector};
use crate::{Dataset, Flight};

/// Minimum number of identical positions of a frozen track.
const FROZEN_SAMPLES: usize = 4;
/// Minimum motion in the same time elsewhere in the flight, m, of a frozen track.
const FROZEN_DISTANCE: f64 = 0.005;
/// Minimum motion of repeated positions, in units of the resolution of the coordinates.
const FROZEN_STEPS: f64 = 10.0;
/// Minimum fraction of the intervals without motion, of a flight with repeated values.
const REPEATED_FRACTION: f64 = 0.3;
/// Minimum number of samples at which a flight is checked for being a copy of an earlier flight.
const COPY_SAMPLES: usize = 8;

pub fn check(body: &dyn Body, dataset: &Dataset, flight: usize) -> Option<DataFault> {
    copy(body, dataset, flight)
        .or_else(|| (0..dataset.markers.len()).find_map(|marker| frozen(dataset, flight, marker)))
}

/// Fault of a flight that equals an earlier one; simulations without noise may be equal.
fn copy(body: &dyn Body, dataset: &Dataset, flight: usize) -> Option<DataFault> {
    let this = &dataset.flights[flight];
    if this.times.len() < COPY_SAMPLES {
        return None;
    }
    let mut earlier = dataset.flights[..flight].iter();
    let original = earlier
        .find(|other| other.positions == this.positions && other.readings == this.readings)?;
    if !is_noisy(&body.points().of(this)) {
        return None;
    }
    Some(DataFault::new(
        this,
        FaultKind::Other,
        format!("its samples are a copy of those of {}", original.file),
        format!("remove one of {} and {}", original.file, this.file),
    ))
}

/// Whether third differences exceed 0.1 mm; those of a smooth path are smaller at the rates of cameras.
fn is_noisy(rows: &[Vec<Option<[f64; 3]>>]) -> bool {
    let third = |w: &[Vec<Option<[f64; 3]>>]| {
        let [a, b, c, d] = [w[0][0]?, w[1][0]?, w[2][0]?, w[3][0]?];
        let axis = |k: usize| (d[k] - 3.0 * c[k] + 3.0 * b[k] - a[k]).abs();
        Some(axis(0).max(axis(1)).max(axis(2)))
    };
    median_of(rows.windows(4).filter_map(third)).is_some_and(|size| size > 1e-4)
}

/// Run of consecutive identical positions of a marker.
struct Run {
    start: usize,
    samples: usize,
}

fn frozen(dataset: &Dataset, flight: usize, marker: usize) -> Option<DataFault> {
    let this = &dataset.flights[flight];
    let track: Vec<(usize, [f64; 3])> = (this.positions.iter().enumerate())
        .filter_map(|(sample, row)| Some((sample, row[marker]?)))
        .collect();
    if track.len() < FROZEN_SAMPLES {
        return None;
    }
    let name = &dataset.markers[marker].name;
    let fault = |detail: String, correction: &str| {
        Some(DataFault::new(this, FaultKind::Frozen, detail, correction))
    };
    let zeros = track.iter().filter(|(_, point)| *point == [0.0; 3]).count();
    let far = |point: &[f64; 3]| point.iter().any(|axis| axis.abs() > 0.05);
    if zeros >= 2 && 2 * zeros < track.len() && track.iter().filter(|(_, p)| far(p)).count() > zeros
    {
        return fault(
            format!(
                "marker {name} is at exactly (0, 0, 0) in {zeros} samples, as where dropouts are written as zeros"
            ),
            "leave the cells of a marker that was not seen empty",
        );
    }
    let whole = track.len();
    if track.iter().all(|(_, point)| *point == track[0].1) {
        return fault(
            format!("marker {name} has the same coordinates in all {whole} samples"),
            "export the recording again, or remove the flight",
        );
    }
    let (detail, correction) = match repeated(&track, FROZEN_DISTANCE)? {
        Repeated::Often { still, pairs } => (
            format!("marker {name} repeats its coordinates in {still} of {pairs} intervals"),
            "keep only the samples at which the cameras recorded, or leave repeated cells empty"
                .to_owned(),
        ),
        Repeated::Once { first, last, usual } => (
            format!(
                "marker {name} stays at the same coordinates from t = {:.3} s to {:.3} s, where it moves by {usual:.2} m otherwise",
                this.times[first], this.times[last]
            ),
            format!("leave the cells of {name} empty there"),
        ),
    };
    fault(detail, &correction)
}

/// Values that a recording repeats although they change elsewhere.
pub enum Repeated {
    /// In `still` of `pairs` intervals.
    Often { still: usize, pairs: usize },
    /// From the sample `first` to the sample `last`; they change by `usual` in that time elsewhere.
    Once {
        first: usize,
        last: usize,
        usual: f64,
    },
}

/// How `track`, entries of (index of the sample, values), repeats its values; `None` if it does not, or changes by less
/// than `least` elsewhere.
pub fn repeated(track: &[(usize, [f64; 3])], least: f64) -> Option<Repeated> {
    let (runs, still) = runs(track);
    let pairs = track.len().saturating_sub(1);
    let step = FROZEN_STEPS * resolution(track);
    if still as f64 > REPEATED_FRACTION * pairs as f64 && moves_by(track, 1) > step {
        return Some(Repeated::Often { still, pairs });
    }
    let longest = runs.into_iter().max_by_key(|run| run.samples)?;
    if longest.samples < FROZEN_SAMPLES {
        return None;
    }
    let usual = moves_by(track, longest.samples - 1);
    let (first, last) = (longest.start, longest.start + longest.samples - 1);
    (usual >= least.max(step)).then(|| Repeated::Once {
        first: track[first].0,
        last: track[last].0,
        usual,
    })
}

/// Runs of identical positions, and the number of intervals within them. `track` contains (index of the sample,
/// position in m).
fn runs(track: &[(usize, [f64; 3])]) -> (Vec<Run>, usize) {
    let (mut runs, mut still, mut start) = (Vec::new(), 0, 0);
    for end in 1..=track.len() {
        if end < track.len() && track[end].1 == track[start].1 {
            continue;
        }
        let samples = end - start;
        if samples > 1 {
            still += samples - 1;
            runs.push(Run { start, samples });
        }
        start = end;
    }
    (runs, still)
}

/// Median distance, m, of different positions `intervals` entries apart.
fn moves_by(track: &[(usize, [f64; 3])], intervals: usize) -> f64 {
    let pairs = track.iter().zip(&track[intervals.min(track.len())..]);
    let moved = pairs.map(|((_, a), (_, b))| distance(*a, *b));
    median_of(moved.filter(|distance| *distance > 0.0)).unwrap_or(0.0)
}

/// Smallest nonzero change of a coordinate between successive entries, m; 0 if there is none.
fn resolution(track: &[(usize, [f64; 3])]) -> f64 {
    let pairs = track.windows(2);
    let steps = pairs.flat_map(|pair| [0, 1, 2].map(|k| (pair[1].1[k] - pair[0].1[k]).abs()));
    // Differences below 0.1 µm are rounding errors of the values.
    let least = steps.filter(|step| *step > 1e-7).min_by(f64::total_cmp);
    least.unwrap_or(0.0)
}

// Jumps of a whole track within one sampling interval: another body, or frames that are missing.

/// Number of points on each side of a possible jump, which is the distance between the lines through them.
const SIDE: usize = 8;
/// Minimum jump: in units of the noise of the path, in m, and in units of the motion in its sampling interval.
const JUMP_SIZE: (f64, f64, f64) = (15.0, 0.08, 0.5);

/// Minimum jump by whole frames, in units of the noise: no motion looks like a missing frame.
const FRAMES: f64 = 10.0;
/// Maximum difference between a jump and the motion in whole frames, in frames.
const WHOLE: f64 = 0.2;
/// Minimum cosine of the angle between a jump and the velocity, of missing frames.
const AHEAD: f64 = 0.97;

pub fn jumps(track: &Track, flight: &Flight) -> Option<DataFault> {
    let points = &track.points;
    if points.len() < 2 * SIDE {
        return None;
    }
    let usual = median_of(points.windows(2).map(|w| w[1].time - w[0].time))?;
    let least = (JUMP_SIZE.0 * track.noise).max(JUMP_SIZE.1);
    for index in SIDE..=points.len() - SIDE {
        let interval = points[index].time - points[index - 1].time;
        if interval > MAX_GAP * usual {
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
        // Lines fitted to a curved path miss its end points, by equal amounts on sides of equal length.
        let span = |side: &[PathPoint]| side[SIDE - 1].time - side[0].time;
        let longest = span(&points[index - SIDE..index]).max(span(&points[index..index + SIDE]));
        let curved = (after - before).norm() * longest / 6.0;
        if jump.norm() < least.max(JUMP_SIZE.2 * step.norm()) + curved {
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

/// Length, m, by which the body moves farther before the point `index` than at its speed beside it, if that is the motion
/// of whole frames. The shortest of the three intervals is a frame.
fn missing_frames(points: &[PathPoint], index: usize, least: f64) -> Option<f64> {
    let interval = |k: usize| points[k].time - points[k - 1].time;
    let velocity = |k: usize| (points[k].position - points[k - 1].position) / interval(k);
    let (before, after) = (velocity(index - 1), velocity(index + 1));
    let usual = 0.5 * (before + after);
    let frame = interval(index)
        .min(interval(index - 1))
        .min(interval(index + 1));
    let step = usual * frame;
    let ahead = (velocity(index) - usual) * interval(index);
    let frames = (ahead.dot(&step) / step.norm_squared()).round();
    let is_whole = (ahead - frames * step).norm() < WHOLE * step.norm();
    let is_steady = (after - before).norm() < WHOLE * usual.norm();
    let size = ahead.norm();
    (frames >= 1.0 && is_whole && is_steady && size > least).then_some(size)
}

/// Quick test for a jump of at least `least`, m, by the displacements beside it.
fn may_jump(points: &[PathPoint], index: usize, least: f64) -> bool {
    let time = |k: usize| points[k].time - points[k - 1].time;
    let rate = |k: usize| (points[k].position - points[k - 1].position) / time(k);
    let rough = rate(index) - 0.5 * (rate(index - 1) + rate(index + 1));
    rough.norm() * time(index) > 0.5 * least
}

/// Position at `time`, m, and velocity, m/s, of a Theil–Sen line through points.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_track_that_stays_is_dated_from_its_first_sample_to_its_last() {
        let track = (10..90).map(|sample: usize| {
            let at = if (30..=40).contains(&sample) {
                30
            } else {
                sample
            };
            (
                sample,
                [0.02 * at as f64, 0.0, 0.5 + 1e-3 * (at as f64).sin()],
            )
        });
        let found = repeated(&track.collect::<Vec<_>>(), FROZEN_DISTANCE);
        let Some(Repeated::Once { first, last, usual }) = found else {
            panic!("it stays once");
        };
        assert_eq!((first, last), (30, 40));
        assert!((usual - 0.2).abs() < 0.01, "{usual}");
    }

    #[test]
    fn a_jump_by_whole_frames_is_found_if_it_is_above_the_noise() {
        // Three frames are missing before the sixth point.
        let points = (0..12).map(|sample: usize| {
            let frames = if sample < 6 { sample } else { sample + 3 };
            PathPoint {
                sample,
                time: 0.01 * sample as f64,
                position: Vector3::new(0.1 * frames as f64, 0.0, 1.0),
                attitude: None,
            }
        });
        let points: Vec<PathPoint> = points.collect();
        let ahead = missing_frames(&points, 6, 0.015).expect("missing frames");
        assert!((ahead - 0.3).abs() < 1e-9, "{ahead}");
        assert_eq!(missing_frames(&points, 6, 0.5), None);
        assert_eq!(missing_frames(&points, 5, 0.015), None);
    }
}
