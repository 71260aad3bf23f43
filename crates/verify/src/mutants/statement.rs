//! Generates mutations of whole statements: units, frames, tables, loads, body.

use super::names::Names;
use super::{Mutation, Operator};
use model_spec::diagnostic::Span;
use model_spec::syntax::ast::{
    Body, BodyPart, BodyPartKind, Expr, Frame, FrameKind, Input, Interpolation, Item, ItemKind,
    Load, LoadClass, Marker, Name, Table, UnitExpr, UnitFactor,
};

/// Mutations of a statement but not of its expressions; `None` deletes it. `angles` may replace a frame's angle.
pub fn changes(item: &Item, names: &Names, angles: &[Name]) -> Vec<Mutation<Option<ItemKind>>> {
    let mut out = Vec::new();
    let mut push = |operator, how: String, to| out.push(Mutation { operator, how, to });
    match &item.kind {
        ItemKind::Parameter(c) => {
            let (unit, at) = (c.value.unit.as_ref(), c.value.span);
            let mut set = |how: &str, unit: Option<UnitExpr>| {
                // Bounds without a unit have the unit of the default value.
                let mut c = c.clone();
                c.value.unit = unit;
                push(Operator::Unit, how.to_owned(), Some(ItemKind::Parameter(c)));
            };
            set("unit times m", Some(times(unit, "m", at)));
            set("unit times s", Some(times(unit, "s", at)));
            if unit.is_some() {
                set("unit left out", None);
            }
        }
        ItemKind::Input(i) => {
            for (how, frame) in other_frames(&i.frame, names) {
                let to = Input { frame, ..i.clone() };
                push(Operator::Frame, how, Some(ItemKind::Input(to)));
            }
        }
        ItemKind::Marker(m) => {
            for (how, frame) in other_frames(&m.frame, names) {
                let to = Marker { frame, ..m.clone() };
                push(Operator::Frame, how, Some(ItemKind::Marker(to)));
            }
        }
        ItemKind::Table(t) => table(t, &mut push),
        ItemKind::Frame(f) => frame(f, names, angles, &mut push),
        ItemKind::Load(l) => {
            push(Operator::Dropped, "left out".into(), None);
            let class = match l.class {
                LoadClass::Force => LoadClass::Moment,
                LoadClass::Moment => LoadClass::Force,
            };
            let how = format!("{class:?} instead").to_lowercase();
            let other = Load { class, ..l.clone() };
            push(Operator::Exchanged, how, Some(ItemKind::Load(other)));
        }
        ItemKind::Body(b) => {
            for index in 0..b.parts.len() {
                body_part(b, index, names, &mut push);
            }
        }
        _ => {}
    }
    out
}

/// Other frames in the place of that of components, each with the words for it.
fn other_frames<'a>(frame: &'a Name, names: &'a Names) -> impl Iterator<Item = (String, Name)> {
    let others = names.other_frames(&frame.text);
    others.map(|other| (format!("in {other}"), Name::new(other, frame.span)))
}

/// Mutations of a table: a value of each knot, and another interpolation.
fn table(table: &Table, push: &mut impl FnMut(Operator, String, Option<ItemKind>)) {
    for (k, (argument, values)) in table.rows.iter().enumerate() {
        for (column, value) in values.iter().enumerate() {
            let Ok(number) = value.number.text.parse::<f64>() else {
                continue;
            };
            let changed = if number == 0.0 { 0.1 } else { number * 1.1 };
            let second = table.columns.get(column);
            let second = second.map_or(String::new(), |knot| format!(", {knot}"));
            let how = format!("{changed} at {argument}{second}");
            let mut to = table.clone();
            to.rows[k].1[column].number.text = format!("{changed:e}");
            push(Operator::Factor, how, Some(ItemKind::Table(to)));
        }
    }
    let interpolation = match table.interpolation {
        Interpolation::Spline if table.arguments.len() == 1 => Interpolation::Monotone,
        Interpolation::Spline => Interpolation::Linear,
        Interpolation::Monotone | Interpolation::Linear => Interpolation::Spline,
    };
    let to = Table {
        interpolation,
        ..table.clone()
    };
    push(
        Operator::Function,
        "other slopes".into(),
        Some(ItemKind::Table(to)),
    );
}

fn frame(
    frame: &Frame,
    names: &Names,
    angles: &[Name],
    push: &mut impl FnMut(Operator, String, Option<ItemKind>),
) {
    let FrameKind::Turned {
        parent,
        angle,
        axis,
    } = &frame.kind
    else {
        return;
    };
    let mut turned = |how: String, parent: &Name, angle: &Name, axis: u8| {
        let mut to = frame.clone();
        to.kind = FrameKind::Turned {
            parent: parent.clone(),
            angle: angle.clone(),
            axis,
        };
        push(Operator::Turn, how, Some(ItemKind::Frame(to)));
    };
    for other in (1..=3).filter(|other| other != axis) {
        turned(format!("about {other} for {axis}"), parent, angle, other);
    }
    for other in names.other_frames(&parent.text) {
        let name = Name::new(other, parent.span);
        turned(format!("{other} turned"), &name, angle, *axis);
    }
    for other in angles.iter().filter(|other| other.text != angle.text) {
        turned(format!("turned {}", other.text), parent, other, *axis);
    }
}

/// Mutations of the part `index` of a body: another frame, interchanged components.
fn body_part(
    body: &Body,
    index: usize,
    names: &Names,
    push: &mut impl FnMut(Operator, String, Option<ItemKind>),
) {
    let part = &body.parts[index];
    let mut named = part.clone();
    let Some(frame) = frame_of_part(&mut named) else {
        return;
    };
    let what = part.words.trim_end_matches(" in");
    let mut push = |operator, how: String, change: &dyn Fn(&mut BodyPart)| {
        let mut to = body.clone();
        change(&mut to.parts[index]);
        push(operator, how, Some(ItemKind::Body(to)));
    };
    for other in names.other_frames(&frame.text) {
        push(Operator::Frame, format!("{what} in {other}"), &|part| {
            if let Some(frame) = frame_of_part(part) {
                frame.text.clone_from(other);
            }
        });
    }
    match &part.kind {
        BodyPartKind::Inertia(inertia) => {
            for (i, j) in [(0, 1), (1, 2), (0, 2)] {
                let how = format!("moments of inertia {} and {} swapped", i + 1, j + 1);
                let mut to = inertia.clone();
                (to.rows[i][i], to.rows[j][j]) = (to.rows[j][j].take(), to.rows[i][i].take());
                push(Operator::Axis, how, &|part| {
                    part.kind = BodyPartKind::Inertia(to.clone());
                });
            }
        }
        BodyPartKind::States(states, frame, values) => {
            for (i, j) in [(0, 1), (1, 2)] {
                let how = format!("{what}: {} and {} swapped", states[i].text, states[j].text);
                let mut to = states.clone();
                to.swap(i, j);
                push(Operator::Axis, how, &|part| {
                    part.kind = BodyPartKind::States(to.clone(), frame.clone(), values.clone());
                });
            }
        }
        _ => {}
    }
}

/// Frame of a part of a body; `None` for the mass.
fn frame_of_part(part: &mut BodyPart) -> Option<&mut Name> {
    match &mut part.kind {
        BodyPartKind::Value(_) => None,
        BodyPartKind::Inertia(inertia) => Some(&mut inertia.frame),
        BodyPartKind::Frame(frame) | BodyPartKind::States(_, frame, _) => Some(frame),
    }
}

fn times(unit: Option<&UnitExpr>, symbol: &str, at: Span) -> UnitExpr {
    let mut product = unit.cloned().unwrap_or(UnitExpr {
        factors: Vec::new(),
        span: at,
    });
    product.factors.push(UnitFactor {
        symbol: symbol.to_owned(),
        doubled: 2,
        span: at,
    });
    product
}

/// Root expressions of a statement that are mutated; none where they do not describe physics.
pub fn roots(item: &mut Item) -> Vec<&mut Expr> {
    match &mut item.kind {
        ItemKind::Limit(_)
        | ItemKind::Claim(_)
        | ItemKind::Balance(_)
        | ItemKind::Function(_)
        | ItemKind::Array(_) => Vec::new(),
        other => other.roots_mut(),
    }
}

/// Kind and name of a statement for messages, such as `frame B` or `der(u)`.
pub fn name(item: &Item) -> String {
    match &item.kind {
        ItemKind::Parameter(c) => format!("declaration of {}", c.name.text),
        ItemKind::Input(i) => format!("input {}", i.name.text),
        ItemKind::Frame(f) => format!("frame {}", f.name.text),
        ItemKind::Body(b) => format!("body {}", b.name.text),
        ItemKind::Table(t) => format!("table {}", t.name.text),
        ItemKind::Let(l) => format!("let {}", l.name.text),
        ItemKind::Load(l) => format!("{:?} {}", l.class, l.name.text).to_lowercase(),
        ItemKind::Equation(e) => format!("der({})", e.state.text),
        ItemKind::Solve(solve) => solve.title().replace('`', ""),
        ItemKind::Marker(m) => format!("marker {}", m.name.text),
        ItemKind::Observe(o) => format!("observe {}", o.name.text),
        ItemKind::Clock(_) => String::from("clock"),
        _ => String::from("statement"),
    }
}
