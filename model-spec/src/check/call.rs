//! Type checking of function calls: number, shape and unit of the arguments, shape and unit of the result.

use super::term::{Fraction, Term};
use super::{Checker, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{ExprKind, Function, Shape};
use crate::syntax::ast;
use crate::unit::Unit;

/// Names of functions in other languages (`arcsin`), each with the name in this language (`asin`), for suggestions.
const ALIASES: [(&str, &str); 12] = [
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("arctan", "atan"),
    ("arctan2", "atan2"),
    ("ln", "log"),
    ("magnitude", "norm"),
    ("length", "norm"),
    ("normalize", "unit"),
    ("direction", "unit"),
    ("pow", "^"),
    ("heaviside", "step"),
    ("sgn", "sign"),
];

#[derive(Clone, Copy)]
pub(super) struct Call<'e> {
    pub(super) name: &'e ast::Name,
    pub(super) arguments: &'e [ast::Expr],
    pub(super) span: Span,
}

impl Checker<'_> {
    pub fn call(&mut self, name: &ast::Name, arguments: &[ast::Expr], span: Span) -> Option<Typed> {
        let function = name.text.as_str();
        let call = Call {
            name,
            arguments,
            span,
        };
        if let Some(function) = Function::named(function) {
            return self.of_scalar(function, call);
        }
        if let Some(table) = self.scope.table(function) {
            return self.call_of_table(table, call);
        }
        if self.scope.has_function(function)
            && let Some(function) = self.declared_function(function)
        {
            return self.call_of_function(function, arguments, span);
        }
        match function {
            "norm" => {
                let [v] = self.arguments(call, "one vector")?;
                let (v, _) = self.vector(v, "the argument of `norm`")?;
                let kind = ExprKind::Norm(Box::new(v.expr));
                Some(Typed::scalar(kind, span, v.unit))
            }
            "unit" => self.direction(call),
            "dot" | "cross" => {
                let [a, b] = self.arguments(call, "two vectors")?;
                let what = format!("an argument of `{function}`");
                let (a, b) = (self.vector(a, &what), self.vector(b, &what));
                let ((a, _), (b, _)) = (a?, b?);
                if function == "dot" {
                    self.dot(a, b, span)
                } else {
                    self.cross(a, b, span)
                }
            }
            "atan2" | "min" | "max" => self.of_two(function, call),
            "ratio" => self.ratio(call),
            "der" => {
                let [of] = self.arguments(call, "one number or vector")?;
                self.rate(of, span)
            }
            "partial" => {
                let own = self.arguments(call, "a number and a state")?;
                self.partial(own, span)
            }
            "in_frame_of" => self.in_frame_of(call),
            _ => match function.strip_prefix("in_") {
                Some(frame) if !frame.is_empty() => self.reexpress(frame, call),
                _ => self.unknown_function(name, span),
            },
        }
    }

    /// Arguments of a call, reported if their number is not `N`; `takes` describes those expected.
    pub fn arguments<'e, const N: usize>(
        &mut self,
        call: Call<'e>,
        takes: &str,
    ) -> Option<[&'e ast::Expr; N]> {
        let found: Vec<&ast::Expr> = call.arguments.iter().collect();
        if let Ok(exact) = found.try_into() {
            return Some(exact);
        }
        let given = match call.arguments.len() {
            0 => "none".to_owned(),
            1 => "only one".to_owned(),
            n => n.to_string(),
        };
        let message = format!("`{}` takes {takes}, but is given {given}", call.name.text);
        self.refuse(Diagnostic::new(Kind::Shape, call.span, message))
    }

    fn of_scalar(&mut self, function: Function, call: Call<'_>) -> Option<Typed> {
        let [argument] = self.arguments(call, "one number")?;
        let what = format!("the argument of `{}`", call.name.text);
        let a = self.scalar(argument, &what)?;
        let unit = match function {
            Function::Abs => a.unit.clone(),
            Function::Sign | Function::Step => UnitOf::of(Unit::ONE),
            Function::Sqrt => self.powered(&a.unit, Fraction::new(1, 2)?, call.span),
            _ => {
                // The unit of the result does not depend on the argument.
                let should = match function {
                    Function::Sin | Function::Cos | Function::Tan => "an angle or a pure number",
                    _ => "a pure number",
                };
                self.must_be(&a, &Term::one(), &format!("{what} must be {should}"));
                if let Function::Sin | Function::Cos | Function::Tan = function {
                    self.must_be_radians(&a, &what);
                }
                UnitOf::of(match function {
                    Function::Asin | Function::Acos | Function::Atan => Unit::RADIAN,
                    _ => Unit::ONE,
                })
            }
        };
        let kind = ExprKind::Call(function, Box::new(a.expr));
        Some(Typed::scalar(kind, call.span, unit))
    }

    fn of_two(&mut self, function: &str, call: Call<'_>) -> Option<Typed> {
        let [a, b] = self.arguments(call, "two numbers")?;
        let what = format!("an argument of `{function}`");
        let (a, b) = (self.scalar(a, &what), self.scalar(b, &what));
        let rule = format!("both arguments of `{function}` must have one unit");
        let both = [a?, b?];
        let unit = self.same_unit(&both, call.span, &rule);
        let [a, b] = both.map(|t| Box::new(t.expr));
        let (kind, unit) = match function {
            "atan2" => (ExprKind::Atan2(a, b), UnitOf::of(Unit::RADIAN)),
            "min" => (ExprKind::Min(a, b), unit),
            _ => (ExprKind::Max(a, b), unit),
        };
        Some(Typed::scalar(kind, call.span, unit))
    }

    fn direction(&mut self, call: Call<'_>) -> Option<Typed> {
        let what = "an argument of `unit`";
        let (v, otherwise) = match call.arguments {
            [v] => (self.vector(v, what)?.0, None),
            [v, otherwise] => {
                let (v, otherwise) = (self.vector(v, what), self.vector(otherwise, what));
                (v?.0, Some(otherwise?.0))
            }
            _ => {
                let takes = "a vector, and perhaps a second for where it is zero";
                self.arguments::<1>(call, takes)?;
                return None;
            }
        };
        let shape = v.expr.shape;
        if let Some(other) = &otherwise {
            if other.expr.shape != shape {
                self.same_shape(&[v, other.clone()], call.span)?;
                return None;
            }
            let rule = "the direction to take where the first is zero must be a pure number";
            self.must_be(other, &Term::one(), rule);
        }
        let otherwise = otherwise.map(|other| Box::new(other.expr));
        let kind = ExprKind::Direction(Box::new(v.expr), otherwise);
        let unit = UnitOf::of(Unit::ONE);
        Some(Typed::new(kind, shape, call.span, unit))
    }

    pub fn dot(&mut self, a: Typed, b: Typed, span: Span) -> Option<Typed> {
        self.one_frame(&a, &b, span)?;
        let unit = self.multiplied(&a.unit, &b.unit, Fraction::ONE, span);
        let kind = ExprKind::Dot(Box::new(a.expr), Box::new(b.expr));
        Some(Typed::scalar(kind, span, unit))
    }

    pub fn cross(&mut self, a: Typed, b: Typed, span: Span) -> Option<Typed> {
        self.one_frame(&a, &b, span)?;
        let unit = self.multiplied(&a.unit, &b.unit, Fraction::ONE, span);
        let shape = a.expr.shape;
        let kind = ExprKind::Cross(Box::new(a.expr), Box::new(b.expr));
        Some(Typed::new(kind, shape, span, unit))
    }

    fn one_frame(&mut self, a: &Typed, b: &Typed, span: Span) -> Option<()> {
        match (a.expr.shape, b.expr.shape) {
            (Shape::Vector(f), Shape::Vector(g)) if f != g => {
                let fault = self.different_frames(a, f, b, g, span);
                self.refuse(fault)
            }
            _ => Some(()),
        }
    }

    /// Elaborates `ratio(a, b, otherwise)`: the quotient a / b, or `otherwise` where b is 0.
    fn ratio(&mut self, call: Call<'_>) -> Option<Typed> {
        let takes = "three numbers: above, below, and the value where the one below is 0";
        let parts: [&ast::Expr; 3] = self.arguments(call, takes)?;
        let [a, b, c] = parts.map(|part| self.scalar(part, "an argument of `ratio`"));
        let (a, b, c) = (a?, b?, c?);
        let mut unit = self.multiplied(&a.unit, &b.unit, Fraction::MINUS_ONE, call.span);
        if let UnitOf::Term(expected) = &unit {
            let should = self.described(expected);
            let rule = format!(
                "the third argument of `ratio`, its value where the second is 0, must be {should}"
            );
            if !self.must_be(&c, expected, &rule) {
                unit = UnitOf::Faulty;
            }
        }
        let kind = ExprKind::Ratio(Box::new([a.expr, b.expr, c.expr]));
        Some(Typed::scalar(kind, call.span, unit))
    }

    fn reexpress(&mut self, frame: &str, call: Call<'_>) -> Option<Typed> {
        let frame = self.frame_named(frame, call.name.span);
        let [v] = self.arguments(call, "one vector")?;
        let what = format!("the argument of `{}`", call.name.text);
        let (v, from) = self.vector(v, &what)?;
        Some(reexpressed(v, from, frame?, call.span))
    }

    /// Elaborates `in_frame_of(v, w)`: the vector `v` with its components transformed to the frame of `w`.
    fn in_frame_of(&mut self, call: Call<'_>) -> Option<Typed> {
        let [v, of] = self.arguments(call, "two vectors")?;
        let what = "an argument of `in_frame_of`";
        let (v, of) = (self.vector(v, what), self.vector(of, what));
        let ((v, from), (_, frame)) = (v?, of?);
        Some(reexpressed(v, from, frame, call.span))
    }

    fn unknown_function(&mut self, name: &ast::Name, span: Span) -> Option<Typed> {
        let text = name.text.as_str();
        let message = format!("there is no function `{text}`");
        let mut fault = Diagnostic::new(Kind::Name, name.span, message);
        if self.scope.find(text).is_some() {
            let message = format!("`{text}` is a quantity, not a function");
            fault = Diagnostic::new(Kind::Name, span, message);
            fault = fault.help(format!("a product is written `{text}*(…)`"));
        } else if let Some((_, known)) = ALIASES.iter().find(|(alias, _)| *alias == text) {
            fault = fault.help(format!("it is written `{known}` here"));
            if *known != "^" {
                fault = fault.fix(name.span, *known);
            }
        } else {
            let frames = self.model.frames.iter();
            let frames: Vec<String> = frames.map(|f| format!("in_{}", f.name)).collect();
            let tables = self.model.tables.iter().map(|t| t.name.as_str());
            let functions = self.declared_functions();
            let tables = tables.chain(functions.map(|own| own.name.text.as_str()));
            let built_in = super::scope::function_names().map(|name| -> &str { name });
            let known = built_in
                .filter(|f| !["der", "diag"].contains(f))
                .chain(tables)
                .chain(frames.iter().map(String::as_str));
            fault = fault.did_you_mean(text, known);
        }
        self.refuse(fault)
    }
}

fn reexpressed(v: Typed, from: usize, frame: usize, span: Span) -> Typed {
    if frame == from {
        return v;
    }
    let kind = ExprKind::Reexpress(Box::new(v.expr));
    Typed::new(kind, Shape::Vector(frame), span, v.unit)
}
