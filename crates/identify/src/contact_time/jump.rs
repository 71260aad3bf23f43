//! Likelihood-ratio test of free motion against free motion whose velocities jump at one time.
//!
//! A. S. Willsky and H. L. Jones, "A generalized likelihood ratio approach to the detection and estimation of jumps in
//! linear systems", IEEE Transactions on Automatic Control 21 (1976).

use flight::parallel;
use nalgebra::DVector;

use super::alternatives::Alternatives;
use super::quadratic::{Coupled, Quadratic};
use super::rows::Point;
use super::trajectory::Part;
use crate::noise::NoiseModel;

/// Maximum number of samples after a possible contact with the ground or an object that are used to test for it.
const MAX_SAMPLES_AFTER: usize = 40;
/// Prior standard deviation of the displacement of a marker by a contact with the ground or an object, in units of the
/// noise of a marker coordinate. It is small, because a contact changes velocities and not positions.
const DISPLACEMENT_SIGMA: f64 = 0.3;

/// Threshold of the decrease of the whitened sum of squares by a velocity jump. Each jump is first tested with all
/// later samples, at most `MAX_SAMPLES_AFTER`. If every decrease is below the threshold, no jump is tested with fewer
/// samples. The threshold is below `MIN_GAIN`, the decrease by a contact with the ground, which samples after the
/// contact increase further.
const MIN_ROUGH_GAIN: f64 = 50.0;

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
    /// `free[i]` is the sum of squared residuals of free motion (without contact) over all samples before the sample
    /// `tried + i`. The last entry is the sum over all samples.
    free: Vec<Quadratic>,
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
        trajectory: Part<'_>,
        rows: &[Vec<Point>],
        noise: &NoiseModel,
        threads: usize,
    ) -> Option<Self> {
        let (dimension, tried) = (trajectory.dimension, trajectory.tried);
        let (before, after) = rows.split_at(tried - trajectory.first);
        let mut sum = Quadratic::zeros(dimension);
        for point in before.iter().flatten() {
            point.add_to(&mut sum);
        }
        let mut free = vec![sum.clone()];
        let mut samples = Vec::with_capacity(after.len());
        for points in after {
            let mut sample = Quadratic::zeros(dimension);
            points.iter().for_each(|point| point.add_to(&mut sample));
            sum.add_all(&sample);
            free.push(sum.clone());
            samples.push(SampleSum {
                points,
                sum: sample,
            });
        }
        let count = samples.len();
        let tests = JumpTests {
            trajectory,
            noise,
            samples: &samples,
            free: &free,
        };
        let rough = parallel::each_on(threads, count, |first| tests.with_all_samples(first));
        let rough = rough.into_iter().collect::<Option<Vec<_>>>()?;
        let may_jump = rough.iter().any(|by| by.gain > MIN_ROUGH_GAIN);
        let comparisons = match may_jump {
            true => parallel::each_on(threads, count, |first| {
                tests.with_each_number_of_samples(first)
            }),
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
    /// one with the index `contact`, which is the first sample after a supposed contact. `None` if these samples do not
    /// determine it.
    pub fn before(&self, contact: usize) -> Option<DVector<f64>> {
        Some(self.free[contact - self.tried].minimum()?.into())
    }
}

/// Data for the tests of velocity jumps.
struct JumpTests<'a> {
    trajectory: Part<'a>,
    noise: &'a NoiseModel,
    /// Samples from `trajectory.tried` on.
    samples: &'a [SampleSum<'a>],
    /// Sums of squared residuals of free motion (see [`Jumps`]).
    free: &'a [Quadratic],
}

impl JumpTests<'_> {
    /// Tests a jump just before the sample `trajectory.tried + first` with all later samples, at most
    /// `MAX_SAMPLES_AFTER`. `None` if the samples do not determine the motion.
    fn with_all_samples(&self, first: usize) -> Option<Comparison> {
        let mut jump = JumpSum::zeros(self.trajectory.dimension);
        let after = self.samples[first..].iter().take(MAX_SAMPLES_AFTER);
        let end = first + after.len();
        for sample in after {
            jump.add(sample, self.trajectory.tried + first);
        }
        jump.compare(&self.free[end], &self.held_markers(first))
    }

    /// Tests a jump just before the sample `trajectory.tried + first` with each number of later samples up to
    /// `MAX_SAMPLES_AFTER`. `None` if the samples do not determine the motion.
    fn with_each_number_of_samples(&self, first: usize) -> Option<Vec<Comparison>> {
        let held = self.held_markers(first);
        let mut jump = JumpSum::zeros(self.trajectory.dimension);
        let after = self.samples[first..].iter().zip(&self.free[first + 1..]);
        let each = after.take(MAX_SAMPLES_AFTER).map(|(sample, free)| {
            jump.add(sample, self.trajectory.tried + first);
            jump.compare(free, &held)
        });
        each.collect()
    }

    /// Priors that a jump just before the sample `trajectory.tried + first` does not displace the markers, one for each
    /// time at which the jump is tried: sums of the squared displacements as functions of the change of the initial
    /// state.
    fn held_markers(&self, first: usize) -> Alternatives {
        let dimension = self.trajectory.dimension;
        let times = self.trajectory.contacts[first].iter().map(|markers| {
            let mut sum = Quadratic::zeros(dimension);
            for marker in markers {
                for (derivatives, sigma) in marker.derivatives.iter().zip(self.noise.sigma) {
                    let weight = (DISPLACEMENT_SIGMA * sigma).recip();
                    sum.add_weighted(weight, derivatives.as_slice(), 0.0);
                }
            }
            sum
        });
        let times: Vec<Quadratic> = times.collect();
        Alternatives::new(&times, dimension)
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
    /// Squares of the residuals of samples with a marker that was not seen after the jump before.
    first: Coupled,
    /// Squares of the residuals of the other samples, which depend on the sum of both vectors.
    later: Quadratic,
}

impl JumpSum {
    fn zeros(dimension: usize) -> Self {
        Self {
            first: Coupled::zeros(dimension),
            later: Quadratic::zeros(dimension),
        }
    }

    /// Adds the squared residuals of `sample` to the sum, for a velocity jump just before the sample with the index
    /// `contact`; `sample` follows this jump.
    fn add(&mut self, sample: &SampleSum<'_>, contact: usize) {
        let is_first = |point: &Point| point.previous.is_none_or(|previous| previous < contact);
        if !sample.points.iter().any(is_first) {
            self.later.add_all(&sample.sum);
            return;
        }
        for point in sample.points {
            for row in &point.rows {
                // Of a marker's first residual after the jump, the preceding sample does not move with the change.
                let by_change = match is_first(point) {
                    true => &row.fresh,
                    false => &row.derivatives,
                };
                let by_state = row.derivatives.as_slice();
                self.first.add(by_state, by_change.as_slice(), row.residual);
            }
        }
    }

    /// Compares motion with a velocity jump and motion without one, both fitted to the samples up to the last one added.
    /// `free` is the sum of squares without a jump. `held` are the priors that the jump does not displace the markers,
    /// one for each time at which the jump is tried. `None` if the normal matrix is singular at every time.
    fn compare(&self, free: &Quadratic, held: &Alternatives) -> Option<Comparison> {
        let mut sum = self.first.clone();
        sum.add_all(&self.later);
        let rest = sum.minimum_over_first(free)?;
        let sampled = |unknown| self.first.diagonal(unknown) + self.later.diagonal(unknown);
        let (gain, change) = held.greatest_decrease(&rest, sampled)?;
        Some(Comparison {
            gain,
            change: change.into(),
        })
    }
}
