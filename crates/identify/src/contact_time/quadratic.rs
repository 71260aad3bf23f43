//! A sum of squared linear residuals as a quadratic function of the unknowns.

use nalgebra::{DMatrix, DVector};

/// Relative increase of the diagonal of the normal matrix, so that it is invertible if the samples do not determine all
/// unknowns.
const RIDGE: f64 = 1e-9;

/// A sum of squared residuals that are linear in the unknowns.
#[derive(Clone, Debug)]
pub struct Quadratic {
    /// Normal matrix JᵀJ; only its lower triangle is used.
    normal: DMatrix<f64>,
    right: DVector<f64>,
    constant: f64,
}

impl Quadratic {
    /// Creates a sum of squares without terms, for a number of unknowns.
    pub fn zeros(unknowns: usize) -> Self {
        Self {
            normal: DMatrix::zeros(unknowns, unknowns),
            right: DVector::zeros(unknowns),
            constant: 0.0,
        }
    }

    /// Adds the square of a residual, given with its derivatives with respect to the unknowns.
    pub fn add(&mut self, derivatives: &DVector<f64>, residual: f64) {
        self.normal.syger(1.0, derivatives, derivatives, 1.0);
        self.right.axpy(residual, derivatives, 1.0);
        self.constant += residual * residual;
    }

    /// Copy of the sum of squares with `further` unknowns appended, on which the sum does not depend.
    pub fn extended(&self, further: usize) -> Self {
        let few = self.right.len();
        let mut extended = Self::zeros(few + further);
        let mut normal = extended.normal.view_mut((0, 0), (few, few));
        normal.copy_from(&self.normal);
        extended.right.rows_mut(0, few).copy_from(&self.right);
        extended.constant = self.constant;
        extended
    }

    /// Copy of the sum of squares with the additional term |`rows` · u|². The vector u contains the last unknowns, one
    /// for each column of `rows`. `None` if `rows` has more columns than there are unknowns.
    pub fn with_last(&self, rows: &DMatrix<f64>) -> Option<Self> {
        let count = rows.ncols();
        let first = self.right.len().checked_sub(count)?;
        let mut held = self.clone();
        let mut normal = held.normal.view_mut((first, first), (count, count));
        normal += rows.tr_mul(rows);
        Some(held)
    }

    /// Minimum of the sum of squares, and the unknowns at the minimum; `None` if the normal equations are singular.
    pub fn least(&self) -> Option<(f64, DVector<f64>)> {
        let diagonal = self.normal.diagonal();
        let scale = diagonal.map(|entry| entry.max(f64::MIN_POSITIVE).sqrt().recip());
        let mut scaled = self.normal.clone();
        for (mut column, by) in scaled.column_iter_mut().zip(&scale) {
            column.component_mul_assign(&scale);
            column *= *by;
        }
        for index in 0..scale.len() {
            scaled[(index, index)] += RIDGE;
        }
        let right = self.right.component_mul(&scale);
        let solution = scaled.cholesky()?.solve(&right);
        let least = self.constant - right.dot(&solution);
        Some((least, -solution.component_mul(&scale)))
    }
}
