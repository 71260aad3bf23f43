//! Errors of a diagnosis.

use identify::FitError;
use model_spec::load::LoadError;

use crate::context::OptionsError;

/// Reason why a diagnosis cannot be completed.
#[derive(Debug, thiserror::Error)]
pub enum DiagnosisError {
    /// An option has an invalid value, or names an effect that does not exist.
    #[error(transparent)]
    Options(#[from] OptionsError),
    /// The flights cannot be fitted.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// The model extended by all candidate effects, or by the selected ones, cannot be loaded.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// The samples of a flight do not determine its initial state.
    #[error("{file}: the samples do not determine the initial state")]
    UndeterminedInitialState {
        /// File name of the flight.
        file: String,
    },
    /// The information matrix of the model's parameters contains values that are not finite.
    #[error(
        "the information matrix of the model's parameters cannot be inverted: look for values that are not finite"
    )]
    SingularInformation,
}

impl DiagnosisError {
    /// File of the flight that caused the error; `None` if the error does not concern a single flight.
    pub(crate) fn flight(&self) -> Option<&str> {
        match self {
            Self::UndeterminedInitialState { file } | Self::Fit(FitError::Flight { file, .. }) => {
                Some(file)
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use identify::FlightError;

    #[test]
    fn an_error_of_one_flight_names_it() {
        let file = || "a.csv".to_owned();
        let of_flight = DiagnosisError::UndeterminedInitialState { file: file() };
        assert_eq!(of_flight.flight(), Some("a.csv"));
        let of_fit = FitError::Flight {
            file: file(),
            reason: FlightError::NoMatchingState,
        };
        assert_eq!(DiagnosisError::from(of_fit).flight(), Some("a.csv"));
        assert_eq!(DiagnosisError::SingularInformation.flight(), None);
    }
}
