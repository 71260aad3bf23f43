//! Reference law with active effects, evaluated for given values.

use super::{Effect, Flow, inertia, loads, observation, surroundings};
use nalgebra::Vector3;
use oracle::scalar::Real;
use oracle::{Law, Load, Motion, Physical};

/// An effect of the catalogue with the values of its coefficients and states.
#[derive(Clone, Debug)]
pub struct ActiveEffect<T> {
    /// Description of the effect: names of its coefficients and states, and its laws.
    pub effect: &'static Effect,
    /// Values of the coefficients of the effect, then of its states.
    pub values: Vec<T>,
}

/// A law of motion with effects, and with the values of constants, wind and effects; the order of the effects does not
/// matter.
#[derive(Clone, Debug)]
pub struct ExtendedLaw<T> {
    /// The law of motion without effects.
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
            let load = loads::load(active.effect.name, &active.values, &flow);
            force += load.force;
            moment += load.moment;
        }
        let mut properties = self.law.mass_properties(&constants);
        // The reaction of the added mass depends on the sum of all other forces.
        let added_mass = self
            .called("added_mass")
            .fold(Vector3::zeros(), |sum, values| {
                sum + inertia::added_mass_force(values[0], &flow, force, properties.mass)
            });
        force += added_mass;
        if let Some(tensor) = &mut properties.inertia {
            for active in &self.effects {
                *tensor += inertia::added(active.effect.name, &active.values);
            }
        }
        Motion::under(Load { force, moment }, &properties, at)
    }

    /// Seconds of true time per second of recorded time; 1 without an effect on the rate of the time stamps.
    pub fn clock(&self) -> T {
        self.called("clock_rate")
            .fold(T::one(), |rate, values| rate * surroundings::clock(values))
    }

    /// Position of a marker as the measurement reports it, m. `marker` is the marker's measured position in the body
    /// frame; `which` has a 1 at the index of the first, second or third marker, and is 0 for all other markers.
    pub fn observation(
        &self,
        at: &Physical<T>,
        marker: Vector3<T>,
        which: Vector3<T>,
    ) -> Vector3<T> {
        let effects = self.effects.iter();
        let on_body = effects.clone().fold(marker, |sum, active| {
            sum + observation::displacement(active.effect.name, &active.values, marker, which)
        });
        let arm = at.attitude.carry(on_body);
        let delays = self.called("marker_time_offset");
        let position = delays.fold(at.position + arm, |sum, values| {
            sum + observation::motion_until_sampled([values[0], values[1]], at, arm, which)
        });
        effects.fold(position, |position, active| {
            observation::reported(active.effect.name, &active.values, position)
        })
    }

    /// Values of the effect called `name`, if it is active.
    fn called<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a [T]> {
        let active = self.effects.iter().filter(move |a| a.effect.name == name);
        active.map(|active| active.values.as_slice())
    }

    /// Velocity of the air at the body, m/s, in inertial components.
    fn air_velocity(&self, at: &Physical<T>) -> Vector3<T> {
        self.effects.iter().fold(self.wind, |sum, active| {
            sum + surroundings::wind(active.effect.name, &active.values, at.position.z)
        })
    }

    /// Constants of the law of motion in the order of [`Law::constants`], multiplied by the factors of the effects on
    /// air density and gravity.
    fn scaled_constants(&self) -> Vec<T> {
        let mut constants = self.constants.clone();
        for active in &self.effects {
            let factor = surroundings::factor(active.effect.name, &active.values);
            if let Some((name, factor)) = factor {
                let names = self.law.constants().iter();
                for (constant, _) in constants.iter_mut().zip(names).filter(|(_, n)| **n == name) {
                    *constant *= factor;
                }
            }
        }
        constants
    }
}
