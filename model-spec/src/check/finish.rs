//! Final pass of the semantic check: substitutes inferred units and assigns a unit to every expression.

use super::term::Term;
use super::{Checker, UnitOf};
use crate::diagnostic::{Diagnostic, Kind};
use crate::model::{Expr, ExprKind, Function};
use crate::unit::Unit;

impl Checker<'_> {
    /// Stores the inferred units of parameters and expressions in the model, and adds the applied effects.
    pub fn finish(&mut self) {
        self.undetermined();
        let units = &self.units;
        let inferred = |term: &Term| units.resolve(term).unit().unwrap_or_default().tidy();
        let model = &mut self.model;
        let params = model.params.iter_mut().zip(&self.params);
        let coefficients = model.coefficients.iter_mut().zip(&self.coefficients);
        for (parameter, term) in params.chain(coefficients).filter(|(own, _)| own.inferred) {
            parameter.unit = inferred(term);
            parameter.unit_text = parameter.unit.to_string();
        }
        for (input, term) in model.inputs.iter_mut().zip(&self.inputs) {
            if term.has_unknowns() {
                input.unit = inferred(term);
                input.unit_text = input.unit.to_string();
            }
        }
        for (state, term) in model.states.iter_mut().zip(&self.states) {
            if term.has_unknowns() {
                state.unit = inferred(term);
                state.unit_text = state.unit.to_string();
            }
        }
        self.assign();
        self.applied();
    }

    /// Reports units that could not be inferred, unless other errors may be the cause.
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
            // A unit that depends on another unknown is reported with that unknown.
            if term.has_unknowns() && !term.unknowns().any(|u| u as usize == unknown) {
                continue;
            }
            let name = self.units.name(unknown as u32).to_owned();
            let declared = self.scope.place(&name).unwrap_or(file.end);
            let message = if term.has_unknowns() {
                format!("the unit of `{name}` cannot be inferred from how it is used")
            } else {
                format!("the unit of `{name}` comes out as a power that is neither whole nor half")
            };
            let fault = Diagnostic::new(Kind::Unit, declared, message)
                .label(declared, "to be inferred, by `[?]`")
                .label(used, "used here");
            self.report(fault.help("write its unit behind the number where it is declared"));
        }
    }

    fn assign(&mut self) {
        let rates = self.model.systems.iter().map(|system| {
            let states = system.unknowns.iter().map(|unknown| unknown.state);
            let unit = |state: usize| self.model.states[state].unit.checked_div(Unit::SECOND);
            states.map(|state| state.and_then(unit)).collect()
        });
        let rates = rates.collect();
        let model = &mut self.model;
        let mut tables = Tables {
            rates,
            params: model.params.iter().map(|c| c.unit).collect(),
            coefficients: model.coefficients.iter().map(|c| c.unit).collect(),
            inputs: model.inputs.iter().map(|c| c.unit).collect(),
            states: model.states.iter().map(|c| c.unit).collect(),
            tables: model.tables.iter().map(|t| t.unit).collect(),
            lets: Vec::with_capacity(model.aux_variables.len()),
        };
        for (i, named) in model.aux_variables.iter_mut().enumerate() {
            tables.assign(&mut named.value);
            if let UnitOf::Term(term) = &self.variables[i].unit
                && let Some(unit) = self.units.resolve(term).unit()
            {
                named.value.unit = unit;
            }
            tables.lets.push(named.value.unit);
        }
        // The auxiliary variables, which come first, have their units.
        for e in model.expressions_mut().into_iter().skip(tables.lets.len()) {
            tables.assign(e);
        }
    }
}

fn bare_zero(e: &Expr) -> bool {
    matches!(e.kind, ExprKind::Number { value: 0.0, .. }) && e.unit == Unit::ONE
}

struct Tables {
    params: Vec<Unit>,
    coefficients: Vec<Unit>,
    inputs: Vec<Unit>,
    states: Vec<Unit>,
    tables: Vec<Unit>,
    lets: Vec<Unit>,
    /// Units of the unknowns of each system that are derivatives.
    rates: Vec<Vec<Option<Unit>>>,
}

impl Tables {
    fn assign(&self, e: &mut Expr) {
        use ExprKind as K;
        let mul = |a: Unit, b: Unit| a.checked_mul(b).unwrap_or_default();
        // A literal 0 takes the unit of the other operand.
        let either = |a: &Expr, b: &Expr| if bare_zero(a) { b.unit } else { a.unit };
        for child in e.children_mut() {
            self.assign(child);
        }
        e.unit = match &e.kind {
            K::Number { .. } => e.unit,
            K::Unknown(system, k) => self.rates[*system][*k].unwrap_or(e.unit),
            K::Determinacy(_) | K::Pi | K::Axis(..) | K::Direction(..) => Unit::ONE,
            K::RealPower(a, b) => { b.rational() }
                .and_then(|(above, below)| a.unit.checked_pow(above, below))
                .unwrap_or(Unit::ONE),
            K::Time => Unit::SECOND,
            K::Param(i) => self.params[*i],
            K::Coefficient(i) => self.coefficients[*i],
            K::Input(i) => self.inputs[*i],
            K::State(i) => self.states[*i],
            K::AuxVariable(i) => self.lets.get(*i).copied().unwrap_or_default(),
            K::Position | K::Marker => Unit::METRE,
            K::Velocity => Unit::SPEED,
            K::AngularVelocity => Unit::RATE,
            K::SpecificForce => Unit::ACCELERATION,
            K::AngularAcceleration => Unit::ANGULAR_ACCELERATION,
            K::Components(parts) => parts
                .iter()
                .find(|p| !bare_zero(p))
                .map_or(Unit::ONE, |p| p.unit),
            K::Rate(a, ..) => a.unit.checked_div(Unit::SECOND).unwrap_or_default(),
            K::BodyRate(i, _) => { self.states[*i].checked_div(Unit::SECOND) }.unwrap_or_default(),
            K::Partial(a, i) => a.unit.checked_div(self.states[*i]).unwrap_or_default(),
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
            K::Call(Function::Table(i), _) | K::Lookup(i, ..) => self.tables[*i],
            K::Call(..) => Unit::ONE,
        };
    }
}
