//! Stages of a step in all lanes, and weighted sums of them.

use crate::method::tableau::{Row, Tableau};
use lanes::Lanes;

/// Number of components summed in parallel: independent accumulators hide the latency of the additions.
pub(crate) const BLOCK: usize = 6;

/// Stage derivatives of a step in all lanes: component i of stage s is at index `s · n + i` of `k`.
pub(crate) struct Stages<T> {
    pub n: usize,
    pub k: Vec<T>,
}

impl<T: Lanes> Stages<T> {
    #[inline(always)]
    pub(crate) fn new(tableau: &Tableau, n: usize) -> Self {
        let count = tableau.stages() + tableau.dense_rows.len();
        Stages {
            n,
            k: vec![T::splat(0.0); count * n],
        }
    }

    #[inline(always)]
    pub(crate) fn stage(&self, s: usize) -> &[T] {
        &self.k[s * self.n..][..self.n]
    }

    #[inline(always)]
    pub(crate) fn stage_mut(&mut self, s: usize) -> &mut [T] {
        &mut self.k[s * self.n..][..self.n]
    }

    /// Component `i` of the sum of the stage derivatives over the stages, Σ weight · stage, with the weights `row`.
    #[inline(always)]
    pub(crate) fn sum(&self, row: Row, i: usize) -> T {
        let mut sum = T::splat(0.0);
        for &(s, weight) in row {
            sum = T::splat(weight).mul_add(self.k[s * self.n + i], sum);
        }
        sum
    }

    /// [`BLOCK`] consecutive components, from component `start` on, of the weighted sum of the stage derivatives with
    /// the weights `row`. The state must have at least `start + BLOCK` components.
    #[inline(always)]
    pub(crate) fn block(&self, row: Row, start: usize) -> [T; BLOCK] {
        let mut sums = [T::splat(0.0); BLOCK];
        for &(s, weight) in row {
            let (k, weight) = (&self.k[s * self.n + start..][..BLOCK], T::splat(weight));
            for b in 0..BLOCK {
                sums[b] = weight.mul_add(k[b], sums[b]);
            }
        }
        sums
    }

    /// Computes `to = x + h Σ weight · stage` from the stage derivatives, with the weights `row`, in all SIMD lanes.
    #[inline(always)]
    pub(crate) fn advance(&self, to: &mut [T], x: &[T], h: T, row: Row) {
        let n = self.n;
        let (to, x) = (&mut to[..n], &x[..n]);
        let mut start = 0;
        while start + BLOCK <= n {
            let sums = self.block(row, start);
            for b in 0..BLOCK {
                to[start + b] = h.mul_add(sums[b], x[start + b]);
            }
            start += BLOCK;
        }
        for i in start..n {
            to[i] = h.mul_add(self.sum(row, i), x[i]);
        }
    }
}
