//! Simulates flights of any model with a hidden effect: the oracle evaluates the model's tree, this module adds the
//! effect and integrates by Runge–Kutta steps.

use dataset::synthesize::Corruption;
use dataset::{Dataset, Flight, Marker, Role};
use model_spec::model::Model;
use nalgebra::{Matrix3, Vector3};
use oracle::{Chart, Motion, Point, Tree, derivatives};
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;

use super::hidden::{Action, Hidden, Scene};
use super::subjects::Subject;
use crate::oracle_flights::{add_noise, even_times, file_name};

/// Maximum step size with which simulated flights are integrated, s.
const MAX_STEP: f64 = 1e-3;

/// Sample rate of the simulated measurements, Hz.
const RATE: f64 = 120.0;

/// Number of flights per dataset, and how many of them are held out from the fit, to test predictions.
const FLIGHTS: (usize, usize) = (16, 4);

/// Reality from which measurements are simulated: a model with its true coefficients, and optionally an effect that the
/// diagnosed model lacks, with its size.
struct World<'w> {
    model: &'w Model,
    chart: Option<Chart>,
    point: Point<f64>,
    hidden: Option<(Hidden, f64)>,
}

/// Simulates the flights of a user model (`subject`). `hidden` is an optional effect that the diagnosed model lacks,
/// with its size; `noise` is optional. The same seed gives the same throws.
///
/// # Panics
/// If the oracle does not support the model.
pub(crate) fn dataset(
    subject: &Subject,
    model: &Model,
    hidden: Option<(Hidden, f64)>,
    noise: Option<Corruption>,
    seed: u64,
) -> Dataset {
    let mut point = Point::defaults(model);
    point
        .coefficients
        .iter_mut()
        .for_each(|c| *c *= subject.truth);
    let world = World {
        chart: Chart::declared(model),
        model,
        point,
        hidden,
    };
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let (count, held_out) = FLIGHTS;
    let flights = (0..count).map(|index| {
        let start = subject.start(model, &mut random);
        let times = even_times(subject.duration, RATE);
        Flight {
            file: file_name(index),
            role: match index + held_out < count {
                true => Role::Fit,
                false => Role::HeldOut,
            },
            positions: world.observed(start, &times, subject.markers),
            times,
            ..Flight::default()
        }
    });
    let flights = flights.collect();
    let markers = subject
        .markers
        .iter()
        .enumerate()
        .map(|(k, &position)| Marker {
            name: format!("m{}", k + 1),
            position,
        });
    let mut dataset = Dataset {
        model: model.name.clone(),
        markers: markers.collect(),
        flights,
        ..Dataset::default()
    };
    if let Some(noise) = &noise {
        add_noise(&mut dataset, noise, seed);
    }
    dataset
}

impl World<'_> {
    /// Simulated measurements of the marker positions, m, inertial axes, indexed `[sample][marker]`, without noise.
    /// `times` (s) are time stamps of the measurements, which may run at another rate than true time.
    fn observed(
        &self,
        start: Vec<f64>,
        times: &[f64],
        markers: &[[f64; 3]],
    ) -> Vec<Vec<Option<[f64; 3]>>> {
        let clock = match self.hidden {
            Some((hidden, size)) if matches!(hidden.action, Action::Clock) => 1.0 / (1.0 + size),
            _ => 1.0,
        };
        let (mut states, mut now) = (start, 0.0);
        let rows = times.iter().map(|time| {
            let time = time * clock;
            let steps = ((time - now) / MAX_STEP).ceil().max(1.0);
            let h = (time - now) / steps;
            for step in 0..steps as usize {
                states = self.step(&states, now + step as f64 * h, h);
            }
            now = time;
            let each = markers.iter().enumerate();
            each.map(|(k, marker)| Some(self.position(&states, now, (*marker).into(), k).into()))
                .collect()
        });
        rows.collect()
    }

    fn at(&self, states: &[f64], time: f64) -> Point<f64> {
        let mut point = Point {
            time,
            states: states.to_vec(),
            ..self.point.clone()
        };
        if let Some((hidden, size)) = self.hidden
            && let Action::Parameter(name, of_time) = hidden.action
            && let Some(index) = self.model.params.iter().position(|p| p.name == name)
        {
            point.params[index] *= 1.0 + size * of_time(time);
        }
        point
    }

    fn scene(&self, states: &[f64], time: f64) -> Option<Scene> {
        let physical = self.chart.as_ref()?.physical(states);
        Some(Scene {
            time,
            position: physical.position,
            velocity: physical.velocity,
            axes: physical.attitude.matrix(),
            angular_velocity: physical.angular_velocity,
        })
    }

    /// Measured position of the marker with the index `index`, m, inertial axes, without noise. Includes the change by
    /// an added effect that acts on measured positions.
    fn position(
        &self,
        states: &[f64],
        time: f64,
        marker: Vector3<f64>,
        index: usize,
    ) -> Vector3<f64> {
        let mut point = self.at(states, time);
        point.marker = marker;
        let observation = self.model.observation.as_ref().expect("an observation");
        let position = Tree::new(self.model, &point).vector(&observation.value);
        match self.hidden {
            Some((hidden, size)) => match hidden.action {
                Action::Observation(displaced) => {
                    let scene = self.scene(states, time).unwrap_or(Scene {
                        time,
                        position,
                        velocity: Vector3::zeros(),
                        axes: Matrix3::identity(),
                        angular_velocity: Vector3::zeros(),
                    });
                    position + displaced(&scene, position, index) * size
                }
                _ => position,
            },
            None => position,
        }
    }

    fn rates(&self, states: &[f64], time: f64) -> Vec<f64> {
        let plain = |states: &[f64]| {
            derivatives(self.model, &self.at(states, time))
                .expect("a model that the oracle supports")
        };
        let mut rates = plain(states);
        let Some((hidden, size)) = self.hidden else {
            return rates;
        };
        if let Action::Rate(name, of) = hidden.action {
            let index = |name: &str| self.model.states.iter().position(|s| s.name == name);
            let value = |name: &str| index(name).map_or(f64::NAN, |k| states[k]);
            if let Some(k) = index(name) {
                rates[k] += size * of(time, &value);
            }
        }
        let (Some(chart), Some(scene)) = (&self.chart, self.scene(states, time)) else {
            return rates;
        };
        let (mut linear, mut angular) = (Vector3::zeros(), Vector3::zeros());
        match hidden.action {
            Action::Force(of) => linear = of(&scene) * size,
            Action::Moment(of) => angular = of(&scene) * size,
            Action::Wind(of) => {
                // The loads depend only on the velocity relative to the air, so they are evaluated with the wind
                // velocity subtracted.
                assert_eq!(chart.velocity_after, 0, "a velocity in the inertial frame");
                let mut there = states.to_vec();
                for (k, wind) in chart.velocity.into_iter().zip((of(&scene) * size).iter()) {
                    there[k] -= wind;
                }
                let there = chart.physical_rate(&there, &plain(&there));
                let here = chart.physical_rate(states, &rates);
                linear = there.acceleration - here.acceleration;
                angular = there.angular_acceleration - here.angular_acceleration;
            }
            _ => return rates,
        }
        let here = chart.physical_rate(states, &rates);
        let motion = Motion {
            force: Vector3::zeros(),
            moment: Vector3::zeros(),
            acceleration: here.acceleration + linear,
            angular_acceleration: here.angular_acceleration + angular,
        };
        chart.derivatives(states, &motion)
    }

    /// One classic Runge–Kutta step of `h` seconds from the state vector `x`.
    fn step(&self, x: &[f64], time: f64, h: f64) -> Vec<f64> {
        let ahead = |rates: &[f64], h: f64| -> Vec<f64> {
            x.iter().zip(rates).map(|(x, rate)| x + h * rate).collect()
        };
        let k1 = self.rates(x, time);
        let k2 = self.rates(&ahead(&k1, h / 2.0), time + h / 2.0);
        let k3 = self.rates(&ahead(&k2, h / 2.0), time + h / 2.0);
        let k4 = self.rates(&ahead(&k3, h), time + h);
        let each = (0..x.len()).map(|k| (k1[k] + 2.0 * (k2[k] + k3[k]) + k4[k]) / 6.0);
        ahead(&each.collect::<Vec<_>>(), h)
    }
}
