//! What is told of flights beforehand, and is not quite so: spins that were measured badly, and spins of other flights.

use identify::dataset::{Dataset, KnownValue};
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use rand_distr::StandardNormal;

/// How the spins that are told of a ball's flights depart from the true ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Told {
    /// Standard deviation of each component of the error, over the size of the spin.
    pub off: f64,
    /// The part of the flights whose spins are passed on to one another.
    pub swapped: f64,
}

/// A stream of random numbers that no flight takes.
const STREAM: u64 = u64::MAX - 1;

impl Told {
    /// Changes what is told of the flights of a dataset.
    pub fn spoil(&self, dataset: &mut Dataset, seed: u64) {
        let mut random = ChaCha12Rng::seed_from_u64(seed);
        random.set_stream(STREAM);
        let swapped = self.swapped(dataset.flights.len(), seed);
        let before: Vec<Option<[f64; 3]>> = dataset.flights.iter().map(spin).collect();
        for (k, &flight) in swapped.iter().enumerate() {
            let from = swapped[(k + 1) % swapped.len()];
            if let Some(spin) = before[from] {
                let told = &mut dataset.flights[flight].known;
                told.insert("omega".to_owned(), KnownValue::Vector(spin));
            }
        }
        for flight in &mut dataset.flights {
            if let Some(KnownValue::Vector(spin)) = flight.known.get_mut("omega") {
                let size = spin.iter().map(|s| s * s).sum::<f64>().sqrt();
                for component in spin {
                    let error: f64 = random.sample(StandardNormal);
                    *component += self.off * size * error;
                }
            }
        }
    }

    /// The flights whose spins are passed on, by index.
    pub fn swapped(&self, flights: usize, seed: u64) -> Vec<usize> {
        let mut random = ChaCha12Rng::seed_from_u64(seed);
        random.set_stream(STREAM - 1);
        let mut all: Vec<usize> = (0..flights).collect();
        all.shuffle(&mut random);
        all.truncate((self.swapped * flights as f64).round() as usize);
        all
    }
}

fn spin(flight: &identify::dataset::Flight) -> Option<[f64; 3]> {
    match flight.known.get("omega") {
        Some(KnownValue::Vector(spin)) => Some(*spin),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::seeded::{Hidden, ball};

    #[test]
    fn spins_are_passed_on_and_none_is_lost() {
        let fresh = ball::dataset(&ball::TABLE_TENNIS, &Hidden::default(), 3);
        let told = Told {
            off: 0.0,
            swapped: 0.5,
        };
        let mut spoiled = fresh.clone();
        told.spoil(&mut spoiled, 3);
        let spins = |dataset: &Dataset| -> Vec<[f64; 3]> {
            dataset.flights.iter().filter_map(spin).collect()
        };
        let (before, after) = (spins(&fresh), spins(&spoiled));
        let swapped = told.swapped(12, 3);
        assert_eq!(swapped.len(), 6);
        for flight in 0..12 {
            assert_eq!(before[flight] != after[flight], swapped.contains(&flight));
            assert!(after.contains(&before[flight]));
        }
    }
}
