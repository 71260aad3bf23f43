//! Simulated flights for the tests of fits.

use ::flight::release::{Vocabulary, built_in, read};
use model_spec::model::Model;
use nalgebra::Vector3;

use dataset::synthesize::{Plan, flights};
use dataset::{Dataset, Flight};

/// Flights of a model from a built-in release.
pub fn simulated(model: &Model, release: &str, plan: &Plan) -> Dataset {
    let text = built_in(release).unwrap();
    let release = read(release, text, |_| Ok(Vocabulary::of(model)));
    flights(model, &[release.unwrap()], plan).unwrap().dataset
}

/// The model of a ball, and flights of it of `duration`, s.
pub fn balls(flights: usize, duration: f64) -> (Model, Dataset) {
    let model = model_spec::load::load("ball", &[]).unwrap();
    let plan = Plan {
        flights,
        duration: Some(duration),
        ..Plan::default()
    };
    let dataset = simulated(&model, "serve", &plan);
    (model, dataset)
}

/// Copy of a flight in which the velocity of the body jumps by `push`, m/s, at the sample with the index `sample`.
/// The index may be fractional.
pub fn pushed(flight: &Flight, sample: f64, push: Vector3<f64>) -> Flight {
    let interval = flight.times[1] - flight.times[0];
    let mut flight = flight.clone();
    for (sample_of, row) in flight.positions.iter_mut().enumerate() {
        let since = (sample_of as f64 - sample).max(0.0) * interval;
        for point in row.iter_mut().flatten() {
            *point = (Vector3::from(*point) + push * since).into();
        }
    }
    flight
}

/// Deterministic pseudo-random value between −1 and 1, used as measurement noise.
pub fn jitter(seed: usize) -> f64 {
    let mixed = (seed as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mixed = (mixed ^ (mixed >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    ((mixed >> 11) as f64 / (1_u64 << 53) as f64).mul_add(2.0, -1.0)
}
