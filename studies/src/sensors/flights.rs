//! Flights of a disc simulated by the oracle, with simulated readings of sensors on the disc.

use dataset::synthesize::MARKERS;
use dataset::{Dataset, Flight, Reading, Sensor, SensorKind};
use model_spec::compose::Instrument;
use model_spec::model::Model;
use nalgebra::{UnitQuaternion, Vector3};
use oracle::{Motion, Physical};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use rand_distr::StandardNormal;
use serde::Serialize;

use crate::oracle_flights::{
    Plan, disc_constants, empty, file_name, integrate, marker_positions, reference_of, sample_times,
};

/// Specification of the measurements that are simulated for each flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Observed {
    /// Whether the positions of three markers on the disc are measured.
    pub markers: bool,
    /// Sensors, with their positions on the body as specified in the dataset.
    pub sensors: Vec<Sensor>,
    /// Offset of the true position of each accelerometer from the position that the dataset states, m, body axes.
    pub displacement: [f64; 3],
    /// Standard deviations of the noise of the simulated measurements.
    pub noise: SensorNoise,
}

/// Standard deviations of the white noise that is added to each simulated measurement.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SensorNoise {
    /// Standard deviation of the noise of each coordinate of a measured marker position or pose, m.
    pub position: f64,
    /// Standard deviation of the noise of an attitude about each axis, rad.
    pub attitude: f64,
    /// Standard deviation of the noise of each component of a gyroscope reading, rad/s.
    pub rate: f64,
    /// Standard deviation of the noise of each component of an accelerometer reading, m/s².
    pub force: f64,
    /// Standard deviation of the noise of a measured speed over the ground (magnitude of the inertial velocity), m/s.
    pub speed: f64,
}

impl Default for SensorNoise {
    fn default() -> Self {
        Self {
            position: 0.0015,
            attitude: 0.01,
            rate: 0.05,
            force: 0.3,
            speed: 0.1,
        }
    }
}

/// Simulates the flights of a plan (set of random throws) with sensor readings. The same seed gives the same flights
/// and noise.
///
/// # Panics
/// If the oracle does not support the model.
pub fn sensor_flights(model: &Model, plan: &Plan<'_>, observed: &Observed, seed: u64) -> Dataset {
    let reference = reference_of(model);
    let constants = disc_constants(model, plan);
    let gravity = model.params.iter().find(|own| own.name == "g");
    let gravity = Vector3::z() * gravity.map_or(0.0, |own| own.value);
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let mut noise = ChaCha12Rng::seed_from_u64(seed ^ 0x5e50);
    let flights = (0..plan.flights).map(|index| {
        let start = plan.throws.draw(&mut random);
        let times = sample_times(plan.duration, plan.rate, &mut random);
        let states = integrate(&reference, &constants, start, &times);
        let mut normal = |sigma: f64| sigma * noise.sample::<f64, _>(StandardNormal);
        let rows = states.iter().map(|body| {
            let motion = reference.motion_at(body, &constants);
            let mut positions = Vec::new();
            if observed.markers {
                let seen = marker_positions(body, &MARKERS).into_iter();
                let seen = seen.map(|p| Some(p.map(|x| x + normal(observed.noise.position))));
                positions.extend(seen);
            }
            let mut readings = Vec::new();
            for sensor in &observed.sensors {
                let mut place = Vector3::from(sensor.position);
                if sensor.kind == SensorKind::Instrument(Instrument::Accelerometer) {
                    place += Vector3::from(observed.displacement);
                }
                let at = (body, &motion);
                read(
                    sensor.kind,
                    at,
                    place,
                    gravity,
                    &observed.noise,
                    &mut normal,
                    &mut readings,
                );
            }
            (positions, readings)
        });
        let (positions, readings) = rows.unzip();
        Flight {
            file: file_name(index),
            times,
            positions,
            readings: match observed.sensors.is_empty() {
                true => Vec::new(),
                false => readings,
            },
            ..Flight::default()
        }
    });
    let flights = flights.collect();
    let mut dataset = empty(model);
    if !observed.markers {
        dataset.markers.clear();
    }
    Dataset {
        flights,
        sensors: observed.sensors.clone(),
        ..dataset
    }
}

/// Appends what a sensor at the position `place` on the body (m, body axes) reads in one sample, with noise, to
/// `readings`.
pub(crate) fn read(
    kind: SensorKind,
    (body, motion): (&Physical<f64>, &Motion<f64>),
    place: Vector3<f64>,
    gravity: Vector3<f64>,
    noise: &SensorNoise,
    normal: &mut impl FnMut(f64) -> f64,
    readings: &mut Vec<Option<Reading>>,
) {
    let (attitude, spin) = (body.attitude, body.angular_velocity);
    let arm = attitude.carry(place);
    let [w, x, y, z] = attitude.parts();
    let turn = UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, x, y, z));
    let mut vector = |v: Vector3<f64>, sigma: f64| -> Option<Reading> {
        Some([
            v.x + normal(sigma),
            v.y + normal(sigma),
            v.z + normal(sigma),
            0.0,
        ])
    };
    match kind {
        SensorKind::Pose => {
            readings.push(vector(body.position + arm, noise.position));
            let off = Vector3::from_fn(|_, _| normal(noise.attitude));
            let seen = UnitQuaternion::from_scaled_axis(off) * turn;
            readings.push(Some([seen.w, seen.i, seen.j, seen.k]));
        }
        SensorKind::Instrument(Instrument::Gyroscope) => {
            readings.push(vector(turn.inverse() * spin, noise.rate));
        }
        SensorKind::Instrument(Instrument::Accelerometer) => {
            let acceleration = motion.acceleration
                + motion.angular_acceleration.cross(&arm)
                + spin.cross(&spin.cross(&arm));
            readings.push(vector(
                turn.inverse() * (acceleration + gravity),
                noise.force,
            ));
        }
        SensorKind::Instrument(Instrument::Speed) => {
            let speed = body.velocity.norm() + normal(noise.speed);
            readings.push(Some([speed, 0.0, 0.0, 0.0]));
        }
        // Tracks have no columns of a launch monitor.
        SensorKind::Summary(_) => {}
    }
}
