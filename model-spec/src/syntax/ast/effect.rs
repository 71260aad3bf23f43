//! Syntax tree of effects.

use super::{Expr, Inertia, Item, Name, Quantity, UnitExpr};
use crate::source::Span;

/// An effect `effect NAME { … }`: a named change to a model, such as an additional force.
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
    /// Statements that the effect adds to the model, in order.
    pub(crate) fn added(&self) -> impl Iterator<Item = &Item> {
        self.parts.iter().filter_map(|part| match part {
            EffectPart::Add(item) => Some(&**item),
            _ => None,
        })
    }

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
    /// Fallback expression in a model that lacks the quantity.
    pub otherwise: Option<Expr>,
}

/// A statement in the block of an effect.
#[derive(Clone, Debug, PartialEq)]
pub enum EffectPart {
    /// `needs NAME: UNIT, …;`: quantities that the model must have.
    Needs(Vec<Need>),
    /// `generalises NAME, …;`: more specific effects; where one is applicable, this one is no candidate.
    Generalises(Vec<Name>),
    /// `source "…";`: literature reference, with the source span of the statement.
    Citation(String, Span),
    /// `increases "…";`: sentence for a first coefficient above its null value, with the span of the statement.
    Increases(String, Span),
    /// `decreases "…";`: sentence for a first coefficient below its null value, with the span of the statement.
    Decreases(String, Span),
    /// `site NAME;`: component of the model that changes, one of [`SITES`](crate::SITES).
    Site(Name),
    /// `variables NAME, NAME;`: what the effect depends on, from [`VARIABLES`](crate::VARIABLES), with the span.
    Variables(Vec<Name>, Span),
    /// `negligible NAME value;`: smallest effect size of interest of a coefficient or initial state.
    Negligible(Name, Quantity),
    /// `replace …;`: statement that replaces the model's statement of equal kind and name.
    Replace(Box<Item>),
    /// `replace inertia … in FRAME;`: inertia tensor in place of the body's, with the span of the statement.
    ReplaceInertia(Box<Inertia>, Span),
    /// A declaration, such as a coefficient or a load, that the effect adds to the model.
    Add(Box<Item>),
}
