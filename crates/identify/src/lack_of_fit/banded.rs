//! Least squares with a banded design: Gram matrix, its Cholesky factor, and projections on the design's columns.

use dataset::levels::RANK;

/// Number of subdiagonals of the Gram matrix. A whitened row combines the splines of two successive samples at most 5
/// knot intervals apart, at most 9; samples farther apart count as independent.
pub(super) const BANDWIDTH: usize = 8;

/// Gram matrix of a banded design matrix, and the products of the design with several right-hand sides.
#[derive(Clone, Debug)]
pub(super) struct BandedGram {
    /// `band[column][d]`: entry of the Gram matrix at (column + d, column).
    band: Vec<[f64; BANDWIDTH + 1]>,
    /// Products of the design's columns with the right-hand sides: `sides` values for each column of the design.
    products: Vec<f64>,
    sides: usize,
}

/// Projections of the right-hand sides on the columns of a banded design.
#[derive(Clone, Debug)]
pub(super) struct Projected {
    /// L⁻¹ Bᵀ z for each right-hand side z, with the design B and the factor L of BᵀB; 0 in dependent columns.
    pub coordinates: Vec<f64>,
    /// Factor L: `factor[column][d]` is the entry at (column + d, column); 0 in dependent columns.
    factor: Vec<[f64; BANDWIDTH + 1]>,
    pub rank: usize,
    /// Natural logarithm of the determinant of the Gram matrix of the independent columns.
    pub ln_determinant: f64,
    sides: usize,
}

impl BandedGram {
    /// Creates the zero Gram matrix of a design with `columns` columns, for `sides` right-hand sides.
    pub fn new(columns: usize, sides: usize) -> Self {
        Self {
            band: vec![[0.0; BANDWIDTH + 1]; columns],
            products: vec![0.0; columns * sides],
            sides,
        }
    }

    /// Adds a row of the design, its nonzero entries from column `first` on, with its right-hand sides.
    pub fn add(&mut self, first: usize, row: &[f64], sides: &[f64]) {
        for (i, &value) in row.iter().enumerate() {
            let column = first + i;
            for (d, &below) in row[i..].iter().enumerate() {
                self.band[column][d] += value * below;
            }
            let products = &mut self.products[column * self.sides..][..self.sides];
            for (product, side) in products.iter_mut().zip(sides) {
                *product += value * side;
            }
        }
    }

    /// Factors the Gram matrix and projects the right-hand sides on the columns of the design.
    pub fn project(mut self) -> Projected {
        let (mut rank, mut ln_determinant) = (0, 0.0);
        let columns = self.band.len();
        let diagonal: Vec<f64> = self.band.iter().map(|column| column[0]).collect();
        for column in 0..columns {
            let pivot = self.band[column][0];
            let sides = column * self.sides..(column + 1) * self.sides;
            if pivot.is_nan() || pivot <= RANK * diagonal[column] {
                self.band[column] = [0.0; BANDWIDTH + 1];
                self.products[sides].fill(0.0);
                continue;
            }
            rank += 1;
            ln_determinant += pivot.ln();
            let root = pivot.sqrt();
            self.band[column]
                .iter_mut()
                .for_each(|value| *value /= root);
            self.products[sides]
                .iter_mut()
                .for_each(|value| *value /= root);
            let own = self.band[column];
            for d in 1..=BANDWIDTH.min(columns - 1 - column) {
                for e in d..=BANDWIDTH.min(columns - 1 - column) {
                    self.band[column + d][e - d] -= own[d] * own[e];
                }
                let (before, after) = self.products.split_at_mut((column + d) * self.sides);
                let from = &before[column * self.sides..][..self.sides];
                for (to, from) in after.iter_mut().zip(from) {
                    *to -= own[d] * from;
                }
            }
        }
        Projected {
            coordinates: self.products,
            factor: self.band,
            rank,
            ln_determinant,
            sides: self.sides,
        }
    }
}

impl Projected {
    /// Least-squares coefficients of the design's columns for the first right-hand side; 0 for dependent columns.
    pub fn coefficients(&self) -> Vec<f64> {
        let columns = self.factor.len();
        let mut values: Vec<f64> = self
            .coordinates
            .iter()
            .step_by(self.sides)
            .copied()
            .collect();
        for column in (0..columns).rev() {
            let own = &self.factor[column];
            if own[0] <= 0.0 {
                values[column] = 0.0;
                continue;
            }
            let above: f64 = (1..=BANDWIDTH.min(columns - 1 - column))
                .map(|d| own[d] * values[column + d])
                .sum();
            values[column] = (values[column] - above) / own[0];
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    #[test]
    fn a_projection_is_that_of_the_dense_least_squares() {
        let columns = 12;
        let mut gram = BandedGram::new(columns, 1);
        let mut design = DMatrix::zeros(40, columns);
        let mut side = DVector::zeros(40);
        for i in 0..40 {
            let first = (i * (columns - 3) / 40).min(columns - 4);
            let row: Vec<f64> = (0..4).map(|k| ((3 * i + 5 * k) as f64).sin()).collect();
            side[i] = (i as f64).cos();
            gram.add(first, &row, &[side[i]]);
            for k in 0..4 {
                design[(i, first + k)] = row[k];
            }
        }
        // A column without data is dependent.
        for i in 0..40 {
            assert_eq!(design[(i, columns - 1)] * 0.0, 0.0);
        }
        let found = gram.project();
        let normal = design.tr_mul(&design);
        let expected = normal.clone().try_inverse().unwrap() * design.tr_mul(&side);
        for (a, b) in found.coefficients().iter().zip(expected.iter()) {
            assert!((a - b).abs() < 1e-8, "{a} {b}");
        }
        let squares: f64 = found.coordinates.iter().map(|c| c * c).sum();
        assert!((squares - (design * expected).norm_squared()).abs() < 1e-9);
        assert_eq!(found.rank, columns);
        assert!((found.ln_determinant - normal.determinant().ln()).abs() < 1e-8);
    }

    #[test]
    fn a_column_without_data_is_left_out() {
        let mut gram = BandedGram::new(3, 1);
        for i in 0..5 {
            gram.add(0, &[1.0, f64::from(i)], &[2.0]);
        }
        let found = gram.project();
        assert_eq!(found.rank, 2);
        assert!((found.coefficients()[0] - 2.0).abs() < 1e-12);
        assert_eq!(found.coefficients()[2], 0.0);
    }
}
