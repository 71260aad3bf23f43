//! Declarations: parameters, inputs, states, frames and the marker are added to the model and to the symbol table.

use super::quantity::Measure;
use super::scope::Symbol;
use super::term::Term;
use super::{Checker, Definition};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model;
use crate::syntax::ast::{self, Item, ItemKind, Name, ParameterClass, UnitExpr};
use crate::syntax::{of_kind, stated_twice};
use crate::unit::Unit;

impl<'a> Checker<'a> {
    /// Declares every name of the file in the symbol table, before any expression is resolved.
    pub fn declare(&mut self) {
        let file = self.file;
        self.headings();
        self.declare_unitless();
        self.frame_names();
        for item in &file.items {
            match &item.kind {
                ItemKind::Parameter(constant) => self.constant(constant, item),
                ItemKind::Input(input) => self.input(input, item),
                ItemKind::Table(table) => self.table(table, item),
                ItemKind::Include(file) => self.not_read(file),
                ItemKind::Function(function) => self.define_function(&function.name),
                _ => {}
            }
        }
        self.declare_states();
        self.frame_kinds();
        let mut lets = 0;
        for item in &file.items {
            match &item.kind {
                ItemKind::Let(binding) => {
                    self.define(&binding.name, Symbol::Let(lets));
                    self.definitions.push(Definition::Missing);
                    lets += 1;
                }
                ItemKind::Marker(marker) => self.marker(marker),
                _ => {}
            }
        }
        self.find_state_sets();
        self.declare_unknowns();
    }

    /// Checks the statements `model NAME;` and `reference NAME;`: each may occur at most once, and `model` is required.
    fn headings(&mut self) {
        let file = self.file;
        let models = of_kind!(file.items.iter(), ItemKind::Model);
        let model = self.first_of("model", models);
        let references = of_kind!(file.items.iter(), ItemKind::Reference);
        let reference = self.first_of("reference", references);
        self.model.reference = reference.map(|n| n.text.clone());
        match model {
            Some(name) => self.model.name.clone_from(&name.text),
            None => {
                let start = Span {
                    end: file.end.start.min(1),
                    start: 0,
                    source: file.end.source,
                };
                let message = "the file does not say which model it is";
                let fault = Diagnostic::new(Kind::Missing, start, message);
                self.report(fault.help("begin with `model NAME;`"));
            }
        }
    }

    fn first_of(
        &mut self,
        word: &str,
        mut names: impl Iterator<Item = &'a Name>,
    ) -> Option<&'a Name> {
        let first = names.next()?;
        for other in names {
            self.second(word, first.span, other.span);
        }
        Some(first)
    }

    pub fn second(&mut self, what: &str, first: Span, again: Span) {
        self.report(stated_twice(what, first, again));
    }

    /// Declared unit with its factor, and as a term; `true` if it is a new unknown, for `[?]` or an invalid unit.
    pub fn declared_unit(&mut self, name: &Name, unit: Option<&UnitExpr>) -> (Measure, Term, bool) {
        let Some(unit) = unit else {
            let term = self.unitless.term(name.span);
            return (Measure::one(), term, false);
        };
        if unit.is_inferred() {
            return (Measure::one(), self.unknown_unit_of(&name.text), true);
        }
        match self.measure(unit) {
            Some(measure) => {
                let term = Term::known(measure.unit);
                (measure, term, false)
            }
            // The unknown symbol has been reported; an unknown as unit causes no further errors.
            None => (Measure::one(), self.unknown_unit_of(&name.text), true),
        }
    }

    pub fn unknown_unit_of(&mut self, name: &str) -> Term {
        self.first_uses.push(None);
        self.units.fresh(name)
    }

    fn constant(&mut self, constant: &ast::Parameter, item: &Item) {
        let (measure, term, inferred) =
            self.declared_unit(&constant.name, constant.value.unit.as_ref());
        let (value, _) = measure.of(&constant.value.number);
        let bounds = constant.bounds.as_ref().and_then(|(least, greatest)| {
            let least_value = self.bound(least, &measure, inferred)?;
            let greatest_value = self.bound(greatest, &measure, inferred)?;
            if least_value > greatest_value {
                let message = format!(
                    "the bounds of `{}` are the wrong way round",
                    constant.name.text
                );
                let fault = Diagnostic::new(Kind::Value, least.span.to(greatest.span), message);
                let reversed = format!("{greatest} .. {least}");
                let fault = fault.help(format!("write `in {reversed}`"));
                let span = fault.span;
                return self.refuse(fault.fix(span, reversed));
            }
            if value < least_value || value > greatest_value {
                let message = format!(
                    "the default of `{}`, {}, lies outside its bounds {least} .. {greatest}",
                    constant.name.text, constant.value
                );
                self.report(
                    Diagnostic::new(Kind::Value, constant.value.span, message)
                        .label(constant.value.span, "the default")
                        .label(least.span.to(greatest.span), "its bounds"),
                );
            }
            Some((least_value, greatest_value))
        });
        let made = model::Parameter {
            name: constant.name.text.clone(),
            doc: item.doc.clone(),
            unit: measure.unit,
            unit_text: measure.text,
            varies: constant.class == ParameterClass::Input,
            inferred,
            value,
            bounds,
            span: constant.name.span,
        };
        let (made_in, terms, symbol): (_, _, fn(usize) -> Symbol) = match constant.class {
            ParameterClass::Param | ParameterClass::Input => {
                (&mut self.model.params, &mut self.params, Symbol::Param)
            }
            ParameterClass::Coefficient => {
                let own = &mut self.model.coefficients;
                (own, &mut self.coefficients, Symbol::Coefficient)
            }
        };
        let symbol = symbol(made_in.len());
        made_in.push(made);
        terms.push(term);
        self.define(&constant.name, symbol);
    }

    /// SI value of a bound; without a unit it has that of the default value, with one it must fit.
    fn bound(&mut self, bound: &ast::Quantity, of: &Measure, inferred: bool) -> Option<f64> {
        let Some(unit) = &bound.unit else {
            return Some(of.of(&bound.number).0);
        };
        let own = self.measure(unit)?;
        if inferred || !own.unit.agrees(of.unit) {
            let should = if inferred {
                "no unit, as that of the default is inferred".to_owned()
            } else if of.unit == Unit::ONE {
                "no unit, as the default is a pure number".to_owned()
            } else {
                format!("the unit {}", of.text)
            };
            let message = format!(
                "this bound must have {should}, but it has {}",
                own.unit.explained()
            );
            return self.refuse(Diagnostic::new(Kind::Unit, bound.span, message));
        }
        Some(own.of(&bound.number).0)
    }

    fn input(&mut self, input: &ast::Input, item: &Item) {
        let frame = self.frame_of(&input.frame);
        let (measure, term, _) = self.declared_unit(&input.name, input.unit.as_ref());
        let index = self.model.inputs.len();
        self.model.inputs.push(model::Input {
            name: input.name.text.clone(),
            doc: item.doc.clone(),
            frame: frame.unwrap_or(0),
            unit: measure.unit,
            unit_text: measure.text.clone(),
            value: input.value.each_ref().map(|n| measure.of(n).0),
            span: input.name.span,
        });
        self.inputs.push(term);
        if self.define(&input.name, Symbol::Input(index)) {
            for (part, axis) in [(1, "x"), (2, "y"), (3, "z")] {
                let name = format!("{}_{axis}", input.name.text);
                self.define_as(&name, input.name.span, Symbol::InputPart(index, part));
            }
        }
    }

    /// Adds a state with a known unit and a default value, SI; returns its index.
    pub fn state(&mut self, name: &str, span: Span, unit: Unit, value: f64) -> usize {
        let state = model::State {
            name: name.to_owned(),
            unit,
            unit_text: unit.to_string(),
            value,
            span,
        };
        self.add_state(state, Term::known(unit))
    }

    fn add_state(&mut self, state: model::State, unit: Term) -> usize {
        let index = self.model.states.len();
        self.define_as(&state.name, state.span, Symbol::State(index));
        self.model.states.push(state);
        self.states.push(unit);
        index
    }

    fn declare_states(&mut self) {
        let file = self.file;
        let stated: Vec<&ast::State> = of_kind!(file.items.iter(), ItemKind::State).collect();
        if let Some(body) = self.declared_body {
            self.body_states(body);
            self.of_body = self.model.states.len();
        }
        for state in &stated {
            let (measure, term, _) = self.declared_unit(&state.name, state.value.unit.as_ref());
            let state = model::State {
                name: state.name.text.clone(),
                unit: measure.unit,
                value: measure.of(&state.value.number).0,
                unit_text: measure.text,
                span: state.name.span,
            };
            self.add_state(state, term);
        }
        if stated.is_empty() && self.declared_body.is_none() {
            let message = "the model has no body and no states";
            let fault = Diagnostic::new(Kind::Missing, self.heading(), message);
            self.report(fault.help(
                "declare a `body` or a `point`, or state equations outright with `state x = 0 m;` and `der(x) = …;`",
            ));
        }
    }

    /// Place of errors about missing statements: the model's name, else the end of the file.
    pub fn heading(&self) -> Span {
        self.file.model().map_or(self.file.end, |name| name.span)
    }

    fn marker(&mut self, marker: &ast::Marker) {
        if let Some(first) = &self.model.marker {
            let fault = stated_twice("marker", first.span, marker.name.span);
            self.report(fault.help(
                "keep one of them: it stands for all markers, whose places come with each recording",
            ));
            return;
        }
        let frame = self.frame_of(&marker.frame);
        if self.define(&marker.name, Symbol::Marker) {
            self.model.marker = frame.map(|frame| model::Marker {
                name: marker.name.text.clone(),
                frame,
                span: marker.name.span,
            });
        }
    }
}
