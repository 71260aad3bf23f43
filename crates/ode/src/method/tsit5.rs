//! Tsit5 method of Ch. Tsitouras, "Runge–Kutta pairs of order 5(4) satisfying only the first column simplifying
//! assumption", Computers & Mathematics with Applications 62 (2011).

use super::tableau::Tableau;
use super::{ErrorTolerance, Method, ROWS, slices};
use crate::rhs::StateVector;

/// Nodes: time of each stage as a fraction of the step.
pub(crate) const C: [f64; 7] = [0.0, 0.161, 0.327, 0.9, 0.9800255409045097, 1.0, 1.0];
/// Row of the Runge–Kutta matrix for stage 2 (stages counted from 1); A2 to A5 are the rows for stages 3 to 6.
const A1: [f64; 1] = [0.161];
const A2: [f64; 2] = [-0.008480655492356989, 0.335480655492357];
const A3: [f64; 3] = [2.8971530571054935, -6.359448489975075, 4.3622954328695815];
const A4: [f64; 4] = [
    5.325864828439257,
    -11.748883564062828,
    7.4955393428898365,
    -0.09249506636175525,
];
const A5: [f64; 5] = [
    5.86145544294642,
    -12.92096931784711,
    8.159367898576159,
    -0.071584973281401,
    -0.028269050394068383,
];
/// Weights of the stages in the state at the end of the step, of order 5.
pub(crate) const B: [f64; 6] = [
    0.09646076681806523,
    0.01,
    0.4798896504144996,
    1.379008574103742,
    -3.290069515436081,
    2.324710524099774,
];
/// Weights of the error estimate: those of the step minus those of the embedded method of order 4.
pub(crate) const E: [f64; 7] = [
    -0.001_780_011_052_225_777,
    -0.0008164344596567469,
    0.007880878010261995,
    -0.1447110071732629,
    0.5823571654525552,
    -0.45808210592918697,
    0.015151515151515152,
];

/// Sparse form, (stage index, weight) of each element, of a row of the Butcher tableau that contains no zeros.
const fn row<const M: usize>(weights: [f64; M]) -> [(usize, f64); M] {
    let mut row = [(0, 0.0); M];
    let mut s = 0;
    while s < M {
        row[s] = (s, weights[s]);
        s += 1;
    }
    row
}

pub(crate) const TABLEAU: Tableau = Tableau {
    method: Method::Tsit5,
    c: &C,
    rows: &[&row(A1), &row(A2), &row(A3), &row(A4), &row(A5), &row(B)],
    dense_rows: &[],
    errors: &[&row(E)],
    error_order: 5,
    pi_beta: 0.04,
    step_factor_bounds: (0.2, 10.0),
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
    let k: [&[f64]; 7] = slices(k, n);
    let (x, end) = (&x.as_ref()[..n], &end.as_ref()[..n]);
    // Four independent partial sums, for instruction-level parallelism.
    let mut sums = [0.0; 4];
    for i in 0..n {
        let mut error = E[0] * k[0][i];
        for m in 1..7 {
            error += E[m] * k[m][i];
        }
        let scaled = error / tolerance.scale(x[i], end[i]);
        sums[i % 4] += scaled * scaled;
    }
    h * (((sums[0] + sums[1]) + (sums[2] + sums[3])) / n as f64).sqrt()
}

/// Weights of the coefficient vectors of the dense output at the fraction `s` of the step, for the order-4 interpolant,
/// which needs no additional stages. The caller must multiply all weights but the first by the step size.
pub(crate) fn weights(s: f64) -> [f64; ROWS] {
    let mut weights = [1.0; ROWS];
    for (weight, [a, b, c, d]) in weights[1..].iter_mut().zip(INTERPOLANT) {
        *weight = s * (a + s * (b + s * (c + s * d)));
    }
    weights
}

/// Derivatives of the [`weights`] by `s`, without the factor of the step size.
pub(crate) fn slopes(s: f64) -> [f64; ROWS] {
    let mut slopes = [0.0; ROWS];
    for (slope, [a, b, c, d]) in slopes[1..].iter_mut().zip(INTERPOLANT) {
        *slope = a + s * (2.0 * b + s * (3.0 * c + s * 4.0 * d));
    }
    slopes
}

/// Weight of each stage in the order-4 interpolant: coefficients of s, s², s³ and s⁴, the fraction s of the step.
pub(crate) const INTERPOLANT: [[f64; 4]; ROWS - 1] = [
    first_weight(),
    even_weight(0.1017, 2.196_656_833_824_975_4, 1.294_985_250_737_463),
    even_weight(
        2.490_627_285_651_253,
        2.385_356_454_720_616_5,
        1.578_034_682_080_924_8,
    ),
    zeros_weight(
        -16.548_102_889_244_902,
        1.217_129_272_955_332_5,
        0.616_204_060_378_000_9,
    ),
    zeros_weight(
        47.379_521_962_819_28,
        1.203_071_208_372_362_7,
        0.658_047_292_653_547_3,
    ),
    zeros_weight(-34.870_657_861_496_61, 1.2, 2.0 / 3.0),
    zeros_weight(2.5, 1.0, 0.6),
];

/// Coefficients of s, s², s³ and s⁴ in the dense-output weight a s (s - b) (s² - c s + d) of the first stage, where s
/// is the fraction of the step and a to d are constants of the method.
const fn first_weight() -> [f64; 4] {
    let (a, b) = (-1.0530884977290216, 1.329_989_018_975_141);
    let (c, d) = (1.4364028541716351, 0.7139816917074209);
    [-a * b * d, a * (d + b * c), -a * (b + c), a]
}

/// Coefficients of s, s², s³ and s⁴ in a stage's dense-output weight a s² (s² - c s + d).
const fn even_weight(a: f64, c: f64, d: f64) -> [f64; 4] {
    [0.0, a * d, -a * c, a]
}

/// Coefficients of s, s², s³ and s⁴ in a stage's dense-output weight a s² (s - b) (s - c).
const fn zeros_weight(a: f64, b: f64, c: f64) -> [f64; 4] {
    even_weight(a, b + c, b * c)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_satisfy_the_order_conditions_up_to_5() {
        let a: [&[f64]; 7] = [&[], &A1, &A2, &A3, &A4, &A5, &B];
        for (row, c) in a.iter().zip(C) {
            assert!((row.iter().sum::<f64>() - c).abs() < 1e-14);
        }
        let close = |value: f64, expected: f64| {
            assert!((value - expected).abs() < 3e-15, "{value}, not {expected}");
        };
        let sum = |f: &dyn Fn(usize) -> f64| (0..6).map(|i| B[i] * f(i)).sum::<f64>();
        let below = |i: usize, f: &dyn Fn(usize) -> f64| {
            a[i].iter().enumerate().map(|(j, a)| a * f(j)).sum::<f64>()
        };
        for power in 0..5 {
            close(sum(&|i| C[i].powi(power)), 1.0 / f64::from(power + 1));
        }
        close(sum(&|i| below(i, &|j| C[j])), 1.0 / 6.0);
        close(sum(&|i| C[i] * below(i, &|j| C[j])), 1.0 / 8.0);
        close(sum(&|i| below(i, &|j| C[j] * C[j])), 1.0 / 12.0);
        close(sum(&|i| below(i, &|j| below(j, &|k| C[k]))), 1.0 / 24.0);
        close(E.iter().sum(), 0.0);
        close(E.iter().zip(C).map(|(e, c)| e * c.powi(3)).sum(), 0.0);
        // The interpolant meets the ends of the step.
        for (weight, b) in weights(1.0)[1..].iter().zip(B.into_iter().chain([0.0])) {
            assert!((weight - b).abs() < 3e-14);
        }
        assert_eq!(weights(0.0)[1..], [0.0; 7]);
    }
}
