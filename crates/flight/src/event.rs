//! What is looked for while flying: the ground, the apex, where the model ends.

use crate::dynamics::{Dynamics, Storage};
use crate::method::wide::{WIDE, Weighted};
use crate::method::{Method, ROWS};
use crate::root::just_past;
use std::borrow::Cow;
use std::ops::Range;

/// Something that happens where a quantity passes through 0.
pub struct Event<'a, X> {
    pub(crate) name: Cow<'a, str>,
    quantity: Quantity<'a, X>,
    crossing: Crossing,
    pub(crate) then: Then,
}

/// A function of time and state.
type Measure<'a, X> = Box<dyn FnMut(f64, &X) -> f64 + 'a>;

enum Quantity<'a, X> {
    /// A component of the state less a number.
    Component(usize, f64),
    /// The rate of change of a component.
    Rate(usize),
    /// Anything.
    Function(Measure<'a, X>),
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Crossing {
    Falling,
    Rising,
}

impl Crossing {
    /// The value as one that falls through 0.
    #[inline(always)]
    fn falling(self, value: f64) -> f64 {
        match self {
            Crossing::Falling => value,
            Crossing::Rising => -value,
        }
    }
}

/// What follows an event.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Then {
    Record,
    Stop,
    Fail,
}

/// An event that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Occurrence {
    /// Name of the event.
    pub event: String,
    /// When, s.
    pub time: f64,
    /// The state then.
    pub state: Vec<f64>,
}

impl<'a, X: Storage> Event<'a, X> {
    /// `component` of the state falls to `level`, in the component's unit: the height to the ground.
    pub fn falls_to(name: impl Into<Cow<'a, str>>, component: usize, level: f64) -> Self {
        Event {
            name: name.into(),
            quantity: Quantity::Component(component, level),
            crossing: Crossing::Falling,
            then: Then::Record,
        }
    }

    /// `component` of the state has a maximum: the height at the apex.
    pub fn peak_of(name: impl Into<Cow<'a, str>>, component: usize) -> Self {
        Event {
            name: name.into(),
            quantity: Quantity::Rate(component),
            crossing: Crossing::Falling,
            then: Then::Record,
        }
    }

    /// A function of time (s) and state falls to 0.
    pub fn falling(name: impl Into<Cow<'a, str>>, f: impl FnMut(f64, &X) -> f64 + 'a) -> Self {
        Event {
            name: name.into(),
            quantity: Quantity::Function(Box::new(f)),
            crossing: Crossing::Falling,
            then: Then::Record,
        }
    }

    /// A limit of the model: where the function falls to 0 the flight ends with an error that gives `reason`.
    pub fn limit(reason: impl Into<Cow<'a, str>>, f: impl FnMut(f64, &X) -> f64 + 'a) -> Self {
        Event {
            then: Then::Fail,
            ..Self::falling(reason, f)
        }
    }

    /// The same event where the quantity rises instead.
    pub fn rising(self) -> Self {
        Event {
            crossing: Crossing::Rising,
            ..self
        }
    }

    /// The flight ends at this event.
    pub fn ends_flight(self) -> Self {
        Event {
            then: Then::Stop,
            ..self
        }
    }

    /// The quantity, positive before the event and negative after it.
    #[inline(always)]
    fn value<D: Dynamics<State = X>>(&mut self, d: &mut D, t: f64, x: &X, rate: &mut X) -> f64 {
        let value = match &mut self.quantity {
            Quantity::Component(i, level) => x.as_ref()[*i] - *level,
            Quantity::Rate(i) => {
                d.derivative(t, x, rate);
                rate.as_ref()[*i]
            }
            Quantity::Function(f) => f(t, x),
        };
        self.crossing.falling(value)
    }

    /// Whether the start is beyond the event already, or at it and going beyond.
    pub(crate) fn is_past<D: Dynamics<State = X>>(
        &mut self,
        d: &mut D,
        t: f64,
        x: &X,
        dx: &X,
    ) -> bool {
        let value = self.value(d, t, x, &mut dx.clone());
        let falling = if let Quantity::Component(i, _) = self.quantity {
            self.crossing.falling(dx.as_ref()[i]) < 0.0
        } else {
            self.then == Then::Fail
        };
        value < 0.0 || value == 0.0 && falling
    }

    /// Whether something may have happened in a step, judged by a cubic through its ends.
    #[inline(always)]
    pub(crate) fn may_happen(&mut self, step: &Step<'_, X>, scratch: &mut X) -> bool {
        let sign = self.crossing.falling(1.0);
        match &mut self.quantity {
            Quantity::Component(i, level) => {
                // The cubic strays from its chord by no more than a quarter of how its slopes differ from it.
                let (a, b, da, db) = step.ends(*i);
                let (a, b) = (sign * (a - *level), sign * (b - *level));
                let stray = 0.25 * ((da.abs() + db.abs()) + (b - a).abs());
                if a.min(b) > stray || a.max(b) < -stray {
                    return false;
                }
                falls(4, |s| sign * (step.cubic(*i, s) - *level))
            }
            Quantity::Rate(i) => {
                let (a, b, da, db) = step.ends(*i);
                let stray = 0.75 * (2.0 * (b - a) - da - db).abs();
                if (sign * da).min(sign * db) > stray || (sign * da).max(sign * db) < -stray {
                    return false;
                }
                falls(2, |s| sign * step.cubic_rate(*i, s))
            }
            Quantity::Function(f) => {
                let first = sign * f(step.t, step.x);
                for (i, x) in scratch.as_mut().iter_mut().enumerate() {
                    *x = step.cubic(i, 0.5);
                }
                let middle = sign * f(step.t + 0.5 * step.h, scratch);
                let last = sign * f(step.t + step.h, step.end);
                first > 0.0 && middle <= 0.0 || middle > 0.0 && last <= 0.0
            }
        }
    }

    /// Every time at which it happens in a step, on the step's own curve, as parts of the step.
    pub(crate) fn locate<D: Dynamics<State = X>>(
        &mut self,
        d: &mut D,
        curve: &Curve<'_>,
        scratch: [&mut X; 2],
        found: &mut Vec<f64>,
    ) {
        if let Quantity::Component(i, level) = self.quantity {
            let sign = self.crossing.falling(1.0);
            return search(curve, |s| sign * (curve.component(s, i) - level), found);
        }
        let [x, rate] = scratch;
        let value = |s: f64| {
            curve.state(s, x.as_mut());
            self.value(d, curve.t + s * curve.h, x, rate)
        };
        search(curve, value, found);
    }
}

/// Every part of a step at which a value falls to 0.
fn search(curve: &Curve<'_>, mut value: impl FnMut(f64) -> f64, found: &mut Vec<f64>) {
    const PARTS: u32 = 8;
    let mut before = (0.0, value(0.0));
    for k in 1..=PARTS {
        let s = f64::from(k) / f64::from(PARTS);
        let after = (s, value(s));
        if before.1 > 0.0 && after.1 <= 0.0 {
            let within = (1e-13 * curve.t.abs().max(1.0) / curve.h).min(1e-3);
            found.push(just_past(
                &mut value,
                (before.0, after.0),
                (before.1, after.1),
                within,
            ));
        }
        before = after;
    }
}

/// An accepted step, seen from its ends.
pub(crate) struct Step<'a, X> {
    pub t: f64,
    pub h: f64,
    pub x: &'a X,
    pub dx: &'a X,
    pub end: &'a X,
    pub end_rate: &'a X,
}

/// Whether a function passes from above 0 to 0 or below, looked at in so many parts of a step, lest two
/// crossings in one step hide each other.
fn falls(parts: u32, value: impl Fn(f64) -> f64) -> bool {
    let mut before = value(0.0);
    for k in 1..=parts {
        let after = value(f64::from(k) / f64::from(parts));
        if before > 0.0 && after <= 0.0 {
            return true;
        }
        before = after;
    }
    false
}

impl<X: Storage> Step<'_, X> {
    /// A component at both ends, and its rates of change there times the step.
    #[inline(always)]
    fn ends(&self, i: usize) -> (f64, f64, f64, f64) {
        (
            self.x.as_ref()[i],
            self.end.as_ref()[i],
            self.h * self.dx.as_ref()[i],
            self.h * self.end_rate.as_ref()[i],
        )
    }

    /// A component at a part of the step, by Hermite's cubic.
    #[inline(always)]
    fn cubic(&self, i: usize, s: f64) -> f64 {
        let (a, b, da, db) = self.ends(i);
        let r = 1.0 - s;
        a * r + b * s + s * r * ((da - (b - a)) * r - (db - (b - a)) * s)
    }

    /// Rate of change of that cubic, times the step.
    #[inline(always)]
    fn cubic_rate(&self, i: usize, s: f64) -> f64 {
        let (a, b, da, db) = self.ends(i);
        let r = 1.0 - s;
        da * r + db * s + 3.0 * s * r * (2.0 * (b - a) - da - db)
    }
}

/// The curve of a step.
#[derive(Clone, Copy)]
pub(crate) struct Curve<'a> {
    pub method: Method,
    pub t: f64,
    pub h: f64,
    pub rows: [&'a [f64]; ROWS],
}

impl Curve<'_> {
    /// The numbers at some places of the state at a part of the step.
    pub(crate) fn at_places(&self, s: f64, places: &[Range<usize>], to: &mut [f64]) {
        let weights = self.method.weights(s, self.h);
        for places in places {
            let rows = self.rows.map(|row| &row[places.clone()]);
            let to = &mut to[places.clone()];
            lanes::dispatch(Weighted { rows, weights, to });
        }
    }

    /// The state at a part of the step.
    #[inline]
    pub(crate) fn state(&self, s: f64, to: &mut [f64]) {
        let n = to.len();
        let weights = self.method.weights(s, self.h);
        if n >= WIDE {
            let rows = self.rows;
            return lanes::dispatch(Weighted { rows, weights, to });
        }
        to.copy_from_slice(self.rows[0]);
        for (row, weight) in self.rows.iter().zip(weights).skip(1) {
            for (to, value) in to.iter_mut().zip(*row) {
                *to += weight * value;
            }
        }
    }
}

impl Curve<'_> {
    /// One of the states at a part of the step: the bits that [`state`](Self::state) has for a short state.
    pub(crate) fn component(&self, s: f64, i: usize) -> f64 {
        let weights = self.method.weights(s, self.h);
        let mut sum = self.rows[0][i];
        for (row, weight) in self.rows.iter().zip(weights).skip(1) {
            sum += weight * row[i];
        }
        sum
    }
}
