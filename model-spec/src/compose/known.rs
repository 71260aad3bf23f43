//! The effects known for a model, and why some are not candidates.

use thiserror::Error;

use super::binding::{Binding, Unmet};
use super::{EffectTree, ModelTree, rates};
use crate::library::{EFFECTS, GENERAL_EFFECTS};
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
    /// Created from an equation `der(STATE) = …` of the model, to which it adds a term.
    Equation,
}

/// Reason why a diagnosis does not consider an effect, that is, a named change to the model.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Refused {
    /// The model does not meet a requirement of the effect.
    #[error(transparent)]
    Unmet(Unmet),
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
/// built-in effects, and effects created from the equations `der(STATE) = …` of the model. If several effects have the
/// same name, only the first is returned.
///
/// [`KnownEffect::refused`] is `None` for an effect that a diagnosis considers as possibly missing from the model. This
/// is determined from names and units, without applying the effect.
pub fn known_effects(model: &Model) -> Vec<KnownEffect> {
    let tree = ModelTree::of(model);
    let binding = Binding::new(model);
    let mut known: Vec<KnownEffect> = Vec::new();
    let mut add = |effect: EffectTree, origin: Origin| {
        if known.iter().any(|k| k.effect.name() == effect.name()) {
            return;
        }
        let is_applied = model.effects.iter().any(|own| own.name == effect.name());
        let refused = if is_applied {
            Some(Refused::Applied)
        } else {
            binding.unmet(&effect).map(Refused::Unmet)
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
    for (table, origin) in [
        (EFFECTS, Origin::Specific),
        (GENERAL_EFFECTS, Origin::General),
    ] {
        for effect in table
            .iter()
            .filter_map(|(name, _)| EffectTree::built_in(name))
        {
            add(effect.clone(), origin);
        }
    }
    for effect in rates::rate_effects(tree.file()) {
        add(effect, Origin::Equation);
    }
    let bound: Vec<String> = known
        .iter()
        .filter(|k| matches!(k.refused, None | Some(Refused::Applied)))
        .map(|k| k.effect.name().to_owned())
        .collect();
    for own in known.iter_mut().filter(|k| k.refused.is_none()) {
        let mut generalised = own.effect.generalises().map(str::to_owned);
        let by = generalised.find(|name| bound.contains(name));
        drop(generalised);
        own.refused = by.map(|by| Refused::Covered { by });
    }
    known
}
