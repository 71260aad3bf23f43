//! Pseudo-inverse, by one-sided Jacobi rotations (Hestenes 1958).
//!
//! The rotations make the columns of the matrix orthogonal; their lengths are then the singular values. The decomposition
//! of nalgebra is not used: of some matrices, also well-conditioned ones, its singular values are wrong by percents
//! without a sign of it (issues 1117 and 1172 of nalgebra, open at 0.35).

use nalgebra::DMatrix;

/// Cosine of the angle between two columns below which they are orthogonal to rounding.
const ORTHOGONAL: f64 = f64::EPSILON;
/// Maximum number of passes over all pairs of columns; six to eight suffice.
const MAX_SWEEPS: usize = 40;

/// Moore–Penrose pseudo-inverse of a matrix: applied to a right-hand side, it gives the least-squares solution of least
/// norm. Singular values of at most `tolerance` times the greatest count as 0. Not finite where the matrix is not.
///
/// ```
/// let inverse = flight::moore_penrose(&nalgebra::DMatrix::from_element(3, 5, 1.0), 1e-9);
/// assert!(inverse.iter().all(|entry| (entry - 1.0 / 15.0).abs() < 1e-15));
/// ```
pub fn moore_penrose(matrix: &DMatrix<f64>, tolerance: f64) -> DMatrix<f64> {
    if matrix.nrows() < matrix.ncols() {
        return moore_penrose(&matrix.transpose(), tolerance).transpose();
    }
    let mut columns = matrix.clone();
    let mut turned = DMatrix::identity(matrix.ncols(), matrix.ncols());
    for _ in 0..MAX_SWEEPS {
        if !sweep(&mut columns, &mut turned) {
            break;
        }
    }
    let squares: Vec<f64> = columns
        .column_iter()
        .map(|own| own.norm_squared())
        .collect();
    let least = squares.iter().copied().fold(0.0, f64::max) * tolerance * tolerance;
    for (square, mut column) in squares.iter().zip(turned.column_iter_mut()) {
        // A value that is not a number is kept, and makes the result one.
        column *= if *square <= least { 0.0 } else { 1.0 / square };
    }
    turned * columns.transpose()
}

/// Rotates each pair of columns until they are orthogonal, and `turned` alike; false if all of them were.
fn sweep(columns: &mut DMatrix<f64>, turned: &mut DMatrix<f64>) -> bool {
    let mut has_rotated = false;
    for first in 0..columns.ncols() {
        for second in first + 1..columns.ncols() {
            let (a, b) = (columns.column(first), columns.column(second));
            let (product, squares) = (a.dot(&b), (a.norm_squared(), b.norm_squared()));
            let is_orthogonal = product.abs() <= ORTHOGONAL * (squares.0 * squares.1).sqrt();
            if is_orthogonal || !product.is_finite() {
                continue;
            }
            let cotangent = (squares.1 - squares.0) / (2.0 * product);
            let tangent = cotangent.signum() / (cotangent.abs() + cotangent.hypot(1.0));
            let cosine = 1.0 / tangent.hypot(1.0);
            for matrix in [&mut *columns, &mut *turned] {
                rotate(matrix, (first, second), (cosine, cosine * tangent));
            }
            has_rotated = true;
        }
    }
    has_rotated
}

/// Rotates two columns by an angle of the given cosine and sine.
fn rotate(matrix: &mut DMatrix<f64>, (first, second): (usize, usize), (cosine, sine): (f64, f64)) {
    for row in 0..matrix.nrows() {
        let (a, b) = (matrix[(row, first)], matrix[(row, second)]);
        matrix[(row, first)] = cosine * a - sine * b;
        matrix[(row, second)] = sine * a + cosine * b;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The four conditions of Penrose, which determine the pseudo-inverse.
    fn assert_inverse(matrix: &DMatrix<f64>, tolerance: f64) {
        let inverse = moore_penrose(matrix, tolerance);
        let (left, right) = (matrix * &inverse, &inverse * matrix);
        let size = 1e-13 * (1.0 + matrix.amax()) * (1.0 + inverse.amax());
        assert!((&left * matrix - matrix).amax() < size, "{matrix}");
        assert!((&right * &inverse - &inverse).amax() < size * (1.0 + inverse.amax()));
        assert!((&left - left.transpose()).amax() < size);
        assert!((&right - right.transpose()).amax() < size);
    }

    #[test]
    fn it_is_the_inverse_of_matrices_of_which_nalgebra_has_wrong_singular_values() {
        for rows in 1..12 {
            for columns in 1..12 {
                assert_inverse(&DMatrix::from_element(rows, columns, 1.0), 1e-9);
            }
        }
        let full = [1.0, 2.0, 2.0, 2.0, -1.0, -1.0, 2.0, 1.0, -1.0];
        assert_inverse(&DMatrix::from_row_slice(3, 3, &full), 1e-9);
    }

    #[test]
    fn it_is_the_inverse_of_matrices_of_every_shape_and_rank() {
        let mut random = 1_u64;
        let mut draw = || {
            random = random
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (random >> 33) as f64 / f64::from(1_u32 << 30) - 1.0
        };
        for (rows, columns, rank) in [(18, 13, 12), (13, 18, 12), (6, 13, 6), (5, 5, 1), (9, 4, 4)]
        {
            for _ in 0..20 {
                let left = DMatrix::from_fn(rows, rank, |_, _| draw());
                let right = DMatrix::from_fn(rank, columns, |_, _| draw());
                assert_inverse(&(left * right), 1e-9);
            }
        }
        assert_eq!(
            moore_penrose(&DMatrix::zeros(3, 2), 1e-9),
            DMatrix::zeros(2, 3)
        );
    }

    #[test]
    fn what_is_not_finite_ends_and_is_not_finite() {
        for wrong in [f64::NAN, f64::INFINITY] {
            let mut matrix = DMatrix::from_element(4, 3, 1.0);
            matrix[(1, 1)] = wrong;
            let inverse = moore_penrose(&matrix, 1e-9);
            assert!(!inverse.iter().all(|entry| entry.is_finite()));
        }
    }
}
