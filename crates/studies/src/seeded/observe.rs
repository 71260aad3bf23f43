//! One flight with what is hidden in it, flown and watched.

use nalgebra::Vector3;
use oracle::effect::{Scene, World};
use oracle::physical::Physical;
use rand::Rng;

use super::unlisted::{self, Outside};
use super::{Hidden, drawn};
use crate::oracle_flights::integrate::{Answer, fly_by};

/// The world of one flight.
pub struct Flown {
    world: World<f64>,
    outside: Vec<(&'static Outside, f64)>,
}

impl Flown {
    /// The world with what is hidden, drawn for one flight.
    pub fn new(world: &World<f64>, hidden: &Hidden, random: &mut impl Rng) -> Self {
        let mut world = world.clone();
        let acting = hidden.effects.iter();
        world.effects = acting
            .map(|(name, values)| drawn(name, values, random))
            .collect();
        for acting in &world.effects {
            let name = acting.effect.name;
            assert!(
                acting.effect.laws.contains(&world.law),
                "`{name}` is no effect of this body"
            );
        }
        let outside = hidden.outside.iter().map(|(name, size)| {
            let found = unlisted::by_name(name);
            (
                found.unwrap_or_else(|| panic!("there is no `{name}`")),
                *size,
            )
        });
        Self {
            outside: outside.collect(),
            world,
        }
    }

    /// Where the markers are reported at the times that a clock shows.
    pub fn seen(
        &self,
        start: Physical<f64>,
        times: &[f64],
        markers: &[[f64; 3]],
    ) -> Vec<Vec<Option<[f64; 3]>>> {
        let clock = self.world.clock();
        let flown: Vec<f64> = times.iter().map(|time| time * clock).collect();
        let memory = self.scene(&start, 0.0, |scene| scene.alpha());
        let bodies = fly_by(
            &|at, time, memory| self.answer(at, time, memory),
            start,
            memory,
            &flown,
        );
        let report = |body: &Physical<f64>| {
            let each = markers.iter().enumerate().map(|(k, &marker)| {
                let which = Vector3::from_fn(|axis, _| if axis == k { 1.0 } else { 0.0 });
                Some(self.world.seen(body, marker.into(), which).into())
            });
            each.collect()
        };
        bodies.iter().map(report).collect()
    }

    /// What the body does, and how the angle of attack that it remembers follows.
    fn answer(&self, at: &Physical<f64>, time: f64, memory: f64) -> Answer {
        if self.outside.is_empty() {
            return Answer {
                motion: self.world.motion(at, time),
                memory: 0.0,
            };
        }
        let mut world = self.world.clone();
        for (outside, size) in &self.outside {
            world.wind += outside.wind(*size, at, time);
        }
        let (load, lag) = self.scene(at, time, |scene| {
            let zero = (Vector3::zeros(), Vector3::zeros());
            let load = self
                .outside
                .iter()
                .fold(zero, |(force, moment), (outside, size)| {
                    let (f, m) = outside.load(*size, scene, memory);
                    (force + f, moment + m)
                });
            (load, (scene.alpha() - memory) / unlisted::LAG)
        });
        Answer {
            motion: world.motion_with(at, time, load.0, load.1),
            memory: lag,
        }
    }

    fn scene<R>(&self, at: &Physical<f64>, time: f64, look: impl Fn(&Scene<'_, f64>) -> R) -> R {
        let world = &self.world;
        look(&Scene::new(
            world.law,
            &world.constants,
            at,
            world.wind,
            time,
            world.omega,
        ))
    }
}
