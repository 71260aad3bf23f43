//! Flights that touch nothing: none of them is to be truncated.

use std::f64::consts::PI;
use std::time::Duration;

use flight::batch;
use identify::dataset::Dataset;
use identify::synthesize::corrupt;

use crate::bounded_fit::bounded_fit;
use crate::oracle_flights::{Plan, TRUTH, Throws, disc, flights, noise_conditions};
use crate::seeded::{SeededEffects, ball};

/// Number of flights of a dataset.
const FLIGHTS: usize = 20;

/// Longest time of a fit.
const LIMIT: Duration = Duration::from_secs(60);

/// Fast and slow throws at any angle of attack up to 35 degrees, upwards and downwards.
const WILD: Throws = Throws {
    speed: (5.0, 32.0),
    launch: (-0.6, 1.0),
    nose: (-0.2, 0.6),
    hyzer: (-1.0, 1.0),
    spin: (25.0, 120.0),
    counter_clockwise: 0.5,
    wobble: 6.0,
};

/// Fast throws at a high angle of attack, which are lifted by several g at first.
const LIFTED: Throws = Throws {
    speed: (18.0, 30.0),
    launch: (-0.1, 0.3),
    nose: (0.15, 0.45),
    hyzer: (-0.3, 0.3),
    spin: (50.0, 110.0),
    counter_clockwise: 0.3,
    wobble: 2.0,
};

/// A flight that touches nothing, as the fit used it.
#[derive(Clone, Debug)]
pub struct FreeFlight {
    /// Group of throws.
    pub group: &'static str,
    /// Seed of the dataset.
    pub seed: u64,
    /// File name.
    pub file: String,
    /// Why the flight was truncated; `None` if it was not.
    pub cut: Option<String>,
    /// Why the flight was excluded, or the fit failed; `None` if it was used.
    pub excluded: Option<String>,
}

/// Groups of throws that touch nothing.
const GROUPS: [&str; 4] = [
    "usual throws of a disc",
    "wild throws of a disc",
    "fast throws at a high angle of attack",
    "balls",
];

/// Fits `datasets` datasets of twenty flights that touch nothing, in equal numbers of each group.
pub fn free_flights(
    datasets: usize,
    threads: usize,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Vec<FreeFlight> {
    let finished = std::sync::atomic::AtomicUsize::new(0);
    let each = batch::each_on(threads, datasets, |index| {
        let flights = of_dataset(index);
        let done = 1 + finished.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        progress(done, datasets);
        flights
    });
    each.into_iter().flatten().collect()
}

fn of_dataset(index: usize) -> Vec<FreeFlight> {
    let group = GROUPS[index % GROUPS.len()];
    let seed = index as u64;
    let dataset = dataset(index, seed);
    let model = model_spec::load::load(&dataset.model, &[]).expect("a built-in model");
    let fitted = bounded_fit(&model, &dataset, LIMIT);
    let each = dataset.flights.iter().enumerate().map(|(k, flight)| {
        let report = fitted.result.as_ref().map(|fit| &fit.report.flights[k]);
        let (cut, excluded) = match report {
            Ok(report) => {
                let excluded = match &report.outcome {
                    identify::FlightOutcome::Excluded { reason } => Some(reason.clone()),
                    _ => None,
                };
                (report.cut.as_ref().map(|cut| cut.why.clone()), excluded)
            }
            Err(error) => (None, Some(format!("the fit failed: {error}"))),
        };
        FreeFlight {
            group,
            seed,
            file: flight.file.clone(),
            cut,
            excluded,
        }
    });
    each.collect()
}

/// A dataset without a touch, under one of the kinds of noise.
fn dataset(index: usize, seed: u64) -> Dataset {
    let noises = noise_conditions();
    let noise = noises[(index / GROUPS.len()) % noises.len()].noise;
    let of_disc = |throws, duration| {
        let plan = Plan {
            truth: &TRUTH,
            throws,
            flights: FLIGHTS,
            duration,
            rate: 120.0,
        };
        let mut dataset = flights(&disc(), &plan, seed);
        for (k, flight) in dataset.flights.iter_mut().enumerate() {
            corrupt(&mut flight.positions, &noise, 1000 * seed + k as u64);
        }
        dataset
    };
    match index % GROUPS.len() {
        0 => of_disc(Throws::SPREAD, (0.5, 1.5)),
        1 => of_disc(WILD, (0.5, 1.2)),
        2 => of_disc(LIFTED, (0.5, 1.0)),
        _ => {
            let plan = ball::Plan {
                flights: FLIGHTS,
                throws: ball::Throws {
                    speed: (3.0, 25.0),
                    launch: (-PI / 4.0, PI / 3.0),
                    spin: (0.0, 200.0),
                },
                ..ball::TABLE_TENNIS
            };
            let seeded = SeededEffects::default().with_noise(noise);
            ball::dataset(&plan, &seeded, seed)
        }
    }
}
