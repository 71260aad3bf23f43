//! Simulates one flight with effects added to the law of motion.

use dataset::synthesize::corrupt;
use dataset::{Flight, Role};
use oracle::Physical;
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;

use super::effects::SeededEffects;
use super::law::ExtendedLaw;
use super::world::SeededWorld;
use crate::oracle_flights::file_name;

/// Identifies a flight within a simulated dataset. The seed and the index determine its random stream; the index and
/// the number of flights determine whether it is held out.
#[derive(Clone, Copy)]
pub(super) struct FlightPlace {
    /// Seed of the dataset.
    pub(super) seed: u64,
    /// Index of the flight in the dataset, from 0.
    pub(super) index: usize,
    /// Number of flights in the dataset.
    pub(super) flights: usize,
}

impl FlightPlace {
    /// Law of motion of this flight with the effects in `seeded`. The states of these effects are drawn at random for
    /// the flight.
    pub(super) fn world(self, world: &ExtendedLaw<f64>, seeded: &SeededEffects) -> SeededWorld {
        let mut random = ChaCha12Rng::seed_from_u64(self.seed);
        random.set_stream(1 + self.index as u64);
        SeededWorld::draw(world, seeded, &mut random)
    }
}

/// Simulates a flight and its measurement at `times` (s); `markers` are in the body frame, m. The random stream depends
/// only on the dataset's seed and the flight's index, so the throws are the same whatever effects are added.
pub(super) fn seeded_flight(
    world: &ExtendedLaw<f64>,
    seeded: &SeededEffects,
    place: FlightPlace,
    start: Physical<f64>,
    times: Vec<f64>,
    markers: &[[f64; 3]],
) -> Flight {
    let FlightPlace {
        seed,
        index,
        flights,
    } = place;
    let world = place.world(world, seeded);
    let mut positions = world.observe(start, &times, markers);
    if let Some(noise) = &seeded.noise {
        corrupt(
            &mut positions,
            noise,
            seed.wrapping_mul(1000) + index as u64,
        );
    }
    let role = match index + seeded.held_out < flights {
        true => Role::Fit,
        false => Role::HeldOut,
    };
    Flight {
        file: file_name(index),
        role,
        positions,
        times,
        ..Flight::default()
    }
}
