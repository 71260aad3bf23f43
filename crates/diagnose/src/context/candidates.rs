//! Candidate effects: effects that the model may lack.

use model_spec::layout::{Layout, ParamId, StateId};
use model_spec::model::{AppliedEffect, Model};

/// An effect that the model may lack, with its coefficients and states in the encompassing model.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Candidate {
    /// Name of the effect with hyphens, as shown in reports.
    pub name: String,
    /// Description of the effect: the doc comment of the effect's declaration in the model language.
    pub doc: String,
    /// Two sentences that describe the effect: the first if its first coefficient is above its null value, the second
    /// if below. An effect that declares no such sentence has its general description here.
    pub senses: [String; 2],
    /// Site of the effect: the load or the equation of the model that it changes.
    pub site: String,
    /// Names of the variables on which the effect depends.
    pub variables: Vec<String>,
    /// Coefficients of the effect, each with one value common to all flights.
    pub coefficients: Vec<CandidateParameter<ParamId>>,
    /// States that the effect adds: constant in time, with one value for each flight.
    pub states: Vec<CandidateParameter<StateId>>,
}

/// A coefficient (`ParamId`) or a state (`StateId`) of a candidate effect.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CandidateParameter<Id> {
    /// Name of the coefficient or state.
    pub name: String,
    /// Index of the parameter or state in the encompassing model, which includes all candidate effects.
    pub id: Id,
    /// Unit of the coefficient or state, as text.
    pub unit: String,
    /// Null value, SI: the value at which the effect vanishes.
    pub null_value: f64,
    /// Smallest effect size of interest, SI: a smaller difference of the value from the null value is negligible.
    /// `None` if the effect declares none.
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
    /// Creates the candidate for the effect `effect`, which is switched on in `model`.
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

    /// Sentence that describes the effect if its first coefficient minus its null value is `departure`. The sentence
    /// depends only on the sign; if `departure` is 0, it is the general description of the effect.
    pub fn sentence(&self, departure: f64) -> &str {
        match departure {
            d if d > 0.0 => &self.senses[0],
            d if d < 0.0 => &self.senses[1],
            _ => &self.doc,
        }
    }

    /// Whether the effect is represented by a state with a separate initial value for each flight, rather than by one
    /// coefficient common to all flights.
    pub fn is_per_flight(&self) -> bool {
        !self.states.is_empty()
    }
}

#[cfg(test)]
mod tests {
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
