//! Flight models with exact derivatives, fitted to motion capture and diagnosed for missing effects.
//!
//! A [`Model`] is loaded by name, path or text; an [`Effect`] extends it. Flying a [`Release`] gives a [`Flight`] with
//! states and marker positions at any time. A [`Dataset`] is read from files ([`read_dataset`]),
//! built in memory ([`DatasetBuilder`]) or simulated ([`synthesize`]). [`Fit::of`] estimates the model's coefficients
//! with their standard errors, [`Diagnosis::of`] tests which effects the model lacks, and [`Verification::of`] checks
//! a model against its reference. [`Design::of`] searches for a throw, [`Stability::of`] linearises the motion, and
//! [`sweep()`] flies many flights. Fallible operations return an [`Error`].
//!
//! ```
#![doc = include_str!("../examples/library.rs")]
//! ```
//!
//! Long work reports its progress and can be cancelled ([`Progress`], [`CancellationToken`]). Results do not depend on
//! the number of threads.
//!
//! The feature `cli`, on by default, builds the program `hyzer`; library users disable it with
//! `default-features = false` and choose among `sweep` and `verification`.

#![forbid(unsafe_code)]

#[cfg(feature = "cli")]
mod cli;
#[cfg(feature = "cli")]
mod commands;
mod dataset;
mod design;
mod diagnosis;
mod error;
mod fit;
mod flight;
#[cfg(feature = "cli")]
mod lsp;
mod model;
#[cfg(feature = "cli")]
mod output;
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod program;
#[cfg(feature = "cli")]
mod progress;
mod stability;
#[cfg(feature = "sweep")]
mod sweep;
#[cfg(feature = "verification")]
mod verification;

#[cfg(feature = "cli")]
use commands::Answer;
pub use error::Error;

// Models and their flights.
pub use ::flight::release::{Release, Stop};
pub use ::flight::throw::Throw;
pub use ::flight::wind::WindField;
pub use ::flight::{InputInterpolation, InputSeries};
pub use flight::Flight;
pub use model::{Effect, Model};

// Datasets.
pub use ::dataset::synthesize::{Corruption, Plan, Spread};
pub use ::dataset::{
    DataFault, Dataset, FaultKind, Flight as MeasuredFlight, KnownValue, Marker, Reading, Role,
    Sensor, SensorKind,
};
pub use dataset::{DatasetBuilder, read_dataset, synthesize};
pub use model_spec::compose::Instrument;

// Fits.
pub use fit::{Estimate, Fit, FitBuilder};
pub use identify::{CancellationToken, FitReport, FlightOutcome, Progress};

// Diagnoses.
pub use ::diagnose::{
    Estimate as EffectEstimate, Explanation, ExplanationEffect, PredictiveGain, RemainingEffect,
    Verdict,
};
pub use diagnosis::{Diagnosis, DiagnosisBuilder};

// Throws for a purpose, stability, many flights, verification.
pub use ::analysis::design::Goal;
#[cfg(feature = "verification")]
pub use ::verify::report::Outcome;
pub use design::{Design, DesignBuilder};
pub use stability::{Mode, Stability};
#[cfg(feature = "sweep")]
pub use sweep::{Sweep, sweep};
#[cfg(feature = "verification")]
pub use verification::Verification;

/// Parts of a [`FitReport`].
pub mod fit_report {
    pub use identify::{
        AxisNoise, AxisResiduals, Coefficient, Estimate, FitStatus, FlightReport, Iterations,
        MarkerDistance, NoiseReport, NonIdentifiable, Profile, Rms, SensorReport, Truncation,
    };
}

/// Causes of an [`Error`].
pub mod errors {
    #[cfg(feature = "sweep")]
    pub use analysis::sweep::SweepError;
    pub use {
        ::dataset::InputError, ::dataset::synthesize::SynthesisError, ::flight::release::Fault,
        ::flight::release::ReleaseError, analysis::design::DesignError,
        analysis::design::ThrowFlightError, analysis::stability::StabilityError,
        diagnose::DiagnosisError, identify::FitError, model_spec::LoadError,
        model_spec::compose::ValueError, ode::IntegrationError,
    };
}

/// Compiles the code of the how-to.
#[cfg(doctest)]
#[doc = include_str!("../docs/how-to/use-the-library.md")]
struct HowTo;
