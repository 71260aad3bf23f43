//! Degrees where radians are expected, and radians where degrees are: the units of both agree, as both are pure numbers.

use std::f64::consts::{PI, TAU};

use super::term::Term;
use super::{Checker, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind};
use crate::model::{Expr, ExprKind, Function};
use crate::unit::Unit;

/// Degrees in a radian.
const DEGREES: f64 = 180.0 / PI;
/// Relative difference of a factor from [`DEGREES`], or of its inverse, that rounding to three digits leaves.
const ROUNDED: f64 = 1e-3;

impl Checker<'_> {
    /// Reports an argument that should be an angle in rad, and is plainly one in degrees.
    pub fn must_be_radians(&mut self, argument: &Typed, what: &str) {
        let span = argument.expr.span;
        let text = self.text(span);
        let (found, help) = if self.is_in_degrees(&argument.expr) {
            let help =
                "angles are in rad wherever they come from: leave the conversion to degrees out";
            (format!("`{text}` is in degrees"), help.to_owned())
        } else if let Some(value) = self.more_than_a_turn(&argument.expr) {
            let help = format!("state its unit: `{value} deg`, or `{value} rad` if that is meant");
            (format!("`{text}` is {value} without a unit"), help)
        } else {
            return;
        };
        let message = format!("{what} is an angle in rad, but {found}");
        self.report(Diagnostic::new(Kind::Unit, span, message).help(help));
    }

    /// Reports an angle in rad as argument of a table whose knots, without a unit, reach beyond a turn.
    pub fn must_not_be_radians(
        &mut self,
        argument: &Typed,
        (table, at): (usize, usize),
        what: &str,
    ) {
        let of = &self.model.tables[table].arguments[at];
        let is_angle = |unit: &UnitOf| match unit {
            UnitOf::Term(term) => self.known(term) == Some(Unit::RADIAN),
            _ => false,
        };
        let ends = [of.knots.first(), of.knots.last()].map(|knot| knot.copied().unwrap_or(0.0));
        let is_within = ends.iter().all(|knot| knot.abs() <= TAU);
        if of.unit != Unit::ONE || is_within || !is_angle(&argument.unit) {
            return;
        }
        if self.is_in_degrees(&argument.expr) {
            return;
        }
        let span = argument.expr.span;
        let [first, last] = ends;
        let message = format!(
            "{what} has knots from {first} to {last} without a unit, but `{}` is an angle in rad",
            self.text(span)
        );
        let name = &of.name;
        self.report(Diagnostic::new(Kind::Unit, span, message).help(format!(
            "declare `{name}: deg`, and the knots are converted; or `{name}: rad` if they are in rad"
        )));
    }

    fn known(&self, term: &Term) -> Option<Unit> {
        self.units.resolve(term).unit()
    }

    /// Whether an expression converts an angle to degrees: by `180/pi`, or by `1 deg` as a divisor.
    fn is_in_degrees(&self, e: &Expr) -> bool {
        match &e.kind {
            ExprKind::AuxVariable(index) => {
                self.is_in_degrees(&self.model.aux_variables[*index].value)
            }
            ExprKind::Neg(of) => self.is_in_degrees(of),
            ExprKind::Div(_, by)
                if matches!(&by.kind, ExprKind::Number { value, .. } if is_near(*value * DEGREES, 1.0))
                    && by.unit == Unit::RADIAN =>
            {
                true
            }
            ExprKind::Mul(..) | ExprKind::Div(..) => {
                let (mut factor, mut others) = (1.0, Vec::new());
                constant_factors(e, false, &mut factor, &mut others);
                let [only] = others[..] else {
                    return false;
                };
                is_near(factor.abs(), DEGREES) && self.is_in_radians(only)
            }
            _ => false,
        }
    }

    fn is_in_radians(&self, e: &Expr) -> bool {
        let term = match &e.kind {
            ExprKind::Neg(of) => return self.is_in_radians(of),
            ExprKind::Atan2(..) => return true,
            ExprKind::Call(Function::Asin | Function::Acos | Function::Atan, _) => return true,
            kind => self.declared(kind).and_then(|(.., term)| term),
        };
        term.is_some_and(|term| self.known(term) == Some(Unit::RADIAN))
    }

    /// Value of a number, parameter or coefficient without a unit that is more than a turn in rad.
    fn more_than_a_turn(&self, e: &Expr) -> Option<f64> {
        let (value, unit) = match &e.kind {
            ExprKind::Number { value, .. } => (*value, Some(e.unit)),
            ExprKind::Neg(of) => return self.more_than_a_turn(of).map(|value| -value),
            ExprKind::Param(index) if !self.model.params[*index].varies => (
                self.model.params[*index].value,
                self.known(&self.params[*index]),
            ),
            ExprKind::Coefficient(index) => {
                let value = self.model.coefficients[*index].value;
                (value, self.known(&self.coefficients[*index]))
            }
            _ => return None,
        };
        (unit == Some(Unit::ONE) && value.abs() > TAU).then_some(value)
    }
}

/// Multiplies `factor` by the numbers of a product, and appends what it has beside them.
fn constant_factors<'e>(
    e: &'e Expr,
    is_divisor: bool,
    factor: &mut f64,
    others: &mut Vec<&'e Expr>,
) {
    let mut times = |value: f64| match is_divisor {
        true => *factor /= value,
        false => *factor *= value,
    };
    match &e.kind {
        ExprKind::Number { value, .. } if e.unit == Unit::ONE => times(*value),
        ExprKind::Pi => times(PI),
        ExprKind::Mul(a, b) => {
            constant_factors(a, is_divisor, factor, others);
            constant_factors(b, is_divisor, factor, others);
        }
        ExprKind::Div(a, b) => {
            constant_factors(a, is_divisor, factor, others);
            constant_factors(b, !is_divisor, factor, others);
        }
        _ => others.push(e),
    }
}

fn is_near(value: f64, expected: f64) -> bool {
    (value / expected - 1.0).abs() <= ROUNDED
}
