//! Generation of a term library for a model that is compatible with no built-in library, from the model's quantities
//! and their units.
//!
//! For a body, the channels (quantities to which terms can be added) are the forces along, upward across and leftward
//! across the relative wind, divided by the weight on Earth, and the moments about the axes of the inertia frame,
//! divided by ten times the moments of inertia per s². For a model without a body, the channels are the derivatives in
//! its equations `der(STATE) = …`, divided by the state's unit per second. The variables are: for a body, its speed,
//! height, angular rates and the direction of the relative wind, otherwise the states; scalar auxiliary variables that
//! vary during a flight and depend on no coefficient; and time. Each variable is divided by a typical magnitude of its
//! unit.

use std::fmt::Write;

use super::{ChannelEntry, LibraryFile, VariableEntry};
use crate::layout::depending_on;
use crate::model::{Body, Expr, ExprKind, Model, Shape};
use crate::unit::Unit;

/// Number of variables, in order of priority, that a generated library of candidate terms combines in products of two
/// (squares included). Further variables occur in no product of two.
const MAX_IN_PRODUCTS: usize = 4;

/// Maximum number of auxiliary variables of a model that become variables of its generated term library (library of
/// terms that the model may lack).
const MAX_NAMED: usize = 3;

/// Maximum number of states of a model without a body that become variables of its generated term library (library of
/// terms that the model may lack).
const MAX_STATES: usize = 6;

/// Maximum number of explicitly written equations `der(STATE) = …` of a model to which the generated library of
/// candidate terms can add a term; further equations are skipped.
const MAX_EQUATIONS: usize = 8;

/// `needs` statement of every generated effect (addition of one candidate term to a model) that uses `air_velocity`,
/// the velocity of the body relative to the air. In a model without `air_velocity`, the velocity of the body replaces
/// it.
const NEEDS_AIR_VELOCITY: &str = "needs vector air_velocity: m/s or velocity;";
const DOWNSTREAM: &str = "unit(in_inertial(air_velocity))";
const LEFTWARD: &str = "unit(cross(inertial.3, in_inertial(air_velocity)))";
const WEIGHT: &str = "mass*(9.80665 [m/s^2])";

/// A variable of the generated term library, with its definition. `rank` is its priority, from 0 (highest) to 4:
/// variables are sorted by ascending rank, and products of two are formed only of the first [`MAX_IN_PRODUCTS`]
/// variables.
struct Variable {
    name: String,
    definition: String,
    depends_on: &'static str,
    rank: u8,
}

fn sort_by_rank(variables: &mut [Variable]) {
    variables.sort_by_key(|variable| variable.rank);
}

/// Generates a library of candidate terms for a model. `None` if there is nothing to which a term can be added. This is
/// the case if the model has no body, and each equation in the model file only equates a derivative with a state, as in
/// `der(phi) = phidot`.
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
    sort_by_rank(&mut variables);
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

/// Products that a generated term library contains, each as the list of its factors: an empty list for the constant 1,
/// each of the variables `names` alone, and each pair of the first [`MAX_IN_PRODUCTS`] variables (squares included).
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
    let up = format!("cross({DOWNSTREAM}, {LEFTWARD})");
    let mut channels = Vec::new();
    let mut loads = format!("{NEEDS_AIR_VELOCITY}\n");
    for (name, sign, direction) in [
        ("drag", "-", DOWNSTREAM),
        ("lift", "", &up),
        ("side", "", LEFTWARD),
    ] {
        let x = coefficient(name);
        let _ = writeln!(
            loads,
            "coefficient {x} = 0 [1];\nforce {name}_of_no_law = {sign}{WEIGHT}*{x}*{direction};"
        );
        channels.push(channel(
            name,
            format!(
                "effect NAME {{ {NEEDS_AIR_VELOCITY} site {name}; force NAME = {sign}{WEIGHT}*TERM*{direction}; }}"
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
                    "effect NAME {{ {NEEDS_AIR_VELOCITY} site {name}; moment NAME = {scale}*TERM*{frame}.{axis}; }}"
                ),
            ));
        }
    }
    (loads, channels)
}

/// Name of the frame in which the inertia tensor of `body` has its components; `None` for a point mass.
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

/// Variables of the term library for a model without a body: one for each of the first [`MAX_STATES`] states that the
/// model declares itself, not through effects.
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

/// Selects up to [`MAX_NAMED`] variables of the term library from the scalar auxiliary variables that vary during a
/// flight and depend on no coefficient. Forces and moments are excluded; in a model with a body, also speeds and
/// lengths. Dimensionless quantities come first, then rates in rad/s or 1/s, then others, each in the order of the
/// file.
fn named_quantities(model: &Model) -> Vec<Variable> {
    let varies = depending_on(model, is_variable);
    // The marker belongs to an observation, so it is excluded like a coefficient.
    let is_estimated = depending_on(model, |kind| {
        matches!(kind, ExprKind::Coefficient(_) | ExprKind::Marker)
    });
    let loads = [Unit::NEWTON, Unit::NEWTON_METRE];
    let of_body = [Unit::SPEED, Unit::METRE];
    let has_body = model.body.is_some();
    let own = model.aux_variables.iter().enumerate();
    let usable = own.filter(|(index, own)| {
        let unit = own.value.unit;
        varies[*index]
            && !is_estimated[*index]
            && own.value.shape == Shape::Scalar
            && own.effect.is_none()
            && !own.name.starts_with("der_")
            && !loads.iter().any(|load| load.agrees(unit))
            && !(has_body && of_body.iter().any(|of_body| of_body.agrees(unit)))
    });
    let mut named: Vec<Variable> = usable
        .map(|(_, own)| {
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
    sort_by_rank(&mut named);
    named.truncate(MAX_NAMED);
    named
}

/// Text of the expression that divides a quantity by a typical magnitude: 10 SI units for speeds and angular rates, 1
/// SI unit for others. A dimensionless quantity is not divided.
fn scaled(name: &str, unit: Unit) -> String {
    match () {
        () if unit.agrees(Unit::ONE) => name.to_owned(),
        () if unit.agrees(Unit::SPEED) || unit.agrees(Unit::RATE) => {
            format!("{name}/(10 [{unit}])")
        }
        () => format!("{name}/(1 [{unit}])"),
    }
}

/// Kind of variable to which a quantity belongs, guessed from the name and unit of the quantity: one of
/// [`VARIABLES`](crate::VARIABLES), such as `spin` or `height`.
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

/// Whether a leaf of an expression has a value that varies during a flight.
fn is_variable(kind: &ExprKind) -> bool {
    matches!(
        kind,
        ExprKind::Time
            | ExprKind::State(_)
            | ExprKind::Position
            | ExprKind::Velocity
            | ExprKind::AngularVelocity
            | ExprKind::SpecificForce
            | ExprKind::AngularAcceleration
            | ExprKind::Axis(1.., _)
    )
}
