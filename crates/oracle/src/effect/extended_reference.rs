//! Reference implementations of a model's law and effects, bound to the names in the model.

use super::{ActiveEffect, Effect, ExtendedLaw, by_name};
use crate::error::BindError;
use crate::point::Point;
use crate::reference::{Reference, inertial_input};
use crate::scalar::Real;
use model_spec::model::Model;
use nalgebra::Vector3;

/// The reference law and the effects of a model. Contains the indices in the model of the law's constants and of the
/// effects' coefficients and states.
#[derive(Clone, Debug)]
pub struct ExtendedReference {
    /// The reference law, without effects.
    pub reference: Reference,
    effects: Vec<(&'static Effect, Vec<Slot>)>,
    omega: Option<usize>,
    marker_is: Option<usize>,
}

#[derive(Clone, Copy, Debug)]
enum Slot {
    Coefficient(usize),
    State(usize),
}

impl ExtendedReference {
    /// Looks up, in a model, the constants and states of its reference law and the coefficients and states of its
    /// effects. `None` if the model names no reference law.
    ///
    /// # Errors
    /// The errors of [`Reference::bind`]; [`BindError::UnknownEffect`] if an effect has no reference implementation for
    /// the law, [`BindError::MissingEffectValue`] if the model does not declare a coefficient or state of an effect.
    pub fn bind(model: &Model) -> Option<Result<Self, BindError>> {
        Some(Reference::bind(model)?.and_then(|reference| Self::of(reference, model)))
    }

    fn of(reference: Reference, model: &Model) -> Result<Self, BindError> {
        let bound = |name: &str| {
            let effect = by_name(name)
                .filter(|effect| effect.laws.contains(&reference.law))
                .ok_or_else(|| BindError::UnknownEffect { name: name.into() })?;
            Ok((effect, slots(effect, model)?))
        };
        let effects = model.effects.iter().map(|effect| bound(&effect.name));
        let effects = effects.collect::<Result<_, _>>()?;
        let input = |name: &str| model.inputs.iter().position(|input| input.name == name);
        Ok(Self {
            effects,
            omega: inertial_input(model, "omega")?,
            marker_is: input("marker_is"),
            reference,
        })
    }

    /// Returns the law of motion and its effects, with the values that their constants, coefficients and states have at
    /// a point.
    pub fn at<T: Real>(&self, point: &Point<T>) -> ExtendedLaw<T> {
        let value = |slot: &Slot| match *slot {
            Slot::Coefficient(i) => point.coefficients[i],
            Slot::State(i) => point.states[i],
        };
        let effects = self.effects.iter().map(|(effect, slots)| ActiveEffect {
            effect,
            values: slots.iter().map(value).collect(),
        });
        ExtendedLaw {
            law: self.reference.law,
            constants: self.reference.values(point),
            wind: self.reference.wind(point),
            omega: self.input(self.omega, point),
            effects: effects.collect(),
        }
    }

    /// Computes the derivative of every state with respect to recorded time.
    pub fn derivatives<T: Real>(&self, point: &Point<T>) -> Vec<T> {
        let law = self.at(point);
        let chart = &self.reference.chart;
        let motion = law.motion(&chart.physical(&point.states), point.time);
        let rates = chart.derivatives(&point.states, &motion);
        let clock_rate = law.clock();
        rates.into_iter().map(|rate| rate * clock_rate).collect()
    }

    /// Position, m, that the measurement reports for the marker with the body-frame coordinates [`Point::marker`],
    /// including effects on the observation. The components are along the measurement axes, which are the inertial axes
    /// unless an effect rotates them.
    pub fn observation<T: Real>(&self, point: &Point<T>) -> Vector3<T> {
        let at = self.reference.chart.physical(&point.states);
        let which = self.input(self.marker_is, point);
        self.at(point).observation(&at, point.marker, which)
    }

    fn input<T: Real>(&self, index: Option<usize>, point: &Point<T>) -> Vector3<T> {
        index.map_or_else(Vector3::zeros, |index| point.inputs[index])
    }
}

/// Indices in a model of the coefficients of an effect, followed by those of the states of the effect.
fn slots(effect: &'static Effect, model: &Model) -> Result<Vec<Slot>, BindError> {
    let missing = |name| BindError::MissingEffectValue {
        effect: effect.name,
        name,
    };
    let coefficients = effect.coefficients.iter().map(|&name| {
        let index = model.coefficients.iter().position(|c| c.name == name);
        index.map(Slot::Coefficient).ok_or(missing(name))
    });
    let states = effect.states.iter().map(|&name| {
        let index = model.states.iter().position(|s| s.name == name);
        index.map(Slot::State).ok_or(missing(name))
    });
    coefficients.chain(states).collect()
}
