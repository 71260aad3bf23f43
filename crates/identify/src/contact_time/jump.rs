//! Likelihood-ratio test of free motion against free motion whose velocities jump at one time.
//!
//! A. S. Willsky and H. L. Jones, "A generalized likelihood ratio approach to the detection and estimation of jumps in
//! linear systems", IEEE Transactions on Automatic Control 21 (1976).

use nalgebra::DVector;

use super::quadratic::Quadratic;
use super::rows::{Point, Row};
use super::trajectory::{Trajectory, over_noise};
use crate::noise::NoiseModel;

/// Maximum number of samples after a tried contact that are used to test for it.
const AFTER: usize = 40;
/// Prior standard deviation of the displacement of a marker by the contact itself, in units of the noise of a marker
/// coordinate. It is small, because a contact changes velocities and not positions.
const SLACK: f64 = 0.3;

/// Result of the comparison of free motion with motion whose velocities jump just before a sample.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Decrease of the whitened sum of squares if the jump is allowed.
    pub gain: f64,
    /// Difference between the initial state of the motion after the jump and that of the motion before it.
    pub change: DVector<f64>,
}

/// Comparisons of free motion with motion whose velocities jump, for jumps just before each of the tried samples.
pub struct Jumps {
    /// Index of the first sample for which a jump in the preceding interval is tested.
    tried: usize,
    /// For each sample before which a jump is tested: change of the initial state, relative to that of the predicted
    /// trajectory, for which free motion best fits all earlier samples.
    before: Vec<DVector<f64>>,
    /// `comparisons[i][k]` tests a jump just before sample `tried + i`, with the samples up to `tried + i + k`.
    comparisons: Vec<Vec<Comparison>>,
}

impl Jumps {
    /// Tests a jump just before each sample from `trajectory.tried` on. `rows` contains the whitened residuals by
    /// sample from `trajectory.first` on. `None` if the samples before a jump do not determine the free motion.
    pub fn new(trajectory: &Trajectory, rows: &[Vec<Point>], noise: &NoiseModel) -> Option<Self> {
        let (dimension, tried) = (trajectory.dimension, trajectory.tried);
        let end = trajectory.first + rows.len();
        let of = |sample: usize| &rows[sample - trajectory.first];
        let mut sum = Quadratic::zeros(dimension);
        (trajectory.first..tried)
            .flat_map(of)
            .for_each(|point| point.add_to(&mut sum));
        let (mut sums, mut before, mut free) = (Vec::new(), Vec::new(), Vec::new());
        for sample in tried..end {
            before.push(sum.least()?.1);
            sums.push(sum.clone());
            of(sample).iter().for_each(|point| point.add_to(&mut sum));
            free.push(sum.least()?.0);
        }
        let each = (tried..).zip(trajectory.contacts.iter().zip(&sums));
        let comparisons = each.map(|(contact, (contacts, sum))| {
            let contacts = contacts.iter();
            let held: Vec<_> = contacts
                .map(|at| over_noise(at, noise.sigma) / SLACK)
                .collect();
            let mut sum = sum.extended(dimension);
            let samples = contact..end.min(contact + AFTER);
            let each = samples.map(|sample| {
                for (point, row) in of(sample)
                    .iter()
                    .flat_map(|p| p.rows.iter().map(move |r| (p, r)))
                {
                    sum.add(&after(point, row, contact), row.residual);
                }
                let found = held.iter().filter_map(|held| sum.with_last(held)?.least());
                let (least, solution) = found.min_by(|a, b| a.0.total_cmp(&b.0))?;
                Some(Comparison {
                    gain: free[sample - tried] - least,
                    change: solution.rows(dimension, dimension).into_owned(),
                })
            });
            each.collect()
        });
        Some(Self {
            tried,
            comparisons: comparisons.collect::<Option<_>>()?,
            before,
        })
    }

    /// Of the jumps tested with the samples up to `last`, the one with the greatest decrease of the sum of squares,
    /// with the index of the first sample after it. `None` if no jump was tested.
    pub fn best(&self, last: usize) -> Option<(usize, &Comparison)> {
        self.until(last)
            .max_by(|a, b| a.1.gain.total_cmp(&b.1.gain))
    }

    /// Earliest jump that decreases the sum of squares over the samples up to `last` by at least `gain`, with the index
    /// of the first sample after it; `None` if there is no such jump.
    pub fn earliest(&self, last: usize, gain: f64) -> Option<(usize, &Comparison)> {
        self.until(last).find(|(_, found)| found.gain >= gain)
    }

    fn until(&self, last: usize) -> impl Iterator<Item = (usize, &Comparison)> {
        let each = (self.tried..=last).zip(&self.comparisons);
        each.filter_map(move |(contact, by)| Some((contact, by.get(last - contact)?)))
    }

    /// Change of the initial state, relative to that of the predicted trajectory, for which free motion best fits the
    /// samples before the sample of index `contact`.
    pub fn before(&self, contact: usize) -> &DVector<f64> {
        &self.before[contact - self.tried]
    }
}

/// Derivatives of a residual, if the velocities jump just before sample `contact`: first with respect to the initial
/// state before the jump, then with respect to the change of the initial state that represents the jump.
fn after(point: &Point, row: &Row, contact: usize) -> DVector<f64> {
    let is_first = point.previous.is_none_or(|previous| previous < contact);
    let by_change = match is_first {
        true => &row.fresh,
        false => &row.derivatives,
    };
    let all = row.derivatives.iter().chain(by_change).copied();
    DVector::from_iterator(2 * by_change.len(), all)
}
