//! The candidates: every effect that could be missing from a model, switched on together in one model with each at the value
//! where it vanishes, so that one run shows what each of them would do.

use model_spec::load::{self, EFFECTS, LoadError};
use model_spec::model::{AppliedEffect, Model};

use crate::terms::{Channels, family};

/// An effect that may be the cause.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Its name, with hyphens as in reports.
    pub name: String,
    /// What it says.
    pub doc: String,
    /// Where it acts.
    pub site: String,
    /// What it depends on.
    pub variables: Vec<String>,
    /// Its coefficients, by index into the model's.
    pub coefficients: Vec<Part>,
    /// States that it adds: each flight has its own value of them.
    pub states: Vec<Part>,
}

/// A coefficient, or a state, of a candidate.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Its index among the coefficients, or the states, of the model with all candidates.
    pub index: usize,
    /// Its unit.
    pub unit: String,
    /// Where it vanishes, SI.
    pub null_value: f64,
    /// A departure smaller than this does not matter in practice, SI.
    pub negligible: Option<f64>,
    /// Least and greatest value, SI.
    pub bounds: Option<(f64, f64)>,
}

/// A model with all candidates.
#[derive(Clone, Debug)]
pub struct Catalogue {
    /// The model with every candidate switched on.
    pub model: Model,
    /// The candidates, in the order in which they were switched on.
    pub candidates: Vec<Candidate>,
    /// Loads that no law gives, on which terms outside the catalogue are tried; none where the model has no place for them.
    pub channels: Option<Channels>,
}

/// A name as reports have it.
pub fn hyphened(name: &str) -> String {
    name.replace('_', "-")
}

/// A name as model files have it.
pub fn underscored(name: &str) -> String {
    name.replace('-', "_")
}

impl Catalogue {
    /// Switches on what fits a model: of its own file's effects and of the built-in ones those that are not among `with`, the
    /// names or paths of those that are on, nor `without`, and can be applied together.
    ///
    /// # Errors
    /// Where the model itself cannot be loaded.
    pub fn new(model: &Model, with: &[String], without: &[String]) -> Result<Self, LoadError> {
        let source = &model.sources[0];
        let on: Vec<&str> = model.effects.iter().map(|e| e.name.as_str()).collect();
        let with: Vec<&str> = with.iter().map(String::as_str).collect();
        let left_out = |name: &str| without.iter().any(|w| underscored(w) == name);
        let local = model.offers.iter().map(|offer| offer.name.as_str());
        let built_in = EFFECTS.iter().map(|(name, _)| *name);
        let mut wanted: Vec<&str> = Vec::new();
        for name in local.chain(built_in) {
            if !on.contains(&name) && !wanted.contains(&name) && !left_out(name) {
                wanted.push(name);
            }
        }
        let load_with = |text: &str, more: &[&str]| {
            let with: Vec<&str> = with.iter().chain(more).copied().collect();
            load::from_text(&source.name, text, &with)
        };
        // What cannot be applied alone is made for another model.
        wanted.retain(|name| load_with(&source.text, &[name]).is_ok());
        let (channels, text) = match family(model, &with) {
            Some((channels, text)) => (Some(channels), text),
            None => (None, source.text.clone()),
        };
        let first: Vec<&str> = channels.iter().map(|channels| channels.effect).collect();
        let together = |names: &[&str]| {
            let names: Vec<&str> = first.iter().chain(names).copied().collect();
            load_with(&text, &names)
        };
        let all = match together(&wanted) {
            Ok(all) => all,
            // Two of them do not go together: one by one, those that still fit.
            Err(_) => {
                let mut fits = together(&[])?;
                let mut taken: Vec<&str> = Vec::new();
                for name in &wanted {
                    taken.push(name);
                    match together(&taken) {
                        Ok(model) => fits = model,
                        Err(_) => {
                            taken.pop();
                        }
                    }
                }
                fits
            }
        };
        let is_candidate = |e: &&AppliedEffect| {
            !on.contains(&e.name.as_str()) && !first.contains(&e.name.as_str())
        };
        let candidates = all.effects.iter().filter(is_candidate);
        let candidates = candidates.map(|e| candidate(&all, e)).collect();
        Ok(Self {
            model: all,
            candidates,
            channels,
        })
    }
}

fn candidate(model: &Model, effect: &AppliedEffect) -> Candidate {
    let coefficients = effect.coefficients.iter().map(|local| {
        let constant = &model.coefficients[local.index];
        Part {
            name: constant.name.clone(),
            index: local.index,
            unit: constant.unit_text.clone(),
            null_value: local.null_value,
            negligible: local.smallest_of_interest,
            bounds: constant.bounds,
        }
    });
    let states = effect.states.iter().map(|local| {
        let state = &model.states[local.index];
        Part {
            name: state.name.clone(),
            index: local.index,
            unit: state.unit_text.clone(),
            null_value: local.null_value,
            negligible: local.smallest_of_interest,
            bounds: None,
        }
    });
    Candidate {
        name: hyphened(&effect.name),
        doc: effect.doc.clone(),
        site: effect.site.clone(),
        variables: effect.variables.clone(),
        coefficients: coefficients.collect(),
        states: states.collect(),
    }
}
