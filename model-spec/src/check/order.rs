//! Topological order of the definitions of auxiliary variables, by the names that they use, and what must precede the
//! motion.

use super::Checker;
use super::scope::Symbol;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::layout::{depends, depends_on_accelerations, is_acceleration};
use crate::syntax::ast::{self, Expr};
use std::collections::HashMap;

/// Maximum number of dependency cycles that are reported, since each report traverses the definitions of a cycle.
const MAX_CYCLES: usize = 50;

const MAX_LISTED: usize = 8;

#[derive(Clone, Copy)]
pub(super) struct Defining<'a> {
    pub name: &'a ast::Name,
    pub unit: Option<&'a ast::UnitExpr>,
    pub value: &'a Expr,
    pub doc: &'a str,
    pub effect: Option<usize>,
    /// Whether it is declared by `param`.
    pub is_constant: bool,
    /// Source span of the call to which it belongs, if any.
    pub call: Option<Span>,
    /// For an equation `der(STATE) = …`, index of `STATE` into `Model::states`; `None` for a `let`.
    pub state: Option<usize>,
    pub span: Span,
}

impl Checker<'_> {
    fn dependencies(&self, definitions: &[Defining<'_>]) -> Vec<Vec<(usize, Span)>> {
        let derivatives = definitions.iter().enumerate();
        let of_state: HashMap<usize, usize> = derivatives
            .filter_map(|(i, d)| Some((d.state?, i)))
            .collect();
        let used_by = |definition: &Defining<'_>| {
            let mut used = Vec::new();
            self.all_uses(definition.value, &mut |name, is_derivative, span| {
                let index = match self.scope.find(name) {
                    Some(Symbol::Let(i)) if !is_derivative => Some(i),
                    Some(Symbol::State(s)) if is_derivative => of_state.get(&s).copied(),
                    _ => None,
                };
                used.extend(index.map(|i| (i, span)));
            });
            used
        };
        definitions.iter().map(used_by).collect()
    }

    pub fn ordered(&mut self, definitions: &[Defining<'_>]) -> Vec<usize> {
        let edges = self.dependencies(definitions);
        let mut cycles = 0;
        let mut order = Vec::with_capacity(definitions.len());
        let mut mark = vec![Mark::New; definitions.len()];
        for root in 0..definitions.len() {
            if mark[root] != Mark::New {
                continue;
            }
            mark[root] = Mark::Open;
            // Stack of the search: index of a definition, and number of its dependencies visited so far.
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
                        let cycle = path[start..].iter();
                        let cycle: Vec<(usize, Span)> =
                            cycle.map(|&(i, next)| (i, edges[i][next - 1].1)).collect();
                        for &(i, _) in &cycle {
                            mark[i] = Mark::Cyclic;
                        }
                        self.report_cycle(definitions, &cycle);
                        cycles += 1;
                        if cycles == MAX_CYCLES {
                            return order;
                        }
                    }
                    Mark::Done | Mark::Cyclic => {}
                }
            }
        }
        order
    }

    fn report_cycle(&mut self, definitions: &[Defining<'_>], cycle: &[(usize, Span)]) {
        let called = |i: usize| {
            let d = &definitions[i];
            match d.state {
                Some(_) => format!("`der({})`", d.name.text),
                None => format!("`{}`", d.name.text),
            }
        };
        let first = definitions[cycle[0].0].name.span;
        let mut names: Vec<String> = cycle
            .iter()
            .take(MAX_LISTED)
            .map(|&(i, _)| called(i))
            .collect();
        if cycle.len() > MAX_LISTED {
            names.push(format!("{} more", cycle.len() - MAX_LISTED));
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
        for (k, &(i, span)) in cycle.iter().enumerate().take(MAX_LISTED) {
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

impl Checker<'_> {
    /// Reports expressions that depend on the specific force or the angular acceleration, but precede the motion.
    pub fn after_motion(&mut self) {
        let model = &self.model;
        let known = depends_on_accelerations(model);
        let statements = model.statements().into_iter();
        let before = statements.filter(|own| own.0 != "an observation");
        let found: Vec<(Span, &str)> = before
            .filter(|(_, _, value, _)| depends(value, &known, &is_acceleration))
            .map(|(what, _, value, _)| (value.span, what))
            .collect();
        for (span, what) in found {
            let message = format!(
                "{what} cannot depend on `specific_force` or `angular_acceleration`, which follow from the forces and moments"
            );
            let fault = Diagnostic::new(Kind::Cycle, span, message);
            self.report(fault.help("use them in a `let` for a sensor, or in `observe`"));
        }
    }
}
