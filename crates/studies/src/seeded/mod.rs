//! Flights with effects that nobody tells the diagnosis of: of the catalogue by the oracle's hand, and outside it.
//!
//! Nothing of the compiler and no effect's text takes part: forces, integration and what the cameras make of it are
//! the oracle's and this crate's own.

pub mod ball;
pub mod input_errors;
mod observe;
pub mod strength;
pub mod unlisted;

use identify::dataset::{Dataset, Flight, Role};
use identify::synthesize::{Corruption, MARKERS, corrupt};
use nalgebra::Vector3;
use oracle::effect::{World, by_name};
use oracle::physical::Physical;
use oracle::point::Point;
use oracle::reference::Reference;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha12Rng;

use crate::oracle_flights::dataset::{Plan, disc, empty, truth};
use observe::Flown;

/// What is hidden in a dataset.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hidden {
    /// Effects of the catalogue, each with its coefficients in order. Where an effect has states of each flight, its
    /// numbers are their standard deviations from flight to flight.
    pub effects: Vec<(String, Vec<f64>)>,
    /// Effects outside the catalogue, by name, with their sizes.
    pub outside: Vec<(String, f64)>,
    /// Noise; none leaves the positions as they are.
    pub noise: Option<Corruption>,
    /// So many flights, the last ones, are held out.
    pub held_out: usize,
}

impl Hidden {
    /// One effect of the catalogue.
    pub fn effect(name: &str, values: &[f64]) -> Self {
        Self {
            effects: vec![(name.to_owned(), values.to_vec())],
            ..Self::default()
        }
    }

    /// One effect outside the catalogue.
    pub fn outside(name: &str, size: f64) -> Self {
        Self {
            outside: vec![(name.to_owned(), size)],
            ..Self::default()
        }
    }

    /// The same with noise.
    pub fn with_noise(self, noise: Corruption) -> Self {
        Self {
            noise: Some(noise),
            ..self
        }
    }
}

/// Flights of the disc with what is hidden in them. Without anything, they are those of [`crate::oracle_flights::dataset::flights`].
///
/// # Panics
/// Where an effect is not one of the disc's, or not given as many numbers as it takes.
pub fn dataset(plan: &Plan<'_>, hidden: &Hidden, seed: u64) -> Dataset {
    let model = disc();
    let reference = Reference::bind(&model)
        .expect("a reference")
        .expect("its names");
    let mut constants = Point::defaults(&model);
    for ((_, value), place) in truth(&model, plan).iter().zip(&mut constants.coefficients) {
        *place = *value;
    }
    let world = World {
        law: reference.law,
        constants: reference.values(&constants),
        wind: Vector3::zeros(),
        omega: Vector3::zeros(),
        effects: Vec::new(),
    };
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let flights = (0..plan.flights).map(|index| {
        let start = plan.throws.draw(&mut random);
        let times = times(plan.duration, plan.rate, &mut random);
        let seen = fly(&world, hidden, start, &times, &MARKERS, (seed, index));
        flight(index, plan.flights, hidden, times, seen)
    });
    Dataset {
        flights: flights.collect(),
        ..empty(&model)
    }
}

/// Times of the samples of a flight whose duration is drawn.
fn times(duration: (f64, f64), rate: f64, random: &mut impl Rng) -> Vec<f64> {
    let part: f64 = rand::RngExt::random(random);
    let duration = duration.0 + part * (duration.1 - duration.0);
    let count = (duration * rate).round() as usize;
    (0..=count).map(|k| k as f64 / rate).collect()
}

/// Where the markers of a flight are reported, with noise: `[sample][marker]`.
fn fly(
    world: &World<f64>,
    hidden: &Hidden,
    start: Physical<f64>,
    times: &[f64],
    markers: &[[f64; 3]],
    (seed, index): (u64, usize),
) -> Vec<Vec<Option<[f64; 3]>>> {
    // A stream of its own, so that the throws are the same whatever is hidden.
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    random.set_stream(1 + index as u64);
    let flown = Flown::new(world, hidden, &mut random);
    let mut seen = flown.seen(start, times, markers);
    if let Some(noise) = &hidden.noise {
        corrupt(&mut seen, noise, seed.wrapping_mul(1000) + index as u64);
    }
    seen
}

/// The file of a flight, by its index.
pub fn file_of(index: usize) -> String {
    format!("flight{:03}.csv", index + 1)
}

fn flight(
    index: usize,
    of: usize,
    hidden: &Hidden,
    times: Vec<f64>,
    positions: Vec<Vec<Option<[f64; 3]>>>,
) -> Flight {
    Flight {
        file: file_of(index),
        role: if index + hidden.held_out < of {
            Role::Fit
        } else {
            Role::HeldOut
        },
        known: Default::default(),
        positions,
        times,
    }
}

/// Numbers of an effect in one flight: what differs from flight to flight is drawn.
fn drawn(name: &str, values: &[f64], random: &mut impl Rng) -> oracle::effect::Acting<f64> {
    let effect = by_name(name).unwrap_or_else(|| panic!("`{name}` is not written by hand"));
    assert_eq!(values.len(), effect.values(), "numbers of `{name}`");
    let each = values.iter().enumerate().map(|(k, &value)| {
        if k < effect.coefficients.len() {
            return value;
        }
        let part: f64 = rand::RngExt::sample(random, rand_distr::StandardNormal);
        value * part
    });
    oracle::effect::Acting {
        effect,
        values: each.collect(),
    }
}
