//! Loads on bodies after the first one whose quantities would have one name.

use super::on_body;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::syntax::ast::{Body, BodyClass, File, ItemKind, Load, LoadClass};
use crate::syntax::of_kind;
use crate::syntax::reserved::BodyQuantity;

/// A quantity that a body makes: its name, what it is, and where that is declared.
struct Made {
    name: String,
    what: String,
    span: Span,
}

/// Errors of loads whose quantity has the name of another quantity that bodies make. Two loads of one class and name on one
/// body are left to the check of what is declared twice.
pub(super) fn collisions(file: &File, others: &[Body]) -> Vec<Diagnostic> {
    let mut made: Vec<Made> = others.iter().flat_map(of_body).collect();
    let mut faults = Vec::new();
    for load in of_kind!(file.items.iter(), ItemKind::Load) {
        let on = load.on.as_ref().map(|name| name.text.as_str());
        let Some(own) = on.filter(|on| others.iter().any(|body| body.name.text == *on)) else {
            continue;
        };
        let own = of_load(load, own);
        if let Some(other) =
            { made.iter() }.find(|other| other.name == own.name && other.what != own.what)
        {
            let message = format!(
                "`{}` would be both {} and {}",
                own.name, other.what, own.what
            );
            let fault = Diagnostic::new(Kind::Duplicate, own.span, message);
            let fault = fault.label(own.span, &own.what);
            let fault = fault.label(other.span, &other.what);
            faults.push(fault.help(
                "rename the load: a quantity stands for each load on a body after the first",
            ));
        }
        made.push(own);
    }
    faults
}

fn of_load(load: &Load, body: &str) -> Made {
    let class = match load.class {
        LoadClass::Force => "force",
        LoadClass::Moment => "moment",
    };
    Made {
        name: on_body(load, body),
        what: format!("the {class} `{}` on `{body}`", load.name.text),
        span: load.name.span,
    }
}

fn of_body(body: &Body) -> impl Iterator<Item = Made> {
    use BodyQuantity as Q;
    let turns = body.class == BodyClass::Rigid;
    let is_its =
        move |own: &Q| turns || matches!(own, Q::Position | Q::Velocity | Q::Mass | Q::Force);
    Q::ALL.into_iter().filter(is_its).map(|own| Made {
        name: own.of(&body.name.text),
        what: format!("the {} of `{}`", own.meaning(), body.name.text),
        span: body.name.span,
    })
}
