//! Staging of flights: the next flight of each lane is prepared ahead of its start, for all lanes at once: invariants,
//! derivative and initial step size.

use super::control::MAX_LANES;
use super::functions::{Function, LaneFunctions};
use super::norms::{change_norm, initial_norms};
use super::{FlightEnd, FlightOutcome, FlightQueue, FlightSpan, LanePoint, LaneSizes};
use crate::options::{IntegrationOptions, SolverStats};
use crate::step_control::{first_step, second_step};
use crate::time_breaks::just_after;
use lanes::Lanes;

/// Data of flights, one flight per SIMD lane: state, parameters and invariants.
pub(crate) struct LaneValues<T> {
    pub x: Vec<T>,
    pub p: Vec<T>,
    pub prepared: Vec<T>,
}

impl<T: Lanes> LaneValues<T> {
    #[inline(always)]
    pub(crate) fn new(sizes: &LaneSizes) -> Self {
        let zeros = |n| vec![T::splat(0.0); n];
        LaneValues {
            x: zeros(sizes.states),
            p: zeros(sizes.parameters),
            prepared: zeros(sizes.prepared),
        }
    }

    /// The time `t` and the state `x` with these parameters and invariants.
    #[inline(always)]
    pub(crate) fn at<'a>(&'a self, t: T, x: &'a [T]) -> LanePoint<'a, T> {
        LanePoint {
            t,
            x,
            p: &self.p,
            prepared: &self.prepared,
        }
    }

    /// Replaces the values of a SIMD lane by those of `from` if the element of the mask `keep` for this lane is 0.
    #[inline(always)]
    pub(crate) fn take(&mut self, keep: T, from: &LaneValues<T>) {
        merge(keep, &from.x, &mut self.x);
        merge(keep, &from.p, &mut self.p);
        merge(keep, &from.prepared, &mut self.prepared);
    }
}

/// Copies the values of a SIMD lane from `from` to `to` if the element of the mask `keep` for this lane is 0.
#[inline(always)]
pub(crate) fn merge<T: Lanes>(keep: T, from: &[T], to: &mut [T]) {
    let n = to.len();
    let from = &from[..n];
    for i in 0..n {
        to[i] = keep.if_zero(from[i], to[i]);
    }
}

/// Flights that wait to be started, at most one per SIMD lane.
pub(crate) struct Staging<T> {
    pub values: LaneValues<T>,
    /// Derivatives at the initial states.
    pub dx: Vec<T>,
    /// Margins of the limits of validity at the initial states.
    margins: Vec<T>,
    /// Number of the flight that waits for each lane, as returned by `FlightQueue::next`, if any.
    pub flight: [Option<u64>; MAX_LANES],
    pub h: [f64; MAX_LANES],
    pub breaks: [Vec<f64>; MAX_LANES],
    pub is_drained: bool,
    euler_state: Vec<T>,
    euler_rate: Vec<T>,
    /// Initial states, transposed: component i of lane l is at index `i · WIDTH + l`, where `WIDTH` is the number of
    /// lanes. `p_columns` contains the parameters in the same layout.
    x_columns: Vec<f64>,
    p_columns: Vec<f64>,
    x_next: Vec<f64>,
    p_next: Vec<f64>,
}

impl<T: Lanes> Staging<T> {
    #[inline(always)]
    pub(crate) fn new(sizes: &LaneSizes) -> Self {
        let zeros = || vec![T::splat(0.0); sizes.states];
        Staging {
            values: LaneValues::new(sizes),
            dx: zeros(),
            margins: vec![T::splat(0.0); sizes.limits],
            flight: [None; MAX_LANES],
            h: [0.0; MAX_LANES],
            breaks: std::array::from_fn(|_| Vec::new()),
            is_drained: false,
            euler_state: zeros(),
            euler_rate: zeros(),
            x_columns: vec![0.0; sizes.states * T::WIDTH],
            p_columns: vec![0.0; sizes.parameters * T::WIDTH],
            x_next: vec![0.0; sizes.states],
            p_next: vec![0.0; sizes.parameters],
        }
    }

    /// Takes a flight from the queue for each lane for which no flight waits, and computes its invariants, initial
    /// derivative and initial step size. A flight that cannot start is reported to the queue as ended; no flight then
    /// waits for the lane.
    #[inline(always)]
    pub(crate) fn fill(
        &mut self,
        rhs: &dyn LaneFunctions<T>,
        queue: &mut dyn FlightQueue,
        (span, options): (&FlightSpan, &IntegrationOptions),
        order: i32,
        scratch: &mut [T],
    ) {
        let mut is_new = [false; MAX_LANES];
        for (lane, is_new) in is_new.iter_mut().enumerate().take(T::WIDTH) {
            if self.flight[lane].is_none() {
                *is_new = self.draw(lane, rhs, queue, span);
            }
        }
        let values = &mut self.values;
        let columns = [
            (&mut values.x, &self.x_columns),
            (&mut values.p, &self.p_columns),
        ];
        for (to, columns) in columns {
            for (to, column) in to.iter_mut().zip(columns.chunks_exact(T::WIDTH)) {
                *to = T::load(column);
            }
        }
        let (dx, margins) = (&mut self.dx, &mut self.margins);
        let LaneValues { x, p, prepared } = values;
        let of_parameters = LanePoint {
            t: T::splat(0.0),
            x,
            p,
            prepared: &[],
        };
        rhs.call(Function::Prepare, &of_parameters, scratch, prepared);
        let tolerance = options.tolerance(usize::MAX);
        let max_step = options.max_step.min(span.t_end);
        let mut norms = [T::splat(0.0); 2];
        let mut euler_step = T::splat(0.0);
        let starts = self.breaks.each_ref().map(|breaks| just_after(breaks, 0.0));
        // First at the start, then one Euler step ahead.
        for pass in 0..2 {
            let (t, at, to) = match pass {
                0 => (T::load(&starts), &*x, &mut *dx),
                _ => {
                    norms = initial_norms(x, dx, &tolerance);
                    let [x_norm, rate] = norms;
                    euler_step = T::from_fn(|l| first_step(x_norm.lane(l), rate.lane(l), max_step));
                    for (i, state) in self.euler_state.iter_mut().enumerate() {
                        *state = euler_step.mul_add(dx[i], x[i]);
                    }
                    (euler_step, &self.euler_state, &mut self.euler_rate)
                }
            };
            let point = LanePoint {
                t,
                x: at,
                p,
                prepared,
            };
            rhs.call(Function::Derivative, &point, scratch, to);
        }
        let change = change_norm(x, (dx, &self.euler_rate), &tolerance);
        let start = LanePoint {
            t: T::splat(0.0),
            x,
            p,
            prepared,
        };
        rhs.call(Function::Limits, &start, scratch, margins);
        for (lane, is_new) in is_new.iter().enumerate().take(T::WIDTH) {
            if !is_new {
                continue;
            }
            self.h[lane] = options.first_step.unwrap_or_else(|| {
                let (euler, rate) = (euler_step.lane(lane), norms[1].lane(lane));
                second_step(euler, rate, change.lane(lane) / euler, order, max_step)
            });
            if let Some(outcome) = self.fault(lane, span) {
                self.end_at_start(lane, outcome, queue, span);
            }
        }
    }

    /// Takes flights from the queue until one is finite, which then waits for the lane.
    #[inline(always)]
    fn draw(
        &mut self,
        lane: usize,
        rhs: &dyn LaneFunctions<T>,
        queue: &mut dyn FlightQueue,
        span: &FlightSpan,
    ) -> bool {
        while !self.is_drained {
            let Some(flight) = queue.next(&mut self.x_next, &mut self.p_next) else {
                self.is_drained = true;
                return false;
            };
            let mut sum = 0.0;
            for value in self.x_next.iter().chain(&self.p_next) {
                sum += 0.0 * value;
            }
            if sum != 0.0 {
                let end = start_end(flight, FlightOutcome::NotFinite, &self.x_next, span);
                queue.end(end);
                continue;
            }
            for (i, value) in self.x_next.iter().enumerate() {
                self.x_columns[i * T::WIDTH + lane] = *value;
            }
            for (i, value) in self.p_next.iter().enumerate() {
                self.p_columns[i * T::WIDTH + lane] = *value;
            }
            self.breaks[lane].clear();
            rhs.time_breaks(&self.p_next, &mut self.breaks[lane]);
            self.flight[lane] = Some(flight);
            return true;
        }
        false
    }

    /// Reason why the flight that waits for a lane cannot start; `None` if it can.
    #[inline(always)]
    fn fault(&self, lane: usize, span: &FlightSpan) -> Option<FlightOutcome> {
        let (x, dx) = (&self.values.x, &self.dx);
        if let Some(limit) = self.margins.iter().position(|m| m.lane(lane) <= 0.0) {
            return Some(FlightOutcome::Limit(limit));
        }
        let mut sum = T::splat(0.0);
        for rate in dx {
            sum = sum + T::splat(0.0) * *rate;
        }
        if sum.lane(lane) != 0.0 {
            return Some(FlightOutcome::StepTooSmall);
        }
        let z = span.height.filter(|_| span.until_ground)?;
        let (height, rate) = (x[z].lane(lane), dx[z].lane(lane));
        (height < 0.0 || height == 0.0 && rate < 0.0).then_some(FlightOutcome::StartsBelowGround)
    }

    #[inline(always)]
    fn end_at_start(
        &mut self,
        lane: usize,
        outcome: FlightOutcome,
        queue: &mut dyn FlightQueue,
        span: &FlightSpan,
    ) {
        for (i, value) in self.x_next.iter_mut().enumerate() {
            *value = self.x_columns[i * T::WIDTH + lane];
        }
        if let Some(flight) = self.flight[lane].take() {
            queue.end(start_end(flight, outcome, &self.x_next, span));
        }
    }
}

fn start_end<'x>(
    flight: u64,
    outcome: FlightOutcome,
    state: &'x [f64],
    span: &FlightSpan,
) -> FlightEnd<'x> {
    FlightEnd {
        flight,
        outcome,
        time: 0.0,
        state,
        apex: (0.0, span.apex().map_or(f64::NAN, |z| state[z])),
        stats: SolverStats::default(),
    }
}
