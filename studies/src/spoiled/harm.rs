//! The changes that each kind of mistake makes to a flight or a dataset.

use dataset::{Dataset, Flight};
use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use rand_distr::StandardNormal;

use super::kinematics::{Row, centre, moved, turned, velocity};
use crate::cuts::bouncing_flight;

/// Function that introduces a mistake into a flight. The second argument is the preceding flight of the unchanged
/// dataset (for the first flight, the last one), the third a random generator.
pub(super) type FlightHarm = fn(&mut Flight, &Flight, &mut ChaCha12Rng);

/// How a mistake in a recording, introduced on purpose, changes the data of a dataset.
#[derive(Clone, Copy)]
pub(super) enum Harm {
    /// Multiplies all marker coordinates of a flight by a factor.
    Lengths(f64),
    /// Multiplies all sample times of a flight by a factor.
    Times(f64),
    /// Applies a function to each measured marker position (m) of a flight.
    Points(fn([f64; 3]) -> [f64; 3]),
    /// Applies a function to the marker positions of each sample of a flight.
    Samples(fn(&mut Row)),
    /// Applies a function to the marker positions of each sample from the middle of a flight to its end.
    LaterSamples(fn(&mut Row)),
    /// Applies a function that may change any part of a flight, such as its samples and times. Its arguments are the
    /// flight, the preceding flight of the dataset and a random generator.
    Flight(FlightHarm),
    /// Applies a function to each marker position (m, body frame) in the dataset's marker template.
    Template(fn([f64; 3]) -> [f64; 3]),
    /// Applies a function that changes the marker template or the parameters of the dataset.
    Dataset(fn(&mut Dataset)),
}

impl Harm {
    /// Introduces the recording mistake into the flights with the given indices. A mistake in the marker template or
    /// the parameters is introduced into the whole dataset; the indices are then ignored.
    pub(super) fn apply(self, dataset: &mut Dataset, flights: &[usize], seed: u64) {
        match self {
            Self::Dataset(change) => return change(dataset),
            Self::Template(change) => {
                for marker in &mut dataset.markers {
                    marker.position = change(marker.position);
                }
                return;
            }
            _ => {}
        }
        let before = dataset.flights.clone();
        for &index in flights {
            let other = &before[(index + before.len() - 1) % before.len()];
            let mut random = ChaCha12Rng::seed_from_u64(seed);
            random.set_stream(1_000_000 + index as u64);
            let flight = &mut dataset.flights[index];
            let from = middle(flight);
            match self {
                Self::Lengths(factor) => each_point(flight, |p| p.map(|x| x * factor)),
                Self::Times(factor) => flight.times.iter_mut().for_each(|t| *t *= factor),
                Self::Points(change) => each_point(flight, change),
                Self::Samples(change) => flight.positions.iter_mut().for_each(change),
                Self::LaterSamples(change) => flight.positions[from..].iter_mut().for_each(change),
                Self::Flight(change) => change(flight, other, &mut random),
                Self::Template(_) | Self::Dataset(_) => {}
            }
        }
    }
}

/// Index of the middle sample of a flight, in its list of samples.
fn middle(flight: &Flight) -> usize {
    flight.positions.len() / 2
}

fn each_point(flight: &mut Flight, mut change: impl FnMut([f64; 3]) -> [f64; 3]) {
    for point in flight.positions.iter_mut().flatten().flatten() {
        *point = change(*point);
    }
}

pub(super) fn labels_flicker(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    for row in &mut flight.positions {
        if random.random::<f64>() < 0.1 {
            row.swap(0, 1);
        }
    }
}

pub(super) fn dropped_frames(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    let mut kept: Vec<Row> = Vec::new();
    for row in &flight.positions {
        if random.random::<f64>() >= 0.1 {
            kept.push(row.clone());
        }
    }
    flight.times.truncate(kept.len());
    flight.positions = kept;
}

pub(super) fn pause(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    let from = middle(flight);
    flight.times[from..].iter_mut().for_each(|t| *t += 0.2);
}

pub(super) fn jitter(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    for time in &mut flight.times {
        let normal: f64 = random.sample(StandardNormal);
        // The times must increase; samples are 8.3 ms apart.
        *time += (0.002 * normal).clamp(-0.004, 0.004);
    }
}

pub(super) fn frozen_marker(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    let from = middle(flight);
    let last = flight.positions[from][1];
    flight.positions[from..]
        .iter_mut()
        .for_each(|row| row[1] = last);
}

pub(super) fn frozen(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    let from = middle(flight);
    let last = flight.positions[from].clone();
    flight.positions[from..].fill(last);
}

pub(super) fn teleporting_marker(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    for start in [20, 50, 90] {
        for row in flight.positions.iter_mut().skip(start).take(8) {
            if let Some(point) = &mut row[2] {
                point[0] += 0.4;
                point[1] -= 0.3;
            }
        }
    }
}

pub(super) fn constant(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    let first = flight.positions[0].clone();
    flight.positions.fill(first);
}

pub(super) fn random(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    each_point(flight, |_| std::array::from_fn(|_| random.random::<f64>()));
}

/// Inserts the marker positions `rows` (m) with white noise of 1.5 mm before the first sample of a flight if `at_start`
/// is true, otherwise after the last one. All sample times are replaced by equally spaced ones.
fn add(flight: &mut Flight, rows: Vec<Row>, at_start: bool, random: &mut ChaCha12Rng) {
    let noisy = rows.into_iter().map(|row| {
        let each = row.into_iter().map(|point| {
            point.map(|p: [f64; 3]| p.map(|x| x + 0.0015 * random.sample::<f64, _>(StandardNormal)))
        });
        each.collect()
    });
    let rows: Vec<Row> = noisy.collect();
    match at_start {
        true => flight.positions.splice(..0, rows).for_each(drop),
        false => flight.positions.extend(rows),
    }
    renumber(flight);
}

/// Replaces the times of a flight by equally spaced times from the same start, with the interval between the first two
/// samples.
fn renumber(flight: &mut Flight) {
    let (first, interval) = (flight.times[0], flight.times[1] - flight.times[0]);
    let samples = 0..flight.positions.len();
    flight.times = samples.map(|k| first + k as f64 * interval).collect();
}

/// Adds white noise with the standard deviation `sigma` (m) to every marker coordinate of the flight.
fn add_noise(flight: &mut Flight, sigma: f64, random: &mut ChaCha12Rng) {
    each_point(flight, |p| {
        p.map(|x| x + sigma * random.sample::<f64, _>(StandardNormal))
    });
}

pub(super) fn in_the_hand(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    // The arm accelerates uniformly over 0.5 s, and the disc rotates by 100 degrees without spin.
    let release = velocity(flight, 0, 4);
    let row = flight.positions[0].clone();
    let count = 60;
    let rows = (0..count).map(|k| {
        let ahead = f64::from(count - k) / 120.0;
        let path = release * (ahead - ahead * ahead / (2.0 * 0.51));
        turned(&moved(&row, -path), 3.4 * ahead)
    });
    add(flight, rows.collect(), true, random);
}

pub(super) fn after_the_catch(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    // The hand yields over 0.1 s.
    let last = flight.positions.len() - 1;
    let arrival = velocity(flight, last - 4, last);
    let row = flight.positions[last].clone();
    let rows = (1..=60).map(|k| {
        let time = f64::from(k) / 120.0;
        let path = arrival * (0.05 * (1.0 - (-time / 0.05).exp()));
        moved(&row, path)
    });
    add(flight, rows.collect(), false, random);
}

pub(super) fn bounce(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    let file = flight.file.clone();
    (*flight, _) = bouncing_flight(0, random);
    flight.file = file;
    renumber(flight);
    add_noise(flight, 0.0015, random);
}

pub(super) fn at_rest(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    // The disc lies flat where it came down.
    let last = flight.positions.last().cloned().unwrap_or_default();
    let (middle, rows) = (centre(&last), 48);
    let lying: Row = last
        .iter()
        .map(|point| point.map(|p| [p[0], p[1], middle.z]))
        .collect();
    add(flight, vec![lying; rows], false, random);
}

pub(super) fn duplicated(flight: &mut Flight, other: &Flight, _: &mut ChaCha12Rng) {
    flight.times.clone_from(&other.times);
    flight.positions.clone_from(&other.positions);
}

pub(super) fn joined(flight: &mut Flight, other: &Flight, _: &mut ChaCha12Rng) {
    flight.positions.extend(other.positions.iter().cloned());
    renumber(flight);
}

pub(super) fn foreign_marker(flight: &mut Flight, other: &Flight, _: &mut ChaCha12Rng) {
    for (row, from) in flight.positions.iter_mut().zip(&other.positions) {
        row[2] = from[2];
    }
}

pub(super) fn late_marker(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    let later: Vec<Option<[f64; 3]>> = flight.positions.iter().skip(3).map(|row| row[1]).collect();
    for (k, row) in flight.positions.iter_mut().enumerate() {
        row[1] = later.get(k).copied().flatten();
    }
}

pub(super) fn one_point(row: &mut Row) {
    let first = row[0];
    row.fill(first);
}

pub(super) fn slow_frames(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    flight.times = flight.times.iter().copied().step_by(12).collect();
    flight.positions = flight.positions.iter().step_by(12).cloned().collect();
}

pub(super) fn dropouts(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    for point in flight.positions.iter_mut().flatten() {
        if random.random::<f64>() < 0.7 {
            *point = None;
        }
    }
}

pub(super) fn outliers(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    each_point(flight, |p| match random.random::<f64>() < 0.1 {
        true => p.map(|x| x + 0.5 * random.sample::<f64, _>(StandardNormal)),
        false => p,
    });
}

pub(super) fn noisy(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    add_noise(flight, 0.03, random);
}

pub(super) fn smoothed(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    let before = flight.positions.clone();
    let last = before.len() - 1;
    for (k, row) in flight.positions.iter_mut().enumerate() {
        let half = 5.min(k).min(last - k);
        for (marker, point) in row.iter_mut().enumerate() {
            let window = &before[k - half..=k + half];
            let seen: Vec<Vector3<f64>> = window
                .iter()
                .filter_map(|row| row[marker].map(Vector3::from))
                .collect();
            let mean = seen.iter().sum::<Vector3<f64>>() / seen.len().max(1) as f64;
            *point = point.map(|_| mean.into());
        }
    }
}

pub(super) fn moon(dataset: &mut Dataset) {
    dataset.parameters.insert("g".to_owned(), 1.62);
}
