//! Simulates the flights of a setting and what the instruments show of them.

use dataset::synthesize::{MARKERS, corrupt};
use dataset::{Dataset, Flight, Reading, SensorKind};
use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::{Motion, Physical, Quaternion};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use rand_distr::StandardNormal;

use super::recording::constants;
use super::setting::Setting;
use crate::oracle_flights::{Plan, empty, file_name, reference_of, sample_times};
use crate::seeded::SeededWorld;
use crate::seeded::law::ExtendedLaw;
use crate::sensors::read;

/// Height, m, at which a recording ends: flights do not touch the ground.
const LOWEST: f64 = 0.1;

/// Minimum number of samples of a flight.
const MIN_SAMPLES: usize = 15;

/// Simulates the dataset of a setting. The same seed gives the same throws, whatever the noise.
///
/// # Panics
/// If the oracle has no law for the model.
pub(super) fn fly(model: &Model, setting: &Setting, seed: u64) -> Dataset {
    let flights = (0..setting.flights).map(|index| flight(model, setting, seed, index));
    let mut dataset = Dataset {
        flights: flights.collect(),
        sensors: setting.measured.sensors(),
        ..empty(model)
    };
    if !setting.measured.has_markers() {
        dataset.markers.clear();
    }
    dataset
}

fn flight(model: &Model, setting: &Setting, seed: u64, index: usize) -> Flight {
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    random.set_stream(1 + index as u64);
    let start = setting.throws.draw(&mut random);
    let mut times = sample_times(setting.duration, setting.rate, &mut random);
    let world = world(model, setting, index, &mut random);
    let states = world.fly(start, &times);
    let low = states.iter().position(|body| body.position.z < LOWEST);
    times.truncate(low.unwrap_or(states.len()).max(MIN_SAMPLES));
    let late: Vec<f64> = times.iter().map(|time| time + setting.latency).collect();
    let late = world.fly(start, &late);
    let view = View {
        setting,
        world: &world,
        gravity: gravity(model),
    };
    let samples = times.iter().zip(states.iter().zip(&late));
    let (mut positions, mut readings) = (Vec::new(), Vec::new());
    for (&time, (body, late)) in samples {
        positions.push(view.markers(body, time));
        readings.push(view.readings([body, late], time, &mut random));
    }
    corrupt(
        &mut positions,
        &setting.noise,
        seed.wrapping_mul(1000) + index as u64,
    );
    if readings.iter().all(Vec::is_empty) {
        readings.clear();
    }
    Flight {
        file: file_name(index),
        times,
        positions,
        readings,
        ..Flight::default()
    }
}

fn world(model: &Model, setting: &Setting, index: usize, random: &mut ChaCha12Rng) -> SeededWorld {
    let plan = setting.plan();
    let plan = match &setting.other_disc {
        Some((other, truth)) if *other == index => Plan { truth, ..plan },
        _ => plan,
    };
    let reference = reference_of(model);
    let law = ExtendedLaw {
        law: reference.law,
        constants: reference.values(&constants(model, &plan)),
        wind: Vector3::zeros(),
        omega: Vector3::zeros(),
        effects: Vec::new(),
    };
    SeededWorld::draw(&law, &setting.hidden, random)
}

fn gravity(model: &Model) -> Vector3<f64> {
    let own = model.params.iter().find(|own| own.name == "g");
    Vector3::z() * own.map_or(0.0, |own| own.value)
}

/// A flight as the instruments of a setting see it.
struct View<'v> {
    setting: &'v Setting,
    world: &'v SeededWorld,
    gravity: Vector3<f64>,
}

impl View<'_> {
    /// Positions of the markers, m, without noise; empty if they are not measured.
    fn markers(&self, body: &Physical<f64>, time: f64) -> Vec<Option<[f64; 3]>> {
        if !self.setting.measured.has_markers() {
            return Vec::new();
        }
        let each = MARKERS.iter().enumerate().map(|(k, marker)| {
            let seen = self.world.observation(body, *marker, k);
            if self.setting.row_time == 0.0 {
                return Some(seen.into());
            }
            let motion = self.world.motion(body, time);
            let later = advanced(body, &motion, self.setting.row_time * seen.y);
            Some(self.world.observation(&later, *marker, k).into())
        });
        each.collect()
    }

    /// Readings of the sensors: a pose of the first state, every other sensor of the second one.
    fn readings(
        &self,
        [body, late]: [&Physical<f64>; 2],
        time: f64,
        random: &mut ChaCha12Rng,
    ) -> Vec<Option<Reading>> {
        let mut normal = |sigma: f64| sigma * random.sample::<f64, _>(StandardNormal);
        let mut readings = Vec::new();
        for sensor in self.setting.measured.sensors() {
            let body = match sensor.kind {
                SensorKind::Pose => body,
                SensorKind::Instrument(_) | SensorKind::Summary(_) => late,
            };
            let motion = self.world.motion(body, time);
            read(
                sensor.kind,
                (body, &motion),
                sensor.position.into(),
                self.gravity,
                &self.setting.sensor_noise,
                &mut normal,
                &mut readings,
            );
        }
        readings
    }
}

/// State of a body `later` seconds after `body`, by a Taylor series.
fn advanced(body: &Physical<f64>, motion: &Motion<f64>, later: f64) -> Physical<f64> {
    let turn = body.angular_velocity * later;
    let (angle, axis) = (turn.norm(), turn.try_normalize(1e-12));
    let turn = Quaternion {
        w: (angle / 2.0).cos(),
        v: axis.unwrap_or_else(Vector3::zeros) * (angle / 2.0).sin(),
    };
    Physical {
        position: body.position
            + body.velocity * later
            + motion.acceleration * (later * later / 2.0),
        velocity: body.velocity + motion.acceleration * later,
        attitude: turn.times(body.attitude),
        angular_velocity: body.angular_velocity + motion.angular_acceleration * later,
    }
}
