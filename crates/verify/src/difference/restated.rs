//! Differences of units, stated values and bounds of corresponding constants, inputs and states.

use super::pairing::Pairing;
use super::values::Everything;
use model_spec::model::{Model, Parameter};
use serde::Serialize;
use std::fmt::Display;

/// A unit, default value or bound of a constant, an input or a state that differs between two models.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Restated {
    /// Name of the constant, input or state in the new model.
    pub name: String,
    /// Attribute that changed: `unit`, `value` or `bounds`.
    pub what: &'static str,
    /// Unit, default value or bounds (as given by `what`) in the old model, as text.
    pub old: String,
    /// Unit, default value or bounds (as given by `what`) in the new model, as text.
    pub new: String,
}

/// Lists the units, default values and bounds that differ between paired constants, inputs and states of the old model
/// `a` and the new model `b`.
pub fn restated(a: &Everything<'_>, b: &Everything<'_>, pairing: &Pairing) -> Vec<Restated> {
    let mut out = Vec::new();
    let mut note = |name: &str, what, old: &dyn Display, new: &dyn Display| {
        let (old, new) = (old.to_string(), new.to_string());
        if old != new {
            let name = name.to_owned();
            out.push(Restated {
                name,
                what,
                old,
                new,
            });
        }
    };
    for (state, old) in b.model.states.iter().zip(&pairing.states) {
        let Some(old) = old.map(|old| &a.model.states[old]) else {
            continue;
        };
        note(&state.name, "unit", &old.unit, &state.unit);
        note(&state.name, "value", &old.value, &state.value);
    }
    let constants = |model: &Model| -> Vec<Parameter> {
        let all = model.params.iter().chain(&model.coefficients);
        all.cloned().collect()
    };
    let (olds, news) = (constants(a.model), constants(b.model));
    let bounds = |c: &Parameter| {
        c.bounds.map_or_else(
            || String::from("none"),
            |(low, high)| format!("{low} .. {high}"),
        )
    };
    for (constant, old) in news.iter().zip(&pairing.parameters) {
        let Some(old) = old.and_then(|old| olds.get(old)) else {
            continue;
        };
        let name = &constant.name;
        note(name, "unit", &old.unit, &constant.unit);
        note(name, "value", &old.value, &constant.value);
        note(name, "bounds", &bounds(old), &bounds(constant));
    }
    let (first, count) = (news.len(), olds.len());
    for (k, value) in b.code.layout.defaults.iter().enumerate().skip(first) {
        let old = pairing.parameters[k].filter(|&old| old >= count);
        if let Some(old) = old.map(|old| a.code.layout.defaults[old]) {
            note(&b.code.layout.parameters[k], "value", &old, &value);
        }
    }
    out
}
