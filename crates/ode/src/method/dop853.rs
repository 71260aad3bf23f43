//! DOP853 (Hairer, Nørsett & Wanner, II.5): order 8, error estimates of orders 5 and 3, dense output of order 7.

use super::dop853_table::*;
use super::tableau::{Row, Tableau};
use super::{ErrorTolerance, Method, ROWS, StepStart, Stepper, slices};
use crate::rhs::{OdeRhs, StateVector};

/// Butcher tableau of the Runge–Kutta method DOP853, of order 8.
pub(crate) static TABLEAU: Tableau = Tableau {
    method: Method::Dop853,
    c: &C,
    rows: &[&A1, &A2, &A3, &A4, &A5, &A6, &A7, &A8, &A9, &A10, &A11, &B],
    dense_rows: &[&A13, &A14, &A15],
    errors: &[&E5, &E3],
    error_order: ERROR_ORDER,
    pi_beta: PI_BETA,
    step_factor_bounds: STEP_FACTOR_BOUNDS,
};

/// Weights of the stages in each of the last four of the eight coefficient vectors of the dense output.
pub(crate) static DENSE: [Row; 4] = [&D0, &D1, &D2, &D3];

/// Order q of the error estimate, which is proportional to h^q, where h is the step size.
const ERROR_ORDER: i32 = 8;
/// Exponent of the previous step's error norm in the PI step-size controller.
const PI_BETA: f64 = 0.0;
/// Minimum and maximum ratio of successive step sizes.
const STEP_FACTOR_BOUNDS: (f64, f64) = (0.333, 6.0);

/// Stage derivatives of a step: twelve, the derivative at the end, and three more for dense output.
pub(crate) struct Dop853<X> {
    k: [X; 16],
    stage: X,
    end: X,
}

/// Computes the argument of a Runge–Kutta stage with sparse weights: `to = from + h Σ weight · k[stage]`, where `k`
/// contains the stage derivatives.
#[inline(always)]
fn combine<X: StateVector, const M: usize>(
    to: &mut X,
    from: &X,
    h: f64,
    k: &[X; 16],
    terms: Terms<M>,
) {
    let (mut weights, mut stages) = ([0.0; M], [&k[0]; M]);
    for m in 0..M {
        (stages[m], weights[m]) = (&k[terms[m].0], terms[m].1);
    }
    super::combine(to, from, h, weights, stages);
}

impl<X: StateVector> Stepper<X> for Dop853<X> {
    const METHOD: Method = Method::Dop853;
    const EVALUATIONS: usize = 12;
    const ERROR_ORDER: i32 = ERROR_ORDER;
    const PI_BETA: f64 = PI_BETA;
    const STEP_FACTOR_BOUNDS: (f64, f64) = STEP_FACTOR_BOUNDS;

    fn new(like: &X) -> Self {
        Dop853 {
            k: std::array::from_fn(|_| like.clone()),
            stage: like.clone(),
            end: like.clone(),
        }
    }

    #[inline(always)]
    fn try_step<D: OdeRhs<State = X>>(
        &mut self,
        rhs: &mut D,
        start: &StepStart<'_, X>,
        h: f64,
        tolerance: &ErrorTolerance,
    ) -> f64 {
        let StepStart { t, x, dx } = *start;
        let Dop853 { k, stage, end } = self;
        k[0].clone_from(dx);
        macro_rules! stages {
            ($($s:literal $terms:ident)*) => {$(
                combine(stage, x, h, k, $terms);
                rhs.derivative(t + C[$s] * h, stage, &mut k[$s]);
            )*};
        }
        stages!(1 A1 2 A2 3 A3 4 A4 5 A5 6 A6 7 A7 8 A8 9 A9 10 A10 11 A11);
        combine(end, x, h, k, B);

        let n = x.as_ref().len().min(tolerance.controlled_len);
        let k = slices(k.each_ref(), n);
        let (x, end) = (&x.as_ref()[..n], &end.as_ref()[..n]);
        let (mut sum_5, mut sum_3) = (0.0, 0.0);
        for i in 0..n {
            let scale = tolerance.scale(x[i], end[i]);
            let (mut error_5, mut error_3) = (0.0, 0.0);
            for (stage, weight) in E5 {
                error_5 += weight * k[stage][i];
            }
            for (stage, weight) in E3 {
                error_3 += weight * k[stage][i];
            }
            (error_5, error_3) = (error_5 / scale, error_3 / scale);
            sum_5 += error_5 * error_5;
            sum_3 += error_3 * error_3;
        }
        let sum_of_both = sum_5 + 0.01 * sum_3;
        if sum_of_both == 0.0 {
            0.0
        } else {
            h * sum_5 / (sum_of_both * n as f64).sqrt()
        }
    }

    #[inline(always)]
    fn accept<D: OdeRhs<State = X>>(&mut self, rhs: &mut D, t_end: f64) {
        rhs.derivative(t_end, &self.end, &mut self.k[12]);
    }

    #[inline(always)]
    fn x_end(&self) -> &X {
        &self.end
    }

    #[inline(always)]
    fn dx_end(&self) -> &X {
        &self.k[12]
    }

    #[inline(always)]
    fn dense_rows<'s, D: OdeRhs<State = X>>(
        &'s mut self,
        rhs: &mut D,
        start: &StepStart<'s, X>,
        h: f64,
        buffer: &'s mut Vec<f64>,
    ) -> ([&'s [f64]; ROWS], usize) {
        let StepStart { t, x, dx } = *start;
        let Dop853 { k, stage, end } = self;
        combine(stage, x, h, k, A13);
        rhs.derivative(t + C[13] * h, stage, &mut k[13]);
        combine(stage, x, h, k, A14);
        rhs.derivative(t + C[14] * h, stage, &mut k[14]);
        combine(stage, x, h, k, A15);
        rhs.derivative(t + C[15] * h, stage, &mut k[15]);

        let (x, dx, end, dx_end) = (x.as_ref(), dx.as_ref(), end.as_ref(), k[12].as_ref());
        let n = x.len();
        let to = &mut *buffer;
        to.clear();
        to.extend_from_slice(x);
        to.extend((0..n).map(|i| end[i] - x[i]));
        to.extend((0..n).map(|i| h * dx[i] - (end[i] - x[i])));
        to.extend((0..n).map(|i| 2.0 * (end[i] - x[i]) - h * (dx_end[i] + dx[i])));
        append_row(to, h, k, D0);
        append_row(to, h, k, D1);
        append_row(to, h, k, D2);
        append_row(to, h, k, D3);
        (std::array::from_fn(|row| &buffer[row * n..][..n]), 3)
    }
}

/// Appends to `to` a coefficient vector of the dense output, `h Σ weight · k[stage]`; `k` contains the stage
/// derivatives.
#[inline(always)]
fn append_row<X: StateVector, const M: usize>(
    to: &mut Vec<f64>,
    h: f64,
    k: &[X; 16],
    terms: Terms<M>,
) {
    let n = k[0].as_ref().len();
    let k = slices(k.each_ref(), n);
    to.extend((0..n).map(|i| {
        let mut sum = 0.0;
        for (stage, weight) in terms {
            sum += weight * k[stage][i];
        }
        h * sum
    }));
}

/// Weights of the coefficient vectors of the order-7 interpolant at the fraction `s` of the step: 1, s, s (1 - s),
/// s² (1 - s), s² (1 - s)², … Each weight is the preceding one times `s` and `1 - s` in turn.
pub(crate) fn weights(s: f64) -> [f64; ROWS] {
    let r = 1.0 - s;
    let sr = s * r;
    [
        1.0,
        s,
        sr,
        s * sr,
        sr * sr,
        s * sr * sr,
        sr * sr * sr,
        s * sr * sr * sr,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_are_consistent() {
        let rows: [&[(usize, f64)]; 15] = [
            &A1, &A2, &A3, &A4, &A5, &A6, &A7, &A8, &A9, &A10, &A11, &B, &A13, &A14, &A15,
        ];
        for (i, row) in rows.iter().enumerate() {
            // Simplifying conditions: a row's sum is c, and from the second on its first moment c²/2.
            let moment = |power| row.iter().map(|(j, a)| a * C[*j].powi(power)).sum::<f64>();
            let c = C[i + 1];
            assert!((moment(0) - c).abs() < 1e-14 * (1.0 + c), "row {}", i + 1);
            assert!(
                i == 0 || (moment(1) - c * c / 2.0).abs() < 2e-14,
                "row {}",
                i + 1
            );
        }
        for power in 0..8 {
            let sum: f64 = B.iter().map(|(i, b)| b * C[*i].powi(power)).sum();
            assert!(
                (sum - 1.0 / f64::from(power + 1)).abs() < 1e-14,
                "t^{power}"
            );
        }
        for power in 0..5 {
            let moment =
                |e: &[(usize, f64)]| e.iter().map(|(i, e)| e * C[*i].powi(power)).sum::<f64>();
            assert!(power >= 3 || moment(&E3).abs() < 1e-14, "t^{power}");
            assert!(moment(&E5).abs() < 1e-14, "t^{power}");
        }
    }
}
