//! Datasets of the disc with seeded effects.

use identify::dataset::Dataset;
use identify::synthesize::MARKERS;
use nalgebra::Vector3;
use oracle::effect::ExtendedLaw;
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;

use super::effects::SeededEffects;
use super::flight::{FlightPlace, seeded_flight};
use crate::oracle_flights::{Plan, disc, disc_constants, empty, reference_of, sample_times};

/// Flights of the disc with seeded effects. Without any they are those of [`crate::oracle_flights::flights`].
///
/// # Panics
/// If an effect does not act on a disc, or has another number of values.
pub fn dataset(plan: &Plan<'_>, seeded: &SeededEffects, seed: u64) -> Dataset {
    let model = disc();
    let reference = reference_of(&model);
    let world = ExtendedLaw {
        law: reference.law,
        constants: reference.values(&disc_constants(&model, plan)),
        wind: Vector3::zeros(),
        omega: Vector3::zeros(),
        effects: Vec::new(),
    };
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let flights = (0..plan.flights).map(|index| {
        let start = plan.throws.draw(&mut random);
        let times = sample_times(plan.duration, plan.rate, &mut random);
        let place = FlightPlace {
            seed,
            index,
            flights: plan.flights,
        };
        seeded_flight(&world, seeded, place, start, times, &MARKERS)
    });
    Dataset {
        flights: flights.collect(),
        ..empty(&model)
    }
}
