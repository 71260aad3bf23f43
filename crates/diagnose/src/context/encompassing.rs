//! The encompassing model: every candidate effect switched on at its null value.

use model_spec::layout::Layout;
use model_spec::load::{self, EFFECTS, LoadError};
use model_spec::model::Model;

use super::candidates::{Candidate, identifier};
use super::ids::CandidateId;
use super::term_library::{LIBRARIES, TermLibrary};
use model_spec::index::IndexVec;

/// A model with all candidate effects, and with the loads of a term library where it can have them.
#[derive(Clone, Debug)]
pub(crate) struct EncompassingModel {
    /// The model with every candidate switched on.
    pub model: Model,
    /// The candidates, in the order in which they were switched on.
    pub candidates: IndexVec<CandidateId, Candidate>,
    /// The term library whose loads the model has.
    pub library: Option<TermLibrary>,
}

/// A model's text with the effects that stand beside it.
struct Composer<'a> {
    name: &'a str,
    text: String,
    with: Vec<&'a str>,
}

impl Composer<'_> {
    fn compose(&self, more: &[&str]) -> Result<Model, LoadError> {
        let with: Vec<&str> = self.with.iter().chain(more).copied().collect();
        load::from_text(self.name, &self.text, &with)
    }

    /// The names that can be switched on together, tried one by one, and the model with them.
    fn compatible<'n>(&self, names: &[&'n str]) -> Result<(Vec<&'n str>, Model), LoadError> {
        let mut model = self.compose(&[])?;
        let mut taken: Vec<&str> = Vec::new();
        for name in names {
            taken.push(name);
            match self.compose(&taken) {
                Ok(next) => model = next,
                Err(_) => {
                    taken.pop();
                }
            }
        }
        Ok((taken, model))
    }
}

impl EncompassingModel {
    /// Switches on the effects of the model's own file and the built-in ones that can be applied, except those in
    /// `with` (names or paths of effects that are on) and in `without`.
    ///
    /// # Errors
    /// [`LoadError`] if the model itself cannot be loaded.
    pub fn new(model: &Model, with: &[String], without: &[String]) -> Result<Self, LoadError> {
        let source = &model.sources[0];
        let with: Vec<&str> = with.iter().map(String::as_str).collect();
        let plain = Composer {
            name: &source.name,
            text: source.text.clone(),
            with: with.clone(),
        };
        let mut names = candidate_names(model, without);
        // An effect that cannot be applied alone is made for another model.
        names.retain(|name| plain.compose(&[name]).is_ok());
        let (library, composer) = match library_of(&plain) {
            Some((library, composer)) => (Some(library), composer),
            None => (None, plain),
        };
        let all = match composer.compose(&names) {
            Ok(all) => all,
            // Two of them conflict.
            Err(_) => composer.compatible(&names)?.1,
        };
        let layout = Layout::new(&all);
        let on: Vec<&str> = model.effects.iter().map(|e| e.name.as_str()).collect();
        let candidates = all.effects.iter().filter(|effect| {
            let name = effect.name.as_str();
            !on.contains(&name) && library.is_none_or(|library| library.effect != name)
        });
        let candidates = candidates.map(|effect| Candidate::new(&all, &layout, effect));
        Ok(Self {
            candidates: candidates.collect(),
            model: all,
            library,
        })
    }
}

/// Names of the effects that a model offers and of the built-in ones, without those that are on or excluded.
fn candidate_names<'m>(model: &'m Model, without: &[String]) -> Vec<&'m str> {
    let on: Vec<&str> = model.effects.iter().map(|e| e.name.as_str()).collect();
    let is_excluded = |name: &str| without.iter().any(|w| identifier(w) == name);
    let own = model.offers.iter().map(|offer| offer.name.as_str());
    let built_in = EFFECTS.iter().map(|(name, _)| *name);
    let mut names: Vec<&str> = Vec::new();
    for name in own.chain(built_in) {
        if !on.contains(&name) && !names.contains(&name) && !is_excluded(name) {
            names.push(name);
        }
    }
    names
}

/// The first library whose loads a model can be given, and the composer that adds them.
fn library_of<'a>(plain: &Composer<'a>) -> Option<(TermLibrary, Composer<'a>)> {
    LIBRARIES.into_iter().find_map(|library| {
        let composer = Composer {
            name: plain.name,
            text: format!("{}\n{}\n", plain.text, library.text),
            with: plain.with.iter().copied().chain([library.effect]).collect(),
        };
        composer.compose(&[]).ok()?;
        Some((library, composer))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_effect_that_fits_is_a_candidate_at_its_null_value() {
        let model = load::load("disc", &["wind"]).unwrap();
        let on = ["wind".to_owned()];
        let without = ["added-mass".to_owned()];
        let all = EncompassingModel::new(&model, &on, &without).unwrap();
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
