//! The changes that each kind of mistake makes to a flight or a dataset.

use identify::dataset::{Dataset, Flight};
use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use rand_distr::StandardNormal;

use super::kinematics::{Row, centre, moved, turned, velocity};
use crate::cuts::bouncing_flight;

/// Function that introduces a mistake into a flight. The second argument is the preceding flight of the dataset, the
/// third a random generator.
pub(super) type FlightHarm = fn(&mut Flight, &Flight, &mut ChaCha12Rng);

/// Function that introduces a mistake into the marker template or the parameters of a dataset.
pub(super) type DatasetHarm = fn(&mut Dataset);

/// How a kind of recording mistake changes the data.
#[derive(Clone, Copy)]
pub(super) enum Harm {
    Flight(FlightHarm),
    Dataset(DatasetHarm),
}

impl Harm {
    /// Introduces the mistake into the flights with the given indices or, for a mistake of the dataset, into the whole
    /// dataset.
    pub(super) fn apply(self, dataset: &mut Dataset, flights: &[usize], seed: u64) {
        match self {
            Self::Dataset(harm) => harm(dataset),
            Self::Flight(harm) => {
                let before = dataset.flights.clone();
                for &index in flights {
                    let other = &before[(index + before.len() - 1) % before.len()];
                    let mut random = ChaCha12Rng::seed_from_u64(seed);
                    random.set_stream(1_000_000 + index as u64);
                    harm(&mut dataset.flights[index], other, &mut random);
                }
            }
        }
    }
}

/// Index of the sample in the middle of a flight.
fn middle(flight: &Flight) -> usize {
    flight.positions.len() / 2
}

fn each_point(flight: &mut Flight, mut change: impl FnMut([f64; 3]) -> [f64; 3]) {
    for point in flight.positions.iter_mut().flatten().flatten() {
        *point = change(*point);
    }
}

fn scaled(flight: &mut Flight, factor: f64) {
    each_point(flight, |p| p.map(|x| x * factor));
}

fn timed(flight: &mut Flight, factor: f64) {
    flight.times.iter_mut().for_each(|t| *t *= factor);
}

pub(super) fn labels_12(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    flight.positions.iter_mut().for_each(|row| row.swap(0, 1));
}

pub(super) fn labels_23(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    flight.positions.iter_mut().for_each(|row| row.swap(1, 2));
}

pub(super) fn labels_cycle(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    flight
        .positions
        .iter_mut()
        .for_each(|row| row.rotate_left(1));
}

pub(super) fn labels_from_middle(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    let from = middle(flight);
    flight.positions[from..]
        .iter_mut()
        .for_each(|row| row.swap(0, 2));
}

pub(super) fn labels_flicker(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    for row in &mut flight.positions {
        if random.random::<f64>() < 0.1 {
            row.swap(0, 1);
        }
    }
}

pub(super) fn mirrored_y(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    each_point(flight, |[x, y, z]| [x, -y, z]);
}

pub(super) fn mirrored_xy(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    each_point(flight, |[x, y, z]| [y, x, z]);
}

pub(super) fn mirrored_z(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    each_point(flight, |[x, y, z]| [x, y, -z]);
}

pub(super) fn z_down(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    each_point(flight, |[x, y, z]| [x, -y, -z]);
}

pub(super) fn y_up(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    each_point(flight, |[x, y, z]| [x, z, -y]);
}

pub(super) fn x_up(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    each_point(flight, |[x, y, z]| [z, y, -x]);
}

pub(super) fn feet(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    scaled(flight, 1.0 / 0.3048);
}

pub(super) fn inches(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    scaled(flight, 1.0 / 0.0254);
}

pub(super) fn centimetres(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    scaled(flight, 100.0);
}

pub(super) fn millimetres(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    scaled(flight, 1000.0);
}

pub(super) fn milliseconds(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    timed(flight, 1000.0);
}

pub(super) fn double_time(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    timed(flight, 2.0);
}

pub(super) fn half_time(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    timed(flight, 0.5);
}

pub(super) fn wrong_rate(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    // Flights sampled at 120 Hz but stamped as 144 Hz have the same ratio as 100 Hz to 120 Hz.
    timed(flight, 100.0 / 120.0);
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

pub(super) fn reversed(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    flight.positions.reverse();
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
    flight.positions[from..]
        .iter_mut()
        .for_each(|row| row.clone_from(&last));
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

pub(super) fn jump(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    let from = middle(flight);
    for row in &mut flight.positions[from..] {
        *row = moved(row, Vector3::new(0.0, 1.0, 0.0));
    }
}

pub(super) fn marker_off(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    for point in flight
        .positions
        .iter_mut()
        .filter_map(|row| row[0].as_mut())
    {
        point[1] += 1.0;
    }
}

pub(super) fn flight_off(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    for row in &mut flight.positions {
        *row = moved(row, Vector3::new(0.3, 1.0, 0.0));
    }
}

pub(super) fn constant(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    let first = flight.positions[0].clone();
    flight
        .positions
        .iter_mut()
        .for_each(|row| row.clone_from(&first));
}

pub(super) fn random(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    each_point(flight, |_| std::array::from_fn(|_| random.random::<f64>()));
}

/// Inserts samples of marker positions before the first or after the last sample of a flight, with noise of 1.5 mm, and
/// renumbers the times at a constant interval.
fn add(flight: &mut Flight, rows: Vec<Row>, at_start: bool, random: &mut ChaCha12Rng) {
    let interval = flight.times[1] - flight.times[0];
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
    let first = flight.times[0];
    let count = flight.positions.len();
    flight.times = (0..count).map(|k| first + k as f64 * interval).collect();
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
    add(flight, Vec::new(), false, random);
    each_point(flight, |p| {
        p.map(|x| x + 0.0015 * random.sample::<f64, _>(StandardNormal))
    });
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
    let interval = flight.times[1] - flight.times[0];
    flight.positions.extend(other.positions.iter().cloned());
    let first = flight.times[0];
    let count = flight.positions.len();
    flight.times = (0..count).map(|k| first + k as f64 * interval).collect();
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

pub(super) fn one_point(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    for row in &mut flight.positions {
        let first = row[0];
        row.fill(first);
    }
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

pub(super) fn unseen_marker(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    flight.positions.iter_mut().for_each(|row| row[2] = None);
}

pub(super) fn outliers(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    each_point(flight, |p| match random.random::<f64>() < 0.1 {
        true => p.map(|x| x + 0.5 * random.sample::<f64, _>(StandardNormal)),
        false => p,
    });
}

pub(super) fn noisy(flight: &mut Flight, _: &Flight, random: &mut ChaCha12Rng) {
    each_point(flight, |p| {
        p.map(|x| x + 0.03 * random.sample::<f64, _>(StandardNormal))
    });
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

pub(super) fn single_precision(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    each_point(flight, |[x, y, z]| {
        [x + 1e5, y, z].map(|x| f64::from(x as f32))
    });
}

pub(super) fn millimetre_steps(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    each_point(flight, |p| p.map(|x| (x * 1000.0).round() / 1000.0));
}

pub(super) fn centimetre_steps(flight: &mut Flight, _: &Flight, _: &mut ChaCha12Rng) {
    each_point(flight, |p| p.map(|x| (x * 100.0).round() / 100.0));
}

pub(super) fn template_5_mm(dataset: &mut Dataset) {
    dataset.markers[1].position[0] += 0.005;
}

pub(super) fn template_50_mm(dataset: &mut Dataset) {
    dataset.markers[1].position[0] += 0.05;
}

pub(super) fn template_mirrored(dataset: &mut Dataset) {
    for marker in &mut dataset.markers {
        marker.position[1] *= -1.0;
    }
}

pub(super) fn template_centimetres(dataset: &mut Dataset) {
    for marker in &mut dataset.markers {
        marker.position = marker.position.map(|x| x * 100.0);
    }
}

pub(super) fn moon(dataset: &mut Dataset) {
    dataset.parameters.insert("g".to_owned(), 1.62);
}
