//! Blocks `solve { … }`: which unknowns each has, and whether its equations determine them.

use std::collections::{HashMap, HashSet};

use super::elaborate::node;
use super::scope::Symbol;
use super::term::Term;
use super::{Checker, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind};
use crate::model::{self, Expr, ExprKind, Function, LinearSystem, Shape, Unknown, ValidityLimit};
use crate::syntax::ast::{self, ItemKind, Solve};
use crate::unit::Unit;

/// Maximum number of unknowns of a block, scalar ones and components of vectors.
const MAX_UNKNOWNS: usize = 12;

/// Bound of [`ExprKind::Determinacy`]: half of the digits of a pivot are lost to cancellation.
const LEAST_DETERMINACY: f64 = 1e-8;

/// Rate at which deviations from a constraint decay, 1/s.
const DECAY: f64 = 10.0;

/// Maximum number of derivatives of a constraint.
const MAX_REDUCTION: usize = 2;

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
    fn used(&self, block: &'a Solve, checker: &Checker<'_>) -> Vec<(String, bool)> {
        let mut found = Vec::new();
        let mut seen = HashSet::new();
        let constraints = block.equations.iter().filter(|own| own.within.is_some());
        let mut open: Vec<&ast::Expr> = block.sides().collect();
        for name in constraints.flat_map(|own| checker.states_of_constraint(own)) {
            if seen.insert((name.to_owned(), true)) {
                found.push((name.to_owned(), true));
                open.extend(self.equations.get(name));
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
        let defined = Defined::of(self.file);
        let used: Vec<Vec<(String, bool)>> = { blocks.iter() }
            .map(|own| defined.used(own.1, self))
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
            let made = model::AuxVariable {
                span,
                ..model::AuxVariable::new(
                    format!("der_{name}"),
                    node(leaf, Shape::Scalar, item.span),
                )
            };
            let made = self.add_unknown(made, unit.map_or(UnitOf::Faulty, UnitOf::Term), item);
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
                ..model::AuxVariable::new(name.clone(), value)
            };
            let made = self.add_unknown(made, UnitOf::Term(term), item);
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

    /// Adds an unknown as auxiliary variable; returns its index.
    fn add_unknown(
        &mut self,
        made: model::AuxVariable,
        unit: UnitOf,
        item: &'a ast::Item,
    ) -> usize {
        self.let_units.push(unit);
        self.varies.push(true);
        self.calls.push(None);
        let effect = item.effect;
        self.model
            .aux_variables
            .push(model::AuxVariable { effect, ..made });
        self.model.aux_variables.len() - 1
    }

    /// The auxiliary variable with this index, as an expression.
    pub fn unknown(&self, index: usize, span: crate::diagnostic::Span) -> Typed {
        let shape = self.model.aux_variables[index].value.shape;
        let unit = self.let_units[index].clone();
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
            if equations.iter().all(Option::is_some) && system < self.model.systems.len() {
                self.model.systems[system].equations = equations.into_iter().flatten().collect();
                self.determined(system);
            }
        }
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

    /// The constraint, differentiated until it has unknowns of its system, with a part of what it and its derivatives
    /// deviate by, so that deviations decay (Baumgarte 1972). Limits hold them within the tolerance.
    fn constraint(
        &mut self,
        deviation: Typed,
        within: &'a ast::Quantity,
        equation: &'a ast::ImplicitEquation,
        (system, known): &(usize, &[Vec<usize>]),
    ) -> Option<Expr> {
        let span = equation.span;
        if deviation.expr.shape != Shape::Scalar {
            let message = "a constraint is an equation of numbers, but this is one of vectors";
            let fault = Diagnostic::new(Kind::Shape, span, message);
            return self.refuse(fault.help("state one for each component, such as `….1`"));
        }
        let measure = self.measure_or_one(within.unit.as_ref())?;
        let (tolerance, _) = measure.of(&within.number);
        let rule = format!("`{within}` is the tolerance of a constraint that");
        let text = self.text(span);
        let term = Term::known(measure.unit);
        self.must_be(
            &deviation,
            &term,
            &format!("{rule} must be {}", self.described(&term)),
        );
        let mut orders = vec![deviation];
        while occurring(&orders.last()?.expr, *system, known).is_empty() {
            if orders.len() > MAX_REDUCTION {
                let message =
                    format!("neither `{text}` nor its derivatives have unknowns of this block");
                return self.refuse(Diagnostic::new(Kind::Value, span, message));
            }
            let next = self.rate_of(orders.last()?.clone(), span)?;
            orders.push(next);
        }
        let rate = |power: i32| {
            let mut rate = node(
                ExprKind::Number {
                    value: DECAY.powi(power),
                    exact: Some(((DECAY as i64).pow(power as u32), 1)),
                },
                Shape::Scalar,
                span,
            );
            rate.unit = Unit::SECOND
                .checked_pow_half(-2 * power)
                .unwrap_or_default();
            rate
        };
        let reason = format!(
            "the constraint \"{}\" is violated",
            text.trim_end_matches(';')
        );
        let reduced = orders.len() as i32 - 1;
        for (order, own) in orders.iter().take(orders.len() - 1).enumerate() {
            let size = ExprKind::Call(Function::Abs, Box::new(own.expr.clone()));
            let size = node(size, Shape::Scalar, span);
            let mut allowed = rate(order as i32);
            if let ExprKind::Number { value, exact } = &mut allowed.kind {
                (*value, *exact) = (*value * tolerance, None);
            }
            allowed.unit = allowed.unit.checked_mul(measure.unit).unwrap_or_default();
            let kind = ExprKind::Sub(Box::new(allowed), Box::new(size));
            self.model.limits.push(ValidityLimit {
                value: node(kind, Shape::Scalar, span),
                bound: 0.0,
                reason: reason.clone(),
                span,
            });
        }
        let deviations = orders.iter().take(orders.len() - 1);
        let deviations = deviations.map(|own| own.expr.clone());
        self.model.systems[*system].constraints.extend(deviations);
        let mut sum = orders.pop()?.expr;
        for (order, own) in orders.into_iter().enumerate() {
            let power = reduced - order as i32;
            let mut factor = rate(power);
            if let (2, 1, ExprKind::Number { value, exact }) = (reduced, power, &mut factor.kind) {
                (*value, *exact) = (2.0 * DECAY, Some((2 * DECAY as i64, 1)));
            }
            let term = ExprKind::Mul(Box::new(factor), Box::new(own.expr));
            let term = node(term, Shape::Scalar, span);
            sum = node(
                ExprKind::Add(Box::new(sum), Box::new(term)),
                Shape::Scalar,
                span,
            );
        }
        Some(sum)
    }

    /// Checks the claimed changes of quantities.
    pub fn balances(&mut self) {
        for item in &self.file.items {
            let ItemKind::Balance(own) = &item.kind else {
                continue;
            };
            let (quantity, change) = (self.elaborate(&own.quantity), self.elaborate(&own.change));
            let (Some(quantity), Some(change)) = (quantity, change) else {
                continue;
            };
            let span = own.quantity.span;
            let expr = quantity.expr.clone();
            let Some(rate) = self.rate_of(quantity, span) else {
                continue;
            };
            let sides = [rate, change];
            if self.same_shape(&sides, item.span).is_none() {
                continue;
            }
            let rule = "a quantity and its change must agree in their units";
            self.same_unit(&sides, item.span, rule);
            let [_, change] = sides;
            if let Some(name) = self.solved_derivative(&change.expr) {
                let message = format!(
                    "`{name}` follows from the equations: a claim made of it would hold whatever they are"
                );
                let fault = Diagnostic::new(Kind::Cycle, own.change.span, message);
                self.report(fault.help("state the change by the states, parameters and reactions"));
                continue;
            }
            self.model.balances.push(model::Balance {
                quantity: expr,
                change: change.expr,
                span: item.span,
            });
        }
    }

    /// Name of a derivative that is an unknown and that an expression depends on.
    fn solved_derivative(&self, e: &Expr) -> Option<String> {
        let systems = self.model.systems.iter().enumerate();
        let mut names = systems.filter_map(|(index, system)| {
            let found = occurring(e, index, &self.unknowns_of_variables(index));
            let mut unknowns = found.into_iter().map(|k| &system.unknowns[k]);
            unknowns.find(|own| own.state.is_some())
        });
        names.next().map(|own| own.name.clone())
    }

    /// Reports a system that is not linear, or whose equations cannot determine its unknowns.
    fn determined(&mut self, index: usize) {
        let system = self.model.systems[index].clone();
        let count = |e: &Expr| match e.shape {
            Shape::Scalar => 1,
            Shape::Vector(_) => 3,
        };
        let rows: usize = system.equations.iter().map(count).sum();
        let unknowns = &system.unknowns;
        let listed = || {
            let names: Vec<&str> = unknowns.iter().map(|own| &*own.name).collect();
            super::scope::listed(&names)
        };
        if rows != unknowns.len() {
            let counted = |count: usize, what: &str| {
                format!("{count} {what}{}", if count == 1 { "" } else { "s" })
            };
            let message = format!(
                "{} has {}, but {}",
                system.title,
                counted(rows, "equation"),
                counted(unknowns.len(), "unknown")
            );
            let fault = Diagnostic::new(Kind::Value, system.span, message);
            let fault = fault.note("an equation of vectors, and a vector, count as three");
            self.report(match unknowns.is_empty() {
                true => fault.help("the unknowns are derivatives such as `der(v)`, and what `unknown NAME: UNIT;` declares"),
                false => fault.note(format!("the unknowns are {}", listed())),
            });
            return;
        }
        if let Some(fault) = self.not_linear(index) {
            self.report(fault);
            return;
        }
        let (mut row_unknowns, known) = (Vec::new(), self.unknowns_of_variables(index));
        for e in &system.equations {
            let found = occurring(e, index, &known);
            row_unknowns.extend(vec![found; count(e)]);
        }
        let undetermined = unmatched(&row_unknowns, unknowns.len());
        if let Some(&first) = undetermined.first() {
            let names: Vec<&str> = undetermined.iter().map(|k| &*unknowns[*k].name).collect();
            let message = format!(
                "the equations of {} do not determine {}",
                system.title,
                super::scope::listed(&names)
            );
            let occurs = row_unknowns.iter().any(|row| row.contains(&first));
            let fault = Diagnostic::new(Kind::Value, system.span, message);
            self.report(if occurs {
                fault.note(
                    "other unknowns are in too few of the equations, or the same ones in too many",
                )
            } else {
                fault.note(format!("`{}` is in none of them", unknowns[first].name))
            });
            return;
        }
        let determinacy = node(ExprKind::Determinacy(index), Shape::Scalar, system.span);
        self.model.limits.push(ValidityLimit {
            value: determinacy,
            bound: LEAST_DETERMINACY,
            reason: format!(
                "{} does not determine {} here",
                system.title.replace('`', "\""),
                {
                    let names: Vec<&str> = unknowns.iter().map(|own| &*own.name).collect();
                    names.join(", ")
                }
            ),
            span: system.span,
        });
    }

    fn not_linear(&self, system: usize) -> Option<Diagnostic> {
        let mut degrees = Degrees {
            system,
            variables: Vec::new(),
        };
        for own in &self.model.aux_variables {
            let degree = degrees.of(&own.value).ok();
            degrees.variables.push(degree);
        }
        let equations = self.model.systems[system].equations.iter();
        let culprit = { equations }.find_map(|e| degrees.of(e).err())?;
        let text = self.text(culprit.span);
        let message = format!(
            "`{text}` is not linear in the unknowns of {}",
            self.model.systems[system].title
        );
        let fault = Diagnostic::new(Kind::Value, culprit.span, message);
        Some(fault.help(
            "unknowns are added, and multiplied and divided by what is known without the block",
        ))
    }

    /// For each auxiliary variable, the unknowns of a system on which it depends.
    fn unknowns_of_variables(&self, system: usize) -> Vec<Vec<usize>> {
        let mut known: Vec<Vec<usize>> = Vec::new();
        for own in &self.model.aux_variables {
            let found = occurring(&own.value, system, &known);
            known.push(found);
        }
        known
    }
}

/// Unknowns of a system in an expression; `known` has those of the auxiliary variables.
fn occurring(e: &Expr, system: usize, known: &[Vec<usize>]) -> Vec<usize> {
    let mut found = Vec::new();
    e.walk(&mut |part| match &part.kind {
        ExprKind::Unknown(of, k) if *of == system => found.push(*k),
        ExprKind::AuxVariable(i) => found.extend(known.get(*i).into_iter().flatten()),
        _ => {}
    });
    found.sort_unstable();
    found.dedup();
    found
}

/// Unknowns that no assignment of each to an equation of its own covers.
fn unmatched(rows: &[Vec<usize>], count: usize) -> Vec<usize> {
    fn place(
        unknown: usize,
        rows: &[Vec<usize>],
        taken: &mut [Option<usize>],
        seen: &mut [bool],
    ) -> bool {
        for row in 0..rows.len() {
            if seen[row] || !rows[row].contains(&unknown) {
                continue;
            }
            seen[row] = true;
            if taken[row].is_none_or(|other| place(other, rows, taken, seen)) {
                taken[row] = Some(unknown);
                return true;
            }
        }
        false
    }
    let mut taken = vec![None; rows.len()];
    let fails = |unknown: &usize| !place(*unknown, rows, &mut taken, &mut vec![false; rows.len()]);
    (0..count).filter(fails).collect()
}

/// Whether expressions are independent of the unknowns of a system (0) or linear in them (1).
struct Degrees {
    system: usize,
    /// `None` for an auxiliary variable that is not linear.
    variables: Vec<Option<u8>>,
}

impl Degrees {
    /// Degree of an expression, or the part of it that is not linear.
    fn of<'e>(&self, e: &'e Expr) -> Result<u8, &'e Expr> {
        use ExprKind as K;
        match &e.kind {
            K::Unknown(system, _) => Ok(u8::from(*system == self.system)),
            K::AuxVariable(i) => self.variables.get(*i).copied().flatten().ok_or(e),
            K::Add(a, b) | K::Sub(a, b) => Ok(self.of(a)?.max(self.of(b)?)),
            K::Mul(a, b) | K::Dot(a, b) | K::Cross(a, b) => match self.of(a)? + self.of(b)? {
                2 => Err(e),
                degree => Ok(degree),
            },
            K::Div(a, b) => match (self.of(a)?, self.of(b)?) {
                (degree, 0) => Ok(degree),
                _ => Err(e),
            },
            K::Neg(a) | K::Component(a, _) | K::Reexpress(a) => self.of(a),
            // What is differentiated depends on no unknown.
            K::Rate(_, _, rates) => {
                let mut degree = 0;
                for rate in rates.iter() {
                    degree = degree.max(self.of(rate)?);
                }
                Ok(degree)
            }
            K::Components(parts) => {
                let mut degree = 0;
                for part in parts.iter() {
                    degree = degree.max(self.of(part)?);
                }
                Ok(degree)
            }
            _ => {
                let mut found = Ok(0);
                e.children(&mut |child| match (&found, self.of(child)) {
                    (Ok(_), Ok(1)) => found = Err(e),
                    (Ok(_), Err(inner)) => found = Err(inner),
                    _ => {}
                });
                found
            }
        }
    }
}
