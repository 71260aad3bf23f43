//! Out-of-sample validation: error reduction by an extension on flights that were not fitted.

mod cross_validation;
mod predictive_gain;

pub(crate) use cross_validation::{ApplyTo, ChosenExtension, cross_validate, predictive_terms};
pub(crate) use predictive_gain::gain_of_fits;

pub use predictive_gain::{PredictiveGain, held_out_gain};
