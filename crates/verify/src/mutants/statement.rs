//! Generates mutations of whole statements: units, frames, tables, loads, body.

use super::names::Names;
use super::{Mutation, Operator};
use model_spec::diagnostic::Span;
use model_spec::syntax::ast::{
    BodyPart, BodyPartKind, Expr, FrameKind, Interpolation, Item, ItemKind, LoadClass, Name, Table,
    UnitExpr, UnitFactor,
};

/// Mutations of a statement but not of its expressions; `None` deletes it. `angles` may replace a frame's angle.
pub fn changes(item: &Item, names: &Names, angles: &[Name]) -> Vec<Mutation<Option<Item>>> {
    let mut out = Changes {
        item,
        list: Vec::new(),
    };
    match &item.kind {
        ItemKind::Parameter(c) => {
            let (unit, at) = (&c.value.unit, c.value.span);
            let mut set = |how: &str, unit: Option<UnitExpr>| {
                out.push(Operator::Unit, how.to_owned(), &|item| {
                    // Bounds without a unit have the unit of the default value.
                    if let ItemKind::Parameter(c) = &mut item.kind {
                        c.value.unit.clone_from(&unit);
                    }
                });
            };
            set("unit times m", Some(times(unit.as_ref(), "m", at)));
            set("unit times s", Some(times(unit.as_ref(), "s", at)));
            if unit.is_some() {
                set("unit left out", None);
            }
        }
        ItemKind::Input(i) => frame_of_components(&mut out, &i.frame, names),
        ItemKind::Marker(m) => frame_of_components(&mut out, &m.frame, names),
        ItemKind::Table(t) => table(&mut out, t),
        ItemKind::Frame(f) => frame(&mut out, &f.kind, names, angles),
        ItemKind::Load(l) => {
            out.list.push(Mutation {
                operator: Operator::Dropped,
                how: "left out".into(),
                to: None,
            });
            let other = match l.class {
                LoadClass::Force => LoadClass::Moment,
                LoadClass::Moment => LoadClass::Force,
            };
            let how = format!("{other:?} instead").to_lowercase();
            out.push(Operator::Exchanged, how, &|item| {
                if let ItemKind::Load(l) = &mut item.kind {
                    l.class = other;
                }
            });
        }
        ItemKind::Body(b) => {
            for (index, part) in b.parts.iter().enumerate() {
                body_part(&mut out, index, part, names);
            }
        }
        _ => {}
    }
    out.list
}

struct Changes<'a> {
    item: &'a Item,
    list: Vec<Mutation<Option<Item>>>,
}

impl Changes<'_> {
    fn push(&mut self, operator: Operator, how: String, change: &dyn Fn(&mut Item)) {
        let mut to = self.item.clone();
        change(&mut to);
        self.list.push(Mutation {
            operator,
            how,
            to: Some(to),
        });
    }
}

/// Mutations of the frame of an input or a marker.
fn frame_of_components(out: &mut Changes<'_>, frame: &Name, names: &Names) {
    for other in names.other_frames(&frame.text) {
        out.push(
            Operator::Frame,
            format!("in {other}"),
            &|item| match &mut item.kind {
                ItemKind::Input(i) => i.frame.text.clone_from(other),
                ItemKind::Marker(m) => m.frame.text.clone_from(other),
                _ => {}
            },
        );
    }
}

/// Mutations of a table: a value of each knot, and another interpolation.
fn table(out: &mut Changes<'_>, table: &Table) {
    let mut change = |operator, how: String, change: &dyn Fn(&mut Table)| {
        out.push(operator, how, &|item| {
            if let ItemKind::Table(table) = &mut item.kind {
                change(table);
            }
        });
    };
    for (k, (argument, values)) in table.rows.iter().enumerate() {
        for (column, value) in values.iter().enumerate() {
            let Ok(number) = value.number.text.parse::<f64>() else {
                continue;
            };
            let changed = if number == 0.0 { 0.1 } else { number * 1.1 };
            let second = table.columns.get(column);
            let second = second.map_or(String::new(), |knot| format!(", {knot}"));
            change(
                Operator::Factor,
                format!("{changed} at {argument}{second}"),
                &|table| table.rows[k].1[column].number.text = format!("{changed:e}"),
            );
        }
    }
    change(Operator::Function, String::from("other slopes"), &|table| {
        table.interpolation = match table.interpolation {
            Interpolation::Spline if table.arguments.len() == 1 => Interpolation::Monotone,
            Interpolation::Spline => Interpolation::Linear,
            Interpolation::Monotone | Interpolation::Linear => Interpolation::Spline,
        };
    });
}

fn frame(out: &mut Changes<'_>, kind: &FrameKind, names: &Names, angles: &[Name]) {
    let FrameKind::Turned {
        parent,
        angle,
        axis,
    } = kind
    else {
        return;
    };
    let mut turned = |how: String, parent: &Name, angle: &Name, axis: u8| {
        let kind = FrameKind::Turned {
            parent: parent.clone(),
            angle: angle.clone(),
            axis,
        };
        out.push(Operator::Turn, how, &|item| {
            if let ItemKind::Frame(f) = &mut item.kind {
                f.kind = kind.clone();
            }
        });
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
fn body_part(out: &mut Changes<'_>, index: usize, part: &BodyPart, names: &Names) {
    let mut push = |operator, how: String, change: &dyn Fn(&mut BodyPart)| {
        out.push(operator, how, &|item| {
            if let ItemKind::Body(b) = &mut item.kind {
                change(&mut b.parts[index]);
            }
        });
    };
    let mut named = part.clone();
    let Some((what, frame)) = frame_of_part(&mut named) else {
        return;
    };
    for other in names.other_frames(&frame.text) {
        push(Operator::Frame, format!("{what} in {other}"), &|part| {
            if let Some((_, frame)) = frame_of_part(part) {
                frame.text.clone_from(other);
            }
        });
    }
    match &part.kind {
        BodyPartKind::Inertia(_) => {
            for (i, j) in [(0, 1), (1, 2), (0, 2)] {
                let how = format!("moments of inertia {} and {} swapped", i + 1, j + 1);
                push(Operator::Axis, how, &|part| {
                    if let BodyPartKind::Inertia(to) = &mut part.kind {
                        (to.rows[i][i], to.rows[j][j]) =
                            (to.rows[j][j].take(), to.rows[i][i].take());
                    }
                });
            }
        }
        BodyPartKind::States(states, ..) => {
            for (i, j) in [(0, 1), (1, 2)] {
                let how = format!("{what}: {} and {} swapped", states[i].text, states[j].text);
                push(Operator::Axis, how, &|part| {
                    if let BodyPartKind::States(states, ..) = &mut part.kind {
                        states.swap(i, j);
                    }
                });
            }
        }
        _ => {}
    }
}

/// Frame of a part of a body, with a name of the part; `None` for the mass.
fn frame_of_part(part: &mut BodyPart) -> Option<(&'static str, &mut Name)> {
    let frame = match &mut part.kind {
        BodyPartKind::Value(_) => return None,
        BodyPartKind::Inertia(inertia) => &mut inertia.frame,
        BodyPartKind::Frame(frame) | BodyPartKind::States(_, frame, _) => frame,
    };
    Some((part.words.trim_end_matches(" in"), frame))
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
