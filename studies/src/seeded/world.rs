//! The oracle's law of motion with added effects, and the simulated measurement of a flight under it.

use nalgebra::Vector3;
use oracle::{Motion, Physical};
use rand::{Rng, RngExt};
use rand_distr::StandardNormal;

use super::effects::SeededEffects;
use super::law::{ActiveEffect, ExtendedLaw, Flow, by_name};
use super::unlisted::{LAG, UnlistedEffect, unlisted};
use crate::oracle_flights::{Derivatives, integrate_law};

/// Law of motion with added effects, under which one flight is simulated.
pub(crate) struct SeededWorld {
    world: ExtendedLaw<f64>,
    unlisted: Vec<(&'static UnlistedEffect, f64)>,
}

impl SeededWorld {
    /// Adds effects to a law of motion, and draws the effects' states for one flight.
    ///
    /// # Panics
    /// If an effect does not act on this body, or if its number of values is wrong.
    pub(crate) fn draw(
        world: &ExtendedLaw<f64>,
        seeded: &SeededEffects,
        random: &mut impl Rng,
    ) -> Self {
        let mut world = world.clone();
        let listed = seeded.listed.iter();
        world.effects = listed
            .map(|(name, values)| drawn(name, values, random))
            .collect();
        for acting in &world.effects {
            let name = acting.effect.name;
            assert!(
                acting.effect.laws.contains(&world.law),
                "`{name}` does not act on this body"
            );
        }
        let unlisted = seeded.unlisted.iter().map(|(name, size)| {
            let found = unlisted(name).unwrap_or_else(|| panic!("there is no effect `{name}`"));
            (found, *size)
        });
        Self {
            unlisted: unlisted.collect(),
            world,
        }
    }

    /// Simulated measurements of the marker positions, m, inertial axes, indexed `[sample][marker]`, without noise.
    /// `times` (s) are time stamps of the measurements, which may run at another rate than true time.
    pub(super) fn observe(
        &self,
        start: Physical<f64>,
        times: &[f64],
        markers: &[[f64; 3]],
    ) -> Vec<Vec<Option<[f64; 3]>>> {
        let states = self.fly(start, times);
        let observed = |body: &Physical<f64>| {
            let each = markers.iter().enumerate();
            each.map(|(k, &marker)| Some(self.observation(body, marker, k).into()))
                .collect()
        };
        states.iter().map(observed).collect()
    }

    /// Measured position, m, inertial axes, without noise, of the marker with the index `index` at `marker` (m, body
    /// axes).
    pub(crate) fn observation(
        &self,
        body: &Physical<f64>,
        marker: [f64; 3],
        index: usize,
    ) -> Vector3<f64> {
        let which = Vector3::from_fn(|axis, _| if axis == index { 1.0 } else { 0.0 });
        self.world.observation(body, marker.into(), which)
    }

    /// Loads and accelerations of the body at `time`, s. The lift does not lag.
    pub(crate) fn motion(&self, body: &Physical<f64>, time: f64) -> Motion<f64> {
        let alpha = self.scene(body, time).alpha();
        self.derivatives(body, time, alpha).motion
    }

    /// Maximum magnitude of the angle of attack, rad, over the states at `times` of a flight that starts in the state
    /// `start`.
    pub(super) fn greatest_angle_of_attack(&self, start: Physical<f64>, times: &[f64]) -> f64 {
        let angles = self.fly(start, times).into_iter().zip(times);
        let angles = angles.map(|(body, time)| self.scene(&body, *time).alpha().abs());
        angles.fold(0.0, f64::max)
    }

    /// Body states at `times` (s). These are time stamps of the measurements, which may run at another rate than true
    /// time.
    pub(crate) fn fly(&self, start: Physical<f64>, times: &[f64]) -> Vec<Physical<f64>> {
        let clock = self.world.clock();
        let true_times: Vec<f64> = times.iter().map(|time| time * clock).collect();
        let initial_lagged_alpha = self.scene(&start, 0.0).alpha();
        integrate_law(
            &|body, time, lagged_alpha| self.derivatives(body, time, lagged_alpha),
            start,
            initial_lagged_alpha,
            &true_times,
        )
    }

    /// Linear and angular acceleration of the body with all added effects, and the time derivative (rad/s) of the
    /// lagged angle of attack, which is 0 if no effect outside the built-in effects catalogue is added.
    fn derivatives(&self, body: &Physical<f64>, time: f64, lagged_alpha: f64) -> Derivatives {
        if self.unlisted.is_empty() {
            return Derivatives {
                motion: self.world.motion(body, time),
                internal_rate: 0.0,
            };
        }
        let mut world = self.world.clone();
        for (effect, size) in &self.unlisted {
            world.wind += effect.wind(*size, time);
        }
        let scene = self.scene(body, time);
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for (effect, size) in &self.unlisted {
            let (f, m) = effect.load(*size, &scene, lagged_alpha);
            force += f;
            moment += m;
        }
        Derivatives {
            motion: world.motion_with(body, time, force, moment),
            internal_rate: (scene.alpha() - lagged_alpha) / LAG,
        }
    }

    /// Flow of the air relative to the body. It contains the wind of the unmodified law of motion, but not the wind of
    /// an effect outside the built-in effects catalogue. The angle of attack follows from it.
    fn scene<'s>(&'s self, body: &'s Physical<f64>, time: f64) -> Flow<'s, f64> {
        let world = &self.world;
        Flow::new(
            world.law,
            &world.constants,
            body,
            world.wind,
            time,
            world.omega,
        )
    }
}

/// Returns an effect of the built-in effects catalogue for one flight. The first of `values` are its coefficients. The
/// following ones are the standard deviations of the normal distributions from which its states are drawn.
fn drawn(name: &str, values: &[f64], random: &mut impl Rng) -> ActiveEffect<f64> {
    let effect = by_name(name).unwrap_or_else(|| panic!("there is no effect `{name}`"));
    assert_eq!(values.len(), effect.values(), "values of `{name}`");
    let each = values.iter().enumerate().map(|(k, &value)| {
        if k < effect.coefficients.len() {
            return value;
        }
        let normal: f64 = random.sample(StandardNormal);
        value * normal
    });
    ActiveEffect {
        effect,
        values: each.collect(),
    }
}
