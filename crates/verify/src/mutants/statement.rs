//! Generates mutations of whole statements: units, frames, tables, loads, body.

use super::Operator;
use super::names::Names;
use model_spec::syntax::ast::{
    BodyPartKind, FrameKind, Interpolation, Item, ItemKind, LoadClass, Name, Table, UnitExpr,
    UnitFactor,
};

/// A mutation of one statement.
pub struct Change {
    /// Operator that produced the mutation.
    pub operator: Operator,
    /// Short description of the mutation.
    pub how: String,
    /// The mutated statement; `None` if it is deleted.
    pub to: Option<Item>,
}

/// Generates the mutations of a statement other than those of its expressions, such as another unit or axis. `angles`
/// are the names that may replace a frame's angle.
pub fn changes(item: &Item, names: &Names, angles: &[Name]) -> Vec<Change> {
    let mut out = Changes {
        item,
        list: Vec::new(),
    };
    match &item.kind {
        ItemKind::Parameter(c) => {
            let unit = &c.value.unit;
            let mut set = |how: &str, unit: Option<UnitExpr>| {
                out.push(Operator::Unit, how.to_owned(), |item| {
                    if let ItemKind::Parameter(c) = &mut item.kind {
                        c.value.unit = unit;
                        // Bounds without a unit have the unit of the default value.
                    }
                });
            };
            set(
                "unit times m",
                Some(times(unit.as_ref(), "m", c.value.span)),
            );
            set(
                "unit times s",
                Some(times(unit.as_ref(), "s", c.value.span)),
            );
            if unit.is_some() {
                set("unit left out", None);
            }
        }
        ItemKind::Input(i) => {
            for other in names.other_frames(&i.frame.text) {
                out.push(Operator::Frame, format!("in {other}"), |item| {
                    if let ItemKind::Input(i) = &mut item.kind {
                        i.frame.text.clone_from(other);
                    }
                });
            }
        }
        ItemKind::Marker(m) => {
            for other in names.other_frames(&m.frame.text) {
                out.push(Operator::Frame, format!("in {other}"), |item| {
                    if let ItemKind::Marker(m) = &mut item.kind {
                        m.frame.text.clone_from(other);
                    }
                });
            }
        }
        ItemKind::Table(t) => table(&mut out, t),
        ItemKind::Frame(f) => frame(&mut out, &f.kind, names, angles),
        ItemKind::Load(l) => {
            out.list.push(Change {
                operator: Operator::Dropped,
                how: "left out".into(),
                to: None,
            });
            let other = match l.class {
                LoadClass::Force => LoadClass::Moment,
                LoadClass::Moment => LoadClass::Force,
            };
            out.push(
                Operator::Exchanged,
                format!("{other:?} instead").to_lowercase(),
                |item| {
                    if let ItemKind::Load(l) = &mut item.kind {
                        l.class = other;
                    }
                },
            );
        }
        ItemKind::Body(b) => {
            for (index, part) in b.parts.iter().enumerate() {
                body_part(&mut out, index, &part.kind, names);
            }
        }
        _ => {}
    }
    out.list
}

struct Changes<'a> {
    item: &'a Item,
    list: Vec<Change>,
}

impl Changes<'_> {
    fn push(&mut self, operator: Operator, how: String, change: impl FnOnce(&mut Item)) {
        let mut to = self.item.clone();
        change(&mut to);
        self.list.push(Change {
            operator,
            how,
            to: Some(to),
        });
    }

    fn push_part(&mut self, operator: Operator, how: String, index: usize, kind: BodyPartKind) {
        self.push(operator, how, |item| {
            if let ItemKind::Body(b) = &mut item.kind {
                b.parts[index].kind = kind;
            }
        });
    }
}

/// Adds the mutations of an interpolated table to `out`: one changed value per knot, and another interpolation of the
/// same knots.
fn table(out: &mut Changes<'_>, table: &Table) {
    let mut change = |operator, how: String, change: &dyn Fn(&mut Table)| {
        out.push(operator, how, |item| {
            if let ItemKind::Table(table) = &mut item.kind {
                change(table);
            }
        });
    };
    for (k, (argument, value)) in table.knots.iter().enumerate() {
        let Ok(number) = value.number.text.parse::<f64>() else {
            continue;
        };
        let changed = if number == 0.0 { 0.1 } else { number * 1.1 };
        change(
            Operator::Factor,
            format!("{changed} at {argument}"),
            &|table| table.knots[k].1.number.text = format!("{changed:e}"),
        );
    }
    change(Operator::Function, String::from("other slopes"), &|table| {
        table.interpolation = match table.interpolation {
            Interpolation::Spline => Interpolation::Monotone,
            Interpolation::Monotone => Interpolation::Spline,
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
    let turned = |parent: &Name, angle: &Name, axis: u8| {
        let kind = FrameKind::Turned {
            parent: parent.clone(),
            angle: angle.clone(),
            axis,
        };
        move |item: &mut Item| {
            if let ItemKind::Frame(f) = &mut item.kind {
                f.kind = kind;
            }
        }
    };
    for other in (1..=3).filter(|other| other != axis) {
        out.push(
            Operator::Turn,
            format!("about {other} for {axis}"),
            turned(parent, angle, other),
        );
    }
    for other in names.other_frames(&parent.text) {
        let name = Name {
            text: other.clone(),
            span: parent.span,
        };
        out.push(
            Operator::Turn,
            format!("{other} turned"),
            turned(&name, angle, *axis),
        );
    }
    for other in angles.iter().filter(|other| other.text != angle.text) {
        out.push(
            Operator::Turn,
            format!("turned {}", other.text),
            turned(parent, other, *axis),
        );
    }
}

fn body_part(out: &mut Changes<'_>, index: usize, kind: &BodyPartKind, names: &Names) {
    let name = |other: &String, at: &Name| Name {
        text: other.clone(),
        span: at.span,
    };
    match kind {
        BodyPartKind::Mass(_) => {}
        BodyPartKind::Inertia(inertia) => {
            for other in names.other_frames(&inertia.frame.text) {
                let mut to = inertia.clone();
                to.frame.text.clone_from(other);
                let how = format!("inertia in {other}");
                out.push_part(Operator::Frame, how, index, BodyPartKind::Inertia(to));
            }
            for (i, j) in [(0, 1), (1, 2), (0, 2)] {
                let mut to = inertia.clone();
                (to.rows[i][i], to.rows[j][j]) = (to.rows[j][j].take(), to.rows[i][i].take());
                let how = format!("moments of inertia {} and {} swapped", i + 1, j + 1);
                out.push_part(Operator::Axis, how, index, BodyPartKind::Inertia(to));
            }
        }
        BodyPartKind::Fixed(frame) => {
            for other in names.other_frames(&frame.text) {
                let how = format!("fixed in {other}");
                out.push_part(
                    Operator::Frame,
                    how,
                    index,
                    BodyPartKind::Fixed(name(other, frame)),
                );
            }
        }
        BodyPartKind::AngularVelocityIn(frame) => {
            for other in names.other_frames(&frame.text) {
                let how = format!("angular velocity in {other}");
                let kind = BodyPartKind::AngularVelocityIn(name(other, frame));
                out.push_part(Operator::Frame, how, index, kind);
            }
        }
        BodyPartKind::Position(states, frame) => {
            vector(
                out,
                index,
                "position",
                states,
                frame,
                names,
                BodyPartKind::Position,
            );
        }
        BodyPartKind::Velocity(states, frame) => {
            vector(
                out,
                index,
                "velocity",
                states,
                frame,
                names,
                BodyPartKind::Velocity,
            );
        }
        BodyPartKind::AngularVelocity(states, frame) => {
            vector(
                out,
                index,
                "angular velocity",
                states,
                frame,
                names,
                BodyPartKind::AngularVelocity,
            );
        }
    }
}

fn vector(
    out: &mut Changes<'_>,
    index: usize,
    what: &str,
    states: &[Name; 3],
    frame: &Name,
    names: &Names,
    kind: impl Fn([Name; 3], Name) -> BodyPartKind,
) {
    for other in names.other_frames(&frame.text) {
        let name = Name {
            text: other.clone(),
            span: frame.span,
        };
        out.push_part(
            Operator::Frame,
            format!("{what} in {other}"),
            index,
            kind(states.clone(), name),
        );
    }
    for (i, j) in [(0, 1), (1, 2)] {
        let mut swapped = states.clone();
        swapped.swap(i, j);
        let how = format!("{what}: {} and {} swapped", states[i].text, states[j].text);
        out.push_part(Operator::Axis, how, index, kind(swapped, frame.clone()));
    }
}

fn times(unit: Option<&UnitExpr>, symbol: &str, at: model_spec::diagnostic::Span) -> UnitExpr {
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
