//! Summary of a model as text.

use std::fmt::Write;

use crate::check::singular_points;
use crate::model::{
    Continuation, EffectUnknown, ExprKind, Function, Interpolation, Load, Model, Parameter,
    ValidityLimit,
};
use crate::source::LineStarts;

/// Summary of a model as text: states, parameters with units, forces, validity limits, singular points, effects.
pub fn summary(model: &Model) -> String {
    let mut out = String::new();
    let _ = write(&mut out, model);
    out
}

fn write(out: &mut String, model: &Model) -> std::fmt::Result {
    writeln!(out, "model {}", model.name)?;
    if let Some(line) = model.doc.lines().next() {
        writeln!(out, "  {line}")?;
    }
    if let Some(reference) = &model.reference {
        writeln!(out, "  verified against {reference}")?;
    }
    states(out, model)?;
    frames(out, model)?;
    constants(out, "parameters", &model.params)?;
    constants(out, "coefficients", &model.coefficients)?;
    inputs(out, model)?;
    tables(out, model)?;
    equations(out, model)?;
    observation(out, model)?;
    limits(out, model)?;
    singularities(out, model)?;
    if !model.checks.is_empty() {
        writeln!(out, "\nchecks in the file: {}", model.checks.len())?;
    }
    if !model.offers.is_empty() {
        writeln!(out, "\neffects that can be switched on")?;
        for offer in &model.offers {
            writeln!(out, "  {}   {}", offer.name, first(&offer.doc))?;
        }
    }
    effects(out, model)
}

fn inputs(out: &mut String, model: &Model) -> std::fmt::Result {
    if !model.inputs.is_empty() {
        writeln!(out, "\ninputs")?;
        for input in &model.inputs {
            let [x, y, z] = input.value;
            let frame = &model.frames[input.frame].name;
            writeln!(
                out,
                "  {} = ({x}, {y}, {z}) {} in {frame}   {}",
                input.name,
                input.unit_text,
                first(&input.doc)
            )?;
        }
    }
    Ok(())
}

/// Writes the loads of the body, or what is claimed of equations that are stated outright.
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
    Ok(())
}

/// Writes what is observed, and the rate of its clock.
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

fn limits(out: &mut String, model: &Model) -> std::fmt::Result {
    if !model.limits.is_empty() {
        writeln!(out, "\nlimits")?;
        for limit in &model.limits {
            let text = if model.is_automatic(limit) {
                automatic(model, limit)
            } else {
                model.text(limit.value.span)
            };
            let bound = with_unit(limit.bound, &limit.value.unit.tidy().to_string());
            writeln!(out, "  {text} > {bound}   {}", limit.reason)?;
        }
    }
    Ok(())
}

fn singularities(out: &mut String, model: &Model) -> std::fmt::Result {
    let points = singular_points(model);
    if !points.is_empty() {
        writeln!(out, "\nsingular points")?;
        let sources = model.sources.iter();
        let lines: Vec<LineStarts> = sources.map(|s| LineStarts::new(&s.text)).collect();
        for point in points {
            let source = lines.get(usize::from(point.span.source));
            let line = source.map_or(1, |lines| lines.line(point.span.start));
            let file = match model.sources.get(usize::from(point.span.source)) {
                Some(source) if point.span.source > 0 => format!("{}, ", source.name),
                _ => String::new(),
            };
            writeln!(out, "  {file}line {line}: {} is {}", point.text, point.what)?;
        }
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

/// Writes a line about a coefficient or state of an effect.
fn unknown(out: &mut String, what: &str, unknown: &EffectUnknown, unit: &str) -> std::fmt::Result {
    let value = |value: f64| with_unit(value, unit);
    write!(out, "  {what} vanishes at {}", value(unknown.null_value))?;
    if let Some(size) = unknown.smallest_effect_of_interest {
        write!(out, ", a departure below {} does not matter", value(size))?;
    }
    writeln!(out)
}

fn tables(out: &mut String, model: &Model) -> std::fmt::Result {
    if model.tables.is_empty() {
        return Ok(());
    }
    writeln!(out, "\ntables")?;
    for table in &model.tables {
        let [of_argument, of_value] = &table.unit_texts;
        let argument = |knot: Option<&(f64, f64)>| knot.map_or(0.0, |knot| knot.0);
        let (first_knot, last_knot) = (table.knots.first(), table.knots.last());
        let way = match table.interpolation {
            Interpolation::Spline => "spline",
            Interpolation::Monotone => "monotone",
        };
        let beyond = match table.continuation {
            Continuation::Linear => "linear",
            Continuation::Constant => "constant",
        };
        write!(out, "  {}({})", table.name, table.argument)?;
        if of_value != "1" {
            write!(out, " in {of_value}")?;
        }
        writeln!(
            out,
            ", {} knots from {} to {}, {way}, {beyond} beyond   {}",
            table.knots.len(),
            with_unit(argument(first_knot), of_argument),
            with_unit(argument(last_knot), of_argument),
            first(&table.doc)
        )?;
    }
    Ok(())
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

fn states(out: &mut String, model: &Model) -> std::fmt::Result {
    writeln!(out, "\nstates")?;
    let width = model.states.iter().map(|s| s.name.len()).max().unwrap_or(0);
    for state in &model.states {
        writeln!(out, "  {:width$}  {}", state.name, state.unit_text)?;
    }
    Ok(())
}

fn frames(out: &mut String, model: &Model) -> std::fmt::Result {
    writeln!(out, "\nframes")?;
    for frame in model.tree.frames() {
        let (name, kind) = (&frame.name.text, frame.kind.to_string());
        let kind = kind.strip_prefix(" = ").unwrap_or("inertial, axis 3 up");
        writeln!(out, "  {name}: {kind}")?;
    }
    Ok(())
}

fn constants(out: &mut String, title: &str, constants: &[Parameter]) -> std::fmt::Result {
    if constants.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n{title}")?;
    let width = constants.iter().map(|c| c.name.len()).max().unwrap_or(0);
    for c in constants {
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
        writeln!(out, "  {:width$} = {value:36} {}", c.name, first(&c.doc))?;
    }
    Ok(())
}
