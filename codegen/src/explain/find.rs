//! Resolution of quantity names to expression graph nodes and source locations.

use crate::compile::{Compiler, Selection};
use crate::graph::{NodeId, Symbol};
use crate::latex;
use crate::layout::{Layout, is_unlisted};
use model_spec::diagnostic::Span;
use model_spec::location::line_of;
use model_spec::model::{AuxVariable, Expr, ExprKind, Load, Model};
use model_spec::nearest_name;

/// Quantity found by name: label, source location, formula, and the names and graph nodes of its components.
pub(super) struct FoundQuantity {
    pub label: String,
    pub place: String,
    pub line: String,
    pub doc: String,
    /// LaTeX formula of the definition; `None` if the model does not define the quantity by one expression.
    pub latex: Option<String>,
    pub names: Vec<String>,
    pub symbols: Vec<String>,
    pub nodes: Vec<NodeId>,
    pub compiler: Compiler,
}

enum Meaning<'a> {
    Let(&'a AuxVariable),
    Component(&'a AuxVariable, String),
    Load(&'a Load, &'static str),
    Rate(usize),
}

/// Finds the quantity of a model with the name `wanted`; an error if the name is unknown or ambiguous.
pub(super) fn quantity(model: &Model, wanted: &str) -> Result<FoundQuantity, ExplainError> {
    // A component is `v.1` in a model and `v_1` in generated code.
    let wanted = &*wanted.trim().replace('.', "_");
    let meaning = meaning(model, wanted)?;
    let mut changed = model.clone();
    let (mut label, mut prefix) = (wanted.to_string(), wanted.to_string());
    if let Meaning::Load(load, kind) = &meaning {
        label = format!("{kind} {}", load.name);
        prefix = format!("{kind}_{}", load.name);
        let named = |name: &str| changed.aux_variables.iter().any(|own| own.name == name);
        while named(&prefix) {
            prefix.push('_');
        }
        changed.aux_variables.push(AuxVariable {
            span: load.span,
            effect: load.effect,
            ..AuxVariable::new(prefix.clone(), load.value.clone())
        });
    }
    let compiler = Compiler::new(&changed, &Selection::Only(Vec::new()));
    let lowered = &compiler.lowered;
    let of_let = |name: &str| {
        let mut start = 0;
        let of_marker = is_unlisted(&changed);
        let values = changed.aux_variables.iter().zip(&lowered.lets);
        for ((quantity, nodes), of_marker) in values.zip(of_marker) {
            if quantity.name == name && of_marker {
                // Marker-dependent variables are not in `quantities`, whose inputs lack a marker.
                let each = nodes.iter().zip(["x", "y", "z"]);
                return each
                    .map(|(&node, axis)| (format!("{name}_{axis}"), node))
                    .collect();
            }
            if quantity.name == name {
                return lowered.quantities[start..start + nodes.len()].to_vec();
            }
            if !of_marker {
                start += nodes.len();
            }
        }
        Vec::new()
    };
    let parts: Vec<(String, NodeId)> = match &meaning {
        Meaning::Let(_) | Meaning::Load(..) => of_let(&prefix),
        Meaning::Component(_, name) => {
            let mut quantities = lowered.quantities.iter();
            let found = quantities.find(|(known, _)| known == name);
            found.cloned().into_iter().collect()
        }
        Meaning::Rate(k) => vec![(format!("{}_dot", model.states[*k].name), lowered.dx[*k])],
    };
    let (span, end, doc) = match &meaning {
        Meaning::Let(quantity) | Meaning::Component(quantity, _) => {
            (quantity.span, quantity.value.span, quantity.doc.clone())
        }
        Meaning::Load(load, _) => (load.span, load.value.span, String::new()),
        Meaning::Rate(k) => rate_place(model, *k),
    };
    let (place, line) = source(model, span, end);
    let latex = match &meaning {
        Meaning::Component(..) => None,
        // Equations of a block determine it.
        _ if is_unknown(model, &meaning) => None,
        _ => latex::definition(model, &label),
    };
    let (names, nodes): (Vec<String>, Vec<NodeId>) = parts.into_iter().unzip();
    let symbols = names.iter().map(|name| symbol_of(model, name)).collect();
    Ok(FoundQuantity {
        label,
        place,
        line,
        doc,
        latex,
        names,
        symbols,
        nodes,
        compiler,
    })
}

/// Whether a quantity is an unknown of a block `solve`, which no statement defines.
fn is_unknown(model: &Model, meaning: &Meaning<'_>) -> bool {
    let value = match meaning {
        Meaning::Let(own) => Some(&own.value),
        Meaning::Rate(k) => {
            let mut equations = model.equations.iter();
            let value = equations
                .find(|own| own.state == *k)
                .map(|own| &own.value.kind);
            match value {
                Some(ExprKind::AuxVariable(i)) => Some(&model.aux_variables[*i].value),
                _ => None,
            }
        }
        _ => None,
    };
    let is_leaf = |e: &Expr| matches!(e.kind, ExprKind::Unknown(..));
    value.is_some_and(|value| match &value.kind {
        ExprKind::Components(parts) => parts.iter().all(is_leaf),
        _ => is_leaf(value),
    })
}

fn meaning<'a>(model: &'a Model, wanted: &str) -> Result<Meaning<'a>, ExplainError> {
    let load = |loads: &'a [Load], name: &str| loads.iter().find(|load| load.name == name);
    if let Some(state) = wanted
        .strip_prefix("der(")
        .and_then(|rest| rest.strip_suffix(')'))
        && let Some(k) = model.states.iter().position(|s| s.name == state.trim())
    {
        return Ok(Meaning::Rate(k));
    }
    let mut variables = model.aux_variables.iter();
    if let Some(quantity) = variables.find(|quantity| quantity.name == wanted) {
        return Ok(Meaning::Let(quantity));
    }
    let bare = |prefix: &str| wanted.strip_prefix(prefix).unwrap_or(wanted);
    let force = load(&model.forces, bare("force "));
    let moment = load(&model.moments, bare("moment "));
    match (force, moment) {
        (Some(_), Some(_)) => {
            let wanted = wanted.to_string();
            return Err(ExplainError::Ambiguous { wanted });
        }
        (Some(force), None) => return Ok(Meaning::Load(force, "force")),
        (None, Some(moment)) => return Ok(Meaning::Load(moment, "moment")),
        (None, None) => {}
    }
    for quantity in &model.aux_variables {
        if let Some(component) = components(model, quantity).find(|name| name == wanted) {
            return Ok(Meaning::Component(quantity, component));
        }
    }
    // Variables of a call, `q__1_V`, are written in no text.
    let written = model
        .aux_variables
        .iter()
        .filter(|own| !own.name.contains("__"));
    let mut known: Vec<String> = written.map(|own| own.name.clone()).collect();
    known.extend(model.forces.iter().map(|l| format!("force {}", l.name)));
    known.extend(model.moments.iter().map(|l| format!("moment {}", l.name)));
    known.extend(model.states.iter().map(|s| format!("der({})", s.name)));
    Err(ExplainError::Quantity {
        wanted: wanted.to_string(),
        nearest: nearest(wanted, &known),
        known,
    })
}

/// Names of the components of a vector-valued auxiliary variable; empty for a scalar.
fn components<'a>(
    model: &Model,
    quantity: &'a AuxVariable,
) -> impl Iterator<Item = String> + use<'a> {
    let mut alone = model.clone();
    alone
        .aux_variables
        .retain(|other| other.name == quantity.name);
    let names = Layout::new(&alone).quantities.into_iter();
    names.filter(move |name| *name != quantity.name)
}

/// Symbol of the state, parameter, coefficient or input component with the name `wanted`; an error if there is none.
pub(super) fn symbol(model: &Model, wanted: &str) -> Result<Symbol, ExplainError> {
    let layout = Layout::new(model);
    if let Some(k) = layout.state(wanted) {
        return Ok(Symbol::State(k.index() as u32));
    }
    if let Some(k) = layout.parameter(wanted) {
        return Ok(Symbol::Parameter(k.index() as u32));
    }
    let mut known = layout.states;
    known.extend(layout.parameters);
    Err(ExplainError::Wrt {
        wanted: wanted.to_string(),
        nearest: nearest(wanted, &known),
        known,
    })
}

pub(super) fn symbol_of(model: &Model, name: &str) -> String {
    for (loads, kind, letter) in [
        (&model.forces, "force_", "F"),
        (&model.moments, "moment_", "M"),
    ] {
        for load in loads {
            let rest = name.strip_prefix(&format!("{kind}{}_", load.name));
            if let Some(axis) = rest {
                let words = load.name.replace('_', r"\ ");
                return format!(r"{letter}_{{\mathrm{{{words}}},{axis}}}");
            }
        }
    }
    latex::name(name, latex::Style::Scalar)
}

/// First and last span of the declaration from which a state derivative follows.
fn rate_place(model: &Model, state: usize) -> (Span, Span, String) {
    if let Some(equation) = model.equations.iter().find(|e| e.state == state) {
        return (equation.span, equation.value.span, String::new());
    }
    let body = model.body.as_ref();
    let span = body.map_or(model.states[state].span, |body| body.span);
    let mut end = span;
    if model.body.is_some()
        && let Some(source) = model.sources.get(usize::from(span.source))
        && let Some(rest) = source.text.get(span.start as usize..)
        && let Some(closed) = rest.find('}')
    {
        end.end = span.start + closed as u32;
    }
    (span, end, String::new())
}

fn source(model: &Model, from: Span, to: Span) -> (String, String) {
    let Some(source) = model.sources.get(usize::from(from.source)) else {
        return (model.name.clone(), String::new());
    };
    let text = &source.text;
    let first = line_of(text, from.start as usize);
    let last = if to.source == from.source {
        line_of(text, to.end as usize).max(first)
    } else {
        first
    };
    let lines = text.lines().skip(first - 1).take(last - first + 1);
    let lines: Vec<&str> = lines.collect();
    let file = source.name.rsplit('/').next().unwrap_or(&source.name);
    (format!("{file}:{first}"), lines.join("\n"))
}

/// Reason why a quantity or derivative cannot be explained.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ExplainError {
    /// No quantity has the requested name.
    #[error(
        "there is no quantity `{wanted}`{}\nthere are: {}",
        suggestion(nearest.as_ref()), known.join(", ")
    )]
    Quantity {
        /// Name that the caller requested.
        wanted: String,
        /// Name of the quantity whose name is most similar to `wanted`; `None` if no quantity has a similar name.
        nearest: Option<String>,
        /// Names of all quantities of the model for which formulas and generated code can be shown.
        known: Vec<String>,
    },
    /// No symbol of this name, with respect to which to differentiate.
    #[error(
        "there is no state, parameter, coefficient or component of an input `{wanted}`{}\nthere are: {}",
        suggestion(nearest.as_ref()), known.join(", ")
    )]
    Wrt {
        /// Name that the caller requested.
        wanted: String,
        /// Name of the symbol whose name is most similar to `wanted`; `None` if no symbol has a similar name.
        nearest: Option<String>,
        /// Names of all symbols of the model with respect to which a quantity can be differentiated.
        known: Vec<String>,
    },
    /// Both a force and a moment have the requested name.
    #[error(
        "a force and a moment are called `{wanted}`: write `force {wanted}` or `moment {wanted}`"
    )]
    Ambiguous {
        /// Name that the caller requested.
        wanted: String,
    },
}

fn suggestion(nearest: Option<&String>) -> String {
    nearest.map_or_else(String::new, |name| format!("; did you mean `{name}`?"))
}

/// Name most similar to `wanted`: one that contains it as a load, derivative or beginning, else the nearest by edits.
fn nearest(wanted: &str, known: &[String]) -> Option<String> {
    let part = |name: &&String| {
        let starts = wanted.len() >= 3 && name.starts_with(wanted);
        starts || name.ends_with(&format!(" {wanted}")) || **name == format!("der({wanted})")
    };
    let near = || nearest_name(wanted, known.iter().map(String::as_str));
    known
        .iter()
        .find(part)
        .cloned()
        .or_else(|| near().map(str::to_owned))
}
