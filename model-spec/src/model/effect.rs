//! Effects of a checked model: applied effects, and effects declared in the model's file.

#[cfg(doc)]
use crate::model::Model;
use crate::source::Span;

/// An effect (a named change to a model, such as an additional force) that has been applied to a model.
#[derive(Clone, Debug)]
pub struct AppliedEffect {
    /// Name of the effect, words separated by underscores, such as `added_mass`.
    pub name: String,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Component of the model that the effect changes: one of [`SITES`](crate::SITES).
    pub site: String,
    /// Kinds of variables on which the magnitude of the effect depends, from [`VARIABLES`](crate::VARIABLES); empty if
    /// none are stated.
    pub variables: Vec<String>,
    /// Literature reference of the effect, from its `source` statement; empty if there is none.
    pub citation: String,
    /// Sentence that describes the effect if its first coefficient exceeds its null value, from the statement
    /// `increases "…"`; empty if not stated.
    pub increases: String,
    /// Sentence that describes the effect if its first coefficient is below its null value, from the statement
    /// `decreases "…"`; empty if not stated.
    pub decreases: String,
    /// Coefficients that the effect adds; [`EffectUnknown::index`] refers to [`Model::coefficients`].
    pub coefficients: Vec<EffectUnknown>,
    /// States that the effect adds; [`EffectUnknown::index`] refers to [`Model::states`]. The initial value of such a
    /// state is estimated separately for each flight.
    pub states: Vec<EffectUnknown>,
}

impl AppliedEffect {
    /// Sentence that describes the effect for `departure`, the value of the first coefficient minus its null value:
    /// [`AppliedEffect::increases`] if `departure` is positive, [`AppliedEffect::decreases`] if it is negative. Returns
    /// the documentation of the effect if `departure` is 0 or the selected sentence is empty.
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

/// An effect (a named change to a model, such as an additional force) declared in a model's file. It can be applied by
/// its name.
#[derive(Clone, Debug)]
pub struct OfferedEffect {
    /// Name of the effect, words separated by underscores.
    pub name: String,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Source span of the name of the effect.
    pub span: Span,
}

/// An unknown quantity that an effect adds: a coefficient, or the initial value of a state. The effect is absent if the
/// quantity has its null value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffectUnknown {
    /// Index into [`Model::coefficients`] for a coefficient, or into [`Model::states`] for a state.
    pub index: usize,
    /// Null value: value at which the effect is absent, SI; equal to the default value of the coefficient or state.
    pub null_value: f64,
    /// Smallest difference from [`EffectUnknown::null_value`] that matters in practice (smallest effect size of
    /// interest), SI; `None` if not stated.
    pub smallest_effect_of_interest: Option<f64>,
}
