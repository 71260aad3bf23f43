//! Detection of samples in the hand and after the catch.

use nalgebra::Vector3;

use super::{Screened, ball, disc, found, kinds};
use crate::Flight;
use crate::contact::tests::jitter;
use crate::screening::handling;
use crate::screening::track::Track;

/// Copy of a flight with additional samples before its start, as if a hand threw the body: `held` samples at rest, then
/// `pushed` samples of acceleration to the initial velocity.
fn with_hand(flight: &Flight, held: usize, pushed: usize) -> Flight {
    let mut flight = flight.clone();
    let dt = flight.times[1] - flight.times[0];
    let complete = |row: &Vec<Option<[f64; 3]>>| row.iter().all(Option::is_some);
    let first = flight
        .positions
        .iter()
        .position(complete)
        .expect("a complete row");
    flight.positions.drain(..first);
    let next = (1..)
        .find(|&i| complete(&flight.positions[i]))
        .expect("another");
    let row = |i: usize| {
        flight.positions[i]
            .iter()
            .flatten()
            .copied()
            .collect::<Vec<[f64; 3]>>()
    };
    let (start, later) = (row(0), row(next));
    let count = start.len() as f64;
    let velocity = [0, 1, 2].map(|axis| {
        let moved = later.iter().zip(&start).map(|(b, a)| b[axis] - a[axis]);
        moved.sum::<f64>() / count / (next as f64 * dt)
    });
    let push = pushed as f64 * dt;
    let before = (1..=held + pushed).rev().map(|back| {
        let since = push - back as f64 * dt;
        let moved = since.max(0.0).powi(2) / (2.0 * push) - push / 2.0;
        let shift = |(k, p): (usize, &[f64; 3])| {
            let noise = 0.0015 * ((back * 31 + k * 7) as f64).sin();
            Some([0, 1, 2].map(|axis| p[axis] + velocity[axis] * moved + noise))
        };
        start.iter().enumerate().map(shift).collect()
    });
    let mut positions: Vec<Vec<Option<[f64; 3]>>> = before.collect();
    positions.append(&mut flight.positions);
    flight.times = (0..positions.len()).map(|i| i as f64 * dt).collect();
    flight.positions = positions;
    flight
}

/// Copy of a flight with additional samples at its end, as if a hand caught the body: `braked` samples of deceleration,
/// then `held` samples at rest.
fn with_catch(flight: &Flight, braked: usize, held: usize) -> Flight {
    let mut backwards = flight.clone();
    backwards.positions.reverse();
    let mut caught = with_hand(&backwards, held, braked);
    caught.positions.reverse();
    caught
}

#[test]
fn a_body_that_sinks_slowly_moves_and_one_that_lies_does_not() {
    let (model, dataset) = ball(1);
    let body = Screened::new(&model, &dataset);
    let told = |speed: f64| {
        let mut flight = dataset.flights[0].clone();
        for (index, (time, row)) in flight.times.iter().zip(&mut flight.positions).enumerate() {
            let noise = |k: usize| 0.0015 * jitter(3 * index + k);
            let point = [noise(0), noise(1), 1.0 - speed * time + noise(2)];
            row.fill(Some(point));
        }
        let (track, _) = Track::of(&body, &flight);
        handling::check(&track, -9.81 * Vector3::z(), &flight).map(|fault| fault.detail)
    };
    assert_eq!(told(0.3), None);
    assert_eq!(told(0.0), Some("the body does not move".to_owned()));
}

#[test]
fn samples_in_the_hand_and_after_the_catch_are_named() {
    type Change = fn(&Flight) -> Flight;
    let changes: [(&str, Change); 6] = [
        ("held for half a second", |f| with_hand(f, 60, 20)),
        ("pushed only", |f| with_hand(f, 0, 14)),
        ("pushed briefly", |f| with_hand(f, 0, 7)),
        ("caught and held", |f| with_catch(f, 8, 30)),
        ("caught", |f| with_catch(f, 9, 0)),
        ("at rest", |f| Flight {
            positions: f
                .positions
                .iter()
                .map(|_| {
                    f.positions[0]
                        .iter()
                        .map(|p| p.or(Some([1.0; 3])))
                        .collect()
                })
                .collect(),
            ..f.clone()
        }),
    ];
    let mut wrong = Vec::new();
    for ((model, clean), which_body) in [(disc(5), "disc"), (ball(6), "ball")] {
        for (name, change) in &changes {
            for which in [&[3][..], &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]] {
                let mut dataset = clean.clone();
                for &flight in which {
                    dataset.flights[flight] = change(&clean.flights[flight]);
                }
                let faults = found(&model, &dataset);
                let files = faults.iter().map(|fault| fault.file.as_str());
                let expected = which
                    .iter()
                    .map(|&flight| dataset.flights[flight].file.as_str());
                if !files.eq(expected) {
                    wrong.push(format!(
                        "{which_body}, {name}, {}: {:?} {:?}",
                        which.len(),
                        kinds(&faults),
                        faults.first().map(|f| &f.detail)
                    ));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
