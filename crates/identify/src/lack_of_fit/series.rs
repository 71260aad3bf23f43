//! Residuals of one measurement channel along one axis, and their whitened products.

use crate::noise::AxesNoise;

use super::banded::{BANDWIDTH, BandedGram, Projected};
use super::spline_basis::{SUPPORT, SplineBasis};

/// Residuals of one measurement channel of a flight along one axis, at the sample times of the inliers.
#[derive(Clone, Debug, Default)]
pub(super) struct Series {
    /// Sample times of the inliers, s after the first sample of the flight.
    pub times: Vec<f64>,
    /// `sides[sample * count + k]`: residual, m, for `k = 0`; for larger `k`, derivative of the residual with respect
    /// to local parameter `k − 1` of the flight (tangent direction of the initial state).
    pub sides: Vec<f64>,
    /// Number of values that `sides` contains for each sample: the residual and its derivatives with respect to the
    /// local parameters of the flight.
    pub count: usize,
}

/// Whitened residuals and derivatives of a series in the form that least squares needs: their Gram matrix, and their
/// projections on a spline basis.
#[derive(Clone, Debug)]
pub(super) struct WhitenedProducts {
    /// Gram matrix of the whitened values (residual first, then derivatives), row by row.
    pub products: Vec<f64>,
    /// Projections of the whitened residual and derivatives on the splines.
    pub projected: Projected,
    /// Sum over the samples of the log ratio of innovation variance to noise variance.
    pub ln_variances: f64,
    /// Number of samples of the series.
    pub samples: usize,
}

impl Series {
    /// Creates an empty series. Each sample added to it must have `count` values: the residual, then its derivatives
    /// with respect to the flight's local parameters.
    pub fn new(count: usize) -> Self {
        Self {
            count,
            ..Self::default()
        }
    }

    /// Whitens the residuals and derivatives of the series with the noise model of its coordinate axis, and projects
    /// them on the splines of `basis`.
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
            // After a gap of many knot intervals, the noise is independent of the noise before the gap.
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

    /// Copy of the series with the residuals only, without derivatives.
    pub fn residuals_only(&self) -> Self {
        Self {
            times: self.times.clone(),
            sides: self.sides.iter().step_by(self.count).copied().collect(),
            count: 1,
        }
    }
}
