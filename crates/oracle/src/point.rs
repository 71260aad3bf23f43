//! Point of evaluation of a model: a value for every variable.

use crate::scalar::{Field, Real};
use model_spec::model::Model;
use nalgebra::Vector3;

/// Values of the time, parameters, coefficients, inputs, states and marker position of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Point<T> {
    /// Recorded time since release, s; equal to true time unless the model declares another rate of the time stamps.
    pub time: T,
    /// Values of the model's parameters, in the order of [`Model::params`].
    pub params: Vec<T>,
    /// Values of the model's coefficients, in the order of [`Model::coefficients`].
    pub coefficients: Vec<T>,
    /// Values of the inputs, in the order of [`Model::inputs`], with components in their declared frames.
    pub inputs: Vec<Vector3<T>>,
    /// Values of the model's states, in the order of [`Model::states`].
    pub states: Vec<T>,
    /// Coordinates of the observed marker in the frame in which the model declares marker positions, m.
    pub marker: Vector3<T>,
}

impl Point<f64> {
    /// Default values of all variables of a model, at time 0 and with the marker at the origin of its frame.
    pub fn defaults(model: &Model) -> Self {
        Self {
            time: 0.0,
            params: model.params.iter().map(|c| c.value).collect(),
            coefficients: model.coefficients.iter().map(|c| c.value).collect(),
            inputs: model
                .inputs
                .iter()
                .map(|i| Vector3::from(i.value))
                .collect(),
            states: model.states.iter().map(|s| s.value).collect(),
            marker: Vector3::zeros(),
        }
    }

    /// Converts every value to a constant of another scalar type, with derivative 0 if that type carries derivatives.
    pub fn lift<T: Real>(&self) -> Point<T> {
        self.map(T::lit)
    }
}

impl<T: Field> Point<T> {
    /// Values of parameters, coefficients and components of inputs in one list, in this order.
    pub fn parameters(&self) -> Vec<T> {
        let inputs = self.inputs.iter().flat_map(|v| v.iter());
        let constants = self.params.iter().chain(&self.coefficients);
        constants.chain(inputs).copied().collect()
    }

    /// Iterates mutably over the values of parameters, coefficients and components of inputs, in this order.
    pub fn parameters_mut(&mut self) -> impl Iterator<Item = &mut T> {
        let inputs = self.inputs.iter_mut().flat_map(|v| v.iter_mut());
        let constants = self.params.iter_mut().chain(&mut self.coefficients);
        constants.chain(inputs)
    }

    /// Applies the function `f` to every value, for example to convert it to another scalar type.
    pub fn map<U: Field>(&self, mut f: impl FnMut(T) -> U) -> Point<U> {
        Point {
            time: f(self.time),
            params: self.params.iter().map(|&v| f(v)).collect(),
            coefficients: self.coefficients.iter().map(|&v| f(v)).collect(),
            inputs: self.inputs.iter().map(|v| v.map(&mut f)).collect(),
            states: self.states.iter().map(|&v| f(v)).collect(),
            marker: self.marker.map(&mut f),
        }
    }
}
