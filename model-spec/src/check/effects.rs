//! Semantic checks of applied effects.

use super::Checker;
use super::quantity::Measure;
use super::scope::Symbol;
use crate::diagnostic::{Diagnostic, Kind};
use crate::model::{AppliedEffect, EffectUnknown, Shape};
use crate::syntax::ast::{Effect, EffectPart, Name, Need};
use crate::unit::Unit;

impl Checker<'_> {
    pub fn applied(&mut self) {
        let file = self.file;
        for (i, effect) in file.applied.iter().enumerate() {
            for need in effect.needs() {
                self.needed(&effect.name, need);
            }
            let mut applied = described(effect);
            for item in file.items.iter().filter(|item| item.effect == Some(i)) {
                let Some(name) = item.kind.declared() else {
                    continue;
                };
                let (unknowns, index, null_value, unit) = match self.scope.find(&name.text) {
                    Some(Symbol::Coefficient(i)) => {
                        let own = &self.model.coefficients[i];
                        (&mut applied.coefficients, i, own.value, own.unit)
                    }
                    Some(Symbol::State(i)) => {
                        let own = &self.model.states[i];
                        (&mut applied.states, i, own.value, own.unit)
                    }
                    _ => continue,
                };
                unknowns.push(EffectUnknown {
                    index,
                    null_value,
                    smallest_effect_of_interest: self
                        .smallest_effect_of_interest(effect, name, unit),
                });
            }
            self.model.effects.push(applied);
        }
    }

    /// Reports a needed quantity whose kind or unit in the model is another.
    fn needed(&mut self, effect: &Name, need: &Need) {
        let symbol = self.scope.find(&need.name.text);
        let own = symbol.and_then(|symbol| {
            let term = self.unit_of_symbol(symbol)?.factor()?;
            Some((self.shape_of_symbol(symbol)?, self.units.resolve(&term)))
        });
        // The error of a definition has already been reported.
        let Some((shape, term)) = own else { return };
        let Some(Measure { unit: wanted, .. }) = self.measure_or_one(need.unit.as_ref()) else {
            return;
        };
        let unit = term.unit().unwrap_or_default();
        let is_vector = shape != Shape::Scalar;
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

    /// SI value in the statement `negligible NAME …;` of an effect.
    fn smallest_effect_of_interest(
        &mut self,
        effect: &Effect,
        name: &Name,
        unit: Unit,
    ) -> Option<f64> {
        let quantity = effect.parts.iter().find_map(|part| match part {
            EffectPart::Negligible(own, quantity) if own.text == name.text => Some(quantity),
            _ => None,
        })?;
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

/// What an effect states about itself, without its coefficients and states.
fn described(effect: &Effect) -> AppliedEffect {
    let mut applied = AppliedEffect {
        name: effect.name.text.clone(),
        doc: effect.doc.clone(),
        ..AppliedEffect::default()
    };
    for part in &effect.parts {
        match part {
            EffectPart::Citation(text, _) => applied.citation.clone_from(text),
            EffectPart::Increases(text, _) => applied.increases.clone_from(text),
            EffectPart::Decreases(text, _) => applied.decreases.clone_from(text),
            EffectPart::Site(name) => applied.site.clone_from(&name.text),
            EffectPart::Variables(names, _) => {
                applied.variables = names.iter().map(|n| n.text.clone()).collect();
            }
            _ => {}
        }
    }
    applied
}
