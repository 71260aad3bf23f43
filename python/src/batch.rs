//! Many states at once, one per SIMD lane, with the bits of single states.

use std::thread;

use codegen::tape::{Inputs, Tape};
use lanes::{Kernel, LaneKernel, Lanes, dispatch};

/// Least number of states that are worth a thread of their own: it starts in the time of some hundred states.
const MIN_SHARE: usize = 2048;

/// States whose derivatives are computed.
pub struct Batch<'a> {
    /// The function f.
    pub tape: &'a Tape,
    /// One time, or one for each state.
    pub t: &'a [f64],
    /// States, one after another.
    pub x: &'a [f64],
    /// Parameters.
    pub p: &'a [f64],
    /// Their invariants.
    pub prepared: &'a [f64],
    /// The results, as long as the states.
    pub dx: &'a mut [f64],
}

impl Batch<'_> {
    /// Computes all derivatives, on all processors where there are many states. The threads end with the call: a process
    /// that is forked later has none of them.
    pub fn run(self) {
        let n = self.tape.outputs();
        let rows = self.dx.len() / n;
        let shares = flight::parallel::threads().min(rows / MIN_SHARE).max(1);
        let share = rows.div_ceil(shares);
        if shares == 1 {
            return dispatch(self);
        }
        thread::scope(|scope| {
            for (index, dx) in self.dx.chunks_mut(share * n).enumerate() {
                let rows = index * share..index * share + dx.len() / n;
                let part = Batch {
                    t: self.t.get(rows.clone()).unwrap_or(self.t),
                    x: &self.x[rows.start * n..rows.end * n],
                    dx,
                    ..self
                };
                scope.spawn(|| dispatch(part));
            }
        });
    }
}

impl Kernel for Batch<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let n = self.tape.outputs();
        let splat = |values: &[f64]| values.iter().map(|value| T::splat(*value)).collect();
        let (p, prepared): (Vec<T>, Vec<T>) = (splat(self.p), splat(self.prepared));
        let mut registers = vec![T::splat(0.0); self.tape.registers()];
        let (mut x, mut out) = (vec![T::splat(0.0); n], vec![T::splat(0.0); n]);
        for (index, dx) in self.dx.chunks_mut(n * T::WIDTH).enumerate() {
            let first = index * T::WIDTH;
            let count = dx.len() / n;
            // Lanes without a state repeat the last one.
            let row = |lane: usize| first + lane.min(count - 1);
            let t = match self.t {
                [t] => T::splat(*t),
                times => T::from_fn(|lane| times[row(lane)]),
            };
            for (k, x) in x.iter_mut().enumerate() {
                *x = T::from_fn(|lane| self.x[row(lane) * n + k]);
            }
            let inputs = Inputs {
                t,
                x: &x,
                p: &p,
                prepared: &prepared,
                marker: &[],
            };
            T::outlined(Step {
                tape: self.tape,
                inputs,
                registers: &mut registers,
                out: &mut out,
            });
            for (lane, dx) in dx.chunks_exact_mut(n).enumerate() {
                for (dx, out) in dx.iter_mut().zip(&out) {
                    *dx = out.lane(lane);
                }
            }
        }
    }
}

/// One evaluation of the tape.
struct Step<'a, T> {
    tape: &'a Tape,
    inputs: Inputs<'a, T>,
    registers: &'a mut [T],
    out: &'a mut [T],
}

impl<T: Lanes> LaneKernel<T> for Step<'_, T> {
    #[inline(always)]
    fn run(self) {
        self.tape.eval_in(self.inputs, self.registers, self.out);
    }
}
