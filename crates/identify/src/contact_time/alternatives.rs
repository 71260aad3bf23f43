//! Minima of sums of squares that differ in one term, computed side by side in SIMD lanes.

use lanes::{Isa, Kernel, Lanes};

use super::quadratic::{Quadratic, ridge};

/// Alternative terms of a sum of squares, each a function of the same unknowns. A SIMD lane belongs to each alternative.
pub struct Alternatives {
    unknowns: usize,
    count: usize,
    /// Number of lanes of a SIMD vector.
    width: usize,
    /// Upper triangles of the normal matrices, row by row, each row followed by its entry of the right-hand side. An
    /// entry is a vector with one lane per alternative. If there are more alternatives than lanes, there are several
    /// groups of such triangles, one after the other.
    entries: Vec<f64>,
}

impl Alternatives {
    /// Arranges the terms `terms`, functions of `unknowns` unknowns, in lanes.
    pub fn new(terms: &[Quadratic], unknowns: usize) -> Self {
        let width = Isa::best().width();
        let mut entries =
            Vec::with_capacity(terms.len().next_multiple_of(width) * length(unknowns));
        for terms in terms.chunks(width) {
            for unknown in 0..unknowns {
                for column in unknown..=unknowns {
                    let lanes = terms.iter().map(|term| term.row(unknown)[column]);
                    entries.extend(lanes.chain(std::iter::repeat(0.0)).take(width));
                }
            }
        }
        Self {
            unknowns,
            count: terms.len(),
            width,
            entries,
        }
    }

    /// Of the sums of squares `common` + alternative, finds the one whose minimum is farthest below its value for
    /// unknowns equal to 0. Returns this decrease and the unknowns at the minimum; `None` if every normal matrix is
    /// singular. The diagonal entry of unknown `i` of a normal matrix is first increased by the [`ridge`] of the sum of
    /// `diagonal(i)` and the diagonal entry of the alternative.
    pub fn greatest_decrease(
        &self,
        common: &Quadratic,
        diagonal: impl Fn(usize) -> f64,
    ) -> Option<(f64, Vec<f64>)> {
        let (unknowns, width) = (self.unknowns, self.width);
        let mut best: Option<(f64, Vec<f64>)> = None;
        let groups = self.entries.chunks_exact(length(unknowns) * width);
        for (group, entries) in groups.enumerate() {
            let mut matrices = entries.to_vec();
            let mut place = 0;
            for unknown in 0..unknowns {
                let diagonal = diagonal(unknown);
                for entry in &mut matrices[place..place + width] {
                    *entry += ridge(diagonal + *entry);
                }
                place += (unknowns + 1 - unknown) * width;
            }
            let mut decreases = vec![0.0; width];
            lanes::dispatch(Eliminate {
                common,
                unknowns,
                matrices: &mut matrices,
                decreases: &mut decreases,
            });
            for (lane, decrease) in decreases.into_iter().enumerate() {
                let is_better = best.as_ref().is_none_or(|(best, _)| decrease > *best);
                // The decrease for a singular matrix is not finite.
                if group * width + lane < self.count && decrease.is_finite() && is_better {
                    best = Some((decrease, solution(&matrices[lane..], unknowns, width)));
                }
            }
        }
        best
    }
}

/// Number of entries of the upper triangle of a normal matrix with its right-hand side.
fn length(unknowns: usize) -> usize {
    unknowns * (unknowns + 3) / 2
}

/// Unknowns at the minimum of a sum of squares, from its Cholesky factor and the solution of the forward substitution.
/// The entries of both are `width` apart.
fn solution(factor: &[f64], unknowns: usize, width: usize) -> Vec<f64> {
    let mut values = vec![0.0; unknowns];
    let mut end = length(unknowns);
    for index in (0..unknowns).rev() {
        let first = end - (unknowns + 1 - index);
        let mut rest = factor[(end - 1) * width];
        for (place, value) in (first + 1..).zip(&values[index + 1..]) {
            rest += factor[place * width] * value;
        }
        values[index] = -rest / factor[first * width];
        end = first;
    }
    values
}

/// Kernel that adds the normal matrix of `common` to the matrices of all lanes, and computes their Cholesky factors and
/// the decreases of the sums of squares to their minima.
struct Eliminate<'a> {
    common: &'a Quadratic,
    unknowns: usize,
    matrices: &'a mut [f64],
    decreases: &'a mut [f64],
}

impl Kernel for Eliminate<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let unknowns = self.unknowns;
        let mut entries = self.matrices.chunks_exact_mut(T::WIDTH);
        for unknown in 0..unknowns {
            let row = &self.common.row(unknown)[unknown..=unknowns];
            for (value, entry) in row.iter().zip(&mut entries) {
                (T::load(entry) + T::splat(*value)).store(entry);
            }
        }
        let mut decrease = T::splat(0.0);
        let mut rest = self.matrices;
        for unknown in 0..unknowns {
            let (row, below) = rest.split_at_mut((unknowns + 1 - unknown) * T::WIDTH);
            let scale = T::splat(1.0) / T::load(row).sqrt();
            for entry in row.chunks_exact_mut(T::WIDTH) {
                (T::load(entry) * scale).store(entry);
            }
            let mut others = &mut *below;
            for first in 1..unknowns - unknown {
                let own = &row[first * T::WIDTH..];
                let factor = -T::load(own);
                let (other, later) = others.split_at_mut(own.len());
                let pairs = other
                    .chunks_exact_mut(T::WIDTH)
                    .zip(own.chunks_exact(T::WIDTH));
                for (entry, own) in pairs {
                    factor.mul_add(T::load(own), T::load(entry)).store(entry);
                }
                others = later;
            }
            let last = T::load(&row[row.len() - T::WIDTH..]);
            decrease = last.mul_add(last, decrease);
            rest = below;
        }
        decrease.store(self.decreases);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sum of squares of `count` residuals that are linear functions of `unknowns` unknowns.
    fn sum(count: usize, unknowns: usize, seed: usize) -> Quadratic {
        let at = |row: usize, column: usize| ((row * 37 + column * 101 + seed) % 23) as f64 / 23.0;
        let mut sum = Quadratic::zeros(unknowns);
        for row in 0..count {
            let derivatives: Vec<f64> = (0..unknowns).map(|column| at(row, column) - 0.4).collect();
            sum.add(&derivatives, at(row, unknowns + 3));
        }
        sum
    }

    #[test]
    fn the_best_alternative_is_that_of_separate_minima() {
        for (unknowns, count) in [(1, 1), (5, 3), (12, 4), (16, 9)] {
            let common = sum(40, unknowns, 0);
            let terms: Vec<Quadratic> = (0..count).map(|k| sum(7, unknowns, 5 * k + 1)).collect();
            let minima = terms.iter().map(|term| {
                let mut both = common.clone();
                both.add_all(term);
                let at = both.minimum().unwrap();
                let gradient = (0..unknowns).map(|unknown| both.row(unknown)[unknowns]);
                let decrease: f64 = gradient.zip(&at).map(|(slope, value)| -slope * value).sum();
                (decrease, at)
            });
            let (decrease, at) = minima.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
            let found = Alternatives::new(&terms, unknowns)
                .greatest_decrease(&common, |unknown| common.diagonal(unknown))
                .unwrap();
            assert!((found.0 - decrease).abs() < 1e-9 * decrease, "{unknowns}");
            let differences = found.1.iter().zip(&at).map(|(a, b)| (a - b).abs());
            assert!(differences.fold(0.0, f64::max) < 1e-6, "{unknowns}");
        }
    }

    #[test]
    fn an_alternative_without_a_minimum_is_left_out() {
        let (common, good) = (sum(20, 3, 0), sum(4, 3, 1));
        let mut bad = Quadratic::zeros(3);
        bad.add(&[1.0, f64::NAN, 2.0], 1.0);
        let of = |terms: &[Quadratic]| {
            Alternatives::new(terms, 3).greatest_decrease(&common, |i| common.diagonal(i))
        };
        assert_eq!(of(&[bad.clone(), good.clone()]), of(&[good]));
        assert_eq!(of(&[bad]), None);
    }
}
