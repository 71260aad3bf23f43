//! Application of `replace` statements: the replaced definition is substituted for `previous` in the new one.

use super::Change;
use crate::diagnostic::{Diagnostic, Kind, MAX_SHOWN, Span};
use crate::syntax::expand::height;
use crate::syntax::reserved::PREVIOUS;
use crate::syntax::{self, of_kind};

use std::collections::HashMap;

use super::standard::replace_names;
use crate::syntax::ast::{
    Body, BodyPart, BodyPartKind, Expr, ExprKind, File, Inertia, Item, ItemKind, Let, Name,
    ParameterClass,
};

const MAX_NODES: usize = 20_000;

impl Change<'_> {
    pub(super) fn replace(&mut self, item: &Item) {
        let of_input = self.acting(item);
        let item = of_input.as_ref().unwrap_or(item);
        let (class, name) = item.kind.class_and_name();
        let on = body_of(&self.file, item);
        let key = match class {
            "the clock" | "observation" => class.to_owned(),
            _ => format!("{class} `{}`", name.map_or("", |name| &name.text)),
        };
        let key = match on {
            Some(body) => format!("{key} on `{body}`"),
            None => key,
        };
        if matches!(item.kind, ItemKind::Clock(_)) {
            self.own_clock(item.span);
        }
        // An observation without a name matches any observation.
        let is_any = class == "observation" && name.is_some_and(|name| name.text.is_empty());
        let found = self.file.items.iter().position(|old| {
            let (of, own) = old.kind.class_and_name();
            let is_same = own.map(|n| &n.text) == name.map(|n| &n.text);
            of == class && (is_any || is_same && body_of(&self.file, old) == on)
        });
        let span = name.map_or(item.span, |name| name.span);
        let Some(at) = found else {
            let message = format!(
                "the model has no {key} that `{}` could replace",
                self.name.text
            );
            let mut fault = Diagnostic::new(Kind::Name, span, message);
            if let ItemKind::Let(wanted) = &item.kind
                && self.diagnostics.len() < MAX_SHOWN
            {
                let names = of_kind!(self.file.items.iter(), ItemKind::Let);
                let names = names.map(|own| own.name.text.as_str());
                fault = fault.did_you_mean(&wanted.name.text, names);
            }
            self.report(fault);
            return;
        };
        if let Some((_, first)) = self.replaced.iter().find(|r| r.0 == key) {
            let fault = Diagnostic::new(
                Kind::Duplicate,
                span,
                format!("this effect replaces {key} twice"),
            );
            self.report(fault.label(*first, "replaced here already"));
            return;
        }
        self.replaced.push((key.clone(), span));
        let mut new = Item {
            effect: Some(self.index),
            ..item.clone()
        };
        if new.doc.is_empty() {
            new.doc.clone_from(&self.file.items[at].doc);
        }
        let old = &self.file.items[at];
        let mut uses_old = false;
        if let (Some(before), Some(expr)) = (old.kind.value(), new.kind.value_mut()) {
            let mut nodes = 0;
            put_in(expr, before, &mut nodes, &mut uses_old);
            if nodes > MAX_NODES || (uses_old && height(expr) > syntax::MAX_HEIGHT) {
                let message = format!("this replacement makes {key} too long");
                self.report(Diagnostic::new(Kind::Limit, span, message));
                return;
            }
        }
        if let Some(other) = old.effect.filter(|_| !uses_old) {
            let other = &self.file.applied[other].name;
            let message = format!(
                "`{}` would undo the effect `{}`, which replaces {key} too",
                self.name.text, other.text
            );
            let fault = Diagnostic::new(Kind::Duplicate, span, message)
                .label(other.span, "switched on before")
                .help(format!(
                    "switch `{}` on first, or let it use the quantity as it was: `replace X = previous + …;`",
                    self.name.text
                ));
            self.report(fault);
            return;
        }
        match (&old.kind, &mut new.kind) {
            (ItemKind::Let(old), ItemKind::Let(new)) => {
                new.unit = new.unit.take().or_else(|| old.unit.clone());
            }
            (ItemKind::Observe(old), ItemKind::Observe(new)) => new.name.clone_from(&old.name),
            _ => {}
        }
        self.file.items[at] = new;
    }

    /// The replacement of a scalar input, as that of a quantity `NAME_acting`, which takes its place in the model: the
    /// input itself is what was recorded. What replaces `NAME_in_time` takes the place of the input in `NAME_acting`
    /// too, so that delays and lags come before all else. `None` if `item` replaces something else.
    fn acting(&mut self, item: &Item) -> Option<Item> {
        let ItemKind::Let(wanted) = &item.kind else {
            return None;
        };
        let inputs = of_kind!(self.file.items.iter(), ItemKind::Parameter);
        let mut inputs = inputs.filter(|own| own.class == ParameterClass::Input);
        let in_time = wanted.name.text.strip_suffix("_in_time");
        let declared = inputs.find(|own| {
            own.name.text == wanted.name.text || in_time == Some(own.name.text.as_str())
        })?;
        let (input, span) = (declared.name.text.clone(), declared.name.span);
        let is_acting = input == wanted.name.text;
        let has = |file: &File, name: &str| file.binding(name).is_some();
        let (timed, acting) = (format!("{input}_in_time"), format!("{input}_acting"));
        let (new, old) = match is_acting {
            true if has(&self.file, &timed) => (acting, timed),
            true => (acting, input.clone()),
            false => (timed, input.clone()),
        };
        if !has(&self.file, &new) {
            self.stand_in(&new, &old, span);
            let doc = if is_acting {
                "as it acts"
            } else {
                "when it acts"
            };
            let value = Expr::name(&old, span);
            let kind = ItemKind::Let(Let::new(Name::new(&new, span), None, value));
            let of_input = Item::new(kind, format!("{input} {doc}"), span);
            self.file.items.push(of_input);
        }
        let mut item = item.clone();
        if let ItemKind::Let(own) = &mut item.kind {
            own.name.text = new;
        }
        Some(item)
    }

    /// Puts the quantity `new` in the place of `old` wherever the model uses it.
    fn stand_in(&mut self, new: &str, old: &str, span: Span) {
        let uses = HashMap::from([(old.to_owned(), Expr::name(new, span))]);
        // A parameter of a function hides a quantity of its name; a body has no inputs.
        let hides = |item: &Item| match &item.kind {
            ItemKind::Body(_) => true,
            ItemKind::Function(function) => {
                let mut parameters = function.parameters.iter();
                parameters.any(|own| own.name.text == old)
            }
            _ => false,
        };
        for item in self.file.items.iter_mut().filter(|item| !hides(item)) {
            for root in item.kind.roots_mut() {
                replace_names(root, &uses);
            }
        }
    }

    /// Adds the statement `clock 1;` to a model without a clock rate, so that an effect can replace it.
    fn own_clock(&mut self, span: Span) {
        let items = &mut self.file.items;
        if items.iter().any(|i| matches!(i.kind, ItemKind::Clock(_))) {
            return;
        }
        let rate = ItemKind::Clock(Expr::number("1", span));
        items.push(Item::new(rate, "", span));
    }

    /// Replaces the inertia tensor; `previous` is the same entry before. Entries are equal in both frames, which differ
    /// by rotations about axes of symmetry.
    pub(super) fn replace_inertia(&mut self, mut inertia: Box<Inertia>, span: Span) {
        let lacking = |message| Diagnostic::new(Kind::Missing, span, message);
        let body = self.file.items.iter_mut().find_map(|i| match &mut i.kind {
            ItemKind::Body(body) => Some(body),
            _ => None,
        });
        let Some(Body { parts, .. }) = body else {
            let message = "the model has no body with moments of inertia";
            self.report(lacking(message));
            return;
        };
        let old = parts.iter().enumerate().find_map(|(i, p)| match &p.kind {
            BodyPartKind::Inertia(inertia) => Some((i, inertia.clone())),
            _ => None,
        });
        let Some((at, old)) = old else {
            let message = "the body has no moments of inertia to replace";
            self.report(lacking(message));
            return;
        };
        let rows = inertia.rows.iter_mut().flatten();
        for (new, before) in rows.zip(old.rows.iter().flatten()) {
            let before = before.clone().unwrap_or_else(|| Expr::number("0", span));
            if let Some(new) = new {
                put_in(new, &before, &mut 0, &mut false);
            }
        }
        // Keep `angular_velocity` in the frame of the replaced tensor.
        let stated = |p: &BodyPart| p.words == "angular velocity in";
        if inertia.frame.text != old.frame.text && !parts.iter().any(stated) {
            parts.push(BodyPart {
                words: "angular velocity in",
                span: old.frame.span,
                kind: BodyPartKind::Frame(old.frame),
            });
        }
        parts[at] = BodyPart {
            words: "inertia",
            kind: BodyPartKind::Inertia(inertia),
            span,
        };
    }
}

/// Name of the body after the first one on which a load acts.
fn body_of<'i>(file: &File, item: &'i Item) -> Option<&'i str> {
    match &item.kind {
        ItemKind::Load(load) if !file.is_of_first_body(load) => {
            load.on.as_ref().map(|body| body.text.as_str())
        }
        _ => None,
    }
}

/// Substitutes `old` for `previous` in `e`; counts nodes up to [`MAX_NODES`].
fn put_in(e: &mut Expr, old: &Expr, nodes: &mut usize, found: &mut bool) {
    *nodes += 1;
    if *nodes > MAX_NODES {
        return;
    }
    if matches!(&e.kind, ExprKind::Name(name) if name == PREVIOUS) {
        *found = true;
        *nodes += old.nodes().count();
        e.kind = old.kind.clone();
        e.span = old.span;
        return;
    }
    for child in e.children_mut() {
        put_in(child, old, nodes, found);
    }
}
