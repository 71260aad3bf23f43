//! Runs: flights are made, spoiled and fitted.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use flight::batch;
use identify::dataset::Dataset;
use identify::synthesize::{Corruption, corrupt};

use super::judge::{Judged, judge};
use super::kinds::{KINDS, Kind};
use crate::bounded_fit::bounded_fit;
use crate::oracle_flights::{TRUTH, TWELVE, disc, flights};

/// Longest time of a fit.
const LIMIT: Duration = Duration::from_secs(30);

/// Index of the flight that is spoiled where it is one.
const SPOILED: usize = 3;

/// Which flights are spoiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// One of twelve.
    One,
    /// All of them.
    All,
}

impl Which {
    /// In words.
    pub fn label(self) -> &'static str {
        match self {
            Self::One => "one flight",
            Self::All => "all flights",
        }
    }
}

/// A spoiled dataset and the answer.
#[derive(Clone)]
pub struct Run {
    /// Kind of fault.
    pub kind: &'static Kind,
    /// Spoiled flights.
    pub which: Which,
    /// Seed of the flights.
    pub seed: u64,
    /// The answer, judged.
    pub judged: Judged,
    /// Computing time, s.
    pub seconds: f64,
}

/// Kinds, with the flights that they spoil, that have all of the words.
pub fn runs(words: &str) -> Vec<(&'static Kind, Which)> {
    let all = KINDS.iter().flat_map(|kind| {
        let which: &[Which] = match kind.of_dataset {
            true => &[Which::All],
            false => &[Which::One, Which::All],
        };
        which.iter().map(move |which| (kind, *which))
    });
    let has = |(kind, which): &(&Kind, Which)| {
        let text = format!("{} {} {}", kind.name, kind.what, which.label());
        words.split_whitespace().all(|word| text.contains(word))
    };
    all.filter(has).collect()
}

/// Spoils and fits `seeds` datasets of each kind on this number of threads.
pub fn spoiled(
    kinds: &[(&'static Kind, Which)],
    seeds: u64,
    threads: usize,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Vec<Run> {
    let count = kinds.len() * seeds as usize;
    let finished = AtomicUsize::new(0);
    batch::each_on(threads, count, |index| {
        let (kind, which) = kinds[index / seeds as usize];
        let run = run(kind, which, index as u64 % seeds);
        progress(1 + finished.fetch_add(1, Ordering::Relaxed), count);
        run
    })
}

fn run(kind: &'static Kind, which: Which, seed: u64) -> Run {
    let model = disc();
    let mut dataset = clean(seed);
    let flights: Vec<usize> = match which {
        Which::One => vec![SPOILED],
        Which::All => (0..dataset.flights.len()).collect(),
    };
    kind.harm.apply(&mut dataset, &flights, seed);
    let spoiled: Vec<String> = flights
        .iter()
        .map(|k| dataset.flights[*k].file.clone())
        .collect();
    let truth = TRUTH.map(|(name, value)| (name.to_owned(), value));
    let fitted = bounded_fit(&model, &dataset, LIMIT);
    let report = fitted.result.map(|fit| fit.report);
    Run {
        kind,
        which,
        seed,
        judged: judge(&report, &spoiled, &truth),
        seconds: fitted.seconds,
    }
}

/// Twelve flights with white noise of 1.5 mm.
fn clean(seed: u64) -> Dataset {
    let mut dataset = flights(&disc(), &TWELVE, seed);
    for (k, flight) in dataset.flights.iter_mut().enumerate() {
        let noise_seed = 1000 * (seed + 1) + k as u64;
        corrupt(&mut flight.positions, &Corruption::default(), noise_seed);
    }
    dataset
}
