//! Semantic checks of applied effects.

use super::quantity::Measure;
use super::scope::Symbol;
use super::{Checker, Definition};
use crate::diagnostic::{Diagnostic, Kind};
use crate::model::{AppliedEffect, EffectUnknown, Shape};
use crate::syntax::ast::{Applied, Name, Need};
use crate::unit::Unit;

impl Checker<'_> {
    /// Adds the applied effects, with their coefficients and states, to the checked model.
    pub fn applied(&mut self) {
        let file = self.file;
        for (i, applied) in file.applied.iter().enumerate() {
            for need in &applied.needs {
                self.needed(&applied.name, need);
            }
            let (mut coefficients, mut states) = (Vec::new(), Vec::new());
            for item in file.items.iter().filter(|item| item.effect == Some(i)) {
                let Some(name) = item.kind.declared() else {
                    continue;
                };
                let (unknowns, index, null_value, unit) = match self.scope.find(&name.text) {
                    Some(Symbol::Coefficient(i)) => {
                        let own = &self.model.coefficients[i];
                        (&mut coefficients, i, own.value, own.unit)
                    }
                    Some(Symbol::State(i)) => {
                        let own = &self.model.states[i];
                        (&mut states, i, own.value, own.unit)
                    }
                    _ => continue,
                };
                unknowns.push(EffectUnknown {
                    index,
                    null_value,
                    smallest_effect_of_interest: self
                        .smallest_effect_of_interest(applied, name, unit),
                });
            }
            self.model.effects.push(AppliedEffect {
                name: applied.name.text.clone(),
                doc: applied.doc.clone(),
                site: applied.site.clone(),
                variables: applied.variables.clone(),
                citation: applied.citation.clone(),
                increases: applied.increases.clone(),
                decreases: applied.decreases.clone(),
                coefficients,
                states,
            });
        }
    }

    /// Reports a needed quantity whose kind or unit in the model is another.
    fn needed(&mut self, effect: &Name, need: &Need) {
        let (is_vector, unit) = match self.scope.find(&need.name.text) {
            Some(Symbol::Param(i)) => (false, self.model.params[i].unit),
            Some(Symbol::Coefficient(i)) => (false, self.model.coefficients[i].unit),
            Some(Symbol::Input(i)) => (true, self.model.inputs[i].unit),
            Some(Symbol::InputPart(i, _)) => (false, self.model.inputs[i].unit),
            Some(Symbol::State(i)) => (false, self.model.states[i].unit),
            Some(Symbol::Marker) => (true, Unit::METRE),
            Some(Symbol::Let(i)) => match self.definitions.get(i) {
                Some(Definition::Done(aux, shape, _)) => {
                    let unit = self.model.aux_variables[*aux].value.unit;
                    (*shape != Shape::Scalar, unit)
                }
                // The error of the definition has already been reported.
                _ => return,
            },
            None => return,
        };
        let Some(Measure { unit: wanted, .. }) = self.measure_or_one(need.unit.as_ref()) else {
            return;
        };
        let kind = |is_vector| if is_vector { "a vector" } else { "a number" };
        if is_vector == need.is_vector && unit.agrees(wanted) {
            return;
        }
        let message = format!(
            "the effect `{}` needs `{}` as {} in {wanted}, but in this model it is {} in {unit}",
            effect.text,
            need.name.text,
            kind(need.is_vector),
            kind(is_vector),
        );
        let mut fault = Diagnostic::new(Kind::Unit, need.name.span, message);
        if let Some(place) = self.scope.place(&need.name.text) {
            fault = fault.label(place, "declared here");
        }
        self.report(fault);
    }

    /// Smallest effect size of interest, SI, as stated by `negligible NAME …;`.
    fn smallest_effect_of_interest(
        &mut self,
        applied: &Applied,
        name: &Name,
        unit: Unit,
    ) -> Option<f64> {
        let mut stated = applied.negligible.iter();
        let (_, quantity) = stated.find(|(own, _)| own.text == name.text)?;
        let measure = self.measure_or_one(quantity.unit.as_ref())?;
        if !measure.unit.agrees(unit) {
            let message = format!(
                "`{}` is in {}, but this is in {}",
                name.text,
                unit.explained(),
                measure.unit.explained()
            );
            let fault = Diagnostic::new(Kind::Unit, quantity.span, message);
            self.report(fault.label(name.span, "declared here"));
        }
        Some(measure.of(&quantity.number).0)
    }
}
