//! Syntax tree of effects.

use super::{Expr, Inertia, Item, Name, Quantity, UnitExpr};
use crate::source::Span;

/// An effect: a named change to a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// Name of the effect.
    pub name: Name,
    /// Documentation: the `///` lines before the effect.
    pub doc: String,
    /// Names of the models that the effect is compatible with; empty for any model.
    pub on: Vec<Name>,
    /// Statements of the effect's block, in order.
    pub parts: Vec<EffectPart>,
}

/// A quantity that a model must have for an effect.
#[derive(Clone, Debug, PartialEq)]
pub struct Need {
    /// Name of the quantity.
    pub name: Name,
    /// Whether the quantity is a vector.
    pub is_vector: bool,
    /// Unit of the quantity; `None` for an angle or a pure number.
    pub unit: Option<UnitExpr>,
    /// Expression that stands for the quantity in a model without it; `None` if the effect needs the quantity.
    pub otherwise: Option<Expr>,
}

/// A statement in the block of an effect.
#[derive(Clone, Debug, PartialEq)]
pub enum EffectPart {
    /// `needs NAME: UNIT, …;`: quantities that the model must have, with kind and unit.
    Needs(Vec<Need>),
    /// `generalises NAME, …;`: effects that say the same of a narrower family of models; where one of them can be applied,
    /// this effect is no candidate.
    Generalises(Vec<Name>),
    /// `source "…";`: literature reference, with the source span of the statement.
    Citation(String, Span),
    /// `increases "…";`: what the effect does where its first coefficient is above its null value.
    Increases(String, Span),
    /// `decreases "…";`: what the effect does where its first coefficient is below its null value.
    Decreases(String, Span),
    /// `site NAME;`: the component of the model that the effect changes.
    Site(Name),
    /// `variables NAME, NAME;`: variables that the effect depends on, with the statement's source span.
    Variables(Vec<Name>, Span),
    /// `negligible NAME value;`: smallest effect size of interest of a coefficient or state.
    Negligible(Name, Quantity),
    /// `replace …;`: replaces the model's statement of equal kind and name.
    Replace(Box<Item>),
    /// `replace inertia … in FRAME;`: replaces the inertia tensor; with the statement's source span.
    ReplaceInertia(Box<Inertia>, Span),
    /// A statement that is added to the model.
    Add(Box<Item>),
}
