//! Summary of a model as text.

use crate::check::singular_points;
use crate::location::line_of;
use crate::model::{
    Continuation, EffectUnknown, ExprKind, Function, Interpolation, Load, Model, Parameter, Table,
    ValidityLimit,
};
use crate::syntax::ast::{BodyClass, ItemKind, LoadClass};
use crate::syntax::of_kind;
use std::fmt::Write;

/// Summary of a model as text: states, parameters with units, forces, validity limits, singular points, effects.
pub fn summary(model: &Model) -> String {
    let mut out = String::new();
    let _ = write(&mut out, model);
    out.lines()
        .map(|line| line.trim_end().to_owned() + "\n")
        .collect()
}

fn write(out: &mut String, model: &Model) -> std::fmt::Result {
    writeln!(out, "model {}", model.name)?;
    if let Some(line) = model.doc.lines().next() {
        writeln!(out, "  {line}")?;
    }
    if let Some(reference) = &model.reference {
        writeln!(out, "  verified against {reference}")?;
    }
    let width = model.states.iter().map(|s| s.name.len()).max().unwrap_or(0);
    let states = model.states.iter();
    let states = states.map(|s| format!("{:width$}  {}", s.name, s.unit_text));
    section(out, "states", states)?;
    section(
        out,
        "frames",
        model.tree.frames().map(|frame| {
            let kind = frame.kind.to_string();
            let kind = kind.strip_prefix(" = ").unwrap_or("inertial, axis 3 up");
            format!("{}: {kind}", frame.name.text)
        }),
    )?;
    let (varying, constant): (Vec<_>, Vec<_>) = model.params.iter().partition(|p| p.varies);
    constants(out, "parameters", &constant)?;
    constants(
        out,
        "coefficients",
        &model.coefficients.iter().collect::<Vec<_>>(),
    )?;
    constants(out, "inputs over time", &varying)?;
    section(
        out,
        "inputs",
        model.inputs.iter().map(|input| {
            let ([x, y, z], unit) = (input.value, &input.unit_text);
            let frame = &model.frames[input.frame].name;
            let doc = first(&input.doc);
            format!("{} = ({x}, {y}, {z}) {unit} in {frame}   {doc}", input.name)
        }),
    )?;
    section(out, "tables", model.tables.iter().map(table))?;
    equations(out, model)?;
    observation(out, model)?;
    section(
        out,
        "limits",
        { model.limits.iter().enumerate() }
            .filter(|(_, limit)| !is_of_system(limit))
            .map(|(index, limit)| {
                if let Some(allowed) = tolerance(limit) {
                    // Behind a constraint come its derivatives.
                    let is_first = index == 0 || model.limits[index - 1].span != limit.span;
                    return match is_first {
                        true => model.text(limit.span).trim_end_matches(';').to_owned(),
                        false => format!("  its derivative within {allowed}"),
                    };
                }
                let text = if model.is_automatic(limit) {
                    automatic(model, limit)
                } else {
                    model.text(limit.value.span)
                };
                let bound = with_unit(limit.bound, &limit.value.unit.tidy().to_string());
                format!("{text} > {bound}   {}", limit.reason)
            }),
    )?;
    // The points are in the order of their spans, so that each text is read once.
    let mut read = vec![(0, 1); model.sources.len()];
    let points = singular_points(model);
    let points = points.iter().map(|point| {
        let (text, what) = (&point.text, &point.what);
        let index = usize::from(point.span.source);
        let Some(source) = model.sources.get(index) else {
            return format!("line 1: {text} {what}");
        };
        let (from, line) = &mut read[index];
        let start = point.span.range().start.max(*from);
        *line += line_of(&source.text[*from..], start - *from) - 1;
        *from = start;
        let file = match index {
            0 => String::new(),
            _ => format!("{}, ", source.name),
        };
        format!("{file}line {line}: {text} {what}")
    });
    section(out, "singular points", points)?;
    if !model.checks.is_empty() {
        writeln!(out, "\nchecks in the file: {}", model.checks.len())?;
    }
    let offers = model.tree.effects();
    let offers = offers.map(|offer| format!("{}   {}", offer.name.text, first(&offer.doc)));
    section(out, "effects that can be switched on", offers)?;
    effects(out, model)
}

/// Writes a title and indented lines; nothing if there are no lines.
fn section(out: &mut String, title: &str, lines: impl Iterator<Item = String>) -> std::fmt::Result {
    let mut lines = lines.peekable();
    if lines.peek().is_some() {
        writeln!(out, "\n{title}")?;
    }
    lines.try_for_each(|line| writeln!(out, "  {line}"))
}

fn equations(out: &mut String, model: &Model) -> std::fmt::Result {
    let kind = |is_rigid: bool| if is_rigid { "rigid body" } else { "point" };
    if let Some(body) = &model.body {
        let loads = |loads: &[Load]| {
            let names: Vec<&str> = loads.iter().map(|load| load.name.as_str()).collect();
            names.join(", ")
        };
        let kind = kind(body.rotation.is_some());
        writeln!(out, "\n{kind} {}", body.name)?;
        writeln!(out, "  forces   {}", loads(&model.forces))?;
        if body.rotation.is_some() {
            writeln!(out, "  moments  {}", loads(&model.moments))?;
        }
        if let Some(rotation) = &body.rotation
            && rotation.angular_velocity_frame != rotation.inertia_frame
        {
            let inertia = &model.frames[rotation.inertia_frame].name;
            let rates = &model.frames[rotation.angular_velocity_frame].name;
            let line = format!("inertia in {inertia}, angular velocity seen in {rates}");
            writeln!(out, "  {line}")?;
        }
    } else {
        let count = model.equations.len();
        writeln!(out, "\nequations stated outright for all {count} states")?;
        if let Some(claim) = &model.claim {
            let kind = kind(claim.rotation.is_some());
            let force = model.text(claim.force.span);
            writeln!(out, "  claimed to be those of the {kind} {}", claim.name)?;
            writeln!(out, "  force    {force}")?;
            if let Some(rotation) = &claim.rotation {
                writeln!(out, "  moment   {}", model.text(rotation.moment.span))?;
            }
        }
    }
    for body in of_kind!(model.tree.items.iter(), ItemKind::Body).skip(1) {
        let name = &body.name.text;
        writeln!(out, "\n{} {name}", kind(body.class == BodyClass::Rigid))?;
        for class in [LoadClass::Force, LoadClass::Moment] {
            let loads = of_kind!(model.tree.items.iter(), ItemKind::Load);
            let own = loads.filter(|load| load.class == class && load.is_on(name));
            let names: Vec<&str> = own.map(|load| load.name.text.as_str()).collect();
            if !names.is_empty() {
                writeln!(
                    out,
                    "  {:<8} {}",
                    format!("{}s", class.keyword()),
                    names.join(", ")
                )?;
            }
        }
    }
    for system in &model.systems {
        let unknowns: Vec<&str> = system.unknowns.iter().map(|own| &*own.name).collect();
        let title = system.title.replace('`', "");
        writeln!(out, "  {title}: {} together", unknowns.join(", "))?;
    }
    Ok(())
}

fn observation(out: &mut String, model: &Model) -> std::fmt::Result {
    if let (Some(observation), Some(marker)) = (&model.observation, &model.marker) {
        let frame = &model.frames[marker.frame].name;
        let name = &observation.name;
        writeln!(out, "\nobserved: {name} of a marker fixed in {frame}")?;
    } else if let Some(observation) = &model.observation {
        writeln!(out, "\nobserved: {}", observation.name)?;
    }
    if let Some(clock) = &model.clock {
        let text = model.text(clock.value.span);
        writeln!(out, "\nseconds of flight per second of the clock: {text}")?;
    }
    Ok(())
}

fn effects(out: &mut String, model: &Model) -> std::fmt::Result {
    for effect in &model.effects {
        let doc = first(&effect.doc);
        writeln!(out, "\neffect {} on {}   {doc}", effect.name, effect.site)?;
        if !effect.variables.is_empty() {
            writeln!(out, "  depends on {}", effect.variables.join(", "))?;
        }
        for coefficient in &effect.coefficients {
            let constant = &model.coefficients[coefficient.index];
            unknown(out, &constant.name, coefficient, &constant.unit_text)?;
        }
        for own in &effect.states {
            let state = &model.states[own.index];
            let what = format!("{}, of each flight its own,", state.name);
            unknown(out, &what, own, &state.unit_text)?;
        }
    }
    Ok(())
}

fn unknown(out: &mut String, what: &str, unknown: &EffectUnknown, unit: &str) -> std::fmt::Result {
    let value = |value: f64| with_unit(value, unit);
    write!(out, "  {what} vanishes at {}", value(unknown.null_value))?;
    if let Some(size) = unknown.smallest_effect_of_interest {
        write!(out, ", a departure below {} does not matter", value(size))?;
    }
    writeln!(out)
}

/// Number and range of the knots of each argument of a table.
pub fn knots(table: &Table) -> String {
    let knots = table.arguments.iter().map(|own| {
        let at = |knot: Option<&f64>| with_unit(knot.copied().unwrap_or_default(), &own.unit_text);
        let (from, to) = (at(own.knots.first()), at(own.knots.last()));
        format!("{} knots from {from} to {to}", own.knots.len())
    });
    knots.collect::<Vec<_>>().join(" by ")
}

fn table(table: &Table) -> String {
    let knots = knots(table);
    let way = match table.interpolation {
        Interpolation::Spline => "spline",
        Interpolation::Monotone => "monotone",
        Interpolation::Linear => "straight lines",
    };
    let beyond = match table.continuation {
        Continuation::Linear => "linear",
        Continuation::Constant => "constant",
    };
    let unit = match table.unit_text.as_str() {
        "1" => String::new(),
        unit => format!(" in {unit}"),
    };
    let arguments = table.arguments.iter().map(|own| own.name.as_str());
    let (name, arguments) = (&table.name, arguments.collect::<Vec<_>>().join(", "));
    let doc = first(&table.doc);
    format!("{name}({arguments}){unit}, {knots}, {way}, {beyond} beyond   {doc}")
}

/// Whether the limit ends where a block `solve` does not determine its unknowns.
fn is_of_system(limit: &ValidityLimit) -> bool {
    matches!(limit.value.kind, ExprKind::Determinacy(_))
}

/// By how much the sides of a constraint, or of its derivative, may differ; `None` for other limits.
fn tolerance(limit: &ValidityLimit) -> Option<String> {
    match &limit.value.kind {
        ExprKind::Sub(allowed, size) if size.span == limit.span => match allowed.kind {
            ExprKind::Number { value, .. } => {
                Some(with_unit(value, &allowed.unit.tidy().to_string()))
            }
            _ => None,
        },
        _ => None,
    }
}

/// Text of a limit that avoids gimbal lock, such as `cos(theta)`.
fn automatic(model: &Model, limit: &ValidityLimit) -> String {
    if let ExprKind::Call(function, angle) = &limit.value.kind
        && let ExprKind::State(state) = angle.kind
    {
        let name = match function {
            Function::Cos => "cos",
            _ => "sin",
        };
        return format!("{name}({})", model.states[state].name);
    }
    String::new()
}

fn first(doc: &str) -> &str {
    doc.lines().next().unwrap_or("")
}

/// Formats a value with its unit; the unit `1` is omitted.
pub fn with_unit(value: f64, unit: &str) -> String {
    let small = value != 0.0 && value.abs() < 1e-3;
    let number = if small {
        format!("{value:e}")
    } else {
        value.to_string()
    };
    if unit == "1" {
        number
    } else {
        format!("{number} {unit}")
    }
}

fn constants(out: &mut String, title: &str, constants: &[&Parameter]) -> std::fmt::Result {
    let width = constants.iter().map(|c| c.name.len()).max().unwrap_or(0);
    section(
        out,
        title,
        constants.iter().map(|c| {
            let mut value = with_unit(c.value, &c.unit_text);
            if c.inferred {
                value += if c.unit_text == "1" {
                    " (inferred: pure number)"
                } else {
                    " (unit inferred)"
                };
            }
            if let Some((least, greatest)) = c.bounds {
                value += &format!(" in {least} .. {greatest}");
            }
            format!("{:width$} = {value:36} {}", c.name, first(&c.doc))
        }),
    )
}
