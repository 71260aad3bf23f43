//! Last stage of the search: the model extended by the selected effects, in memory and as the text of a model file.

mod extended_model;

pub use extended_model::ExtendedModel;
