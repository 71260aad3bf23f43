//! Flight models with exact derivatives, fitted to motion capture and diagnosed for missing effects.
//!
//! A [`Model`] is loaded by name, path or text, with built-in effects or effects of your own. Simulating a
//! [`Release`] with it gives a [`Flight`], with states and marker positions at any time. A [`Dataset`] is read from
//! files ([`read_dataset`]) or built in memory ([`DatasetBuilder`]). [`fit`] estimates the model's coefficients from
//! a dataset, with their standard errors; [`diagnose`](fn@diagnose) tests which effects the model lacks. All fallible
//! operations return an [`Error`].
//!
//! ```
#![doc = include_str!("../examples/library.rs")]
//! ```
//!
//! Progress, cancellation, a deadline and the number of threads are options of the caller: see [`FitOptions`].
//! Results do not depend on the number of threads. [`Fit::is_reliable`] states whether a fit can be relied on, and
//! [`Fit::data_faults`] lists mistakes that the data seem to have.
//!
//! The feature `cli`, on by default, builds the program `hyzer`; library users disable it with
//! `default-features = false`.

#![forbid(unsafe_code)]

mod dataset;
mod diagnosis;
mod error;
mod fit;
mod flight;
mod model;
#[cfg(feature = "sweep")]
mod sweep;

pub use error::Error;

// Models and their flights.
pub use ::flight::release::{Release, Stop as StopCondition};
pub use flight::Flight;
pub use model::Model;
pub use ode::{IntegrationOptions, Trajectory};

// Throws for a purpose, and stability.
pub use analysis::design::{Bounds, Design, Goal, SearchOptions, ThrownBody, design};
pub use analysis::stability::{Body as LinearisedBody, Mode, ModeKind, modes};

// Datasets.
pub use ::dataset::{Dataset, Flight as MeasuredFlight, KnownValue, Marker, Role};
pub use dataset::{DatasetBuilder, read_dataset};

// Fits.
pub use fit::{Estimate, Fit, fit};
pub use identify::{CancellationToken, FitOptions, FitReport, FlightOutcome, Prior, Progress};
pub use identify::{DataFault, FaultKind};

// Many flights.
#[cfg(feature = "sweep")]
pub use sweep::{Sweep, sweep};

// Diagnoses.
pub use diagnosis::{Diagnosis, DiagnosisOptions, diagnose};

/// Crates of the workspace on which this library is built, for functions that it does not re-export itself.
pub mod crates {
    pub use {::dataset, ::flight};
    pub use {analysis, codegen, diagnose, identify, model_spec, ode};
}
