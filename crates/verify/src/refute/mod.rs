//! Diagnosis of refuted equations: which equation disagrees with the reference, and in which term.
//!
//! The reference rates are those of the reference law or, in a model without one, those implied by the laws of the
//! claimed body. Each stated equation is compared with them separately. Derivatives that an equation uses are replaced
//! by the reference's values, so that a misprint is attributed to one equation only. Then a search finds the smallest
//! correction with which the equation agrees.

mod edit;

use crate::options::{Options, TOLERANCE};
use crate::random::Random;
use crate::sample;
use crate::subject::Subject;
use edit::{Edit, Editor};
use model_spec::model::{Equation, Expr, ExprKind, FrameKind, Function, Model, Shape};
use model_spec::unit::Unit;
use oracle::scalar::{ErrorBound, Field};
use oracle::{Point, Tree, Value, claimed_rates};
use serde::Serialize;

/// An equation that disagrees with the reference law or, without one, with the laws of motion of the claimed body.
#[derive(Clone, Debug, Serialize)]
pub struct Refutation {
    /// Name of the state, such as `vz`.
    pub state: String,
    /// Source text of the right-hand side of the equation.
    pub equation: String,
    /// Maximum difference from the correct derivative, relative to the sum of the magnitudes of the terms.
    pub error: f64,
    /// Corrections that together make the equation agree; empty if none were found.
    pub corrections: Vec<String>,
    /// The same difference with all corrections; equal to `error` if there are none.
    pub error_corrected: f64,
}

impl Refutation {
    /// Sentence on the wrong equation and its corrections.
    pub fn sentence(&self) -> String {
        let Self {
            state,
            error,
            error_corrected,
            ..
        } = self;
        if self.corrections.is_empty() {
            return format!(
                "der({state}) is off by {error:.0e} of its terms; no small correction mends it"
            );
        }
        let all = self.corrections.join(", and ");
        format!(
            "der({state}): {all}; corrected, the equation agrees with the oracle to {error_corrected:.0e}"
        )
    }
}

const POINTS: usize = 8;

/// Compares every stated equation with the reference law or, without one, with the laws of motion of the claimed body.
/// Returns the equations that disagree, with corrections.
pub fn refutations(subject: &Subject<'_>, options: &Options) -> Vec<Refutation> {
    let model = subject.model;
    let Some(points) = points(subject, options) else {
        return Vec::new();
    };
    let truths: Vec<Vec<Option<ErrorBound>>> = match &subject.reference {
        Some(reference) => {
            let known = |p| reference.derivatives(p).into_iter().map(Some).collect();
            points.iter().map(known).collect()
        }
        None => match points.iter().map(|p| implied(model, p)).collect() {
            Some(truths) => truths,
            None => return Vec::new(),
        },
    };
    let points = points.iter().zip(truths).map(|(point, rates)| {
        let tree = Tree::overriding(model, point, &used_derivatives(model, &rates));
        ReferencePoint { tree, rates }
    });
    let examination = Examination {
        model,
        points: points.collect(),
    };
    // The reference law does not contain added states.
    let added = model.added_states();
    let of_law = model.equations.iter().filter(|e| !added.contains(&e.state));
    of_law
        .filter_map(|equation| examination.of(equation))
        .collect()
}

/// Random points of the comparison; `None` without a reference law and a claim.
fn points(subject: &Subject<'_>, options: &Options) -> Option<Vec<Point<ErrorBound>>> {
    let mut random = Random::new(options.seed, "refute");
    let has_reference = subject.reference.is_some();
    if !has_reference && subject.model.claim.is_none() {
        return None;
    }
    let drawn = (0..POINTS).map(|_| {
        let point = sample::point(subject.model, &mut random);
        if has_reference {
            subject.without_extras(point).lift()
        } else {
            subject.without_effects(point).lift()
        }
    });
    Some(drawn.collect())
}

/// Rate of each state with respect to true time, as implied by the laws of motion of the claimed body; an inner `None`
/// marks a rate that they do not determine. `None` if the claim itself is wrong.
fn implied(model: &Model, point: &Point<ErrorBound>) -> Option<Vec<Option<ErrorBound>>> {
    let pace = Tree::new(model, point).clock();
    let implied = claimed_rates(model, point, ErrorBound::integer(1) / pace)?;
    implied.solves_the_others.then_some(implied.rates)
}

/// Variables that are the derivative of a state, with its expression, and the correct rate.
fn used_derivatives(
    model: &Model,
    truth: &[Option<ErrorBound>],
) -> Vec<(usize, Value<ErrorBound>)> {
    let mut out = Vec::new();
    for (index, named) in model.aux_variables.iter().enumerate() {
        let own = model
            .equations
            .iter()
            .find(|e| e.value.span == named.value.span);
        let known = own.and_then(|e| truth[e.state]);
        out.extend(known.map(|rate| (index, Value::Scalar(rate))));
    }
    out
}

/// A random point of the comparison.
struct ReferencePoint<'a> {
    /// The model at the point; derivatives that occur in expressions have the values in `rates` where known.
    tree: Tree<'a, ErrorBound>,
    /// Correct rate of each state; `None` if unknown.
    rates: Vec<Option<ErrorBound>>,
}

struct Examination<'a> {
    model: &'a Model,
    points: Vec<ReferencePoint<'a>>,
}

impl Examination<'_> {
    /// Maximum relative difference of `e` from the correct derivative of the state; stops above `stop`.
    fn error(&self, state: usize, e: &Expr, stop: f64) -> f64 {
        let mut worst = 0.0_f64;
        for point in &self.points {
            let Some(truth) = point.rates[state] else {
                continue;
            };
            let found = point.tree.scalar(e);
            if !(truth.value.is_finite() || found.value.is_finite()) {
                continue;
            }
            let magnitude = truth.magnitude.max(found.magnitude);
            let truth = ErrorBound { magnitude, ..truth };
            worst = worst.max(truth.relative_error(found.value));
            if worst > stop {
                break;
            }
        }
        worst
    }

    fn of(&self, equation: &Equation) -> Option<Refutation> {
        let state = equation.state;
        // A derivative that other equations use is stated as an auxiliary variable, whose expression is examined.
        let stated = match &equation.value.kind {
            ExprKind::AuxVariable(i)
                if self.model.aux_variables[*i].value.span == equation.value.span =>
            {
                &self.model.aux_variables[*i].value
            }
            _ => &equation.value,
        };
        let error = self.error(state, stated, f64::INFINITY);
        if error <= TOLERANCE {
            return None;
        }
        let (corrections, error_corrected) = self
            .corrections(state, stated)
            .unwrap_or((Vec::new(), error));
        Some(Refutation {
            state: self.model.states[state].name.clone(),
            equation: self.model.text(stated.span),
            error,
            corrections,
            error_corrected,
        })
    }

    /// Searches for corrections with which the equation agrees: one, one including a missing factor, two, three.
    /// Returns them with the remaining error.
    fn corrections(&self, state: usize, e: &Expr) -> Option<(Vec<String>, f64)> {
        let whole = self.model.text(e.span);
        let plain = Editor::new(self.model);
        let thorough = Editor::lacking(self.model, factors(self.model, e));
        for (editor, depth) in [(&plain, 1), (&thorough, 1), (&plain, 2), (&plain, 3)] {
            let start = Edit {
                says: String::new(),
                rank: 0,
                to: e.clone(),
            };
            let found = self.search(editor, state, &start, &whole, depth);
            if found.is_some() {
                return found;
            }
        }
        None
    }

    fn search(
        &self,
        editor: &Editor<'_>,
        state: usize,
        from: &Edit,
        whole: &str,
        depth: usize,
    ) -> Option<(Vec<String>, f64)> {
        let mut edits = editor.edits(&from.to, whole);
        edits.sort_by_key(|edit| edit.rank);
        for edit in &edits {
            if depth == 1 {
                let error = self.error(state, &edit.to, TOLERANCE);
                if error <= TOLERANCE {
                    return Some((vec![edit.says.clone()], error));
                }
            } else if let Some((mut rest, error)) =
                self.search(editor, state, edit, whole, depth - 1)
            {
                rest.insert(0, edit.says.clone());
                return Some((rest, error));
            }
        }
        None
    }
}

/// Factors (name, expression) that a misprinted term may lack: 2, 1/2, parameters, sines and cosines of frame angles,
/// and their inverses. They have the source location of `at`.
fn factors(model: &Model, at: &Expr) -> Vec<(String, Expr)> {
    let scalar = |kind| Expr {
        kind,
        shape: Shape::Scalar,
        unit: Unit::default(),
        span: at.span,
    };
    let number = |value: f64| scalar(ExprKind::Number { value, exact: None });
    let mut out = vec![
        (String::from("2"), number(2.0)),
        (String::from("1/2"), number(0.5)),
    ];
    let mut also_inverse = |name: String, e: Expr| {
        let inverse = ExprKind::Div(Box::new(number(1.0)), Box::new(e.clone()));
        out.push((name.clone(), e));
        out.push((format!("1/{name}"), scalar(inverse)));
    };
    for frame in &model.frames {
        let FrameKind::Turned { angle, .. } = frame.kind else {
            continue;
        };
        let name = &model.states[angle].name;
        for (function, spelled) in [(Function::Cos, "cos"), (Function::Sin, "sin")] {
            let call = ExprKind::Call(function, Box::new(scalar(ExprKind::State(angle))));
            also_inverse(format!("{spelled}({name})"), scalar(call));
        }
    }
    for (i, parameter) in model.params.iter().enumerate() {
        also_inverse(parameter.name.clone(), scalar(ExprKind::Param(i)));
    }
    out
}
