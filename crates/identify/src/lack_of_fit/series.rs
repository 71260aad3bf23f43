//! Residuals of one measurement channel along one axis, and their whitened products.

use super::banded::{BANDWIDTH, BandedGram, Projected};
use crate::noise::AxesNoise;

/// Residuals of one measurement channel of a flight along one axis, at the sample times of the inliers.
#[derive(Clone, Debug, Default)]
pub(super) struct Series {
    /// Sample times of the inliers, s after the first sample of the flight.
    pub times: Vec<f64>,
    /// `sides[sample * count + k]`: residual, m, for `k = 0`; else its derivative by local parameter `k − 1`.
    pub sides: Vec<f64>,
    pub count: usize,
}

/// Whitened residuals and derivatives of a series as least squares needs them.
#[derive(Clone, Debug)]
pub(super) struct WhitenedProducts {
    /// Gram matrix of the whitened values (residual first, then derivatives), row by row.
    pub products: Vec<f64>,
    pub projected: Projected,
    /// Sum over the samples of the log ratio of innovation variance to noise variance.
    pub ln_variances: f64,
    pub samples: usize,
}

impl Series {
    /// Creates an empty series with `count` values for each sample.
    pub fn new(count: usize) -> Self {
        Self {
            count,
            ..Self::default()
        }
    }

    /// Whitens the series with the noise of its axis, and projects it on the splines of `basis`.
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
        let innovation = |gap: Option<f64>| {
            let (phi, sigma) = noise.innovation(axis, gap);
            (phi, sigma, 2.0 * (sigma / noise.sigma[axis]).ln())
        };
        let after_one_interval = innovation(Some(noise.interval));
        for (&time, own) in self.times.iter().zip(self.sides.chunks_exact(count)) {
            let (first, values) = basis.at(time);
            // After a gap of many knot intervals, the noise is independent of the noise before the gap.
            let last = before.filter(|(_, earlier, ..)| first - earlier <= BANDWIDTH + 1 - SUPPORT);
            let (phi, sigma, ln_variance) = match last.map(|(earlier, ..)| time - earlier) {
                Some(gap) if noise.is_one_interval(gap) => after_one_interval,
                gap => innovation(gap),
            };
            ln_variances += ln_variance;
            let start = last.map_or(first, |(_, place, ..)| place);
            row.fill(0.0);
            sides.copy_from_slice(own);
            if let Some((_, _, splines, previous)) = last {
                for (row, value) in row.iter_mut().zip(splines) {
                    *row = -phi * value / sigma;
                }
                for (side, then) in sides.iter_mut().zip(previous) {
                    *side -= phi * then;
                }
            }
            for (row, value) in row[first - start..].iter_mut().zip(values) {
                *row += value / sigma;
            }
            sides.iter_mut().for_each(|side| *side /= sigma);
            gram.add(start, &row[..first - start + SUPPORT], &sides);
            for (i, &value) in sides.iter().enumerate() {
                for (product, other) in products[i * count..].iter_mut().zip(&sides[..=i]) {
                    *product += value * other;
                }
            }
            before = Some((time, first, values, own));
        }
        for i in 0..count {
            for k in 0..i {
                products[k * count + i] = products[i * count + k];
            }
        }
        WhitenedProducts {
            products,
            projected: gram.project(),
            ln_variances,
            samples: self.times.len(),
        }
    }

    /// Residuals of several series, side by side for those with the same times.
    pub fn together<'s>(each: impl Iterator<Item = &'s Series>) -> Vec<Series> {
        let mut found: Vec<(&Vec<f64>, Vec<&Series>)> = Vec::new();
        for own in each {
            match found.iter_mut().find(|(times, _)| **times == own.times) {
                Some((_, same)) => same.push(own),
                None => found.push((&own.times, vec![own])),
            }
        }
        let joined = found.into_iter().map(|(times, same)| {
            let residuals = (0..times.len()).flat_map(|sample| {
                let residual = move |own: &&Series| own.sides[sample * own.count];
                same.iter().map(residual).collect::<Vec<f64>>()
            });
            Series {
                sides: residuals.collect(),
                times: times.clone(),
                count: same.len(),
            }
        });
        joined.collect()
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

// Cubic B-splines on evenly spaced knots: a basis for motions that are smooth on the scale of the knot interval.

/// Number of cubic B-splines that are nonzero at a given time.
pub(super) const SUPPORT: usize = 4;

/// Basis of cubic B-splines with evenly spaced knots over a time interval.
#[derive(Clone, Copy, Debug)]
pub(super) struct SplineBasis {
    start: f64,
    knot_interval: f64,
    intervals: usize,
}

impl SplineBasis {
    /// Basis over `start` … `end`, s, with knots at most `knot_interval` apart, or [`MAX_INTERVALS`] intervals.
    pub fn new((start, end): (f64, f64), knot_interval: f64) -> Self {
        let span = (end - start).max(f64::MIN_POSITIVE);
        let intervals = (span / knot_interval).ceil().clamp(1.0, MAX_INTERVALS);
        Self {
            start,
            knot_interval: span / intervals,
            intervals: intervals as usize,
        }
    }

    /// Number of splines in the basis.
    pub fn len(&self) -> usize {
        self.intervals + SUPPORT - 1
    }

    /// Index of the first spline that is nonzero at `time`, s, and the values of this spline and the next three.
    pub fn at(&self, time: f64) -> (usize, [f64; SUPPORT]) {
        let place = (time - self.start) / self.knot_interval;
        let interval = (place.max(0.0) as usize).min(self.intervals - 1);
        let u = place - interval as f64;
        let v = 1.0 - u;
        let values = [
            v * v * v,
            3.0 * u * u * u - 6.0 * u * u + 4.0,
            3.0 * v * v * v - 6.0 * v * v + 4.0,
            u * u * u,
        ];
        (interval, values.map(|value| value / 6.0))
    }
}

/// Maximum number of knot intervals of a spline basis over one flight; bounds the memory.
const MAX_INTERVALS: f64 = 4096.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splines_sum_to_one_and_reproduce_a_line() {
        let basis = SplineBasis::new((0.5, 2.5), 0.3);
        assert_eq!(basis.len(), 10);
        for k in 0..=20 {
            let time = 0.5 + 0.1 * f64::from(k);
            let (first, values) = basis.at(time);
            assert!(first + SUPPORT <= basis.len());
            assert!((values.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            // The Greville abscissa of spline j is start + (j - 1) knot intervals.
            let line: f64 = (0..SUPPORT)
                .map(|k| values[k] * (0.5 + ((first + k) as f64 - 1.0) * 2.0 / 7.0))
                .sum();
            assert!((line - time).abs() < 1e-12, "{line} {time}");
        }
    }
}
