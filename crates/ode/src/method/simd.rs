//! SIMD kernels for long states, with results bit-identical to those of the scalar loops for short states.

use super::ROWS;
use lanes::{Kernel, Lanes};

/// Minimum state length for which SIMD kernels are used; for shorter states the scalar loops are faster.
pub(crate) const MIN_SIMD_LEN: usize = 64;

/// Number of elements in an iteration of a loop over the elements of a state: whole SIMD vectors on every machine. The
/// length is known to the compiler, so that the loops have no bounds checks.
const BLOCK: usize = 8;

/// Argument of a stage: `to = from + h Σ weight · k`, with derivatives `k` of earlier stages of equal length.
// Not generic, so that programs do not compile the kernels again for each of their right-hand sides.
pub(crate) fn combine(to: &mut [f64], from: &[f64], h: f64, weights: &[f64], k: &[&[f64]]) {
    macro_rules! stages {
        ($($count:literal)*) => {
            match k.len() {
                $($count => {
                    let mut of = ([0.0; $count], [&[] as &[f64]; $count]);
                    of.0.copy_from_slice(weights);
                    of.1.copy_from_slice(k);
                    let (weights, k) = of;
                    lanes::dispatch(Combine { to, from, h, weights, k });
                })*
                count => unreachable!("a stage of {count} derivatives"),
            }
        };
    }
    stages!(1 2 3 4 5 6 7 8 9);
}

/// Kernel that computes the argument of a stage: `to = from + h Σ weight · k`.
struct Combine<'a, const M: usize> {
    to: &'a mut [f64],
    from: &'a [f64],
    h: f64,
    weights: [f64; M],
    k: [&'a [f64]; M],
}

impl<const M: usize> Kernel for Combine<'_, M> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Combine { to, h, weights, .. } = self;
        let n = to.len();
        // Equal lengths, visible to the compiler, remove the bounds checks from the loop.
        let from = &self.from[..n];
        let mut k = self.k;
        for k in &mut k {
            *k = &k[..n];
        }
        let (blocks, from_blocks) = (to.as_chunks_mut::<BLOCK>().0, from.as_chunks::<BLOCK>().0);
        let mut k_blocks = [&[] as &[[f64; BLOCK]]; M];
        for m in 0..M {
            k_blocks[m] = &k[m].as_chunks().0[..blocks.len()];
        }
        let from_blocks = &from_blocks[..blocks.len()];
        for (index, to) in blocks.iter_mut().enumerate() {
            for i in (0..BLOCK).step_by(T::WIDTH) {
                let mut sum = T::splat(weights[0]) * T::load(&k_blocks[0][index][i..]);
                for m in 1..M {
                    sum = sum + T::splat(weights[m]) * T::load(&k_blocks[m][index][i..]);
                }
                let from = T::load(&from_blocks[index][i..]);
                (from + T::splat(h) * sum).store(&mut to[i..]);
            }
        }
        let i = blocks.len() * BLOCK;
        for i in i..n {
            let mut sum = weights[0] * k[0][i];
            for m in 1..M {
                sum += weights[m] * k[m][i];
            }
            to[i] = from[i] + h * sum;
        }
    }
}

/// Kernel that evaluates dense output: `to = Σ weight · row` over the coefficient vectors, where the first weight is 1.
pub(crate) struct WeightedRows<'a> {
    pub rows: [&'a [f64]; ROWS],
    pub weights: [f64; ROWS],
    pub to: &'a mut [f64],
}

impl Kernel for WeightedRows<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let WeightedRows { weights, to, .. } = self;
        let n = to.len();
        let mut rows = self.rows;
        for row in &mut rows {
            *row = &row[..n];
        }
        let blocks = to.as_chunks_mut::<BLOCK>().0;
        let mut row_blocks = [&[] as &[[f64; BLOCK]]; ROWS];
        for row in 0..ROWS {
            row_blocks[row] = &rows[row].as_chunks().0[..blocks.len()];
        }
        for (index, to) in blocks.iter_mut().enumerate() {
            for i in (0..BLOCK).step_by(T::WIDTH) {
                let mut sum = T::load(&row_blocks[0][index][i..]);
                for row in 1..ROWS {
                    sum = sum + T::splat(weights[row]) * T::load(&row_blocks[row][index][i..]);
                }
                sum.store(&mut to[i..]);
            }
        }
        let i = blocks.len() * BLOCK;
        for i in i..n {
            let mut sum = rows[0][i];
            for row in 1..ROWS {
                sum += weights[row] * rows[row][i];
            }
            to[i] = sum;
        }
    }
}

pub(crate) struct AllFinite<'a>(pub &'a [f64]);

impl Kernel for AllFinite<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<T: Lanes>(self) -> bool {
        // 0 times a finite number is 0; 0 times an infinity or NaN is NaN.
        let zero = T::splat(0.0);
        let mut sum = zero;
        let (blocks, others) = self.0.as_chunks::<BLOCK>();
        for block in blocks {
            for i in (0..BLOCK).step_by(T::WIDTH) {
                sum = zero.mul_add(T::load(&block[i..]), sum);
            }
        }
        let mut rest = 0.0;
        for value in others {
            rest += 0.0 * value;
        }
        for lane in 0..T::WIDTH {
            rest += sum.lane(lane);
        }
        rest == 0.0
    }
}
