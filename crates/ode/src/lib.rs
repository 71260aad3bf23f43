//! Explicit Runge–Kutta integration of initial value problems dx/dt = f(t, x), with dense output, event location
//! and forward sensitivities.
//!
//! - **Problem**: [`OdeRhs`] is the right-hand side f; [`rhs_from_fn`] builds a right-hand side from a closure. States
//!   are fixed arrays or boxed slices ([`StateVector`]), so that an integration allocates nothing per step.
//! - **Integration**: [`integrate`] returns a [`Trajectory`] that can be evaluated at any time; [`integrate_at`],
//!   [`integrate_with_callback`] and [`integrate_to_end`] do not store dense output. [`IntegrationOptions`] sets
//!   method, tolerances and step bounds; each result contains its [`SolverStats`].
//! - **Constraints**: states are held to what the equations keep by a [`Projection`], at the ends of steps and where
//!   they are read between them.
//! - **Events**: an [`Event`] is a zero of a function of time and state; it is recorded, stops the integration, or
//!   makes the integration fail.
//! - **Sensitivities**: [`Sensitivities`] integrates ∂x/∂x₀ and ∂x/∂p together with x, from a
//!   [`DifferentiableRhs`] with sparse Jacobians ∂f/∂x and ∂f/∂p.
//! - **Batches**: [`fly_on`] integrates many initial value problems ("flights"), one per SIMD lane, each with its own step
//!   sizes and events.
//!
//! ```
//! use ode::{IntegrationOptions, integrate, rhs_from_fn};
//!
//! // Van der Pol's oscillator.
//! let mut rhs = rhs_from_fn(&["x", "v"], |_, x: &[f64; 2], dx: &mut [f64; 2]| {
//!     *dx = [x[1], (1.0 - x[0] * x[0]) * x[1] - x[0]];
//! });
//! let options = IntegrationOptions::with_tolerance(1e-9);
//! let solution = integrate(&mut rhs, (0.0, &[2.0, 0.0]), 20.0, &options, &mut [])?;
//! let x = solution.sample(12.5).expect("a time within the solution");
//! assert!(x[0].abs() < 2.1);
//! assert!(solution.stats.rejected < solution.stats.steps);
//! # Ok::<(), ode::IntegrationError>(())
//! ```

#![forbid(unsafe_code)]

mod aligned;
mod batch;
mod dense_output;
mod error;
mod event;
mod input;
mod integrate;
mod method;
mod options;
mod projection;
mod rhs;
mod root;
mod sensitivity;
mod solver;
mod step_control;
mod switches;
mod time_breaks;
mod trajectory;

pub use aligned::AlignedVec;
pub use batch::{
    FlightEnd, FlightOutcome, FlightQueue, FlightSpan, LanePoint, LaneRhs, LaneSizes, fly_on,
    fly_on_widest,
};
pub use error::{IntegrationError, IntegrationFailure};
pub use event::{Event, Occurrence};
pub use integrate::{
    integrate, integrate_at, integrate_to_end, integrate_to_event, integrate_with_callback,
};
pub use method::Method;
pub use options::{IntegrationOptions, SolverStats};
pub use projection::{Project, Projection};
pub use rhs::{FnRhs, OdeRhs, RhsProperties, StateVector, rhs_from_fn};
pub use sensitivity::{DifferentiableRhs, Sensitivities, SensitivityLayout};
pub use solver::Endpoint;
pub use trajectory::Trajectory;
