//! Likelihood-ratio test of free motion against free motion whose velocities jump at one time.
//!
//! A. S. Willsky and H. L. Jones, "A generalized likelihood ratio approach to the detection and estimation of jumps in
//! linear systems", IEEE Transactions on Automatic Control 21 (1976).

use flight::batch;
use nalgebra::{DMatrix, DVector};

use super::quadratic::{Minimum, Quadratic};
use super::rows::Point;
use super::trajectory::{Trajectory, over_noise};
use crate::noise::NoiseModel;

/// Maximum number of samples after a possible contact with the ground or an object that are used to test for it.
const MAX_SAMPLES_AFTER: usize = 40;
/// Prior standard deviation of the displacement of a marker by a contact with the ground or an object, in units of the
/// noise of a marker coordinate. It is small, because a contact changes velocities and not positions.
const DISPLACEMENT_SIGMA: f64 = 0.3;

/// Threshold of the decrease of the whitened sum of squares by a velocity jump. Each jump is first tested with all
/// later samples, at most `MAX_SAMPLES_AFTER`. If every decrease is below the threshold, no jump is tested with fewer
/// samples. The threshold is far below the decrease by a contact with the ground, which samples after the contact
/// increase further.
const MIN_ROUGH_GAIN: f64 = 30.0;

/// Result of the comparison of free motion (without contact) with motion whose velocities jump just before a sample.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Decrease of the sum of squared whitened residuals if the velocities may jump.
    pub gain: f64,
    /// Difference between the initial state of the motion after the jump and that of the motion before it.
    pub change: DVector<f64>,
}

/// Comparisons of free motion (without contact) with motion whose velocities jump, for jumps just before each of
/// several successive samples.
pub struct Jumps {
    /// Index of the first sample for which a jump in the preceding interval is tested.
    tried: usize,
    /// `free[i]` is the free motion (without contact) fitted to all samples before the sample `tried + i`. The last
    /// entry is the free motion fitted to all samples.
    free: Vec<Minimum>,
    /// `comparisons[i][k]` tests a jump just before sample `tried + i`, with the samples up to `tried + i + k`. The
    /// outer vector is empty if no jump decreases the sum of squares by more than `MIN_ROUGH_GAIN` when it is tested
    /// with all later samples, at most `MAX_SAMPLES_AFTER`.
    comparisons: Vec<Vec<Comparison>>,
}

impl Jumps {
    /// Tests a velocity jump just before each sample from `trajectory.tried` on. `rows` contains the whitened residuals
    /// of the markers by sample from `trajectory.first` on. `None` if the samples before a jump do not determine the
    /// motion without a contact. Uses `threads` threads.
    pub fn new(
        trajectory: &Trajectory,
        rows: &[Vec<Point>],
        noise: &NoiseModel,
        threads: usize,
    ) -> Option<Self> {
        let (dimension, tried) = (trajectory.dimension, trajectory.tried);
        let end = trajectory.first + rows.len();
        let of = |sample: usize| &rows[sample - trajectory.first];
        let mut sum = Quadratic::zeros(dimension);
        for point in (trajectory.first..tried).flat_map(of) {
            point.add_to(&mut sum);
        }
        let mut free = vec![sum.minimum()?];
        let mut samples = Vec::with_capacity(end - tried);
        for points in (tried..end).map(of) {
            let mut sample = Quadratic::zeros(dimension);
            points.iter().for_each(|point| point.add_to(&mut sample));
            sum.add_all(&sample);
            free.push(sum.minimum()?);
            samples.push(SampleSum {
                points,
                sum: sample,
            });
        }
        let count = samples.len();
        // Tests a jump with each number of samples after it from `least` on.
        let compare =
            |first: usize, least: usize| -> Option<Vec<Comparison>> {
                let held = trajectory.contacts[first].iter().map(|at| {
                    let displacement = over_noise(at, noise.sigma) / DISPLACEMENT_SIGMA;
                    displacement.tr_mul(&displacement)
                });
                let held: Vec<DMatrix<f64>> = held.collect();
                let mut change = JumpSum::zeros(dimension);
                let after = samples[first..].iter().zip(&free[first + 1..]);
                let each = after.take(MAX_SAMPLES_AFTER).enumerate().filter_map(
                    |(index, (sample, free))| {
                        change.add(sample, tried + first);
                        (index + 1 >= least).then(|| change.compare(free, &held))
                    },
                );
                each.collect()
            };
        let rough = batch::each_on(threads, count, |first| {
            compare(first, MAX_SAMPLES_AFTER.min(count - first))
        });
        let rough = rough.into_iter().collect::<Option<Vec<_>>>()?;
        let may_jump = rough.iter().flatten().any(|by| by.gain > MIN_ROUGH_GAIN);
        let comparisons = match may_jump {
            true => batch::each_on(threads, count, |first| compare(first, 1)),
            false => Vec::new(),
        };
        Some(Self {
            tried,
            comparisons: comparisons.into_iter().collect::<Option<_>>()?,
            free,
        })
    }

    /// Of the velocity jumps tested with the samples up to index `last`, the one with the greatest decrease of the sum
    /// of squares, and the index of the first sample after this jump. `None` if no jump was tested.
    pub fn best(&self, last: usize) -> Option<(usize, &Comparison)> {
        self.until(last)
            .max_by(|a, b| a.1.gain.total_cmp(&b.1.gain))
    }

    /// Earliest velocity jump that decreases the sum of squares over the samples up to index `last` by at least `gain`,
    /// and the index of the first sample after this jump; `None` if there is no such jump.
    pub fn earliest(&self, last: usize, gain: f64) -> Option<(usize, &Comparison)> {
        self.until(last).find(|(_, found)| found.gain >= gain)
    }

    fn until(&self, last: usize) -> impl Iterator<Item = (usize, &Comparison)> {
        let each = (self.tried..=last).zip(&self.comparisons);
        each.filter_map(move |(contact, by)| Some((contact, by.get(last - contact)?)))
    }

    /// Change of the initial state of the predicted trajectory with which free motion best fits the samples before the
    /// one with the index `contact`, which is the first sample after a supposed contact.
    pub fn before(&self, contact: usize) -> DVector<f64> {
        self.free[contact - self.tried].unknowns()
    }
}

/// Whitened residuals of the markers in one sample, and the sum of their squares as a quadratic function of the change
/// of the initial state.
struct SampleSum<'a> {
    points: &'a [Point],
    sum: Quadratic,
}

/// Sum of squared residuals of the samples after a jump, as a quadratic function of two vectors: the initial state
/// before the jump, and the change of the initial state that represents the jump. The terms with the initial state
/// alone are those of free motion, and are not stored here.
struct JumpSum {
    /// Block of the normal matrix that couples the initial state before the jump (rows) with the change of the initial
    /// state that represents the jump (columns).
    cross: DMatrix<f64>,
    change: Quadratic,
}

impl JumpSum {
    fn zeros(dimension: usize) -> Self {
        Self {
            cross: DMatrix::zeros(dimension, dimension),
            change: Quadratic::zeros(dimension),
        }
    }

    /// Adds the squared residuals of `sample` to the sum, for a velocity jump just before the sample with the index
    /// `contact`; `sample` follows this jump.
    fn add(&mut self, sample: &SampleSum<'_>, contact: usize) {
        let is_first = |point: &Point| point.previous.is_none_or(|previous| previous < contact);
        if !sample.points.iter().any(is_first) {
            self.cross += &sample.sum.normal;
            self.change.add_all(&sample.sum);
            return;
        }
        for point in sample.points {
            for row in &point.rows {
                // Of a marker's first residual after the jump, the preceding sample does not move with the change.
                let by_change = match is_first(point) {
                    true => &row.fresh,
                    false => &row.derivatives,
                };
                self.cross.ger(1.0, &row.derivatives, by_change, 1.0);
                self.change.add(by_change, row.residual);
            }
        }
    }

    /// Compares motion with a velocity jump and motion without one (`free`), both fitted to the samples up to the last
    /// one added. `held` are the normal matrices of the prior that the jump does not displace the markers, one for each
    /// time at which the jump is tried. `None` if the normal matrix is singular at every time.
    fn compare(&self, free: &Minimum, held: &[DMatrix<f64>]) -> Option<Comparison> {
        let rest = free.eliminated(&self.cross, &self.change);
        let found = held.iter().filter_map(|held| {
            let diagonal = |index| self.change.normal[(index, index)] + held[(index, index)];
            let jump = Minimum::new(&rest.normal + held, diagonal, &rest.right)?;
            Some((jump.reduced.norm_squared(), jump))
        });
        let (gain, jump) = found.max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(Comparison {
            gain,
            change: jump.unknowns(),
        })
    }
}
