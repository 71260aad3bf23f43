//! Specification search by forward selection and backward elimination.

mod after_round;
mod bic;
mod hypothesis;
mod nearest;
mod search;
mod stepwise_terms;

pub(crate) use after_round::INFLATED;
pub(crate) use bic::{are_alternative, select_by_bic};
pub(crate) use hypothesis::Hypothesis;
pub(crate) use search::{MAX_EFFECTS, Search, Weights};
pub(crate) use stepwise_terms::{FittedTerms, MAX_SELECTED, StepwiseModel};

pub use stepwise_terms::StepwiseTerm;
