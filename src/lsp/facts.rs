//! What a checked model says about a name: value, unit, frame, formula.

use codegen::latex;
use model_spec::model::{
    Expr, ExprKind, FrameKind, Function, Load, Model, Parameter, Shape, Table,
};

/// Longest formula that is shown, characters.
const MAX_FORMULA: usize = 600;

/// Number of elements of an array that are shown.
const MAX_ELEMENTS: usize = 8;

/// A value without its rounding noise, and its unit: `0.03375 m`.
pub fn with_unit(value: f64, unit: &str) -> String {
    model_spec::with_unit(rounded(value), unit)
}

/// The value to twelve significant digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

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

impl Facts {
    fn new(of: impl Into<String>, value: impl Into<String>) -> Facts {
        Facts {
            of: of.into(),
            value: value.into(),
            formula: String::new(),
        }
    }
}

/// What a model says about a parameter, coefficient, input, state, table, marker or named quantity.
pub fn of_value(model: &Model, name: &str) -> Option<Facts> {
    let found = |own: &&Parameter| own.name == name;
    let parameters = model.params.iter().chain(&model.coefficients);
    if let Some(own) = { parameters }.find(found) {
        return Some(of_parameter(own));
    }
    if let Some(own) = model.states.iter().find(|own| own.name == name) {
        let unit = &own.unit_text;
        return Some(Facts::new(unit, with_unit(own.value, unit)));
    }
    if let Some(own) = model.inputs.iter().find(|own| own.name == name) {
        let ([x, y, z], unit) = (own.value.map(rounded), &own.unit_text);
        let of = format!("vector {unit} in {}", frame(model, own.frame));
        return Some(Facts::new(of, format!("({x}, {y}, {z}) {unit}")));
    }
    if let Some(own) = model.marker.as_ref().filter(|own| own.name == name) {
        let of = format!("vector m in {}", frame(model, own.frame));
        return Some(Facts::new(of, ""));
    }
    let own = model.aux_variables.iter().rfind(|own| own.name == name)?;
    Some(Facts::new(shape(model, &own.value), ""))
}

/// What a model says about an array: unit and frame of its first element.
pub fn of_array(model: &Model, name: &str) -> Option<Facts> {
    let first = elements(model, name).next()?;
    Some(Facts::new(of_value(model, first)?.of, ""))
}

/// Names of the elements of an array, in order.
fn elements<'m>(model: &'m Model, name: &str) -> impl Iterator<Item = &'m str> {
    let is_element = move |own: &&str| {
        let index = own
            .strip_prefix(name)
            .and_then(|rest| rest.strip_prefix('_'));
        index.is_some_and(|index| index.chars().all(|c| c == '_' || c.is_ascii_digit()))
    };
    let parameters = model.params.iter().chain(&model.coefficients);
    let given = parameters.map(|own| own.name.as_str());
    let given = given.chain(model.states.iter().map(|own| own.name.as_str()));
    let computed = model.aux_variables.iter().map(|own| own.name.as_str());
    given.chain(computed).filter(is_element)
}

/// Adds value and formula of a named quantity to its unit and frame.
pub fn complete(model: &Model, name: &str, facts: &mut Facts) {
    let own = model.aux_variables.iter().rposition(|own| own.name == name);
    if let Some(own) = own {
        if let Some(value) = constants(model)[own] {
            facts.value = with_unit(value, &unit_of(&model.aux_variables[own].value));
        }
        facts.formula = formula(model, name);
    }
}

/// Adds the values of an array's elements to its unit and frame.
pub fn complete_array(model: &Model, name: &str, facts: &mut Facts) {
    facts.value = values(model, name, &facts.of).unwrap_or_default();
}

/// Values of the first elements of an array, with their unit; `None` if one is not constant.
fn values(model: &Model, name: &str, of: &str) -> Option<String> {
    let known = constants(model);
    let value = |name: &str| {
        let mut parameters = model.params.iter().chain(&model.coefficients);
        let mut states = model.states.iter();
        let given = parameters.find(|own| own.name == name).map(|own| own.value);
        let given = given.or_else(|| Some(states.find(|own| own.name == name)?.value));
        given.or_else(|| {
            known[model
                .aux_variables
                .iter()
                .rposition(|own| own.name == name)?]
        })
    };
    let shown = elements(model, name).take(MAX_ELEMENTS);
    let shown: Option<Vec<String>> = shown.map(|own| Some(with_unit(value(own)?, "1"))).collect();
    let mut shown = shown?.join(", ");
    let count = elements(model, name).count();
    if count > MAX_ELEMENTS {
        shown += &format!(", … {count} elements");
    }
    let unit = of.split(' ').next().filter(|unit| *unit != "1");
    let unit = unit.map_or_else(String::new, |unit| format!(" {unit}"));
    (count > 0).then(|| format!("({shown}){unit}"))
}

/// What a model says about a force or moment.
pub fn of_load(model: &Model, name: &str, is_moment: bool) -> Option<Facts> {
    let (loads, prefix): (&[Load], _) = if is_moment {
        (&model.moments, "moment")
    } else {
        (&model.forces, "force")
    };
    let own = loads.iter().find(|own| own.name == name)?;
    let statement = format!("{prefix} {name}");
    let formula = formula(model, &statement);
    // Expressions cannot name a load.
    let formula = match formula.split_once(" = ") {
        Some((_, value)) => format!("{statement} = {value}"),
        None => formula,
    };
    Some(Facts {
        of: shape(model, &own.value),
        value: String::new(),
        formula,
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
    Some(Facts::new("", value))
}

/// What a model says about a table.
pub fn of_table(model: &Model, name: &str) -> Option<Facts> {
    let own: &Table = model.tables.iter().find(|own| own.name == name)?;
    Some(Facts::new(&own.unit_text, model_spec::knots(own)))
}

fn of_parameter(own: &Parameter) -> Facts {
    let mut value = with_unit(own.value, &own.unit_text);
    if let Some((least, greatest)) = own.bounds {
        value += &format!(" in {} .. {}", rounded(least), rounded(greatest));
    }
    let inferred = if own.inferred { " (inferred)" } else { "" };
    Facts::new(format!("{}{inferred}", own.unit_text), value)
}

fn frame(model: &Model, index: usize) -> &str {
    model
        .frames
        .get(index)
        .map_or("?", |frame| frame.name.as_str())
}

/// Unit as a declaration has it, by its derived symbol where it has one: `N*m`.
fn unit_of(e: &Expr) -> String {
    match e.unit.named() {
        Some(symbol) if !symbol.contains('/') => symbol.replace('·', "*"),
        _ => e.unit.tidy().to_string(),
    }
}

fn shape(model: &Model, e: &Expr) -> String {
    let unit = unit_of(e);
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
