//! Effects of a checked model: applied ones, and ones that the model's file declares.

#[cfg(doc)]
use crate::model::Model;
use crate::source::Span;

/// An effect that has been applied to a model.
#[derive(Clone, Debug)]
pub struct AppliedEffect {
    /// Name of the effect, words separated by underscores.
    pub name: String,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Component of the model that the effect changes: one of [`SITES`](crate::SITES).
    pub site: String,
    /// Variables that the effect depends on, from [`VARIABLES`](crate::VARIABLES); empty if none are stated.
    pub variables: Vec<String>,
    /// Literature reference of the effect (`source` statement); empty if there is none.
    pub citation: String,
    /// What the effect does where its first coefficient is above its null value (`increases "…"`); empty if not stated.
    pub increases: String,
    /// What the effect does where its first coefficient is below its null value (`decreases "…"`); empty if not stated.
    pub decreases: String,
    /// Coefficients of the effect, by index into [`Model::coefficients`].
    pub coefficients: Vec<EffectUnknown>,
    /// States of the effect, by index into [`Model::states`]; their initial values are local parameters of each flight.
    pub states: Vec<EffectUnknown>,
}

impl AppliedEffect {
    /// What the effect does where its first coefficient departs from its null value by `departure`; its documentation if
    /// the effect does not state it.
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

/// An effect declared in a model's file, which can be applied by its name.
#[derive(Clone, Debug)]
pub struct OfferedEffect {
    /// Name of the effect, words separated by underscores.
    pub name: String,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Source span of the effect's name.
    pub span: Span,
}

/// A coefficient or initial state of an effect: at its null value it contributes nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffectUnknown {
    /// Index into the model's coefficients, or into its states.
    pub index: usize,
    /// Value at which the effect is absent, SI; equal to the default value.
    pub null_value: f64,
    /// Smallest effect size of interest, as distance from the null value, SI; `None` if not stated.
    pub smallest_of_interest: Option<f64>,
}
