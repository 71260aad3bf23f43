//! Events: zeros of event functions g(t, x), located on the dense output of each step.

use crate::dense_output::{DenseOutput, HermiteStep};
use crate::rhs::{OdeRhs, StateVector};
use crate::root::first_past_root;
use std::borrow::Cow;

/// Number of equal subintervals of a step that are searched for a sign change of an event function.
const SEARCH_INTERVALS: u32 = 8;

/// Event: where a function g(t, x) falls from positive to zero or below.
///
/// By default an event is recorded; [`terminal`](Self::terminal) makes it end the integration.
pub struct Event<'a, X> {
    pub(crate) name: Cow<'a, str>,
    function: EventFunction<'a, X>,
    pub(crate) action: EventAction,
}

/// Boxed function of time and state with a scalar value.
type Scalar<'a, X> = Box<dyn FnMut(f64, &X) -> f64 + 'a>;

/// Event function g(t, x), whose fall from positive to zero or below is the event.
enum EventFunction<'a, X> {
    /// Value of a state component minus a level; contains the index of the component and the level.
    Component(usize, f64),
    /// Time derivative of a state component; contains the index of the component.
    Derivative(usize),
    /// Function g(t, x) given by the caller.
    Function(Scalar<'a, X>),
}

/// Action of the integration at an event: record the event, stop, or fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EventAction {
    Record,
    Stop,
    Fail,
}

/// Time and state at which an event occurred.
#[derive(Clone, Debug, PartialEq)]
pub struct Occurrence {
    /// Name of the event that occurred, as given when the event was defined.
    pub event: String,
    /// Time of the event, in the time unit of the right-hand side.
    pub time: f64,
    /// State at the time of the event.
    pub state: Vec<f64>,
}

impl<'a, X: StateVector> Event<'a, X> {
    /// Event where a state component falls to `level`, in the unit of the component.
    pub fn falls_to(name: impl Into<Cow<'a, str>>, component: usize, level: f64) -> Self {
        Self::recorded(name, EventFunction::Component(component, level))
    }

    /// Event where a state component has a maximum: its derivative falls to 0.
    pub fn peak_of(name: impl Into<Cow<'a, str>>, component: usize) -> Self {
        Self::recorded(name, EventFunction::Derivative(component))
    }

    /// Event where `g(t, x)` falls to 0.
    pub fn falling(name: impl Into<Cow<'a, str>>, g: impl FnMut(f64, &X) -> f64 + 'a) -> Self {
        Self::recorded(name, EventFunction::Function(Box::new(g)))
    }

    /// Limit of validity of a model: where `g(t, x)` falls to 0, the integration fails with
    /// [`IntegrationFailure::Limit`](crate::IntegrationFailure::Limit) and the given `reason`.
    pub fn limit(reason: impl Into<Cow<'a, str>>, g: impl FnMut(f64, &X) -> f64 + 'a) -> Self {
        Event {
            action: EventAction::Fail,
            ..Self::falling(reason, g)
        }
    }

    /// Turns the event into a terminal one: the integration stops at its first occurrence.
    pub fn terminal(self) -> Self {
        Event {
            action: EventAction::Stop,
            ..self
        }
    }

    fn recorded(name: impl Into<Cow<'a, str>>, function: EventFunction<'a, X>) -> Self {
        Event {
            name: name.into(),
            function,
            action: EventAction::Record,
        }
    }

    /// Value of the event function at the time `t` and the state `x`; `dx` is scratch space.
    #[inline(always)]
    fn value<D: OdeRhs<State = X>>(&mut self, rhs: &mut D, t: f64, x: &X, dx: &mut X) -> f64 {
        match &mut self.function {
            EventFunction::Component(i, level) => x.as_ref()[*i] - *level,
            EventFunction::Derivative(i) => {
                rhs.derivative(t, x, dx);
                dx.as_ref()[*i]
            }
            EventFunction::Function(g) => g(t, x),
        }
    }

    /// Whether the event function is negative at the initial state `x`; `dx` is the derivative there. The value 0
    /// counts as negative if the event function is that of a decreasing state component, or if the event is a
    /// limit of validity.
    pub(crate) fn is_past<D: OdeRhs<State = X>>(
        &mut self,
        rhs: &mut D,
        t: f64,
        x: &X,
        dx: &X,
    ) -> bool {
        let value = self.value(rhs, t, x, &mut dx.clone());
        let is_falling = if let EventFunction::Component(i, _) = self.function {
            dx.as_ref()[i] < 0.0
        } else {
            self.action == EventAction::Fail
        };
        value < 0.0 || value == 0.0 && is_falling
    }

    /// Whether the event may occur within a step, according to the cubic Hermite interpolant of the step. This test is
    /// cheaper than the search for the event in the dense output.
    #[inline(always)]
    pub(crate) fn may_occur(&mut self, step: &HermiteStep<'_, X>, scratch: &mut X) -> bool {
        match &mut self.function {
            EventFunction::Component(i, level) => {
                // The cubic is within 1/4 (|h x'(0)| + |h x'(1)| + |x(1) - x(0)|) of its chord.
                let (a, b, da, db) = step.ends(*i);
                let (a, b) = (a - *level, b - *level);
                let chord_distance = 0.25 * ((da.abs() + db.abs()) + (b - a).abs());
                if a.min(b) > chord_distance || a.max(b) < -chord_distance {
                    return false;
                }
                has_falling_zero(4, |s| step.component(*i, s) - *level)
            }
            EventFunction::Derivative(i) => {
                // The derivative of the cubic is a parabola within this distance of its chord.
                let (a, b, da, db) = step.ends(*i);
                let chord_distance = 0.75 * (2.0 * (b - a) - da - db).abs();
                if da.min(db) > chord_distance || da.max(db) < -chord_distance {
                    return false;
                }
                has_falling_zero(2, |s| step.scaled_derivative(*i, s))
            }
            EventFunction::Function(g) => {
                let first = g(step.t, step.x);
                for (i, x) in scratch.as_mut().iter_mut().enumerate() {
                    *x = step.component(i, 0.5);
                }
                let middle = g(step.t + 0.5 * step.h, scratch);
                let last = g(step.t + step.h, step.x_end);
                first > 0.0 && middle <= 0.0 || middle > 0.0 && last <= 0.0
            }
        }
    }

    /// Appends to `found` every occurrence of the event in a step, each as a fraction of the step.
    pub(crate) fn locate<D: OdeRhs<State = X>>(
        &mut self,
        rhs: &mut D,
        step: &DenseOutput<'_>,
        scratch: [&mut X; 2],
        found: &mut Vec<f64>,
    ) {
        if let EventFunction::Component(i, level) = self.function {
            return falling_zeros((step.t, step.h), |s| step.component(s, i) - level, found);
        }
        let [x, dx] = scratch;
        let value = |s: f64| {
            step.state(s, x.as_mut());
            self.value(rhs, step.t + s * step.h, x, dx)
        };
        falling_zeros((step.t, step.h), value, found);
    }
}

/// Appends to `found` the fractions of a step, in increasing order, at which `value`, a function of the fraction, falls
/// from positive to 0 or below. The step starts at the time `t` and has the size `h`.
pub(crate) fn falling_zeros(
    (t, h): (f64, f64),
    mut value: impl FnMut(f64) -> f64,
    found: &mut Vec<f64>,
) {
    let mut before = (0.0, value(0.0));
    for k in 1..=SEARCH_INTERVALS {
        let s = f64::from(k) / f64::from(SEARCH_INTERVALS);
        let after = (s, value(s));
        if before.1 > 0.0 && after.1 <= 0.0 {
            let width = location_width(t, h);
            found.push(first_past_root(
                &mut value,
                (before.0, after.0),
                (before.1, after.1),
                width,
            ));
        }
        before = after;
    }
}

/// Bracket width to which an event is located, as a fraction of the step from `t` of size `h`.
pub(crate) fn location_width(t: f64, h: f64) -> f64 {
    (1e-13 * t.abs().max(1.0) / h).min(1e-3)
}

/// Whether `value`, a function of the fraction of a step, falls from positive to 0 or below between neighbouring points
/// that divide the step into `intervals` equal intervals. More than one interval can detect two zeros within the step.
pub(crate) fn has_falling_zero(intervals: u32, value: impl Fn(f64) -> f64) -> bool {
    let mut before = value(0.0);
    for k in 1..=intervals {
        let after = value(f64::from(k) / f64::from(intervals));
        if before > 0.0 && after <= 0.0 {
            return true;
        }
        before = after;
    }
    false
}
