//! Simulates datasets of the disc with effects added to the law of motion.

use dataset::Dataset;
use dataset::synthesize::MARKERS;
use nalgebra::Vector3;
use oracle::Physical;
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;

use super::effects::SeededEffects;
use super::flight::{FlightPlace, seeded_flight};
use super::law::ExtendedLaw;
use crate::oracle_flights::{Plan, disc, disc_constants, empty, reference_of, sample_times};

/// Simulates flights of the disc with the effects and noise in `seeded`. Without effects and noise, they are the exact
/// flights of the unmodified law of motion from [`crate::oracle_flights::flights`].
///
/// # Panics
/// If an effect does not act on a disc, or if its number of values is wrong.
pub fn dataset(plan: &Plan<'_>, seeded: &SeededEffects, seed: u64) -> Dataset {
    let flights = each_flight(plan, seed, |world, place, start, times| {
        seeded_flight(world, seeded, place, start, times, &MARKERS)
    });
    Dataset {
        flights,
        ..empty(&disc())
    }
}

/// Maximum magnitude of the angle of attack over the flights of a disc that are simulated with the effects in `seeded`,
/// rad.
///
/// # Panics
/// If an effect does not act on a disc, or if its number of values is wrong.
pub fn greatest_angle_of_attack(plan: &Plan<'_>, seeded: &SeededEffects, seed: u64) -> f64 {
    let angles = each_flight(plan, seed, |world, place, start, times| {
        let world = place.world(world, seeded);
        world.greatest_angle_of_attack(start, &times)
    });
    angles.into_iter().fold(0.0, f64::max)
}

fn each_flight<T>(
    plan: &Plan<'_>,
    seed: u64,
    each: impl Fn(&ExtendedLaw<f64>, FlightPlace, Physical<f64>, Vec<f64>) -> T,
) -> Vec<T> {
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
        each(&world, place, start, times)
    });
    flights.collect()
}
