//! Typed indices, the partition of the columns of the normal equations into nuisance and tested ones, and submatrices.

use model_spec::index::Idx;
use model_spec::index_type;
use nalgebra::{DMatrix, DVector};

/// Partition of the columns under a null hypothesis into nuisance and tested ones.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Partition {
    /// Columns of the nuisance parameters: unknowns that are estimated under the null hypothesis.
    pub nuisance: Vec<ColumnId>,
    /// Columns that are fixed at their null value under the null hypothesis, ascending.
    pub tested: Vec<ColumnId>,
}

impl Partition {
    pub fn new(nuisance: Vec<ColumnId>, columns: usize) -> Self {
        let all = (0..columns).map(ColumnId::new);
        Self {
            tested: all.filter(|column| !nuisance.contains(column)).collect(),
            nuisance,
        }
    }
}

/// Submatrix of `matrix` that consists of its rows `rows` and its columns `columns`, in the order of these lists.
pub(crate) fn select<R: Idx, C: Idx>(
    matrix: &DMatrix<f64>,
    rows: &[R],
    columns: &[C],
) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
        matrix[(rows[i].index(), columns[j].index())]
    })
}

/// Subvector of `vector` that consists of its entries with the indices `rows`, in the order of this list.
pub(crate) fn select_vector<I: Idx>(vector: &DVector<f64>, rows: &[I]) -> DVector<f64> {
    DVector::from_fn(rows.len(), |i, _| vector[rows[i].index()])
}

// Typed indices (newtypes) used in a diagnosis.

index_type!(
    /// Index of a candidate effect: an effect that the model may lack.
    pub(crate) struct CandidateId;
);

index_type!(
    /// Index of a library term: a product of variables that is added to one load.
    pub(crate) struct TermId;
);

index_type!(
    /// Index of a global column: the encompassing model's global parameters, then the library terms.
    pub(crate) struct ColumnId;
);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nuisance_and_tested_columns_make_up_all_columns() {
        let nuisance = vec![ColumnId::new(2), ColumnId::new(0)];
        let partition = Partition::new(nuisance, 4);
        assert_eq!(partition.tested, [1, 3].map(ColumnId::new));
        let matrix = DMatrix::from_fn(4, 4, |i, j| (10 * i + j) as f64);
        let block = select(&matrix, &partition.nuisance, &partition.tested);
        assert_eq!(
            block,
            DMatrix::from_row_slice(2, 2, &[21.0, 23.0, 1.0, 3.0])
        );
        let vector = DVector::from_fn(4, |i, _| i as f64);
        assert_eq!(
            select_vector(&vector, &partition.nuisance).as_slice(),
            [2.0, 0.0]
        );
    }
}
