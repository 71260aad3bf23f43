//! The screening on synthetic flights: none of what flies is a fault, and mistakes are named.

use ::flight::release::{Release, Stop, Vocabulary, built_in, read};
use model_spec::model::Model;

use super::track::{self, Track};
use super::{DataFault, FaultKind, screen};
use crate::dataset::{Dataset, Flight};
use crate::impact_detection;
use crate::options::FitOptions;
use crate::problem::FitProblem;
use crate::synthesize::{Corruption, Plan, Spread, flights};

const AR: Corruption = Corruption {
    sigma: 0.0015,
    ar1: 0.6,
    outliers: 0.01,
    outlier_size: 0.05,
    dropouts: 0.12,
};

fn model(name: &str) -> Model {
    model_spec::load::load(name, &[]).expect("a model")
}

fn release(model: &Model, name: &str) -> Release {
    let text = built_in(name).expect("a release");
    read(name, text, |_| Ok(Vocabulary::of(model))).expect("readable")
}

fn plan(flights: usize, seed: u64) -> Plan {
    Plan {
        flights,
        seed,
        noise: AR,
        duration: Some(1.0),
        ..Plan::default()
    }
}

fn found(model: &Model, dataset: &Dataset) -> Vec<DataFault> {
    let problem = FitProblem::new(model, dataset, &FitOptions::default()).expect("a problem");
    screen(&problem, dataset, 2)
}

/// Throws of a disc: usual, at steep angles of attack, fast, slow, upside down.
fn disc_releases(model: &Model) -> Vec<Release> {
    let usual = release(model, "backhand");
    let with = |changes: &[(&str, f64)]| {
        let mut release = usual.clone();
        release.stop = Stop::Duration(1.0);
        for (name, value) in &mut release.initial {
            if let Some((_, changed)) = changes.iter().find(|(changed, _)| changed == name) {
                *value = *changed;
            }
        }
        release
    };
    vec![
        with(&[]),
        with(&[("u", 25.0), ("w", -7.0), ("gammadot", -90.0)]),
        with(&[("u", 30.0), ("w", -4.0), ("theta", 0.1)]),
        with(&[("u", 6.0), ("w", -1.0), ("gammadot", -20.0)]),
        with(&[("u", 12.0), ("w", -9.0)]),
        with(&[("phi", 0.9), ("theta", -0.5)]),
    ]
}

fn discs(flights_each: usize, seed: u64) -> (Model, Vec<Dataset>) {
    let model = model("disc");
    let each = disc_releases(&model).into_iter().enumerate();
    let made = each.filter_map(|(k, release)| {
        let plan = plan(flights_each, seed + 100 * k as u64);
        flights(&model, &[release], &plan)
            .ok()
            .map(|made| made.dataset)
    });
    let made = made.collect();
    (model, made)
}

fn disc(seed: u64) -> (Model, Dataset) {
    let model = model("disc");
    let mut usual = release(&model, "backhand");
    usual.stop = Stop::Duration(1.0);
    let made = flights(&model, &[usual], &plan(10, seed)).expect("flights");
    (model, made.dataset)
}

fn ball(seed: u64) -> (Model, Dataset) {
    let model = model("ball");
    let mut serve = release(&model, "serve");
    serve.stop = Stop::Duration(0.6);
    let plan = Plan {
        duration: Some(0.6),
        spread: Spread {
            fraction: 0.3,
            ..Spread::default()
        },
        ..plan(10, seed)
    };
    let made = flights(&model, &[serve], &plan).expect("flights");
    (model, made.dataset)
}

#[test]
fn clean_flights_have_no_fault() {
    let (model, datasets) = discs(6, 1);
    assert!(datasets.len() > 4);
    for (k, dataset) in datasets.iter().enumerate() {
        assert_eq!(found(&model, dataset), [], "dataset {k}");
    }
    let (model, dataset) = ball(2);
    assert_eq!(found(&model, &dataset), []);
}

fn each_point(flight: &mut Flight, change: impl Fn([f64; 3]) -> [f64; 3]) {
    for point in flight.positions.iter_mut().flatten().flatten() {
        *point = change(*point);
    }
}

type Spoil = fn(&mut Flight);

const DISC_SPOILS: [(&str, FaultKind, Spoil); 12] = [
    ("labels", FaultKind::LabelsExchanged, |f| {
        f.positions.iter_mut().for_each(|row| row.swap(0, 1))
    }),
    ("labels 2 3", FaultKind::LabelsExchanged, |f| {
        f.positions.iter_mut().for_each(|row| row.swap(1, 2))
    }),
    ("labels in a cycle", FaultKind::LabelsExchanged, |f| {
        f.positions.iter_mut().for_each(|row| row.rotate_left(1))
    }),
    ("labels in a part", FaultKind::LabelsExchanged, |f| {
        f.positions[50..100]
            .iter_mut()
            .for_each(|row| row.swap(0, 2))
    }),
    ("feet", FaultKind::Units, |f| {
        each_point(f, |p| p.map(|x| x / 0.3048))
    }),
    ("centimetres", FaultKind::Units, |f| {
        each_point(f, |p| p.map(|x| x * 100.0))
    }),
    ("z down", FaultKind::Axes, |f| {
        each_point(f, |[x, y, z]| [x, -y, -z])
    }),
    ("y up", FaultKind::Axes, |f| {
        each_point(f, |[x, y, z]| [x, z, -y])
    }),
    ("milliseconds", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 1000.0)
    }),
    ("twice the time", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 2.0)
    }),
    ("half the time", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 0.5)
    }),
    ("frozen", FaultKind::Frozen, |f| {
        let held = f.positions[60][1];
        f.positions[60..80]
            .iter_mut()
            .for_each(|row| row[1] = held.or(Some([1.0, 1.0, 1.0])));
    }),
];

fn spoiled(dataset: &Dataset, which: &[usize], spoil: Spoil) -> Dataset {
    let mut dataset = dataset.clone();
    for &flight in which {
        spoil(&mut dataset.flights[flight]);
    }
    dataset
}

#[test]
fn mistakes_in_flights_of_a_disc_are_named() {
    let (model, dataset) = disc(3);
    let all: Vec<usize> = (0..dataset.flights.len()).collect();
    let mut wrong = Vec::new();
    for (name, kind, spoil) in DISC_SPOILS {
        for which in [&[4][..], &all] {
            let dataset = spoiled(&dataset, which, spoil);
            let faults = found(&model, &dataset);
            let expected = which
                .iter()
                .map(|&flight| (dataset.flights[flight].file.clone(), kind));
            let got: Vec<_> = faults
                .iter()
                .map(|fault| (fault.file.clone(), fault.fault))
                .collect();
            if got != expected.collect::<Vec<_>>() {
                wrong.push((name, which.len(), faults.into_iter().next(), got.len()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

const BALL_SPOILS: [(&str, FaultKind, Spoil); 8] = [
    ("feet", FaultKind::Units, |f| {
        each_point(f, |p| p.map(|x| x / 0.3048))
    }),
    ("centimetres", FaultKind::Units, |f| {
        each_point(f, |p| p.map(|x| x * 100.0))
    }),
    ("z down", FaultKind::Axes, |f| {
        each_point(f, |[x, y, z]| [x, -y, -z])
    }),
    ("y up", FaultKind::Axes, |f| {
        each_point(f, |[x, y, z]| [x, z, -y])
    }),
    ("milliseconds", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 1000.0)
    }),
    ("twice the time", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 2.0)
    }),
    ("half the time", FaultKind::TimeUnit, |f| {
        f.times.iter_mut().for_each(|t| *t *= 0.5)
    }),
    ("frozen", FaultKind::Frozen, |f| {
        let held = f.positions[20][0];
        f.positions[20..35]
            .iter_mut()
            .for_each(|row| row[0] = held.or(Some([1.0, 1.0, 1.0])));
    }),
];

#[test]
fn mistakes_in_flights_of_a_ball_are_named() {
    let (model, dataset) = ball(4);
    let all: Vec<usize> = (0..dataset.flights.len()).collect();
    let mut wrong = Vec::new();
    for (name, kind, spoil) in BALL_SPOILS {
        for which in [&[4][..], &all] {
            let dataset = spoiled(&dataset, which, spoil);
            let faults = found(&model, &dataset);
            let expected = which
                .iter()
                .map(|&flight| (dataset.flights[flight].file.clone(), kind));
            let got: Vec<_> = faults
                .iter()
                .map(|fault| (fault.file.clone(), fault.fault))
                .collect();
            if got != expected.collect::<Vec<_>>() {
                wrong.push((name, which.len(), faults.into_iter().next(), got.len()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Many clean flights of many kinds; run with --ignored in release.
#[test]
#[ignore = "takes long"]
fn two_thousand_clean_flights_have_no_fault() {
    let (mut count, mut alarms) = (0, 0);
    for seed in 0..30 {
        let (model, datasets) = discs(12, 1000 * seed);
        for dataset in datasets {
            let faults = found(&model, &dataset);
            count += dataset.flights.len();
            alarms += faults.len();
            for fault in faults {
                eprintln!("disc {seed} {fault}");
            }
        }
        let (model, dataset) = ball(seed);
        let faults = found(&model, &dataset);
        count += dataset.flights.len();
        alarms += faults.len();
        for fault in faults {
            eprintln!("ball {seed} {fault}");
        }
    }
    eprintln!("{alarms} alarms in {count} flights");
    assert_eq!(alarms, 0);
}

#[test]
fn measured_flights_and_examples_have_no_fault() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folders = [
        "../shared/data/spindoe",
        "examples/ball",
        "examples/disc",
        "examples/mystery",
    ];
    for folder in folders {
        let path = root.join(folder);
        if !path.exists() {
            eprintln!("skipped: {folder} is absent");
            continue;
        }
        let dataset = crate::dataset::load(&path).expect("a dataset");
        assert_eq!(found(&model(&dataset.model), &dataset), [], "{folder}");
    }
}

/// Lets the body of a flight bounce at a time: its velocity jumps by `change`, m/s.
fn bounced(flight: &Flight, time: f64, change: [f64; 3]) -> Flight {
    let mut flight = flight.clone();
    for (t, row) in flight.times.iter().zip(&mut flight.positions) {
        let since = (t - time).max(0.0);
        for point in row.iter_mut().flatten() {
            for (axis, change) in point.iter_mut().zip(change) {
                *axis += change * since;
            }
        }
    }
    flight
}

/// Index of the first sample after the impact that is detected.
fn cut_at(problem: &FitProblem, flight: &Flight) -> Option<usize> {
    let track = Track::of(
        &problem.markers,
        problem.has_attitude,
        &flight.times,
        &flight.positions,
    );
    let path: Vec<_> = track
        .points
        .iter()
        .map(|p| (p.sample, p.time, p.position))
        .collect();
    impact_detection::impact(&path).map(|impact| path[impact.index].0)
}

fn cuts(seeds: std::ops::Range<u64>) -> [usize; 4] {
    let (mut flown, mut wrong, mut bounces, mut missed) = (0, 0, 0, 0);
    for seed in seeds {
        let (disc, mut datasets) = discs(12, 1000 * seed);
        let (ball, of_ball) = ball(seed);
        let discs = datasets.len();
        datasets.push(of_ball);
        for (k, dataset) in datasets.iter().enumerate() {
            let model = if k < discs { &disc } else { &ball };
            let problem =
                FitProblem::new(model, dataset, &FitOptions::default()).expect("a problem");
            for (index, flight) in dataset.flights.iter().enumerate() {
                flown += 1;
                if let Some(at) = cut_at(&problem, flight) {
                    wrong += 1;
                    eprintln!(
                        "seed {seed} dataset {k} flight {index} cut at {at} of {}",
                        flight.times.len()
                    );
                }
                let track = Track::of(
                    &problem.markers,
                    problem.has_attitude,
                    &flight.times,
                    &flight.positions,
                );
                let middle = track.points.len() / 2 + index;
                let Some(motion) =
                    track::parabola(&track.points[middle - 10..middle + 10], track.noise)
                else {
                    continue;
                };
                let velocity = motion.velocity;
                if velocity.z > -1.0 {
                    continue;
                }
                bounces += 1;
                let restitution = 0.2 + 0.05 * index as f64;
                let change = [
                    -0.2 * velocity.x,
                    -0.2 * velocity.y,
                    -(1.0 + restitution) * velocity.z,
                ];
                let time = track.points[middle].time - 0.003;
                let at = cut_at(&problem, &bounced(flight, time, change));
                // Dropouts may hide the samples at the impact.
                let index_of = |sample| track.points.partition_point(|point| point.sample < sample);
                if at.is_none_or(|at| index_of(at).abs_diff(middle) > 2) {
                    missed += 1;
                    eprintln!(
                        "seed {seed} dataset {k} flight {index}: bounce at {middle} of change {change:?}, cut at {:?}",
                        at.map(index_of)
                    );
                }
            }
        }
    }
    eprintln!("{wrong} of {flown} cut wrongly; {missed} of {bounces} bounces missed");
    [flown, wrong, bounces, missed]
}

#[test]
fn flights_are_cut_at_bounces_only() {
    let [flown, wrong, bounces, missed] = cuts(0..1);
    assert!(flown > 50 && bounces > 20);
    assert_eq!([wrong, missed], [0, 0]);
}

/// Cuts of many flights; run with --ignored in release.
#[test]
#[ignore = "takes long"]
fn two_thousand_flights_are_cut_at_bounces_only() {
    let [_, wrong, bounces, missed] = cuts(0..30);
    assert_eq!(wrong, 0);
    assert!(100 * missed <= bounces);
}
