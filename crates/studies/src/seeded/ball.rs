//! Flights of a ball whose spin is known, with what is hidden in them.

use identify::dataset::{Dataset, KnownValue, Marker};
use model_spec::model::Model;
use nalgebra::Vector3;
use oracle::effect::World;
use oracle::physical::Physical;
use oracle::point::Point;
use oracle::reference::Reference;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use super::{Hidden, flight, fly, times};

/// How a ball is thrown, each quantity drawn evenly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Throws {
    /// Speed, m/s.
    pub speed: (f64, f64),
    /// Climb at the release, rad.
    pub climb: (f64, f64),
    /// Size of the spin, rad/s; its direction is anywhere.
    pub spin: (f64, f64),
}

/// What is thrown, and how it is watched.
#[derive(Clone, Copy, Debug)]
pub struct Plan<'a> {
    /// Parameters of the ball by name; the rest as the model's file has them.
    pub parameters: &'a [(&'a str, f64)],
    /// Coefficients by name; the rest as the model's file has them.
    pub truth: &'a [(&'a str, f64)],
    /// How it is thrown.
    pub throws: Throws,
    /// How often.
    pub flights: usize,
    /// For how long, s: drawn evenly.
    pub duration: (f64, f64),
    /// Samples each second.
    pub rate: f64,
}

/// Twelve throws of a table-tennis ball, of a second each.
pub const TABLE_TENNIS: Plan<'static> = Plan {
    parameters: &[],
    truth: &[("C_D", 0.5)],
    throws: Throws {
        speed: (5.0, 15.0),
        climb: (0.1, 0.7),
        spin: (20.0, 200.0),
    },
    flights: 12,
    duration: (0.8, 1.0),
    rate: 120.0,
};

/// Twelve kicks of a football, through its drag crisis.
pub const FOOTBALL: Plan<'static> = Plan {
    parameters: &[("m", 0.43), ("radius", 0.11)],
    truth: &[("C_D", 0.45)],
    throws: Throws {
        speed: (5.0, 22.0),
        climb: (0.1, 0.7),
        spin: (0.0, 60.0),
    },
    flights: 12,
    duration: (0.8, 1.2),
    rate: 120.0,
};

/// The model of the ball.
///
/// # Panics
/// Where the built-in ball is broken.
pub fn model() -> Model {
    model_spec::load::load("ball", &[]).expect("the built-in ball")
}

/// Flights of a ball, each with its spin known.
///
/// # Panics
/// Where an effect is not one of the ball's, or not given as many numbers as it takes.
pub fn dataset(plan: &Plan<'_>, hidden: &Hidden, seed: u64) -> Dataset {
    let model = model();
    let reference = Reference::bind(&model)
        .expect("a reference")
        .expect("its names");
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
        let times = times(plan.duration, plan.rate, &mut random);
        let world = World {
            law: reference.law,
            constants: reference.values(&constants),
            wind: Vector3::zeros(),
            omega,
            effects: Vec::new(),
        };
        let seen = fly(&world, hidden, start, &times, &[marker], (seed, index));
        let mut flight = flight(index, plan.flights, hidden, times, seen);
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
        sigma: None,
        flights: flights.collect(),
    }
}

impl Throws {
    /// Draws a throw and its spin.
    fn draw(&self, random: &mut impl Rng) -> (Physical<f64>, Vector3<f64>) {
        let mut even = |(low, high): (f64, f64)| low + (high - low) * random.random::<f64>();
        let (speed, climb, spin) = (even(self.speed), even(self.climb), even(self.spin));
        let heading = even((-0.3, 0.3));
        // Evenly over the sphere: the third coordinate of its points is spread evenly.
        let (up, around) = (
            even((-1.0, 1.0)),
            even((-std::f64::consts::PI, std::f64::consts::PI)),
        );
        let flat = (1.0 - up * up).max(0.0).sqrt();
        let axis = Vector3::new(flat * around.cos(), flat * around.sin(), up);
        let (sine, cosine) = (climb.sin(), climb.cos());
        let path = Vector3::new(cosine * heading.cos(), cosine * heading.sin(), sine);
        let start = Physical {
            position: Vector3::new(0.0, 0.0, even((1.0, 1.8))),
            velocity: path * speed,
            ..Physical::rest()
        };
        (start, axis * spin)
    }
}
