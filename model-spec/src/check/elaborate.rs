//! Elaboration of expressions: resolves names, shapes and frames, and computes units.

use super::term::{Fraction, Term};
use super::{Checker, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{Expr, ExprKind, Shape};
use crate::syntax::ast::{self, BinaryOp};
use crate::unit::{Unit, symbol};

const MAX_DOUBLED_EXPONENT: f64 = 128.0;

/// Creates an expression node with the provisional unit 1; [`Checker::finish`] assigns the final unit.
pub(super) fn node(kind: ExprKind, shape: Shape, span: Span) -> Expr {
    Expr {
        kind,
        shape,
        unit: Unit::ONE,
        span,
    }
}

/// A literal; `exact` is its value as a fraction.
pub(super) fn number(value: f64, exact: Option<(i64, i64)>, unit: Unit, span: Span) -> Expr {
    let kind = ExprKind::Number { value, exact };
    Expr {
        unit,
        ..node(kind, Shape::Scalar, span)
    }
}

impl UnitOf {
    pub fn of(unit: Unit) -> UnitOf {
        UnitOf::Term(Term::known(unit))
    }

    /// Unit for use in products, where a literal 0 counts as dimensionless; `None` if the unit is inconsistent.
    pub fn factor(&self) -> Option<Term> {
        match self {
            UnitOf::Term(term) => Some(term.clone()),
            UnitOf::Zero => Some(Term::one()),
            UnitOf::Faulty => None,
        }
    }
}

impl Checker<'_> {
    /// Resolves names, shape, frame and unit of an expression; `None` on any error but a unit error.
    pub fn elaborate(&mut self, e: &ast::Expr) -> Option<Typed> {
        match &e.kind {
            ast::ExprKind::Number(q) => self.literal(q, e.span),
            ast::ExprKind::Name(name) => self.name(name, e.span),
            ast::ExprKind::Part(of, part) => self.part(of, *part, e.span),
            ast::ExprKind::Derivative(state) => self.derivative(state, e.span),
            ast::ExprKind::Components(parts, frame) => self.components(parts, frame, e.span),
            ast::ExprKind::Neg(of) => {
                let of = self.elaborate(of)?;
                let shape = of.expr.shape;
                let kind = ExprKind::Neg(Box::new(of.expr));
                Some(Typed::new(kind, shape, e.span, of.unit))
            }
            ast::ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, ..) => self.sum(e),
            ast::ExprKind::Binary(op, a, b) => {
                if self.unit_in_pieces(e) {
                    return None;
                }
                match op {
                    BinaryOp::Pow => self.power(a, b, e.span),
                    BinaryOp::Div => self.quotient(a, b, e.span),
                    _ => self.product(*op, a, b, e.span),
                }
            }
            ast::ExprKind::Call(function, arguments) => self.call(function, arguments, e.span),
            ast::ExprKind::Ascribed(of, ascription) => self.ascribed(of, ascription, e.span),
            ast::ExprKind::Element(..) | ast::ExprKind::Sum(..) => {
                let message = "the indices of this expression are not written out";
                self.refuse(Diagnostic::new(Kind::Grammar, e.span, message))
            }
        }
    }

    /// Elaborates an expression that must be a scalar; messages call it `what`.
    pub fn scalar(&mut self, e: &ast::Expr, what: &str) -> Option<Typed> {
        let typed = self.elaborate(e)?;
        if typed.expr.shape == Shape::Scalar {
            return Some(typed);
        }
        let message = format!("{what} must be a number, but this is a vector");
        let fault = Diagnostic::new(Kind::Shape, e.span, message);
        self.refuse(fault.help(
            "take its length `norm(…)`, one component `….1`, or its part along an axis `dot(…, …)`",
        ))
    }

    /// Elaborates an expression that must be a vector, with its frame; messages call it `what`.
    pub fn vector(&mut self, e: &ast::Expr, what: &str) -> Option<(Typed, usize)> {
        let typed = self.elaborate(e)?;
        if let Shape::Vector(frame) = typed.expr.shape {
            return Some((typed, frame));
        }
        let message = format!("{what} must be a vector, but this is a number");
        let fault = Diagnostic::new(Kind::Shape, e.span, message);
        self.refuse(fault.help("multiply it by a direction, such as `N.3`"))
    }

    fn literal(&mut self, q: &ast::Quantity, span: Span) -> Option<Typed> {
        let measure = self.measure_or_one(q.unit.as_ref())?;
        self.refuse_two_readings(q, measure.unit, span);
        let (value, exact) = measure.of(&q.number);
        let expr = number(value, exact, measure.unit, span);
        let unit = match q.unit {
            None if value == 0.0 => UnitOf::Zero,
            _ => UnitOf::of(measure.unit),
        };
        Some(Typed { expr, unit })
    }

    /// Reports a number like `2 m` where a quantity `m` is a length too: the units of what it stands in cannot tell whether
    /// two metres are meant or twice the length.
    fn refuse_two_readings(&mut self, q: &ast::Quantity, unit: Unit, span: Span) {
        let factors = q.unit.as_ref().map_or(&[][..], |own| &own.factors);
        let [
            ast::UnitFactor {
                symbol, doubled: 2, ..
            },
        ] = factors
        else {
            return;
        };
        let (text, number) = (self.text(span), &q.number.text);
        let named = self.scope.find(symbol).filter(|_| !text.contains('['));
        let Some(UnitOf::Term(term)) = named.and_then(|named| self.unit_of_symbol(named)) else {
            return;
        };
        let of_quantity = self.units.resolve(&term).unit();
        if of_quantity.is_some_and(|own| own.agrees(unit)) {
            let is = self.described(&term);
            let message =
                format!("`{text}` can be read in two ways: the quantity `{symbol}` is {is}, too");
            let fault = Diagnostic::new(Kind::Grammar, span, message);
            self.report(fault.help(format!(
                "write `{number} [{symbol}]` for the unit, or `{number}*{symbol}` for the quantity"
            )));
        }
    }

    fn components(
        &mut self,
        parts: &[ast::Expr; 3],
        frame: &ast::Name,
        span: Span,
    ) -> Option<Typed> {
        let frame = self.frame_of(frame);
        let typed = parts
            .each_ref()
            .map(|p| self.scalar(p, "a component of a vector"));
        let present: Vec<Typed> = typed.iter().flatten().cloned().collect();
        let rule = "the components of a vector must have one unit";
        let unit = self.same_unit(&present, span, rule);
        let [a, b, c] = typed;
        let kind = ExprKind::Components(Box::new([a?.expr, b?.expr, c?.expr]));
        Some(Typed::new(kind, Shape::Vector(frame?), span, unit))
    }

    fn product(&mut self, op: BinaryOp, a: &ast::Expr, b: &ast::Expr, span: Span) -> Option<Typed> {
        let (a, b) = (self.elaborate(a), self.elaborate(b));
        let (a, b) = (a?, b?);
        match (op, a.expr.shape, b.expr.shape) {
            (BinaryOp::Dot, Shape::Vector(_), Shape::Vector(_)) => return self.dot(a, b, span),
            (BinaryOp::Cross, Shape::Vector(_), Shape::Vector(_)) => return self.cross(a, b, span),
            (_, Shape::Vector(_), Shape::Vector(_)) => {
                let message = "two vectors are multiplied by `dot` or `cross`, not by `*`";
                let (ta, tb) = (self.text(a.expr.span), self.text(b.expr.span));
                let fault = Diagnostic::new(Kind::Shape, span, message)
                    .label(a.expr.span, "a vector")
                    .label(b.expr.span, "a vector")
                    .help(format!("write `dot({ta}, {tb})` or `cross({ta}, {tb})`"));
                return self.refuse(fault);
            }
            _ => {}
        }
        let shape = if a.expr.shape == Shape::Scalar {
            b.expr.shape
        } else {
            a.expr.shape
        };
        let unit = self.multiplied(&a.unit, &b.unit, Fraction::ONE, span);
        let kind = ExprKind::Mul(Box::new(a.expr), Box::new(b.expr));
        Some(Typed::new(kind, shape, span, unit))
    }

    fn quotient(&mut self, a: &ast::Expr, b: &ast::Expr, span: Span) -> Option<Typed> {
        let (a, b) = (self.elaborate(a), self.scalar(b, "a divisor"));
        let (a, b) = (a?, b?);
        let unit = self.multiplied(&a.unit, &b.unit, Fraction::MINUS_ONE, span);
        let shape = a.expr.shape;
        let kind = ExprKind::Div(Box::new(a.expr), Box::new(b.expr));
        Some(Typed::new(kind, shape, span, unit))
    }

    /// Unit of a · b^`power`; [`UnitOf::Faulty`] if the unit of either operand is inconsistent.
    pub fn multiplied(&mut self, a: &UnitOf, b: &UnitOf, power: Fraction, span: Span) -> UnitOf {
        let (Some(a), Some(b)) = (a.factor(), b.factor()) else {
            return UnitOf::Faulty;
        };
        let (a, b) = (self.units.resolve(&a), self.units.resolve(&b));
        self.in_range(a.times_power(&b, power), span)
    }

    /// Power of a unit; reports one out of range.
    pub fn powered(&mut self, unit: &UnitOf, power: Fraction, span: Span) -> UnitOf {
        match unit.factor() {
            Some(term) => self.in_range(term.power(power), span),
            None => UnitOf::Faulty,
        }
    }

    /// Converts a computed unit; reports an exponent that is out of range.
    pub fn in_range(&mut self, term: Option<Term>, span: Span) -> UnitOf {
        match term {
            Some(term) if term.has_unknowns() || term.unit().is_some() => UnitOf::Term(term),
            _ => {
                let message = format!("the unit of `{}` has a power out of range", self.text(span));
                let fault = Diagnostic::new(Kind::Unit, span, message)
                    .note("powers of units are whole or half numbers up to 63");
                self.report(fault);
                UnitOf::Faulty
            }
        }
    }

    fn power(&mut self, base: &ast::Expr, exponent: &ast::Expr, span: Span) -> Option<Typed> {
        let typed = self.elaborate(base);
        let doubled = constant(exponent).map(|value| value * 2.0);
        if let Some(doubled) = doubled
            && (doubled.abs() > MAX_DOUBLED_EXPONENT || !doubled.is_finite())
        {
            let message = format!(
                "the exponent `{}` is not one of the powers that can be taken",
                self.text(exponent.span)
            );
            let fault = Diagnostic::new(Kind::Value, exponent.span, message);
            return self.refuse(fault.note("exponents are numbers between -64 and 64"));
        }
        let typed = typed?;
        if typed.expr.shape != Shape::Scalar {
            let text = self.text(base.span);
            let fault = Diagnostic::new(Kind::Shape, span, "a vector has no powers");
            return self
                .refuse(fault.help(format!("write `dot({text}, {text})` or `norm({text})^2`")));
        }
        let Some(doubled) = doubled.filter(|doubled| doubled.fract() == 0.0) else {
            return self.real_power(typed, exponent, span);
        };
        let doubled = doubled as i32;
        let power = Fraction::new(i64::from(doubled), 2)?;
        let unit = self.powered(&typed.unit, power, span);
        let kind = ExprKind::Pow(Box::new(typed.expr), doubled);
        Some(Typed::scalar(kind, span, unit))
    }

    fn real_power(&mut self, base: Typed, exponent: &ast::Expr, span: Span) -> Option<Typed> {
        let exponent = self.scalar(exponent, "an exponent")?;
        let power = self.text(span);
        if let Some((above, below)) = exponent.expr.rational()
            && let Some(term) = base.unit.factor()
            && let Some(unit) = self.units.resolve(&term).unit().filter(|u| !u.is_pure())
            && let Some(unit) = unit.checked_pow(above, below)
        {
            let kind = ExprKind::RealPower(Box::new(base.expr), Box::new(exponent.expr));
            return Some(Typed::scalar(kind, span, UnitOf::of(unit)));
        }
        let pure = |what: &str| format!("the {what} of `{power}` must be a pure number");
        self.must_be(&base, &Term::one(), &pure("base"));
        self.must_be(&exponent, &Term::one(), &pure("exponent"));
        let kind = ExprKind::RealPower(Box::new(base.expr), Box::new(exponent.expr));
        Some(Typed::scalar(kind, span, UnitOf::of(Unit::ONE)))
    }

    /// Reports `5 m/s`, which parses as `(5 m)/s`, if `s` is no variable; returns whether it did.
    fn unit_in_pieces(&mut self, e: &ast::Expr) -> bool {
        if self.literal_with_units(e) != Some(true) {
            return false;
        }
        let text = self.text(e.span);
        let Some((digits, unit)) = text.split_once(' ') else {
            return false;
        };
        let message = format!("in an expression `{text}` is read as a product");
        let fault = Diagnostic::new(Kind::Grammar, e.span, message)
            .note("a number takes one unit there; several stand in square brackets")
            .help(format!("write `{digits} [{unit}]`"))
            .fix(e.span, format!("{digits} [{unit}]"));
        self.report(fault);
        true
    }

    /// For a literal times names of units, such as `5 m/s`, whether one of them is no variable.
    fn literal_with_units(&self, e: &ast::Expr) -> Option<bool> {
        match &e.kind {
            ast::ExprKind::Number(q) => q.unit.as_ref().map(|_| false),
            ast::ExprKind::Binary(BinaryOp::Mul | BinaryOp::Div | BinaryOp::Dot, a, b) => {
                let name = match &b.kind {
                    ast::ExprKind::Name(name) => name,
                    ast::ExprKind::Binary(BinaryOp::Pow, base, _) => match &base.kind {
                        ast::ExprKind::Name(name) => name,
                        _ => return None,
                    },
                    _ => return None,
                };
                symbol::find(name)?;
                Some(self.literal_with_units(a)? || self.scope.find(name).is_none())
            }
            _ => None,
        }
    }
}

/// Evaluates an expression of literals without units; `None` if it contains anything else.
fn constant(e: &ast::Expr) -> Option<f64> {
    match &e.kind {
        ast::ExprKind::Number(q) if q.unit.is_none() => q.number.text.parse().ok(),
        ast::ExprKind::Neg(of) => constant(of).map(|v| -v),
        ast::ExprKind::Binary(op, a, b) => {
            let (a, b) = (constant(a)?, constant(b)?);
            match op {
                BinaryOp::Add => Some(a + b),
                BinaryOp::Sub => Some(a - b),
                BinaryOp::Mul | BinaryOp::Dot | BinaryOp::Cross => Some(a * b),
                BinaryOp::Div => Some(a / b),
                BinaryOp::Pow => Some(a.powf(b)),
            }
        }
        _ => None,
    }
}
