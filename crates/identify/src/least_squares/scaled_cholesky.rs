//! Cholesky factor and inverse of symmetric matrices after scaling to a unit diagonal.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn, SymmetricEigen};

use dataset::levels::RANK;

/// Square root of a diagonal entry of a matrix, at or below which the row and the column of this entry are not scaled.
const MIN_ROOT: f64 = 1e-150;

/// Squared pivot, for a unit diagonal, below which a column depends on the previous ones.
const MIN_SQUARED_PIVOT: f64 = 10.0 * RANK;

/// Jacobi scaling of a symmetric matrix: 1/√diagonal, or `otherwise` if √diagonal is at most `least`.
pub(crate) fn jacobi_scale(matrix: &DMatrix<f64>, least: f64, otherwise: f64) -> DVector<f64> {
    matrix.diagonal().map(|value| {
        let root = value.max(0.0).sqrt();
        if root > least { 1.0 / root } else { otherwise }
    })
}

/// Matrix product D A D for the diagonal matrix D given by `scale`.
pub(crate) fn scaled(matrix: &DMatrix<f64>, scale: &DVector<f64>) -> DMatrix<f64> {
    let size = matrix.nrows();
    DMatrix::from_fn(size, size, |i, j| matrix[(i, j)] * scale[i] * scale[j])
}

/// Cholesky factor of a symmetric matrix scaled to a unit diagonal, as unknowns differ by seven orders of magnitude.
pub(crate) struct ScaledCholesky {
    scale: DVector<f64>,
    cholesky: Cholesky<f64, Dyn>,
}

impl ScaledCholesky {
    /// Factors the scaled matrix with `damping` added to its diagonal; `None` if it is not positive definite.
    pub fn new(matrix: &DMatrix<f64>, damping: f64) -> Option<Self> {
        let scale = jacobi_scale(matrix, MIN_ROOT, 1.0);
        let mut scaled = scaled(matrix, &scale);
        for i in 0..matrix.nrows() {
            scaled[(i, i)] += damping;
        }
        let cholesky = scaled.cholesky()?;
        Some(Self { scale, cholesky })
    }

    /// [`new`](Self::new), but `None` if a column is linearly dependent on others within rounding error.
    pub fn independent(matrix: &DMatrix<f64>, damping: f64) -> Option<Self> {
        let factor = Self::new(matrix, damping)?;
        let least = factor.cholesky.l_dirty().diagonal().min();
        (matrix.nrows() == 0 || least * least > MIN_SQUARED_PIVOT).then_some(factor)
    }

    /// Solves A x = right, where A is the unscaled matrix with `damping` × its diagonal added.
    pub fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let scaled = right.component_mul(&self.scale);
        self.cholesky.solve(&scaled).component_mul(&self.scale)
    }

    /// Solves A X = right, where A is the unscaled matrix with `damping` × its diagonal added.
    pub fn solve_matrix(&self, right: &DMatrix<f64>) -> DMatrix<f64> {
        let mut solved = right.clone();
        self.scale_rows(&mut solved);
        self.cholesky.solve_mut(&mut solved);
        self.scale_rows(&mut solved);
        solved
    }

    fn scale_rows(&self, matrix: &mut DMatrix<f64>) {
        for (mut row, scale) in matrix.row_iter_mut().zip(self.scale.iter()) {
            row *= *scale;
        }
    }

    /// Inverse of A, the unscaled matrix from which the factor was created, with `damping` × its diagonal added.
    pub fn inverse(&self) -> DMatrix<f64> {
        scaled(&self.cholesky.inverse(), &self.scale)
    }
}

/// Inverse of an information matrix, whose eigenvalues after scaling are raised to `least`, which bounds the variance
/// along directions without information.
pub(crate) fn floored_inverse(information: &DMatrix<f64>, least: f64) -> DMatrix<f64> {
    // Unknowns without information have a scale of their own.
    let scale = jacobi_scale(information, 1e-100, 1e6);
    let inverse = inverse_by(information, &scale, (f64::EPSILON, 0), |value| {
        1.0 / value.max(least)
    });
    inverse.expect("an iteration without a limit")
}

/// Pseudo-inverse of a symmetric positive semidefinite matrix, after scaling to a unit diagonal; `None` if the
/// eigenvalue iteration fails.
pub fn pseudo_inverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let scale = jacobi_scale(matrix, MIN_ROOT, 1.0);
    inverse_by(matrix, &scale, (1e-14, 10_000), |value| {
        let is_zero = value.is_nan() || value <= RANK;
        if is_zero { 0.0 } else { 1.0 / value }
    })
}

/// Matrix with the eigenvectors of a symmetric matrix scaled by `scale`, whose eigenvalues `of` converts. `None` if
/// they are not found with the relative `accuracy` in the maximum number of iterations; 0 for no limit.
fn inverse_by(
    matrix: &DMatrix<f64>,
    scale: &DVector<f64>,
    (accuracy, most): (f64, usize),
    of: impl Fn(f64) -> f64,
) -> Option<DMatrix<f64>> {
    if matrix.nrows() == 0 {
        return Some(DMatrix::zeros(0, 0));
    }
    let eigen = SymmetricEigen::try_new(scaled(matrix, scale), accuracy, most)?;
    let mut weighted = eigen.eigenvectors.clone();
    for (mut column, &value) in weighted.column_iter_mut().zip(eigen.eigenvalues.iter()) {
        column *= of(value);
    }
    Some(scaled(&(weighted * eigen.eigenvectors.transpose()), scale))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_of_a_regular_matrix() {
        let matrix = DMatrix::from_row_slice(2, 2, &[4e10, 1e3, 1e3, 1e-2]);
        let expected = matrix.clone().try_inverse().unwrap();
        let all = [
            floored_inverse(&matrix, 1e-13),
            pseudo_inverse(&matrix).unwrap(),
            ScaledCholesky::new(&matrix, 0.0).unwrap().inverse(),
        ];
        for found in all {
            for (a, b) in found.iter().zip(expected.iter()) {
                assert!((a / b - 1.0).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn a_direction_without_information_is_uncertain() {
        // Only the sum of the two unknowns is determined.
        let matrix = DMatrix::from_element(2, 2, 100.0);
        let found = floored_inverse(&matrix, 1e-13);
        assert!(found[(0, 0)] > 1e9);
        let sum = found[(0, 0)] + 2.0 * found[(0, 1)] + found[(1, 1)];
        assert!(sum < 1e-2 * found[(0, 0)]);
        let pseudo = pseudo_inverse(&matrix).unwrap();
        assert!((pseudo[(0, 0)] - 0.0025).abs() < 1e-12);
        assert!(ScaledCholesky::independent(&matrix, 0.0).is_none());
        // Different but for rounding; without unknowns nothing depends on others.
        let last = 1.0 + 4.0 * f64::EPSILON;
        let nearly = DMatrix::from_row_slice(2, 2, &[1.0, 1.0, 1.0, last]);
        assert!(ScaledCholesky::new(&nearly, 0.0).is_some());
        assert!(ScaledCholesky::independent(&nearly, 0.0).is_none());
        assert!(ScaledCholesky::independent(&DMatrix::zeros(0, 0), 0.0).is_some());
    }
}
