//! Likelihood-ratio test of free motion against free motion whose velocities jump at one time (A. S. Willsky and H. L.
//! Jones, "A generalized likelihood ratio approach to the detection and estimation of jumps in linear systems", IEEE
//! Transactions on Automatic Control 21, 1976).

use nalgebra::{DMatrix, DVector};

use super::trajectory::{Point, Trajectory};
use crate::least_squares::{NormalBlock, ScaledCholesky};
use crate::noise::NoiseModel;
use dataset::levels::ROUNDING;

/// Maximum number of samples after a possible contact with the ground or an object that are used to test for it.
const MAX_SAMPLES_AFTER: usize = 40;
/// Prior standard deviation of the displacement of a marker by a contact, in units of the noise: velocities change at
/// once, positions do not.
const DISPLACEMENT_SIGMA: f64 = 0.3;
/// Times at which a jump is tried between two samples, as fractions of the interval from the earlier to the later one.
const PARTS: [f64; 4] = [0.125, 0.375, 0.625, 0.875];

/// Result of the comparison of free motion (without contact) with motion whose velocities jump just before a sample.
#[derive(Clone, Debug)]
pub struct Jump {
    pub contact: usize,
    /// Decrease of the sum of squared whitened residuals if the velocities may jump.
    pub gain: f64,
    /// Difference between the initial state of the motion after the jump and that of the motion before it.
    pub change: DVector<f64>,
}

/// Tests velocity jumps just before each sample from `tried` on. `rows` are the whitened residuals by sample from
/// `trajectory.first` on. Entry `i` of the result contains the tests with the samples up to `tried + i`, in the order
/// of the contacts. `None` if the samples do not determine the motion.
pub fn jumps(
    trajectory: &Trajectory,
    tried: usize,
    rows: &[Vec<Point>],
    noise: &NoiseModel,
) -> Option<Vec<Vec<Jump>>> {
    let (before, after) = rows.split_at(tried - trajectory.first);
    let mut free = sum_of(before.iter().flatten(), trajectory.dimension);
    let samples = after.iter().map(|points| {
        let sum = sum_of(points, trajectory.dimension);
        free.local += &sum.local;
        free.local_gradient += &sum.local_gradient;
        Sample {
            points,
            sum,
            free: free.clone(),
        }
    });
    let samples: Vec<Sample<'_>> = samples.collect();
    let mut tests = vec![Vec::new(); samples.len()];
    for first in 0..samples.len() {
        let held = held_markers(trajectory, tried + first, noise);
        let mut both = NormalBlock::zero(trajectory.dimension, trajectory.dimension);
        for (last, sample) in samples
            .iter()
            .enumerate()
            .skip(first)
            .take(MAX_SAMPLES_AFTER)
        {
            sample.add_to(&mut both, tried + first);
            tests[last].push(compare(tried + first, &both, &held)?);
        }
    }
    Some(tests)
}

/// Change of the initial state with which free motion best fits the residuals `points`; `None` if they do not determine
/// it.
pub fn free_motion<'p>(
    points: impl IntoIterator<Item = &'p Point>,
    dimension: usize,
) -> Option<DVector<f64>> {
    let sum = sum_of(points, dimension);
    Some(-ScaledCholesky::new(&sum.local, ROUNDING)?.solve(&sum.local_gradient))
}

/// Sum of the squared residuals of `points`, as a function of the initial state of the flight.
fn sum_of<'p>(points: impl IntoIterator<Item = &'p Point>, dimension: usize) -> NormalBlock {
    let mut sum = NormalBlock::zero(dimension, 0);
    let none = DVector::zeros(0);
    for row in points.into_iter().flat_map(|point| &point.rows) {
        sum.add(row.residual, &row.derivatives, &none);
    }
    sum
}

/// Whitened residuals of the markers in one sample.
struct Sample<'a> {
    points: &'a [Point],
    sum: NormalBlock,
    free: NormalBlock,
}

impl Sample<'_> {
    /// Adds the squared residuals to `both`, a function of the initial state and of its change by a jump just before
    /// the sample `contact`. The terms of the initial state alone become those of all samples up to this one.
    fn add_to(&self, both: &mut NormalBlock, contact: usize) {
        let is_first = |point: &Point| point.previous.is_none_or(|previous| previous < contact);
        if self.points.iter().any(is_first) {
            for point in self.points {
                for row in &point.rows {
                    // Of a marker's first residual after the jump, the preceding sample does not move with the change.
                    let by_change = match is_first(point) {
                        true => &row.fresh,
                        false => &row.derivatives,
                    };
                    both.add(row.residual, &row.derivatives, by_change);
                }
            }
        } else {
            both.cross += &self.sum.local;
            both.global += &self.sum.local;
            both.global_gradient += &self.sum.local_gradient;
        }
        both.local.copy_from(&self.free.local);
        both.local_gradient.copy_from(&self.free.local_gradient);
    }
}

/// Priors that a jump before the sample `contact` displaces no marker, one for each of [`PARTS`].
fn held_markers(trajectory: &Trajectory, contact: usize, noise: &NoiseModel) -> Vec<DMatrix<f64>> {
    let (before, after) = (trajectory.markers(contact - 1), trajectory.markers(contact));
    let times = PARTS.iter().map(|part| {
        let mut normal = DMatrix::zeros(trajectory.dimension, trajectory.dimension);
        for (marker, (before, after)) in before.iter().zip(after).enumerate() {
            for (axis, sigma) in noise.of(marker).sigma.iter().enumerate() {
                let derivatives = before.derivatives[axis].lerp(&after.derivatives[axis], *part);
                let weight = (DISPLACEMENT_SIGMA * sigma).powi(-2);
                normal.ger(weight, &derivatives, &derivatives, 1.0);
            }
        }
        normal
    });
    times.collect()
}

/// Best jump at one of the times to which the priors `held` belong. `both` is the sum of squares as a function of the
/// initial state and its change. `None` if the motion is determined at no time.
fn compare(contact: usize, both: &NormalBlock, held: &[DMatrix<f64>]) -> Option<Jump> {
    let before = ScaledCholesky::new(&both.local, ROUNDING)?;
    let rest = &both.global - both.cross.tr_mul(&before.solve_matrix(&both.cross));
    let gradient = &both.global_gradient - both.cross.tr_mul(&before.solve(&both.local_gradient));
    let times = held.iter().filter_map(|held| {
        let mut normal = &rest + held;
        for index in 0..normal.nrows() {
            normal[(index, index)] +=
                ROUNDING * (both.global[(index, index)] + held[(index, index)]);
        }
        let change = -ScaledCholesky::new(&normal, ROUNDING)?.solve(&gradient);
        Some(Jump {
            contact,
            gain: -gradient.dot(&change),
            change,
        })
    });
    times.max_by(|a, b| a.gain.total_cmp(&b.gain))
}
