//! The axis of a body that moves least, how fast that axis wobbles, and the correlation of the noise.

use nalgebra::{Matrix3, SVector, UnitQuaternion, Vector3};

use super::motion::Point;
use super::regression::{Regression, Row};
use super::{PathPoint, Posed};
use crate::statistics::median;

/// Greatest root mean square turn of the axis from sample to sample, rad; bodies that tumble have no steady axis.
const MOST_TURN: f64 = 0.3;
/// Least spin, rad/s: the axis of a slower body drifts as fast as it wobbles, and free motion is not told from a touch.
const LEAST_SPIN: f64 = 24.0;
/// Divisor of a flight's length whose first part shows the spin: friction of the ground slows it later.
const SPIN_PART: usize = 3;
/// Least turn of the wobble from sample to sample, rad, its step, and the number of steps, up to half a turn.
const TURNS: (f64, f64, usize) = (0.25, 0.05, 56);
/// Number of these steps between the turns that are tried first.
const COARSE: usize = 3;
/// Number of points that show the rate of the wobble.
const CHUNK: usize = 12;
/// Time that scales the powers of a polynomial over these points, s.
const SCALE: f64 = 0.05;
/// Least squared residual of the axis: below it there is only rounding.
const LEAST_SQUARE: f64 = 1e-12;
/// Step between the correlations that are tried, and their number.
const CORRELATIONS: (f64, i32) = (0.05, 18);
/// Least number of third differences that show a correlation.
const DIFFERENCES: usize = 30;

/// Positions and directions of the steadiest axis; none for a body without a steady axis or that spins slowly.
pub fn points_with_axis(posed: &[Posed]) -> Option<Vec<Point>> {
    let pairs = posed.windows(2);
    let mut spins: Vec<f64> = pairs
        .map(|pair| pair[0].1.angle_to(&pair[1].1) / (pair[1].0.1 - pair[0].0.1))
        .collect();
    let part = spins.len().div_ceil(SPIN_PART);
    if median(spins.get_mut(..part)?) < LEAST_SPIN {
        return None;
    }
    let axis = steadiest_axis(posed)?;
    let each = posed.iter().map(|(point, attitude)| {
        let &(sample, time, position) = point;
        Point {
            sample,
            time,
            position,
            axis: attitude * axis,
        }
    });
    Some(each.collect())
}

/// The body axis whose direction in space changes least from sample to sample.
fn steadiest_axis(posed: &[(PathPoint, UnitQuaternion<f64>)]) -> Option<Vector3<f64>> {
    let neighbours = posed
        .windows(2)
        .filter(|pair| pair[1].0.0 == pair[0].0.0 + 1);
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
    let is_steady = eigen.eigenvalues[least] < MOST_TURN * MOST_TURN;
    is_steady.then(|| eigen.eigenvectors.column(least).into())
}

/// Rate at which the axis wobbles about its mean direction, rad/s: that of the sinusoid that leaves the least residuals
/// in short pieces of the flight, at a median interval, s, between samples. An impact changes the wobble, not its rate.
pub fn wobble_rate(points: &[Point], interval: f64) -> f64 {
    let (least, step, count) = TURNS;
    let rate = |index: usize| (least + step * index as f64) / interval;
    let misfit = |rate: f64| {
        let each = points.chunks_exact(CHUNK).filter_map(|chunk| {
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
            let rows: Vec<_> = chunk.iter().map(row).collect();
            let fitted = Regression::solve(&rows, &[0.0; 5], 0.0)?;
            Some(fitted.squares.max(LEAST_SQUARE).ln())
        });
        each.sum::<f64>()
    };
    let best = |indices: &mut dyn Iterator<Item = usize>| {
        let misfits = indices.map(|index| (misfit(rate(index)), index));
        misfits
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map_or(0, |(_, index)| index)
    };
    // The pieces are too short for the misfit to change much in a few steps.
    let near = best(&mut (0..count).step_by(COARSE));
    rate(best(
        &mut (near.saturating_sub(COARSE - 1)..count.min(near + COARSE)),
    ))
}

/// Correlation of the noise of neighbouring samples, by third differences of neighbouring samples and of every other one;
/// 0 where there are few.
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
