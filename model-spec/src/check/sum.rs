//! Type checking of sums: all terms must have one shape, one frame and one unit.

use super::elaborate::node;
use super::{Checker, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{ExprKind, Shape};
use crate::syntax::ast::{self, BinaryOp};

impl Checker<'_> {
    /// Elaborates `a + b - c …` as one n-ary sum, so that one inconsistent term causes only one error message.
    pub fn sum(&mut self, e: &ast::Expr) -> Option<Typed> {
        // Terms from the left, each with its operator and the source span of the partial sum.
        let mut terms: Vec<(BinaryOp, &ast::Expr, Span)> = Vec::new();
        let mut rest = e;
        while let ast::ExprKind::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), a, b) = &rest.kind {
            terms.push((*op, b, rest.span));
            rest = a;
        }
        terms.push((BinaryOp::Add, rest, rest.span));
        terms.reverse();

        let typed: Vec<Option<Typed>> = terms.iter().map(|t| self.elaborate(t.1)).collect();
        let present: Vec<Typed> = typed.iter().flatten().cloned().collect();
        let shape = self.same_shape(&present, e.span)?;
        let rule = "quantities of different units cannot be added";
        let unit = self.same_unit(&present, e.span, rule);

        let mut sum: Option<crate::model::Expr> = None;
        for ((op, _, span), term) in terms.iter().zip(typed) {
            let term = term?.expr;
            sum = Some(match sum {
                None => term,
                Some(left) => {
                    let (a, b) = (Box::new(left), Box::new(term));
                    let kind = if *op == BinaryOp::Sub {
                        ExprKind::Sub(a, b)
                    } else {
                        ExprKind::Add(a, b)
                    };
                    node(kind, shape, *span)
                }
            });
        }
        Some(Typed { expr: sum?, unit })
    }

    /// Common shape of all terms of a sum; `None`, with an error reported, if they differ in shape or frame.
    pub fn same_shape(&mut self, terms: &[Typed], span: Span) -> Option<Shape> {
        let first = terms.first()?;
        let Some(other) = terms.iter().find(|t| t.expr.shape != first.expr.shape) else {
            return Some(first.expr.shape);
        };
        let (a, b) = (self.text(first.expr.span), self.text(other.expr.span));
        let fault = match (first.expr.shape, other.expr.shape) {
            (Shape::Vector(f), Shape::Vector(g)) => self.different_frames(first, f, other, g, span),
            (one, _) => {
                let [c, d] = if one == Shape::Scalar {
                    ["number", "vector"]
                } else {
                    ["vector", "number"]
                };
                let message =
                    format!("a {c} and a {d} cannot be added: `{a}` is a {c}, `{b}` a {d}");
                Diagnostic::new(Kind::Shape, span, message)
                    .label(first.expr.span, format!("a {c}"))
                    .label(other.expr.span, format!("a {d}"))
            }
        };
        self.refuse(fault)
    }

    /// Creates the error for two vectors `a` and `b` whose components are in different frames, `f` and `g`.
    pub fn different_frames(
        &self,
        a: &Typed,
        f: usize,
        b: &Typed,
        g: usize,
        span: Span,
    ) -> Diagnostic {
        let frame = |i: usize| self.model.frames.get(i).map_or("?", |f| f.name.as_str());
        let (f, g) = (frame(f), frame(g));
        let (ta, tb) = (self.text(a.expr.span), self.text(b.expr.span));
        let message = format!(
            "the vectors have their components in different frames: `{ta}` in {f}, `{tb}` in {g}"
        );
        let fault = Diagnostic::new(Kind::Frame, span, message)
            .label(a.expr.span, format!("components in {f}"))
            .label(b.expr.span, format!("components in {g}"))
            .help(format!(
                "bring one to the other's frame: `in_{f}({tb})`, or `in_{g}({ta})`"
            ));
        self.called(fault, &format!("in_{f}"), b.expr.span)
    }

    /// Common unit of `terms`; reports one error, which begins with `rule`, if they differ.
    pub fn same_unit(&mut self, terms: &[Typed], span: Span, rule: &str) -> UnitOf {
        let mut groups: Vec<Vec<usize>> = Vec::new();
        let mut faulty = false;
        for (i, typed) in terms.iter().enumerate() {
            let UnitOf::Term(term) = &typed.unit else {
                faulty |= matches!(typed.unit, UnitOf::Faulty);
                continue;
            };
            let term = term.clone();
            let fits = groups.iter().position(|group| match &terms[group[0]].unit {
                UnitOf::Term(first) => self.units.equate(first, &term, typed.expr.span).is_ok(),
                _ => false,
            });
            match fits {
                Some(group) => groups[group].push(i),
                None => groups.push(vec![i]),
            }
        }
        if groups.len() > 1 {
            let fault = self.mismatch(terms, &groups, span, rule);
            self.report(fault);
            return UnitOf::Faulty;
        }
        match groups.first() {
            _ if faulty => UnitOf::Faulty,
            None => UnitOf::Zero,
            Some(group) => terms[group[0]].unit.clone(),
        }
    }
}
