//! Partition of the columns of the normal equations, and blocks of matrices by index.

use model_spec::index::Idx;
use nalgebra::{DMatrix, DVector};

use super::ids::ColumnId;

/// Partition of the global columns under a null hypothesis. Unknowns that are neither nuisance nor tested are fixed and
/// have no column.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Partition {
    /// Columns whose unknowns are estimated under the null hypothesis.
    pub nuisance: Vec<ColumnId>,
    /// Columns whose unknowns are fixed at their null value and tested, in order.
    pub tested: Vec<ColumnId>,
}

impl Partition {
    /// Partition in which all of the first `columns` columns that are not nuisance columns are tested.
    pub fn new(nuisance: Vec<ColumnId>, columns: usize) -> Self {
        let all = (0..columns).map(ColumnId::new);
        Self {
            tested: all.filter(|column| !nuisance.contains(column)).collect(),
            nuisance,
        }
    }
}

/// Submatrix with these rows and columns.
pub(crate) fn select<R: Idx, C: Idx>(
    matrix: &DMatrix<f64>,
    rows: &[R],
    columns: &[C],
) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
        matrix[(rows[i].index(), columns[j].index())]
    })
}

/// Subvector with these entries.
pub(crate) fn select_vector<I: Idx>(vector: &DVector<f64>, rows: &[I]) -> DVector<f64> {
    DVector::from_fn(rows.len(), |i, _| vector[rows[i].index()])
}

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
