//! Effects of a checked model: those that are applied, and those that its file offers.

#[cfg(doc)]
use crate::model::Model;
use crate::source::Span;

/// An effect that has been applied to a model.
#[derive(Clone, Debug)]
pub struct AppliedEffect {
    /// Name, words separated by underscores.
    pub name: String,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Part of the model that it changes: one of [`SITES`](crate::SITES).
    pub site: String,
    /// Variables it depends on, of [`VARIABLES`](crate::VARIABLES); empty if it states none.
    pub variables: Vec<String>,
    /// Literature reference of its `source` statement; empty if there is none.
    pub citation: String,
    /// Its coefficients, by index into [`Model::coefficients`].
    pub coefficients: Vec<EffectUnknown>,
    /// Its states, by index into [`Model::states`]; their initial values differ from flight to flight.
    pub states: Vec<EffectUnknown>,
}

/// An effect that a model's file offers by name.
#[derive(Clone, Debug)]
pub struct OfferedEffect {
    /// Name, words separated by underscores.
    pub name: String,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Source span of its name.
    pub span: Span,
}

/// A coefficient, or the initial value of a state, by which an effect is switched on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffectUnknown {
    /// Index into the model's coefficients or states.
    pub index: usize,
    /// Value at which the effect is absent, SI: the default.
    pub null_value: f64,
    /// Smallest distance from the null value that matters in practice, SI; none if the effect states none.
    pub smallest_of_interest: Option<f64>,
}
