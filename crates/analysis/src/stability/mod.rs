//! Stability of flying bodies: modes of the linearised motion, steady flight, and criteria in symbols.
//!
//! - [`Body`] is a rigid body of any model; [`BoundBody::linearise`] computes its [`Linearised`] motion about a state
//!   from the model's exact Jacobian, in coordinates that do not depend on those of the model.
//! - [`modes`](fn@modes) removes the coordinates that nothing depends on and classifies the remaining motion: nutation,
//!   incidence, phugoid and others.
//! - [`AxisDerivatives`] are the few derivatives that determine how the body axis moves in the air stream;
//!   [`Criteria`] are the stability criteria computed from them.
//! - [`trim`](fn@trim) finds steady flight; [`along`] evaluates modes and criteria along a flight, and [`map`] over a
//!   grid of speeds and spins.
//!
//! ```
//! use flight::throw::Throw;
//! use analysis::stability::{self, Body, ModeKind};
//!
//! let body = Body::new(model_spec::load::load("disc", &[])?)?;
//! let bound = body.with_parameters(body.compiled.layout().default_parameters());
//! let throw = Throw { spin: Some(700.0), ..Throw::at_speed(16.0) };
//! let state = body.thrown.state(&throw, [0.0; 2], &bound.parameters)?;
//! let instant = stability::at(&bound, 0.0, &state)?;
//! let nutation = &instant.modes.modes[0];
//! assert_eq!(nutation.kind, ModeKind::Nutation);
//! assert!((nutation.frequency() / instant.criteria.nutation - 1.0).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod criteria;
mod linearise;
mod modes;
mod state_space;
mod survey;
mod trim;

pub use criteria::{AxisDerivatives, Criteria, FlightDirection};
pub use linearise::{Body, BoundBody, Linearised, StabilityError};
pub use modes::{Mode, ModeKind, Modes, NEUTRAL, modes};
pub use state_space::{ControlDerivative, StateSpace};
pub use survey::{Instant, along, at, map};
pub use trim::{Trim, trim};
