//! Integration of many initial value problems at once: one problem ("flight") per SIMD lane, each with its own step
//! sizes and events.
//!
//! [`fly_on`] reads flights from a [`FlightQueue`] and integrates them as [`integrate_to_end`](crate::integrate_to_end)
//! would, with the same method, step-size control and event location. A lane whose flight has ended starts the next
//! flight at once. The arithmetic of a lane is independent of the other lanes: the result of a flight is bit-identical
//! whatever flights are integrated in the other lanes. Nothing is allocated per flight.

mod control;
mod events;
mod functions;
mod kernel;
mod norms;
mod stages;
mod staging;

use crate::input::is_valid;
use crate::options::{IntegrationOptions, SolverStats};
use lanes::{Enclosure, Isa, Lanes, Switch, dispatch_widest, dispatch_with};

/// Lengths of the arrays that a [`LaneRhs`] reads and writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LaneSizes {
    /// Number of states: length of the state vector x.
    pub states: usize,
    /// Number of parameters p of a flight.
    pub parameters: usize,
    /// Number of invariants: values that are computed once for each flight, from its parameters.
    pub prepared: usize,
    /// Number of limits of validity of the right-hand side, whose margins [`LaneRhs::limits`] computes.
    pub limits: usize,
    /// Length of the scratch array that each method of the [`LaneRhs`] requires.
    pub scratch: usize,
}

/// Arguments of the functions of a [`LaneRhs`] (time, state, parameters), with one flight per SIMD lane.
#[derive(Clone, Copy)]
pub struct LanePoint<'a, T> {
    /// Time, in the time unit of the right-hand side.
    pub t: T,
    /// State vector x of the flights, one flight per SIMD lane.
    pub x: &'a [T],
    /// Parameter vector p of the flights, one flight per SIMD lane.
    pub p: &'a [T],
    /// Invariants that [`LaneRhs::prepare`] computed from `p`.
    pub prepared: &'a [T],
}

/// Right-hand side f of dx/dt = f(t, x, p), evaluated for one flight per lane.
///
/// Implementations and all functions that they call must be `#[inline(always)]`, for the reason given at
/// [`lanes::Kernel`].
pub trait LaneRhs {
    /// Returns the lengths of the state, parameter and work arrays.
    fn sizes(&self) -> LaneSizes;
    /// Writes the invariants of the flights, values that depend only on the parameters `p`, to `prepared`.
    fn prepare<T: Lanes>(&self, p: &[T], scratch: &mut [T], prepared: &mut [T]);
    /// Writes f(t, x, p) to `dx`, in which every element must be set.
    fn derivative<T: Lanes>(&self, at: LanePoint<'_, T>, scratch: &mut [T], dx: &mut [T]);
    /// Writes the times at which f of a flight with the parameters `p` may jump to the empty `breaks`, in increasing
    /// order; a step ends at each. None by default.
    fn time_breaks(&self, p: &[f64], breaks: &mut Vec<f64>) {
        let _ = (p, breaks);
    }
    /// Levels of the arguments of switches, as [`RhsProperties::switches`](crate::RhsProperties::switches).
    fn switches(&self) -> &[Switch] {
        &[]
    }
    /// Writes the arguments of switches, one for each of the [`switches`](Self::switches).
    #[inline(always)]
    fn switch_arguments<T: Lanes>(&self, at: LanePoint<'_, T>, scratch: &mut [T], to: &mut [T]) {
        let _ = (at, scratch, to);
    }
    /// Writes bounds of the arguments of switches of a flight with the parameters `p`, as
    /// [`RhsProperties::switch_bounds`](crate::RhsProperties::switch_bounds).
    fn switch_bounds(
        &self,
        t: Enclosure,
        x: &[Enclosure],
        p: &[f64],
        to: &mut [Enclosure],
    ) -> bool {
        let _ = (t, x, p, to);
        false
    }
    /// Writes the margin of each limit of validity; the right-hand side is valid where all are above 0.
    fn limits<T: Lanes>(&self, at: LanePoint<'_, T>, scratch: &mut [T], margins: &mut [T]);
}

/// Source of the flights to integrate, and receiver of their results.
pub trait FlightQueue {
    /// Writes the initial state and the parameters of the next flight to `x` and `p` and returns the number that
    /// identifies the flight; `None` after the last flight.
    fn next(&mut self, x: &mut [f64], p: &mut [f64]) -> Option<u64>;
    /// Receives the result of a flight. Flights may end in another order than [`next`](Self::next) returned them.
    fn end(&mut self, end: FlightEnd<'_>);
}

/// Reason why the integration of a flight ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlightOutcome {
    /// The height above the ground ([`FlightSpan::height`]) fell to 0.
    Ground,
    /// The final time [`FlightSpan::t_end`] was reached.
    Time,
    /// A limit of validity was crossed, or the initial state was already beyond it. Contains the index of the limit
    /// among the margins that [`LaneRhs::limits`] writes.
    Limit(usize),
    /// The maximum number of steps was reached.
    TooManySteps,
    /// The derivative was not finite, or the error test failed at the minimum step size.
    StepTooSmall,
    /// The initial height was below 0, or was 0 and falling.
    StartsBelowGround,
    /// A component of the initial state or a parameter was not finite.
    NotFinite,
}

/// Result of a flight: reason of its end, final time and state, and apex.
#[derive(Clone, Copy, Debug)]
pub struct FlightEnd<'a> {
    /// Number of the flight, as returned by [`FlightQueue::next`].
    pub flight: u64,
    /// Reason why the integration ended.
    pub outcome: FlightOutcome,
    /// Time at which the flight ended, in the time unit of the right-hand side.
    pub time: f64,
    /// State vector at the time at which the flight ended.
    pub state: &'a [f64],
    /// Time and value of the maximum height, which is at the start, at the end, or where the time derivative of the
    /// height falls to 0. The value is NaN if [`FlightSpan::seeks_apex`] is false or [`FlightSpan::height`] is `None`.
    pub apex: (f64, f64),
    /// Numbers of steps and of right-hand side evaluations of this flight.
    pub stats: SolverStats,
}

/// Conditions that end a flight, and whether its maximum height is located. All flights start at time 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlightSpan {
    /// Final time, in the time unit of the right-hand side, at which a flight ends if no event has ended it before.
    pub t_end: f64,
    /// Index of the state component that is the height above the ground; `None` if there is no such component.
    pub height: Option<usize>,
    /// Whether the time and value of the maximum height of each flight are determined.
    pub seeks_apex: bool,
    /// Whether a flight ends when its height falls to 0.
    pub until_ground: bool,
}

impl FlightSpan {
    /// State index of the height if the maximum of the height is to be located, else `None`.
    fn apex(&self) -> Option<usize> {
        self.height.filter(|_| self.seeks_apex)
    }
}

/// Integrates all flights of a queue on the SIMD lanes of one instruction set. Returns the number of vector evaluations
/// of the right-hand side, each for all lanes, including those without a flight; `None` if the processor does not support
/// the instruction set.
///
/// # Panics
/// If a tolerance, a step bound or the final time is not a positive number, if the right-hand side has no states, or if
/// the height is not a state.
pub fn fly_on<R: LaneRhs>(
    isa: Isa,
    rhs: &R,
    queue: &mut dyn FlightQueue,
    span: &FlightSpan,
    options: &IntegrationOptions,
) -> Option<u64> {
    dispatch_with(isa, batch(rhs, queue, span, options))
}

/// Integrates all flights of a queue on the SIMD lanes of the instruction set `isa`, and returns the number of vector
/// evaluations of the right-hand side. The integration is compiled only for the widest instruction sets of the
/// architecture (see [`lanes::dispatch_widest`]). Returns `None` if `isa` is not one of these, or if the processor does
/// not support it.
pub fn fly_on_widest<R: LaneRhs>(
    isa: Isa,
    rhs: &R,
    queue: &mut dyn FlightQueue,
    span: &FlightSpan,
    options: &IntegrationOptions,
) -> Option<u64> {
    dispatch_widest(isa, batch(rhs, queue, span, options))
}

/// Checks the options, the final time, the number of states and the index of the height, and returns the kernel that
/// integrates the flights. Panics under the conditions of [`fly_on`].
fn batch<'a, R: LaneRhs>(
    rhs: &'a R,
    queue: &'a mut dyn FlightQueue,
    span: &'a FlightSpan,
    options: &'a IntegrationOptions,
) -> kernel::Batch<'a, R> {
    let states = rhs.sizes().states;
    assert!(
        is_valid(options, span.t_end) && span.t_end.is_finite(),
        "options and times that are positive numbers"
    );
    assert!(states > 0, "a right-hand side with states");
    assert!(
        span.height.is_none_or(|z| z < states),
        "a height that is a state"
    );
    kernel::Batch {
        rhs,
        queue,
        span,
        options,
    }
}
