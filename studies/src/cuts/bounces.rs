//! Flights of a disc that bounce. A fit is expected to truncate each within two samples of its first ground contact.

use std::time::Duration;

use dataset::{Dataset, Flight};
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use crate::bounded_fit::bounded_fit;
use crate::contact::{Surface, Touched, fly};
use crate::oracle_flights::{
    TWELVE, Throws, add_noise, disc, disc_constants, empty, even_times, file_name, marker_flight,
    noise_conditions, reference_of,
};
use crate::progress::{Progress, each_run};

/// Number of simulated flights per dataset.
const FLIGHTS: usize = 20;

/// Limit of the computing time for fitting one dataset.
const LIMIT: Duration = Duration::from_secs(60);

/// Time span of each flight that is simulated and measured, from its release, s.
const DURATION: f64 = 1.0;
/// Sampling rate of the simulated measurements, Hz.
const RATE: f64 = 120.0;

/// Permitted range of the time from the release to the first ground contact, s. Throws with a contact at another time
/// or without one are redrawn.
const TOUCH: (f64, f64) = (0.3, 0.85);

/// Ranges of the launch conditions from which the throws are drawn: slow to moderate throws, level or downward.
const LOW: Throws = Throws {
    speed: (6.0, 18.0),
    launch: (-0.35, 0.0),
    nose: (-0.2, 0.15),
    hyzer: (-0.6, 0.6),
    spin: (30.0, 65.0),
    counter_clockwise: 0.3,
    wobble: 2.0,
};

/// A simulated flight that bounces, and the samples of it that a fit used.
#[derive(Clone, Debug)]
pub struct Bounce {
    /// Seed of the simulated dataset.
    pub seed: u64,
    /// File name of the flight in its simulated dataset.
    pub file: String,
    /// Time from the release to the first ground contact, s.
    pub time: f64,
    /// Downward speed of the rim's lowest point at the first ground contact, m/s.
    pub speed: f64,
    /// Number of samples before the first ground contact.
    pub before: usize,
    /// Number of samples that the fit used; `None` if the flight was excluded or the fit failed.
    pub used: Option<usize>,
    /// Why the fit excluded the flight, or why the fit failed; `None` if the fit used the flight.
    pub excluded: Option<String>,
}

impl Bounce {
    /// Whether the fit truncated the flight within two samples of its first ground contact.
    pub fn is_cut_there(&self) -> bool {
        self.used
            .is_some_and(|used| used.abs_diff(self.before) <= 2)
    }
}

/// Simulates and fits `datasets` datasets of twenty flights that bounce. `progress` is called with the numbers of
/// finished datasets and of all datasets.
pub fn bounces(datasets: usize, threads: usize, progress: Progress<'_>) -> Vec<Bounce> {
    let each = each_run(threads, datasets, progress, |seed| of_dataset(seed as u64));
    each.into_iter().flatten().collect()
}

fn of_dataset(seed: u64) -> Vec<Bounce> {
    let (dataset, touches) = dataset(seed);
    let fitted = bounded_fit(&disc(), &dataset, LIMIT);
    let pairs = dataset.flights.iter().zip(touches).enumerate();
    let each = pairs.map(|(k, (flight, (time, speed)))| {
        let (used, excluded) = match &fitted.result {
            Ok(fit) => {
                let report = &fit.report.flights[k];
                let end = report.cut.as_ref().map_or(f64::INFINITY, |cut| cut.t);
                let used = flight.times.iter().filter(|t| **t <= end + 1e-9).count();
                match &report.outcome {
                    identify::FlightOutcome::Excluded { reason } => (None, Some(reason.clone())),
                    _ => (Some(used), None),
                }
            }
            Err(error) => (None, Some(format!("the fit failed: {error}"))),
        };
        Bounce {
            seed,
            file: flight.file.clone(),
            time,
            speed,
            before: flight.times.iter().filter(|t| **t < time).count(),
            used,
            excluded,
        }
    });
    each.collect()
}

/// Simulates a dataset of flights that bounce. Also returns, for each flight, the time (s) of the first ground contact
/// and the downward speed (m/s) at that contact.
fn dataset(seed: u64) -> (Dataset, Vec<(f64, f64)>) {
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let noises = noise_conditions();
    let noise = noises[seed as usize % noises.len()].noise;
    let mut dataset = empty(&disc());
    let mut touches = Vec::new();
    for index in 0..FLIGHTS {
        let (flight, touch) = bouncing_flight(index, &mut random);
        dataset.flights.push(flight);
        touches.push(touch);
    }
    add_noise(&mut dataset, &noise, seed);
    (dataset, touches)
}

/// Simulates a flight without noise, redrawn until its first ground contact lies between 0.3 and 0.85 s after the
/// release. Also returns the time (s) and downward speed (m/s) of that contact.
pub(crate) fn bouncing_flight(index: usize, random: &mut impl Rng) -> (Flight, (f64, f64)) {
    let model = disc();
    let reference = reference_of(&model);
    let constants = disc_constants(&model, &TWELVE);
    let times = even_times(DURATION, RATE);
    loop {
        let mut start = LOW.draw(random);
        start.position.z = 0.3 + 1.2 * random.random::<f64>();
        let surface = Surface {
            restitution: 0.2 + 0.4 * random.random::<f64>(),
            friction: 0.2 + 0.5 * random.random::<f64>(),
        };
        let Touched { states, first } =
            fly(&model, (&reference, &constants), start, surface, &times);
        let Some(touch) = first.filter(|(time, _)| (TOUCH.0..TOUCH.1).contains(time)) else {
            continue;
        };
        return (marker_flight(file_name(index), times, &states), touch);
    }
}
