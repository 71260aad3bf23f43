//! Blocks `solve { … }`: which unknowns each has, and whether its equations determine them.

use std::collections::{HashMap, HashSet};

use super::elaborate::node;
use super::scope::Symbol;
use super::{Checker, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{self, Expr, ExprKind, LinearSystem, Shape, Unknown};
use crate::syntax::ast::{self, ItemKind, Solve};

/// Maximum number of unknowns of a block, scalar ones and components of vectors.
const MAX_UNKNOWNS: usize = 12;

/// Definitions by name, as far as blocks use them: quantities, and stated equations by their state.
struct Defined<'a> {
    lets: HashMap<&'a str, &'a ast::Expr>,
    equations: HashMap<&'a str, &'a ast::Expr>,
}

impl<'a> Defined<'a> {
    fn of(file: &'a ast::File) -> Defined<'a> {
        let mut defined = Defined {
            lets: HashMap::new(),
            equations: HashMap::new(),
        };
        for item in &file.items {
            match &item.kind {
                ItemKind::Let(own) => drop(defined.lets.insert(&own.name.text, &own.value)),
                ItemKind::Equation(own) => {
                    defined.equations.insert(&own.state.text, &own.value);
                }
                _ => {}
            }
        }
        defined
    }

    /// What a block uses, by its quantities too, in order: names, and whether each is the state of a derivative.
    fn used(
        &self,
        (item, block): (&'a ast::Item, &'a Solve),
        checker: &Checker<'_>,
    ) -> Vec<(String, bool)> {
        let mut found = Vec::new();
        let mut seen = HashSet::new();
        let mut open: Vec<&ast::Expr> = block.sides().collect();
        for state in checker.implied_rates(&item.kind).iter() {
            let name = checker.model.states[state].name.clone();
            open.extend(self.equations.get(&*name));
            if seen.insert((name.clone(), true)) {
                found.push((name, true));
            }
        }
        open.reverse();
        while let Some(e) = open.pop() {
            let mut next: Vec<&ast::Expr> = Vec::new();
            checker.all_uses(e, &mut |name, is_derivative, _| {
                if seen.insert((name.to_owned(), is_derivative)) {
                    found.push((name.to_owned(), is_derivative));
                    let definitions = if is_derivative {
                        &self.equations
                    } else {
                        &self.lets
                    };
                    next.extend(definitions.get(name));
                }
            });
            open.extend(next);
        }
        found
    }
}

impl<'a> Checker<'a> {
    fn blocks(&self) -> Vec<(&'a ast::Item, &'a Solve)> {
        let items = self.file.items.iter();
        items
            .filter_map(|item| match &item.kind {
                ItemKind::Solve(own) => Some((item, own)),
                _ => None,
            })
            .collect()
    }

    /// Declares the unknowns of all blocks, as quantities of the model.
    pub fn declare_unknowns(&mut self) {
        let blocks = self.blocks();
        if blocks.is_empty() {
            return;
        }
        let mut names: HashMap<&str, Span> = HashMap::new();
        for name in blocks.iter().filter_map(|(_, block)| block.name.as_ref()) {
            match names.get(&*name.text) {
                Some(first) => self.second(&format!("solve {}", name.text), *first, name.span),
                None => drop(names.insert(&name.text, name.span)),
            }
        }
        let defined = Defined::of(self.file);
        let used: Vec<Vec<(String, bool)>> = { blocks.iter() }
            .map(|own| defined.used(*own, self))
            .collect();
        // A derivative that no equation states is an unknown of the first block that uses it.
        let mut owner: HashMap<(&str, bool), usize> = HashMap::new();
        for (block, used) in used.iter().enumerate() {
            let own = blocks[block].1.unknowns.iter();
            owner.extend(own.map(|unknown| ((&*unknown.name.text, false), block)));
            for (name, is_derivative) in used {
                let is_unknown = *is_derivative
                    && !defined.equations.contains_key(name.as_str())
                    && matches!(self.scope.find(name), Some(Symbol::State(i)) if i >= self.of_body);
                if is_unknown {
                    owner.entry((name, true)).or_insert(block);
                }
            }
        }
        let needs = |block: usize| -> Vec<usize> {
            let names = used[block]
                .iter()
                .map(|(name, is_rate)| (name.as_str(), *is_rate));
            let owners = names.filter_map(|name| owner.get(&name));
            owners.copied().filter(|other| *other != block).collect()
        };
        for block in self.in_order(&blocks, &needs) {
            let derivatives = used[block].iter().filter(|(name, is_derivative)| {
                *is_derivative && owner.get(&(name.as_str(), true)) == Some(&block)
            });
            let derivatives: Vec<&str> = derivatives.map(|own| own.0.as_str()).collect();
            self.declare_block(blocks[block], &derivatives);
        }
    }

    /// Blocks so that each follows those whose unknowns it uses; reports those that use one another's.
    fn in_order(
        &mut self,
        blocks: &[(&'a ast::Item, &'a Solve)],
        needs: &dyn Fn(usize) -> Vec<usize>,
    ) -> Vec<usize> {
        let mut order: Vec<usize> = Vec::new();
        while order.len() < blocks.len() {
            let is_next = |block: &usize| {
                !order.contains(block) && needs(*block).iter().all(|other| order.contains(other))
            };
            match (0..blocks.len()).find(is_next) {
                Some(next) => order.push(next),
                None => {
                    let rest: Vec<usize> = { 0..blocks.len() }
                        .filter(|block| !order.contains(block))
                        .collect();
                    let message = "these blocks use one another's unknowns";
                    let mut fault = Diagnostic::new(Kind::Cycle, blocks[rest[0]].0.span, message);
                    for &block in &rest {
                        fault = fault.label(blocks[block].0.span, "uses the unknowns of another");
                    }
                    self.report(fault.help("put their equations into one block"));
                    order.extend(rest);
                }
            }
        }
        order
    }

    fn declare_block(&mut self, (item, block): (&'a ast::Item, &'a Solve), derivatives: &[&str]) {
        let system = self.model.systems.len();
        let mut unknowns: Vec<Unknown> = Vec::new();
        for name in derivatives {
            let Some(Symbol::State(state)) = self.scope.find(name) else {
                continue;
            };
            let (span, unit) = (self.model.states[state].span, self.unit_of_rate(state));
            let leaf = ExprKind::Unknown(system, unknowns.len());
            unknowns.push(Unknown {
                name: format!("der({name})"),
                state: Some(state),
            });
            let effect = item.effect;
            let made = model::AuxVariable {
                span,
                effect,
                ..model::AuxVariable::new(
                    format!("der_{name}"),
                    node(leaf, Shape::Scalar, item.span),
                )
            };
            let unit = unit.map_or(UnitOf::Faulty, UnitOf::Term);
            let made = self.add_variable(made, unit, true);
            self.solved.insert(state, made);
        }
        for own in &block.unknowns {
            let (measure, term, _) = self.declared_unit(&own.name, own.of.unit.as_ref());
            let frame = match &own.of.frame {
                Some(frame) => match self.frame_of(frame) {
                    Some(frame) => Some(frame),
                    None => continue,
                },
                None => None,
            };
            let name = &own.name.text;
            let mut leaf = |name: String| {
                let kind = ExprKind::Unknown(system, unknowns.len());
                unknowns.push(Unknown { name, state: None });
                let mut leaf = node(kind, Shape::Scalar, own.name.span);
                leaf.unit = measure.unit;
                leaf
            };
            let value = match frame {
                None => leaf(name.clone()),
                Some(frame) => {
                    let parts = [1, 2, 3].map(|k| leaf(format!("{name}.{k}")));
                    let kind = ExprKind::Components(Box::new(parts));
                    node(kind, Shape::Vector(frame), own.name.span)
                }
            };
            let made = model::AuxVariable {
                doc: own.doc.clone(),
                effect: item.effect,
                ..model::AuxVariable::new(name.clone(), value)
            };
            let made = self.add_variable(made, UnitOf::Term(term), true);
            self.define(&own.name, Symbol::Unknown(made));
        }
        let title = block.title();
        let count = unknowns.len();
        self.model.systems.push(LinearSystem {
            title: title.clone(),
            unknowns,
            equations: Vec::new(),
            constraints: Vec::new(),
            span: item.span,
        });
        if count > MAX_UNKNOWNS {
            let message =
                format!("{title} has {count} unknowns; at most {MAX_UNKNOWNS} are possible");
            let fault = Diagnostic::new(Kind::Limit, item.span, message);
            self.report(fault.note("a vector counts as three"));
        }
    }

    /// The auxiliary variable with this index, as an expression.
    pub fn unknown(&self, index: usize, span: Span) -> Typed {
        let shape = self.model.aux_variables[index].value.shape;
        let unit = self.variables[index].unit.clone();
        Typed::new(ExprKind::AuxVariable(index), shape, span, unit)
    }

    /// Checks the equations of all blocks, and adds a limit where they do not determine their unknowns.
    pub fn systems(&mut self) {
        let mut ordered: Vec<_> = self.blocks();
        let place = |span| {
            let systems = self.model.systems.iter();
            { systems }.position(|own| own.span == span)
        };
        ordered.sort_by_key(|(item, _)| place(item.span));
        for (system, (_, block)) in ordered.into_iter().enumerate() {
            let known = self.unknowns_of_variables(system);
            let equations: Vec<Option<Expr>> = { block.equations.iter() }
                .map(|own| {
                    let typed = self.implicit(own)?;
                    match &own.within {
                        None => Some(typed.expr),
                        Some(within) => self.constraint(typed, within, own, &(system, &known)),
                    }
                })
                .collect();
            if self.holds_unknowns_of_others(system, &equations) {
                continue;
            }
            if equations.iter().all(Option::is_some) && system < self.model.systems.len() {
                self.model.systems[system].equations = equations.into_iter().flatten().collect();
                self.determined(system);
            }
        }
    }

    /// Whether equations of a block have unknowns of one that is solved after it, as where two blocks hold one body;
    /// reports it.
    fn holds_unknowns_of_others(&mut self, system: usize, equations: &[Option<Expr>]) -> bool {
        // Without a body, the order of the blocks has told.
        let others = self
            .declared_body
            .map_or(0..0, |_| system + 1..self.model.systems.len());
        for other in others {
            let known = self.unknowns_of_variables(other);
            let mut found = equations.iter().flatten();
            let Some(found) = found.find_map(|e| occurring(e, other, &known).first().copied())
            else {
                continue;
            };
            let [own, later] = [system, other].map(|index| &self.model.systems[index]);
            // Blocks in a circle have been reported.
            let is_cycle = |fault: &Diagnostic| {
                let mut labels = fault.labels.iter();
                fault.kind == Kind::Cycle && labels.any(|label| label.span == own.span)
            };
            if self.diagnostics.iter().any(is_cycle) {
                return true;
            }
            let message = format!(
                "the equations of {} have `{}`, which {} determines",
                own.title, later.unknowns[found].name, later.title
            );
            let fault = Diagnostic::new(Kind::Cycle, own.span, message);
            let fault = fault.label(later.span, "acts on the body that this block holds");
            self.report(fault.help("put the equations of both into one block"));
            return true;
        }
        false
    }

    /// Left-hand side minus right-hand side of an equation.
    fn implicit(&mut self, equation: &'a ast::ImplicitEquation) -> Option<Typed> {
        let (left, right) = (
            self.elaborate(&equation.left),
            self.elaborate(&equation.right),
        );
        let sides = [left?, right?];
        let is_zero = |side: &Typed| matches!(side.unit, UnitOf::Zero);
        let [left, right] = &sides;
        if left.expr.shape != Shape::Scalar && right.expr.shape == Shape::Scalar && is_zero(right) {
            // A bare 0 fits every vector.
            return sides.into_iter().next();
        }
        let shape = self.same_shape(&sides, equation.span)?;
        let rule = "the sides of an equation must have one unit";
        let unit = self.same_unit(&sides, equation.span, rule);
        let [left, right] = sides.map(|side| Box::new(side.expr));
        let kind = ExprKind::Sub(left, right);
        Some(Typed::new(kind, shape, equation.span, unit))
    }
}

/// Unknowns of a system in an expression; `known` has those of the auxiliary variables.
pub(super) fn occurring(e: &Expr, system: usize, known: &[Vec<usize>]) -> Vec<usize> {
    let mut found = Vec::new();
    for part in e.nodes() {
        match &part.kind {
            ExprKind::Unknown(of, k) if *of == system => found.push(*k),
            ExprKind::AuxVariable(i) => found.extend(known.get(*i).into_iter().flatten()),
            _ => {}
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}
