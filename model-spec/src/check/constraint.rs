//! Constraints of blocks `solve { … }`, and claimed changes of quantities.

use super::elaborate::{node, number};
use super::solve::occurring;
use super::term::Term;
use super::{Checker, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind};
use crate::model::{self, Expr, ExprKind, Function, Shape, ValidityLimit};
use crate::syntax::ast::{self, ItemKind};
use crate::unit::Unit;

/// Rate at which deviations from a constraint decay, 1/s.
const DECAY: f64 = 10.0;

/// Maximum number of derivatives of a constraint.
const MAX_REDUCTION: usize = 2;

impl<'a> Checker<'a> {
    /// The constraint, differentiated until it has unknowns of its system, with a part of what it and its derivatives
    /// deviate by, so that deviations decay (Baumgarte 1972). Limits hold them within the tolerance.
    pub fn constraint(
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
        let text = self.text(span);
        if let UnitOf::Term(sides) = &deviation.unit {
            let of = UnitOf::Term(Term::known(measure.unit));
            let rule = format!(
                "the tolerance must be {}, as the sides of the constraint are",
                self.described(sides)
            );
            let expr = number(tolerance, None, measure.unit, within.span);
            self.must_be(&Typed { expr, unit: of }, sides, &rule);
        }
        let mut orders = vec![deviation];
        while occurring(&orders.last()?.expr, *system, known).is_empty() {
            if orders.len() > MAX_REDUCTION {
                let message =
                    format!("neither `{text}` nor its derivatives have unknowns of this block");
                return self.refuse(Diagnostic::new(Kind::Value, span, message));
            }
            let next = self.rate_along(orders.last()?.clone(), span, true)?;
            orders.push(next);
        }
        let number =
            |value, exact, unit: Option<Unit>| number(value, exact, unit.unwrap_or_default(), span);
        let per_time = |power: i32| Unit::SECOND.checked_pow_half(-2 * power);
        let reason = format!(
            "the constraint \"{}\" is violated",
            text.trim_start_matches("constraint ").trim_end_matches(';')
        );
        let reduced = orders.len() as i32 - 1;
        for (order, own) in orders.iter().take(orders.len() - 1).enumerate() {
            let size = ExprKind::Call(Function::Abs, Box::new(own.expr.clone()));
            let size = node(size, Shape::Scalar, span);
            let power = order as i32;
            let unit = per_time(power).and_then(|unit| unit.checked_mul(measure.unit));
            let allowed = number(DECAY.powi(power) * tolerance, None, unit);
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
            // The factor of the n-th derivative in (d/dt + DECAY)^reduced.
            let ways = if order > 0 { f64::from(reduced) } else { 1.0 };
            let value = ways * DECAY.powi(power);
            let factor = number(value, Some((value as i64, 1)), per_time(power));
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
            let Some(rate) = self.rate_along(quantity, span, true) else {
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
}
