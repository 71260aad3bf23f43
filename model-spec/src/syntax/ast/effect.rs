//! Syntax tree of effects.

use super::{Expr, Inertia, Item, Name, Quantity, UnitExpr};
use crate::source::Span;

/// An effect: a named change to a model, such as an additional force or another drag coefficient, written as `effect
/// NAME { … }`.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// Name of the effect, words separated by underscores.
    pub name: Name,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Names of the models that the effect is compatible with; empty for any model.
    pub on: Vec<Name>,
    /// Statements in the block of the effect, in order.
    pub parts: Vec<EffectPart>,
}

impl Effect {
    /// Whether the effect is restricted to certain models by `on MODEL, …`, and `model` is not one of them.
    pub(crate) fn excludes(&self, model: &str) -> bool {
        !self.on.is_empty() && self.on.iter().all(|on| on.text != model)
    }
}

/// A quantity that a model must have for an effect to be applicable.
#[derive(Clone, Debug, PartialEq)]
pub struct Need {
    /// Name of the needed quantity, such as `air_velocity`.
    pub name: Name,
    /// Whether the needed quantity is a vector.
    pub is_vector: bool,
    /// Unit of the needed quantity; `None` for an angle or a pure number.
    pub unit: Option<UnitExpr>,
    /// Fallback expression that replaces the quantity in a model that lacks it; `None` if the effect is not applicable
    /// to such a model.
    pub otherwise: Option<Expr>,
}

/// A statement in the block of an effect.
#[derive(Clone, Debug, PartialEq)]
pub enum EffectPart {
    /// `needs NAME: UNIT, …;`: quantities that the model must have, each with its kind (scalar or vector), unit and
    /// optional fallback expression.
    Needs(Vec<Need>),
    /// `generalises NAME, …;`: more specific effects, each made for a narrower family of models, of which this effect
    /// is the general form. If one of them is applicable to a model, the search for effects that the model lacks does
    /// not consider this effect.
    Generalises(Vec<Name>),
    /// `source "…";`: literature reference, with the source span of the statement.
    Citation(String, Span),
    /// `increases "…";`: sentence with which a diagnosis describes the effect where the first coefficient of the effect
    /// is estimated above its null value, with the source span of the statement.
    Increases(String, Span),
    /// `decreases "…";`: sentence with which a diagnosis describes the effect where the first coefficient of the effect
    /// is estimated below its null value, with the source span of the statement.
    Decreases(String, Span),
    /// `site NAME;`: the component of the model that the effect changes, such as `drag`; one of
    /// [`SITES`](crate::SITES).
    Site(Name),
    /// `variables NAME, NAME;`: kinds of variables on which the magnitude of the effect depends, from
    /// [`VARIABLES`](crate::VARIABLES), with the source span of the statement.
    Variables(Vec<Name>, Span),
    /// `negligible NAME value;`: smallest difference of a coefficient or initial state from its null value that matters
    /// in practice (smallest effect size of interest).
    Negligible(Name, Quantity),
    /// `replace …;`: statement that replaces the model's statement of equal kind and name.
    Replace(Box<Item>),
    /// `replace inertia … in FRAME;`: inertia tensor that replaces that of the model's body, with the source span of
    /// the statement.
    ReplaceInertia(Box<Inertia>, Span),
    /// A declaration, such as a coefficient or a load, that the effect adds to the model.
    Add(Box<Item>),
}
