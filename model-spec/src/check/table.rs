//! Semantic checks of tables: declarations and calls.

use super::call::Call;
use super::quantity::Measure;
use super::term::Term;
use super::{Checker, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind};
use crate::model::{self, ExprKind, Function, Interpolation, TableArgument};
use crate::syntax::ast::{self, Item, Quantity};
use crate::unit::Unit;

/// Minimum number of knots of an argument.
const MIN_KNOTS: usize = 2;
const MAX_KNOTS: usize = 10_000;
/// Maximum number of values of a table of two arguments.
const MAX_VALUES: usize = 2_500;
const MAX_TABLES: usize = 100;
/// Minimum width between adjacent knots, as a fraction of the whole range.
const MIN_WIDTH: f64 = 1e-9;
/// Numbers above 10^60 and widths of at most 10^-60, SI, are errors.
const MAX_EXPONENT: f64 = 60.0;

impl Checker<'_> {
    pub fn table(&mut self, table: &ast::Table, item: &Item) {
        let index = self.model.tables.len();
        if index == MAX_TABLES {
            let message = format!("a model has at most {MAX_TABLES} tables");
            self.report(Diagnostic::new(Kind::Limit, table.name.span, message));
        }
        self.define_table(&table.name, index);
        if let Some(file) = &table.file {
            self.not_read(file);
        }
        let of_value = self.measure_or_one(table.unit.as_ref());
        let arguments = table.arguments.iter();
        let measures: Vec<_> = arguments
            .map(|(_, unit)| self.measure_or_one(unit.as_ref()))
            .collect();
        let mut made = model::Table {
            name: table.name.text.clone(),
            doc: item.doc.clone(),
            // Calls of a table without values cause no further reports.
            arguments: vec![TableArgument::default(); table.arguments.len()],
            unit: Default::default(),
            unit_text: String::new(),
            values: Vec::new(),
            interpolation: table.interpolation,
            continuation: table.continuation,
        };
        // A fault of the values does not hide one of the arguments.
        let arguments = match table.file {
            Some(_) => None,
            None => self.arguments_of(table, &measures),
        };
        if let Some(of_value) = of_value
            && let Some(values) = self.values(table, &of_value)
            && let Some(arguments) = arguments
        {
            made.arguments = arguments;
            made.values = values;
            (made.unit, made.unit_text) = (of_value.unit, of_value.text);
        }
        self.model.tables.push(made);
    }

    /// Reports a file that is named in a tree that was not read from a file.
    pub fn not_read(&mut self, file: &ast::Name) {
        let message = format!("`{}` has not been read", file.text);
        let fault = Diagnostic::new(Kind::Missing, file.span, message);
        self.report(fault.help("load the model by its path"));
    }

    /// Values of a table, SI; reports rows of another length than that of the knots.
    fn values(&mut self, table: &ast::Table, unit: &Measure) -> Option<Vec<f64>> {
        let name = &table.name.text;
        let is_monotone = table.interpolation == Interpolation::Monotone;
        if let [_, (second, _)] = &table.arguments[..] {
            if is_monotone {
                let message = "a table of two arguments cannot be `monotone`";
                let fault = Diagnostic::new(Kind::Value, table.name.span, message);
                return self.refuse(fault.help("leave the word out, or write `linear`"));
            }
            for (argument, values) in &table.rows {
                if values.len() != table.columns.len() {
                    let message = format!(
                        "the row at {argument} of the table `{name}` has {} values, but `{}` has {} knots",
                        values.len(),
                        second.text,
                        table.columns.len()
                    );
                    return self.refuse(Diagnostic::new(Kind::Value, argument.span, message));
                }
            }
            let count = table.rows.len() * table.columns.len();
            if count > MAX_VALUES {
                let message = format!(
                    "the table `{name}` has {count} values, but one of two arguments has at most {MAX_VALUES}"
                );
                return self.refuse(Diagnostic::new(Kind::Value, table.name.span, message));
            }
        }
        let values = table.rows.iter().flat_map(|(_, values)| values);
        let values: Vec<_> = values.map(|value| self.of_table(value, unit)).collect();
        values.into_iter().collect()
    }

    fn arguments_of(
        &mut self,
        table: &ast::Table,
        measures: &[Option<Measure>],
    ) -> Option<Vec<TableArgument>> {
        let first: Vec<&Quantity> = table.rows.iter().map(|(argument, _)| argument).collect();
        let knots = [first, table.columns.iter().collect()];
        let mut arguments = Vec::new();
        for (((name, _), measure), written) in table.arguments.iter().zip(measures).zip(knots) {
            let measure = measure.as_ref()?;
            let of_argument = match table.arguments.len() {
                1 => String::new(),
                _ => format!(" of `{}`", name.text),
            };
            let knots = self.knots(&table.name, &of_argument, measure, &written)?;
            arguments.push(TableArgument {
                name: name.text.clone(),
                unit: measure.unit,
                unit_text: measure.text.clone(),
                knots,
            });
        }
        Some(arguments)
    }

    /// SI value of a number of the table; without a unit it has that of its column.
    fn of_table(&mut self, number: &Quantity, column: &Measure) -> Option<f64> {
        let mut own = None;
        if let Some(unit) = &number.unit {
            let measure = self.measure(unit)?;
            if !measure.unit.agrees(column.unit) {
                let message = format!(
                    "this number of the table must have the unit {}, but it has {}",
                    column.unit.explained(),
                    measure.unit.explained()
                );
                // A model with faults of units alone is still compiled, with this number as it stands.
                self.report(Diagnostic::new(Kind::Unit, number.span, message));
            }
            own = Some(measure);
        }
        let value = own.as_ref().unwrap_or(column).of(&number.number).0;
        if value.abs() > 10f64.powf(MAX_EXPONENT) {
            let message = format!("the number {number} is too large for a table");
            return self.refuse(Diagnostic::new(Kind::Value, number.span, message));
        }
        Some(value)
    }

    /// Knots of an argument, SI; reports the first violation of number, order and distance.
    fn knots(
        &mut self,
        table: &ast::Name,
        of_argument: &str,
        unit: &Measure,
        written: &[&Quantity],
    ) -> Option<Vec<f64>> {
        let name = &table.text;
        if !(MIN_KNOTS..=MAX_KNOTS).contains(&written.len()) {
            let message = format!(
                "the table `{name}` has {} knot{}{of_argument}, but must have from {MIN_KNOTS} to {MAX_KNOTS}",
                written.len(),
                if written.len() == 1 { "" } else { "s" }
            );
            return self.refuse(Diagnostic::new(Kind::Value, table.span, message));
        }
        let knots = written.iter().map(|knot| self.of_table(knot, unit));
        let knots: Vec<f64> = knots
            .collect::<Vec<_>>()
            .into_iter()
            .collect::<Option<_>>()?;
        let range = knots[knots.len() - 1] - knots[0];
        for (i, pair) in knots.windows(2).enumerate() {
            let width = pair[1] - pair[0];
            if width > 0.0 && width >= MIN_WIDTH * range && width > 10f64.powf(-MAX_EXPONENT) {
                continue;
            }
            let [before, here] = [written[i], written[i + 1]];
            let message = if width > 0.0 {
                format!(
                    "the knots {before} and {here}{of_argument} of the table `{name}` are too close together"
                )
            } else if of_argument.is_empty() {
                format!(
                    "the arguments of the table `{name}` must increase, but {here} follows {before}"
                )
            } else {
                format!(
                    "the knots{of_argument} of the table `{name}` must increase, but {here} follows {before}"
                )
            };
            let fault = Diagnostic::new(Kind::Value, here.span, message);
            return self.refuse(fault.label(before.span, "the knot before"));
        }
        Some(knots)
    }

    /// Elaborates the call of a table, by its index in the model, and checks the units of the arguments.
    pub fn call_of_table(&mut self, index: usize, call: Call<'_>) -> Option<Typed> {
        let name = &call.name.text;
        let made = match self.model.tables[index].arguments.len() {
            1 => {
                let [a] = self.arguments(call, "one number")?;
                let a = self.argument_of_table(index, 0, a, &format!("the argument of `{name}`"));
                ExprKind::Call(Function::Table(index), Box::new(a?.expr))
            }
            _ => {
                let [a, b] = self.arguments(call, "two numbers")?;
                let mut argument = |at: usize, e| {
                    let own = self.model.tables[index].arguments[at].name.clone();
                    let what = format!("the argument `{own}` of `{name}`");
                    self.argument_of_table(index, at, e, &what)
                };
                let (a, b) = (argument(0, a), argument(1, b));
                ExprKind::Lookup(index, Box::new(a?.expr), Box::new(b?.expr))
            }
        };
        let table = &self.model.tables[index];
        let unit = match table.values.is_empty() {
            true => UnitOf::Faulty,
            false => UnitOf::of(table.unit),
        };
        Some(Typed::scalar(made, call.span, unit))
    }

    fn argument_of_table(
        &mut self,
        index: usize,
        at: usize,
        e: &ast::Expr,
        what: &str,
    ) -> Option<Typed> {
        let argument = self.scalar(e, what)?;
        let table = &self.model.tables[index];
        if !table.values.is_empty() {
            let expected = Term::known(table.arguments[at].unit);
            let should = self.described(&expected);
            let is_angle = table.arguments[at].unit == Unit::RADIAN;
            self.must_be(&argument, &expected, &format!("{what} must be {should}"));
            match is_angle {
                true => self.must_be_radians(&argument, what),
                false => self.must_not_be_radians(&argument, (index, at), what),
            }
        }
        Some(argument)
    }
}
