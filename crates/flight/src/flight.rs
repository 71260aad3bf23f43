//! A flight: its curve at every time, its events and its end.

use crate::dynamics::{Dynamics, Storage};
use crate::error::{Cause, FlightError};
use crate::event::{Curve, Event, Occurrence};
use crate::integrate::{End, Observer, Options, Work, integrate};
use crate::method::{Method, ROWS};
use std::ops::Range;

/// A flight from its start to its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Flight {
    method: Method,
    states: usize,
    /// Start and length of each step, s.
    steps: Vec<(f64, f64)>,
    rows: Vec<f64>,
    /// When it starts, s.
    pub start: f64,
    /// When it ends, s.
    pub end: f64,
    /// The state at the end.
    pub end_state: Vec<f64>,
    /// The event that ended it; none where it was the time.
    pub ended_by: Option<String>,
    /// Events, in order of time.
    pub events: Vec<Occurrence>,
    /// Work.
    pub work: Work,
}

/// Flies from the time `from.0` (s) and the state `from.1` until the time `end` (s), or until an event that ends
/// the flight, and keeps the curve.
///
/// ```
/// use flight::{Event, Options, equations, fly};
///
/// // A stone: height, speed.
/// let mut stone = equations(&["z", "vz"], |_, x: &[f64; 2], dx: &mut [f64; 2]| *dx = [x[1], -9.81]);
/// let ground = Event::falls_to("ground", 0, 0.0).ends_flight();
/// let flight = fly(&mut stone, (0.0, &[20.0, 0.0]), 10.0, &Options::default(), &mut [ground]).unwrap();
/// assert!((flight.end - (2.0 * 20.0 / 9.81_f64).sqrt()).abs() < 1e-12);
/// assert!((flight.sample(1.0).unwrap()[0] - (20.0 - 9.81 / 2.0)).abs() < 1e-12);
/// ```
pub fn fly<D: Dynamics>(
    d: &mut D,
    from: (f64, &D::State),
    end: f64,
    options: &Options,
    events: &mut [Event<'_, D::State>],
) -> Result<Flight, FlightError> {
    let mut curve = Recorder {
        states: from.1.as_ref().len(),
        steps: Vec::new(),
        rows: Vec::new(),
    };
    curve.steps.reserve(64);
    curve.rows.reserve(64 * ROWS * curve.states);
    let finish = integrate(d, from, end, options, events, &mut curve)?;
    Ok(Flight {
        method: options.method,
        states: curve.states,
        steps: curve.steps,
        rows: curve.rows,
        start: from.0,
        end: finish.time,
        end_state: finish.state.as_ref().to_vec(),
        ended_by: finish.event,
        events: finish.occurrences,
        work: finish.work,
    })
}

/// Flies as [`fly`] does, but the flight must end by an event; where none comes by the time `end`, that is an error.
pub fn fly_to_event<D: Dynamics>(
    d: &mut D,
    from: (f64, &D::State),
    end: f64,
    options: &Options,
    events: &mut [Event<'_, D::State>],
) -> Result<Flight, FlightError> {
    let flight = fly(d, from, end, options, events)?;
    if flight.ended_by.is_some() {
        return Ok(flight);
    }
    let names: Vec<&str> = events
        .iter()
        .filter(|e| e.then == crate::event::Then::Stop)
        .map(|e| &*e.name)
        .collect();
    let states = flight
        .end_state
        .iter()
        .enumerate()
        .map(|(i, v)| (d.state_name(i).into_owned(), *v))
        .collect();
    Err(FlightError {
        time: flight.end,
        states,
        cause: Cause::NoEnd {
            event: names.join(", "),
        },
    })
}

/// Flies without keeping the curve: only the end and the events.
pub fn fly_to_end<D: Dynamics>(
    d: &mut D,
    from: (f64, &D::State),
    end: f64,
    options: &Options,
    events: &mut [Event<'_, D::State>],
) -> Result<End<D::State>, FlightError> {
    integrate(d, from, end, options, events, &mut Nobody)
}

/// Flies without keeping the curve, and writes the states at `times` (s, in order), one after the other, to
/// `samples`. Times beyond an event that ends the flight get the state at its end.
///
/// # Panics
/// Where `samples` has not room for exactly all states at all times, or a time lies outside the flight or
/// before the one ahead of it.
pub fn fly_at<D: Dynamics>(
    d: &mut D,
    from: (f64, &D::State),
    times: &[f64],
    options: &Options,
    events: &mut [Event<'_, D::State>],
    samples: &mut [f64],
) -> Result<End<D::State>, FlightError> {
    let n = from.1.as_ref().len();
    assert_eq!(
        samples.len(),
        n * times.len(),
        "room for all states at all times"
    );
    let at_start = started(from.0, times);
    for to in samples.chunks_mut(n).take(at_start) {
        to.copy_from_slice(from.1.as_ref());
    }
    let Some(&last) = times[at_start..].last() else {
        let end = End {
            time: from.0,
            state: from.1.clone(),
            event: None,
            occurrences: Vec::new(),
            work: Work::default(),
        };
        return Ok(end);
    };
    let mut sampler = Sampler {
        times,
        next: at_start,
        samples,
        states: n,
    };
    let end = integrate(d, from, last, options, events, &mut sampler)?;
    let next = sampler.next;
    for to in samples.chunks_mut(n).skip(next) {
        to.copy_from_slice(end.state.as_ref());
    }
    Ok(end)
}

/// Flies as [`fly_at`] does, and shows the state at each of `times` as it comes there, with the time's index; of it only the
/// numbers at these places are up to date. What was shown of a flight that fails means nothing.
///
/// # Panics
/// Where a time lies outside the flight or before the one ahead of it, or a place outside the state.
pub fn fly_past<D: Dynamics>(
    d: &mut D,
    from: (f64, &D::State),
    times: &[f64],
    options: &Options,
    places: &[Range<usize>],
    mut show: impl FnMut(usize, &[f64]),
) -> Result<(), FlightError> {
    let at_start = started(from.0, times);
    for index in 0..at_start {
        show(index, from.1.as_ref());
    }
    let Some(&last) = times[at_start..].last() else {
        return Ok(());
    };
    let mut shower = Shower {
        times,
        next: at_start,
        state: from.1.clone(),
        places,
        show,
    };
    integrate(d, from, last, options, &mut [], &mut shower)?;
    Ok(())
}

/// How many of the times, which must be in order, are that of the start; none may be before.
fn started(start: f64, times: &[f64]) -> usize {
    assert!(times.is_sorted(), "times in order");
    let at_start = times.iter().take_while(|t| **t == start).count();
    assert!(
        times.get(at_start).is_none_or(|t| *t > start),
        "times after the start"
    );
    at_start
}

impl Flight {
    /// How many states.
    pub fn states(&self) -> usize {
        self.states
    }

    /// The state at a time (s); none outside the flight.
    pub fn sample(&self, t: f64) -> Option<Vec<f64>> {
        let mut state = vec![0.0; self.states];
        self.sample_into(t, &mut state).then_some(state)
    }

    /// Writes the state at a time (s) to `state`; false, and nothing written, outside the flight.
    ///
    /// # Panics
    /// Where `state` has another length than there are states.
    pub fn sample_into(&self, t: f64, state: &mut [f64]) -> bool {
        assert_eq!(state.len(), self.states);
        if !(self.start <= t && t <= self.end) {
            return false;
        }
        if t == self.end {
            state.copy_from_slice(&self.end_state);
            return true;
        }
        let step = self
            .steps
            .partition_point(|(start, _)| *start <= t)
            .saturating_sub(1);
        let (start, h) = self.steps[step];
        let size = ROWS * self.states;
        let all = &self.rows[step * size..(step + 1) * size];
        let rows = std::array::from_fn(|row| &all[row * self.states..][..self.states]);
        Curve {
            method: self.method,
            t: start,
            h,
            rows,
        }
        .state((t - start) / h, state);
        true
    }

    /// The states at an even rate (1/s) from the start, and at the end.
    ///
    /// # Panics
    /// Where the rate is not positive.
    pub fn at_rate(&self, rate: f64) -> impl Iterator<Item = (f64, Vec<f64>)> {
        assert!(rate > 0.0, "a positive rate");
        let duration = self.end - self.start;
        // A sample within a millionth of an interval of the end is the end.
        let count = (duration * rate - 1e-6).ceil().max(0.0) as usize;
        let sample = move |i: usize| {
            let t = self.start + i as f64 / rate;
            (t, self.sample(t).unwrap_or_else(|| self.end_state.clone()))
        };
        (0..count)
            .map(sample)
            .chain(std::iter::once_with(|| (self.end, self.end_state.clone())))
    }

    /// Start and length (s) of each step.
    pub fn steps(&self) -> &[(f64, f64)] {
        &self.steps
    }
}

/// Keeps the whole curve.
struct Recorder {
    states: usize,
    steps: Vec<(f64, f64)>,
    rows: Vec<f64>,
}

impl Observer for Recorder {
    fn wants(&self, _: f64, _: f64) -> bool {
        true
    }

    #[inline(always)]
    fn see(&mut self, curve: Curve<'_>, _: f64) {
        self.steps.push((curve.t, curve.h));
        for row in curve.rows {
            self.rows.extend_from_slice(row);
        }
    }
}

/// Writes the states at given times.
struct Sampler<'a> {
    times: &'a [f64],
    next: usize,
    samples: &'a mut [f64],
    states: usize,
}

impl Observer for Sampler<'_> {
    fn wants(&self, _: f64, to: f64) -> bool {
        self.times.get(self.next).is_some_and(|t| *t <= to)
    }

    fn see(&mut self, curve: Curve<'_>, until: f64) {
        while let Some(&t) = self.times.get(self.next).filter(|t| **t <= until) {
            let to = &mut self.samples[self.next * self.states..][..self.states];
            curve.state((t - curve.t) / curve.h, to);
            self.next += 1;
        }
    }
}

/// Shows parts of the state at given times.
struct Shower<'a, X, S> {
    times: &'a [f64],
    next: usize,
    state: X,
    places: &'a [Range<usize>],
    show: S,
}

impl<X: Storage, S: FnMut(usize, &[f64])> Observer for Shower<'_, X, S> {
    fn wants(&self, _: f64, to: f64) -> bool {
        self.times.get(self.next).is_some_and(|t| *t <= to)
    }

    fn see(&mut self, curve: Curve<'_>, until: f64) {
        while let Some(&t) = self.times.get(self.next).filter(|t| **t <= until) {
            let s = (t - curve.t) / curve.h;
            curve.at_places(s, self.places, self.state.as_mut());
            (self.show)(self.next, self.state.as_ref());
            self.next += 1;
        }
    }
}

/// Keeps nothing.
struct Nobody;

impl Observer for Nobody {
    fn wants(&self, _: f64, _: f64) -> bool {
        false
    }

    fn see(&mut self, _: Curve<'_>, _: f64) {}
}
