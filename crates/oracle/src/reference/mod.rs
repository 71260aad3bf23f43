//! References written by hand, one per body: the physics that a model claims by `reference NAME;`.

mod ball;
mod disc;
mod discus;
pub(crate) mod spinning;

use crate::chart::{Chart, Step, defaults};
use crate::dynamics::MassProperties;
use crate::physical::{Motion, Physical};
use crate::point::Point;
use crate::scalar::Real;
use model_spec::model::Model;
use nalgebra::Vector3;

/// A law written by hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Hubbard & Hummel's disc, eight coefficients.
    Disc,
    /// A point mass with gravity and drag.
    Ball,
    /// A discus, top and bottom alike.
    Discus,
}

/// Names that a model may give after `reference`.
pub const NAMES: [&str; 3] = ["hubbard_hummel_disc", "ball_with_drag", "frohlich_discus"];

/// A law tied to the names of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// The law.
    pub law: Law,
    /// Which state stands for what, by the names that the contract fixes.
    pub chart: Chart,
    /// Coefficients of the model that the law does not know, by index: effects, or a user's own terms.
    pub unknown: Vec<usize>,
    constants: Vec<Slot>,
    wind: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Slot {
    Param(usize),
    Coefficient(usize),
}

impl Law {
    /// The law of that name.
    pub fn by_name(name: &str) -> Option<Self> {
        match name {
            "hubbard_hummel_disc" => Some(Self::Disc),
            "ball_with_drag" => Some(Self::Ball),
            "frohlich_discus" => Some(Self::Discus),
            _ => None,
        }
    }

    /// Its parameters and coefficients, by the names that the contract fixes.
    pub fn constants(self) -> &'static [&'static str] {
        match self {
            Self::Disc => &disc::CONSTANTS,
            Self::Ball => &ball::CONSTANTS,
            Self::Discus => &discus::CONSTANTS,
        }
    }

    /// Whether its body turns.
    pub fn turns(self) -> bool {
        self != Self::Ball
    }

    /// Forces, moments and the body's answer; constants in the order of [`Law::constants`].
    pub fn motion<T: Real>(self, constants: &[T], at: &Physical<T>, air: Vector3<T>) -> Motion<T> {
        match self {
            Self::Disc => disc::motion(constants, at, air),
            Self::Ball => ball::motion(constants, at, air),
            Self::Discus => discus::motion(constants, at, air),
        }
    }

    /// Mass, and inertia in the frame that is fixed in the body; constants as above.
    pub fn mass_properties<T: Real>(self, constants: &[T]) -> MassProperties<T> {
        match self {
            Self::Disc | Self::Discus => disc::mass_properties(constants),
            Self::Ball => ball::mass_properties(constants),
        }
    }
}

impl Reference {
    /// Ties the law that a model claims to the model's names. `None` where it claims none; an error says
    /// which names are missing.
    pub fn bind(model: &Model) -> Option<Result<Self, String>> {
        let name = model.reference.as_ref()?;
        Some(Law::by_name(name).map_or_else(
            || {
                Err(format!(
                    "there is no reference `{name}`; there are {}",
                    NAMES.join(", ")
                ))
            },
            |law| Self::of(law, model),
        ))
    }

    fn of(law: Law, model: &Model) -> Result<Self, String> {
        let slot = |name: &&str| {
            let param = model
                .params
                .iter()
                .position(|c| c.name == **name)
                .map(Slot::Param);
            let coefficient = || {
                model
                    .coefficients
                    .iter()
                    .position(|c| c.name == **name)
                    .map(Slot::Coefficient)
            };
            param
                .or_else(coefficient)
                .ok_or_else(|| format!("`{name}` is not declared"))
        };
        let constants = law
            .constants()
            .iter()
            .map(slot)
            .collect::<Result<Vec<_>, _>>()?;
        let unknown = (0..model.coefficients.len())
            .filter(|&i| !constants.contains(&Slot::Coefficient(i)))
            .collect();
        let wind = model
            .inputs
            .iter()
            .position(|i| i.name == "wind")
            .ok_or("there is no input `wind`")?;
        let chart = if law.turns() {
            turning_chart(model)
        } else {
            point_chart(model)
        }?;
        Ok(Self {
            law,
            chart,
            unknown,
            constants,
            wind,
        })
    }

    /// The value at which each unknown coefficient leaves the law as it is.
    pub fn vanishing(&self, model: &Model) -> Vec<(usize, f64)> {
        let of_effects = model.effects.iter().flat_map(|e| &e.coefficients);
        let vanishes = |i| {
            of_effects
                .clone()
                .find(|c| c.index == i)
                .map_or(0.0, |c| c.null_value)
        };
        self.unknown.iter().map(|&i| (i, vanishes(i))).collect()
    }

    /// Forces, moments and the body's answer at a point of the model.
    pub fn motion<T: Real>(&self, point: &Point<T>) -> Motion<T> {
        self.motion_at(&self.chart.physical(&point.states), point)
    }

    /// The same, at a physical state of one's own; constants and wind are taken from the point.
    pub fn motion_at<T: Real>(&self, physical: &Physical<T>, point: &Point<T>) -> Motion<T> {
        self.law
            .motion(&self.values(point), physical, self.wind(point))
    }

    /// The wind at a point: the contract fixes its components as inertial ones.
    pub fn wind<T: Real>(&self, point: &Point<T>) -> Vector3<T> {
        point.inputs[self.wind]
    }

    /// Mass, and inertia in the frame that is fixed in the body.
    pub fn mass_properties<T: Real>(&self, point: &Point<T>) -> MassProperties<T> {
        self.law.mass_properties(&self.values(point))
    }

    /// The law's constants at a point, in the order of [`Law::constants`].
    pub fn values<T: Real>(&self, point: &Point<T>) -> Vec<T> {
        let value = |slot: &Slot| match *slot {
            Slot::Param(i) => point.params[i],
            Slot::Coefficient(i) => point.coefficients[i],
        };
        self.constants.iter().map(value).collect()
    }

    /// The derivative of every state.
    pub fn derivatives<T: Real>(&self, point: &Point<T>) -> Vec<T> {
        self.chart.derivatives(&point.states, &self.motion(point))
    }

    /// Where the marker is seen, in inertial components: it is fixed in the body.
    pub fn observation<T: Real>(&self, point: &Point<T>) -> Vector3<T> {
        let physical = self.chart.physical(&point.states);
        physical.position + physical.attitude.carry(point.marker)
    }
}

fn states<const N: usize>(model: &Model, names: [&str; N]) -> Result<[usize; N], String> {
    let mut indices = [0; N];
    for (index, name) in indices.iter_mut().zip(names) {
        *index = model
            .states
            .iter()
            .position(|s| s.name == name)
            .ok_or_else(|| {
                format!("the reference knows the state by the name `{name}`, which is not there")
            })?;
    }
    Ok(indices)
}

/// The paper's angles, or a quaternion from the inertial frame to the disc's own.
fn turning_chart(model: &Model) -> Result<Chart, String> {
    if model.states.iter().any(|s| s.name == "q0") {
        return quaternion_chart(model);
    }
    let [phi, theta, gamma] = states(model, ["phi", "theta", "gamma"])?;
    let [phidot, thetadot, gammadot] = states(model, ["phidot", "thetadot", "gammadot"])?;
    let turn = |axis, angle, rate| Step::Turn { axis, angle, rate };
    Ok(Chart {
        defaults: defaults(model),
        position: states(model, ["x", "y", "z"])?,
        velocity: states(model, ["u", "v", "w"])?,
        velocity_after: 2,
        steps: vec![
            turn(1, phi, phidot),
            turn(2, theta, thetadot),
            turn(3, gamma, gammadot),
        ],
        angular_velocity: None,
    })
}

/// Velocity in inertial components, angular velocity in those of the body.
fn quaternion_chart(model: &Model) -> Result<Chart, String> {
    Ok(Chart {
        defaults: defaults(model),
        position: states(model, ["x", "y", "z"])?,
        velocity: states(model, ["vx", "vy", "vz"])?,
        velocity_after: 0,
        steps: vec![Step::Quaternion(states(model, ["q0", "q1", "q2", "q3"])?)],
        angular_velocity: Some((states(model, ["p", "q", "r"])?, 1)),
    })
}

fn point_chart(model: &Model) -> Result<Chart, String> {
    Ok(Chart {
        defaults: defaults(model),
        position: states(model, ["x", "y", "z"])?,
        velocity: states(model, ["vx", "vy", "vz"])?,
        velocity_after: 0,
        steps: Vec::new(),
        angular_velocity: None,
    })
}
