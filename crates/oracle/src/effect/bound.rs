//! A model's effects tied to their laws by hand, by name.

use super::{Acting, Effect, World, by_name};
use crate::point::Point;
use crate::reference::Reference;
use crate::scalar::Real;
use model_spec::model::Model;
use nalgebra::Vector3;

/// A reference with the effects that a model has switched on, tied to the model's names.
#[derive(Clone, Debug)]
pub struct Bound {
    /// The law without them.
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

impl Bound {
    /// Ties a model's reference and its effects. `None` where it claims no reference; an error says what there is none of
    /// by hand, or which name is missing.
    pub fn bind(model: &Model) -> Option<Result<Self, String>> {
        Some(Reference::bind(model)?.and_then(|reference| Self::of(reference, model)))
    }

    fn of(reference: Reference, model: &Model) -> Result<Self, String> {
        let tied = |name: &str| {
            let effect = by_name(name)
                .filter(|effect| effect.laws.contains(&reference.law))
                .ok_or_else(|| format!("`{name}` is not written by hand for this law"))?;
            let coefficient = |name: &&str| {
                let index = model.coefficients.iter().position(|c| c.name == **name);
                index
                    .map(Slot::Coefficient)
                    .ok_or_else(|| format!("the coefficient `{name}` is not declared"))
            };
            let state = |name: &&str| {
                let index = model.states.iter().position(|s| s.name == **name);
                index
                    .map(Slot::State)
                    .ok_or_else(|| format!("the state `{name}` is not declared"))
            };
            let coefficients = effect.coefficients.iter().map(coefficient);
            let slots = coefficients.chain(effect.states.iter().map(state));
            Ok::<_, String>((effect, slots.collect::<Result<_, _>>()?))
        };
        let effects = model.effects.iter().map(|effect| tied(&effect.name));
        let effects = effects.collect::<Result<_, _>>()?;
        let input = |name: &str| model.inputs.iter().position(|input| input.name == name);
        Ok(Self {
            effects,
            omega: input("omega"),
            marker_is: input("marker_is"),
            reference,
        })
    }

    /// The law and its effects with the numbers of a point.
    pub fn world<T: Real>(&self, point: &Point<T>) -> World<T> {
        let value = |slot: &Slot| match *slot {
            Slot::Coefficient(i) => point.coefficients[i],
            Slot::State(i) => point.states[i],
        };
        let effects = self.effects.iter().map(|(effect, slots)| Acting {
            effect,
            values: slots.iter().map(value).collect(),
        });
        World {
            law: self.reference.law,
            constants: self.reference.values(point),
            wind: self.reference.wind(point),
            omega: self.input(self.omega, point),
            effects: effects.collect(),
        }
    }

    /// The derivative of every state, by the time of the clock that measures.
    pub fn derivatives<T: Real>(&self, point: &Point<T>) -> Vec<T> {
        let world = self.world(point);
        let chart = &self.reference.chart;
        let motion = world.motion(&chart.physical(&point.states), point.time);
        let rates = chart.derivatives(&point.states, &motion);
        rates.into_iter().map(|rate| rate * world.clock()).collect()
    }

    /// Where the marker is reported, in inertial components.
    pub fn observation<T: Real>(&self, point: &Point<T>) -> Vector3<T> {
        let at = self.reference.chart.physical(&point.states);
        let which = self.input(self.marker_is, point);
        self.world(point).seen(&at, point.marker, which)
    }

    fn input<T: Real>(&self, index: Option<usize>, point: &Point<T>) -> Vector3<T> {
        index.map_or_else(Vector3::zeros, |index| point.inputs[index])
    }
}
