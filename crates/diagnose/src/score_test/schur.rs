//! Linear algebra of score tests: nuisance parameters projected out of the tested columns.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

use crate::context::{Partition, select, select_vector};

/// Eigenvalues of a matrix with unit diagonal below this are taken for 0.
const MIN_EIGENVALUE: f64 = 1e-12;

/// Pseudo-inverse of a symmetric positive semidefinite matrix, scaled to unit diagonal; none if the eigenvalue
/// iteration fails.
pub(crate) fn pseudo_inverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let scale = matrix.diagonal().map(inverse_sqrt);
    let size = matrix.nrows();
    if size == 0 {
        return Some(DMatrix::zeros(0, 0));
    }
    let scaled = DMatrix::from_fn(size, size, |i, j| matrix[(i, j)] * scale[i] * scale[j]);
    let eigen = SymmetricEigen::try_new(scaled, 1e-14, 10_000)?;
    let mut weighted = eigen.eigenvectors.clone();
    for (mut column, value) in weighted.column_iter_mut().zip(eigen.eigenvalues.iter()) {
        column *= if *value > MIN_EIGENVALUE {
            1.0 / value
        } else {
            0.0
        };
    }
    let inverse = weighted * eigen.eigenvectors.transpose();
    Some(DMatrix::from_fn(size, size, |i, j| {
        inverse[(i, j)] * scale[i] * scale[j]
    }))
}

/// 1/√value; 1 where the value is 0.
pub(super) fn inverse_sqrt(value: f64) -> f64 {
    let root = value.max(0.0).sqrt();
    if root > 1e-150 { 1.0 / root } else { 1.0 }
}

/// Score and information of the tested columns, the nuisance parameters being estimated.
#[derive(Clone, Debug)]
pub(super) struct EffectiveScore {
    /// Information of the tested columns: the Schur complement H_tt − H_tn H_nn⁻¹ H_nt, each column scaled.
    pub information: DMatrix<f64>,
    /// Effective score −(g_t − H_tn H_nn⁻¹ g_n), each entry scaled.
    pub score: DVector<f64>,
    /// Projection coefficients H_nn⁻¹ H_nt: nuisance rows, tested columns.
    pub nuisance_projection: DMatrix<f64>,
    /// Step −H_nn⁻¹ g_n of the nuisance parameters alone.
    pub nuisance_step: DVector<f64>,
}

impl EffectiveScore {
    /// From the Hessian `h` and the gradient `g` of half the sum of squares; tested columns are multiplied by `scale`.
    /// None if the information of the nuisance parameters cannot be inverted.
    pub fn new(
        (h, g): (&DMatrix<f64>, &DVector<f64>),
        partition: &Partition,
        scale: &[f64],
    ) -> Option<Self> {
        let (nuisance, tested) = (&partition.nuisance, &partition.tested);
        let scale = DVector::from_column_slice(scale);
        let mut cross = select(h, nuisance, tested);
        let mut information = select(h, tested, tested);
        for (j, &factor) in scale.iter().enumerate() {
            cross.column_mut(j).scale_mut(factor);
        }
        let size = tested.len();
        information =
            DMatrix::from_fn(size, size, |i, j| information[(i, j)] * scale[i] * scale[j]);
        let nuisance_gradient = select_vector(g, nuisance);
        let gradient = select_vector(g, tested).component_mul(&scale);
        let inverse = pseudo_inverse(&select(h, nuisance, nuisance))?;
        let nuisance_step = -(&inverse * &nuisance_gradient);
        let nuisance_projection = inverse * &cross;
        let information = &information - cross.tr_mul(&nuisance_projection);
        let score = -(&gradient - nuisance_projection.tr_mul(&nuisance_gradient));
        Some(Self {
            information: (&information + information.transpose()) * 0.5,
            score,
            nuisance_projection,
            nuisance_step,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::context::ColumnId;

    /// JᵀJ and Jᵀr of fixed rows with columns of very different size.
    fn equations() -> (DMatrix<f64>, DVector<f64>) {
        let size = [1.0, 1e-5, 1e3, 2.0];
        let jacobian = DMatrix::from_fn(9, 4, |i, j| {
            size[j] * ((3 * i * i + 7 * i * j + j) as f64 * 1.3).sin()
        });
        let residuals = DVector::from_fn(9, |i, _| (i as f64 * 0.7).cos());
        (jacobian.tr_mul(&jacobian), jacobian.tr_mul(&residuals))
    }

    #[test]
    fn the_effective_score_is_that_of_the_schur_complement() {
        let (h, g) = equations();
        let partition = Partition::new(vec![ColumnId::new(1), ColumnId::new(3)], 4);
        let scale = [0.5, 1e-3];
        let found = EffectiveScore::new((&h, &g), &partition, &scale).unwrap();
        // The inverse of the information is the block of the whole inverse.
        let whole = h.clone().try_inverse().unwrap();
        let information = found.information.clone().try_inverse().unwrap();
        for (i, a) in [0, 2].into_iter().enumerate() {
            for (j, b) in [0, 2].into_iter().enumerate() {
                let expected = whole[(a, b)] / (scale[i] * scale[j]);
                assert!((information[(i, j)] / expected - 1.0).abs() < 1e-6);
            }
        }
        // So the one-step estimate is that of the whole Newton step.
        let newton = -(&whole * &g);
        let step = information * &found.score;
        for (i, a) in [0, 2].into_iter().enumerate() {
            assert!((step[i] * scale[i] / newton[a] - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn a_direction_without_information_is_left_out_of_the_inverse() {
        let matrix = DMatrix::from_row_slice(3, 3, &[4.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
        let inverse = pseudo_inverse(&matrix).unwrap();
        assert!((&matrix * &inverse * &matrix - &matrix).norm() < 1e-12);
        assert_eq!(
            pseudo_inverse(&DMatrix::zeros(0, 0)),
            Some(DMatrix::zeros(0, 0))
        );
    }
}
