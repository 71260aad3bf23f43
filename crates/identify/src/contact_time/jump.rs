//! Likelihood-ratio test of free motion against free motion whose velocities jump at one time.
//!
//! A. S. Willsky and H. L. Jones, "A generalized likelihood ratio approach to the detection and estimation of jumps in
//! linear systems", IEEE Transactions on Automatic Control 21 (1976).

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::rows::{Point, Row};
use super::trajectory::{Part, Predicted};
use crate::noise::NoiseModel;

/// Prior standard deviation of the displacement of a marker by a contact with the ground or an object, in units of the
/// noise of a marker coordinate. It is small, because a contact changes velocities and not positions.
const DISPLACEMENT_SIGMA: f64 = 0.3;
/// Relative increase of the diagonals of normal matrices, so that they are invertible if the samples do not determine
/// all unknowns.
const RIDGE: f64 = 1e-9;

/// A jump of the velocities just before a sample, fitted to the samples before and after it.
#[derive(Clone, Debug)]
pub struct Jump {
    /// Index of the first sample after the jump.
    pub sample: usize,
    /// Decrease of the sum of squared whitened residuals if the velocities may jump.
    pub gain: f64,
    /// Difference between the initial state of the motion after the jump and that of the motion before it.
    pub change: DVector<f64>,
}

/// Normal equations of a sum of squared whitened residuals that are linear in the change of the initial state.
#[derive(Clone)]
struct NormalEquations {
    matrix: DMatrix<f64>,
    right: DVector<f64>,
}

impl NormalEquations {
    fn zeros(dimension: usize) -> Self {
        Self {
            matrix: DMatrix::zeros(dimension, dimension),
            right: DVector::zeros(dimension),
        }
    }

    fn add(&mut self, row: &Row) {
        self.matrix
            .ger(1.0, &row.derivatives, &row.derivatives, 1.0);
        self.right.axpy(row.residual, &row.derivatives, 1.0);
    }
}

/// Tests for velocity jumps in one part of a flight.
pub struct JumpTests<'a> {
    trajectory: Part<'a>,
    rows: &'a [Vec<Point>],
    /// Normal equations of free motion over all samples before the sample `trajectory.first + i`, by i.
    free: Vec<NormalEquations>,
    /// Cholesky factors of the normal matrices `free`; `None` where the samples do not determine the motion.
    factors: Vec<Option<Cholesky<f64, Dyn>>>,
    /// Priors that a jump just before the sample `trajectory.tried + i` displaces no marker, by i: a normal matrix for
    /// each time at which the jump is tried.
    held: Vec<Vec<DMatrix<f64>>>,
}

impl<'a> JumpTests<'a> {
    /// Sums the normal equations of free motion. `rows` contains the whitened residuals of the markers by sample from
    /// `trajectory.first` on.
    pub fn new(trajectory: Part<'a>, rows: &'a [Vec<Point>], noise: &NoiseModel) -> Self {
        let mut sum = NormalEquations::zeros(trajectory.dimension);
        let mut free = vec![sum.clone()];
        for points in rows {
            let rows = points.iter().flat_map(|point| &point.rows);
            rows.for_each(|row| sum.add(row));
            free.push(sum.clone());
        }
        let weights = noise
            .sigma
            .map(|sigma| (DISPLACEMENT_SIGMA * sigma).powi(-2));
        let held = |markers: &Vec<Predicted>| {
            let mut sum = DMatrix::zeros(trajectory.dimension, trajectory.dimension);
            for marker in markers {
                for (derivatives, weight) in marker.derivatives.iter().zip(weights) {
                    sum.ger(weight, derivatives, derivatives, 1.0);
                }
            }
            sum
        };
        let contacts = trajectory.contacts.iter();
        Self {
            trajectory,
            rows,
            factors: free
                .iter()
                .map(|free| factor(free.matrix.clone(), &free.matrix))
                .collect(),
            free,
            held: contacts
                .map(|times| times.iter().map(held).collect())
                .collect(),
        }
    }

    /// Change of the initial state of the predicted trajectory with which free motion best fits the samples before
    /// `end`; `None` if these samples do not determine it.
    pub fn free_motion(&self, end: usize) -> Option<DVector<f64>> {
        let place = end - self.trajectory.first;
        Some(-self.factors[place].as_ref()?.solve(&self.free[place].right))
    }

    /// Fits a velocity jump just before the sample `contact` to the samples before `end`. The time of the jump is the
    /// best one of those at which the trajectory was predicted. `None` if the samples do not determine the motion.
    pub fn jump(&self, contact: usize, end: usize) -> Option<Jump> {
        let Part { first, tried, .. } = self.trajectory;
        let (all, before) = (&self.free[end - first], &self.free[contact - first]);
        let mut cross = &all.matrix - &before.matrix;
        let (mut own, mut right) = (cross.clone(), &all.right - &before.right);
        for row in self.first_rows(contact, end) {
            // The sample from which the noise of this one is predicted does not move with the jump.
            let difference = &row.fresh - &row.derivatives;
            cross.ger(1.0, &row.derivatives, &difference, 1.0);
            own.ger(1.0, &row.fresh, &row.fresh, 1.0);
            own.ger(-1.0, &row.derivatives, &row.derivatives, 1.0);
            right.axpy(row.residual, &difference, 1.0);
        }
        let explained = self.factors[end - first].as_ref()?.solve(&cross);
        let rest = &own - cross.tr_mul(&explained);
        right -= explained.tr_mul(&all.right);
        let mut best: Option<Jump> = None;
        for held in &self.held[contact - tried] {
            let Some(factor) = factor(&rest + held, &(&own + held)) else {
                continue;
            };
            let change = -factor.solve(&right);
            let gain = -change.dot(&right);
            if best.as_ref().is_none_or(|best| gain > best.gain) {
                best = Some(Jump {
                    sample: contact,
                    gain,
                    change,
                });
            }
        }
        best
    }

    /// Rows of the first measured position of each marker in the samples `contact..end`.
    fn first_rows(&self, contact: usize, end: usize) -> impl Iterator<Item = &Row> {
        let first = self.trajectory.first;
        let points = self.rows[contact - first..end - first].iter().flatten();
        points
            .filter(move |point| point.previous.is_none_or(|previous| previous < contact))
            .flat_map(|point| &point.rows)
    }
}

/// Cholesky factor of `matrix`, after its diagonal is increased by the fraction [`RIDGE`] of the diagonal of `scale`;
/// `None` if it is not positive definite.
fn factor(mut matrix: DMatrix<f64>, scale: &DMatrix<f64>) -> Option<Cholesky<f64, Dyn>> {
    for index in 0..matrix.nrows() {
        // An unknown on which nothing depends stays 0.
        matrix[(index, index)] += match scale[(index, index)] {
            0.0 => 1.0,
            diagonal => RIDGE * diagonal,
        };
    }
    matrix.cholesky()
}
