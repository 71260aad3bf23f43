//! The order of named quantities: each after those that it uses.

use std::collections::HashMap;

use super::Checker;
use super::scope::Symbol;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::syntax::ast::{self, Expr, ExprKind};

/// A `let`, or the right side of an equation that is used as `der(STATE)`.
#[derive(Clone, Copy)]
pub(super) struct Defining<'a> {
    pub name: &'a ast::Name,
    pub unit: Option<&'a ast::UnitExpr>,
    pub value: &'a Expr,
    pub doc: &'a str,
    pub effect: Option<usize>,
    /// The state whose derivative it is.
    pub state: Option<usize>,
    /// The statement.
    pub span: Span,
}

/// Every name and every `der(STATE)` of an expression, with its place.
pub(super) fn uses<'e>(e: &'e Expr, visit: &mut dyn FnMut(&'e str, bool, Span)) {
    match &e.kind {
        ExprKind::Number(_) => {}
        ExprKind::Name(name) => visit(name, false, e.span),
        ExprKind::Derivative(state) => visit(&state.text, true, e.span),
        ExprKind::Part(of, _) | ExprKind::Neg(of) => uses(of, visit),
        ExprKind::Components(parts, _) => parts.iter().for_each(|p| uses(p, visit)),
        ExprKind::Binary(_, a, b) => {
            uses(a, visit);
            uses(b, visit);
        }
        ExprKind::Call(_, arguments) => arguments.iter().for_each(|a| uses(a, visit)),
    }
}

impl Checker<'_> {
    /// An order in which each definition comes after those it uses, else as written.
    /// Definitions on a cycle are left out, and every cycle is reported once.
    pub fn ordered(&mut self, definitions: &[Defining<'_>]) -> Vec<usize> {
        let of_state: HashMap<usize, usize> = definitions
            .iter()
            .enumerate()
            .filter_map(|(i, d)| Some((d.state?, i)))
            .collect();
        let edges: Vec<Vec<(usize, Span)>> = definitions
            .iter()
            .map(|d| {
                let mut to = Vec::new();
                uses(
                    d.value,
                    &mut |name, derivative, span| match self.scope.find(name) {
                        Some(Symbol::Let(i)) if !derivative => to.push((i, span)),
                        Some(Symbol::State(s)) if derivative => {
                            to.extend(of_state.get(&s).map(|&i| (i, span)))
                        }
                        _ => {}
                    },
                );
                to
            })
            .collect();

        let mut order = Vec::with_capacity(definitions.len());
        let mut mark = vec![Mark::New; definitions.len()];
        for root in 0..definitions.len() {
            if mark[root] != Mark::New {
                continue;
            }
            mark[root] = Mark::Open;
            // Each entry: a definition, and how many of its uses have been looked at.
            let mut path = vec![(root, 0)];
            while let Some(&mut (at, ref mut next)) = path.last_mut() {
                let Some(&(to, _)) = edges[at].get(*next) else {
                    if mark[at] == Mark::Open {
                        mark[at] = Mark::Done;
                        order.push(at);
                    }
                    path.pop();
                    continue;
                };
                *next += 1;
                match mark[to] {
                    Mark::New => {
                        mark[to] = Mark::Open;
                        path.push((to, 0));
                    }
                    Mark::Open => {
                        let start = path.iter().position(|p| p.0 == to).unwrap_or(0);
                        let cycle: Vec<(usize, Span)> = path[start..]
                            .iter()
                            .map(|&(i, next)| (i, edges[i][next - 1].1))
                            .collect();
                        for &(i, _) in &cycle {
                            mark[i] = Mark::Cyclic;
                        }
                        self.report_cycle(definitions, &cycle);
                    }
                    Mark::Done | Mark::Cyclic => {}
                }
            }
        }
        order
    }

    fn report_cycle(&mut self, definitions: &[Defining<'_>], cycle: &[(usize, Span)]) {
        const MOST: usize = 8;
        let called = |i: usize| {
            let d = &definitions[i];
            match d.state {
                Some(_) => format!("`der({})`", d.name.text),
                None => format!("`{}`", d.name.text),
            }
        };
        let first = definitions[cycle[0].0].name.span;
        let mut names: Vec<String> = cycle.iter().take(MOST).map(|&(i, _)| called(i)).collect();
        if cycle.len() > MOST {
            names.push(format!("{} more", cycle.len() - MOST));
        }
        names.push(called(cycle[0].0));
        let message = match cycle.len() {
            1 => format!("{} is defined by itself", names[0]),
            _ => format!(
                "these are defined by one another in a circle: {}",
                names.join(" → ")
            ),
        };
        let mut fault = Diagnostic::new(Kind::Cycle, first, message);
        for (k, &(i, span)) in cycle.iter().enumerate().take(MOST) {
            let next = cycle[(k + 1) % cycle.len()].0;
            fault = fault.label(span, format!("{} uses {}", called(i), called(next)));
        }
        let replaced = cycle.len() == 1 && definitions[cycle[0].0].effect.is_some();
        self.report(fault.help(if replaced {
            "in a `replace`, `previous` stands for the definition as it was"
        } else if cycle.len() == 1 {
            "define it by other quantities"
        } else {
            "one of them must be defined without the others"
        }));
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Mark {
    New,
    Open,
    Done,
    Cyclic,
}
