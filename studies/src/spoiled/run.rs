//! Executes the runs: simulates flights, spoils them, fits them and judges the answer.

use std::time::Duration;

use dataset::Dataset;
use dataset::synthesize::Corruption;

use super::judge::{Judged, judge};
use super::kinds::{KINDS, Kind};
use crate::bounded_fit::bounded_fit;
use crate::oracle_flights::{TRUTH, TWELVE, add_noise, disc, flights};
use crate::progress::{Progress, each_run};

/// Limit of the computing time for fitting one dataset.
const LIMIT: Duration = Duration::from_secs(30);

/// Index of the flight into which a recording mistake is introduced in those runs that change only one flight.
const SPOILED: usize = 3;

/// Whether a mistake is introduced into one flight or into all flights of a dataset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The recording mistake is introduced into one of the twelve flights.
    One,
    /// The recording mistake is introduced into all twelve flights.
    All,
}

impl Which {
    /// Text for the page of results: "one flight" or "all flights". The words with which a user selects runs on the
    /// command line are compared with it.
    pub fn label(self) -> &'static str {
        match self {
            Self::One => "one flight",
            Self::All => "all flights",
        }
    }
}

/// Result of fitting a dataset into which a recording mistake was introduced.
#[derive(Clone)]
pub struct Run {
    /// Kind of recording mistake that was introduced into the dataset.
    pub kind: &'static Kind,
    /// Whether the recording mistake is introduced into one flight or into all flights of the dataset.
    pub which: Which,
    /// Seed of the simulated flights.
    pub seed: u64,
    /// Result of the fit, classified by whether it could mislead a user.
    pub judged: Judged,
    /// Elapsed time of the fit, s.
    pub seconds: f64,
}

/// Lists pairs of a kind of recording mistake and whether it is introduced into one or into all flights. A pair is
/// listed if its texts (name and description of the kind, label of `Which`) together contain all of `words`.
pub fn runs(words: &str) -> Vec<(&'static Kind, Which)> {
    let all = KINDS.iter().flat_map(|kind| {
        let which: &[Which] = match kind.is_of_dataset() {
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

/// Introduces each kind of recording mistake into `seeds` datasets and fits them, `threads` in parallel. Calls
/// `progress` with the numbers of finished runs and of all runs.
pub fn spoiled(
    kinds: &[(&'static Kind, Which)],
    seeds: u64,
    threads: usize,
    progress: Progress<'_>,
) -> Vec<Run> {
    each_run(threads, kinds.len() * seeds as usize, progress, |index| {
        let (kind, which) = kinds[index / seeds as usize];
        run(kind, which, index as u64 % seeds)
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

/// Simulates twelve flights without a recording mistake, with white noise of 1.5 mm.
fn clean(seed: u64) -> Dataset {
    let mut dataset = flights(&disc(), &TWELVE, seed);
    add_noise(&mut dataset, &Corruption::default(), seed + 1);
    dataset
}
