//! Product J S of a sparse Jacobian with the dense, row-major sensitivity matrix.

use super::PADDING;
use lanes::{Kernel, Lanes};
use std::ops::Range;

/// Maximum number of rows in a block, that is a set of rows of the Jacobian J with equal column indices. It is small
/// enough that the sums of all rows of a block stay in registers.
const MAX_BLOCK_ROWS: usize = 3;

/// Sparsity pattern of the Jacobian J, grouped into blocks of rows with equal column indices, for the product J S with
/// the sensitivity matrix S.
///
/// Each row of S is divided into lines of `PADDING` elements, and `lines_per_group` consecutive lines form a group. The
/// sums of one group of a row of J S are accumulated together.
pub(super) struct JacobianProduct {
    /// Blocks of Jacobian rows with equal column indices, in increasing order of column count, so that the branch
    /// predictor learns the loop lengths.
    blocks: Vec<Block>,
    /// Column indices of all blocks, concatenated. Column j multiplies row j of the sensitivity matrix S. It is stored
    /// as `j * groups_per_row`, the index of the first [`Group`] (array of consecutive elements) of that row.
    columns: Vec<usize>,
    /// Number of lines (`PADDING` consecutive elements of a row of the sensitivity matrix S) in a group; the sums of
    /// one group of a row of J S are accumulated together.
    lines_per_group: usize,
    /// Number of groups in each row of the sensitivity matrix S; a group has `lines_per_group` lines of `PADDING`
    /// elements.
    groups_per_row: usize,
}

/// Rows of the Jacobian J with equal column indices. Each row of the sensitivity matrix S is read once for all rows of
/// the block.
struct Block {
    count: usize,
    /// For each row of the block, the index of the first [`Group`] (array of consecutive elements) of the corresponding
    /// row of the product J S.
    rows: [usize; MAX_BLOCK_ROWS],
    /// For each row of the block, the index of the row's first entry among the entries of the Jacobian J; the other
    /// entries of the row follow directly.
    entries: [usize; MAX_BLOCK_ROWS],
    /// Range of the elements of `JacobianProduct::columns` that belong to the block.
    columns: Range<usize>,
}

impl JacobianProduct {
    /// Combines rows of the Jacobian J with equal column indices into blocks. `pattern` is the sparsity pattern of J in
    /// row order, `states` the number of rows of J, and `stride` the length of a row of the sensitivity matrix S in
    /// elements, a multiple of `PADDING`.
    pub fn new(pattern: &[(usize, usize)], states: usize, stride: usize) -> Self {
        let lines_per_row = stride / PADDING;
        let lines = [4, 3, 2]
            .into_iter()
            .find(|n| lines_per_row.is_multiple_of(*n));
        let lines_per_group = lines.unwrap_or(1);
        let groups_per_row = lines_per_row / lines_per_group;
        let mut blocks: Vec<Block> = Vec::with_capacity(states);
        let mut columns = Vec::with_capacity(pattern.len());
        for row in 0..states {
            let first = pattern.partition_point(|(at, _)| *at < row);
            let row_columns = pattern[first..].iter().take_while(|(at, _)| *at == row);
            let row_columns = row_columns.map(|(_, column)| column * groups_per_row);
            let has_same_columns = |block: &&mut Block| {
                let others: &[usize] = &columns[block.columns.clone()];
                block.count < MAX_BLOCK_ROWS && others.iter().copied().eq(row_columns.clone())
            };
            if let Some(block) = blocks.iter_mut().find(has_same_columns) {
                block.rows[block.count] = row * groups_per_row;
                block.entries[block.count] = first;
                block.count += 1;
            } else {
                let begin = columns.len();
                columns.extend(row_columns);
                blocks.push(Block {
                    count: 1,
                    rows: [row * groups_per_row; MAX_BLOCK_ROWS],
                    entries: [first; MAX_BLOCK_ROWS],
                    columns: begin..columns.len(),
                });
            }
        }
        blocks.sort_by_key(|block| block.columns.len());
        JacobianProduct {
            blocks,
            columns,
            lines_per_group,
            groups_per_row,
        }
    }

    /// Computes the product J S of the Jacobian and the sensitivity matrix. `values` contains the entries of J in the
    /// order of its pattern, `s` the elements of S; the result is written to `ds`. Both matrices are stored row by row,
    /// each row padded to the `stride` given to [`new`](Self::new).
    pub fn write(&self, values: &[f64], s: &[f64], ds: &mut [f64]) {
        match self.lines_per_group {
            4 => self.write_in::<4>(values, s, ds),
            3 => self.write_in::<3>(values, s, ds),
            2 => self.write_in::<2>(values, s, ds),
            _ => self.write_in::<1>(values, s, ds),
        }
    }

    fn write_in<const LINES: usize>(&self, values: &[f64], s: &[f64], ds: &mut [f64]) {
        lanes::dispatch(Sums::<LINES> {
            blocks: &self.blocks,
            columns: &self.columns,
            groups_per_row: self.groups_per_row,
            values,
            s: s.as_chunks().0.as_chunks().0,
            ds: ds.as_chunks_mut().0.as_chunks_mut().0,
        });
    }
}

/// Group of consecutive elements of one row of the sensitivity matrix S or of the product J S, as `LINES` lines of
/// `PADDING` elements; the sums of one group of J S are accumulated together.
type Group<const LINES: usize> = [[f64; PADDING]; LINES];

/// SIMD kernel that computes the product J S of the Jacobian and the sensitivity matrix, block by block. `LINES`, the
/// number of lines of `PADDING` elements in a [`Group`], is a const parameter, so that the sums remain in registers.
struct Sums<'a, const LINES: usize> {
    blocks: &'a [Block],
    columns: &'a [usize],
    groups_per_row: usize,
    values: &'a [f64],
    s: &'a [Group<LINES>],
    ds: &'a mut [Group<LINES>],
}

impl<const LINES: usize> Sums<'_, LINES> {
    /// Computes one [`Group`] (array of consecutive elements) in each of the `ROWS` rows of the product J S that belong
    /// to a block, and writes it to `ds`. `group` is the index of the group within a row.
    #[inline(always)]
    fn sum<T: Lanes, const ROWS: usize>(&mut self, block: &Block, group: usize) {
        let columns = &self.columns[block.columns.clone()];
        let values: [&[f64]; ROWS] =
            std::array::from_fn(|row| &self.values[block.entries[row]..][..columns.len()]);
        for part in (0..PADDING).step_by(T::WIDTH) {
            let mut sums = [[T::splat(0.0); LINES]; ROWS];
            // Indexed rather than zipped: the equal lengths are then checked only once.
            for entry in 0..columns.len() {
                let from = &self.s[columns[entry] + group];
                let from: [T; LINES] = std::array::from_fn(|line| T::load(&from[line][part..]));
                for row in 0..ROWS {
                    let value = T::splat(values[row][entry]);
                    for line in 0..LINES {
                        sums[row][line] = value.mul_add(from[line], sums[row][line]);
                    }
                }
            }
            for (row, sums) in block.rows.iter().zip(sums) {
                let to = &mut self.ds[row + group];
                for (to, sum) in to.iter_mut().zip(sums) {
                    sum.store(&mut to[part..]);
                }
            }
        }
    }
}

impl<const LINES: usize> Kernel for Sums<'_, LINES> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(mut self) {
        const { assert!(PADDING.is_multiple_of(T::WIDTH)) };
        for group in 0..self.groups_per_row {
            for block in self.blocks {
                match block.count {
                    1 => self.sum::<T, 1>(block, group),
                    2 => self.sum::<T, 2>(block, group),
                    _ => self.sum::<T, MAX_BLOCK_ROWS>(block, group),
                }
            }
        }
    }
}
