//! Residuals of one channel along one axis, whitened.

use identify::AxesNoise;

use super::banded::{BANDWIDTH, BandedGram, Projected};
use super::spline_basis::{SUPPORT, SplineBasis};

/// Residuals of one channel of a flight at the times of its inliers.
#[derive(Clone, Debug, Default)]
pub(super) struct Series {
    /// Times of the inliers, s.
    pub times: Vec<f64>,
    /// `sides[sample * count + k]`: the residual, m, and its derivatives by the local parameters.
    pub sides: Vec<f64>,
    /// Number of values of one sample in `sides`.
    pub count: usize,
}

/// Whitened products of a series, with a spline basis projected out.
#[derive(Clone, Debug)]
pub(super) struct WhitenedProducts {
    /// Products of the sides with one another, the residual first; row by row.
    pub products: Vec<f64>,
    /// The sides projected on the splines.
    pub projected: Projected,
    /// Sum of the log variances of the innovations over that of the noise.
    pub ln_variances: f64,
    /// Number of samples.
    pub samples: usize,
}

impl Series {
    /// A series of `count` values in each sample.
    pub fn new(count: usize) -> Self {
        Self {
            count,
            ..Self::default()
        }
    }

    /// Whitens the series by a noise model along an axis, and projects it on splines.
    pub fn whitened(
        &self,
        basis: &SplineBasis,
        noise: &AxesNoise,
        axis: usize,
    ) -> WhitenedProducts {
        let count = self.count;
        let mut gram = BandedGram::new(basis.len(), count);
        let mut products = vec![0.0; count * count];
        let mut ln_variances = 0.0;
        let mut row = [0.0; BANDWIDTH + 1];
        let mut sides = vec![0.0; count];
        let mut before: Option<(f64, usize, [f64; SUPPORT], &[f64])> = None;
        for (&time, own) in self.times.iter().zip(self.sides.chunks_exact(count)) {
            let (first, values) = basis.at(time);
            // After a gap of many knots the noise is independent of that before it.
            let last = before.filter(|(_, earlier, ..)| first - earlier <= BANDWIDTH + 1 - SUPPORT);
            let (start, length) = match last {
                Some((earlier, place, splines, previous)) => {
                    let (phi, sigma) = noise.innovation(axis, time - earlier);
                    ln_variances += 2.0 * (sigma / noise.sigma[axis]).ln();
                    row.fill(0.0);
                    for (k, value) in splines.iter().enumerate() {
                        row[k] = -phi * value / sigma;
                    }
                    for (k, value) in values.iter().enumerate() {
                        row[first - place + k] += value / sigma;
                    }
                    for ((side, now), then) in sides.iter_mut().zip(own).zip(previous) {
                        *side = (now - phi * then) / sigma;
                    }
                    (place, first - place + SUPPORT)
                }
                None => {
                    let sigma = noise.sigma[axis];
                    for (k, value) in values.iter().enumerate() {
                        row[k] = value / sigma;
                    }
                    for (side, now) in sides.iter_mut().zip(own) {
                        *side = now / sigma;
                    }
                    (first, SUPPORT)
                }
            };
            gram.add(start, &row[..length], &sides);
            for (i, &value) in sides.iter().enumerate() {
                for (product, other) in products[i * count..].iter_mut().zip(&sides) {
                    *product += value * other;
                }
            }
            before = Some((time, first, values, own));
        }
        WhitenedProducts {
            products,
            projected: gram.project(),
            ln_variances,
            samples: self.times.len(),
        }
    }

    /// The series with the residual alone.
    pub fn residuals_only(&self) -> Self {
        Self {
            times: self.times.clone(),
            sides: self.sides.iter().step_by(self.count).copied().collect(),
            count: 1,
        }
    }
}
