//! Errors in the spins that a dataset states for a ball's flights: noise, and exchanges between flights.

use dataset::{Dataset, Flight, KnownValue};
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use rand_distr::StandardNormal;
use serde::Serialize;

/// Errors that are introduced into the spins specified in a dataset for the flights of a ball.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct InputErrors {
    /// Standard deviation of the error of each component, relative to the magnitude of the spin.
    pub relative_error: f64,
    /// Fraction of the flights that exchange the spins stated for them in the dataset, by a cyclic permutation.
    pub exchanged: f64,
}

/// Number of the ChaCha random stream from which the errors of the spins in the dataset are drawn. The streams of the
/// flights are numbered from 1.
const ERROR_STREAM: u64 = u64::MAX - 1;

/// Number of the ChaCha random stream that selects the flights with exchanged spins.
const EXCHANGE_STREAM: u64 = u64::MAX - 2;

impl InputErrors {
    /// Introduces the errors into the spins that a dataset states for its flights. Flights without a stated spin are
    /// not changed.
    pub(crate) fn apply(&self, dataset: &mut Dataset, seed: u64) {
        let mut random = ChaCha12Rng::seed_from_u64(seed);
        random.set_stream(ERROR_STREAM);
        let exchanged = self.exchanged_flights(dataset.flights.len(), seed);
        let before: Vec<Option<[f64; 3]>> = dataset.flights.iter().map(spin).collect();
        for (k, &flight) in exchanged.iter().enumerate() {
            let from = exchanged[(k + 1) % exchanged.len()];
            if let Some(spin) = before[from] {
                let known = &mut dataset.flights[flight].known;
                known.insert("omega".to_owned(), KnownValue::Vector(spin));
            }
        }
        for flight in &mut dataset.flights {
            if let Some(KnownValue::Vector(spin)) = flight.known.get_mut("omega") {
                let magnitude = spin.iter().map(|s| s * s).sum::<f64>().sqrt();
                for component in spin {
                    let normal: f64 = random.sample(StandardNormal);
                    *component += self.relative_error * magnitude * normal;
                }
            }
        }
    }

    /// Indices of the flights whose spins are exchanged among each other, in the order of the cyclic permutation.
    /// `flights` is the number of flights in the dataset.
    pub(crate) fn exchanged_flights(&self, flights: usize, seed: u64) -> Vec<usize> {
        let mut random = ChaCha12Rng::seed_from_u64(seed);
        random.set_stream(EXCHANGE_STREAM);
        let mut all: Vec<usize> = (0..flights).collect();
        all.shuffle(&mut random);
        all.truncate((self.exchanged * flights as f64).round() as usize);
        all
    }
}

fn spin(flight: &Flight) -> Option<[f64; 3]> {
    match flight.known.get("omega") {
        Some(KnownValue::Vector(spin)) => Some(*spin),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::seeded::{SeededEffects, ball};

    #[test]
    fn spins_are_passed_on_and_none_is_lost() {
        let exact = ball::dataset(&ball::TABLE_TENNIS, &SeededEffects::default(), 3);
        let errors = InputErrors {
            relative_error: 0.0,
            exchanged: 0.5,
        };
        let mut with_errors = exact.clone();
        errors.apply(&mut with_errors, 3);
        let spins = |dataset: &Dataset| -> Vec<[f64; 3]> {
            dataset.flights.iter().filter_map(spin).collect()
        };
        let (before, after) = (spins(&exact), spins(&with_errors));
        let exchanged = errors.exchanged_flights(12, 3);
        assert_eq!(exchanged.len(), 6);
        for flight in 0..12 {
            assert_eq!(before[flight] != after[flight], exchanged.contains(&flight));
            assert!(after.contains(&before[flight]));
        }
    }
}
