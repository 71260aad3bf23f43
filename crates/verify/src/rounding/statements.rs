//! Digits lost in each statement of a model: its local error, after Herbie (Panchekha and others, 2015, "Automatically
//! improving accuracy for floating point expressions").
//!
//! Every statement is compiled with the values of the auxiliary variables as inputs. It is evaluated by the tape from
//! correctly rounded inputs, and in 256-bit arithmetic from exact inputs. The difference is lost in this statement, by
//! its own rounding or because it amplifies the rounding of its inputs.

use super::sort_largest_first;
use crate::engine;
use crate::evaluation::{Inputs, outputs};
use codegen::compile_every_value;
use codegen::tape::Tape;
use model_spec::diagnostic::Span;
use model_spec::location::trimmed_line;
use model_spec::model::{AuxVariable, Expr, ExprKind, Input, Model, Parameter, Shape};
use model_spec::sort_by_number;
use oracle::Point;
use oracle::scalar::{Big, Real, with_numbers};
use serde::Serialize;
use std::path::Path;

/// Number of lost bits above which a statement is reported: by chance, once in a million points.
pub const REPORTED_BITS: f64 = 20.0;

/// Minimum magnitude of values whose lost bits are counted; smaller ones may be subnormal.
const MIN_NORM: f64 = 1e-290;

/// A statement whose value loses bits.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Loss {
    /// Name of what the statement declares, such as `alpha`, `der(v)`, `clock`, `mass` or `inertia`.
    pub name: String,
    /// File name of the model or effect, without folders.
    pub source: String,
    /// Line number of the statement in the file `source`, from 1.
    pub line: usize,
    /// Source text of the line with the statement.
    pub text: String,
    /// Maximum number of lost bits over the points, out of 53.
    pub bits: f64,
    /// Median number of lost bits.
    pub median_bits: f64,
    /// Description of the point at which the statement loses the most bits.
    pub place: String,
}

struct Statement {
    name: String,
    span: Span,
}

/// Bits that each statement loses at points with descriptions, in descending order, without those that lose none.
pub fn losses(model: &Model, points: &[(String, Point<f64>)]) -> Vec<Loss> {
    let (alone, statements) = separated(model);
    let whole = compile_every_value(model);
    let parts = compile_every_value(&alone);
    let tape = Tape::new(&parts.program);
    let first = |lets: &[usize], all: usize| all - lets.iter().sum::<usize>();
    let start = first(&whole.lets, whole.program.outputs.len());
    let start_alone = first(&parts.lets, parts.program.outputs.len());
    let mut lost: Vec<Vec<(f64, usize)>> = vec![Vec::new(); statements.len()];
    for (place, (_, point)) in points.iter().enumerate() {
        with_numbers(|| {
            let mut exact: Inputs<Big> = Inputs::of(&point.lift());
            let values = outputs(&whole.program, &exact);
            let given = &values[start..];
            let near: Vec<f64> = given.iter().map(|v| v.re()).collect();
            let mut rounded = Inputs::of(point);
            rounded.parameters = rearranged(model, &whole.lets, &rounded.parameters, &near);
            exact.parameters = rearranged(model, &whole.lets, &exact.parameters, given);
            let exact = outputs(&parts.program, &exact);
            let rounded = engine::outputs(&tape, &rounded);
            let mut at = start_alone;
            for (statement, &width) in parts.lets.iter().enumerate() {
                let range = at..at + width;
                at += width;
                if let Some(bits) = bits(&exact[range.clone()], &rounded[range]) {
                    lost[statement].push((bits, place));
                }
            }
        });
    }
    let mut losses: Vec<Loss> = statements
        .iter()
        .zip(lost)
        .filter_map(|(statement, lost)| loss(model, statement, lost, points))
        .collect();
    sort_by_number(&mut losses, |loss| -loss.bits);
    losses
}

/// Parameter vector of the model of [`separated`]: parameters, scalar auxiliary variables, coefficients, inputs, vector
/// auxiliary variables. `all`: parameter vector of the original model; `given`: components of its auxiliary variables,
/// `lets` of each.
fn rearranged<T: Copy>(model: &Model, lets: &[usize], all: &[T], given: &[T]) -> Vec<T> {
    let (mut scalars, mut vectors, mut rest) = (Vec::new(), Vec::new(), given);
    for &width in lets {
        let (own, others) = rest.split_at(width);
        match own {
            [scalar] => scalars.push(*scalar),
            vector => vectors.extend_from_slice(vector),
        }
        rest = others;
    }
    let (params, rest) = all.split_at(model.params.len());
    [params, &scalars, rest, &vectors].concat()
}

/// Lost bits of a scalar or vector: log2 of the error in units of the f64 epsilon of the norm. `None` if the norm is
/// below [`MIN_NORM`] or not finite.
fn bits(exact: &[Big], rounded: &[f64]) -> Option<f64> {
    let norm = |values: Vec<f64>| values.iter().fold(0.0, |sum: f64, v| sum.hypot(*v));
    let size = norm(exact.iter().map(|v| v.re()).collect());
    if !(MIN_NORM..f64::INFINITY).contains(&size) {
        return None;
    }
    let each = exact.iter().zip(rounded);
    let error = norm(each.map(|(&e, &r)| (e - Big::lit(r)).re()).collect());
    let units = error / size / f64::EPSILON;
    Some(units.max(1.0).log2().min(53.0))
}

fn loss(
    model: &Model,
    statement: &Statement,
    mut lost: Vec<(f64, usize)>,
    points: &[(String, Point<f64>)],
) -> Option<Loss> {
    sort_largest_first(&mut lost);
    let &(bits, place) = lost.first().filter(|(bits, _)| *bits > 0.0)?;
    let source = model.sources.get(usize::from(statement.span.source))?;
    let (line, text) = trimmed_line(&source.text, statement.span.range().start);
    Some(Loss {
        name: statement.name.clone(),
        source: match Path::new(&source.name).file_name() {
            Some(name) => name.to_string_lossy().into_owned(),
            None => source.name.clone(),
        },
        line,
        text: text.to_owned(),
        bits,
        median_bits: lost[lost.len() / 2].0,
        place: points[place].0.clone(),
    })
}

/// Model in which every statement is an auxiliary variable that reads the original ones as inputs, so that their errors
/// do not count; and the statements in this order.
fn separated(model: &Model) -> (Model, Vec<Statement>) {
    let mut alone = model.clone();
    let mut statements: Vec<Statement> = Vec::new();
    let mut push = |name: &str, span| {
        statements.push(Statement {
            name: name.to_owned(),
            span,
        });
    };
    // Input that replaces each auxiliary variable.
    let mut given = Vec::new();
    for (index, variable) in model.aux_variables.iter().enumerate() {
        push(&variable.name, variable.span);
        let name = format!("given_{index}");
        given.push(match variable.value.shape {
            Shape::Scalar => {
                alone.params.push(Parameter {
                    name,
                    ..Parameter::default()
                });
                ExprKind::Param(alone.params.len() - 1)
            }
            Shape::Vector(frame) => {
                alone.inputs.push(Input {
                    name,
                    frame,
                    ..Input::default()
                });
                ExprKind::Input(alone.inputs.len() - 1)
            }
        });
    }
    for root in alone.expressions_mut() {
        replace(root, &given);
    }
    let mut own: Vec<Expr> = Vec::new();
    let mut add = |name: &str, value: &Expr, span: Span| {
        push(name, span);
        own.push(value.clone());
    };
    for load in alone.forces.iter().chain(&alone.moments) {
        add(&load.name, &load.value, load.span);
    }
    for equation in &alone.equations {
        let name = format!("der({})", alone.states[equation.state].name);
        add(&name, &equation.value, equation.span);
    }
    if let Some(observation) = &alone.observation {
        add(&observation.name, &observation.value, observation.span);
    }
    if let Some(clock) = &alone.clock {
        add("clock", &clock.value, clock.span);
    }
    if let Some(body) = &alone.body {
        add("mass", &body.mass, body.mass.span);
        for entry in body.rotation.iter().flat_map(|r| r.inertia.as_flattened()) {
            add("inertia", entry, entry.span);
        }
    }
    for (index, value) in own.into_iter().enumerate() {
        let name = format!("statement_{index}");
        alone.aux_variables.push(AuxVariable::new(name, value));
    }
    (alone, statements)
}

fn replace(e: &mut Expr, given: &[ExprKind]) {
    if let ExprKind::AuxVariable(index) = e.kind {
        e.kind = given[index].clone();
    }
    for child in e.children_mut() {
        replace(child, given);
    }
}
