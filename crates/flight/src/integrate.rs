//! The loop of steps.

use crate::control::{Control, first_step};
use crate::dynamics::{Dynamics, Storage};
use crate::error::{Cause, FlightError};
use crate::event::{Curve, Event, Occurrence, Step, Then};
use crate::method::dop853::Dop853;
use crate::method::tsit5::Tsit5;
use crate::method::wide::{AllFinite, WIDE};
use crate::method::{Method, Start, Stepper, Tolerance};

/// How a flight is computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Method.
    pub method: Method,
    /// Error allowed in a step, as a part of each state's size.
    pub relative: f64,
    /// Error allowed in a step beside that, in each state's own unit.
    pub absolute: f64,
    /// Longest step, s.
    pub longest_step: f64,
    /// First step, s; chosen by the derivatives where none.
    pub first_step: Option<f64>,
    /// Most steps, refused ones too, after which the flight is given up.
    pub most_steps: usize,
}

impl Default for Options {
    /// Tsit5 at 1e-6.
    fn default() -> Self {
        Options {
            method: Method::Tsit5,
            relative: 1e-6,
            absolute: 1e-6,
            longest_step: f64::INFINITY,
            first_step: None,
            most_steps: 100_000,
        }
    }
}

impl Options {
    /// Both tolerances, and the method that is quickest at them.
    pub fn tolerance(tolerance: f64) -> Options {
        let method = if tolerance < 1e-8 {
            Method::Dop853
        } else {
            Method::Tsit5
        };
        Options {
            method,
            relative: tolerance,
            absolute: tolerance,
            ..Options::default()
        }
    }
}

/// How much work a flight was.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Steps.
    pub steps: usize,
    /// Trials that were refused.
    pub refused: usize,
    /// How often the model was asked for a rate of change, by the steps and their curves.
    pub evaluations: usize,
}

/// Where a flight ended.
#[derive(Clone, Debug, PartialEq)]
pub struct End<X> {
    /// When, s.
    pub time: f64,
    /// The state.
    pub state: X,
    /// The event that ended it; none where it was the time.
    pub event: Option<String>,
    /// Events, in order of time.
    pub occurrences: Vec<Occurrence>,
    /// Work.
    pub work: Work,
}

/// Sees each step.
pub(crate) trait Observer {
    /// Whether it must see the curve of a step over these times.
    fn wants(&self, from: f64, to: f64) -> bool;
    /// A step's curve, of which the flight has the part up to the time `until`.
    fn see(&mut self, curve: Curve<'_>, until: f64);
}

/// Flies from (`t`, `x`) until the time `end` or an event that ends the flight.
pub(crate) fn integrate<D: Dynamics, O: Observer>(
    d: &mut D,
    (t, x): (f64, &D::State),
    end: f64,
    options: &Options,
    events: &mut [Event<'_, D::State>],
    observer: &mut O,
) -> Result<End<D::State>, FlightError> {
    match options.method {
        Method::Tsit5 => run::<D, O, Tsit5<D::State>>(d, t, x, end, options, events, observer),
        Method::Dop853 => run::<D, O, Dop853<D::State>>(d, t, x, end, options, events, observer),
    }
}

fn run<D: Dynamics, O: Observer, S: Stepper<D::State>>(
    d: &mut D,
    mut t: f64,
    x: &D::State,
    end: f64,
    options: &Options,
    events: &mut [Event<'_, D::State>],
    observer: &mut O,
) -> Result<End<D::State>, FlightError> {
    let mut x = x.clone();
    let mut dx = x.clone();
    check_start(d, t, &x, end, options)?;
    d.derivative(t, &x, &mut dx);
    if let Some(i) = not_finite(&dx) {
        return Err(no_answer(d, t, &x, i, dx.as_ref()[i]));
    }
    for event in events.iter_mut().filter(|event| event.then != Then::Record) {
        if event.is_past(d, t, &x, &dx) {
            let event_name = event.name.to_string();
            let fails = event.then == Then::Fail;
            let cause = if fails {
                Cause::Limit { reason: event_name }
            } else {
                Cause::StartsBeyond { event: event_name }
            };
            return Err(fail(d, t, &x, cause));
        }
    }

    let within = Tolerance {
        relative: options.relative,
        absolute: options.absolute,
        controlled: d.controlled(),
    };
    let mut control = Control::new(S::ORDER, S::MEMORY, S::FACTORS);
    let mut stepper = S::new(&x);
    let mut found: Vec<(f64, usize)> = Vec::new();
    let (mut room, mut scratch) = (Vec::new(), x.clone());
    let mut occurrences = Vec::new();
    let mut work = Work {
        evaluations: 1,
        ..Work::default()
    };
    let shortest = 1e-14 * t.abs().max(end.abs()).max(end - t);
    let mut h = match options.first_step {
        Some(h) => h,
        None => {
            work.evaluations += 1;
            let longest = options.longest_step.min(end - t);
            first_step(d, &Start { t, x: &x, dx: &dx }, S::ORDER, &within, longest)
        }
    };

    loop {
        h = h.min(options.longest_step);
        let remains = end - t;
        // A last step a hair short of the end would leave one too short to take.
        let last = h >= remains * (1.0 - 1e-10);
        if last {
            h = remains;
        }
        let t_end = if last { end } else { t + h };
        if work.steps + work.refused >= options.most_steps {
            return Err(too_many_steps(d, t, &x, work));
        }
        let mut error = stepper.attempt(d, &Start { t, x: &x, dx: &dx }, h, &within);
        work.evaluations += S::EVALUATIONS;
        if error <= 1.0 {
            stepper.accept(d, t_end);
            if not_finite(stepper.end()).is_some() || not_finite(stepper.end_rate()).is_some() {
                error = f64::NAN;
            }
        }
        if error.is_nan() || error > 1.0 {
            work.refused += 1;
            h *= control.rejected(error);
            if h <= shortest {
                return Err(stuck(d, t, &x, &dx, h));
            }
            continue;
        }
        work.steps += 1;
        let next = h * control.accepted(error);

        let step = Step {
            t,
            h,
            x: &x,
            dx: &dx,
            end: stepper.end(),
            end_rate: stepper.end_rate(),
        };
        let mut happens = 0_u64;
        for (i, event) in events.iter_mut().enumerate() {
            happens |= u64::from(event.may_happen(&step, &mut scratch)) << i.min(63);
        }
        let mut stop = None;
        if happens != 0 || observer.wants(t, t_end) {
            let start = Start { t, x: &x, dx: &dx };
            let (rows, asked) = stepper.rows(d, &start, h, &mut room);
            work.evaluations += asked;
            let curve = Curve {
                method: S::METHOD,
                t,
                h,
                rows,
            };
            if happens != 0 {
                locate(d, &curve, events, &x, &mut found);
                for &(s, i) in &found {
                    curve.state(s, scratch.as_mut());
                    let (time, event) = (t + s * h, &events[i]);
                    let name = event.name.to_string();
                    if event.then == Then::Fail {
                        return Err(fail(d, time, &scratch, Cause::Limit { reason: name }));
                    }
                    occurrences.push(Occurrence {
                        event: name.clone(),
                        time,
                        state: scratch.as_ref().to_vec(),
                    });
                    if event.then == Then::Stop {
                        stop = Some((time, name));
                        break;
                    }
                }
            }
            observer.see(curve, stop.as_ref().map_or(t_end, |(time, _)| *time));
        }
        if let Some((time, event)) = stop {
            return Ok(End {
                time,
                state: scratch,
                event: Some(event),
                occurrences,
                work,
            });
        }
        x.clone_from(stepper.end());
        dx.clone_from(stepper.end_rate());
        t = t_end;
        if last {
            return Ok(End {
                time: end,
                state: x,
                event: None,
                occurrences,
                work,
            });
        }
        h = next;
    }
}

/// All that happens in a step, in order.
#[cold]
fn locate<D: Dynamics>(
    d: &mut D,
    curve: &Curve<'_>,
    events: &mut [Event<'_, D::State>],
    like: &D::State,
    found: &mut Vec<(f64, usize)>,
) {
    found.clear();
    let (mut a, mut b, mut times) = (like.clone(), like.clone(), Vec::new());
    for (i, event) in events.iter_mut().enumerate() {
        times.clear();
        event.locate(d, curve, [&mut a, &mut b], &mut times);
        found.extend(times.iter().map(|s| (*s, i)));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
}

fn not_finite<X: Storage>(x: &X) -> Option<usize> {
    // First without branches: it is asked of every step.
    let x = x.as_ref();
    let finite = match x.len() < WIDE {
        true => x.iter().fold(true, |all, v| all & v.is_finite()),
        false => lanes::dispatch(AllFinite(x)),
    };
    if finite {
        return None;
    }
    x.iter().position(|v| !v.is_finite())
}

#[cold]
fn check_start<D: Dynamics>(
    d: &D,
    t: f64,
    x: &D::State,
    end: f64,
    options: &Options,
) -> Result<(), FlightError> {
    let error = |what: String, value: f64| {
        Err(FlightError {
            time: t,
            states: Vec::new(),
            cause: Cause::Start { what, value },
        })
    };
    if let Some(i) = not_finite(x) {
        return error(format!("the state {}", d.state_name(i)), x.as_ref()[i]);
    }
    for (what, value) in [
        ("the time of the start, in s,", t),
        ("the time of the end, in s,", end),
    ] {
        if !value.is_finite() {
            return error(what.into(), value);
        }
    }
    if end <= t {
        return error("the time from start to end, in s,".into(), end - t);
    }
    let positive = [
        ("the relative tolerance", options.relative),
        ("the absolute tolerance", options.absolute),
        ("the longest step, in s,", options.longest_step),
        ("the first step, in s,", options.first_step.unwrap_or(1.0)),
    ];
    match positive
        .into_iter()
        .find(|(_, value)| value.is_nan() || *value <= 0.0)
    {
        Some((what, value)) => error(what.into(), value),
        None => Ok(()),
    }
}

#[cold]
fn fail<D: Dynamics>(d: &D, time: f64, x: &D::State, cause: Cause) -> FlightError {
    let states = x
        .as_ref()
        .iter()
        .enumerate()
        .take(d.controlled())
        .map(|(i, v)| (d.state_name(i).into_owned(), *v));
    FlightError {
        time,
        states: states.collect(),
        cause,
    }
}

#[cold]
fn too_many_steps<D: Dynamics>(d: &D, t: f64, x: &D::State, work: Work) -> FlightError {
    let steps = work.steps + work.refused;
    fail(d, t, x, Cause::TooManySteps { steps })
}

#[cold]
fn no_answer<D: Dynamics>(d: &D, t: f64, x: &D::State, i: usize, rate: f64) -> FlightError {
    fail(
        d,
        t,
        x,
        Cause::NotFinite {
            state: d.state_name(i).into_owned(),
            rate,
        },
    )
}

/// Why no step is short enough: the model has no answer just ahead, or changes too fast.
#[cold]
fn stuck<D: Dynamics>(d: &mut D, t: f64, x: &D::State, dx: &D::State, h: f64) -> FlightError {
    let (mut ahead, mut rate) = (x.clone(), dx.clone());
    for step in [h, 1e3 * h] {
        crate::method::combine(&mut ahead, x, step, [1.0], [dx]);
        d.derivative(t + step, &ahead, &mut rate);
        if let Some(i) = not_finite(&rate) {
            return no_answer(d, t, x, i, rate.as_ref()[i]);
        }
    }
    let speed = |i: &usize| dx.as_ref()[*i].abs() / (x.as_ref()[*i].abs() + 1.0);
    let fastest = (0..dx.as_ref().len())
        .max_by(|a, b| speed(a).total_cmp(&speed(b)))
        .unwrap_or(0);
    let state = (d.state_name(fastest).into_owned(), dx.as_ref()[fastest]);
    fail(d, t, x, Cause::StepTooSmall { step: h, state })
}
