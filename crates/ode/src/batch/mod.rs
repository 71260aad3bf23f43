//! Many initial value problems at once: one flight per SIMD lane, each with step sizes and events of its own.
//!
//! [`fly`] takes flights from a [`FlightQueue`] and integrates them as [`integrate_to_end`](crate::integrate_to_end) would,
//! with the same method, step-size control and event location; a lane that has finished takes the next flight at once. The
//! arithmetic of a lane is independent of its neighbours: the result of a flight is the same bits with whatever others it
//! shares the vectors. Nothing is allocated per flight.

mod control;
mod events;
mod kernel;
mod norms;
mod stages;
mod staging;

use crate::input::is_valid;
use crate::options::{IntegrationOptions, SolverStats};
use lanes::{Isa, LaneKernel, Lanes, dispatch, dispatch_widest, dispatch_with};

/// Numbers of values that a [`LaneRhs`] reads and writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LaneSizes {
    /// States x.
    pub states: usize,
    /// Parameters p of a flight.
    pub parameters: usize,
    /// Invariants that are computed once for a flight's parameters.
    pub prepared: usize,
    /// Limits of validity.
    pub limits: usize,
    /// Scratch values of an evaluation.
    pub scratch: usize,
}

/// Arguments of a [`LaneRhs`], one flight per lane.
#[derive(Clone, Copy)]
pub struct LanePoint<'a, T> {
    /// Time, in the unit of the integration.
    pub t: T,
    /// States.
    pub x: &'a [T],
    /// Parameters.
    pub p: &'a [T],
    /// Results of [`LaneRhs::prepare`] for these parameters.
    pub prepared: &'a [T],
}

/// Right-hand side f of dx/dt = f(t, x, p), over lanes.
///
/// Implementations and what they call must be `#[inline(always)]`, for the reason given at [`lanes::Kernel`].
pub trait LaneRhs {
    /// Numbers of values.
    fn sizes(&self) -> LaneSizes;
    /// Computes the invariants of flights from their parameters.
    fn prepare<T: Lanes>(&self, p: &[T], scratch: &mut [T], prepared: &mut [T]);
    /// Writes f(t, x, p) to every element of `dx`.
    fn derivative<T: Lanes>(&self, at: LanePoint<'_, T>, scratch: &mut [T], dx: &mut [T]);
    /// Writes the margins of the limits of validity: the right-hand side holds where all are above 0.
    fn limits<T: Lanes>(&self, at: LanePoint<'_, T>, scratch: &mut [T], margins: &mut [T]);
}

/// Left-hand sides of the limits, in a function of its own: for the rare places that need them.
#[inline(always)]
fn outlined_limits<T: Lanes, R: LaneRhs>(
    rhs: &R,
    at: LanePoint<'_, T>,
    scratch: &mut [T],
    margins: &mut [T],
) {
    T::outlined(Limits {
        rhs,
        at,
        scratch,
        margins,
    });
}

struct Limits<'a, T, R> {
    rhs: &'a R,
    at: LanePoint<'a, T>,
    scratch: &'a mut [T],
    margins: &'a mut [T],
}

impl<T: Lanes, R: LaneRhs> LaneKernel<T> for Limits<'_, T, R> {
    #[inline(always)]
    fn run(self) {
        self.rhs.limits(self.at, self.scratch, self.margins);
    }
}

/// Flights to integrate and where their ends go.
pub trait FlightQueue {
    /// Writes the initial states and the parameters of the next flight and returns its number; `None` after the last.
    fn next(&mut self, x: &mut [f64], p: &mut [f64]) -> Option<u64>;
    /// Takes the end of a flight. The order of ends is not that of [`next`](Self::next).
    fn end(&mut self, end: FlightEnd<'_>);
}

/// How a flight ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlightOutcome {
    /// The height fell to 0.
    Ground,
    /// The final time was reached.
    Time,
    /// The limit of validity of this index was crossed, or exceeded at the start.
    Limit(usize),
    /// The maximum number of steps was reached.
    TooManySteps,
    /// The derivative was not finite, or the error test failed, however short the step.
    StepTooSmall,
    /// At the start the height was below 0, or 0 and falling.
    StartsBelowGround,
    /// An initial state or a parameter was not finite.
    NotFinite,
}

/// End of a flight.
#[derive(Clone, Copy, Debug)]
pub struct FlightEnd<'a> {
    /// Number of the flight, as [`FlightQueue::next`] gave it.
    pub flight: u64,
    /// How it ended.
    pub outcome: FlightOutcome,
    /// Time of the end.
    pub time: f64,
    /// State at that time.
    pub state: &'a [f64],
    /// Greatest height: (time, height), at the start, the end, or where its derivative falls to 0; NaN if
    /// it is not sought.
    pub apex: (f64, f64),
    /// Counts of the flight's own steps and evaluations.
    pub stats: SolverStats,
}

/// When flights end, and what is recorded of them. All start at time 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlightSpan {
    /// Final time.
    pub t_end: f64,
    /// State component that is the height.
    pub height: Option<usize>,
    /// Whether the greatest height is sought.
    pub seeks_apex: bool,
    /// Whether a flight ends where its height falls to 0.
    pub until_ground: bool,
}

impl FlightSpan {
    /// State component whose greatest value is sought.
    fn apex(&self) -> Option<usize> {
        self.height.filter(|_| self.seeks_apex)
    }
}

/// Integrates all flights of a queue on the widest lanes of the processor.
///
/// Returns the vector evaluations of the right-hand side: the flights' own evaluations, shared by the lanes, and those of
/// lanes without a flight.
///
/// # Panics
/// Where options or times are not positive numbers, or the height is not a state.
///
/// ```
/// use ode::{FlightEnd, FlightQueue, FlightSpan, IntegrationOptions, LanePoint, LaneRhs, LaneSizes, fly};
///
/// struct Fall;
/// impl LaneRhs for Fall {
///     fn sizes(&self) -> LaneSizes {
///         LaneSizes { states: 2, parameters: 1, prepared: 0, limits: 0, scratch: 0 }
///     }
///     #[inline(always)]
///     fn prepare<T: lanes::Lanes>(&self, _: &[T], _: &mut [T], _: &mut [T]) {}
///     #[inline(always)]
///     fn derivative<T: lanes::Lanes>(&self, at: LanePoint<'_, T>, _: &mut [T], dx: &mut [T]) {
///         (dx[0], dx[1]) = (at.x[1], -at.p[0]);
///     }
///     #[inline(always)]
///     fn limits<T: lanes::Lanes>(&self, _: LanePoint<'_, T>, _: &mut [T], _: &mut [T]) {}
/// }
///
/// /// Ten falls from 1 m to 10 m.
/// struct Falls(u64, [f64; 10]);
/// impl FlightQueue for Falls {
///     fn next(&mut self, x: &mut [f64], p: &mut [f64]) -> Option<u64> {
///         self.0 += 1;
///         (x[0], x[1], p[0]) = (self.0 as f64, 0.0, 9.81);
///         (self.0 <= 10).then_some(self.0)
///     }
///     fn end(&mut self, end: FlightEnd<'_>) {
///         self.1[end.flight as usize - 1] = end.time;
///     }
/// }
///
/// let span = FlightSpan { t_end: 10.0, height: Some(0), seeks_apex: false, until_ground: true };
/// let mut falls = Falls(0, [0.0; 10]);
/// fly(&Fall, &mut falls, &span, &IntegrationOptions::default());
/// for (k, time) in falls.1.iter().enumerate() {
///     let height = (k + 1) as f64;
///     assert!((time - (2.0 * height / 9.81).sqrt()).abs() < 1e-9);
/// }
/// ```
pub fn fly<R: LaneRhs, Q: FlightQueue + ?Sized>(
    rhs: &R,
    queue: &mut Q,
    span: &FlightSpan,
    options: &IntegrationOptions,
) -> u64 {
    dispatch(batch(rhs, queue, span, options))
}

/// As [`fly`], on the lanes of one instruction set; `None` if the processor does not support it.
///
/// # Panics
/// As [`fly`].
pub fn fly_on<R: LaneRhs, Q: FlightQueue + ?Sized>(
    isa: Isa,
    rhs: &R,
    queue: &mut Q,
    span: &FlightSpan,
    options: &IntegrationOptions,
) -> Option<u64> {
    dispatch_with(isa, batch(rhs, queue, span, options))
}

/// As [`fly_on`], compiled only for the widest instruction sets of the architecture; `None` for others, and if the
/// processor does not support `isa`. See [`lanes::dispatch_widest`].
///
/// # Panics
/// As [`fly`].
pub fn fly_on_widest<R: LaneRhs, Q: FlightQueue + ?Sized>(
    isa: Isa,
    rhs: &R,
    queue: &mut Q,
    span: &FlightSpan,
    options: &IntegrationOptions,
) -> Option<u64> {
    dispatch_widest(isa, batch(rhs, queue, span, options))
}

/// The kernel that integrates the flights, after a check of what it is given.
fn batch<'a, R: LaneRhs, Q: FlightQueue + ?Sized>(
    rhs: &'a R,
    queue: &'a mut Q,
    span: &'a FlightSpan,
    options: &'a IntegrationOptions,
) -> kernel::Batch<'a, R, Q> {
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
