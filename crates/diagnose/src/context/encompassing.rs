//! The encompassing model: every candidate effect switched on at its null value.

use std::sync::Arc;

use dataset::{Dataset, Sensor, SensorKind};
use model_spec::LoadError;
use model_spec::compose::{EffectTree, ModelTree, known_effects};
use model_spec::index::IndexVec;
use model_spec::layout::{Layout, ParamId, StateId, acts_in};
use model_spec::model::{AppliedEffect, Model};
use model_spec::term_library::TermLibrary;

use super::columns::CandidateId;

/// A model extended by all candidate effects, and the loads of a term library where one is compatible.
#[derive(Clone, Debug)]
pub(crate) struct EncompassingModel {
    pub model: Model,
    /// The candidate effects, in the order in which they were switched on.
    pub candidates: IndexVec<CandidateId, Candidate>,
    /// The term library whose loads are part of the model; `None` if no library is compatible with the model.
    pub library: Option<Arc<TermLibrary>>,
    /// Names of the effects that conflict with others before them, and are no candidates.
    pub conflicting: Vec<String>,
}

impl EncompassingModel {
    /// Composes `model` with every compatible effect that is not on, in `without`, or a duplicate of a specific one. An
    /// error if the model with the loads of the library is invalid.
    pub fn new(model: &Model, without: &[String]) -> Result<Self, LoadError> {
        let effects = candidate_effects(model, without);
        let (library, base) = match TermLibrary::for_model(model) {
            Some((library, with_loads)) => (Some(library), with_loads),
            None => (None, ModelTree::of(model)),
        };
        let (all, conflicting) = match compose_all(&base, &effects) {
            Ok(all) => (all, Vec::new()),
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
            conflicting,
        })
    }

    /// Names of the parameters that scale the loads of the term library.
    pub fn load_coefficients(&self) -> impl Iterator<Item = &str> {
        let channels = self
            .library
            .iter()
            .flat_map(|library| library.channels.iter());
        channels.map(|channel| channel.coefficient.as_str())
    }
}

fn candidate_effects(model: &Model, without: &[String]) -> Vec<EffectTree> {
    let is_excluded = |name: &str| without.iter().any(|w| identifier(w) == name);
    known_effects(model)
        .into_iter()
        .filter(|known| known.refused.is_none() && !is_excluded(known.effect.name()))
        .map(|known| known.effect)
        .collect()
}

/// Effects with a value in each flight that stand for an input nobody measured, although a flight states it or the model
/// depends on it, so that its unknown values are estimated.
pub(crate) fn of_stated_inputs(model: &Model, dataset: &Dataset) -> Vec<String> {
    let is_stated = |name: &str| {
        let mut flights = dataset.flights.iter();
        let unknown = model.unknown_states();
        flights.any(|flight| flight.known.contains_key(name) && is_input(model, name)) || {
            unknown.iter()
        }
        .any(|(own, state)| own == name && acts_in(model, *state))
    };
    let effects = EffectTree::built_in().iter();
    let stand_in = effects.filter(|effect| {
        effect.has_states() && effect.needs().any(|need| is_stated(&need.name.text))
    });
    stand_in.map(|effect| effect.name().to_owned()).collect()
}

/// Effects on the attitudes of poses, of which the dataset has none.
pub(crate) fn of_missing_poses(dataset: &Dataset) -> Vec<String> {
    let is_pose = |sensor: &Sensor| sensor.kind == SensorKind::Pose;
    let has_poses = dataset.sensors.iter().any(is_pose);
    let effects = EffectTree::built_in().iter().filter(|_| !has_poses);
    let on_poses = effects.filter(|effect| effect.is_about_poses());
    on_poses.map(|effect| effect.name().to_owned()).collect()
}

fn is_input(model: &Model, name: &str) -> bool {
    model.inputs.iter().any(|input| input.name == name)
}

fn compose_all(base: &ModelTree, effects: &[EffectTree]) -> Result<Model, LoadError> {
    let mut tree = base.clone();
    for effect in effects {
        tree = tree.with(effect)?;
    }
    tree.check()
}

/// Adds the effects to the model one by one, and skips each effect that conflicts with the effects added before; their names.
fn compose_compatible(
    base: &ModelTree,
    effects: &[EffectTree],
) -> Result<(Model, Vec<String>), LoadError> {
    let (mut tree, mut conflicting) = (base.clone(), Vec::new());
    let mut model = tree.check()?;
    for effect in effects {
        let with = tree.with(effect);
        match with.and_then(|with| Ok((with.check()?, with))) {
            Ok((next, with)) => (model, tree) = (next, with),
            Err(_) => conflicting.push(display_name(effect.name())),
        }
    }
    Ok((model, conflicting))
}

// Candidate effects: effects that the model may lack.

/// An effect that the model may lack, with its coefficients and states in the encompassing model.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Candidate {
    pub name: String,
    /// Description of the effect: the doc comment of the effect's declaration in the model language.
    pub doc: String,
    /// Sentences on the effect if its first coefficient is above, or below, its null value.
    pub senses: [String; 2],
    /// Site of the effect: the load or the equation of the model that it changes.
    pub site: String,
    pub variables: Vec<String>,
    /// Coefficients of the effect, each with one value common to all flights.
    pub coefficients: Vec<CandidateParameter<ParamId>>,
    /// States that the effect adds: constant in time, with one value for each flight.
    pub states: Vec<CandidateParameter<StateId>>,
}

/// A coefficient (`ParamId`) or a state (`StateId`) of a candidate effect.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CandidateParameter<Id> {
    pub name: String,
    /// Index of the parameter or state in the encompassing model, which includes all candidate effects.
    pub id: Id,
    pub unit: String,
    pub null_value: f64,
    /// Smallest effect size of interest, SI; `None` if the effect declares none.
    pub smallest_effect_of_interest: Option<f64>,
    /// Minimum and maximum value, SI; `None` if unbounded.
    pub bounds: Option<(f64, f64)>,
}

/// Converts the identifier of an effect in model files to its name in reports, with hyphens for underscores.
pub(crate) fn display_name(identifier: &str) -> String {
    identifier.replace('_', "-")
}

/// Converts the name of an effect in reports to its identifier in model files, with underscores for hyphens.
pub fn identifier(display_name: &str) -> String {
    display_name.replace('-', "_")
}

impl Candidate {
    pub fn new(model: &Model, layout: &Layout, effect: &AppliedEffect) -> Self {
        let coefficients = effect.coefficients.iter().map(|own| {
            let constant = &model.coefficients[own.index];
            CandidateParameter {
                name: constant.name.clone(),
                id: layout.coefficient(own.index),
                unit: constant.unit_text.clone(),
                null_value: own.null_value,
                smallest_effect_of_interest: own.smallest_effect_of_interest,
                bounds: constant.bounds,
            }
        });
        let states = effect.states.iter().map(|own| {
            let state = &model.states[own.index];
            CandidateParameter {
                name: state.name.clone(),
                id: StateId::new(own.index),
                unit: state.unit_text.clone(),
                null_value: own.null_value,
                smallest_effect_of_interest: own.smallest_effect_of_interest,
                bounds: None,
            }
        });
        Self {
            name: display_name(&effect.name),
            doc: effect.doc.clone(),
            senses: [1.0, -1.0].map(|departure| effect.sentence(departure).to_owned()),
            site: effect.site.clone(),
            variables: effect.variables.clone(),
            coefficients: coefficients.collect(),
            states: states.collect(),
        }
    }

    /// Sentence on the effect if its first coefficient departs from its null value by `departure`.
    pub fn sentence(&self, departure: f64) -> &str {
        match departure {
            d if d > 0.0 => &self.senses[0],
            d if d < 0.0 => &self.senses[1],
            _ => &self.doc,
        }
    }

    /// Whether a state with its own value for each flight represents the effect.
    pub fn is_per_flight(&self) -> bool {
        !self.states.is_empty()
    }
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

    #[test]
    fn no_effect_of_the_catalogue_conflicts_with_others() {
        for name in ["disc", "disc_quaternion", "ball"] {
            let model = model_spec::load::load(name, &[]).unwrap();
            let all = EncompassingModel::new(&model, &[]).unwrap();
            assert_eq!(all.conflicting, Vec::<String>::new(), "{name}");
        }
    }

    #[test]
    fn the_sentence_of_an_effect_follows_its_sign() {
        for (name, above, below) in [
            ("stall", "stops growing", "steepens"),
            ("clock_rate", "runs fast", "runs slow"),
        ] {
            let model = model_spec::load::load("disc", &[name]).unwrap();
            let effect = &model.effects[0];
            assert!(effect.sentence(1.0).contains(above), "{name}");
            assert!(effect.sentence(-1.0).contains(below), "{name}");
            assert_eq!(effect.sentence(0.0), effect.doc);
        }
    }
}
