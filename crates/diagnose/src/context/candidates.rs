//! Candidate effects: what could be missing from a model.

use model_spec::layout::{Layout, ParamId, StateId};
use model_spec::model::{AppliedEffect, Model};

/// An effect that the model may lack.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Candidate {
    /// Name with hyphens, as in reports.
    pub name: String,
    /// Its description.
    pub doc: String,
    /// Where it acts.
    pub site: String,
    /// What it depends on.
    pub variables: Vec<String>,
    /// Its coefficients, one value for all flights.
    pub coefficients: Vec<CandidateParameter<ParamId>>,
    /// States that it adds, constant in time, one value for each flight.
    pub states: Vec<CandidateParameter<StateId>>,
}

/// A coefficient (`ParamId`) or a state (`StateId`) of a candidate.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CandidateParameter<Id> {
    /// Its name.
    pub name: String,
    /// Its index in the encompassing model.
    pub id: Id,
    /// Its unit.
    pub unit: String,
    /// Null value: the effect vanishes there, SI.
    pub null_value: f64,
    /// Smallest effect size of interest: departures from the null value below it are negligible, SI.
    pub smallest_of_interest: Option<f64>,
    /// Least and greatest value, SI.
    pub bounds: Option<(f64, f64)>,
}

/// The name of an effect as reports print it.
pub(crate) fn display_name(identifier: &str) -> String {
    identifier.replace('_', "-")
}

/// The name of an effect in model files, from the name in a report.
pub fn identifier(display_name: &str) -> String {
    display_name.replace('-', "_")
}

impl Candidate {
    /// The candidate of an effect that a model has switched on.
    pub fn new(model: &Model, layout: &Layout, effect: &AppliedEffect) -> Self {
        let coefficients = effect.coefficients.iter().map(|own| {
            let constant = &model.coefficients[own.index];
            CandidateParameter {
                name: constant.name.clone(),
                id: layout.coefficient(own.index),
                unit: constant.unit_text.clone(),
                null_value: own.null_value,
                smallest_of_interest: own.smallest_of_interest,
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
                smallest_of_interest: own.smallest_of_interest,
                bounds: None,
            }
        });
        Self {
            name: display_name(&effect.name),
            doc: effect.doc.clone(),
            site: effect.site.clone(),
            variables: effect.variables.clone(),
            coefficients: coefficients.collect(),
            states: states.collect(),
        }
    }

    /// Whether it has a value for each flight, and not one for all.
    pub fn is_per_flight(&self) -> bool {
        !self.states.is_empty()
    }
}
