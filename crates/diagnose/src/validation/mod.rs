//! Out-of-sample validation: error reduction by an extension on flights that were not fitted.

mod cross_validation;
mod discordant_beginning;
mod overflexible;
mod predictive_gain;
mod predictive_terms;

pub(crate) use cross_validation::cross_validate;
pub(crate) use discordant_beginning::ApplyTo;
pub(crate) use overflexible::Validated;
pub(crate) use predictive_gain::gain_of_fits;
pub(crate) use predictive_terms::predictive_terms;

pub use predictive_gain::{PredictiveGain, held_out_gain};
