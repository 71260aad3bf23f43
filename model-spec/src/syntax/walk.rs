//! Traversal of the syntax tree.

use super::ast::{Expr, ExprKind, ItemKind};

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
    pub(crate) fn value(&self) -> Option<&Expr> {
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
    pub(crate) fn value_mut(&mut self) -> Option<&mut Expr> {
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
