//! What a model declares: states, parameters, inputs, marker, auxiliary variables and limits.

use super::SCHEMA;
use super::text::{Field, NotFinite, lines, number, numbers, object, row, string};
use model_spec::layout::{Layout, is_of_observation};
use model_spec::model::{Input, Model, Parameter, Shape, State, ValidityLimit};

/// Fields of the model, from the schema to the limits of validity.
pub(super) fn fields(model: &Model, layout: &Layout) -> Result<Vec<Field>, NotFinite> {
    let effects = model.effects.iter().map(|effect| string(&effect.name));
    Ok(vec![
        ("schema", string(SCHEMA)),
        ("version", string(env!("CARGO_PKG_VERSION"))),
        ("model", string(&model.name)),
        ("effects", row(effects)),
        ("states", each(&model.states, state)?),
        ("parameters", parameters(model)?),
        ("inputs", each(&model.inputs, |i| Ok(input(model, i)))?),
        ("marker", row(layout.marker.iter().map(|name| string(name)))),
        ("quantities", quantities(model, layout)),
        ("limits", each(&model.limits, limit)?),
    ])
}

/// List with one line for each of `items`.
fn each<T>(
    items: &[T],
    json: impl Fn(&T) -> Result<String, NotFinite>,
) -> Result<String, NotFinite> {
    Ok(lines(
        items.iter().map(json).collect::<Result<Vec<_>, _>>()?,
    ))
}

fn state(state: &State) -> Result<String, NotFinite> {
    value(&state.name, &state.unit_text, state.value, &[])
}

/// Object of a value with a name, a unit and a default; `more` are further fields.
fn value(name: &str, unit: &str, value: f64, more: &[Field]) -> Result<String, NotFinite> {
    let mut fields = vec![
        ("name", string(name)),
        ("unit", self::unit(unit)),
        ("value", number(value, name)?),
    ];
    fields.extend_from_slice(more);
    Ok(object(&fields, ""))
}

/// A unit; 1 for pure numbers, whose unit a model file may write as `[1]`.
fn unit(text: &str) -> String {
    string(if text == "[1]" { "1" } else { text })
}

/// Known constants, then coefficients, then components of inputs, in the order of `Layout::parameters`.
fn parameters(model: &Model) -> Result<String, NotFinite> {
    let constants = model
        .params
        .iter()
        .map(|constant| parameter(constant, false));
    let coefficients = model.coefficients.iter().map(|c| parameter(c, true));
    let inputs = model.inputs.iter().flat_map(components);
    let all = constants.chain(coefficients).chain(inputs);
    Ok(lines(all.collect::<Result<Vec<_>, _>>()?))
}

fn parameter(parameter: &Parameter, coefficient: bool) -> Result<String, NotFinite> {
    let Parameter {
        name, unit_text, ..
    } = parameter;
    let bounds = match parameter.bounds {
        Some((low, high)) => numbers(&[low, high], name)?,
        None => "null".into(),
    };
    let more = [
        ("coefficient", coefficient.to_string()),
        ("bounds", bounds),
        ("doc", string(&parameter.doc)),
    ];
    value(name, unit_text, parameter.value, &more)
}

fn components(input: &Input) -> [Result<String, NotFinite>; 3] {
    [0, 1, 2].map(|k| {
        let more = [
            ("coefficient", "false".into()),
            ("bounds", "null".into()),
            ("doc", string(&input.doc)),
        ];
        let name = component(&input.name, k);
        value(&name, &input.unit_text, input.value[k], &more)
    })
}

fn component(vector: &str, k: usize) -> String {
    format!("{vector}_{}", ["x", "y", "z"][k])
}

fn input(model: &Model, input: &Input) -> String {
    let parameters = [0, 1, 2].map(|k| string(&component(&input.name, k)));
    let fields = [
        ("name", string(&input.name)),
        ("unit", unit(&input.unit_text)),
        ("frame", string(&model.frames[input.frame].name)),
        ("parameters", row(parameters)),
    ];
    object(&fields, "")
}

/// Auxiliary variables by component, in the order of `Layout::quantities`.
fn quantities(model: &Model, layout: &Layout) -> String {
    let known = model.aux_variables.iter().zip(is_of_observation(model));
    let units = known.filter(|(_, observed)| !observed).flat_map(|(v, _)| {
        let components = match v.value.shape {
            Shape::Scalar => 1,
            Shape::Vector(_) => 3,
        };
        std::iter::repeat_n(v.value.unit.to_string(), components)
    });
    lines(
        layout
            .quantities
            .iter()
            .zip(units)
            .map(|(name, unit)| object(&[("name", string(name)), ("unit", string(&unit))], "")),
    )
}

fn limit(limit: &ValidityLimit) -> Result<String, NotFinite> {
    let fields = [
        ("bound", number(limit.bound, "a limit")?),
        ("reason", string(&limit.reason)),
    ];
    Ok(object(&fields, ""))
}
