//! LaTeX formulas, in the notation of the paper, of a model's expressions and of expression graph nodes.
//!
//! The output requires `amsmath` (or MathJax, KaTeX).

mod names;
pub(crate) mod node;
pub(crate) mod piece;
mod tree;

pub(crate) use names::{Style, name, rate};

use model_spec::model::{Equation, Expr, ExprKind, Load, Model};
use names::words;

/// LaTeX of an expression of a model.
pub fn expression(model: &Model, expr: &Expr) -> String {
    tree::piece(model, expr).text
}

/// LaTeX formula `left = right` of an auxiliary variable, a force, a moment, or the derivative `der(u)` of a state for
/// which the model contains an equation; `None` for an unknown name. If a force and a moment have the same name, `force
/// aero` and `moment aero` select one of them; the name without prefix refers to the force.
pub fn definition(model: &Model, name: &str) -> Option<String> {
    sides(model, name).map(|(left, right)| format!("{left} = {right}"))
}

/// LaTeX of the left-hand and right-hand side of the definition of the quantity `wanted`; `None` for an unknown name.
pub(crate) fn sides(model: &Model, wanted: &str) -> Option<(String, String)> {
    if let Some(quantity) = model
        .aux_variables
        .iter()
        .find(|quantity| quantity.name == wanted)
    {
        let left = name(&quantity.name, tree::style(&quantity.value));
        return Some((left, expression(model, &quantity.value)));
    }
    let load = |loads: &[Load], letter: &str, prefix: &str| {
        let bare = wanted.strip_prefix(prefix).unwrap_or(wanted);
        let load = loads.iter().find(|load| load.name == bare)?;
        Some((
            load_name(letter, &load.name),
            expression(model, &load.value),
        ))
    };
    let equation = || {
        let equation = model
            .equations
            .iter()
            .find(|equation| format!("der({})", model.states[equation.state].name) == wanted)?;
        let state = &model.states[equation.state].name;
        Some((rate(state), expression(model, stated(model, equation))))
    };
    load(&model.forces, "F", "force ")
        .or_else(|| load(&model.moments, "M", "moment "))
        .or_else(equation)
}

/// Right-hand side of an equation. If the right-hand side is only a reference to an auxiliary variable whose name
/// begins with `der_`, the definition of that variable is returned instead.
fn stated<'a>(model: &'a Model, equation: &'a Equation) -> &'a Expr {
    match equation.value.kind {
        ExprKind::AuxVariable(k) if model.aux_variables[k].name.starts_with("der_") => {
            &model.aux_variables[k].value
        }
        _ => &equation.value,
    }
}

/// LaTeX name of a force or moment: the bold letter `letter` (F or M) with the name `load` of the force or moment as
/// subscript, as in `\mathbf{F}_{\mathrm{weight}}`.
pub(crate) fn load_name(letter: &str, load: &str) -> String {
    format!(r"\mathbf{{{letter}}}_{{{}}}", words(load))
}

/// All equations of motion of a model as one LaTeX `align*` environment.
pub fn model(model: &Model) -> String {
    let mut lines: Vec<(String, String)> = Vec::new();
    for quantity in &model.aux_variables {
        // Stated derivatives that other expressions use are auxiliary variables too; the equations below include them.
        if !quantity.name.starts_with("der_") {
            lines.extend(sides(model, &quantity.name));
        }
    }
    for (loads, letter) in [(&model.forces, "F"), (&model.moments, "M")] {
        for load in loads {
            lines.push((
                load_name(letter, &load.name),
                expression(model, &load.value),
            ));
        }
    }
    if let Some(body) = &model.body {
        let sum = |loads: &[Load], letter: &str| match loads {
            [] => r"\mathbf{0}".to_string(),
            _ => {
                let names: Vec<String> = loads
                    .iter()
                    .map(|load| load_name(letter, &load.name))
                    .collect();
                names.join(" + ")
            }
        };
        let mass = tree::piece(model, &body.mass).at_least(piece::Bind::Product);
        lines.push((
            format!(r"{} \dot{{\mathbf{{v}}}}", mass.text),
            sum(&model.forces, "F"),
        ));
        if body.rotation.is_some() {
            let momentum = r"\frac{\mathrm{d}}{\mathrm{d}t} (\mathbf{I} \boldsymbol{\omega})";
            lines.push((momentum.to_string(), sum(&model.moments, "M")));
        }
    }
    for equation in &model.equations {
        let state = &model.states[equation.state].name;
        let line = (rate(state), expression(model, stated(model, equation)));
        // Skips trivial equations: a state that is named as the rate of another.
        if line.0 != line.1 {
            lines.push(line);
        }
    }
    if let Some(clock) = &model.clock {
        let left = r"\frac{\mathrm{d}t}{\mathrm{d}t_{\mathrm{clock}}}".to_string();
        lines.push((left, expression(model, &clock.value)));
    }
    if let Some(observation) = &model.observation {
        let left = format!(r"\mathbf{{y}}_{{{}}}", words(&observation.name));
        lines.push((left, expression(model, &observation.value)));
    }
    let lines: Vec<String> = lines
        .into_iter()
        .map(|(left, right)| format!("  {left} &= {right}"))
        .collect();
    format!(
        "\\begin{{align*}}\n{}\n\\end{{align*}}\n",
        lines.join(" \\\\\n")
    )
}

#[cfg(test)]
mod tests;
