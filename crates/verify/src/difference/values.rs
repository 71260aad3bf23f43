//! Evaluates every value of a model, in floating-point numbers and in the prime field: derivatives, observation,
//! limits, named quantities, loads.

use crate::engine::outputs;
use crate::evaluation::Inputs;
use crate::field::FieldPoint;
use crate::symbolic;
use codegen::EveryValue;
use codegen::tape::Tape;
use model_spec::model::{AuxVariable, Expr, ExprKind, Load, Model, Shape};
use oracle::Point;
use oracle::scalar::Prime;
use std::collections::BTreeMap;
use std::ops::Range;

/// A model compiled to one program of all its values; vectors in other frames also in inertial components.
pub struct Everything<'a> {
    /// Model whose values are evaluated.
    pub model: &'a Model,
    /// Program of state derivatives, observation, limits and auxiliary variables; then, in inertial components, loads
    /// and vectors of other frames.
    pub code: EveryValue,
    /// Auxiliary variables and loads with their outputs of `code`.
    pub named: Vec<Named>,
    tape: Tape,
}

/// An auxiliary variable or load, with its outputs.
pub struct Named {
    /// Class of the statement: `let`, `force` or `moment`.
    pub class: &'static str,
    /// Name of the auxiliary variable or load.
    pub name: String,
    /// Indices of its outputs: one of a scalar, three of a vector.
    pub outputs: Range<usize>,
}

impl<'a> Everything<'a> {
    /// Compiles a model.
    pub fn of(model: &'a Model) -> Self {
        let mut extended = model.clone();
        let mut sources: Vec<(&'static str, String, usize)> = Vec::new();
        for (index, quantity) in model.aux_variables.iter().enumerate() {
            let place = match quantity.value.shape {
                Shape::Vector(frame) if frame != 0 => {
                    let value = Expr {
                        kind: ExprKind::AuxVariable(index),
                        ..quantity.value.clone()
                    };
                    add(&mut extended, value)
                }
                _ => index,
            };
            sources.push(("let", quantity.name.clone(), place));
        }
        let loads = |loads: &'a [Load], class: &'static str| loads.iter().map(move |l| (class, l));
        for (class, load) in loads(&model.forces, "force").chain(loads(&model.moments, "moment")) {
            let place = add(&mut extended, load.value.clone());
            sources.push((class, load.name.clone(), place));
        }
        let code = codegen::compile_every_value(&extended);
        let first = code.layout.states.len() + code.observed + code.limits;
        let start = |place: usize| first + code.lets[..place].iter().sum::<usize>();
        let named = sources
            .into_iter()
            .map(|(class, name, place)| Named {
                class,
                name,
                outputs: start(place)..start(place) + code.lets[place],
            })
            .collect();
        Self {
            model,
            tape: Tape::new(&code.program),
            code,
            named,
        }
    }

    /// Names of state derivatives, components of the observation and limits.
    pub fn rows(&self) -> Vec<String> {
        let states = self.code.layout.states.iter();
        let observed = ["x", "y", "z"].into_iter().take(self.code.observed);
        let limits = 1..=self.code.limits;
        states
            .map(|state| format!("der({state})"))
            .chain(observed.map(|axis| format!("observation {axis}")))
            .chain(limits.map(|k| format!("limit {k}")))
            .collect()
    }

    /// Outputs by name of the row, or by class and name.
    pub fn groups(&self) -> BTreeMap<String, Range<usize>> {
        let rows = self.rows().into_iter().zip(0..);
        let rows = rows.map(|(row, k)| (row, k..k + 1));
        let named = self.named.iter();
        let named = named.map(|n| (format!("{} {}", n.class, n.name), n.outputs.clone()));
        rows.chain(named).collect()
    }

    /// All outputs in floating-point arithmetic.
    pub fn numbers(&self, point: &Point<f64>) -> Vec<f64> {
        outputs(&self.tape, &Inputs::of(point))
    }

    /// All outputs in the prime field; `None` for a value that does not exist.
    pub fn exact(&self, spot: &FieldPoint) -> Vec<Option<Prime>> {
        symbolic::outputs(&self.code.program, spot)
    }
}

/// Appends an auxiliary variable, in inertial components, and returns its index.
fn add(model: &mut Model, value: Expr) -> usize {
    let index = model.aux_variables.len();
    let value = match value.shape {
        Shape::Vector(frame) if frame != 0 => Expr {
            shape: Shape::Vector(0),
            unit: value.unit,
            span: value.span,
            kind: ExprKind::Reexpress(Box::new(value)),
        },
        _ => value,
    };
    let name = format!("compared_{index}");
    model.aux_variables.push(AuxVariable::new(name, value));
    index
}
