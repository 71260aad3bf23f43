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

/// LaTeX of an expression in the model language; `model` is the model that contains the expression.
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
    let mut variables = model.aux_variables.iter();
    if let Some(quantity) = variables.find(|quantity| quantity.name == wanted) {
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

/// Right-hand side of an equation, that of its `der_…` variable if it only refers to one.
fn stated<'a>(model: &'a Model, equation: &'a Equation) -> &'a Expr {
    match equation.value.kind {
        ExprKind::AuxVariable(k) if model.aux_variables[k].name.starts_with("der_") => {
            &model.aux_variables[k].value
        }
        _ => &equation.value,
    }
}

/// LaTeX name of a load, such as `\mathbf{F}_{\mathrm{weight}}`.
pub(crate) fn load_name(letter: &str, load: &str) -> String {
    format!(r"\mathbf{{{letter}}}_{{{}}}", words(load))
}

#[cfg(test)]
mod tests;
