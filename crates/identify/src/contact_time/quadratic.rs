//! A sum of squared linear residuals as a quadratic function of the unknowns.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Relative increase of the diagonal of the normal matrix, so that it is invertible if the samples do not determine all
/// unknowns.
const RIDGE: f64 = 1e-9;

/// A sum of squared residuals that are linear functions of the unknowns.
#[derive(Clone, Debug)]
pub struct Quadratic {
    /// Normal matrix JᵀJ, where J is the Jacobian of the residuals with respect to the unknowns.
    pub normal: DMatrix<f64>,
    /// Right-hand side Jᵀr, where r are the residuals if all unknowns are 0, and J is their Jacobian.
    pub right: DVector<f64>,
}

impl Quadratic {
    /// Creates a sum of squares that is identically 0, as a function of `unknowns` unknowns.
    pub fn zeros(unknowns: usize) -> Self {
        Self {
            normal: DMatrix::zeros(unknowns, unknowns),
            right: DVector::zeros(unknowns),
        }
    }

    /// Adds the square of a residual that is linear in the unknowns: `residual` is its value if all unknowns are 0, and
    /// `derivatives` are its derivatives with respect to them.
    pub fn add(&mut self, derivatives: &DVector<f64>, residual: f64) {
        self.normal.ger(1.0, derivatives, derivatives, 1.0);
        self.right.axpy(residual, derivatives, 1.0);
    }

    /// Adds `other`, a sum of squares as a function of the same unknowns.
    pub fn add_all(&mut self, other: &Self) {
        self.normal += &other.normal;
        self.right += &other.right;
    }

    /// Factorises the normal equations, which gives the minimum of the sum of squares; `None` if they are singular.
    pub fn minimum(&self) -> Option<Minimum> {
        let diagonal = |index| self.normal[(index, index)];
        Minimum::new(self.normal.clone(), diagonal, &self.right)
    }
}

/// Factorised normal equations of a sum of squares, from which the minimum of the sum is computed.
#[derive(Clone, Debug)]
pub struct Minimum {
    factor: Cholesky<f64, Dyn>,
    /// L⁻¹ Jᵀr, where L is the Cholesky factor of the normal matrix JᵀJ. The squared norm of this vector is the
    /// decrease of the sum of squares from its value for unknowns equal to 0 to its minimum.
    pub reduced: DVector<f64>,
}

impl Minimum {
    /// Factorises the normal matrix `normal`, and solves for the right-hand side `right`. The diagonal entry `i` of the
    /// matrix is first increased by `RIDGE` × `diagonal(i)`, or by 1 if `diagonal(i)` is 0. `None` if the matrix is
    /// singular.
    pub fn new(
        mut normal: DMatrix<f64>,
        diagonal: impl Fn(usize) -> f64,
        right: &DVector<f64>,
    ) -> Option<Self> {
        for index in 0..right.len() {
            let entry = diagonal(index);
            // An unknown on which nothing depends stays 0.
            normal[(index, index)] += if entry == 0.0 { 1.0 } else { RIDGE * entry };
        }
        let factor = Cholesky::new(normal)?;
        let mut reduced = right.clone();
        let is_regular = factor.l_dirty().solve_lower_triangular_mut(&mut reduced);
        is_regular.then_some(Self { factor, reduced })
    }

    /// Values of the unknowns at the minimum of the sum of squares.
    pub fn unknowns(&self) -> DVector<f64> {
        let mut unknowns = -&self.reduced;
        let lower = self.factor.l_dirty();
        lower.ad_solve_lower_triangular_mut(&mut unknowns);
        unknowns
    }

    /// Minimises a sum of squares over the unknowns of `self` (Schur complement). The sum also depends on other
    /// unknowns: `others` contains the terms that depend on the other unknowns alone, and `cross` is the block of the
    /// normal matrix that couples the unknowns of `self` (rows) with the other unknowns (columns). Returns the minimum
    /// as a function of the other unknowns.
    pub fn eliminated(&self, cross: &DMatrix<f64>, others: &Quadratic) -> Quadratic {
        let mut solved = cross.clone();
        let lower = self.factor.l_dirty();
        lower.solve_lower_triangular_mut(&mut solved);
        let mut rest = others.clone();
        rest.normal.gemm_tr(-1.0, &solved, &solved, 1.0);
        rest.right.gemv_tr(-1.0, &solved, &self.reduced, 1.0);
        rest
    }
}
