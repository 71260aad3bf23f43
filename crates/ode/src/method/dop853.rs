//! DOP853 (Hairer, Nørsett & Wanner, II.5): order 8, error estimates of orders 5 and 3, dense output of order 7.

pub(crate) use super::dop853_table::DENSE;
use super::dop853_table::{C, DENSE_ROWS, E3, E5, ROWS as STAGES};
use super::tableau::Tableau;
use super::{ErrorTolerance, Method, ROWS, slices};
use crate::rhs::StateVector;

pub(crate) const TABLEAU: Tableau = Tableau {
    method: Method::Dop853,
    c: &C,
    rows: &STAGES,
    dense_rows: &DENSE_ROWS,
    errors: &[&E5, &E3],
    error_order: 8,
    pi_beta: 0.0,
    step_factor_bounds: (0.333, 6.0),
};

/// Error norm of a step of size `h` from `x` to `end` with the stage derivatives `k`.
#[inline(always)]
pub(crate) fn error_norm<X: StateVector>(
    k: &[X],
    (x, end): (&X, &X),
    h: f64,
    tolerance: &ErrorTolerance,
) -> f64 {
    let n = x.as_ref().len().min(tolerance.controlled_len);
    let k: [&[f64]; 12] = slices(k, n);
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

/// Writes the coefficient vectors of the dense output of a step of size `h` from `x` to `end` to `to`, one after
/// another; `k` contains all stage derivatives.
#[inline(always)]
pub(crate) fn dense_rows<X: StateVector>(k: &[X], (x, end): (&X, &X), h: f64, to: &mut Vec<f64>) {
    let (x, end) = (x.as_ref(), end.as_ref());
    let n = x.len();
    let k: [&[f64]; 16] = slices(k, n);
    let (dx, dx_end) = (k[0], k[12]);
    to.clear();
    to.extend_from_slice(x);
    to.extend((0..n).map(|i| end[i] - x[i]));
    to.extend((0..n).map(|i| h * dx[i] - (end[i] - x[i])));
    to.extend((0..n).map(|i| 2.0 * (end[i] - x[i]) - h * (dx_end[i] + dx[i])));
    for row in &DENSE {
        to.extend((0..n).map(|i| {
            let mut sum = 0.0;
            for (stage, weight) in row {
                sum += weight * k[*stage][i];
            }
            h * sum
        }));
    }
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

/// Derivatives of the [`weights`] by `s`.
pub(crate) fn slopes(s: f64) -> [f64; ROWS] {
    let (sr, d) = (s * (1.0 - s), 1.0 - 2.0 * s);
    let [one, two] = [2.0 * sr * d, 3.0 * sr * sr * d];
    [
        0.0,
        1.0,
        d,
        sr + s * d,
        one,
        sr * sr + s * one,
        two,
        sr * sr * sr + s * two,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_are_consistent() {
        for (i, row) in STAGES.iter().chain(&DENSE_ROWS).enumerate() {
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
            let sum: f64 = STAGES[11].iter().map(|(i, b)| b * C[*i].powi(power)).sum();
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
