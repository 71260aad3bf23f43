//! Events: zeros of event functions g(t, x), located on the dense output of each step.

use crate::dense_output::{DenseOutput, HermiteStep, cubic};
use crate::rhs::{OdeRhs, StateVector};
use crate::root::first_past_root;
use std::borrow::Cow;

/// Number of equal subintervals of a step that are searched for a sign change of an event function, and for a minimum.
const SEARCH_INTERVALS: u32 = 16;

/// Distance from the end of a step, as a fraction of a subinterval, at which the slope of an event function is asked.
const SLOPE_STEP: f64 = 1e-3;

/// Bracket width to which a minimum of an event function is located, as a fraction of the step.
const MINIMUM_WIDTH: f64 = 1e-7;

/// Distance of the cubic Hermite interpolant from 0 at which the dense output is asked, in units of the bound of the
/// interpolant's distance from its chord: the two differ by terms of fourth and higher order in the step size.
pub(crate) const HERMITE_MARGIN: f64 = 0.3;

/// Distance of an event function from 0, in units of its changes between both ends and the middle of a step, beyond
/// which it does not reach 0 within the step.
pub(crate) const REACH: f64 = 2.0;

/// Event: where a function g(t, x) falls from positive to zero or below.
///
/// By default an event is recorded; [`terminal`](Self::terminal) makes it end the integration.
pub struct Event<'a, X> {
    pub(crate) name: Cow<'a, str>,
    function: EventFunction<'a, X>,
    pub(crate) action: EventAction,
}

type Scalar<'a, X> = Box<dyn FnMut(f64, &X) -> f64 + 'a>;

/// Event function g(t, x), whose fall from positive to zero or below is the event.
enum EventFunction<'a, X> {
    /// Value of a state component minus a level; contains the index of the component and the level.
    Component(usize, f64),
    /// Time derivative of a state component; contains the index of the component.
    Derivative(usize),
    Function(Scalar<'a, X>),
}

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

    /// Name of the event, or the reason of the limit.
    pub fn name(&self) -> &str {
        &self.name
    }

    fn recorded(name: impl Into<Cow<'a, str>>, function: EventFunction<'a, X>) -> Self {
        Event {
            name: name.into(),
            function,
            action: EventAction::Record,
        }
    }

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
    /// limit of validity. A terminal event at which the function leaves 0 later is located in the first step.
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
                cubic_minimum((a, b, da, db)) <= HERMITE_MARGIN * chord_distance
            }
            EventFunction::Derivative(i) => {
                // The derivative of the cubic is a parabola within this distance of its chord.
                let (a, b, da, db) = step.ends(*i);
                let chord_distance = 0.75 * (2.0 * (b - a) - da - db).abs();
                if da.min(db) > chord_distance || da.max(db) < -chord_distance {
                    return false;
                }
                // Two intervals, since the parabola may have two zeros.
                let values = [0.0, 0.5, 1.0].map(|s| step.scaled_derivative(*i, s));
                values
                    .windows(2)
                    .any(|pair| pair[0] > 0.0 && pair[1] <= 0.0)
            }
            EventFunction::Function(g) => {
                let first = g(step.t, step.x);
                for (i, x) in scratch.as_mut().iter_mut().enumerate() {
                    *x = step.component(i, 0.5);
                }
                let middle = g(step.t + 0.5 * step.h, scratch);
                let last = g(step.t + step.h, step.x_end);
                let changes = (middle - first).abs() + (last - middle).abs();
                let (least, greatest) = (first.min(middle).min(last), first.max(middle).max(last));
                least <= REACH * changes && greatest >= -REACH * changes
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
        let from_zero = self.action == EventAction::Stop;
        if let EventFunction::Component(i, level) = self.function
            && step.projection.is_none()
        {
            let value = |s: f64| step.component(s, i) - level;
            return falling_zeros((step.t, step.h), from_zero, value, found);
        }
        let [x, dx] = scratch;
        let value = |s: f64| {
            step.state(s, x.as_mut());
            self.value(rhs, step.t + s * step.h, x, dx)
        };
        falling_zeros((step.t, step.h), from_zero, value, found);
    }
}

/// Values nearer to 0 are 0 at the start of a step: a body on the ground does not fall by the error of the interpolation.
const AT_ZERO: f64 = 1e-8;

/// Appends to `found` the fractions of a step, in increasing order, at which `value`, a function of the fraction, falls
/// from positive to 0 or below; if `from_zero`, also the start of the step if the function is 0 there and falls.
pub(crate) fn falling_zeros(
    (t, h): (f64, f64),
    from_zero: bool,
    mut value: impl FnMut(f64) -> f64,
    found: &mut Vec<f64>,
) {
    let mut points = with_dips(&mut value);
    if from_zero && (-AT_ZERO..=0.0).contains(&points[0].1) {
        let leaves = points.iter().find(|point| point.1.abs() > AT_ZERO);
        if let Some(&(until, _)) = leaves.filter(|point| point.1 < 0.0) {
            // A hop that is over before that point is a rise first.
            match dip(&mut |s| AT_ZERO - value(s), 0.0, until) {
                Some((s, below)) => {
                    let place = points.partition_point(|point| point.0 < s);
                    points.insert(place, (s, AT_ZERO - below));
                }
                None => found.push(0.0),
            }
        }
    }
    for (index, pair) in points.windows(2).enumerate() {
        let [before, after] = [pair[0], pair[1]];
        let rests = || {
            let was_above = points[..=index].iter().any(|point| point.1 > AT_ZERO);
            let is_below = points[index..].iter().any(|point| point.1 < -AT_ZERO);
            from_zero && points[0].1 == 0.0 && !was_above && !is_below
        };
        if before.1 > 0.0 && after.1 <= 0.0 && !rests() {
            let width = location_width(t, h);
            found.push(first_past_root(
                &mut value,
                (before.0, after.0),
                (before.1, after.1),
                width,
            ));
        }
    }
}

/// Points (s, `value`(s)) of a step in increasing order: the ends of its subintervals, and the minima between them at
/// which the function is not positive.
fn with_dips(value: &mut impl FnMut(f64) -> f64) -> Vec<(f64, f64)> {
    let last = SEARCH_INTERVALS as usize;
    let mut at = |k: f64| (k / last as f64, value(k / last as f64));
    let ends: Vec<(f64, f64)> = (0..=last).map(|k| at(k as f64)).collect();
    // A minimum in the first or the last subinterval shows by the slope at the end of the step.
    let falls_first = ends[0].1 > 0.0 && at(SLOPE_STEP).1 < ends[0].1;
    let falls_last = ends[last].1 > 0.0 && at(last as f64 - SLOPE_STEP).1 < ends[last].1;
    let mut points = ends.clone();
    for k in 0..=last {
        let (low, high) = (k.saturating_sub(1), (k + 1).min(last));
        let is_least = ends[low..=high]
            .iter()
            .all(|e| e.1 > 0.0 && e.1 >= ends[k].1);
        let is_inside = match k {
            0 => falls_first,
            _ if k == last => falls_last,
            _ => true,
        };
        if is_least && is_inside {
            points.extend(dip(value, ends[low].0, ends[high].0));
        }
    }
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// Golden-section search for the minimum of `value` in a bracket, which ends where the function is not positive: that
/// point and its value; `None` if the minimum is positive.
fn dip(value: &mut impl FnMut(f64) -> f64, mut low: f64, mut high: f64) -> Option<(f64, f64)> {
    let part = (5.0_f64.sqrt() - 1.0) / 2.0;
    let (mut a, mut b) = (high - part * (high - low), low + part * (high - low));
    let (mut of_a, mut of_b) = (value(a), value(b));
    while high - low > MINIMUM_WIDTH {
        if of_a.min(of_b) <= 0.0 {
            let is_first = of_a <= 0.0;
            return Some(if is_first { (a, of_a) } else { (b, of_b) });
        }
        if of_a < of_b {
            (high, b, of_b) = (b, a, of_a);
            a = high - part * (high - low);
            of_a = value(a);
        } else {
            (low, a, of_a) = (a, b, of_b);
            b = low + part * (high - low);
            of_b = value(b);
        }
    }
    None
}

/// Minimum over a step of the cubic with the values and scaled derivatives `ends`, as of [`HermiteStep::ends`].
#[inline(always)]
pub(crate) fn cubic_minimum(ends: (f64, f64, f64, f64)) -> f64 {
    let (a, b, da, db) = ends;
    let mut least = a.min(b);
    // The derivative is da + (db - da + bend) s - bend s².
    let bend = 3.0 * (2.0 * (b - a) - da - db);
    let middle = db - da + bend;
    let discriminant = middle * middle + 4.0 * bend * da;
    if discriminant >= 0.0 {
        let sum = middle + discriminant.sqrt().copysign(middle);
        for s in [0.5 * sum / bend, -2.0 * da / sum] {
            if 0.0 < s && s < 1.0 {
                least = least.min(cubic(ends, s));
            }
        }
    }
    least
}

/// Bracket width to which an event is located, as a fraction of the step from `t` of size `h`.
pub(crate) fn location_width(t: f64, h: f64) -> f64 {
    (1e-13 * t.abs().max(1.0) / h).min(1e-3)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        /// A smooth function whose minimum is `depth` below 0, anywhere in the step, has its first zero found.
        #[test]
        fn a_dip_anywhere_in_a_step_is_found(
            at in 0.02..0.98_f64,
            depth in 1e-5..1e-2_f64,
            curvature in 1.0..30.0_f64,
            third in -0.2..0.2_f64,
        ) {
            let value = |s: f64| {
                let d = s - at;
                curvature * d * d * (1.0 + third * d) - depth
            };
            prop_assume!(value(0.0) > 0.0);
            let mut found = Vec::new();
            falling_zeros((0.0, 1.0), false, value, &mut found);
            prop_assert_eq!(found.len(), 1);
            prop_assert!(found[0] < at && value(found[0]).abs() < 1e-9);
            let mut none = Vec::new();
            falling_zeros((0.0, 1.0), false, |s| value(s) + 1.001 * depth, &mut none);
            prop_assert!(none.is_empty());
        }

        #[test]
        fn the_minimum_of_a_cubic_is_no_more_than_any_of_its_values(
            a in -2.0..2.0_f64, b in -2.0..2.0_f64, da in -9.0..9.0_f64, db in -9.0..9.0_f64,
        ) {
            let least = cubic_minimum((a, b, da, db));
            let values = (0..=1000).map(|k| cubic((a, b, da, db), f64::from(k) / 1000.0));
            let sampled = values.fold(f64::INFINITY, f64::min);
            prop_assert!(least <= sampled + 1e-12 && least > sampled - 1e-4);
        }
    }

    #[test]
    fn a_fall_from_zero_counts_where_it_is_asked_for() {
        let find = |from_zero, value: fn(f64) -> f64| {
            let mut found = Vec::new();
            falling_zeros((0.0, 1.0), from_zero, value, &mut found);
            found
        };
        assert_eq!(find(true, |s| -s * s), [0.0]);
        assert_eq!(find(false, |s| -s * s), []);
        assert_eq!(find(true, |s| s * s), []);
        // The error of the interpolation, before the start of a rocket.
        assert_eq!(find(true, |s| s.powi(3) - 1e-9 * s), []);
        assert_eq!(find(true, |s| -1e-9 - s), [0.0]);
        assert_eq!(find(true, |s| 1e-10 * (9.0 * s).sin()), []);
        assert_eq!(find(true, |s| 1e-3 * (4.0 * s).sin()).len(), 1);
        // A hop at the start of a long step, which has a landing; one of less than the error of the interpolation.
        let hop = find(true, |s| s * (2e-3 - s));
        assert!((hop[0] - 2e-3).abs() < 1e-12 && hop.len() == 1, "{hop:?}");
        assert_eq!(find(true, |s| s * (1e-4 - s)), [0.0]);
        // A corner, as of a speed.
        let cusp = find(false, |s| (s - 0.3012).abs() - 1e-3);
        assert!((cusp[0] - 0.3002).abs() < 1e-12, "{cusp:?}");
    }
}
