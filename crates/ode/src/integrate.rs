//! Functions that integrate initial value problems, one for each kind of output.

use crate::dense_output::DenseOutput;
use crate::error::{IntegrationError, IntegrationFailure};
use crate::event::{Event, EventAction};
use crate::input::failure;
use crate::method::ROWS;
use crate::options::{IntegrationOptions, SolverStats};
use crate::rhs::{OdeRhs, StateVector};
use crate::solver::{Endpoint, StepObserver, solve};
use crate::trajectory::Trajectory;
use std::ops::Range;

/// Number of steps for which a trajectory reserves memory in advance.
const RESERVED_STEPS: usize = 64;

/// Integrates from the time `start.0` and the state `start.1` to the time `t_end`, or to the first terminal event,
/// and returns the trajectory with its dense output.
///
/// # Errors
/// [`IntegrationError`] if the integration fails; its `cause` is the return code.
///
/// ```
/// use ode::{Event, IntegrationOptions, integrate, rhs_from_fn};
///
/// // Free fall from 20 m: height (m), vertical velocity (m/s).
/// let mut rhs = rhs_from_fn(&["z", "vz"], |_, x: &[f64; 2], dx: &mut [f64; 2]| *dx = [x[1], -9.81]);
/// let ground = Event::falls_to("ground", 0, 0.0).terminal();
/// let options = IntegrationOptions::default();
/// let fall = integrate(&mut rhs, (0.0, &[20.0, 0.0]), 10.0, &options, &mut [ground])?;
/// assert!((fall.end - (2.0 * 20.0 / 9.81_f64).sqrt()).abs() < 1e-12);
/// assert!((fall.sample(1.0).unwrap()[0] - (20.0 - 9.81 / 2.0)).abs() < 1e-12);
/// # Ok::<(), ode::IntegrationError>(())
/// ```
pub fn integrate<D: OdeRhs>(
    rhs: &mut D,
    start: (f64, &D::State),
    t_end: f64,
    options: &IntegrationOptions,
    events: &mut [Event<'_, D::State>],
) -> Result<Trajectory, IntegrationError> {
    let states = start.1.as_ref().len();
    let mut recorder = Recorder {
        steps: Vec::with_capacity(RESERVED_STEPS),
        rows: Vec::with_capacity(RESERVED_STEPS * ROWS * states),
    };
    let end = solve(rhs, start, t_end, options, events, &mut recorder)?;
    Ok(Trajectory {
        method: options.method,
        states,
        steps: recorder.steps,
        rows: recorder.rows,
        start: start.0,
        end: end.time,
        end_state: end.state.as_ref().to_vec(),
        terminal_event: end.event,
        events: end.occurrences,
        stats: end.stats,
    })
}

/// Integrates from the time `start.0` and the state `start.1` to the first terminal event, which must occur before the
/// time `t_end`, and returns the trajectory with its dense output.
///
/// # Errors
/// [`IntegrationError`] if the integration fails; its cause is [`IntegrationFailure::NoTerminalEvent`] if no terminal
/// event occurs.
pub fn integrate_to_event<D: OdeRhs>(
    rhs: &mut D,
    start: (f64, &D::State),
    t_end: f64,
    options: &IntegrationOptions,
    events: &mut [Event<'_, D::State>],
) -> Result<Trajectory, IntegrationError> {
    let trajectory = integrate(rhs, start, t_end, options, events)?;
    if trajectory.terminal_event.is_some() {
        return Ok(trajectory);
    }
    let terminal = events.iter().filter(|e| e.action == EventAction::Stop);
    let names: Vec<&str> = terminal.map(|e| &*e.name).collect();
    let event = names.join(", ");
    Err(failure(
        rhs,
        trajectory.end,
        &trajectory.end_state,
        IntegrationFailure::NoTerminalEvent { event },
    ))
}

/// Integrates from the time `start.0` and the state `start.1` to the time `t_end`, or to the first terminal event.
/// Returns only the final state and the events; dense output is not stored.
///
/// # Errors
/// [`IntegrationError`] if the integration fails; its `cause` is the return code.
pub fn integrate_to_end<D: OdeRhs>(
    rhs: &mut D,
    start: (f64, &D::State),
    t_end: f64,
    options: &IntegrationOptions,
    events: &mut [Event<'_, D::State>],
) -> Result<Endpoint<D::State>, IntegrationError> {
    solve(rhs, start, t_end, options, events, &mut NoObserver)
}

/// Integrates to the last of `times` (non-decreasing, not before the initial time) and writes the states at these
/// times, concatenated, to `states`. Times past a terminal event get the state at the event.
///
/// # Errors
/// [`IntegrationError`] if the integration fails; its `cause` is the return code.
///
/// # Panics
/// If the length of `states` is not the number of times multiplied by the state length, or `times` decrease or begin
/// before the initial time.
pub fn integrate_at<D: OdeRhs>(
    rhs: &mut D,
    start: (f64, &D::State),
    times: &[f64],
    options: &IntegrationOptions,
    events: &mut [Event<'_, D::State>],
    states: &mut [f64],
) -> Result<Endpoint<D::State>, IntegrationError> {
    let n = start.1.as_ref().len();
    assert_eq!(states.len(), n * times.len(), "one state per output time");
    let at_start = count_at_start(start.0, times);
    for to in states.chunks_mut(n).take(at_start) {
        to.copy_from_slice(start.1.as_ref());
    }
    let Some(&last) = times[at_start..].last() else {
        return Ok(Endpoint {
            time: start.0,
            state: start.1.clone(),
            event: None,
            occurrences: Vec::new(),
            stats: SolverStats::default(),
        });
    };
    let mut sampler = Sampler {
        times,
        next: at_start,
        states,
        state_len: n,
    };
    let end = solve(rhs, start, last, options, events, &mut sampler)?;
    let next = sampler.next;
    for to in states.chunks_mut(n).skip(next) {
        to.copy_from_slice(end.state.as_ref());
    }
    Ok(end)
}

/// Integrates to the last of `times` and calls `callback` with the index of each output time and the state at that
/// time.
///
/// Only the state components in `ranges` are computed; other components of the state that `callback` receives
/// are not valid. If the integration fails, `callback` may already have been called for some of the output times.
///
/// # Errors
/// [`IntegrationError`] if the integration fails; its `cause` is the return code.
///
/// # Panics
/// If `times` decrease or begin before the initial time, or a range exceeds the state length.
pub fn integrate_with_callback<D: OdeRhs>(
    rhs: &mut D,
    start: (f64, &D::State),
    times: &[f64],
    options: &IntegrationOptions,
    ranges: &[Range<usize>],
    mut callback: impl FnMut(usize, &[f64]),
) -> Result<(), IntegrationError> {
    let at_start = count_at_start(start.0, times);
    for index in 0..at_start {
        callback(index, start.1.as_ref());
    }
    let Some(&last) = times[at_start..].last() else {
        return Ok(());
    };
    let mut caller = Caller {
        times,
        next: at_start,
        state: start.1.clone(),
        ranges,
        callback,
    };
    solve(rhs, start, last, options, &mut [], &mut caller)?;
    Ok(())
}

/// Returns the number of leading output times equal to the initial time. Panics if the output times decrease or precede
/// the initial time.
fn count_at_start(start: f64, times: &[f64]) -> usize {
    assert!(times.is_sorted(), "output times must not decrease");
    let at_start = times.iter().take_while(|t| **t == start).count();
    assert!(
        times.get(at_start).is_none_or(|t| *t > start),
        "output times must not precede the initial time"
    );
    at_start
}

/// Step observer that stores the dense output of all accepted steps.
struct Recorder {
    /// Start time and size of each step.
    steps: Vec<(f64, f64)>,
    rows: Vec<f64>,
}

impl StepObserver for Recorder {
    fn needs_dense_output(&self, _: f64, _: f64) -> bool {
        true
    }

    #[inline(always)]
    fn on_step(&mut self, step: DenseOutput<'_>, _: f64) {
        self.steps.push((step.t, step.h));
        for row in step.rows {
            self.rows.extend_from_slice(row);
        }
    }
}

/// Step observer that writes the states at the output times to an array.
struct Sampler<'a> {
    times: &'a [f64],
    /// Index of the next output time.
    next: usize,
    states: &'a mut [f64],
    state_len: usize,
}

impl StepObserver for Sampler<'_> {
    fn needs_dense_output(&self, _: f64, t_end: f64) -> bool {
        self.times.get(self.next).is_some_and(|t| *t <= t_end)
    }

    fn on_step(&mut self, step: DenseOutput<'_>, until: f64) {
        while let Some(&t) = self.times.get(self.next).filter(|t| **t <= until) {
            let to = &mut self.states[self.next * self.state_len..][..self.state_len];
            step.state((t - step.t) / step.h, to);
            self.next += 1;
        }
    }
}

/// Step observer that calls a function with selected state components at the output times.
struct Caller<'a, X, F> {
    times: &'a [f64],
    /// Index of the next output time.
    next: usize,
    state: X,
    ranges: &'a [Range<usize>],
    callback: F,
}

impl<X: StateVector, F: FnMut(usize, &[f64])> StepObserver for Caller<'_, X, F> {
    fn needs_dense_output(&self, _: f64, t_end: f64) -> bool {
        self.times.get(self.next).is_some_and(|t| *t <= t_end)
    }

    fn on_step(&mut self, step: DenseOutput<'_>, until: f64) {
        while let Some(&t) = self.times.get(self.next).filter(|t| **t <= until) {
            let s = (t - step.t) / step.h;
            step.components(s, self.ranges, self.state.as_mut());
            (self.callback)(self.next, self.state.as_ref());
            self.next += 1;
        }
    }
}

/// Step observer that ignores all steps.
struct NoObserver;

impl StepObserver for NoObserver {
    fn needs_dense_output(&self, _: f64, _: f64) -> bool {
        false
    }

    fn on_step(&mut self, _: DenseOutput<'_>, _: f64) {}
}
