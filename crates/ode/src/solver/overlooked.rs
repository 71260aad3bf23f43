//! What a step that passes the error test has flown over: the rate of the state in its cells, between its stages.

use super::Solver;
use crate::OdeRhs;
use crate::dense_output::{DenseOutput, HermiteStep};
use crate::switches::{Passed, Path, greatest, may_have_cells, overlooked};
use crate::time_breaks::StepEnd;
use lanes::{Enclosure, Switch};
use std::sync::Arc;

/// Arguments of switches in the current step.
pub(super) struct Watch {
    switches: Arc<[Switch]>,
    /// Arguments at the start, in the middle and at the end of the step.
    points: [Vec<f64>; 3],
    is_start_known: bool,
}

impl Watch {
    pub fn new(switches: Arc<[Switch]>) -> Watch {
        let points = [0; 3].map(|_| vec![0.0; switches.len()]);
        Watch {
            switches,
            points,
            is_start_known: false,
        }
    }

    /// Begins the next step at the end of the last one, which has been accepted.
    pub fn advance(&mut self) {
        self.points.swap(0, 2);
        self.is_start_known = true;
    }

    /// Begins a step with a state that is not the end of the last one.
    pub fn begin(&mut self) {
        self.is_start_known = false;
    }
}

impl<D: OdeRhs> Solver<'_, '_, D> {
    /// Fraction of a step, which passes the error test, at which the rate of the state differs from that of the step by
    /// more than the tolerance allows; a step that ends there sees why.
    pub(super) fn overlooked(&mut self, end: StepEnd) -> Option<f64> {
        let watch = self.watch.as_mut()?;
        let (t, h) = (self.t, end.h);
        let step = HermiteStep::of(&self.stepper, t, h);
        let (rhs, state) = (&mut *self.rhs, &mut self.scratch);
        let mut within = |s: f64, to: &mut [f64]| {
            for (i, x) in state.as_mut().iter_mut().enumerate() {
                *x = step.component(i, s);
            }
            rhs.switch_arguments(t + s * h, state.as_ref(), to);
        };
        let [first, middle, last] = &mut watch.points;
        if !watch.is_start_known {
            within(0.0, first);
            watch.is_start_known = true;
        }
        within(0.5, middle);
        within(1.0, last);
        let points = [&**first, &**middle, &**last];
        if !may_have_cells(&watch.switches, points) {
            return None;
        }
        self.overlooked_cell(end)
    }

    /// As [`overlooked`](Self::overlooked), of a step that may have cells.
    #[cold]
    fn overlooked_cell(&mut self, end: StepEnd) -> Option<f64> {
        let switches = self.watch.as_ref()?.switches.clone();
        let (t, h, tolerance) = (self.t, end.h, self.tolerance);
        let (tableau, rate) = (self.stepper.tableau, self.stepper.x.clone());
        let scales: Vec<f64> = {
            let (x, x_end) = (self.stepper.x.as_ref(), self.stepper.x_end().as_ref());
            let controlled = x.iter().zip(x_end).take(tolerance.controlled_len);
            controlled.map(|(a, b)| tolerance.scale(*a, *b)).collect()
        };
        let rows = self
            .stepper
            .dense_rows(self.rhs, (t, h), &mut self.dense_buffer);
        self.stats.evaluations += tableau.dense_rows.len();
        let step = DenseOutput {
            method: tableau.method,
            t,
            h,
            rows,
            projection: self.projection.as_deref(),
        };
        let mut passed = OnPath {
            rhs: self.rhs,
            path: Path::of(&step),
            step,
            state: &mut self.scratch,
            rate,
            scales,
            evaluations: &mut self.stats.evaluations,
            bounds: Vec::new(),
        };
        overlooked(&switches, &mut passed)
    }
}

/// Step on the path of its dense output.
struct OnPath<'a, D: OdeRhs> {
    rhs: &'a mut D,
    path: Path,
    step: DenseOutput<'a>,
    state: &'a mut D::State,
    rate: D::State,
    /// Tolerated errors of the components of the state.
    scales: Vec<f64>,
    evaluations: &'a mut usize,
    bounds: Vec<Enclosure>,
}

impl<D: OdeRhs> Passed for OnPath<'_, D> {
    fn arguments(&mut self, s: f64, to: &mut [f64]) {
        for (x, value) in self.state.as_mut().iter_mut().zip(self.path.state(s)) {
            *x = value;
        }
        let (t, x) = (self.path.time(s), self.state.as_ref());
        self.rhs.switch_arguments(t, x, to);
    }

    fn bounds(&mut self, part: (f64, f64), to: &mut [Enclosure]) -> bool {
        let time = self.path.bounds(part, &mut self.bounds);
        self.rhs.switch_bounds(time, &self.bounds, to)
    }

    fn deviation(&mut self, s: f64) -> f64 {
        let h = self.step.h;
        self.step.state(s, self.state.as_mut());
        let t = self.step.t + s * h;
        self.rhs.derivative(t, self.state, &mut self.rate);
        *self.evaluations += 1;
        let rates = self.rate.as_ref().iter().zip(&self.scales).enumerate();
        let each = rates.map(|(i, (rate, scale))| (h * rate - self.step.slope(s, i)).abs() / scale);
        each.fold(0.0, greatest)
    }
}
