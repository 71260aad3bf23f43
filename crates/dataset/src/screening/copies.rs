//! Flights that are near copies of others: one throw exported twice, with another filter, rounding, clock or rate. Two
//! throws are never alike to within the noise, and the noise of one is independent of that of the other.

use std::ops::Range;

use crate::Dataset;
use crate::statistics::{median_of, robust_sigma};
use flight::parallel;
use nalgebra::Vector3;

use super::track::Track;
use crate::contact::PathPoint;
use crate::fault::{DataFault, FaultKind};
use crate::levels::{LEAST_NOISE, MAX_GAP, MIN_SERIES, SIGNIFICANT};

/// Ratio of the variance of the difference of two paths to the sum of their noise variances below which they share their
/// noise; it is 1 for equal motions with independent noise. Rounding to 1 mm leaves 0.14 of noise of 0.5 mm.
const SHARED: f64 = 0.25;
/// Numbers of successive differences over which a mean is taken, where one path is smoother than the other: a filter
/// keeps the slow part of the noise.
const BLOCKS: [usize; 4] = [4, 8, 16, 32];
/// Minimum number of means.
const MIN_BLOCKS: usize = 8;
/// Ratio of the noise of two paths above which one was filtered.
const FILTERED: f64 = 2.0;
/// Time, s, of the displacements that tell which paths can be of one throw.
const CHORD: f64 = 0.25;
/// Number of steps that refine the shift of the clock.
const STEPS: usize = 4;
/// Number of points by which paths are compared first, and size of their differences, in units of the noise of both, above
/// which the paths are not of one throw. Throws of a machine are near each other, and many.
const FIRST: (usize, f64) = (8, 3.0);

/// Turns the later flight of each pair of near copies into a fault.
pub fn reject(
    dataset: &Dataset,
    faults: &mut [Option<DataFault>],
    tracks: &mut [Option<Track>],
    threads: usize,
) {
    let paths: Vec<Option<Path<'_>>> = tracks
        .iter()
        .map(|track| Path::of(track.as_ref()?))
        .collect();
    let originals = parallel::each_on(threads, paths.len(), |later| {
        let own = paths[later].as_ref()?;
        let is_original = |earlier: &Option<Path<'_>>| {
            earlier.as_ref().is_some_and(|other| are_copies(other, own))
        };
        paths[..later].iter().position(is_original)
    });
    for (later, original) in originals.into_iter().enumerate() {
        let Some(original) = original else { continue };
        let [original, flight] = [original, later].map(|index| &dataset.flights[index]);
        faults[later] = Some(DataFault::new(
            flight,
            FaultKind::Other,
            format!(
                "its path is that of {} to within the noise, which both share, as of one throw that was exported twice",
                original.file
            ),
            format!("remove one of {} and {}", original.file, flight.file),
        ));
        tracks[later] = None;
    }
}

/// Points of a path, with their usual interval, s, the noise of a coordinate, m, and the longest step between two, m.
struct Path<'t> {
    points: &'t [PathPoint],
    interval: f64,
    noise: f64,
    step: f64,
    /// Chord of the first point.
    start: Chord,
    pieces: Vec<Piece>,
}

/// Position, m, and the displacement over [`CHORD`] that follows, m, which is NaN near the end of the path.
type Chord = [f64; 6];

/// Points of a path within [`CHORD`], with the bounds of their chords, m, of those that are known.
struct Piece {
    points: Range<usize>,
    low: Chord,
    high: Chord,
}

impl<'t> Path<'t> {
    /// The path of a track; `None` if it has few points or, as a simulated one, no noise.
    fn of(track: &'t Track) -> Option<Self> {
        let path = Self::new(&track.points, track.noise)?;
        (path.points.len() >= MIN_SERIES && path.noise > LEAST_NOISE).then_some(path)
    }

    fn new(points: &'t [PathPoint], noise: f64) -> Option<Self> {
        let intervals = points.windows(2).map(|pair| pair[1].time - pair[0].time);
        let steps = points.windows(2);
        let steps = steps.map(|pair| (pair[1].position - pair[0].position).norm());
        Some(Self {
            points,
            interval: median_of(intervals)?,
            noise,
            step: steps.fold(0.0, f64::max),
            start: chord(points, 0),
            pieces: pieces(points),
        })
    }
}

fn chord(points: &[PathPoint], index: usize) -> Chord {
    let first = &points[index];
    let later = &points[index + within_chord(&points[index..])..];
    let along = later.first().map(|then| then.position - first.position);
    let (at, along) = (first.position, along.unwrap_or(Vector3::repeat(f64::NAN)));
    [at.x, at.y, at.z, along.x, along.y, along.z]
}

/// Number of the points within [`CHORD`] of the first one, which is always one of them.
fn within_chord(points: &[PathPoint]) -> usize {
    let within = points.partition_point(|point| point.time - points[0].time < CHORD);
    within.max(1)
}

fn pieces(points: &[PathPoint]) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut from = 0;
    while from < points.len() {
        let own = from..from + within_chord(&points[from..]);
        from = own.end;
        let (mut low, mut high) = ([f64::NAN; 6], [f64::NAN; 6]);
        for index in own.clone() {
            for (k, value) in chord(points, index).into_iter().enumerate() {
                (low[k], high[k]) = (low[k].min(value), high[k].max(value));
            }
        }
        pieces.push(Piece {
            points: own,
            low,
            high,
        });
    }
    pieces
}

/// Whether two paths are of one throw, with a shift of the clock.
fn are_copies(one: &Path<'_>, other: &Path<'_>) -> bool {
    // The path with more samples is read at the times of the other one.
    let (dense, sparse) = match one.interval <= other.interval {
        true => (one, other),
        false => (other, one),
    };
    let starts = [
        shift_at_start(sparse, dense),
        shift_at_start(dense, sparse).map(|shift| -shift),
    ];
    let mut shifts = starts.into_iter().flatten();
    shifts.any(|shift| {
        are_near(dense, sparse, shift)
            && are_close(dense, sparse, shift)
            && share_noise(dense, sparse, refined((dense, sparse, 1), shift, STEPS))
    })
}

/// What is added to the times of `path` so that its first point is at the nearest one of `other`; `None` if they are far
/// apart, or part.
fn shift_at_start(path: &Path<'_>, other: &Path<'_>) -> Option<f64> {
    let reach = reach(path, other);
    // Bounds are computed for all pairs of flights, distances for few. Both points of a chord are as far off as one.
    let is_near = |piece: &&Piece| {
        let bounds = piece.low.iter().zip(&piece.high);
        let mut each = path.start.iter().zip(bounds);
        // Unknown displacements are within all bounds.
        !each.any(|(own, (low, high))| own - high > 2.0 * reach || low - own > 2.0 * reach)
    };
    let near = other.pieces.iter().filter(is_near);
    let each = near.flat_map(|piece| &other.points[piece.points.clone()]);
    let first = path.points.first()?;
    let away = each.map(|point| ((point.position - first.position).norm_squared(), point));
    let (squared, near) = away.min_by(|a, b| a.0.total_cmp(&b.0))?;
    (squared.sqrt() <= reach).then_some(near.time - first.time)
}

/// Distance of two points of one path, m, that are at most an interval and the noise apart.
fn reach(one: &Path<'_>, other: &Path<'_>) -> f64 {
    one.step.max(other.step) + SIGNIFICANT * (one.noise + other.noise)
}

/// Whether the paths, aligned at a start, are near each other in the middle of what they have in common.
fn are_near(dense: &Path<'_>, sparse: &Path<'_>, shift: f64) -> bool {
    let [first, last] = [dense.points[0], dense.points[dense.points.len() - 1]];
    let before = |time: f64| sparse.points.partition_point(|own| own.time + shift < time);
    let (from, to) = (before(first.time), before(last.time));
    let common = sparse.points.get(from..to).unwrap_or_default();
    let middle = common.get(common.len() / 2).map(|point| PathPoint {
        time: point.time + shift,
        ..*point
    });
    middle.is_some_and(|point| {
        let next = dense.points.partition_point(|own| own.time < point.time);
        (dense.points[next].position - point.position).norm() <= 2.0 * reach(dense, sparse)
    })
}

/// Whether a few points differ by no more than noise may.
fn are_close(dense: &Path<'_>, sparse: &Path<'_>, shift: f64) -> bool {
    let pair = (dense, sparse, (sparse.points.len() / FIRST.0).max(1));
    let few = differences(pair, refined(pair, shift, 1));
    let mut sizes = sizes(few.map(|(difference, _)| difference));
    robust_sigma(&mut sizes) <= FIRST.1 * dense.noise.hypot(sparse.noise)
}

/// Shift of the clock at which the paths differ least, after some steps.
fn refined(pair: Pair<'_>, mut shift: f64, steps: usize) -> f64 {
    for _ in 0..steps {
        let (mut along, mut squares) = (0.0, 0.0);
        for (difference, velocity) in differences(pair, shift) {
            along += difference.dot(&velocity);
            squares += velocity.norm_squared();
        }
        if squares > 0.0 {
            shift -= along / squares;
        }
    }
    shift
}

/// A dense and a sparse path, of which every so many points are compared.
type Pair<'t> = (&'t Path<'t>, &'t Path<'t>, usize);

/// Differences of the paths, dense − sparse, m, at points of the sparse one with the clock shifted, and velocities, m/s,
/// where the dense one has points around them.
fn differences(
    (dense, sparse, every): Pair<'_>,
    shift: f64,
) -> impl Iterator<Item = (Vector3<f64>, Vector3<f64>)> {
    let longest = 3.0 * MAX_GAP * dense.interval;
    let points = dense.points;
    sparse
        .points
        .iter()
        .step_by(every)
        .filter_map(move |point| {
            let time = point.time + shift;
            let next = points.partition_point(|own| own.time < time);
            let around: Range<usize> = next.checked_sub(2)?..next + 2;
            let four = points.get(around)?;
            if four[3].time - four[0].time > longest {
                return None;
            }
            let velocity = (four[2].position - four[1].position) / (four[2].time - four[1].time);
            Some((cubic(four, time) - point.position, velocity))
        })
}

/// Cubic in time through four points.
fn cubic(four: &[PathPoint], time: f64) -> Vector3<f64> {
    let weight = |i: usize| -> f64 {
        let others = (0..4).filter(|j| *j != i);
        others
            .map(|j| (time - four[j].time) / (four[i].time - four[j].time))
            .product()
    };
    (0..4).map(|i| four[i].position * weight(i)).sum()
}

/// Whether the paths differ by less than independent noise, from sample to sample or, of a filtered one, slowly.
fn share_noise(dense: &Path<'_>, sparse: &Path<'_>, shift: f64) -> bool {
    let all = differences((dense, sparse, 1), shift).map(|(difference, _)| difference);
    let all: Vec<Vector3<f64>> = all.collect();
    if all.len() < MIN_SERIES {
        return false;
    }
    let variances = [dense, sparse].map(|path| path.noise.powi(2));
    let [limit, greatest, least] = [
        SHARED * (variances[0] + variances[1]),
        variances[0].max(variances[1]),
        variances[0].min(variances[1]),
    ];
    if robust_sigma(&mut sizes(all.iter().copied())).powi(2) < limit {
        return true;
    }
    let is_filtered = greatest > FILTERED.powi(2) * least;
    is_filtered
        && BLOCKS.into_iter().any(|block| {
            let means = all.chunks_exact(block);
            let count = means.len();
            let squares = means.map(|own| own.iter().sum::<Vector3<f64>>().norm_squared());
            // Mean square of a coordinate of a mean, times the number of its differences.
            let variance = squares.sum::<f64>() / (3 * count * block) as f64;
            count >= MIN_BLOCKS && variance < limit
        })
}

/// Absolute values of the coordinates.
fn sizes(differences: impl Iterator<Item = Vector3<f64>>) -> Vec<f64> {
    let each = differences.flat_map(|own| [own.x.abs(), own.y.abs(), own.z.abs()]);
    each.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shift_of_a_clock_is_found() {
        let points = |interval: f64, shift: f64| -> Vec<PathPoint> {
            let each = (0..40).map(|sample| {
                let time = interval * sample as f64;
                let at = time + shift;
                PathPoint {
                    sample,
                    time,
                    position: Vector3::new(9.0 * at, 0.3 * at, 1.0 + 2.0 * at - 4.905 * at * at),
                    attitude: None,
                }
            });
            each.collect()
        };
        let (dense, sparse) = (points(0.01, 0.0), points(0.02, 0.0137));
        let [dense, sparse] = [&dense, &sparse].map(|points| Path::new(points, 1e-3).unwrap());
        assert!((refined((&dense, &sparse, 1), 0.02, STEPS) - 0.0137).abs() < 1e-6);
    }

    #[test]
    fn clocks_of_any_size_have_pieces() {
        for (start, interval) in [(0.0, 0.01), (1.7e18, 1e6), (-1e300, f64::INFINITY)] {
            let each = (0..40).map(|sample| PathPoint {
                sample,
                time: start + interval * sample as f64,
                position: Vector3::zeros(),
                attitude: None,
            });
            let points: Vec<PathPoint> = each.collect();
            let pieces = pieces(&points);
            assert_eq!(pieces.last().map(|piece| piece.points.end), Some(40));
        }
    }
}
