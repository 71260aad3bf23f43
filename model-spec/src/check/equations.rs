//! Semantic checks of `let`, `force`, `moment`, `der(…) =`, `observe` and `clock` statements.

use std::collections::{HashMap, HashSet};

use super::order::Defining;
use super::scope::Symbol;
use super::term::Term;
use super::{Checker, Definition, UnitOf, Variable};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model;
use crate::syntax::ast::{self, ItemKind, LoadClass};
use crate::unit::Unit;

impl<'a> Checker<'a> {
    /// Checks the `let` definitions and the equations used as `der(STATE)`, in order of their uses.
    pub fn definitions(&mut self) {
        let file = self.file;
        let mut definitions: Vec<Defining<'a>> = Vec::new();
        for item in &file.items {
            if let ItemKind::Let(binding) = &item.kind {
                definitions.push(Defining {
                    name: &binding.name,
                    unit: binding.unit.as_ref(),
                    value: &binding.value,
                    doc: &item.doc,
                    effect: item.effect,
                    is_constant: binding.is_constant,
                    call: item.expanded.as_ref().and_then(|own| own.call),
                    state: None,
                    span: binding.name.span,
                });
            }
        }
        self.used_derivatives(&mut definitions);
        self.definitions
            .resize_with(definitions.len(), || Definition::Missing);
        for i in self.ordered(&definitions) {
            self.define_value(i, &definitions[i]);
        }
    }

    /// Appends to `definitions` each equation whose derivative an expression uses.
    fn used_derivatives(&mut self, definitions: &mut Vec<Defining<'a>>) {
        let file = self.file;
        let mut used: HashSet<usize> = HashSet::new();
        let roots = file.items.iter().flat_map(|item| item.kind.roots());
        for value in roots {
            self.all_uses(value, &mut |name, derivative, _| {
                if derivative && let Some(Symbol::State(i)) = self.scope.find(name) {
                    used.insert(i);
                }
            });
        }
        for item in &file.items {
            used.extend(self.implied_rates(&item.kind).iter());
        }
        for item in &file.items {
            if let ItemKind::Equation(equation) = &item.kind
                && let Some(Symbol::State(state)) = self.scope.find(&equation.state.text)
                && state >= self.of_body
                && used.contains(&state)
                && !self.derivatives.contains_key(&state)
            {
                self.derivatives.insert(state, definitions.len());
                definitions.push(Defining {
                    name: &equation.state,
                    unit: None,
                    value: &equation.value,
                    doc: "",
                    effect: item.effect,
                    is_constant: false,
                    call: None,
                    state: Some(state),
                    span: equation.state.span,
                });
            }
        }
    }

    /// Index into [`Checker::definitions`] of `der(STATE)`; `None` if no expression uses it.
    pub fn derivative_definition(&self, state: usize) -> Option<usize> {
        self.derivatives.get(&state).copied()
    }

    fn define_value(&mut self, index: usize, defining: &Defining<'a>) {
        let typed = match defining.state {
            Some(_) => self.scalar(defining.value, "the derivative of a state"),
            None => self.elaborate(defining.value),
        };
        let Some(mut typed) = typed else { return };
        let name = match defining.state {
            Some(state) => {
                self.is_derivative(&typed, state);
                format!("der_{}", defining.name.text)
            }
            None => defining.name.text.clone(),
        };
        if let Some(unit) = defining.unit {
            let Some(declared) = self.declared_as(typed, unit, defining.name) else {
                return;
            };
            typed = declared;
        }
        let varying = self.varying(&typed.expr);
        if let Some(culprit) = varying.filter(|_| defining.is_constant) {
            let message = format!(
                "the parameter `{}` must not change during a flight, but `{}` does",
                defining.name.text,
                self.text(culprit)
            );
            let fault = Diagnostic::new(Kind::Value, culprit, message);
            self.report(fault.help(format!(
                "make it of parameters and coefficients only, or name it with `let {} = …;`",
                defining.name.text
            )));
        }
        let varies = varying.is_some();
        let (shape, unit) = (typed.expr.shape, typed.unit);
        let variable = model::AuxVariable {
            name,
            doc: defining.doc.to_owned(),
            value: typed.expr,
            span: defining.span,
            effect: defining.effect,
            is_of_call: defining.call.is_some(),
        };
        let made = self.add_variable(variable, unit.clone(), varies);
        self.variables[made].call = defining.call;
        self.definitions[index] = Definition::Done(made, shape, unit);
    }

    /// Adds an auxiliary variable to the model; returns its index.
    pub fn add_variable(&mut self, own: model::AuxVariable, unit: UnitOf, varies: bool) -> usize {
        let call = None;
        self.variables.push(Variable { unit, varies, call });
        self.model.aux_variables.push(own);
        self.model.aux_variables.len() - 1
    }

    fn is_derivative(&mut self, typed: &super::Typed, state: usize) {
        let Some(unit) = self.unit_of_rate(state) else {
            return;
        };
        let model::State { name, span, .. } = self.model.states[state].clone();
        let rule = format!("`der({name})` is {}", self.described(&unit));
        if !self.must_be(typed, &unit, &rule) {
            self.suspect_declaration(typed.expr.span, span);
        }
    }

    pub fn equations(&mut self) {
        let file = self.file;
        let mut loads: HashMap<(bool, &str), Span> = HashMap::new();
        let mut equations: Vec<Option<(Span, Option<model::Equation>)>> =
            vec![None; self.model.states.len()];
        for item in &file.items {
            match &item.kind {
                // The equations of further bodies are stated.
                ItemKind::Load(load) if !self.file.is_of_first_body(load) => {}
                ItemKind::Load(load) => {
                    let key = (load.class == LoadClass::Force, load.name.text.as_str());
                    if let Some(&first) = loads.get(&key) {
                        let what = format!("{} {}", load.class.keyword(), load.name.text);
                        self.second(&what, first, load.name.span);
                        continue;
                    }
                    loads.insert(key, load.name.span);
                    self.load(load, item.effect);
                }
                ItemKind::Equation(equation) => self.equation(equation, &mut equations),
                ItemKind::Observe(observe) => self.observe(observe),
                ItemKind::Clock(value) => self.clock(value, item),
                _ => {}
            }
        }
        for (&state, &unknown) in &self.solved {
            let span = self.model.states[state].span;
            let value = self.unknown(unknown, span).expr;
            let made = model::Equation { state, value, span };
            equations[state].get_or_insert((span, Some(made)));
        }
        let states = self.model.states.iter().enumerate().skip(self.of_body);
        // A state whose name is taken has been reported.
        let is_own = |(index, state): &(usize, &model::State)| {
            self.scope.find(&state.name) == Some(Symbol::State(*index))
        };
        let missing = states.filter(|own| equations[own.0].is_none() && is_own(own));
        let missing: Vec<&model::State> = missing.map(|(_, state)| state).collect();
        if let Some(first) = missing.first() {
            let have = if missing.len() > 1 {
                "have no equations"
            } else {
                "has no equation"
            };
            let names: Vec<&str> = missing.iter().map(|state| state.name.as_str()).collect();
            let message = format!("{} {have}", crate::diagnostic::listed(&names));
            let fault = Diagnostic::new(Kind::Missing, first.span, message);
            let fault = fault.help(format!("state `der({}) = …;`", first.name));
            self.report(fault);
        }
        let equations = equations.into_iter().flatten();
        self.model.equations = equations.filter_map(|e| e.1).collect();
    }

    fn load(&mut self, load: &'a ast::Load, effect: Option<usize>) {
        let force = load.class == LoadClass::Force;
        let word = load.class.keyword();
        let Some(body) = self.declared_body else {
            let message = format!("this {word} acts on nothing: the model has no body");
            let fault = Diagnostic::new(Kind::Missing, load.name.span, message);
            let name = &load.name.text;
            let help = format!("declare a `body`, or name the vector with `let {name} = …;`");
            self.report(fault.help(help));
            return;
        };
        if !force && body.class == ast::BodyClass::Point {
            let message = "a moment cannot act on a point";
            let fault = Diagnostic::new(Kind::Shape, load.name.span, message)
                .label(body.name.span, "declared as a point");
            self.report(fault.help("declare it as `body`, with moments of inertia"));
            return;
        }
        let what = format!("the {word} `{}`", load.name.text);
        let Some((typed, _)) = self.vector(&load.value, &what) else {
            return;
        };
        let unit = if force {
            Unit::NEWTON
        } else {
            Unit::NEWTON_METRE
        };
        let rule = format!("{what} must be in {}", unit.explained());
        self.must_be(&typed, &Term::known(unit), &rule);
        let made = model::Load {
            name: load.name.text.clone(),
            value: typed.expr,
            span: load.name.span,
            effect,
        };
        if force {
            self.model.forces.push(made);
        } else {
            self.model.moments.push(made);
        }
    }

    fn equation(
        &mut self,
        equation: &'a ast::Equation,
        equations: &mut [Option<(Span, Option<model::Equation>)>],
    ) {
        let name = &equation.state;
        let found = self.scope.find(&name.text);
        if let (Some(body), Some(Symbol::State(state))) = (self.declared_body, found)
            && state < self.of_body
        {
            let message = format!(
                "the equation for `{}` follows from the body and its forces",
                name.text
            );
            let fault = Diagnostic::new(Kind::Duplicate, name.span, message)
                .label(body.name.span, "the body whose equations are derived");
            self.report(fault.help("remove this equation, or the body"));
            return;
        }
        let Some(Symbol::State(state)) = found else {
            self.no_state(name);
            let _ = self.elaborate(&equation.value);
            return;
        };
        if let Some((first, _)) = equations[state] {
            self.second(&format!("der({})", name.text), first, name.span);
            return;
        }
        let value = match self.derivative_definition(state) {
            // The right-hand side was already checked as an auxiliary variable; the equation refers to it.
            Some(definition) => match &self.definitions[definition] {
                Definition::Done(index, shape, _) => {
                    let kind = model::ExprKind::AuxVariable(*index);
                    Some(super::elaborate::node(kind, *shape, equation.value.span))
                }
                Definition::Missing => None,
            },
            None => {
                let typed = self.scalar(&equation.value, "the derivative of a state");
                typed.map(|typed| {
                    self.is_derivative(&typed, state);
                    typed.expr
                })
            }
        };
        let made = value.map(|value| model::Equation {
            state,
            value,
            span: name.span,
        });
        equations[state] = Some((name.span, made));
    }

    fn clock(&mut self, value: &'a ast::Expr, item: &ast::Item) {
        if let Some(first) = &self.model.clock {
            let first = first.span;
            self.second("clock", first, item.span);
            return;
        }
        let Some(typed) = self.scalar(value, "the clock") else {
            return;
        };
        let rule = "the clock, seconds of flight per second of the clock, must be a pure number";
        self.must_be(&typed, &Term::known(Unit::ONE), rule);
        self.model.clock = Some(model::Clock {
            value: typed.expr,
            span: item.span,
        });
    }

    fn observe(&mut self, observe: &'a ast::Observe) {
        if let Some(first) = &self.model.observation {
            let first = first.span;
            self.second("observe", first, observe.name.span);
            return;
        }
        let what = "what is observed";
        let Some((typed, frame)) = self.vector(&observe.value, what) else {
            return;
        };
        if frame != 0 {
            let name = |i: usize| self.model.frames.get(i).map_or("N", |f| &f.name);
            let message = format!(
                "{what} must be a vector in the inertial frame {}, but this one is in {}",
                name(0),
                name(frame)
            );
            let span = observe.value.span;
            let help = format!("write `in_{}({})`", name(0), self.text(span));
            let fault = Diagnostic::new(Kind::Frame, span, message).help(help);
            let fault = self.called(fault, &format!("in_{}", name(0)), span);
            self.report(fault);
            return;
        }
        let rule = "what is observed must be a length (m)";
        self.must_be(&typed, &Term::known(Unit::METRE), rule);
        self.model.observation = Some(model::Observation {
            name: observe.name.text.clone(),
            value: typed.expr,
            span: observe.name.span,
        });
    }
}
