//! Derivatives of expressions: `der(EXPR)` along the motion, and `partial(EXPR, STATE)`.

use std::collections::HashMap;

use super::scope::Symbol;
use super::term::Fraction;
use super::{Checker, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{Expr, ExprKind, FrameKind, Shape};
use crate::syntax::ast::{self, ItemKind};
use crate::unit::Unit;

/// Maximum number of derivatives within one another.
const MAX_ORDER: u8 = 3;

/// Maximum number of states of a model with derivatives of expressions, which bounds the sets of states.
const MAX_STATES: usize = 512;

/// Maximum number of passes over the statements, from the first to the last and back.
const MAX_PASSES: usize = 64;

/// A set of indices of states.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct States([u64; MAX_STATES / 64]);

impl States {
    fn insert(&mut self, state: usize) {
        if let Some(word) = self.0.get_mut(state / 64) {
            *word |= 1 << (state % 64);
        }
    }

    fn merge(&mut self, other: &States) {
        for (own, more) in self.0.iter_mut().zip(other.0) {
            *own |= more;
        }
    }

    /// Adds states; returns whether there were new ones.
    fn grow(&mut self, more: &States) -> bool {
        let before = *self;
        self.merge(more);
        *self != before
    }

    /// The states, in order.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..MAX_STATES).filter(move |state| self.0[state / 64] >> (state % 64) & 1 == 1)
    }
}

/// States on which quantities and derivatives depend, by their statements.
#[derive(Clone, Debug, Default)]
pub(super) struct StateSets {
    lets: HashMap<String, States>,
    rates: HashMap<usize, States>,
}

/// Whether an expression has `der(…)`.
fn has_rates(e: &ast::Expr) -> bool {
    e.nodes().any(|part| match &part.kind {
        ast::ExprKind::Call(name, _) => name.text == "der",
        kind => matches!(kind, ast::ExprKind::Derivative(_)),
    })
}

impl Checker<'_> {
    /// Finds on which states the quantities depend that `der(…)` needs.
    pub fn find_state_sets(&mut self) {
        let file = self.file;
        let is_block =
            |item: &ast::Item| matches!(item.kind, ItemKind::Solve(_) | ItemKind::Balance(_));
        let mut items = file.items.iter();
        if !items.any(|item| is_block(item) || item.kind.roots().into_iter().any(has_rates)) {
            return;
        }
        if self.model.states.len() > MAX_STATES {
            let message = format!(
                "a model with blocks `solve` or derivatives of expressions has at most {MAX_STATES} states"
            );
            self.report(Diagnostic::new(Kind::Limit, self.heading(), message));
            return;
        }
        let mut sets = StateSets::default();
        let (forwards, backwards): (Vec<_>, Vec<_>) = (
            file.items.iter().collect(),
            file.items.iter().rev().collect(),
        );
        for pass in 0..MAX_PASSES {
            let mut has_changed = false;
            for item in if pass % 2 == 0 { &forwards } else { &backwards } {
                match &item.kind {
                    ItemKind::Let(own) => {
                        let found = self.states_in(&own.value, &sets);
                        let set = sets.lets.entry(own.name.text.clone()).or_default();
                        has_changed |= set.grow(&found);
                    }
                    ItemKind::Equation(own) => {
                        let found = self.states_in(&own.value, &sets);
                        if let Some(Symbol::State(state)) = self.scope.find(&own.state.text) {
                            has_changed |= sets.rates.entry(state).or_default().grow(&found);
                        }
                    }
                    _ => {}
                }
            }
            if !has_changed {
                self.state_sets = sets;
                return;
            }
        }
        let message = "the quantities that are differentiated use one another in too long chains";
        let fault = Diagnostic::new(Kind::Limit, self.heading(), message);
        self.report(fault.help("define quantities before they are used"));
    }

    /// States on which an expression depends; `sets` has those of the quantities.
    fn states_in(&self, e: &ast::Expr, sets: &StateSets) -> States {
        let mut found = States::default();
        match &e.kind {
            ast::ExprKind::Name(name) => self.states_of_name(name, sets, &mut found),
            ast::ExprKind::Derivative(name) => match self.scope.find(&name.text) {
                Some(Symbol::State(state)) => {
                    found.merge(&sets.rates.get(&state).copied().unwrap_or_default());
                }
                _ => {
                    self.states_of_name(&name.text, sets, &mut found);
                    with_rates(&mut found, sets);
                }
            },
            ast::ExprKind::Components(_, frame) => self.states_of_frame(&frame.text, &mut found),
            ast::ExprKind::Call(name, _) => {
                if let Some(frame) = name.text.strip_prefix("in_") {
                    self.states_of_frame(frame, &mut found);
                }
            }
            _ => {}
        }
        for child in e.children() {
            found.merge(&self.states_in(child, sets));
        }
        if matches!(&e.kind, ast::ExprKind::Call(name, _) if name.text == "der") {
            with_rates(&mut found, sets);
        }
        found
    }

    fn states_of_name(&self, name: &str, sets: &StateSets, found: &mut States) {
        match self.scope.find(name) {
            Some(Symbol::State(state)) => {
                found.insert(state);
            }
            Some(_) => found.merge(&sets.lets.get(name).copied().unwrap_or_default()),
            None => self.states_of_frame(name, found),
        }
    }

    fn states_of_frame(&self, name: &str, found: &mut States) {
        if let Some(frame) = self.scope.frame(name) {
            for state in self.states_of_attitude(frame) {
                found.insert(state);
            }
        }
    }

    /// States that orient a frame against the inertial one.
    pub fn states_of_attitude(&self, frame: usize) -> Vec<usize> {
        let chain = self.chain(frame).into_iter();
        chain
            .flat_map(|frame| match self.model.frames[frame].kind {
                FrameKind::Inertial | FrameKind::Fixed { .. } => Vec::new(),
                FrameKind::Turned { angle, .. } => vec![angle],
                FrameKind::Quaternion { states, .. } => states.to_vec(),
            })
            .collect()
    }

    /// Calls `visit` with each name in an expression, whether it is the state of a derivative, and its span; `der(…)` of
    /// an expression uses the derivatives of all states on which it depends.
    pub fn all_uses<'e>(&self, e: &'e ast::Expr, visit: &mut dyn FnMut(&str, bool, Span))
    where
        Self: 'e,
    {
        let states = match &e.kind {
            ast::ExprKind::Name(name) => return visit(name, false, e.span),
            ast::ExprKind::Derivative(name) => {
                if let Some(Symbol::State(_)) | None = self.scope.find(&name.text) {
                    return visit(&name.text, true, e.span);
                }
                visit(&name.text, false, e.span);
                let mut found = States::default();
                self.states_of_name(&name.text, &self.state_sets, &mut found);
                found
            }
            ast::ExprKind::Call(name, arguments) if name.text == "der" => {
                let mut found = States::default();
                for own in arguments {
                    found.merge(&self.states_in(own, &self.state_sets));
                }
                found
            }
            _ => States::default(),
        };
        for state in states.iter() {
            visit(&self.model.states[state].name, true, e.span);
        }
        for child in e.children() {
            self.all_uses(child, visit);
        }
    }

    /// States whose derivatives a statement needs without naming them: of a constraint those on which it depends, and
    /// those on which their derivatives do.
    pub fn implied_rates(&self, kind: &ItemKind) -> States {
        let sets = &self.state_sets;
        match kind {
            ItemKind::Balance(own) => self.states_in(&own.quantity, sets),
            ItemKind::Solve(block) => {
                let constraints = { block.equations.iter() }.filter(|own| own.within.is_some());
                let mut found = States::default();
                for side in constraints.flat_map(|own| [&own.left, &own.right]) {
                    found.merge(&self.states_in(side, sets));
                }
                with_rates(&mut found, sets);
                found
            }
            _ => States::default(),
        }
    }

    /// Elaborates `der(EXPR)`: the derivative of a number or vector by the time of the flight, along the motion.
    pub fn rate(&mut self, of: &ast::Expr, span: Span) -> Option<Typed> {
        let typed = self.elaborate(of)?;
        self.rate_of(typed, span)
    }

    pub fn rate_of(&mut self, of: Typed, span: Span) -> Option<Typed> {
        self.rate_along(of, span, false)
    }

    /// As [`rate_of`](Self::rate_of); `with_body`, what is differentiated may depend on the motion of the body.
    pub fn rate_along(&mut self, of: Typed, span: Span, with_body: bool) -> Option<Typed> {
        let found = self.differentiable(&of.expr, span)?;
        let mut rates = Vec::new();
        let states: Vec<usize> = found.iter().collect();
        for &state in &states {
            if state < self.of_body && with_body {
                rates.push(self.body_rate(state, span));
                continue;
            }
            if state < self.of_body {
                let message = format!(
                    "`{}` changes with `{}`, whose derivative follows from the forces",
                    self.text(of.expr.span),
                    self.model.states[state].name
                );
                let fault = Diagnostic::new(Kind::Cycle, span, message);
                return self.refuse(fault.help("`der(…)` needs states whose equations are stated"));
            }
            rates.push(self.derivative_of(state, span)?.expr);
        }
        let second = UnitOf::of(Unit::SECOND);
        let unit = self.multiplied(&of.unit, &second, Fraction::MINUS_ONE, span);
        let shape = of.expr.shape;
        let kind = ExprKind::Rate(Box::new(of.expr), states, rates.into());
        Some(Typed::new(kind, shape, span, unit))
    }

    /// Elaborates `partial(EXPR, STATE)`: the derivative of a number by a state, all others held.
    pub fn partial(&mut self, [of, by]: [&ast::Expr; 2], span: Span) -> Option<Typed> {
        let typed = self.scalar(of, "what is differentiated")?;
        let state = match &by.kind {
            ast::ExprKind::Name(name) => self.scope.find(name),
            _ => None,
        };
        let Some(Symbol::State(state)) = state else {
            let message = format!("`{}` is not a state", self.text(by.span));
            let fault = Diagnostic::new(Kind::Name, by.span, message);
            return self.refuse(fault.note("`partial(EXPR, STATE)` differentiates by a state"));
        };
        self.differentiable(&typed.expr, span)?;
        let by = UnitOf::Term(self.states[state].clone());
        let unit = self.multiplied(&typed.unit, &by, Fraction::MINUS_ONE, span);
        let kind = ExprKind::Partial(Box::new(typed.expr), state);
        Some(Typed::scalar(kind, span, unit))
    }

    /// States on which an expression depends; `None`, with an error reported, if it cannot be differentiated.
    fn differentiable(&mut self, e: &Expr, span: Span) -> Option<States> {
        for index in self.dependences.len()..self.model.aux_variables.len() {
            let own = Dependence::of(self, &self.model.aux_variables[index].value);
            self.dependences.push(own);
        }
        let found = Dependence::of(self, e);
        if let Some(what) = found.obstacle {
            let message = format!("`{}` depends on {what}", self.text(e.span));
            let fault = Diagnostic::new(Kind::Value, span, message);
            return self.refuse(fault.note(
                "what is differentiated is made of states, parameters, coefficients and the time",
            ));
        }
        if found.order >= MAX_ORDER {
            let message = format!("at most {MAX_ORDER} derivatives may stand within one another");
            return self.refuse(Diagnostic::new(Kind::Limit, span, message));
        }
        Some(found.states)
    }

    /// The derivative of a state whose equation is stated.
    fn derivative_of(&mut self, state: usize, span: Span) -> Option<Typed> {
        let name = ast::Name::new(self.model.states[state].name.clone(), span);
        self.derivative(&name, span)
    }
}

fn with_rates(found: &mut States, sets: &StateSets) {
    for state in found.iter() {
        found.merge(&sets.rates.get(&state).copied().unwrap_or_default());
    }
}

/// What an expression depends on.
#[derive(Clone, Debug, Default)]
pub(super) struct Dependence {
    states: States,
    /// What has no derivative, as in messages.
    obstacle: Option<String>,
    /// Number of derivatives within one another.
    order: u8,
}

impl Dependence {
    fn of(checker: &Checker<'_>, e: &Expr) -> Dependence {
        let mut found = Dependence::default();
        found.order = found.visit(checker, e);
        found
    }

    /// Visits an expression; returns the number of derivatives within one another.
    fn visit(&mut self, checker: &Checker<'_>, e: &Expr) -> u8 {
        let model = &checker.model;
        if let Shape::Vector(frame) = e.shape {
            for state in checker.states_of_attitude(frame) {
                self.states.insert(state);
            }
        }
        match &e.kind {
            ExprKind::State(state) => {
                self.states.insert(*state);
            }
            ExprKind::Param(i) if model.params[*i].varies => {
                self.obstacle = Some(format!("the input `{}`", model.params[*i].name));
            }
            ExprKind::Unknown(system, k) => {
                let name = &model.systems[*system].unknowns[*k].name;
                self.obstacle = Some(format!("the unknown `{name}`"));
            }
            ExprKind::Position | ExprKind::Velocity | ExprKind::AngularVelocity => {
                for state in checker.states_of_motion(&e.kind) {
                    self.states.insert(state);
                }
            }
            ExprKind::BodyRate(state, loads) if loads.is_empty() => {
                for state in checker.states_of_body_rate(*state) {
                    self.states.insert(state);
                }
            }
            ExprKind::SpecificForce | ExprKind::AngularAcceleration | ExprKind::BodyRate(..) => {
                self.obstacle = Some("the forces on the body".to_owned());
            }
            ExprKind::AuxVariable(i) => {
                let Some(own) = checker.dependences.get(*i) else {
                    return 0;
                };
                self.states.merge(&own.states);
                self.obstacle = self.obstacle.take().or_else(|| own.obstacle.clone());
                return own.order;
            }
            _ => {}
        }
        let children = e.children().into_iter();
        let order = children.map(|child| self.visit(checker, child)).max();
        order.unwrap_or(0) + u8::from(matches!(e.kind, ExprKind::Rate(..) | ExprKind::Partial(..)))
    }
}
