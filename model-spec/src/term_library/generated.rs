//! Generation of a term library for a model that is compatible with no built-in library, from the model's quantities
//! and their units.
//!
//! For a body, the channels are the forces along, upward across and leftward across the relative wind, divided by the
//! weight on Earth, and the moments about the axes of the inertia frame, divided by ten times the moments of inertia
//! per s². For a model without a body, the channels are the derivatives in its equations `der(STATE) = …`, divided by
//! the state's unit per second. The variables are: for a body, its speed, height, angular rates and the direction of
//! the relative wind, otherwise the states; scalar auxiliary variables that vary during a flight and depend on no
//! coefficient; and time. Each variable is divided by a typical magnitude of its unit.

use std::fmt::Write;

use super::{ChannelEntry, LibraryFile, VariableEntry};
use crate::layout::depending_on;
use crate::model::{Body, Expr, ExprKind, Model, Shape};
use crate::unit::Unit;

/// Number of variables, in order of priority, that occur in products of two.
const MAX_IN_PRODUCTS: usize = 4;

const MAX_NAMED: usize = 3;

/// Maximum number of states of a model without a body that become variables of its generated term library.
const MAX_STATES: usize = 6;

const MAX_EQUATIONS: usize = 8;

const NEEDS_AIR_VELOCITY: &str = "needs vector air_velocity: m/s or velocity;";
const DOWNSTREAM: &str = "unit(in_inertial(air_velocity))";
const LEFTWARD: &str = "unit(cross(inertial.3, in_inertial(air_velocity)))";
const WEIGHT: &str = "mass*(9.80665 [m/s^2])";

/// A variable with its definition and its priority, from 0 (highest) to 4.
struct Variable {
    name: String,
    definition: String,
    depends_on: &'static str,
    rank: u8,
}

fn sort_by_rank(variables: &mut [Variable]) {
    variables.sort_by_key(|variable| variable.rank);
}

/// Generates a library; `None` if no equation can take a term.
pub(super) fn library(model: &Model) -> Option<LibraryFile> {
    let Channels {
        mut loads,
        entries: channels,
    } = match &model.body {
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

/// Products by their factors: none, each variable, and pairs of the first [`MAX_IN_PRODUCTS`].
fn products(names: &[String]) -> Vec<Vec<String>> {
    let mut products = vec![Vec::new()];
    products.extend(names.iter().map(|name| vec![name.clone()]));
    let first = &names[..names.len().min(MAX_IN_PRODUCTS)];
    for (k, a) in first.iter().enumerate() {
        products.extend(first[k..].iter().map(|b| vec![a.clone(), b.clone()]));
    }
    products
}

/// Channels of a library, and the statements that add a constant term to each.
struct Channels {
    loads: String,
    entries: Vec<ChannelEntry>,
}

impl Channels {
    /// Adds a channel by the statement of a term with `NAME` and `TERM`, and what the effect needs.
    fn add(&mut self, name: &str, site: &str, needs: &str, statement: &str) {
        let coefficient = format!("X_{}", name.replace('-', "_"));
        let constant = statement.replacen("NAME =", &format!("{name}_of_no_law ="), 1);
        let constant = constant.replacen("TERM*", &format!("{coefficient}*"), 1);
        let _ = writeln!(self.loads, "coefficient {coefficient} = 0 [1];\n{constant}");
        self.entries.push(ChannelEntry {
            coefficient,
            name: name.to_owned(),
            term: format!("effect NAME {{ {needs}site {site}; {statement} }}"),
        });
    }
}

fn channels_of_body(model: &Model, body: &Body) -> Channels {
    let up = format!("cross({DOWNSTREAM}, {LEFTWARD})");
    let mut channels = Channels {
        loads: format!("{NEEDS_AIR_VELOCITY}\n"),
        entries: Vec::new(),
    };
    let needs = format!("{NEEDS_AIR_VELOCITY} ");
    for (name, sign, direction) in [
        ("drag", "-", DOWNSTREAM),
        ("lift", "", &up),
        ("side", "", LEFTWARD),
    ] {
        let statement = format!("force NAME = {sign}{WEIGHT}*TERM*{direction};");
        channels.add(name, name, &needs, &statement);
    }
    if let Some(frame) = axes(model, body) {
        for (name, axis) in ["roll", "pitch", "spin"].into_iter().zip(1..) {
            let scale = format!("inertia_{axis}{axis}*(10 [1/s^2])");
            let statement = format!("moment NAME = {scale}*TERM*{frame}.{axis};");
            channels.add(name, name, &needs, &statement);
        }
    }
    channels
}

/// Name of the frame in which the inertia tensor of `body` has its components; `None` for a point mass.
fn axes<'a>(model: &'a Model, body: &Body) -> Option<&'a str> {
    let rotation = body.rotation.as_ref()?;
    Some(&model.frames[rotation.inertia_frame].name)
}

fn channels_of_equations(model: &Model) -> Option<Channels> {
    let more_than_a_state = |value: &Expr| !matches!(value.kind, ExprKind::State(_));
    let of_effects: Vec<usize> = model.added_states();
    let equations = model.equations.iter().filter(|equation| {
        more_than_a_state(&equation.value) && !of_effects.contains(&equation.state)
    });
    let mut channels = Channels {
        loads: String::new(),
        entries: Vec::new(),
    };
    for equation in equations.take(MAX_EQUATIONS) {
        let state = &model.states[equation.state];
        let rate = state.unit.checked_div(Unit::SECOND)?;
        let state = &state.name;
        let statement = format!("replace der({state}) = previous + TERM*(1 [{rate}]);");
        channels.add(&format!("rate-of-{state}"), "unknown", "", &statement);
    }
    (!channels.entries.is_empty()).then_some(channels)
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

/// Variables for a model without a body: its first [`MAX_STATES`] own states.
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

/// Up to [`MAX_NAMED`] scalar auxiliary variables that vary and depend on no coefficient, no loads and, with a body, no
/// speeds and lengths: dimensionless ones first, then rates.
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

/// Divides a quantity by a typical magnitude: 10 SI units of speed and rate, else 1.
fn scaled(name: &str, unit: Unit) -> String {
    match () {
        () if unit.agrees(Unit::ONE) => name.to_owned(),
        () if unit.agrees(Unit::SPEED) || unit.agrees(Unit::RATE) => {
            format!("{name}/(10 [{unit}])")
        }
        () => format!("{name}/(1 [{unit}])"),
    }
}

/// Kind of variable, guessed from name and unit: one of [`VARIABLES`](crate::VARIABLES).
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
            | ExprKind::BodyRate(..)
            | ExprKind::Axis(1.., _)
    )
}
