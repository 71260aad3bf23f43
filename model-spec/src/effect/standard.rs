//! Standard names of mass, inertia and frames of any model, and needed quantities with a fallback, which are replaced
//! by the model's own.

use std::collections::{HashMap, HashSet};

use crate::diagnostic::{Diagnostic, Kind};
use crate::syntax::ast::{
    BodyPartKind, Effect, EffectPart, Expr, ExprKind, File, ItemKind, Name, Need,
};
use crate::syntax::reserved::OF_BODY;

/// Name by which an effect refers to the mass of any model's body.
const MASS: &str = "mass";

/// Names of the moments of inertia about axes 1, 2 and 3 of the inertia frame.
const INERTIA: [&str; 3] = ["inertia_11", "inertia_22", "inertia_33"];

/// Names of the inertial frame and of the body-fixed frame.
const FRAMES: [&str; 2] = ["inertial", "body"];

/// Replacements of the standard names: expressions and frames.
#[derive(Default)]
struct Standard {
    values: HashMap<String, Expr>,
    frames: HashMap<&'static str, String>,
}

/// Returns a copy of an effect that refers to the quantities of the model in `file`. The standard names ([`MASS`],
/// [`INERTIA`], [`FRAMES`]) are replaced by expressions and frame names of the model, except names that the model or
/// the effect declares. Needed quantities that the model lacks are replaced by their fallback expressions.
pub(super) fn in_names_of(file: &File, effect: &Effect) -> Result<Effect, Vec<Diagnostic>> {
    let mut standard = Standard::of_model(file);
    let (declared, own) = (file.declared(), declared_by(effect));
    standard
        .values
        .retain(|name, _| !declared.contains(name) && !own.contains(name.as_str()));
    let (replaced, faults): (Vec<&Need>, Vec<&Need>) =
        lacking(file, effect).partition(|need| need.otherwise.is_some());
    if !faults.is_empty() {
        return Err({ faults.into_iter() }
            .map(|need| fault(&effect.name, need))
            .collect());
    }
    let fallbacks: HashMap<String, Expr> = replaced
        .into_iter()
        .filter_map(|need| Some((need.name.text.clone(), need.otherwise.clone()?)))
        .collect();
    let lacks = |name: &str| fallbacks.contains_key(name);
    let mut effect = effect.clone();
    for part in &mut effect.parts {
        if let EffectPart::Needs(needs) = part {
            needs.retain(|need| !lacks(&need.name.text));
        }
    }
    for expression in expressions(&mut effect) {
        replace_names(expression, &fallbacks);
        standard.rename(expression);
    }
    for part in &mut effect.parts {
        match part {
            EffectPart::ReplaceInertia(inertia, _) => standard.rename_frame(&mut inertia.frame),
            EffectPart::Add(item) => match &mut item.kind {
                ItemKind::Input(input) => standard.rename_frame(&mut input.frame),
                ItemKind::Function(function) => {
                    let parameters = function.parameters.iter_mut().map(|own| &mut own.of);
                    let types = parameters.chain([&mut function.result]);
                    for frame in types.filter_map(|of| of.frame.as_mut()) {
                        standard.rename_frame(frame);
                    }
                }
                _ => {}
            },
            _ => {}
        }
    }
    Ok(effect)
}

/// Quantities that an effect needs, and neither the model in `file` nor the effect has.
pub(crate) fn lacking<'e>(file: &File, effect: &'e Effect) -> impl Iterator<Item = &'e Need> {
    let (declared, own) = (file.declared(), declared_by(effect));
    let has_body = file.body().is_some();
    effect.needs().filter(move |need| {
        let name = need.name.text.as_str();
        let is_of_body = has_body && OF_BODY.contains(&name) && !own.contains(name);
        !declared.contains(name) && !is_of_body
    })
}

fn fault(effect: &Name, need: &Need) -> Diagnostic {
    let name = &need.name.text;
    let kind = if need.is_vector { "vector" } else { "quantity" };
    let unit = need.unit.as_ref().map(|unit| format!(" in {unit}"));
    let message = format!(
        "the effect `{}` needs a {kind} `{name}`{}, and the model has none",
        effect.text,
        unit.unwrap_or_default()
    );
    Diagnostic::new(Kind::Missing, need.name.span, message).help(format!(
        "if the model has it under another name, add `let {name} = …;`"
    ))
}

impl Standard {
    fn of_model(file: &File) -> Standard {
        let mut standard = Standard::default();
        let own = |wanted: &str| file.frames().any(|frame| frame.name.text == wanted);
        if let (Some(frame), false) = (file.inertial(), own(FRAMES[0])) {
            standard.frames.insert(FRAMES[0], frame.to_owned());
        }
        let Some(body) = file.body() else {
            return standard;
        };
        for part in &body.parts {
            match &part.kind {
                BodyPartKind::Value(mass) => {
                    standard.values.insert(MASS.to_owned(), mass.clone());
                }
                BodyPartKind::Frame(frame) if part.words == "fixed in" && !own(FRAMES[1]) => {
                    standard.frames.insert(FRAMES[1], frame.text.clone());
                }
                BodyPartKind::Inertia(inertia) => {
                    for (k, name) in INERTIA.iter().enumerate() {
                        if let Some(moment) = &inertia.rows[k][k] {
                            standard.values.insert((*name).to_owned(), moment.clone());
                        }
                    }
                }
                _ => {}
            }
        }
        standard
    }

    fn rename(&self, e: &mut Expr) {
        if let ExprKind::Name(name) = &e.kind
            && let Some(value) = self.values.get(name)
        {
            e.kind = value.kind.clone();
            return;
        }
        match &mut e.kind {
            ExprKind::Part(of, _) => {
                if let ExprKind::Name(name) = &mut of.kind
                    && let Some(frame) = self.frames.get(name.as_str())
                {
                    name.clone_from(frame);
                    return;
                }
            }
            ExprKind::Components(_, frame) => self.rename_frame(frame),
            ExprKind::Call(function, _) => {
                let frame = function.text.strip_prefix("in_");
                if let Some(frame) = frame.and_then(|frame| self.frames.get(frame)) {
                    function.text = format!("in_{frame}");
                }
            }
            _ => {}
        }
        for child in e.children_mut() {
            self.rename(child);
        }
    }

    fn rename_frame(&self, frame: &mut Name) {
        if let Some(own) = self.frames.get(frame.text.as_str()) {
            frame.text.clone_from(own);
        }
    }
}

pub(super) fn replace_names(e: &mut Expr, by: &HashMap<String, Expr>) {
    if let ExprKind::Name(name) = &e.kind
        && let Some(value) = by.get(name)
    {
        e.kind = value.kind.clone();
        return;
    }
    for child in e.children_mut() {
        replace_names(child, by);
    }
}

fn expressions(effect: &mut Effect) -> impl Iterator<Item = &mut Expr> {
    effect.parts.iter_mut().flat_map(|part| match part {
        EffectPart::Replace(item) | EffectPart::Add(item) => item.kind.roots_mut(),
        EffectPart::ReplaceInertia(inertia, _) => {
            inertia.rows.iter_mut().flatten().flatten().collect()
        }
        _ => Vec::new(),
    })
}

/// Names of the parameters, inputs, states and auxiliary variables that an effect declares.
fn declared_by(effect: &Effect) -> HashSet<&str> {
    let declared = effect.added().filter_map(|item| item.kind.declared());
    declared.map(|name| name.text.as_str()).collect()
}
