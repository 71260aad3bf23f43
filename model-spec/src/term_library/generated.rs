//! The term library of a model that has none of its own, from the model's named quantities and their units.
//!
//! Channels are the forces along, up across and left across the stream (over the weight on Earth), the moments about the axes
//! of the moments of inertia (over ten times those per s²), or the stated equations (over the state's unit per second).
//! Variables are speed, height, time and rates of a body, the direction of the stream in its axes, the states of stated
//! equations, and named numbers that change in flight and depend on no coefficient, each over a typical size of its unit.

use std::fmt::Write;

use super::{ChannelEntry, LibraryFile, VariableEntry};
use crate::model::{Body, Expr, ExprKind, Model, Shape};
use crate::unit::Unit;

/// Maximum number of variables of which all products of two are formed.
const MAX_IN_PRODUCTS: usize = 4;

/// Maximum number of variables taken from the model's named quantities.
const MAX_NAMED: usize = 3;

/// Maximum number of variables taken from the states of stated equations.
const MAX_STATES: usize = 6;

/// Maximum number of stated equations with channels.
const MAX_EQUATIONS: usize = 8;

/// Needed by every expression that speaks of the stream.
const NEEDS: &str = "needs vector air_velocity: m/s or velocity;";
const ALONG: &str = "unit(in_inertial(air_velocity))";
const LEFT: &str = "unit(cross(inertial.3, in_inertial(air_velocity)))";
const WEIGHT: &str = "mass*(9.80665 [m/s^2])";

/// A variable with its definition and its rank: those of lower rank come first, and take part in products.
struct Variable {
    name: String,
    definition: String,
    depends_on: &'static str,
    rank: u8,
}

/// The library of a model; `None` if the model has neither a body nor equations with channels.
pub(super) fn library(model: &Model) -> Option<LibraryFile> {
    let (mut loads, channels) = match &model.body {
        Some(body) => channels_of_body(model, body),
        None => channels_of_equations(model)?,
    };
    let mut variables = match &model.body {
        Some(body) => variables_of_body(model, body),
        None => variables_of_states(model),
    };
    variables.extend(named_quantities(model));
    variables.push(Variable {
        name: "time".to_owned(),
        definition: "time/(1 s)".to_owned(),
        depends_on: "time",
        rank: 4,
    });
    variables.sort_by_key(|variable| variable.rank);
    let mut entries: Vec<VariableEntry> = Vec::new();
    for variable in variables {
        if entries.iter().any(|entry| entry.name == variable.name) {
            continue;
        }
        let quantity = format!("on_{}", variable.name.replace('-', "_"));
        let _ = writeln!(loads, "let {quantity} = {};", variable.definition);
        entries.push(VariableEntry {
            quantity,
            name: variable.name,
            depends_on: variable.depends_on.to_owned(),
        });
    }
    let names: Vec<String> = entries.iter().map(|entry| entry.name.clone()).collect();
    Some(LibraryFile {
        loads: format!("effect loads_of_no_law {{\nsite unknown;\n{loads}}}\n"),
        products: products(&names),
        variables: entries,
        channels,
    })
}

/// The constant, every variable, and the products of two of the first variables.
fn products(names: &[String]) -> Vec<Vec<String>> {
    let mut products = vec![Vec::new()];
    products.extend(names.iter().map(|name| vec![name.clone()]));
    let first = &names[..names.len().min(MAX_IN_PRODUCTS)];
    for (k, a) in first.iter().enumerate() {
        products.extend(first[k..].iter().map(|b| vec![a.clone(), b.clone()]));
    }
    products
}

fn channel(name: &str, term: String) -> ChannelEntry {
    ChannelEntry {
        coefficient: coefficient(name),
        name: name.to_owned(),
        term,
    }
}

fn coefficient(channel: &str) -> String {
    format!("X_{}", channel.replace('-', "_"))
}

fn channels_of_body(model: &Model, body: &Body) -> (String, Vec<ChannelEntry>) {
    let up = format!("cross({ALONG}, {LEFT})");
    let mut channels = Vec::new();
    let mut loads = format!("{NEEDS}\n");
    for (name, sign, direction) in [("drag", "-", ALONG), ("lift", "", &up), ("side", "", LEFT)] {
        let x = coefficient(name);
        let _ = writeln!(
            loads,
            "coefficient {x} = 0 [1];\nforce {name}_of_no_law = {sign}{WEIGHT}*{x}*{direction};"
        );
        channels.push(channel(
            name,
            format!(
                "effect NAME {{ {NEEDS} site {name}; force NAME = {sign}{WEIGHT}*TERM*{direction}; }}"
            ),
        ));
    }
    if let Some(frame) = axes(model, body) {
        for (k, name) in ["roll", "pitch", "spin"].into_iter().enumerate() {
            let axis = k + 1;
            let x = coefficient(name);
            let scale = format!("inertia_{axis}{axis}*(10 [1/s^2])");
            let _ = writeln!(
                loads,
                "coefficient {x} = 0 [1];\nmoment {name}_of_no_law = {scale}*{x}*{frame}.{axis};"
            );
            channels.push(channel(
                name,
                format!(
                    "effect NAME {{ {NEEDS} site {name}; moment NAME = {scale}*TERM*{frame}.{axis}; }}"
                ),
            ));
        }
    }
    (loads, channels)
}

/// Name of the frame of the moments of inertia; `None` for a point mass.
fn axes<'a>(model: &'a Model, body: &Body) -> Option<&'a str> {
    let rotation = body.rotation.as_ref()?;
    Some(&model.frames[rotation.inertia_frame].name)
}

fn channels_of_equations(model: &Model) -> Option<(String, Vec<ChannelEntry>)> {
    let more_than_a_state = |value: &Expr| !matches!(value.kind, ExprKind::State(_));
    let of_effects: Vec<usize> = model.added_states();
    let equations = model.equations.iter().filter(|equation| {
        more_than_a_state(&equation.value) && !of_effects.contains(&equation.state)
    });
    let (mut loads, mut channels) = (String::new(), Vec::new());
    for equation in equations.take(MAX_EQUATIONS) {
        let state = &model.states[equation.state];
        let rate = state.unit.checked_div(Unit::SECOND)?;
        let name = format!("rate-of-{}", state.name);
        let x = coefficient(&name);
        let state = &state.name;
        let _ = writeln!(
            loads,
            "coefficient {x} = 0 [1];\nreplace der({state}) = previous + {x}*(1 [{rate}]);"
        );
        channels.push(channel(
            &name,
            format!(
                "effect NAME {{ site unknown; replace der({state}) = previous + TERM*(1 [{rate}]); }}"
            ),
        ));
    }
    (!channels.is_empty()).then_some((loads, channels))
}

fn variables_of_body(model: &Model, body: &Body) -> Vec<Variable> {
    let variable = |name: &str, definition: String, depends_on, rank| Variable {
        name: name.to_owned(),
        definition,
        depends_on,
        rank,
    };
    let mut variables = vec![
        variable(
            "speed",
            "norm(air_velocity)/(10 [m/s])".to_owned(),
            "speed",
            0,
        ),
        variable("height", "position.3/(1 m)".to_owned(), "height", 3),
    ];
    if let Some(frame) = axes(model, body) {
        for axis in 1..=3 {
            variables.push(variable(
                &format!("stream-{axis}"),
                format!("dot(unit(in_{frame}(air_velocity)), {frame}.{axis})"),
                "alpha",
                2,
            ));
        }
        for axis in 1..=3 {
            variables.push(variable(
                &format!("rate-{axis}"),
                format!("dot(in_{frame}(angular_velocity), {frame}.{axis})/(10 [rad/s])"),
                "rates",
                3,
            ));
        }
    }
    variables
}

/// States of stated equations.
fn variables_of_states(model: &Model) -> Vec<Variable> {
    let of_effects = model.added_states();
    let own = model.states.iter().enumerate();
    let own = own.filter(|(index, _)| !of_effects.contains(index));
    own.take(MAX_STATES)
        .map(|(_, state)| Variable {
            name: state.name.replace('_', "-"),
            definition: scaled(&state.name, state.unit),
            depends_on: depends_on(&state.name, state.unit),
            rank: 1,
        })
        .collect()
}

/// Numbers with a name that change in flight and depend on no coefficient: pure numbers and angles first, then rates, then
/// others, in the order of the file. Loads are none of them, nor is what a body has already.
fn named_quantities(model: &Model) -> Vec<Variable> {
    let traits = traits(model);
    let loads = [Unit::NEWTON, Unit::NEWTON_METRE];
    let of_body = [Unit::SPEED, Unit::METRE];
    let has_body = model.body.is_some();
    let own = model.aux_variables.iter().zip(&traits);
    let usable = own.filter(|(own, traits)| {
        let unit = own.value.unit;
        traits.varies
            && !traits.is_estimated
            && own.value.shape == Shape::Scalar
            && own.effect.is_none()
            && !own.name.starts_with("der_")
            && !loads.iter().any(|load| load.agrees(unit))
            && !(has_body && of_body.iter().any(|of_body| of_body.agrees(unit)))
    });
    let mut named: Vec<Variable> = usable
        .map(|(own, _)| {
            let unit = own.value.unit;
            let rank = match () {
                () if unit.agrees(Unit::ONE) => 1,
                () if unit.agrees(Unit::RATE) => 2,
                () => 3,
            };
            Variable {
                name: own.name.replace('_', "-"),
                definition: scaled(&own.name, unit),
                depends_on: depends_on(&own.name, unit),
                rank,
            }
        })
        .collect();
    named.sort_by_key(|variable| variable.rank);
    named.truncate(MAX_NAMED);
    named
}

/// A quantity over a typical size of its unit.
fn scaled(name: &str, unit: Unit) -> String {
    match () {
        () if unit.agrees(Unit::ONE) => name.to_owned(),
        () if unit.agrees(Unit::SPEED) || unit.agrees(Unit::RATE) => {
            format!("{name}/(10 [{unit}])")
        }
        () => format!("{name}/(1 [{unit}])"),
    }
}

/// Word for what a quantity is, from its name and unit: one of [`VARIABLES`](crate::VARIABLES).
fn depends_on(name: &str, unit: Unit) -> &'static str {
    match () {
        () if name.contains("alpha") => "alpha",
        () if name.contains("spin") => "spin",
        () if name.contains("height") || name == "z" => "height",
        () if unit.agrees(Unit::RATE) => "rates",
        () if unit.agrees(Unit::ONE) => "attitude",
        () if unit.agrees(Unit::METRE) => "position",
        () => "speed",
    }
}

/// What a named quantity depends on, directly or by others.
#[derive(Clone, Copy, Default)]
struct Traits {
    varies: bool,
    is_estimated: bool,
}

fn traits(model: &Model) -> Vec<Traits> {
    let mut traits: Vec<Traits> = Vec::with_capacity(model.aux_variables.len());
    for own in &model.aux_variables {
        let mut found = Traits::default();
        look(&own.value, &traits, &mut found);
        traits.push(found);
    }
    traits
}

fn look(e: &Expr, before: &[Traits], found: &mut Traits) {
    match e.kind {
        ExprKind::Time
        | ExprKind::State(_)
        | ExprKind::Position
        | ExprKind::Velocity
        | ExprKind::AngularVelocity
        | ExprKind::SpecificForce
        | ExprKind::AngularAcceleration
        | ExprKind::Axis(1.., _) => found.varies = true,
        // Of a marker, and so no quantity of the flight.
        ExprKind::Coefficient(_) | ExprKind::Marker => found.is_estimated = true,
        ExprKind::AuxVariable(index) => {
            let own = before.get(index).copied().unwrap_or_default();
            found.varies |= own.varies;
            found.is_estimated |= own.is_estimated;
        }
        _ => {}
    }
    e.children(&mut |child| look(child, before, found));
}
