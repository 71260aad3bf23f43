//! From tree to model: names, shapes, frames, units and singular points.
//!
//! Everything is checked on the vector tree as it was written, before anything is simplified. A part that
//! is at fault is reported once and left out; what uses it is not reported again.

mod attitude;
mod body;
mod call;
mod cases;
mod declare;
mod effects;
mod elaborate;
mod equations;
mod explain;
mod finish;
mod frames;
mod limits;
mod names;
mod order;
mod quantity;
mod scope;
mod singular;
mod sum;
mod term;

use std::collections::HashMap;
use std::sync::Arc;

use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::model::{self, Model, Source};
use crate::syntax::ast;
use scope::Scope;
use term::{Term, Units};

pub use singular::{SingularPoint, nonzero_constants, singular_points};

/// What came of checking a file.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The model, where there are no faults or only faults of units, so that what can be said about a
    /// model with wrong units can still be said.
    pub model: Option<Model>,
    /// What is wrong, in the order of the places.
    pub diagnostics: Vec<Diagnostic>,
}

/// Checks a file; `sources` are the texts that its places refer to.
pub fn check(file: &ast::File, sources: &[Source]) -> Checked {
    if file.items.is_empty() {
        let fault = Diagnostic::new(Kind::Missing, file.end, "the file declares nothing").help(
            "a model begins with `model NAME;`, a frame `frame N;` and a `body` or a `point`",
        );
        return Checked {
            model: None,
            diagnostics: vec![fault],
        };
    }
    if let Some(ast::Item {
        kind: ast::ItemKind::Effect(effect),
        ..
    }) = file.items.first()
        && file
            .items
            .iter()
            .all(|i| matches!(i.kind, ast::ItemKind::Effect(_)))
    {
        let message = "this file has an effect but no model";
        let fault = Diagnostic::new(Kind::Missing, effect.name.span, message)
            .help("load a model and switch the effect on by the name of this file");
        return Checked {
            model: None,
            diagnostics: vec![fault],
        };
    }
    let mut checker = Checker::new(file, sources);
    checker.declare();
    checker.definitions();
    checker.body();
    checker.equations();
    checker.limits();
    checker.finish();
    if checker.sound() {
        checker.singularities();
    }
    checker.cases();
    let Checker {
        mut diagnostics,
        model,
        ..
    } = checker;
    diagnostics.sort_by_key(|d| d.span);
    let sound = diagnostics.iter().all(|d| d.kind == Kind::Unit);
    Checked {
        model: sound.then_some(model),
        diagnostics,
    }
}

/// What is known about the unit of an expression while it is being checked.
#[derive(Clone, Debug)]
enum UnitOf {
    /// This, perhaps with unknowns.
    Term(Term),
    /// A bare 0, which fits every unit.
    Zero,
    /// At fault, and reported.
    Faulty,
}

/// An expression whose names, shapes and frames are right.
#[derive(Clone, Debug)]
struct Typed {
    expr: model::Expr,
    unit: UnitOf,
}

/// What has become of a `let`.
#[derive(Clone, Debug)]
enum Definition {
    /// Not yet reached, or at fault.
    Missing,
    /// Index into [`Model::aux_variables`], shape and unit.
    Done(usize, model::Shape, UnitOf),
}

/// Everything that is known while a file is checked.
struct Checker<'a> {
    file: &'a ast::File,
    sources: &'a [Source],
    diagnostics: Vec<Diagnostic>,
    units: Units,
    scope: Scope,
    model: Model,
    /// Units of parameters, coefficients, inputs and states, by their indices.
    params: Vec<Term>,
    coefficients: Vec<Term>,
    inputs: Vec<Term>,
    states: Vec<Term>,
    /// Units of [`Model::aux_variables`], by their indices.
    let_units: Vec<UnitOf>,
    /// Whether each of [`Model::aux_variables`] changes during a flight.
    varies: Vec<bool>,
    /// Statements that define a quantity: all `let`s, then one for every `der(…)` that is used.
    definitions: Vec<Definition>,
    /// Where each unknown unit was first used, by the unknown's number.
    first_uses: Vec<Option<Span>>,
    /// Definitions of the derivatives of states, by the state: the `der(…)` that are used.
    derivatives: HashMap<usize, usize>,
    /// How many states are the body's; those that are declared come after them.
    of_body: usize,
    /// Body, where one is declared (even a faulty one).
    declared_body: Option<&'a ast::Body>,
}

impl<'a> Checker<'a> {
    fn new(file: &'a ast::File, sources: &'a [Source]) -> Checker<'a> {
        let declared_body = file.items.iter().find_map(|i| match &i.kind {
            ast::ItemKind::Body(body) => Some(body),
            _ => None,
        });
        Checker {
            file,
            sources,
            diagnostics: Vec::new(),
            units: Units::default(),
            scope: Scope::default(),
            model: empty_model(file, sources),
            params: Vec::new(),
            coefficients: Vec::new(),
            inputs: Vec::new(),
            states: Vec::new(),
            let_units: Vec::new(),
            varies: Vec::new(),
            definitions: Vec::new(),
            first_uses: Vec::new(),
            derivatives: HashMap::new(),
            of_body: 0,
            declared_body,
        }
    }

    fn report(&mut self, fault: Diagnostic) {
        self.diagnostics.push(fault);
    }

    /// Whether nothing but units is wrong so far.
    fn sound(&self) -> bool {
        self.diagnostics.iter().all(|d| d.kind == Kind::Unit)
    }

    /// A place as it was written, on one line.
    fn text(&self, span: Span) -> String {
        let raw = self
            .sources
            .get(usize::from(span.source))
            .and_then(|s| s.text.get(span.range()))
            .unwrap_or("this expression");
        let line = raw.split_whitespace().collect::<Vec<_>>().join(" ");
        crate::syntax::token::clip(unwrapped(&line))
    }
}

/// A text without brackets around the whole of it.
fn unwrapped(text: &str) -> &str {
    let Some(inner) = text.strip_prefix('(').and_then(|t| t.strip_suffix(')')) else {
        return text;
    };
    let mut open = 0_i32;
    for c in inner.chars() {
        open += i32::from(c == '(') - i32::from(c == ')');
        if open < 0 {
            return text;
        }
    }
    inner
}

fn empty_model(file: &ast::File, sources: &[Source]) -> Model {
    Model {
        name: String::new(),
        doc: file.doc.clone(),
        reference: None,
        sources: sources.to_vec(),
        params: Vec::new(),
        coefficients: Vec::new(),
        inputs: Vec::new(),
        states: Vec::new(),
        frames: Vec::new(),
        body: None,
        aux_variables: Vec::new(),
        forces: Vec::new(),
        moments: Vec::new(),
        equations: Vec::new(),
        marker: None,
        observation: None,
        clock: None,
        limits: Vec::new(),
        checks: Vec::new(),
        effects: Vec::new(),
        tree: Arc::new(file.clone()),
        offers: file
            .items
            .iter()
            .filter_map(|i| match &i.kind {
                ast::ItemKind::Effect(effect) => Some(model::OfferedEffect {
                    name: effect.name.text.clone(),
                    doc: effect.doc.clone(),
                    span: effect.name.span,
                }),
                _ => None,
            })
            .collect(),
    }
}
