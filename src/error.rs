//! Errors of the library.

use dataset::InputError;
use diagnose::DiagnosisError;
use flight::release::ReleaseError;
use identify::FitError;
use model_spec::LoadError;
use ode::IntegrationError;

/// Error of an operation of the library; the variants name the operation that failed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A model or an effect cannot be loaded.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// A release file has faults.
    #[error(transparent)]
    Release(#[from] ReleaseError),
    /// A trajectory cannot be computed.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// A dataset cannot be read or built.
    #[error(transparent)]
    Dataset(#[from] InputError),
    /// A model cannot be fitted to a dataset.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// The estimates of a fit cannot be written into the text of its model.
    #[error(transparent)]
    FittedText(#[from] model_spec::compose::ValueError),
    /// A report cannot be written as JSON.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
    /// A dataset cannot be diagnosed.
    #[error(transparent)]
    Diagnosis(#[from] DiagnosisError),
    /// A dataset cannot be simulated.
    #[error(transparent)]
    Synthesis(#[from] dataset::synthesize::SynthesisError),
    /// A body cannot be thrown.
    #[error(transparent)]
    Throw(#[from] analysis::design::ThrowFlightError),
    /// No throw serves the goal.
    #[error(transparent)]
    Design(#[from] analysis::design::DesignError),
    /// The motion cannot be linearised.
    #[error(transparent)]
    Stability(#[from] analysis::stability::StabilityError),
    /// A sweep cannot be computed, or its results cannot be written.
    #[cfg(feature = "sweep")]
    #[error(transparent)]
    Sweep(#[from] analysis::sweep::SweepError),
    /// There is no built-in release of the given name.
    #[error("no built-in release {name:?}; expected one of {}", known.join(", "))]
    UnknownRelease {
        /// Name that was requested.
        name: String,
        /// Names of the built-in releases.
        known: Vec<&'static str>,
    },
    /// No flight can begin in the initial state of a release, for the stated reason.
    #[error("{0}")]
    InitialState(String),
    /// A release or a design names a quantity that the model does not have.
    #[error("the model {model} has no state, parameter or coefficient {name:?}")]
    UnknownName {
        /// Name of the model.
        model: String,
        /// Name that it does not have.
        name: String,
    },
}
