//! State within an accepted step: the method's interpolant, and a cheaper cubic Hermite interpolant.

use crate::method::simd::{MIN_SIMD_LEN, WeightedRows};
use crate::method::{Method, ROWS, Stepper};
use crate::projection::Project;
use crate::rhs::StateVector;
use std::ops::Range;

/// Dense output of one step: x(t + s h) = Σ weight(s) · row over the coefficient vectors `rows`, with s from 0 to 1.
#[derive(Clone, Copy)]
pub(crate) struct DenseOutput<'a> {
    pub method: Method,
    pub t: f64,
    pub h: f64,
    /// Coefficient vectors of the dense output, each as long as the state.
    pub rows: [&'a [f64]; ROWS],
    /// Projection of the states that are read.
    pub projection: Option<&'a dyn Project>,
}

impl<'a> DenseOutput<'a> {
    /// Dense output of the step from `t` to `t + h`, not projected; `rows` are the coefficient vectors one after the other.
    #[inline]
    pub(crate) fn of_rows(method: Method, (t, h): (f64, f64), rows: &'a [f64]) -> Self {
        let n = rows.len() / ROWS;
        DenseOutput {
            method,
            t,
            h,
            rows: std::array::from_fn(|k| &rows[k * n..][..n]),
            projection: None,
        }
    }
}

impl DenseOutput<'_> {
    #[inline]
    pub(crate) fn state(&self, s: f64, to: &mut [f64]) {
        self.interpolate(s, to);
        if let Some(projection) = self.projection {
            projection.project(self.t + s * self.h, to);
        }
    }

    /// State at the fraction `s` of the step, not projected.
    #[inline]
    fn interpolate(&self, s: f64, to: &mut [f64]) {
        let n = to.len();
        let weights = self.method.weights(s, self.h);
        if n >= MIN_SIMD_LEN {
            let rows = self.rows;
            return lanes::dispatch(WeightedRows { rows, weights, to });
        }
        to.copy_from_slice(self.rows[0]);
        for (row, weight) in self.rows.iter().zip(weights).skip(1) {
            for (to, value) in to.iter_mut().zip(*row) {
                *to += weight * value;
            }
        }
    }

    /// Writes the components in `ranges` of the state at the fraction `s` of the step; all if it is projected.
    pub(crate) fn components(&self, s: f64, ranges: &[Range<usize>], to: &mut [f64]) {
        if self.projection.is_some() {
            return self.state(s, to);
        }
        let weights = self.method.weights(s, self.h);
        for range in ranges {
            let rows = self.rows.map(|row| &row[range.clone()]);
            let to = &mut to[range.clone()];
            lanes::dispatch(WeightedRows { rows, weights, to });
        }
    }

    /// Derivative of component `i` of the state, not projected, by the fraction `s` of the step.
    pub(crate) fn slope(&self, s: f64, i: usize) -> f64 {
        let slopes = self.method.slopes(s, self.h);
        let terms = self.rows.iter().zip(slopes).skip(1);
        terms.map(|(row, slope)| slope * row[i]).sum()
    }

    /// Component `i` of the state at the fraction `s`, not projected, with the bits of [`state`](Self::state) of a short
    /// state.
    pub(crate) fn component(&self, s: f64, i: usize) -> f64 {
        let weights = self.method.weights(s, self.h);
        let mut sum = self.rows[0][i];
        for (row, weight) in self.rows.iter().zip(weights).skip(1) {
            sum += weight * row[i];
        }
        sum
    }
}

/// Accepted step with the states and rates at its ends, interpolated by the cubic Hermite polynomial.
pub(crate) struct HermiteStep<'a, X> {
    pub t: f64,
    pub h: f64,
    pub x: &'a X,
    pub dx: &'a X,
    pub x_end: &'a X,
    pub dx_end: &'a X,
}

impl<'a, X: StateVector> HermiteStep<'a, X> {
    /// The last step of a stepper, from the time `t`, of the size `h`.
    #[inline(always)]
    pub(crate) fn of(stepper: &'a Stepper<X>, t: f64, h: f64) -> HermiteStep<'a, X> {
        HermiteStep {
            t,
            h,
            x: &stepper.x,
            dx: stepper.dx(),
            x_end: stepper.x_end(),
            dx_end: stepper.dx_end(),
        }
    }

    #[inline(always)]
    pub(crate) fn ends(&self, i: usize) -> (f64, f64, f64, f64) {
        (
            self.x.as_ref()[i],
            self.x_end.as_ref()[i],
            self.h * self.dx.as_ref()[i],
            self.h * self.dx_end.as_ref()[i],
        )
    }

    #[inline(always)]
    pub(crate) fn component(&self, i: usize, s: f64) -> f64 {
        cubic(self.ends(i), s)
    }

    /// Step size times the time derivative of the cubic interpolant of component `i` at the fraction `s` of the step.
    #[inline(always)]
    pub(crate) fn scaled_derivative(&self, i: usize, s: f64) -> f64 {
        let (a, b, da, db) = self.ends(i);
        let r = 1.0 - s;
        da * r + db * s + 3.0 * s * r * (2.0 * (b - a) - da - db)
    }
}

/// Value of a cubic polynomial at the fraction `s` of a step.
#[inline(always)]
pub(crate) fn cubic((a, b, da, db): (f64, f64, f64, f64), s: f64) -> f64 {
    let r = 1.0 - s;
    a * r + b * s + s * r * ((da - (b - a)) * r - (db - (b - a)) * s)
}
