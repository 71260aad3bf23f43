//! Piecewise cubic functions of tables: cubic splines and monotone interpolation.

use lanes::Real;
use model_spec::model::{Continuation, Interpolation, Table};

/// A piecewise cubic function, given by its knots and by the coefficients of one cubic for each interval.
#[derive(Clone, Debug, PartialEq)]
pub struct PiecewiseCubic {
    knots: Vec<f64>,
    cubics: Vec<[f64; 4]>,
}

impl PiecewiseCubic {
    /// A piecewise cubic of increasing knots and one cubic more, see [`PiecewiseCubic::cubics`].
    pub fn new(knots: Vec<f64>, cubics: Vec<[f64; 4]>) -> PiecewiseCubic {
        PiecewiseCubic { knots, cubics }
    }

    /// Interpolates a table by its interpolation rule and continues it beyond the end knots by its continuation rule.
    pub fn of(table: &Table) -> PiecewiseCubic {
        Self::through(&table.points(), table.interpolation, table.continuation)
    }

    /// Interpolates at least two knots (argument, value) with increasing arguments.
    pub fn through(
        knots: &[(f64, f64)],
        interpolation: Interpolation,
        continuation: Continuation,
    ) -> PiecewiseCubic {
        let is_flat = continuation == Continuation::Constant;
        match interpolation {
            Interpolation::Spline => spline(knots, is_flat),
            Interpolation::Monotone => monotone(knots, is_flat),
            Interpolation::Linear => lines(knots, is_flat),
        }
    }

    /// Natural cubic spline through at least two knots (argument, value) with increasing arguments.
    pub fn natural_spline(knots: &[(f64, f64)]) -> PiecewiseCubic {
        spline(knots, false)
    }

    /// Straight lines between at least two knots (argument, value) with increasing arguments.
    pub fn linear(knots: &[(f64, f64)]) -> PiecewiseCubic {
        lines(knots, false)
    }

    /// The value of each of at least one knot (argument, value), from its argument up to the next one.
    pub fn hold(knots: &[(f64, f64)]) -> PiecewiseCubic {
        let values = knots.iter().map(|(_, value)| [*value, 0.0, 0.0, 0.0]);
        let first = values.clone().take(1);
        PiecewiseCubic {
            knots: knots.iter().map(|knot| knot.0).collect(),
            cubics: first.chain(values).collect(),
        }
    }

    /// Argument values at the knots, in increasing order.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// Coefficients of powers 0 to 3 of the distance from the knot below, first below the first knot.
    pub fn cubics(&self) -> &[[f64; 4]] {
        &self.cubics
    }

    /// Derivative of the function with respect to its argument.
    pub fn derivative(&self) -> PiecewiseCubic {
        let of = |&[_, b, c, d]: &[f64; 4]| [b, 2.0 * c, 3.0 * d, 0.0];
        PiecewiseCubic {
            knots: self.knots.clone(),
            cubics: self.cubics.iter().map(of).collect(),
        }
    }

    /// Origin and coefficients of the cubic that applies at `x`.
    pub fn piece(&self, x: f64) -> (f64, [f64; 4]) {
        let below = self.knots.partition_point(|&knot| knot <= x);
        (self.knots[below.saturating_sub(1)], self.cubics[below])
    }

    /// Evaluates the function at `x`.
    #[inline(always)]
    pub fn eval<T: Real>(&self, x: T) -> T {
        x.piecewise_cubic(&self.knots, &self.cubics)
    }
}

/// Straight lines between the knots.
fn lines(knots: &[(f64, f64)], is_flat: bool) -> PiecewiseCubic {
    let slopes = knots.windows(2).map(|pair| {
        let [(x, a), (y, b)] = [pair[0], pair[1]];
        [a, (b - a) / (y - x), 0.0, 0.0]
    });
    let pieces: Vec<_> = slopes.collect();
    let last = pieces[pieces.len() - 1][1];
    continued(knots, pieces, last, is_flat)
}

/// Cubic spline; at the ends the slope is 0 if `is_flat`, else the second derivative is.
fn spline(knots: &[(f64, f64)], is_flat: bool) -> PiecewiseCubic {
    let n = knots.len();
    let width = |k: usize| knots[k + 1].0 - knots[k].0;
    let slope = |k: usize| (knots[k + 1].1 - knots[k].1) / width(k);
    // Rows (subdiagonal, diagonal, superdiagonal, right-hand side) of a tridiagonal system, solved by elimination.
    let row = |k: usize| match (k, is_flat) {
        (0, true) => (0.0, 2.0 * width(0), width(0), 6.0 * slope(0)),
        (_, true) if k == n - 1 => (width(n - 2), 2.0 * width(n - 2), 0.0, -6.0 * slope(n - 2)),
        _ if k == 0 || k == n - 1 => (0.0, 1.0, 0.0, 0.0),
        _ => {
            let sum = width(k - 1) + width(k);
            (
                width(k - 1),
                2.0 * sum,
                width(k),
                6.0 * (slope(k) - slope(k - 1)),
            )
        }
    };
    let (mut diagonal, mut value) = (vec![0.0; n], vec![0.0; n]);
    for k in 0..n {
        let (below, middle, _, right) = row(k);
        (diagonal[k], value[k]) = (middle, right);
        if k > 0 {
            let factor = below / diagonal[k - 1];
            diagonal[k] -= factor * row(k - 1).2;
            value[k] -= factor * value[k - 1];
        }
    }
    let mut second = vec![0.0; n];
    for k in (0..n).rev() {
        let above = second.get(k + 1).map_or(0.0, |next| row(k).2 * next);
        second[k] = (value[k] - above) / diagonal[k];
    }
    let cubic = |k: usize| {
        let (h, a, b) = (width(k), second[k], second[k + 1]);
        [
            knots[k].1,
            slope(k) - h * (2.0 * a + b) / 6.0,
            a / 2.0,
            (b - a) / (6.0 * h),
        ]
    };
    let end_slope = {
        let h = width(n - 2);
        slope(n - 2) + h * (second[n - 2] + 2.0 * second[n - 1]) / 6.0
    };
    continued(knots, (0..n - 1).map(cubic).collect(), end_slope, is_flat)
}

/// Monotone cubic (Fritsch and Butland 1984); at the ends the slope is 0 if `is_flat`.
fn monotone(knots: &[(f64, f64)], is_flat: bool) -> PiecewiseCubic {
    let n = knots.len();
    let width = |k: usize| knots[k + 1].0 - knots[k].0;
    let mean = |k: usize| (knots[k + 1].1 - knots[k].1) / width(k);
    let end = |at: usize, next: usize| {
        if n == 2 {
            return if is_flat { 0.0 } else { mean(0) };
        }
        let (h, s, t) = (width(at), mean(at), mean(next));
        let sum = h + width(next);
        let slope = ((h + sum) * s - h * t) / sum;
        if is_flat || slope * s <= 0.0 {
            0.0
        } else if s * t <= 0.0 && slope.abs() > (3.0 * s).abs() {
            3.0 * s
        } else {
            slope
        }
    };
    let slope = |k: usize| match k {
        0 => end(0, 1),
        _ if k == n - 1 => end(n - 2, n.saturating_sub(3)),
        _ if mean(k - 1) * mean(k) <= 0.0 => 0.0,
        _ => {
            let (before, behind) = (width(k - 1), width(k));
            let weights = (2.0 * behind + before, behind + 2.0 * before);
            (weights.0 + weights.1) / (weights.0 / mean(k - 1) + weights.1 / mean(k))
        }
    };
    let cubic = |k: usize| {
        let (h, s, a, b) = (width(k), mean(k), slope(k), slope(k + 1));
        let second = (3.0 * s - 2.0 * a - b) / h;
        [knots[k].1, a, second, (a + b - 2.0 * s) / (h * h)]
    };
    continued(
        knots,
        (0..n - 1).map(cubic).collect(),
        slope(n - 1),
        is_flat,
    )
}

/// Adds straight lines beyond the knots, horizontal if `is_flat`.
fn continued(
    knots: &[(f64, f64)],
    inner: Vec<[f64; 4]>,
    end_slope: f64,
    is_flat: bool,
) -> PiecewiseCubic {
    let line = |value: f64, slope: f64| [value, if is_flat { 0.0 } else { slope }, 0.0, 0.0];
    let first = line(knots[0].1, inner[0][1]);
    let last = line(knots[knots.len() - 1].1, end_slope);
    PiecewiseCubic {
        knots: knots.iter().map(|knot| knot.0).collect(),
        cubics: [first].into_iter().chain(inner).chain([last]).collect(),
    }
}
