//! Product J S of a sparse Jacobian with the dense, row-major sensitivity matrix.

use lanes::{Kernel, Lanes};
use std::ops::Range;

/// Maximum number of rows in a block, that is a set of rows of the Jacobian J with equal column indices.
const MAX_BLOCK_ROWS: usize = 3;

/// Maximum number of SIMD vectors of a row of J S that are accumulated together.
const MAX_VECTORS: usize = 4;

/// Sparsity pattern of the Jacobian J in blocks of rows with equal columns, for the product J S.
pub(super) struct JacobianProduct {
    /// Blocks in increasing order of column count, so that the branch predictor learns the loop lengths.
    blocks: Vec<Block>,
    /// For each column index of all blocks, the index of the first element of the row of S that it multiplies.
    columns: Vec<usize>,
    /// Length of a row of the sensitivity matrix S in elements, a whole number of SIMD vectors.
    stride: usize,
}

/// Rows of the Jacobian J with equal column indices.
struct Block {
    count: usize,
    /// For each row of the block, the index of the first element of the corresponding row of the product J S.
    rows: [usize; MAX_BLOCK_ROWS],
    /// For each row of the block, the index of its first entry in J; its other entries follow directly.
    entries: [usize; MAX_BLOCK_ROWS],
    /// Range of the elements of `JacobianProduct::columns` that belong to the block.
    columns: Range<usize>,
}

impl JacobianProduct {
    /// Combines rows of the Jacobian J with equal column indices into blocks. `pattern` is the sparsity pattern of J in
    /// row order, `states` the number of rows of J, and `stride` the length of a row of the sensitivity matrix S in
    /// elements, a whole number of SIMD vectors.
    pub fn new(pattern: &[(usize, usize)], states: usize, stride: usize) -> Self {
        let mut blocks: Vec<Block> = Vec::with_capacity(states);
        let mut columns = Vec::with_capacity(pattern.len());
        for row in 0..states {
            let first = pattern.partition_point(|(at, _)| *at < row);
            let row_columns = pattern[first..].iter().take_while(|(at, _)| *at == row);
            let row_columns = row_columns.map(|(_, column)| column * stride);
            let has_same_columns = |block: &&mut Block| {
                let others: &[usize] = &columns[block.columns.clone()];
                block.count < MAX_BLOCK_ROWS && others.iter().copied().eq(row_columns.clone())
            };
            if let Some(block) = blocks.iter_mut().find(has_same_columns) {
                block.rows[block.count] = row * stride;
                block.entries[block.count] = first;
                block.count += 1;
            } else {
                let begin = columns.len();
                columns.extend(row_columns);
                blocks.push(Block {
                    count: 1,
                    rows: [row * stride; MAX_BLOCK_ROWS],
                    entries: [first; MAX_BLOCK_ROWS],
                    columns: begin..columns.len(),
                });
            }
        }
        blocks.sort_by_key(|block| block.columns.len());
        JacobianProduct {
            blocks,
            columns,
            stride,
        }
    }

    /// Computes the product J S of the Jacobian and the sensitivity matrix. `values` contains the entries of J in the
    /// order of its pattern, `s` the elements of S; the result is written to `ds`. Both matrices are stored row by row,
    /// each row padded to the `stride` given to [`new`](Self::new).
    pub fn write(&self, values: &[f64], s: &[f64], ds: &mut [f64]) {
        lanes::dispatch(Sums {
            product: self,
            values,
            s,
            ds,
        });
    }
}

/// SIMD kernel that computes the product J S of the Jacobian and the sensitivity matrix, block by block.
struct Sums<'a> {
    product: &'a JacobianProduct,
    values: &'a [f64],
    s: &'a [f64],
    ds: &'a mut [f64],
}

impl Sums<'_> {
    /// Computes `VECTORS` consecutive SIMD vectors, from the element `first` on, of all rows of the product J S.
    #[inline(always)]
    fn vectors<T: Lanes, const VECTORS: usize>(&mut self, first: usize) {
        for block in &self.product.blocks {
            match block.count {
                1 => self.sum::<T, VECTORS, 1>(block, first),
                2 => self.sum::<T, VECTORS, 2>(block, first),
                _ => self.sum::<T, VECTORS, MAX_BLOCK_ROWS>(block, first),
            }
        }
    }

    /// Computes `VECTORS` consecutive SIMD vectors from `first` on of the `ROWS` rows of J S of a block.
    // The counts are const parameters, so that the sums remain in registers.
    #[inline(always)]
    fn sum<T: Lanes, const VECTORS: usize, const ROWS: usize>(
        &mut self,
        block: &Block,
        first: usize,
    ) {
        let columns = &self.product.columns[block.columns.clone()];
        let values: [&[f64]; ROWS] =
            std::array::from_fn(|row| &self.values[block.entries[row]..][..columns.len()]);
        let s = &self.s[first..];
        let mut sums = [[T::splat(0.0); VECTORS]; ROWS];
        // Indexed rather than zipped: the equal lengths are then checked only once.
        for entry in 0..columns.len() {
            let from = &s[columns[entry]..][..VECTORS * T::WIDTH];
            let mut loaded = [T::splat(0.0); VECTORS];
            for v in 0..VECTORS {
                loaded[v] = T::load(&from[v * T::WIDTH..]);
            }
            for row in 0..ROWS {
                let value = T::splat(values[row][entry]);
                for v in 0..VECTORS {
                    sums[row][v] = value.mul_add(loaded[v], sums[row][v]);
                }
            }
        }
        for (row, sums) in block.rows.iter().zip(sums) {
            let to = &mut self.ds[row + first..][..VECTORS * T::WIDTH];
            for (to, sum) in to.chunks_exact_mut(T::WIDTH).zip(sums) {
                sum.store(to);
            }
        }
    }
}

impl Kernel for Sums<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(mut self) {
        let vectors = self.product.stride / T::WIDTH;
        // Parts of about equal size.
        let parts = vectors.div_ceil(MAX_VECTORS);
        for part in 0..parts {
            let (first, end) = (part * vectors / parts, (part + 1) * vectors / parts);
            let at = first * T::WIDTH;
            match end - first {
                1 => self.vectors::<T, 1>(at),
                2 => self.vectors::<T, 2>(at),
                3 => self.vectors::<T, 3>(at),
                _ => self.vectors::<T, MAX_VECTORS>(at),
            }
        }
    }
}
