//! Least-squares regression of a vector on a few functions of time, with noise that is correlated between samples.

use nalgebra::{SMatrix, SVector, Vector3};

/// Relative increase of the diagonal of the normal matrix, so that it is invertible if functions are nearly collinear.
const RIDGE: f64 = 1e-9;

/// One measured vector and the values of the basis functions at its time.
#[derive(Clone, Copy, Debug)]
pub struct Row<const N: usize> {
    /// Index of the sample.
    pub sample: usize,
    /// Values of the basis functions.
    pub functions: SVector<f64, N>,
    /// Measured vector.
    pub value: Vector3<f64>,
}

/// Solution of a regression.
#[derive(Clone, Debug)]
pub struct Regression<const N: usize> {
    /// Coefficients of the basis functions; one column per component of the vector.
    pub coefficients: SMatrix<f64, N, 3>,
    /// Sum of squared whitened residuals, plus the penalty by the priors of the coefficients.
    pub squares: f64,
    /// Degrees of freedom of the residuals, at least 3.
    pub freedom: f64,
    /// For each whitened row, the squared residual divided by 1 − leverage: the decrease of the sum of squares if the
    /// row is removed.
    pub removable: Vec<f64>,
    inverse: SMatrix<f64, N, N>,
    origin: Vector3<f64>,
    correlation: f64,
}

/// Minimum of 1 − leverage used as a divisor; smaller values are rounding errors.
const LEAST_PART: f64 = 0.05;

impl<const N: usize> Regression<N> {
    /// Solves the regression. `precisions` are the ratios of the noise variance to the prior variance of each
    /// coefficient about 0; 0 for a coefficient without prior. `correlation` is the correlation of the noise between
    /// successive samples, 0 to 0.9. `None` if there are no rows or if they do not determine the coefficients.
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

    /// Residual variance: sum of squared residuals per degree of freedom.
    pub fn variance(&self) -> f64 {
        self.squares / self.freedom
    }

    /// Squared innovation: squared distance of a row from its prediction by the regression and the previous row,
    /// divided by the variance of that prediction for noise of variance 1.
    pub fn innovation(&self, previous: &Row<N>, row: &Row<N>) -> f64 {
        let (functions, value) = whitened(Some(previous), row, self.origin, self.correlation);
        let square = (value - self.coefficients.tr_mul(&functions)).norm_squared();
        square / (1.0 + functions.dot(&(self.inverse * functions)))
    }
}

/// Subtracts from a row the part that the noise of the previous row predicts, and scales it so that all rows have the
/// same noise variance.
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
