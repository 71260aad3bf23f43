//! Equations of a model linearised by its states and scalar inputs.

use model_spec::layout::{Layout, ParamId};
use model_spec::model::Model;
use model_spec::unit::Unit;
use nalgebra::DMatrix;

/// Equations linearised about a state: departures x of states and u of inputs obey ẋ = A x + B u, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct StateSpace {
    /// Names of the states, the rows of both matrices and the columns of A.
    pub states: Vec<String>,
    /// Names of the scalar inputs, the columns of B.
    pub inputs: Vec<String>,
    /// Derivatives of the rates of the states by the states.
    pub a: DMatrix<f64>,
    /// Derivatives of the rates of the states by the inputs.
    pub b: DMatrix<f64>,
    /// Texts of the units of B, row by row.
    units: Vec<String>,
}

/// Derivative of the rate of a state by an input: an entry of B.
#[derive(Clone, Debug, PartialEq)]
pub struct ControlDerivative<'s> {
    /// Name of the state.
    pub state: &'s str,
    /// Name of the input.
    pub input: &'s str,
    /// The derivative, SI.
    pub value: f64,
    /// Text of its unit.
    pub unit: &'s str,
}

impl StateSpace {
    /// `by_parameter` has the row, parameter and value of each derivative of a rate by a parameter.
    pub(super) fn new(
        model: &Model,
        layout: &Layout,
        a: DMatrix<f64>,
        by_parameter: impl Iterator<Item = (usize, usize, f64)>,
    ) -> StateSpace {
        let inputs: Vec<_> = model.params.iter().filter(|own| own.varies).collect();
        let columns = inputs.iter().map(|own| layout.parameter(&own.name));
        let columns: Vec<_> = columns.map(|id| id.map(ParamId::index)).collect();
        let mut b = DMatrix::zeros(a.nrows(), inputs.len());
        for (row, parameter, value) in by_parameter {
            if let Some(column) = columns.iter().position(|own| *own == Some(parameter)) {
                b[(row, column)] += value;
            }
        }
        let units = model.states.iter().flat_map(|state| {
            inputs.iter().map(|input| {
                let rate = state.unit.checked_div(Unit::SECOND);
                let by = rate.and_then(|rate| rate.checked_div(input.unit));
                by.map_or_else(String::new, |unit| unit.tidy().pretty())
            })
        });
        StateSpace {
            units: units.collect(),
            states: model.states.iter().map(|own| own.name.clone()).collect(),
            inputs: inputs.iter().map(|own| own.name.clone()).collect(),
            a,
            b,
        }
    }

    /// Entries of B that are not 0, state by state.
    pub fn control_derivatives(&self) -> impl Iterator<Item = ControlDerivative<'_>> {
        let entries = self
            .states
            .iter()
            .enumerate()
            .flat_map(move |(row, state)| {
                let inputs = self.inputs.iter().enumerate();
                inputs.map(move |(column, input)| ControlDerivative {
                    state,
                    input,
                    value: self.b[(row, column)],
                    unit: &self.units[row * self.inputs.len() + column],
                })
            });
        entries.filter(|entry| entry.value != 0.0)
    }
}
