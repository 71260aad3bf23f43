//! Explicit Runge–Kutta methods: one step, its error estimate and its dense output.

pub(crate) mod dop853;
mod dop853_table;
pub(crate) mod simd;
pub(crate) mod tableau;
pub(crate) mod tsit5;

use crate::rhs::{OdeRhs, StateVector};
use tableau::Tableau;

/// Runge–Kutta method of an integration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// Tsitouras (2011), order 5 with dense output of order 4; efficient at tolerances of 1e-6 and looser.
    #[default]
    Tsit5,
    /// Dormand & Prince's method of order 8 with Hairer's dense output of order 7: for tight tolerances.
    Dop853,
}

impl Method {
    pub(crate) fn tableau(self) -> &'static Tableau {
        match self {
            Method::Tsit5 => &tsit5::TABLEAU,
            Method::Dop853 => &dop853::TABLEAU,
        }
    }

    /// Weights of the coefficient vectors of the dense output at the fraction `s` (0 to 1) of a step of size `h`.
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

    /// Derivatives of the [`weights`](Self::weights) by `s`.
    pub(crate) fn slopes(self, s: f64, h: f64) -> [f64; ROWS] {
        match self {
            Method::Tsit5 => tsit5::slopes(s).map(|slope| h * slope),
            Method::Dop853 => dop853::slopes(s),
        }
    }
}

/// Number of coefficient vectors ("rows") of the dense output of one step, the same for Tsit5 and DOP853.
pub(crate) const ROWS: usize = 8;

/// Stages of DOP853 with those of its dense output; Tsit5 has 7.
const MAX_STAGES: usize = 16;

/// Error tolerances of a step, and the number of state components that they apply to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ErrorTolerance {
    pub rtol: f64,
    pub atol: f64,
    /// Number of leading state components in the error norm.
    pub controlled_len: usize,
}

impl ErrorTolerance {
    /// Tolerated error `atol + rtol · max(|a|, |b|)` of a component with the values `a` and `b` at the ends of a step.
    #[inline(always)]
    pub(crate) fn scale(&self, a: f64, b: f64) -> f64 {
        self.atol + self.rtol * a.abs().max(b.abs())
    }
}

/// Explicit Runge–Kutta stepper: computes the stages, error norm and dense output of a step.
pub(crate) struct Stepper<X> {
    pub tableau: &'static Tableau,
    /// Stage derivatives; the first is that at the start. An array: a vector makes a short step a tenth slower.
    k: [X; MAX_STAGES],
    pub x: X,
    stage: X,
    end: X,
}

impl<X: StateVector> Stepper<X> {
    /// Stepper that starts at the state `x`, where the derivative is `dx`.
    pub fn new(method: Method, x: X, dx: X) -> Self {
        let tableau = method.tableau();
        Stepper {
            tableau,
            k: std::array::from_fn(|_| dx.clone()),
            stage: x.clone(),
            end: x.clone(),
            x,
        }
    }

    /// Index of the stage whose derivative is that at the end of the step.
    #[inline(always)]
    fn last(&self) -> usize {
        self.tableau.rows.len()
    }

    /// Computes a step of size `h` from the time `t` and returns its error norm, acceptable up to 1; NaN if not finite.
    #[inline(always)]
    pub fn try_step<D: OdeRhs<State = X>>(
        &mut self,
        rhs: &mut D,
        t: f64,
        h: f64,
        tolerance: &ErrorTolerance,
    ) -> f64 {
        let (k, x, to, end) = (&mut self.k[..], &self.x, &mut self.stage, &mut self.end);
        // Arrays and unrolled loops, so that lengths and weights are constants of the code.
        match self.tableau.method {
            Method::Tsit5 => {
                let k: &mut [X; 7] = k.first_chunk_mut().expect("seven stages");
                const TABLEAU: &Tableau = &tsit5::TABLEAU;
                stage(rhs, k, (to, x), (t, h), TABLEAU, 1);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 2);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 3);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 4);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 5);
                combine(end, x, h, TABLEAU.rows[5], k);
                rhs.derivative(t + h, end, &mut k[6]);
                tsit5::error_norm(k, (x, end), h, tolerance)
            }
            Method::Dop853 => {
                let k: &mut [X; 16] = k.first_chunk_mut().expect("sixteen stages");
                const TABLEAU: &Tableau = &dop853::TABLEAU;
                stage(rhs, k, (to, x), (t, h), TABLEAU, 1);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 2);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 3);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 4);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 5);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 6);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 7);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 8);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 9);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 10);
                stage(rhs, k, (to, x), (t, h), TABLEAU, 11);
                combine(end, x, h, TABLEAU.rows[11], k);
                dop853::error_norm(k, (x, end), h, tolerance)
            }
        }
    }

    /// Completes an accepted step: computes the derivative at its end `t_end`, unless the error norm needed it.
    #[inline(always)]
    pub fn accept<D: OdeRhs<State = X>>(&mut self, rhs: &mut D, t_end: f64) {
        let last = self.last();
        if self.tableau.method == Method::Dop853 {
            rhs.derivative(t_end, &self.end, &mut self.k[last]);
        }
    }

    /// Makes the end of the accepted step the start of the next.
    #[inline(always)]
    pub fn advance(&mut self) {
        let last = self.last();
        self.x.clone_from(&self.end);
        let (first, others) = self.k.split_at_mut(1);
        first[0].clone_from(&others[last - 1]);
    }

    /// State at the end of the step that was tried last.
    #[inline(always)]
    pub fn x_end(&self) -> &X {
        &self.end
    }

    /// Derivative at the start of the step.
    #[inline(always)]
    pub fn dx(&self) -> &X {
        &self.k[0]
    }

    /// State and derivative at the start of the step, to compute the derivative anew.
    pub fn start_mut(&mut self) -> (&mut X, &mut X) {
        (&mut self.x, &mut self.k[0])
    }

    /// Derivative at the end of an accepted step.
    #[inline(always)]
    pub fn dx_end(&self) -> &X {
        &self.k[self.last()]
    }

    /// Dense-output rows of an accepted step; `buffer` stores rows that are not stage derivatives.
    #[inline(always)]
    pub fn dense_rows<'s, D: OdeRhs<State = X>>(
        &'s mut self,
        rhs: &mut D,
        (t, h): (f64, f64),
        buffer: &'s mut Vec<f64>,
    ) -> [&'s [f64]; ROWS] {
        let (first, tableau) = (self.tableau.stages(), self.tableau);
        for (s, row) in (first..).zip(tableau.dense_rows) {
            combine(&mut self.stage, &self.x, h, row, &self.k);
            rhs.derivative(t + tableau.c[s] * h, &self.stage, &mut self.k[s]);
        }
        let mut rows = [self.x.as_ref(); ROWS];
        match tableau.method {
            Method::Tsit5 => {
                for (row, k) in rows[1..].iter_mut().zip(&self.k) {
                    *row = k.as_ref();
                }
            }
            Method::Dop853 => {
                dop853::dense_rows(&self.k, (&self.x, &self.end), h, buffer);
                let n = rows[0].len();
                rows = std::array::from_fn(|row| &buffer[row * n..][..n]);
            }
        }
        rows
    }
}

/// Evaluates the stage `s` of a step of size `h` from the time `t` and the state `from`, with the argument `to`.
#[inline(always)]
fn stage<X: StateVector, D: OdeRhs<State = X>, const N: usize>(
    rhs: &mut D,
    k: &mut [X; N],
    (to, from): (&mut X, &X),
    (t, h): (f64, f64),
    tableau: &Tableau,
    s: usize,
) {
    combine(to, from, h, tableau.rows[s - 1], k);
    rhs.derivative(t + tableau.c[s] * h, to, &mut k[s]);
}

/// Maximum number of nonzero weights in a row of the Runge–Kutta matrices.
const MAX_WEIGHTS: usize = 9;

/// Argument of a stage: `to = from + h Σ weight · k`, with derivatives `k` of earlier stages weighted by `row`.
#[inline(always)]
pub(crate) fn combine<X: StateVector>(to: &mut X, from: &X, h: f64, row: &[(usize, f64)], k: &[X]) {
    match row.len() {
        1 => sum::<X, 1>(to, from, h, row, k),
        2 => sum::<X, 2>(to, from, h, row, k),
        3 => sum::<X, 3>(to, from, h, row, k),
        4 => sum::<X, 4>(to, from, h, row, k),
        5 => sum::<X, 5>(to, from, h, row, k),
        6 => sum::<X, 6>(to, from, h, row, k),
        7 => sum::<X, 7>(to, from, h, row, k),
        8 => sum::<X, 8>(to, from, h, row, k),
        _ => sum::<X, MAX_WEIGHTS>(to, from, h, row, k),
    }
}

/// [`combine`] for a row of `M` weights.
// Loops instead of iterator closures, which are not always inlined.
#[inline(always)]
fn sum<X: StateVector, const M: usize>(
    to: &mut X,
    from: &X,
    h: f64,
    row: &[(usize, f64)],
    k: &[X],
) {
    let to = to.as_mut();
    let n = to.len();
    let from = &from.as_ref()[..n];
    let (mut weights, mut stages) = ([0.0; M], [&[] as &[f64]; M]);
    for m in 0..M {
        (weights[m], stages[m]) = (row[m].1, &k[row[m].0].as_ref()[..n]);
    }
    if n >= simd::MIN_SIMD_LEN {
        return simd::combine(to, from, h, &weights, &stages);
    }
    for i in 0..n {
        let mut sum = weights[0] * stages[0][i];
        for m in 1..M {
            sum += weights[m] * stages[m][i];
        }
        to[i] = from[i] + h * sum;
    }
}

/// First `n` components of the first `M` stage derivatives.
#[inline(always)]
fn slices<X: StateVector, const M: usize>(k: &[X], n: usize) -> [&[f64]; M] {
    let mut slices: [&[f64]; M] = [&[]; M];
    for m in 0..M {
        slices[m] = &k[m].as_ref()[..n];
    }
    slices
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_the_derivatives_of_the_weights() {
        for method in [Method::Tsit5, Method::Dop853] {
            for k in 0..=10 {
                let (s, d) = (0.1 * f64::from(k), 1e-5);
                let [below, above] = [s - d, s + d].map(|s| method.weights(s, 0.7));
                for (row, slope) in method.slopes(s, 0.7).into_iter().enumerate() {
                    let expected = (above[row] - below[row]) / (2.0 * d);
                    assert!((slope - expected).abs() < 1e-7, "{method:?} {row} at {s}");
                }
            }
        }
    }
}
