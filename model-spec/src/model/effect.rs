//! Effects of a checked model: applied effects, and effects declared in the model's file.

#[cfg(doc)]
use crate::model::Model;
use crate::source::Span;

/// An effect that has been applied to a model.
#[derive(Clone, Debug)]
pub struct AppliedEffect {
    /// Name of the effect, words separated by underscores, such as `added_mass`.
    pub name: String,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Component of the model that the effect changes: one of [`SITES`](crate::SITES).
    pub site: String,
    /// Kinds of variables on which the effect depends, from [`VARIABLES`](crate::VARIABLES); may be empty.
    pub variables: Vec<String>,
    /// Literature reference of the effect, from its `source` statement; empty if there is none.
    pub citation: String,
    /// Sentence for a first coefficient beyond its null value, from the statement of this name; may be empty.
    pub increases: String,
    /// Sentence for a first coefficient beyond its null value, from the statement of this name; may be empty.
    pub decreases: String,
    /// Coefficients that the effect adds; [`EffectUnknown::index`] refers to [`Model::coefficients`].
    pub coefficients: Vec<EffectUnknown>,
    /// States that the effect adds, with an initial value for each flight; indices into [`Model::states`].
    pub states: Vec<EffectUnknown>,
}

impl AppliedEffect {
    /// Sentence for a first coefficient that exceeds its null value by `departure`; the documentation if none is
    /// stated.
    pub fn sentence(&self, departure: f64) -> &str {
        let stated = if departure > 0.0 {
            &self.increases
        } else if departure < 0.0 {
            &self.decreases
        } else {
            &self.doc
        };
        if stated.is_empty() { &self.doc } else { stated }
    }
}

/// An effect declared in a model's file. It can be applied by its name.
#[derive(Clone, Debug)]
pub struct OfferedEffect {
    /// Name of the effect, words separated by underscores.
    pub name: String,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Source span of the name of the effect.
    pub span: Span,
}

/// A coefficient or initial state that an effect adds; at its null value, the effect is absent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffectUnknown {
    /// Index into [`Model::coefficients`] for a coefficient, or into [`Model::states`] for a state.
    pub index: usize,
    /// Null value: value at which the effect is absent, SI; equal to the default value of the coefficient or state.
    pub null_value: f64,
    /// Smallest difference from [`EffectUnknown::null_value`] that matters in practice, SI; `None` if not stated.
    pub smallest_effect_of_interest: Option<f64>,
}
