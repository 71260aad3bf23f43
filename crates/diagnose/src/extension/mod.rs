//! The model with selected effects, as a model and as a file of its own.

mod extended_model;

pub use extended_model::ExtendedModel;
