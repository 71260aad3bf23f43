//! A reference's law with effects at work, each with its numbers.

use super::{Effect, Kind, Load, Scene};
use crate::physical::{Motion, Physical};
use crate::reference::Law;
use crate::rigid::{angular_acceleration, inertia_in_n};
use crate::scalar::Real;
use nalgebra::Vector3;

/// An effect at work.
#[derive(Clone, Debug)]
pub struct Acting<T> {
    /// The effect.
    pub effect: &'static Effect,
    /// Its coefficients, then its states.
    pub values: Vec<T>,
}

/// A law, its numbers, and the effects on it. The order of the effects does not matter.
#[derive(Clone, Debug)]
pub struct World<T> {
    /// The law.
    pub law: Law,
    /// Its constants, in the order of [`Law::constants`].
    pub constants: Vec<T>,
    /// Velocity of the air that was given, in inertial components.
    pub wind: Vector3<T>,
    /// Spin of a ball; nothing for bodies whose spin is a state.
    pub omega: Vector3<T>,
    /// Effects at work.
    pub effects: Vec<Acting<T>>,
}

impl<T: Real> World<T> {
    /// Forces, moments and the body's answer, by the time of the flight.
    pub fn motion(&self, at: &Physical<T>, time: T) -> Motion<T> {
        self.motion_with(at, time, Vector3::zeros(), Vector3::zeros())
    }

    /// The same with a force and a moment of one's own.
    pub fn motion_with(
        &self,
        at: &Physical<T>,
        time: T,
        force: Vector3<T>,
        moment: Vector3<T>,
    ) -> Motion<T> {
        let constants = self.constants();
        let air = self.air(at);
        let plain = self.law.motion(&constants, at, air);
        let scene = Scene::new(self.law, &constants, at, air, time, self.omega);
        let (mut force, mut moment) = (plain.force + force, plain.moment + moment);
        for acting in &self.effects {
            let load = acting.load(&scene);
            force += load.force;
            moment += load.moment;
        }
        let mut properties = self.law.mass_properties(&constants);
        // What the air carried along adds depends on all other forces.
        let carried = self.effects.iter().fold(Vector3::zeros(), |sum, acting| {
            sum + acting.carried(&scene, force, properties.mass)
        });
        force += carried;
        let mut turning = Vector3::zeros();
        if let Some(inertia) = &mut properties.inertia {
            for acting in &self.effects {
                if let Kind::Inertia(kind) = acting.effect.kind {
                    *inertia += kind.added(&acting.values);
                }
            }
            let inertia = inertia_in_n(&at.attitude.matrix(), inertia);
            let omega = at.angular_velocity;
            turning = angular_acceleration(&inertia, &omega, &omega, &moment);
        }
        Motion {
            force,
            moment,
            acceleration: force / properties.mass,
            angular_acceleration: turning,
        }
    }

    /// Seconds of flight in a second of the clock that measures.
    pub fn clock(&self) -> T {
        self.effects
            .iter()
            .filter(|acting| acting.effect.kind == Kind::Clock)
            .fold(T::one(), |pace, acting| {
                pace / (T::one() + acting.values[0])
            })
    }

    /// Where a marker is reported. Its coordinates are in the frame that is fixed in the body, as they were measured;
    /// `which` has a 1 for the first, second or third marker, and is zero for any other.
    pub fn seen(&self, at: &Physical<T>, marker: Vector3<T>, which: Vector3<T>) -> Vector3<T> {
        let seen = self.effects.iter().filter_map(|acting| {
            let Kind::Seen(kind) = acting.effect.kind else {
                return None;
            };
            Some((kind, acting.values.as_slice()))
        });
        let on_body = seen.clone().fold(marker, |sum, (kind, values)| {
            sum + kind.slip(values, marker, which)
        });
        let arm = at.attitude.carry(on_body);
        let place = seen.clone().fold(at.position + arm, |sum, (kind, values)| {
            sum + kind.moved(values, at, arm, which)
        });
        seen.fold(place, |place, (kind, values)| kind.reported(values, place))
    }

    /// Velocity of the air where the body is.
    fn air(&self, at: &Physical<T>) -> Vector3<T> {
        self.effects
            .iter()
            .fold(self.wind, |sum, acting| match acting.effect.kind {
                Kind::Air(kind) => sum + kind.velocity(&acting.values, at),
                _ => sum,
            })
    }

    /// The law's constants as the effects have them.
    fn constants(&self) -> Vec<T> {
        let mut constants = self.constants.clone();
        for acting in &self.effects {
            let Kind::Air(kind) = acting.effect.kind else {
                continue;
            };
            if let Some((name, factor)) = kind.factor(&acting.values) {
                let names = self.law.constants().iter();
                for (constant, _) in constants.iter_mut().zip(names).filter(|(_, n)| **n == name) {
                    *constant *= factor;
                }
            }
        }
        constants
    }
}

impl<T: Real> Acting<T> {
    /// The force and moment it adds.
    fn load(&self, scene: &Scene<'_, T>) -> Load<T> {
        let values = self.values.as_slice();
        match self.effect.kind {
            Kind::Lift(kind) => kind.load(values, scene),
            Kind::Drag(kind) => kind.load(values, scene),
            Kind::Side(kind) => kind.load(values, scene),
            Kind::Roll(kind) => kind.load(values, scene),
            Kind::Pitch(kind) => kind.load(values, scene),
            Kind::Spin(kind) => kind.load(values, scene),
            Kind::Ball(kind) => kind.load(values, scene),
            Kind::Air(_) | Kind::Inertia(_) | Kind::Seen(_) | Kind::Clock => Load::nothing(),
        }
    }

    fn carried(&self, scene: &Scene<'_, T>, force: Vector3<T>, mass: T) -> Vector3<T> {
        match self.effect.kind {
            Kind::Inertia(kind) => kind.carried(&self.values, scene, force, mass),
            _ => Vector3::zeros(),
        }
    }
}
