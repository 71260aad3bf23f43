//! The linear algebra of scores: the base taken out of the candidates' columns.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// The inverse of a symmetric matrix, its diagonal scaled to 1; directions that carry nothing are left out.
pub fn inverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let scale = matrix.diagonal().map(inverse_root);
    let size = matrix.nrows();
    if size == 0 {
        return Some(DMatrix::zeros(0, 0));
    }
    let scaled = DMatrix::from_fn(size, size, |i, j| matrix[(i, j)] * scale[i] * scale[j]);
    let eigen = SymmetricEigen::try_new(scaled, 1e-14, 10_000)?;
    let mut weighed = eigen.eigenvectors.clone();
    for (mut column, value) in weighed.column_iter_mut().zip(eigen.eigenvalues.iter()) {
        column *= if *value > 1e-12 { 1.0 / value } else { 0.0 };
    }
    let inverse = weighed * eigen.eigenvectors.transpose();
    Some(DMatrix::from_fn(size, size, |i, j| {
        inverse[(i, j)] * scale[i] * scale[j]
    }))
}

/// One over the root of a diagonal entry; 1 where there is nothing.
pub(super) fn inverse_root(value: f64) -> f64 {
    let root = value.max(0.0).sqrt();
    if root > 1e-150 { 1.0 / root } else { 1.0 }
}

/// The columns without the base.
pub(super) struct Eliminated {
    pub information: DMatrix<f64>,
    pub score: DVector<f64>,
    /// How the columns lean on the base's unknowns.
    pub leaning: DMatrix<f64>,
    /// The base's own step.
    pub base_step: DVector<f64>,
}

/// The base and the columns of the candidates, the latter scaled.
pub(super) struct Parts {
    base: DMatrix<f64>,
    cross: DMatrix<f64>,
    columns: DMatrix<f64>,
    base_gradient: DVector<f64>,
    gradient: DVector<f64>,
}

impl Parts {
    pub fn new(
        h: &DMatrix<f64>,
        g: &DVector<f64>,
        free: &[usize],
        columns: &[usize],
        scale: &[f64],
    ) -> Self {
        let (b, c) = (free.len(), columns.len());
        Self {
            base: DMatrix::from_fn(b, b, |i, j| h[(free[i], free[j])]),
            cross: DMatrix::from_fn(b, c, |i, j| h[(free[i], columns[j])] * scale[j]),
            columns: DMatrix::from_fn(c, c, |i, j| {
                h[(columns[i], columns[j])] * scale[i] * scale[j]
            }),
            base_gradient: DVector::from_fn(b, |i, _| g[free[i]]),
            gradient: DVector::from_fn(c, |i, _| g[columns[i]] * scale[i]),
        }
    }

    /// Takes the base out.
    pub fn eliminated(self) -> Result<Eliminated, String> {
        let inverse = inverse(&self.base).ok_or("the base's unknowns are not determined")?;
        let base_step = -(&inverse * &self.base_gradient);
        let leaning = inverse * &self.cross;
        let information = &self.columns - self.cross.tr_mul(&leaning);
        let score = -(&self.gradient - leaning.tr_mul(&self.base_gradient));
        let information = (&information + information.transpose()) * 0.5;
        Ok(Eliminated {
            information,
            score,
            leaning,
            base_step,
        })
    }
}
