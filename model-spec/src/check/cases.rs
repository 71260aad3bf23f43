//! Limits of a model and its check cases.

use std::collections::HashMap;

use super::quantity::Measure;
use super::scope::Symbol;
use super::term::Term;
use super::{Checker, Definition, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{
    self, CheckCase, Expectation, Expr, ExprKind, FrameKind, Function, Observable, Shape, Target,
};
use crate::syntax::ast::{self, CheckPart, ItemKind, Name, Number, UnitExpr};
use crate::unit::Unit;

/// How near to zero the cosine (or sine) of the middle angle may come where the model does not say.
const GIMBAL: f64 = 0.01;

/// Every divisor is compared with every limit.
const MOST_LIMITS: usize = 100;

impl Checker<'_> {
    /// The limits that are stated, and the one that angles of attitude need.
    pub fn limits(&mut self) {
        let file = self.file;
        for item in &file.items {
            let ItemKind::Limit(limit) = &item.kind else {
                continue;
            };
            if self.model.limits.len() >= MOST_LIMITS {
                let message = format!("a model has at most {MOST_LIMITS} limits");
                self.report(Diagnostic::new(Kind::Limit, limit.value.span, message));
                break;
            }
            let Some(typed) = self.scalar(&limit.value, "what is limited") else {
                continue;
            };
            let measure = match &limit.bound.unit {
                Some(unit) => match self.measure(unit) {
                    Some(measure) => measure,
                    None => continue,
                },
                None => Measure::one(),
            };
            let (bound, _) = measure.of(&limit.bound.number);
            // A bare 0 fits every unit.
            if (limit.bound.unit.is_some() || bound != 0.0)
                && let UnitOf::Term(found) = &typed.unit
                && self
                    .units
                    .equate(found, &Term::known(measure.unit), limit.bound.span)
                    .is_err()
            {
                let text = self.text(limit.value.span);
                let (is, other) = (
                    self.described(found),
                    self.described(&Term::known(measure.unit)),
                );
                let message = format!("`{text}` is {is}, but its bound is {other}");
                let fault =
                    Diagnostic::new(Kind::Unit, limit.value.span.to(limit.bound.span), message)
                        .label(limit.value.span, is)
                        .label(limit.bound.span, other);
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

    /// Three angles have a singular attitude, where the first and the last turn about one axis.
    fn attitude_limit(&mut self) {
        let Some(rotation) = self.model.body.as_ref().and_then(|b| b.rotation.as_ref()) else {
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
        let mut angle = super::elaborate::node(ExprKind::State(b), Shape::Scalar, span);
        angle.unit = Unit::RADIAN;
        let value = super::elaborate::node(
            ExprKind::Call(function, Box::new(angle)),
            Shape::Scalar,
            span,
        );
        if self
            .model
            .limits
            .iter()
            .any(|l| l.bound >= 0.0 && l.value.same(&value))
        {
            return;
        }
        let name = |i: usize| self.model.states[i].name.clone();
        let reason = format!("{} and {} turn about one axis", name(a), name(c));
        self.model.limits.push(model::ValidityLimit {
            value,
            bound: GIMBAL,
            reason,
            span,
        });
    }

    /// The check cases.
    pub fn cases(&mut self) {
        let file = self.file;
        let mut titles: HashMap<&str, Span> = HashMap::new();
        for item in &file.items {
            let ItemKind::Check(check) = &item.kind else {
                continue;
            };
            let span = Span {
                end: item.span.start + "check".len() as u32,
                ..item.span
            };
            if let Some(&first) = titles.get(check.title.as_str()) {
                self.second(&format!("check \"{}\"", check.title), first, span);
            }
            titles.insert(&check.title, span);
            let mut case = CheckCase {
                title: check.title.clone(),
                settings: Vec::new(),
                expectations: Vec::new(),
                span,
            };
            for part in &check.parts {
                match part {
                    CheckPart::Set {
                        name,
                        value,
                        unit,
                        span,
                    } => {
                        if let Some(settings) = self.setting(name, value, unit.as_ref(), *span) {
                            case.settings.extend(settings);
                        }
                    }
                    CheckPart::Expect {
                        name,
                        derivative,
                        value,
                        within,
                        span,
                    } => {
                        case.expectations.extend(self.expectation(
                            name,
                            *derivative,
                            value,
                            within,
                            *span,
                        ));
                    }
                }
            }
            self.model.checks.push(case);
        }
    }

    fn setting(
        &mut self,
        name: &Name,
        value: &[Number],
        unit: Option<&UnitExpr>,
        span: Span,
    ) -> Option<Vec<(Target, f64)>> {
        let (targets, expected): (Vec<Target>, Term) = match self.scope.find(&name.text) {
            Some(Symbol::Param(i)) => (vec![Target::Param(i)], self.params[i].clone()),
            Some(Symbol::Coefficient(i)) => {
                (vec![Target::Coefficient(i)], self.coefficients[i].clone())
            }
            Some(Symbol::State(i)) => (vec![Target::State(i)], self.states[i].clone()),
            Some(Symbol::InputPart(i, part)) => (
                vec![Target::Input(i, usize::from(part) - 1)],
                self.inputs[i].clone(),
            ),
            Some(Symbol::Input(i)) => (
                (0..3).map(|k| Target::Input(i, k)).collect(),
                self.inputs[i].clone(),
            ),
            Some(Symbol::Let(_) | Symbol::Marker) => {
                let message = format!("`{}` is computed and cannot be set", name.text);
                let declared = self.scope.place(&name.text).unwrap_or(name.span);
                let fault = Diagnostic::new(Kind::Name, name.span, message)
                    .label(declared, "declared here");
                self.report(fault.help("set parameters, coefficients, inputs and states"));
                return None;
            }
            None => {
                self.nothing_named(name, "parameter, coefficient, input or state");
                return None;
            }
        };
        if targets.len() != value.len() {
            let message = match targets.len() {
                1 => format!("`{}` is a number, but this is a vector", name.text),
                _ => format!("`{}` is a vector, but this is a number", name.text),
            };
            let help = match targets.len() {
                1 => format!("write `set {} = 1;`, with its unit", name.text),
                _ => format!(
                    "write `set {0} = (0, 0, 0);`, with its unit, or set `{0}_x`",
                    name.text
                ),
            };
            self.report(Diagnostic::new(Kind::Shape, span, message).help(help));
            return None;
        }
        let measure = match unit {
            Some(unit) => self.measure(unit)?,
            None => Measure::one(),
        };
        let zero = unit.is_none() && value.iter().all(|n| measure.of(n).0 == 0.0);
        if !zero {
            self.agrees(&name.text, &measure, &expected, span);
        }
        Some(
            targets
                .into_iter()
                .zip(value)
                .map(|(t, n)| (t, measure.of(n).0))
                .collect(),
        )
    }

    /// Reports a number whose unit is not that of the quantity it is for.
    fn agrees(&mut self, name: &str, measure: &Measure, expected: &Term, span: Span) -> bool {
        let expected = self.units.resolve(expected);
        let Some(unit) = expected.unit() else {
            return true;
        };
        if unit.agrees(measure.unit) {
            return true;
        }
        let declared = self.scope.place(name).unwrap_or(span);
        let is = self.described(&expected);
        let found = self.described(&Term::known(measure.unit));
        let message = format!("`{name}` is {is}, but this is {found}");
        let fault =
            Diagnostic::new(Kind::Unit, span, message).label(declared, format!("`{name}` is {is}"));
        self.report(fault.help(format!("give the number the unit `{}`", unit.tidy())));
        false
    }

    fn expectation(
        &mut self,
        name: &Name,
        derivative: bool,
        value: &ast::Quantity,
        within: &ast::Quantity,
        span: Span,
    ) -> Option<Expectation> {
        let (what, expected, said) = if derivative {
            let Some(Symbol::State(i)) = self.scope.find(&name.text) else {
                self.no_state(name);
                return None;
            };
            let per_second = super::term::Fraction::new(-1, 1)
                .and_then(|p| self.states[i].times_power(&Term::known(Unit::SECOND), p))?;
            (
                Observable::Derivative(i),
                per_second,
                format!("der({})", name.text),
            )
        } else {
            match self.scope.find(&name.text) {
                Some(Symbol::Let(i)) => match self.definitions.get(i)?.clone() {
                    Definition::Missing => return None,
                    Definition::Done(_, Shape::Vector(_), _) => {
                        let message = format!(
                            "`{}` is a vector; what is expected must be a number",
                            name.text
                        );
                        let help = format!("name a component: `let {0}_1 = {0}.1;`", name.text);
                        self.report(Diagnostic::new(Kind::Shape, name.span, message).help(help));
                        return None;
                    }
                    Definition::Done(index, _, unit) => {
                        let UnitOf::Term(unit) = unit else {
                            return None;
                        };
                        (Observable::AuxVariable(index), unit, name.text.clone())
                    }
                },
                Some(Symbol::State(_)) => {
                    let message = format!("`{}` is a state, and is what it was set to", name.text);
                    let help = format!("expect its derivative: `expect der({}) = …`", name.text);
                    self.report(Diagnostic::new(Kind::Name, name.span, message).help(help));
                    return None;
                }
                Some(_) => {
                    let message = format!("`{}` is given, not computed", name.text);
                    let fault = Diagnostic::new(Kind::Name, name.span, message);
                    self.report(
                        fault.help("expect a quantity that is named with `let`, or `der(state)`"),
                    );
                    return None;
                }
                None => {
                    self.nothing_named(name, "quantity");
                    return None;
                }
            }
        };
        let measure = match &value.unit {
            Some(unit) => self.measure(unit)?,
            None => Measure::one(),
        };
        let tolerance = match &within.unit {
            Some(unit) => self.measure(unit)?,
            None => measure.clone(),
        };
        let (expected_value, _) = measure.of(&value.number);
        let (allowed, _) = tolerance.of(&within.number);
        if value.unit.is_some() || expected_value != 0.0 {
            self.agrees_said(&said, name, &measure, &expected, value.span)?;
        }
        if within.unit.is_some() {
            self.agrees_said(&said, name, &tolerance, &expected, within.span)?;
        }
        if allowed < 0.0 {
            let message = "the greatest difference cannot be negative";
            self.report(Diagnostic::new(Kind::Value, within.span, message));
            return None;
        }
        Some(Expectation {
            what,
            value: expected_value,
            within: allowed,
            span,
        })
    }

    fn agrees_said(
        &mut self,
        said: &str,
        name: &Name,
        measure: &Measure,
        expected: &Term,
        span: Span,
    ) -> Option<()> {
        let expected = self.units.resolve(expected);
        let Some(unit) = expected.unit() else {
            return Some(());
        };
        if unit.agrees(measure.unit) {
            return Some(());
        }
        let is = self.described(&expected);
        let found = self.described(&Term::known(measure.unit));
        let mut fault = Diagnostic::new(
            Kind::Unit,
            span,
            format!("`{said}` is {is}, but this is {found}"),
        );
        if let Some(declared) = self.scope.place(&name.text) {
            fault = fault.label(declared, format!("`{}` is declared here", name.text));
        }
        self.report(fault.help(format!("give the number the unit `{}`", unit.tidy())));
        None
    }

    fn nothing_named(&mut self, name: &Name, what: &str) {
        let fault = Diagnostic::new(
            Kind::Name,
            name.span,
            format!("there is no {what} `{}`", name.text),
        );
        let near = self
            .nearest(&name.text)
            .map(|near| format!("did you mean `{near}`?"));
        self.report(fault.help_if(near));
    }

    /// Whether an expression is one that a limit keeps above a bound of 0 or more.
    pub fn limited(&self, e: &Expr) -> bool {
        super::singular::limited(&self.model, e)
    }
}
