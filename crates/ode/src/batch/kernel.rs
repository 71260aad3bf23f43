//! Step loop of the batch integration, with one flight per lane.

mod overlooked;
mod stop;

use self::overlooked::Watch;
use super::control::{Control, MAX_LANES};
use super::events::HeightEnds;
use super::functions::{Function, LaneFunctions};
use super::norms::error_norm;
use super::stages::Stages;
use super::staging::{LaneValues, Staging, merge};
use super::{FlightEnd, FlightOutcome, FlightQueue, FlightSpan, LaneRhs};
use crate::method::tableau::Tableau;
use crate::method::{ErrorTolerance, ROWS};
use crate::options::IntegrationOptions;
use crate::time_breaks::just_after;
use lanes::{Kernel, LaneKernel, Lanes};

/// Kernel that integrates all flights of a queue and returns the number of vector evaluations.
pub(crate) struct Batch<'a, R> {
    pub rhs: &'a R,
    pub queue: &'a mut dyn FlightQueue,
    pub span: &'a FlightSpan,
    pub options: &'a IntegrationOptions,
}

impl<R: LaneRhs> Kernel for Batch<'_, R> {
    type Output = u64;

    #[inline(always)]
    fn run<T: Lanes>(self) -> u64 {
        let mut evaluations = 0;
        T::outlined(StepLoop {
            lanes: Flying::<T>::new(self.rhs, self.span, self.options),
            queue: self.queue,
            evaluations: &mut evaluations,
        });
        evaluations
    }
}

/// Kernel with the loop over the steps, which does not depend on the type of the right-hand side.
struct StepLoop<'a, T> {
    lanes: Flying<'a, T>,
    queue: &'a mut dyn FlightQueue,
    evaluations: &'a mut u64,
}

impl<T: Lanes> LaneKernel<T> for StepLoop<'_, T> {
    #[inline(always)]
    fn run(self) {
        let (mut lanes, queue) = (self.lanes, self.queue);
        loop {
            lanes.refill(queue);
            if lanes.control.flight[..T::WIDTH].iter().all(Option::is_none) {
                *self.evaluations = lanes.evaluations;
                return;
            }
            lanes.step(queue);
        }
    }
}

/// State of a batch integration between two steps: the flights in the SIMD lanes, one per lane, and work arrays.
struct Flying<'a, T> {
    rhs: &'a dyn LaneFunctions<T>,
    span: &'a FlightSpan,
    options: &'a IntegrationOptions,
    tableau: &'static Tableau,
    tolerance: ErrorTolerance,
    control: Control,
    values: LaneValues<T>,
    staging: Staging<T>,
    stages: Stages<T>,
    /// State at which the current stage is evaluated; after the last stage, the state at the end of the step.
    end: Vec<T>,
    /// Work array for the state at an interior point of the step, such as its middle or the point where a flight ends.
    within: Vec<T>,
    /// Margins of the limits of validity (positive where the right-hand side is valid): in the middle of the step, at
    /// its end, and at the trial point of the search for a crossing.
    margins: [Vec<T>; 3],
    watch: Watch<T>,
    scratch: Vec<T>,
    heights: [HeightEnds; MAX_LANES],
    /// Work array for the state of one lane; `rows` is the work array for the dense-output coefficients of one lane.
    state: Vec<f64>,
    rows: Vec<f64>,
    found: Vec<f64>,
    evaluations: u64,
}

/// Point of a step whose state is the final state of a flight.
#[derive(Clone, Copy)]
enum EndState {
    Start,
    End,
    /// The flight ends in the state at an interior point of the step, which is stored in [`Flying::within`].
    Within,
}

impl<'a, T: Lanes> Flying<'a, T> {
    #[inline(always)]
    fn new(
        rhs: &'a dyn LaneFunctions<T>,
        span: &'a FlightSpan,
        options: &'a IntegrationOptions,
    ) -> Self {
        let (sizes, tableau) = (rhs.sizes(), options.method.tableau());
        let zeros = |n| vec![T::splat(0.0); n];
        Flying {
            rhs,
            span,
            options,
            tableau,
            tolerance: options.tolerance(usize::MAX),
            control: Control::new(tableau, span, options),
            values: LaneValues::new(&sizes),
            staging: Staging::new(&sizes),
            stages: Stages::new(tableau, sizes.states),
            end: zeros(sizes.states),
            within: zeros(sizes.states),
            margins: [0; 3].map(|_| zeros(sizes.limits)),
            watch: Watch::new(rhs.switches().len(), sizes.states),
            scratch: zeros(sizes.scratch),
            heights: [HeightEnds::default(); MAX_LANES],
            state: vec![0.0; sizes.states],
            rows: vec![0.0; sizes.states * ROWS],
            found: Vec::with_capacity(8),
            evaluations: 0,
        }
    }

    /// Starts, in each idle lane, the flight that waits for it, and takes further flights from the queue.
    #[inline(always)]
    fn refill(&mut self, queue: &mut dyn FlightQueue) {
        loop {
            let mut keep = [1.0; MAX_LANES];
            let (mut any, mut wants) = (false, false);
            for (lane, keep) in keep.iter_mut().enumerate().take(T::WIDTH) {
                if self.control.flight[lane].is_some() {
                    continue;
                }
                let Some(flight) = self.staging.flight[lane].take() else {
                    wants = true;
                    continue;
                };
                let x = &self.staging.values.x;
                let height = self.span.apex().map_or(f64::NAN, |z| x[z].lane(lane));
                let h = self.staging.h[lane];
                let breaks = &mut self.staging.breaks[lane];
                std::mem::swap(&mut self.control.breaks[lane], breaks);
                self.control.start(lane, flight, h, height);
                (*keep, any) = (0.0, true);
            }
            if any {
                self.watch.knows_start = false;
                let keep = T::load(&keep);
                self.values.take(keep, &self.staging.values);
                merge(keep, &self.staging.dx, self.stages.stage_mut(0));
            }
            if !wants || self.staging.is_drained {
                return;
            }
            let order = self.tableau.error_order;
            let (staging, scratch) = (&mut self.staging, &mut self.scratch[..]);
            staging.fill(self.rhs, queue, (self.span, self.options), order, scratch);
            self.evaluations += 2;
        }
    }

    #[inline(always)]
    fn step(&mut self, queue: &mut dyn FlightQueue) {
        for lane in 0..T::WIDTH {
            if self.control.flight[lane].is_some() && self.control.is_exhausted(lane) {
                let time = self.control.t[lane];
                self.finish(
                    lane,
                    FlightOutcome::TooManySteps,
                    time,
                    EndState::Start,
                    queue,
                );
            }
        }
        self.control.set_steps(T::WIDTH);
        let (t, h) = (T::load(&self.control.t), T::load(&self.control.h));
        let (mut errors, mut passes) = ([0.0; MAX_LANES], [false; MAX_LANES]);
        let mut asks = [false; MAX_LANES];
        let mut may_have_cells = [false; MAX_LANES];
        // A loop, so that the stages are compiled once: first for the step, then for its dense output.
        for is_dense in [false, true] {
            if is_dense && !asks.iter().chain(&may_have_cells).any(|ask| *ask) {
                break;
            }
            self.run_stages(t, h, is_dense);
            if !is_dense {
                self.error_norms(h, &mut errors);
                for lane in 0..T::WIDTH {
                    passes[lane] = self.control.flight[lane].is_some() && errors[lane] <= 1.0;
                }
                asks = self.attention(t, h, &passes);
                may_have_cells = self.may_have_cells(t, h, &passes);
            }
        }
        let mut cuts = [None; MAX_LANES];
        for lane in 0..T::WIDTH {
            if may_have_cells[lane] {
                let cut = self.overlooked(lane, h);
                cuts[lane] = cut.filter(|cut| self.control.may_cut(lane, *cut));
            }
        }
        let accepted = self.judge(&errors, &cuts, queue);
        for lane in 0..T::WIDTH {
            asks[lane] &= accepted[lane];
        }
        if asks.iter().any(|ask| *ask) {
            self.stop(&asks, h, queue);
        }
        self.advance(&accepted, queue);
    }

    /// Evaluates the stages of a step, or the additional stages of its dense output if `is_dense`.
    #[inline(always)]
    fn run_stages(&mut self, t: T, h: T, is_dense: bool) {
        let (rows, first, argument) = match is_dense {
            false => (self.tableau.rows, 1, &mut self.end),
            true => (
                self.tableau.dense_rows,
                self.tableau.stages(),
                &mut self.within,
            ),
        };
        for (k, row) in rows.iter().enumerate() {
            let s = first + k;
            self.stages.advance(argument, &self.values.x, h, row);
            let time = T::splat(self.tableau.c[s]).mul_add(h, t);
            let point = self.values.at(time, argument);
            let to = self.stages.stage_mut(s);
            self.rhs
                .call(Function::Derivative, &point, &mut self.scratch, to);
        }
        self.evaluations += rows.len() as u64;
    }

    #[inline(always)]
    fn error_norms(&self, h: T, errors: &mut [f64; MAX_LANES]) {
        let ends = (&self.values.x[..], &self.end[..]);
        error_norm(self.tableau, &self.stages, ends, h, &self.tolerance).store(errors);
    }

    /// Applies the error test, and cuts steps at the fractions `cuts`; ends flights whose next step would be too small.
    /// Whether each lane's step is accepted.
    #[inline(always)]
    fn judge(
        &mut self,
        errors: &[f64; MAX_LANES],
        cuts: &[Option<f64>; MAX_LANES],
        queue: &mut dyn FlightQueue,
    ) -> [bool; MAX_LANES] {
        let (mut errors, mut accepted) = (*errors, [false; MAX_LANES]);
        for lane in 0..T::WIDTH {
            if cuts[lane].is_some() {
                errors[lane] = f64::INFINITY;
            }
        }
        self.control.accept(&errors);
        for lane in 0..T::WIDTH {
            if self.control.flight[lane].is_none() {
                continue;
            }
            if errors[lane] <= 1.0 {
                accepted[lane] = true;
            } else if !self.control.reject(lane, errors[lane], cuts[lane]) {
                let (outcome, time) = (FlightOutcome::StepTooSmall, self.control.t[lane]);
                self.finish(lane, outcome, time, EndState::Start, queue);
            }
        }
        accepted
    }

    /// Whether a landing, an apex or the crossing of a limit is possible within each lane's accepted step.
    #[inline(always)]
    fn attention(&mut self, t: T, h: T, accepted: &[bool; MAX_LANES]) -> [bool; MAX_LANES] {
        let mut asks = [false; MAX_LANES];
        let last = self.tableau.rows.len();
        if let Some(z) = self.span.height {
            let mut ends = [[0.0; MAX_LANES]; 4];
            self.values.x[z].store(&mut ends[0]);
            self.end[z].store(&mut ends[1]);
            (h * self.stages.stage(0)[z]).store(&mut ends[2]);
            (h * self.stages.stage(last)[z]).store(&mut ends[3]);
            for lane in 0..T::WIDTH {
                // In place: a copy of the whole would wait for its parts to be written.
                let height = &mut self.heights[lane];
                (height.start, height.end) = (ends[0][lane], ends[1][lane]);
                (height.start_slope, height.end_slope) = (ends[2][lane], ends[3][lane]);
                let peaks = self.span.seeks_apex & height.has_peak();
                let is_near = self.span.until_ground & height.is_near_ground();
                asks[lane] = accepted[lane] & (peaks | (is_near && height.may_land()));
            }
        }
        if self.margins[0].is_empty() {
            return asks;
        }
        for (i, middle) in self.within.iter_mut().enumerate() {
            let ends = self.values.x[i] + self.end[i];
            let bend = h * (self.stages.stage(0)[i] - self.stages.stage(last)[i]);
            *middle = T::splat(0.5).mul_add(ends, T::splat(0.125) * bend);
        }
        for (k, margins) in self.margins.iter_mut().take(2).enumerate() {
            let (x, fraction) = match k {
                0 => (&self.within, 0.5),
                _ => (&self.end, 1.0),
            };
            let point = self.values.at(T::splat(fraction).mul_add(h, t), x);
            self.rhs
                .call(Function::Limits, &point, &mut self.scratch, margins);
        }
        let mut least = T::splat(f64::INFINITY);
        for limit in 0..self.margins[0].len() {
            least = self.least_margin(limit).min(least);
        }
        let mut lowest = [0.0; MAX_LANES];
        least.store(&mut lowest);
        for lane in 0..T::WIDTH {
            asks[lane] |= accepted[lane] && (lowest[lane] <= 0.0);
        }
        asks
    }

    /// Advances the SIMD lanes with accepted steps to the end of the step; flights that reach the final time end.
    #[inline(always)]
    fn advance(&mut self, accepted: &[bool; MAX_LANES], queue: &mut dyn FlightQueue) {
        let mut keep = [1.0; MAX_LANES];
        let mut at_break = [false; MAX_LANES];
        for lane in 0..T::WIDTH {
            if !accepted[lane] {
                continue;
            }
            keep[lane] = 0.0;
            let time = self.control.end[lane];
            self.control.t[lane] = time;
            let is_flying = self.control.flight[lane].is_some();
            if self.control.is_last[lane] && is_flying {
                self.finish(lane, FlightOutcome::Time, time, EndState::End, queue);
            }
            at_break[lane] = is_flying && time == self.control.segment_end[lane];
        }
        self.advance_switches(T::load(&keep));
        let n = self.stages.n;
        let last = self.tableau.rows.len() * n;
        let k = &mut self.stages.k;
        if accepted[..T::WIDTH].iter().all(|is_accepted| *is_accepted) {
            std::mem::swap(&mut self.values.x, &mut self.end);
            k.copy_within(last..last + n, 0);
        } else {
            let keep = T::load(&keep);
            merge(keep, &self.end, &mut self.values.x);
            for i in 0..n {
                k[i] = keep.if_zero(k[last + i], k[i]);
            }
        }
        if at_break.iter().any(|is_at| *is_at) {
            self.begin_segments(&at_break);
        }
    }

    /// Begins the segments after time breaks, at which the derivatives may jump, in the SIMD lanes `at_break`.
    #[inline(always)]
    fn begin_segments(&mut self, at_break: &[bool; MAX_LANES]) {
        self.watch.knows_start = false;
        let (mut keep, mut times) = ([1.0; MAX_LANES], self.control.t);
        for lane in (0..T::WIDTH).filter(|lane| at_break[*lane]) {
            keep[lane] = 0.0;
            times[lane] = just_after(&self.control.breaks[lane], self.control.t[lane]);
            self.control.begin_segment(lane);
        }
        let point = self.values.at(T::load(&times), &self.values.x);
        let rates = &mut self.within;
        self.rhs
            .call(Function::Derivative, &point, &mut self.scratch, rates);
        merge(T::load(&keep), rates, self.stages.stage_mut(0));
        self.evaluations += 1;
    }

    /// Reports the end of the flight in a SIMD lane to the queue, and leaves the lane idle.
    #[inline(always)]
    fn finish(
        &mut self,
        lane: usize,
        outcome: FlightOutcome,
        time: f64,
        state: EndState,
        queue: &mut dyn FlightQueue,
    ) {
        let from = match state {
            EndState::Start => &self.values.x,
            EndState::End => &self.end,
            EndState::Within => &self.within,
        };
        for (to, value) in self.state.iter_mut().zip(from) {
            *to = value.lane(lane);
        }
        if let Some(z) = self.span.apex() {
            self.control.rise(lane, time, self.state[z]);
        }
        let Some(flight) = self.control.flight[lane].take() else {
            return;
        };
        queue.end(FlightEnd {
            flight,
            outcome,
            time,
            state: &self.state,
            apex: self.control.apex[lane],
            stats: self.control.stats(lane),
        });
    }
}
