//! One run's flights: throws, sizes, signs and noise, all from its own seed.

use identify::dataset::Dataset;
use model_spec::load::load;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use super::plan::{Body, Row, Size, numbers};
use crate::identification::coverage::TWELVE;
use crate::oracle_flights::dataset::Plan;
use crate::seeded::input_errors::Told;
use crate::seeded::{Hidden, ball, dataset, unlisted};

/// Flights of a disc, and those of them that are held out.
const DISC: (usize, usize) = (20, 4);

/// The same of a ball.
const BALL: (usize, usize) = (12, 3);

/// Sizes lie between this and twice this part of what the row says.
const LEAST: f64 = 0.7;

/// A stream of random numbers that no flight takes.
const SIZES: u64 = u64::MAX;

/// A run before it is run.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// What is thrown.
    pub body: Body,
    /// What is hidden, with its numbers.
    pub hidden: Hidden,
    /// How many flights.
    pub flights: usize,
    /// How what is told of them departs from the truth.
    pub told: Option<Told>,
    /// The seed of all of it.
    pub seed: u64,
}

impl Case {
    /// A run of a row; it depends on nothing but the row's key and the run's number.
    ///
    /// # Panics
    /// Where a built-in effect cannot be switched on.
    pub fn of(row: &Row, run: usize) -> Self {
        let seed = seed(&row.key(), run);
        let mut random = ChaCha12Rng::seed_from_u64(seed);
        random.set_stream(SIZES);
        let mut around = |value: f64| {
            let size = LEAST * 2.0_f64.powf(random.random::<f64>());
            let sign = if random.random::<bool>() { 1.0 } else { -1.0 };
            (value * size, sign)
        };
        let size = row.size.unwrap_or(Size::Weak);
        let effects = row.effects.iter().map(|&name| {
            let model = load(row.body.model(), &[name]).expect("a built-in effect");
            let own = &model.effects[0].coefficients;
            let values = numbers(name, size).iter().enumerate().map(|(k, &value)| {
                let (value, sign) = around(value);
                let turned = sign * value;
                // What differs from flight to flight has no sign; others keep theirs where the turned one is impossible.
                let Some(coefficient) = own.get(k) else {
                    return value;
                };
                let bounds = model.coefficients[coefficient.index].bounds;
                match bounds.is_none_or(|(low, high)| (low..=high).contains(&turned)) {
                    true => turned,
                    false => value,
                }
            });
            (name.to_owned(), values.collect())
        });
        let effects = effects.collect();
        let outside = row.outside.iter().map(|&name| {
            let found = unlisted::by_name(name).expect("one from outside");
            let (value, sign) = around(found.strength[size as usize]);
            (name.to_owned(), sign * value)
        });
        let (usual, held_out) = flights(row.body);
        let flights = row.flights.unwrap_or(usual);
        Self {
            body: row.body,
            flights,
            told: row.told,
            hidden: Hidden {
                effects,
                outside: outside.collect(),
                noise: Some(row.noise.noise),
                held_out: held_out * flights / usual,
            },
            seed,
        }
    }

    /// Its flights.
    pub fn dataset(&self) -> Dataset {
        let flights = self.flights;
        let of_ball = |plan| {
            let plan = ball::Plan { flights, ..plan };
            ball::dataset(&plan, &self.hidden, self.seed)
        };
        let mut dataset = match self.body {
            Body::Disc => dataset(&Plan { flights, ..TWELVE }, &self.hidden, self.seed),
            Body::TableTennis => of_ball(ball::TABLE_TENNIS),
            Body::Football => of_ball(ball::FOOTBALL),
        };
        if let Some(told) = self.told {
            told.spoil(&mut dataset, self.seed);
        }
        dataset
    }
}

fn flights(body: Body) -> (usize, usize) {
    match body {
        Body::Disc => DISC,
        Body::TableTennis | Body::Football => BALL,
    }
}

/// FNV-1a of a row's key and the number of a run, short enough to be multiplied by a thousand.
fn seed(key: &str, run: usize) -> u64 {
    let bytes = key.bytes().chain((run as u64).to_le_bytes());
    let hash = bytes.fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    hash >> 24
}

#[cfg(test)]
mod tests {
    use super::super::plan::plan;
    use super::*;

    #[test]
    fn sizes_stay_around_the_row_s_and_signs_change_where_they_may() {
        let rows = plan(100);
        let row = |words: &str| rows.iter().find(|row| row.has(words)).expect("a row");
        let value = |words: &str, run| Case::of(row(words), run).hidden.effects[0].1[0];
        let stall: Vec<f64> = (0..20)
            .map(|k| value("effects stall strong white", k))
            .collect();
        assert!(
            stall.iter().all(|v| (3.5..=7.0).contains(&v.abs())),
            "{stall:?}"
        );
        assert!(stall.iter().any(|v| *v < 0.0) && stall.iter().any(|v| *v > 0.0));
        // A mass of air cannot be negative.
        assert!((0..20).all(|k| value("effects added_mass strong white", k) > 0.0));
        assert_eq!(
            Case::of(row("gusts weak"), 3),
            Case::of(row("gusts weak"), 3)
        );
        assert_ne!(
            Case::of(row("gusts weak"), 3).seed,
            Case::of(row("gusts weak"), 4).seed
        );
    }
}
