//! Linear systems, solved by elimination with scaled partial pivoting.

use crate::scalar::Real;

/// Solution of a linear system.
pub(crate) struct Solved<T> {
    pub unknowns: Vec<T>,
    /// Least size of a pivot over the sum of the sizes of its terms.
    pub determinacy: f64,
}

/// Solves the system whose rows are coefficients and right-hand side.
pub(crate) fn eliminate<T: Real>(mut rows: Vec<Vec<T>>) -> Solved<T> {
    let count = rows.len();
    let mut sizes: Vec<Vec<f64>> = { rows.iter() }
        .map(|row| row.iter().map(|entry| size(*entry)).collect())
        .collect();
    let mut determinacy = 1.0_f64;
    for step in 0..count {
        let scaled = |row: usize| {
            let rest = &sizes[row][step..count];
            let scale = rest.iter().copied().fold(0.0, f64::max);
            size(rows[row][step]) / scale
        };
        let best = (step..count).max_by(|a, b| scaled(*a).total_cmp(&scaled(*b)));
        let best = best.unwrap_or(step);
        rows.swap(step, best);
        sizes.swap(step, best);
        let pivot = rows[step][step];
        let share = size(pivot) / sizes[step][step];
        determinacy = if share.is_nan() {
            0.0
        } else {
            determinacy.min(share)
        };
        for row in step + 1..count {
            let factor = rows[row][step] / pivot;
            for column in step..=count {
                let (less, more) = (rows[step][column], sizes[step][column]);
                rows[row][column] -= factor * less;
                sizes[row][column] += size(factor) * more;
            }
        }
    }
    let mut unknowns = vec![T::zero(); count];
    for row in (0..count).rev() {
        let known = (row + 1..count).map(|k| rows[row][k] * unknowns[k]);
        let known = known.fold(T::zero(), |sum, term| sum + term);
        unknowns[row] = (rows[row][count] - known) / rows[row][row];
    }
    Solved {
        unknowns,
        determinacy,
    }
}

/// Absolute value; above 0 for symbols, whose real value is none, unless they are zero.
fn size<T: Real>(value: T) -> f64 {
    if value.is_zero() {
        0.0
    } else {
        value.re().abs()
    }
}
