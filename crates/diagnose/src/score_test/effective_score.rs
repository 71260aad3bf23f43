//! Linear algebra of score tests: projection of the nuisance parameters out of the tested columns.

use identify::pseudo_inverse;
use nalgebra::{DMatrix, DVector};

use crate::context::{Partition, select, select_vector};

/// Returns 1/√value, or 1 if the value is below about 1e-300, negative or not a number.
pub(super) fn inverse_sqrt(value: f64) -> f64 {
    let root = value.max(0.0).sqrt();
    if root > 1e-150 { 1.0 / root } else { 1.0 }
}

/// Score and information of the tested unknowns after the nuisance parameters are projected out.
#[derive(Clone, Debug)]
pub(super) struct EffectiveScore {
    /// Effective information: the Schur complement H_tt − H_tn H_nn⁻¹ H_nt, scaled on both sides. H is the Hessian of
    /// half the sum of squares; `t` denotes tested unknowns, `n` nuisance parameters.
    pub information: DMatrix<f64>,
    /// Effective score −(g_t − H_tn H_nn⁻¹ g_n), scaled.
    pub score: DVector<f64>,
    /// Projection coefficients H_nn⁻¹ H_nt, with scaled columns.
    pub nuisance_projection: DMatrix<f64>,
    /// Step −H_nn⁻¹ g_n of the nuisance parameters with the tested ones fixed.
    pub nuisance_step: DVector<f64>,
}

impl EffectiveScore {
    /// Effective score from Hessian `h` and gradient `g`; rows and columns of tested unknowns are multiplied by
    /// `scale`. `None` if the nuisance information cannot be inverted.
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

    /// JᵀJ and Jᵀr of a fixed example in which the columns of J differ in size by eight orders of magnitude.
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
        // The inverse of the effective information is the tested block of the full inverse.
        let whole = h.clone().try_inverse().unwrap();
        let information = found.information.clone().try_inverse().unwrap();
        for (i, a) in [0, 2].into_iter().enumerate() {
            for (j, b) in [0, 2].into_iter().enumerate() {
                let expected = whole[(a, b)] / (scale[i] * scale[j]);
                assert!((information[(i, j)] / expected - 1.0).abs() < 1e-6);
            }
        }
        // The one-step estimate therefore equals the tested part of the full Newton step.
        let newton = -(&whole * &g);
        let step = information * &found.score;
        for (i, a) in [0, 2].into_iter().enumerate() {
            assert!((step[i] * scale[i] / newton[a] - 1.0).abs() < 1e-6);
        }
    }
}
