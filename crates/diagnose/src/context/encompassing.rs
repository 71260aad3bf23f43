//! The encompassing model: every candidate effect switched on at its null value.

use std::sync::Arc;

use model_spec::LoadError;
use model_spec::compose::{EffectTree, ModelTree, known_effects};
use model_spec::index::IndexVec;
use model_spec::layout::Layout;
use model_spec::model::Model;
use model_spec::term_library::TermLibrary;

use super::candidates::{Candidate, identifier};
use super::ids::CandidateId;

/// A model extended by all candidate effects. Where a term library is compatible with the model, its loads (additional
/// force and moment components) are also part of it.
#[derive(Clone, Debug)]
pub(crate) struct EncompassingModel {
    /// The model with every candidate effect switched on.
    pub model: Model,
    /// The candidate effects, in the order in which they were switched on.
    pub candidates: IndexVec<CandidateId, Candidate>,
    /// The term library whose loads are part of the model; `None` if no library is compatible with the model.
    pub library: Option<Arc<TermLibrary>>,
}

impl EncompassingModel {
    /// Composes `model` with every compatible effect. Left out are effects that are already switched on, effects named
    /// in `without`, and general effects that duplicate an effect specific to the model.
    ///
    /// # Errors
    /// [`LoadError`] if the model with the loads of the term library, but without candidates, is invalid.
    pub fn new(model: &Model, without: &[String]) -> Result<Self, LoadError> {
        let effects = candidate_effects(model, without);
        let (library, base) = match TermLibrary::for_model(model) {
            Some((library, with_loads)) => (Some(library), with_loads),
            None => (None, ModelTree::of(model)),
        };
        let all = match compose_all(&base, &effects) {
            Ok(all) => all,
            // Two effects conflict.
            Err(_) => compose_compatible(&base, &effects)?,
        };
        let layout = Layout::new(&all);
        let on: Vec<&str> = model.effects.iter().map(|e| e.name.as_str()).collect();
        let candidates = all.effects.iter().filter(|effect| {
            let name = effect.name.as_str();
            !on.contains(&name)
                && library
                    .as_ref()
                    .is_none_or(|library| library.loads.name() != name)
        });
        let candidates = candidates.map(|effect| Candidate::new(&all, &layout, effect));
        Ok(Self {
            candidates: candidates.collect(),
            model: all,
            library,
        })
    }

    /// Names of the parameters that scale the additional loads of the term library; empty if no library is part of the
    /// model.
    pub fn load_coefficients(&self) -> impl Iterator<Item = &str> {
        let channels = self
            .library
            .iter()
            .flat_map(|library| library.channels.iter());
        channels.map(|channel| channel.coefficient.as_str())
    }
}

/// Effects that can be added to the model and are not named in `without`.
fn candidate_effects(model: &Model, without: &[String]) -> Vec<EffectTree> {
    let is_excluded = |name: &str| without.iter().any(|w| identifier(w) == name);
    known_effects(model)
        .into_iter()
        .filter(|known| known.refused.is_none() && !is_excluded(known.effect.name()))
        .map(|known| known.effect)
        .collect()
}

fn compose_all(base: &ModelTree, effects: &[EffectTree]) -> Result<Model, LoadError> {
    let mut tree = base.clone();
    for effect in effects {
        tree = tree.with(effect)?;
    }
    tree.check()
}

/// Adds the effects to the model one by one, and skips each effect that conflicts with the effects added before.
fn compose_compatible(base: &ModelTree, effects: &[EffectTree]) -> Result<Model, LoadError> {
    let mut tree = base.clone();
    let mut model = tree.check()?;
    for effect in effects {
        let with = tree.with(effect);
        let checked = with.and_then(|with| Ok((with.check()?, with)));
        if let Ok((next, with)) = checked {
            (model, tree) = (next, with);
        }
    }
    Ok(model)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_effect_that_fits_is_a_candidate_at_its_null_value() {
        let model = model_spec::load::load("disc", &["wind"]).unwrap();
        let without = ["added-mass".to_owned()];
        let all = EncompassingModel::new(&model, &without).unwrap();
        let names: Vec<&str> = all.candidates.iter().map(|c| c.name.as_str()).collect();
        assert!(names.contains(&"stall") && names.contains(&"wind-of-each-flight"));
        // Made for the ball; excluded; already on; the loads of the library.
        for name in ["magnus", "added-mass", "wind", "loads-of-no-law"] {
            assert!(!names.contains(&name), "{name}");
        }
        assert!(all.library.is_some());
        let layout = Layout::new(&all.model);
        for candidate in all.candidates.iter() {
            for coefficient in &candidate.coefficients {
                assert_eq!(layout.parameter(&coefficient.name), Some(coefficient.id));
            }
            for state in &candidate.states {
                assert_eq!(layout.state(&state.name), Some(state.id));
            }
        }
    }
}
