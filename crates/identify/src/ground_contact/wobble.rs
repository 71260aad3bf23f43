//! Most steady axis of a body, the rate at which this axis wobbles, and the correlation of the noise.

use nalgebra::{Matrix3, SVector, UnitQuaternion, Vector3};

use super::PathPoint;
use super::designs::Designs;
use super::motion::Point;
use super::regression::{Design, Row, Whitened};
use dataset::statistics::median;

/// Maximum root mean square rotation of the most steady body axis between successive samples, rad. If it is exceeded,
/// the body tumbles and has no steady axis.
const MAX_TURN: f64 = 0.3;
/// Minimum spin, rad/s. The axis of a slower body drifts as fast as it wobbles, so that a ground contact is
/// indistinguishable from free motion.
const MIN_SPIN: f64 = 24.0;
/// Reciprocal of the fraction of a flight, counted from its start, from which the spin is computed, because ground
/// friction slows the spin later.
const SPIN_PART: usize = 3;
/// Trial values of the wobble angle between successive samples: minimum (rad), step (rad) and number, up to about half
/// a turn.
const TURNS: (f64, f64, usize) = (0.25, 0.05, 56);
/// Spacing of the trial values in the first, coarse search for the wobble rate, in multiples of the step of the fine
/// search (0.05 rad per sample).
const COARSE: usize = 3;
/// Number of samples in each of the segments into which a flight is divided. For every trial value of the wobble rate,
/// a sinusoid with this rate is fitted to the body axis in each segment.
const CHUNK: usize = 12;
/// Unit of time in the polynomial that describes the drift of the body axis in a segment of a flight, s: its variable
/// is time divided by this value.
const SCALE: f64 = 0.05;
/// Lower limit of the sum of squared residuals of the axis in a segment, because its logarithm is used; smaller values
/// are rounding errors.
const MIN_SQUARE: f64 = 1e-12;
/// Spacing and number of the trial values of the noise correlation between successive samples; the first one is 0.
const CORRELATIONS: (f64, i32) = (0.05, 18);
/// Minimum number of third differences of the measured positions from which the noise correlation is estimated.
const DIFFERENCES: usize = 30;

/// A point of the measured path of a body, with the attitude of the body at this point (rotation from body to inertial
/// components).
pub type Posed<'p> = (&'p PathPoint, UnitQuaternion<f64>);

/// Position of the body and direction of its most steady axis in each sample; `None` if the body has no such axis or
/// spins slowly.
pub fn points_with_axis(posed: &[Posed<'_>]) -> Option<Vec<Point>> {
    let pairs = posed.windows(2);
    let mut spins: Vec<f64> = pairs
        .map(|pair| pair[0].1.angle_to(&pair[1].1) / (pair[1].0.time - pair[0].0.time))
        .collect();
    let part = spins.len().div_ceil(SPIN_PART);
    if median(spins.get_mut(..part)?) < MIN_SPIN {
        return None;
    }
    let axis = steadiest_axis(posed)?;
    let each = posed.iter().map(|(point, attitude)| Point {
        sample: point.sample,
        time: point.time,
        position: point.position,
        axis: attitude * axis,
    });
    Some(each.collect())
}

/// Body axis whose direction in space changes least between successive samples, as a unit vector in body components;
/// `None` if the body tumbles, or if no two poses are in successive samples.
fn steadiest_axis(posed: &[Posed<'_>]) -> Option<Vector3<f64>> {
    let neighbours = posed
        .windows(2)
        .filter(|pair| pair[1].0.sample == pair[0].0.sample + 1);
    let (mut sum, mut count) = (Matrix3::zeros(), 0);
    for pair in neighbours {
        let turn = (pair[0].1.inverse() * pair[1].1).to_rotation_matrix();
        sum += Matrix3::identity() * 2.0 - turn.matrix() - turn.matrix().transpose();
        count += 1;
    }
    if count == 0 || !sum.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let eigen = (sum / f64::from(count)).symmetric_eigen();
    let least = eigen.eigenvalues.imin();
    let is_steady = eigen.eigenvalues[least] < MAX_TURN * MAX_TURN;
    is_steady.then(|| eigen.eigenvectors.column(least).into())
}

/// Rate at which the most steady body axis wobbles about its mean direction, rad/s: the frequency of the sinusoid with
/// the smallest residuals in short segments of the flight. `interval` is the median time between samples, s. An impact
/// changes the amplitude and phase of the wobble, but not its rate.
pub fn wobble_rate(points: &[Point], interval: f64) -> f64 {
    let (least, step, count) = TURNS;
    let rate = |index: usize| (least + step * index as f64) / interval;
    let chunks = points.chunks_exact(CHUNK);
    let axes = chunks
        .clone()
        .map(|chunk| Whitened::white(chunk.iter().map(|point| point.axis)));
    let axes: Vec<Whitened> = axes.collect();
    let misfit = |rate: f64| {
        let mut designs = Designs::new();
        let each = chunks.clone().zip(&axes).filter_map(|(chunk, axes)| {
            let middle = chunk[CHUNK / 2].time;
            let row = |point: &Point| {
                let time = point.time - middle;
                let (sine, cosine) = (rate * time).sin_cos();
                let t = time / SCALE;
                Row {
                    sample: point.sample,
                    functions: SVector::<f64, 5>::from([1.0, t, t * t, cosine, sine]),
                    value: point.axis,
                }
            };
            let design = designs.of(chunk.iter(), middle, || {
                let rows: Vec<_> = chunk.iter().map(row).collect();
                Design::new(&rows, &[0.0; 5], 0.0)
            })?;
            Some(design.squares(axes).max(MIN_SQUARE).ln())
        });
        each.sum::<f64>()
    };
    let best = |indices: &mut dyn Iterator<Item = usize>| {
        let misfits = indices.map(|index| (misfit(rate(index)), index));
        misfits
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map_or(0, |(_, index)| index)
    };
    // The segments are so short that the misfit changes little over a few steps.
    let near = best(&mut (0..count).step_by(COARSE));
    rate(best(
        &mut (near.saturating_sub(COARSE - 1)..count.min(near + COARSE)),
    ))
}

/// Correlation of the position noise between successive samples, estimated from third differences of successive samples
/// and of every second sample; 0 if there are too few samples.
pub fn noise_correlation(points: &[Point]) -> f64 {
    let differences = |stride: usize| -> Vec<f64> {
        let windows = points.windows(3 * stride + 1);
        let whole = windows.filter(|w| w[3 * stride].sample == w[0].sample + 3 * stride);
        let each = whole.flat_map(|w| {
            let at = |k: usize| w[k * stride].position;
            let third = at(3) - 3.0 * at(2) + 3.0 * at(1) - at(0);
            [third.x.abs(), third.y.abs(), third.z.abs()]
        });
        each.collect()
    };
    let (mut near, mut far) = (differences(1), differences(2));
    if far.len() < DIFFERENCES {
        return 0.0;
    }
    let ratio = (median(&mut near) / median(&mut far)).powi(2);
    let variance = |r: f64| 20.0 - 30.0 * r + 12.0 * r * r - 2.0 * r.powi(3);
    let misfit = |r: f64| (variance(r) / variance(r * r) / ratio).ln().abs();
    let (step, count) = CORRELATIONS;
    let tried = (0..count).map(|index| step * f64::from(index));
    let best = tried.min_by(|a, b| misfit(*a).total_cmp(&misfit(*b)));
    best.unwrap_or(0.0)
}
