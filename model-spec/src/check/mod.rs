//! Semantic analysis, from syntax tree to model: names, shapes, frames, units and singular points.
//!
//! Everything is checked on the vector expressions as written, before any simplification. A statement at fault is reported
//! once and omitted; statements that use it are not reported again.

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

/// Result of [`check`](fn@check).
#[derive(Clone, Debug)]
pub struct Checked {
    /// The model, if there are no faults other than of units.
    pub model: Option<Model>,
    /// Faults, in the order of their source spans.
    pub diagnostics: Vec<Diagnostic>,
}

/// Checks a syntax tree; `sources` are the texts that its spans refer to.
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

/// Unit of an expression during the check.
#[derive(Clone, Debug)]
enum UnitOf {
    /// A unit, perhaps with unknown factors.
    Term(Term),
    /// Any unit: the expression is a literal 0 without a unit.
    Zero,
    /// Inconsistent; the fault has been reported.
    Faulty,
}

/// An expression with resolved names, consistent shapes and frames, and its unit as far as known.
#[derive(Clone, Debug)]
struct Typed {
    expr: model::Expr,
    unit: UnitOf,
}

/// State of the definition of an auxiliary variable.
#[derive(Clone, Debug)]
enum Definition {
    /// Not yet checked, or at fault.
    Missing,
    /// Index into [`Model::aux_variables`], shape and unit.
    Done(usize, model::Shape, UnitOf),
}

/// State of the check of one file.
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
    /// Definitions: all `let`s, then one for every `der(…)` used in an expression.
    definitions: Vec<Definition>,
    /// First use of each constant of unknown unit, by the index of the unknown.
    first_uses: Vec<Option<Span>>,
    /// For each state whose `der(…)` is used in an expression, the index of its definition.
    derivatives: HashMap<usize, usize>,
    /// Number of states of the body; declared states follow them.
    of_body: usize,
    /// The body, if one is declared, even if it is at fault.
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

    /// Whether there are no faults other than of units so far.
    fn sound(&self) -> bool {
        self.diagnostics.iter().all(|d| d.kind == Kind::Unit)
    }

    /// Source text of a span, on one line.
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

/// A text without brackets that enclose all of it.
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
