//! Runge–Kutta methods: one step and the curve within it.

pub(crate) mod dop853;
mod dop853_table;
pub(crate) mod tsit5;
pub(crate) mod wide;

use crate::dynamics::{Dynamics, Storage};

/// Which method flies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// Tsitouras (2011), order 5 with a curve of order 4: the quickest at tolerances of 1e-6 and looser.
    #[default]
    Tsit5,
    /// Dormand & Prince's order 8 with a curve of order 7, by Hairer: for tight tolerances.
    Dop853,
}

impl Method {
    /// Weights of a segment's rows for the state at the part `s` (0 to 1) of its step `h`.
    pub(crate) fn weights(self, s: f64, h: f64) -> [f64; ROWS] {
        match self {
            Method::Tsit5 => {
                let mut weights = tsit5::weights(s);
                for weight in &mut weights[1..] {
                    *weight *= h;
                }
                weights
            }
            Method::Dop853 => dop853::weights(s),
        }
    }
}

/// Rows that a segment's curve is a weighted sum of; each has a number for each state.
pub(crate) const ROWS: usize = 8;

/// How far a step may be wrong.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance {
    pub relative: f64,
    pub absolute: f64,
    pub controlled: usize,
}

impl Tolerance {
    #[inline(always)]
    pub(crate) fn scale(&self, a: f64, b: f64) -> f64 {
        self.absolute + self.relative * a.abs().max(b.abs())
    }
}

/// A step being tried.
pub(crate) trait Stepper<X: Storage> {
    const METHOD: Method;
    /// How often a trial asks the model, with the rate at its end.
    const EVALUATIONS: usize;
    /// Order of the error estimate: it grows as this power of the step.
    const ORDER: i32;
    /// Weight of the last error in the choice of the next step (PI control).
    const MEMORY: f64;
    /// Least and greatest factor from one step to the next.
    const FACTORS: (f64, f64);

    fn new(like: &X) -> Self;

    /// Tries a step `h` from `x`, whose rate of change is `dx`, and gives its error over what is tolerated;
    /// NaN or infinite where the model has no answer.
    fn attempt<D: Dynamics<State = X>>(
        &mut self,
        d: &mut D,
        start: &Start<'_, X>,
        h: f64,
        within: &Tolerance,
    ) -> f64;

    /// The rate of change at the end of the step, once it is accepted.
    fn accept<D: Dynamics<State = X>>(&mut self, d: &mut D, t_end: f64);

    fn end(&self) -> &X;
    fn end_rate(&self) -> &X;

    /// The [`ROWS`] rows of the accepted step's curve, in `room` where they are not at hand; and how often the model was
    /// asked for them.
    fn rows<'s, D: Dynamics<State = X>>(
        &'s mut self,
        d: &mut D,
        start: &Start<'s, X>,
        h: f64,
        room: &'s mut Vec<f64>,
    ) -> ([&'s [f64]; ROWS], usize);
}

/// Where a step starts.
pub(crate) struct Start<'a, X> {
    pub t: f64,
    pub x: &'a X,
    pub dx: &'a X,
}

/// `to = from + h Σ weight · k`
// Loops and no closures, which are not always inlined.
#[inline(always)]
pub(crate) fn combine<X: Storage, const M: usize>(
    to: &mut X,
    from: &X,
    h: f64,
    weights: [f64; M],
    k: [&X; M],
) {
    let to = to.as_mut();
    let n = to.len();
    let from = &from.as_ref()[..n];
    let k = slices(k, n);
    if n >= wide::WIDE {
        return lanes::dispatch(wide::Combine {
            to,
            from,
            h,
            weights,
            k,
        });
    }
    for i in 0..n {
        let mut sum = weights[0] * k[0][i];
        for m in 1..M {
            sum += weights[m] * k[m][i];
        }
        to[i] = from[i] + h * sum;
    }
}

/// The first `n` numbers of each.
#[inline(always)]
pub(crate) fn slices<X: Storage, const M: usize>(k: [&X; M], n: usize) -> [&[f64]; M] {
    let mut slices: [&[f64]; M] = [&[]; M];
    for m in 0..M {
        slices[m] = &k[m].as_ref()[..n];
    }
    slices
}
