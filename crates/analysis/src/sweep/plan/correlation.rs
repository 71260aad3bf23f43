//! Cholesky factor of the correlation matrix of the normal axes.

/// Lower triangular factor L of a correlation matrix C = L Lᵀ, row by row; row i has i + 1 elements.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Factor(Vec<Vec<f64>>);

/// Pivot of the factorization below which a variable is a linear combination of the preceding ones.
const DEPENDENT: f64 = 1e-10;
/// Most negative pivot that is attributed to rounding; with a more negative one the matrix is rejected.
const ROUNDING: f64 = -1e-6;

impl Factor {
    /// Factor of a correlation matrix; `None` if the matrix is not positive semidefinite.
    pub(crate) fn of(matrix: &[Vec<f64>]) -> Option<Factor> {
        let n = matrix.len();
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(n);
        for i in 0..n {
            let mut row = vec![0.0; i + 1];
            for j in 0..=i {
                let before: f64 = (0..j)
                    .map(|k| row[k] * if i == j { row[k] } else { rows[j][k] })
                    .sum();
                let left = matrix[i][j] - before;
                if i == j {
                    if left < ROUNDING {
                        return None;
                    }
                    row[i] = if left < DEPENDENT { 0.0 } else { left.sqrt() };
                } else if rows[j][j] > 0.0 {
                    row[j] = left / rows[j][j];
                } else if left.abs() > ROUNDING.abs().sqrt() {
                    return None;
                }
            }
            rows.push(row);
        }
        Some(Factor(rows))
    }

    /// Correlated standard normal value of variable `i`, from independent ones.
    #[inline]
    pub(crate) fn mix(&self, i: usize, independent: &[f64]) -> f64 {
        let row = self.0[i].iter().zip(independent);
        row.map(|(weight, number)| weight * number).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::Factor;

    #[test]
    fn a_factor_gives_its_matrix() {
        let matrix = [[1.0, 0.6, -0.3], [0.6, 1.0, 0.2], [-0.3, 0.2, 1.0]].map(|row| row.to_vec());
        let Factor(rows) = Factor::of(&matrix).expect("a correlation matrix");
        for i in 0..3 {
            for j in 0..=i {
                let product: f64 = (0..=j).map(|k| rows[i][k] * rows[j][k]).sum();
                assert!((product - matrix[i][j]).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn what_no_distribution_has_is_refused_and_dependence_is_not() {
        let impossible =
            [[1.0, 0.9, -0.9], [0.9, 1.0, 0.9], [-0.9, 0.9, 1.0]].map(|row| row.to_vec());
        assert!(Factor::of(&impossible).is_none());
        let dependent = [[1.0, 1.0], [1.0, 1.0]].map(|row| row.to_vec());
        let factor = Factor::of(&dependent).expect("dependent variables");
        assert_eq!(factor.mix(1, &[0.7, 5.0]), 0.7);
    }
}
