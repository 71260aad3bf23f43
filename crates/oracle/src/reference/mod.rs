//! Reference implementations of the laws of motion, one per kind of body. A model claims the physics of one of them by
//! `reference NAME;`.

mod ball;
mod charts;
mod disc;
mod discus;
mod spinning;

pub use spinning::Stream;

use crate::chart::Chart;
use crate::error::BindError;
use crate::physical::{Load, MassProperties, Motion, Physical};
use crate::point::Point;
use crate::scalar::Real;
use model_spec::model::{FrameKind, Model, Parameter};
use nalgebra::Vector3;

/// A law of motion that has a reference implementation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Flying disc (Frisbee) of Hubbard and Hummel (2000) with eight aerodynamic coefficients.
    Disc,
    /// Ball as a point mass with weight and drag.
    Ball,
    /// Symmetric discus of Frohlich (1981).
    Discus,
}

const LAWS: [(&str, Law); 3] = [
    ("hubbard_hummel_disc", Law::Disc),
    ("ball_with_drag", Law::Ball),
    ("frohlich_discus", Law::Discus),
];

/// A reference law, with the indices of its parameters, coefficients, states and wind in a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// Law of motion with which the model's equations are compared.
    pub law: Law,
    /// Conversion between the model's states, which are identified by their names, and a physical state.
    pub chart: Chart,
    /// Indices of the model's coefficients that occur only in effects or in terms that the user added.
    pub unknown: Vec<usize>,
    constants: Vec<Slot>,
    /// Index of the model's input `wind`; `None` if the model has no such input, so that the air is still.
    wind: Option<usize>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Slot {
    Param(usize),
    Coefficient(usize),
}

impl Law {
    /// Law with the given name, as written after `reference` in a model; `None` for unknown names.
    pub fn by_name(name: &str) -> Option<Self> {
        let law = LAWS.into_iter().find(|law| law.0 == name);
        law.map(|(_, law)| law)
    }

    /// Names of the law's parameters and coefficients, as a model with this law must declare them.
    pub fn constants(self) -> &'static [&'static str] {
        match self {
            Self::Disc => &disc::CONSTANTS,
            Self::Ball => &ball::CONSTANTS,
            Self::Discus => &discus::CONSTANTS,
        }
    }

    /// Whether the body of the law has an attitude; false for a point mass.
    pub fn has_attitude(self) -> bool {
        self != Self::Ball
    }

    /// Loads on a body and its accelerations by this law at the physical state `at`, in air of velocity `air`, m/s;
    /// `constants` are in the order of [`Law::constants`].
    pub fn motion<T: Real>(self, constants: &[T], at: &Physical<T>, air: Vector3<T>) -> Motion<T> {
        let load = self.load(constants, at, air);
        Motion::under(load, &self.mass_properties(constants), at)
    }

    /// Force and moment on a body at `at` in air of velocity `air`, m/s; `constants` as of [`Law::constants`].
    pub fn load<T: Real>(self, constants: &[T], at: &Physical<T>, air: Vector3<T>) -> Load<T> {
        match self {
            Self::Disc => disc::load(constants, at, air),
            Self::Ball => ball::load(constants, at, air),
            Self::Discus => discus::load(constants, at, air),
        }
    }

    /// Mass, and inertia in the body frame, of a body under this law; `constants` as of [`Law::constants`].
    pub fn mass_properties<T: Real>(self, constants: &[T]) -> MassProperties<T> {
        match self {
            Self::Disc | Self::Discus => disc::mass_properties(constants),
            Self::Ball => ball::mass_properties(constants),
        }
    }
}

/// Index in [`Model::inputs`] of the input `name`, taken in inertial components; `None` if there is none.
fn inertial_input(model: &Model, name: &'static str) -> Result<Option<usize>, BindError> {
    let index = model.inputs.iter().position(|input| input.name == name);
    let frame = index.map(|index| &model.frames[model.inputs[index].frame]);
    match frame {
        Some(frame) if !matches!(frame.kind, FrameKind::Inertial) => {
            let frame = frame.name.clone();
            Err(BindError::InputFrame { name, frame })
        }
        _ => Ok(index),
    }
}

impl Reference {
    /// Looks up the reference law that a model names after the keyword `reference`, and the model's indices of the
    /// constants and states of this law. `None` if the model names no law.
    ///
    /// # Errors
    /// [`BindError::UnknownReference`] if there is no law of this name; [`BindError::MissingConstant`] or
    /// [`BindError::MissingState`] for the first constant or state of the law that the model does not declare;
    /// [`BindError::InputFrame`] if the model states the wind in another frame than the inertial one.
    pub fn bind(model: &Model) -> Option<Result<Self, BindError>> {
        let name = model.reference.as_ref()?;
        let law = Law::by_name(name).ok_or_else(|| BindError::UnknownReference {
            name: name.clone(),
            available: LAWS.map(|law| law.0).to_vec(),
        });
        Some(law.and_then(|law| Self::of(law, model)))
    }

    fn of(law: Law, model: &Model) -> Result<Self, BindError> {
        let index = |list: &[Parameter], name: &str| list.iter().position(|c| c.name == name);
        let slot = |&name: &&'static str| {
            let parameter = index(&model.params, name).map(Slot::Param);
            let coefficient = || index(&model.coefficients, name).map(Slot::Coefficient);
            parameter
                .or_else(coefficient)
                .ok_or(BindError::MissingConstant { name })
        };
        let constants = law.constants().iter().map(slot);
        let constants = constants.collect::<Result<Vec<_>, _>>()?;
        let unknown = (0..model.coefficients.len())
            .filter(|&i| !constants.contains(&Slot::Coefficient(i)))
            .collect();
        let wind = inertial_input(model, "wind")?;
        let chart = if law.has_attitude() {
            charts::with_attitude(model)
        } else {
            charts::point_mass(model)
        };
        Ok(Self {
            law,
            wind,
            chart: chart?,
            unknown,
            constants,
        })
    }

    /// Index of each coefficient that the reference law lacks, with the value at which its effect vanishes.
    pub fn null_values(&self, model: &Model) -> Vec<(usize, f64)> {
        let of_effects = model.effects.iter().flat_map(|e| &e.coefficients);
        let null_value = |i| {
            of_effects
                .clone()
                .find(|c| c.index == i)
                .map_or(0.0, |c| c.null_value)
        };
        self.unknown.iter().map(|&i| (i, null_value(i))).collect()
    }

    /// Loads on the body and its accelerations for the values in `point`; vectors are in inertial components.
    pub fn motion<T: Real>(&self, point: &Point<T>) -> Motion<T> {
        self.motion_at(&self.chart.physical(&point.states), point)
    }

    /// Loads on the body and its accelerations at a physical state, with the constants and the wind of `point`.
    pub fn motion_at<T: Real>(&self, physical: &Physical<T>, point: &Point<T>) -> Motion<T> {
        self.law
            .motion(&self.values(point), physical, self.wind(point))
    }

    /// Whether the model has an input `wind`; without it the reference law assumes still air.
    pub fn has_wind(&self) -> bool {
        self.wind.is_some()
    }

    /// Wind velocity at a point, m/s, in inertial components; zero if the model has no input `wind`.
    pub fn wind<T: Real>(&self, point: &Point<T>) -> Vector3<T> {
        self.wind
            .map_or_else(Vector3::zeros, |wind| point.inputs[wind])
    }

    /// Mass, and inertia in the body frame, of the body of the reference law at a point.
    pub fn mass_properties<T: Real>(&self, point: &Point<T>) -> MassProperties<T> {
        self.law.mass_properties(&self.values(point))
    }

    /// Values of the law's constants in `point`, in the order of [`Law::constants`].
    pub fn values<T: Real>(&self, point: &Point<T>) -> Vec<T> {
        let value = |slot: &Slot| match *slot {
            Slot::Param(i) => point.params[i],
            Slot::Coefficient(i) => point.coefficients[i],
        };
        self.constants.iter().map(value).collect()
    }

    /// Computes the derivative of every state with respect to true time, in contrast to recorded time.
    pub fn derivatives<T: Real>(&self, point: &Point<T>) -> Vec<T> {
        self.chart.derivatives(&point.states, &self.motion(point))
    }

    /// Position, m, in inertial components, of the marker at [`Point::marker`] in the body frame.
    pub fn observation<T: Real>(&self, point: &Point<T>) -> Vector3<T> {
        let physical = self.chart.physical(&point.states);
        physical.position + physical.attitude.carry(point.marker)
    }
}
