//! Functions that integrate initial value problems, one for each kind of output.

use crate::dense_output::DenseOutput;
use crate::event::{Event, EventAction};
use crate::input::failure;
use crate::method::ROWS;
use crate::solver::{Endpoint, StepObserver, solve};
use crate::{
    IntegrationError, IntegrationFailure, IntegrationOptions, OdeRhs, SolverStats, Trajectory,
};
use std::ops::Range;

const RESERVED_STEPS: usize = 64;

/// Integrates from the time `start.0` and the state `start.1` to the time `t_end`, or to the first terminal event,
/// and returns the trajectory with its dense output.
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
        projection: rhs.projection(),
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
    let mut write = |index: usize, sample: Sample<'_>| {
        let to = &mut states[index * n..][..n];
        match sample {
            Sample::State(state) => to.copy_from_slice(state),
            Sample::Step(step, s) => step.state(s, to),
        }
    };
    solve_at(rhs, start, times, options, events, &mut write)
}

/// Integrates to the last of `times` and calls `callback` with the index of each output time and the state at that
/// time.
///
/// Only the state components in `ranges` are computed; other components of the state that `callback` receives
/// are not valid. If the integration fails, `callback` may already have been called for some of the output times.
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
    let mut state = start.1.clone();
    let mut write = |index: usize, sample: Sample<'_>| match sample {
        Sample::State(state) => callback(index, state),
        Sample::Step(step, s) => {
            step.components(s, ranges, state.as_mut());
            callback(index, state.as_ref());
        }
    };
    solve_at(rhs, start, times, options, &mut [], &mut write)?;
    Ok(())
}

/// State at an output time: known, or that at a fraction of a step.
enum Sample<'a> {
    State(&'a [f64]),
    Step(&'a DenseOutput<'a>, f64),
}

/// Integrates to the last of `times` and passes the state at each of them, with its index, to `write`. Panics if the
/// times decrease or precede the initial time.
fn solve_at<D: OdeRhs>(
    rhs: &mut D,
    start: (f64, &D::State),
    times: &[f64],
    options: &IntegrationOptions,
    events: &mut [Event<'_, D::State>],
    write: &mut dyn FnMut(usize, Sample<'_>),
) -> Result<Endpoint<D::State>, IntegrationError> {
    assert!(times.is_sorted(), "output times must not decrease");
    let at_start = times.iter().take_while(|t| **t == start.0).count();
    assert!(
        times.get(at_start).is_none_or(|t| *t > start.0),
        "output times must not precede the initial time"
    );
    for index in 0..at_start {
        write(index, Sample::State(start.1.as_ref()));
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
        write,
    };
    let end = solve(rhs, start, last, options, events, &mut sampler)?;
    for index in sampler.next..times.len() {
        (sampler.write)(index, Sample::State(end.state.as_ref()));
    }
    Ok(end)
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

/// Step observer that passes on the states at the output times.
struct Sampler<'a> {
    times: &'a [f64],
    next: usize,
    write: &'a mut dyn FnMut(usize, Sample<'_>),
}

impl StepObserver for Sampler<'_> {
    fn needs_dense_output(&self, _: f64, t_end: f64) -> bool {
        self.times.get(self.next).is_some_and(|t| *t <= t_end)
    }

    fn on_step(&mut self, step: DenseOutput<'_>, until: f64) {
        while let Some(&t) = self.times.get(self.next).filter(|t| **t <= until) {
            (self.write)(self.next, Sample::Step(&step, (t - step.t) / step.h));
            self.next += 1;
        }
    }
}

struct NoObserver;

impl StepObserver for NoObserver {
    fn needs_dense_output(&self, _: f64, _: f64) -> bool {
        false
    }

    fn on_step(&mut self, _: DenseOutput<'_>, _: f64) {}
}
