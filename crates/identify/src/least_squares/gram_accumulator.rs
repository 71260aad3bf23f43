//! Gram matrix of Jacobian rows, accumulated with SIMD lanes.

use lanes::{Kernel, Lanes};
use nalgebra::{DMatrix, DVector};

use crate::least_squares::NormalBlock;

/// Number of Jacobian rows that are summed in one batch; few enough to stay in the first-level cache.
const BATCH: usize = 64;

/// Jacobian rows are padded to a multiple of this length, the number of lanes of the widest SIMD vectors.
pub const LANES: usize = 8;

/// Accumulates the Gram matrix of the Jacobian rows of one flight: derivatives by the local and global parameters, the
/// residual, and zeros as padding.
pub struct GramAccumulator {
    /// Columns of the Jacobian rows that contain the derivatives with respect to the local parameters.
    local: Vec<usize>,
    /// Columns of the Jacobian rows that contain the derivatives with respect to the global parameters.
    global: Vec<usize>,
    width: usize,
    /// Jacobian rows that are not summed yet, concatenated.
    batch: Vec<f64>,
    filled: usize,
    sums: Vec<f64>,
    /// Sum of the terms that robust losses add to the sum of the squared weighted residuals.
    extra: f64,
    count: usize,
}

impl GramAccumulator {
    /// Creates an accumulator; `local` and `global` are the columns of the parameters, together 0, 1, 2, ….
    pub fn new(local: Vec<usize>, global: Vec<usize>) -> Self {
        let unknowns = local.len() + global.len();
        let width = Self::width(unknowns);
        let summed = (unknowns + 1).next_multiple_of(TILE.0);
        Self {
            local,
            global,
            width,
            batch: vec![0.0; BATCH * width],
            filled: 0,
            sums: vec![0.0; width * summed],
            extra: 0.0,
            count: 0,
        }
    }

    /// Length of a padded Jacobian row with `columns` derivatives.
    pub fn width(columns: usize) -> usize {
        (columns + 1).next_multiple_of(LANES)
    }

    /// Column index of the residual in a Jacobian row.
    pub fn residual(&self) -> usize {
        self.local.len() + self.global.len()
    }

    /// Adds `scale * (row − phi * previous)`, where `before` is (phi, previous) or `None`, and `extra`, a term of a
    /// robust loss. Returns the row that was added.
    pub fn add(
        &mut self,
        row: &[f64],
        before: Option<(f64, &[f64])>,
        scale: f64,
        extra: f64,
    ) -> &[f64] {
        let place = self.filled;
        let to = &mut self.batch[self.filled..][..self.width];
        let row = &row[..self.width];
        let (kept, before) = before.unwrap_or((0.0, row));
        lanes::dispatch(AddInnovation {
            to,
            row,
            kept,
            before,
            scale,
        });
        self.filled += self.width;
        self.extra += extra;
        self.count += 1;
        if self.filled == self.batch.len() {
            self.sum();
        }
        &self.batch[place..][..self.width]
    }

    fn sum(&mut self) {
        lanes::dispatch(AddSquares {
            rows: &self.batch[..self.filled],
            width: self.width,
            sums: &mut self.sums,
        });
        self.filled = 0;
    }

    /// Returns the normal equations summed over all Jacobian rows.
    pub fn block(mut self) -> NormalBlock {
        self.sum();
        let (local, global, last) = (&self.local, &self.global, self.residual());
        let at =
            |row: usize, column: usize| self.sums[row.min(column) * self.width + row.max(column)];
        NormalBlock {
            local: DMatrix::from_fn(local.len(), local.len(), |i, j| at(local[i], local[j])),
            cross: DMatrix::from_fn(local.len(), global.len(), |i, j| at(local[i], global[j])),
            global: DMatrix::from_fn(global.len(), global.len(), |i, j| at(global[i], global[j])),
            local_gradient: DVector::from_fn(local.len(), |i, _| at(local[i], last)),
            global_gradient: DVector::from_fn(global.len(), |i, _| at(global[i], last)),
            squares: at(last, last) + self.extra,
            count: self.count,
        }
    }
}

/// SIMD kernel: `to = scale * (row − kept * before)`.
struct AddInnovation<'a> {
    to: &'a mut [f64],
    row: &'a [f64],
    kept: f64,
    before: &'a [f64],
    scale: f64,
}

impl Kernel for AddInnovation<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let (kept, scale) = (T::splat(self.kept), T::splat(self.scale));
        let from = self.row.chunks_exact(T::WIDTH);
        let from = from.zip(self.before.chunks_exact(T::WIDTH));
        for (to, (row, before)) in self.to.chunks_exact_mut(T::WIDTH).zip(from) {
            (scale * (T::load(row) - kept * T::load(before))).store(to);
        }
    }
}

/// SIMD kernel that adds the rows of the upper triangle of `rowsᵀ rows` that `sums` has, and some unused entries below it.
struct AddSquares<'a> {
    rows: &'a [f64],
    width: usize,
    sums: &'a mut [f64],
}

/// Rows and SIMD vectors of a tile whose sums are computed at once, so that loaded values are reused.
const TILE: (usize, usize) = (4, 3);

impl Kernel for AddSquares<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        const { assert!(LANES.is_multiple_of(T::WIDTH)) };
        let AddSquares { rows, width, sums } = self;
        for first in (0..sums.len() / width).step_by(TILE.0) {
            // The first vector is the one that contains the diagonal element.
            let mut column = first / T::WIDTH * T::WIDTH;
            while column < width {
                column += match (width - column) / T::WIDTH {
                    1 => add_block::<T, 1>(rows, width, sums, (first, column)),
                    2 => add_block::<T, 2>(rows, width, sums, (first, column)),
                    _ => add_block::<T, { TILE.1 }>(rows, width, sums, (first, column)),
                };
            }
        }
    }
}

/// Adds the rows' products to a tile of `sums`, `VECTORS` vectors wide. Returns the number of its columns.
#[inline(always)]
fn add_block<T: Lanes, const VECTORS: usize>(
    rows: &[f64],
    width: usize,
    sums: &mut [f64],
    (first, column): (usize, usize),
) -> usize {
    let columns = VECTORS * T::WIDTH;
    let mut block = [[T::splat(0.0); VECTORS]; TILE.0];
    for row in rows.chunks_exact(width) {
        let (left, right) = (&row[first..][..TILE.0], &row[column..][..columns]);
        for k in 0..TILE.0 {
            let left = T::splat(left[k]);
            for v in 0..VECTORS {
                block[k][v] = left.mul_add(T::load(&right[v * T::WIDTH..]), block[k][v]);
            }
        }
    }
    for k in 0..TILE.0 {
        let places = &mut sums[(first + k) * width + column..][..columns];
        for v in 0..VECTORS {
            let place = &mut places[v * T::WIDTH..];
            (T::load(place) + block[k][v]).store(place);
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_plain_loops() {
        let (local, global) = (5, 4);
        // The global parameters come first.
        let mut rows = GramAccumulator::new((4..9).collect(), (0..4).collect());
        let mut plain = NormalBlock::zero(local, global);
        for k in 0..150 {
            let value = |i: usize| ((k * 31 + i * 17) as f64 * 0.37).sin();
            let mut row = vec![0.0; rows.width];
            for (i, place) in row[..=(local + global)].iter_mut().enumerate() {
                *place = value(i);
            }
            rows.add(&row, None, 2.0, 0.25);
            plain.add(
                2.0 * value(local + global),
                &DVector::from_fn(local, |i, _| 2.0 * value(4 + i)),
                &DVector::from_fn(global, |i, _| 2.0 * value(i)),
            );
        }
        let block = rows.block();
        assert!((&block.local - &plain.local).amax() < 1e-11);
        assert!((&block.cross - &plain.cross).amax() < 1e-11);
        assert!((&block.global - &plain.global).amax() < 1e-11);
        assert!((&block.local_gradient - &plain.local_gradient).amax() < 1e-11);
        assert!((&block.global_gradient - &plain.global_gradient).amax() < 1e-11);
        assert!((block.squares - plain.squares - 150.0 * 0.25).abs() < 1e-10);
    }

    #[test]
    fn a_row_less_a_part_of_the_one_before() {
        let mut rows = GramAccumulator::new(vec![0], Vec::new());
        let width = rows.width;
        let row = |a: f64, r: f64| {
            let mut row = vec![0.0; width];
            (row[0], row[1]) = (a, r);
            row
        };
        rows.add(&row(3.0, 5.0), Some((0.5, &row(2.0, 4.0))), 10.0, 0.0);
        let block = rows.block();
        assert_eq!(block.local[(0, 0)], 400.0);
        assert_eq!(block.local_gradient[0], 600.0);
        assert_eq!(block.squares, 900.0);
    }
}
