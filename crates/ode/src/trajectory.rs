//! Solution of an initial value problem, with dense output.

use crate::dense_output::DenseOutput;
use crate::method::{Method, ROWS};
use crate::projection::Projection;
use crate::{Occurrence, SolverStats};

/// Tolerance for sampling at a constant rate, as a fraction of the sampling interval: a sample closer than this to the
/// end of the trajectory is omitted, since the final state is always included.
const END_SLACK: f64 = 1e-6;

/// Solution x(t) of an initial value problem; dense output evaluates it at any time between its start and its end.
#[derive(Clone, Debug)]
pub struct Trajectory {
    pub(crate) method: Method,
    pub(crate) states: usize,
    pub(crate) steps: Vec<(f64, f64)>,
    /// Dense-output coefficients of all steps, concatenated in the order of the steps.
    pub(crate) rows: Vec<f64>,
    pub(crate) projection: Option<Projection>,
    /// Initial time, in the time unit of the right-hand side.
    pub start: f64,
    /// Final time: the requested one, or that of the terminal event which ended the integration.
    pub end: f64,
    /// State at the final time.
    pub end_state: Vec<f64>,
    /// Name of the terminal event; `None` where the requested final time was reached.
    pub terminal_event: Option<String>,
    /// Recorded events, in order of time; a terminal event is the last.
    pub events: Vec<Occurrence>,
    /// Numbers of steps and of right-hand side evaluations of the integration.
    pub stats: SolverStats,
}

impl Trajectory {
    /// Length of the state vector.
    pub fn states(&self) -> usize {
        self.states
    }

    /// State at the time `t`; `None` outside the trajectory.
    pub fn sample(&self, t: f64) -> Option<Vec<f64>> {
        if !(self.start <= t && t <= self.end) {
            return None;
        }
        if t == self.end {
            return Some(self.end_state.clone());
        }
        let following = self.steps.partition_point(|(start, _)| *start <= t);
        let step = self.step(following.saturating_sub(1));
        let mut state = vec![0.0; self.states];
        step.state((t - step.t) / step.h, &mut state);
        Some(state)
    }

    /// Dense output of the step with this index.
    fn step(&self, index: usize) -> DenseOutput<'_> {
        let length = ROWS * self.states;
        let rows = &self.rows[index * length..][..length];
        DenseOutput {
            projection: self.projection.as_deref(),
            ..DenseOutput::of_rows(self.method, self.steps[index], rows)
        }
    }

    /// Returns an iterator over (time, state) at `rate` samples per unit of time from the initial time on, and at the
    /// final time.
    ///
    /// # Panics
    /// If the rate is not positive.
    pub fn at_rate(&self, rate: f64) -> impl Iterator<Item = (f64, Vec<f64>)> {
        assert!(rate > 0.0, "a positive rate");
        let duration = self.end - self.start;
        let count = (duration * rate - END_SLACK).ceil().max(0.0) as usize;
        let sample = move |i: usize| {
            let t = self.start + i as f64 / rate;
            (t, self.sample(t).unwrap_or_else(|| self.end_state.clone()))
        };
        let end = std::iter::once_with(|| (self.end, self.end_state.clone()));
        (0..count).map(sample).chain(end)
    }

    /// Start time and size of each accepted step.
    pub fn steps(&self) -> &[(f64, f64)] {
        &self.steps
    }
}
