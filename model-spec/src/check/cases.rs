//! Semantic checks of `check` blocks: values to set and expected results.

use std::collections::HashMap;

use super::quantity::Measure;
use super::scope::Symbol;
use super::term::Term;
use super::{Checker, Definition, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{CheckCase, Expectation, Observable, Shape, Target};
use crate::syntax::ast::{self, CheckPart, ItemKind, Name, Number, UnitExpr};
use crate::syntax::case::derivatives_advice;
use crate::unit::Unit;

impl Checker<'_> {
    pub fn cases(&mut self) {
        let file = self.file;
        let mut titles: HashMap<&str, Span> = HashMap::new();
        for item in &file.items {
            let ItemKind::Check(check) = &item.kind else {
                continue;
            };
            let span = item.span.first_bytes("check".len() as u32);
            if let Some(&first) = titles.get(check.title.as_str()) {
                self.second(&format!("check \"{}\"", check.title), first, span);
            }
            titles.insert(&check.title, span);
            let (mut settings, mut expectations) = (Vec::new(), Vec::new());
            let is_expectation = |part: &CheckPart| matches!(part, CheckPart::Expect { .. });
            if !check.parts.iter().any(is_expectation) {
                let fault = Diagnostic::new(Kind::Missing, span, "the case expects nothing");
                self.report(fault.help("state `expect NAME = VALUE within ERROR;`"));
            }
            let mut set: HashMap<&str, Span> = HashMap::new();
            for part in &check.parts {
                match part {
                    CheckPart::Set {
                        name,
                        value,
                        unit,
                        span,
                    } => {
                        if let Some(first) = set.insert(&name.text, *span) {
                            self.second(&format!("set {}", name.text), first, *span);
                        }
                        let setting = self.setting(name, value, unit.as_ref(), *span);
                        settings.extend(setting.into_iter().flatten());
                    }
                    CheckPart::Expect {
                        name,
                        derivative,
                        value,
                        within,
                        is_relative,
                        span,
                    } => {
                        let observable = if *derivative {
                            self.expected_derivative(name)
                        } else {
                            self.expected_quantity(name)
                        };
                        let expectation = observable
                            .and_then(|o| self.expectation(o, name, value, within, *span));
                        expectations.extend(expectation.and_then(|own| {
                            if *is_relative {
                                self.relative(own, within)
                            } else {
                                Some(own)
                            }
                        }));
                    }
                }
            }
            self.model.checks.push(CheckCase {
                title: check.title.clone(),
                settings,
                expectations,
            });
        }
    }

    /// Checks `set NAME = value;`; returns pairs of target and SI value, one per component.
    fn setting(
        &mut self,
        name: &Name,
        value: &[Number],
        unit: Option<&UnitExpr>,
        span: Span,
    ) -> Option<Vec<(Target, f64)>> {
        let (targets, expected) = self.targets(name)?;
        if targets.len() != value.len() {
            return self.refuse(wrong_shape(&name.text, targets.len() == 1, span));
        }
        let measure = self.measure_or_one(unit)?;
        let is_bare_zero = unit.is_none() && value.iter().all(|n| measure.of(n).0 == 0.0);
        if !is_bare_zero {
            let label = |is: &str| format!("`{}` is {is}", name.text);
            self.agrees(name, &name.text, &measure, &expected, span, label);
        }
        let values = value.iter().map(|number| measure.of(number).0);
        Some(targets.into_iter().zip(values).collect())
    }

    fn targets(&mut self, name: &Name) -> Option<(Vec<Target>, Term)> {
        let Some(symbol) = self.scope.find(&name.text) else {
            self.nothing_named(name, "parameter, coefficient, input, state or marker");
            return None;
        };
        let targets = match symbol {
            Symbol::Param(i) => vec![Target::Param(i)],
            Symbol::Coefficient(i) => vec![Target::Coefficient(i)],
            Symbol::State(i) => vec![Target::State(i)],
            Symbol::InputPart(i, part) => vec![Target::Input(i, usize::from(part) - 1)],
            Symbol::Input(i) => (0..3).map(|k| Target::Input(i, k)).collect(),
            Symbol::Marker => (0..3).map(Target::Marker).collect(),
            Symbol::Let(_) | Symbol::Unknown(_) => {
                let message = format!("`{}` is computed and cannot be set", name.text);
                let declared = self.scope.place(&name.text).unwrap_or(name.span);
                let fault = Diagnostic::new(Kind::Name, name.span, message)
                    .label(declared, "declared here");
                return self.refuse(
                    fault.help("set parameters, coefficients, inputs, states and the marker"),
                );
            }
        };
        match self.unit_of_symbol(symbol)? {
            UnitOf::Term(unit) => Some((targets, unit)),
            UnitOf::Zero | UnitOf::Faulty => None,
        }
    }

    fn expected_derivative(&mut self, name: &Name) -> Option<Expected> {
        let Some(Symbol::State(i)) = self.scope.find(&name.text) else {
            if let Some(states) = self.states_of_body(&name.text) {
                let message = format!(
                    "`der({})` is a vector; what is expected must be a number",
                    name.text
                );
                let fault = Diagnostic::new(Kind::Shape, name.span, message);
                let help = derivatives_advice(&states);
                return self.refuse(fault.help(help));
            }
            self.no_state(name);
            return None;
        };
        Some(Expected {
            observable: Observable::Derivative(i),
            unit: self.unit_of_rate(i)?,
            text: format!("der({})", name.text),
        })
    }

    fn expected_quantity(&mut self, name: &Name) -> Option<Expected> {
        let (message, help) = match self.scope.find(&name.text) {
            Some(symbol @ (Symbol::Let(_) | Symbol::Unknown(_))) => match self.defined(symbol)? {
                Definition::Done(index, Shape::Scalar, UnitOf::Term(unit)) => {
                    return Some(Expected {
                        observable: Observable::AuxVariable(index),
                        unit,
                        text: name.text.clone(),
                    });
                }
                Definition::Done(_, Shape::Vector(_), _) => {
                    let text = &name.text;
                    let message =
                        format!("`{text}` is a vector; what is expected must be a number");
                    let help = format!("name a component: `let {0}_1 = {0}.1;`", name.text);
                    return self
                        .refuse(Diagnostic::new(Kind::Shape, name.span, message).help(help));
                }
                Definition::Done(..) | Definition::Missing => return None,
            },
            Some(Symbol::State(_)) => (
                format!("`{}` is a state, and is what it was set to", name.text),
                format!("expect its derivative: `expect der({}) = …`", name.text),
            ),
            Some(_) => (
                format!("`{}` is given, not computed", name.text),
                "expect a quantity that is named with `let`, or `der(state)`".to_owned(),
            ),
            None => {
                self.nothing_named(name, "quantity");
                return None;
            }
        };
        self.refuse(Diagnostic::new(Kind::Name, name.span, message).help(help))
    }

    fn expectation(
        &mut self,
        expected: Expected,
        name: &Name,
        value: &ast::Quantity,
        within: &ast::Quantity,
        span: Span,
    ) -> Option<Expectation> {
        let measure = self.measure_or_one(value.unit.as_ref())?;
        let tolerance = match &within.unit {
            Some(unit) => self.measure(unit)?,
            None => measure.clone(),
        };
        let (number, _) = measure.of(&value.number);
        let (allowed, _) = tolerance.of(&within.number);
        let mut stated = Vec::new();
        if value.unit.is_some() || number != 0.0 {
            stated.push((&measure, value.span));
        }
        if within.unit.is_some() {
            stated.push((&tolerance, within.span));
        }
        let label = |_: &str| format!("`{}` is declared here", name.text);
        for (measure, span) in stated {
            if !self.agrees(name, &expected.text, measure, &expected.unit, span, label) {
                return None;
            }
        }
        if allowed < 0.0 {
            let message = "the greatest difference cannot be negative";
            return self.refuse(Diagnostic::new(Kind::Value, within.span, message));
        }
        Some(Expectation {
            what: expected.observable,
            value: number,
            within: allowed,
            span,
        })
    }

    /// An expectation whose tolerance is a part of the expected value.
    fn relative(&mut self, mut own: Expectation, within: &ast::Quantity) -> Option<Expectation> {
        if let Some(unit) = &within.unit {
            let message = "a tolerance relative to the expected value is a pure number";
            let fault = Diagnostic::new(Kind::Unit, unit.span, message);
            return self.refuse(fault.help("leave out its unit, or `relative`"));
        }
        if own.value == 0.0 {
            let message = "no tolerance is relative to an expected value of 0";
            let fault = Diagnostic::new(Kind::Value, within.span, message);
            return self.refuse(fault.help("state the greatest difference, without `relative`"));
        }
        let part = Measure::one().of(&within.number).0;
        own.within = part * own.value.abs();
        Some(own)
    }

    /// [`Checker::measure`], dimensionless without a unit.
    pub fn measure_or_one(&mut self, unit: Option<&UnitExpr>) -> Option<Measure> {
        match unit {
            Some(unit) => self.measure(unit),
            None => Some(Measure::one()),
        }
    }

    /// Whether the unit of a literal agrees with that of `quantity`, if it is known; else reports an error with a `label` at
    /// the declaration of `name`.
    fn agrees(
        &mut self,
        name: &Name,
        quantity: &str,
        measure: &Measure,
        expected: &Term,
        span: Span,
        label: impl Fn(&str) -> String,
    ) -> bool {
        let expected = self.units.resolve(expected);
        let Some(unit) = expected.unit() else {
            return true;
        };
        if unit.agrees(measure.unit) {
            return true;
        }
        let is = self.described(&expected);
        let found = self.described(&Term::known(measure.unit));
        let message = format!("`{quantity}` is {is}, but this is {found}");
        let declared = self.scope.place(&name.text).unwrap_or(name.span);
        let fault = Diagnostic::new(Kind::Unit, span, message).label(declared, label(&is));
        let help = match unit.tidy() {
            Unit::ONE => "write the number without a unit".to_owned(),
            unit => format!("give the number the unit `{unit}`"),
        };
        self.report(fault.help(help));
        false
    }

    fn nothing_named(&mut self, name: &Name, what: &str) {
        let message = format!("there is no {what} `{}`", name.text);
        let fault = Diagnostic::new(Kind::Name, name.span, message);
        self.report(fault.did_you_mean(&name.text, self.declared_names()));
    }
}

struct Expected {
    observable: Observable,
    unit: Term,
    text: String,
}

/// Creates the error for a vector where a scalar is required (`is_number`), or a scalar where a vector is required.
fn wrong_shape(name: &str, is_number: bool, span: Span) -> Diagnostic {
    let (message, help) = if is_number {
        (
            format!("`{name}` is a number, but this is a vector"),
            format!("write `set {name} = 1;`, with its unit"),
        )
    } else {
        (
            format!("`{name}` is a vector, but this is a number"),
            format!("write `set {name} = (0, 0, 0);`, with its unit, or set `{name}_x`"),
        )
    };
    Diagnostic::new(Kind::Shape, span, message).help(help)
}
