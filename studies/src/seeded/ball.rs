//! Simulates datasets of a ball of known spin, with effects added to the law of motion.

use dataset::{Dataset, KnownValue, Marker};
use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::{Physical, Point};
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use super::effects::SeededEffects;
use super::flight::{FlightPlace, seeded_flight};
use super::law::ExtendedLaw;
use crate::oracle_flights::{reference_of, sample_times};

/// Distribution of the throws of a ball: each quantity is uniform over a range (minimum, maximum).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Throws {
    /// Range of the speed of the ball at release, m/s.
    pub speed: (f64, f64),
    /// Range of the launch angle (velocity above the horizontal), rad.
    pub launch: (f64, f64),
    /// Range of the magnitude of the spin, rad/s. The direction of the spin is uniform over the sphere.
    pub spin: (f64, f64),
}

/// A set of random throws of a ball, and the duration and sample rate of their measurement.
#[derive(Clone, Copy, Debug)]
pub struct Plan<'a> {
    /// Parameters of the ball by name, SI. Parameters that are not listed have the values of the model file.
    pub parameters: &'a [(&'a str, f64)],
    /// True coefficients by name, SI. Coefficients that are not listed have the values of the model file.
    pub truth: &'a [(&'a str, f64)],
    /// Distribution of the launch conditions from which the throws are drawn.
    pub throws: Throws,
    /// Number of flights in the dataset.
    pub flights: usize,
    /// Minimum and maximum duration of a flight, s. Durations are uniformly distributed.
    pub duration: (f64, f64),
    /// Sample rate of the marker positions, Hz.
    pub rate: f64,
}

/// Plan of twelve throws of a table-tennis ball, of up to one second each.
pub const TABLE_TENNIS: Plan<'static> = Plan {
    parameters: &[],
    truth: &[("C_D", 0.5)],
    throws: Throws {
        speed: (5.0, 15.0),
        launch: (0.1, 0.7),
        spin: (20.0, 200.0),
    },
    flights: 12,
    duration: (0.8, 1.0),
    rate: 120.0,
};

/// Plan of twelve kicks of a football, at speeds on both sides of its drag crisis.
pub const FOOTBALL: Plan<'static> = Plan {
    parameters: &[("m", 0.43), ("radius", 0.11)],
    truth: &[("C_D", 0.45)],
    throws: Throws {
        speed: (5.0, 22.0),
        launch: (0.1, 0.7),
        spin: (0.0, 60.0),
    },
    flights: 12,
    duration: (0.8, 1.2),
    rate: 120.0,
};

fn model() -> Model {
    model_spec::load::load("ball", &[]).expect("the built-in ball")
}

/// Simulates flights of a ball with the effects and noise in `seeded`. The dataset states the true spin of each flight.
///
/// # Panics
/// If an effect does not act on a ball, or if its number of values is wrong.
pub fn dataset(plan: &Plan<'_>, seeded: &SeededEffects, seed: u64) -> Dataset {
    let model = model();
    let reference = reference_of(&model);
    let mut constants = Point::defaults(&model);
    let set = |names: &[(&str, f64)], name: &str| {
        let mut names = names.iter();
        names.find(|(n, _)| *n == name).map(|(_, value)| *value)
    };
    for (constant, place) in model.params.iter().zip(&mut constants.params) {
        *place = set(plan.parameters, &constant.name).unwrap_or(*place);
    }
    for (constant, place) in model.coefficients.iter().zip(&mut constants.coefficients) {
        *place = set(plan.truth, &constant.name).unwrap_or(*place);
    }
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let marker = [0.0; 3];
    let flights = (0..plan.flights).map(|index| {
        let (start, omega) = plan.throws.draw(&mut random);
        let times = sample_times(plan.duration, plan.rate, &mut random);
        let world = ExtendedLaw {
            law: reference.law,
            constants: reference.values(&constants),
            wind: Vector3::zeros(),
            omega,
            effects: Vec::new(),
        };
        let place = FlightPlace {
            seed,
            index,
            flights: plan.flights,
        };
        let mut flight = seeded_flight(&world, seeded, place, start, times, &[marker]);
        let known = KnownValue::Vector(omega.into());
        flight.known.insert("omega".to_owned(), known);
        flight
    });
    let parameters = plan.parameters.iter();
    Dataset {
        model: model.name.clone(),
        parameters: parameters.map(|(n, v)| ((*n).to_owned(), *v)).collect(),
        markers: vec![Marker {
            name: "m1".to_owned(),
            position: marker,
        }],
        flights: flights.collect(),
        ..Dataset::default()
    }
}

impl Throws {
    /// Draws the release of a throw and its spin vector (rad/s). The order of the random draws must not change: it
    /// determines the flights of each seed.
    fn draw(&self, random: &mut impl Rng) -> (Physical<f64>, Vector3<f64>) {
        let mut uniform = |(low, high): (f64, f64)| low + (high - low) * random.random::<f64>();
        let (speed, launch, spin) = (
            uniform(self.speed),
            uniform(self.launch),
            uniform(self.spin),
        );
        let heading = uniform((-0.3, 0.3));
        // The third coordinate of a uniform point on the sphere is uniform.
        let (up, azimuth) = (
            uniform((-1.0, 1.0)),
            uniform((-std::f64::consts::PI, std::f64::consts::PI)),
        );
        let flat = (1.0 - up * up).max(0.0).sqrt();
        let axis = Vector3::new(flat * azimuth.cos(), flat * azimuth.sin(), up);
        let (sine, cosine) = (launch.sin(), launch.cos());
        let path = Vector3::new(cosine * heading.cos(), cosine * heading.sin(), sine);
        let start = Physical {
            position: Vector3::new(0.0, 0.0, uniform((1.0, 1.8))),
            velocity: path * speed,
            ..Physical::rest()
        };
        (start, axis * spin)
    }
}
