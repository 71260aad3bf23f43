//! Cholesky factor and inverse of symmetric matrices after scaling to a unit diagonal.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn, SymmetricEigen};

/// Square root of a diagonal entry of a matrix, at or below which the row and the column of this entry are not scaled.
const MIN_ROOT: f64 = 1e-150;

/// Squared pivot of a Cholesky factorisation, for a matrix with unit diagonal, below which a column is considered
/// linearly dependent on the previous ones.
const MIN_SQUARED_PIVOT: f64 = 1e-11;

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

/// Cholesky factor of a symmetric matrix that is scaled to a unit diagonal first, because the unknowns differ by seven
/// orders of magnitude.
pub(crate) struct ScaledCholesky {
    scale: DVector<f64>,
    cholesky: Cholesky<f64, Dyn>,
}

impl ScaledCholesky {
    /// Scales a matrix to a unit diagonal, adds `damping` to this diagonal, and factors the result; `None` if the
    /// result is not positive definite.
    pub fn new(matrix: &DMatrix<f64>, damping: f64) -> Option<Self> {
        let scale = jacobi_scale(matrix, MIN_ROOT, 1.0);
        let mut scaled = scaled(matrix, &scale);
        for i in 0..matrix.nrows() {
            scaled[(i, i)] += damping;
        }
        let cholesky = scaled.cholesky()?;
        Some(Self { scale, cholesky })
    }

    /// Scales a matrix to a unit diagonal, adds `damping` to this diagonal, and factors the result; `None` if the
    /// result is not positive definite, or if a column is linearly dependent on other columns within rounding error.
    pub fn independent(matrix: &DMatrix<f64>, damping: f64) -> Option<Self> {
        let factor = Self::new(matrix, damping)?;
        let least = factor.cholesky.l_dirty().diagonal().min();
        (matrix.nrows() == 0 || least * least > MIN_SQUARED_PIVOT).then_some(factor)
    }

    /// Solves A x = right for a vector x. A is the unscaled matrix from which the factor was created, with `damping` ×
    /// its diagonal added.
    pub fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let scaled = right.component_mul(&self.scale);
        self.cholesky.solve(&scaled).component_mul(&self.scale)
    }

    /// Solves A X = right for a matrix X. A is the unscaled matrix from which the factor was created, with `damping` ×
    /// its diagonal added.
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

/// Inverse of an information matrix by eigendecomposition after scaling to a unit diagonal. Eigenvalues below `least`
/// are raised to `least`, which bounds the variance along directions without information.
pub(crate) fn floored_inverse(information: &DMatrix<f64>, least: f64) -> DMatrix<f64> {
    /// Scale of an unknown without information, used instead of 1/√diagonal.
    const SCALE_WITHOUT_INFORMATION: f64 = 1e6;
    let size = information.nrows();
    if size == 0 {
        return DMatrix::zeros(0, 0);
    }
    let scale = jacobi_scale(information, 1e-100, SCALE_WITHOUT_INFORMATION);
    let eigen = SymmetricEigen::new(scaled(information, &scale));
    let mut inverse = DMatrix::zeros(size, size);
    let pairs = eigen
        .eigenvalues
        .iter()
        .zip(eigen.eigenvectors.column_iter());
    for (value, vector) in pairs {
        inverse.ger(1.0 / value.max(least), &vector, &vector, 1.0);
    }
    scaled(&inverse, &scale)
}

/// Eigenvalue of a matrix with unit diagonal, below which it is considered 0.
const MIN_EIGENVALUE: f64 = 1e-12;

/// Pseudo-inverse of a symmetric positive semidefinite matrix, computed after scaling to a unit diagonal; `None` if the
/// eigenvalue iteration fails.
pub fn pseudo_inverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    /// Relative accuracy and maximum number of iterations of the eigenvalue iteration.
    const EIGEN_ITERATION: (f64, usize) = (1e-14, 10_000);
    if matrix.nrows() == 0 {
        return Some(DMatrix::zeros(0, 0));
    }
    let scale = jacobi_scale(matrix, MIN_ROOT, 1.0);
    let (accuracy, most) = EIGEN_ITERATION;
    let eigen = SymmetricEigen::try_new(scaled(matrix, &scale), accuracy, most)?;
    let mut weighted = eigen.eigenvectors.clone();
    for (mut column, &value) in weighted.column_iter_mut().zip(eigen.eigenvalues.iter()) {
        column *= if value > MIN_EIGENVALUE {
            1.0 / value
        } else {
            0.0
        };
    }
    let inverse = weighted * eigen.eigenvectors.transpose();
    Some(scaled(&inverse, &scale))
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
    }
}
