//! Step loop of an integration: error test, event location, and calls of the step observer.

mod overlooked;

use self::overlooked::Watch;
use crate::dense_output::{DenseOutput, HermiteStep};
use crate::event::{Event, EventAction, Occurrence};
use crate::input::{check_input, failure, first_non_finite, non_finite_derivative, step_too_small};
use crate::method::{ErrorTolerance, Stepper};
use crate::projection::Projection;
use crate::step_control::{PiGains, PiMemory, initial_step};
use crate::time_breaks::{StepEnd, just_after, segment_end, steps_at};
use crate::{IntegrationError, IntegrationFailure, IntegrationOptions, OdeRhs, SolverStats};

/// Minimum step size as a fraction of the largest absolute time of the integration.
pub(crate) const MIN_RELATIVE_STEP: f64 = 1e-14;

/// Final time and state of an integration.
#[derive(Clone, Debug, PartialEq)]
pub struct Endpoint<X> {
    /// Final time: the requested one, or that of the terminal event which ended the integration.
    pub time: f64,
    /// State at the final time.
    pub state: X,
    /// Name of the terminal event; `None` where the requested final time was reached.
    pub event: Option<String>,
    /// Recorded events, in order of time; a terminal event is the last.
    pub occurrences: Vec<Occurrence>,
    /// Numbers of steps and of right-hand side evaluations of the integration.
    pub stats: SolverStats,
}

/// Observer of accepted steps, which receives their dense output.
pub(crate) trait StepObserver {
    /// Whether the observer needs dense output for the step from `t` to `t_end`.
    fn needs_dense_output(&self, t: f64, t_end: f64) -> bool;
    /// Receives the dense output of an accepted step; times after `until`, a terminal event, must be ignored.
    fn on_step(&mut self, step: DenseOutput<'_>, until: f64);
}

/// Integrates from the initial time and state `start` to the time `t_end`, or to the first terminal event. Passes each
/// accepted step to `observer`, a trait object, so that the step loop is compiled once for each right-hand side.
pub(crate) fn solve<D: OdeRhs>(
    rhs: &mut D,
    start: (f64, &D::State),
    t_end: f64,
    options: &IntegrationOptions,
    events: &mut [Event<'_, D::State>],
    observer: &mut dyn StepObserver,
) -> Result<Endpoint<D::State>, IntegrationError> {
    Solver::new(rhs, start, t_end, options, events, observer)?.run()
}

/// Integration in progress: problem, options, and the state between steps.
struct Solver<'s, 'e, D: OdeRhs> {
    rhs: &'s mut D,
    events: &'s mut [Event<'e, D::State>],
    observer: &'s mut dyn StepObserver,
    projection: Option<Projection>,
    t: f64,
    t_end: f64,
    /// Time at which the current segment ends: just before a time break, or `t_end`.
    segment_end: f64,
    /// Proposed size of the next step, before it is limited by `max_step` and `segment_end`.
    h: f64,
    min_step: f64,
    max_step: f64,
    max_steps: usize,
    tolerance: ErrorTolerance,
    gains: PiGains,
    memory: PiMemory,
    stepper: Stepper<D::State>,
    dense_buffer: Vec<f64>,
    scratch: D::State,
    /// `None` where the right-hand side has no switches.
    watch: Option<Watch>,
    log: EventLog,
    stats: SolverStats,
}

/// Event occurrences that an integration has recorded so far, and the events located in its current step.
#[derive(Default)]
struct EventLog {
    occurrences: Vec<Occurrence>,
    /// Events located in the current step: (fraction of the step, event index).
    in_step: Vec<(f64, usize)>,
}

impl<'s, 'e, D: OdeRhs> Solver<'s, 'e, D> {
    fn new(
        rhs: &'s mut D,
        (t, x): (f64, &D::State),
        t_end: f64,
        options: &IntegrationOptions,
        events: &'s mut [Event<'e, D::State>],
        observer: &'s mut dyn StepObserver,
    ) -> Result<Self, IntegrationError> {
        let (x, mut dx) = (x.clone(), x.clone());
        check_input(rhs, t, &x, t_end, options)?;
        rhs.derivative(just_after(rhs.time_breaks(), t), &x, &mut dx);
        if let Some(i) = first_non_finite(&dx) {
            return Err(non_finite_derivative(rhs, t, &x, i, dx.as_ref()[i]));
        }
        check_initial_events(rhs, t, (&x, &dx), events)?;
        let tolerance = options.tolerance(rhs.error_controlled_len());
        let mut evaluations = 1;
        let tableau = options.method.tableau();
        let h = options.first_step.unwrap_or_else(|| {
            evaluations += 1;
            let max_step = options.max_step.min(t_end - t);
            initial_step(rhs, t, (&x, &dx), tableau.error_order, &tolerance, max_step)
        });
        let gains = PiGains::new(tableau);
        Ok(Solver {
            projection: rhs.projection(),
            t,
            t_end,
            segment_end: segment_end(rhs.time_breaks(), t, t_end),
            h,
            min_step: MIN_RELATIVE_STEP * t.abs().max(t_end.abs()).max(t_end - t),
            max_step: options.max_step,
            max_steps: options
                .max_steps
                .saturating_add(steps_at(rhs.time_breaks())),
            tolerance,
            gains,
            memory: gains.start(),
            dense_buffer: Vec::new(),
            scratch: x.clone(),
            stepper: Stepper::new(options.method, x, dx),
            watch: rhs.switches().map(Watch::new),
            log: EventLog::default(),
            stats: SolverStats {
                evaluations,
                ..SolverStats::default()
            },
            rhs,
            events,
            observer,
        })
    }

    fn run(mut self) -> Result<Endpoint<D::State>, IntegrationError> {
        loop {
            let end = self.step()?;
            if let Some((time, event)) = self.handle_step(end)? {
                let event = Some(self.events[event].name.to_string());
                return Ok(self.endpoint(time, event));
            }
            self.stepper.advance();
            self.t = end.t;
            if let Some(projection) = &self.projection
                && projection.project(end.t, self.stepper.start_mut().0.as_mut())
                && !end.is_last
            {
                self.begin_step();
            }
            if end.is_last {
                self.scratch.clone_from(&self.stepper.x);
                return Ok(self.endpoint(end.t, None));
            }
            if end.t == self.segment_end {
                self.begin_segment();
            }
        }
    }

    /// Begins the segment after a time break, at which the derivative may jump.
    #[cold]
    fn begin_segment(&mut self) {
        let breaks = self.rhs.time_breaks();
        self.segment_end = segment_end(breaks, self.t, self.t_end);
        self.begin_step();
    }

    /// Computes the derivative at the start of the next step.
    #[cold]
    fn begin_step(&mut self) {
        if let Some(watch) = &mut self.watch {
            watch.begin();
        }
        let start = just_after(self.rhs.time_breaks(), self.t);
        let (x, dx) = self.stepper.start_mut();
        self.rhs.derivative(start, x, dx);
        self.stats.evaluations += 1;
    }

    /// Result of an integration that ended at the time `time`; `event` is the name of the terminal event that ended it,
    /// or `None` at the requested final time. The field `scratch` must contain the final state.
    fn endpoint(self, time: f64, event: Option<String>) -> Endpoint<D::State> {
        Endpoint {
            time,
            state: self.scratch,
            event,
            occurrences: self.log.occurrences,
            stats: self.stats,
        }
    }

    /// Tries steps until one passes the error test; sets the size of the next step.
    #[inline]
    fn step(&mut self) -> Result<StepEnd, IntegrationError> {
        loop {
            let h = self.h.min(self.max_step);
            let end = StepEnd::new(h, self.t, self.segment_end, self.t_end);
            if self.stats.steps + self.stats.rejected >= self.max_steps {
                return Err(self.too_many_steps());
            }
            let error = self.try_step(end);
            let overlooked = match error <= 1.0 {
                true => self.overlooked(end),
                false => None,
            };
            // A part too short for a step may be flown over.
            let overlooked = overlooked.filter(|cut| end.h * cut > self.min_step);
            if error <= 1.0 && overlooked.is_none() {
                self.stats.steps += 1;
                let (factor, memory) = self.gains.after_accepted(self.memory, error);
                (self.h, self.memory) = (end.h * factor, memory);
                if let Some(watch) = &mut self.watch {
                    watch.advance();
                }
                return Ok(end);
            }
            self.stats.rejected += 1;
            let retried = self.gains.after_rejected(&mut self.memory, error);
            self.h = end.h * overlooked.unwrap_or(retried);
            if self.h <= self.min_step {
                let (x, dx) = (&self.stepper.x, self.stepper.dx());
                return Err(step_too_small(self.rhs, self.t, x, dx, self.h));
            }
        }
    }

    /// Tries a step and returns its error norm; NaN if state or derivative at its end is not finite.
    #[inline(always)]
    fn try_step(&mut self, end: StepEnd) -> f64 {
        let (stepper, tolerance) = (&mut self.stepper, &self.tolerance);
        let error = stepper.try_step(self.rhs, self.t, end.h, tolerance);
        self.stats.evaluations += stepper.tableau.rows.len();
        if error <= 1.0 {
            self.stepper.accept(self.rhs, end.t);
            let is_finite = first_non_finite(self.stepper.x_end()).is_none()
                && first_non_finite(self.stepper.dx_end()).is_none();
            if !is_finite {
                return f64::NAN;
            }
        }
        error
    }

    /// Records the events in an accepted step, and passes the dense output of the step to the observer if needed.
    #[inline]
    fn handle_step(&mut self, end: StepEnd) -> Result<Option<(f64, usize)>, IntegrationError> {
        let (t, h) = (self.t, end.h);
        let step = HermiteStep::of(&self.stepper, t, h);
        let mut may_occur = false;
        for event in self.events.iter_mut() {
            may_occur |= event.may_occur(&step, &mut self.scratch);
        }
        if !may_occur && !self.observer.needs_dense_output(t, end.t) {
            return Ok(None);
        }
        let tableau = self.stepper.tableau;
        self.stats.evaluations += tableau.dense_rows.len();
        let rows = self
            .stepper
            .dense_rows(self.rhs, (t, h), &mut self.dense_buffer);
        let step = DenseOutput {
            method: tableau.method,
            t,
            h,
            rows,
            projection: self.projection.as_deref(),
        };
        let stop = match may_occur {
            true => self
                .log
                .record(self.rhs, &step, self.events, &mut self.scratch)?,
            false => None,
        };
        self.observer
            .on_step(step, stop.map_or(end.t, |(time, _)| time));
        Ok(stop)
    }

    #[cold]
    fn too_many_steps(&self) -> IntegrationError {
        let steps = self.stats.steps + self.stats.rejected;
        let cause = IntegrationFailure::TooManySteps { steps };
        failure(self.rhs, self.t, self.stepper.x.as_ref(), cause)
    }
}

impl EventLog {
    /// Records the events of a step in order of time, up to the first terminal event.
    #[cold]
    fn record<D: OdeRhs>(
        &mut self,
        rhs: &mut D,
        step: &DenseOutput<'_>,
        events: &mut [Event<'_, D::State>],
        state: &mut D::State,
    ) -> Result<Option<(f64, usize)>, IntegrationError> {
        self.locate(rhs, step, events, state);
        for &(s, index) in &self.in_step {
            step.state(s, state.as_mut());
            let (time, event) = (step.t + s * step.h, &events[index]);
            if event.action == EventAction::Fail {
                let reason = event.name.to_string();
                let cause = IntegrationFailure::Limit { reason };
                return Err(failure(rhs, time, state.as_ref(), cause));
            }
            self.occurrences.push(Occurrence {
                event: event.name.to_string(),
                time,
                state: state.as_ref().to_vec(),
            });
            if event.action == EventAction::Stop {
                return Ok(Some((time, index)));
            }
        }
        Ok(None)
    }

    /// Locates all events in a step and stores them in `in_step`, in order of time.
    fn locate<D: OdeRhs>(
        &mut self,
        rhs: &mut D,
        step: &DenseOutput<'_>,
        events: &mut [Event<'_, D::State>],
        like: &D::State,
    ) {
        self.in_step.clear();
        let (mut x, mut dx, mut fractions) = (like.clone(), like.clone(), Vec::new());
        for (index, event) in events.iter_mut().enumerate() {
            fractions.clear();
            event.locate(rhs, step, [&mut x, &mut dx], &mut fractions);
            self.in_step.extend(fractions.iter().map(|s| (*s, index)));
        }
        self.in_step.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
}

/// Returns an error if the initial state is past a terminal event or a limit of validity, that is on the negative side
/// of the zero of its event function; `Event::is_past` decides the case of a zero value.
fn check_initial_events<D: OdeRhs>(
    rhs: &mut D,
    t: f64,
    (x, dx): (&D::State, &D::State),
    events: &mut [Event<'_, D::State>],
) -> Result<(), IntegrationError> {
    for event in events {
        if event.action == EventAction::Record || !event.is_past(rhs, t, x, dx) {
            continue;
        }
        let name = event.name.to_string();
        let cause = match event.action {
            EventAction::Fail => IntegrationFailure::Limit { reason: name },
            _ => IntegrationFailure::StartsPastEvent { event: name },
        };
        return Err(failure(rhs, t, x.as_ref(), cause));
    }
    Ok(())
}
