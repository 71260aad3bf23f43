//! Effects that were applied, with what they brought.

use super::Checker;
use super::quantity::Measure;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{AppliedEffect, EffectUnknown};
use crate::syntax::ast::{Applied, ItemKind, Quantity};
use crate::unit::Unit;

impl Checker<'_> {
    /// Effects that were applied, with their coefficients and states.
    pub fn applied(&mut self) {
        let file = self.file;
        for (i, applied) in file.applied.iter().enumerate() {
            let mut made = AppliedEffect {
                name: applied.name.text.clone(),
                doc: applied.doc.clone(),
                site: applied.site.clone(),
                variables: applied.variables.clone(),
                citation: applied.citation.clone(),
                coefficients: Vec::new(),
                states: Vec::new(),
            };
            for item in file.items.iter().filter(|item| item.effect == Some(i)) {
                match &item.kind {
                    ItemKind::Parameter(constant) => {
                        let place = constant.name.span;
                        let all = &self.model.coefficients;
                        let Some(index) = all.iter().position(|c| c.name == constant.name.text)
                        else {
                            continue;
                        };
                        let (null_value, unit) = (all[index].value, all[index].unit);
                        let name = &constant.name.text;
                        made.coefficients.push(EffectUnknown {
                            index,
                            null_value,
                            smallest_of_interest: self.negligible(applied, name, place, unit),
                        });
                    }
                    ItemKind::State(state) => {
                        let place = state.name.span;
                        let all = &self.model.states;
                        let Some(index) = all.iter().position(|s| s.name == state.name.text) else {
                            continue;
                        };
                        let (null_value, unit) = (all[index].value, all[index].unit);
                        let name = &state.name.text;
                        made.states.push(EffectUnknown {
                            index,
                            null_value,
                            smallest_of_interest: self.negligible(applied, name, place, unit),
                        });
                    }
                    _ => {}
                }
            }
            self.model.effects.push(made);
        }
    }

    /// The size below which a departure of a name does not matter, where the effect states one.
    fn negligible(
        &mut self,
        applied: &Applied,
        name: &str,
        place: Span,
        unit: Unit,
    ) -> Option<f64> {
        let (_, quantity) = applied.negligible.iter().find(|n| n.0.text == name)?;
        let measure = match &quantity.unit {
            Some(unit) => self.measure(unit)?,
            None => Measure::one(),
        };
        self.agrees_with(&measure, quantity, (name, place, unit));
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
