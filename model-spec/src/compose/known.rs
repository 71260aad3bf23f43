//! The effects known for a model, and why some are not candidates.

use thiserror::Error;

use super::{EffectTree, ModelTree};
use crate::check::check;
use crate::effect;
use crate::model::Model;

/// Where an effect is defined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Origin {
    /// The effect is declared in the file of the model itself.
    Own,
    /// A built-in effect that is written for a certain family of models, such as flying discs.
    Specific,
    /// A built-in effect that is written for models of any kind.
    General,
    /// Created from an equation `der(STATE) = …` of the model, to which it adds a term, or from a scalar input.
    Equation,
}

/// Reason why a diagnosis does not consider an effect, that is, a named change to the model.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Refused {
    /// The effect cannot be applied to the model, for this reason.
    #[error("{0}")]
    Unmet(String),
    /// The effect is already applied to the model.
    #[error("it is switched on")]
    Applied,
    /// A more specific effect is applicable to the model.
    #[error("`{by}` says it of this model")]
    Covered {
        /// Name of the more specific effect, which a diagnosis considers in place of the general one.
        by: String,
    },
}

/// An effect that can be found by name for a model, and whether a diagnosis considers the effect.
#[derive(Clone, Debug)]
pub struct KnownEffect {
    /// Syntax tree of the effect.
    pub effect: EffectTree,
    /// Where the effect is defined.
    pub origin: Origin,
    /// Why a diagnosis does not consider the effect; `None` if it does.
    pub refused: Option<Refused>,
}

/// Returns all effects that can be found by name for a checked model: effects of the model's file, specific and general
/// built-in effects, and effects created from the equations `der(STATE) = …` and the scalar inputs of the model. If
/// several effects have the same name, only the first is returned.
///
/// [`KnownEffect::refused`] is `None` for an effect that a diagnosis considers as possibly missing from the model.
pub fn known_effects(model: &Model) -> Vec<KnownEffect> {
    let tree = ModelTree::of(model);
    let mut known: Vec<KnownEffect> = Vec::new();
    let mut add = |effect: EffectTree, origin: Origin| {
        if known.iter().any(|k| k.effect.name() == effect.name()) {
            return;
        }
        let is_applied = model.effects.iter().any(|own| own.name == effect.name());
        let refused = if is_applied {
            Some(Refused::Applied)
        } else {
            unmet(&tree, &effect).map(Refused::Unmet)
        };
        known.push(KnownEffect {
            effect,
            origin,
            refused,
        });
    };
    for own in tree.file().effects() {
        add(EffectTree::of_model(own.clone()), Origin::Own);
    }
    for effect in EffectTree::built_in() {
        let origin = if effect.is_general() {
            Origin::General
        } else {
            Origin::Specific
        };
        add(effect.clone(), origin);
    }
    for effect in super::made_effects(tree.file()) {
        add(effect, Origin::Equation);
    }
    let bound: Vec<String> = known
        .iter()
        .filter(|k| matches!(k.refused, None | Some(Refused::Applied)))
        .map(|k| k.effect.name().to_owned())
        .collect();
    for own in known.iter_mut().filter(|k| k.refused.is_none()) {
        let is_bound = |name: &&str| bound.iter().any(|own| own == name);
        let by = own.effect.generalises().find(is_bound).map(str::to_owned);
        own.refused = by.map(|by| Refused::Covered { by });
    }
    known
}

/// Why an effect cannot be applied: a quantity that the model lacks, else the first error of the extended model.
fn unmet(tree: &ModelTree, effect: &EffectTree) -> Option<String> {
    let mut lacking = effect::lacking(tree.file(), effect.tree());
    if let Some(need) = lacking.find(|need| need.otherwise.is_none()) {
        let kind = if need.is_vector { "vector" } else { "number" };
        let unit = need.unit.as_ref().map(|unit| format!(" in {unit}"));
        let (name, unit) = (&need.name.text, unit.unwrap_or_default());
        return Some(format!("it needs a {kind} `{name}`{unit}"));
    }
    let mut extended = tree.clone();
    let faults = match extended.apply(effect) {
        Ok(()) => check(extended.file(), extended.sources()).diagnostics,
        Err(faults) => faults,
    };
    Some(faults.into_iter().next()?.message)
}
