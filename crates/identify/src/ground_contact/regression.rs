//! Least squares of a vector on a few functions of time, with noise that is correlated from sample to sample.

use nalgebra::{SMatrix, SVector, Vector3};

/// Relative increase of the diagonal of the normal matrix, which makes it invertible where functions are nearly alike.
const RIDGE: f64 = 1e-9;

/// One measured vector and the values of the functions there.
#[derive(Clone, Copy, Debug)]
pub struct Row<const N: usize> {
    /// Sample number.
    pub sample: usize,
    /// Values of the functions.
    pub functions: SVector<f64, N>,
    /// Measured vector.
    pub value: Vector3<f64>,
}

/// A solved regression.
#[derive(Clone, Debug)]
pub struct Regression<const N: usize> {
    /// Coefficients of the functions, a column for each component.
    pub coefficients: SMatrix<f64, N, 3>,
    /// Sum of squared whitened residuals, with those of the expected coefficients.
    pub squares: f64,
    /// Degrees of freedom of the residuals.
    pub freedom: f64,
    /// Squared residual of each whitened row, by the part of its variance that the regression leaves.
    pub removable: Vec<f64>,
    inverse: SMatrix<f64, N, N>,
    origin: Vector3<f64>,
    correlation: f64,
}

/// Least part of a residual's variance that divides it; less is rounding.
const LEAST_PART: f64 = 0.05;

impl<const N: usize> Regression<N> {
    /// Solves the regression. `precisions` are the variance of the noise by that of each coefficient about 0, or 0 for a
    /// coefficient of which nothing is known; `correlation` is that of the noise in neighbouring samples, 0 to 0.9. None
    /// without rows or if the rows do not determine the coefficients.
    pub fn solve(rows: &[Row<N>], precisions: &[f64; N], correlation: f64) -> Option<Self> {
        let origin = rows.first()?.value;
        let mut normal = SMatrix::<f64, N, N>::zeros();
        let mut right = SMatrix::<f64, N, 3>::zeros();
        let each = (0..rows.len()).map(|index| {
            let previous = index.checked_sub(1).map(|previous| &rows[previous]);
            whitened(previous, &rows[index], origin, correlation)
        });
        let each: Vec<_> = each.collect();
        for (functions, value) in &each {
            normal += functions * functions.transpose();
            right += functions * value.transpose();
        }
        for (index, precision) in precisions.iter().enumerate() {
            normal[(index, index)] = normal[(index, index)] * (1.0 + RIDGE) + precision;
        }
        let inverse = normal.cholesky()?.inverse();
        let coefficients = inverse * right;
        let (mut squares, mut used) = (0.0, 0.0);
        let removable = each.iter().map(|(functions, value)| {
            let square = (value - coefficients.tr_mul(functions)).norm_squared();
            let leverage = functions.dot(&(inverse * functions));
            squares += square;
            used += leverage;
            square / (1.0 - leverage).max(LEAST_PART)
        });
        let removable = removable.collect();
        for (index, precision) in precisions.iter().enumerate() {
            squares += precision * coefficients.row(index).norm_squared();
        }
        Some(Self {
            coefficients,
            squares,
            freedom: (3.0 * (each.len() as f64 - used)).max(3.0),
            removable,
            inverse,
            origin,
            correlation,
        })
    }

    /// Mean squared residual by degree of freedom.
    pub fn variance(&self) -> f64 {
        self.squares / self.freedom
    }

    /// Squared distance of a row from its prediction by the regression and the row before it, by the variance of that
    /// prediction for noise of variance 1.
    pub fn innovation(&self, previous: &Row<N>, row: &Row<N>) -> f64 {
        let (functions, value) = whitened(Some(previous), row, self.origin, self.correlation);
        let square = (value - self.coefficients.tr_mul(&functions)).norm_squared();
        square / (1.0 + functions.dot(&(self.inverse * functions)))
    }
}

/// A row less what the noise of the previous one predicts of it, scaled to noise of the same variance in each row.
fn whitened<const N: usize>(
    previous: Option<&Row<N>>,
    row: &Row<N>,
    origin: Vector3<f64>,
    correlation: f64,
) -> (SVector<f64, N>, Vector3<f64>) {
    let fresh = 1.0 - correlation * correlation;
    let value = row.value - origin;
    let Some(previous) = previous else {
        let scale = fresh.sqrt();
        return (row.functions * scale, value * scale);
    };
    let interval = row.sample.saturating_sub(previous.sample).max(1);
    let shared = correlation.powi(i32::try_from(interval).unwrap_or(i32::MAX));
    let scale = (fresh / (1.0 - shared * shared)).sqrt();
    (
        (row.functions - previous.functions * shared) * scale,
        (value - (previous.value - origin) * shared) * scale,
    )
}
