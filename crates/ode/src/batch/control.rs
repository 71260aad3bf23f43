//! Step-size control of the lanes: times, step sizes, step counts and maximum heights.

use super::FlightSpan;
use crate::method::tableau::Tableau;
use crate::options::{IntegrationOptions, SolverStats};
use crate::solver::MIN_RELATIVE_STEP;
use crate::step_control::{PiGains, PiMemory};
use crate::time_breaks::{StepEnd, segment_end, steps_at};

/// Maximum number of SIMD lanes of any instruction set.
pub(crate) const MAX_LANES: usize = 8;

/// Flight, time, step size and step counts of each SIMD lane of a batch integration.
pub(crate) struct Control {
    /// Number of the flight in each lane, as returned by `FlightQueue::next`; `None` if the lane is idle.
    pub flight: [Option<u64>; MAX_LANES],
    pub t: [f64; MAX_LANES],
    pub proposed: [f64; MAX_LANES],
    /// Size of the current step in each SIMD lane; 0 in lanes without a flight.
    pub h: [f64; MAX_LANES],
    pub end: [f64; MAX_LANES],
    /// Times at which the derivative of the flight in each SIMD lane may jump, increasing.
    pub breaks: [Vec<f64>; MAX_LANES],
    /// Time at which the current segment of the flight in each SIMD lane ends: just before a break, or the final time.
    pub segment_end: [f64; MAX_LANES],
    pub is_last: [bool; MAX_LANES],
    /// Time and value of the maximum height so far of the flight in each SIMD lane.
    pub apex: [(f64, f64); MAX_LANES],
    steps: [u64; MAX_LANES],
    rejected: [u64; MAX_LANES],
    log2_last_error: [f64; MAX_LANES],
    max_factor: [f64; MAX_LANES],
    gains: PiGains,
    /// Number of evaluations of the right-hand side per step.
    evaluations: u64,
    t_end: f64,
    max_step: f64,
    min_step: f64,
    max_steps: u64,
}

impl Control {
    pub(crate) fn new(tableau: &Tableau, span: &FlightSpan, options: &IntegrationOptions) -> Self {
        Control {
            flight: [None; MAX_LANES],
            t: [0.0; MAX_LANES],
            proposed: [0.0; MAX_LANES],
            h: [0.0; MAX_LANES],
            end: [0.0; MAX_LANES],
            breaks: std::array::from_fn(|_| Vec::new()),
            segment_end: [span.t_end; MAX_LANES],
            is_last: [false; MAX_LANES],
            apex: [(0.0, f64::NAN); MAX_LANES],
            steps: [0; MAX_LANES],
            rejected: [0; MAX_LANES],
            log2_last_error: [0.0; MAX_LANES],
            max_factor: [1.0; MAX_LANES],
            gains: PiGains::new(tableau),
            evaluations: tableau.rows.len() as u64,
            t_end: span.t_end,
            max_step: options.max_step,
            min_step: MIN_RELATIVE_STEP * span.t_end,
            max_steps: options.max_steps as u64,
        }
    }

    /// Starts the flight number `flight` in a lane at time 0, with the step size `h` and the height `height`.
    #[inline(always)]
    pub(crate) fn start(&mut self, lane: usize, flight: u64, h: f64, height: f64) {
        self.flight[lane] = Some(flight);
        self.t[lane] = 0.0;
        self.proposed[lane] = h;
        self.apex[lane] = (0.0, height);
        self.remember(lane, self.gains.start());
        (self.steps[lane], self.rejected[lane]) = (0, 0);
        self.segment_end[lane] = segment_end(&self.breaks[lane], 0.0, self.t_end);
    }

    #[cold]
    pub(crate) fn begin_segment(&mut self, lane: usize) {
        self.segment_end[lane] = segment_end(&self.breaks[lane], self.t[lane], self.t_end);
    }

    #[inline(always)]
    fn remember(&mut self, lane: usize, memory: PiMemory) {
        self.log2_last_error[lane] = memory.log2_last_error;
        self.max_factor[lane] = memory.max_factor;
    }

    #[inline(always)]
    fn memory(&self, lane: usize) -> PiMemory {
        PiMemory {
            log2_last_error: self.log2_last_error[lane],
            max_factor: self.max_factor[lane],
        }
    }

    /// Sets size and end time of the next step in the first `lanes` lanes; the size is 0 in idle lanes.
    #[inline(always)]
    pub(crate) fn set_steps(&mut self, lanes: usize) {
        for lane in 0..lanes {
            let h = self.proposed[lane].min(self.max_step);
            let end = StepEnd::new(h, self.t[lane], self.segment_end[lane], self.t_end);
            self.is_last[lane] = end.is_last;
            self.end[lane] = end.t;
            self.h[lane] = self.flight[lane].map_or(0.0, |_| end.h);
        }
    }

    #[inline(always)]
    pub(crate) fn is_exhausted(&self, lane: usize) -> bool {
        let allowed = self
            .max_steps
            .saturating_add(steps_at(&self.breaks[lane]) as u64);
        self.steps[lane] + self.rejected[lane] >= allowed
    }

    pub(crate) fn stats(&self, lane: usize) -> SolverStats {
        let (steps, rejected) = (self.steps[lane], self.rejected[lane]);
        SolverStats {
            steps: steps as usize,
            rejected: rejected as usize,
            // Two evaluations precede the first step: one at the start, one for the size of the first step.
            evaluations: (2 + self.evaluations * (steps + rejected)) as usize,
        }
    }

    /// Counts the step of every lane whose error norm is at most 1 as accepted, and proposes the next size.
    #[inline(always)]
    #[allow(clippy::needless_range_loop)]
    pub(crate) fn accept(&mut self, errors: &[f64; MAX_LANES]) {
        // One loop without branches over arrays of the same length, which the compiler vectorizes.
        for lane in 0..MAX_LANES {
            let error = errors[lane];
            let (factor, memory) = self.gains.after_accepted(self.memory(lane), error);
            let is_accepted = error <= 1.0;
            self.log2_last_error[lane] = if is_accepted {
                memory.log2_last_error
            } else {
                self.log2_last_error[lane]
            };
            self.max_factor[lane] = if is_accepted {
                memory.max_factor
            } else {
                self.max_factor[lane]
            };
            self.proposed[lane] = if is_accepted {
                self.h[lane] * factor
            } else {
                self.proposed[lane]
            };
            self.steps[lane] += u64::from(is_accepted);
        }
    }

    /// Counts a step as rejected, and proposes the part `cut` of its size, or one by its error. Whether that is enough
    /// for a step.
    #[inline(always)]
    pub(crate) fn reject(&mut self, lane: usize, error: f64, cut: Option<f64>) -> bool {
        self.rejected[lane] += 1;
        let mut memory = self.memory(lane);
        let retried = self.gains.after_rejected(&mut memory, error);
        self.proposed[lane] = self.h[lane] * cut.unwrap_or(retried);
        self.remember(lane, memory);
        self.proposed[lane] > self.min_step
    }

    /// Whether the part `cut` of a step is long enough for a step; one that is not may fly over what is in it.
    pub(crate) fn may_cut(&self, lane: usize, cut: f64) -> bool {
        self.h[lane] * cut > self.min_step
    }

    /// Updates time and value of the maximum height of the flight in a lane.
    #[inline(always)]
    pub(crate) fn rise(&mut self, lane: usize, time: f64, height: f64) {
        if height > self.apex[lane].1 {
            self.apex[lane] = (time, height);
        }
    }
}
