//! One run of a row: its throws, effect sizes, signs and noise, all derived from the run's own seed.

use std::path::Path;

use dataset::Dataset;
use model_spec::load::load;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use super::row::{Body, Row, Size};
use crate::oracle_flights::{Plan, TWELVE};
use crate::seeded::{self, InputErrors, SeededEffects, ball};

/// Number of flights in a disc dataset, and how many of them are held out from the fit, to test predictions.
const DISC_FLIGHTS: (usize, usize) = (20, 4);

/// Number of flights in a ball dataset, and how many of them are held out from the fit, to test predictions.
const BALL_FLIGHTS: (usize, usize) = (12, 3);

/// Minimum ratio of an effect's size in one run to the nominal size (weak, strong or severe). The maximum ratio is
/// twice this.
const MIN_SIZE: f64 = 0.7;

/// Number of the ChaCha random stream from which the sizes and signs of the effects are drawn. The streams of the
/// flights are numbered from 1.
const SIZE_STREAM: u64 = u64::MAX;

/// Simulation settings of one run of the study, that is of one simulated and diagnosed dataset.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Body that is thrown.
    pub body: Body,
    /// Effects added to the simulated flights, noise of the measurements, and the number of held-out flights.
    pub seeded: SeededEffects,
    /// Number of flights in the simulated dataset.
    pub flights: usize,
    /// Errors introduced into the spins specified in the dataset; `None` if the specified spins are exact.
    pub input_errors: Option<InputErrors>,
    /// Seed from which the run's settings, throws and noise are drawn.
    pub seed: u64,
}

impl Case {
    /// Specifies one run: derives its seed from `row` (simulation settings that several runs share) and from the index
    /// `run`, and draws the sizes and signs of the added effects with this seed.
    pub fn of(row: &Row, run: usize) -> Self {
        let seed = seed(&row.key(), run);
        let mut random = ChaCha12Rng::seed_from_u64(seed);
        random.set_stream(SIZE_STREAM);
        let mut draw = |value: f64| {
            let ratio = MIN_SIZE * 2.0_f64.powf(random.random::<f64>());
            let sign = if random.random::<bool>() { 1.0 } else { -1.0 };
            (value * ratio, sign)
        };
        let size = row.size.unwrap_or(Size::Weak);
        let listed = row.effects.iter().map(|&name| {
            let values = listed_values(row.body, name, size, &mut draw);
            (name.to_owned(), values)
        });
        let listed = listed.collect();
        let unlisted = row.unlisted.iter().map(|&name| {
            let effect = seeded::unlisted(name).expect("an unlisted effect");
            let [weak, strong] = effect.strength;
            let (value, sign) = draw(size.of(weak, strong));
            (name.to_owned(), sign * value)
        });
        let (default, held_out) = default_flights(row.body);
        let flights = row.flights.unwrap_or(default);
        Self {
            body: row.body,
            flights,
            input_errors: row.input_errors,
            seeded: SeededEffects {
                listed,
                unlisted: unlisted.collect(),
                noise: Some(row.noise.noise),
                held_out: held_out * flights / default,
            },
            seed,
        }
    }

    /// Simulates the flights of the run, with measurement noise. If `input_errors` is set, also introduces errors into
    /// the spins that the dataset states.
    pub fn dataset(&self) -> Dataset {
        let flights = self.flights;
        let ball = |plan| {
            let plan = ball::Plan { flights, ..plan };
            ball::dataset(&plan, &self.seeded, self.seed)
        };
        let mut dataset = match self.body {
            Body::Disc => {
                let plan = Plan { flights, ..TWELVE };
                seeded::dataset(&plan, &self.seeded, self.seed)
            }
            Body::TableTennis => ball(ball::TABLE_TENNIS),
            Body::Football => ball(ball::FOOTBALL),
        };
        if let Some(errors) = self.input_errors {
            errors.apply(&mut dataset, self.seed);
        }
        dataset
    }

    /// Writes the flights of the run to a folder, as the program `hyzer` reads them, with a file `truth.txt` of the
    /// added effects.
    ///
    /// # Errors
    /// If the folder has other content, or cannot be written.
    pub fn write(&self, folder: &Path) -> std::io::Result<()> {
        let text = format!("{:#?}\n", self.seeded);
        dataset::write_with(folder, &self.dataset(), &[("truth.txt".into(), text)])
    }

    /// Names of the effects of the built-in effects catalogue that are added to the simulated flights, sorted; effects
    /// outside the catalogue are left out.
    pub(super) fn truth(&self) -> Vec<String> {
        let names = self.seeded.listed.iter().map(|(name, _)| name.clone());
        let mut names: Vec<String> = names.collect();
        names.sort();
        names
    }
}

/// Draws the values of an effect of the built-in effects catalogue: its coefficients and the standard deviations of its
/// states. Each has a random ratio to its nominal value. A coefficient also has a random sign, unless the negative
/// value would be out of its bounds.
fn listed_values(
    body: Body,
    name: &str,
    size: Size,
    draw: &mut impl FnMut(f64) -> (f64, f64),
) -> Vec<f64> {
    let model = load(body.model(), &[name]).expect("a built-in effect");
    let coefficients = &model.effects[0].coefficients;
    let strength = seeded::strength(name).expect("a strength of every effect");
    let values = strength.weak.iter().zip(strength.strong);
    let each = values.enumerate().map(|(k, (&weak, &strong))| {
        let (value, sign) = draw(size.of(weak, strong));
        let Some(coefficient) = coefficients.get(k) else {
            return value;
        };
        let bounds = model.coefficients[coefficient.index].bounds;
        match bounds.is_none_or(|(low, high)| (low..=high).contains(&(sign * value))) {
            true => sign * value,
            false => value,
        }
    });
    each.collect()
}

fn default_flights(body: Body) -> (usize, usize) {
    match body {
        Body::Disc => DISC_FLIGHTS,
        Body::TableTennis | Body::Football => BALL_FLIGHTS,
    }
}

/// Seed of a run: 40-bit FNV-1a hash of `key` (text of the simulation settings) and of the index of the run. It is
/// limited to 40 bits because other code multiplies seeds by 1000.
fn seed(key: &str, run: usize) -> u64 {
    let bytes = key.bytes().chain((run as u64).to_le_bytes());
    model_spec::fingerprint(&bytes.collect::<Vec<u8>>()) >> 24
}

#[cfg(test)]
mod tests {
    use super::super::plan::plan;
    use super::*;

    #[test]
    fn sizes_stay_around_the_row_s_and_signs_change_where_they_may() {
        let rows = plan(100);
        let row = |words: &str| rows.iter().find(|row| row.has(words)).expect("a row");
        let value = |words: &str, run| Case::of(row(words), run).seeded.listed[0].1[0];
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
