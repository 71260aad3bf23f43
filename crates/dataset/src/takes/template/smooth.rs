//! Residual of a signal after a polynomial in time is fitted to it.

use nalgebra::DMatrix;

/// Least-squares fits of polynomials in time to weighted samples of a flight.
pub(super) struct Smooth {
    roots: Vec<f64>,
    /// Orthonormal basis of the weighted polynomials, whose values are multiplied by the square roots of the weights.
    basis: DMatrix<f64>,
    /// Matrix from coefficients of the columns of `basis` to those of the Legendre polynomials.
    coefficients: DMatrix<f64>,
    /// First and second derivatives of the Legendre polynomials with respect to time, 1/s and 1/s².
    derivatives: [DMatrix<f64>; 2],
    /// Values of the Legendre polynomials at the samples: one row per sample, one column per degree from 0.
    values: DMatrix<f64>,
}

impl Smooth {
    /// Fits of polynomials up to a degree at times (s) with weights; `None` without more samples than coefficients.
    pub fn new(times: &[f64], weights: &[f64], degree: usize) -> Option<Self> {
        let (count, columns) = (times.len(), degree + 1);
        if count <= columns {
            return None;
        }
        let middle = 0.5 * (times[0] + times[count - 1]);
        let half = 0.5 * (times[count - 1] - times[0]);
        let [mut values, mut first, mut second] =
            [0; 3].map(|_| DMatrix::<f64>::zeros(count, columns));
        for (i, time) in times.iter().enumerate() {
            let x = (time - middle) / half;
            values[(i, 0)] = 1.0;
            for n in 0..degree {
                // Recurrence of the Legendre polynomials, differentiated twice.
                let (a, b) = ((2 * n + 1) as f64, n as f64);
                let before = |of: &DMatrix<f64>| if n > 0 { of[(i, n - 1)] } else { 0.0 };
                let next = |terms: f64, before: f64| (a * terms - b * before) / (n + 1) as f64;
                let v = next(x * values[(i, n)], before(&values));
                let d = next(values[(i, n)] + x * first[(i, n)], before(&first));
                let dd = next(2.0 * first[(i, n)] + x * second[(i, n)], before(&second));
                (values[(i, n + 1)], first[(i, n + 1)], second[(i, n + 1)]) = (v, d, dd);
            }
        }
        let roots: Vec<f64> = weights.iter().map(|weight| weight.sqrt()).collect();
        let weighted = DMatrix::from_fn(count, columns, |i, k| roots[i] * values[(i, k)]);
        let decomposition = weighted.qr();
        Some(Self {
            coefficients: decomposition.r().try_inverse()?,
            basis: decomposition.q(),
            roots,
            derivatives: [first / half, second / (half * half)],
            values,
        })
    }

    /// Residuals of signals (one column each) from their polynomials, times the square roots of the weights.
    pub fn rest(&self, signals: &DMatrix<f64>) -> DMatrix<f64> {
        let weighted = self.weighted(signals);
        let fitted = &self.basis * (self.basis.transpose() * &weighted);
        weighted - fitted
    }

    /// Polynomials fitted to signals (one column each), with first and second derivatives in time, at the samples.
    pub fn fitted(&self, signals: &DMatrix<f64>) -> [DMatrix<f64>; 3] {
        let of_basis = self.basis.transpose() * self.weighted(signals);
        let coefficients = &self.coefficients * of_basis;
        let [first, second] = &self.derivatives;
        [&self.values, first, second].map(|each| each * &coefficients)
    }

    /// Fraction of the variance of white noise at sample `i` that remains in the residual of a fit.
    pub fn left(&self, i: usize) -> f64 {
        1.0 - self.basis.row(i).norm_squared()
    }

    fn weighted(&self, signals: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(signals.nrows(), signals.ncols(), |i, k| {
            self.roots[i] * signals[(i, k)]
        })
    }
}
