//! Change of the source spans of an effect's syntax tree, so that they refer to another source text.

use super::ast::{Effect, EffectPart, Expr, ExprKind, Inertia, Item, ItemKind, Quantity, UnitExpr};
use crate::source::Span;

type Change<'a> = &'a mut dyn FnMut(&mut Span);

impl Effect {
    /// Calls `change` on every source span of the syntax tree of an effect.
    pub(crate) fn change_spans(&mut self, change: Change<'_>) {
        change(&mut self.name.span);
        self.on.iter_mut().for_each(|model| change(&mut model.span));
        for part in &mut self.parts {
            match part {
                EffectPart::Needs(needs) => needs.iter_mut().for_each(|need| {
                    change(&mut need.name.span);
                    need.unit.iter_mut().for_each(|u| unit(u, change));
                    need.otherwise
                        .iter_mut()
                        .for_each(|e| expression(e, change));
                }),
                EffectPart::Generalises(names) => {
                    names.iter_mut().for_each(|name| change(&mut name.span));
                }
                EffectPart::Citation(_, span)
                | EffectPart::Increases(_, span)
                | EffectPart::Decreases(_, span) => change(span),
                EffectPart::Site(name) => change(&mut name.span),
                EffectPart::Variables(names, span) => {
                    names.iter_mut().for_each(|name| change(&mut name.span));
                    change(span);
                }
                EffectPart::Negligible(name, value) => {
                    change(&mut name.span);
                    quantity(value, change);
                }
                EffectPart::ReplaceInertia(moments, span) => {
                    inertia(moments, change);
                    change(span);
                }
                EffectPart::Replace(item) | EffectPart::Add(item) => item.change_spans(change),
            }
        }
    }
}

impl Item {
    /// Calls `change` on every span of a statement of a kind that effects contain.
    pub(crate) fn change_spans(&mut self, change: Change<'_>) {
        change(&mut self.span);
        match &mut self.kind {
            ItemKind::Parameter(parameter) => {
                change(&mut parameter.name.span);
                quantity(&mut parameter.value, change);
                if let Some((least, greatest)) = &mut parameter.bounds {
                    quantity(least, change);
                    quantity(greatest, change);
                }
            }
            ItemKind::Input(input) => {
                change(&mut input.name.span);
                change(&mut input.frame.span);
                input.value.iter_mut().for_each(|n| change(&mut n.span));
                input.unit.iter_mut().for_each(|u| unit(u, change));
            }
            ItemKind::State(state) => {
                change(&mut state.name.span);
                quantity(&mut state.value, change);
            }
            ItemKind::Table(table) => {
                change(&mut table.name.span);
                change(&mut table.argument.span);
                for units in [&mut table.argument_unit, &mut table.unit] {
                    units.iter_mut().for_each(|u| unit(u, change));
                }
                for (argument, value) in &mut table.knots {
                    quantity(argument, change);
                    quantity(value, change);
                }
            }
            ItemKind::Let(binding) => {
                change(&mut binding.name.span);
                binding.unit.iter_mut().for_each(|u| unit(u, change));
            }
            ItemKind::Load(load) => change(&mut load.name.span),
            ItemKind::Equation(equation) => change(&mut equation.state.span),
            ItemKind::Observe(observe) => change(&mut observe.name.span),
            ItemKind::Clock(_)
            | ItemKind::Model(_)
            | ItemKind::Reference(_)
            | ItemKind::Frame(_)
            | ItemKind::Body(_)
            | ItemKind::Claim(_)
            | ItemKind::Marker(_)
            | ItemKind::Limit(_)
            | ItemKind::Check(_)
            | ItemKind::Effect(_) => {}
        }
        if let Some(value) = self.kind.value_mut() {
            expression(value, change);
        }
    }
}

fn inertia(inertia: &mut Inertia, change: Change<'_>) {
    change(&mut inertia.frame.span);
    for moment in inertia.rows.iter_mut().flatten().flatten() {
        expression(moment, change);
    }
}

fn quantity(quantity: &mut Quantity, change: Change<'_>) {
    change(&mut quantity.span);
    change(&mut quantity.number.span);
    quantity.unit.iter_mut().for_each(|u| unit(u, change));
}

fn unit(unit: &mut UnitExpr, change: Change<'_>) {
    change(&mut unit.span);
    unit.factors.iter_mut().for_each(|f| change(&mut f.span));
}

fn expression(e: &mut Expr, change: Change<'_>) {
    change(&mut e.span);
    match &mut e.kind {
        ExprKind::Number(number) => quantity(number, change),
        ExprKind::Derivative(name) => change(&mut name.span),
        ExprKind::Components(_, frame) => change(&mut frame.span),
        ExprKind::Call(name, _) => change(&mut name.span),
        ExprKind::Name(_) | ExprKind::Part(..) | ExprKind::Neg(_) | ExprKind::Binary(..) => {}
    }
    e.children_mut(&mut |child| expression(child, change));
}
