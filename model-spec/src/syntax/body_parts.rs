//! Statements in the block of a body: each once, and all that are needed.

use super::ast::{self, Body, BodyClass, BodyPartKind, InitialValues, Name};
use crate::diagnostic::{Diagnostic, Kind, Span, listed};

/// States of a vector, the frame of its components, and their defaults.
pub(crate) type Triple<'a> = (&'a [Name; 3], &'a Name, Option<&'a InitialValues>);

/// Statements in the block of a body, each at most once.
#[derive(Clone, Default)]
pub(crate) struct Parts<'a> {
    pub mass: Option<&'a ast::Expr>,
    pub inertia: Option<(&'a ast::Inertia, Span)>,
    pub fixed: Option<&'a Name>,
    pub position: Option<Triple<'a>>,
    pub velocity: Option<Triple<'a>>,
    pub angular: Option<Triple<'a>>,
    pub angular_velocity_frame: Option<&'a Name>,
    pub axis: Option<&'a ast::Expr>,
    pub forward: Option<&'a ast::Expr>,
}

impl<'a> Parts<'a> {
    /// The statements of a body, with errors for those that are stated twice, are not of a point, or are missing.
    pub fn of(body: &'a Body) -> (Self, Vec<Diagnostic>) {
        let (mut parts, mut faults) = (Parts::default(), Vec::new());
        let mut seen: Vec<(&str, Span)> = Vec::new();
        for part in &body.parts {
            let word = part.words;
            if let Some(&(_, first)) = seen.iter().find(|s| s.0 == word) {
                faults.push(stated_twice(word, first, part.span));
                continue;
            }
            seen.push((word, part.span));
            let turning = !matches!(word, "mass" | "position" | "velocity");
            if turning && body.class == BodyClass::Point {
                let message = format!("a point has no `{word}`");
                let fault = Diagnostic::new(Kind::Shape, part.span, message);
                faults.push(fault.help("declare it as `body`, not as `point`, if it turns"));
                continue;
            }
            match (word, &part.kind) {
                ("axis", BodyPartKind::Value(axis)) => parts.axis = Some(axis),
                ("forward", BodyPartKind::Value(axis)) => parts.forward = Some(axis),
                (_, BodyPartKind::Value(mass)) => parts.mass = Some(mass),
                (_, BodyPartKind::Inertia(own)) => parts.inertia = Some((own, part.span)),
                ("fixed in", BodyPartKind::Frame(frame)) => parts.fixed = Some(frame),
                (_, BodyPartKind::Frame(frame)) => parts.angular_velocity_frame = Some(frame),
                (_, BodyPartKind::States(names, frame, initial)) => {
                    let own = match word {
                        "position" => &mut parts.position,
                        "velocity" => &mut parts.velocity,
                        _ => &mut parts.angular,
                    };
                    *own = Some((names, frame, initial.as_deref()));
                }
            }
        }
        let rigid = body.class == BodyClass::Rigid;
        let needed = [
            ("mass …;", parts.mass.is_none()),
            (
                "inertia diag(…, …, …) in …;",
                rigid && parts.inertia.is_none(),
            ),
            ("fixed in …;", rigid && parts.fixed.is_none()),
            ("position (x, y, z) in N;", parts.position.is_none()),
            ("velocity (u, v, w) in …;", parts.velocity.is_none()),
        ];
        faults.extend(lacking("the body", "the body", &body.name, &needed));
        (parts, faults)
    }
}

/// Error of missing statements of the block `name`, which `what` precedes in the message; `owner` is to have them.
pub(crate) fn lacking(
    what: &str,
    owner: &str,
    name: &Name,
    needed: &[(&str, bool)],
) -> Option<Diagnostic> {
    let missing: Vec<&str> = needed.iter().filter(|n| n.1).map(|n| n.0).collect();
    if missing.is_empty() {
        return None;
    }
    let message = format!("{what} `{}` lacks {}", name.text, listed(&missing));
    let fault = Diagnostic::new(Kind::Missing, name.span, message);
    Some(fault.help(format!("add what is missing to the block of {owner}")))
}

/// Error of a statement that may stand once.
pub(crate) fn stated_twice(what: &str, first: Span, again: Span) -> Diagnostic {
    Diagnostic::new(Kind::Duplicate, again, format!("`{what}` is stated twice"))
        .label(first, "first stated here")
        .label(again, "stated again here")
        .help("keep one of them")
}
