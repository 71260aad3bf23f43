//! Semantic analysis, from syntax tree to model: names, shapes, frames, units and singular points.
//!
//! The checks analyse the vector expressions as written, before any simplification. A statement with an error is
//! reported once and omitted; statements that refer to it cause no further reports.

mod angle;
mod attitude;
mod body;
mod body_rates;
mod call;
mod cases;
mod claim;
mod constraint;
mod declare;
mod determined;
mod effects;
mod elaborate;
mod equations;
mod explain;
mod finish;
mod frames;
mod function;
mod kept;
mod limits;
mod names;
mod order;
mod quantity;
mod rates;
mod scope;
mod shown;
mod singular;
mod size;
mod solve;
mod sum;
mod table;
mod term;
mod unitless;

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use crate::diagnostic::{self, Diagnostic, Kind, Span};
use crate::model::{self, Model, Source};
use crate::syntax::{Parts, ast, expand};
use function::FunctionFaults;
use rates::{Dependence, StateSets};
use scope::Scope;
pub(crate) use scope::function_names;
use term::{Term, Units};
use unitless::Unitless;

use crate::syntax::reserved::{OF_BODY, PREVIOUS};
pub(crate) use quantity::si_value;
pub use singular::{SingularPoint, singular_points};

/// Result of [`check`](fn@check): the model and the diagnostics.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The checked model; `None` if there is any error other than a unit error.
    pub model: Option<Model>,
    /// Errors, in the order of their source spans.
    pub diagnostics: Vec<Diagnostic>,
}

/// Checks names, shapes, frames, units and singular points of a syntax tree, and converts it to a model. The spans of
/// the tree refer to `sources`.
pub fn check(file: &ast::File, sources: &[Source]) -> Checked {
    if expand::is_needed(file) {
        let mut own = file.clone();
        let diagnostics = expand::expand(&mut own);
        return match diagnostics.is_empty() {
            true => check(&own, sources),
            false => refused(diagnostics),
        };
    }
    if file.items.is_empty() {
        let fault = Diagnostic::new(Kind::Missing, file.end, "the file declares nothing").help(
            "a model begins with `model NAME;`, a frame `frame N;` and a `body` or a `point`",
        );
        return refused(vec![fault]);
    }
    if let Some(effect) = file.effects().next()
        && file.effects().count() == file.items.len()
    {
        let message = "this file has an effect but no model";
        let fault = Diagnostic::new(Kind::Missing, effect.name.span, message)
            .help("load a model and switch the effect on by the name of this file");
        return refused(vec![fault]);
    }
    let mut checker = Checker::new(file, sources, Unitless::default());
    checker.run();
    if checker.unitless.is_suspected() {
        let mut inferring = Checker::new(file, sources, Unitless::inferred());
        inferring.run();
        checker.suggest_units(&inferring);
    }
    let mut diagnostics = checker.all_faults();
    let model = checker.model;
    diagnostic::sort(&mut diagnostics);
    shown::show_written_names(file, &mut diagnostics);
    let sound = diagnostics.iter().all(|d| d.kind == Kind::Unit);
    Checked {
        model: sound.then_some(model),
        diagnostics,
    }
}

fn refused(diagnostics: Vec<Diagnostic>) -> Checked {
    Checked {
        model: None,
        diagnostics,
    }
}

#[derive(Clone, Debug)]
enum UnitOf {
    /// A product of powers of base units and of unknown units.
    Term(Term),
    /// Compatible with every unit, because the expression is a literal 0 without a unit.
    Zero,
    /// The units of the operands are inconsistent; the error has already been reported.
    Faulty,
}

#[derive(Clone, Debug)]
struct Typed {
    expr: model::Expr,
    unit: UnitOf,
}

impl Typed {
    fn scalar(kind: model::ExprKind, span: Span, unit: UnitOf) -> Typed {
        Typed::new(kind, model::Shape::Scalar, span, unit)
    }

    fn new(kind: model::ExprKind, shape: model::Shape, span: Span, unit: UnitOf) -> Typed {
        let expr = elaborate::node(kind, shape, span);
        Typed { expr, unit }
    }
}

#[derive(Clone, Debug)]
enum Definition {
    /// The definition is not yet checked, or has an error.
    Missing,
    /// Checked without error: index into [`Model::aux_variables`], shape and unit.
    Done(usize, model::Shape, UnitOf),
}

/// What the checker knows of an auxiliary variable.
struct Variable {
    unit: UnitOf,
    /// Whether the variable may change during a flight.
    varies: bool,
    /// The call that has added the variable of a function.
    call: Option<Span>,
}

/// State of the semantic analysis.
struct Checker<'a> {
    file: &'a ast::File,
    sources: &'a [Source],
    diagnostics: Vec<Diagnostic>,
    units: Units,
    scope: Scope,
    model: Model,
    /// Units of the parameters; a unit to be inferred is a term with one unknown.
    params: Vec<Term>,
    coefficients: Vec<Term>,
    inputs: Vec<Term>,
    states: Vec<Term>,
    /// What is known of the auxiliary variables, in their order.
    variables: Vec<Variable>,
    of_functions: FunctionFaults,
    /// Checked definitions: each `let` in order, then each equation whose derivative is used.
    definitions: Vec<Definition>,
    /// First use of each name whose unit is to be inferred, by index of the unknown.
    first_uses: Vec<Option<Span>>,
    /// Maps the index of each state whose `der(…)` an expression uses to an index into [`Checker::definitions`].
    derivatives: HashMap<usize, usize>,
    /// Maps each state whose derivative is an unknown of a block `solve` to an index into [`Model::aux_variables`].
    solved: HashMap<usize, usize>,
    state_sets: StateSets,
    /// What the auxiliary variables depend on, by index into [`Model::aux_variables`], as far as it was needed.
    dependences: Vec<Dependence>,
    /// Number of states of the body, which precede the states declared with `state`.
    of_body: usize,
    /// Declaration of the body, even if it has errors.
    declared_body: Option<&'a ast::Body>,
    parts_of_body: Parts<'a>,
    /// Declarations without a unit, and the unit errors that they may cause.
    unitless: Unitless,
    /// Names of the elements of arrays in the file, each with how it is written.
    elements: HashMap<&'a str, String>,
    /// Errors so far, by [`Checker::place`].
    reported: HashSet<(Span, String)>,
}

impl<'a> Checker<'a> {
    fn new(file: &'a ast::File, sources: &'a [Source], unitless: Unitless) -> Checker<'a> {
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
            variables: Vec::new(),
            of_functions: FunctionFaults::default(),
            definitions: Vec::new(),
            first_uses: Vec::new(),
            derivatives: HashMap::new(),
            solved: HashMap::new(),
            state_sets: StateSets::default(),
            dependences: Vec::new(),
            of_body: 0,
            declared_body: file.body(),
            parts_of_body: Parts::default(),
            unitless,
            elements: file.items.iter().filter_map(shown::written).collect(),
            reported: HashSet::new(),
        }
    }

    fn run(&mut self) {
        self.declare();
        self.definitions();
        self.functions();
        self.constant_angles();
        self.body();
        self.further_bodies();
        self.equations();
        self.systems();
        self.claim();
        self.balances();
        self.limits();
        self.after_motion();
        self.finish();
        if self.sound() {
            self.singularities();
            self.size();
        }
        self.cases();
    }

    fn report(&mut self, fault: Diagnostic) {
        self.reported.insert(self.place(&fault));
        self.diagnostics.push(fault);
    }

    /// What is one error: its span and message, whichever element of an array it is about.
    fn place(&self, fault: &Diagnostic) -> (Span, String) {
        (
            fault.span,
            shown::of_any_element(&fault.message, &self.elements),
        )
    }

    /// Whether the error was reported before, of another element or another copy of a function.
    fn is_reported(&self, fault: &Diagnostic) -> bool {
        self.reported.contains(&self.place(fault))
    }

    /// Reports an error; returns `None`.
    fn refuse<T>(&mut self, fault: Diagnostic) -> Option<T> {
        self.report(fault);
        None
    }

    fn sound(&self) -> bool {
        let of_functions = self.of_functions.found();
        let mut all = self.diagnostics.iter().chain(of_functions);
        all.all(|d| d.kind == Kind::Unit)
    }

    /// Adds the replacement of an expression by a call of `function` with it.
    fn called(&self, fault: Diagnostic, function: &str, span: Span) -> Diagnostic {
        let source = self.sources.get(usize::from(span.source));
        match source.and_then(|source| source.text.get(span.range())) {
            Some(text) => fault.fix(span, format!("{function}({})", unwrapped(text))),
            None => fault,
        }
    }

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
        doc: file.doc.clone(),
        sources: sources.to_vec(),
        tree: Arc::new(file.clone()),
        ..Model::default()
    }
}
