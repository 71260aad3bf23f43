//! Every effect that is known for a model, with what keeps it from being a candidate for what the model lacks.

use thiserror::Error;

use super::binding::{Binding, Unmet};
use super::{EffectTree, ModelTree, effects_of, rates};
use crate::library::{EFFECTS, GENERAL_EFFECTS};
use crate::model::Model;

/// Where an effect comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Origin {
    /// Declared in the model's file.
    Own,
    /// Built in, for a family of bodies.
    Specific,
    /// Built in, for models of any kind.
    General,
    /// Made for a stated equation of the model.
    Equation,
}

/// Why an effect is not a candidate for what a model lacks.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Refused {
    /// The model has not what the effect requires.
    #[error(transparent)]
    Unmet(Unmet),
    /// The effect is switched on.
    #[error("it is switched on")]
    Applied,
    /// Another effect says the same of this model.
    #[error("`{by}` says it of this model")]
    Covered {
        /// Name of that effect.
        by: String,
    },
}

/// An effect, and why it is not a candidate.
#[derive(Clone, Debug)]
pub struct KnownEffect {
    /// The effect.
    pub effect: EffectTree,
    /// Where it comes from.
    pub origin: Origin,
    /// Why it is not a candidate; `None` if it is one.
    pub refused: Option<Refused>,
}

/// All effects known for a checked model: those of its own file, built-in ones, general ones, and those made for its stated
/// equations; of several with one name the first. Told by names and units, without composing any of them.
pub fn known_effects(model: &Model) -> Vec<KnownEffect> {
    let tree = ModelTree::of(model);
    let binding = Binding::new(model);
    let mut known: Vec<KnownEffect> = Vec::new();
    let mut add = |effect: EffectTree, origin: Origin| {
        if known.iter().any(|k| k.effect.name() == effect.name()) {
            return;
        }
        let is_applied = model.effects.iter().any(|own| own.name == effect.name());
        let refused = match is_applied {
            true => Some(Refused::Applied),
            false => binding.unmet(&effect).map(Refused::Unmet),
        };
        known.push(KnownEffect {
            effect,
            origin,
            refused,
        });
    };
    for own in effects_of(tree.file()) {
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
