//! Step sizes, counts and apexes of the lanes.

use super::FlightSpan;
use crate::method::tableau::Tableau;
use crate::options::{IntegrationOptions, SolverStats};
use crate::solver::{FINAL_STEP_SLACK, MIN_RELATIVE_STEP};
use crate::step_control::PiController;

/// Maximum number of lanes.
pub(crate) const MAX_LANES: usize = 8;

/// Flight, time, step size and step counts of each lane.
pub(crate) struct Control {
    /// Number of the flight in the lane; `None` where the lane is idle.
    pub flight: [Option<u64>; MAX_LANES],
    /// Time at the start of the step.
    pub t: [f64; MAX_LANES],
    /// Proposed size of the next step.
    pub proposed: [f64; MAX_LANES],
    /// Size of the step; 0 in idle lanes.
    pub h: [f64; MAX_LANES],
    /// Time at the end of the step.
    pub end: [f64; MAX_LANES],
    /// Whether the step leads to the final time.
    pub is_last: [bool; MAX_LANES],
    /// Greatest height so far: (time, height).
    pub apex: [(f64, f64); MAX_LANES],
    pub stats: [SolverStats; MAX_LANES],
    controllers: [PiController; MAX_LANES],
    new_controller: PiController,
    t_end: f64,
    max_step: f64,
    min_step: f64,
    max_steps: usize,
}

/// Result of the error test.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Verdict {
    Accepted,
    Rejected,
    /// Rejected, and a shorter step would be below the minimum.
    TooSmall,
}

impl Control {
    pub(crate) fn new(tableau: &Tableau, span: &FlightSpan, options: &IntegrationOptions) -> Self {
        let controller = PiController::new(
            tableau.error_order,
            tableau.pi_beta,
            tableau.step_factor_bounds,
        );
        Control {
            flight: [None; MAX_LANES],
            t: [0.0; MAX_LANES],
            proposed: [0.0; MAX_LANES],
            h: [0.0; MAX_LANES],
            end: [0.0; MAX_LANES],
            is_last: [false; MAX_LANES],
            apex: [(0.0, f64::NAN); MAX_LANES],
            stats: [SolverStats::default(); MAX_LANES],
            controllers: [controller; MAX_LANES],
            new_controller: controller,
            t_end: span.t_end,
            max_step: options.max_step,
            min_step: MIN_RELATIVE_STEP * span.t_end,
            max_steps: options.max_steps,
        }
    }

    /// Puts a flight into a lane.
    #[inline(always)]
    pub(crate) fn start(&mut self, lane: usize, flight: u64, h: f64, height: f64) {
        self.flight[lane] = Some(flight);
        self.t[lane] = 0.0;
        self.proposed[lane] = h;
        self.apex[lane] = (0.0, height);
        self.controllers[lane] = self.new_controller;
        self.stats[lane] = SolverStats {
            evaluations: 2,
            ..SolverStats::default()
        };
    }

    /// Sets the size and the end of the next step of every lane.
    #[inline(always)]
    pub(crate) fn set_steps(&mut self, lanes: usize) {
        for lane in 0..lanes {
            let h = self.proposed[lane].min(self.max_step);
            let remaining = self.t_end - self.t[lane];
            let is_last = h >= remaining * (1.0 - FINAL_STEP_SLACK);
            let h = if is_last { remaining } else { h };
            self.is_last[lane] = is_last;
            self.end[lane] = if is_last {
                self.t_end
            } else {
                self.t[lane] + h
            };
            self.h[lane] = match self.flight[lane] {
                Some(_) => h,
                None => 0.0,
            };
        }
    }

    /// Whether the lane has had as many steps as are allowed.
    #[inline(always)]
    pub(crate) fn is_exhausted(&self, lane: usize) -> bool {
        let stats = &self.stats[lane];
        stats.steps + stats.rejected >= self.max_steps
    }

    /// Judges the step of a lane by its error norm and proposes the size of the next.
    #[inline(always)]
    pub(crate) fn judge(&mut self, lane: usize, error: f64, evaluations: usize) -> Verdict {
        let (stats, h) = (&mut self.stats[lane], self.h[lane]);
        stats.evaluations += evaluations;
        if error <= 1.0 {
            stats.steps += 1;
            self.proposed[lane] = h * self.controllers[lane].factor_after_accepted(error);
            return Verdict::Accepted;
        }
        stats.rejected += 1;
        self.proposed[lane] = h * self.controllers[lane].factor_after_rejected(error);
        if self.proposed[lane] <= self.min_step {
            Verdict::TooSmall
        } else {
            Verdict::Rejected
        }
    }

    /// Records a height, if it is the greatest.
    #[inline(always)]
    pub(crate) fn rise(&mut self, lane: usize, time: f64, height: f64) {
        if height > self.apex[lane].1 {
            self.apex[lane] = (time, height);
        }
    }
}
