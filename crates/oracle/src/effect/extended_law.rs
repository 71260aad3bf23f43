//! Reference law with active effects, evaluated for given values.

use super::{Effect, Flow, Kind, clock};
use crate::physical::{Load, Motion, Physical};
use crate::reference::Law;
use crate::scalar::Real;
use nalgebra::Vector3;

/// A built-in effect (an optional addition to a model) with the values of its coefficients and states.
#[derive(Clone, Debug)]
pub struct ActiveEffect<T> {
    /// Description of the effect (optional addition to a model): names of its coefficients and states, and its
    /// reference implementation.
    pub effect: &'static Effect,
    /// Values of the coefficients of the effect (optional addition to a model), then of its states.
    pub values: Vec<T>,
}

/// A law of motion with effects (optional additions), and with the values of constants, wind and effects; the order of
/// the effects does not matter.
#[derive(Clone, Debug)]
pub struct ExtendedLaw<T> {
    /// The law of motion without effects (optional additions to a model).
    pub law: Law,
    /// Values of the law's constants, in the order of [`Law::constants`].
    pub constants: Vec<T>,
    /// Wind velocity in inertial components, m/s.
    pub wind: Vector3<T>,
    /// Measured angular velocity of a ball in inertial components, rad/s; 0 for bodies whose attitude is a state.
    pub omega: Vector3<T>,
    /// Effects that the model contains, each with the values of its coefficients and states.
    pub effects: Vec<ActiveEffect<T>>,
}

impl<T: Real> ExtendedLaw<T> {
    /// Loads and accelerations of a body at the physical state `at` under the law and its effects; `time` is the time
    /// since release, s.
    pub fn motion(&self, at: &Physical<T>, time: T) -> Motion<T> {
        self.motion_with(at, time, Vector3::zeros(), Vector3::zeros())
    }

    /// Loads and accelerations of a body at the physical state `at` under the law, its effects and an additional
    /// `force`, N, and `moment`, N·m, in inertial components; `time` is the time since release, s.
    pub fn motion_with(
        &self,
        at: &Physical<T>,
        time: T,
        force: Vector3<T>,
        moment: Vector3<T>,
    ) -> Motion<T> {
        let constants = self.scaled_constants();
        let air = self.air_velocity(at);
        let unextended = self.law.load(&constants, at, air);
        let flow = Flow::new(self.law, &constants, at, air, time, self.omega);
        let (mut force, mut moment) = (unextended.force + force, unextended.moment + moment);
        for active in &self.effects {
            let load = active.load(&flow);
            force += load.force;
            moment += load.moment;
        }
        let mut properties = self.law.mass_properties(&constants);
        // The reaction of the added mass depends on the sum of all other forces.
        let added_mass = self.effects.iter().fold(Vector3::zeros(), |sum, active| {
            sum + active.added_mass_force(&flow, force, properties.mass)
        });
        force += added_mass;
        if let Some(inertia) = &mut properties.inertia {
            for active in &self.effects {
                if let Kind::Inertia(kind) = active.effect.kind {
                    *inertia += kind.added(&active.values);
                }
            }
        }
        Motion::under(Load { force, moment }, &properties, at)
    }

    /// Seconds of true time per second of recorded time (the time stamps of the measurements); 1 without an effect on
    /// the rate of the time stamps.
    pub fn clock(&self) -> T {
        self.effects
            .iter()
            .fold(T::one(), |rate, active| match active.effect.kind {
                Kind::Clock => rate * clock::factor(&active.values),
                _ => rate,
            })
    }

    /// Position of a marker as the measurement reports it, m. `marker` is the marker's measured position in the body
    /// frame; `which` has a 1 at the index of the first, second or third marker, and is 0 for all other markers.
    pub fn observation(
        &self,
        at: &Physical<T>,
        marker: Vector3<T>,
        which: Vector3<T>,
    ) -> Vector3<T> {
        let of_observation = self.effects.iter().filter_map(|active| {
            let Kind::Observation(kind) = active.effect.kind else {
                return None;
            };
            Some((kind, active.values.as_slice()))
        });
        let on_body = of_observation.clone().fold(marker, |sum, (kind, values)| {
            sum + kind.displacement(values, marker, which)
        });
        let arm = at.attitude.carry(on_body);
        let position = of_observation
            .clone()
            .fold(at.position + arm, |sum, (kind, values)| {
                sum + kind.motion_until_sampled(values, at, arm, which)
            });
        of_observation.fold(position, |position, (kind, values)| {
            kind.reported(values, position)
        })
    }

    /// Velocity of the air at the body, m/s, in inertial components.
    fn air_velocity(&self, at: &Physical<T>) -> Vector3<T> {
        self.effects
            .iter()
            .fold(self.wind, |sum, active| match active.effect.kind {
                Kind::Air(kind) => sum + kind.velocity(&active.values, at),
                _ => sum,
            })
    }

    /// Constants of the law of motion in the order of [`Law::constants`], multiplied by the factors of the effects
    /// (optional additions to a model) on air density and gravity.
    fn scaled_constants(&self) -> Vec<T> {
        let mut constants = self.constants.clone();
        for active in &self.effects {
            let Kind::Air(kind) = active.effect.kind else {
                continue;
            };
            if let Some((name, factor)) = kind.factor(&active.values) {
                let names = self.law.constants().iter();
                for (constant, _) in constants.iter_mut().zip(names).filter(|(_, n)| **n == name) {
                    *constant *= factor;
                }
            }
        }
        constants
    }
}

impl<T: Real> ActiveEffect<T> {
    /// Force, N, and moment about the mass centre, N·m, that this effect adds to those of the law of motion, in
    /// inertial components. They do not depend on other effects. The force of the added mass is not included.
    fn load(&self, flow: &Flow<'_, T>) -> Load<T> {
        let values = self.values.as_slice();
        match self.effect.kind {
            Kind::Lift(kind) => kind.load(values, flow),
            Kind::Drag(kind) => kind.load(values, flow),
            Kind::Side(kind) => kind.load(values, flow),
            Kind::Roll(kind) => kind.load(values, flow),
            Kind::Pitch(kind) => kind.load(values, flow),
            Kind::Spin(kind) => kind.load(values, flow),
            Kind::Ball(kind) => kind.load(values, flow),
            Kind::Air(_) | Kind::Inertia(_) | Kind::Observation(_) | Kind::Clock => Load::zero(),
        }
    }

    fn added_mass_force(&self, flow: &Flow<'_, T>, force: Vector3<T>, mass: T) -> Vector3<T> {
        match self.effect.kind {
            Kind::Inertia(kind) => kind.added_mass_force(&self.values, flow, force, mass),
            _ => Vector3::zeros(),
        }
    }
}
