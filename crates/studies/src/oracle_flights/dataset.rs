//! Datasets of a disc that the oracle made.

use identify::dataset::{Dataset, Flight, Role};
use identify::synthesize::{MARKERS, default_markers};
use model_spec::model::Model;
use oracle::point::Point;
use oracle::reference::Reference;
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;

use crate::oracle_flights::integrate::{fly, markers};
use crate::oracle_flights::throws::Throws;

/// What is thrown, and how it is watched.
#[derive(Clone, Copy, Debug)]
pub struct Plan<'a> {
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

/// The model that the oracle's flights are made with and fitted by.
///
/// # Panics
/// Where the built-in disc is broken.
pub fn disc() -> Model {
    model_spec::load::load("disc", &[]).expect("the built-in disc")
}

/// The true value of each coefficient of the disc, in the model's order.
pub fn truth(model: &Model, plan: &Plan<'_>) -> Vec<(String, f64)> {
    let stated = |name: &str| {
        plan.truth
            .iter()
            .find(|(n, _)| *n == name)
            .map(|(_, value)| *value)
    };
    let each = model.coefficients.iter();
    each.map(|c| (c.name.clone(), stated(&c.name).unwrap_or(c.value)))
        .collect()
}

/// Flights without noise.
///
/// # Panics
/// Where the model is not one of the oracle's.
pub fn flights(model: &Model, plan: &Plan<'_>, seed: u64) -> Dataset {
    let reference = Reference::bind(model)
        .expect("a reference")
        .expect("its names");
    let mut constants = Point::defaults(model);
    for ((_, value), place) in truth(model, plan).iter().zip(&mut constants.coefficients) {
        *place = *value;
    }
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let flights = (0..plan.flights).map(|index| {
        let start = plan.throws.draw(&mut random);
        let part: f64 = rand::RngExt::random(&mut random);
        let duration = plan.duration.0 + part * (plan.duration.1 - plan.duration.0);
        let count = (duration * plan.rate).round() as usize;
        let times: Vec<f64> = (0..=count).map(|k| k as f64 / plan.rate).collect();
        let flown = fly(&reference, &constants, start, &times);
        let seen = flown
            .iter()
            .map(|body| markers(body, &MARKERS).into_iter().map(Some).collect());
        Flight {
            file: format!("flight{:03}.csv", index + 1),
            role: Role::Fit,
            known: Default::default(),
            positions: seen.collect(),
            times,
        }
    });
    Dataset {
        flights: flights.collect(),
        ..empty(model)
    }
}

/// A dataset of no flights yet, with [`MARKERS`].
pub fn empty(model: &Model) -> Dataset {
    Dataset {
        model: model.name.clone(),
        parameters: Default::default(),
        markers: default_markers(model),
        sigma: None,
        flights: Vec::new(),
    }
}
