//! A point at which a model is evaluated: a number for every name.

use crate::scalar::{Field, Real};
use model_spec::model::Model;
use nalgebra::Vector3;

/// A number for every name of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Point<T> {
    /// Time since release.
    pub time: T,
    /// As in [`Model::params`].
    pub params: Vec<T>,
    /// As in [`Model::coefficients`].
    pub coefficients: Vec<T>,
    /// As in [`Model::inputs`], components in each one's frame.
    pub inputs: Vec<Vector3<T>>,
    /// As in [`Model::states`].
    pub states: Vec<T>,
    /// Coordinates of the marker in its frame.
    pub marker: Vector3<T>,
}

impl Point<f64> {
    /// Every name at its default.
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

    /// The same point in other numbers.
    pub fn lift<T: Real>(&self) -> Point<T> {
        self.map(T::lit)
    }
}

impl<T: Field> Point<T> {
    /// The same point in other numbers.
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
