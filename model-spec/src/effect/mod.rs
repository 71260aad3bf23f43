//! Effects: named changes to a model, applied to its syntax tree.

mod replace;
mod standard;

use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::syntax::ast::{Effect, EffectPart, File, Input, Item, ItemKind, Name};
use crate::syntax::expand;

pub(crate) use standard::lacking;

/// Permitted names in `site NAME;`, the statement by which an effect names the component of the model that it changes.
pub const SITES: [&str; 15] = [
    "lift", "drag", "side", "roll", "pitch", "spin", "wind", "gravity", "vertical", "scale",
    "clock", "marker", "inertia", "noise", "unknown",
];

/// Permitted names in `variables NAME, …;`; `none` if the effect depends on no variable.
pub const VARIABLES: [&str; 9] = [
    "alpha", "spin", "speed", "rates", "height", "time", "position", "attitude", "none",
];

/// Maximum number of statements in an effect: for each, the whole model is searched.
const MAX_STATEMENTS: usize = 500;

/// Returns a copy of `file` with `effect` applied, or the errors. The statements that the effect adds come last.
///
/// In a `replace` statement, the name `previous` refers to the replaced definition, so that effects on one quantity
/// accumulate. A `replace` without `previous` is an error if a previously applied effect replaces the same quantity.
pub fn apply(file: &File, effect: &Effect) -> Result<File, Vec<Diagnostic>> {
    let mut change = Change {
        file: file.clone(),
        index: file.applied.len(),
        name: &effect.name,
        replaced: Vec::new(),
        diagnostics: Vec::new(),
    };
    change.is_for_this_model(effect);
    if effect.parts.len() > MAX_STATEMENTS {
        let message = format!("an effect has at most {MAX_STATEMENTS} statements");
        change.report(Diagnostic::new(Kind::Limit, effect.name.span, message));
    }
    if !change.diagnostics.is_empty() {
        return Err(change.diagnostics);
    }
    let mut unrolled = effect.clone();
    let mut faults = expand::unroll_effect(&mut unrolled, file);
    if unrolled.parts.len() > MAX_STATEMENTS {
        let message = format!(
            "with its arrays written out, an effect has at most {MAX_STATEMENTS} statements"
        );
        faults.push(Diagnostic::new(Kind::Limit, effect.name.span, message));
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let effect = standard::in_names_of(file, &unrolled)?;
    let mut site: Option<Span> = None;
    let mut variables: Option<Span> = None;
    for part in &effect.parts {
        match part {
            EffectPart::Site(name) => {
                change.known_site(name, site);
                site = Some(name.span);
            }
            EffectPart::Variables(names, span) => {
                change.known_variables(names, *span, variables);
                variables = Some(*span);
            }
            EffectPart::Negligible(name, _) => change.own_coefficient(&effect, name),
            EffectPart::Replace(item) => change.replace(item),
            EffectPart::ReplaceInertia(inertia, span) => {
                change.replace_inertia(inertia.clone(), *span);
            }
            EffectPart::Add(item) if !change.has_input(item) => {
                change.file.items.push(Item {
                    effect: Some(change.index),
                    ..Item::clone(item)
                });
            }
            _ => {}
        }
    }
    if site.is_none() {
        let message = format!(
            "the effect `{}` does not say where it acts",
            effect.name.text
        );
        let fault = Diagnostic::new(Kind::Missing, effect.name.span, message);
        change
            .report(fault.help("add `site drag;`, or another of lift, side, roll, pitch, spin, …"));
    }
    if change.diagnostics.is_empty() {
        change.diagnostics = expand::expand(&mut change.file);
    }
    if change.diagnostics.is_empty() {
        change.file.applied.push(effect);
        Ok(change.file)
    } else {
        Err(change.diagnostics)
    }
}

struct Change<'a> {
    file: File,
    index: usize,
    name: &'a Name,
    /// Statements replaced so far: description, and span of the replacement.
    replaced: Vec<(String, Span)>,
    diagnostics: Vec<Diagnostic>,
}

impl Change<'_> {
    fn report(&mut self, fault: Diagnostic) {
        self.diagnostics.push(fault);
    }

    fn is_for_this_model(&mut self, effect: &Effect) {
        let mut applied = self.file.applied.iter();
        if let Some(other) = applied.find(|a| a.name.text == effect.name.text) {
            let message = format!("the effect `{}` is switched on twice", effect.name.text);
            let fault = Diagnostic::new(Kind::Duplicate, effect.name.span, message);
            self.report(fault.label(other.name.span, "switched on already"));
        }
        let Some(model) = self.file.model() else {
            return;
        };
        if effect.excludes(&model.text) {
            let made_for: Vec<&str> = effect.on.iter().map(|n| n.text.as_str()).collect();
            let message = format!(
                "the effect `{}` is made for {}, and this is the model `{}`",
                effect.name.text,
                made_for.join(", "),
                model.text
            );
            let place = effect.on[0].span.to(effect.on[effect.on.len() - 1].span);
            self.report(Diagnostic::new(Kind::Name, place, message).help(format!(
                "add `{}` to this list if it fits that model too",
                model.text
            )));
        }
    }

    fn known_site(&mut self, name: &Name, before: Option<Span>) {
        if let Some(first) = before {
            let fault = Diagnostic::new(Kind::Duplicate, name.span, "an effect acts at one site");
            self.report(fault.label(first, "stated here already"));
        }
        if !SITES.contains(&name.text.as_str()) {
            let fault = Diagnostic::new(
                Kind::Name,
                name.span,
                format!("there is no site `{}`", name.text),
            )
            .note(format!("the sites are {}", SITES.join(", ")));
            self.report(fault.did_you_mean(&name.text, SITES));
        }
    }

    fn known_variables(&mut self, names: &[Name], span: Span, before: Option<Span>) {
        if let Some(first) = before {
            let message = "what an effect depends on is stated once";
            let fault = Diagnostic::new(Kind::Duplicate, span, message);
            self.report(fault.label(first, "stated here already"));
        }
        for (i, name) in names.iter().enumerate() {
            if let Some(first) = names[..i].iter().find(|n| n.text == name.text) {
                let message = format!("`{}` is named twice", name.text);
                let fault = Diagnostic::new(Kind::Duplicate, name.span, message);
                self.report(fault.label(first.span, "named here already"));
            } else if !VARIABLES.contains(&name.text.as_str()) {
                let message = format!("there is no variable `{}`", name.text);
                let fault = Diagnostic::new(Kind::Name, name.span, message)
                    .note(format!("the variables are {}", VARIABLES.join(", ")));
                self.report(fault.did_you_mean(&name.text, VARIABLES));
            } else if name.text == "none" && names.len() > 1 {
                let message = "an effect that depends on nothing depends on nothing else";
                self.report(Diagnostic::new(Kind::Value, name.span, message).help("remove `none`"));
            }
        }
    }

    /// Whether `item` is an input that is already declared identically.
    fn has_input(&self, item: &Item) -> bool {
        let ItemKind::Input(wanted) = &item.kind else {
            return false;
        };
        self.file.items.iter().any(|i| match &i.kind {
            ItemKind::Input(input) => same_input(input, wanted),
            _ => false,
        })
    }

    fn own_coefficient(&mut self, effect: &Effect, name: &Name) {
        let own = effect.added().filter_map(|item| match &item.kind {
            ItemKind::Parameter(_) | ItemKind::State(_) => item.kind.declared(),
            _ => None,
        });
        let own: Vec<&str> = own.map(|name| name.text.as_str()).collect();
        if !own.contains(&name.text.as_str()) {
            let message = format!(
                "the effect `{}` has no coefficient and no state `{}`",
                effect.name.text, name.text
            );
            let fault = Diagnostic::new(Kind::Name, name.span, message);
            self.report(fault.did_you_mean(&name.text, own));
        }
    }
}

/// Whether two inputs are identical in name, frame, unit and default value.
fn same_input(a: &Input, b: &Input) -> bool {
    let unit = |input: &Input| input.unit.as_ref().map(ToString::to_string);
    let numbers = |input: &Input| {
        input
            .value
            .each_ref()
            .map(|n| n.text.parse::<f64>().unwrap_or(f64::NAN))
    };
    a.name.text == b.name.text
        && a.frame.text == b.frame.text
        && unit(a) == unit(b)
        && numbers(a) == numbers(b)
}
