//! The model with selected effects, in memory and as a model file.

mod extended_model;

pub use extended_model::ExtendedModel;
