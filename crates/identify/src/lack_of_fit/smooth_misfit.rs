//! Smooth part of the residuals of one flight: the reduction of the sum of squares by splines, beyond the reduction
//! by the flight's own unknowns.

use crate::noise::{AxesNoise, NoiseModel};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::f_test::ScaledStatistic;
use super::noise_floor::FlightSeries;
use super::series::Series;
use super::spline_basis::SplineBasis;

/// Minimum eigenvalue of the Gram matrix of the local columns (derivatives of the residuals with respect to the
/// flight's initial state, scaled to unit norm). Directions with smaller eigenvalues after projecting out the splines
/// are dropped, because the splines reproduce them.
const MIN_TOLERANCE: f64 = 1e-9;

/// Lack-of-fit statistics of one flight: reduction of the sum of squares of its residuals by two sets of splines.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct FlightMisfit {
    /// Reduction of the sum of squares by splines that follow slow deviations of the residuals from zero, such as those
    /// caused by wrong forces. The knots are a fifth of the flight's duration apart.
    pub slow: ScaledStatistic,
    /// Reduction of the sum of squares by splines that follow fast deviations of the residuals from zero, such as those
    /// caused by errors of marker positions, attitude and spin. There are several knots for each turn of the body.
    pub fine: ScaledStatistic,
}

/// Sums of products over all residual series of a flight, before and after projecting out one spline basis. Local
/// columns are the derivatives of the residuals with respect to the flight's initial state.
struct Projection {
    /// Sum of squares of the residuals' projection on the splines.
    squares: f64,
    rank: usize,
    /// Gram matrix of the derivatives of the residuals with respect to the flight's initial state, after the splines
    /// are projected out. `left_gradient` contains the products of these projected derivatives with the residuals.
    left: DMatrix<f64>,
    left_gradient: DVector<f64>,
    /// Sum of squares of the residuals before the splines are projected out. `local` (Gram matrix of the derivatives of
    /// the residuals with respect to the flight's initial state) and `gradient` (products of these derivatives with the
    /// residuals) are also values before this projection.
    total: f64,
    local: DMatrix<f64>,
    gradient: DVector<f64>,
    samples: usize,
}

impl FlightMisfit {
    /// Tests the residuals of a flight against the noise floor; `None` if the flight has too few samples. The standard
    /// deviation of the flight's noise is assumed to be at least `least_ratio` times that of the noise floor, because
    /// integration errors also contribute to the residuals.
    pub fn new(
        flight: &FlightSeries,
        slow: &SplineBasis,
        noise: &NoiseModel,
        least_ratio: f64,
    ) -> Option<Self> {
        let of_fine = Projection::new(flight, &flight.fine, noise);
        let of_slow = Projection::new(flight, slow, noise);
        let scale = of_fine.local.diagonal().map(|value| {
            let root = value.max(0.0).sqrt();
            if root > 0.0 { 1.0 / root } else { 0.0 }
        });
        let (of_locals, locals) = decrease(&of_fine.local, &of_fine.gradient, &scale);
        let statistic = |found: &Projection| {
            let (left, rank) = decrease(&found.left, &found.left_gradient, &scale);
            let degrees_of_freedom = (found.rank + rank).saturating_sub(locals) as f64;
            (found.squares + left - of_locals, degrees_of_freedom, rank)
        };
        let (fine, fine_dof, rank) = statistic(&of_fine);
        let (slow, slow_dof, _) = statistic(&of_slow);
        let degrees_of_freedom = of_fine.samples as f64 - (of_fine.rank + rank) as f64;
        if degrees_of_freedom < 1.0 {
            return None;
        }
        let remaining = (of_fine.total - of_locals - fine).max(0.0);
        let variance = (remaining / degrees_of_freedom).max(least_ratio * least_ratio);
        let scaled = |value: f64, of: f64| ScaledStatistic {
            value: value.max(0.0) / variance,
            degrees_of_freedom: of,
            noise_variance: of * of * 2.0 / degrees_of_freedom,
        };
        Some(Self {
            slow: scaled(slow, slow_dof),
            fine: scaled(fine, fine_dof),
        })
    }

    /// p-value of the flight's lack-of-fit test. `relative_error` is the relative standard error of the noise variance
    /// at low frequencies, which is extrapolated from high frequencies.
    pub fn p_value(&self, relative_error: f64) -> f64 {
        least_p(self.slow, self.fine, relative_error)
    }
}

/// Bonferroni-corrected p-value of the more significant of two tests: of slow deviations of the residuals from zero
/// (`slow`), and of fast ones (`fine`). `relative_error` is the relative standard error of the noise variance at low
/// frequencies; it widens the null distributions of both statistics.
pub(super) fn least_p(slow: ScaledStatistic, fine: ScaledStatistic, relative_error: f64) -> f64 {
    let p = [slow, fine].map(|mut statistic| {
        statistic.noise_variance += (statistic.degrees_of_freedom * relative_error).powi(2);
        statistic.p_value()
    });
    (2.0 * p[0].min(p[1])).min(1.0)
}

impl Projection {
    fn new(flight: &FlightSeries, basis: &SplineBasis, noise: &NoiseModel) -> Self {
        let count = flight.series.first().map_or(1, |series| series[0].count);
        let locals = count - 1;
        let mut sum = Self {
            squares: 0.0,
            rank: 0,
            left: DMatrix::zeros(locals, locals),
            left_gradient: DVector::zeros(locals),
            total: 0.0,
            local: DMatrix::zeros(locals, locals),
            gradient: DVector::zeros(locals),
            samples: 0,
        };
        for (channel, axes) in flight.series.iter().enumerate() {
            for (axis, series) in axes.iter().enumerate() {
                sum.add(series, basis, noise.of(channel), axis);
            }
        }
        sum.left = &sum.local - &sum.left;
        sum.left_gradient = &sum.gradient - &sum.left_gradient;
        sum
    }

    fn add(&mut self, series: &Series, basis: &SplineBasis, noise: &AxesNoise, axis: usize) {
        let found = series.whitened(basis, noise, axis);
        let count = series.count;
        self.total += found.products[0];
        self.rank += found.projected.rank;
        self.samples += found.samples;
        for i in 1..count {
            self.gradient[i - 1] += found.products[i];
            for j in 1..count {
                self.local[(i - 1, j - 1)] += found.products[i * count + j];
            }
        }
        for row in found.projected.coordinates.chunks_exact(count) {
            self.squares += row[0] * row[0];
            for i in 1..count {
                self.left_gradient[i - 1] += row[0] * row[i];
                for j in 1..count {
                    self.left[(i - 1, j - 1)] += row[i] * row[j];
                }
            }
        }
    }
}

/// Reduction of the sum of squares by fitting columns with Gram matrix `matrix` and products `gradient` with the
/// residuals, and the number of independent directions. The columns are multiplied by `scale` before the rank is
/// determined.
fn decrease(matrix: &DMatrix<f64>, gradient: &DVector<f64>, scale: &DVector<f64>) -> (f64, usize) {
    let size = gradient.len();
    if size == 0 {
        return (0.0, 0);
    }
    let scaled = DMatrix::from_fn(size, size, |i, j| matrix[(i, j)] * scale[i] * scale[j]);
    let Some(eigen) = SymmetricEigen::try_new(scaled, 1e-14, 10_000) else {
        return (0.0, 0);
    };
    let products = eigen.eigenvectors.tr_mul(&gradient.component_mul(scale));
    let kept = eigen.eigenvalues.iter().zip(products.iter());
    let kept = kept.filter(|(value, _)| **value > MIN_TOLERANCE);
    kept.fold((0.0, 0), |(sum, rank), (value, product)| {
        (sum + product * product / value, rank + 1)
    })
}
