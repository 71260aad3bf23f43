//! Effects generated for models that state their equations: terms missing from a derivative.

use std::collections::BTreeSet;

use super::EffectTree;
use crate::location::Span;
use crate::syntax::ast::{
    Equation, ExprKind, File, FrameKind, ItemKind, State, UnitExpr, UnitFactor,
};
use crate::syntax::of_kind;

/// Maximum number of equations per model for which effects are created.
const MAX_EQUATIONS: usize = 24;

/// Creates three effects for each equation of a model without a body, except those that only name a state and those of
/// quaternions, whose norm is 1.
pub(super) fn rate_effects(file: &File) -> Vec<EffectTree> {
    if file.body().is_some() {
        return Vec::new();
    }
    let states = states(file);
    let named: BTreeSet<&str> = states
        .iter()
        .map(|state| state.name.text.as_str())
        .collect();
    let quaternions = file.frames().filter_map(|frame| match &frame.kind {
        FrameKind::Quaternion { states, .. } => Some(states.each_ref().map(|own| &*own.text)),
        _ => None,
    });
    let of_attitude: BTreeSet<&str> = quaternions.flatten().collect();
    let equations = equations(file).filter(|equation| {
        !is_state(equation, &named) && !of_attitude.contains(&*equation.state.text)
    });
    equations
        .take(MAX_EQUATIONS)
        .filter_map(|equation| {
            let state = states.iter().find(|s| s.name.text == equation.state.text)?;
            Some(of_equation(state))
        })
        .flatten()
        .collect()
}

/// States that the file itself declares, in the order of declaration; states that applied effects added are omitted.
fn states(file: &File) -> Vec<&State> {
    let own = file.items.iter().filter(|item| item.effect.is_none());
    of_kind!(own, ItemKind::State).collect()
}

fn equations(file: &File) -> impl Iterator<Item = &Equation> {
    of_kind!(file.items.iter(), ItemKind::Equation)
}

/// Whether the right-hand side of an equation is only the name of a state, as in `der(phi) = phidot`.
fn is_state(equation: &Equation, states: &BTreeSet<&str>) -> bool {
    matches!(&equation.value.kind, ExprKind::Name(name) if states.contains(name.as_str()))
}

/// Effects that add a constant, a multiple of time or a multiple of the state to its derivative.
fn of_equation(state: &State) -> impl Iterator<Item = EffectTree> {
    let name = &state.name.text;
    let per = |seconds: i32| format!("[{}]", per_second(state.value.unit.as_ref(), seconds));
    let forms = [
        (
            format!("rate_of_{name}"),
            "is missing a steady rate",
            "none",
            per(1),
            "",
        ),
        (
            format!("rate_of_{name}_by_time"),
            "is missing a rate that grows with the time",
            "time",
            per(2),
            "*time",
        ),
        (
            format!("rate_of_{name}_by_itself"),
            "is missing a rate in proportion to it",
            "none",
            "[1/s]".to_owned(),
            name.as_str(),
        ),
    ];
    let texts = forms.map(|(effect, says, depends_on, unit, factor)| {
        let factor = match factor {
            "" | "*time" => factor.to_owned(),
            name => format!("*{name}"),
        };
        format!(
            "/// The equation for {name} {says}.\n\
             effect {effect} {{\n\
             source \"whatever the stated equation leaves out\";\n\
             site unknown;\n\
             variables {depends_on};\n\
             /// what is missing from the derivative of {name}\n\
             coefficient k_{effect} = 0 {unit};\n\
             negligible k_{effect} 1e-3 {unit};\n\
             replace der({name}) = previous + k_{effect}{factor};\n}}\n"
        )
    });
    texts
        .into_iter()
        .filter_map(|text| EffectTree::parse("stated equations", &text).ok())
}

/// Text of the unit `unit` divided by s^`power`. If `unit` is `None`, the unit 1 is divided.
pub(super) fn per_second(unit: Option<&UnitExpr>, power: i32) -> String {
    let mut factors = unit.map_or_else(Vec::new, |unit| unit.factors.clone());
    match factors.iter_mut().find(|factor| factor.symbol == "s") {
        Some(seconds) => seconds.doubled -= 2 * power,
        None => factors.push(UnitFactor {
            symbol: "s".to_owned(),
            doubled: -2 * power,
            span: Span::default(),
        }),
    }
    factors.retain(|factor| factor.doubled != 0);
    let span = Span::default();
    let unit = UnitExpr { factors, span }.to_string();
    unit.trim_matches(['[', ']']).to_owned()
}
