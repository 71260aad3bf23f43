//! Checks singular points: all values and derivatives must be finite in every backend.

use super::backends::{Run, function_at};
use crate::evaluation::exponential_overflows;
use crate::row::Row;
use crate::sample::{is_valid, is_velocity};
use codegen::Compiled;
use model_spec::model::{FrameKind, Model};
use oracle::{Point, Tree};
use std::collections::BTreeSet;
use std::f64::consts::FRAC_PI_2;

/// Name of this check in reports: finite results at singular points.
pub const SINGULAR: &str = "singular points";

/// Beginnings of the names of points that are arbitrary but for their velocities: what overflows there is no fault.
const ARBITRARY: [&str; 2] = ["no velocity", "velocities whose squares vanish"];

/// Checks that all results of every backend are finite at the singular points.
pub fn check(points: &[(String, Point<f64>)], compiled: &Compiled, runs: &[Run]) -> Row {
    let mut faults = Vec::new();
    let mut overflows = BTreeSet::new();
    for run in runs {
        for ((name, point), results) in points.iter().zip(&run.results) {
            if let Some(index) = results.iter().position(|v| !v.is_finite()) {
                let is_arbitrary = ARBITRARY.iter().any(|kind| name.starts_with(kind));
                if is_arbitrary && exponential_overflows(compiled, point) {
                    overflows.insert(name);
                    continue;
                }
                let function = function_at(compiled, index);
                faults.push(format!(
                    "{name}: {function} is not finite in {}",
                    run.backend
                ));
            }
        }
    }
    let row = Row::counted(SINGULAR, points.len() * runs.len(), &faults, "");
    if overflows.is_empty() {
        return row;
    }
    let names: Vec<&str> = overflows.into_iter().map(String::as_str).collect();
    row.with_remark(format!(
        "OVERFLOW ({SINGULAR}): an exponential is beyond the range of double precision at: {}",
        names.join(", ")
    ))
}

/// Points, with descriptions, at which a divisor may vanish, within the validity limits; of singular attitudes only
/// limits written in the model file count.
pub fn points(model: &Model) -> Vec<(String, Point<f64>)> {
    let base = moving(model);
    let all = 0..model.states.len();
    let is_velocity = |&state: &usize| is_velocity(model.states[state].unit);
    let velocities: Vec<usize> = all.clone().filter(is_velocity).collect();
    let mut out = Vec::new();
    let mut add = |name: &str, point| out.push((name.to_owned(), point));
    add("every state at its default", Point::defaults(model));
    add("every state 0", with(&base, all, 0.0));
    add("no velocity", with(&base, velocities.clone(), 0.0));
    // Only one velocity component is nonzero; for the disc the third one is along its axis.
    for &kept in &velocities {
        let others = velocities.iter().copied().filter(|&i| i != kept);
        let name = format!("no velocity but {}", model.states[kept].name);
        add(&name, with(&base, others, 0.0));
    }
    for (wind, input) in model.inputs.iter().enumerate() {
        // The airspeed is zero in a model whose axes are parallel to the inertial axes.
        let mut point = Point::defaults(model);
        for (axis, &state) in velocities.iter().take(3).enumerate() {
            point.states[state] = 3.0;
            point.inputs[wind][axis] = 3.0;
        }
        add(&format!("as fast as {}", input.name), point);
    }
    let tiny = with(&base, velocities, 1e-160);
    add("velocities whose squares vanish", tiny);
    out.retain(|(_, point)| is_valid(model, point));
    // The results at singular attitudes must be finite too, so only limits stated in the model exclude them.
    let angles = model.frames.iter().filter_map(|frame| match frame.kind {
        FrameKind::Turned { angle, .. } => Some(angle),
        _ => None,
    });
    let near = FRAC_PI_2 - 1e-8;
    for angle in angles {
        for (how, value) in [("at", FRAC_PI_2), ("near", near), ("at minus", -FRAC_PI_2)] {
            let name = &model.states[angle].name;
            let point = with(&base, [angle], value);
            if is_within_stated(model, &point) {
                out.push((format!("{name} {how} a right angle"), point));
            }
        }
    }
    out
}

/// Whether a point is within every limit that is written in the model file.
fn is_within_stated(model: &Model, point: &Point<f64>) -> bool {
    let tree = Tree::new(model, point);
    let mut limits = model
        .limits_of_validity()
        .filter(|l| !model.is_automatic(l));
    limits.all(|limit| tree.scalar(&limit.value) > limit.bound)
}

fn moving(model: &Model) -> Point<f64> {
    let mut point = Point::defaults(model);
    for (k, value) in point.states.iter_mut().enumerate() {
        *value += 0.1 + 0.07 * k as f64;
    }
    point
}

fn with(point: &Point<f64>, states: impl IntoIterator<Item = usize>, value: f64) -> Point<f64> {
    let mut point = point.clone();
    for state in states {
        point.states[state] = value;
    }
    point
}
