//! Separation of hypotheses by the information in the flights.

use identify::{NormalBlock, eliminate, pseudo_inverse};
use nalgebra::{DMatrix, DVector};

use crate::context::{ColumnId, ScoreTestModel, select};
use crate::selection::Hypothesis;

/// Damping added to JᵀJ, the normal matrix of a flight's local parameters, when these parameters are eliminated;
/// relative to the diagonal of JᵀJ.
const DAMPING: f64 = 1e-12;

/// Information matrix of the global unknowns (parameters and library-term coefficients) from the given normal
/// equations, with the local parameters (initial states) eliminated; `None` if a flight does not determine its local
/// parameters.
pub(super) fn information(
    model: &ScoreTestModel<'_>,
    blocks: &[NormalBlock],
) -> Option<DMatrix<f64>> {
    let size = model.global_columns();
    let mut sum = DMatrix::zeros(size, size);
    for block in blocks {
        let system = eliminate(std::slice::from_ref(block), DAMPING).ok()?;
        sum += system.reduced.view((0, 0), (size, size));
    }
    Some(sum)
}

/// Differences of the fitted coefficients of a hypothesis from their null values.
pub(super) struct Alternative {
    columns: Vec<ColumnId>,
    /// For each column of the normal equations in `columns`: fitted value minus null value, SI, of the coefficient to
    /// which the column belongs.
    largest_misfits: Vec<f64>,
}

impl Alternative {
    /// Computes the fitted minus the null value of every coefficient of the hypothesis.
    pub fn new(model: &ScoreTestModel<'_>, hypothesis: &Hypothesis) -> Self {
        let effects = hypothesis.effects.iter();
        let columns: Vec<ColumnId> = effects
            .flat_map(|&e| model.columns_of(e))
            .copied()
            .collect();
        let departure = |column: &ColumnId| {
            let null_value = model.problem.globals[column.index()].model_value;
            hypothesis.iterate.global[column.index()] - null_value
        };
        Self {
            largest_misfits: columns.iter().map(departure).collect(),
            columns,
        }
    }
}

/// Smallest separation among all ordered pairs of hypotheses, in standard deviations. The first hypothesis of a pair is
/// assumed true. The second hypothesis, together with the parameters of the columns `nuisance`, is fitted to the
/// predictions of the first; the separation is the square root of the remaining χ². Returns 0 if no hypothesis has a
/// column that another lacks.
pub(super) fn separation(
    nuisance: &[ColumnId],
    hypotheses: &[Alternative],
    information: &DMatrix<f64>,
) -> f64 {
    let mut least = f64::INFINITY;
    for truth in hypotheses {
        for other in hypotheses {
            let own = truth.columns.iter().zip(&truth.largest_misfits);
            let own = own.filter(|(column, _)| !other.columns.contains(column));
            let (own, largest_misfits): (Vec<ColumnId>, Vec<f64>) = own.unzip();
            if own.is_empty() {
                continue;
            }
            let free: Vec<ColumnId> = nuisance.iter().chain(&other.columns).copied().collect();
            let Some(inverse) = pseudo_inverse(&select(information, &free, &free)) else {
                continue;
            };
            let cross = select(information, &free, &own);
            let effective = select(information, &own, &own) - cross.tr_mul(&(inverse * &cross));
            let largest_misfits = DVector::from_vec(largest_misfits);
            let chi2 = largest_misfits
                .dot(&(effective * &largest_misfits))
                .max(0.0);
            least = least.min(chi2.sqrt());
        }
    }
    if least.is_finite() { least } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hypotheses_are_as_far_apart_as_their_columns_are_independent() {
        let alternative = |column: usize| Alternative {
            columns: vec![ColumnId::new(column)],
            largest_misfits: vec![2.0],
        };
        let both = [alternative(0), alternative(1)];
        // Orthogonal columns: the other hypothesis explains nothing.
        let found = separation(&[], &both, &(DMatrix::identity(2, 2) * 9.0));
        assert!((found - 6.0).abs() < 1e-9, "{found}");
        // Correlation 0.8: 1 − R² = 0.36.
        let correlated = DMatrix::from_row_slice(2, 2, &[9.0, 7.2, 7.2, 9.0]);
        let found = separation(&[], &both, &correlated);
        assert!((found - 6.0 * 0.6).abs() < 1e-9, "{found}");
        assert_eq!(separation(&[], &both[..1], &correlated), 0.0);
    }
}
