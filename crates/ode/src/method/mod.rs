//! Explicit Runge–Kutta methods: one step, its error estimate and its dense output.

pub(crate) mod dop853;
mod dop853_table;
pub(crate) mod simd;
pub(crate) mod tableau;
pub(crate) mod tsit5;

use crate::rhs::{OdeRhs, StateVector};

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
    /// Butcher tableau of the method.
    pub(crate) fn tableau(self) -> &'static tableau::Tableau {
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
}

/// Number of coefficient vectors ("rows") of the dense output of one step, the same for Tsit5 and DOP853.
pub(crate) const ROWS: usize = 8;

/// Error tolerances of a step, and the number of state components that they apply to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ErrorTolerance {
    pub rtol: f64,
    pub atol: f64,
    /// Number of leading state components in the error norm.
    pub controlled_len: usize,
}

impl ErrorTolerance {
    /// Tolerated error `atol + rtol · max(|a|, |b|)` of a state component with the values `a` and `b` at the start and
    /// end of a step.
    #[inline(always)]
    pub(crate) fn scale(&self, a: f64, b: f64) -> f64 {
        self.atol + self.rtol * a.abs().max(b.abs())
    }
}

/// Start of a step: time, state and derivative.
pub(crate) struct StepStart<'a, X> {
    pub t: f64,
    pub x: &'a X,
    pub dx: &'a X,
}

/// Explicit Runge–Kutta stepper: computes the stages, error norm and dense output of a step.
pub(crate) trait Stepper<X: StateVector> {
    const METHOD: Method;
    /// Number of evaluations of the right-hand side per step, including the derivative at the end of the step.
    const EVALUATIONS: usize;
    /// Order q of the error estimate, which is proportional to h^q, where h is the step size.
    const ERROR_ORDER: i32;
    /// Exponent of the previous step's error norm in the PI step-size controller; 0 makes it an integral controller.
    const PI_BETA: f64;
    /// Minimum and maximum ratio of successive step sizes.
    const STEP_FACTOR_BOUNDS: (f64, f64);

    /// Creates the stepper and allocates its stage derivatives, each of the length of `like`.
    fn new(like: &X) -> Self;

    /// Computes a step of size `h` and returns its error norm, acceptable up to 1; NaN or infinite where the
    /// right-hand side is not finite.
    fn try_step<D: OdeRhs<State = X>>(
        &mut self,
        rhs: &mut D,
        start: &StepStart<'_, X>,
        h: f64,
        tolerance: &ErrorTolerance,
    ) -> f64;

    /// Completes an accepted step: computes the derivative at its end `t_end`, unless the last stage is that
    /// derivative (FSAL).
    fn accept<D: OdeRhs<State = X>>(&mut self, rhs: &mut D, t_end: f64);

    /// State at the end of the step that was tried last.
    fn x_end(&self) -> &X;
    /// Derivative at the end of an accepted step.
    fn dx_end(&self) -> &X;

    /// Dense-output rows (coefficient vectors) of an accepted step, and the number of right-hand side evaluations made
    /// to compute them; `buffer` stores rows that are not stage derivatives.
    fn dense_rows<'s, D: OdeRhs<State = X>>(
        &'s mut self,
        rhs: &mut D,
        start: &StepStart<'s, X>,
        h: f64,
        buffer: &'s mut Vec<f64>,
    ) -> ([&'s [f64]; ROWS], usize);
}

/// Computes the argument of a Runge–Kutta stage: `to = from + h Σ weight · k`, where `k` are derivatives computed by
/// earlier stages.
// Loops instead of iterator closures, which are not always inlined.
#[inline(always)]
pub(crate) fn combine<X: StateVector, const M: usize>(
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
    if n >= simd::MIN_SIMD_LEN {
        return simd::combine(to, from, h, &weights, &k);
    }
    for i in 0..n {
        let mut sum = weights[0] * k[0][i];
        for m in 1..M {
            sum += weights[m] * k[m][i];
        }
        to[i] = from[i] + h * sum;
    }
}

/// First `n` components of each vector in `k`, the stage derivatives.
#[inline(always)]
pub(crate) fn slices<X: StateVector, const M: usize>(k: [&X; M], n: usize) -> [&[f64]; M] {
    let mut slices: [&[f64]; M] = [&[]; M];
    for m in 0..M {
        slices[m] = &k[m].as_ref()[..n];
    }
    slices
}
