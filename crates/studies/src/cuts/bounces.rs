//! Flights of a disc that bounce: each is to be truncated within two samples of its first touch.

use std::time::Duration;

use flight::batch;
use identify::dataset::{Dataset, Flight, Role};
use identify::synthesize::{MARKERS, corrupt};
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use crate::bounded_fit::bounded_fit;
use crate::contact::{Surface, Touched, fly};
use crate::oracle_flights::{
    TWELVE, Throws, disc, disc_constants, empty, file_name, marker_positions, noise_conditions,
    reference_of,
};

/// Number of flights of a dataset.
const FLIGHTS: usize = 20;

/// Longest time of a fit.
const LIMIT: Duration = Duration::from_secs(60);

/// Observed time, s, and rate, Hz.
const DURATION: f64 = 1.0;
const RATE: f64 = 120.0;

/// Earliest and latest first touch, s.
const TOUCH: (f64, f64) = (0.3, 0.85);

/// Downward throws from low heights.
const LOW: Throws = Throws {
    speed: (6.0, 18.0),
    launch: (-0.35, 0.0),
    nose: (-0.2, 0.15),
    hyzer: (-0.6, 0.6),
    spin: (30.0, 65.0),
    counter_clockwise: 0.3,
    wobble: 2.0,
};

/// A flight that bounces, as the fit used it.
#[derive(Clone, Debug)]
pub struct Bounce {
    /// Seed of the dataset.
    pub seed: u64,
    /// File name.
    pub file: String,
    /// Time of the first touch, s.
    pub time: f64,
    /// Speed at which the rim met the ground, m/s.
    pub speed: f64,
    /// Number of samples before the touch.
    pub before: usize,
    /// Number of samples that the fit used; `None` if it used none.
    pub used: Option<usize>,
    /// Why the flight was excluded, or the fit failed; `None` if it was used.
    pub excluded: Option<String>,
}

impl Bounce {
    /// Whether the flight ends within two samples of its touch.
    pub fn is_cut_there(&self) -> bool {
        self.used
            .is_some_and(|used| used.abs_diff(self.before) <= 2)
    }
}

/// Fits `datasets` datasets of twenty flights that bounce.
pub fn bounces(
    datasets: usize,
    threads: usize,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Vec<Bounce> {
    let finished = std::sync::atomic::AtomicUsize::new(0);
    let each = batch::each_on(threads, datasets, |seed| {
        let found = of_dataset(seed as u64);
        let done = 1 + finished.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        progress(done, datasets);
        found
    });
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

/// Flights that bounce, and the time (s) and speed (m/s) of each first touch.
fn dataset(seed: u64) -> (Dataset, Vec<(f64, f64)>) {
    let mut random = ChaCha12Rng::seed_from_u64(seed);
    let noises = noise_conditions();
    let noise = noises[seed as usize % noises.len()].noise;
    let mut dataset = empty(&disc());
    let mut touches = Vec::new();
    for index in 0..FLIGHTS {
        let (mut flight, touch) = bouncing_flight(index, &mut random);
        corrupt(&mut flight.positions, &noise, 1000 * seed + index as u64);
        dataset.flights.push(flight);
        touches.push(touch);
    }
    (dataset, touches)
}

/// A flight without noise whose first touch comes in time, and that touch.
pub(crate) fn bouncing_flight(index: usize, random: &mut impl Rng) -> (Flight, (f64, f64)) {
    let model = disc();
    let reference = reference_of(&model);
    let constants = disc_constants(&model, &TWELVE);
    let samples = (DURATION * RATE).round() as usize;
    let times: Vec<f64> = (0..=samples).map(|k| k as f64 / RATE).collect();
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
        let positions = states.iter().map(|body| {
            let positions = marker_positions(body, &MARKERS);
            positions.into_iter().map(Some).collect()
        });
        let flight = Flight {
            file: file_name(index),
            role: Role::Fit,
            known: Default::default(),
            positions: positions.collect(),
            readings: Vec::new(),
            times,
        };
        return (flight, touch);
    }
}
