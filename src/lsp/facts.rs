//! What a checked model says about a name: value, unit, frame, formula.

use codegen::latex;
use model_spec::model::{
    Expr, ExprKind, FrameKind, Function, Load, Model, Parameter, Shape, Table,
};
use model_spec::with_unit;

/// Longest formula that is shown, characters.
const MAX_FORMULA: usize = 600;

/// Facts about a name.
#[derive(Default)]
pub struct Facts {
    /// Unit and, of a vector, frame, as in a declaration: `vector m/s in B`; empty for a frame.
    pub of: String,
    /// Value, or how a frame is turned; empty if it is not constant.
    pub value: String,
    /// Formula in plain text; empty if there is none.
    pub formula: String,
}

/// What a model says about a parameter, coefficient, input, state, table, marker or named quantity.
pub fn of_value(model: &Model, name: &str) -> Option<Facts> {
    let found = |own: &&Parameter| own.name == name;
    let parameters = model.params.iter().chain(&model.coefficients);
    if let Some(own) = { parameters }.find(found) {
        return Some(of_parameter(own));
    }
    if let Some(own) = model.states.iter().find(|own| own.name == name) {
        return Some(Facts {
            of: own.unit_text.clone(),
            value: with_unit(own.value, &own.unit_text),
            ..Facts::default()
        });
    }
    if let Some(own) = model.inputs.iter().find(|own| own.name == name) {
        let ([x, y, z], unit) = (own.value, &own.unit_text);
        return Some(Facts {
            of: format!("vector {unit} in {}", frame(model, own.frame)),
            value: format!("({x}, {y}, {z}) {unit}"),
            ..Facts::default()
        });
    }
    if let Some(own) = model.marker.as_ref().filter(|own| own.name == name) {
        return Some(Facts {
            of: format!("vector m in {}", frame(model, own.frame)),
            ..Facts::default()
        });
    }
    let own = model.aux_variables.iter().rfind(|own| own.name == name)?;
    Some(Facts {
        of: shape(model, &own.value),
        ..Facts::default()
    })
}

/// Adds value and formula of a named quantity to its unit and frame.
pub fn complete(model: &Model, name: &str, facts: &mut Facts) {
    let own = model.aux_variables.iter().rposition(|own| own.name == name);
    if let Some(own) = own {
        let unit = model.aux_variables[own].value.unit.tidy().to_string();
        if let Some(value) = constants(model)[own] {
            facts.value = with_unit(value, &unit);
        }
        facts.formula = formula(model, name);
    }
}

/// What a model says about a force or moment.
pub fn of_load(model: &Model, name: &str, is_moment: bool) -> Option<Facts> {
    let (loads, prefix): (&[Load], _) = if is_moment {
        (&model.moments, "moment")
    } else {
        (&model.forces, "force")
    };
    let own = loads.iter().find(|own| own.name == name)?;
    Some(Facts {
        of: shape(model, &own.value),
        value: String::new(),
        formula: formula(model, &format!("{prefix} {name}")),
    })
}

/// What a model says about a frame.
pub fn of_frame(model: &Model, name: &str) -> Option<Facts> {
    let own = model.frames.iter().find(|own| own.name == name)?;
    let state = |k: usize| model.states.get(k).map_or("", |state| state.name.as_str());
    let value = match own.kind {
        FrameKind::Inertial => "inertial, axis 3 up".to_owned(),
        FrameKind::Turned {
            parent,
            angle,
            axis,
            ..
        } => {
            format!(
                "{} turned {} about {axis}",
                frame(model, parent),
                state(angle)
            )
        }
        FrameKind::Fixed {
            parent,
            angle,
            axis,
        } => {
            let angle = model.text(model.constant_angles[angle].span);
            format!("{} turned {angle} about {axis}", frame(model, parent))
        }
        FrameKind::Quaternion { parent, states } => {
            format!(
                "{} by quaternion ({})",
                frame(model, parent),
                states.map(state).join(", ")
            )
        }
    };
    Some(Facts {
        value,
        ..Facts::default()
    })
}

/// What a model says about a table.
pub fn of_table(model: &Model, name: &str) -> Option<Facts> {
    let own: &Table = model.tables.iter().find(|own| own.name == name)?;
    Some(Facts {
        of: own.unit_text.clone(),
        value: model_spec::knots(own),
        formula: String::new(),
    })
}

fn of_parameter(own: &Parameter) -> Facts {
    let mut value = with_unit(own.value, &own.unit_text);
    if let Some((least, greatest)) = own.bounds {
        value += &format!(" in {least} .. {greatest}");
    }
    let inferred = if own.inferred { " (inferred)" } else { "" };
    Facts {
        of: format!("{}{inferred}", own.unit_text),
        value,
        formula: String::new(),
    }
}

fn frame(model: &Model, index: usize) -> &str {
    model
        .frames
        .get(index)
        .map_or("?", |frame| frame.name.as_str())
}

fn shape(model: &Model, e: &Expr) -> String {
    let unit = match e.unit.named() {
        Some(symbol) if symbol.chars().all(char::is_alphabetic) => symbol.to_owned(),
        _ => e.unit.tidy().to_string(),
    };
    match e.shape {
        Shape::Scalar => unit,
        Shape::Vector(of) if unit == "1" => format!("vector in {}", frame(model, of)),
        Shape::Vector(of) => format!("vector {unit} in {}", frame(model, of)),
    }
}

fn formula(model: &Model, name: &str) -> String {
    let formula = latex::definition(model, name).filter(|latex| latex.len() < 4 * MAX_FORMULA);
    let formula = formula.map(|latex| report::plain_formula(&latex));
    formula
        .filter(|text| text.chars().count() <= MAX_FORMULA)
        .unwrap_or_default()
}

/// Values at the defaults of the named quantities that are constant in flight; `None` for others and those of tables.
fn constants(model: &Model) -> Vec<Option<f64>> {
    let mut values = Vec::with_capacity(model.aux_variables.len());
    for variable in &model.aux_variables {
        let value = constant(model, &values, &variable.value);
        values.push(value);
    }
    values
}

fn constant(model: &Model, known: &[Option<f64>], e: &Expr) -> Option<f64> {
    let of = |e: &Expr| constant(model, known, e);
    Some(match &e.kind {
        ExprKind::Number { value, .. } => *value,
        ExprKind::Pi => std::f64::consts::PI,
        ExprKind::Param(k) => model.params.get(*k).filter(|own| !own.varies)?.value,
        ExprKind::Coefficient(k) => model.coefficients.get(*k)?.value,
        ExprKind::AuxVariable(k) => (*known.get(*k)?)?,
        ExprKind::Neg(a) => -of(a)?,
        ExprKind::Add(a, b) => of(a)? + of(b)?,
        ExprKind::Sub(a, b) => of(a)? - of(b)?,
        ExprKind::Mul(a, b) => of(a)? * of(b)?,
        ExprKind::Div(a, b) => of(a)? / of(b)?,
        ExprKind::Pow(a, doubled) => of(a)?.powf(f64::from(*doubled) / 2.0),
        ExprKind::Call(function, a) => called(*function, of(a)?)?,
        _ => return None,
    })
}

fn called(function: Function, x: f64) -> Option<f64> {
    Some(match function {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.tan(),
        Function::Sqrt => x.max(0.0).sqrt(),
        Function::Exp => x.exp(),
        Function::Abs => x.abs(),
        _ => return None,
    })
}
