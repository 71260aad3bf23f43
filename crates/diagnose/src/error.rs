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

impl DiagnosisError {
    /// File of the flight that cannot be tested, if the error is of one flight.
    pub(crate) fn flight(&self) -> Option<&str> {
        match self {
            Self::UndeterminedInitialState { file } | Self::Fit(FitError::Flight { file, .. }) => {
                Some(file)
            }
            _ => None,
        }
    }
}

/// Turns an error into nothing, except that the caller cancelled: what cannot be fitted is no answer, and no failure.
pub(crate) fn if_possible<T, E: Into<DiagnosisError>>(
    result: Result<T, E>,
) -> Result<Option<T>, DiagnosisError> {
    match result.map_err(Into::into) {
        Ok(value) => Ok(Some(value)),
        Err(DiagnosisError::Fit(FitError::Interrupted)) => Err(FitError::Interrupted.into()),
        Err(_) => Ok(None),
    }
}
