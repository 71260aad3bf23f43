//! Semantic checks of `check` blocks: values to set and expected results.

use std::collections::HashMap;

use super::quantity::Measure;
use super::scope::Symbol;
use super::term::{Fraction, Term};
use super::{Checker, Definition, UnitOf};
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{CheckCase, Expectation, Observable, Shape, Target};
use crate::syntax::ast::{self, CheckPart, ItemKind, Name, Number, UnitExpr};
use crate::unit::Unit;

impl Checker<'_> {
    /// Checks every `check` block (test case of the model file) and adds it to the model's check cases.
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
            let (mut settings, mut expectations) = (Vec::new(), Vec::new());
            for part in &check.parts {
                match part {
                    CheckPart::Set {
                        name,
                        value,
                        unit,
                        span,
                    } => {
                        let setting = self.setting(name, value, unit.as_ref(), *span);
                        settings.extend(setting.into_iter().flatten());
                    }
                    CheckPart::Expect {
                        name,
                        derivative,
                        value,
                        within,
                        span,
                    } => {
                        let observable = match derivative {
                            true => self.expected_derivative(name),
                            false => self.expected_quantity(name),
                        };
                        let expectation = observable
                            .and_then(|o| self.expectation(o, name, value, within, *span));
                        expectations.extend(expectation);
                    }
                }
            }
            self.model.checks.push(CheckCase {
                title: check.title.clone(),
                settings,
                expectations,
                span,
            });
        }
    }

    /// Checks `set NAME = value;`. Returns pairs of target and SI value: one pair, or three for the components of an
    /// input or of the marker. `None`, with an error reported, if the name or its value is invalid.
    fn setting(
        &mut self,
        name: &Name,
        value: &[Number],
        unit: Option<&UnitExpr>,
        span: Span,
    ) -> Option<Vec<(Target, f64)>> {
        let (targets, expected) = self.targets(name)?;
        if targets.len() != value.len() {
            self.report(wrong_shape(&name.text, targets.len() == 1, span));
            return None;
        }
        let measure = self.measure_or_one(unit)?;
        let is_bare_zero = unit.is_none() && value.iter().all(|n| measure.of(n).0 == 0.0);
        if !is_bare_zero {
            let declared = self.scope.place(&name.text).unwrap_or(span);
            self.agrees(&name.text, &measure, &expected, span, |is| {
                (declared, format!("`{}` is {is}", name.text))
            });
        }
        let values = value.iter().map(|number| measure.of(number).0);
        Some(targets.into_iter().zip(values).collect())
    }

    /// Scalars, such as a state or the components of an input, to which the name in `set NAME` refers, with their
    /// common unit; `None`, with an error reported, if the name cannot be set.
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
            Symbol::Let(_) => {
                let message = format!("`{}` is computed and cannot be set", name.text);
                let declared = self.scope.place(&name.text).unwrap_or(name.span);
                let fault = Diagnostic::new(Kind::Name, name.span, message)
                    .label(declared, "declared here");
                self.report(
                    fault.help("set parameters, coefficients, inputs, states and the marker"),
                );
                return None;
            }
        };
        match self.unit_of_symbol(symbol)? {
            UnitOf::Term(unit) => Some((targets, unit)),
            UnitOf::Zero | UnitOf::Faulty => None,
        }
    }

    /// Resolves the state derivative in `expect der(NAME) = …`; `None`, with an error reported, if `NAME` is not a
    /// state.
    fn expected_derivative(&mut self, name: &Name) -> Option<Expected> {
        let Some(Symbol::State(i)) = self.scope.find(&name.text) else {
            self.no_state(name);
            return None;
        };
        let inverse = Fraction::new(-1, 1)?;
        Some(Expected {
            observable: Observable::Derivative(i),
            unit: self.states[i].times_power(&Term::known(Unit::SECOND), inverse)?,
            text: format!("der({})", name.text),
        })
    }

    /// Resolves the scalar auxiliary variable in `expect NAME = …`; `None`, with an error reported, if `NAME` is not a
    /// scalar auxiliary variable.
    fn expected_quantity(&mut self, name: &Name) -> Option<Expected> {
        let (message, help) = match self.scope.find(&name.text) {
            Some(Symbol::Let(i)) => match self.definitions.get(i)?.clone() {
                Definition::Done(index, Shape::Scalar, UnitOf::Term(unit)) => {
                    return Some(Expected {
                        observable: Observable::AuxVariable(index),
                        unit,
                        text: name.text.clone(),
                    });
                }
                Definition::Done(_, Shape::Vector(_), _) => {
                    let message = format!(
                        "`{}` is a vector; what is expected must be a number",
                        name.text
                    );
                    let help = format!("name a component: `let {0}_1 = {0}.1;`", name.text);
                    self.report(Diagnostic::new(Kind::Shape, name.span, message).help(help));
                    return None;
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
        self.report(Diagnostic::new(Kind::Name, name.span, message).help(help));
        None
    }

    /// Checks `expect … = value within tolerance;`. A tolerance without a unit has the unit of the value. `None` if a
    /// unit or the tolerance is invalid, with an error reported.
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
        let declared = self.scope.place(&name.text).unwrap_or(name.span);
        for (measure, span) in stated {
            let label = |_: &str| (declared, format!("`{}` is declared here", name.text));
            if !self.agrees(&expected.text, measure, &expected.unit, span, label) {
                return None;
            }
        }
        if allowed < 0.0 {
            let message = "the greatest difference cannot be negative";
            self.report(Diagnostic::new(Kind::Value, within.span, message));
            return None;
        }
        Some(Expectation {
            what: expected.observable,
            value: number,
            within: allowed,
            span,
        })
    }

    /// SI unit and conversion factor of a unit expression; dimensionless if `unit` is `None`. Returns `None`, with an
    /// error reported, if the expression is invalid.
    pub fn measure_or_one(&mut self, unit: Option<&UnitExpr>) -> Option<Measure> {
        match unit {
            Some(unit) => self.measure(unit),
            None => Some(Measure::one()),
        }
    }

    /// Whether the unit `measure` of a literal agrees with the unit `expected` of `quantity`; reports an error if not.
    /// A unit that is still unknown agrees with any unit. `label` returns a source span and its annotation for the
    /// error, given a description of the expected unit.
    fn agrees(
        &mut self,
        quantity: &str,
        measure: &Measure,
        expected: &Term,
        span: Span,
        label: impl Fn(&str) -> (Span, String),
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
        let (declared, text) = label(&is);
        let fault = Diagnostic::new(Kind::Unit, span, message).label(declared, text);
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

/// A result that a check case compares with an expected value.
struct Expected {
    observable: Observable,
    unit: Term,
    /// Text of the result as written, such as `der(u)` or `alpha`, for messages.
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
