//! Why a diagnosis fails.

use identify::FitError;
use model_spec::load::LoadError;

use crate::context::OptionsError;

/// Why a diagnosis fails.
#[derive(Debug, thiserror::Error)]
pub enum DiagnosisError {
    /// An option cannot be used.
    #[error(transparent)]
    Options(#[from] OptionsError),
    /// The flights cannot be fitted.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// The model with candidate effects, or with the selected ones, cannot be loaded.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// The samples of a flight do not determine its initial state.
    #[error("{file}: the samples do not determine the initial state")]
    UndeterminedInitialState {
        /// File of the flight.
        file: String,
    },
    /// The information matrix of the model's own parameters has no eigenvalue decomposition.
    #[error(
        "the information matrix of the model's parameters cannot be inverted: look for values that are not finite"
    )]
    SingularInformation,
}
