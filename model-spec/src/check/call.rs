//! Type checking of function calls: number, shape and unit of the arguments, shape and unit of the result.

use super::term::{Fraction, Term};
use super::{Checker, Typed, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{ExprKind, Function, Shape};
use crate::syntax::ast;
use crate::unit::Unit;

/// Unit rule of a function of one scalar: permitted unit of the argument, and unit of the result.
#[derive(Clone, Copy)]
enum Rule {
    /// Argument: angle or dimensionless number; result: dimensionless number.
    OfNumber,
    /// Argument: dimensionless number; result: angle, rad.
    ToAngle,
    /// Argument: any unit; result: unit of the argument.
    Keeps,
    /// Argument: any unit; result: dimensionless number.
    Forgets,
    /// Argument: any unit; result: square root of the argument's unit.
    Root,
}

fn rule_of(function: Function) -> Rule {
    match function {
        Function::Asin | Function::Acos | Function::Atan => Rule::ToAngle,
        Function::Sqrt => Rule::Root,
        Function::Abs => Rule::Keeps,
        Function::Sign | Function::Step => Rule::Forgets,
        _ => Rule::OfNumber,
    }
}

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

impl Checker<'_> {
    pub fn call(&mut self, name: &ast::Name, arguments: &[ast::Expr], span: Span) -> Option<Typed> {
        let function = name.text.as_str();
        if let Some(function) = Function::named(function) {
            let [argument] = self.arguments(name, arguments, span, "one number")?;
            let what = format!("the argument of `{}`", name.text);
            let argument = self.scalar(argument, &what)?;
            return self.of_scalar(function, &what, argument, span);
        }
        if let Some(table) = self.scope.table(function) {
            let [argument] = self.arguments(name, arguments, span, "one number")?;
            let argument = self.scalar(argument, &format!("the argument of `{function}`"))?;
            return Some(self.call_of_table(table, argument, span));
        }
        match function {
            "norm" => {
                let [v] = self.arguments(name, arguments, span, "one vector")?;
                let (v, _) = self.vector(v, "the argument of `norm`")?;
                let unit = v.unit.clone();
                Some(Typed::new(
                    ExprKind::Norm(Box::new(v.expr)),
                    Shape::Scalar,
                    span,
                    unit,
                ))
            }
            "unit" => self.direction(name, arguments, span),
            "dot" | "cross" => {
                let [a, b] = self.arguments(name, arguments, span, "two vectors")?;
                let what = format!("an argument of `{function}`");
                let (a, b) = (self.vector(a, &what), self.vector(b, &what));
                let ((a, _), (b, _)) = (a?, b?);
                if function == "dot" {
                    self.dot(a, b, span)
                } else {
                    self.cross(a, b, span)
                }
            }
            "atan2" | "min" | "max" => {
                let [a, b] = self.arguments(name, arguments, span, "two numbers")?;
                let what = format!("an argument of `{function}`");
                let (a, b) = (self.scalar(a, &what), self.scalar(b, &what));
                self.of_two(function, a?, b?, span)
            }
            "ratio" => self.ratio(name, arguments, span),
            "in_frame_of" => self.in_frame_of(name, arguments, span),
            _ => match function.strip_prefix("in_") {
                Some(frame) if !frame.is_empty() => self.reexpress(frame, name, arguments, span),
                _ => self.unknown_function(name, span),
            },
        }
    }

    /// Converts the arguments of a call to an array; `None`, with an error reported, if their number is not `N`.
    /// `takes` describes the expected arguments.
    fn arguments<'e, const N: usize>(
        &mut self,
        name: &ast::Name,
        arguments: &'e [ast::Expr],
        span: Span,
        takes: &str,
    ) -> Option<[&'e ast::Expr; N]> {
        let found: Vec<&ast::Expr> = arguments.iter().collect();
        if let Ok(exact) = found.try_into() {
            return Some(exact);
        }
        let message = format!(
            "`{}` takes {takes}, but is given {}",
            name.text,
            match arguments.len() {
                0 => "none".to_owned(),
                1 => "only one".to_owned(),
                n => n.to_string(),
            }
        );
        self.report(Diagnostic::new(Kind::Shape, span, message));
        None
    }

    fn of_scalar(&mut self, function: Function, what: &str, a: Typed, span: Span) -> Option<Typed> {
        let rule = rule_of(function);
        let unit = match rule {
            Rule::OfNumber | Rule::ToAngle => {
                let out = if matches!(rule, Rule::ToAngle) {
                    Unit::RADIAN
                } else {
                    Unit::ONE
                };
                // The unit of the result does not depend on the argument.
                let should = match function {
                    Function::Sin | Function::Cos | Function::Tan => "an angle or a pure number",
                    _ => "a pure number",
                };
                self.must_be(&a, &Term::one(), &format!("{what} must be {should}"));
                UnitOf::of(out)
            }
            Rule::Forgets => UnitOf::of(Unit::ONE),
            Rule::Keeps => a.unit.clone(),
            Rule::Root => match a.unit.factor() {
                Some(term) => {
                    let root = term.power(Fraction::new(1, 2)?);
                    self.in_range(root, span)
                }
                None => UnitOf::Faulty,
            },
        };
        Some(Typed::new(
            ExprKind::Call(function, Box::new(a.expr)),
            Shape::Scalar,
            span,
            unit,
        ))
    }

    fn of_two(&mut self, function: &str, a: Typed, b: Typed, span: Span) -> Option<Typed> {
        let rule = format!("both arguments of `{function}` must have one unit");
        let both = [a, b];
        let unit = self.same_unit(&both, span, &rule);
        let [a, b] = both.map(|t| Box::new(t.expr));
        let (kind, unit) = match function {
            "atan2" => (ExprKind::Atan2(a, b), UnitOf::of(Unit::RADIAN)),
            "min" => (ExprKind::Min(a, b), unit),
            _ => (ExprKind::Max(a, b), unit),
        };
        Some(Typed::new(kind, Shape::Scalar, span, unit))
    }

    /// Elaborates (resolves and type-checks) `unit(v)` or `unit(v, otherwise)`: unit vector along `v`; `otherwise` is
    /// the value at the zero vector.
    fn direction(
        &mut self,
        name: &ast::Name,
        arguments: &[ast::Expr],
        span: Span,
    ) -> Option<Typed> {
        let what = "an argument of `unit`";
        let (v, otherwise) = match arguments {
            [v] => (self.vector(v, what)?.0, None),
            [v, otherwise] => {
                let (v, otherwise) = (self.vector(v, what), self.vector(otherwise, what));
                (v?.0, Some(otherwise?.0))
            }
            _ => {
                self.arguments::<1>(
                    name,
                    arguments,
                    span,
                    "a vector, and perhaps a second for where it is zero",
                )?;
                return None;
            }
        };
        let shape = v.expr.shape;
        let otherwise = match otherwise {
            Some(other) => {
                if other.expr.shape != shape {
                    self.same_shape(&[v, other], span)?;
                    return None;
                }
                let rule = "the direction to take where the first is zero must be a pure number";
                self.must_be(&other, &Term::one(), rule);
                Some(Box::new(other.expr))
            }
            None => None,
        };
        let kind = ExprKind::Direction(Box::new(v.expr), otherwise);
        Some(Typed::new(kind, shape, span, UnitOf::of(Unit::ONE)))
    }

    pub fn dot(&mut self, a: Typed, b: Typed, span: Span) -> Option<Typed> {
        self.one_frame(&a, &b, span)?;
        let unit = self.multiplied(&a.unit, &b.unit, Fraction::ONE, span);
        let kind = ExprKind::Dot(Box::new(a.expr), Box::new(b.expr));
        Some(Typed::new(kind, Shape::Scalar, span, unit))
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
                self.report(fault);
                None
            }
            _ => Some(()),
        }
    }

    /// Elaborates (resolves and type-checks) `ratio(a, b, otherwise)`: the quotient a / b, or `otherwise` where b is 0.
    fn ratio(&mut self, name: &ast::Name, arguments: &[ast::Expr], span: Span) -> Option<Typed> {
        let takes = "three numbers: above, below, and the value where the one below is 0";
        let [a, b, c] = self.arguments(name, arguments, span, takes)?;
        let what = "an argument of `ratio`";
        let (a, b, c) = (
            self.scalar(a, what),
            self.scalar(b, what),
            self.scalar(c, what),
        );
        let (a, b, c) = (a?, b?, c?);
        let quotient = self.multiplied(&a.unit, &b.unit, Fraction::new(-1, 1)?, span);
        let mut unit = quotient.clone();
        if let UnitOf::Term(expected) = &quotient {
            let should = self.described(expected);
            let rule = format!(
                "the third argument of `ratio`, its value where the second is 0, must be {should}"
            );
            let fits = self.must_be(&c, expected, &rule);
            if !fits {
                unit = UnitOf::Faulty;
            }
        }
        let kind = ExprKind::Ratio(Box::new([a.expr, b.expr, c.expr]));
        Some(Typed::new(kind, Shape::Scalar, span, unit))
    }

    /// Elaborates (resolves and type-checks) `in_F(v)`: the vector `v` with its components transformed to the frame F.
    fn reexpress(
        &mut self,
        frame: &str,
        name: &ast::Name,
        arguments: &[ast::Expr],
        span: Span,
    ) -> Option<Typed> {
        let frame = self.frame_named(frame, name.span);
        let [v] = self.arguments(name, arguments, span, "one vector")?;
        let what = format!("the argument of `{}`", name.text);
        let (v, from) = self.vector(v, &what)?;
        let frame = frame?;
        Some(reexpressed(v, from, frame, span))
    }

    /// Elaborates (resolves and type-checks) `in_frame_of(v, w)`: the vector `v` with its components transformed to the
    /// frame of `w`.
    fn in_frame_of(
        &mut self,
        name: &ast::Name,
        arguments: &[ast::Expr],
        span: Span,
    ) -> Option<Typed> {
        let [v, of] = self.arguments(name, arguments, span, "two vectors")?;
        let what = "an argument of `in_frame_of`";
        let (v, of) = (self.vector(v, what), self.vector(of, what));
        let ((v, from), (_, frame)) = (v?, of?);
        Some(reexpressed(v, from, frame, span))
    }

    fn unknown_function(&mut self, name: &ast::Name, span: Span) -> Option<Typed> {
        let text = name.text.as_str();
        let mut fault = Diagnostic::new(
            Kind::Name,
            name.span,
            format!("there is no function `{text}`"),
        );
        if self.scope.find(text).is_some() {
            fault = Diagnostic::new(
                Kind::Name,
                span,
                format!("`{text}` is a quantity, not a function"),
            )
            .help(format!("a product is written `{text}*(…)`"));
        } else if let Some((_, known)) = ALIASES.iter().find(|(alias, _)| *alias == text) {
            fault = fault.help(format!("it is written `{known}` here"));
        } else {
            let frames = self.model.frames.iter();
            let frames: Vec<String> = frames.map(|f| format!("in_{}", f.name)).collect();
            let tables = self.model.tables.iter().map(|t| t.name.as_str());
            let built_in = super::scope::function_names().map(|name| -> &str { name });
            let known = built_in
                .filter(|f| !["der", "diag"].contains(f))
                .chain(tables)
                .chain(frames.iter().map(String::as_str));
            fault = fault.did_you_mean(text, known);
        }
        self.report(fault);
        None
    }
}

/// Transforms the components of the vector `v` from the frame `from` to the frame `frame`.
fn reexpressed(v: Typed, from: usize, frame: usize, span: Span) -> Typed {
    if frame == from {
        return v;
    }
    let kind = ExprKind::Reexpress(Box::new(v.expr));
    Typed::new(kind, Shape::Vector(frame), span, v.unit)
}
