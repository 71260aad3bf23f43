//! Traversal of the syntax tree, and lookup of its statements.

use super::ast::{Body, Effect, Expr, ExprKind, File, Frame, ItemKind, Name};

impl File {
    /// Name in the statement `model NAME;`; `None` if the file contains no such statement.
    pub(crate) fn model(&self) -> Option<&Name> {
        self.items.iter().find_map(|item| match &item.kind {
            ItemKind::Model(name) => Some(name),
            _ => None,
        })
    }

    /// The first rigid body or point mass that the file declares; `None` if it declares none.
    pub(crate) fn body(&self) -> Option<&Body> {
        self.items.iter().find_map(|item| match &item.kind {
            ItemKind::Body(body) => Some(body),
            _ => None,
        })
    }

    /// The frames that the file declares, in order.
    pub fn frames(&self) -> impl Iterator<Item = &Frame> {
        self.items.iter().filter_map(|item| match &item.kind {
            ItemKind::Frame(frame) => Some(frame),
            _ => None,
        })
    }

    /// The effects that the file declares, in order.
    pub(crate) fn effects(&self) -> impl Iterator<Item = &Effect> {
        self.items.iter().filter_map(|item| match &item.kind {
            ItemKind::Effect(effect) => Some(effect),
            _ => None,
        })
    }
}

impl Expr {
    /// Calls `visit` on each direct subexpression, from left to right.
    pub fn children<'a>(&'a self, visit: &mut dyn FnMut(&'a Expr)) {
        match &self.kind {
            ExprKind::Name(_) | ExprKind::Number(_) | ExprKind::Derivative(_) => {}
            ExprKind::Part(of, _) | ExprKind::Neg(of) => visit(of),
            ExprKind::Components(parts, _) => parts.iter().for_each(visit),
            ExprKind::Binary(_, a, b) => {
                visit(a);
                visit(b);
            }
            ExprKind::Call(_, arguments) => arguments.iter().for_each(visit),
        }
    }

    /// Calls `visit` with a mutable reference to each direct subexpression, from left to right.
    pub fn children_mut(&mut self, visit: &mut dyn FnMut(&mut Expr)) {
        match &mut self.kind {
            ExprKind::Name(_) | ExprKind::Number(_) | ExprKind::Derivative(_) => {}
            ExprKind::Part(of, _) | ExprKind::Neg(of) => visit(of),
            ExprKind::Components(parts, _) => parts.iter_mut().for_each(visit),
            ExprKind::Binary(_, a, b) => {
                visit(a);
                visit(b);
            }
            ExprKind::Call(_, arguments) => arguments.iter_mut().for_each(visit),
        }
    }
}

impl ItemKind {
    /// Right-hand side of a `let`, load, equation, observation or clock statement; `None` for other kinds of statement.
    pub fn value(&self) -> Option<&Expr> {
        match self {
            ItemKind::Let(binding) => Some(&binding.value),
            ItemKind::Load(load) => Some(&load.value),
            ItemKind::Equation(equation) => Some(&equation.value),
            ItemKind::Observe(observe) => Some(&observe.value),
            ItemKind::Clock(value) => Some(value),
            _ => None,
        }
    }

    /// Mutable reference to the right-hand side of a `let`, load, equation, observation or clock statement; `None` for
    /// other kinds of statement.
    pub fn value_mut(&mut self) -> Option<&mut Expr> {
        match self {
            ItemKind::Let(binding) => Some(&mut binding.value),
            ItemKind::Load(load) => Some(&mut load.value),
            ItemKind::Equation(equation) => Some(&mut equation.value),
            ItemKind::Observe(observe) => Some(&mut observe.value),
            ItemKind::Clock(value) => Some(value),
            _ => None,
        }
    }
}
