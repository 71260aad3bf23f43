//! A sum of squared linear residuals as a quadratic function of the unknowns.

use lanes::{Kernel, Lanes};

/// Relative increase of the diagonal of the normal matrix, so that it is invertible if the samples do not determine all
/// unknowns.
const RIDGE: f64 = 1e-9;

/// Number of entries in a block of a stored row: some whole SIMD registers. The lengths of rows are multiples of it.
const BLOCK: usize = 8;

/// Dispatches the kernel `$kernel`. Its const parameter is the number of blocks of a row, so that the compiler unrolls
/// the loops over them; it is 0 for rows of more blocks than listed here.
macro_rules! by_blocks {
    ($blocks:expr, $kernel:ident $fields:tt) => {
        by_blocks!(@ $blocks, $kernel $fields, 1 2 3 4 5)
    };
    (@ $blocks:expr, $kernel:ident $fields:tt, $($count:literal)*) => {
        match $blocks {
            $($count => lanes::dispatch($kernel::<$count> $fields),)*
            _ => lanes::dispatch($kernel::<0> $fields),
        }
    };
}

/// Amount by which a diagonal entry of the normal matrix is increased, so that it is invertible.
pub fn ridge(diagonal: f64) -> f64 {
    // An unknown on which nothing depends stays 0.
    if diagonal == 0.0 {
        1.0
    } else {
        RIDGE * diagonal
    }
}

/// A sum of squared residuals that are linear functions of the unknowns.
#[derive(Clone, Debug)]
pub struct Quadratic {
    unknowns: usize,
    /// Normal matrix JᵀJ, row by row, where J is the Jacobian of the residuals with respect to the unknowns. The entry
    /// after the last column of the matrix is that of the right-hand side Jᵀr, where r are the residuals if all unknowns
    /// are 0.
    rows: Vec<f64>,
}

impl Quadratic {
    /// Creates a sum of squares that is identically 0, as a function of `unknowns` unknowns.
    pub fn zeros(unknowns: usize) -> Self {
        Self {
            unknowns,
            rows: vec![0.0; unknowns * row_length(unknowns)],
        }
    }

    /// Adds the square of a residual that is linear in the unknowns: `residual` is its value if all unknowns are 0, and
    /// `derivatives` are its derivatives with respect to them.
    pub fn add(&mut self, derivatives: &[f64], residual: f64) {
        self.add_weighted(1.0, derivatives, residual);
    }

    /// Adds the square of `weight` times a residual that is linear in the unknowns: `residual` is its value if all
    /// unknowns are 0, and `derivatives` are its derivatives with respect to them.
    pub fn add_weighted(&mut self, weight: f64, derivatives: &[f64], residual: f64) {
        let square = weight * weight;
        with_padded(
            0,
            derivatives,
            residual,
            row_length(self.unknowns),
            |vector| {
                add_products(&mut self.rows, square, [derivatives, &[]], vector);
            },
        );
    }

    /// Adds `other`, a sum of squares as a function of the same unknowns.
    pub fn add_all(&mut self, other: &Self) {
        for (entry, other) in self.rows.iter_mut().zip(&other.rows) {
            *entry += other;
        }
    }

    /// Diagonal entry of the normal matrix for one unknown.
    pub fn diagonal(&self, unknown: usize) -> f64 {
        self.row(unknown)[unknown]
    }

    /// Row of the normal matrix for one unknown. The entry after the last column is that of the right-hand side.
    pub fn row(&self, unknown: usize) -> &[f64] {
        &self.rows[unknown * row_length(self.unknowns)..][..row_length(self.unknowns)]
    }

    /// Values of the unknowns at the minimum of the sum of squares; `None` if the normal matrix is singular.
    pub fn minimum(&self) -> Option<Vec<f64>> {
        let count = self.unknowns;
        let mut factor = self.clone();
        factor.eliminate(count)?;
        let mut unknowns = vec![0.0; count];
        for index in (0..count).rev() {
            let row = factor.row(index);
            let known = row[index + 1..count].iter().zip(&unknowns[index + 1..]);
            let known: f64 = known.map(|(entry, unknown)| entry * unknown).sum();
            unknowns[index] = -(row[count] + known) / row[index];
        }
        Some(unknowns)
    }

    /// Replaces the rows of the first `count` unknowns by those of the Cholesky factor U of the normal matrix UᵀU and by
    /// the solution of Uᵀy = Jᵀr, and the other rows by those of the Schur complement. `None` if the matrix is not
    /// positive definite. The diagonal entries of the first `count` unknowns are first increased (see [`ridge`]).
    fn eliminate(&mut self, count: usize) -> Option<()> {
        let length = row_length(self.unknowns);
        for unknown in 0..count {
            let entry = &mut self.rows[unknown * length + unknown];
            *entry += ridge(*entry);
        }
        let (rows, blocks) = (self.rows.as_chunks_mut().0, length / BLOCK);
        let is_definite = by_blocks!(
            blocks,
            Eliminate {
                rows,
                blocks,
                count
            }
        );
        is_definite.then_some(())
    }
}

/// Length of the stored rows of a normal matrix and its right-hand side.
fn row_length(unknowns: usize) -> usize {
    (unknowns + 1).next_multiple_of(BLOCK)
}

/// A sum of squared residuals that are linear functions of two vectors of unknowns of the same length, without the terms
/// that depend on the first vector alone.
#[derive(Clone, Debug)]
pub struct Coupled {
    length: usize,
    /// The sum as a function of the unknowns of both vectors, one after the other. The entries of the first vector alone
    /// are not used, nor is its right-hand side.
    both: Quadratic,
}

impl Coupled {
    /// Creates a sum of squares that is identically 0, as a function of two vectors of `length` unknowns each.
    pub fn zeros(length: usize) -> Self {
        Self {
            length,
            both: Quadratic::zeros(2 * length),
        }
    }

    /// Adds the square of a residual: `residual` is its value if all unknowns are 0, and `first` and `second` are its
    /// derivatives with respect to the two vectors.
    pub fn add(&mut self, first: &[f64], second: &[f64], residual: f64) {
        let length = row_length(2 * self.length);
        with_padded(self.length, second, residual, length, |vector| {
            add_products(&mut self.both.rows, 1.0, [first, second], vector);
        });
    }

    /// Adds residuals that depend on the sum of the two vectors. `sum` contains them as a function of one vector.
    pub fn add_all(&mut self, sum: &Quadratic) {
        let (length, row_length) = (self.length, row_length(2 * self.length));
        let (cross, own) = self.both.rows.split_at_mut(length * row_length);
        let rows = cross
            .chunks_exact_mut(row_length)
            .zip(own.chunks_exact_mut(row_length));
        for (index, (cross, own)) in rows.enumerate() {
            let from = &sum.row(index)[..=length];
            for row in [cross, own] {
                for (entry, other) in row[length..=2 * length].iter_mut().zip(from) {
                    *entry += other;
                }
            }
        }
    }

    /// Diagonal entry of the normal matrix for one unknown of the second vector.
    pub fn diagonal(&self, unknown: usize) -> f64 {
        self.both.diagonal(self.length + unknown)
    }

    /// Minimum of the sum of squares over the first vector, as a function of the second one (Schur complement). `first`
    /// contains the terms that depend on the first vector alone; `None` if the first vector is undetermined.
    pub fn minimum_over_first(self, first: &Quadratic) -> Option<Quadratic> {
        let (length, row_length) = (self.length, row_length(2 * self.length));
        let mut both = self.both;
        let rows = both.rows.chunks_exact_mut(row_length);
        for (index, row) in rows.take(length).enumerate() {
            let from = first.row(index);
            row[index..length].copy_from_slice(&from[index..length]);
            row[2 * length] = from[length];
        }
        both.eliminate(length)?;
        let mut rest = Quadratic::zeros(length);
        let rows = both.rows[length * row_length..].chunks_exact(row_length);
        let own = rest.rows.chunks_exact_mut(self::row_length(length));
        for (to, from) in own.zip(rows) {
            to[..=length].copy_from_slice(&from[length..=2 * length]);
        }
        Some(rest)
    }
}

/// Length of a row up to which it is padded on the stack.
const STACK: usize = 32;

/// Calls `each` with a row of `length` entries: zeros before `from`, then `derivatives` and `residual`, then zeros.
fn with_padded(
    from: usize,
    derivatives: &[f64],
    residual: f64,
    length: usize,
    each: impl FnOnce(&[f64]),
) {
    let mut stack;
    let mut heap;
    let row = if length <= STACK {
        stack = [0.0; STACK];
        &mut stack[..length]
    } else {
        heap = vec![0.0; length];
        &mut heap[..]
    };
    let end = from + derivatives.len();
    row[from..end].copy_from_slice(derivatives);
    row[end] = residual;
    each(row);
}

/// Adds, to each row of a matrix, the product of `square`, a vector and the factor of the row. `factors` contains the
/// factors of the first rows, and those of the other rows.
fn add_products(rows: &mut [f64], square: f64, factors: [&[f64]; 2], vector: &[f64]) {
    let (rows, vector) = (rows.as_chunks_mut().0, vector.as_chunks().0);
    by_blocks!(
        vector.len(),
        AddProducts {
            rows,
            square,
            factors,
            vector
        }
    );
}

/// Kernel of [`add_products`], for vectors of `BLOCKS` blocks; 0 for any number.
struct AddProducts<'a, const BLOCKS: usize> {
    rows: &'a mut [[f64; BLOCK]],
    square: f64,
    factors: [&'a [f64]; 2],
    vector: &'a [[f64; BLOCK]],
}

impl<const BLOCKS: usize> Kernel for AddProducts<'_, BLOCKS> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let blocks = match BLOCKS {
            0 => self.vector.len(),
            _ => BLOCKS,
        };
        let mut rows = self.rows.chunks_exact_mut(blocks);
        for factors in self.factors {
            // The factors come first, so that no row is taken without one.
            for (factor, row) in factors.iter().zip(&mut rows) {
                let factor = T::splat(self.square * factor);
                for (block, other) in row.iter_mut().zip(self.vector) {
                    let parts = block.chunks_exact_mut(T::WIDTH);
                    for (part, other) in parts.zip(other.chunks_exact(T::WIDTH)) {
                        T::load(other).mul_add(factor, T::load(part)).store(part);
                    }
                }
            }
        }
    }
}

/// Kernel that eliminates the first `count` unknowns of a symmetric matrix, whose upper triangle is stored in rows of
/// `blocks` blocks. Returns whether the part of the matrix for these unknowns is positive definite. If `BLOCKS` is not
/// 0, it is the value of `blocks`, and the kernel is compiled for it.
struct Eliminate<'a, const BLOCKS: usize> {
    rows: &'a mut [[f64; BLOCK]],
    blocks: usize,
    count: usize,
}

impl<const BLOCKS: usize> Kernel for Eliminate<'_, BLOCKS> {
    type Output = bool;

    #[inline(always)]
    fn run<T: Lanes>(self) -> bool {
        let blocks = match BLOCKS {
            0 => self.blocks,
            _ => BLOCKS,
        };
        for index in 0..self.count {
            let (above, below) = self.rows.split_at_mut((index + 1) * blocks);
            let row = &mut above[index * blocks..][..blocks];
            let pivot = row[index / BLOCK][index % BLOCK];
            if pivot.is_nan() || pivot <= 0.0 {
                return false;
            }
            let scale = T::splat(pivot.sqrt().recip());
            for block in &mut *row {
                for part in block.chunks_exact_mut(T::WIDTH) {
                    (T::load(part) * scale).store(part);
                }
            }
            for (other, to) in (index + 1..).zip(below.chunks_exact_mut(blocks)) {
                let factor = T::splat(-row[other / BLOCK][other % BLOCK]);
                // A loop over whole rows, of known length, is faster than one from the diagonal on.
                for (block, own) in to.iter_mut().zip(&*row) {
                    let parts = block.chunks_exact_mut(T::WIDTH);
                    for (part, own) in parts.zip(own.chunks_exact(T::WIDTH)) {
                        T::load(own).mul_add(factor, T::load(part)).store(part);
                    }
                }
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector};

    use super::*;

    /// Residuals that are linear functions of `unknowns` unknowns: Jacobian, and values if all unknowns are 0.
    fn residuals(count: usize, unknowns: usize) -> (DMatrix<f64>, DVector<f64>) {
        let at = |row: usize, column: usize| ((row * 37 + column * 101) % 23) as f64 / 23.0 - 0.4;
        (
            DMatrix::from_fn(count, unknowns, at),
            DVector::from_fn(count, |row, _| at(row, unknowns + 3)),
        )
    }

    fn quadratic(jacobian: &DMatrix<f64>, residuals: &DVector<f64>) -> Quadratic {
        let mut sum = Quadratic::zeros(jacobian.ncols());
        for (row, residual) in jacobian.row_iter().zip(residuals) {
            sum.add(&row.iter().copied().collect::<Vec<_>>(), *residual);
        }
        sum
    }

    /// Minimum of the sum of squares and the unknowns there, by a singular value decomposition.
    fn by_svd(jacobian: DMatrix<f64>, residuals: &DVector<f64>) -> (f64, DVector<f64>) {
        let unknowns = -jacobian
            .clone()
            .svd(true, true)
            .solve(residuals, 1e-12)
            .unwrap();
        ((residuals + jacobian * &unknowns).norm_squared(), unknowns)
    }

    #[test]
    fn a_minimum_is_that_of_least_squares() {
        for unknowns in [1, 3, 7, 8, 12, 15, 16, 30, 45] {
            let (jacobian, residuals) = residuals(60, unknowns);
            let found = quadratic(&jacobian, &residuals).minimum().unwrap();
            let (least, at) = by_svd(jacobian.clone(), &residuals);
            let found = DVector::from(found);
            let squares = (&residuals + &jacobian * &found).norm_squared();
            let decrease = residuals.norm_squared() - least;
            assert!((squares - least).abs() < 1e-6 * decrease);
            assert!((found - &at).amax() < 1e-5 * at.amax(), "{unknowns}");
        }
    }

    #[test]
    fn eliminated_unknowns_are_at_their_minimum() {
        let own = 5;
        let (jacobian, residuals) = residuals(22, 2 * own);
        let first = jacobian.columns(0, own).into_owned();
        let mut sum = Coupled::zeros(own);
        for (row, residual) in jacobian.row_iter().zip(&residuals) {
            let row: Vec<f64> = row.iter().copied().collect();
            sum.add(&row[..own], &row[own..], *residual);
        }
        let rest = sum.minimum_over_first(&quadratic(&first, &residuals));
        let (_, at) = by_svd(jacobian, &residuals);
        let found = DVector::from(rest.unwrap().minimum().unwrap());
        assert!((found - at.rows(own, own)).amax() < 1e-5 * at.amax());
    }

    #[test]
    fn residuals_of_a_sum_depend_on_both_vectors_alike() {
        let (jacobian, residuals) = residuals(9, 4);
        let (mut of_rows, mut of_sum) = (Coupled::zeros(4), Coupled::zeros(4));
        for (row, residual) in jacobian.row_iter().zip(&residuals) {
            let row: Vec<f64> = row.iter().copied().collect();
            of_rows.add(&row, &row, *residual);
        }
        of_sum.add_all(&quadratic(&jacobian, &residuals));
        for index in 0..8 {
            // The right-hand side of the first vector is not used.
            let end = if index < 4 { 8 } else { 9 };
            let [a, b] = [&of_rows, &of_sum].map(|sum| &sum.both.row(index)[index.max(4)..end]);
            assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12));
        }
    }

    #[test]
    fn a_matrix_that_is_not_a_number_has_no_minimum() {
        let mut sum = Quadratic::zeros(3);
        sum.add(&[1.0, f64::NAN, 2.0], 1.0);
        assert!(sum.minimum().is_none());
    }
}
