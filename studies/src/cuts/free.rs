//! Flights that touch nothing. A fit is expected to truncate none of them.

use std::f64::consts::PI;
use std::time::Duration;

use dataset::Dataset;

use crate::bounded_fit::bounded_fit;
use crate::oracle_flights::{Plan, TRUTH, Throws, add_noise, disc, flights, noise_conditions};
use crate::progress::{Progress, each_run};
use crate::seeded::{SeededEffects, ball};

/// Number of simulated flights per dataset.
const FLIGHTS: usize = 20;

/// Limit of the computing time for fitting one dataset.
const LIMIT: Duration = Duration::from_secs(60);

/// Ranges of the launch conditions: fast and slow throws at angles of attack up to about 35 degrees, upwards and
/// downwards.
const WILD: Throws = Throws {
    speed: (5.0, 32.0),
    launch: (-0.6, 1.0),
    nose: (-0.2, 0.6),
    hyzer: (-1.0, 1.0),
    spin: (25.0, 120.0),
    counter_clockwise: 0.5,
    wobble: 6.0,
};

/// Ranges of the launch conditions: fast throws at a high angle of attack, with an initial lift of several times the
/// weight.
const LIFTED: Throws = Throws {
    speed: (18.0, 30.0),
    launch: (-0.1, 0.3),
    nose: (0.15, 0.45),
    hyzer: (-0.3, 0.3),
    spin: (50.0, 110.0),
    counter_clockwise: 0.3,
    wobble: 2.0,
};

/// A simulated flight without ground contact, and whether a fit truncated or excluded it.
#[derive(Clone, Debug)]
pub struct FreeFlight {
    /// Name of the group of simulated throws from which the flight was drawn.
    pub group: &'static str,
    /// Seed of the simulated dataset.
    pub seed: u64,
    /// File name of the flight in its simulated dataset.
    pub file: String,
    /// Reason why the fit truncated the flight; `None` if the fit did not truncate it.
    pub cut: Option<String>,
    /// Why the fit excluded the flight, or why the fit failed; `None` if the fit used the flight.
    pub excluded: Option<String>,
}

/// Names of the groups of simulated throws with which fits of flights without ground contact are tested.
const GROUPS: [&str; 4] = [
    "usual throws of a disc",
    "wild throws of a disc",
    "fast throws at a high angle of attack",
    "balls",
];

/// Simulates and fits `datasets` datasets of twenty flights without ground contact. The datasets take their throws from
/// four groups in turn: three kinds of disc throws, and balls. `progress` is called with the numbers of finished
/// datasets and of all datasets.
pub fn free_flights(datasets: usize, threads: usize, progress: Progress<'_>) -> Vec<FreeFlight> {
    let each = each_run(threads, datasets, progress, |seed| of_dataset(seed as u64));
    each.into_iter().flatten().collect()
}

fn of_dataset(seed: u64) -> Vec<FreeFlight> {
    let group = GROUPS[seed as usize % GROUPS.len()];
    let dataset = dataset(seed);
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
                (report.cut.as_ref().map(|cut| cut.reason.clone()), excluded)
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

/// Simulates a dataset of flights without ground contact. Its seed also selects the group of throws (such as fast
/// throws of a disc, or balls) and the noise condition.
fn dataset(seed: u64) -> Dataset {
    let (group, index) = (seed as usize % GROUPS.len(), seed as usize / GROUPS.len());
    let noises = noise_conditions();
    let noise = noises[index % noises.len()].noise;
    let of_disc = |throws, duration| {
        let plan = Plan {
            truth: &TRUTH,
            throws,
            flights: FLIGHTS,
            duration,
            rate: 120.0,
        };
        let mut dataset = flights(&disc(), &plan, seed);
        add_noise(&mut dataset, &noise, seed);
        dataset
    };
    match group {
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
