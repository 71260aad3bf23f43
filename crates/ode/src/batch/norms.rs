//! Error norms of steps and initial step sizes, one value per SIMD lane.

use super::stages::{BLOCK, Stages};
use crate::method::ErrorTolerance;
use crate::method::tableau::{Row, Tableau};
use lanes::Lanes;

/// Tolerated error `atol + rtol · max(|a|, |b|)`, in each lane, of a state component from `a` to `b`.
#[inline(always)]
fn scale<T: Lanes>(tolerance: &ErrorTolerance, a: T, b: T) -> T {
    let greatest = a.abs().max(b.abs());
    T::splat(tolerance.rtol) * greatest + T::splat(tolerance.atol)
}

#[inline(always)]
pub(crate) fn error_norm<T: Lanes>(
    tableau: &Tableau,
    stages: &Stages<T>,
    (x, end): (&[T], &[T]),
    h: T,
    tolerance: &ErrorTolerance,
) -> T {
    let n = stages.n;
    let (x, end) = (&x[..n], &end[..n]);
    let zero = T::splat(0.0);
    let (mut sum_5, mut sum_3) = (zero, zero);
    let mut start = 0;
    while start < n {
        let end_of_block = (start + BLOCK).min(n);
        let fives = errors(stages, tableau.errors[0], start, end_of_block);
        let threes = match tableau.errors.get(1) {
            Some(row) => errors(stages, row, start, end_of_block),
            None => [zero; BLOCK],
        };
        for i in start..end_of_block {
            let inverse = T::splat(1.0) / scale(tolerance, x[i], end[i]);
            let (five, three) = (fives[i - start] * inverse, threes[i - start] * inverse);
            sum_5 = five.mul_add(five, sum_5);
            sum_3 = three.mul_add(three, sum_3);
        }
        start = end_of_block;
    }
    if tableau.errors.len() == 1 {
        return h * (sum_5 * T::splat(1.0 / n as f64)).sqrt();
    }
    // No estimate uses the derivative at the end; adding 0 times that makes the norm NaN if it is not finite.
    let mut last = zero;
    for rate in stages.stage(tableau.rows.len()) {
        last = zero.mul_add(*rate, last);
    }
    let sum_5 = sum_5 + last;
    let both = (sum_5 + T::splat(0.01) * sum_3) * T::splat(n as f64);
    // 0 where the sum is 0; NaN remains.
    h * sum_5 * both.if_zero(zero, T::splat(1.0) / both.sqrt())
}

/// Error estimates over the step size with the weights `row`, of the components `start..end`, else 0.
// A function, since a closure need not be inlined.
#[inline(always)]
fn errors<T: Lanes>(stages: &Stages<T>, row: Row, start: usize, end: usize) -> [T; BLOCK] {
    if end - start == BLOCK {
        return stages.block(row, start);
    }
    let mut sums = [T::splat(0.0); BLOCK];
    for i in start..end {
        sums[i - start] = stages.sum(row, i);
    }
    sums
}

/// Root mean squares of state and derivative in each lane, relative to the tolerated error at `x`.
#[inline(always)]
pub(crate) fn initial_norms<T: Lanes>(x: &[T], dx: &[T], tolerance: &ErrorTolerance) -> [T; 2] {
    let n = x.len();
    let (mut of_x, mut of_dx) = (T::splat(0.0), T::splat(0.0));
    for i in 0..n {
        let inverse = T::splat(1.0) / scale(tolerance, x[i], x[i]);
        let (a, b) = (x[i] * inverse, dx[i] * inverse);
        of_x = a.mul_add(a, of_x);
        of_dx = b.mul_add(b, of_dx);
    }
    let one_over_n = T::splat(1.0 / n as f64);
    [(of_x * one_over_n).sqrt(), (of_dx * one_over_n).sqrt()]
}

/// Root mean square of `after - before` in each lane, relative to the tolerated error at `x`.
#[inline(always)]
pub(crate) fn change_norm<T: Lanes>(
    x: &[T],
    (before, after): (&[T], &[T]),
    tolerance: &ErrorTolerance,
) -> T {
    let n = x.len();
    let mut sum = T::splat(0.0);
    for i in 0..n {
        let scaled = (after[i] - before[i]) / scale(tolerance, x[i], x[i]);
        sum = scaled.mul_add(scaled, sum);
    }
    (sum * T::splat(1.0 / n as f64)).sqrt()
}
