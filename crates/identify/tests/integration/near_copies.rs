//! Flights that are near copies of others in the same dataset.

use crate::support::release;
use dataset::synthesize::{Corruption, Plan, Spread, flights};
use dataset::{Dataset, Flight};
use identify::{FitOptions, fit};
use model_spec::model::Model;

fn made(model: &str, name: &str, plan: &Plan) -> (Model, Dataset) {
    let model = model_spec::load::load(model, &[]).expect("a model");
    let release = release(name, &model);
    let made = flights(&model, &[release], plan).expect("flights");
    (model, made.dataset)
}

fn plan(flights: usize) -> Plan {
    Plan {
        flights,
        duration: Some(0.9),
        rate: 200.0,
        noise: Corruption {
            sigma: 0.001,
            dropouts: 0.03,
            ..Corruption::default()
        },
        ..Plan::default()
    }
}

/// Positions at `time`, linear between the samples; `None` where a marker is not seen.
fn between(flight: &Flight, time: f64) -> Vec<Option<[f64; 3]>> {
    let next = flight.times.partition_point(|own| *own <= time);
    let (before, next) = (next - 1, next.min(flight.times.len() - 1));
    let part = match next > before {
        true => (time - flight.times[before]) / (flight.times[next] - flight.times[before]),
        false => 0.0,
    };
    let pairs = flight.positions[before].iter().zip(&flight.positions[next]);
    let each = pairs.map(|pair| match pair {
        (Some(a), Some(b)) => Some([0, 1, 2].map(|k| a[k] + part * (b[k] - a[k]))),
        _ => None,
    });
    each.collect()
}

fn later_start(flight: &mut Flight) {
    flight.times.drain(..20);
    flight.positions.drain(..20);
    flight.times.iter_mut().for_each(|time| *time += 0.137);
}

fn rounded(flight: &mut Flight) {
    for coordinate in flight.positions.iter_mut().flatten().flatten().flatten() {
        *coordinate = (*coordinate * 1e3).round() / 1e3;
    }
}

fn subset(flight: &mut Flight) {
    let every_third = |index: &usize| index % 3 == 1;
    let samples: Vec<usize> = (0..flight.times.len()).filter(every_third).collect();
    flight.times = samples.iter().map(|&sample| flight.times[sample]).collect();
    flight.positions = samples
        .iter()
        .map(|&sample| flight.positions[sample].clone())
        .collect();
}

fn resampled(flight: &mut Flight) {
    let last = flight.times[flight.times.len() - 1];
    let times: Vec<f64> = (0..)
        .map(|k| f64::from(k) / 173.0)
        .take_while(|t| *t < last)
        .collect();
    flight.positions = times.iter().map(|time| between(flight, *time)).collect();
    flight.times = times;
}

/// Parabolas by least squares through nine samples, as of Savitzky and Golay.
fn filtered(flight: &mut Flight) {
    let weights = [-21.0, 14.0, 39.0, 54.0, 59.0, 54.0, 39.0, 14.0, -21.0].map(|w| w / 231.0);
    let measured = flight.positions.clone();
    for sample in 4..measured.len() - 4 {
        for (marker, point) in flight.positions[sample].iter_mut().enumerate() {
            let window = measured[sample - 4..].iter().zip(&weights);
            let all: Option<Vec<_>> = window.map(|(row, w)| Some((row[marker]?, w))).collect();
            *point = all.map(|all| [0, 1, 2].map(|k| all.iter().map(|(p, w)| p[k] * **w).sum()));
        }
    }
}

/// Files that are told to be copies, with a fourth flight that `change` makes of the second one.
fn told(change: fn(&mut Flight), (model, name): (&str, &str)) -> Vec<String> {
    let (model, mut dataset) = made(model, name, &plan(3));
    let mut copy = dataset.flights[1].clone();
    copy.file = "again.csv".into();
    change(&mut copy);
    dataset.flights.push(copy);
    let report = fit(&model, &dataset, &FitOptions::default())
        .expect("a fit")
        .report;
    let copies = report.data_faults.iter().filter(|fault| {
        fault.correction.contains("remove one of")
            && fault.correction.contains(&dataset.flights[1].file)
    });
    copies.map(|fault| fault.file.clone()).collect()
}

#[test]
fn a_throw_that_is_exported_twice_counts_once() {
    let changes: [fn(&mut Flight); 6] = [|_| {}, later_start, rounded, subset, resampled, filtered];
    for body in [("disc", "backhand"), ("ball", "serve")] {
        for (place, change) in changes.into_iter().enumerate() {
            assert_eq!(told(change, body), ["again.csv"], "{} {place}", body.0);
        }
    }
}

#[test]
fn equal_throws_with_noise_of_their_own_are_no_copies() {
    for (model, name) in [("disc", "backhand"), ("ball", "serve")] {
        for noise in [
            plan(0).noise,
            Corruption {
                sigma: 0.005,
                ar1: 0.8,
                ..Corruption::default()
            },
        ] {
            let equal = Plan {
                noise,
                spread: Spread {
                    fraction: 0.0,
                    ..Spread::default()
                },
                ..plan(8)
            };
            let (model, dataset) = made(model, name, &equal);
            let report = fit(&model, &dataset, &FitOptions::default())
                .expect("a fit")
                .report;
            assert_eq!(report.data_faults, [], "{name}");
        }
    }
}
