//! Datasets of a disc with flights simulated by the oracle.

use dataset::synthesize::{Corruption, MARKERS, corrupt, default_markers};
use dataset::{Dataset, Flight};
use model_spec::model::Model;
use oracle::{Physical, Point};
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use super::constants::reference_of;
use super::integrate::{integrate, marker_positions};
use super::throws::Throws;

/// A set of random throws of a disc, and the duration and sample rate of their measurement.
#[derive(Clone, Copy, Debug)]
pub struct Plan<'a> {
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

/// Loads the built-in model `disc`, with which the studies' flights are simulated and fitted.
///
/// # Panics
/// If the built-in model does not load.
pub fn disc() -> Model {
    model_spec::load::load("disc", &[]).expect("the built-in disc")
}

/// Name and true value (SI) of each coefficient, in the order of the model's coefficients. A coefficient that the plan
/// (set of random throws) does not list has the value of the model file.
pub fn truth(model: &Model, plan: &Plan<'_>) -> Vec<(String, f64)> {
    let stated = |name: &str| {
        let mut truth = plan.truth.iter();
        truth.find(|(n, _)| *n == name).map(|(_, value)| *value)
    };
    let each = model.coefficients.iter();
    each.map(|c| (c.name.clone(), stated(&c.name).unwrap_or(c.value)))
        .collect()
}

/// Default parameters of the disc, with the true coefficients that a plan (set of random throws) specifies.
pub(crate) fn disc_constants(model: &Model, plan: &Plan<'_>) -> Point<f64> {
    let mut constants = Point::defaults(model);
    for ((_, value), place) in truth(model, plan).iter().zip(&mut constants.coefficients) {
        *place = *value;
    }
    constants
}

/// Simulates the flights of a plan (set of random throws), without noise. The same seed gives the same flights.
///
/// # Panics
/// If the oracle does not support the model.
pub fn flights(model: &Model, plan: &Plan<'_>, seed: u64) -> Dataset {
    let reference = reference_of(model);
    let constants = disc_constants(model, plan);
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let flights = (0..plan.flights).map(|index| {
        let start = plan.throws.draw(&mut random);
        let times = sample_times(plan.duration, plan.rate, &mut random);
        let states = integrate(&reference, &constants, start, &times);
        marker_flight(file_name(index), times, &states)
    });
    Dataset {
        flights: flights.collect(),
        ..empty(model)
    }
}

/// Builds a flight from body states at `times` (s), with the exact positions of the default markers ([`MARKERS`]) in
/// these states.
pub(crate) fn marker_flight(file: String, times: Vec<f64>, states: &[Physical<f64>]) -> Flight {
    let positions = states.iter().map(|body| {
        let positions = marker_positions(body, &MARKERS);
        positions.into_iter().map(Some).collect()
    });
    Flight {
        file,
        positions: positions.collect(),
        times,
        ..Flight::default()
    }
}

/// Adds noise to the marker positions of all flights; each flight has a noise of its own, derived from `seed`.
pub(crate) fn add_noise(dataset: &mut Dataset, noise: &Corruption, seed: u64) {
    for (index, flight) in dataset.flights.iter_mut().enumerate() {
        corrupt(&mut flight.positions, noise, 1000 * seed + index as u64);
    }
}

/// Returns a dataset without flights for a model, with the model's default markers.
pub(crate) fn empty(model: &Model) -> Dataset {
    Dataset {
        model: model.name.clone(),
        markers: default_markers(model),
        ..Dataset::default()
    }
}

/// File name of the simulated flight with the index `index` (from 0).
pub(crate) fn file_name(index: usize) -> String {
    format!("flight{:03}.csv", index + 1)
}

/// Sample times (s, from 0) of a flight whose duration (s) is drawn uniformly from a range; `rate` in Hz.
pub(crate) fn sample_times(duration: (f64, f64), rate: f64, random: &mut impl Rng) -> Vec<f64> {
    let fraction: f64 = random.random();
    even_times(duration.0 + fraction * (duration.1 - duration.0), rate)
}

/// Sample times, s, from 0 to `duration` (s) at `rate` (Hz), both ends included. The number of sample intervals is
/// rounded, so the last time can differ from `duration` by half an interval.
pub(crate) fn even_times(duration: f64, rate: f64) -> Vec<f64> {
    let count = (duration * rate).round() as usize;
    (0..=count).map(|k| k as f64 / rate).collect()
}
