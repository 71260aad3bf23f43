//! Effects: changes to a model, stated once and applied to its tree.

use crate::diagnostic::{Diagnostic, Kind, SHOWN, Span};
use crate::suggest;
use crate::syntax;
use crate::syntax::ast::{
    Applied, Body, BodyPart, BodyPartKind, Effect, EffectPart, Expr, ExprKind, File, Item,
    ItemKind, Let, LoadClass, Name, Quantity,
};

/// Where an effect can act.
pub const SITES: [&str; 15] = [
    "lift", "drag", "side", "roll", "pitch", "spin", "wind", "gravity", "vertical", "scale",
    "clock", "marker", "inertia", "noise", "unknown",
];

/// Every statement of an effect is looked for in the whole model.
const MOST_PARTS: usize = 500;

/// An expression does not grow beyond this when a definition is put into its replacement.
const MOST_NODES: usize = 20_000;

/// Applies an effect: the file as it is with the effect in it. Its coefficients come last.
///
/// In a `replace` the name `previous` stands for what is replaced, as it was, so that effects on one
/// quantity add up. One that does not use it would undo an effect that was applied before, and is refused
/// then.
pub fn apply(file: &File, effect: &Effect) -> Result<File, Vec<Diagnostic>> {
    let mut change = Change {
        file: file.clone(),
        index: file.applied.len(),
        name: &effect.name,
        replaced: Vec::new(),
        diagnostics: Vec::new(),
    };
    change.is_for_this_model(effect);
    if effect.parts.len() > MOST_PARTS {
        let message = format!("an effect has at most {MOST_PARTS} statements");
        change
            .diagnostics
            .push(Diagnostic::new(Kind::Limit, effect.name.span, message));
    }
    if !change.diagnostics.is_empty() {
        return Err(change.diagnostics);
    }
    let mut applied = Applied {
        name: effect.name.clone(),
        doc: effect.doc.clone(),
        site: String::new(),
        citation: String::new(),
        negligible: Vec::new(),
    };
    let mut site: Option<Span> = None;
    for part in &effect.parts {
        match part {
            EffectPart::Citation(text, _) => applied.citation.clone_from(text),
            EffectPart::Site(name) => {
                change.known_site(name, site);
                site = Some(name.span);
                applied.site.clone_from(&name.text);
            }
            EffectPart::Negligible(name, quantity) => {
                change.own_coefficient(effect, name);
                applied.negligible.push((name.clone(), quantity.clone()));
            }
            EffectPart::Replace(item) => change.replace(item),
            EffectPart::ReplaceInertia(inertia, span) => {
                let part = BodyPart {
                    kind: BodyPartKind::Inertia(inertia.clone()),
                    span: *span,
                };
                change.replace_inertia(part);
            }
            EffectPart::Add(item) => {
                let item = Item::clone(item);
                change.file.items.push(Item {
                    effect: Some(change.index),
                    ..item
                });
            }
        }
    }
    if site.is_none() {
        let message = format!(
            "the effect `{}` does not say where it acts",
            effect.name.text
        );
        let fault = Diagnostic::new(Kind::Missing, effect.name.span, message);
        change
            .diagnostics
            .push(fault.help("add `site drag;`, or another of lift, side, roll, pitch, spin, …"));
    }
    if change.diagnostics.is_empty() {
        change.file.applied.push(applied);
        Ok(change.file)
    } else {
        Err(change.diagnostics)
    }
}

/// A file that is being changed by an effect.
struct Change<'a> {
    file: File,
    index: usize,
    name: &'a Name,
    /// What this effect has replaced already.
    replaced: Vec<(String, Span)>,
    diagnostics: Vec<Diagnostic>,
}

impl Change<'_> {
    fn is_for_this_model(&mut self, effect: &Effect) {
        if let Some(other) = self
            .file
            .applied
            .iter()
            .find(|a| a.name.text == effect.name.text)
        {
            let message = format!("the effect `{}` is switched on twice", effect.name.text);
            let fault = Diagnostic::new(Kind::Duplicate, effect.name.span, message);
            self.diagnostics
                .push(fault.label(other.name.span, "switched on already"));
        }
        let model = self.file.items.iter().find_map(|i| match &i.kind {
            ItemKind::Model(name) => Some(name),
            _ => None,
        });
        let Some(model) = model else { return };
        if !effect.on.is_empty() && effect.on.iter().all(|on| on.text != model.text) {
            let made_for: Vec<&str> = effect.on.iter().map(|n| n.text.as_str()).collect();
            let message = format!(
                "the effect `{}` is made for {}, and this is the model `{}`",
                effect.name.text,
                made_for.join(", "),
                model.text
            );
            let place = effect.on[0].span.to(effect.on[effect.on.len() - 1].span);
            self.diagnostics
                .push(Diagnostic::new(Kind::Name, place, message).help(format!(
                    "add `{}` to this list if it fits that model too",
                    model.text
                )));
        }
    }

    fn known_site(&mut self, name: &Name, before: Option<Span>) {
        if let Some(first) = before {
            let fault = Diagnostic::new(Kind::Duplicate, name.span, "an effect acts at one site");
            self.diagnostics
                .push(fault.label(first, "stated here already"));
        }
        if !SITES.contains(&name.text.as_str()) {
            let fault = Diagnostic::new(
                Kind::Name,
                name.span,
                format!("there is no site `{}`", name.text),
            )
            .note(format!("the sites are {}", SITES.join(", ")));
            let near = suggest::nearest(&name.text, SITES.into_iter());
            self.diagnostics
                .push(fault.help_if(near.map(|n| format!("did you mean `{n}`?"))));
        }
    }

    fn own_coefficient(&mut self, effect: &Effect, name: &Name) {
        let own = effect.parts.iter().filter_map(|p| match p {
            EffectPart::Add(item) => match &item.kind {
                ItemKind::Constant(c) => Some(c.name.text.as_str()),
                _ => None,
            },
            _ => None,
        });
        let own: Vec<&str> = own.collect();
        if !own.contains(&name.text.as_str()) {
            let message = format!(
                "the effect `{}` has no coefficient `{}`",
                effect.name.text, name.text
            );
            let near = suggest::nearest(&name.text, own.into_iter());
            let fault = Diagnostic::new(Kind::Name, name.span, message);
            self.diagnostics
                .push(fault.help_if(near.map(|n| format!("did you mean `{n}`?"))));
        }
    }

    fn replace(&mut self, item: &Item) {
        let key = key(&item.kind);
        let found = self
            .file
            .items
            .iter()
            .position(|i| same_statement(&i.kind, &item.kind));
        let span = name_span(&item.kind).unwrap_or(item.span);
        let Some(at) = found else {
            let names = self.file.items.iter().filter_map(|i| match &i.kind {
                ItemKind::Let(l) => Some(l.name.text.as_str()),
                _ => None,
            });
            let near = match &item.kind {
                ItemKind::Let(l) if self.diagnostics.len() < SHOWN => {
                    suggest::nearest(&l.name.text, names)
                }
                _ => None,
            };
            let message = format!(
                "the model has no {key} that `{}` could replace",
                self.name.text
            );
            let fault = Diagnostic::new(Kind::Name, span, message);
            self.diagnostics
                .push(fault.help_if(near.map(|n| format!("did you mean `{n}`?"))));
            return;
        };
        if let Some((_, first)) = self.replaced.iter().find(|r| r.0 == key) {
            let fault = Diagnostic::new(
                Kind::Duplicate,
                span,
                format!("this effect replaces {key} twice"),
            );
            self.diagnostics
                .push(fault.label(*first, "replaced here already"));
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
        if let (Some(before), Some(expr)) = (value(&old.kind), value_mut(&mut new.kind)) {
            let mut nodes = 0;
            put_in(expr, before, &mut nodes, &mut uses_old);
            if nodes > MOST_NODES || (uses_old && height(expr) > syntax::HIGHEST) {
                let message = format!("this replacement makes {key} too long");
                self.diagnostics
                    .push(Diagnostic::new(Kind::Limit, span, message));
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
            self.diagnostics.push(fault);
            return;
        }
        if let (ItemKind::Let(old), ItemKind::Let(new)) = (&old.kind, &mut new.kind) {
            new.unit = new.unit.take().or_else(|| old.unit.clone());
        }
        self.file.items[at] = new;
    }

    fn replace_inertia(&mut self, part: BodyPart) {
        let body = self.file.items.iter_mut().find_map(|i| match &mut i.kind {
            ItemKind::Body(body) => Some(body),
            _ => None,
        });
        let Some(Body { parts, .. }) = body else {
            let fault = Diagnostic::new(
                Kind::Missing,
                part.span,
                "the model has no body with moments of inertia",
            );
            self.diagnostics.push(fault);
            return;
        };
        match parts
            .iter_mut()
            .find(|p| matches!(p.kind, BodyPartKind::Inertia(_)))
        {
            Some(old) => *old = part,
            None => {
                let fault = Diagnostic::new(
                    Kind::Missing,
                    part.span,
                    "the body has no moments of inertia to replace",
                );
                self.diagnostics.push(fault);
            }
        }
    }
}

/// The name that stands for the definition that is replaced.
pub(crate) const PREVIOUS: &str = "previous";

/// Puts the old definition in wherever the new one says `previous`.
fn put_in(e: &mut Expr, old: &Expr, nodes: &mut usize, found: &mut bool) {
    *nodes += 1;
    if *nodes > MOST_NODES {
        return;
    }
    match &mut e.kind {
        ExprKind::Name(n) if n == PREVIOUS => {
            *found = true;
            *nodes += size(old);
            e.kind = old.kind.clone();
            e.span = old.span;
        }
        ExprKind::Name(_) | ExprKind::Number(Quantity { .. }) | ExprKind::Derivative(_) => {}
        ExprKind::Part(of, _) | ExprKind::Neg(of) => put_in(of, old, nodes, found),
        ExprKind::Components(parts, _) => {
            parts.iter_mut().for_each(|p| put_in(p, old, nodes, found));
        }
        ExprKind::Binary(_, a, b) => {
            put_in(a, old, nodes, found);
            put_in(b, old, nodes, found);
        }
        ExprKind::Call(_, arguments) => {
            arguments
                .iter_mut()
                .for_each(|a| put_in(a, old, nodes, found));
        }
    }
}

fn size(e: &Expr) -> usize {
    1 + match &e.kind {
        ExprKind::Name(_) | ExprKind::Number(_) | ExprKind::Derivative(_) => 0,
        ExprKind::Part(of, _) | ExprKind::Neg(of) => size(of),
        ExprKind::Components(parts, _) => parts.iter().map(size).sum(),
        ExprKind::Binary(_, a, b) => size(a) + size(b),
        ExprKind::Call(_, arguments) => arguments.iter().map(size).sum(),
    }
}

fn height(e: &Expr) -> u32 {
    1 + match &e.kind {
        ExprKind::Name(_) | ExprKind::Number(_) | ExprKind::Derivative(_) => 0,
        ExprKind::Part(of, _) | ExprKind::Neg(of) => height(of),
        ExprKind::Components(parts, _) => parts.iter().map(height).max().unwrap_or(0),
        ExprKind::Binary(_, a, b) => height(a).max(height(b)),
        ExprKind::Call(_, arguments) => arguments.iter().map(height).max().unwrap_or(0),
    }
}

/// What a replacement is called in a message.
fn key(kind: &ItemKind) -> String {
    match kind {
        ItemKind::Let(l) => format!("quantity `{}`", l.name.text),
        ItemKind::Load(l) if l.class == LoadClass::Force => format!("force `{}`", l.name.text),
        ItemKind::Load(l) => format!("moment `{}`", l.name.text),
        _ => "observation".to_owned(),
    }
}

fn same_statement(a: &ItemKind, b: &ItemKind) -> bool {
    match (a, b) {
        (ItemKind::Let(a), ItemKind::Let(b)) => a.name.text == b.name.text,
        (ItemKind::Load(a), ItemKind::Load(b)) => a.class == b.class && a.name.text == b.name.text,
        (ItemKind::Observe(a), ItemKind::Observe(b)) => a.name.text == b.name.text,
        _ => false,
    }
}

fn name_span(kind: &ItemKind) -> Option<Span> {
    match kind {
        ItemKind::Let(l) => Some(l.name.span),
        ItemKind::Load(l) => Some(l.name.span),
        ItemKind::Observe(o) => Some(o.name.span),
        _ => None,
    }
}

fn value(kind: &ItemKind) -> Option<&Expr> {
    match kind {
        ItemKind::Let(Let { value, .. }) => Some(value),
        ItemKind::Load(l) => Some(&l.value),
        ItemKind::Observe(o) => Some(&o.value),
        _ => None,
    }
}

fn value_mut(kind: &mut ItemKind) -> Option<&mut Expr> {
    match kind {
        ItemKind::Let(Let { value, .. }) => Some(value),
        ItemKind::Load(l) => Some(&mut l.value),
        ItemKind::Observe(o) => Some(&mut o.value),
        _ => None,
    }
}
