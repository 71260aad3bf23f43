//! Semantic checks of tables: declarations and calls.

use super::quantity::Measure;
use super::term::Term;
use super::{Checker, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{self, ExprKind, Function};
use crate::syntax::ast::{self, Item, Quantity};

/// Minimum number of knots of a table; two knots would define only a straight line.
const MIN_KNOTS: usize = 3;
const MAX_KNOTS: usize = 500;
const MAX_TABLES: usize = 100;
/// Minimum width between adjacent knots, as a fraction of the whole range.
const MIN_WIDTH: f64 = 1e-9;
/// Numbers above 10^60 and widths of at most 10^-60, SI, are errors.
const MAX_EXPONENT: f64 = 60.0;

impl Checker<'_> {
    pub fn table(&mut self, table: &ast::Table, item: &Item) {
        let units = [&table.argument_unit, &table.unit];
        let units = units.map(|unit| self.measure_or_one(unit.as_ref()));
        let index = self.model.tables.len();
        if index == MAX_TABLES {
            let message = format!("a model has at most {MAX_TABLES} tables");
            self.report(Diagnostic::new(Kind::Limit, table.name.span, message));
        }
        self.define_table(&table.name, index);
        let [Some(of_argument), Some(of_value)] = units else {
            // Calls of a table without knots cause no further reports.
            self.model.tables.push(self.made(table, item, Vec::new()));
            return;
        };
        let mut knots = Vec::with_capacity(table.knots.len());
        for (argument, value) in &table.knots {
            let x = self.of_table(argument, &of_argument);
            let y = self.of_table(value, &of_value);
            knots.extend(x.zip(y));
        }
        if knots.len() == table.knots.len() {
            self.knots(table, &knots);
        }
        let made = self.made(table, item, knots);
        self.model.tables.push(model::Table {
            argument_unit: of_argument.unit,
            unit: of_value.unit,
            unit_texts: [of_argument.text, of_value.text],
            ..made
        });
    }

    fn made(&self, table: &ast::Table, item: &Item, knots: Vec<(f64, f64)>) -> model::Table {
        model::Table {
            name: table.name.text.clone(),
            doc: item.doc.clone(),
            argument: table.argument.text.clone(),
            argument_unit: Default::default(),
            unit: Default::default(),
            unit_texts: Default::default(),
            knots,
            interpolation: table.interpolation,
            continuation: table.continuation,
            span: table.name.span,
            effect: item.effect,
        }
    }

    /// SI value of a number of the table; without a unit it has that of its column.
    fn of_table(&mut self, number: &Quantity, column: &Measure) -> Option<f64> {
        let Some(unit) = &number.unit else {
            return Some(column.of(&number.number).0);
        };
        let own = self.measure(unit)?;
        if !own.unit.agrees(column.unit) {
            let message = format!(
                "this number of the table must have the unit {}, but it has {}",
                column.unit.explained(),
                own.unit.explained()
            );
            return self.refuse(Diagnostic::new(Kind::Unit, number.span, message));
        }
        Some(own.of(&number.number).0)
    }

    /// Checks number, order and size of the knots, SI; reports the first violation.
    fn knots(&mut self, table: &ast::Table, knots: &[(f64, f64)]) {
        let name = &table.name.text;
        if !(MIN_KNOTS..=MAX_KNOTS).contains(&knots.len()) {
            let message = format!(
                "the table `{name}` has {} knots, but must have from {MIN_KNOTS} to {MAX_KNOTS}",
                knots.len()
            );
            self.report(Diagnostic::new(Kind::Value, table.name.span, message));
            return;
        }
        let greatest = 10f64.powf(MAX_EXPONENT);
        for ((x, y), (argument, value)) in knots.iter().zip(&table.knots) {
            for (number, quantity) in [(x, argument), (y, value)] {
                if number.abs() > greatest {
                    let message = format!("the number {quantity} is too large for a table");
                    self.report(Diagnostic::new(Kind::Value, quantity.span, message));
                    return;
                }
            }
        }
        let range = knots[knots.len() - 1].0 - knots[0].0;
        for (i, pair) in knots.windows(2).enumerate() {
            let width = pair[1].0 - pair[0].0;
            if width > 0.0 && width >= MIN_WIDTH * range && width > greatest.recip() {
                continue;
            }
            let [before, here] = [&table.knots[i].0, &table.knots[i + 1].0];
            let message = if width > 0.0 {
                format!(
                    "the knots {before} and {here} of the table `{name}` are too close together"
                )
            } else {
                format!(
                    "the arguments of the table `{name}` must increase, but {here} follows {before}"
                )
            };
            let fault = Diagnostic::new(Kind::Value, here.span, message);
            self.report(fault.label(before.span, "the knot before"));
            return;
        }
    }

    /// Elaborates the call of a table, by its index in the model, and checks the unit of the argument.
    pub fn call_of_table(&mut self, index: usize, argument: Typed, span: Span) -> Typed {
        let table = &self.model.tables[index];
        let (unit, expected) = (table.unit, Term::known(table.argument_unit));
        let what = format!("the argument of `{}`", table.name);
        let is_sound = !table.knots.is_empty();
        let should = self.described(&expected);
        if is_sound {
            self.must_be(&argument, &expected, &format!("{what} must be {should}"));
        }
        let kind = ExprKind::Call(Function::Table(index), Box::new(argument.expr));
        let unit = if is_sound {
            UnitOf::of(unit)
        } else {
            UnitOf::Faulty
        };
        Typed::scalar(kind, span, unit)
    }
}
