//! What a step that passes the error test has flown over, in each lane: the rate of the state in its cells.

// Iterator methods need not be inlined, and are then compiled for the baseline processor.
#![allow(clippy::needless_range_loop)]

use super::Flying;
use crate::batch::control::MAX_LANES;
use crate::batch::functions::{Function, LaneFunctions};
use crate::batch::staging::{LaneValues, merge};
use crate::dense_output::DenseOutput;
use crate::switches::{Passed, Path, greatest, overlooked, possible_passages};
use lanes::{Enclosure, Lanes};

/// Fractions of a step at which the arguments of switches are computed first.
const POINTS: [f64; 3] = [0.0, 0.5, 1.0];

/// Arguments of switches in the current step of each lane.
pub(super) struct Watch<T> {
    /// Arguments at the [`POINTS`].
    points: [Vec<T>; 3],
    /// Whether the arguments at the start are known in every lane.
    pub(super) knows_start: bool,
    /// Arguments at another point.
    within: Vec<T>,
    /// Rates of the state at that point.
    rates: Vec<T>,
}

impl<T: Lanes> Watch<T> {
    pub(super) fn new(switches: usize, states: usize) -> Self {
        let zeros = || vec![T::splat(0.0); switches];
        Watch {
            points: [0; 3].map(|_| zeros()),
            knows_start: false,
            within: zeros(),
            rates: vec![T::splat(0.0); states],
        }
    }
}

impl<T: Lanes> Flying<'_, T> {
    /// Whether the step of each lane marked in `passes` may have cells.
    #[inline(always)]
    pub(super) fn may_have_cells(
        &mut self,
        t: T,
        h: T,
        passes: &[bool; MAX_LANES],
    ) -> [bool; MAX_LANES] {
        let mut found = [false; MAX_LANES];
        if self.watch.within.is_empty() {
            return found;
        }
        let last = self.tableau.rows.len();
        for k in usize::from(self.watch.knows_start)..POINTS.len() {
            let s = POINTS[k];
            for i in 0..self.stages.n {
                let (a, b) = (self.values.x[i], self.end[i]);
                let (da, db) = (h * self.stages.stage(0)[i], h * self.stages.stage(last)[i]);
                // The cubic of the scalar solver, in lanes.
                let [r, s] = [1.0 - s, s].map(T::splat);
                let bent = (da - (b - a)) * r - (db - (b - a)) * s;
                self.within[i] = a * r + b * s + s * r * bent;
            }
            // The time at the end is, to the bit, that at the start of the next step.
            let time = match k {
                2 => T::load(&self.control.end),
                _ => T::splat(s).mul_add(h, t),
            };
            let point = self.values.at(time, &self.within);
            let to = &mut self.watch.points[k];
            self.rhs
                .call(Function::Switches, &point, &mut self.scratch, to);
        }
        self.watch.knows_start = true;
        let mut possible = [0; MAX_LANES];
        let switches = self.rhs.switches();
        for j in 0..switches.len() {
            let mut values = [[0.0; MAX_LANES]; 3];
            for k in 0..POINTS.len() {
                self.watch.points[k][j].store(&mut values[k]);
            }
            for lane in 0..T::WIDTH {
                let [start, middle, end] = values;
                let values = [start[lane], middle[lane], end[lane]];
                possible[lane] += possible_passages(&switches[j], values);
            }
        }
        for lane in 0..T::WIDTH {
            found[lane] = passes[lane] && possible[lane] > 1;
        }
        found
    }

    /// Makes the arguments at the ends of the steps of the lanes whose element of `keep` is 0 those at the starts.
    #[inline(always)]
    pub(super) fn advance_switches(&mut self, keep: T) {
        let [start, _, end] = &mut self.watch.points;
        merge(keep, end, start);
    }

    /// Fraction of the step of a lane at which its rate differs from that of the step by more than the tolerance allows,
    /// by the dense output.
    #[inline(always)]
    pub(super) fn overlooked(&mut self, lane: usize, h: T) -> Option<f64> {
        self.fill_rows(lane, h);
        let span = (self.control.t[lane], self.control.h[lane]);
        let step = DenseOutput::of_rows(self.tableau.method, span, &self.rows);
        let ends = self.values.x.iter().zip(&self.end);
        let scales = ends.map(|(a, b)| self.tolerance.scale(a.lane(lane), b.lane(lane)));
        let mut passed = InLane {
            rhs: self.rhs,
            values: &self.values,
            lane,
            path: Path::of(&step),
            step,
            scales: scales.collect(),
            evaluations: &mut self.evaluations,
            bounds: Vec::new(),
            parameters: self.values.p.iter().map(|p| p.lane(lane)).collect(),
            of_lane: &mut self.state,
            state: &mut self.within,
            within: &mut self.watch.within,
            rates: &mut self.watch.rates,
            scratch: &mut self.scratch,
        };
        overlooked(self.rhs.switches(), &mut passed)
    }
}

/// Step of one lane on the path of its dense output.
struct InLane<'a, T> {
    rhs: &'a dyn LaneFunctions<T>,
    values: &'a LaneValues<T>,
    lane: usize,
    path: Path,
    step: DenseOutput<'a>,
    /// Tolerated errors of the components of the state.
    scales: Vec<f64>,
    evaluations: &'a mut u64,
    bounds: Vec<Enclosure>,
    parameters: Vec<f64>,
    /// Work arrays: a state of the lane and of all, arguments, rates, and what the functions need.
    of_lane: &'a mut [f64],
    state: &'a mut [T],
    within: &'a mut [T],
    rates: &'a mut [T],
    scratch: &'a mut [T],
}

impl<T: Lanes> Passed for InLane<'_, T> {
    fn arguments(&mut self, s: f64, to: &mut [f64]) {
        for (x, value) in self.state.iter_mut().zip(self.path.state(s)) {
            *x = T::splat(value);
        }
        let point = self.values.at(T::splat(self.path.time(s)), self.state);
        self.rhs
            .call(Function::Switches, &point, self.scratch, self.within);
        for (to, value) in to.iter_mut().zip(&*self.within) {
            *to = value.lane(self.lane);
        }
    }

    fn bounds(&mut self, part: (f64, f64), to: &mut [Enclosure]) -> bool {
        let time = self.path.bounds(part, &mut self.bounds);
        self.rhs
            .switch_bounds(time, &self.bounds, &self.parameters, to)
    }

    fn deviation(&mut self, s: f64) -> f64 {
        let (t, h) = (self.step.t + s * self.step.h, self.step.h);
        self.step.state(s, self.of_lane);
        for (x, value) in self.state.iter_mut().zip(&*self.of_lane) {
            *x = T::splat(*value);
        }
        let point = self.values.at(T::splat(t), self.state);
        self.rhs
            .call(Function::Derivative, &point, self.scratch, self.rates);
        *self.evaluations += 1;
        let rates = self.rates.iter().zip(&self.scales).enumerate();
        let each = rates.map(|(i, (rate, scale))| {
            (h * rate.lane(self.lane) - self.step.slope(s, i)).abs() / scale
        });
        each.fold(0.0, greatest)
    }
}
