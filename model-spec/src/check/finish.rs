//! The end: unknown units are put in, and every expression learns its own.

use super::{Checker, UnitOf};
use crate::diagnostic::{Diagnostic, Kind};
use crate::model::{Expr, ExprKind, Function};
use crate::unit::Unit;

impl Checker<'_> {
    /// Puts in all units that were inferred.
    pub fn finish(&mut self) {
        self.undetermined();
        for i in 0..self.model.params.len() {
            if self.model.params[i].inferred {
                let unit = self.inferred(&self.params[i].clone());
                let constant = &mut self.model.params[i];
                (constant.unit, constant.unit_text) = (unit, unit.to_string());
            }
        }
        for i in 0..self.model.coefficients.len() {
            if self.model.coefficients[i].inferred {
                let unit = self.inferred(&self.coefficients[i].clone());
                let constant = &mut self.model.coefficients[i];
                (constant.unit, constant.unit_text) = (unit, unit.to_string());
            }
        }
        for i in 0..self.model.inputs.len() {
            if self.inputs[i].has_unknowns() {
                let unit = self.inferred(&self.inputs[i].clone());
                let input = &mut self.model.inputs[i];
                (input.unit, input.unit_text) = (unit, unit.to_string());
            }
        }
        for i in 0..self.model.states.len() {
            if self.states[i].has_unknowns() {
                let unit = self.inferred(&self.states[i].clone());
                let state = &mut self.model.states[i];
                (state.unit, state.unit_text) = (unit, unit.to_string());
            }
        }
        self.assign();
        self.applied();
    }

    fn inferred(&self, term: &super::term::Term) -> Unit {
        self.units.resolve(term).unit().unwrap_or_default().tidy()
    }

    /// Reports units that could not be inferred; only where nothing else is wrong that would explain it.
    fn undetermined(&mut self) {
        if !self.diagnostics.is_empty() {
            return;
        }
        let file = self.file;
        for (unknown, first_use) in self.first_uses.clone().into_iter().enumerate() {
            let term = self.units.solution(unknown as u32);
            let Some(used) = first_use.filter(|_| term.unit().is_none()) else {
                continue;
            };
            // What follows from another unknown is reported with that one.
            if term.has_unknowns() && !term.unknowns().any(|u| u as usize == unknown) {
                continue;
            }
            let name = self.units.name(unknown as u32).to_owned();
            let declared = self.scope.place(&name).unwrap_or(file.end);
            let mut fault = if term.has_unknowns() {
                let message =
                    format!("the unit of `{name}` cannot be inferred from how it is used");
                Diagnostic::new(Kind::Unit, declared, message)
            } else {
                let message = format!(
                    "the unit of `{name}` comes out as a power that is neither whole nor half"
                );
                Diagnostic::new(Kind::Unit, declared, message)
            };
            fault = fault
                .label(declared, "declared without a unit")
                .label(used, "used here");
            self.report(fault.help("write its unit behind the number where it is declared"));
        }
    }

    /// Every expression learns its unit, from its leaves upwards.
    fn assign(&mut self) {
        let model = &mut self.model;
        let mut tables = Tables {
            params: model.params.iter().map(|c| c.unit).collect(),
            coefficients: model.coefficients.iter().map(|c| c.unit).collect(),
            inputs: model.inputs.iter().map(|c| c.unit).collect(),
            states: model.states.iter().map(|c| c.unit).collect(),
            lets: Vec::with_capacity(model.aux_variables.len()),
        };
        for (i, named) in model.aux_variables.iter_mut().enumerate() {
            tables.assign(&mut named.value);
            if let UnitOf::Term(term) = &self.let_units[i]
                && let Some(unit) = self.units.resolve(term).unit()
            {
                named.value.unit = unit;
            }
            tables.lets.push(named.value.unit);
        }
        for e in expressions(model) {
            tables.assign(e);
        }
    }
}

fn bare_zero(e: &Expr) -> bool {
    matches!(e.kind, ExprKind::Number { value: 0.0, .. }) && e.unit == Unit::ONE
}

/// All expressions of a model but those of its named quantities.
fn expressions(model: &mut crate::model::Model) -> Vec<&mut Expr> {
    let mut all: Vec<&mut Expr> = Vec::new();
    if let Some(body) = &mut model.body {
        all.push(&mut body.mass);
        if let Some(rotation) = &mut body.rotation {
            all.extend(rotation.inertia.iter_mut().flatten());
        }
    }
    all.extend(
        model
            .forces
            .iter_mut()
            .chain(&mut model.moments)
            .map(|l| &mut l.value),
    );
    all.extend(model.equations.iter_mut().map(|e| &mut e.value));
    all.extend(model.observation.iter_mut().map(|o| &mut o.value));
    all.extend(model.clock.iter_mut().map(|c| &mut c.value));
    all.extend(model.limits.iter_mut().map(|l| &mut l.value));
    all
}

/// Units of everything that has a name.
struct Tables {
    params: Vec<Unit>,
    coefficients: Vec<Unit>,
    inputs: Vec<Unit>,
    states: Vec<Unit>,
    lets: Vec<Unit>,
}

impl Tables {
    fn assign(&self, e: &mut Expr) {
        use ExprKind as K;
        let mul = |a: Unit, b: Unit| a.checked_mul(b).unwrap_or_default();
        // A bare 0 has the unit of what stands beside it.
        let either = |a: &Expr, b: &Expr| if bare_zero(a) { b.unit } else { a.unit };
        e.children_mut(&mut |child| self.assign(child));
        e.unit = match &e.kind {
            K::Number { .. } => e.unit,
            K::Pi | K::Axis(..) | K::Direction(..) => Unit::ONE,
            K::Time => Unit::SECOND,
            K::Param(i) => self.params[*i],
            K::Coefficient(i) => self.coefficients[*i],
            K::Input(i) => self.inputs[*i],
            K::State(i) => self.states[*i],
            K::AuxVariable(i) => self.lets.get(*i).copied().unwrap_or_default(),
            K::Position | K::Marker => Unit::METRE,
            K::Velocity => Unit::SPEED,
            K::AngularVelocity => Unit::RATE,
            K::Components(parts) => parts
                .iter()
                .find(|p| !bare_zero(p))
                .map_or(Unit::ONE, |p| p.unit),
            K::Neg(a) | K::Norm(a) | K::Component(a, _) | K::Reexpress(a) => a.unit,
            K::Add(a, b) | K::Sub(a, b) | K::Min(a, b) | K::Max(a, b) => either(a, b),
            K::Mul(a, b) | K::Dot(a, b) | K::Cross(a, b) => mul(a.unit, b.unit),
            K::Div(a, b) => a.unit.checked_div(b.unit).unwrap_or_default(),
            K::Ratio(parts) => parts[0].unit.checked_div(parts[1].unit).unwrap_or_default(),
            K::Pow(a, doubled) => a.unit.checked_pow_half(*doubled).unwrap_or_default(),
            K::Atan2(..) | K::Call(Function::Asin | Function::Acos | Function::Atan, _) => {
                Unit::RADIAN
            }
            K::Call(Function::Abs, a) => a.unit,
            K::Call(Function::Sqrt, a) => a.unit.checked_pow_half(1).unwrap_or_default(),
            K::Call(..) => Unit::ONE,
        };
    }
}
