//! Errors of the library.

use dataset::InputError;
use diagnose::DiagnosisError;
use flight::release::ReleaseError;
use identify::FitError;
use model_spec::LoadError;
use ode::IntegrationError;

/// Error of an operation of the library; the variants name the operation that failed.
#[derive(thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A model or an effect (optional model extension) cannot be loaded: a missing file, an unknown name, or faults in
    /// a text.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// A release file (launch conditions of a flight) has faults.
    #[error(transparent)]
    Release(#[from] ReleaseError),
    /// A trajectory cannot be computed.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// A dataset cannot be read or built, because its files or values have faults.
    #[error(transparent)]
    Dataset(#[from] InputError),
    /// A model cannot be fitted to a dataset.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// A dataset cannot be diagnosed: the search for effects (possible extensions) that its model lacks failed.
    #[error(transparent)]
    Diagnosis(#[from] DiagnosisError),
    /// A sweep cannot be computed, or its results cannot be written.
    #[cfg(feature = "sweep")]
    #[error(transparent)]
    Sweep(#[from] analysis::sweep::SweepError),
    /// There is no built-in release (launch conditions of a flight) of the given name.
    #[error("no built-in release {name:?}; expected one of {}", known.join(", "))]
    UnknownRelease {
        /// Name of the release that was requested.
        name: String,
        /// Names of the built-in releases (launch conditions of a flight).
        known: Vec<&'static str>,
    },
    /// A release (launch conditions of a flight) sets a parameter or coefficient that the model does not have.
    #[error("the model {model} has no state, parameter or coefficient {name:?}")]
    UnknownName {
        /// Name of the model to which the release was applied.
        model: String,
        /// Name that the release sets, but that is neither a parameter nor a coefficient of the model.
        name: String,
    },
}

/// Writes the same text as `Display`, because Rust uses `Debug` to print an error that `main` returns.
impl std::fmt::Debug for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self, f)
    }
}
