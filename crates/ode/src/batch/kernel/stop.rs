//! Events within a step: landings, apexes and crossed limits of validity, located on the dense output.

// Iterator methods need not be inlined, and are then compiled for the baseline processor.
#![allow(clippy::needless_range_loop)]

use super::{EndState, Flying};
use crate::batch::control::MAX_LANES;
use crate::batch::events::HeightStep;
use crate::batch::functions::Function;
use crate::batch::{FlightOutcome, FlightQueue};
use crate::dense_output::DenseOutput;
use crate::event::{REACH, falling_zeros};
use crate::method::{Method, ROWS, dop853, tsit5};
use lanes::Lanes;

impl<T: Lanes> Flying<'_, T> {
    /// Coefficients of the dense output of state component `i` over the current step, in each SIMD lane.
    #[inline(always)]
    fn dense_rows(&self, i: usize, h: T) -> [T; ROWS] {
        let (x, k) = (self.values.x[i], |s: usize| self.stages.stage(s)[i]);
        match self.tableau.method {
            Method::Tsit5 => [x, k(0), k(1), k(2), k(3), k(4), k(5), k(6)],
            Method::Dop853 => {
                let (change, first, last) = (self.end[i] - x, h * k(0), h * k(12));
                let [a, b, c, d] = &dop853::DENSE;
                let sum = |row| h * self.stages.sum(row, i);
                let twice = T::splat(2.0) * change;
                let slopes = last + first;
                [
                    x,
                    change,
                    first - change,
                    twice - slopes,
                    sum(a),
                    sum(b),
                    sum(c),
                    sum(d),
                ]
            }
        }
    }

    /// Dense output of the height, state component `z`, in the nested-product form of `HeightStep`, in each lane.
    #[inline(always)]
    fn height_terms(&self, z: usize, h: T) -> [T; ROWS] {
        let rows = self.dense_rows(z, h);
        let Method::Tsit5 = self.tableau.method else {
            return rows;
        };
        let mut terms = [T::splat(0.0); ROWS];
        for k in 1..ROWS {
            for power in 1..5 {
                let weight = T::splat(tsit5::INTERPOLANT[k - 1][power - 1]);
                terms[power] = weight.mul_add(rows[k], terms[power]);
            }
        }
        for term in &mut terms {
            *term = h * *term;
        }
        terms[0] = rows[0];
        terms
    }

    /// Locates the events in the steps of the lanes marked in `asks`, and ends flights that land or cross a limit.
    #[inline(always)]
    pub(super) fn stop(&mut self, asks: &[bool; MAX_LANES], h: T, queue: &mut dyn FlightQueue) {
        let method = self.tableau.method;
        let mut height_terms = [[0.0; MAX_LANES]; ROWS];
        if let Some(z) = self.span.height {
            let terms = self.height_terms(z, h);
            for k in 0..ROWS {
                terms[k].store(&mut height_terms[k]);
            }
        }
        let mut stops: [Option<(f64, FlightOutcome)>; MAX_LANES] = [None; MAX_LANES];
        for lane in 0..T::WIDTH {
            if !asks[lane] {
                continue;
            }
            let (t, step) = (self.control.t[lane], self.control.h[lane]);
            let ends = self.heights[lane];
            let mut height = HeightStep {
                method,
                t,
                h: step,
                terms: [0.0; ROWS],
            };
            for k in 0..ROWS {
                height.terms[k] = height_terms[k][lane];
            }
            let mut stop = None;
            if self.span.height.is_some() && self.span.until_ground && ends.may_land() {
                let landing = height.landing(&ends, &mut self.found);
                stop = landing.map(|s| (s, FlightOutcome::Ground));
            }
            for limit in 0..self.margins[0].len() {
                if let Some(s) = self.limit_crossing(lane, limit, h)
                    && stop.is_none_or(|(earliest, _)| s < earliest)
                {
                    stop = Some((s, FlightOutcome::Limit(limit)));
                }
            }
            if self.span.apex().is_some() && ends.has_peak() {
                let s = height.peak();
                if stop.is_none_or(|(end, _)| s <= end) {
                    self.control.rise(lane, t + s * step, height.height(s));
                }
            }
            stops[lane] = stop;
        }
        let (mut any, mut fractions) = (false, [0.0; MAX_LANES]);
        for lane in 0..T::WIDTH {
            if let Some((s, _)) = stops[lane] {
                (any, fractions[lane]) = (true, s);
            }
        }
        if !any {
            return;
        }
        let weights = weights(method, T::load(&fractions), h);
        for i in 0..self.within.len() {
            let rows = self.dense_rows(i, h);
            // Two independent sums, which hide the latency of the additions.
            let mut sums = [rows[0], T::splat(0.0)];
            for k in 1..ROWS {
                sums[k % 2] = weights[k].mul_add(rows[k], sums[k % 2]);
            }
            self.within[i] = sums[0] + sums[1];
        }
        for lane in 0..T::WIDTH {
            if let Some((s, outcome)) = stops[lane] {
                let time = self.control.t[lane] + s * self.control.h[lane];
                self.finish(lane, outcome, time, EndState::Within, queue);
            }
        }
    }

    /// Value below which the margin of a limit of validity does not fall within the step, in each lane: that at the
    /// middle or the end, less [`REACH`] times its change between them, which stands for that in the first half too.
    #[inline(always)]
    pub(super) fn least_margin(&self, limit: usize) -> T {
        let [middle, end, _] = &self.margins;
        let change = (end[limit] - middle[limit]).abs();
        T::splat(-2.0 * REACH).mul_add(change, middle[limit].min(end[limit]))
    }

    /// Writes the coefficients of the dense output of one lane to its work array.
    #[inline(always)]
    pub(super) fn fill_rows(&mut self, lane: usize, h: T) {
        let n = self.within.len();
        for i in 0..n {
            for (k, row) in self.dense_rows(i, h).into_iter().enumerate() {
                self.rows[k * n + i] = row.lane(lane);
            }
        }
    }

    /// Fraction of the step at which the flight in a lane first crosses the limit of validity with the index `limit`.
    #[inline(always)]
    fn limit_crossing(&mut self, lane: usize, limit: usize, h: T) -> Option<f64> {
        if self.least_margin(limit).lane(lane) > 0.0 {
            return None;
        }
        self.fill_rows(lane, h);
        let span = (self.control.t[lane], self.control.h[lane]);
        let step = DenseOutput::of_rows(self.tableau.method, span, &self.rows);
        let (state, margins) = (&mut self.state, &mut self.margins[2]);
        let value = |s: f64| {
            step.state(s, state);
            for (to, value) in self.within.iter_mut().zip(&*state) {
                *to = T::splat(*value);
            }
            let time = T::splat(step.t + s * step.h);
            let point = self.values.at(time, &self.within);
            self.rhs
                .call(Function::Limits, &point, &mut self.scratch, margins);
            margins[limit].lane(lane)
        };
        self.found.clear();
        falling_zeros((step.t, step.h), false, value, &mut self.found);
        self.found.first().copied()
    }
}

/// Weights of the coefficient vectors of the dense output at the fraction `s` of a step of size `h`, in each lane.
#[inline(always)]
fn weights<T: Lanes>(method: Method, s: T, h: T) -> [T; ROWS] {
    let mut weights = [T::splat(1.0); ROWS];
    match method {
        Method::Tsit5 => {
            for k in 1..ROWS {
                let powers = &tsit5::INTERPOLANT[k - 1];
                let mut sum = T::splat(powers[3]);
                for power in (0..3).rev() {
                    sum = sum.mul_add(s, T::splat(powers[power]));
                }
                weights[k] = h * s * sum;
            }
        }
        Method::Dop853 => {
            let r = T::splat(1.0) - s;
            for k in 1..ROWS {
                let factor = if k % 2 == 1 { s } else { r };
                weights[k] = weights[k - 1] * factor;
            }
        }
    }
    weights
}
