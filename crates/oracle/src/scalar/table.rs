//! Tables of a model, interpolated by Hermite cubics.
//!
//! The curve is that of the compiler, computed in a different way: the unknowns are the slopes at the knots, not the
//! second derivatives.

use super::Real;
use model_spec::model::{Continuation, Interpolation, Table};

/// Interpolated table (piecewise cubic curve): the knots, and the slopes of the curve at the knots.
#[derive(Clone, Debug)]
pub struct Interpolant<'a> {
    table: &'a Table,
    knots: Vec<(f64, f64)>,
    /// Slopes at the knots; empty for straight lines between them.
    slopes: Vec<f64>,
    is_flat: bool,
}

impl<'a> Interpolant<'a> {
    /// Creates the interpolating curve of a table of one argument that a model declares.
    pub fn new(table: &'a Table) -> Self {
        Self::through(table.points(), table)
    }

    /// Creates the curve through knots (argument, value) by the rules of a table.
    pub(super) fn through(knots: Vec<(f64, f64)>, table: &'a Table) -> Self {
        let is_flat = table.continuation == Continuation::Constant;
        let slopes = match table.interpolation {
            Interpolation::Spline => spline_slopes(&knots, is_flat),
            Interpolation::Monotone if knots.len() > 2 => monotone_slopes(&knots, is_flat),
            Interpolation::Monotone if is_flat => vec![0.0; 2],
            Interpolation::Monotone => vec![intervals(&knots)[0].1; 2],
            Interpolation::Linear => Vec::new(),
        };
        Self {
            table,
            knots,
            slopes,
            is_flat,
        }
    }

    /// Hash of the interpolated curve ([`Table::fingerprint`]); most evaluations need none.
    pub fn fingerprint(&self) -> u64 {
        self.table.fingerprint()
    }

    /// Value of the polygon through the knots at `x` (`order` 0), or its derivative of the given order.
    fn on_lines<T: Real>(&self, x: T, order: u8) -> T {
        let last = self.knots.len() - 1;
        let at = x.re();
        let is_beyond = at < self.knots[0].0 || at >= self.knots[last].0;
        let behind = self.knots.iter().filter(|knot| knot.0 <= at).count();
        let right = behind.clamp(1, last);
        let ((x0, y0), (x1, y1)) = (self.knots[right - 1], self.knots[right]);
        let (x0, x1, y0, y1) = (T::lit(x0), T::lit(x1), T::lit(y0), T::lit(y1));
        match order {
            0 if is_beyond && self.is_flat => {
                if at < self.knots[0].0 {
                    y0
                } else {
                    y1
                }
            }
            0 => (y0 * (x1 - x) + y1 * (x - x0)) / (x1 - x0),
            1 if is_beyond && self.is_flat => T::zero(),
            1 => (y1 - y0) / (x1 - x0),
            _ => T::zero(),
        }
    }

    /// Value of the interpolated curve at `x` (`order` 0), or its derivative of the given order.
    pub fn at<T: Real>(&self, x: T, order: u8) -> T {
        if self.slopes.is_empty() {
            return self.on_lines(x, order);
        }
        let last = self.knots.len() - 1;
        let line = |end: usize| {
            let ((x_end, y), slope) = (self.knots[end], self.slopes[end]);
            match order {
                0 => T::lit(y) + (x - T::lit(x_end)) * T::lit(slope),
                1 => T::lit(slope),
                _ => T::zero(),
            }
        };
        let at = x.re();
        if at < self.knots[0].0 {
            return line(0);
        }
        let Some(right) = self.knots.iter().position(|&(knot, _)| at < knot) else {
            return line(last);
        };
        let (((x0, y0), (x1, y1)), (m0, m1)) = (
            (self.knots[right - 1], self.knots[right]),
            (self.slopes[right - 1], self.slopes[right]),
        );
        let (one, h) = (T::one(), T::lit(x1) - T::lit(x0));
        let t = (x - T::lit(x0)) / h;
        let s = one - t;
        let [y0, y1, m0, m1] = [y0, y1, m0, m1].map(T::lit);
        let [two, three, six] = [2, 3, 6].map(T::integer);
        let rise = y1 - y0;
        match order {
            0 => {
                y0 * (one + two * t) * s * s
                    + y1 * (three - two * t) * t * t
                    + h * t * s * (m0 * s - m1 * t)
            }
            1 => six * rise / h * t * s + m0 * s * (one - three * t) + m1 * t * (t + t + t - two),
            2 => {
                (six * rise / h * (s - t)
                    + m0 * two * (three * t - two)
                    + m1 * two * (three * t - one))
                    / h
            }
            3 => six * (m0 + m1 - two * rise / h) / (h * h),
            _ => T::zero(),
        }
    }

    /// Scale of the rounding error of the interpolated value: the sum, over the two knots next to `x`, of the absolute
    /// value and of the absolute slope times the spacing between these knots.
    pub fn magnitude_near(&self, x: f64) -> f64 {
        let right = self.knots.iter().position(|&(knot, _)| x < knot);
        let right = right.unwrap_or(self.knots.len() - 1).max(1);
        let width = self.knots[right].0 - self.knots[right - 1].0;
        let slope = |k: usize| self.slopes.get(k).map_or(0.0, |slope| slope.abs());
        let size = |k: usize| self.knots[k].1.abs() + width * slope(k);
        size(right - 1) + size(right)
    }
}

/// (Width, mean slope) of each interval between two neighbouring knots; a knot is a pair (argument, value).
fn intervals(knots: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let of = |pair: &[(f64, f64)]| {
        let width = pair[1].0 - pair[0].0;
        (width, (pair[1].1 - pair[0].1) / width)
    };
    knots.windows(2).map(of).collect()
}

/// Slopes at the knots of the cubic spline with continuous second derivative. At the ends the slope is 0 if `is_flat`,
/// otherwise the second derivative is 0.
fn spline_slopes(knots: &[(f64, f64)], is_flat: bool) -> Vec<f64> {
    let intervals = intervals(knots);
    let n = knots.len();
    // Rows (left, middle, right, right-hand side) of the tridiagonal equations.
    let row = |k: usize| match k {
        _ if (k == 0 || k == n - 1) && is_flat => (0.0, 1.0, 0.0, 0.0),
        0 => (0.0, 2.0, 1.0, 3.0 * intervals[0].1),
        _ if k == n - 1 => (1.0, 2.0, 0.0, 3.0 * intervals[n - 2].1),
        _ => {
            let ((left, before), (right, behind)) = (intervals[k - 1], intervals[k]);
            let sum = 2.0 * (left + right);
            (right, sum, left, 3.0 * (right * before + left * behind))
        }
    };
    let mut reduced: Vec<(f64, f64)> = Vec::with_capacity(n);
    for k in 0..n {
        let (left, middle, right, value) = row(k);
        let (ratio, solved) = reduced.last().copied().unwrap_or_default();
        let pivot = middle - left * ratio;
        reduced.push((right / pivot, (value - left * solved) / pivot));
    }
    let mut slopes = vec![0.0; n];
    let mut next = 0.0;
    for (slope, (ratio, solved)) in slopes.iter_mut().zip(reduced).rev() {
        next = solved - ratio * next;
        *slope = next;
    }
    slopes
}

/// Slopes at the knots that make the curve monotone wherever the values at the knots are (Fritsch and Butland 1984). At
/// the ends the slope is 0 if `is_flat`, otherwise it is that of a parabola through three knots, limited so that the
/// curve stays monotone.
fn monotone_slopes(knots: &[(f64, f64)], is_flat: bool) -> Vec<f64> {
    let intervals = intervals(knots);
    let last = intervals.len();
    let end = |(width, slope): (f64, f64), (next_width, next): (f64, f64)| {
        if is_flat {
            return 0.0;
        }
        let three_points = slope + (slope - next) * width / (width + next_width);
        match () {
            () if three_points * slope <= 0.0 => 0.0,
            () if slope * next <= 0.0 && three_points.abs() > 3.0 * slope.abs() => 3.0 * slope,
            () => three_points,
        }
    };
    let inner = |k: usize| {
        let ((left, before), (right, behind)) = (intervals[k - 1], intervals[k]);
        if before * behind <= 0.0 {
            return 0.0;
        }
        let (by_before, by_behind) = (left + 2.0 * right, 2.0 * left + right);
        (by_before + by_behind) / (by_before / before + by_behind / behind)
    };
    let of = |k: usize| match k {
        0 => end(intervals[0], intervals[1]),
        _ if k == last => end(intervals[last - 1], intervals[last - 2]),
        _ => inner(k),
    };
    (0..=last).map(of).collect()
}
