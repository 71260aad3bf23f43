//! Applied effects: their coefficients and states, with null values and smallest effect sizes of interest.

use super::Checker;
use super::quantity::Measure;
use super::scope::Symbol;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{AppliedEffect, EffectUnknown};
use crate::syntax::ast::{Applied, ItemKind, Name, Quantity};
use crate::unit::Unit;

impl Checker<'_> {
    /// Adds the applied effects, with their coefficients and states, to the model.
    pub fn applied(&mut self) {
        let file = self.file;
        for (i, applied) in file.applied.iter().enumerate() {
            let (mut coefficients, mut states) = (Vec::new(), Vec::new());
            for item in file.items.iter().filter(|item| item.effect == Some(i)) {
                let name = match &item.kind {
                    ItemKind::Parameter(parameter) => &parameter.name,
                    ItemKind::State(state) => &state.name,
                    _ => continue,
                };
                match self.scope.find(&name.text) {
                    Some(Symbol::Coefficient(index)) => {
                        let own = &self.model.coefficients[index];
                        let (null_value, unit) = (own.value, own.unit);
                        coefficients.push(EffectUnknown {
                            index,
                            null_value,
                            smallest_of_interest: self.smallest_of_interest(applied, name, unit),
                        });
                    }
                    Some(Symbol::State(index)) => {
                        let own = &self.model.states[index];
                        let (null_value, unit) = (own.value, own.unit);
                        states.push(EffectUnknown {
                            index,
                            null_value,
                            smallest_of_interest: self.smallest_of_interest(applied, name, unit),
                        });
                    }
                    _ => {}
                }
            }
            self.model.effects.push(AppliedEffect {
                name: applied.name.text.clone(),
                doc: applied.doc.clone(),
                site: applied.site.clone(),
                variables: applied.variables.clone(),
                citation: applied.citation.clone(),
                coefficients,
                states,
            });
        }
    }

    /// Smallest effect size of interest (`negligible NAME …;`), SI, of a coefficient or state; `None` if not stated.
    fn smallest_of_interest(&mut self, applied: &Applied, name: &Name, unit: Unit) -> Option<f64> {
        let mut stated = applied.negligible.iter();
        let (_, quantity) = stated.find(|(own, _)| own.text == name.text)?;
        let measure = match &quantity.unit {
            Some(unit) => self.measure(unit)?,
            None => Measure::one(),
        };
        self.agrees_with(&measure, quantity, (&name.text, name.span, unit));
        Some(measure.of(&quantity.number).0)
    }

    fn agrees_with(
        &mut self,
        measure: &Measure,
        quantity: &Quantity,
        (name, place, unit): (&str, Span, Unit),
    ) {
        if !measure.unit.agrees(unit) {
            let message = format!(
                "`{name}` is in {}, but this is in {}",
                unit.explained(),
                measure.unit.explained()
            );
            let fault =
                Diagnostic::new(Kind::Unit, quantity.span, message).label(place, "declared here");
            self.report(fault);
        }
    }
}
