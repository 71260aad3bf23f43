//! Long states on the machine's widest lanes, with the bits that short ones have.

use super::ROWS;
use lanes::{Kernel, Lanes};

/// States of so many numbers are worked on so; shorter ones are quicker as they are.
pub(crate) const WIDE: usize = 64;

/// `to = from + h Σ weight · k`
pub(crate) struct Combine<'a, const M: usize> {
    pub to: &'a mut [f64],
    pub from: &'a [f64],
    pub h: f64,
    pub weights: [f64; M],
    pub k: [&'a [f64]; M],
}

impl<const M: usize> Kernel for Combine<'_, M> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Combine { to, h, weights, .. } = self;
        let n = to.len();
        // Of one length, as the compiler sees here, so that it checks no place in the loop.
        let from = &self.from[..n];
        let mut k = self.k;
        for k in &mut k {
            *k = &k[..n];
        }
        let mut i = 0;
        while i + T::WIDTH <= n {
            let mut sum = T::splat(weights[0]) * T::load(&k[0][i..]);
            for m in 1..M {
                sum = sum + T::splat(weights[m]) * T::load(&k[m][i..]);
            }
            (T::load(&from[i..]) + T::splat(h) * sum).store(&mut to[i..]);
            i += T::WIDTH;
        }
        for i in i..n {
            let mut sum = weights[0] * k[0][i];
            for m in 1..M {
                sum += weights[m] * k[m][i];
            }
            to[i] = from[i] + h * sum;
        }
    }
}

/// `to = Σ weight · row`, the first weight being 1.
pub(crate) struct Weighted<'a> {
    pub rows: [&'a [f64]; ROWS],
    pub weights: [f64; ROWS],
    pub to: &'a mut [f64],
}

impl Kernel for Weighted<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Weighted { weights, to, .. } = self;
        let n = to.len();
        let mut rows = self.rows;
        for row in &mut rows {
            *row = &row[..n];
        }
        let mut i = 0;
        while i + T::WIDTH <= n {
            let mut sum = T::load(&rows[0][i..]);
            for row in 1..ROWS {
                sum = sum + T::splat(weights[row]) * T::load(&rows[row][i..]);
            }
            sum.store(&mut to[i..]);
            i += T::WIDTH;
        }
        for i in i..n {
            let mut sum = rows[0][i];
            for row in 1..ROWS {
                sum += weights[row] * rows[row][i];
            }
            to[i] = sum;
        }
    }
}

/// Whether all numbers are finite.
pub(crate) struct AllFinite<'a>(pub &'a [f64]);

impl Kernel for AllFinite<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<T: Lanes>(self) -> bool {
        // Nothing times a number is nothing, but of an infinity or NaN it is NaN.
        let nothing = T::splat(0.0);
        let mut sum = nothing;
        let n = self.0.len();
        let mut i = 0;
        while i + T::WIDTH <= n {
            sum = sum + nothing * T::load(&self.0[i..]);
            i += T::WIDTH;
        }
        let mut rest = 0.0;
        for value in &self.0[i..] {
            rest += 0.0 * value;
        }
        for lane in 0..T::WIDTH {
            rest += sum.lane(lane);
        }
        rest == 0.0
    }
}
