//! Semantic checks of validity limits (`limit … > bound`).

use super::elaborate::node;
use super::term::Term;
use super::{Checker, UnitOf};
use crate::diagnostic::{Diagnostic, Kind};
use crate::model::{self, ExprKind, FrameKind, Function, Shape};
use crate::syntax::ast::ItemKind;
use crate::unit::Unit;

const GIMBAL_LIMIT: f64 = 0.01;

/// Maximum number of validity limits, which bounds the run time: every divisor is compared with each.
const MAX_LIMITS: usize = 100;

impl Checker<'_> {
    /// Checks the stated validity limits, and adds the one that avoids gimbal lock.
    pub fn limits(&mut self) {
        let file = self.file;
        for item in &file.items {
            let ItemKind::Limit(limit) = &item.kind else {
                continue;
            };
            if self.model.limits.len() >= MAX_LIMITS {
                let message = format!("a model has at most {MAX_LIMITS} limits");
                self.report(Diagnostic::new(Kind::Limit, limit.value.span, message));
                break;
            }
            let Some(typed) = self.scalar(&limit.value, "what is limited") else {
                continue;
            };
            let Some(measure) = self.measure_or_one(limit.bound.unit.as_ref()) else {
                continue;
            };
            let (bound, _) = measure.of(&limit.bound.number);
            // A bound of 0 without a unit is valid for every unit.
            if (limit.bound.unit.is_some() || bound != 0.0)
                && let UnitOf::Term(found) = &typed.unit
                && self
                    .units
                    .equate(found, &Term::known(measure.unit), limit.bound.span)
                    .is_err()
            {
                let text = self.text(limit.value.span);
                let is = self.described(found);
                let other = self.described(&Term::known(measure.unit));
                let message = format!("`{text}` is {is}, but its bound is {other}");
                let fault =
                    Diagnostic::new(Kind::Unit, limit.value.span.to(limit.bound.span), message)
                        .label(limit.value.span, is)
                        .label(limit.bound.span, other);
                self.suspect_unitless(fault.span, &[&typed]);
                self.report(fault.help("give the bound the unit of what it bounds"));
            }
            self.model.limits.push(model::ValidityLimit {
                value: typed.expr,
                bound,
                reason: limit.reason.clone(),
                span: item.span,
            });
        }
        self.attitude_limit();
    }

    /// Adds the limit that avoids gimbal lock: of the sine for sequences such as 3-1-3, else of the cosine.
    fn attitude_limit(&mut self) {
        let Some(rotation) = self.model.rotation() else {
            return;
        };
        let chain = self.chain(rotation.body_frame);
        let [third, second, first] = chain[..] else {
            return;
        };
        let turn = |f: usize| match self.model.frames[f].kind {
            FrameKind::Turned { angle, axis, .. } => Some((angle, axis)),
            _ => None,
        };
        let (Some((a, i)), Some((b, _)), Some((c, k))) = (turn(first), turn(second), turn(third))
        else {
            return;
        };
        let function = if i == k { Function::Sin } else { Function::Cos };
        let span = self.model.frames[second].span;
        let mut angle = node(ExprKind::State(b), Shape::Scalar, span);
        angle.unit = Unit::RADIAN;
        let call = ExprKind::Call(function, Box::new(angle));
        let value = node(call, Shape::Scalar, span);
        let mut limits = self.model.limits.iter();
        if limits.any(|limit| limit.bound >= 0.0 && limit.value.same(&value)) {
            return;
        }
        let name = |i: usize| self.model.states[i].name.clone();
        let reason = format!("{} and {} turn about one axis", name(a), name(c));
        self.model.limits.push(model::ValidityLimit {
            value,
            bound: GIMBAL_LIMIT,
            reason,
            span,
        });
    }
}
